// SPDX-License-Identifier: MIT
// See below.h. The medium: shaders/common/below_medium.glsl.
#include "below.h"

#include <math.h>

#include "bolan/query.h"
#include "shared/fournier_forand.glsl"
#include "shared/bed.glsl"
#include "shared/refraction.glsl"

// By quality: texture fetches along a footprint, as in water_physical.c; then the waterline.
enum { WATERLINE = 1 << BOLAN_QUALITIES };
static const water_shader shader = {.stem = "below",
                                    .reads = WATER_FEATURE_WAVES | WATER_FEATURE_LAND,
                                    .defines = {[BOLAN_QUALITY_LOW] = "TAPS 1\n",
                                                [BOLAN_QUALITY_MEDIUM] = "TAPS 2\n",
                                                [BOLAN_QUALITY_HIGH] = "TAPS 4\nSPLINES 1\n",
                                                [BOLAN_QUALITY_ULTRA] = "TAPS 8\nSPLINES 1\n",
                                                [BOLAN_QUALITIES] = "WATERLINE 1\n"}};

typedef struct below_block {
#include "shared/below_block.glsl"
} below_block;

// ---- where the eye is -----------------------------------------------------------------------------------------------

view_medium bolan_below_medium(const frame *f, bolan_dvec3 eye) {
    double vertical, horizontal;
    const double reach = 4.0 * WATERLINE_NEAR; // of the corners of a wide near plane, and of steep water between
    bolan_water_bounds(&f->water, &vertical, &horizontal);
    if (eye.z - f->level > vertical + reach) return EYE_IN_AIR;
    if (eye.z - f->level < -vertical - reach) return EYE_IN_WATER;
    float height;
    bolan_query_heights(&f->water, &(bolan_dvec2){eye.x, eye.y}, 1, &height);
    const double over = eye.z - (double)height;
    return fabs(over) < reach ? EYE_AT_WATERLINE : over > 0.0 ? EYE_IN_AIR : EYE_IN_WATER;
}

// ---- the medium -----------------------------------------------------------------------------------------------------

// Light scattered by less than this still belongs to an image, which it blurs [deg].
#define IMAGE_BLUR 5.0
// Exponents of the particles: the model's range.
#define LEAST_EXPONENT 3.05
#define MOST_EXPONENT 4.9

// The exponent of the phase function that scatters this share back.
static double exponent_of(double back) {
    double low = LEAST_EXPONENT, high = MOST_EXPONENT;
    for (int i = 0; i < 30; ++i) {
        const double m = 0.5 * (low + high);
        if (1.0 - fournier_forand_within(0.0, fournier_forand_index(m), m) < back)
            low = m;
        else
            high = m;
    }
    return 0.5 * (low + high);
}

// waves: that are drawn; those of cascades have fine ones.
static below_block block_of(const render_view *v, water_waves waves, const gl_texture *window) {
    const fine_values fine = waves == WATER_CASCADES ? bolan_fine_values(v) : (fine_values){.widest = 0.0f};
    const bolan_water_optics *o = &v->frame->water.optics;
    const float *a = &o->absorption.x, *b = &o->scattering.x, *back = &o->backscatter.x, *kd = &o->kd.x;
    const float *deep = &o->deep.x;
    const double blur = cos(bolan_radians(IMAGE_BLUR));
    below_block out = {.blur_cosine = (float)blur,
                       .window_present = window != NULL ? 1.0f : 0.0f,
                       .fine_tile = fine.tile,
                       .fine_slopes = fine.slopes,
                       .fine_widest = fine.widest,
                       .fine_texel = fine.texel};
    for (int i = 0; i < 3; ++i) {
        const double m = exponent_of(fmin((double)back[i] / fmax((double)b[i], 1e-9), 0.5));
        const double wide = (double)b[i] * (1.0 - fournier_forand_within(blur, fournier_forand_index(m), m));
        const double beam = (double)a[i] + wide;
        (&out.particle_exponent.x)[i] = (float)m;
        (&out.wide_scattering.x)[i] = (float)wide;
        (&out.beam_attenuation.x)[i] = (float)beam;
        // straight down into endless water the veil is source / (beam + kd): the radiance that leaves it
        (&out.diffuse_source.x)[i] = (float)((double)deep[i] / BED_LEAVES * (beam + (double)kd[i]));
    }
    out.sun_below_z = (float)refracted_cosine((double)v->frame->sun_direction.z, (double)v->frame->block.water_index);
    return out;
}

// An eye opens up as the light fades: by less than the light, so that the deep looks dark.
#define OPENS_UP 0.7
#define FIRST_STOPS 0.5 // that the dimmer light from below the surface takes
float bolan_below_exposure(const frame *f, bolan_dvec3 eye) {
    const double depth = fmax(f->level - eye.z, 0.0);
    const bolan_vec3 kd = f->water.optics.kd;
    const double left = 0.2126 * exp(-(double)kd.x * depth) + 0.7152 * exp(-(double)kd.y * depth) +
                        0.0722 * exp(-(double)kd.z * depth);
    const double stops = FIRST_STOPS * fmin(depth, 1.0) - OPENS_UP * log2(fmax(left, 1e-4));
    return (float)exp2(stops);
}

// ---- drawing --------------------------------------------------------------------------------------------------------

static void free_window(window_targets *t) {
    bolan_gl_target_free(&t->target);
    bolan_gl_texture_free(&t->color);
    bolan_gl_texture_free(&t->depth);
}

void bolan_below_free(below_water *b) {
    for (int i = 0; i < KEPT_SIZES; ++i) free_window(&b->sizes[i]);
}

static bolan_result create_window(window_targets *t, uint32_t width, uint32_t height) {
    gl_texture_desc c = {
        .format = GL_FMT_RGBA16F, .width = width, .height = height, .filter = GL_FILTER_LINEAR, .wrap = GL_WRAP_CLAMP};
    gl_texture_desc d = c;
    d.format = GL_FMT_DEPTH32F;
    d.filter = GL_FILTER_NEAREST;
    const gl_texture *colors[] = {&t->color};
    bolan_result r = bolan_gl_texture_create(&c, &t->color);
    if (r == BOLAN_OK) r = bolan_gl_texture_create(&d, &t->depth);
    return r == BOLAN_OK ? bolan_gl_target_create(colors, 1, &t->depth, -1, 0, &t->target) : r;
}

// Waves blur what they show: half the view's size is enough.
static window_targets *fit(below_water *b, const render_view *v) {
    const uint32_t width = (v->width + 1) / 2, height = (v->height + 1) / 2;
    bool fresh;
    uint32_t over;
    const uint32_t slot = bolan_kept_sizes_use(&b->kept, width, height, &fresh);
    window_targets *t = &b->sizes[slot];
    if (fresh) free_window(t);
    while (bolan_kept_sizes_over(&b->kept, &over)) free_window(&b->sizes[over]);
    if (!fresh || create_window(t, width, height) == BOLAN_OK) return t;
    free_window(t);
    bolan_kept_sizes_forget(&b->kept, slot);
    return NULL;
}

void bolan_below_behind(below_water *b, const water_draw *d, const world_drawer *world) {
    render_view *v = d->view;
    b->window = NULL;
    if (!v->frame->behind || v->block.eye_height > -0.02f) return;
    window_targets *t = fit(b, v);
    if (t == NULL) return;
    render_view m = *v;
    m.clip = (view_clip){.side = 1.0f, .elevation = 0.0f, .mode = 2.0f};
    m.width = t->target.width;
    m.height = t->target.height;
    m.pixel_scale = (float)v->height / (float)m.height;
    m.picture = true;
    m.fog = false;
    m.hdr = t->target;
    bolan_view_use(&m);
    bolan_gl_set_state(&(gl_state){.depth_test = true, .depth_write = true, .color_write = true});
    bolan_gl_target_bind(&m.hdr);
    bolan_gl_target_clear_color(0.0f, 0.0f, 0.0f, 0.0f);
    bolan_gl_target_clear_depth(0.0f);
    world->draw(world->user, &m, false);
    bolan_view_use(v);
    b->window = &t->color;
}

void bolan_below_list(const water_setup *s, water_programs *all) {
    bolan_water_programs_add(all, s, false, &shader, 1u << s->quality);
    bolan_water_programs_add(all, s, false, &shader, 1u << s->quality | WATERLINE);
}

void bolan_below_draw(below_water *b, const water_draw *d) {
    const render_view *v = d->view;
    const bool line = v->medium == EYE_AT_WATERLINE;
    if (bolan_water_program(d, &shader, 1u << v->frame->quality | (line ? WATERLINE : 0u)) == NULL) return;
    const below_block block = block_of(v, d->waves, b->window);
    bolan_water_blocks_upload_optics(d->blocks, &block, sizeof block);
    if (b->window != NULL) bolan_gl_texture_bind(b->window, UNIT_WINDOW);
    if (d->fields->now->fine.id != 0) bolan_gl_texture_bind(&d->fields->now->fine, UNIT_FINE);
    bolan_gl_target_bind(&v->hdr);
    bolan_gl_set_state(&(gl_state){.color_write = true, .blend = line ? GL_BLEND_ALPHA : GL_BLEND_NONE});
    bolan_gl_draw_fullscreen();
}

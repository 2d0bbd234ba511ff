// SPDX-License-Identifier: MIT
// The pictures that some optics look up: the world on the eye's side of the water mirrored in its plane, and the world
// on the other side raised as refraction raises it (Ma, Zhu & Gong 2006, section 2.2; there P-buffers, here textures of
// the picture's size). The water plane stays where it is in both, so that a place of the water finds what it mirrors
// and what lies behind it at its own place in them.
#include "render/papers/planar_views.h"

#include <math.h>

// A bent look-up at the water's edge finds a little of what lies beyond it [m].
#define OVERLAP 0.25f
#define BLUR_LEVELS 6

// Waves blur what they show: the pictures' share of the frame's width and height. The paper's are as large as the
// window.
static const double shares[] = {
    [BOLAN_QUALITY_LOW] = 0.4, [BOLAN_QUALITY_MEDIUM] = 0.5, [BOLAN_QUALITY_HIGH] = 1.0, [BOLAN_QUALITY_ULTRA] = 1.0};

static void free_targets(planar_targets *p) {
    bolan_gl_target_free(&p->reflection_target);
    bolan_gl_target_free(&p->refraction_target);
    bolan_gl_texture_free(&p->reflection);
    bolan_gl_texture_free(&p->refraction);
    bolan_gl_texture_free(&p->reflection_depth);
    bolan_gl_texture_free(&p->refraction_depth);
}

static bolan_result create_picture(uint32_t width, uint32_t height, uint32_t levels, gl_texture *color,
                                   gl_texture *depth, gl_target *target) {
    gl_texture_desc c = {
        .format = GL_FMT_RGBA16F, .width = width, .height = height, .filter = GL_FILTER_LINEAR, .wrap = GL_WRAP_CLAMP};
    gl_texture_desc d = c;
    if (levels > 1) c.filter = GL_FILTER_MIPMAP_NEAREST, c.levels = levels;
    d.format = GL_FMT_DEPTH32F;
    d.filter = GL_FILTER_NEAREST;
    const gl_texture *colors[] = {color};
    bolan_result r = bolan_gl_texture_create(&c, color);
    if (r == BOLAN_OK) r = bolan_gl_texture_create(&d, depth);
    return r == BOLAN_OK ? bolan_gl_target_create(colors, 1, depth, -1, 0, target) : r;
}

double bolan_planar_views_share(const render_view *v) {
    return v->frame->lighting.look.paper ? 1.0 : shares[v->frame->quality];
}

void bolan_planar_views_free(planar_views *p) {
    for (int i = 0; i < KEPT_SIZES; ++i) free_targets(&p->sizes[i]);
}

static bolan_result create_targets(planar_targets *t, uint32_t width, uint32_t height) {
    const bolan_result result =
        create_picture(width, height, BLUR_LEVELS, &t->reflection, &t->reflection_depth, &t->reflection_target);
    if (result != BOLAN_OK) return result;
    return create_picture(width, height, 1, &t->refraction, &t->refraction_depth, &t->refraction_target);
}

// The targets of this view; NULL: there is no memory for them (logged).
static planar_targets *fit(planar_views *p, const render_view *v) {
    const double share = bolan_planar_views_share(v);
    const uint32_t width = (uint32_t)fmax(v->width * share, 1.0), height = (uint32_t)fmax(v->height * share, 1.0);
    bool fresh;
    uint32_t over;
    const uint32_t slot = bolan_kept_sizes_use(&p->kept, width, height, &fresh);
    planar_targets *t = &p->sizes[slot];
    if (fresh) free_targets(t);
    while (bolan_kept_sizes_over(&p->kept, &over)) free_targets(&p->sizes[over]);
    if (!fresh || create_targets(t, width, height) == BOLAN_OK) return t;
    free_targets(t);
    bolan_kept_sizes_forget(&p->kept, slot);
    return NULL;
}

// The mirror z -> -2 h - z about the plane h below the eye, before the camera (paper A: S = I - 2 n n^T). Directions,
// which the sky is drawn by, have no translation.
static render_view reflect(const planar_targets *p, const render_view *v) {
    render_view m = *v;
    const bool under = v->block.eye_under_water > 0.5f;
    const float overlap = v->frame->lighting.look.paper ? 0.0f : OVERLAP, side = under ? -1.0f : 1.0f;
    m.mirror.m[10] = -1.0f;
    m.mirror.m[14] = -2.0f * v->block.eye_height;
    m.clip = (view_clip){.side = side, .elevation = -side * overlap};
    m.width = p->reflection.width;
    m.height = p->reflection.height;
    m.pixel_scale = (float)v->height / (float)m.height;
    m.mirrored_under = under;
    m.picture = true;
    m.hdr = p->reflection_target;
    return m;
}

// The one factor of the paper's mode: at the middle of what the picture shows below the horizon, as the paper leaves
// open which angle it means.
static double paper_factor(const view_lens *lens) {
    const double half = 0.5 * bolan_degrees(lens->fov_y);
    const double low = lens->pitch_deg - half, high = fmin(lens->pitch_deg + half, 0.0);
    const double depression = fmin(fmax(-0.5 * (low + high), 0.5), 90.0);
    return bolan_refraction_k_paper(bolan_radians(90.0 - depression));
}

static bolan_vec4 deep_water(const render_view *v) {
    const frame_block *f = &v->frame->block;
    const bolan_vec3 s = v->light.sun, k = v->light.sky;
    const float sun = fmaxf(f->sun_direction.z, 0.0f);
    return (bolan_vec4){f->water_reflectance.x * (s.x * sun + k.x), f->water_reflectance.y * (s.y * sun + k.y),
                        f->water_reflectance.z * (s.z * sun + k.z), 1.0f};
}

static render_view refract(const planar_targets *p, const render_view *v, bool sky) {
    render_view m = *v;
    const bool under = v->block.eye_under_water > 0.5f, paper = v->frame->lighting.look.paper && !under;
    const float overlap = v->frame->lighting.look.paper ? 0.0f : OVERLAP, side = under ? 1.0f : -1.0f;
    m.clip = (view_clip){.side = side,
                         .elevation = under ? 0.0f : overlap,
                         .raise = (float)paper_factor(&v->lens),
                         .mode = paper ? 1.0f : 2.0f};
    m.width = p->refraction.width;
    m.height = p->refraction.height;
    m.pixel_scale = (float)v->height / (float)m.height;
    // An optics with a sky of its own attenuates the bed itself: once is enough. The paper names fog as work to come.
    if (!sky || paper) m.fog = false;
    m.background = under ? (bolan_vec4){0.0f, 0.0f, 0.0f, 0.0f} : deep_water(v);
    m.picture = true;
    m.hdr = p->refraction_target;
    return m;
}

static void bind(const planar_targets *p) {
    bolan_gl_texture_bind(&p->reflection, UNIT_REFLECTION);
    bolan_gl_texture_bind(&p->refraction, UNIT_REFRACTION);
    bolan_gl_texture_bind(&p->reflection_depth, UNIT_REFLECTION_DEPTH);
    bolan_gl_texture_bind(&p->refraction_depth, UNIT_REFRACTION_DEPTH);
}

static void draw_one(render_view *m, bool sky, const world_drawer *world) {
    const bolan_vec4 b = m->background;
    bolan_view_use(m);
    bolan_gl_set_state(&(gl_state){.depth_test = true, .depth_write = true, .color_write = true});
    bolan_gl_target_bind(&m->hdr);
    bolan_gl_target_clear_color(b.x, b.y, b.z, b.w);
    bolan_gl_target_clear_depth(0.0f);
    world->draw(world->user, m, sky);
}

void bolan_planar_views_draw(planar_views *views, const water_draw *d, bool sky, const world_drawer *world) {
    render_view *v = d->view;
    planar_targets *p = fit(views, v);
    if (p == NULL) return;
    render_view above = reflect(p, v), below = refract(p, v, sky);
    const bolan_look *look = &v->frame->lighting.look;
    // A margin for blurred fetches at the horizon; what is mirrored there is the haze.
    bolan_gl_clip_rows(bolan_water_rows(v, d->vertical) * above.hdr.height / v->hdr.height + 64);
    if (look->effects & BOLAN_EFFECT_REFLECTION) draw_one(&above, sky, world);
    if (look->effects & BOLAN_EFFECT_REFRACTION) draw_one(&below, false, world);
    bolan_gl_clip_rows(0);
    if (!look->paper) bolan_gl_texture_generate_mipmaps(&p->reflection);
    bolan_view_use(v);
    bind(p);
}

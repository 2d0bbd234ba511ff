// SPDX-License-Identifier: MIT
// The last pass: linear radiance -> the caller's framebuffer. One sample is written straight out; of several each is
// tone mapped and added up (the mean of what is seen, not of radiance: a glint must not outshine its pixel), and the
// last one writes the mean. High quality adds a glow round what is bright. Shaders: tonemap.glsl, tonemap_glow.glsl.
// Only fragments reach a framebuffer of the caller's. Where compute shaders shade pixels, one does the arithmetic and
// writes what is displayed into a texture, which a few fragment instructions copy.
#include "frame.h"
#include "memory.h"
#include "pixels.h"
#include "temporal.h"

enum { GLOW_LEVELS = 6, GLOW_PARTS = 4 }; // GLOW_PARTS: the picture's size over the glow's
static const float glow_share = 0.06f;

struct pass_tonemap {
    gl_program single[2], accumulate[2]; // without and with glow
    gl_program resolve, linear, shrink;
    // Sums over samples of what is displayed and of radiance. One pair is read while the other is written: floats of 32
    // bits cannot be blended everywhere.
    gl_texture sum[2], radiance_sum[2];
    gl_target sum_target[2];
    uint32_t summed,
        latest;          // samples in the sums of the last picture (0: one sample, no sums), the pair that holds them
    uint32_t first;      // samples that were in the sums before this view
    bool accumulating;   // the last view's sums may be added to,
    bolan_output output; // by a view of this output
    gl_texture glow;
    gl_target glow_target;
    gl_program pixels[2]; // without and with glow; none where fragment shaders shade pixels
    gl_texture display;   // what they write
    gl_target display_target;
};

bolan_result bolan_pass_tonemap_create(bool compute, pass_tonemap **out) {
    *out = NULL;
    pass_tonemap *p = allocate_for("the tone map", sizeof *p);
    if (!p) return BOLAN_ERROR_MEMORY;
    bolan_result result = bolan_gl_program_create("tonemap", NULL, &p->single[0]);
    if (result == BOLAN_OK) result = bolan_gl_program_create("tonemap", "GLOW 1\n", &p->single[1]);
    if (result == BOLAN_OK) result = bolan_gl_program_create("tonemap", "ACCUMULATE 1\n", &p->accumulate[0]);
    if (result == BOLAN_OK) result = bolan_gl_program_create("tonemap", "ACCUMULATE 1\nGLOW 1\n", &p->accumulate[1]);
    if (result == BOLAN_OK) result = bolan_gl_program_create("tonemap", "RESOLVE 1\n", &p->resolve);
    if (result == BOLAN_OK) result = bolan_gl_program_create("tonemap", "LINEAR 1\n", &p->linear);
    if (result == BOLAN_OK) result = bolan_gl_program_create("tonemap_glow", NULL, &p->shrink);
    if (result == BOLAN_OK && compute) result = bolan_gl_program_create_compute("tonemap", NULL, &p->pixels[0]);
    if (result == BOLAN_OK && compute) result = bolan_gl_program_create_compute("tonemap", "GLOW 1\n", &p->pixels[1]);
    if (result != BOLAN_OK) {
        bolan_pass_tonemap_destroy(&p);
        return result;
    }
    *out = p;
    return BOLAN_OK;
}

bolan_result bolan_pass_tonemap_reload(pass_tonemap *p) {
    gl_program *const programs[] = {&p->single[0], &p->single[1], &p->accumulate[0], &p->accumulate[1], &p->resolve,
                                    &p->linear,    &p->shrink,    &p->pixels[0],     &p->pixels[1]};
    for (size_t i = 0; i < sizeof programs / sizeof programs[0]; i++) {
        if (programs[i]->id == 0) continue;
        const bolan_result result = bolan_gl_program_reload(programs[i]);
        if (result != BOLAN_OK) return result;
    }
    return BOLAN_OK;
}

static void free_sums(pass_tonemap *p) {
    for (int i = 0; i < 2; i++) {
        bolan_gl_target_free(&p->sum_target[i]);
        bolan_gl_texture_free(&p->sum[i]);
        bolan_gl_texture_free(&p->radiance_sum[i]);
    }
}

static bool resize(pass_tonemap *p, uint32_t width, uint32_t height) {
    if (p->sum[1].id && p->sum[1].width == width && p->sum[1].height == height) return true;
    free_sums(p);
    const gl_texture_desc d = {.format = GL_FMT_RGBA32F, .width = width, .height = height};
    for (int i = 0; i < 2; i++) {
        const gl_texture *color[] = {&p->sum[i], &p->radiance_sum[i]};
        if (bolan_gl_texture_create(&d, &p->sum[i]) != BOLAN_OK) return false;
        if (bolan_gl_texture_create(&d, &p->radiance_sum[i]) != BOLAN_OK) return false;
        if (bolan_gl_target_create(color, 2, NULL, -1, 0, &p->sum_target[i]) != BOLAN_OK) return false;
    }
    return true;
}

// A texture and its target, made anew where the size is another.
static bool fit(const gl_texture_desc *d, gl_texture *color, gl_target *target) {
    if (target->id && color->width == d->width && color->height == d->height) return true;
    bolan_gl_target_free(target);
    bolan_gl_texture_free(color);
    const gl_texture *colors[] = {color};
    return bolan_gl_texture_create(d, color) == BOLAN_OK &&
           bolan_gl_target_create(colors, 1, NULL, -1, 0, target) == BOLAN_OK;
}

static bool resize_glow(pass_tonemap *p, uint32_t width, uint32_t height) {
    const uint32_t w = (width + GLOW_PARTS - 1) / GLOW_PARTS, h = (height + GLOW_PARTS - 1) / GLOW_PARTS;
    const gl_texture_desc d = {.format = GL_FMT_RGBA16F, .width = w, .height = h, .filter = GL_FILTER_MIPMAP_NEAREST};
    return fit(&d, &p->glow, &p->glow_target);
}

static bool resize_display(pass_tonemap *p, uint32_t width, uint32_t height) {
    const gl_texture_desc d = {.format = GL_FMT_RGBA16F, .width = width, .height = height, .storage = true};
    return fit(&d, &p->display, &p->display_target);
}

// Fills the glow and its mip chain. A picture too small for the levels goes without.
static bool draw_glow(pass_tonemap *p, const render_view *v, const gl_texture *hdr_color) {
    const uint32_t smallest = GLOW_PARTS << GLOW_LEVELS;
    if (v->frame->quality < BOLAN_QUALITY_HIGH || v->width < smallest || v->height < smallest) return false;
    if (!resize_glow(p, v->width, v->height)) return false;
    bolan_gl_target_bind(&p->glow_target);
    bolan_gl_texture_bind(hdr_color, UNIT_OWN);
    bolan_gl_program_use(&p->shrink);
    bolan_gl_draw_fullscreen();
    bolan_gl_texture_generate_mipmaps(&p->glow);
    bolan_gl_texture_bind(&p->glow, UNIT_OWN + 2);
    return true;
}

static void draw(const gl_program *program, const gl_texture *source, const bolan_view *to, bool encode, float dither,
                 float weight) {
    bolan_gl_texture_bind(source, UNIT_OWN);
    bolan_gl_program_vec2(program, "origin", to ? (float)to->x : 0.0f, to ? (float)to->y : 0.0f);
    bolan_gl_program_vec4(program, "settings", (bolan_vec4){glow_share, encode ? 1.0f : 0.0f, dither, weight});
    bolan_gl_draw_fullscreen();
}

// An sRGB framebuffer does the encoding itself; dither is then a little strong in the dark, never absent.
static void draw_out(const gl_program *program, const gl_texture *source, const bolan_view *to, float weight) {
    const bool encode = to->output == BOLAN_OUTPUT_SRGB;
    bolan_gl_target_bind_external(to->framebuffer, to->x, to->y, to->width, to->height);
    bolan_gl_set_framebuffer_srgb(to->output == BOLAN_OUTPUT_SRGB_FRAMEBUFFER);
    draw(program, source, to, encode, encode ? 0.5f : 0.1f, weight);
    bolan_gl_set_framebuffer_srgb(false);
}

// One sample, tone mapped.
static void draw_single(pass_tonemap *p, const render_view *v, const bolan_view *to, const gl_texture *hdr_color,
                        bool glow) {
    const gl_program *pixels = &p->pixels[glow];
    if (!pixels->id || !resize_display(p, v->width, v->height)) {
        draw_out(&p->single[glow], hdr_color, to, 1.0f);
        return;
    }
    bolan_gl_texture_bind(hdr_color, UNIT_OWN);
    bolan_gl_program_vec4(pixels, "settings", (bolan_vec4){glow_share, 0.0f, 0.0f, 0.0f});
    bolan_pixels_draw(pixels, &p->display_target, 0, v->height);
    draw_out(&p->resolve, &p->display, to, 1.0f);
}

// Adds a sample to the sums. Returns the index of the pair that holds them now.
static uint32_t accumulate(pass_tonemap *p, const gl_texture *hdr_color, bool glow, uint32_t sample) {
    const uint32_t pair = sample & 1u;
    p->summed = sample + 1;
    p->latest = pair;
    bolan_gl_target_bind(&p->sum_target[pair]);
    bolan_gl_texture_bind(&p->sum[pair ^ 1u], UNIT_OWN + 3);
    bolan_gl_texture_bind(&p->radiance_sum[pair ^ 1u], UNIT_OWN + 1);
    draw(&p->accumulate[glow], hdr_color, NULL, false, 0.0f, sample > 0 ? 1.0f : 0.0f);
    return pair;
}

uint32_t bolan_pass_tonemap_begin(pass_tonemap *p, const bolan_view *to) {
    const bool same = p->sum[1].width == to->width && p->sum[1].height == to->height && p->output == to->output;
    p->first = to->accumulate && p->accumulating && same ? p->summed : 0;
    p->accumulating = to->accumulate;
    p->output = to->output;
    return p->first;
}

void bolan_pass_tonemap_draw(pass_tonemap *p, const render_view *v, const bolan_view *to, const gl_texture *hdr_color,
                             uint32_t sample, temporal *history) {
    const bool linear = to->output == BOLAN_OUTPUT_LINEAR;
    const float unit = linear ? v->frame->block.radiance_unit : 1.0f;
    bolan_gl_set_state(&(gl_state){.color_write = true});
    const bool glow = !linear && draw_glow(p, v, hdr_color);
    p->summed = 0;
    const bool blended = history != NULL && history->drawing;
    const bool several = to->samples > 1 || to->accumulate || blended;
    if (!several || !resize(p, v->width, v->height)) {
        if (linear)
            draw_out(&p->linear, hdr_color, to, 1.0f / unit);
        else
            draw_single(p, v, to, hdr_color, glow);
        return;
    }
    const uint32_t pair = accumulate(p, hdr_color, glow, p->first + sample);
    if (sample + 1 < to->samples) return;
    if (blended) {
        draw_out(&p->resolve, bolan_temporal_blend(history, v, &p->sum[pair], to->samples), to, 1.0f);
        return;
    }
    draw_out(linear ? &p->linear : &p->resolve, linear ? &p->radiance_sum[pair] : &p->sum[pair], to,
             1.0f / (unit * (float)p->summed));
}

void bolan_pass_tonemap_forget(pass_tonemap *p) { p->summed = 0; }

uint32_t bolan_pass_tonemap_samples(const pass_tonemap *p) { return p->summed > 0 ? p->summed : 1; }

uint32_t bolan_pass_tonemap_read_sum(const pass_tonemap *p, float *rgba) {
    if (p->summed > 0) bolan_gl_target_read_float(&p->sum_target[p->latest], 1, rgba);
    return p->summed;
}

void bolan_pass_tonemap_destroy(pass_tonemap **pp) {
    if (!pp || !*pp) return;
    pass_tonemap *p = *pp;
    free_sums(p);
    bolan_gl_target_free(&p->glow_target);
    bolan_gl_texture_free(&p->glow);
    bolan_gl_target_free(&p->display_target);
    bolan_gl_texture_free(&p->display);
    for (int i = 0; i < 2; i++) {
        bolan_gl_program_free(&p->pixels[i]);
        bolan_gl_program_free(&p->single[i]);
        bolan_gl_program_free(&p->accumulate[i]);
    }
    bolan_gl_program_free(&p->resolve);
    bolan_gl_program_free(&p->linear);
    bolan_gl_program_free(&p->shrink);
    bolan_release(p, sizeof *p);
    *pp = NULL;
}

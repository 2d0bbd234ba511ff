// SPDX-License-Identifier: MIT
// The last pass: linear radiance -> the caller's framebuffer. One sample is written straight out; of several each is tone
// mapped and added up (the mean of what is seen, not of radiance: a glint must not outshine its pixel), and the last one
// writes the mean. Shader: shaders/tonemap.glsl.
#include "frame.h"

struct pass_tonemap {
    gl_program single, accumulate, resolve;
    gl_texture sum[2]; // one is read while the other is written: floats of 32 bits cannot be blended everywhere
    gl_target sum_target[2];
};

bolan_result pass_tonemap_create(const gl_caps *caps, pass_tonemap **out) {
    (void)caps;
    *out = NULL;
    pass_tonemap *p = bolan_allocate(sizeof *p);
    if (!p) return BOLAN_ERROR_MEMORY;
    bolan_result result = gl_program_create("tonemap", NULL, &p->single);
    if (result == BOLAN_OK) result = gl_program_create("tonemap", "ACCUMULATE 1\n", &p->accumulate);
    if (result == BOLAN_OK) result = gl_program_create("tonemap", "RESOLVE 1\n", &p->resolve);
    if (result != BOLAN_OK) {
        pass_tonemap_destroy(&p);
        return result;
    }
    *out = p;
    return BOLAN_OK;
}

bolan_result pass_tonemap_reload(pass_tonemap *p) {
    bolan_result result = gl_program_reload(&p->single);
    if (result == BOLAN_OK) result = gl_program_reload(&p->accumulate);
    return result == BOLAN_OK ? gl_program_reload(&p->resolve) : result;
}

static void free_sums(pass_tonemap *p) {
    for (int i = 0; i < 2; i++) {
        gl_target_free(&p->sum_target[i]);
        gl_texture_free(&p->sum[i]);
    }
}

static bool resize(pass_tonemap *p, uint32_t width, uint32_t height) {
    if (p->sum[1].id && p->sum[1].width == width && p->sum[1].height == height) return true;
    free_sums(p);
    const gl_texture_desc d = {.format = GL_FMT_RGBA32F, .width = width, .height = height};
    for (int i = 0; i < 2; i++) {
        const gl_texture *color = &p->sum[i];
        if (gl_texture_create(&d, &p->sum[i]) != BOLAN_OK) return false;
        if (gl_target_create(&color, 1, NULL, -1, 0, &p->sum_target[i]) != BOLAN_OK) return false;
    }
    return true;
}

static void draw(const gl_program *program, const gl_texture *source, bool encode, float dither, float weight) {
    gl_texture_bind(source, UNIT_PASS);
    gl_program_vec4(program, "settings", (bolan_vec4){0.0f, encode ? 1.0f : 0.0f, dither, weight});
    gl_draw_fullscreen();
}

// An sRGB framebuffer does the encoding itself; dither is then a little strong in the dark, never absent.
static void draw_out(const gl_program *program, const gl_texture *source, const frame *f, float weight) {
    const bool encode = !f->desc->srgb_framebuffer;
    gl_target_bind_external(f->desc->framebuffer, f->desc->width, f->desc->height);
    gl_set_framebuffer_srgb(!encode);
    draw(program, source, encode, encode ? 0.5f : 0.1f, weight);
    gl_set_framebuffer_srgb(false);
}

void pass_tonemap_draw(pass_tonemap *p, const frame *f, const gl_texture *hdr_color, uint32_t sample, uint32_t samples) {
    gl_set_state(&(gl_state){.color_write = true});
    if (samples <= 1 || !resize(p, f->desc->width, f->desc->height)) {
        draw_out(&p->single, hdr_color, f, 1.0f);
        return;
    }
    const uint32_t to = sample & 1u;
    gl_target_bind(&p->sum_target[to]);
    gl_texture_bind(&p->sum[to ^ 1u], UNIT_SCENE_DEPTH);
    draw(&p->accumulate, hdr_color, false, 0.0f, sample > 0 ? 1.0f : 0.0f);
    if (sample + 1 == samples) draw_out(&p->resolve, &p->sum[to], f, 1.0f / (float)samples);
}

void pass_tonemap_destroy(pass_tonemap **pp) {
    if (!pp || !*pp) return;
    pass_tonemap *p = *pp;
    free_sums(p);
    gl_program_free(&p->single);
    gl_program_free(&p->accumulate);
    gl_program_free(&p->resolve);
    bolan_release(p, sizeof *p);
    *pp = NULL;
}

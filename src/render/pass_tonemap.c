// SPDX-License-Identifier: MIT
// The last pass: linear radiance -> the caller's framebuffer. One sample is written straight out; of several each is tone
// mapped and added up (the mean of what is seen, not of radiance: a glint must not outshine its pixel), and the last one
// writes the mean. Shader: shaders/tonemap.glsl.
#include "frame.h"

struct pass_tonemap {
    gl_program single, resolve;
    gl_texture sum;
    gl_target sum_target;
};

bolan_result pass_tonemap_create(const gl_caps *caps, pass_tonemap **out) {
    (void)caps;
    *out = NULL;
    pass_tonemap *p = bolan_allocate(sizeof *p);
    if (!p) return BOLAN_ERROR_MEMORY;
    bolan_result result = gl_program_create("tonemap", NULL, &p->single);
    if (result == BOLAN_OK) result = gl_program_create("tonemap", "RESOLVE 1\n", &p->resolve);
    if (result != BOLAN_OK) {
        pass_tonemap_destroy(&p);
        return result;
    }
    *out = p;
    return BOLAN_OK;
}

bolan_result pass_tonemap_reload(pass_tonemap *p) {
    const bolan_result result = gl_program_reload(&p->single);
    return result == BOLAN_OK ? gl_program_reload(&p->resolve) : result;
}

static bool resize(pass_tonemap *p, uint32_t width, uint32_t height) {
    if (p->sum.id && p->sum.width == width && p->sum.height == height) return true;
    gl_target_free(&p->sum_target);
    gl_texture_free(&p->sum);
    const gl_texture_desc d = {.format = GL_FMT_RGBA16F, .width = width, .height = height};
    const gl_texture *color = &p->sum;
    return gl_texture_create(&d, &p->sum) == BOLAN_OK && gl_target_create(&color, 1, NULL, -1, 0, &p->sum_target) == BOLAN_OK;
}

static void draw(const gl_program *program, const gl_texture *source, bool encode, float dither, float weight) {
    gl_texture_bind(source, UNIT_PASS);
    gl_program_vec4(program, "settings", (bolan_vec4){0.0f, encode ? 1.0f : 0.0f, dither, weight});
    gl_draw_fullscreen();
}

// An sRGB framebuffer does the encoding itself; dither is then a little strong in the dark, never absent.
static void draw_out(const gl_program *program, const gl_texture *source, const frame *f, float weight) {
    const bool encode = !f->desc->srgb_framebuffer;
    gl_set_state(&(gl_state){.color_write = true});
    gl_set_framebuffer_srgb(!encode);
    draw(program, source, encode, encode ? 0.5f : 0.1f, weight);
    gl_set_framebuffer_srgb(false);
}

void pass_tonemap_draw(pass_tonemap *p, const frame *f, const gl_texture *hdr_color, uint32_t sample, uint32_t samples) {
    const bolan_frame_desc *desc = f->desc;
    if (samples <= 1 || !resize(p, desc->width, desc->height)) {
        draw_out(&p->single, hdr_color, f, 1.0f);
        return;
    }
    gl_target_bind(&p->sum_target);
    if (sample == 0) gl_target_clear_color(0.0f, 0.0f, 0.0f, 0.0f);
    gl_set_state(&(gl_state){.color_write = true, .blend = GL_BLEND_ADD});
    draw(&p->single, hdr_color, false, 0.0f, 1.0f / 16.0f); // a sum of 256 display values stays exact enough in halfs
    gl_target_bind_external(desc->framebuffer, desc->width, desc->height);
    if (sample + 1 == samples) draw_out(&p->resolve, &p->sum, f, 16.0f / (float)samples);
}

void pass_tonemap_destroy(pass_tonemap **pp) {
    if (!pp || !*pp) return;
    pass_tonemap *p = *pp;
    gl_target_free(&p->sum_target);
    gl_texture_free(&p->sum);
    gl_program_free(&p->single);
    gl_program_free(&p->resolve);
    bolan_release(p, sizeof *p);
    *pp = NULL;
}

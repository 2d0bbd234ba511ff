// SPDX-License-Identifier: MIT
// See host.h. For every perspective, standard or reversed, finite or infinite, window depth is a + b / t at distance t
// along the view axis: clip z is m10 Z + m14 and w is m11 Z, so that z / w = m10 / m11 + m14 / (|m11| t). Our own depth
// is near / t. So each depth is a linear function of the other, and nothing is lost but the host's own precision.
#include "host.h"

#include <math.h>

#include "frame.h"

bolan_host bolan_host_default(void) { return (bolan_host){.color = 0}; }

host_depth bolan_host_depth_of(const bolan_view *view) {
    const float *m = view->projection.m;
    const double a = (double)m[10] / (double)m[11], b = (double)m[14] / fabs((double)m[11]);
    return view->zero_to_one ? (host_depth){a, b} : (host_depth){0.5 * a + 0.5, 0.5 * b};
}

bolan_result bolan_host_create(const gl_caps *caps, host_frame *h) {
    bolan_result result = bolan_gl_program_create("host_import", NULL, &h->import[0]);
    if (result == BOLAN_OK && !caps->es)
        result = bolan_gl_program_create("host_import", "MULTISAMPLED 1\n", &h->import[1]);
    if (result == BOLAN_OK) result = bolan_gl_program_create("host_resolve", NULL, &h->resolve[0]);
    if (result == BOLAN_OK) result = bolan_gl_program_create("host_resolve", "MASK 1\n", &h->resolve[1]);
    if (result == BOLAN_OK) result = bolan_gl_program_create("host_resolve", "TONEMAP 1\n", &h->tonemap[0]);
    if (result == BOLAN_OK) result = bolan_gl_program_create("host_resolve", "TONEMAP 1\nMASK 1\n", &h->tonemap[1]);
    bolan_gl_sampler_create(&h->sampler, false);
    return result;
}

bolan_result bolan_host_reload(host_frame *h) {
    bolan_result result = bolan_gl_program_reload(&h->import[0]);
    if (result == BOLAN_OK && h->import[1].id != 0) result = bolan_gl_program_reload(&h->import[1]);
    for (int i = 0; i < 2 && result == BOLAN_OK; ++i) {
        result = bolan_gl_program_reload(&h->resolve[i]);
        if (result == BOLAN_OK) result = bolan_gl_program_reload(&h->tonemap[i]);
    }
    return result;
}

// Window depth of the host over ours, offset and scale; a factor of radiance; what else the shader's member w means.
static bolan_vec4 depth_law(const render_view *v, const bolan_view *to, float radiance, float w) {
    const host_depth d = bolan_host_depth_of(to);
    return (bolan_vec4){(float)d.offset, (float)(d.scale / v->near_distance), radiance, w};
}

static float radiance_of(const bolan_host *host) { return host->radiance > 0.0 ? (float)host->radiance : 1.0f; }

static void draw_pixels(const host_frame *h, const bolan_host *host) {
    bolan_gl_guest_texture_bind(host->color, UNIT_OWN, &h->sampler);
    bolan_gl_guest_texture_bind(host->depth, UNIT_OWN + 1, &h->sampler);
    bolan_gl_draw_fullscreen();
    bolan_gl_guest_texture_bind(0, UNIT_OWN, NULL);
    bolan_gl_guest_texture_bind(0, UNIT_OWN + 1, NULL);
}

static void draw_samples(const bolan_host *host) {
    const uint32_t color = bolan_gl_multisampled_bind(host->color, UNIT_OWN);
    const uint32_t depth = bolan_gl_multisampled_bind(host->depth, UNIT_OWN + 1);
    bolan_gl_draw_fullscreen();
    bolan_gl_multisampled_unbind(color, UNIT_OWN);
    bolan_gl_multisampled_unbind(depth, UNIT_OWN + 1);
}

void bolan_host_import(host_frame *h, const render_view *v, const bolan_view *to, const bolan_host *host) {
    const bool several = host->samples > 1;
    const gl_program *p = &h->import[several];
    bolan_gl_target_bind(&v->hdr);
    bolan_gl_set_state(&(gl_state){.depth_write = true, .color_write = true});
    bolan_gl_program_use(p);
    bolan_gl_program_vec4(
        p, "host_depth", depth_law(v, to, v->frame->block.radiance_unit / radiance_of(host), (float)host->samples));
    bolan_gl_program_vec2(p, "host_origin", (float)host->x, (float)host->y);
    if (several)
        draw_samples(host);
    else
        draw_pixels(h, host);
}

void bolan_host_resolve(host_frame *h, const render_view *v, const bolan_view *to, const bolan_host *host,
                        const gl_texture *color) {
    const bool linear = to->output == BOLAN_OUTPUT_LINEAR, encode = to->output == BOLAN_OUTPUT_SRGB;
    const bool masked = host->mask != 0;
    const gl_program *p = linear ? &h->resolve[masked] : &h->tonemap[masked];
    const bool reversed = bolan_host_depth_of(to).scale > 0.0;
    bolan_gl_target_bind_external(to->framebuffer, to->x, to->y, to->width, to->height);
    bolan_gl_set_state(
        &(gl_state){.depth_test = true, .depth_write = true, .color_write = true, .depth_less = !reversed});
    bolan_gl_set_framebuffer_srgb(to->output == BOLAN_OUTPUT_SRGB_FRAMEBUFFER);
    bolan_gl_program_use(p);
    bolan_gl_program_vec4(
        p, "host_depth",
        depth_law(v, to, radiance_of(host) / v->frame->block.radiance_unit, encode ? 1.0f : 0.0f));
    bolan_gl_program_vec2(p, "host_origin", (float)to->x, (float)to->y);
    bolan_gl_texture_bind(color, UNIT_OWN);
    bolan_gl_texture_bind(v->hdr_depth, UNIT_OWN + 1);
    bolan_gl_program_vec2(p, "mask_origin", (float)host->x, (float)host->y);
    if (masked) bolan_gl_guest_texture_bind(host->mask, UNIT_OWN + 2, &h->sampler);
    gl_stencil stencil;
    if (host->stencil_mask != 0) bolan_gl_stencil_begin(&stencil, host->stencil, host->stencil_mask);
    bolan_gl_draw_fullscreen();
    if (host->stencil_mask != 0) bolan_gl_stencil_end(&stencil);
    if (masked) bolan_gl_guest_texture_bind(0, UNIT_OWN + 2, NULL);
    bolan_gl_set_framebuffer_srgb(false);
}

void bolan_host_free(host_frame *h) {
    for (int i = 0; i < 2; ++i) {
        bolan_gl_program_free(&h->import[i]);
        bolan_gl_program_free(&h->resolve[i]);
        bolan_gl_program_free(&h->tonemap[i]);
    }
    bolan_gl_sampler_free(&h->sampler);
}

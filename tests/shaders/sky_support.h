// SPDX-License-Identifier: MIT
// A frame with nothing in it but sky, for the tests of the sky and tone map passes.
#ifndef BOLAN_TESTS_SKY_SUPPORT_H
#define BOLAN_TESTS_SKY_SUPPORT_H

#include "bolan/earth.h"
#include "gl_support.h"
#include "render/frame.h"

#include <math.h>
#include <string.h>

typedef struct sky_rig {
    gl_caps caps;
    bolan_camera camera;
    bolan_view to;
    frame step;
    render_view f;
    pass_sky *sky;
    pass_tonemap *tonemap;
    gl_texture color, depth, out;
    gl_target hdr, display;
    block_buffers uniforms;
} sky_rig;

static inline void rig_create(sky_rig *r, uint32_t width, uint32_t height) {
    memset(r, 0, sizeof *r);
    r->caps = bolan_gl_get_caps();
    assert_int_equal(bolan_pass_sky_create(&r->caps, false, NULL, &r->sky), BOLAN_OK);
    assert_int_equal(bolan_pass_tonemap_create(false, &r->tonemap), BOLAN_OK);
    const gl_texture_desc hdr = {.format = GL_FMT_RGBA16F, .width = width, .height = height};
    const gl_texture_desc depth = {.format = GL_FMT_DEPTH32F, .width = width, .height = height};
    const gl_texture_desc out = {.format = GL_FMT_RGBA8, .width = width, .height = height};
    const gl_texture *c = &r->color, *o = &r->out;
    assert_int_equal(bolan_gl_texture_create(&hdr, &r->color), BOLAN_OK);
    assert_int_equal(bolan_gl_texture_create(&depth, &r->depth), BOLAN_OK);
    assert_int_equal(bolan_gl_texture_create(&out, &r->out), BOLAN_OK);
    assert_int_equal(bolan_gl_target_create(&c, 1, &r->depth, -1, 0, &r->hdr), BOLAN_OK);
    assert_int_equal(bolan_gl_target_create(&o, 1, NULL, -1, 0, &r->display), BOLAN_OK);
    assert_int_equal(bolan_blocks_create(&r->uniforms), BOLAN_OK);
    r->step.lighting.sky = (bolan_sky){
        .sun_azimuth_deg = 180, .sun_elevation_deg = 35, .visibility = 40000, .cloud_base = 1200, .cloud_seed = 1};
    r->camera.fov_deg = 50;
    r->to = bolan_view_default();
    r->to.framebuffer = r->display.id;
    r->to.width = width;
    r->to.height = height;
    r->step.caps = &r->caps;
    r->step.quality = BOLAN_QUALITY_LOW;
    r->f = (render_view){.frame = &r->step, .width = width, .height = height, .hdr = r->hdr, .hdr_depth = &r->depth};
}

static inline void rig_upload(sky_rig *r) {
    bolan_blocks_upload_frame(&r->uniforms, &r->step.block);
    bolan_blocks_upload_view(&r->uniforms, &r->f.block);
}

// Blocks of the sky and the camera, as the renderer fills them; then the pass's tables.
static inline void rig_prepare(sky_rig *r) {
    const bolan_sky *s = &r->step.lighting.sky;
    bolan_view view = bolan_view_from_camera(&r->camera, r->f.width, r->f.height);
    const bool progressive = r->f.progressive;
    frame_block *b = &r->step.block;
    const double azimuth = bolan_radians(s->sun_azimuth_deg), elevation = bolan_radians(s->sun_elevation_deg);
    bolan_gl_set_clip_zero_to_one(r->caps.clip_control);
    bolan_view_open(&r->f, &r->step, &view, r->caps.clip_control);
    r->f.progressive = progressive;
    r->step.sun_direction =
        bolan_v3((float)(sin(azimuth) * cos(elevation)), (float)(cos(azimuth) * cos(elevation)), (float)sin(elevation));
    b->sun_direction = r->step.sun_direction;
    b->radiance_unit = bolan_radiance_unit(r->step.sun_direction.z);
    b->wind_direction = (bolan_vec2){1, 0};
    b->cloud_cover = (float)s->cloud_cover;
    b->cloud_base = (float)s->cloud_base;
    b->visibility = (float)s->visibility;
    b->earth_radius = (float)BOLAN_EARTH_RADIUS;
    b->water_reflectance = bolan_v3(0.0005f, 0.003f, 0.006f);
    b->water_index = 1.34f;
    bolan_view_fill(&r->f);
    rig_upload(r);
    bolan_pass_sky_prepare(r->sky, &r->f);
    bolan_view_fill(&r->f);
    rig_upload(r);
}

static inline void rig_draw(sky_rig *r) {
    bolan_gl_target_bind(&r->hdr);
    bolan_gl_target_clear_color(0, 0, 0, 0);
    bolan_gl_target_clear_depth(0);
    bolan_pass_sky_draw(r->sky, &r->f, false);
}

static inline void rig_destroy(sky_rig *r) {
    bolan_pass_sky_destroy(&r->sky);
    bolan_pass_tonemap_destroy(&r->tonemap);
    bolan_blocks_free(&r->uniforms);
    bolan_gl_target_free(&r->hdr);
    bolan_gl_target_free(&r->display);
    bolan_gl_texture_free(&r->color);
    bolan_gl_texture_free(&r->depth);
    bolan_gl_texture_free(&r->out);
}

#endif

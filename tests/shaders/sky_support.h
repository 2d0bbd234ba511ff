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
    bolan_scene scene;
    bolan_frame_desc desc;
    frame f;
    pass_sky *sky;
    pass_tonemap *tonemap;
    gl_texture color, depth, out;
    gl_target hdr, display;
    block_buffers uniforms;
} sky_rig;

static inline void rig_create(sky_rig *r, uint32_t width, uint32_t height) {
    memset(r, 0, sizeof *r);
    r->caps = bolan_gl_get_caps();
    assert_int_equal(bolan_pass_sky_create(&r->caps, &r->sky), BOLAN_OK);
    assert_int_equal(bolan_pass_tonemap_create(&r->caps, &r->tonemap), BOLAN_OK);
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
    r->scene.sky = (bolan_sky){
        .sun_azimuth_deg = 180, .sun_elevation_deg = 35, .visibility = 40000, .cloud_base = 1200, .cloud_seed = 1};
    r->scene.camera.fov_deg = 50;
    r->desc = (bolan_frame_desc){
        .scene = &r->scene, .framebuffer = r->display.id, .width = width, .height = height, .samples = 1};
    r->f = (frame){.desc = &r->desc,
                   .scene = &r->scene,
                   .caps = &r->caps,
                   .quality = BOLAN_QUALITY_LOW,
                   .hdr = r->hdr,
                   .hdr_depth = &r->depth};
}

static inline void rig_upload(sky_rig *r) { bolan_blocks_upload(&r->uniforms, &r->f.uniforms); }

// Uniforms of the scene's sky and camera, as the renderer sets them; then the pass's tables.
static inline void rig_prepare(sky_rig *r) {
    const bolan_sky *s = &r->scene.sky;
    const bolan_camera *c = &r->scene.camera;
    block_values *u = &r->f.uniforms;
    const double azimuth = bolan_radians(s->sun_azimuth_deg), elevation = bolan_radians(s->sun_elevation_deg);
    const double fov = bolan_radians(c->fov_deg), width = r->desc.width, height = r->desc.height;
    bolan_gl_set_clip_zero_to_one(r->caps.clip_control);
    r->f.eye = c->position;
    r->f.view = bolan_m4_view(c->heading_deg, c->pitch_deg, c->roll_deg);
    r->f.projection = bolan_m4_projection(fov, width / height, 0.1, r->caps.clip_control);
    r->f.sun_direction =
        bolan_v3((float)(sin(azimuth) * cos(elevation)), (float)(cos(azimuth) * cos(elevation)), (float)sin(elevation));
    u->view.view_projection = bolan_m4_mul(r->f.projection, r->f.view);
    u->view.inverse_view_projection = bolan_m4_inverse(u->view.view_projection);
    bolan_view_block_resize(&u->view, r->desc.width, r->desc.height);
    u->view.eye_height = (float)c->position.z;
    u->view.radians_per_pixel = (float)(2.0 * tan(0.5 * fov) / height);
    u->view.near_distance = 0.1f;
    u->view.clip_zero_to_one = r->caps.clip_control ? 1.0f : 0.0f;
    u->frame.sun_direction = r->f.sun_direction;
    u->frame.wind_direction = (bolan_vec2){1, 0};
    u->frame.cloud_cover = (float)s->cloud_cover;
    u->frame.cloud_base = (float)s->cloud_base;
    u->frame.visibility = (float)s->visibility;
    u->frame.earth_radius = (float)BOLAN_EARTH_RADIUS;
    u->frame.water_reflectance = bolan_v3(0.0005f, 0.003f, 0.006f);
    u->frame.water_index = 1.34f;
    rig_upload(r);
    bolan_pass_sky_prepare(r->sky, &r->f);
    rig_upload(r);
}

static inline void rig_draw(sky_rig *r) {
    bolan_gl_target_bind(&r->hdr);
    bolan_gl_target_clear_color(0, 0, 0, 0);
    bolan_gl_target_clear_depth(0);
    bolan_pass_sky_draw(r->sky, &r->f);
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

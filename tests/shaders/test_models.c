// SPDX-License-Identifier: MIT
// Objects on the GPU: where a box comes to stand in the picture, what clipping, the vertical scale and the three
// classes leave of it, and how it floats.
#include "gl_support.h"

#include "bolan/earth.h"
#include "bolan/query.h"
#include "render/frame.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 256 };

// A camera 20 m south of the origin looks north along the water's plane through a window of 90 degrees: a point at
// height z over the origin stands at row SIDE / 2 * (1 + z / 20).
typedef struct rig {
    gl_caps caps;
    bolan_scene scene;
    frame step;
    render_view frame;
    block_buffers uniforms;
    gl_texture color, depth;
    pass_objects *pass;
    bolan_sea *sea;
    bolan_model *box;
    const bolan_model *models[2];
    float *pixels;
} rig;

// A box of 4 m whose bottom stands at `bottom`.
static bolan_model *box_model(float bottom) {
    static const uint32_t faces[36] = {0, 1, 5, 0, 5, 4, 3, 2, 6, 3, 6, 7, 1, 3, 7, 1, 7, 5,
                                       2, 0, 4, 2, 4, 6, 4, 5, 7, 4, 7, 6, 2, 3, 1, 2, 1, 0};
    bolan_vec3 p[8], n[8];
    bolan_vec4 c[8];
    for (int i = 0; i < 8; i++) {
        p[i] = bolan_v3(i & 1 ? 2.0f : -2.0f, i & 2 ? 2.0f : -2.0f, bottom + (i & 4 ? 4.0f : 0.0f));
        n[i] = bolan_v3(0.0f, -1.0f, 0.0f);
        c[i] = (bolan_vec4){0.5f, 0.5f, 0.5f, 1.0f};
    }
    bolan_model *m = NULL;
    assert_int_equal(bolan_model_create(&(bolan_model_view){8, 36, p, n, c, faces}, &m), BOLAN_OK);
    return m;
}

static void rig_open(rig *r, float bottom) {
    *r = (rig){.caps = bolan_gl_get_caps(), .scene = bolan_scene_default(), .box = box_model(bottom)};
    r->models[0] = r->models[1] = r->box;
    r->scene.object_count = 1;
    r->scene.objects[0] = (bolan_object){.scale = 1.0};
    r->scene.sea.resolution = 64;
    assert_int_equal(bolan_sea_create(&r->scene.sea, &r->sea), BOLAN_OK);
    r->step = (frame){.caps = &r->caps,
                      .quality = BOLAN_QUALITY_LOW,
                      .sea = r->sea,
                      .water = {.sea = r->sea},
                      .scene = &r->scene,
                      .models = r->models};
    r->frame = (render_view){.frame = &r->step, .width = SIDE, .height = SIDE, .pixel_scale = 1.0f};
    gl_texture_desc c = {.format = GL_FMT_RGBA16F, .width = SIDE, .height = SIDE, .filter = GL_FILTER_NEAREST};
    gl_texture_desc d = {.format = GL_FMT_DEPTH32F, .width = SIDE, .height = SIDE, .filter = GL_FILTER_NEAREST};
    assert_int_equal(bolan_gl_texture_create(&c, &r->color), BOLAN_OK);
    assert_int_equal(bolan_gl_texture_create(&d, &r->depth), BOLAN_OK);
    const gl_texture *colors[] = {&r->color};
    assert_int_equal(bolan_gl_target_create(colors, 1, &r->depth, -1, 0, &r->frame.hdr), BOLAN_OK);
    assert_int_equal(bolan_blocks_create(&r->uniforms), BOLAN_OK);
    assert_int_equal(bolan_pass_objects_create(&r->caps, &r->pass), BOLAN_OK);
    r->pixels = malloc(sizeof(float) * 4 * SIDE * SIDE);
}

static void rig_close(rig *r) {
    bolan_pass_objects_destroy(&r->pass);
    bolan_gl_target_free(&r->frame.hdr);
    bolan_gl_texture_free(&r->color), bolan_gl_texture_free(&r->depth);
    bolan_blocks_free(&r->uniforms);
    bolan_sea_destroy(&r->sea);
    bolan_model_destroy(&r->box);
    free(r->pixels);
}

static const bolan_vec4 everything = {0.0f, 0.0f, 1.0f, 0.0f};

// clip: clip_side, clip_elevation, refraction_raise, refraction_mode of the view.
static void draw(rig *r, bolan_vec4 clip) {
    render_view *f = &r->frame;
    f->picture = clip.x != 0.0f;
    const bool zero_to_one = r->caps.clip_control;
    f->eye = bolan_dv3(0.0, -20.0, 0.0);
    f->triangles = 0;
    r->step.block = (frame_block){.sun_direction = {0.0f, -0.6f, 0.8f},
                                  .cloud_base = 1200.0f,
                                  .visibility = 40000.0f,
                                  .earth_radius = (float)BOLAN_EARTH_RADIUS};
    f->block = (view_block){.sun_light = {1.0f, 1.0f, 1.0f},
                            .exposure = {1.0f, 1.0f, 1.0f},
                            .sky_light = {1.0f, 1.0f, 1.0f},
                            .radians_per_pixel = 0.01f,
                            .near_distance = 0.2f,
                            .clip_zero_to_one = zero_to_one ? 1.0f : 0.0f,
                            .clip_side = clip.x,
                            .clip_elevation = clip.y,
                            .refraction_raise = clip.z,
                            .refraction_mode = clip.w};
    bolan_view_block_resize(&f->block, SIDE, SIDE);
    f->view = bolan_m4_view(0.0, 0.0, 0.0);
    f->projection = bolan_m4_projection(0.5 * BOLAN_PI, 1.0, 0.2, zero_to_one);
    f->block.view_projection = bolan_m4_mul(f->projection, f->view);
    f->block.inverse_view_projection = bolan_m4_inverse(f->block.view_projection);
    if (r->caps.clip_control) bolan_gl_set_clip_zero_to_one(zero_to_one);
    bolan_blocks_upload_frame(&r->uniforms, &r->step.block);
    bolan_blocks_upload_view(&r->uniforms, &f->block);
    bolan_pass_objects_prepare(r->pass, f);
    bolan_gl_set_state(&(gl_state){.depth_test = true, .depth_write = true, .color_write = true});
    bolan_gl_target_bind(&f->hdr);
    bolan_gl_target_clear_color(0.0f, 0.0f, 0.0f, 0.0f);
    bolan_gl_target_clear_depth(0.0f);
    bolan_pass_objects_draw(r->pass, f);
    bolan_gl_target_read_float(&f->hdr, 0, r->pixels);
    assert_true(watch_is_clean("models"));
}

// Lowest and highest height [m] of what is drawn in the column through the origin, in the plane of the box's south
// face, 18 m away.
static bool extent(const rig *r, float *low, float *high) {
    int first = -1, last = -1;
    for (int j = 0; j < SIDE; j++) {
        if (r->pixels[4 * (j * SIDE + SIDE / 2) + 3] == 0.0f) continue;
        if (first < 0) first = j;
        last = j;
    }
    *low = 18.0f * (2.0f * (float)first / SIDE - 1.0f);
    *high = 18.0f * (2.0f * (float)(last + 1) / SIDE - 1.0f);
    return first >= 0;
}

#define PIXEL (2.0 * 18.0 / SIDE) // [m] in the plane of that face

static void a_box_stands_where_it_is_put(void **state) {
    (void)state;
    rig r;
    float low, high;
    rig_open(&r, -1.0f);
    draw(&r, everything);
    assert_true(extent(&r, &low, &high));
    assert_near(low, -1.0, PIXEL);
    assert_near(high, 3.0, PIXEL);
    assert_int_equal(r.frame.triangles, 12);
    r.scene.objects[0].position.z = 2.0;
    draw(&r, everything);
    assert_true(extent(&r, &low, &high));
    assert_near(low, 1.0 * 18.0 / 22.0, PIXEL); // from below its far edge is seen, at 22 m
    r.step.models = NULL;
    draw(&r, everything);
    assert_false(extent(&r, &low, &high));
    rig_close(&r);
}

static void its_light_is_that_of_sun_and_sky(void **state) {
    (void)state;
    rig r;
    rig_open(&r, -1.0f);
    draw(&r, everything);
    // A wall to the south: the sun comes in at a cosine of 0.6, half of the sky is open; the air's tables are empty, so
    // the shadow of the clouds is whole: sky alone, 0.5, and half of the light from around, (0.6 * 0.8 + 1) (.13, .14,
    // .08). An absent texture is black and opaque: the grain's red and alpha add up to its mean.
    const int row = SIDE / 2 + (int)(1.0 / PIXEL); // 1 m over the water, where it is dry
    const float *p = r.pixels + 4 * (row * SIDE + SIDE / 2);
    assert_near(p[1], 0.5 / BOLAN_PI * (0.5 + 0.5 * 1.48 * 0.14), 2e-3); // half floats, and clear air over 18 m
    rig_close(&r);
}

static void clipping_keeps_one_side(void **state) {
    (void)state;
    rig r;
    float low, high;
    rig_open(&r, -1.0f);
    draw(&r, (bolan_vec4){1.0f, 0.0f, 1.0f, 0.0f});
    assert_true(extent(&r, &low, &high));
    assert_near(low, 0.0, PIXEL);
    assert_near(high, 3.0, PIXEL);
    draw(&r, (bolan_vec4){-1.0f, 0.0f, 1.0f, 0.0f});
    assert_true(extent(&r, &low, &high));
    assert_near(low, -1.0, PIXEL);
    assert_near(high, 0.0, PIXEL);
    draw(&r, (bolan_vec4){-1.0f, 1.0f, 1.0f, 0.0f});
    assert_true(extent(&r, &low, &high));
    assert_near(high, 1.0, PIXEL);
    rig_close(&r);
}

// z' = level + k (z - level), Ma, Zhu & Gong 2006, refraction pass.
static void the_vertical_scale_raises_the_bottom(void **state) {
    (void)state;
    rig r;
    float low, high;
    rig_open(&r, -4.0f);
    draw(&r, (bolan_vec4){-1.0f, 0.0f, 0.75f, 1.0f});
    assert_true(extent(&r, &low, &high));
    assert_near(low, -3.0, PIXEL);
    assert_near(high, 0.0, PIXEL);
    rig_close(&r);
}

static void objects_fall_into_three_classes(void **state) {
    (void)state;
    static const struct {
        float bottom;
        uint32_t above, below; // triangles in the picture of what is above, of what is below
    } boxes[] = {
        {0.5f, 12, 0}, {-2.0f, 10, 10}, {-5.0f, 0, 12}}; // where it stands in the water, lid and bottom are in one each
    for (int b = 0; b < 3; b++) {
        rig r;
        rig_open(&r, boxes[b].bottom);
        draw(&r, (bolan_vec4){1.0f, 0.0f, 1.0f, 0.0f});
        assert_int_equal(r.frame.triangles, boxes[b].above);
        draw(&r, (bolan_vec4){-1.0f, 0.0f, 1.0f, 0.0f});
        assert_int_equal(r.frame.triangles, boxes[b].below);
        rig_close(&r);
    }
}

static void what_floats_follows_the_water(void **state) {
    (void)state;
    rig r;
    rig_open(&r, -1.0f);
    r.scene.objects[0].floats = true;
    for (int i = 0; i < 4; i++) {
        static const double at[5][2] = {{0, 0}, {0, 1.6}, {0, -1.6}, {1.6, 0}, {-1.6, 0}};
        float low, high, mean = 0.0f;
        bolan_sea_step(r.sea, 3.0 + 2.5 * i);
        for (int k = 0; k < 5; k++) {
            bolan_query_point water;
            bolan_query_surface(&(bolan_water){.sea = r.sea}, &(bolan_dvec2){at[k][0], at[k][1]}, 1, &water);
            mean += 0.2f * water.height;
        }
        draw(&r, everything);
        assert_true(extent(&r, &low, &high));
        // The middle of the south face; the box tilts by up to 0.2 about a point 2 m behind it.
        assert_near(0.5f * (low + high), 1.0f + mean, 0.2 * 2.0 + PIXEL);
    }
    rig_close(&r);
}

static void a_changed_model_is_uploaded_again(void **state) {
    (void)state;
    rig r;
    float low, high;
    rig_open(&r, -1.0f);
    draw(&r, everything);
    bolan_model *other = box_model(2.0f);
    r.models[0] = other;
    draw(&r, everything);
    assert_true(extent(&r, &low, &high));
    assert_near(low, 2.0 * 18.0 / 22.0, PIXEL); // its far edge
    bolan_model_destroy(&other);
    rig_close(&r);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        IN_BOTH_APIS(a_box_stands_where_it_is_put),      IN_BOTH_APIS(its_light_is_that_of_sun_and_sky),
        IN_BOTH_APIS(clipping_keeps_one_side),           IN_BOTH_APIS(the_vertical_scale_raises_the_bottom),
        IN_BOTH_APIS(objects_fall_into_three_classes),   IN_BOTH_APIS(what_floats_follows_the_water),
        IN_BOTH_APIS(a_changed_model_is_uploaded_again),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

// SPDX-License-Identifier: MIT
// The terrain pass in a context: no cracks, the shore map, and the shader's twin of bolan_coast_attenuation().
#include "bolan/coast.h"
#include "bolan/earth.h"
#include "probe.h"

#include <math.h>

#include "render/frame.h"
#include "render/shore_map.h"

static void attenuation_is_the_twin_of_the_library_s(void **state) {
    (void)state;
    enum { COUNT = 250 };
    float in[COUNT][4] = {{0}}, out[COUNT][4];
    for (int i = 0; i < COUNT; i++) {
        in[i][0] = i < 5 ? -1.0f + 0.25f * (float)i : 0.02f * expf(0.03f * (float)i);
        in[i][1] = 0.0f + 0.13f * (float)(i % 40);
    }
    probe_run("#include \"common/frame.glsl\"\n#include \"common/shore.glsl\"",
              "vec4 probe(vec4 x) { return vec4(coast_attenuation(x.x, x.y), shore_elevation(x.xy), 0.0, 0.0); }", in,
              COUNT, out);
    for (int i = 0; i < COUNT; i++) {
        // the same rational function; GPUs may divide to 2.5 ulp
        assert_true(fabsf(out[i][0] - bolan_coast_attenuation(in[i][0], in[i][1])) < 1e-6f);
        assert_true(out[i][1] == -1000.0f); // no terrain was set
    }
}

static void attenuations_of_bands_are_the_twin_of_the_library_s(void **state) {
    (void)state;
    enum { COUNT = 200 };
    static const float band_hs[4] = {2.5f, 3.1f, 0.6f, 0.0f};
    float in[COUNT][4] = {{0}}, out[COUNT][4];
    for (int i = 0; i < COUNT; i++) in[i][0] = i < 5 ? -1.0f + 0.25f * (float)i : 0.02f * expf(0.04f * (float)i);
    probe_run("#include \"common/frame.glsl\"\n#include \"common/shore.glsl\"",
              "vec4 probe(vec4 x) { return coast_attenuations(x.x, vec4(2.5, 3.1, 0.6, 0.0)); }", in, COUNT, out);
    for (int i = 0; i < COUNT; i++) {
        float keep[4];
        bolan_coast_attenuations(in[i][0], band_hs, 3, keep);
        for (int c = 0; c < 3; c++) assert_near(out[i][c], keep[c], 4e-6); // a square root and a quotient more
    }
}

// ---- a frame by hand
// -------------------------------------------------------------------------------------------------

enum { WIDTH = 480, HEIGHT = 320 };

typedef struct stage {
    gl_caps caps;
    bolan_scene scene;
    frame step;
    render_view frame;
    block_buffers uniforms;
    gl_texture color, depth;
    pass_ground *pass;
    bolan_ground *terrain;
    size_t memory; // in use before
} stage;

// Rough hills without sea: whatever lies under the horizon is ground.
static bolan_ground *rough_hills(void) {
    enum { N = 65 };
    static float z[N * N];
    for (int n = 0; n < N * N; n++) {
        int i = n % N, j = n / N;
        z[n] = (float)(120.0 + 90.0 * sin(0.9 * i) * cos(0.7 * j) + 60.0 * sin(2.1 * i + 1.3 * j));
    }
    bolan_ground_desc d = bolan_ground_desc_default();
    d.field = (bolan_heightfield){N, N, -12800.0, -12800.0, 400.0, 400.0, z};
    d.edge_elevation = 0.0;
    bolan_ground *t = NULL;
    assert_int_equal(bolan_ground_create(&d, &t), BOLAN_OK);
    return t;
}

static void stage_open(stage *s) {
    const size_t memory = bolan_memory_in_use();
    *s = (stage){
        .memory = memory, .caps = bolan_gl_get_caps(), .scene = bolan_scene_default(), .terrain = rough_hills()};
    s->step = (frame){.caps = &s->caps, .quality = BOLAN_QUALITY_LOW, .ground = s->terrain, .scene = &s->scene};
    s->frame = (render_view){.frame = &s->step, .width = WIDTH, .height = HEIGHT};
    s->step.sun_direction = bolan_v3(0.5f, 0.3f, 0.8124f);
    gl_texture_desc c = {.format = GL_FMT_RGBA16F, .width = WIDTH, .height = HEIGHT, .filter = GL_FILTER_NEAREST};
    gl_texture_desc d = {.format = GL_FMT_DEPTH32F, .width = WIDTH, .height = HEIGHT, .filter = GL_FILTER_NEAREST};
    assert_int_equal(bolan_gl_texture_create(&c, &s->color), BOLAN_OK);
    assert_int_equal(bolan_gl_texture_create(&d, &s->depth), BOLAN_OK);
    const gl_texture *colors[] = {&s->color};
    assert_int_equal(bolan_gl_target_create(colors, 1, &s->depth, -1, 0, &s->frame.hdr), BOLAN_OK);
    assert_int_equal(bolan_blocks_create(&s->uniforms), BOLAN_OK);
    assert_int_equal(bolan_pass_ground_create(&s->caps, NULL, &s->pass), BOLAN_OK);
}

static void stage_close(stage *s) {
    bolan_pass_ground_destroy(&s->pass);
    bolan_gl_target_free(&s->frame.hdr);
    bolan_gl_texture_free(&s->color), bolan_gl_texture_free(&s->depth);
    bolan_blocks_free(&s->uniforms);
    bolan_ground_destroy(&s->terrain);
    assert_int_equal(bolan_memory_in_use(), s->memory);
}

static void draw(stage *s, bolan_dvec3 eye, double heading, double pitch) {
    render_view *f = &s->frame;
    bool zero_to_one = s->caps.clip_control;
    f->eye = eye;
    s->step.block = (frame_block){.sun_direction = {0.5f, 0.3f, 0.8124f},
                                  .cloud_base = 1200.0f,
                                  .visibility = 40000.0f,
                                  .earth_radius = (float)BOLAN_EARTH_RADIUS};
    f->block = (view_block){.eye_height = (float)eye.z,
                            .sun_light = {1.0f, 1.0f, 1.0f},
                            .exposure = {1.0f, 1.0f, 1.0f},
                            .sky_light = {0.3f, 0.3f, 0.3f},
                            .radians_per_pixel = (float)(2.0 * tan(0.5) / HEIGHT),
                            .near_distance = 0.2f,
                            .clip_zero_to_one = zero_to_one ? 1.0f : 0.0f};
    bolan_view_block_resize(&f->block, WIDTH, HEIGHT);
    f->view = bolan_m4_view(heading, pitch, 0.0);
    f->projection = bolan_m4_projection(1.0, (double)WIDTH / HEIGHT, 0.2, zero_to_one);
    f->block.view_projection = bolan_m4_mul(f->projection, f->view);
    f->block.inverse_view_projection = bolan_m4_inverse(f->block.view_projection);
    if (s->caps.clip_control) bolan_gl_set_clip_zero_to_one(zero_to_one);
    bolan_blocks_upload_frame(&s->uniforms, &s->step.block);
    bolan_blocks_upload_view(&s->uniforms, &f->block);
    bolan_pass_ground_prepare(s->pass, f);
    bolan_gl_set_state(&(gl_state){.depth_test = true, .depth_write = true, .color_write = true});
    bolan_gl_target_bind(&f->hdr);
    bolan_gl_target_clear_color(1.0f, 0.0f, 1.0f, 1.0f);
    bolan_gl_target_clear_depth(0.0f);
    f->triangles = 0;
    bolan_pass_ground_draw(s->pass, f);
}

// Pixels of a column that show the background although there is ground above them in the picture.
static int holes(stage *s) {
    static float depth[WIDTH * HEIGHT];
    read_depths(&s->depth, depth);
    int count = 0;
    for (int x = 0; x < WIDTH; x++) {
        bool ground_above = false;
        for (int y = HEIGHT - 1; y >= 0; y--) {
            bool ground = depth[y * WIDTH + x] > 0.0f;
            count += ground_above && !ground;
            ground_above = ground_above || ground;
        }
    }
    return count;
}

static void no_background_shows_through_the_ground(void **state) {
    (void)state;
    stage s;
    stage_open(&s);
    const double views[][5] = {{0, 0, 330, 0, -12},    {730, -410, 290, 77, -3},      {-2100, 900, 900, 160, -25},
                               {0, 0, 5000, 250, -40}, {3000, 3000, 12000, 220, -60}, {40, 50, 310, 300, -35}};
    for (size_t n = 0; n < sizeof views / sizeof views[0]; n++) {
        draw(&s, bolan_dv3(views[n][0], views[n][1], views[n][2]), views[n][3], views[n][4]);
        assert_true(s.frame.triangles > 500);
        assert_int_equal(holes(&s), 0);
    }
    stage_close(&s);
}

static void flying_on_leaves_no_holes_while_chunks_are_rationed(void **state) {
    (void)state;
    stage s;
    stage_open(&s);
    for (int n = 0; n < 12; n++) { // 40 m a frame at 400 m: new chunks come a few at a time
        draw(&s, bolan_dv3(-500.0 + 40.0 * n, 200.0, 420.0), 80.0, -10.0);
        assert_int_equal(holes(&s), 0);
    }
    stage_close(&s);
}

static void what_is_drawn_lies_where_the_terrain_is(void **state) {
    (void)state;
    stage s;
    stage_open(&s);
    static float depth[WIDTH * HEIGHT];
    const bolan_dvec3 eye = bolan_dv3(150.0, -220.0, 700.0);
    draw(&s, eye, 30.0, -35.0);
    read_depths(&s.depth, depth);
    for (int y = 40; y < HEIGHT; y += 40) {
        for (int x = 20; x < WIDTH; x += 40) {
            float d = depth[y * WIDTH + x], window = s.caps.clip_control ? d : 2.0f * d - 1.0f;
            if (d <= 0.0f) continue;
            bolan_vec4 clip = {((float)x + 0.5f) / WIDTH * 2.0f - 1.0f, ((float)y + 0.5f) / HEIGHT * 2.0f - 1.0f,
                               window, 1.0f};
            bolan_vec4 p = bolan_m4_mul_v4(s.frame.block.inverse_view_projection, clip);
            double px = p.x / p.w, py = p.y / p.w, pz = p.z / p.w, distance = sqrt(px * px + py * py + pz * pz);
            double ground = bolan_ground_elevation(s.terrain, eye.x + px, eye.y + py, 0.0) - eye.z;
            ground -= (px * px + py * py) / (2.0 * BOLAN_EARTH_RADIUS);
            // LOW lets the mesh depart by 6 pixels at most, and leaves out detail below its texels of 6.5 pixels
            double pixel = s.frame.block.radians_per_pixel * distance;
            assert_true(fabs(pz - ground) < 12.0 * pixel + 0.5);
        }
    }
    stage_close(&s);
}

static void the_shore_map_follows_the_eye_without_changing_a_texel(void **state) {
    (void)state;
    stage s;
    stage_open(&s);
    shore_builder b = {0};
    assert_int_equal(bolan_shore_builder_create(&b), BOLAN_OK);
    s.scene.water.level = 1.5;
    const double path[][3] = {{0, 0, 20}, {70, -65, 20}, {-400, 300, 25}, {-390, 310, 3000}, {5000, 5000, 30}};
    for (int n = 0; n < 5; n++) {
        s.frame.eye = bolan_dv3(path[n][0], path[n][1], path[n][2]);
        bolan_shore_builder_update(&b, &s.frame);
        assert_true(b.map.present);
        for (int l = 0; l < SHORE_LEVELS; l++) {
            double texel = b.level[l].texel, half = 0.5 * SHORE_SIZE * texel;
            assert_true(fabs(b.level[l].west + half - path[n][0]) <= 16.0 * texel); // the eye stays in the middle
            assert_true(fabs(b.map.level[l][0] - (b.level[l].west - path[n][0])) < 0.01);
            for (int k = 0; k < 200; k++) {
                int i = k * 97 % SHORE_SIZE, j = k * 61 % SHORE_SIZE;
                double x = b.level[l].west + (i + 0.5) * texel, y = b.level[l].south + (j + 0.5) * texel;
                // texel centres are sums in another order after a shift: the last bit of a double in x
                assert_true(fabs(b.level[l].elevation[j * SHORE_SIZE + i] -
                                 bolan_ground_elevation(s.terrain, x, y, texel)) < 1e-3);
            }
        }
    }
    bolan_shore_builder_free(&b);
    stage_close(&s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        IN_BOTH_APIS(attenuation_is_the_twin_of_the_library_s),
        IN_BOTH_APIS(attenuations_of_bands_are_the_twin_of_the_library_s),
        IN_BOTH_APIS(no_background_shows_through_the_ground),
        IN_BOTH_APIS(flying_on_leaves_no_holes_while_chunks_are_rationed),
        IN_BOTH_APIS(what_is_drawn_lies_where_the_terrain_is),
        IN_BOTH_APIS(the_shore_map_follows_the_eye_without_changing_a_texel),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

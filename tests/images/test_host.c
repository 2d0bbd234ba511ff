// SPDX-License-Identifier: MIT
// The water drawn into a host's frame: over Bolan's own sky, ground and objects it is the water of Bolan's own picture,
// whatever the host's depth means, whichever part of the framebuffer it draws into, and its depth is its distance.
#include "../support.h"
#include "picture.h"

#include <epoxy/gl.h>

enum { WIDTH = 320, HEIGHT = 180, MARGIN = 8, WHOLE_WIDTH = WIDTH + 2 * MARGIN, WHOLE_HEIGHT = HEIGHT + 2 * MARGIN };
#define NEAR 0.5
#define FAR 1e5

// A host's perspective: how it keeps depth, beside where things are.
typedef struct convention {
    bool reversed, zero_to_one, infinite;
} convention;

// Window depth at distance t, written down from the usual matrices: nobody's code but the textbook's.
static double window_depth(convention c, double t) {
    const double share = isinf(t)     ? (c.infinite ? 1.0 : 1.0)
                         : c.infinite ? 1.0 - NEAR / t
                                      : (1.0 - NEAR / t) / (1.0 - NEAR / FAR);
    return c.reversed ? 1.0 - share : share;
}

static bolan_mat4 projection_of(convention c, double fov_y, double aspect) {
    const double f = 1.0 / tan(0.5 * fov_y), n = NEAR;
    // standard depth in [0,1]: z = p Z + q, w = -Z
    double p = c.infinite ? -1.0 : -FAR / (FAR - n), q = c.infinite ? -n : -FAR * n / (FAR - n);
    if (c.reversed) p = -1.0 - p, q = -q;            // 1 - z
    if (!c.zero_to_one) p = 2.0 * p + 1.0, q *= 2.0; // 2 z - 1
    bolan_mat4 m = {{0}};
    m.m[0] = (float)(f / aspect), m.m[5] = (float)f, m.m[10] = (float)p, m.m[14] = (float)q, m.m[11] = -1.0f;
    return m;
}

typedef struct host_rig {
    stage s;
    bolan_water water;
    bolan_lighting lighting;
    float radiance[3 * WIDTH * HEIGHT], distance[WIDTH * HEIGHT];
    uint8_t opaque[3 * WIDTH * HEIGHT]; // the world without its water
    picture whole;                      // and with it
    GLuint color, depth, shown, framebuffer;
} host_rig;

static void draw_opaque(host_rig *h) {
    bolan_target *target = NULL;
    assert_int_equal(bolan_target_create(WIDTH, HEIGHT, &target), BOLAN_OK);
    bolan_view view = stage_view(&h->s, target, WIDTH, HEIGHT);
    view.without_water = true;
    bolan_renderer_draw_world(h->s.renderer, h->s.world, &view);
    bolan_renderer_read_rgb8(h->s.renderer, view.framebuffer, WIDTH, HEIGHT, h->opaque);
    bolan_renderer_read_linear(h->s.renderer, h->radiance, h->distance);
    bolan_target_destroy(&target);
}

static GLuint texture_of(GLenum format) {
    GLuint id;
    glGenTextures(1, &id);
    glBindTexture(GL_TEXTURE_2D, id); // its filter is the default, which wants levels that it has not
    glTexStorage2D(GL_TEXTURE_2D, 1, format, WHOLE_WIDTH, WHOLE_HEIGHT);
    return id;
}

static void rig_open(host_rig *h, const char *scene_name) {
    bolan_scene scene;
    assert_int_equal(bolan_scene_load(scene_name, &scene), BOLAN_OK);
    assert_true(stage_open(&h->s, &scene, BOLAN_QUALITY_MEDIUM, false));
    h->water = *bolan_world_water(h->s.world);
    h->lighting = bolan_lighting_from_scene(&h->s.scene);
    h->whole = stage_draw(&h->s, WIDTH, HEIGHT, 1);
    draw_opaque(h);
    h->color = texture_of(GL_RGBA32F);
    h->depth = texture_of(GL_DEPTH_COMPONENT32F);
    h->shown = texture_of(GL_RGBA8);
    glGenFramebuffers(1, &h->framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, h->framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, h->shown, 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, h->depth, 0);
    assert_int_equal(glCheckFramebufferStatus(GL_FRAMEBUFFER), GL_FRAMEBUFFER_COMPLETE);
}

static void rig_close(host_rig *h) {
    glDeleteFramebuffers(1, &h->framebuffer);
    const GLuint textures[] = {h->color, h->depth, h->shown};
    glDeleteTextures(3, textures);
    picture_free(&h->whole);
    stage_close(&h->s);
}

// The host's frame before the water: its picture in the middle, a margin that is grey.
static void fill(host_rig *h, convention c) {
    static float color[WHOLE_WIDTH * WHOLE_HEIGHT][4], depth[WHOLE_WIDTH * WHOLE_HEIGHT];
    static uint8_t shown[WHOLE_WIDTH * WHOLE_HEIGHT][4];
    memset(color, 0, sizeof color);
    memset(shown, 77, sizeof shown);
    for (int i = 0; i < WHOLE_WIDTH * WHOLE_HEIGHT; ++i) depth[i] = (float)window_depth(c, INFINITY);
    for (int y = 0; y < HEIGHT; ++y)
        for (int x = 0; x < WIDTH; ++x) {
            const int to = (HEIGHT - 1 - y + MARGIN) * WHOLE_WIDTH + x + MARGIN, from = y * WIDTH + x;
            depth[to] = (float)window_depth(c, (double)h->distance[from]);
            for (int k = 0; k < 3; ++k) {
                color[to][k] = 3.0f * h->radiance[3 * from + k]; // the host's unit is a third of ours
                shown[to][k] = h->opaque[3 * from + k];
            }
        }
    glBindTexture(GL_TEXTURE_2D, h->color);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, WHOLE_WIDTH, WHOLE_HEIGHT, GL_RGBA, GL_FLOAT, color);
    glBindTexture(GL_TEXTURE_2D, h->depth);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, WHOLE_WIDTH, WHOLE_HEIGHT, GL_DEPTH_COMPONENT, GL_FLOAT, depth);
    glBindTexture(GL_TEXTURE_2D, h->shown);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, WHOLE_WIDTH, WHOLE_HEIGHT, GL_RGBA, GL_UNSIGNED_BYTE, shown);
}

static picture draw(host_rig *h, convention c) {
    const bolan_camera *camera = &h->s.scene.camera;
    bolan_view view = bolan_view_from_camera(camera, WIDTH, HEIGHT);
    view.projection = projection_of(c, bolan_radians(camera->fov_deg), (double)WIDTH / HEIGHT);
    view.zero_to_one = c.zero_to_one;
    view.framebuffer = h->framebuffer;
    view.x = view.y = MARGIN;
    const bolan_host host = {.color = h->color, .depth = h->depth, .x = MARGIN, .y = MARGIN, .radiance = 3.0};
    fill(h, c);
    bolan_renderer_prepare(h->s.renderer, &h->water, &h->lighting);
    bolan_renderer_draw_water(h->s.renderer, &view, &host);
    static uint8_t shown[WHOLE_WIDTH * WHOLE_HEIGHT * 3];
    static float depth[WHOLE_WIDTH * WHOLE_HEIGHT];
    bolan_renderer_read_rgb8(h->s.renderer, h->framebuffer, WHOLE_WIDTH, WHOLE_HEIGHT, shown);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, h->framebuffer);
    glReadPixels(0, 0, WHOLE_WIDTH, WHOLE_HEIGHT, GL_DEPTH_COMPONENT, GL_FLOAT, depth);
    picture p = {WIDTH, HEIGHT, malloc(WIDTH * HEIGHT * 3), malloc(sizeof(float) * WIDTH * HEIGHT)};
    for (int y = 0; y < WHOLE_HEIGHT; ++y)
        for (int x = 0; x < WHOLE_WIDTH; ++x) {
            const int i = x - MARGIN, j = y - MARGIN;
            const uint8_t *rgb = shown + 3 * (y * WHOLE_WIDTH + x);
            if (i < 0 || j < 0 || i >= WIDTH || j >= HEIGHT) {
                assert_int_equal(rgb[0], 77); // nothing outside the rectangle is touched
                continue;
            }
            memcpy(p.rgb + 3 * (j * WIDTH + i), rgb, 3);
            p.distance[j * WIDTH + i] = depth[(WHOLE_HEIGHT - 1 - y) * WHOLE_WIDTH + x];
        }
    assert_true(watch_is_clean("after the water"));
    return p;
}

static const convention conventions[] = {{true, true, true},   {true, true, false},  {true, false, true},
                                         {true, false, false}, {false, true, true},  {false, true, false},
                                         {false, false, true}, {false, false, false}};

static void compare(host_rig *h, const char *scene_name) {
    for (size_t i = 0; i < sizeof conventions / sizeof conventions[0]; ++i) {
        picture p = draw(h, conventions[i]);
        const double psnr = picture_psnr(&h->whole, &p);
        print_message("%s, reversed %d, [0,1] %d, infinite %d: %.1f dB\n", scene_name, conventions[i].reversed,
                      conventions[i].zero_to_one, conventions[i].infinite, psnr);
        if (psnr < 45.0) picture_report("host", &h->whole, &p, psnr, 45.0);
        assert_true(psnr >= 45.0);
        int seen = 0;
        for (int k = 0; k < WIDTH * HEIGHT; ++k) {
            const double t = (double)h->whole.distance[k];
            if (isinf(t) || t > 500.0 || t == (double)h->distance[k]) continue; // the water, within the float's reach
            ++seen;
            const double error = fabs((double)p.distance[k] - window_depth(conventions[i], t));
            assert_true(error < 2e-6);
        }
        assert_true(seen > 100);
        picture_free(&p);
    }
}

// The world drawn from a view is the world drawn from its camera.
static void compare_world(host_rig *h) {
    bolan_target *target = NULL;
    bolan_view view = bolan_view_from_camera(&h->s.scene.camera, WIDTH, HEIGHT);
    picture p = {WIDTH, HEIGHT, malloc(WIDTH * HEIGHT * 3), NULL};
    assert_int_equal(bolan_target_create(WIDTH, HEIGHT, &target), BOLAN_OK);
    view.framebuffer = bolan_target_framebuffer(target);
    bolan_renderer_draw_world(h->s.renderer, h->s.world, &view);
    bolan_renderer_read_rgb8(h->s.renderer, view.framebuffer, WIDTH, HEIGHT, p.rgb);
    bolan_target_destroy(&target);
    assert_memory_equal(p.rgb, h->whole.rgb, WIDTH * HEIGHT * 3);
    picture_free(&p);
}

static void water_in_a_host_s_frame_is_the_water_of_the_world(void **state) {
    (void)state;
    static const char *const scenes[] = {"open-sea", "island"};
    for (int i = 0; i < 2; ++i) {
        host_rig *h = calloc(1, sizeof *h);
        rig_open(h, scenes[i]);
        compare_world(h);
        compare(h, scenes[i]);
        rig_close(h);
        free(h);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(water_in_a_host_s_frame_is_the_water_of_the_world)};
    bolan_context *context = NULL;
    if (bolan_context_create(BOLAN_GL_CORE, &context) != BOLAN_OK) return 77;
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    bolan_context_destroy(&context);
    return failed;
}

// SPDX-License-Identifier: MIT
// What bolan_view promises: a camera that looks along +z, jitter and each kind of output show the picture that the
// plain view shows.
#include "gl_support.h"

#include "bolan/io.h"

#include <epoxy/gl.h>
#include <string.h>

enum { WIDTH = 80, HEIGHT = 60, PIXELS = WIDTH * HEIGHT };

typedef struct rig {
    bolan_context *context;
    bolan_scene scene;
    bolan_world *world;
    bolan_renderer *renderer;
    bolan_water water;
    bolan_lighting lighting;
    bolan_view view; // rolled, off-centre
    GLuint colors[3], depth, framebuffers[3];
} rig;

typedef float pixels[PIXELS][4]; // bottom row first

// Framebuffers of 8 bits, of 8 bits that the framebuffer encodes, and of floats: the kinds of bolan_output.
static void open_framebuffers(rig *r) {
    static const GLenum formats[3] = {GL_RGBA8, GL_SRGB8_ALPHA8, GL_RGBA32F};
    glGenTextures(3, r->colors);
    glGenTextures(1, &r->depth);
    glGenFramebuffers(3, r->framebuffers);
    glBindTexture(GL_TEXTURE_2D, r->depth);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, WIDTH, HEIGHT, 0, GL_DEPTH_COMPONENT, GL_FLOAT, NULL);
    for (int i = 0; i < 3; i++) {
        glBindTexture(GL_TEXTURE_2D, r->colors[i]);
        glTexImage2D(GL_TEXTURE_2D, 0, (GLint)formats[i], WIDTH, HEIGHT, 0, GL_RGBA, GL_FLOAT, NULL);
        glBindFramebuffer(GL_FRAMEBUFFER, r->framebuffers[i]);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, r->colors[i], 0);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, r->depth, 0);
        assert_int_equal(glCheckFramebufferStatus(GL_FRAMEBUFFER), GL_FRAMEBUFFER_COMPLETE);
    }
}

static int open_rig(void **state) {
    static rig r;
    if (gl_setup_core((void **)&r.context) != 0) return -1;
    assert_int_equal(bolan_scene_load("open-sea", &r.scene), BOLAN_OK);
    r.scene.sea.resolution = 64;
    r.scene.sky.cloud_cover = 0.0;
    r.scene.camera.heading_deg = 230.0; // towards the sun, whose path is bright
    assert_int_equal(bolan_world_load_scene(&r.scene, &r.world), BOLAN_OK);
    bolan_world_step(r.world, 3.0);
    bolan_renderer_desc desc = bolan_renderer_desc_default();
    desc.quality = BOLAN_QUALITY_LOW;
    assert_int_equal(bolan_renderer_create(&desc, &r.renderer), BOLAN_OK);
    r.water = *bolan_world_water(r.world);
    r.lighting = bolan_lighting_from_scene(&r.scene);
    open_framebuffers(&r);
    r.view = bolan_view_from_camera(&r.scene.camera, WIDTH, HEIGHT);
    r.view.view = bolan_m4_view(r.scene.camera.heading_deg, -7.0, 9.0);
    r.view.projection.m[8] = 0.12f;
    r.view.projection.m[9] = -0.2f;
    *state = &r;
    return 0;
}

static int close_rig(void **state) {
    rig *r = *state;
    glDeleteFramebuffers(3, r->framebuffers);
    glDeleteTextures(3, r->colors);
    glDeleteTextures(1, &r->depth);
    bolan_renderer_destroy(&r->renderer);
    bolan_world_destroy(&r->world);
    return gl_teardown((void **)&r->context);
}

static void clear(const rig *r, bolan_output output) {
    glBindFramebuffer(GL_FRAMEBUFFER, r->framebuffers[output]);
    glClearColor(0.0f, 0.0f, 0.0f, 1.0f);
    glClearDepthf(0.0f); // that of bolan_m4_projection() is reversed
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

static void draw(rig *r, const bolan_view *view, const bolan_host *host) {
    bolan_view to = *view;
    to.framebuffer = r->framebuffers[to.output];
    if (host == NULL) {
        bolan_renderer_draw_world(r->renderer, r->world, &to);
        return;
    }
    bolan_renderer_prepare(r->renderer, &r->water, &r->lighting);
    bolan_renderer_draw_water(r->renderer, &to, host);
}

static void read(const rig *r, bolan_output output, pixels out) {
    glBindFramebuffer(GL_FRAMEBUFFER, r->framebuffers[output]);
    glReadPixels(0, 0, WIDTH, HEIGHT, GL_RGBA, GL_FLOAT, out);
}

// The world, or with a host the water alone over black.
static void shoot(rig *r, const bolan_view *view, const bolan_host *host, pixels out) {
    clear(r, view->output);
    draw(r, view, host);
    read(r, view->output, out);
    assert_true(watch_is_clean("after a picture"));
}

static pixels plain, got;
static float plain_depth[PIXELS], got_depth[PIXELS];

static double worst_difference(float (*a)[4], float (*b)[4]) {
    double worst = 0.0;
    for (int i = 0; i < PIXELS; i++)
        for (int c = 0; c < 3; c++) worst = fmax(worst, fabs((double)a[i][c] - (double)b[i][c]));
    return worst;
}

static double mean_of(float (*p)[4]) {
    double sum = 0.0;
    for (int i = 0; i < PIXELS; i++) sum += (double)(p[i][0] + p[i][1] + p[i][2]) / (3.0 * PIXELS);
    return sum;
}

// ---- the camera -----------------------------------------------------------------------------------------------------

// The same camera with its z axis turned: Z is negated in the view matrix, and in what the projection makes of it.
static bolan_view turned(bolan_view v) {
    for (int i = 0; i < 3; i++) v.view.m[4 * i + 2] *= -1.0f;
    for (int i = 8; i < 12; i++) v.projection.m[i] *= -1.0f;
    return v;
}

static void read_depth(const rig *r, float *out) {
    glBindFramebuffer(GL_FRAMEBUFFER, r->framebuffers[BOLAN_OUTPUT_LINEAR]);
    glReadPixels(0, 0, WIDTH, HEIGHT, GL_DEPTH_COMPONENT, GL_FLOAT, out);
}

static void a_camera_may_look_along_plus_z(void **state) {
    rig *r = *state;
    bolan_view view = r->view;
    view.output = BOLAN_OUTPUT_LINEAR;
    view.projection.m[10] = 0.001f; // a finite far plane: depth has an offset
    const bolan_view other = turned(view);
    const bolan_host host = bolan_host_default();
    for (int water = 0; water < 2; water++) {
        shoot(r, &view, water ? &host : NULL, plain);
        if (water) read_depth(r, plain_depth);
        shoot(r, &other, water ? &host : NULL, got);
        if (water) read_depth(r, got_depth);
        assert_memory_equal(got, plain, sizeof plain);
    }
    assert_memory_equal(got_depth, plain_depth, sizeof plain_depth);
    assert_true(mean_of(plain) > 0.01);
}

// Right and up by whole pixels: the pixel that a place had is the one two to the right and three up.
static void jitter_moves_the_picture_right_and_up(void **state) {
    rig *r = *state;
    bolan_view view = r->view;
    view.output = BOLAN_OUTPUT_LINEAR;
    shoot(r, &view, NULL, plain);
    view.jitter = (bolan_vec2){2.0f, 3.0f};
    shoot(r, &view, NULL, got);
    double same = 0.0, still = 0.0;
    for (int y = 3; y < HEIGHT; y++)
        for (int x = 2; x < WIDTH; x++) {
            const int to = y * WIDTH + x, from = (y - 3) * WIDTH + x - 2;
            same += fabs((double)got[to][1] - (double)plain[from][1]);
            still += fabs((double)got[to][1] - (double)plain[to][1]);
        }
    assert_true(same < 0.06 * still); // air is interpolated over 16 x 4 pixels, which do not move: 0.053
}

// ---- output ---------------------------------------------------------------------------------------------------------

static double encoded(double x) { return x <= 0.0031308 ? 12.92 * x : 1.055 * pow(x, 1.0 / 2.4) - 0.055; }

// In twilight, where the radiance that is kept is not the true one: the linear picture is what
// bolan_renderer_read_linear() gives, and the two of 8 bits are one picture, encoded by the shader or the framebuffer.
static void check_outputs(rig *r, const bolan_host *host, uint32_t samples) {
    static float linear[PIXELS][3];
    bolan_view view = r->view;
    view.samples = samples;
    view.output = BOLAN_OUTPUT_LINEAR;
    shoot(r, &view, host, plain);
    bolan_renderer_read_linear(r->renderer, linear[0], NULL);
    int water = 0;
    for (int i = 0; i < PIXELS; i++) {
        const float *want = linear[(HEIGHT - 1 - i / WIDTH) * WIDTH + i % WIDTH];
        if (plain[i][1] == 0.0f) continue; // black behind the water
        water++;
        for (int c = 0; c < 3; c++) assert_near(plain[i][c], want[c], 1e-3 * (double)want[c] + 1e-9);
    }
    assert_true(water > PIXELS / 3);
    view.output = BOLAN_OUTPUT_SRGB;
    shoot(r, &view, host, plain);
    view.output = BOLAN_OUTPUT_SRGB_FRAMEBUFFER;
    shoot(r, &view, host, got);
    assert_true(worst_difference(plain, got) < 2.5 / 255.0); // dithered before and after
    assert_true(mean_of(plain) > 0.05);
    assert_true(fabs(encoded(mean_of(plain)) - mean_of(plain)) > 0.05); // encoded once more it would be seen
}

static void each_output_is_the_same_picture(void **state) {
    rig *r = *state;
    const bolan_host host = bolan_host_default();
    bolan_scene dusk = r->scene;
    dusk.sky.sun_elevation_deg = -3.0;
    assert_int_equal(bolan_world_set_scene(r->world, &dusk), BOLAN_OK);
    r->lighting = bolan_lighting_from_scene(&dusk);
    check_outputs(r, NULL, 1);
    check_outputs(r, NULL, 3);
    check_outputs(r, &host, 1);
    assert_int_equal(bolan_world_set_scene(r->world, &r->scene), BOLAN_OK);
    r->lighting = bolan_lighting_from_scene(&r->scene);
}

static void a_host_gets_radiance_in_its_own_unit(void **state) {
    rig *r = *state;
    bolan_view view = r->view;
    bolan_host host = bolan_host_default();
    view.output = BOLAN_OUTPUT_LINEAR;
    shoot(r, &view, &host, plain);
    host.radiance = 3.0;
    shoot(r, &view, &host, got);
    for (int i = 0; i < PIXELS; i++)
        for (int c = 0; c < 3; c++) assert_near(got[i][c], 3.0 * (double)plain[i][c], 1e-5 * (double)got[i][c]);
    assert_true(mean_of(plain) > 0.01);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_camera_may_look_along_plus_z),
        cmocka_unit_test(jitter_moves_the_picture_right_and_up),
        cmocka_unit_test(each_output_is_the_same_picture),
        cmocka_unit_test(a_host_gets_radiance_in_its_own_unit),
    };
    return cmocka_run_group_tests_name("views", tests, open_rig, close_rig);
}

// SPDX-License-Identifier: MIT
// A view, a host's frame, a polygon or a light that is none: one sentence, and nothing is drawn.
#include "gl_support.h"
#include "heard.h"

#include <epoxy/gl.h>
#include <stdio.h>
#include <string.h>

enum { WIDTH = 32, HEIGHT = 24 };

typedef struct rig {
    bolan_context *context;
    bolan_sea *sea;
    bolan_renderer *renderer;
    bolan_water water;
    GLuint color, depth, framebuffer, cube;
    bolan_dvec2 corners[BOLAN_MAX_BOUNDS + 1];
} rig;

// What a case changes before it is drawn.
typedef struct request {
    bolan_view view;
    bolan_host host;
    bolan_lighting lighting;
} request;

static int open_rig(void **state) {
    static rig r;
    if (gl_setup_core((void **)&r.context) != 0) return -1;
    bolan_sea_desc sea = bolan_sea_desc_default();
    sea.resolution = 32;
    sea.fft.cascade_count = 2;
    assert_int_equal(bolan_sea_create(&sea, &r.sea), BOLAN_OK);
    bolan_sea_step(r.sea, 1.0);
    bolan_renderer_desc desc = bolan_renderer_desc_default();
    desc.quality = BOLAN_QUALITY_LOW;
    assert_int_equal(bolan_renderer_create(&desc, &r.renderer), BOLAN_OK);
    r.water = bolan_water_default();
    r.water.sea = r.sea;
    glGenTextures(1, &r.color);
    glBindTexture(GL_TEXTURE_2D, r.color);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, WIDTH, HEIGHT, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
    glGenTextures(1, &r.depth);
    glBindTexture(GL_TEXTURE_2D, r.depth);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, WIDTH, HEIGHT, 0, GL_DEPTH_COMPONENT, GL_FLOAT, NULL);
    glGenTextures(1, &r.cube);
    glBindTexture(GL_TEXTURE_CUBE_MAP, r.cube);
    for (GLenum face = 0; face < 6; face++)
        glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, GL_RGBA8, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
    glGenFramebuffers(1, &r.framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, r.framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, r.color, 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, r.depth, 0);
    for (int i = 0; i <= BOLAN_MAX_BOUNDS; i++) { // a circle round the eye
        const double turn = 2.0 * BOLAN_PI * i / (BOLAN_MAX_BOUNDS + 1);
        r.corners[i] = (bolan_dvec2){500.0 * cos(turn), 500.0 * sin(turn)};
    }
    bolan_set_hooks(&(bolan_hooks){.log = hear});
    *state = &r;
    return 0;
}

static int close_rig(void **state) {
    rig *r = *state;
    const GLuint textures[] = {r->color, r->depth, r->cube};
    bolan_set_hooks(NULL);
    glDeleteFramebuffers(1, &r->framebuffer);
    glDeleteTextures(3, textures);
    bolan_renderer_destroy(&r->renderer);
    bolan_sea_destroy(&r->sea);
    return gl_teardown((void **)&r->context);
}

static request good(const rig *r) {
    request q = {bolan_view_default(), bolan_host_default(), bolan_lighting_default()};
    q.view.framebuffer = r->framebuffer;
    q.view.width = WIDTH;
    q.view.height = HEIGHT;
    q.lighting.environment.cube = r->cube;
    q.lighting.environment.sun_irradiance = bolan_v3(1.0f, 1.0f, 1.0f);
    return q;
}

// Whether anything was drawn.
static bool draws(rig *r, const request *q) {
    static uint8_t rgb[WIDTH * HEIGHT * 3];
    glBindFramebuffer(GL_FRAMEBUFFER, r->framebuffer);
    glClearColor(1.0f, 1.0f, 1.0f, 1.0f);
    glClearDepthf(0.0f);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    bolan_renderer_prepare(r->renderer, &r->water, &q->lighting);
    bolan_renderer_draw_water(r->renderer, &q->view, &q->host);
    read_bytes(r->framebuffer, WIDTH, HEIGHT, rgb);
    int drawn = 0;
    for (int i = 0; i < WIDTH * HEIGHT; i++) drawn += rgb[3 * i] != 255;
    return drawn > 0;
}

static void check_draws(rig *r, const request *q, const char *what) {
    heard.errors = 0;
    if (!draws(r, q) || heard.errors) fail_msg("%s is not drawn: %s", what, heard.errors ? heard.sentence : "");
}

static void check_refused(rig *r, const request *q, bolan_log_id id, const char *part) {
    heard.errors = 0;
    assert_false(draws(r, q));
    if (heard.errors == 0 || heard.id != id || strstr(heard.sentence, part) == NULL)
        fail_msg("%d errors, the first \"%s\", not \"%s\"", heard.errors, heard.sentence, part);
    assert_true(watch_is_clean(part));
    const request right = good(r); // a good one is drawn again
    check_draws(r, &right, "the next frame");
}

// ---- views ----------------------------------------------------------------------------------------------------------

static void a_projection_that_is_no_perspective_is_refused(void **state) {
    static const struct {
        int at;
        float value;
        const char *part;
    } list[] = {{3, 0.1f, "not a perspective"},
                {7, 0.1f, "not a perspective"},
                {11, 0.0f, "not a perspective"},
                {15, 1.0f, "not a perspective"},
                {1, 0.1f, "turns, skews or moves"},
                {4, 0.1f, "turns, skews or moves"},
                {12, 0.1f, "turns, skews or moves"},
                {13, 0.1f, "turns, skews or moves"},
                {0, -1.0f, "mirrors the picture"},
                {5, -1.0f, "mirrors the picture"},
                {0, 0.0f, "singular"},
                {14, 0.0f, "does not depend on the distance"},
                {5, NAN, "not finite"}};
    rig *r = *state;
    for (size_t i = 0; i < sizeof list / sizeof *list; i++) {
        request q = good(r);
        q.view.projection.m[list[i].at] = list[i].value;
        check_refused(r, &q, BOLAN_LOG_VIEW, list[i].part);
    }
}

static void a_view_matrix_that_is_no_rotation_is_refused(void **state) {
    rig *r = *state;
    request q = good(r);
    for (int i = 0; i < 3; i++) q.view.view.m[4 * i] *= -1.0f;
    check_refused(r, &q, BOLAN_LOG_VIEW, "mirrors the world");
    for (int i = 8; i < 12; i++) q.view.projection.m[i] *= -1.0f; // a camera along +z is left-handed
    check_draws(r, &q, "a mirrored camera along +z");
    for (int i = 0; i < 3; i++) {
        q = good(r);
        q.view.view.m[4 * i] *= 1.01f;
        q.view.view.m[4 * i + 1] *= 1.01f;
        q.view.view.m[4 * i + 2] *= 1.01f;
        check_refused(r, &q, BOLAN_LOG_VIEW, "not a rotation");
    }
    q = good(r);
    q.view.view.m[4] += 0.1f;
    check_refused(r, &q, BOLAN_LOG_VIEW, "not a rotation");
    q = good(r);
    q.view.view.m[12] = 1e6f; // its translation is ignored
    check_draws(r, &q, "a translation in the view matrix");
    q.view.eye.y = INFINITY;
    check_refused(r, &q, BOLAN_LOG_VIEW, "not finite");
}

static void a_tile_beyond_the_whole_is_refused(void **state) {
    rig *r = *state;
    request q = good(r);
    q.view.tile.whole_width = 2 * WIDTH;
    q.view.tile.whole_height = 2 * HEIGHT;
    q.view.tile.x = WIDTH;
    check_draws(r, &q, "a tile at the right edge");
    q.view.tile.x = WIDTH + 1;
    check_refused(r, &q, BOLAN_LOG_VIEW, "tile reaches beyond");
    q.view.tile.x = 0;
    q.view.tile.y = HEIGHT + 1;
    check_refused(r, &q, BOLAN_LOG_VIEW, "tile reaches beyond");
    q.view.tile.y = UINT32_MAX;
    check_refused(r, &q, BOLAN_LOG_VIEW, "tile reaches beyond");
}

static void an_output_that_is_none_is_refused(void **state) {
    rig *r = *state;
    request q = good(r);
    q.view.output = (bolan_output)(BOLAN_OUTPUT_LINEAR + 1);
    check_refused(r, &q, BOLAN_LOG_OUT_OF_RANGE, "output is 3");
}

// ---- a host's frame -------------------------------------------------------------------------------------------------

static void a_polygon_that_is_none_is_refused(void **state) {
    rig *r = *state;
    request q = good(r);
    q.host.bounds = r->corners;
    q.host.bounds_count = BOLAN_MAX_BOUNDS;
    check_draws(r, &q, "a polygon of 64 corners");
    const bolan_dvec2 triangle[] = {{-500.0, -9.0}, {500.0, -9.0}, {0.0, 700.0}};
    q.host.bounds = triangle;
    q.host.bounds_count = 3;
    check_draws(r, &q, "a triangle");
    q.host.bounds = r->corners;
    static const uint32_t counts[] = {1, 2, BOLAN_MAX_BOUNDS + 1};
    for (int i = 0; i < 3; i++) {
        q.host.bounds_count = counts[i];
        check_refused(r, &q, BOLAN_LOG_GUEST_FRAME, "bounds_count");
    }
    q.host.bounds_count = 4;
    q.host.bounds = NULL;
    check_refused(r, &q, BOLAN_LOG_GUEST_FRAME, "bounds is NULL");
    bolan_dvec2 odd[4];
    for (int axis = 0; axis < 2; axis++) {
        memcpy(odd, r->corners, sizeof odd);
        *(axis ? &odd[3].y : &odd[3].x) = NAN;
        q.host.bounds = odd;
        check_refused(r, &q, BOLAN_LOG_GUEST_FRAME, "corner");
    }
}

static void textures_that_are_none_are_refused(void **state) {
    rig *r = *state;
    request q = good(r);
    q.host.color = r->color;
    check_refused(r, &q, BOLAN_LOG_GUEST_FRAME, "not both given");
    q.host.color = 0, q.host.depth = r->depth;
    check_refused(r, &q, BOLAN_LOG_GUEST_FRAME, "not both given");
    q.host.color = r->cube;
    check_refused(r, &q, BOLAN_LOG_GUEST_FRAME, "color is no 2D texture");
    q.host.color = r->color, q.host.depth = 9999;
    check_refused(r, &q, BOLAN_LOG_GUEST_FRAME, "depth is no 2D texture");
    q = good(r);
    q.host.mask = r->cube;
    check_refused(r, &q, BOLAN_LOG_GUEST_FRAME, "mask is no 2D texture");
}

// ---- a host's light -------------------------------------------------------------------------------------------------

static void a_light_that_is_none_is_refused(void **state) {
    rig *r = *state;
    request q = good(r);
    bolan_environment *e = &q.lighting.environment;
    e->cube = r->color;
    check_refused(r, &q, BOLAN_LOG_GUEST_LIGHT, "environment.cube is no cube map");
    q = good(r), e->turn.m[5] = 1.01f;
    check_refused(r, &q, BOLAN_LOG_GUEST_LIGHT, "environment.turn is not a rotation");
    q = good(r), e->turn.m[4] = 0.01f;
    check_refused(r, &q, BOLAN_LOG_GUEST_LIGHT, "environment.turn is not a rotation");
    q = good(r), e->sun_direction = bolan_v3(0.0f, 0.0f, 1.01f);
    check_refused(r, &q, BOLAN_LOG_GUEST_LIGHT, "environment.sun_direction");
    static const float wrong[] = {-1.0f, INFINITY, NAN};
    for (int i = 0; i < 9; i++) {
        bolan_vec3 v = bolan_v3(1.0f, 1.0f, 1.0f);
        (&v.x)[i % 3] = wrong[i / 3];
        q = good(r), e->sun_irradiance = v;
        check_refused(r, &q, BOLAN_LOG_GUEST_LIGHT, "environment.sun_irradiance");
        q = good(r), q.lighting.haze = (bolan_haze){BOLAN_HAZE_GIVEN, v, {0.0f, 0.0f, 0.0f}};
        check_refused(r, &q, BOLAN_LOG_GUEST_LIGHT, "haze.radiance");
        q = good(r), q.lighting.haze = (bolan_haze){BOLAN_HAZE_GIVEN, {0.0f, 0.0f, 0.0f}, v};
        check_refused(r, &q, BOLAN_LOG_GUEST_LIGHT, "haze.extinction");
        if (i == 0) continue; // a negative red asks for that of the cube
        q = good(r), e->sky_irradiance = v;
        check_refused(r, &q, BOLAN_LOG_GUEST_LIGHT, "environment.sky_irradiance");
    }
    q = good(r), q.lighting.haze.kind = (bolan_haze_kind)3;
    check_refused(r, &q, BOLAN_LOG_GUEST_LIGHT, "haze.kind");
    q = good(r), e->cube = 0, e->turn.m[5] = 7.0f; // without a cube the other fields have no effect
    check_draws(r, &q, "an environment without a cube");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_projection_that_is_no_perspective_is_refused),
        cmocka_unit_test(a_view_matrix_that_is_no_rotation_is_refused),
        cmocka_unit_test(a_tile_beyond_the_whole_is_refused),
        cmocka_unit_test(an_output_that_is_none_is_refused),
        cmocka_unit_test(a_polygon_that_is_none_is_refused),
        cmocka_unit_test(textures_that_are_none_are_refused),
        cmocka_unit_test(a_light_that_is_none_is_refused),
    };
    return cmocka_run_group_tests_name("what a host gets wrong", tests, open_rig, close_rig);
}

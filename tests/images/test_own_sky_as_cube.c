// SPDX-License-Identifier: MIT
// Bolan's own sky, drawn into the faces of a cube and given back as a host's environment, lights the same water; and
// desktop OpenGL and OpenGL ES draw the same water into a host's frame.
#include "picture.h"

#include <epoxy/gl.h>

enum { SIDE = 128, FACES = 6, WIDTH = 160, HEIGHT = 90, BYTES = WIDTH * HEIGHT * 3 };

typedef struct rig {
    stage s;
    bolan_water water;
    bolan_lighting lighting;
    bolan_view view;
    bolan_target *target;
} rig;

static void open_rig(rig *r, const char *name) {
    bolan_scene scene;
    assert_int_equal(bolan_scene_load(name, &scene), BOLAN_OK);
    scene.sea.resolution = 64;
    scene.sky.cloud_cover = 0.0; // clouds shade the water too, which a cube does not tell
    if (strcmp(name, "open-sea") == 0) { // a view that mirrors little of the aureole, which the cube's texels smear
        scene.camera = (bolan_camera){
            .position = {0.0, 0.0, 6.0}, .heading_deg = 230.0, .pitch_deg = -4.0, .fov_deg = 55.0};
        scene.sky.sun_elevation_deg = 32.0;
    }
    assert_true(stage_open(&r->s, &scene, BOLAN_QUALITY_MEDIUM, false));
    r->water = *bolan_world_water(r->s.world);
    r->lighting = bolan_lighting_from_scene(&scene);
    r->lighting.haze.kind = BOLAN_HAZE_NONE;
    assert_int_equal(bolan_target_create(WIDTH, HEIGHT, &r->target), BOLAN_OK);
    r->view = bolan_view_from_camera(&scene.camera, WIDTH, HEIGHT);
    r->view.framebuffer = bolan_target_framebuffer(r->target);
}

static void close_rig(rig *r) {
    bolan_target_destroy(&r->target);
    stage_close(&r->s);
}

// ---- the cube -------------------------------------------------------------------------------------------------------

static const bolan_vec3 ahead[FACES] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
static float face_rgb[FACES][SIDE * SIDE][3], cube_rgb[SIDE * SIDE][3];

static bolan_vec3 up_of(int face) { return face < 4 ? bolan_v3(0.0f, 0.0f, 1.0f) : bolan_v3(0.0f, 1.0f, 0.0f); }

static void draw_face(rig *r, int face) {
    const bolan_vec3 f = ahead[face], up = up_of(face), right = bolan_v3_cross(f, up);
    const float rows[3][3] = {{right.x, right.y, right.z}, {up.x, up.y, up.z}, {-f.x, -f.y, -f.z}};
    bolan_target *target = NULL;
    bolan_view v = bolan_view_default();
    assert_int_equal(bolan_target_create(SIDE, SIDE, &target), BOLAN_OK);
    v.view = bolan_m4_identity();
    for (int i = 0; i < 3; ++i)
        for (int c = 0; c < 3; ++c) v.view.m[4 * c + i] = rows[i][c];
    v.eye = (bolan_dvec3){0.0, 0.0, r->water.level + 5.0};
    v.width = v.height = SIDE;
    v.projection = bolan_m4_projection(0.5 * BOLAN_PI, 1.0, 0.1, 0);
    v.framebuffer = bolan_target_framebuffer(target);
    bolan_renderer_draw_world(r->s.renderer, r->s.world, &v);
    bolan_renderer_read_linear(r->s.renderer, face_rgb[face][0], NULL);
    bolan_target_destroy(&target);
}

static const float *radiance_of(bolan_vec3 d) {
    int face = 0;
    for (int i = 1; i < FACES; ++i)
        if (bolan_v3_dot(d, ahead[i]) > bolan_v3_dot(d, ahead[face])) face = i;
    const bolan_vec3 f = ahead[face], up = up_of(face), right = bolan_v3_cross(f, up);
    const double along = (double)bolan_v3_dot(d, f);
    const int i = (int)fmin((0.5 + 0.5 * (double)bolan_v3_dot(d, right) / along) * SIDE, SIDE - 1);
    const int j = (int)fmin((0.5 - 0.5 * (double)bolan_v3_dot(d, up) / along) * SIDE, SIDE - 1);
    return face_rgb[face][j * SIDE + i];
}

// Direction of a texel of a cube map: OpenGL 4.6, table 8.19.
static bolan_vec3 texel_direction(int face, int i, int j) {
    const float s = 2.0f * ((float)i + 0.5f) / SIDE - 1.0f, t = 2.0f * ((float)j + 0.5f) / SIDE - 1.0f;
    const bolan_vec3 to[FACES] = {{1, -t, -s}, {-1, -t, s}, {s, 1, t}, {s, -1, -t}, {s, -t, 1}, {-s, -t, -1}};
    return to[face];
}

static bolan_vec3 to_sun(const bolan_sky *sky) {
    const double a = bolan_radians(sky->sun_azimuth_deg), e = bolan_radians(sky->sun_elevation_deg);
    return bolan_v3((float)(sin(a) * cos(e)), (float)(cos(a) * cos(e)), (float)sin(e));
}

// The sun's disc is no part of an environment: there the sky a little higher stands in.
static GLuint cube_of(rig *r) {
    const bolan_vec3 sun = to_sun(&r->lighting.sky);
    GLuint name = 0;
    for (int face = 0; face < FACES; ++face) draw_face(r, face);
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_CUBE_MAP, name);
    for (int face = 0; face < FACES; ++face) {
        for (int k = 0; k < SIDE * SIDE; ++k) {
            bolan_vec3 d = bolan_v3_normalize(texel_direction(face, k % SIDE, k / SIDE));
            if (bolan_v3_dot(d, sun) > 0.9996f) d.z += 0.05f; // 1.6 degrees
            memcpy(cube_rgb[k], radiance_of(d), sizeof cube_rgb[k]);
        }
        glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + (GLenum)face, 0, GL_RGB16F, SIDE, SIDE, 0, GL_RGB, GL_FLOAT,
                     cube_rgb);
    }
    glBindTexture(GL_TEXTURE_CUBE_MAP, 0);
    return name;
}

// ---- the water under it ---------------------------------------------------------------------------------------------

static float own[WIDTH * HEIGHT][3], dark[WIDTH * HEIGHT][3], lit[WIDTH * HEIGHT][3];

static void draw_linear(rig *r, uint32_t effects, float *rgb) {
    r->lighting.look.effects = effects;
    bolan_renderer_prepare(r->s.renderer, &r->water, &r->lighting);
    bolan_renderer_draw_water(r->s.renderer, &r->view, NULL);
    bolan_renderer_read_linear(r->s.renderer, rgb, NULL);
}

static void draw_bytes(rig *r, uint8_t *rgb) {
    r->lighting.look.effects = bolan_lighting_from_scene(&r->s.scene).look.effects;
    bolan_renderer_prepare(r->s.renderer, &r->water, &r->lighting);
    bolan_renderer_draw_water(r->s.renderer, &r->view, NULL);
    bolan_renderer_read_rgb8(r->s.renderer, r->view.framebuffer, WIDTH, HEIGHT, rgb);
}

// Water that is lit from within is sky + sun * irradiance: the irradiance that explains Bolan's own best, and what it
// leaves unexplained.
static double irradiance_of(int channel, double *left) {
    double over = 0.0, under = 0.0, error = 0.0, all = 0.0;
    for (int i = 0; i < WIDTH * HEIGHT; ++i) {
        const double sun = (double)lit[i][channel] - (double)dark[i][channel];
        over += sun * ((double)own[i][channel] - (double)dark[i][channel]);
        under += sun * sun;
    }
    for (int i = 0; i < WIDTH * HEIGHT; ++i) {
        const double sun = (double)lit[i][channel] - (double)dark[i][channel], want = (double)own[i][channel];
        const double away = (double)dark[i][channel] + over / under * sun - want;
        error += away * away;
        all += want * want;
    }
    *left = sqrt(error / all);
    return over / under;
}

static void own_sky_as_a_cube_lights_the_same_water(void **state) {
    (void)state;
    static uint8_t first[BYTES], second[BYTES];
    rig r;
    open_rig(&r, "open-sea");
    bolan_environment *e = &r.lighting.environment;
    const GLuint cube = cube_of(&r);
    draw_bytes(&r, first);
    draw_linear(&r, BOLAN_EFFECT_AMBIENT, own[0]);
    e->cube = cube;
    e->sun_direction = to_sun(&r.lighting.sky);
    draw_linear(&r, BOLAN_EFFECT_AMBIENT, dark[0]);
    e->sun_irradiance = bolan_v3(1.0f, 1.0f, 1.0f);
    draw_linear(&r, BOLAN_EFFECT_AMBIENT, lit[0]);
    for (int c = 0; c < 3; ++c) {
        double left;
        (&e->sun_irradiance.x)[c] = (float)irradiance_of(c, &left);
        print_message("channel %d: irradiance of the sun %.4f, %.4f unexplained\n", c,
                      (double)(&e->sun_irradiance.x)[c], left);
        assert_true((&e->sun_irradiance.x)[c] > 0.3f && (&e->sun_irradiance.x)[c] < 1.0f);
        assert_true(left < 0.002);
    }
    draw_bytes(&r, second);
    const picture a = {WIDTH, HEIGHT, first, NULL}, b = {WIDTH, HEIGHT, second, NULL};
    const double psnr = picture_psnr(&a, &b);
    print_message("the same water: %.1f dB\n", psnr);
    if (getenv("BOLAN_KEEP") || psnr < 60.0) picture_report("own_sky", &a, &b, psnr, 60.0);
    assert_true(psnr >= 60.0);
    glDeleteTextures(1, &cube);
    close_rig(&r);
}

// ---- two APIs -------------------------------------------------------------------------------------------------------

static GLuint texture_of(GLenum format, GLenum components, const void *data) {
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexStorage2D(GL_TEXTURE_2D, 1, format, WIDTH, HEIGHT);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, WIDTH, HEIGHT, components, GL_FLOAT, data);
    return name;
}

// A host's scene: a sky, and a post that stands 20 m away, over and under the water.
static void draw_hosted(bolan_gl_api api, const char *scene, uint8_t *rgb) {
    static float color[WIDTH * HEIGHT][4], depth[WIDTH * HEIGHT];
    bolan_context *context = NULL;
    rig r;
    assert_int_equal(bolan_context_create(api, &context), BOLAN_OK);
    open_rig(&r, scene);
    for (int i = 0; i < WIDTH * HEIGHT; ++i) {
        const bool post = i % WIDTH > 60 && i % WIDTH < 84;
        const float c[4] = {post ? 0.3f : 0.05f, 0.1f, post ? 0.02f : 0.2f, 1.0f};
        memcpy(color[i], c, sizeof c);
        depth[i] = post ? 0.5f * r.view.projection.m[14] / 20.0f : 0.0f; // reversed, [-1,1]: clip depth 2 n / t - 1
    }
    const GLuint textures[] = {texture_of(GL_RGBA32F, GL_RGBA, color),
                               texture_of(GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, depth)};
    const bolan_host host = {.color = textures[0], .depth = textures[1]};
    bolan_renderer_prepare(r.s.renderer, &r.water, &r.lighting);
    bolan_renderer_draw_water(r.s.renderer, &r.view, &host);
    bolan_renderer_read_rgb8(r.s.renderer, r.view.framebuffer, WIDTH, HEIGHT, rgb);
    glDeleteTextures(2, textures);
    close_rig(&r);
    bolan_context_destroy(&context);
}

static void both_apis_draw_the_same_water(void **state) {
    (void)state;
    static uint8_t core[BYTES], es[BYTES];
    static const char *const scenes[] = {"open-sea", "island"};
    for (int i = 0; i < 2; ++i) {
        draw_hosted(BOLAN_GL_CORE, scenes[i], core);
        draw_hosted(BOLAN_GL_ES, scenes[i], es);
        const picture a = {WIDTH, HEIGHT, core, NULL}, b = {WIDTH, HEIGHT, es, NULL};
        const double psnr = picture_psnr(&a, &b);
        int water = 0;
        for (int k = 0; k < WIDTH * HEIGHT; ++k) water += core[3 * k + 2] > 10;
        print_message("%s, desktop and ES: %.1f dB, %d pixels of water\n", scenes[i], psnr, water);
        assert_true(water > WIDTH * HEIGHT / 4);
        if (getenv("BOLAN_KEEP") || psnr < 45.0) picture_report(scenes[i], &a, &b, psnr, 45.0);
        assert_true(psnr >= 45.0);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(own_sky_as_a_cube_lights_the_same_water)};
    const struct CMUnitTest apis[] = {cmocka_unit_test(both_apis_draw_the_same_water)};
    bolan_context *context = NULL;
    if (bolan_context_create(BOLAN_GL_CORE, &context) != BOLAN_OK) return 77;
    int failed = cmocka_run_group_tests_name("own sky as a cube", tests, NULL, NULL);
    bolan_context_destroy(&context);
    failed += cmocka_run_group_tests_name("both APIs", apis, NULL, NULL);
    return failed;
}

// SPDX-License-Identifier: MIT
// Light from the host: a cube map is reflected where it stands and as bright as it is, the given sun glitters, haze
// goes by the given numbers.
#include "gl_support.h"

#include <epoxy/gl.h>
#include <string.h>

enum { WIDTH = 48, HEIGHT = 32, PIXELS = WIDTH * HEIGHT, SIDE = 16 };

// ---- a rig ----------------------------------------------------------------------------------------------------------

typedef struct rig {
    bolan_sea *sea;
    bolan_renderer *renderer;
    bolan_water water;
    bolan_lighting lighting;
    bolan_view view;
    GLuint cube;
} rig;

// Faces +x, -x, +y, -y, +z, -z of one colour each.
static GLuint cube_of(const float colors[6][3]) {
    static float texels[SIDE * SIDE][3];
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_CUBE_MAP, name);
    for (GLenum face = 0; face < 6; face++) {
        for (int i = 0; i < SIDE * SIDE; i++) memcpy(texels[i], colors[face], sizeof texels[i]);
        glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, GL_RGB16F, SIDE, SIDE, 0, GL_RGB, GL_FLOAT, texels);
    }
    return name; // with the filter that a texture has at first, which wants levels: Bolan brings its own
}

// Made once for all tests of an API: what takes long is a renderer's programs.
static struct {
    bolan_context *context;
    bolan_renderer *renderer;
    bolan_target *target;
    uint64_t serial; // of the last cube map: names of textures come again
} shared;

static int open_api(bolan_gl_api api) {
    if (gl_setup((void **)&shared.context, api) != 0) return -1;
    bolan_renderer_desc desc = bolan_renderer_desc_default();
    desc.quality = BOLAN_QUALITY_HIGH;
    assert_int_equal(bolan_renderer_create(&desc, &shared.renderer), BOLAN_OK);
    assert_int_equal(bolan_target_create(WIDTH, HEIGHT, &shared.target), BOLAN_OK);
    return 0;
}

static int open_core(void **state) {
    (void)state;
    return open_api(BOLAN_GL_CORE);
}

static int open_es(void **state) {
    (void)state;
    return open_api(BOLAN_GL_ES);
}

static int close_api(void **state) {
    (void)state;
    bolan_target_destroy(&shared.target);
    bolan_renderer_destroy(&shared.renderer);
    return gl_teardown((void **)&shared.context);
}

static int end(void **state) {
    (void)state;
    return watch_is_clean("at the end of the test") ? 0 : -1;
}

static void open_rig(rig *r, double wind, const float colors[6][3]) {
    memset(r, 0, sizeof *r);
    r->sea = small_sea(wind > 0.0 ? bolan_sea_state_from_wind(wind, 270.0, 100e3) : bolan_sea_state_default());
    r->renderer = shared.renderer;
    r->cube = cube_of(colors);
    r->water = bolan_water_default();
    r->water.sea = r->sea;
    r->water.optics.deep = bolan_v3(0.0f, 0.0f, 0.0f);
    r->water.foam = 0.0;
    r->lighting = bolan_lighting_default();
    r->lighting.environment.cube = r->cube;
    r->lighting.environment.serial = ++shared.serial;
    r->lighting.haze.kind = BOLAN_HAZE_NONE;
    r->view = bolan_view_default();
    r->view.framebuffer = bolan_target_framebuffer(shared.target);
    r->view.width = WIDTH;
    r->view.height = HEIGHT;
    r->view.projection = bolan_m4_projection(bolan_radians(30.0), (double)WIDTH / HEIGHT, 0.1, 0);
}

static void close_rig(rig *r) {
    shared.serial = r->lighting.environment.serial;
    glDeleteTextures(1, &r->cube);
    bolan_sea_destroy(&r->sea);
}

typedef struct picture {
    float rgb[PIXELS][3], distance[PIXELS];
} picture;

static void draw(rig *r, double heading, double pitch, picture *out) {
    r->view.view = bolan_m4_view(heading, pitch, 0.0);
    bolan_renderer_prepare(r->renderer, &r->water, &r->lighting);
    bolan_renderer_draw_water(r->renderer, &r->view, NULL);
    bolan_renderer_read_linear(r->renderer, out->rgb[0], out->distance);
}

// Unit direction through the middle of a pixel in the camera's axes, row 0 at the top.
static bolan_vec3 ray_of(int pixel) {
    const double t = tan(bolan_radians(15.0)), x = (pixel % WIDTH + 0.5) / WIDTH * 2.0 - 1.0;
    const double y = 1.0 - (pixel / WIDTH + 0.5) / HEIGHT * 2.0;
    return bolan_v3_normalize(bolan_v3((float)(x * t * WIDTH / HEIGHT), (float)(y * t), -1.0f));
}

// Unpolarised reflectance of a plane, Fresnel's own two formulas.
static double fresnel_of(double cosine, double index) {
    const double inside = sqrt(1.0 - (1.0 - cosine * cosine) / (index * index));
    const double s = (cosine - index * inside) / (cosine + index * inside);
    const double p = (index * cosine - inside) / (index * cosine + inside);
    return 0.5 * (s * s + p * p);
}

// Of a pixel's ray, downwards, for a camera that is pitched down.
static double cosine_down(int pixel, double pitch) {
    const bolan_vec3 d = ray_of(pixel);
    return -((double)d.y * cos(bolan_radians(pitch)) - (double)d.z * sin(bolan_radians(pitch)));
}

static const float white[6][3] = {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}};
static const float east[6][3] = {{1, 0.5f, 0.25f}};

// ---- tests ----------------------------------------------------------------------------------------------------------

static void a_white_sky_gives_fresnel(void **state) {
    (void)state;
    static picture p;
    rig r;
    open_rig(&r, 0.0, white);
    for (double pitch = -60.0; pitch < -18.0; pitch += 20.0) {
        draw(&r, 0.0, pitch, &p);
        for (int i = 0; i < PIXELS; i++) {
            const double want = fresnel_of(cosine_down(i, pitch), (double)r.water.optics.index);
            for (int c = 0; c < 3; c++) assert_near(p.rgb[i][c], want, 0.003 + 0.02 * want);
        }
    }
    close_rig(&r);
}

static double mean_red(const picture *p) {
    double sum = 0.0;
    for (int i = 0; i < PIXELS; i++) sum += (double)p->rgb[i][0] / PIXELS;
    return sum;
}

// Face +x is in the east; a turn of the cube by 90 degrees puts it north.
static void a_bright_face_is_seen_where_it_stands(void **state) {
    (void)state;
    static picture p;
    rig r;
    open_rig(&r, 0.0, east);
    draw(&r, 90.0, -25.0, &p);
    const double want = fresnel_of(sin(bolan_radians(25.0)), (double)r.water.optics.index);
    const int middle = HEIGHT / 2 * WIDTH + WIDTH / 2;
    assert_near(p.rgb[middle][0], want, 0.1 * want);
    assert_near(p.rgb[middle][1], 0.5 * (double)p.rgb[middle][0], 0.01);
    assert_near(p.rgb[middle][2], 0.25 * (double)p.rgb[middle][0], 0.01);
    for (double heading = 0.0; heading < 360.0; heading += 90.0) {
        draw(&r, heading, -25.0, &p);
        if (heading != 90.0) assert_near(mean_red(&p), 0.0, 1e-3);
    }
    // world north -> +x of the cube, world east -> -y
    memset(&r.lighting.environment.turn, 0, sizeof r.lighting.environment.turn);
    r.lighting.environment.turn.m[1] = -1.0f;
    r.lighting.environment.turn.m[4] = 1.0f;
    r.lighting.environment.turn.m[10] = r.lighting.environment.turn.m[15] = 1.0f;
    draw(&r, 0.0, -25.0, &p);
    assert_near(p.rgb[middle][0], want, 0.1 * want);
    draw(&r, 90.0, -25.0, &p);
    assert_near(mean_red(&p), 0.0, 1e-3);
    close_rig(&r);
}

// The map is made anew when the serial says so, and not before.
static void new_contents_are_seen_with_a_new_serial(void **state) {
    (void)state;
    static picture before, same, after;
    static const float black[SIDE * SIDE * 3];
    rig r;
    open_rig(&r, 0.0, white);
    draw(&r, 0.0, -30.0, &before);
    glBindTexture(GL_TEXTURE_CUBE_MAP, r.cube);
    for (GLenum face = 0; face < 6; face++)
        glTexSubImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, 0, 0, SIDE, SIDE, GL_RGB, GL_FLOAT, black);
    draw(&r, 0.0, -30.0, &same);
    assert_memory_equal(same.rgb, before.rgb, sizeof same.rgb);
    r.lighting.environment.serial++;
    draw(&r, 0.0, -30.0, &after);
    assert_true(mean_red(&before) > 0.03);
    assert_near(mean_red(&after), 0.0, 1e-5);
    close_rig(&r);
}

// Glitter is proportional to the irradiance, and lies under the sun.
static void the_given_sun_glitters(void **state) {
    (void)state;
    static const float black[6][3];
    static picture dark, once, twice, north;
    rig r;
    open_rig(&r, 6.0, black);
    const double elevation = bolan_radians(25.0);
    r.lighting.environment.sun_direction = bolan_v3((float)cos(elevation), 0.0f, (float)sin(elevation)); // east
    draw(&r, 90.0, -25.0, &dark);
    r.lighting.environment.sun_irradiance = bolan_v3(1.0f, 0.5f, 0.0f);
    draw(&r, 90.0, -25.0, &once);
    draw(&r, 270.0, -25.0, &north);
    r.lighting.environment.sun_irradiance = bolan_v3(2.0f, 1.0f, 0.0f);
    draw(&r, 90.0, -25.0, &twice);
    assert_near(mean_red(&dark), 0.0, 1e-6);
    assert_true(mean_red(&once) > 0.05);
    assert_near(mean_red(&twice), 2.0 * mean_red(&once), 0.02 * mean_red(&once));
    assert_true(mean_red(&north) < 0.05 * mean_red(&once));
    for (int i = 0; i < PIXELS; i++) {
        assert_near(once.rgb[i][1], 0.5 * (double)once.rgb[i][0], 1e-3 + 1e-3 * (double)once.rgb[i][0]);
        assert_near(once.rgb[i][2], 0.0, 1e-6);
    }
    close_rig(&r);
}

// A new sun needs no new serial: its glitter moves, and the light of the old one is gone.
static void a_sun_that_moves_is_seen_at_once(void **state) {
    (void)state;
    static const float black[6][3];
    static picture p;
    rig r;
    open_rig(&r, 6.0, black);
    const double elevation = bolan_radians(25.0);
    r.lighting.environment.sun_irradiance = bolan_v3(1.0f, 1.0f, 1.0f);
    for (int i = 0; i < 3; i++) {
        const double turn = bolan_radians(90.0 - 90.0 * i);
        r.lighting.environment.sun_direction =
            bolan_v3((float)(cos(elevation) * cos(turn)), (float)(cos(elevation) * sin(turn)), (float)sin(elevation));
        draw(&r, 90.0 * i, -25.0, &p);
        assert_true(mean_red(&p) > 0.05);
        draw(&r, 90.0 * i + 180.0, -25.0, &p);
        assert_true(mean_red(&p) < 2e-3);
    }
    r.water.optics.deep = bolan_v3(0.1f, 0.1f, 0.1f); // in light that the sea scatters back
    draw(&r, 0.0, -25.0, &p);
    assert_true(mean_red(&p) > 2e-3);
    r.lighting.environment.sun_direction.z *= -1.0f; // set: it lights nothing
    draw(&r, 0.0, -25.0, &p);
    assert_near(mean_red(&p), 0.0, 1e-6);
    close_rig(&r);
}

// What the sea scatters back of the sky's light is proportional to its irradiance; that of a white sky of radiance 1 is
// pi, measured or given.
static void the_given_irradiance_of_the_sky_lights_the_water(void **state) {
    (void)state;
    static picture measured, given, twice;
    rig r;
    open_rig(&r, 0.0, white);
    r.water.optics.deep = bolan_v3(0.1f, 0.05f, 0.02f);
    draw(&r, 0.0, -60.0, &measured);
    r.lighting.environment.sky_irradiance = bolan_v3(3.14159265f, 3.14159265f, 3.14159265f);
    draw(&r, 0.0, -60.0, &given);
    r.lighting.environment.sky_irradiance = bolan_v3(6.2831853f, 6.2831853f, 6.2831853f);
    draw(&r, 0.0, -60.0, &twice);
    const double reflected = fresnel_of(sin(bolan_radians(60.0)), (double)r.water.optics.index);
    const int middle = HEIGHT / 2 * WIDTH + WIDTH / 2;
    for (int c = 0; c < 3; c++) {
        const double scattered = (double)given.rgb[middle][c] - reflected;
        assert_true(scattered > 0.01);
        assert_near(measured.rgb[middle][c], given.rgb[middle][c], 0.01 * (double)given.rgb[middle][c]);
        assert_near((double)twice.rgb[middle][c] - reflected, 2.0 * scattered, 0.05 * scattered);
    }
    close_rig(&r);
}

static void haze_goes_by_the_given_numbers(void **state) {
    (void)state;
    static picture clear, hazy;
    rig r;
    open_rig(&r, 0.0, white);
    r.view.eye.z = 40.0;
    draw(&r, 0.0, -30.0, &clear);
    r.lighting.haze = (bolan_haze){BOLAN_HAZE_GIVEN, {0.4f, 0.5f, 0.6f}, {0.004f, 0.008f, 0.016f}};
    draw(&r, 0.0, -30.0, &hazy);
    for (int i = 0; i < PIXELS; i++) {
        const double away = (double)clear.distance[i] / -(double)ray_of(i).z;
        const float *k = &r.lighting.haze.extinction.x, *h = &r.lighting.haze.radiance.x;
        for (int c = 0; c < 3; c++) {
            const double left = exp(-(double)k[c] * away);
            assert_near(hazy.rgb[i][c], (double)clear.rgb[i][c] * left + (double)h[c] * (1.0 - left), 2e-3);
        }
    }
    close_rig(&r);
}

#define TEST(f) cmocka_unit_test_teardown(f, end)

int main(void) {
    const struct CMUnitTest tests[] = {
        TEST(a_white_sky_gives_fresnel),
        TEST(a_bright_face_is_seen_where_it_stands),
        TEST(new_contents_are_seen_with_a_new_serial),
        TEST(the_given_sun_glitters),
        TEST(a_sun_that_moves_is_seen_at_once),
        TEST(the_given_irradiance_of_the_sky_lights_the_water),
        TEST(haze_goes_by_the_given_numbers),
    };
    const int core = cmocka_run_group_tests_name("light from the host (core)", tests, open_core, close_api);
    return core + cmocka_run_group_tests_name("light from the host (es)", tests, open_es, close_api);
}

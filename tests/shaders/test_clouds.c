// SPDX-License-Identifier: MIT
// The clouds: as many as asked for, none when none are, the same whether marched at once or strip by strip, without
// steps of their textures; cirrus in fibres along the wind.
#include "probe.h"
#include "sky_support.h"

#include "render/clouds.h"
#include <stdlib.h>

enum { WIDTH = 96, HEIGHT = 64, SIZE = WIDTH * HEIGHT * 3 };

static void draw(sky_rig *r, uint8_t *rgb) {
    rig_draw(r);
    bolan_gl_target_bind(&r->display);
    bolan_pass_tonemap_draw(r->tonemap, &r->f, &r->to, &r->color, 0, NULL);
    read_bytes(r->display.id, WIDTH, HEIGHT, rgb);
    assert_true(watch_is_clean("clouds"));
}

static void set_view(sky_rig *r, double x, double y, double z) {
    r->step.lighting.sky.cloud_cover = 0.4;
    r->camera = (bolan_camera){.position = {x, y, z}, .heading_deg = 20, .pitch_deg = 15, .fov_deg = 60};
}

static void clouds_marched_in_strips_are_those_marched_at_once(void **state) {
    (void)state;
    static uint8_t moved[SIZE], fresh[SIZE];
    sky_rig r;
    rig_create(&r, WIDTH, HEIGHT);
    r.f.progressive = true;
    set_view(&r, 0, 0, 5);
    rig_prepare(&r);
    draw(&r, moved);
    set_view(&r, 400, -250, 5);                   // farther than 150 m, nearer than a jump
    for (int i = 0; i < 24; i++) rig_prepare(&r); // the strips of software GL; others need fewer
    draw(&r, moved);
    rig_destroy(&r);
    rig_create(&r, WIDTH, HEIGHT);
    set_view(&r, 400, -250, 5);
    rig_prepare(&r);
    draw(&r, fresh);
    for (int i = 0; i < SIZE; i++) assert_true(abs(moved[i] - fresh[i]) <= 2); // rounding of a strip's own coordinate
    rig_destroy(&r);
}

static void a_still_eye_makes_no_new_clouds(void **state) {
    (void)state;
    sky_rig r;
    clouds c;
    rig_create(&r, WIDTH, HEIGHT);
    assert_int_equal(bolan_clouds_create(&c, NULL), BOLAN_OK);
    set_view(&r, 0, 0, 5);
    rig_prepare(&r);
    assert_int_equal(bolan_clouds_plan(&c, &r.f), CLOUDS_ALL);
    assert_true(bolan_clouds_march(&c, &r.f, CLOUDS_ALL));
    assert_int_equal(bolan_clouds_plan(&c, &r.f), CLOUDS_KEEP);
    r.f.eye.x += 60;
    r.f.eye.y -= 70;
    assert_int_equal(bolan_clouds_plan(&c, &r.f), CLOUDS_KEEP);
    bolan_clouds_place(&c, &r.f);
    assert_near(r.f.light.cloud_offset.x, 60, 0);
    assert_near(r.f.light.cloud_offset.y, -70, 0);
    r.f.eye.x += 200;
    r.f.progressive = true;
    assert_int_equal(bolan_clouds_plan(&c, &r.f), CLOUDS_STRIP);
    r.f.progressive = false; // a picture waits for its clouds
    assert_int_equal(bolan_clouds_plan(&c, &r.f), CLOUDS_ALL);
    r.f.progressive = true;
    r.f.eye.x += 1e6;
    assert_int_equal(bolan_clouds_plan(&c, &r.f), CLOUDS_ALL);
    bolan_clouds_free(&c);
    rig_destroy(&r);
}

// Mean of the shadow under a high sun, over two seeds: the share of the sky that is open, in the mean.
static double open_share(sky_rig *r, clouds *c, double cover) {
    double sum = 0;
    r->step.block.cloud_cover = (float)cover;
    for (uint64_t seed = 1; seed <= 2; seed++) {
        r->step.lighting.sky.cloud_seed = seed;
        assert_int_equal(bolan_clouds_plan(c, &r->f), CLOUDS_ALL);
        rig_upload(r);
        bolan_clouds_march(c, &r->f, CLOUDS_ALL);
        const uint32_t n = bolan_clouds_map(c)->width * bolan_clouds_map(c)->height;
        float *rgba = malloc(sizeof(float) * 4 * n);
        bolan_gl_target_read_float(&c->maps[c->shown].shadow, 0, rgba);
        for (uint32_t i = 0; i < n; i++) sum += rgba[4 * i] / (2.0 * n);
        free(rgba);
    }
    return sum;
}

static void as_many_clouds_stand_as_were_asked_for(void **state) {
    (void)state;
    sky_rig r;
    clouds c;
    rig_create(&r, WIDTH, HEIGHT);
    r.step.lighting.sky.sun_elevation_deg = 90;
    rig_prepare(&r);
    assert_int_equal(bolan_clouds_create(&c, NULL), BOLAN_OK);
    assert_near(open_share(&r, &c, 0), 1, 0);
    double before = 1;
    for (double cover = 0.25; cover < 1; cover += 0.25) {
        const double open = open_share(&r, &c, cover);
        print_message("cover %.2f: %.3f of the sun passes\n", cover, open);
        assert_near(open, 1 - cover, 0.15); // thin edges let light through, and a square of 100 km has few large groups
        assert_true(open < before - 0.05);
        before = open;
    }
    bolan_clouds_free(&c);
    rig_destroy(&r);
}

enum { SHADOWS = 256 };

static void bind_shadow(const gl_program *program, const void *context) {
    (void)program;
    bolan_blocks_bind(&((const sky_rig *)context)->uniforms);
}

// Share of the sun at places of the world, for the eye that the rig has.
static void shadows_at(const sky_rig *r, float (*world)[2], float (*out)[4]) {
    float in[SHADOWS][4] = {{0}};
    for (int i = 0; i < SHADOWS; i++)
        for (int k = 0; k < 2; k++) in[i][k] = world[i][k] - (float)(k ? r->f.eye.y : r->f.eye.x);
    probe_run_with("#include \"common/atmosphere.glsl\"", "vec4 probe(vec4 x) { return vec4(cloud_shadow(x.xy)); }",
                   NULL, bind_shadow, r, in, SHADOWS, out);
}

static void cloud_shadows_stay_where_they_are_while_the_eye_moves(void **state) {
    (void)state;
    static const double moves[][2] = {{60, 0}, {0, -70}, {5000, 3000}};
    float world[SHADOWS][2], before[SHADOWS][4], after[SHADOWS][4];
    uint32_t random = 1;
    for (int i = 0; i < 2 * SHADOWS; i++) {
        random = random * 1664525u + 1013904223u;
        world[i / 2][i % 2] = ((float)(random >> 8) / 8388608.0f - 1.0f) * 15000.0f;
    }
    for (int k = 0; k < 3; k++) {
        sky_rig r;
        rig_create(&r, WIDTH, HEIGHT);
        set_view(&r, 0, 0, 5);
        rig_prepare(&r);
        shadows_at(&r, world, before);
        set_view(&r, moves[k][0], moves[k][1], 5);
        rig_prepare(&r);
        shadows_at(&r, world, after);
        double off = 0, spread = 0, mean = 0;
        for (int i = 0; i < SHADOWS; i++) mean += before[i][0] / (double)SHADOWS;
        for (int i = 0; i < SHADOWS; i++) {
            off += pow(after[i][0] - before[i][0], 2) / SHADOWS;
            spread += pow(before[i][0] - mean, 2) / SHADOWS;
        }
        print_message("moved by %.0f, %.0f m: shadows differ by %.4f, spread %.3f\n", moves[k][0], moves[k][1],
                      sqrt(off), sqrt(spread));
        assert_true(sqrt(spread) > 0.2);
        // the same map while it is kept; a new one, 100 km wide, has its texels elsewhere
        assert_true(sqrt(off) < (k == 2 ? 0.5 * sqrt(spread) : 1e-3));
        rig_destroy(&r);
    }
}

enum { PLACES = 64 };

// Textures of clouds that were marched once.
static void bind_clouds(const gl_program *program, const void *context) {
    (void)program;
    const clouds *c = context;
    bolan_gl_texture_bind(&c->noise, UNIT_OWN + 1);
    bolan_gl_texture_bind(&c->weather, UNIT_OWN + 2);
}

static void march_clouds(sky_rig *r, clouds *c) {
    rig_create(r, WIDTH, HEIGHT);
    set_view(r, 0, 0, 5);
    rig_prepare(r);
    assert_int_equal(bolan_clouds_create(c, NULL), BOLAN_OK);
    assert_int_equal(bolan_clouds_plan(c, &r->f), CLOUDS_ALL);
    bolan_clouds_march(c, &r->f, CLOUDS_ALL);
}

// Rms difference of the fibres' depth over steps of (x, y) metres, seen over a footprint; its mean over all.
static double cirrus_varies(const clouds *c, double x, double y, double footprint, double *mean) {
    static float in[4 * PLACES][4], out[4 * PLACES][4];
    double sum = 0;
    uint32_t random = 7, count = 0;
    *mean = 0;
    for (int k = 0; k < 8; k++) {
        for (int i = 0; i < 4 * PLACES; i += 2) {
            for (int axis = 0; axis < 2; axis++) {
                random = random * 1664525u + 1013904223u;
                in[i][axis] = (float)(random >> 8) / 16777216.0f * 400000.0f;
            }
            in[i + 1][0] = in[i][0] + (float)x;
            in[i + 1][1] = in[i][1] + (float)y;
            in[i][2] = in[i + 1][2] = (float)footprint;
        }
        probe_run_with("#include \"common/clouds.glsl\"\n#include \"common/cirrus.glsl\"",
                       "vec4 probe(vec4 x) { return vec4(cirrus_fibres(x.xy, x.z)); }", NULL, bind_clouds, c, in,
                       4 * PLACES, out);
        for (int i = 0; i < 4 * PLACES; i += 2, count++) {
            sum += pow(out[i + 1][0] - out[i][0], 2);
            *mean += out[i][0];
        }
    }
    *mean /= count;
    return sqrt(sum / count);
}

static void cirrus_is_drawn_out_along_the_wind_and_blurred_over_a_footprint(void **state) {
    (void)state;
    sky_rig r;
    clouds c;
    double mean, unused;
    march_clouds(&r, &c);
    const double along = cirrus_varies(&c, 400, 0, 20, &mean), across = cirrus_varies(&c, 0, 400, 20, &mean);
    const double far = cirrus_varies(&c, 0, 400, 3000, &unused);
    print_message("over 400 m along the wind %.4f, across %.4f, seen from afar %.4f; mean depth %.3f\n", along, across,
                  far, mean);
    assert_true(across > 1.6 * along); // 1 without a direction; bends of the wind keep it near 2
    assert_true(far < 0.5 * across);
    bolan_clouds_free(&c);
    rig_destroy(&r);
}

// A bend of the wind whose slope across it passed 1 would fold the sheet, and the folds would be curls.
static void the_wind_of_cirrus_turns_little_and_never_folds(void **state) {
    (void)state;
    static float in[PROBE_WIDTH][4], out[PROBE_WIDTH][4];
    double turn = 0, fold = 0;
    for (int i = 0; i < PROBE_WIDTH; i++) {
        in[i][0] = (float)(i % 16) * 6100.0f;
        in[i][1] = (float)(i / 16) * 7300.0f;
    }
    probe_run("#include \"common/clouds.glsl\"\n#include \"common/cirrus.glsl\"",
              "vec4 probe(vec4 x) {\n"
              "    vec2 d = vec2(100.0, 0.0);\n"
              "    return vec4(wind_bend(x.xy + d.xy) - wind_bend(x.xy), wind_bend(x.xy + d.yx) - wind_bend(x.xy),\n"
              "                0.0, 0.0) / 100.0;\n"
              "}",
              in, PROBE_WIDTH, out);
    for (int i = 0; i < PROBE_WIDTH; i++) {
        turn = fmax(turn, fabs((double)out[i][0]));
        fold = fmax(fold, fabs((double)out[i][1]));
    }
    print_message("the wind turns by %.1f degrees, the sheet is drawn together by %.2f\n",
                  atan(turn) * 180.0 / BOLAN_PI, fold);
    assert_true(turn > 0.1 && turn < 0.577); // 30 degrees
    assert_true(fold < 0.25);                // 1 folds
}

static void the_weather_has_no_steps(void **state) {
    (void)state;
    static float in[PROBE_WIDTH][4], out[PROBE_WIDTH][4];
    sky_rig r;
    clouds c;
    march_clouds(&r, &c);
    for (int i = 0; i < PROBE_WIDTH; i++) in[i][0] = in[i][1] = 10.0f * (float)i;
    probe_run_with("#include \"common/clouds.glsl\"",
                   "vec4 probe(vec4 x) { return textureLod(cloud_weather, x.xy / WEATHER_TILE, 0.0); }", NULL,
                   bind_clouds, &c, in, PROBE_WIDTH, out);
    double most = 0, range = 0;
    for (int i = 1; i < PROBE_WIDTH; i++) {
        most = fmax(most, fabs((double)out[i][0] - (double)out[i - 1][0]));
        range = fmax(range, fabs((double)out[i][0] - (double)out[0][0]));
    }
    print_message("from 10 m to 10 m the weather changes by %.5f at most, over the line by %.3f\n", most, range);
    assert_true(range > 0.02);
    assert_true(most < 0.5 / 255.0); // bytes change by 1/255 or not at all
    bolan_clouds_free(&c);
    rig_destroy(&r);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        IN_BOTH_APIS(clouds_marched_in_strips_are_those_marched_at_once),
        IN_BOTH_APIS(a_still_eye_makes_no_new_clouds),
        IN_BOTH_APIS(cloud_shadows_stay_where_they_are_while_the_eye_moves),
        cmocka_unit_test_setup_teardown(cirrus_is_drawn_out_along_the_wind_and_blurred_over_a_footprint, gl_setup_core,
                                        gl_teardown),
        cmocka_unit_test_setup_teardown(the_wind_of_cirrus_turns_little_and_never_folds, gl_setup_core, gl_teardown),
        cmocka_unit_test_setup_teardown(the_weather_has_no_steps, gl_setup_core, gl_teardown),
        cmocka_unit_test_setup_teardown(as_many_clouds_stand_as_were_asked_for, gl_setup_core, gl_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

// SPDX-License-Identifier: MIT
// Windrows (src/render/windrows.c, shaders/common/foam.glsl): lines along the wind, whichever way it blows, of many
// distances. Foam drifts with the wind over the water, and its pattern lasts.
#include "probe.h"

#include "render/foam_texture.h"
#include "render/frame.h"
#include "render/windrows.h"
#include "shared/foam.glsl"

#include <stdlib.h>

typedef struct rig {
    gl_texture detail;
    block_buffers uniforms;
    block_values blocks;
} rig;

static void set_foam(const gl_program *program, const void *context) {
    const rig *r = context;
    (void)program;
    bolan_blocks_bind(&r->uniforms);
    bolan_gl_texture_bind(&r->detail, UNIT_FOAM_DETAIL);
}

// ---- pattern --------------------------------------------------------------------------------------------------------

// Mean squared difference of windrows at places x.x apart: along and across the wind; and likewise of fresh foam.
static const char *const probe_body =
    "vec4 probe(vec4 x) {\n"
    "    vec4 sum = vec4(0.0);\n"
    "    vec2 along = x.x * wind_direction, across = x.x * vec2(-wind_direction.y, wind_direction.x);\n"
    "    for (int i = 0; i < 2048; ++i) {\n"
    "        vec2 at = 9000.0 * fract(float(i) * vec2(0.75487766, 0.56984029));\n"
    "        float here = windrow_texels(at, 0.02).x, broad = foam_look_up(at, 0.02).broad.r;\n"
    "        vec4 rise = vec4(windrow_texels(at + along, 0.02).x, windrow_texels(at + across, 0.02).x,\n"
    "                         foam_look_up(at + along, 0.02).broad.r, foam_look_up(at + across, 0.02).broad.r);\n"
    "        rise -= vec4(here, here, broad, broad);\n"
    "        sum += rise * rise / 2048.0;\n"
    "    }\n"
    "    return sum;\n"
    "}\n";

static void windrows_lie_along_the_wind(void **state) {
    (void)state;
    const double winds[] = {0.3, 1.9, -2.6};
    for (int k = 0; k < 3; ++k) {
        rig r = {.blocks = {
                     .frame = {.wind_direction = {(float)cos(winds[k]), (float)sin(winds[k])},
                               .streak_scale = {1.0f / 1600.0f, 1.0f / 9600.0f}},
                     .view = {.eye_wrapped = {700.0f, 100.0f}, .foam_wrapped = {700.0f, 100.0f}, .eye_height = 3.0f}}};
        r.blocks.view.streak_place =
            bolan_frame_streaks(bolan_dv3(700.0, 100.0, 3.0), winds[k], r.blocks.frame.streak_scale);
        float in[2][4] = {{10.0f}, {0.5f}}, out[2][4];
        assert_int_equal(bolan_foam_noise_create(&r.detail), BOLAN_OK);
        assert_int_equal(bolan_blocks_create(&r.uniforms), BOLAN_OK);
        bolan_blocks_upload(&r.uniforms, &r.blocks);
        probe_run_with("#include \"common/frame.glsl\"\n#include \"common/slopes.glsl\"\n#include \"common/foam.glsl\"",
                       probe_body, NULL, set_foam, &r, in, 2, out);
        assert_true(out[0][0] < 0.1f * out[0][1]);     // at a windrow's own width they are drawn out
        assert_near(out[1][2] / out[1][3], 1.0, 0.15); // fresh foam is not: 2048 places
        bolan_blocks_free(&r.uniforms);
        bolan_gl_texture_free(&r.detail);
    }
}

// x: angle from the wind of a pixel of 12 m by 1 m. Its width for windrows.
static const char *const width_body =
    "vec4 probe(vec4 x) {\n"
    "    vec2 axis = cos(x.x) * wind_direction + sin(x.x) * vec2(-wind_direction.y, wind_direction.x);\n"
    "    return vec4(windrow_width(axis, 1.0, 12.0));\n"
    "}\n";

static void pixels_along_the_wind_resolve_windrows(void **state) {
    (void)state;
    rig r = {.blocks = {.frame = {.wind_direction = {0.6f, -0.8f}}}};
    float in[3][4] = {{0.0f}, {1.5707963f}, {0.7853982f}}, out[3][4];
    assert_int_equal(bolan_foam_noise_create(&r.detail), BOLAN_OK);
    assert_int_equal(bolan_blocks_create(&r.uniforms), BOLAN_OK);
    bolan_blocks_upload(&r.uniforms, &r.blocks);
    probe_run_with("#include \"common/frame.glsl\"\n#include \"common/foam.glsl\"", width_body, NULL, set_foam, &r, in,
                   3, out);
    assert_near(out[0][0], 12.0 / 6.0, 1e-5); // by its length, over the stretch of windrows
    assert_near(out[1][0], 12.0, 1e-5);
    assert_near(out[2][0], sqrt(0.5 * (1.0 + 144.0)), 1e-5);
    bolan_blocks_free(&r.uniforms);
    bolan_gl_texture_free(&r.detail);
}

static float windrows[WINDROWS_SIZE][WINDROWS_SIZE];

static int by_size(const void *a, const void *b) {
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

// Distances between windrows across the wind, where the field rises over a standard deviation [texels], sorted.
static uint32_t distances(double *out, uint32_t most) {
    uint32_t count = 0;
    for (uint32_t v = 0; v < WINDROWS_SIZE; v += 4) {
        double last = -1.0;
        for (uint32_t u = 1; u < WINDROWS_SIZE; ++u) {
            const double before = (double)windrows[v][u - 1] - 0.6, here = (double)windrows[v][u] - 0.6;
            if (!(before < 0.0 && here >= 0.0)) continue;
            const double at = u - here / (here - before);
            if (last >= 0.0 && count < most) out[count++] = at - last;
            last = at;
        }
    }
    qsort(out, count, sizeof *out, by_size);
    return count;
}

// Standard deviation of the direction of lines against the wind [degrees], by the structure tensor over 32 x 8 texels.
static double wander(void) {
    enum { ACROSS = 32, ALONG = 8, N = WINDROWS_SIZE / ACROSS, COUNT = N * WINDROWS_SIZE / ALONG };
    double squares = 0.0;
    for (uint32_t i = 0; i < COUNT; ++i) {
        double uu = 0.0, vv = 0.0, uv = 0.0;
        for (uint32_t k = 0; k < ACROSS * ALONG; ++k) {
            const uint32_t u = i % N * ACROSS + k % ACROSS, v = i / N * ALONG + k / ACROSS;
            const double here = (double)windrows[v][u];
            const double du = (double)windrows[v][(u + 1) % WINDROWS_SIZE] - here;
            const double dv = ((double)windrows[(v + 1) % WINDROWS_SIZE][u] - here) / WINDROW_STRETCH;
            uu += du * du, vv += dv * dv, uv += du * dv;
        }
        const double turned = 0.5 * atan2(2.0 * uv, uu - vv) * 180.0 / BOLAN_PI;
        squares += turned * turned / COUNT;
    }
    return sqrt(squares);
}

// Thorpe (2004): foam windrows are 2 to 300 m apart, several sizes at a time. The tile has the broad half of them, in
// 20 m/s 1536 m wide; in its place lie WINDROWS_FINER tiles of the fine half.
static void windrows_have_many_distances_and_wander(void **state) {
    (void)state;
    enum { MOST = 40000 };
    static double apart[MOST];
    assert_int_equal(bolan_windrows_fill(windrows[0], 1), BOLAN_OK);
    const uint32_t count = distances(apart, MOST);
    const double texel = WINDROWS * windrow_distance(20.0) / WINDROWS_SIZE;
    double mean = 0.0, logs = 0.0, square = 0.0, log_square = 0.0, cube = 0.0, log_cube = 0.0;
    for (uint32_t i = 0; i < count; ++i) mean += apart[i] / count, logs += log(apart[i]) / count;
    for (uint32_t i = 0; i < count; ++i) {
        const double d = apart[i] - mean, e = log(apart[i]) - logs;
        square += d * d / count, cube += d * d * d / count, log_square += e * e / count, log_cube += e * e * e / count;
    }
    const double skewness = cube / pow(square, 1.5), log_skewness = log_cube / pow(log_square, 1.5);
    const double low = texel * apart[count / 20], high = texel * apart[count - 1 - count / 20], turned = wander();
    print_message("%u distances: %.0f, %.0f, %.0f m (5, 50, 95 %%), deviation of the logarithm %.2f, skewness %.2f and "
                  "of the logarithm %.2f; lines turn by %.1f degrees\n",
                  count, low, texel * apart[count / 2], high, sqrt(log_square), skewness, log_skewness, turned);
    assert_true(low / WINDROWS_FINER < 3.0 && high > 100.0 && high < 300.0);
    assert_true(sqrt(log_square) > 0.6 && fabs(log_skewness) < 0.5 && skewness > 1.0); // a comb has 0, 0 and 0
    assert_true(turned > 5.0 && turned < 12.0); // twice as much, 10 to 20 degrees, is rare
}

// ---- drift ----------------------------------------------------------------------------------------------------------

// Blocks of that time, for an eye at (10, 20, 5).
static void fill(bolan_sea *sea, double time, block_values *out) {
    bolan_sea_step(sea, time);
    frame f = {.sea = sea};
    const bolan_camera camera = {.position = {10.0, 20.0, 5.0}, .fov_deg = 50.0};
    const bolan_view from = bolan_view_from_camera(&camera, 64, 64);
    render_view v = {0};
    bolan_frame_fill(&f);
    bolan_view_open(&v, &f, &from, false);
    bolan_view_fill(&v);
    out->frame = f.block;
    out->view = v.block;
}

static bolan_sea *sea_of(double wind, bolan_vec2 current, double loop_period) {
    bolan_sea_desc d = bolan_sea_desc_default();
    d.sea_state = bolan_sea_state_from_wind(wind, 250.0, 50e3);
    d.sea_state.current_x = (double)current.x, d.sea_state.current_y = (double)current.y;
    d.resolution = 64;
    d.loop_period = loop_period;
    bolan_sea *sea = NULL;
    assert_int_equal(bolan_sea_create(&d, &sea), BOLAN_OK);
    return sea;
}

// Wind from the west by south (250 degrees), 20 m/s, for 100 s: bubbles go 3.1 % of 2 km (Wu 1983) over the water,
// 58.26 m east and 21.21 m north, eddies 52 m. The current has moved the water by 50 m and -20 m.
static void foam_drifts_with_the_wind_over_the_water(void **state) {
    (void)state;
    block_values b;
    bolan_sea *sea = sea_of(20.0, (bolan_vec2){0.5f, -0.2f}, 0.0);
    fill(sea, 100.0, &b);
    assert_near(b.view.foam_wrapped.x, 4096.0 + 10.0 - 50.0 - 58.26, 0.01);
    assert_near(b.view.foam_wrapped.y, 20.0 + 20.0 - 21.21, 0.01);
    assert_near(b.view.eddies_wrapped.x, 4096.0 + 10.0 - 50.0 - 48.86, 0.01);
    assert_near(b.view.eddies_wrapped.y, 20.0 + 20.0 - 17.78, 0.01);
    const double along = (0.93969 * (10.0 - 50.0) + 0.34202 * (20.0 + 20.0) - 62.0) * (double)b.frame.streak_scale.y;
    assert_near(b.view.streak_place.y, along - floor(along), 1e-4);
    bolan_sea_destroy(&sea);
}

static void drift_closes_a_loop(void **state) {
    (void)state;
    block_values b[2];
    bolan_sea *sea = sea_of(20.0, (bolan_vec2){0.0f, 0.0f}, 300.0);
    for (int i = 0; i < 2; ++i) fill(sea, 10.0 + 300.0 * i, &b[i]);
    const float tile = 64.0f; // of the noise
    assert_near(remainderf(b[1].view.foam_wrapped.x - b[0].view.foam_wrapped.x, tile), 0.0, 1e-3);
    assert_near(remainderf(b[1].view.foam_wrapped.y - b[0].view.foam_wrapped.y, tile), 0.0, 1e-3);
    assert_near(remainderf(b[1].view.streak_place.y - b[0].view.streak_place.y, 1.0f), 0.0, 1e-5);
    fill(sea, 20.0, &b[1]);
    assert_near(remainderf(b[0].view.foam_wrapped.x - b[1].view.foam_wrapped.x, 4096.0f), 10.0 * 3.0 * 64.0 / 300.0,
                1e-2); // near .58 m/s
    bolan_sea_destroy(&sea);
}

// Opacity of streaks at four places.
static const char *const pattern_body =
    "float opacity(vec2 at) {\n"
    "    vec2 windrows = windrow_texels(at, 0.2);\n"
    "    return foam_film(0.0, 0.0, 1.0, streak_grain(foam_look_up(at, 0.2), 0.2, windrows, 0.2), 0.8);\n"
    "}\n"
    "vec4 probe(vec4 x) {\n"
    "    return vec4(opacity(x.xy), opacity(x.xy + vec2(700.0, 310.0)), opacity(x.xy + vec2(-510.0, 630.0)),\n"
    "                opacity(x.xy + vec2(-870.0, -450.0)));\n"
    "}\n";

enum { PLACES = 256 };

// At places that drift with bubbles and small nets.
static void look(rig *r, bolan_sea *sea, double wind, double time, float out[PLACES][4]) {
    float in[PLACES][4] = {{0}};
    fill(sea, time, &r->blocks);
    const float gone = (float)(0.031 * wind * time);
    for (int i = 0; i < PLACES; ++i) {
        in[i][0] = 7.31f * (float)(i % 16) + 1.7f * (float)(i / 16) + gone * r->blocks.frame.wind_direction.x;
        in[i][1] = 6.07f * (float)(i / 16) - 1.3f * (float)(i % 16) + gone * r->blocks.frame.wind_direction.y;
    }
    bolan_blocks_upload(&r->uniforms, &r->blocks);
    probe_run_with("#include \"common/frame.glsl\"\n#include \"common/foam.glsl\"", pattern_body, NULL, set_foam, r, in,
                   PLACES, out);
}

static double correlation(float (*a)[4], float (*b)[4]) {
    double sum_a = 0.0, sum_b = 0.0, aa = 0.0, bb = 0.0, ab = 0.0;
    const double n = 4.0 * PLACES;
    for (int i = 0; i < PLACES; ++i)
        for (int j = 0; j < 4; ++j) {
            const double x = (double)a[i][j], y = (double)b[i][j];
            sum_a += x, sum_b += y, aa += x * x, bb += y * y, ab += x * y;
        }
    return (ab - sum_a * sum_b / n) / sqrt((aa - sum_a * sum_a / n) * (bb - sum_b * sum_b / n));
}

// What drifts with the foam sees its patches change by 1 / e within 10 to 60 s. Windrows last: Langmuir's cells do.
static void patches_of_foam_last_for_tens_of_seconds(void **state) {
    (void)state;
    static const double winds[] = {16.0, 32.0}, times[] = {0.0, 10.0, 60.0, 400.0};
    rig r = {0};
    assert_int_equal(bolan_foam_noise_create(&r.detail), BOLAN_OK);
    assert_int_equal(bolan_blocks_create(&r.uniforms), BOLAN_OK);
    for (int k = 0; k < 2; ++k) {
        static float seen[4][PLACES][4];
        double like[4];
        bolan_sea *sea = sea_of(winds[k], (bolan_vec2){0.0f, 0.0f}, 0.0);
        for (int t = 0; t < 4; ++t) {
            look(&r, sea, winds[k], times[t], seen[t]);
            like[t] = correlation(seen[0], seen[t]);
        }
        print_message("%.0f m/s: correlation %.2f after 10 s, %.2f after 60 s, %.2f at last\n", winds[k], like[1],
                      like[2], like[3]);
        const double at_10 = (like[1] - like[3]) / (1.0 - like[3]), at_60 = (like[2] - like[3]) / (1.0 - like[3]);
        assert_true(at_10 > 0.37 && at_60 < 0.37);
        assert_true(like[3] > 0.4 && like[3] < 0.85);
        bolan_sea_destroy(&sea);
    }
    bolan_blocks_free(&r.uniforms);
    bolan_gl_texture_free(&r.detail);
}

int main(void) {
    const struct CMUnitTest tests[] = {IN_BOTH_APIS(windrows_lie_along_the_wind),
                                       IN_BOTH_APIS(pixels_along_the_wind_resolve_windrows),
                                       cmocka_unit_test(windrows_have_many_distances_and_wander),
                                       cmocka_unit_test(foam_drifts_with_the_wind_over_the_water),
                                       cmocka_unit_test(drift_closes_a_loop),
                                       IN_BOTH_APIS(patches_of_foam_last_for_tens_of_seconds)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

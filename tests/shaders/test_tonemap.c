// SPDX-License-Identifier: MIT
// The tone map: monotone, neutral, and the mean of samples is a mean.
#include "probe.h"
#include "sky_support.h"

#include <stdlib.h>

enum { WIDTH = 256, HEIGHT = 8, SIZE = WIDTH * HEIGHT * 3 };

static uint8_t picture[SIZE];

// A ramp of radiance over 24 stops, times a colour, through the pass.
static void tone_map_ramp(sky_rig *r, const float color[3], uint32_t samples) {
    static float rgba[WIDTH * HEIGHT * 4];
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        const float v = exp2f(-14.0f + 24.0f * (float)(i % WIDTH) / (WIDTH - 1));
        for (int c = 0; c < 3; c++) rgba[4 * i + c] = v * color[c];
        rgba[4 * i + 3] = 1.0f;
    }
    gl_texture_upload(&r->color, 0, -1, rgba, false);
    r->f.uniforms.sun_light.w = 1.0f;
    rig_upload(r);
    for (uint32_t s = 0; s < samples; s++) {
        gl_target_bind(&r->display);
        pass_tonemap_draw(r->tonemap, &r->f, &r->color, s, samples);
    }
    read_bytes(r->display.id, WIDTH, HEIGHT, picture);
    assert_true(watch_is_clean("tone map"));
}

static double column(int x, int channel) { // mean over the rows, to see through the dither
    double sum = 0.0;
    for (int y = 0; y < HEIGHT; y++) sum += picture[3 * (y * WIDTH + x) + channel];
    return sum / HEIGHT;
}

static void the_tone_map_is_monotone_from_black_to_white(void **state) {
    (void)state;
    static const float colors[][3] = {{1, 1, 1}, {1, 0.5f, 0.2f}, {0.1f, 0.3f, 1}};
    sky_rig r;
    rig_create(&r, WIDTH, HEIGHT);
    for (int k = 0; k < 3; k++) {
        tone_map_ramp(&r, colors[k], 1);
        for (int c = 0; c < 3; c++) {
            // Half a level of dither either way, averaged over 8 rows, and rounding to levels.
            for (int x = 1; x < WIDTH; x++) assert_true(column(x, c) >= column(x - 1, c) - 0.75);
            assert_true(column(0, c) < 2.0);
        }
        assert_true(column(WIDTH - 1, 0) > 250.0 || k == 2);
    }
    rig_destroy(&r);
}

static void grey_stays_grey_and_middle_grey_stays_where_it_was(void **state) {
    (void)state;
    static const float white[3] = {1, 1, 1};
    sky_rig r;
    rig_create(&r, WIDTH, HEIGHT);
    tone_map_ramp(&r, white, 1);
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        assert_int_equal(picture[3 * i], picture[3 * i + 1]);
        assert_int_equal(picture[3 * i], picture[3 * i + 2]);
    }
    // 0.18 is at column 255 (log2(0.18) + 14) / 24 = 122.5; IEC 61966-2-1 encodes it as 0.4613, level 117.6.
    assert_near(0.5 * (column(122, 0) + column(123, 0)), 117.6, 1.5); // columns are 6 % apart: 3 levels
    rig_destroy(&r);
}

static void the_mean_of_equal_samples_is_the_sample(void **state) {
    (void)state;
    static const float color[3] = {1, 0.8f, 0.6f};
    sky_rig r;
    rig_create(&r, WIDTH, HEIGHT);
    static const uint32_t counts[] = {2, 7, 64};
    static uint8_t single[SIZE];
    tone_map_ramp(&r, color, 1);
    memcpy(single, picture, SIZE);
    for (int k = 0; k < 3; k++) {
        tone_map_ramp(&r, color, counts[k]);
        for (int i = 0; i < SIZE; i++) assert_true(abs(picture[i] - single[i]) <= 2); // the dither
    }
    rig_destroy(&r);
}

// ---- the curves themselves, in doubles, with powers

static double exact_film(double x) { return pow(x, 1.3) / (pow(x, 1.3) + 0.4903); }
static double exact_srgb(double c) { return c < 0.0031308 ? 12.92 * c : 1.055 * pow(c, 1.0 / 2.4) - 0.055; }

static void exact_tonemap(const float in[4], double out[3]) {
    double c[3], y = 0.2126 * in[0] + 0.7152 * in[1] + 0.0722 * in[2];
    const double burnt = 0.7 * y / (y + 40.0), share = 0.38 / (1.0 + 0.3 * y);
    for (int k = 0; k < 3; k++) c[k] = in[k] + (y - in[k]) * burnt;
    const double peak = fmax(fmax(c[0], c[1]), fmax(c[2], 1e-6));
    for (int k = 0; k < 3; k++)
        out[k] = exact_srgb((1.0 - share) * exact_film(c[k]) + share * c[k] * exact_film(peak) / peak);
}

static void the_fitted_curves_stay_within_half_a_level_of_the_exact_ones(void **state) {
    (void)state;
    static const float colors[][3] = {{1, 1, 1}, {1, 0.5f, 0.2f}, {0.1f, 0.3f, 1}, {1, 0, 0}, {0.02f, 1, 0.5f}};
    double worst = 0.0;
    for (int k = 0; k < 5; k++) {
        static float in[PROBE_WIDTH][4], out[PROBE_WIDTH][4];
        for (int i = 0; i < PROBE_WIDTH; i++) // 2^-18..2^15: from far under one level to the sun's disc
            for (int c = 0; c < 3; c++) in[i][c] = exp2f(-18.0f + 33.0f * (float)i / (PROBE_WIDTH - 1)) * colors[k][c];
        probe_run("#include \"common/tonemap.glsl\"",
                  "vec4 probe(vec4 x) { return vec4(srgb_encode(tonemap(x.rgb)), 1.0); }", in, PROBE_WIDTH, out);
        for (int i = 0; i < PROBE_WIDTH; i++) {
            double want[3];
            exact_tonemap(in[i], want);
            for (int c = 0; c < 3; c++) worst = fmax(worst, 255.0 * fabs(out[i][c] - want[c]));
        }
    }
    print_message("largest error of the tone map: %.3f / 255\n", worst);
    // 0.13 of the film's curve and 0.16 of the encoding, each as fitted; 0.4 is less than rounding to a level does.
    assert_true(worst < 0.4);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        IN_BOTH_APIS(the_tone_map_is_monotone_from_black_to_white),
        IN_BOTH_APIS(grey_stays_grey_and_middle_grey_stays_where_it_was),
        IN_BOTH_APIS(the_fitted_curves_stay_within_half_a_level_of_the_exact_ones),
        IN_BOTH_APIS(the_mean_of_equal_samples_is_the_sample),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

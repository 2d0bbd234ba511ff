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
    bolan_gl_texture_upload(&r->color, 0, -1, rgba, false);
    r->f.block.exposure = bolan_v3(1.0f, 1.0f, 1.0f);
    rig_upload(r);
    for (uint32_t s = 0; s < samples; s++) {
        bolan_gl_target_bind(&r->display);
        r->to.samples = samples;
        bolan_pass_tonemap_draw(r->tonemap, &r->f, &r->to, &r->color, s, NULL);
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

// Middle grey stays: a = 0.18 (0.18^(-1/1.5) - 1).
static double exact_film(double x) { return pow(x / (x + 0.18 * (pow(0.18, -1.0 / 1.5) - 1.0)), 1.5); }
static double exact_srgb(double c) { return c < 0.0031308 ? 12.92 * c : 1.055 * pow(c, 1.0 / 2.4) - 0.055; }

static void exact_tonemap(const float in[4], double out[3]) {
    double c[3], y = 0.2126 * in[0] + 0.7152 * in[1] + 0.0722 * in[2];
    const double most = fmax(fmax(in[0], in[1]), fmax(in[2], 1e-6)), least = fmin(fmin(in[0], in[1]), in[2]);
    const double dim = 1.0 / (1.0 + 0.12 * y), share = 0.4 * dim;
    const double colored = (1.0 + 0.4 * dim * least / most) * (1.0 - 0.7 * y / (y + 40.0));
    for (int k = 0; k < 3; k++) c[k] = y + (in[k] - y) * colored;
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
    // 0.04 of the film's curve and 0.16 of the encoding, each as fitted; 0.4 is less than rounding to a level does.
    assert_true(worst < 0.4);
}

// ---- glow

enum { GLOW_SIZE = 256, GLOW_CELLS = GLOW_SIZE / 4 };

// Mean over the block of `size` cells of 4 x 4 pixels that a pixel of a level lies in; blocks of powers of 2.
static double block_mean(const float *rgba, int x, int y, int size) {
    const int pixels = 4 * size, x0 = x / pixels * pixels, y0 = y / pixels * pixels;
    double sum = 0.0;
    for (int j = y0; j < y0 + pixels; j++)
        for (int i = x0; i < x0 + pixels; i++) sum += fmin(40.0, (double)rgba[4 * (j * GLOW_SIZE + i)]);
    return sum / (pixels * pixels);
}

// A bright square on grey; 1000 is cut to 40, as tonemap_glow.glsl does, so that no glint outshines all.
static void fill_square(float *rgba) {
    for (int j = 0; j < GLOW_SIZE; j++)
        for (int i = 0; i < GLOW_SIZE; i++) {
            float *p = rgba + 4 * (j * GLOW_SIZE + i);
            p[0] = p[1] = p[2] = i >= 64 && i < 96 && j >= 128 && j < 144 ? 1000.0f : 0.1f;
            p[3] = 1.0f;
        }
}

static void draw_square(sky_rig *r, const float *rgba, bolan_quality quality, uint32_t samples, uint8_t *rgb) {
    r->step.quality = quality;
    r->f.block.exposure = bolan_v3(1.0f, 1.0f, 1.0f);
    rig_upload(r);
    bolan_gl_texture_upload(&r->color, 0, -1, rgba, false);
    for (uint32_t s = 0; s < samples; s++) {
        bolan_gl_target_bind(&r->display);
        r->to.samples = samples;
        bolan_pass_tonemap_draw(r->tonemap, &r->f, &r->to, &r->color, s, NULL);
    }
    read_bytes(r->display.id, GLOW_SIZE, GLOW_SIZE, rgb);
    assert_true(watch_is_clean("glow"));
}

// At high quality 6 % of every pixel's light is spread: half over 8 pixels, 30 % over 32, 20 % over 128 (levels 1, 3
// and 5 of the quarter-size copy).
static void six_percent_of_the_light_glows_at_high_quality(void **state) {
    (void)state;
    float *rgba = malloc(sizeof(float) * 4 * GLOW_SIZE * GLOW_SIZE);
    uint8_t *glow = malloc(3 * GLOW_SIZE * GLOW_SIZE), *plain = malloc(3 * GLOW_SIZE * GLOW_SIZE);
    static float in[PROBE_WIDTH][4], want[PROBE_WIDTH][4];
    sky_rig r;
    rig_create(&r, GLOW_SIZE, GLOW_SIZE);
    fill_square(rgba);
    draw_square(&r, rgba, BOLAN_QUALITY_MEDIUM, 1, plain);
    // places in the middle of the blocks of 8, 32 and 128 pixels, or so near that the bilinear weight of each level is
    // known
    static const int places[][2] = {{64, 64}, {192, 64}, {64, 192}, {192, 192}};
    for (int samples = 1; samples <= 2; samples++) {
        draw_square(&r, rgba, BOLAN_QUALITY_HIGH, (uint32_t)samples, glow);
        int far = 0;
        for (int k = 0; k < 4; k++) {
            const int x = places[k][0], y = places[k][1];
            // between two blocks of 8 and of 32 the level is the mean of four; of 128 it is one block's middle
            double around = 0.2 * block_mean(rgba, x, y, 32);
            for (int c = 0; c < 4; c++)
                around += 0.25 * (0.5 * block_mean(rgba, x - 1 + c % 2, y - 1 + c / 2, 2) +
                                  0.3 * block_mean(rgba, x - 1 + c % 2, y - 1 + c / 2, 8));
            in[k][0] = in[k][1] = in[k][2] = (float)(0.94 * (double)rgba[4 * (y * GLOW_SIZE + x)] + 0.06 * around);
            far += glow[3 * (y * GLOW_SIZE + x)] - plain[3 * (y * GLOW_SIZE + x)];
        }
        probe_run("#include \"common/tonemap.glsl\"",
                  "vec4 probe(vec4 x) { return vec4(srgb_encode(tonemap(x.rgb)), 1.0); }", in, 4, want);
        for (int k = 0; k < 4; k++) {
            const int x = places[k][0], y = GLOW_SIZE - 1 - places[k][1]; // row 0 of the picture is at the top
            // half a level of dither and rounding, and half floats in the glow
            assert_near(glow[3 * (y * GLOW_SIZE + x)], 255.0 * (double)want[k][0], 1.6);
        }
        assert_true(far != 0);
    }
    free(rgba);
    free(glow);
    free(plain);
    rig_destroy(&r);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        IN_BOTH_APIS(the_tone_map_is_monotone_from_black_to_white),
        IN_BOTH_APIS(grey_stays_grey_and_middle_grey_stays_where_it_was),
        IN_BOTH_APIS(the_fitted_curves_stay_within_half_a_level_of_the_exact_ones),
        IN_BOTH_APIS(the_mean_of_equal_samples_is_the_sample),
        IN_BOTH_APIS(six_percent_of_the_light_glows_at_high_quality),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

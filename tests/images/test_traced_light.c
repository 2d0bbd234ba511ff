// SPDX-License-Identifier: MIT
// The shading of physical optics against the path tracer of tests/reference over the same sea, sky and sun, from above
// and from below: mean radiance and colour of bands of rows, and the difference of neighbouring pixels. The reference
// has neither air nor gusts: here the air is divided out, and the gusts are switched off in a copy of the shaders.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "traced_light.h"

#include "../reference/exr.h"

enum { WIDTH = REFERENCE_WIDTH, HEIGHT = REFERENCE_HEIGHT, PIXELS = REFERENCE_PIXELS, BANDS = 8 };
static const uint32_t sunless = BOLAN_EFFECT_REFLECTION | BOLAN_EFFECT_AMBIENT;
static const uint32_t in_the_water = BOLAN_EFFECT_REFRACTION | BOLAN_EFFECT_CAUSTICS | BOLAN_EFFECT_FOG;

#define HIGHEST_ROW_DEG 1.0 // below the horizon: nearer, the reference's sea is flat where Bolan's follows the earth

// Of rows, like the reference REFERENCE_CHANNELS numbers a pixel.
typedef struct band {
    double mean[3];
    double detail; // rms of the difference of neighbours across, over the mean: of green without the sun's reflection
    double relief; // rms of its difference to the mean of the row, likewise
} band;

// What the noise of the path tracer adds is taken off.
static band band_of(const double *light, int first, int last) {
    band b = {{0}, 0.0, 0.0};
    double sum = 0.0, rows = 0.0;
    const double n = (last - first) * WIDTH;
    for (int y = first; y < last; ++y) {
        double row = 0.0;
        for (int x = 0; x < WIDTH; ++x) {
            const double *p = &light[REFERENCE_CHANNELS * (y * WIDTH + x)], *left = x > 0 ? p - REFERENCE_CHANNELS : p;
            const double noise = p[REFERENCE_SIGMA], green = p[REFERENCE_SUNLESS];
            for (int c = 0; c < 3; ++c) b.mean[c] += p[c] / n;
            row += green / WIDTH, sum += green / n;
            b.relief += (green * green - noise * noise) / n;
            if (x > 0) b.detail += (pow(green - left[REFERENCE_SUNLESS], 2.0) - noise * noise) / n;
            if (x > 0) b.detail -= left[REFERENCE_SIGMA] * left[REFERENCE_SIGMA] / n;
        }
        rows += row * row / (last - first);
    }
    b.relief = sqrt(fmax(b.relief - rows, 0.0)) / sum;
    b.detail = sqrt(fmax(b.detail, 0.0)) / sum;
    return b;
}

static int first_row(const reference_view *v) {
    if (v->height < 0.0) return 0;
    const double down = tan(bolan_radians(v->pitch + HIGHEST_ROW_DEG)) / tan(bolan_radians(0.5 * REFERENCE_FOV));
    return (int)fmax(ceil(0.5 * HEIGHT * (1.0 + down)), 0.0);
}

// Mean radiance and colour: 10 %, and 15 % where there is glitter.
// Relief: 15 %.
// Detail: 15 % near a low eye. Less is left to the picture, whose bounds are today's state:
//   - in the first two bands, where crests hide one another that the mesh has not;
//   - from high up, where trilinear fetches pass less of the waves of a pixel's width than a Gaussian does.
// More relief and detail than MOST is left to the picture:
//   - in the first band of the bed, where the sea mirrors the low sky by the mean slope of a pixel;
//   - in its last, which shows bed below the lower edge of the image, mirrored;
//   - in the first of the lagoon, where pixels search for the bed that the surface reflects, without an antialias;
//   - in the last of the window, by the noise of the shafts.
// Less in the third to fifth band of the lagoon: bed and mirrored bed farther than the patch of caustics reaches.
typedef struct bound {
    double low, high;          // mean radiance
    double detail, far_detail; // least; far: of the first two bands
    double relief;             // least
    double most_relief, most_detail;
} bound;
#define MOST 1.15
static const bound bounds[REFERENCE_VIEWS] = {
    {0.90, 1.10, 0.86, 0.80, 0.85, MOST, MOST}, {0.85, 1.15, 0.86, 0.69, 0.85, MOST, MOST},
    {0.85, 1.15, 0.86, 0.66, 0.85, MOST, MOST}, {0.87, 1.10, 0.76, 0.70, 0.85, MOST, MOST},
    {0.87, 1.10, 0.74, 0.54, 0.85, MOST, MOST}, {0.90, 1.10, 0.80, 1.00, 0.85, 1.70, 1.75},
    {0.85, 1.15, 0.68, 0.82, 0.85, MOST, 1.45}, {0.90, 1.10, 0.10, 0.85, 0.80, 1.18, 1.50},
};

static bool is_within(double ratio, double low, double high) { return ratio > low && ratio < high; }

static bool compare(const reference_view *v, const bound *within, const double *light, const double *reference) {
    const int top = first_row(v);
    bool good = true;
    for (int i = 0; i < BANDS; ++i) {
        const int first = top + (HEIGHT - top) * i / BANDS, last = top + (HEIGHT - top) * (i + 1) / BANDS;
        const band got = band_of(light, first, last), want = band_of(reference, first, last);
        const double detail = got.detail / want.detail, relief = got.relief / want.relief;
        print_message("%-8s %d: %.3f %.3f %.3f, detail %.3f / %.3f = %.2f, relief %.3f / %.3f = %.2f\n", v->name, i + 1,
                      got.mean[0] / want.mean[0], got.mean[1] / want.mean[1], got.mean[2] / want.mean[2], got.detail,
                      want.detail, detail, got.relief, want.relief, relief);
        for (int c = 0; c < 3; ++c) good = good && is_within(got.mean[c] / want.mean[c], within->low, within->high);
        good = good && is_within(detail, i < 2 ? within->far_detail : within->detail, within->most_detail);
        good = good && is_within(relief, within->relief, within->most_relief);
    }
    return good;
}

static void draw_effects(studio *t, const reference_view *v, uint32_t effects, double *light) {
    if (v->height < 0.0)
        draw_under_water(t, effects | in_the_water, light);
    else
        draw_light(t, v->bed > 0.0 ? effects | BOLAN_EFFECT_REFRACTION | BOLAN_EFFECT_CAUSTICS : effects, light);
}

// The picture as the reference has it.
static void draw(studio *t, const reference_view *v, double *out) {
    double *light = malloc(sizeof(double) * 3 * PIXELS);
    draw_effects(t, v, sunless | BOLAN_EFFECT_GLITTER, light);
    for (int i = 0; i < PIXELS; ++i) {
        for (int c = 0; c < 3; ++c) out[REFERENCE_CHANNELS * i + c] = light[3 * i + c];
        out[REFERENCE_CHANNELS * i + REFERENCE_SIGMA] = 0.0;
    }
    draw_effects(t, v, sunless, light);
    for (int i = 0; i < PIXELS; ++i) out[REFERENCE_CHANNELS * i + REFERENCE_SUNLESS] = light[3 * i + 1];
    free(light);
}

static bool check(const reference_view *v, const bound *within, const char *shaders) {
    char path[1024];
    float *stored = malloc(sizeof(float) * REFERENCE_CHANNELS * PIXELS);
    double *reference = malloc(sizeof(double) * REFERENCE_CHANNELS * PIXELS);
    double *light = malloc(sizeof(double) * REFERENCE_CHANNELS * PIXELS);
    snprintf(path, sizeof path, BOLAN_SOURCE_DIR "/tests/reference/%s.exr", v->name);
    assert_true(reference_read(path, stored));
    for (int i = 0; i < REFERENCE_CHANNELS * PIXELS; ++i) reference[i] = (double)stored[i];
    studio t;
    open_studio(&t, v, WIDTH, HEIGHT, shaders);
    draw(&t, v, light);
    close_studio(&t);
    const bool good = compare(v, within, light, reference);
    free(stored), free(reference), free(light);
    return good;
}

static void the_picture_is_the_path_tracers(void **state) {
    (void)state;
    bolan_context *context = NULL;
    if (bolan_context_create(BOLAN_GL_CORE, &context) != BOLAN_OK) skip_without_gl();
    char shaders[] = "light_XXXXXX";
    make_shaders(shaders);
    bool good = true;
    for (int i = 0; i < (test_is_short() ? 1 : REFERENCE_VIEWS); ++i)
        good = check(&reference_views[i], &bounds[i], shaders) && good;
    remove_shaders(shaders);
    bolan_context_destroy(&context);
    assert_true(good);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(the_picture_is_the_path_tracers)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

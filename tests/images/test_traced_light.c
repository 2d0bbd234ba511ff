// SPDX-License-Identifier: MIT
// The shading of physical optics against the path tracer of tests/reference over the same sea, sky and sun: mean
// radiance and colour of bands of rows, and the difference of neighbouring pixels. The reference has neither air nor
// gusts: here the air is divided out, and the gusts are switched off in a copy of the shaders.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "traced_light.h"

#include "../reference/exr.h"

enum { WIDTH = REFERENCE_WIDTH, HEIGHT = REFERENCE_HEIGHT, PIXELS = REFERENCE_PIXELS, BANDS = 8 };
static const uint32_t sea_light = BOLAN_EFFECT_REFLECTION | BOLAN_EFFECT_GLITTER | BOLAN_EFFECT_AMBIENT;

#define HIGHEST_ROW_DEG 1.0 // below the horizon: nearer, the reference's sea is flat where Bolan's follows the earth

typedef struct studio {
    stage s;
    bolan_target *target;
    float *rgb, *distance;
} studio;

static void open_studio(studio *t, const reference_view *v, const char *shaders) {
    const bolan_scene scene = reference_scene(v);
    bolan_renderer_desc desc = bolan_renderer_desc_default();
    desc.quality = BOLAN_QUALITY_HIGH;
    desc.shader_directory = shaders;
    *t = (studio){.rgb = malloc(sizeof(float) * 3 * PIXELS), .distance = malloc(sizeof(float) * PIXELS)};
    assert_true(stage_load(&t->s, &scene));
    stage_settle(&t->s, scene.time);
    assert_int_equal(bolan_renderer_create(&desc, &t->s.renderer), BOLAN_OK);
    assert_int_equal(bolan_target_create(WIDTH, HEIGHT, &t->target), BOLAN_OK);
}

static void close_studio(studio *t) {
    free(t->rgb), free(t->distance);
    bolan_target_destroy(&t->target);
    stage_close(&t->s);
}

static void add_picture(studio *t, uint32_t effects, double weight, double *sum) {
    const double half = tan(bolan_radians(0.5 * REFERENCE_FOV));
    t->s.scene.look.effects = effects;
    const bolan_view v = stage_view(&t->s, t->target, WIDTH, HEIGHT);
    bolan_renderer_draw_world(t->s.renderer, t->s.world, &v);
    bolan_renderer_read_linear(t->s.renderer, t->rgb, t->distance);
    for (int i = 0; i < PIXELS; ++i) {
        if (!isfinite(t->distance[i])) continue;
        const double x = (2.0 * (i % WIDTH + 0.5) - WIDTH) / HEIGHT * half;
        const double y = (1.0 - 2.0 * (i / WIDTH + 0.5) / HEIGHT) * half;
        const double d = (double)t->distance[i] * sqrt(1.0 + x * x + y * y);
        for (int c = 0; c < 3; ++c) sum[3 * i + c] += weight * (double)t->rgb[3 * i + c] / through_air(c, d);
    }
}

// Radiance at the sea: the picture less the one without any light of the sea, which is the air's.
static void draw(studio *t, double *light) {
    for (int i = 0; i < 3 * PIXELS; ++i) light[i] = 0.0;
    add_picture(t, sea_light, 1.0, light);
    add_picture(t, 0, -1.0, light);
}

typedef struct band {
    double mean[3], contrast; // rms of the difference of green across, over the mean
} band;

// stride: numbers a pixel; the fourth of them is the standard error of green, whose share is taken off the contrast.
static band band_of(const double *light, int stride, int first, int last) {
    band b = {{0}, 0.0};
    const double n = (last - first) * WIDTH;
    for (int i = first * WIDTH; i < last * WIDTH; ++i) {
        for (int c = 0; c < 3; ++c) b.mean[c] += light[stride * i + c] / n;
        if (i % WIDTH == 0) continue;
        const double *p = &light[stride * i], *left = p - stride, d = p[1] - left[1];
        b.contrast += d * d / n;
        if (stride > 3) b.contrast -= (p[3] * p[3] + left[3] * left[3]) / n;
    }
    b.contrast = sqrt(fmax(b.contrast, 0.0)) / b.mean[1];
    return b;
}

static int first_row(const reference_view *v) {
    const double down = tan(bolan_radians(v->pitch + HIGHEST_ROW_DEG)) / tan(bolan_radians(0.5 * REFERENCE_FOV));
    return (int)fmax(ceil(0.5 * HEIGHT * (1.0 + down)), 0.0);
}

// The goal is 10 % in mean radiance and colour, 15 % where it is glitter, and 15 % in contrast. Not reached:
//
//   near       red of the first band, 1 to 5 degrees under the horizon, is 1.14
//   low_sun    0.74 to 1.05. Open which of both is off: the picture has one mean factor for the shadows of waves, and
//              in the reference fine waves and capillaries cast none, which makes it too bright
//   contrast   0.35 to 0.9 of the reference in most bands; a part is the filter of the textures, wider than a pixel
//
// Contrast is bounded from below alone, at today's state: that of single bands of the reference with the sun in them
// has noise of some 30 %.
typedef struct bound {
    double low, high, contrast;
} bound;
static const bound bounds[REFERENCE_VIEWS] = {
    {0.90, 1.16, 0.50}, {0.90, 1.10, 0.60}, {0.70, 1.15, 0.60}, {0.90, 1.10, 0.30}, {0.90, 1.10, 0.28},
};

static bool compare(const reference_view *v, const bound *within, const double *light, const double *reference) {
    const int top = first_row(v);
    bool good = true;
    for (int i = 0; i < BANDS; ++i) {
        const int first = top + (HEIGHT - top) * i / BANDS, last = top + (HEIGHT - top) * (i + 1) / BANDS;
        const band got = band_of(light, 3, first, last), want = band_of(reference, REFERENCE_CHANNELS, first, last);
        const double contrast = got.contrast / want.contrast;
        print_message("%-8s %d: %.3f %.3f %.3f, contrast %.3f / %.3f = %.2f\n", v->name, i + 1,
                      got.mean[0] / want.mean[0], got.mean[1] / want.mean[1], got.mean[2] / want.mean[2], got.contrast,
                      want.contrast, contrast);
        for (int c = 0; c < 3; ++c)
            good = good && got.mean[c] > within->low * want.mean[c] && got.mean[c] < within->high * want.mean[c];
        good = good && contrast > within->contrast;
    }
    return good;
}

static bool check(const reference_view *v, const bound *within, const char *shaders) {
    char path[1024];
    float *stored = malloc(sizeof(float) * REFERENCE_CHANNELS * PIXELS);
    double *reference = malloc(sizeof(double) * REFERENCE_CHANNELS * PIXELS);
    double *light = malloc(sizeof(double) * 3 * PIXELS);
    snprintf(path, sizeof path, BOLAN_SOURCE_DIR "/tests/reference/%s.exr", v->name);
    assert_true(reference_read(path, stored));
    for (int i = 0; i < REFERENCE_CHANNELS * PIXELS; ++i) reference[i] = (double)stored[i];
    studio t;
    open_studio(&t, v, shaders);
    draw(&t, light);
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

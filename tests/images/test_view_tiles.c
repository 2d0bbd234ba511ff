// SPDX-License-Identifier: MIT
// Tiles of a large image against the image drawn whole. What belongs to a pixel alone is the same in both, but for the
// rounding of a projection: a value at the border of two levels may fall on either side. What looks round itself in the
// image (reflections of land, refraction, blurred reflections, glow, half-rate shading) finds less near the edge of a
// tile; there a guard band, an overlap that is cut off, makes up for it. Corners at multiples of 64 pixels give shared
// pixels (texture levels, quads of derivatives) the places that they have in the whole.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "picture.h"

enum { WIDTH = 512, HEIGHT = 256, BYTES = WIDTH * HEIGHT * 3 };

// ---- drawing --------------------------------------------------------------------------------------------------------

static void draw(stage *s, const bolan_view *from, uint8_t *rgb) {
    bolan_target *target = NULL;
    bolan_view view = *from;
    assert_int_equal(bolan_target_create(view.width, view.height, &target), BOLAN_OK);
    view.framebuffer = bolan_target_framebuffer(target);
    bolan_renderer_draw_world(s->renderer, s->world, &view);
    bolan_renderer_read_rgb8(s->renderer, view.framebuffer, view.width, view.height, rgb);
    bolan_target_destroy(&target);
    assert_true(watch_is_clean("after a view"));
}

static bolan_view whole_view(const stage *s) { return bolan_view_from_camera(&s->scene.camera, WIDTH, HEIGHT); }

typedef struct rectangle {
    uint32_t x, y, width, height; // x, y: of the lower left corner
} rectangle;

static rectangle widened(rectangle r, uint32_t guard) {
    const uint32_t left = r.x < guard ? r.x : guard, below = r.y < guard ? r.y : guard;
    const uint32_t right = WIDTH - r.x - r.width, above = HEIGHT - r.y - r.height;
    return (rectangle){r.x - left, r.y - below, r.width + left + (right < guard ? right : guard),
                       r.height + below + (above < guard ? above : guard)};
}

// Draws the rectangle with a guard band, and copies the rectangle alone to its place in @p out (top row first).
static void draw_tile(stage *s, rectangle r, uint32_t guard, uint8_t *out) {
    static uint8_t rgb[BYTES];
    const rectangle w = widened(r, guard);
    bolan_view view = whole_view(s);
    view.tile.x = w.x, view.tile.y = w.y;
    view.tile.whole_width = WIDTH, view.tile.whole_height = HEIGHT;
    view.width = w.width, view.height = w.height;
    draw(s, &view, rgb);
    for (uint32_t row = 0; row < r.height; ++row) {
        const uint32_t y = r.y + row; // from the bottom of the whole
        const uint8_t *from = rgb + 3 * ((size_t)(w.height - 1 - (y - w.y)) * w.width + (r.x - w.x));
        memcpy(out + 3 * ((size_t)(HEIGHT - 1 - y) * WIDTH + r.x), from, 3 * (size_t)r.width);
    }
}

// Columns and rows where the tiles meet.
typedef struct cuts {
    uint32_t columns[4], rows[3];
} cuts;
// Odd, so that no mistake is hidden by a power of two; and multiples of what some optics share between pixels.
static const cuts odd = {{0, 171, 345, WIDTH}, {0, 117, HEIGHT}}, even = {{0, 128, 384, WIDTH}, {0, 128, HEIGHT}};

static void draw_tiles(stage *s, const cuts *c, uint32_t guard, uint8_t *out) {
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 3; ++i)
            draw_tile(s,
                      (rectangle){c->columns[i], c->rows[j], c->columns[i + 1] - c->columns[i],
                                  c->rows[j + 1] - c->rows[j]},
                      guard, out);
}

// ---- comparing ------------------------------------------------------------------------------------------------------

typedef struct difference {
    int most;      // of 255
    double share;  // of bytes that differ by more than one level
    double psnr;   // [dB]
} difference;

static difference compare(const uint8_t *a, const uint8_t *b) {
    difference d = {0};
    double sum = 0.0;
    for (int i = 0; i < BYTES; ++i) {
        const int away = abs((int)a[i] - (int)b[i]);
        d.most = away > d.most ? away : d.most;
        d.share += (double)(away > 1) / BYTES;
        sum += (double)away * away / BYTES;
    }
    d.psnr = 10.0 * log10(255.0 * 255.0 / (sum + 1e-9));
    return d;
}

static void check(const char *name, const uint8_t *whole, const uint8_t *parts, int most, double share,
                        double psnr) {
    const difference d = compare(whole, parts);
    print_message("%s: at most %d levels, %.4f %% differ by more than one, %.1f dB\n", name, d.most, 100.0 * d.share,
                  d.psnr);
    const picture a = {WIDTH, HEIGHT, (uint8_t *)whole, NULL}, b = {WIDTH, HEIGHT, (uint8_t *)parts, NULL};
    if (getenv("BOLAN_KEEP") || d.most > most || d.share > share || d.psnr < psnr)
        picture_report(name, &a, &b, d.psnr, psnr);
    if (d.most > most || d.share > share || d.psnr < psnr)
        fail_msg("%s: expected at most %d levels, %.4f %%, %.1f dB", name, most, 100.0 * share, psnr);
}

static void open(stage *s, const char *name, const bolan_technique *technique, bolan_quality quality) {
    bolan_scene scene;
    assert_int_equal(bolan_scene_load(name, &scene), BOLAN_OK);
    bolan_scene_set_technique(&scene, technique);
    scene.sea.resolution = 64;
    assert_true(stage_open(s, &scene, quality, false));
}

static uint8_t whole[BYTES], parts[BYTES];

static void against_whole(const char *name, const char *scene, const bolan_technique *technique, bolan_quality quality,
                          const cuts *c, uint32_t guard, int most, double share, double psnr) {
    stage s;
    open(&s, scene, technique, quality);
    const bolan_view view = whole_view(&s);
    memset(parts, 0, sizeof parts);
    draw(&s, &view, whole);
    draw_tiles(&s, c, guard, parts);
    check(name, whole, parts, most, share, psnr);
    stage_close(&s);
}

static void tiles_of_sky_and_water_are_the_whole(void **state) {
    (void)state;
    against_whole("sea", "open-sea", &bolan_technique_ocean, BOLAN_QUALITY_MEDIUM, &even, 64, 1, 0.0, 75.0);
    // Elsewhere than at multiples of a step, the air is interpolated between other places: a few levels.
    against_whole("sea_odd", "open-sea", &bolan_technique_ocean, BOLAN_QUALITY_MEDIUM, &odd, 0, 40, 0.06, 45.0);
}

static void tiles_with_a_guard_have_its_glow_and_half_rate_shading(void **state) {
    (void)state;
    against_whole("sea_low", "open-sea", &bolan_technique_ocean, BOLAN_QUALITY_LOW, &even, 64, 1, 0.0, 75.0);
    against_whole("sea_high", "open-sea", &bolan_technique_ocean, BOLAN_QUALITY_HIGH, &even, 128, 1, 0.0, 75.0);
}

// A pixel at a silhouette may show what stands behind it.
static void tiles_of_land_need_a_guard(void **state) {
    (void)state;
    against_whole("island_odd", "island", &bolan_technique_ocean, BOLAN_QUALITY_MEDIUM, &odd, 0, 80, 0.02, 50.0);
    // The land that the water mirrors must stand in the tile or its guard: that of the program has 128 pixels.
    against_whole("island", "island", &bolan_technique_ocean, BOLAN_QUALITY_MEDIUM, &even, 128, 20, 5e-5, 75.0);
}

static void tiles_of_the_papers_are_the_whole(void **state) {
    (void)state;
    against_whole("exp_cosine", "open-sea", &bolan_technique_exp_cosine, BOLAN_QUALITY_MEDIUM, &even, 64, 1, 0.0, 70.0);
    against_whole("flight", "open-sea", &bolan_technique_flight_sim, BOLAN_QUALITY_MEDIUM, &even, 64, 2, 1e-5, 75.0);
    // A few pixels at silhouettes show what stands behind them.
    against_whole("pond", "pond", &bolan_technique_two_triangle, BOLAN_QUALITY_MEDIUM, &even, 64, 40, 2e-4, 60.0);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(tiles_of_sky_and_water_are_the_whole),
                                       cmocka_unit_test(tiles_with_a_guard_have_its_glow_and_half_rate_shading),
                                       cmocka_unit_test(tiles_of_land_need_a_guard),
                                       cmocka_unit_test(tiles_of_the_papers_are_the_whole)};
    bolan_context *context = NULL;
    if (bolan_context_create(BOLAN_GL_CORE, &context) != BOLAN_OK) return 77;
    const int failed = cmocka_run_group_tests_name("tiles", tests, NULL, NULL);
    bolan_context_destroy(&context);
    return failed;
}

// SPDX-License-Identifier: MIT
// The water of every scene that comes with the program, at its own exposure: highlights keep their structure, and deep
// water by day has colour.
#include "picture.h"
#include "support.h"

enum { WIDTH = 320, HEIGHT = 180, PIXELS = WIDTH * HEIGHT };

#define BRIGHT 225       // of 255, the mean of a pixel's channels
#define MOST_BRIGHT 0.05 // share of the water
#define LOW_SUN 10.0     // [deg]: below, its path is bright by right
#define LEAST_COLOR 0.25 // mean saturation of deep water, (max - min) / max
#define DEEP 30.0        // [m]: no bed is seen through more
#define OVERCAST 0.5     // cover from which clouds mirror grey

static bolan_context *context;

static int open_context(void **state) {
    (void)state;
    return bolan_context_create(BOLAN_GL_CORE, &context) == BOLAN_OK ? 0 : -1;
}

static int close_context(void **state) {
    (void)state;
    bolan_context_destroy(&context);
    return 0;
}

typedef struct water_colors {
    double bright, saturation; // share of the water; mean over deep water
    uint32_t water, deep;      // pixels
} water_colors;

// Whether the water under a pixel is deep. distance: along the axis of the view [m].
static bool is_deep(const stage *s, const bolan_view *view, uint32_t pixel, float distance) {
    if (stage_ground(s) == NULL) return true;
    const float *m = view->view.m; // its rows are the axes of the eye
    const float right = (2.0f * ((float)(pixel % WIDTH) + 0.5f) / WIDTH - 1.0f) / view->projection.m[0];
    const float up = (1.0f - 2.0f * ((float)(pixel / WIDTH) + 0.5f) / HEIGHT) / view->projection.m[5];
    const double x = view->eye.x + (double)(distance * (m[0] * right + m[1] * up - m[2]));
    const double y = view->eye.y + (double)(distance * (m[4] * right + m[5] * up - m[6]));
    return (double)bolan_ground_elevation(stage_ground(s), x, y, 10.0) < -DEEP;
}

// An eye under water sees water in every pixel.
static water_colors measure(stage *s) {
    static uint8_t rgb[3 * PIXELS];
    static uint32_t labels[PIXELS];
    static float distances[PIXELS];
    water_colors c = {.bright = 0.0};
    bolan_target *target = NULL;
    assert_int_equal(bolan_target_create(WIDTH, HEIGHT, &target), BOLAN_OK);
    bolan_view view = stage_view(s, target, WIDTH, HEIGHT);
    view.samples = 1;
    bolan_renderer_draw_world(s->renderer, s->world, &view);
    bolan_renderer_read_rgb8(s->renderer, view.framebuffer, WIDTH, HEIGHT, rgb);
    bolan_renderer_read_linear(s->renderer, NULL, distances);
    const bool under = view.eye.z < 0.0;
    const bolan_surfaces surfaces = {.label = labels};
    if (!under) bolan_renderer_read_surfaces(s->renderer, s->world, &view, &surfaces);
    for (uint32_t i = 0; i < PIXELS; ++i) {
        if (!under && labels[i] != BOLAN_LABEL_WATER && labels[i] != BOLAN_LABEL_FOAM) continue;
        const uint8_t *p = rgb + (size_t)3 * i;
        const int most = p[0] > p[1] ? (p[0] > p[2] ? p[0] : p[2]) : (p[1] > p[2] ? p[1] : p[2]);
        const int least = p[0] < p[1] ? (p[0] < p[2] ? p[0] : p[2]) : (p[1] < p[2] ? p[1] : p[2]);
        ++c.water;
        c.bright += p[0] + p[1] + p[2] > 3 * BRIGHT;
        if (under || !is_deep(s, &view, i, distances[i])) continue;
        ++c.deep;
        c.saturation += (double)(most - least) / (most > 0 ? most : 1);
    }
    bolan_target_destroy(&target);
    c.bright /= c.water > 0 ? c.water : 1;
    c.saturation /= c.deep > 0 ? c.deep : 1;
    return c;
}

static void water_is_neither_burnt_out_nor_grey(void **state) {
    (void)state;
    // `coast` needs a raster.
    static const char *const names[] = {"approach", "calm", "island", "measured",  "open-sea",
                                        "pond",     "reef", "storm",  "underwater"};
    stage s = {.world = NULL};
    for (size_t i = 0; i < sizeof names / sizeof *names; ++i) {
        bolan_scene scene;
        assert_int_equal(bolan_scene_load(names[i], &scene), BOLAN_OK);
        scene.camera = bolan_scene_camera_at(&scene, scene.time);
        if (i == 0)
            assert_true(stage_open(&s, &scene, BOLAN_QUALITY_LOW, false));
        else
            stage_settle_scene(&s, &scene); // programs are compiled once
        const water_colors c = measure(&s);
        print_message("%s: %.1f %% of the water bright, saturation of %u deep pixels %.3f\n", names[i],
                      100.0 * c.bright, c.deep, c.saturation);
        assert_true(c.water > PIXELS / 10);
        if (scene.sky.sun_elevation_deg >= LOW_SUN) assert_true(c.bright <= MOST_BRIGHT);
        if (c.deep > PIXELS / 10 && scene.sky.cloud_cover < OVERCAST && scene.sky.sun_elevation_deg >= LOW_SUN)
            assert_true(c.saturation >= LEAST_COLOR);
    }
    stage_close(&s);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(water_is_neither_burnt_out_nor_grey)};
    return cmocka_run_group_tests(tests, open_context, close_context);
}

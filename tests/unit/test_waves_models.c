// SPDX-License-Identifier: MIT
// Sums of waves and TEXTURES: validation, memory, calm seas, and what TEXTURES makes of its desc.
#include "content_support.h"
#include "sea_support.h"

#include "bolan/query.h"

#include <string.h>

typedef struct watcher {
    uint32_t allocations, sentences;
    int64_t budget; // allocations that succeed; negative: all
    bolan_log_id id;
    char sentence[256];
} watcher;

static void *count_allocation(void *user, size_t size, size_t align) {
    watcher *w = user;
    w->allocations++;
    if (w->budget >= 0 && w->allocations > w->budget) return NULL;
    return aligned_alloc(align, (size + align - 1) / align * align);
}

static void release(void *user, void *memory, size_t size) {
    (void)user;
    (void)size;
    free(memory);
}

static void keep_sentence(void *user, bolan_log_level level, bolan_log_id id, const char *sentence) {
    watcher *w = user;
    (void)level;
    w->sentences++;
    w->id = id;
    snprintf(w->sentence, sizeof w->sentence, "%s", sentence);
}

static void watch(watcher *w) {
    const bolan_hooks hooks = {.user = w, .allocate = count_allocation, .release = release, .log = keep_sentence};
    *w = (watcher){.budget = -1};
    bolan_set_hooks(&hooks);
}

static void refused(bolan_sea_desc desc, const char *field, bolan_log_id id) {
    watcher w;
    bolan_sea *sea = NULL;
    watch(&w);
    assert_int_equal(bolan_sea_create(&desc, &sea), BOLAN_ERROR_ARGUMENT);
    assert_null(sea);
    assert_int_equal(w.sentences, 1);
    assert_int_equal(w.id, id);
    assert_non_null(strstr(w.sentence, field));
    bolan_set_hooks(NULL);
}

#define REFUSED(field, value, id)                       \
    do {                                                \
        bolan_sea_desc desc = bolan_sea_desc_default(); \
        desc.field = value;                             \
        refused(desc, #field, id);                      \
    } while (0)

static void every_bad_field_is_named_in_one_sentence(void **state) {
    (void)state;
    REFUSED(cosines.frequencies, 0, BOLAN_LOG_OUT_OF_RANGE);
    REFUSED(cosines.frequencies, BOLAN_MAX_FREQUENCIES + 1, BOLAN_LOG_OUT_OF_RANGE);
    REFUSED(cosines.directions, 0, BOLAN_LOG_OUT_OF_RANGE);
    REFUSED(cosines.directions, BOLAN_MAX_DIRECTIONS + 1, BOLAN_LOG_OUT_OF_RANGE);
    REFUSED(exp_cosine.wave_count, 0, BOLAN_LOG_OUT_OF_RANGE);
    REFUSED(exp_cosine.wave_count, BOLAN_MAX_EXP_WAVES + 1, BOLAN_LOG_OUT_OF_RANGE);
    REFUSED(exp_cosine.sharpness, 0.0, BOLAN_LOG_OUT_OF_RANGE);
    REFUSED(exp_cosine.sharpness, NAN, BOLAN_LOG_NOT_FINITE);
    REFUSED(exp_cosine.sharpness, 2.5, BOLAN_LOG_OUT_OF_RANGE);
    REFUSED(textures.period, 0.5, BOLAN_LOG_OUT_OF_RANGE);
    REFUSED(textures.period, NAN, BOLAN_LOG_NOT_FINITE);
    REFUSED(textures.frames, 1, BOLAN_LOG_OUT_OF_RANGE);
    REFUSED(textures.frames, BOLAN_MAX_LOOP_FRAMES + 1, BOLAN_LOG_OUT_OF_RANGE);
    REFUSED(cosines.split, (bolan_frequency_split)2, BOLAN_LOG_BAD_ARGUMENT);
    REFUSED(waves, (bolan_wave_model)4, BOLAN_LOG_BAD_ARGUMENT);
}

static bolan_sea_desc desc_of(int model) {
    bolan_sea_desc desc = bolan_sea_desc_default();
    desc.waves = (bolan_wave_model)model;
    desc.resolution = 32;
    return desc;
}

static void nothing_allocates_after_creation_and_all_memory_comes_back(void **state) {
    (void)state;
    for (int model = 0; model < BOLAN_WAVE_MODELS; model++) {
        watcher w;
        watch(&w);
        bolan_sea *sea = test_sea(desc_of(model));
        const uint32_t before = w.allocations;
        bolan_dvec2 at[300];
        float spacing[300], height[300];
        bolan_sea_sample sample[300];
        for (int i = 0; i < 300; i++) at[i] = (bolan_dvec2){3.0 * i, 2.0}, spacing[i] = 1.0f;
        bolan_sea_step(sea, 0.1);
        bolan_sea_settle(sea, 77.0);
        bolan_sea_sample_rest(sea, at, 300, sample);
        bolan_sea_sample_grid(sea, at, spacing, 300, sample);
        bolan_query_heights(&(bolan_water){.sea = sea}, at, 300, height);
        bolan_sea_measure(sea);
        char hash[17];
        bolan_sea_hash(sea, hash);
        assert_int_equal(w.allocations, before);
        bolan_sea_destroy(&sea);
        assert_int_equal(bolan_memory_in_use(), 0);
        assert_int_equal(w.sentences, 0);
        bolan_set_hooks(NULL);
    }
}

static void refused_memory_is_an_error_and_leaks_nothing(void **state) {
    (void)state;
    for (int model = 0; model < BOLAN_WAVE_MODELS; model++) {
        for (int64_t budget = 0; budget < 14; budget++) {
            watcher w;
            watch(&w);
            w.budget = budget;
            const bolan_sea_desc desc = desc_of(model);
            bolan_sea *sea = NULL;
            if (bolan_sea_create(&desc, &sea) == BOLAN_OK) {
                bolan_sea_destroy(&sea);
            } else {
                assert_int_equal(w.id, BOLAN_LOG_OUT_OF_MEMORY);
                assert_int_equal(w.sentences, 1);
            }
            assert_int_equal(bolan_memory_in_use(), 0);
            bolan_set_hooks(NULL);
        }
    }
}

static void a_calm_sea_is_flat_in_every_model(void **state) {
    (void)state;
    for (int model = 0; model < BOLAN_WAVE_MODELS; model++) {
        bolan_sea_desc desc = test_calm_desc(32);
        desc.waves = (bolan_wave_model)model;
        bolan_sea *sea = test_sea(desc);
        const bolan_dvec2 at = {3.0, 4.0};
        const float spacing = 1.0f;
        bolan_sea_sample s[2];
        float height;
        bolan_sea_step(sea, 5.0);
        bolan_sea_sample_rest(sea, &at, 1, &s[0]);
        bolan_sea_sample_grid(sea, &at, &spacing, 1, &s[1]);
        bolan_query_heights(&(bolan_water){.sea = sea}, &at, 1, &height);
        for (int i = 0; i < 2; i++) assert_true(s[i].height == 0.0f && s[i].jacobian == 1.0f && s[i].foam == 0.0f);
        assert_true(height == 0.0f);
        assert_int_equal(bolan_sea_component_count(sea), 0);
        const bolan_sea_statistics measured = bolan_sea_measure(sea);
        assert_true(measured.hs == 0.0 && measured.jacobian_min == 1.0);
        bolan_sea_destroy(&sea);
    }
}

static void waves_are_sorted_and_lie_within_the_bounds(void **state) {
    (void)state;
    for (int model = BOLAN_WAVES_COSINES; model <= BOLAN_WAVES_EXP_COSINE; model++) {
        bolan_sea *sea = test_sea(desc_of(model));
        double k = 0.0, vertical, horizontal;
        for (uint32_t i = 0; i < bolan_sea_component_count(sea); i++) {
            const bolan_sea_component c = bolan_sea_get_component(sea, i);
            assert_true(hypot(c.kx, c.ky) >= k * (1.0 - 1e-12));
            assert_true(c.phase >= 0.0 && c.phase < 2.0 * BOLAN_PI && c.amplitude > 0.0 && c.omega > 0.0);
            k = hypot(c.kx, c.ky);
        }
        bolan_sea_bounds(sea, &vertical, &horizontal);
        for (int i = 0; i < 2000; i++) {
            const bolan_dvec2 at = {13.7 * i, 7.9 * i};
            bolan_sea_sample s;
            bolan_sea_sample_rest(sea, &at, 1, &s);
            assert_true(fabs((double)s.height) <= vertical && hypot(s.dx, s.dy) <= horizontal);
        }
        bolan_sea_destroy(&sea);
    }
}

static void shallow_water_attenuates_a_sum_as_one(void **state) {
    (void)state;
    bolan_ground *terrain = NULL;
    bolan_ground_generator ground = generator_named("island");
    assert_int_equal(bolan_content_create_ground(&ground, &terrain), BOLAN_OK);
    bolan_sea *sea = test_sea(desc_of(BOLAN_WAVES_COSINES));
    bolan_dvec2 at[400];
    bolan_query_point answer[400];
    for (int i = 0; i < 400; i++) at[i] = (bolan_dvec2){20.0 * (i - 200), 3.0 * i};
    bolan_query_surface(&(bolan_water){.sea = sea, .ground = terrain}, at, 400, answer);
    double vertical, horizontal;
    bolan_sea_bounds(sea, &vertical, &horizontal);
    uint32_t land = 0;
    for (int i = 0; i < 400; i++) {
        const double depth = -(double)bolan_ground_elevation(terrain, at[i].x, at[i].y, 2.0);
        assert_true(fabs((double)answer[i].height) <= vertical);
        if (depth > -2.0 * vertical) continue;
        assert_true(answer[i].height == 0.0f);
        land++;
    }
    assert_true(land > 50);
    bolan_sea_destroy(&sea);
    bolan_ground_destroy(&terrain);
}

static void textures_is_one_tile_of_seven_peak_waves_in_a_loop_near_ten_seconds(void **state) {
    (void)state;
    bolan_sea_desc desc = desc_of(BOLAN_WAVES_TEXTURES);
    desc.resolution = 256;
    bolan_sea *sea = test_sea(desc);
    const bolan_sea_desc *resolved = bolan_sea_get_desc(sea);
    const double tp = bolan_sea_state_summary(&desc.sea_state).tp, peak = 9.81 * tp * tp / (2.0 * BOLAN_PI);
    assert_int_equal(bolan_sea_cascade_count(sea), 1);
    assert_int_equal(bolan_sea_component_count(sea), 0);
    assert_true(resolved->length >= 6.0 * peak && resolved->length <= 8.0 * peak);
    assert_near(remainder(resolved->textures.period, tp), 0.0, 1e-9);
    assert_true(resolved->textures.period > 6.6 && resolved->textures.period < 13.4); // within half a period of 10 s
    // The oracle shows the same frame as the fields, but for the images of the shortest waves.
    bolan_sea_step(sea, 3.33);
    for (int i = 0; i < 10; i++) {
        const double node = resolved->length / 256.0;
        const bolan_dvec2 at = {17 * i * node, 5 * i * node};
        bolan_sea_sample s;
        bolan_sea_sample_rest(sea, &at, 1, &s);
        const bolan_sea_sample direct = bolan_sea_sample_direct(sea, at.x, at.y, 3.33);
        // Hs is 1.2 m. physics/test_sea_motion.c has these images wave by wave.
        assert_near(s.height, direct.height, 3e-3);
    }
    bolan_sea *again = test_sea(*resolved); // a resolved desc makes the same sea
    assert_near(bolan_sea_get_desc(again)->textures.period, resolved->textures.period, 0.0);
    bolan_sea_destroy(&again);
    bolan_sea_destroy(&sea);
}

// The energy that is left where the grid is coarser than half of the longest wave, and where it is fine.
static void a_coarse_grid_carries_no_short_waves_of_an_fft(void **state) {
    (void)state;
    enum { COUNT = 2000 };
    bolan_sea_desc desc = bolan_sea_desc_default();
    bolan_sea *sea = test_sea(desc);
    static bolan_dvec2 at[COUNT];
    static float spacing[COUNT];
    static bolan_sea_sample fine[COUNT], grid[COUNT];
    for (int i = 0; i < COUNT; i++) at[i] = (bolan_dvec2){31.7 * i, -13.3 * i};
    bolan_sea_sample_grid(sea, at, NULL, COUNT, grid);
    bolan_sea_sample_rest(sea, at, COUNT, fine);
    assert_memory_equal(grid, fine, sizeof fine);
    double slopes[4] = {0};
    for (int s = 0; s < 4; s++) {
        for (int i = 0; i < COUNT; i++) spacing[i] = (float)(pow(10.0, s) * 0.1);
        bolan_sea_sample_grid(sea, at, spacing, COUNT, grid);
        for (int i = 0; i < COUNT; i++) slopes[s] += (double)(grid[i].slope_x * grid[i].slope_x) / COUNT;
    }
    assert_true(slopes[0] > slopes[1] && slopes[1] > slopes[2] && slopes[2] > slopes[3]);
    // On a grid of 100 m no wave shorter than 200 m is left but for a sixteenth; the peak is near 40 m.
    assert_true(slopes[3] < slopes[0] / 16.0);
    bolan_sea_destroy(&sea);
}

RUN_TESTS(cmocka_unit_test(every_bad_field_is_named_in_one_sentence),
          cmocka_unit_test(nothing_allocates_after_creation_and_all_memory_comes_back),
          cmocka_unit_test(refused_memory_is_an_error_and_leaks_nothing),
          cmocka_unit_test(a_calm_sea_is_flat_in_every_model),
          cmocka_unit_test(waves_are_sorted_and_lie_within_the_bounds),
          cmocka_unit_test(shallow_water_attenuates_a_sum_as_one),
          cmocka_unit_test(textures_is_one_tile_of_seven_peak_waves_in_a_loop_near_ten_seconds),
          cmocka_unit_test(a_coarse_grid_carries_no_short_waves_of_an_fft))

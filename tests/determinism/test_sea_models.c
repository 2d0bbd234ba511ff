// SPDX-License-Identifier: MIT
// The sums of waves and the loop of TEXTURES to the bit: over instruction sets, thread counts, batches and turns of the
// loop.
#include "sea_support.h"

#include <string.h>

static const bolan_wave_model sums[2] = {BOLAN_WAVES_COSINES, BOLAN_WAVES_EXP_COSINE};

enum { POINTS = 1003 }; // not a multiple of a block

typedef struct picture {
    char hash[17];
    float threshold;
    bolan_sea_sample rest[POINTS], grid[POINTS];
} picture;

static void place(bolan_dvec2 *at, float *spacing) {
    for (int i = 0; i < POINTS; i++) {
        at[i] = (bolan_dvec2){1e5 * sin(i), 37.0 * i};
        spacing[i] = (float)(0.05 * (1 + i * i % 997));
    }
}

static void take(bolan_sea_desc desc, uint32_t threads, picture *out) {
    bolan_dvec2 at[POINTS];
    float spacing[POINTS];
    place(at, spacing);
    bolan_set_threads(threads);
    bolan_sea *sea = test_sea(desc);
    bolan_sea_step(sea, 4321.1);
    bolan_sea_hash(sea, out->hash);
    out->threshold = (float)bolan_sea_foam_threshold(sea);
    bolan_sea_sample_rest(sea, at, POINTS, out->rest);
    bolan_sea_sample_grid(sea, at, spacing, POINTS, out->grid);
    bolan_sea_destroy(&sea);
    bolan_set_threads(1);
}

static void instruction_sets_and_threads_do_not_matter(void **state) {
    (void)state;
    static picture expected, got;
    for (int m = 0; m < 2; m++) {
        bolan_sea_desc desc = bolan_sea_desc_default();
        desc.waves = sums[m];
        desc.cpu = BOLAN_CPU_SCALAR;
        take(desc, 1, &expected);
        for (int cpu = BOLAN_CPU_SCALAR; cpu <= (int)bolan_cpu_best(); cpu++) {
            desc.cpu = (bolan_cpu)cpu;
            for (uint32_t threads = 1; threads <= 3; threads++) {
                take(desc, threads, &got);
                assert_memory_equal(&got, &expected, sizeof got);
            }
        }
    }
}

static void a_point_does_not_depend_on_its_batch(void **state) {
    (void)state;
    static bolan_dvec2 at[POINTS];
    static float spacing[POINTS];
    static bolan_sea_sample all[POINTS];
    place(at, spacing);
    for (int m = 0; m < 2; m++) {
        bolan_sea_desc desc = bolan_sea_desc_default();
        desc.waves = sums[m];
        bolan_sea *sea = test_sea(desc);
        bolan_sea_sample_grid(sea, at, spacing, POINTS, all);
        for (int i = 0; i < POINTS; i += 7) {
            bolan_sea_sample one;
            bolan_sea_sample_grid(sea, at + i, spacing + i, 1, &one);
            assert_memory_equal(&one, &all[i], sizeof one);
        }
        bolan_sea_destroy(&sea);
    }
}

static void the_path_through_time_does_not_matter(void **state) {
    (void)state;
    for (int m = 0; m < 2; m++) {
        bolan_sea_desc desc = bolan_sea_desc_default();
        desc.waves = sums[m];
        bolan_sea *a = test_sea(desc), *b = test_sea(desc);
        char one[17], other[17];
        for (double t = 0.0; t < 10.0; t += 0.7) bolan_sea_step(a, t);
        bolan_sea_step(a, 10.0);
        bolan_sea_settle(b, 10.0);
        bolan_sea_hash(a, one);
        bolan_sea_hash(b, other);
        assert_string_equal(one, other);
        bolan_sea_step(b, 10.1);
        bolan_sea_hash(b, other);
        assert_string_not_equal(one, other);
        bolan_sea_destroy(&a);
        bolan_sea_destroy(&b);
    }
}

static bolan_sea *textures(uint32_t frames) {
    bolan_sea_desc desc = bolan_sea_desc_default();
    desc.waves = BOLAN_WAVES_TEXTURES;
    desc.resolution = 64;
    desc.textures.frames = frames;
    return test_sea(desc);
}

static void the_loop_of_textures_is_exact(void **state) {
    (void)state;
    enum { FRAMES = 12 };
    bolan_sea *sea = textures(FRAMES);
    const double period = bolan_sea_get_loop(sea).period;
    char hash[FRAMES][17], again[17];
    for (uint32_t f = 0; f < FRAMES; f++) {
        bolan_sea_step(sea, (f + 0.5) * period / FRAMES);
        assert_int_equal(bolan_sea_get_loop(sea).frame, f);
        bolan_sea_hash(sea, hash[f]);
        if (f > 0) assert_string_not_equal(hash[f], hash[f - 1]);
    }
    for (int i = -40; i < 40; i++) { // anywhere in a frame, in any turn of the loop
        const uint32_t f = (uint32_t)((i + 10 * FRAMES) % FRAMES);
        for (int part = 1; part < 10; part += 4) {
            bolan_sea_step(sea, (i + 0.1 * part) * period / FRAMES);
            assert_int_equal(bolan_sea_get_loop(sea).frame, f);
            bolan_sea_hash(sea, again);
            assert_string_equal(again, hash[f]);
        }
    }
    bolan_sea_destroy(&sea);
}

RUN_TESTS(cmocka_unit_test(instruction_sets_and_threads_do_not_matter),
          cmocka_unit_test(a_point_does_not_depend_on_its_batch),
          cmocka_unit_test(the_path_through_time_does_not_matter), cmocka_unit_test(the_loop_of_textures_is_exact))

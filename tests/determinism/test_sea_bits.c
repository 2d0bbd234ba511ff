// SPDX-License-Identifier: MIT
// The same sea to the bit: over instruction sets, thread counts, histories and resolutions.
#include "support.h"

#include "bolan/waves.h"
#include "waves/cascades/cascades.h"

#include <string.h>

static bolan_sea *create(bolan_sea_desc desc) {
    bolan_sea *sea = NULL;
    assert_int_equal(bolan_sea_create(&desc, &sea), BOLAN_OK);
    return sea;
}

static uint64_t bytes_hash(uint64_t h, const void *data, size_t size) {
    const unsigned char *p = data;
    for (size_t i = 0; i < size; i++) h = (h ^ p[i]) * 0x100000001b3u;
    return h;
}

// Everything a reader can see: fields, foam and halfs.
static uint64_t all_bits(const bolan_sea *sea) {
    uint64_t h = 0xcbf29ce484222325u;
    for (uint32_t i = 0; i < bolan_sea_cascade_count(sea); i++) {
        const bolan_cascade_view v = bolan_sea_cascade(sea, i);
        const size_t points = (size_t)v.n * v.n;
        const float *planes[] = {v.slope_x, v.slope_y, v.dxx, v.dyy, v.foam};
        h = bytes_hash(h, v.displacement, (size_t)v.pitch * v.pitch * sizeof *v.displacement);
        for (int f = 0; f < 5; f++) h = bytes_hash(h, planes[f], points * sizeof(float));
        h = bytes_hash(h, v.displacement_half, points * 8);
        h = bytes_hash(h, v.slope_half, points * 8);
        h = bytes_hash(h, v.foam_half, points * 2);
    }
    return h;
}

static uint64_t bits_of(bolan_sea_desc desc, uint32_t threads) {
    bolan_set_threads(threads);
    bolan_sea *sea = create(desc);
    for (int i = 0; i < 4; i++) bolan_sea_step(sea, 1000.0 + 0.1 * i);
    const uint64_t h = all_bits(sea);
    bolan_sea_destroy(&sea);
    bolan_set_threads(1);
    return h;
}

static void instruction_sets_and_threads_do_not_matter(void **state) {
    (void)state;
    for (uint32_t n = 32; n <= 256; n *= 2) {
        bolan_sea_desc desc = bolan_sea_desc_default();
        desc.resolution = n;
        desc.cpu = BOLAN_CPU_SCALAR;
        const uint64_t expected = bits_of(desc, 1);
        for (int cpu = BOLAN_CPU_SCALAR; cpu <= (int)bolan_cpu_best(); cpu++) {
            desc.cpu = (bolan_cpu)cpu;
            for (uint32_t threads = 1; threads <= 3; threads++) assert_true(bits_of(desc, threads) == expected);
        }
    }
}

// Large planes are written around the cache; that is no other sea.
static void large_planes_are_no_other_sea(void **state) {
    (void)state;
    bolan_sea_desc desc = bolan_sea_desc_default();
    desc.resolution = 1024;
    desc.fft.cascade_count = 1;
    desc.cpu = BOLAN_CPU_SCALAR;
    const uint64_t expected = bits_of(desc, 2);
    desc.cpu = BOLAN_CPU_AUTO;
    assert_true(bits_of(desc, 2) == expected);
}

static void the_path_through_time_does_not_matter(void **state) {
    (void)state;
    bolan_sea_desc desc = bolan_sea_desc_default();
    desc.resolution = 64;
    bolan_sea *a = create(desc), *b = create(desc);
    char one[17], other[17];
    for (double t = 0.0; t < 10.0; t += 0.7) bolan_sea_step(a, t);
    bolan_sea_step(a, 10.0);
    bolan_sea_step(b, 10.0);
    bolan_sea_hash(a, one);
    bolan_sea_hash(b, other);
    assert_string_equal(one, other);
    bolan_sea_step(b, 10.1);
    bolan_sea_hash(b, other);
    assert_string_not_equal(one, other);
    bolan_sea_destroy(&a);
    bolan_sea_destroy(&b);
}

static void settling_depends_on_the_time_alone(void **state) {
    (void)state;
    bolan_sea_desc desc = bolan_sea_desc_default();
    desc.resolution = 64;
    desc.foam_decay = 1.0;
    bolan_sea *a = create(desc), *b = create(desc);
    bolan_sea_settle(a, 20.1);
    bolan_sea_step(b, 500.0);
    bolan_sea_settle(b, 20.1);
    assert_true(all_bits(a) == all_bits(b));
    bolan_sea_destroy(&a);
    bolan_sea_destroy(&b);
}

// A film in chunks joins, and a frame alone is the frame of the film: foam is a function of time.
static void a_frame_alone_is_the_frame_of_a_run(void **state) {
    (void)state;
    bolan_sea_desc desc = bolan_sea_desc_default();
    desc.resolution = 64;
    for (int i = 0; i < 3; i++) {
        desc.foam_decay = (double[]){3.5, 0.4, 1.0}[i];
        desc.loop_period = i == 2 ? 17.3 : 0.0;
        desc.waves = i == 1 ? BOLAN_WAVES_TEXTURES : BOLAN_WAVES_FFT;
        bolan_sea *run = create(desc), *alone = create(desc);
        const double start = 1234.56, frame = i == 1 ? 1.0 : 1.0 / 30.0;
        bolan_sea_settle(run, start);
        for (int f = 1; f <= 100; f++) bolan_sea_step(run, start + f * frame);
        bolan_sea_settle(alone, start + 100 * frame);
        assert_true(all_bits(run) == all_bits(alone));
        // without the seconds before there is less foam
        bolan_sea_step(alone, 5000.0);
        bolan_sea_step(alone, start + 100 * frame);
        assert_true(all_bits(run) != all_bits(alone));
        bolan_sea_destroy(&run);
        bolan_sea_destroy(&alone);
    }
}

typedef struct table {
    uint32_t count;
    sea_mode modes[40000];
} table;

static void keep_mode(void *context, const sea_mode *m) {
    table *t = context;
    assert_true(t->count < 40000);
    t->modes[t->count++] = *m;
}

// A mode may have several waves, which differ in frequency.
static bool is_same_wave(const sea_mode *a, const sea_mode *b) {
    return a->kx == b->kx && a->ky == b->ky && a->turns == b->turns;
}

// A finer grid of the same length holds the same waves, and more. The coarse ring ends within cells, of which it has a
// part of the energy.
static void resolution_does_not_change_which_waves_there_are(void **state) {
    (void)state;
    bolan_sea_desc desc = bolan_sea_desc_default();
    desc.fft.cascade_count = 1;
    desc.length = 700.0;
    desc.resolution = 64;
    bolan_sea *coarse = create(desc);
    desc.resolution = 256;
    bolan_sea *fine = create(desc);
    table *a = calloc(1, sizeof *a), *b = calloc(1, sizeof *b);
    bolan_sea_each_mode(&cascade_tables_of(coarse->shared)->cascade[0], keep_mode, a);
    bolan_sea_each_mode(&cascade_tables_of(fine->shared)->cascade[0], keep_mode, b);
    assert_true(a->count > 600 && b->count > 5 * a->count);
    const double end = bolan_sea_cascade(coarse, 0).k_max - 2.0 * BOLAN_PI / 700.0;
    uint32_t inside = 0;
    for (uint32_t i = 0; i < a->count; i++) {
        const sea_mode *m = &a->modes[i];
        uint32_t j = 0;
        while (j < b->count && !is_same_wave(&b->modes[j], m)) j++;
        assert_true(j < b->count);
        if (hypot(m->kx, m->ky) > end) continue;
        assert_memory_equal(&b->modes[j], m, offsetof(sea_mode, paired));
        inside++;
    }
    assert_true(inside > 0.8 * a->count);
    free(a);
    free(b);
    bolan_sea_destroy(&coarse);
    bolan_sea_destroy(&fine);
}

static void another_seed_is_another_sea(void **state) {
    (void)state;
    bolan_sea_desc desc = bolan_sea_desc_default();
    desc.resolution = 32;
    bolan_sea *a = create(desc);
    desc.seed = 2;
    bolan_sea *b = create(desc);
    char one[17], other[17];
    bolan_sea_hash(a, one);
    bolan_sea_hash(b, other);
    assert_string_not_equal(one, other);
    bolan_sea_destroy(&a);
    bolan_sea_destroy(&b);
}

RUN_TESTS(cmocka_unit_test(instruction_sets_and_threads_do_not_matter), cmocka_unit_test(large_planes_are_no_other_sea),
          cmocka_unit_test(the_path_through_time_does_not_matter), cmocka_unit_test(settling_depends_on_the_time_alone),
          cmocka_unit_test(a_frame_alone_is_the_frame_of_a_run),
          cmocka_unit_test(resolution_does_not_change_which_waves_there_are),
          cmocka_unit_test(another_seed_is_another_sea))

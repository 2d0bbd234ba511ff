// SPDX-License-Identifier: MIT
// The strip FFT against its definition in double, for every size and instruction set.
#include "support.h"

#include "bolan/math.h"
#include "fft/transform.h"

#include <string.h>

static float noise(uint32_t *state) {
    *state = *state * 1664525u + 1013904223u;
    return (float)(*state >> 8) / 16777216.0f - 0.5f;
}

static void fill(float *rows, uint32_t n) {
    uint32_t state = 12345u;
    for (uint32_t i = 0; i < n * FFT_ROW; i++) rows[i] = noise(&state);
}

// sum_k x[k] e^{+2 pi i k y / n} of one column.
static void define(const float *rows, uint32_t n, uint32_t column, uint32_t y, double out[2]) {
    out[0] = out[1] = 0.0;
    for (uint32_t k = 0; k < n; k++) {
        const double angle = 2.0 * BOLAN_PI * (double)(k * y % n) / n, c = cos(angle), s = sin(angle);
        const double re = rows[k * FFT_ROW + column], im = rows[k * FFT_ROW + FFT_LANES + column];
        out[0] += re * c - im * s;
        out[1] += re * s + im * c;
    }
}

static void it_is_the_inverse_dft(void **state) {
    (void)state;
    for (uint32_t n = FFT_MIN; n <= FFT_MAX; n *= 2) {
        float *in = bolan_allocate(n * FFT_ROW * sizeof(float)), *rows = bolan_allocate(n * FFT_ROW * sizeof(float));
        fft_plan plan;
        assert_true(bolan_fft_plan_create(n, &plan));
        fill(in, n);
        memcpy(rows, in, n * FFT_ROW * sizeof(float));
        bolan_fft_strip_for(BOLAN_CPU_AUTO)(&plan, rows);
        // Error of a float FFT grows with sqrt(log n) ulp of the rms of a sum of n numbers of rms 0.29 (Schatzman
        // 1996).
        const double tolerance = 4.0 * 6e-8 * sqrt(log2(n)) * 0.41 * sqrt(n);
        for (uint32_t y = 0; y < n; y += 7) {
            double expected[2];
            define(in, n, y % FFT_LANES, y, expected);
            const float *row = rows + (size_t)plan.order[y] * FFT_ROW + y % FFT_LANES;
            assert_near(row[0], expected[0], tolerance);
            assert_near(row[FFT_LANES], expected[1], tolerance);
        }
        bolan_fft_plan_destroy(&plan);
        bolan_release(in, n * FFT_ROW * sizeof(float));
        bolan_release(rows, n * FFT_ROW * sizeof(float));
    }
}

static void every_instruction_set_gives_the_same_bits(void **state) {
    (void)state;
    const uint32_t n = 512, bytes = n * FFT_ROW * sizeof(float);
    float *reference = bolan_allocate(bytes), *rows = bolan_allocate(bytes);
    fft_plan plan;
    assert_true(bolan_fft_plan_create(n, &plan));
    fill(reference, n);
    bolan_fft_strip_for(BOLAN_CPU_SCALAR)(&plan, reference);
    for (int cpu = BOLAN_CPU_GENERIC4; cpu <= (int)bolan_cpu_best(); cpu++) {
        fill(rows, n);
        bolan_fft_strip_for((bolan_cpu)cpu)(&plan, rows);
        assert_memory_equal(rows, reference, bytes);
    }
    bolan_fft_plan_destroy(&plan);
    bolan_release(reference, bytes);
    bolan_release(rows, bytes);
}

static void its_order_is_a_permutation(void **state) {
    (void)state;
    for (uint32_t n = FFT_MIN; n <= FFT_MAX; n *= 2) {
        bool seen[FFT_MAX] = {false};
        fft_plan plan;
        assert_true(bolan_fft_plan_create(n, &plan));
        for (uint32_t y = 0; y < n; y++) {
            assert_in_range(plan.order[y], 0, n - 1);
            assert_false(seen[plan.order[y]]);
            seen[plan.order[y]] = true;
        }
        bolan_fft_plan_destroy(&plan);
    }
}

RUN_TESTS(cmocka_unit_test(it_is_the_inverse_dft), cmocka_unit_test(every_instruction_set_gives_the_same_bits),
          cmocka_unit_test(its_order_is_a_permutation))

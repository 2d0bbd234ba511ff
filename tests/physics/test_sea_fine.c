// SPDX-License-Identifier: MIT
// The fine waves: with the cascades they have Cox & Munk's slope variance, their samples have the variance of their
// modes, they move by the dispersion relation, and a footprint's table knows them.
#include "sea_support.h"

#include "waves/model.h"

#include <complex.h>
#include <string.h>

static bolan_sea_desc desc_of(double wind, uint32_t n) {
    bolan_sea_desc d = bolan_sea_desc_default();
    d.sea_state = bolan_sea_state_from_wind(wind, 240.0, 300e3);
    d.resolution = n;
    return d;
}

static double cascades_hold(const bolan_sea *sea) {
    double sum = 0.0;
    for (uint32_t c = 0; c < bolan_sea_cascade_count(sea); c++) sum += bolan_sea_cascade_layout(sea, c).mss;
    return sum;
}

// Slope variance of the samples, over both axes: what is read linearly has the waves' variance in the mean.
static double sampled_variance(const bolan_sea_fine_view *v) {
    double sum = 0.0;
    const uint32_t mask = v->n - 1;
    for (uint32_t j = 0; j < v->n; j++)
        for (uint32_t i = 0; i < v->n; i++)
            for (int axis = 0; axis < 2; axis++) { // the mean square of a bilinear patch, term by term
                const float *p = axis ? v->slope_y : v->slope_x;
                const double a = p[j * v->n + i], b = p[j * v->n + ((i + 1) & mask)];
                const double c = p[((j + 1) & mask) * v->n + i], d = p[((j + 1) & mask) * v->n + ((i + 1) & mask)];
                sum += (4.0 * (a * a + b * b + c * c + d * d) + 4.0 * (a * b + a * c + b * d + c * d) +
                        2.0 * (a * d + b * c)) /
                       36.0;
            }
    return sum / v->n / v->n;
}

static void all_waves_have_the_slopes_of_cox_and_munk(void **state) {
    (void)state;
    static const double winds[] = {3.0, 6.0, 10.0, 15.0};
    for (int w = 0; w < 4; w++) {
        bolan_sea *sea = test_sea(desc_of(winds[w], 256));
        bolan_sea_step(sea, 17.0);
        const bolan_sea_fine_view v = bolan_sea_fine(sea);
        const double total = 0.003 + 0.00512 * winds[w]; // Cox & Munk 1954, clean surface
        const double fine = v.slopes[0] + v.slopes[2], held = cascades_hold(sea);
        print_message("%g m/s: cascades %.4f, fine waves %.4f of %.4f, %.3f to %.3f m\n", winds[w], held, fine, total,
                      2.0 * BOLAN_PI / v.k_max, 2.0 * BOLAN_PI / v.k_min);
        assert_true(held + fine > 0.9 * total && held + fine <= 1.0001 * total);
        assert_near(sampled_variance(&v) / fine, 1.0, 0.03); // waves opposite each other beat
        assert_true(v.k_min == bolan_sea_cascade_layout(sea, bolan_sea_cascade_count(sea) - 1).k_max);
        bolan_sea_destroy(&sea);
    }
}

// Up- over crosswind variance is that of the rest. The wind comes from 240 degrees and blows to 60, 30 north of east.
static void they_lie_across_the_wind(void **state) {
    (void)state;
    bolan_sea *sea = test_sea(desc_of(10.0, 256));
    const bolan_sea_fine_view v = bolan_sea_fine(sea);
    float rest[3];
    bolan_sea_unresolved_slopes(sea, 0.0, 0.0, 0.0, rest);
    const double c = cos(BOLAN_PI / 6.0), s = sin(BOLAN_PI / 6.0);
    const double up = c * c * v.slopes[0] + 2.0 * c * s * v.slopes[1] + s * s * v.slopes[2];
    const double rest_up = c * c * rest[0] + 2.0 * c * s * rest[1] + s * s * rest[2];
    assert_near(up / (v.slopes[0] + v.slopes[2]), rest_up / (rest[0] + rest[2]), 0.03);
    bolan_sea_destroy(&sea);
}

// ---- motion ---------------------------------------------------------------------------------------------------------

typedef struct strongest {
    sea_mode mode;
    double energy;
} strongest;

static void keep_strongest(void *context, const sea_mode *m) {
    strongest *s = context;
    const double e = m->re * m->re + m->im * m->im;
    if (e > s->energy && hypot(m->kx, m->ky) > 250.0) s->energy = e, s->mode = *m;
}

static double complex component(const bolan_sea_fine_view *v, double kx, double ky) {
    double complex sum = 0.0;
    const double c = cos(v->angle), s = sin(v->angle), step = v->length / v->n;
    for (uint32_t j = 0; j < v->n; j++)
        for (uint32_t i = 0; i < v->n; i++) {
            const double x = step * (i * c - j * s), y = step * (i * s + j * c);
            sum += (double)v->slope_x[(size_t)j * v->n + i] * cexp(-I * (kx * x + ky * y));
        }
    return sum;
}

static void they_run_along_the_wind_by_gravity_and_surface_tension(void **state) {
    (void)state;
    bolan_sea *sea = test_sea(desc_of(8.0, 256));
    strongest s = {.energy = 0.0};
    sea->shared->model->each_fine(sea->shared, keep_strongest, &s);
    const double k = hypot(s.mode.kx, s.mode.ky);
    const double omega = sqrt(9.81 * k + 7.17e-5 * k * k * k); // Lamb 1932, section 267
    const double dt = 0.002;
    double travelled = 0.0, previous = 0.0;
    for (int i = 0; i <= 50; i++) {
        bolan_sea_step(sea, i * dt);
        const bolan_sea_fine_view v = bolan_sea_fine(sea);
        const double phase = carg(component(&v, s.mode.kx, s.mode.ky));
        if (i > 0) travelled -= remainder(phase - previous, 2.0 * BOLAN_PI);
        previous = phase;
    }
    assert_near(travelled / (50.0 * dt) / omega, 1.0, 1e-3);
    assert_true(s.mode.kx * cos(BOLAN_PI / 6.0) + s.mode.ky * sin(BOLAN_PI / 6.0) > 0.0);
    bolan_sea_destroy(&sea);
}

static void the_table_knows_what_a_footprint_keeps_of_them(void **state) {
    (void)state;
    bolan_sea *sea = test_sea(desc_of(10.0, 256));
    const bolan_sea_fine_view v = bolan_sea_fine(sea);
    const float *table = bolan_sea_slope_table(sea);
    for (int i = 0; i < BOLAN_SLOPE_TABLE_MAJOR; i++) { // round footprints: exp(-sigma^2 k^2) over even log k
        const double sigma = pow(2.0, i / 1.5 - 11.0), log_ratio = log(v.k_max / v.k_min);
        double kept = 0.0;
        for (int s = 0; s < 1000; s++) kept += exp(-pow(sigma * v.k_min * exp(log_ratio * (s + 0.5) / 1000.0), 2.0));
        assert_near(table[4 * i + 3], 1.0 - kept / 1000.0, 0.01);
    }
    bolan_sea_destroy(&sea);
}

static void queries_and_sums_have_none(void **state) {
    (void)state;
    bolan_sea_desc d = desc_of(8.0, 128);
    bolan_sea *sea = test_sea(d);
    bolan_sea_step(sea, 3.0);
    char before[17], after[17];
    bolan_sea_hash(sea, before);
    bolan_sea_fine(sea);
    bolan_sea_hash(sea, after);
    assert_string_equal(before, after);
    bolan_sea_destroy(&sea);
    d.waves = BOLAN_WAVES_COSINES;
    sea = test_sea(d);
    assert_int_equal(bolan_sea_fine(sea).n, 0);
    assert_true(bolan_sea_slope_table(sea)[3] == 1.0f);
    bolan_sea_destroy(&sea);
}

RUN_TESTS(cmocka_unit_test(all_waves_have_the_slopes_of_cox_and_munk), cmocka_unit_test(they_lie_across_the_wind),
          cmocka_unit_test(they_run_along_the_wind_by_gravity_and_surface_tension),
          cmocka_unit_test(the_table_knows_what_a_footprint_keeps_of_them),
          cmocka_unit_test(queries_and_sums_have_none))

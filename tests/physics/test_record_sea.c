// SPDX-License-Identifier: MIT
// Records of virtual buoys in a JONSWAP sea: the ratios that zero-up-crossing analyses of real seas of this shape give
// (not Rayleigh's, which hold for narrow bands alone), and the directional spectrum that was asked for.
#include "sea_support.h"

#include "bolan/query.h"
#include "bolan/record.h"

#include <string.h>

enum { BUOYS = 4, SEEDS = 6, SAMPLES = 2400, MOST_WAVES = 4000 };
#define RATE 4.0

static float heave[BUOYS][SAMPLES], east[BUOYS][SAMPLES], north[BUOYS][SAMPLES];
static bolan_record_wave waves[MOST_WAVES];

static bolan_sea_desc jonswap(uint64_t seed) {
    bolan_sea_desc d = bolan_sea_desc_default();
    d.sea_state = bolan_sea_state_from_wind(15.0, 215.0, 100e3);
    d.resolution = 64;
    d.fft.cascade_count = 2; // waves that 4 Hz resolves
    d.seed = seed;
    return d;
}

static bolan_dvec2 place(int b) { return (bolan_dvec2){1733.0 * b, -911.0 * b * b}; }

static int higher_first(const void *a, const void *b) {
    const double x = ((const bolan_record_wave *)a)->height, y = ((const bolan_record_wave *)b)->height;
    return (x < y) - (x > y);
}

static double mean_height(uint32_t count) {
    double sum = 0.0;
    for (uint32_t i = 0; i < count; i++) sum += waves[i].height / count;
    return sum;
}

// sqrt(m0 / m2) of the record's own spectrum, up to 1 Hz.
static void add_moments(const float *record, double m[2]) {
    enum { SEGMENT = 512 };
    static bolan_record_band band[SEGMENT / 2];
    assert_int_equal(bolan_record_spectrum(record, NULL, NULL, SAMPLES, RATE, SEGMENT, band), BOLAN_OK);
    for (int i = 0; i < SEGMENT / 2 - 1; i++) {
        m[0] += band[i].density;
        m[1] += band[i].density * band[i].frequency * band[i].frequency;
    }
}

static void zero_crossing_gives_the_ratios_of_a_jonswap_sea(void **state) {
    (void)state;
    double m2 = 0.0, m3 = 0.0, m4 = 0.0, moment[2] = {0.0, 0.0}, period = 0.0;
    uint32_t count = 0, samples = 0;
    for (uint64_t seed = 1; seed <= SEEDS; seed++) {
        bolan_sea_desc d = jonswap(seed);
        d.choppiness = 0.0; // fixed points
        bolan_sea *sea = test_sea(d);
        bolan_dvec2 at[BUOYS];
        for (int b = 0; b < BUOYS; b++) at[b] = place(b);
        for (int i = 0; i < SAMPLES; i++) {
            float h[BUOYS];
            bolan_sea_step(sea, i / RATE);
            bolan_query_heights(&(bolan_water){.sea = sea}, at, BUOYS, h);
            for (int b = 0; b < BUOYS; b++) heave[b][i] = h[b];
        }
        for (int b = 0; b < BUOYS; b++) {
            count += bolan_record_waves(heave[b], SAMPLES, RATE, MOST_WAVES - count, waves + count);
            add_moments(heave[b], moment);
            for (int i = 0; i < SAMPLES; i++) {
                const double x = (double)heave[b][i];
                m2 += x * x, m3 += x * x * x, m4 += x * x * x * x, samples++;
            }
        }
        bolan_sea_destroy(&sea);
    }
    assert_true(count >= 2000 && count < MOST_WAVES);
    for (uint32_t i = 0; i < count; i++) period += waves[i].period / count;
    qsort(waves, count, sizeof *waves, higher_first);
    m2 /= samples, m3 /= samples, m4 /= samples;
    const double hm0 = 4.0 * sqrt(m2), third = mean_height(count / 3) / hm0, tenth = mean_height(count / 10) / hm0;
    const double tz = sqrt(moment[0] / moment[1]), skewness = m3 / (m2 * sqrt(m2)), kurtosis = m4 / (m2 * m2);
    print_message(
        "%u waves: H1/3 %.3f, H1/10 %.3f of Hm0 %.3f m; Tz %.3f s, sqrt(m0/m2) %.3f s; skewness %.3f, kurtosis "
        "%.3f; higher than Hm0 %.3f\n",
        count, third, tenth, hm0, period, tz, skewness, kurtosis, bolan_record_exceedance(waves, count, hm0));
    assert_true(third > 0.95 && third < 0.99);
    assert_true(tenth > 1.18 && tenth < 1.24);
    assert_near(period / tz, 1.0, 0.03);
    assert_near(skewness, 0.0, 0.05);
    assert_near(kurtosis, 3.0, 0.1);
    assert_true(bolan_record_exceedance(waves, count, hm0) < 0.1353); // Rayleigh's
}

// By the density: direction and spread of the energy, against the sea state's own.
static void a_buoy_has_the_directions_of_the_sea(void **state) {
    (void)state;
    enum { SEGMENT = 256, BANDS = SEGMENT / 2 - 1 };
    static bolan_record_band band[BANDS];
    double energy = 0.0, x = 0.0, y = 0.0, peak[BANDS] = {0.0};
    double from = 0.0, tp = 0.0, m0 = 0.0;
    for (uint64_t seed = 11; seed <= 14; seed++) {
        bolan_sea_desc d = jonswap(seed);
        d.waves = BOLAN_WAVES_COSINES; // summed at the point: no variance is lost between samples
        d.cosines.frequencies = 60, d.cosines.directions = 16;
        bolan_sea *sea = test_sea(d);
        from = bolan_sea_get_summary(sea)->from_deg, tp = bolan_sea_get_summary(sea)->tp;
        m0 += bolan_sea_get_summary(sea)->m0 / 4.0;
        for (int i = 0; i < SAMPLES; i++) {
            bolan_sea_step(sea, i / RATE);
            for (int b = 0; b < BUOYS; b++) {
                const bolan_dvec2 at = place(b);
                bolan_sea_sample s;
                bolan_sea_sample_rest(sea, &at, 1, &s);
                heave[b][i] = s.height, east[b][i] = s.dx, north[b][i] = s.dy;
            }
        }
        for (int b = 0; b < BUOYS; b++) {
            assert_int_equal(bolan_record_spectrum(heave[b], east[b], north[b], SAMPLES, RATE, SEGMENT, band),
                             BOLAN_OK);
            for (int i = 0; i < BANDS; i++) {
                energy += band[i].density * RATE / SEGMENT / 16.0;
                x += band[i].density * band[i].a1;
                y += band[i].density * band[i].b1;
                peak[i] += band[i].density;
            }
        }
        bolan_sea_destroy(&sea);
    }
    int top = 0;
    for (int i = 0; i < BANDS; i++) top = peak[i] > peak[top] ? i : top;
    const double got = bolan_math_to_compass_from(atan2(y, x));
    print_message("16 records: from %.2f deg (asked %.2f), m0 %.3f m2 (%.3f), peak %.2f s (%.2f)\n", got, from, energy,
                  m0, 1.0 / (band[top].frequency), tp);
    assert_near(got, from, 4.0);                      // 16 records of 110 waves that spread by 30 degrees
    assert_near(energy / m0, 1.0, 0.1);               // one tenth by chance; short waves are not in it
    assert_near(band[top].frequency * tp, 1.0, 0.15); // the width of a band at the peak
}

RUN_TESTS(cmocka_unit_test(zero_crossing_gives_the_ratios_of_a_jonswap_sea),
          cmocka_unit_test(a_buoy_has_the_directions_of_the_sea))

// SPDX-License-Identifier: MIT
// The kernels of second-order bound waves against closed forms, and the sea that they make against the skewness of
// Longuet-Higgins and the crest heights of Forristall.
#include "support.h"
#include "waves/second_order.h"

#include "bolan/spectrum.h"

#include <complex.h>

#define G 9.81
#define TURN (2.0 * BOLAN_PI)

static bolan_dvec2 along(double k, double angle) { return (bolan_dvec2){k * cos(angle), k * sin(angle)}; }

// ---- closed forms ---------------------------------------------------------------------------------------------------

static void waves_along_a_line_in_deep_water_have_plain_kernels(void **state) {
    (void)state;
    for (double a = 0.02; a < 2.0; a *= 1.7) {
        for (double b = 0.013; b < 2.0; b *= 1.9) {
            const second_order s = bolan_second_order(along(a, 0.7), along(b, 0.7), BOLAN_DEEP);
            assert_near(s.sum, a + b, 1e-12 * (a + b));
            assert_near(s.difference, -fabs(a - b), 1e-9 * (a + b));
        }
    }
}

// Stokes (1847): eta2 = (k a^2 / 4) cosh kd (2 + cosh 2kd) / sinh^3 kd cos 2 psi.
static void a_wave_with_itself_is_that_of_stokes(void **state) {
    (void)state;
    for (double depth = 2.0; depth < 300.0; depth *= 1.6) {
        const double k = 0.1, x = k * depth;
        const second_order s = bolan_second_order(along(k, 2.0), along(k, 2.0), depth);
        assert_near(s.sum, k * cosh(x) * (2.0 + cosh(2.0 * x)) / pow(sinh(x), 3.0), 1e-9 * s.sum);
        assert_true(s.difference == 0.0); // the mean level stays
    }
}

// A standing wave of two that meet: eta2 = k a^2 cos 2kx (1 + cos 2wt) in deep water, so the pair's own sum is 0.
static void waves_that_meet_make_the_standing_wave(void **state) {
    (void)state;
    const second_order s = bolan_second_order(along(0.1, 0.3), along(0.1, 0.3 + BOLAN_PI), BOLAN_DEEP);
    assert_near(s.sum, 0.0, 1e-12);
    assert_near(s.difference, 0.2, 1e-9);
}

// Two waves that cross, from the two conditions at the surface written to second order, not from the form of the code.
// With R = k tanh kh, eta_i = a_i cos psi_i and phi_i = (g a_i / w_i) cosh k_i(z + h) / cosh k_i h sin psi_i the terms
// of psi1 + sign psi2 are, phi2 = P cosh k(z + h) / cosh kh sin,
//
//     both conditions   (w^2 - g k tanh kh) P = d/dt of the speed squared, and eta1 d/dz (g dphi1/dz + d2phi1/dt2)
//     dynamic           g eta2 = w P - [speed squared / 2] + [eta1 d2phi1/dz dt]
//
// with w = w1 + sign w2, k = |k1 + sign k2|. At z = 0 g dphi/dz + d2phi/dt2 is 0, and its slope g^2 a/w (k^2 - R^2).
static double crossing(double k1, double k2, double angle, int sign, double depth) {
    const double r1 = k1 * tanh(k1 * depth), r2 = k2 * tanh(k2 * depth), w1 = sqrt(G * r1), w2 = sqrt(G * r2);
    const double dot = k1 * k2 * cos(angle), k = sqrt(k1 * k1 + k2 * k2 + sign * 2.0 * dot), w = w1 + sign * w2;
    const double squared = G * G / (w1 * w2) * (dot - sign * r1 * r2);
    const double slope = 0.5 * G * G * ((k1 * k1 - r1 * r1) / w1 + sign * (k2 * k2 - r2 * r2) / w2);
    const double p = (squared * w + slope) / (w * w - G * k * tanh(k * depth));
    return 2.0 * (p * w - 0.5 * squared + 0.5 * G * (r1 + r2)) / G;
}

static void waves_that_cross_follow_the_conditions_at_the_surface(void **state) {
    (void)state;
    for (double depth = 3.0; depth < 1e4; depth *= 4.0) {
        for (double angle = 0.1; angle < 3.1; angle += 0.3) {
            for (double k2 = 0.03; k2 < 1.0; k2 *= 1.8) {
                const second_order s = bolan_second_order(along(0.1, 1.0), along(k2, 1.0 + angle), depth);
                const second_order t = bolan_second_order(along(k2, 1.0 + angle), along(0.1, 1.0), depth);
                assert_near(s.sum, crossing(0.1, k2, angle, 1, depth), 1e-8 * (fabs(s.sum) + 0.1));
                assert_near(s.difference, crossing(0.1, k2, angle, -1, depth), 1e-8 * (fabs(s.difference) + 0.1));
                assert_near(t.sum, s.sum, 1e-12 * (fabs(s.sum) + 0.1));
                assert_near(t.difference, s.difference, 1e-10 * (fabs(s.difference) + 0.1));
            }
        }
    }
}

static void every_pair_and_depth_is_finite(void **state) {
    (void)state;
    for (double depth = 0.1; depth <= BOLAN_DEEP; depth *= 10.0)
        for (double a = 1e-4; a < 1e4; a *= 10.0)
            for (double b = 1e-4; b < 1e4; b *= 10.0)
                for (double angle = 0.0; angle < 3.2; angle += BOLAN_PI / 4.0) {
                    const second_order s = bolan_second_order(along(a, 0.0), along(b, angle), depth);
                    assert_true(isfinite(s.sum) && isfinite(s.difference));
                }
}

// ---- a sea ----------------------------------------------------------------------------------------------------------

// Frequencies of one direction, `step` apart, so that sums and differences are multiples of it too.
enum { LINES = 120, BINS = 2 * LINES + 1, SAMPLES = 1024 };

typedef struct line_sea {
    int first;       // line i has the frequency (first + i) step
    double step;     // [rad/s]
    double m[LINES]; // variance
    second_order kernel[LINES][LINES];
} line_sea;

static double variance_of(const line_sea *sea) {
    double sum = 0.0;
    for (int i = 0; i < LINES; i++) sum += sea->m[i];
    return sum;
}

static void make(line_sea *sea, const bolan_wave_system *system, int first, double step, double depth) {
    double k[LINES];
    sea->first = first;
    sea->step = step;
    for (int i = 0; i < LINES; i++) {
        const double w = (first + i) * step;
        sea->m[i] = bolan_system_density(system, w, depth) * step;
        k[i] = w * w / G;
    }
    for (int i = 0; i < LINES; i++)
        for (int j = 0; j < LINES; j++) sea->kernel[i][j] = bolan_second_order(along(k[i], 0), along(k[j], 0), depth);
}

// The third moment of a Gaussian sea with bound waves, (3/2) sum sum m_i m_j (sum + difference).
static double skewness_of(const line_sea *sea) {
    double third = 0.0;
    for (int i = 0; i < LINES; i++)
        for (int j = 0; j < LINES; j++)
            third += 1.5 * sea->m[i] * sea->m[j] * (sea->kernel[i][j].sum + sea->kernel[i][j].difference);
    return third / pow(variance_of(sea), 1.5);
}

static line_sea sea;

// Longuet-Higgins (1963): a narrow band in deep water has the skewness 3 k sigma.
static void a_narrow_sea_has_the_skewness_of_longuet_higgins(void **state) {
    (void)state;
    bolan_wave_system swell = bolan_wave_system_default();
    swell.kind = BOLAN_SPECTRUM_OCHI_HUBBLE;
    swell.lambda = 10.0;
    swell.hs = 4.0;
    swell.peak_omega = 0.6;
    make(&sea, &swell, 60, 0.006, BOLAN_DEEP); // 0.36 to 1.07 rad/s
    const double sigma = sqrt(variance_of(&sea)), narrow = 3.0 * 0.36 / G * sigma;
    assert_near(sigma, 1.0, 0.01);
    assert_near(skewness_of(&sea), narrow, 0.1 * narrow); // the band is 7 % wide
}

// A random sea of the lines in time at a point: Gaussian amplitudes, all pairs of bound waves.
static uint64_t random_bits = 1;
static double uniform(void) {
    random_bits = random_bits * 6364136223846793005u + 1442695040888963407u;
    return ((double)(random_bits >> 11) + 0.5) * 0x1p-53;
}

static void realise(const line_sea *s, double eta[SAMPLES]) {
    static double complex turn[SAMPLES];
    double complex amplitude[LINES], bin[2 * (LINES + 400)] = {0};
    for (int n = 0; n < SAMPLES; n++) turn[n] = cexp(I * (TURN * n / SAMPLES));
    for (int i = 0; i < LINES; i++) {
        amplitude[i] = sqrt(-2.0 * s->m[i] * log(uniform())) * cexp(I * (TURN * uniform()));
        bin[s->first + i] += amplitude[i];
    }
    for (int i = 0; i < LINES; i++) {
        for (int j = 0; j <= i; j++) {
            const double twice = i == j ? 0.25 : 0.5;
            bin[2 * s->first + i + j] += twice * s->kernel[i][j].sum * amplitude[i] * amplitude[j];
            bin[i - j] += twice * s->kernel[i][j].difference * amplitude[i] * conj(amplitude[j]);
        }
    }
    const int last = 2 * (s->first + LINES);
    for (int n = 0; n < SAMPLES; n++) {
        double sum = 0.0;
        for (int b = 0; b < last; b++) sum += creal(bin[b] * turn[(size_t)b * n % SAMPLES]);
        eta[n] = sum;
    }
}

// Forristall (2000), eq. 20 to 23, long-crested: P(crest > z) = exp(-(z / (alpha Hs))^beta).
static double forristall(double hs, double t1, double probability) {
    const double s1 = TURN * hs / (G * t1 * t1), alpha = 0.3536 + 0.2892 * s1, beta = 2.0 - 2.1597 * s1;
    return alpha * hs * pow(-log(probability), 1.0 / beta);
}

static int compare(const void *a, const void *b) {
    const double x = *(const double *)a, y = *(const double *)b;
    return (x < y) - (x > y);
}

// Crests of some 40000 waves of a steep JONSWAP sea, as Forristall made his own.
static void crests_are_as_high_as_forristall_found_them(void **state) {
    (void)state;
    enum { SEEDS = 700, MOST = 200000 };
    static double crest[MOST], eta[SAMPLES];
    bolan_wave_system storm = bolan_wave_system_default();
    storm.hs = 8.0;
    storm.peak_omega = TURN / 10.0;
    make(&sea, &storm, 38, 0.0105, BOLAN_DEEP); // 0.4 to 1.65 rad/s; 598 s, a sample 0.58 s
    double m0 = 0.0, m1 = 0.0, second = 0.0, third = 0.0, mean = 0.0;
    for (int i = 0; i < LINES; i++) {
        m0 += sea.m[i];
        m1 += sea.m[i] * (sea.first + i) * sea.step;
    }
    int count = 0;
    for (int seed = 0; seed < SEEDS; seed++) {
        realise(&sea, eta);
        double highest = -1.0;
        int start = 0;
        while (!(eta[start] < 0.0 && eta[start + 1] >= 0.0)) start++;
        for (int n = start + 1; n < start + 1 + SAMPLES; n++) { // the record is periodic
            const double here = eta[n % SAMPLES], before = eta[(n - 1) % SAMPLES];
            if (before < 0.0 && here >= 0.0 && highest > 0.0) crest[count++] = highest;
            highest = before < 0.0 && here >= 0.0 ? here : fmax(highest, here);
            mean += here;
            second += here * here;
            third += here * here * here;
        }
    }
    const double places = (double)SEEDS * SAMPLES, hs = 4.0 * sqrt(m0), t1 = TURN * m0 / m1;
    assert_near(mean / places, 0.0, 0.02 * sqrt(m0)); // the mean level is exact; this is the record's own scatter
    assert_near(third / places / pow(second / places, 1.5), skewness_of(&sea), 0.03);
    assert_true(skewness_of(&sea) > 0.15);
    assert_true(count > 30000);
    qsort(crest, (size_t)count, sizeof *crest, compare);
    for (double probability = 0.1; probability > 5e-4; probability *= 0.1) {
        const double expected = forristall(hs, t1, probability), got = crest[(int)(probability * count)];
        assert_near(got, expected, 0.03 * expected);
        assert_true(got > 1.03 * 0.3536 * hs * sqrt(-log(probability))); // higher than Rayleigh's
    }
}

RUN_TESTS(cmocka_unit_test(waves_along_a_line_in_deep_water_have_plain_kernels),
          cmocka_unit_test(a_wave_with_itself_is_that_of_stokes),
          cmocka_unit_test(waves_that_meet_make_the_standing_wave),
          cmocka_unit_test(waves_that_cross_follow_the_conditions_at_the_surface),
          cmocka_unit_test(every_pair_and_depth_is_finite),
          cmocka_unit_test(a_narrow_sea_has_the_skewness_of_longuet_higgins),
          cmocka_unit_test(crests_are_as_high_as_forristall_found_them))

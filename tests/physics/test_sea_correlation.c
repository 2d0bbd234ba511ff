// SPDX-License-Identifier: MIT
// How the queried surface is correlated with itself over distance and time, and what a buoy on it measures band by
// band, against integrals of the spectrum.
#include "sea_support.h"
#include "spectrum_support.h"

#include "bolan/query.h"
#include "bolan/record.h"

enum { PLACES = 8192, LAGS = 9, SEEDS = 6 };

static bolan_dvec2 place[PLACES], beside[PLACES];
static float height[PLACES], other[PLACES];

static void scatter(double side) {
    for (int i = 0; i < PLACES; i++) {
        const double x = i * 0.7548776662466927, y = i * 0.5698402909980532;
        place[i] = (bolan_dvec2){side * (x - floor(x)), side * (y - floor(y))};
    }
}

static bolan_sea_desc linear_desc(uint64_t seed) {
    bolan_sea_desc d = bolan_sea_desc_default();
    d.resolution = 128;
    d.choppiness = 0.0;
    d.seed = seed;
    return d;
}

// Integral of Psi cos(k.r - w t) over all wave vectors, midpoint rule.
static double expected_covariance(const bolan_sea_state *state, double rx, double ry, double t) {
    enum { STEPS = 600, ANGLES = 120 };
    const double k0 = 0.002, dln = log(30.0 / k0) / STEPS, dth = 2.0 * BOLAN_PI / ANGLES;
    double sum = 0.0;
    for (int i = 0; i < STEPS; i++) {
        const double k = k0 * exp((i + 0.5) * dln), w = bolan_omega_from_k(k, state->depth);
        for (int j = 0; j < ANGLES; j++) {
            const double kx = k * cos(j * dth), ky = k * sin(j * dth);
            sum += bolan_sea_state_wavenumber_density(state, kx, ky) * k * k * cos(kx * rx + ky * ry - w * t);
        }
    }
    return sum * dln * dth;
}

static double mean_product(void) {
    double sum = 0.0;
    for (int i = 0; i < PLACES; i++) sum += (double)height[i] * (double)other[i];
    return sum / PLACES;
}

typedef struct lag {
    double x, y, t;
} lag;

// Along the waves (from 240 degrees: towards 30 from the east), across them, and in time; the last two go with the
// waves and against them, at the phase speed of the peak.
static void make_lags(double cp, lag out[LAGS]) {
    const double c = cos(BOLAN_PI / 6.0), s = sin(BOLAN_PI / 6.0), t = 2.5;
    const lag lags[LAGS] = {
        {5.0 * c, 5.0 * s, 0.0},      {20.0 * c, 20.0 * s, 0.0}, {60.0 * c, 60.0 * s, 0.0}, {-15.0 * s, 15.0 * c, 0.0},
        {-60.0 * s, 60.0 * c, 0.0},   {0.0, 0.0, 1.0},           {0.0, 0.0, 4.0},           {cp * t * c, cp * t * s, t},
        {-cp * t * c, -cp * t * s, t}};
    memcpy(out, lags, sizeof lags);
}

static void check_correlation(const bolan_sea_state *state, const char *name) {
    lag lags[LAGS];
    double measured[LAGS] = {0}, variance = 0.0;
    const bolan_sea_summary summary = bolan_sea_state_summary(state);
    const double whole = expected_covariance(state, 0.0, 0.0, 0.0);
    assert_ratio(whole, summary.m0, 0.02);
    make_lags(BOLAN_GRAVITY * summary.tp / (2.0 * BOLAN_PI), lags);
    scatter(2e5);
    for (uint64_t seed = 1; seed <= SEEDS; seed++) {
        bolan_sea_desc d = linear_desc(seed);
        d.sea_state = *state;
        bolan_sea *sea = test_sea(d);
        const bolan_water water = {.sea = sea};
        bolan_query_heights(&water, place, PLACES, height);
        memcpy(other, height, sizeof other);
        variance += mean_product() / SEEDS;
        for (int i = 0; i < LAGS; i++) {
            for (int p = 0; p < PLACES; p++) beside[p] = (bolan_dvec2){place[p].x + lags[i].x, place[p].y + lags[i].y};
            bolan_sea_step(sea, lags[i].t);
            bolan_query_heights(&water, beside, PLACES, other);
            measured[i] += mean_product() / SEEDS;
        }
        bolan_sea_destroy(&sea);
    }
    for (int i = 0; i < LAGS; i++) {
        const double expected = expected_covariance(state, lags[i].x, lags[i].y, lags[i].t) / whole;
        print_message("%s, (%.0f m, %.0f m, %g s): %.3f, of the spectrum %.3f\n", name, lags[i].x, lags[i].y, lags[i].t,
                      measured[i] / variance, expected);
        assert_near(measured[i] / variance, expected, 0.02); // half of which is sampling
    }
}

static void heights_are_correlated_as_the_spectrum_says(void **state) {
    (void)state;
    bolan_sea_state wind = bolan_sea_state_from_wind(10.0, 240.0, 300e3), swell = bolan_sea_state_default(),
                    shallow = bolan_sea_state_from_wind(10.0, 240.0, 300e3);
    bolan_sea_state_add_swell(&swell, 2.0, 11.0, 240.0, 50.0);
    shallow.depth = 9.0;
    check_correlation(&wind, "wind");
    check_correlation(&swell, "swell");
    check_correlation(&shallow, "9 m of water");
}

// ---- a buoy in the sea of a buoy ------------------------------------------------------------------------------------

enum { BUOYS = 64, SAMPLES = 2048, SEGMENT = 256 };
static float heave[BUOYS][SAMPLES], east[BUOYS][SAMPLES], north[BUOYS][SAMPLES];

// Buoys that follow the surface, 2 samples a second.
static void ride(bolan_sea *sea) {
    bolan_dvec2 rest[BUOYS];
    bolan_sea_sample at[BUOYS];
    for (int b = 0; b < BUOYS; b++) rest[b] = (bolan_dvec2){7919.0 * b, -4507.0 * (b * b % 61)};
    for (int i = 0; i < SAMPLES; i++) {
        bolan_sea_step(sea, 0.5 * i);
        bolan_sea_sample_rest(sea, rest, BUOYS, at);
        for (int b = 0; b < BUOYS; b++) heave[b][i] = at[b].height, east[b][i] = at[b].dx, north[b][i] = at[b].dy;
    }
}

typedef struct band {
    double density, a1, b1;
} band;

// alpha1 and r1 of the file's bands of 0.12 to 0.30 Hz come back within a few degrees from the buoys on the sea that is
// made of them. Below lies the front of the peak, into which Welch's window carries the direction of the peak.
static void a_buoy_measures_what_the_buoy_measured(void **state) {
    (void)state;
    static bolan_record_band out[SEGMENT / 2];
    static band bands[SEGMENT / 2];
    bolan_spectrum_texts texts = buoy_41010();
    bolan_measured_spectrum *spectrum = parse(&texts, 148);
    bolan_sea_desc d = linear_desc(3);
    d.choppiness = 1.0;
    d.fft.cascade_count = 3; // no waves that 2 Hz would fold back
    d.sea_state = sea_of(spectrum);
    bolan_sea *sea = test_sea(d);
    ride(sea);
    for (int b = 0; b < BUOYS; b++) {
        assert_int_equal(bolan_record_spectrum(heave[b], east[b], north[b], SAMPLES, 2.0, SEGMENT, out), BOLAN_OK);
        for (int i = 0; i < SEGMENT / 2 - 1; i++) {
            bands[i].density += out[i].density / BUOYS;
            bands[i].a1 += out[i].density * out[i].a1 / BUOYS, bands[i].b1 += out[i].density * out[i].b1 / BUOYS;
        }
    }
    const bolan_measured_view v = bolan_measured_spectrum_view(spectrum);
    const double dth = 2.0 * BOLAN_PI / v.direction_count;
    for (double from = 0.12; from < 0.295; from += 0.02) { // bands of 0.02 Hz
        band file = {0}, buoy = {0};
        for (double f = from + 0.0005; f < from + 0.02; f += 0.001)
            for (uint32_t j = 0; j < v.direction_count; j++) {
                const double e = bolan_sea_state_density(&d.sea_state, 2.0 * BOLAN_PI * f, v.theta[j]) * dth * 2.0 *
                                 BOLAN_PI * 0.001;
                file.density += e, file.a1 += e * cos(v.theta[j]), file.b1 += e * sin(v.theta[j]);
            }
        for (int i = 0; i < SEGMENT / 2 - 1; i++) {
            // The share of a bin of 1/128 Hz that lies in the band.
            const double width = 2.0 / SEGMENT, left = out[i].frequency - 0.5 * width;
            const double share = fmax(0.0, fmin(left + width, from + 0.02) - fmax(left, from));
            buoy.density += bands[i].density * share;
            buoy.a1 += bands[i].a1 * share, buoy.b1 += bands[i].b1 * share;
        }
        const double turned = remainder(atan2(buoy.b1, buoy.a1) - atan2(file.b1, file.a1), 2.0 * BOLAN_PI);
        const double r1_buoy = hypot(buoy.a1, buoy.b1) / buoy.density, r1 = hypot(file.a1, file.b1) / file.density;
        print_message("%.2f Hz: density %.2f, turned by %.1f degrees, r1 %.3f of %.3f\n", from + 0.01,
                      buoy.density / file.density, turned * 180.0 / BOLAN_PI, r1_buoy, r1);
        assert_near(buoy.density / file.density, 1.0, 0.15); // Welch's window is two bins wide
        assert_near(turned * 180.0 / BOLAN_PI, 0.0, 4.0);
        assert_near(r1_buoy, r1, 0.06);
    }
    bolan_sea_destroy(&sea);
    bolan_measured_spectrum_destroy(&spectrum);
    release_texts(&texts);
}

RUN_TESTS(cmocka_unit_test(heights_are_correlated_as_the_spectrum_says),
          cmocka_unit_test(a_buoy_measures_what_the_buoy_measured))

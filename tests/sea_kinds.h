// SPDX-License-Identifier: MIT
// The seas that tests of the surface measure, their waves, and an FFT.
#ifndef BOLAN_TESTS_SEA_KINDS_H
#define BOLAN_TESTS_SEA_KINDS_H

#include "sea_support.h"
#include "spectrum_support.h"

#include "waves/cascades/cascades.h"

#include <complex.h>
#include <string.h>

static inline bool is_long(void) { return getenv("BOLAN_LONG") != NULL; }

// ---- seas -----------------------------------------------------------------------------------------------------------

typedef enum which { WIND5, WIND10, WIND20, SWELL14, NARROW14, OPEN_SEA, SWAN4, SEAS } which;
static const char *const names[] = {"wind 5 m/s",   "wind 10 m/s", "wind 20 m/s",  "swell 14 s",
                                    "narrow swell", "open sea",    "SWAN record 4"};
static bolan_measured_spectrum *swan;

static inline bolan_sea_desc desc_of(which sea, uint32_t n, uint64_t seed) {
    static const double wind[SEAS] = {5.0, 10.0, 20.0, 0.0, 0.0, 10.0, 0.0};
    bolan_sea_desc d = bolan_sea_desc_default();
    d.sea_state = wind[sea] > 0.0 ? bolan_sea_state_from_wind(wind[sea], 240.0, 300e3) : bolan_sea_state_default();
    if (sea == SWELL14) bolan_sea_state_add_swell(&d.sea_state, 2.0, 14.0, 270.0, 75.0);
    if (sea == NARROW14) bolan_sea_state_add_swell(&d.sea_state, 2.0, 14.0, 270.0, 200.0);
    if (sea == OPEN_SEA) bolan_sea_state_add_swell(&d.sea_state, 1.8, 13.0, 300.0, 45.0);
    if (sea == SWAN4) d.sea_state = sea_of(swan), d.sea_state.wind_speed = 15.0;
    d.resolution = n;
    d.seed = seed;
    d.choppiness = 0.0;
    return d;
}

static inline double m0_of(const bolan_sea *sea) { return bolan_sea_get_summary(sea)->m0; }
static inline double turn(double x) { return x - floor(x); }

static inline bolan_dvec2 scattered(uint32_t i, double side) {
    return (bolan_dvec2){side * turn(0.5 + i * 0.7548776662466927), side * turn(0.5 + i * 0.5698402909980532)};
}

// ---- modes ----------------------------------------------------------------------------------------------------------

enum { MOST_MODES = 1 << 20 };
typedef struct wave {
    double kx, ky, turns, variance; // turns: frequency [Hz]
    double complex amplitude;       // h at time 0
} wave;
static wave waves[MOST_MODES];
static uint32_t wave_count;

static inline void keep_wave(void *context, const sea_mode *m) {
    (void)context;
    const double forth = 2.0 * (m->re * m->re + m->im * m->im),
                 back = 2.0 * (m->back_re * m->back_re + m->back_im * m->back_im);
    assert_true(wave_count + 2 <= MOST_MODES);
    waves[wave_count++] = (wave){m->kx, m->ky, m->turns, forth, m->re + I * m->im};
    if (m->paired) waves[wave_count++] = (wave){-m->kx, -m->ky, m->turns, back, m->back_re - I * m->back_im};
}

// The progressive waves of a sea, with the variance of each.
static inline void gather(const bolan_sea *sea) {
    wave_count = 0;
    sea->shared->model->each_wave(sea->shared, keep_wave, NULL);
}

// ---- FFT ------------------------------------------------------------------------------------------------------------

static inline void fft(double complex *x, uint32_t n) { // radix 2
    static double complex turns[1 << 12];
    static uint32_t made;
    for (uint32_t i = 0; made != n && i < n / 2; i++) turns[i] = cexp(-2.0 * I * BOLAN_PI * i / n);
    made = n;
    for (uint32_t i = 1, j = 0; i < n; i++) {
        uint32_t bit = n >> 1;
        for (; j & bit; bit >>= 1) j ^= bit;
        j ^= bit;
        if (i < j) {
            const double complex t = x[i];
            x[i] = x[j], x[j] = t;
        }
    }
    for (uint32_t m = 2; m <= n; m *= 2)
        for (uint32_t block = 0; block < n; block += m)
            for (uint32_t k = 0; k < m / 2; k++) {
                const double complex w = turns[k * (n / m)] * x[block + k + m / 2], a = x[block + k];
                x[block + k] = a + w, x[block + k + m / 2] = a - w;
            }
}

// ---- fixtures -------------------------------------------------------------------------------------------------------

static inline int open_swan(void **state) {
    (void)state;
    bolan_spectrum_texts texts = bolan_spectrum_texts_default();
    texts.density = load_text("swan_maari_lonlat_24f36d.spec");
    swan = parse(&texts, 4);
    free((char *)texts.density.data);
    return 0;
}

static inline int close_swan(void **state) {
    (void)state;
    bolan_measured_spectrum_destroy(&swan);
    return 0;
}

#endif

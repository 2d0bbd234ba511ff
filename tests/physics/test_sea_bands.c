// SPDX-License-Identifier: MIT
// The waves of a sea against the continuous spectrum, band by band: what the grid of wave vectors of each tile does to
// a spectrum. A mode has the energy of its cell, so the whole is exact; where a tile begins its cells are as wide as a
// tenth of an octave. One wave a cell would be off by 0.25 there; a quarter of the cell a wave leaves 0.07.
#include "sea_support.h"
#include "spectrum_support.h"

#include "waves/model.h"

enum { BANDS = 60 };
#define LOWEST 0.04 // [Hz]

typedef struct bands {
    double width, modes[BANDS], asked[BANDS];
} bands;

static void add(bands *b, double hertz, double variance, double *to) {
    const int i = (int)floor(log(hertz / LOWEST) / log(b->width));
    if (i >= 0 && i < BANDS) to[i] += variance;
}

static void keep_mode(void *context, const sea_mode *m) {
    bands *b = context;
    add(b, m->turns, 2.0 * (m->re * m->re + m->im * m->im), b->modes);
    if (m->paired) add(b, m->turns, 2.0 * (m->back_re * m->back_re + m->back_im * m->back_im), b->modes);
}

// Midpoint rule in k and direction.
static void ask(bands *b, const bolan_sea_state *state) {
    enum { STEPS = 20000, ANGLES = 90 };
    const double k0 = 1e-3, dln = log(20.0 / k0) / STEPS, dth = 2.0 * BOLAN_PI / ANGLES;
    for (int i = 0; i < STEPS; i++) {
        const double k = k0 * exp((i + 0.5) * dln);
        double sum = 0.0;
        for (int j = 0; j < ANGLES; j++)
            sum += bolan_sea_state_wavenumber_density(state, k * cos(j * dth), k * sin(j * dth));
        add(b, bolan_omega_from_k(k, state->depth) / (2.0 * BOLAN_PI), sum * k * k * dln * dth, b->asked);
    }
}

// The worst ratio among the bands with a twentieth of the largest.
static double worst_of(const bolan_sea_state *state, double width, const char *name) {
    bands b = {.width = width};
    double top = 0.0, worst = 0.0, at = 0.0;
    bolan_sea_desc d = bolan_sea_desc_default();
    d.sea_state = *state;
    d.resolution = 128;
    bolan_sea *sea = test_sea(d);
    sea->shared->model->each_wave(sea->shared, keep_mode, &b);
    bolan_sea_destroy(&sea);
    ask(&b, state);
    for (int i = 0; i < BANDS; i++) top = fmax(top, b.asked[i]);
    for (int i = 0; i < BANDS; i++) {
        const double error = b.modes[i] / b.asked[i] - 1.0;
        if (getenv("BOLAN_LONG") && b.asked[i] > 0.05 * top)
            print_message("    %.4f Hz %+.3f\n", LOWEST * pow(width, i + 0.5), error);
        if (b.asked[i] > 0.05 * top && fabs(error) > fabs(worst)) worst = error, at = LOWEST * pow(width, i + 0.5);
    }
    print_message("%s, bands of %.2f octaves: off by %+.3f at %.3f Hz\n", name, log(width) / log(2.0), worst, at);
    return fabs(worst);
}

static void the_modes_have_the_spectrum_in_every_band(void **state) {
    (void)state;
    static const double winds[] = {5.0, 10.0, 20.0};
    static const struct { double width, bound; } of[] = {{1.0718, 0.08}, {1.2599, 0.03}};
    for (int i = 0; i < 2; i++) {
        for (int w = 0; w < 3; w++) {
            const bolan_sea_state wind = bolan_sea_state_from_wind(winds[w], 240.0, 300e3);
            char name[32];
            snprintf(name, sizeof name, "wind %g m/s", winds[w]);
            assert_true(worst_of(&wind, of[i].width, name) < of[i].bound);
        }
        bolan_sea_state swell = bolan_sea_state_default(), open = bolan_sea_state_from_wind(10.0, 240.0, 300e3);
        bolan_sea_state_add_swell(&swell, 2.0, 14.0, 270.0, 75.0);
        bolan_sea_state_add_swell(&open, 1.8, 13.0, 300.0, 45.0);
        assert_true(worst_of(&swell, of[i].width, "swell 14 s") < of[i].bound);
        assert_true(worst_of(&open, of[i].width, "open sea") < of[i].bound);
    }
}

RUN_TESTS(cmocka_unit_test(the_modes_have_the_spectrum_in_every_band))

// SPDX-License-Identifier: MIT
// Any sea as a spectrum on a grid.
#include "bolan/math.h"
#include "spectrum/measured.h"
#include "spectrum/portable.h"

#include <math.h>
#include <stdio.h>

enum { FREQUENCIES = 96, DIRECTIONS = 72 };

// The frequencies [rad/s] of all systems: from half of the lowest peak to eight times the highest, and those of the
// measured spectrum.
static void range_of(const bolan_sea_state *sea_state, double *low, double *high) {
    *low = HUGE_VAL, *high = 0.0;
    for (uint32_t i = 0; i < sea_state->system_count; i++) {
        *low = fmin(*low, 0.5 * sea_state->systems[i].peak_omega);
        *high = fmax(*high, 8.0 * sea_state->systems[i].peak_omega);
    }
    if (sea_state->measured) {
        const bolan_measured_view view = bolan_measured_spectrum_view(sea_state->measured);
        *low = fmin(*low, view.omega[0]);
        *high = fmax(*high, view.omega[view.frequency_count - 1]);
    }
    if (!(*low < *high)) *low = 0.2, *high = 4.0; // a calm
    *high = fmin(*high, 2.0 * BOLAN_PI * SPECTRUM_MAX_HERTZ);
}

bolan_result bolan_measured_spectrum_sample(const bolan_sea_state *sea_state, bolan_measured_spectrum **out) {
    BOLAN_ASSERT(sea_state && out);
    *out = NULL;
    const bool own = sea_state->measured && sea_state->system_count == 0;
    bolan_measured_view view = {.frequency_count = FREQUENCIES, .direction_count = DIRECTIONS, .time = ""};
    const bolan_measured_view measured =
        sea_state->measured ? bolan_measured_spectrum_view(sea_state->measured) : view;
    view.time = measured.time, view.place = measured.place;
    if (own) view = measured;
    spectrum_grid grid = {.frequency_count = view.frequency_count, .direction_count = view.direction_count};
    if (!bolan_spectrum_grid_allocate(&grid)) return BOLAN_ERROR_MEMORY;
    snprintf(grid.time, sizeof grid.time, "%s", view.time);
    grid.place = view.place;
    double low, high;
    range_of(sea_state, &low, &high);
    const double ratio = portable_pow(high / low, 1.0 / (grid.frequency_count - 1));
    for (uint32_t j = 0; j < grid.direction_count; j++)
        grid.to[j] = own ? view.theta[j] : 2.0 * BOLAN_PI * j / grid.direction_count;
    double omega = low;
    for (uint32_t i = 0; i < grid.frequency_count; i++, omega *= ratio) {
        if (own) omega = view.omega[i];
        grid.hertz[i] = omega / (2.0 * BOLAN_PI);
        for (uint32_t j = 0; j < grid.direction_count; j++) {
            const size_t k = (size_t)i * grid.direction_count + j;
            const double density = own ? view.density[k] : bolan_sea_state_density(sea_state, omega, grid.to[j]);
            grid.energy[k] = 2.0 * BOLAN_PI * density; // S(f) df = S(w) dw
        }
    }
    const bolan_result result = bolan_spectrum_measured_build("the sea state", &grid, out);
    bolan_spectrum_grid_release(&grid);
    return result;
}

// SPDX-License-Identifier: MIT
// See bands.h.
#include "formats/bands.h"

#include "bolan/math.h"
#include "formats/directional.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define DEFAULT_FROM 270.0
#define DEFAULT_SPREAD 10.0

bolan_result bolan_spectrum_bands_create(spectrum_bands **out) {
    *out = bolan_allocate(sizeof **out);
    if (*out) return BOLAN_OK;
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY,
              "a spectrum of bands needs %zu bytes, which could not be allocated", sizeof **out);
    return BOLAN_ERROR_MEMORY;
}

void bolan_spectrum_bands_destroy(spectrum_bands **bands) {
    if (*bands) bolan_release(*bands, sizeof **bands);
    *bands = NULL;
}

void bolan_spectrum_bands_clear(spectrum_bands *bands) {
    for (uint32_t i = 0; i < SPECTRUM_MAX_FREQUENCIES; i++)
        bands->density[i] = bands->alpha1[i] = bands->alpha2[i] = bands->r1[i] = bands->r2[i] = (double)NAN;
}

static bool none_of(const double *values, uint32_t count) {
    for (uint32_t i = 0; i < count; i++)
        if (!isnan(values[i])) return false;
    return true;
}

// The share of the variance in the bands that are marked, in per cent.
static double share_of(const spectrum_bands *bands, const bool *marked) {
    double part = 0.0, whole = 0.0;
    for (uint32_t i = 0; i < bands->count; i++) {
        const double variance = bands->density[i] * bolan_spectrum_trapezoid_weight(bands->hertz, bands->count, i);
        whole += variance;
        if (marked[i]) part += variance;
    }
    return whole > 0.0 ? 100.0 * part / whole : 0.0;
}

// ---- densities ------------------------------------------------------------------------------------------------------

// The density at band i between the known neighbours; 0 beyond the first or last known band.
static double interpolated(const spectrum_bands *bands, const bool *missing, uint32_t i) {
    uint32_t low = i, high = i;
    while (low > 0 && missing[low]) low--;
    while (high + 1 < bands->count && missing[high]) high++;
    if (missing[low] || missing[high]) return 0.0;
    const double t = (bands->hertz[i] - bands->hertz[low]) / (bands->hertz[high] - bands->hertz[low]);
    return bands->density[low] + t * (bands->density[high] - bands->density[low]);
}

static bolan_result fill_densities(spectrum_bands *bands, const char *name, const char *of_time,
                                   spectrum_notes *notes) {
    bool missing[SPECTRUM_MAX_FREQUENCIES];
    uint32_t count = 0;
    for (uint32_t i = 0; i < bands->count; i++) count += missing[i] = isnan(bands->density[i]);
    if (count == bands->count) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_SPECTRUM_NO_ENERGY,
                  "%s: every density of the record%s is marked as missing; expected at least one that is not", name,
                  of_time);
        return BOLAN_ERROR_FORMAT;
    }
    if (count == 0) return BOLAN_OK;
    for (uint32_t i = 0; i < bands->count; i++)
        if (missing[i]) bands->density[i] = interpolated(bands, missing, i);
    bolan_spectrum_note(
        notes, BOLAN_LOG_SPECTRUM_MISSING,
        "%s: %u of the %u densities of the record%s are missing: those between two others are interpolated, "
        "%.1f %% of the energy; those at the ends count as 0",
        name, (unsigned)count, (unsigned)bands->count, of_time, share_of(bands, missing));
    return BOLAN_OK;
}

// ---- directions -----------------------------------------------------------------------------------------------------

// Replaces missing values by that of the nearest lower band, or of the lowest band with a value; marks them in @p
// filled.
static void fill_from_neighbours(double *values, uint32_t count, bool *filled) {
    uint32_t first = 0;
    while (first < count && isnan(values[first])) first++;
    if (first == count) return;
    double previous = values[first];
    for (uint32_t i = 0; i < count; i++) {
        filled[i] |= isnan(values[i]);
        previous = values[i] = isnan(values[i]) ? previous : values[i];
    }
}

static void say_unused(const char *name, const bolan_spectrum_options *options, bool has_from, bool has_spread,
                       spectrum_notes *notes) {
    const bool from = has_from && !isnan(options->from_deg), spread = has_spread && !isnan(options->spread_s);
    if (!from && !spread) return;
    bolan_spectrum_note(notes, BOLAN_LOG_SPECTRUM_UNUSED, "%s: has %s of its own; %s%s%s not used", name,
                        from ? "directions" : "spreads", from ? "from" : "", from && spread ? " and " : "",
                        spread ? (from ? "spread are" : "spread is") : " is");
}

// One warning about the defaults that replace directions or spreads which no band has.
static void say_default(const char *name, const char *of_time, const char *why, bool from, bool spread,
                        spectrum_notes *notes) {
    char text[160] = "";
    if (from) bolan_format(text, sizeof text, "the waves come from %g degrees", DEFAULT_FROM);
    if (spread)
        bolan_format(text + strlen(text), sizeof text - strlen(text), "%scos-2s has the exponent %g",
                     from ? " and " : "", DEFAULT_SPREAD);
    bolan_spectrum_note(notes, BOLAN_LOG_SPECTRUM_NO_DIRECTIONS, "%s: the record%s %s; %s; give %s%s%s to choose", name,
                        of_time, why, text, from ? "from" : "", from && spread ? " and " : "", spread ? "spread" : "");
}

static void fill_directions(spectrum_bands *bands, const char *name, const char *of_time, const char *why,
                            const bolan_spectrum_options *options, spectrum_notes *notes) {
    bool filled[SPECTRUM_MAX_FREQUENCIES] = {false};
    const bool no_from = none_of(bands->alpha1, bands->count);
    const bool no_spread = none_of(bands->r1, bands->count);
    const double from = isnan(options->from_deg) ? DEFAULT_FROM : options->from_deg;
    for (uint32_t i = 0; no_from && i < bands->count; i++) {
        bands->alpha1[i] = from;
        bands->alpha2[i] = (double)NAN; // the second moment lies about the first
    }
    fill_from_neighbours(bands->alpha1, bands->count, filled);
    fill_from_neighbours(bands->r1, bands->count, filled);
    say_unused(name, options, !no_from, !no_spread, notes);
    const bool default_from = no_from && isnan(options->from_deg);
    const bool default_spread = no_spread && isnan(options->spread_s);
    if (default_from || default_spread)
        say_default(name, of_time, no_from ? why : "has directions but no spreads", default_from, default_spread,
                    notes);
    const double share = share_of(bands, filled);
    if (share > 0.0)
        bolan_spectrum_note(
            notes, BOLAN_LOG_SPECTRUM_MISSING,
            "%s: the record%s has no direction or spread for bands with %.1f %% of the energy; they take that "
            "of the nearest lower band, or of the lowest that has one",
            name, of_time, share);
}

// D on the bins for band i, by the known data: four moments, one moment, or cos-2s with the exponent of the caller.
static void spread_band(const spectrum_bands *bands, uint32_t i, double spread_s, double spread[DIRECTIONAL_BINS]) {
    const double to = bolan_compass_from_to_math(bands->alpha1[i]);
    const double r1 = bands->r1[i], r2 = bands->r2[i], a2 = bands->alpha2[i];
    if (isnan(r1))
        bolan_directional_cos2s(to, spread_s, spread);
    else if (isnan(r2) || isnan(a2))
        bolan_directional_cos2s(to, r1 < 0.995 ? r1 / (1.0 - r1) : 200.0, spread); // r1 of cos-2s is s / (s + 1)
    else
        bolan_directional_from_moments((directional_moments){to, bolan_compass_from_to_math(a2), r1, r2}, spread);
}

static bolan_result fill_grid(const spectrum_bands *bands, double spread_s, spectrum_grid *grid) {
    grid->frequency_count = bands->count;
    grid->direction_count = DIRECTIONAL_BINS;
    if (!bolan_spectrum_grid_allocate(grid)) return BOLAN_ERROR_MEMORY;
    for (uint32_t j = 0; j < DIRECTIONAL_BINS; j++) grid->to[j] = bolan_directional_angle(j);
    for (uint32_t i = 0; i < bands->count; i++) {
        double *energy = grid->energy + (size_t)i * DIRECTIONAL_BINS;
        grid->hertz[i] = bands->hertz[i];
        if (!(bands->density[i] > 0.0)) continue;
        spread_band(bands, i, spread_s, energy);
        for (uint32_t j = 0; j < DIRECTIONAL_BINS; j++) energy[j] *= bands->density[i];
    }
    return BOLAN_OK;
}

bolan_result bolan_spectrum_bands_to_grid(spectrum_bands *bands, const char *name, const char *why,
                                          const bolan_spectrum_options *options, spectrum_grid *grid) {
    char of_time[48] = "";
    if (grid->time[0]) snprintf(of_time, sizeof of_time, " of %s", grid->time);
    if (fill_densities(bands, name, of_time, &grid->notes)) return BOLAN_ERROR_FORMAT;
    fill_directions(bands, name, of_time, why, options, &grid->notes);
    return fill_grid(bands, isnan(options->spread_s) ? DEFAULT_SPREAD : options->spread_s, grid);
}

// SPDX-License-Identifier: MIT
// 2-D wave spectra of ERA5 and of ECMWF's other wave models in NetCDF: d2fd(time, frequency, direction, latitude,
// longitude), the common logarithm of the density [m2 s/rad], whatever its units say (parameter 251 of ECMWF's table
// 140; "ERA5: How to download 2D wave spectra"). A missing value is a density too small to be kept: no energy.
//
// Frequencies and directions are numbered: f = 0.03453 x 1.1^(n - 1) Hz, and 24 directions of 7.5, 22.5, ... compass
// degrees that waves go TO. Files that have hertz or degrees in their place are read as such.
#include "formats/netcdf_spectra.h"

#include "bolan/math.h"
#include "spectrum/portable.h"

#include <math.h>

#define FIRST_HERTZ 0.03453
#define HERTZ_RATIO 1.1
#define LN_10 2.302585092994046

static const char *const times[] = {"time", "valid_time", NULL};
static const char *const frequencies[] = {"frequency", "frequencyNumber", NULL};
static const char *const directions[] = {"direction", "directionNumber", NULL};
static const char *const latitudes[] = {"latitude", "lat", NULL}, *const longitudes[] = {"longitude", "lon", NULL};
static const netcdf_layout layout = {"d2fd", times, frequencies, directions, NULL, latitudes, longitudes};

static bool is_era5(const bolan_spectrum_text *text) { return bolan_netcdf_has(text, layout.density); }

static bolan_result list_records(const bolan_spectrum_texts *texts, record_list *list) {
    return bolan_netcdf_spectra_records(texts, &layout, list);
}

static bolan_result list_locations(const bolan_spectrum_texts *texts, const record_entry *record, location_list *list) {
    return bolan_netcdf_spectra_locations(texts, &layout, record, list);
}

// Are the values 1, 2, 3, ...?
static bool is_numbered(const netcdf_file *file, const netcdf_variable *v) {
    for (uint64_t i = 0; i < v->count; i++)
        if (bolan_netcdf_value(file, v, i) != (double)(i + 1)) return false;
    return true;
}

static bolan_result read_frequencies(const netcdf_spectra *s, double *hertz) {
    if (!is_numbered(&s->file, s->frequency)) return bolan_netcdf_spectra_frequencies(s, hertz);
    double f = FIRST_HERTZ;
    for (uint32_t i = 0; i < s->frequencies; i++, f *= HERTZ_RATIO) {
        hertz[i] = f;
        if (f > SPECTRUM_MAX_HERTZ) return bolan_netcdf_unexpected(&s->file, s->frequency, "at most 60 frequencies");
    }
    return BOLAN_OK;
}

static bolan_result read_directions(const netcdf_spectra *s, double *to) {
    const bool numbered = is_numbered(&s->file, s->direction);
    for (uint32_t j = 0; j < s->directions; j++) {
        const double degrees =
            numbered ? (j + 0.5) * 360.0 / s->directions : bolan_netcdf_value(&s->file, s->direction, j);
        if (!(fabs(degrees) <= 720.0)) return bolan_netcdf_unexpected(&s->file, s->direction, "degrees, or numbers");
        to[j] = bolan_compass_from_to_math(degrees + 180.0);
    }
    return BOLAN_OK;
}

static bolan_result read_densities(const netcdf_spectra *s, const format_choice *choice, spectrum_grid *grid) {
    const uint64_t base = bolan_netcdf_spectra_index(s, s->density, choice->record->order, choice->location);
    bool any = false;
    for (uint32_t i = 0; i < s->frequencies; i++)
        for (uint32_t j = 0; j < s->directions; j++) {
            const double logarithm =
                bolan_netcdf_value(&s->file, s->density, base + i * s->frequency_step + j * s->direction_step);
            if (isnan(logarithm)) continue;
            any = true;
            const double density = portable_exp(logarithm * LN_10);
            if (!(density <= SPECTRUM_MAX_DENSITY))
                return bolan_netcdf_unexpected(&s->file, s->density, "logarithms of densities that a sea can have");
            grid->energy[(size_t)i * s->directions + j] = density;
        }
    return any ? BOLAN_OK : bolan_netcdf_spectra_refuse_dry(s, choice, grid->time);
}

static bolan_result read_spectrum(const bolan_spectrum_texts *texts, const format_choice *choice,
                                  const bolan_spectrum_options *options, spectrum_grid *grid) {
    (void)options;
    static const netcdf_parts parts = {read_frequencies, read_directions, read_densities};
    return bolan_netcdf_spectra_read(texts, &layout, &parts, choice, grid);
}

const spectrum_format bolan_format_era5 = {
    "era5", "ERA5 wave spectra (NetCDF)", is_era5, list_records, list_locations, read_spectrum};

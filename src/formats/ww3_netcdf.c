// SPDX-License-Identifier: MIT
// Point spectra of WAVEWATCH III in NetCDF (user manual, program ww3_ounp): efth(time, station, frequency, direction)
// [m2 s/rad], directions in compass degrees that waves go TO. Files of other programs that say
// sea_surface_wave_from_direction of their directions, or degrees in their units, are believed.
#include "formats/netcdf_spectra.h"

#include "bolan/math.h"

#include <math.h>
#include <string.h>

static const char *const times[] = {"time", NULL}, *const frequencies[] = {"frequency", "freq", NULL};
static const char *const directions[] = {"direction", "dir", NULL}, *const stations[] = {"station", "site", NULL};
static const char *const latitudes[] = {"latitude", "lat", NULL}, *const longitudes[] = {"longitude", "lon", NULL};
static const netcdf_layout layout = {"efth", times, frequencies, directions, stations, latitudes, longitudes};

static bool is_ww3(const bolan_spectrum_text *text) { return bolan_netcdf_has(text, layout.density); }

static bolan_result list_records(const bolan_spectrum_texts *texts, record_list *list) {
    return bolan_netcdf_spectra_records(texts, &layout, list);
}

static bolan_result list_locations(const bolan_spectrum_texts *texts, const record_entry *record, location_list *list) {
    return bolan_netcdf_spectra_locations(texts, &layout, record, list);
}

static bool contains(text_word text, const char *part) {
    const size_t length = strlen(part);
    for (size_t i = 0; i + length <= text.length; i++)
        if (memcmp(text.begin + i, part, length) == 0) return true;
    return false;
}

static bolan_result read_directions(const netcdf_spectra *s, double *to) {
    const bool from = contains(bolan_netcdf_text(&s->file, s->direction, "standard_name"), "from_direction");
    for (uint32_t j = 0; j < s->directions; j++) {
        const double degrees = bolan_netcdf_value(&s->file, s->direction, j);
        if (!(fabs(degrees) <= 720.0)) return bolan_netcdf_unexpected(&s->file, s->direction, "degrees");
        to[j] = bolan_compass_from_to_math(from ? degrees : degrees + 180.0);
    }
    return BOLAN_OK;
}

static bolan_result read_densities(const netcdf_spectra *s, const format_choice *choice, spectrum_grid *grid) {
    const text_word units = bolan_netcdf_text(&s->file, s->density, "units");
    const double scale = contains(units, "deg") ? 180.0 / BOLAN_PI : 1.0;
    const uint64_t base = bolan_netcdf_spectra_index(s, s->density, choice->record->order, choice->location);
    uint32_t missing = 0;
    for (uint32_t i = 0; i < s->frequencies; i++)
        for (uint32_t j = 0; j < s->directions; j++) {
            double value =
                bolan_netcdf_value(&s->file, s->density, base + i * s->frequency_step + j * s->direction_step);
            missing += isnan(value);
            if (isnan(value)) value = 0.0;
            if (!(value >= 0.0 && value * scale <= SPECTRUM_MAX_DENSITY))
                return bolan_netcdf_unexpected(&s->file, s->density, "densities that a sea can have, 0 or more");
            grid->energy[(size_t)i * s->directions + j] = value * scale;
        }
    if (missing == s->frequencies * s->directions) return bolan_netcdf_spectra_refuse_dry(s, choice, grid->time);
    if (missing > 0)
        bolan_spectrum_note(&grid->notes, BOLAN_LOG_SPECTRUM_MISSING,
                            "%s: %.1f %% of the densities of the record are missing: they count as 0", s->file.name,
                            100.0 * missing / ((double)s->frequencies * s->directions));
    return BOLAN_OK;
}

static bolan_result read_spectrum(const bolan_spectrum_texts *texts, const format_choice *choice,
                                  const bolan_spectrum_options *options, spectrum_grid *grid) {
    (void)options;
    static const netcdf_parts parts = {bolan_netcdf_spectra_frequencies, read_directions, read_densities};
    return bolan_netcdf_spectra_read(texts, &layout, &parts, choice, grid);
}

const spectrum_format bolan_format_ww3_netcdf = {
    "ww3-netcdf", "WAVEWATCH III point spectra (NetCDF)", is_ww3, list_records, list_locations, read_spectrum};

// SPDX-License-Identifier: MIT
// Buoys in NetCDF, bands with moments of their directions:
//
//     CDIP  waveEnergyDensity(waveTime, waveFrequency) [m2/Hz]; waveA1Value ... waveB2Value, the Fourier coefficients
//           of the compass direction waves come FROM, so that the mean direction is atan2(b1, a1)
//     NDBC  spectral_wave_density(time, frequency, latitude, longitude); mean_wave_dir, principal_wave_dir, compass
//           degrees FROM; wave_spectrum_r1, wave_spectrum_r2
#include "formats/bands.h"
#include "formats/netcdf_spectra.h"

#include "bolan/math.h"
#include "spectrum/portable.h"

#include <math.h>
#include <string.h>

static const char *const cdip_times[] = {"waveTime", NULL}, *const cdip_frequencies[] = {"waveFrequency", NULL};
static const char *const cdip_latitudes[] = {"metaStationLatitude", "metaDeployLatitude", NULL};
static const char *const cdip_longitudes[] = {"metaStationLongitude", "metaDeployLongitude", NULL};
static const netcdf_layout cdip = {"waveEnergyDensity", cdip_times,     cdip_frequencies, NULL, NULL,
                                   cdip_latitudes,      cdip_longitudes};

static const char *const ndbc_times[] = {"time", NULL}, *const ndbc_frequencies[] = {"frequency", NULL};
static const char *const ndbc_latitudes[] = {"latitude", NULL}, *const ndbc_longitudes[] = {"longitude", NULL};
static const netcdf_layout ndbc = {"spectral_wave_density", ndbc_times,     ndbc_frequencies, NULL, NULL,
                                   ndbc_latitudes,          ndbc_longitudes};

// Fills @p out with a variable over time and frequency, where there is one; NAN for what is missing.
static bolan_result read_row(const netcdf_spectra *s, const char *name, const format_choice *choice, double low,
                             double high, double *out) {
    const netcdf_variable *v = bolan_netcdf_find(&s->file, name);
    for (uint32_t i = 0; i < s->frequencies; i++) out[i] = (double)NAN;
    if (!v) return BOLAN_OK;
    if (v->count != s->density->count || v->rank != s->density->rank || v->type == NETCDF_CHAR ||
        memcmp(v->axes, s->density->axes, v->rank * sizeof *v->axes) != 0)
        return bolan_netcdf_unexpected(&s->file, v, "a value for each density");
    const uint64_t base = bolan_netcdf_spectra_index(s, v, choice->record->order, choice->location);
    for (uint32_t i = 0; i < s->frequencies; i++) {
        out[i] = bolan_netcdf_value(&s->file, v, base + i * s->frequency_step);
        if (isnan(out[i]) || (out[i] >= low && out[i] <= high)) continue;
        char expected[64];
        bolan_format(expected, sizeof expected, "values of %g to %g", low, high);
        return bolan_netcdf_unexpected(&s->file, v, expected);
    }
    return BOLAN_OK;
}

// A moment (a, b) of the angle times @p order as a length and a compass direction.
static bolan_result read_moment(const netcdf_spectra *s, const format_choice *choice, const char *cosine,
                                const char *sine, int order, double *length, double *degrees) {
    if (read_row(s, cosine, choice, -1.0, 1.0, length) || read_row(s, sine, choice, -1.0, 1.0, degrees))
        return BOLAN_ERROR_FORMAT;
    for (uint32_t i = 0; i < s->frequencies; i++) {
        const double a = length[i], b = degrees[i];
        degrees[i] = bolan_degrees(portable_angle(b, a)) / order; // NAN stays
        length[i] = fmin(sqrt(a * a + b * b), 1.0);
        if (isnan(a) || isnan(b)) length[i] = degrees[i] = (double)NAN;
    }
    return BOLAN_OK;
}

static bolan_result read_directions(const netcdf_spectra *s, const format_choice *choice, spectrum_bands *bands) {
    if (s->layout == &cdip)
        return read_moment(s, choice, "waveA1Value", "waveB1Value", 1, bands->r1, bands->alpha1) ||
                       read_moment(s, choice, "waveA2Value", "waveB2Value", 2, bands->r2, bands->alpha2)
                   ? BOLAN_ERROR_FORMAT
                   : BOLAN_OK;
    return read_row(s, "mean_wave_dir", choice, -360.0, 360.0, bands->alpha1) ||
                   read_row(s, "principal_wave_dir", choice, -360.0, 360.0, bands->alpha2) ||
                   read_row(s, "wave_spectrum_r1", choice, 0.0, 1.0, bands->r1) ||
                   read_row(s, "wave_spectrum_r2", choice, 0.0, 1.0, bands->r2)
               ? BOLAN_ERROR_FORMAT
               : BOLAN_OK;
}

static bolan_result read_bands(const netcdf_spectra *s, const format_choice *choice,
                               const bolan_spectrum_options *options, spectrum_bands *bands, spectrum_grid *grid) {
    bolan_spectrum_bands_clear(bands);
    bands->count = s->frequencies;
    if (bolan_netcdf_spectra_frequencies(s, bands->hertz) ||
        read_row(s, s->layout->density, choice, 0.0, SPECTRUM_MAX_DENSITY, bands->density) ||
        read_directions(s, choice, bands))
        return BOLAN_ERROR_FORMAT;
    return bolan_spectrum_bands_to_grid(bands, s->file.name, "has no directions", options, grid);
}

static bolan_result read_layout(const bolan_spectrum_texts *texts, const netcdf_layout *layout,
                                const format_choice *choice, const bolan_spectrum_options *options,
                                spectrum_grid *grid) {
    netcdf_spectra *s = NULL;
    spectrum_bands *bands = NULL;
    bolan_result result = bolan_netcdf_spectra_open(&texts->density, layout, &s);
    if (!result) result = bolan_spectrum_bands_create(&bands);
    if (!result) result = read_bands(s, choice, options, bands, grid);
    bolan_spectrum_bands_destroy(&bands);
    bolan_netcdf_spectra_close(&s);
    return result;
}

#define FORMAT_OF(layout)                                                                                       \
    static bool is_##layout(const bolan_spectrum_text *text) { return bolan_netcdf_has(text, layout.density); } \
    static bolan_result records_##layout(const bolan_spectrum_texts *texts, record_list *list) {                \
        return bolan_netcdf_spectra_records(texts, &layout, list);                                              \
    }                                                                                                           \
    static bolan_result locations_##layout(const bolan_spectrum_texts *texts, const record_entry *record,       \
                                           location_list *list) {                                               \
        return bolan_netcdf_spectra_locations(texts, &layout, record, list);                                    \
    }                                                                                                           \
    static bolan_result read_##layout(const bolan_spectrum_texts *texts, const format_choice *choice,           \
                                      const bolan_spectrum_options *options, spectrum_grid *grid) {             \
        return read_layout(texts, &layout, choice, options, grid);                                              \
    }
FORMAT_OF(cdip)
FORMAT_OF(ndbc)

const spectrum_format bolan_format_cdip = {"cdip",       "CDIP buoy (NetCDF)", is_cdip,
                                           records_cdip, locations_cdip,       read_cdip};
const spectrum_format bolan_format_ndbc_netcdf = {"ndbc-netcdf", "NDBC buoy (NetCDF)", is_ndbc,
                                                  records_ndbc,  locations_ndbc,       read_ndbc};

// SPDX-License-Identifier: MIT
/// @file netcdf_spectra.h
/// What the NetCDF formats of spectra share: a variable of densities over named axes, its records and its places.
/// Private to src/formats.
#ifndef BOLAN_FORMATS_NETCDF_SPECTRA_H
#define BOLAN_FORMATS_NETCDF_SPECTRA_H

#include "formats/format.h"
#include "formats/netcdf.h"

/// Names that a format has for one thing, NULL at the end.
typedef const char *const *netcdf_names;

/// A format's names of its variables and axes. An axis has the name of the variable of its coordinates.
typedef struct netcdf_layout {
    const char *density;
    netcdf_names time, frequency, direction; ///< direction NULL: densities over frequency alone
    netcdf_names place;                      ///< the axis of the stations; NULL: a place is a latitude and a longitude
    netcdf_names latitude, longitude;
} netcdf_layout;

/// A file of one layout: its variables, and the steps of its axes through the densities.
typedef struct netcdf_spectra {
    netcdf_file file;
    const netcdf_layout *layout;
    const netcdf_variable *density, *time, *frequency, *direction, *latitude, *longitude;
    uint32_t frequencies, directions, records;
    uint64_t frequency_step, direction_step;
} netcdf_spectra;

/// Are the bytes NetCDF with the layout's variable of densities? Silent.
bool bolan_netcdf_has(const bolan_spectrum_text *text, const char *density);
/// Opens the file and finds everything that the layout names. FORMAT. @p out is large: allocate it by the next
/// function.
bolan_result bolan_netcdf_spectra_open(const bolan_spectrum_text *text, const netcdf_layout *layout,
                                       netcdf_spectra **out);
void bolan_netcdf_spectra_close(netcdf_spectra **spectra);

/// The first two functions of a format (format.h), for a layout.
bolan_result bolan_netcdf_spectra_records(const bolan_spectrum_texts *texts, const netcdf_layout *layout,
                                          record_list *list);
bolan_result bolan_netcdf_spectra_locations(const bolan_spectrum_texts *texts, const netcdf_layout *layout,
                                            const record_entry *record, location_list *list);

/// The index in @p variable of a record and a location at frequency and direction 0; the axes that it lacks count
/// nothing.
uint64_t bolan_netcdf_spectra_index(const netcdf_spectra *s, const netcdf_variable *variable, uint32_t record,
                                    uint32_t location);
/// The frequencies [Hz] into @p hertz. FORMAT where they do not ascend within the limits.
bolan_result bolan_netcdf_spectra_frequencies(const netcdf_spectra *s, double *hertz);
/// How a format of densities over frequency and direction reads each part.
typedef struct netcdf_parts {
    bolan_result (*frequencies)(const netcdf_spectra *s, double *hertz);
    bolan_result (*directions)(const netcdf_spectra *s, double *to); ///< mathematical, where waves go TO [rad]
    bolan_result (*densities)(const netcdf_spectra *s, const format_choice *choice, spectrum_grid *grid);
} netcdf_parts;
/// The third function of a format (format.h), for a layout and its parts.
bolan_result bolan_netcdf_spectra_read(const bolan_spectrum_texts *texts, const netcdf_layout *layout,
                                       const netcdf_parts *parts, const format_choice *choice, spectrum_grid *grid);
/// "NAME: no data" of a record at a location; FORMAT.
bolan_result bolan_netcdf_spectra_refuse_dry(const netcdf_spectra *s, const format_choice *choice, const char *time);

#endif

// SPDX-License-Identifier: MIT
// See netcdf_spectra.h.
#include "formats/netcdf_spectra.h"

#include "base/hooks.h"

#include <math.h>
#include <stdio.h>

enum { MOST_PLACES = 1000000 };

bool bolan_netcdf_has(const bolan_spectrum_text *text, const char *density) {
    netcdf_file file;
    if (!bolan_netcdf_is(text)) return false;
    bolan_log_mute(true); // bytes that no format claims are refused later
    const bool found = bolan_netcdf_open(text, &file) == BOLAN_OK && bolan_netcdf_find(&file, density);
    bolan_log_mute(false);
    return found;
}

// ---- opening --------------------------------------------------------------------------------------------------------

static uint64_t step_of(const netcdf_file *file, const netcdf_variable *v, int axis) {
    uint64_t step = axis < 0 ? 0 : 1;
    for (int i = axis + 1; axis >= 0 && i < (int)v->rank; i++) step *= bolan_netcdf_length(file, v, i);
    return step;
}

// A variable with the first of the names that is there; it must hold numbers.
static bolan_result find_any(const netcdf_file *file, netcdf_names names, const netcdf_variable **out) {
    netcdf_names name = names;
    while (name[1] && !bolan_netcdf_find(file, *name)) name++;
    return bolan_netcdf_need(file, bolan_netcdf_find(file, *name) ? *name : names[0], out);
}

// The length of a named axis of the densities, within limits, and its step.
static bolan_result find_axis(const netcdf_spectra *s, netcdf_names names, const char *what, uint32_t low,
                              uint32_t high, uint32_t *length, uint64_t *step) {
    const int axis = bolan_netcdf_axis(&s->file, s->density, names);
    char expected[96];
    *length = axis < 0 ? 0 : bolan_netcdf_length(&s->file, s->density, axis);
    if (step) *step = step_of(&s->file, s->density, axis);
    if (*length >= low && *length <= high) return BOLAN_OK;
    snprintf(expected, sizeof expected, "an axis %s of %u to %u %s", names[0], (unsigned)low, (unsigned)high, what);
    return bolan_netcdf_unexpected(&s->file, s->density, expected);
}

// Axes that the layout does not name must have one step only: an ensemble, a level.
static bolan_result check_other_axes(const netcdf_spectra *s) {
    const netcdf_layout *l = s->layout;
    const netcdf_names known[] = {l->time, l->frequency, l->direction, l->place, l->latitude, l->longitude};
    for (uint32_t axis = 0; axis < s->density->rank; axis++) {
        bool named = bolan_netcdf_length(&s->file, s->density, (int)axis) == 1;
        for (size_t i = 0; i < sizeof known / sizeof *known; i++)
            named |= known[i] && bolan_netcdf_axis(&s->file, s->density, known[i]) == (int)axis;
        if (!named)
            return bolan_netcdf_unexpected(&s->file, s->density, "no axes but time, place, frequency, direction");
    }
    return BOLAN_OK;
}

static bolan_result find_all(netcdf_spectra *s) {
    const netcdf_layout *l = s->layout;
    if (bolan_netcdf_need(&s->file, l->density, &s->density) || find_any(&s->file, l->time, &s->time) ||
        find_any(&s->file, l->frequency, &s->frequency) ||
        (l->direction && find_any(&s->file, l->direction, &s->direction)))
        return BOLAN_ERROR_FORMAT;
    if (find_axis(s, l->frequency, "frequencies", SPECTRUM_MIN_FREQUENCIES, SPECTRUM_MAX_FREQUENCIES, &s->frequencies,
                  &s->frequency_step) ||
        (l->direction && find_axis(s, l->direction, "directions", SPECTRUM_MIN_DIRECTIONS, SPECTRUM_MAX_DIRECTIONS,
                                   &s->directions, &s->direction_step)) ||
        find_axis(s, l->time, "times", 1, UINT32_MAX, &s->records, NULL) || check_other_axes(s))
        return BOLAN_ERROR_FORMAT;
    if (s->frequency->count != s->frequencies)
        return bolan_netcdf_unexpected(&s->file, s->frequency, "one value for each frequency of the densities");
    if (l->direction && s->direction->count != s->directions)
        return bolan_netcdf_unexpected(&s->file, s->direction, "one value for each direction of the densities");
    if (s->time->count != s->records)
        return bolan_netcdf_unexpected(&s->file, s->time, "one value for each time of the densities");
    for (netcdf_names name = l->latitude; *name && !s->latitude; name++)
        s->latitude = bolan_netcdf_find(&s->file, *name);
    for (netcdf_names name = l->longitude; *name && !s->longitude; name++)
        s->longitude = bolan_netcdf_find(&s->file, *name);
    return BOLAN_OK;
}

bolan_result bolan_netcdf_spectra_open(const bolan_spectrum_text *text, const netcdf_layout *layout,
                                       netcdf_spectra **out) {
    netcdf_spectra *s = *out = bolan_allocate(sizeof *s);
    if (!s) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY,
                  "a NetCDF header needs %zu bytes, which could not be allocated", sizeof *s);
        return BOLAN_ERROR_MEMORY;
    }
    bolan_result result = bolan_netcdf_open(text, &s->file);
    s->layout = layout;
    if (!result) result = find_all(s);
    if (result) bolan_netcdf_spectra_close(out);
    return result;
}

void bolan_netcdf_spectra_close(netcdf_spectra **spectra) {
    if (*spectra) bolan_release(*spectra, sizeof **spectra);
    *spectra = NULL;
}

// ---- records and places ---------------------------------------------------------------------------------------------

bolan_result bolan_netcdf_spectra_records(const bolan_spectrum_texts *texts, const netcdf_layout *layout,
                                          record_list *list) {
    netcdf_spectra *s;
    bolan_result result = bolan_netcdf_spectra_open(&texts->density, layout, &s);
    if (!result) result = bolan_netcdf_times(&s->file, s->time, list);
    bolan_netcdf_spectra_close(&s);
    return result;
}

static uint32_t axis_length(const netcdf_spectra *s, netcdf_names names) {
    const int axis = names ? bolan_netcdf_axis(&s->file, s->density, names) : -1;
    return axis < 0 ? 1 : bolan_netcdf_length(&s->file, s->density, axis);
}

uint64_t bolan_netcdf_spectra_index(const netcdf_spectra *s, const netcdf_variable *v, uint32_t record,
                                    uint32_t location) {
    const netcdf_layout *l = s->layout;
    const uint32_t columns = axis_length(s, l->longitude);
    const struct {
        netcdf_names names;
        uint32_t index;
    } axes[] = {{l->time, record},
                {l->place, location},
                {l->place ? NULL : l->latitude, location / columns},
                {l->place ? NULL : l->longitude, location % columns}};
    uint64_t index = 0;
    for (size_t i = 0; i < sizeof axes / sizeof *axes; i++)
        if (axes[i].names) index += axes[i].index * step_of(&s->file, v, bolan_netcdf_axis(&s->file, v, axes[i].names));
    return index;
}

// A coordinate of a location; NAN where the file ends before it or marks it as missing.
static double coordinate(const netcdf_spectra *s, const netcdf_variable *v, uint32_t record, uint32_t location) {
    const uint64_t index = bolan_netcdf_spectra_index(s, v, record, location);
    return index < v->count ? bolan_netcdf_value(&s->file, v, index) : (double)NAN;
}

static bolan_result list_places(const netcdf_spectra *s, uint32_t record, location_list *list) {
    const netcdf_variable *names = bolan_netcdf_find(&s->file, "station_name");
    const uint64_t count = s->layout->place
                               ? axis_length(s, s->layout->place)
                               : (uint64_t)axis_length(s, s->layout->latitude) * axis_length(s, s->layout->longitude);
    if (!s->latitude || !s->longitude || s->latitude->type == NETCDF_CHAR || s->longitude->type == NETCDF_CHAR) {
        if (count == 1) return BOLAN_OK;
        return bolan_netcdf_unexpected(&s->file, s->density, "variables of the latitudes and longitudes beside it");
    }
    if (count > MOST_PLACES) return bolan_netcdf_unexpected(&s->file, s->density, "at most 1000000 places");
    list->spherical = true;
    for (uint32_t i = 0; i < count; i++) {
        const text_word name = names ? bolan_netcdf_row(&s->file, names, i) : (text_word){"", 0, 1};
        const double x = coordinate(s, s->longitude, record, i), y = coordinate(s, s->latitude, record, i);
        if (!(fabs(x) <= 720.0 && fabs(y) <= 90.0))
            return bolan_netcdf_unexpected(&s->file, s->latitude, "a latitude and a longitude for each place");
        if (bolan_location_list_add(list, x, y, name.begin, name.length)) return BOLAN_ERROR_MEMORY;
    }
    return BOLAN_OK;
}

bolan_result bolan_netcdf_spectra_locations(const bolan_spectrum_texts *texts, const netcdf_layout *layout,
                                            const record_entry *record, location_list *list) {
    netcdf_spectra *s;
    bolan_result result = bolan_netcdf_spectra_open(&texts->density, layout, &s);
    if (!result) result = list_places(s, record->order, list);
    bolan_netcdf_spectra_close(&s);
    return result;
}

// ---- values ---------------------------------------------------------------------------------------------------------

bolan_result bolan_netcdf_spectra_frequencies(const netcdf_spectra *s, double *hertz) {
    for (uint32_t i = 0; i < s->frequencies; i++) {
        hertz[i] = bolan_netcdf_value(&s->file, s->frequency, i);
        if (!(hertz[i] >= SPECTRUM_MIN_HERTZ && hertz[i] <= SPECTRUM_MAX_HERTZ) ||
            (i > 0 && !(hertz[i] > hertz[i - 1])))
            return bolan_netcdf_unexpected(&s->file, s->frequency, "ascending frequencies of 0.001 to 10 Hz");
    }
    return BOLAN_OK;
}

bolan_result bolan_netcdf_spectra_refuse_dry(const netcdf_spectra *s, const format_choice *choice, const char *time) {
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_SPECTRUM_NO_ENERGY,
              "%s: location %u of %u has no data%s%s: every density is marked as missing; expected a place at sea",
              s->file.name, (unsigned)choice->location + 1,
              (unsigned)(choice->locations->count ? choice->locations->count : 1), time[0] ? " at " : "", time);
    return BOLAN_ERROR_FORMAT;
}

bolan_result bolan_netcdf_spectra_read(const bolan_spectrum_texts *texts, const netcdf_layout *layout,
                                       const netcdf_parts *parts, const format_choice *choice, spectrum_grid *grid) {
    netcdf_spectra *s;
    double hertz[SPECTRUM_MAX_FREQUENCIES], to[SPECTRUM_MAX_DIRECTIONS];
    bolan_result result = bolan_netcdf_spectra_open(&texts->density, layout, &s);
    if (!result) result = parts->frequencies(s, hertz);
    if (!result) result = parts->directions(s, to);
    if (!result) result = bolan_spectrum_grid_begin(grid, hertz, s->frequencies, to, s->directions);
    if (!result) result = parts->densities(s, choice, grid);
    bolan_netcdf_spectra_close(&s);
    return result;
}

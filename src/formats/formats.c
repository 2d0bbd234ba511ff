// SPDX-License-Identifier: MIT
// The table of formats, and the way from texts and options to one measured spectrum (format.h).
#include "formats/format.h"
#include "formats/netcdf.h"

#include <math.h>

const spectrum_format *const bolan_formats[] = {
    &bolan_format_swan,    &bolan_format_ww3,     &bolan_format_ndbc,        &bolan_format_triaxys,
    &bolan_format_octopus, &bolan_format_spotter, &bolan_format_datawell,    &bolan_format_ww3_netcdf,
    &bolan_format_era5,    &bolan_format_cdip,    &bolan_format_ndbc_netcdf, NULL};

bolan_spectrum_texts bolan_spectrum_texts_default(void) {
    const bolan_spectrum_texts texts = {.density = {.name = NULL}};
    return texts;
}

// NetCDF that is damaged, or holds something else.
static void refuse_netcdf(const bolan_spectrum_text *text) {
    netcdf_file file;
    if (bolan_netcdf_open(text, &file)) return;
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_SPECTRUM_UNKNOWN_FORMAT,
              "%s: NetCDF without wave spectra that are known; expected a variable efth (WAVEWATCH III), d2fd (ERA5), "
              "waveEnergyDensity (CDIP) or spectral_wave_density (NDBC)",
              file.name);
}

const spectrum_format *bolan_format_of(const bolan_spectrum_text *text) {
    for (int i = 0; bolan_formats[i]; i++)
        if (bolan_formats[i]->probe(text)) return bolan_formats[i];
    if (bolan_netcdf_is(text)) {
        refuse_netcdf(text);
        return NULL;
    }
    text_cursor cursor = bolan_text_open(text);
    text_word first;
    if (!bolan_text_next_word(&cursor, &first))
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_SPECTRUM_EMPTY, "%s: the text is empty; expected a spectrum", cursor.name);
    else
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_SPECTRUM_UNKNOWN_FORMAT,
                  "%s:%u: the format is not known; expected \"SWAN\", \"'WAVEWATCH III SPECTRA'\", \"YYYY MM DD hh\" "
                  "(NDBC history), \"#YY MM DD hh mm\" (NDBC real time), \"TRIAXYS BUOY\" or NetCDF at the start, or a "
                  "spectrum of Datawell (.spt), Spotter (JSON) or OCTOPUS",
                  cursor.name, (unsigned)first.line);
    return NULL;
}

bolan_result bolan_format_read_frequencies(text_cursor *text, double *hertz, uint32_t count) {
    for (uint32_t i = 0; i < count; i++) {
        text_word word;
        if (!bolan_text_next_word(text, &word)) return bolan_text_unexpected(text, NULL, "a frequency");
        if (!bolan_text_number(word, &hertz[i]) || (i > 0 && !(hertz[i] > hertz[i - 1])) ||
            !(hertz[i] >= SPECTRUM_MIN_HERTZ && hertz[i] <= SPECTRUM_MAX_HERTZ))
            return bolan_text_unexpected(text, &word, "an ascending frequency, 0.001 to 10 Hz");
    }
    return BOLAN_OK;
}

// ---- one record -----------------------------------------------------------------------------------------------------

bolan_result bolan_format_open(const bolan_spectrum_texts *texts, format_file *out) {
    *out = (format_file){.format = bolan_format_of(&texts->density), .texts = texts};
    out->name = texts->density.name ? texts->density.name : "spectrum";
    if (!out->format) return BOLAN_ERROR_FORMAT;
    const bolan_result result = out->format->records(texts, &out->records);
    if (!result) bolan_record_list_sort(&out->records);
    return result;
}

void bolan_format_close(format_file *file) { bolan_record_list_release(&file->records); }

bolan_result bolan_format_read(const format_file *file, const format_choice *choice,
                               const bolan_spectrum_options *options, spectrum_notes *notes, bool *own_directions,
                               bolan_measured_spectrum **out) {
    spectrum_grid grid = {.record_count = file->records.count, .notes = *notes};
    if (file->records.timed) bolan_record_date_print(&choice->record->date, file->records.style, grid.time);
    const location_list *places = choice->locations;
    if (places && choice->location < places->count)
        grid.place = (bolan_measured_place){true, places->spherical, places->entries[choice->location].x,
                                            places->entries[choice->location].y};
    bolan_result result = file->format->read(file->texts, choice, options, &grid);
    if (!result && grid.own_directions && (!isnan(options->from_deg) || !isnan(options->spread_s)))
        bolan_spectrum_note(&grid.notes, BOLAN_LOG_SPECTRUM_UNUSED,
                            "%s: has directions of its own; from and spread are not used", file->name);
    if (own_directions) *own_directions = grid.own_directions;
    if (!result) result = bolan_spectrum_measured_build(file->name, &grid, out);
    bolan_spectrum_grid_release(&grid);
    *notes = grid.notes;
    return result;
}

// One record at the location that the options choose.
static bolan_result read_record(const format_file *file, const record_entry *record,
                                const bolan_spectrum_options *options, spectrum_notes *notes,
                                bolan_measured_spectrum **out) {
    location_list locations = {.entries = NULL};
    format_choice choice = {.record = record, .locations = &locations};
    bolan_result result = file->format->locations(file->texts, record, &locations);
    if (!result) result = bolan_location_list_choose(&locations, file->name, options, notes, &choice.location);
    if (!result) result = bolan_format_read(file, &choice, options, notes, NULL, out);
    bolan_location_list_release(&locations);
    return result;
}

static bolan_result read_choice(const format_file *file, const record_choice *choice,
                                const bolan_spectrum_options *options, spectrum_notes *notes,
                                bolan_measured_spectrum **out) {
    bolan_result result = read_record(file, choice->first, options, notes, out);
    if (result || !choice->second) return result;
    bolan_measured_spectrum *second = NULL;
    spectrum_notes repeated = *notes; // the second record gives the notes of the first again: they are said once
    result = read_record(file, choice->second, options, &repeated, &second);
    if (!result) result = bolan_spectrum_measured_blend(file->name, *out, second, choice->share);
    if (!result) memcpy((*out)->time, choice->time, sizeof(*out)->time);
    bolan_measured_spectrum_destroy(&second);
    return result;
}

bolan_result bolan_measured_spectrum_parse(const bolan_spectrum_texts *texts, const bolan_spectrum_options *options,
                                           bolan_measured_spectrum **out) {
    BOLAN_ASSERT(texts && out);
    *out = NULL;
    const bolan_spectrum_options defaults = bolan_spectrum_options_default();
    if (!options) options = &defaults;
    if (bolan_spectrum_options_validate(options)) return BOLAN_ERROR_ARGUMENT;
    format_file file;
    record_choice choice;
    spectrum_notes notes = {.count = 0};
    bolan_result result = bolan_format_open(texts, &file);
    if (!result) result = bolan_record_list_choose(&file.records, file.name, options, &notes, &choice);
    if (!result) result = read_choice(&file, &choice, options, &notes, out);
    if (result) bolan_measured_spectrum_destroy(out);
    bolan_format_close(&file);
    if (!result) bolan_spectrum_notes_log(&notes);
    return result;
}

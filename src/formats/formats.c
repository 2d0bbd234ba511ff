// SPDX-License-Identifier: MIT
// The table of formats, and the way from texts and options to one measured spectrum (format.h).
#include "formats/format.h"

#include <math.h>

const spectrum_format *const bolan_formats[] = {&bolan_format_swan, &bolan_format_ww3, &bolan_format_ndbc, NULL};

bolan_spectrum_texts bolan_spectrum_texts_default(void) {
    const bolan_spectrum_texts texts = {.density = {.name = NULL}};
    return texts;
}

const spectrum_format *bolan_format_of(const bolan_spectrum_text *text) {
    for (int i = 0; bolan_formats[i]; i++)
        if (bolan_formats[i]->probe(text)) return bolan_formats[i];
    text_cursor cursor = bolan_text_open(text);
    text_word first;
    if (!bolan_text_next_word(&cursor, &first))
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_SPECTRUM_EMPTY,
                  "%s: the text is empty; expected a SWAN, WAVEWATCH III or NDBC spectrum", cursor.name);
    else
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_SPECTRUM_UNKNOWN_FORMAT,
                  "%s:%u: the format is not known; expected \"SWAN\", \"'WAVEWATCH III SPECTRA'\", "
                  "\"YYYY MM DD hh\" (NDBC history) or \"#YY MM DD hh mm\" (NDBC real time) at the start",
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

typedef struct reading {
    const spectrum_format *format;
    const bolan_spectrum_texts *texts;
    const bolan_spectrum_options *options;
    const char *name;
    record_list records;
    spectrum_notes notes;
} reading;

// One record at the location that the options choose.
static bolan_result read_record(reading *r, const record_entry *record, bolan_measured_spectrum **out) {
    location_list locations = {.entries = NULL};
    spectrum_grid grid = {.record_count = r->records.count, .notes = r->notes};
    format_choice choice = {.record = record, .locations = &locations};
    if (r->records.timed) bolan_record_date_print(&record->date, r->records.style, grid.time);
    bolan_result result = r->format->locations(r->texts, record, &locations);
    if (!result) result = bolan_location_list_choose(&locations, r->name, r->options, &grid.notes, &choice.location);
    if (!result) result = r->format->read(r->texts, &choice, r->options, &grid);
    if (!result && grid.own_directions && (!isnan(r->options->from_deg) || !isnan(r->options->spread_s)))
        bolan_spectrum_note(&grid.notes, BOLAN_LOG_SPECTRUM_UNUSED,
                            "%s: has directions of its own; from and spread are not used", r->name);
    if (!result) result = bolan_spectrum_measured_build(r->name, &grid, out);
    bolan_spectrum_grid_release(&grid);
    bolan_location_list_release(&locations);
    r->notes = grid.notes;
    return result;
}

// The second record gives the same notes as the first: what stands in is said once.
static bolan_result blend_second(reading *r, const record_choice *choice, bolan_measured_spectrum *first) {
    bolan_measured_spectrum *second = NULL;
    const spectrum_notes kept = r->notes;
    bolan_result result = read_record(r, choice->second, &second);
    r->notes = kept;
    if (!result) result = bolan_spectrum_measured_blend(r->name, first, second, choice->share);
    bolan_measured_spectrum_destroy(&second);
    if (!result) memcpy(first->time, choice->time, sizeof first->time);
    return result;
}

static bolan_result read_all(reading *r, bolan_measured_spectrum **out) {
    record_choice choice;
    bolan_result result = r->format->records(r->texts, &r->records);
    if (result) return result;
    bolan_record_list_sort(&r->records);
    result = bolan_record_list_choose(&r->records, r->name, r->options, &r->notes, &choice);
    if (!result) result = read_record(r, choice.first, out);
    if (!result && choice.second) result = blend_second(r, &choice, *out);
    if (result) bolan_measured_spectrum_destroy(out);
    return result;
}

bolan_result bolan_measured_spectrum_parse(const bolan_spectrum_texts *texts, const bolan_spectrum_options *options,
                                           bolan_measured_spectrum **out) {
    BOLAN_ASSERT(texts && out);
    *out = NULL;
    const bolan_spectrum_options defaults = bolan_spectrum_options_default();
    if (!options) options = &defaults;
    if (bolan_spectrum_options_validate(options)) return BOLAN_ERROR_ARGUMENT;
    reading r = {.format = bolan_format_of(&texts->density), .texts = texts, .options = options};
    if (!r.format) return BOLAN_ERROR_FORMAT;
    r.name = texts->density.name ? texts->density.name : "spectrum";
    const bolan_result result = read_all(&r, out);
    bolan_record_list_release(&r.records);
    if (!result) bolan_spectrum_notes_log(&r.notes);
    return result;
}

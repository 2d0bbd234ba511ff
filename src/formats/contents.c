// SPDX-License-Identifier: MIT
// What a file of spectra holds: its records and locations, the grid, and the range of heights and periods.
#include "base/hooks.h"
#include "formats/format.h"

#include "bolan/math.h"

#include <math.h>
#include <string.h>

enum { MOST_READ = 512 };

// One allocation: this, then the records, then the places.
typedef struct contents_block {
    bolan_spectrum_contents contents; // first: its address is the block's
    size_t bytes;
} contents_block;

static bolan_result allocate(const record_list *records, const location_list *places, contents_block **out) {
    const size_t head = (sizeof(contents_block) + 15) / 16 * 16;
    const size_t record_bytes = records->count * sizeof(bolan_spectrum_record);
    const size_t bytes = head + record_bytes + places->count * sizeof(bolan_spectrum_place);
    contents_block *block = bolan_allocate(bytes);
    *out = block;
    if (!block) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY,
                  "the contents of a spectrum file need %zu bytes, which could not be allocated", bytes);
        return BOLAN_ERROR_MEMORY;
    }
    block->bytes = bytes;
    block->contents.records = (const void *)((char *)block + head);
    block->contents.places = (const void *)((char *)block + head + record_bytes);
    return BOLAN_OK;
}

static void copy_lists(const format_file *file, const location_list *places, contents_block *block) {
    bolan_spectrum_contents *c = &block->contents;
    bolan_spectrum_record *records = (bolan_spectrum_record *)c->records;
    c->format = file->format->name;
    c->title = file->format->title;
    c->record_count = file->records.count;
    c->place_count = places->count;
    c->spherical = places->spherical;
    for (uint32_t i = 0; i < c->record_count; i++) {
        const record_entry *entry = &file->records.entries[i];
        records[i] = (bolan_spectrum_record){.seconds = (double)NAN};
        if (!file->records.timed) continue;
        records[i].seconds = (double)entry->seconds;
        bolan_record_date_print(&entry->date, file->records.style, records[i].time);
    }
    if (places->count > 0) memcpy((void *)c->places, places->entries, places->count * sizeof *places->entries);
}

// The ranges take in one spectrum.
static void widen(bolan_spectrum_contents *c, const bolan_measured_spectrum *spectrum, bool own_directions, bool none) {
    const bolan_measured_view view = bolan_measured_spectrum_view(spectrum);
    bolan_sea_state sea_state = bolan_sea_state_default();
    sea_state.measured = spectrum;
    const bolan_sea_summary s = bolan_sea_state_summary(&sea_state);
    if (c->frequency_count == 0) {
        c->frequency_count = view.frequency_count;
        c->direction_count = own_directions ? view.direction_count : 0;
        c->has_moments = !own_directions && !none;
        c->lowest_hertz = view.omega[0] / (2.0 * BOLAN_PI);
        c->highest_hertz = view.omega[view.frequency_count - 1] / (2.0 * BOLAN_PI);
        c->hs_min = s.hs;
    }
    c->hs_min = fmin(c->hs_min, s.hs);
    c->hs_max = fmax(c->hs_max, s.hs);
    if (!(s.tp > 0.0)) return;
    c->tp_min = c->tp_max > 0.0 ? fmin(c->tp_min, s.tp) : s.tp;
    c->tp_max = fmax(c->tp_max, s.tp);
}

// The locations of the record that was read last: a record may have thousands.
typedef struct known_places {
    const record_entry *record;
    location_list list;
} known_places;

static bolan_result list_places(const format_file *file, const record_entry *record, known_places *known) {
    if (known->record == record) return BOLAN_OK;
    bolan_location_list_release(&known->list);
    known->record = NULL;
    const bolan_result result = file->format->locations(file->texts, record, &known->list);
    if (!result) known->record = record;
    return result;
}

// Spectrum number @p i of all records and locations.
static bolan_result read_number(const format_file *file, uint64_t i, uint32_t places_of_first,
                                const bolan_spectrum_options *options, known_places *known,
                                bolan_spectrum_contents *c) {
    format_choice choice = {.record = &file->records.entries[i / places_of_first], .locations = &known->list};
    bolan_measured_spectrum *spectrum = NULL;
    spectrum_notes notes = {.count = 0};
    bool own_directions = false;
    bolan_result result = list_places(file, choice.record, known);
    choice.location = (uint32_t)(i % places_of_first);
    if (!result && choice.location > 0 && choice.location >= known->list.count) result = BOLAN_ERROR_FORMAT;
    if (!result) result = bolan_format_read(file, &choice, options, &notes, &own_directions, &spectrum);
    bool none = false; // no directions, so that a default stood in
    for (uint32_t n = 0; n < notes.count; n++) none |= notes.note[n].id == BOLAN_LOG_SPECTRUM_NO_DIRECTIONS;
    if (!result) widen(c, spectrum, own_directions, none);
    bolan_measured_spectrum_destroy(&spectrum);
    return result;
}

// A trial that fails counts and is silent: land among the locations, a record that is cut off. Only where all fail does
// the first one say why.
static bolan_result read_range(const format_file *file, bolan_spectrum_contents *c) {
    bolan_spectrum_options options = bolan_spectrum_options_default();
    const uint32_t places = c->place_count ? c->place_count : 1;
    const uint64_t all = (uint64_t)c->record_count * places, count = all < MOST_READ ? all : MOST_READ;
    known_places known = {.record = NULL};
    bolan_result result = BOLAN_OK;
    bolan_log_mute(true);
    for (uint64_t k = 0; k < count && result != BOLAN_ERROR_MEMORY; k++) {
        result = read_number(file, k * all / count, places, &options, &known, c);
        c->read_count++;
        c->unreadable_count += result != BOLAN_OK;
    }
    bolan_log_mute(false);
    if (result == BOLAN_ERROR_MEMORY) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY, "%s: no memory to read its spectra", file->name);
    } else {
        result = c->unreadable_count < c->read_count ? BOLAN_OK : read_number(file, 0, places, &options, &known, c);
    }
    bolan_location_list_release(&known.list);
    return result;
}

bolan_result bolan_spectrum_contents_parse(const bolan_spectrum_texts *texts, bolan_spectrum_contents **out) {
    BOLAN_ASSERT(texts && out);
    *out = NULL;
    format_file file;
    location_list places = {.entries = NULL};
    contents_block *block = NULL;
    bolan_result result = bolan_format_open(texts, &file);
    if (!result) result = file.format->locations(texts, &file.records.entries[0], &places);
    if (!result) result = allocate(&file.records, &places, &block);
    if (!result) copy_lists(&file, &places, block);
    if (!result) result = read_range(&file, &block->contents);
    bolan_location_list_release(&places);
    bolan_format_close(&file);
    *out = block ? &block->contents : NULL;
    if (result) bolan_spectrum_contents_destroy(out);
    return result;
}

void bolan_spectrum_contents_destroy(bolan_spectrum_contents **contents) {
    if (!contents || !*contents) return;
    contents_block *block = (contents_block *)(void *)*contents;
    bolan_release(block, block->bytes);
    *contents = NULL;
}

// SPDX-License-Identifier: MIT
// See notes.h.
#include "spectrum/notes.h"

#include <stdarg.h>
#include <stdio.h>

static void keep(spectrum_notes *notes, bolan_log_level level, bolan_log_id id, const char *format, va_list arguments) {
    char sentence[NOTE_SIZE], *out = notes->count < NOTES_MAX ? notes->note[notes->count].sentence : sentence;
    vsnprintf(out, NOTE_SIZE, format, arguments);
    if (out == sentence) {
        bolan_log(level, id, "%s", sentence);
        return;
    }
    notes->note[notes->count].level = level;
    notes->note[notes->count++].id = id;
}

void bolan_spectrum_note(spectrum_notes *notes, bolan_log_id id, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    keep(notes, BOLAN_LOG_WARNING, id, format, arguments);
    va_end(arguments);
}

void bolan_spectrum_note_level(spectrum_notes *notes, bolan_log_level level, bolan_log_id id, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    keep(notes, level, id, format, arguments);
    va_end(arguments);
}

void bolan_spectrum_notes_log(const spectrum_notes *notes) {
    for (uint32_t i = 0; i < notes->count; i++)
        bolan_log(notes->note[i].level, notes->note[i].id, "%s", notes->note[i].sentence);
}

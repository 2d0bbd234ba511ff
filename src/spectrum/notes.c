// SPDX-License-Identifier: MIT
// See notes.h.
#include "spectrum/notes.h"

#include <stdarg.h>
#include <stdio.h>

void bolan_spectrum_note(spectrum_notes *notes, bolan_log_id id, const char *format, ...) {
    char sentence[NOTE_SIZE], *out = notes->count < NOTES_MAX ? notes->note[notes->count].sentence : sentence;
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(out, NOTE_SIZE, format, arguments);
    va_end(arguments);
    if (out == sentence)
        bolan_log(BOLAN_LOG_WARNING, id, "%s", sentence);
    else
        notes->note[notes->count++].id = id;
}

void bolan_spectrum_notes_log(const spectrum_notes *notes) {
    for (uint32_t i = 0; i < notes->count; i++)
        bolan_log(BOLAN_LOG_WARNING, notes->note[i].id, "%s", notes->note[i].sentence);
}

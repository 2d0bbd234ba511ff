// SPDX-License-Identifier: MIT
/// @file notes.h
/// Messages that are kept until the whole call has succeeded: a text that is refused gets one sentence, not two.
/// Private to the library.
#ifndef BOLAN_SPECTRUM_NOTES_H
#define BOLAN_SPECTRUM_NOTES_H

#include "bolan/base.h"

enum { NOTES_MAX = 8, NOTE_SIZE = 480 };

typedef struct spectrum_notes {
    uint32_t count;
    struct {
        bolan_log_level level;
        bolan_log_id id;
        char sentence[NOTE_SIZE];
    } note[NOTES_MAX];
} spectrum_notes;

/// Keeps one warning (printf style). More than NOTES_MAX are logged at once.
#if defined(__GNUC__)
__attribute__((format(printf, 3, 4)))
#endif
void bolan_spectrum_note(spectrum_notes *notes, bolan_log_id id, const char *format, ...);
/// The same for a message of another level.
#if defined(__GNUC__)
__attribute__((format(printf, 4, 5)))
#endif
void bolan_spectrum_note_level(spectrum_notes *notes, bolan_log_level level, bolan_log_id id, const char *format, ...);
/// Logs the warnings that are kept.
void bolan_spectrum_notes_log(const spectrum_notes *notes);

#endif

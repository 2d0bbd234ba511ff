// SPDX-License-Identifier: MIT
/// @file film_check.h
/// Checks by its container that a film is complete. Private to src/io.
#ifndef BOLAN_IO_FILM_CHECK_H
#define BOLAN_IO_FILM_CHECK_H

#include <stdbool.h>

/// NULL for a finished film; otherwise what is wrong with it, as the end of a sentence. @p webm: else it is an MP4.
const char *bolan_film_check(const char *path, bool webm);

#endif

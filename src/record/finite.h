// SPDX-License-Identifier: MIT
/// @file finite.h
/// The refusal of records with gaps. Private to src/record.
#ifndef BOLAN_RECORD_FINITE_H
#define BOLAN_RECORD_FINITE_H

#include "bolan/base.h"

#include <math.h>

/// True where every sample of @p x, which is @p what, is a number; otherwise a sentence names the first that is not.
static inline bool record_is_finite(const char *what, const float *x, uint32_t count) {
    for (uint32_t i = 0; i < count; i++) {
        if (isfinite(x[i])) continue;
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_NOT_FINITE, "%s of a record, sample %u, is %g; expected a finite number",
                  what, (unsigned)i, (double)x[i]);
        return false;
    }
    return true;
}

#endif

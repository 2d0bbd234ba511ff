// SPDX-License-Identifier: MIT
// The checks of a sea's desc: one sentence for the first field that is wrong.
#include "waves/sea.h"

static bool in_range(const char *field, double value, double low, double high, const char *unit) {
    if (value >= low && value <= high) return true; // false for what is not a number
    bolan_log(BOLAN_LOG_ERROR, isfinite(value) ? BOLAN_LOG_OUT_OF_RANGE : BOLAN_LOG_NOT_FINITE,
              "bolan_sea_desc.%s is %g%s; expected %g to %g", field, value, unit, low, high);
    return false;
}

static bool resolution_is_valid(uint32_t n) {
    if (n >= FFT_MIN && n <= FFT_MAX && (n & (n - 1)) == 0) return true;
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_RANGE,
              "bolan_sea_desc.resolution is %u; expected a power of two from %d to %d", n, FFT_MIN, FFT_MAX);
    return false;
}

static bool kinds_are_valid(const bolan_sea_desc *desc) {
    if (desc->waves != BOLAN_WAVES_FFT) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_BAD_ARGUMENT, "bolan_sea_desc.waves is %d; expected BOLAN_WAVES_FFT (%d)",
                  (int)desc->waves, (int)BOLAN_WAVES_FFT);
        return false;
    }
    if ((int)desc->cpu < (int)BOLAN_CPU_AUTO || desc->cpu > BOLAN_CPU_AVX512) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_BAD_ARGUMENT,
                  "bolan_sea_desc.cpu is %d; expected a bolan_cpu from %d to %d", (int)desc->cpu, (int)BOLAN_CPU_AUTO,
                  (int)BOLAN_CPU_AVX512);
        return false;
    }
    return true;
}

bolan_result sea_validate(const bolan_sea_desc *desc) {
    const bool valid = kinds_are_valid(desc) && resolution_is_valid(desc->resolution) &&
                       in_range("cascade_count", desc->cascade_count, 1.0, BOLAN_MAX_CASCADES, "") &&
                       (desc->length == 0.0 || in_range("length", desc->length, 10.0, 1e5, " m")) &&
                       in_range("choppiness", desc->choppiness, 0.0, 2.0, "") &&
                       (desc->loop_period == 0.0 || in_range("loop_period", desc->loop_period, 10.0, 1e6, " s")) &&
                       in_range("foam_decay", desc->foam_decay, 0.1, 60.0, " s");
    return valid ? bolan_sea_state_validate(&desc->sea_state) : BOLAN_ERROR_ARGUMENT;
}

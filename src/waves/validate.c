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
    if ((int)desc->waves < 0 || desc->waves >= BOLAN_WAVE_MODELS) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_BAD_ARGUMENT,
                  "bolan_sea_desc.waves is %d; expected a bolan_wave_model from 0 to %d", (int)desc->waves,
                  BOLAN_WAVE_MODELS - 1);
        return false;
    }
    if (desc->cosines.split != BOLAN_SPLIT_EQUAL_ENERGY && desc->cosines.split != BOLAN_SPLIT_EQUAL_WIDTH) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_BAD_ARGUMENT,
                  "bolan_sea_desc.cosines.split is %d; expected a bolan_frequency_split, 0 or 1",
                  (int)desc->cosines.split);
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

static bool sums_are_valid(const bolan_sea_desc *desc) {
    return in_range("cosines.frequencies", desc->cosines.frequencies, 1.0, BOLAN_MAX_FREQUENCIES, "") &&
           in_range("cosines.directions", desc->cosines.directions, 1.0, BOLAN_MAX_DIRECTIONS, "") &&
           in_range("exp_cosine.wave_count", desc->exp_cosine.wave_count, 1.0, BOLAN_MAX_EXP_WAVES, "") &&
           in_range("exp_cosine.sharpness", desc->exp_cosine.sharpness, 0.01, 2.0, "") &&
           in_range("current_x", desc->current_x, -5.0, 5.0, " m/s") &&
           in_range("current_y", desc->current_y, -5.0, 5.0, " m/s");
}

bolan_result bolan_sea_validate(const bolan_sea_desc *desc) {
    const bool valid =
        kinds_are_valid(desc) && resolution_is_valid(desc->resolution) &&
        in_range("fft.cascade_count", desc->fft.cascade_count, 1.0, BOLAN_MAX_CASCADES, "") &&
        (desc->length == 0.0 || in_range("length", desc->length, 10.0, 1e5, " m")) &&
        in_range("choppiness", desc->choppiness, 0.0, 2.0, "") &&
        (desc->loop_period == 0.0 || in_range("loop_period", desc->loop_period, 10.0, 1e6, " s")) &&
        (desc->textures.period == 0.0 || in_range("textures.period", desc->textures.period, 1.0, 1e6, " s")) &&
        in_range("textures.frames", desc->textures.frames, 2.0, BOLAN_MAX_LOOP_FRAMES, "") && sums_are_valid(desc) &&
        in_range("foam_decay", desc->foam_decay, 0.1, 60.0, " s");
    return valid ? bolan_sea_state_validate(&desc->sea_state) : BOLAN_ERROR_ARGUMENT;
}

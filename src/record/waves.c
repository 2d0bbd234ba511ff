// SPDX-License-Identifier: MIT
// Waves of a record between zero-up-crossings, and their statistics (IAHR 1989, List of sea-state parameters).
#include "bolan/record.h"

#include "record/finite.h"

#include <string.h>

static double mean_of(const float *x, uint32_t count) {
    double sum = 0.0;
    for (uint32_t i = 0; i < count; i++) sum += (double)x[i];
    return sum / count;
}

uint32_t bolan_record_waves(const float *heave, uint32_t count, double rate, uint32_t capacity,
                            bolan_record_wave *out) {
    BOLAN_ASSERT((heave || count == 0) && rate > 0.0 && (out || capacity == 0));
    if (count < 2) return 0;
    const double mean = mean_of(heave, count);
    double high = 0.0, low = 0.0, begin = -1.0;
    uint32_t waves = 0;
    for (uint32_t i = 1; i < count; i++) {
        const double before = (double)heave[i - 1] - mean, here = (double)heave[i] - mean;
        if (before < 0.0 && here >= 0.0) {
            const double time = (i - here / (here - before)) / rate;
            if (begin >= 0.0 && waves++ < capacity)
                out[waves - 1] = (bolan_record_wave){.height = high - low, .period = time - begin, .crest = high};
            begin = time;
            high = low = here;
        }
        high = here > high ? here : high;
        low = here < low ? here : low;
    }
    return waves;
}

double bolan_record_exceedance(const bolan_record_wave *waves, uint32_t count, double height) {
    BOLAN_ASSERT(waves || count == 0);
    uint32_t higher = 0;
    for (uint32_t i = 0; i < count; i++) higher += waves[i].height > height;
    return count > 0 ? (double)higher / count : 0.0;
}

// Sorts by height, the highest first (Williams 1964, heapsort), in place.
static void sift(bolan_record_wave *w, uint32_t root, uint32_t count) {
    for (uint32_t child; (child = 2 * root + 1) < count; root = child) {
        if (child + 1 < count && w[child + 1].height < w[child].height) child++;
        if (w[root].height <= w[child].height) return;
        const bolan_record_wave t = w[root];
        w[root] = w[child];
        w[child] = t;
    }
}

static void sort_descending(bolan_record_wave *w, uint32_t count) {
    for (uint32_t i = count / 2; i-- > 0;) sift(w, i, count);
    for (uint32_t end = count; end-- > 1;) {
        const bolan_record_wave t = w[0];
        w[0] = w[end];
        w[end] = t;
        sift(w, 0, end);
    }
}

static double mean_height(const bolan_record_wave *w, uint32_t count) {
    double sum = 0.0;
    for (uint32_t i = 0; i < count; i++) sum += w[i].height;
    return count > 0 ? sum / count : 0.0;
}

static double mean_period(const bolan_record_wave *w, uint32_t count) {
    double sum = 0.0;
    for (uint32_t i = 0; i < count; i++) sum += w[i].period;
    return count > 0 ? sum / count : 0.0;
}

static void measure_samples(const float *heave, uint32_t count, bolan_record_statistics *out) {
    double m2 = 0.0, m3 = 0.0, m4 = 0.0;
    out->mean = mean_of(heave, count);
    for (uint32_t i = 0; i < count; i++) {
        const double x = (double)heave[i] - out->mean;
        m2 += x * x, m3 += x * x * x, m4 += x * x * x * x;
    }
    m2 /= count, m3 /= count, m4 /= count;
    out->hm0 = 4.0 * sqrt(m2);
    out->skewness = m2 > 0.0 ? m3 / (m2 * sqrt(m2)) : 0.0;
    out->kurtosis = m2 > 0.0 ? m4 / (m2 * m2) : 3.0;
}

static void measure_waves(bolan_record_wave *w, uint32_t count, bolan_record_statistics *out) {
    const uint32_t third = (count + 2) / 3, tenth = (count + 9) / 10; // at least one
    for (uint32_t i = 0; i < count; i++) out->crest_max = fmax(out->crest_max, w[i].crest);
    out->tz = mean_period(w, count);
    sort_descending(w, count);
    out->waves = count;
    out->h_mean = mean_height(w, count);
    out->h_third = mean_height(w, third);
    out->h_tenth = mean_height(w, tenth);
    out->h_max = count > 0 ? w[0].height : 0.0;
    out->t_third = mean_period(w, third);
}

bolan_result bolan_record_measure(const float *heave, uint32_t count, double rate, bolan_record_statistics *out) {
    BOLAN_ASSERT(heave && out);
    *out = (bolan_record_statistics){.kurtosis = 3.0};
    if (count < 2 || !(rate > 0.0) || isinf(rate)) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_BAD_ARGUMENT,
                  "a record has %u samples at %g a second; expected at least 2 at a positive rate", (unsigned)count,
                  rate);
        return BOLAN_ERROR_ARGUMENT;
    }
    if (!record_is_finite("heave", heave, count)) return BOLAN_ERROR_ARGUMENT;
    measure_samples(heave, count, out);
    const uint32_t waves = bolan_record_waves(heave, count, rate, 0, NULL);
    if (waves == 0) return BOLAN_OK;
    bolan_record_wave *w = bolan_allocate(waves * sizeof *w);
    if (!w) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY, "no memory for the %u waves of a record", (unsigned)waves);
        return BOLAN_ERROR_MEMORY;
    }
    bolan_record_waves(heave, count, rate, waves, w);
    measure_waves(w, waves, out);
    bolan_release(w, waves * sizeof *w);
    return BOLAN_OK;
}

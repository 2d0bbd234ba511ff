// SPDX-License-Identifier: MIT
// Directional spectra of a buoy's displacements: Welch 1967, and Longuet-Higgins, Cartwright & Smith 1963.
//
// With heave z = a cos(k.x - wt) a parcel moves by -k/|k| a sin(k.x - wt): a quarter period after z along the waves. So
// with cross-spectra C + iQ of z and the displacement, Q is positive where waves go.
#include "bolan/record.h"

#include "record/finite.h"
#include "spectrum/portable.h"

enum { LEAST_SEGMENT = 16, MOST_SEGMENT = 4096, CHANNELS = 3 };

typedef struct estimate {
    uint32_t segment;
    double *window, *sine; // of the segment's length; sine over one turn
    double *x[CHANNELS];   // a segment of each channel
    double (*sum)[6];      // by band: zz, xx + yy, xx - yy, xy, z quadrature x, z quadrature y
} estimate;

// The transform of one channel at band k.
static void transform(const estimate *e, const double *x, uint32_t k, double *re, double *im) {
    double c = 0.0, s = 0.0;
    uint32_t phase = 0, quarter = e->segment / 4;
    for (uint32_t i = 0; i < e->segment; i++) {
        const uint32_t ahead = phase + quarter < e->segment ? phase + quarter : phase + quarter - e->segment;
        c += x[i] * e->sine[ahead];
        s -= x[i] * e->sine[phase];
        phase += k;
        if (phase >= e->segment) phase -= e->segment;
    }
    *re = c;
    *im = s;
}

static void load(const estimate *e, const float *from, double *to) {
    double mean = 0.0;
    for (uint32_t i = 0; i < e->segment; i++) mean += (double)from[i] / e->segment;
    for (uint32_t i = 0; i < e->segment; i++) to[i] = ((double)from[i] - mean) * e->window[i];
}

static void add_segment(const estimate *e, uint32_t channels) {
    for (uint32_t k = 1; k < e->segment / 2; k++) {
        double re[CHANNELS] = {0.0}, im[CHANNELS] = {0.0}, *sum = e->sum[k - 1];
        for (uint32_t c = 0; c < channels; c++) transform(e, e->x[c], k, &re[c], &im[c]);
        const double xx = re[1] * re[1] + im[1] * im[1], yy = re[2] * re[2] + im[2] * im[2];
        sum[0] += re[0] * re[0] + im[0] * im[0];
        sum[1] += xx + yy;
        sum[2] += xx - yy;
        sum[3] += re[1] * re[2] + im[1] * im[2];
        sum[4] += im[0] * re[1] - re[0] * im[1];
        sum[5] += im[0] * re[2] - re[0] * im[2];
    }
}

static bolan_record_band band_of(const double *sum, double frequency, double scale) {
    bolan_record_band b = {.frequency = frequency, .density = scale * sum[0]};
    const double product = sqrt(sum[0] * sum[1]);
    if (!(product > 0.0)) return b;
    b.a1 = sum[4] / product;
    b.b1 = sum[5] / product;
    b.a2 = sum[2] / sum[1];
    b.b2 = 2.0 * sum[3] / sum[1];
    b.direction_from = bolan_math_to_compass_from(portable_angle(b.b1, b.a1));
    b.spread = bolan_degrees(sqrt(2.0 * fmax(1.0 - sqrt(b.a1 * b.a1 + b.b1 * b.b1), 0.0)));
    return b;
}

// A Hann window; its mean square is 3/8.
static void set_tables(estimate *e) {
    for (uint32_t i = 0; i < e->segment; i++) {
        double c;
        bolan_sincos(2.0 * BOLAN_PI * i / e->segment, &e->sine[i], &c);
        e->window[i] = 0.5 - 0.5 * c;
    }
}

static bolan_result check(uint32_t count, double rate, uint32_t segment) {
    const bool good = segment >= LEAST_SEGMENT && segment <= MOST_SEGMENT && segment % 4 == 0 && segment <= count;
    if (good && rate > 0.0 && !isinf(rate)) return BOLAN_OK;
    bolan_log(
        BOLAN_LOG_ERROR, BOLAN_LOG_BAD_ARGUMENT,
        "segments of %u samples of a record of %u at %g a second; expected a multiple of 4 from %d to %d, at most the "
        "record, and a positive rate",
        (unsigned)segment, (unsigned)count, rate, LEAST_SEGMENT, MOST_SEGMENT);
    return BOLAN_ERROR_ARGUMENT;
}

bolan_result bolan_record_spectrum(const float *heave, const float *east, const float *north, uint32_t count,
                                   double rate, uint32_t segment, bolan_record_band *out) {
    BOLAN_ASSERT(heave && out && (east != NULL) == (north != NULL));
    const bolan_result valid = check(count, rate, segment);
    if (valid) return valid;
    if (!record_is_finite("heave", heave, count) ||
        (east && (!record_is_finite("east", east, count) || !record_is_finite("north", north, count))))
        return BOLAN_ERROR_ARGUMENT;
    const size_t floats = (size_t)segment * (2 + CHANNELS), bytes = (floats + (size_t)segment * 3) * sizeof(double);
    double *memory = bolan_allocate(bytes);
    if (!memory) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY, "no memory for a spectrum of %u bands",
                  (unsigned)segment / 2);
        return BOLAN_ERROR_MEMORY;
    }
    estimate e = {.segment = segment, .window = memory, .sine = memory + segment};
    for (uint32_t c = 0; c < CHANNELS; c++) e.x[c] = memory + (size_t)segment * (2 + c);
    e.sum = (double(*)[6])(void *)(memory + floats);
    set_tables(&e);
    const float *channel[CHANNELS] = {heave, east, north};
    uint32_t segments = 0;
    for (uint32_t first = 0; first + segment <= count; first += segment / 2, segments++) {
        for (uint32_t c = 0; c < (east ? CHANNELS : 1u); c++) load(&e, channel[c] + first, e.x[c]);
        add_segment(&e, east ? CHANNELS : 1u);
    }
    const double scale = 2.0 / (0.375 * segment * rate * segments);
    for (uint32_t k = 1; k < segment / 2; k++) out[k - 1] = band_of(e.sum[k - 1], k * rate / segment, scale);
    bolan_release(memory, bytes);
    return BOLAN_OK;
}

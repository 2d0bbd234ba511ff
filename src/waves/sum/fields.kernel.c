// SPDX-License-Identifier: MIT
// The fields of a sum at 16 points, all waves. See sum.h for the arithmetic and its cost.
#include "fft/wide.h"
#include "math/sincos.h"
#include "waves/sum/sum.h"

void KERNEL(bolan_sum_fields)(const sum_tables *tables, const double *x, const double *y, const float *fade,
                              float out[SEA_FIELDS][SUM_LANES]);

// WIDE doubles are two registers.
#if WIDE == 1
typedef struct wide_double {
    double v;
} wide_double;
typedef uint32_t wide_uint;
static inline wide_double double_load(const double *p) { return (wide_double){*p}; }
static inline wide_double turns_of(wide_double x, wide_double y, const sum_wave *w) {
    return (wide_double){(x.v * w->tx + y.v * w->ty) + w->base};
}
static inline wide_uint fraction_bits(wide_double t) {
    uint64_t bits;
    memcpy(&bits, &t.v, sizeof bits);
    return (uint32_t)bits << 6;
}
static inline wide wide_of_int(wide_int v) { return (float)v; }
#else
typedef double half_double __attribute__((vector_size(4 * WIDE), may_alias));
typedef uint32_t wide_uint __attribute__((vector_size(4 * WIDE), may_alias));
typedef struct wide_double {
    half_double low, high;
} wide_double;
static inline wide_double double_load(const double *p) {
    wide_double d;
    memcpy(&d.low, p, sizeof d.low);
    memcpy(&d.high, p + WIDE / 2, sizeof d.high);
    return d;
}
static inline wide_double turns_of(wide_double x, wide_double y, const sum_wave *w) {
    return (wide_double){(x.low * w->tx + y.low * w->ty) + w->base, (x.high * w->tx + y.high * w->ty) + w->base};
}
#if WIDE == 16
#define LOW_WORDS 0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28, 30
#elif WIDE == 8
#define LOW_WORDS 0, 2, 4, 6, 8, 10, 12, 14
#else
#define LOW_WORDS 0, 2, 4, 6
#endif
static inline wide_uint fraction_bits(wide_double t) {
    return (wide_uint)WIDE_SHUFFLE((wide_int)t.low, (wide_int)t.high, LOW_WORDS) << 6;
}
static inline wide wide_of_int(wide_int v) { return __builtin_convertvector(v, wide); }
#endif

static inline wide wide_splat(float v) { return (wide){0} + v; }

// Sine and cosine of 2 pi bits / 2^32: the quarter turn nearest to it, and what is left, -pi/4..pi/4.
static inline void sincos_of_bits(wide_uint bits, wide *sine, wide *cosine) {
    const wide_uint quadrant = (bits + 0x20000000u) >> 30;
    const wide r = wide_of_int((wide_int)(bits - (quadrant << 30))) * 0x1.921fb6p-30f; // pi/2 / 2^30
    const wide z = r * r;
    const wide_uint s = (wide_uint)wide_bits(BOLAN_SINF_REDUCED(r, z)), c = (wide_uint)wide_bits(BOLAN_COSF_REDUCED(z));
    const wide_uint odd = 0u - (quadrant & 1u), crossed = (s ^ c) & odd;
    *sine = wide_from_bits((wide_int)((s ^ crossed) ^ ((quadrant & 2u) << 30)));
    *cosine = wide_from_bits((wide_int)((c ^ crossed) ^ (((quadrant + 1u) & 2u) << 30)));
}

// e^y, |y| <= 1/4: Taylor's series to a float's last bit.
static inline wide exp_small(wide y) {
    wide e = y * (1.0f / 720) + 1.0f / 120;
    e = e * y + 1.0f / 24;
    e = e * y + 1.0f / 6;
    e = e * y + 0.5f;
    e = e * y + 1.0f;
    return e * y + 1.0f;
}

static inline wide exp_8(wide y) { // e^{8y}
    const wide e = exp_small(y), e2 = e * e, e4 = e2 * e2;
    return e4 * e4;
}

// 0 for a wave of two spacings, 1 from four on.
static inline wide faded(wide fade, float length) {
    const wide t = wide_max(fade * length - 1.0f, wide_splat(0.0f));
    const wide u = -wide_max(-t, wide_splat(-1.0f));
    return u * u * (3.0f - 2.0f * u);
}

typedef struct wide_sums {
    wide field[SEA_FIELDS];
} wide_sums;

static inline void add_cosine(const sum_wave *w, wide sine, wide cosine, wide_sums *sums) {
    sums->field[FIELD_HEIGHT] += cosine * w->factor[FIELD_HEIGHT];
    sums->field[FIELD_DX] += sine * w->factor[FIELD_DX];
    sums->field[FIELD_DY] += sine * w->factor[FIELD_DY];
    sums->field[FIELD_SLOPE_X] += sine * w->factor[FIELD_SLOPE_X];
    sums->field[FIELD_SLOPE_Y] += sine * w->factor[FIELD_SLOPE_Y];
    sums->field[FIELD_DXX] += cosine * w->factor[FIELD_DXX];
    sums->field[FIELD_DYY] += cosine * w->factor[FIELD_DYY];
    sums->field[FIELD_DXY] += cosine * w->factor[FIELD_DXY];
}

static inline void add_exponential(const sum_tables *t, const sum_wave *w, wide weight, wide sine, wide cosine,
                                   wide_sums *sums) {
    const wide e = exp_8(cosine * t->sharpness_8th), steep = e * sine * weight;
    sums->field[FIELD_HEIGHT] += (e - t->mean) * weight * w->factor[FIELD_HEIGHT];
    sums->field[FIELD_SLOPE_X] += steep * w->factor[FIELD_SLOPE_X];
    sums->field[FIELD_SLOPE_Y] += steep * w->factor[FIELD_SLOPE_Y];
}

// Waves [begin, end) at the WIDE points of one register; `fades` false: each at its full height.
static inline void add_waves(const sum_tables *t, uint32_t begin, uint32_t end, bool fades, bool exponential,
                             wide_double x, wide_double y, wide fade, wide_sums *sums) {
    for (uint32_t i = begin; i < end; i++) {
        const sum_wave *w = &t->wave[i];
        const wide weight = fades ? faded(fade, w->length) : wide_splat(1.0f);
        wide sine, cosine;
        sincos_of_bits(fraction_bits(turns_of(x, y, w)), &sine, &cosine);
        if (exponential) {
            add_exponential(t, w, weight, sine, cosine, sums);
        } else if (fades) {
            add_cosine(w, sine * weight, cosine * weight, sums);
        } else {
            add_cosine(w, sine, cosine, sums);
        }
    }
}

// Waves are sorted by length: first the waves that no lane fades, then those that some lanes fade; the rest is 0.
static void wave_limits(const sum_tables *t, const float *fade, uint32_t *full, uint32_t *last) {
    *full = *last = t->count;
    if (!fade) return;
    float finest = fade[0], coarsest = fade[0];
    for (int l = 1; l < SUM_LANES; l++) {
        finest = fade[l] > finest ? fade[l] : finest;
        coarsest = fade[l] < coarsest ? fade[l] : coarsest;
    }
    while (*last > 0 && !(finest * t->wave[*last - 1].length - 1.0f > 0.0f)) --*last;
    for (*full = *last; *full > 0 && coarsest * t->wave[*full - 1].length - 1.0f < 1.0f;) --*full;
}

void KERNEL(bolan_sum_fields)(const sum_tables *t, const double *x, const double *y, const float *fade,
                              float out[SEA_FIELDS][SUM_LANES]) {
    uint32_t full, last;
    wave_limits(t, fade, &full, &last);
    for (int l = 0; l < SUM_LANES; l += WIDE) {
        wide_sums sums;
        memset(&sums, 0, sizeof sums);
        const wide_double px = double_load(x + l), py = double_load(y + l);
        wide f = wide_splat(0.0f);
        if (fade) memcpy(&f, fade + l, sizeof f);
        if (t->exponential) {
            add_waves(t, 0, full, false, true, px, py, f, &sums);
            add_waves(t, full, last, true, true, px, py, f, &sums);
        } else {
            add_waves(t, 0, full, false, false, px, py, f, &sums);
            add_waves(t, full, last, true, false, px, py, f, &sums);
        }
        for (int i = 0; i < SEA_FIELDS; i++) memcpy(&out[i][l], &sums.field[i], sizeof(wide));
    }
}

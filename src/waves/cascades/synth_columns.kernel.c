// SPDX-License-Identifier: MIT
// First pass of a step: the modes of 16 values of i at time t, the spectra of the eight fields, and their transforms
// along j. cascades.h has the plan.
//
// With the height h, the divisors q of cubic and l of linear readers, and g = coth(kh) / k, the spectra are h q,
// D = i k g h q, grad eta = i k h l and dD/dx = -k k g h l, k being the wave vector in world axes.
#include "fft/strip.h"
#include "waves/cascades/synth.h"

#include <string.h>

void KERNEL(bolan_sea_columns)(const fft_plan *plan, const sea_cascade *cascade, const sea_planes *planes,
                               const sea_moment *moment, sea_half half, uint32_t strip, float *scratch);

#define ALWAYS_INLINE inline __attribute__((always_inline))

// ---- modes at time t ------------------------------------------------------------------------------------------------

// Sine and cosine of 2 pi x for |x| <= 1/2 turn. The quarter turn is taken off exactly; the polynomials are those of
// math/sincos.h, on |angle| <= pi/4.
static inline void sincos_turns(wide x, wide *sine, wide *cosine) {
    const float magic = 12582912.0f;
    const wide n = (x * 4.0f + magic) - magic;
    const wide r = (x - n * 0.25f) * 6.28318530717958648f;
    const wide z = r * r;
    const wide p = (-0x1.98d6b8p-13f * z + 0x1.1105a8p-7f) * z + -0x1.555554p-3f;
    const wide q = (0x1.99ff42p-16f * z + -0x1.6c0c82p-10f) * z + 0x1.55554ap-5f;
    const wide_int s = wide_bits(r + r * z * p);
    const wide_int c = wide_bits((1.0f - 0.5f * z) + z * z * q);
    const wide_int quadrant = wide_to_int(n);
    const wide_int odd = -(quadrant & 1); // all ones where sine and cosine change places
    // The second bit of the quadrant, spread and cut to the sign bit (a left shift into it is undefined).
    const wide_int sign_s = -((quadrant >> 1) & 1) & INT32_MIN, sign_c = -(((quadrant + 1) >> 1) & 1) & INT32_MIN;
    *sine = wide_from_bits(((odd & c) | (~odd & s)) ^ sign_s);
    *cosine = wide_from_bits(((odd & s) | (~odd & c)) ^ sign_c);
}

// Phases in turns, reduced to |x| <= 1/2 in double, so that they stay accurate after days.
static inline void reduce_turns(const double *turns, double time, float *out) {
    const double magic = 6755399441055744.0;
    for (int l = 0; l < FFT_LANES; l++) {
        const double y = turns[l] * time;
        out[l] = (float)(y - ((y + magic) - magic));
    }
}

// h(k, t) of one row of waves, which stands in h or is added to it.
static ALWAYS_INLINE void evolve_row(const sea_waves *waves, size_t row, double time, bool add, float *h) {
    float phase[FFT_LANES] __attribute__((aligned(64)));
    reduce_turns(waves->turns + row * FFT_LANES, time, phase);
    const float *a = waves->amplitude + row * 4 * FFT_LANES;
    for (int l = 0; l < FFT_LANES; l += WIDE) {
        wide s, c;
        sincos_turns(wide_load(phase + l), &s, &c);
        const wide re = wide_load(a + l) * c + wide_load(a + FFT_LANES + l) * s;
        const wide im = wide_load(a + 2 * FFT_LANES + l) * c + wide_load(a + 3 * FFT_LANES + l) * s;
        const pair before = add ? pair_load(h + l) : (pair){re, im};
        pair_store(h + l, add ? (pair){before.re + re, before.im + im} : before);
    }
}

// A strip at work, in a register or on the stack: what is written to `work` cannot be one of these.
typedef struct column_strip {
    const float *h, *g;                          // [n][FFT_ROW], rows with |j| < reach alone; [n][16]
    const float *k_cos, *k_sin, *cubic, *linear; // of rows: [n]
    wide i_cos, i_sin, i_cubic, i_linear;        // of the lanes at hand
    uint32_t n, reach;
} column_strip;

static inline column_strip strip_of(const sea_cascade *c, uint32_t strip, const float *h, uint32_t lane) {
    const uint32_t i = strip * FFT_LANES + lane;
    return (column_strip){.h = h + lane,
                          .g = c->inverse_k + (size_t)strip * c->n * FFT_LANES + lane,
                          .k_cos = c->k_cos,
                          .k_sin = c->k_sin,
                          .cubic = c->cubic,
                          .linear = c->linear,
                          .i_cos = wide_load(c->k_cos + i),
                          .i_sin = wide_load(c->k_sin + i),
                          .i_cubic = wide_load(c->cubic + i),
                          .i_linear = wide_load(c->linear + i),
                          .n = c->n,
                          .reach = c->reach[strip]};
}

static inline bool has_modes(uint32_t n, uint32_t reach, uint32_t j) { return j < reach || n - j < reach; }

static void evolve(const sea_cascade *cascade, uint32_t strip, double time, float *h) {
    const int32_t n = (int32_t)cascade->n, reach = (int32_t)cascade->reach[strip];
    const int32_t end = reach < SEA_PART_REACH ? reach : SEA_PART_REACH;
    for (uint32_t j = 0; j < cascade->n; j++)
        if (has_modes(cascade->n, cascade->reach[strip], j))
            evolve_row(&cascade->modes, (size_t)strip * cascade->n + j, time, false, h + (size_t)j * FFT_ROW);
    if (strip > 0) return;
    for (uint32_t part = 1; part < SEA_PARTS; part++)
        for (int32_t j = 1 - end; j < end; j++)
            evolve_row(&cascade->parts, sea_part_row(part, j), time, true, h + (size_t)(j & (n - 1)) * FFT_ROW);
}

// A tick sees the water that lies under the foam of a sample: h times e^{i k drift}.
static void drift_rows(const sea_cascade *cascade, uint32_t strip, const uint32_t drift[2], float *h) {
    const uint32_t n = cascade->n;
    float phase[FFT_LANES] __attribute__((aligned(64)));
    for (uint32_t j = 0; j < n; j++) {
        if (!has_modes(n, cascade->reach[strip], j)) continue;
        const uint32_t row = (j < n / 2 ? j : j - n) * drift[1]; // modulo a turn, so that nothing is lost
        for (uint32_t l = 0; l < FFT_LANES; l++)
            phase[l] = (float)(int32_t)(row + (strip * FFT_LANES + l) * drift[0]) * 0x1p-32f;
        for (int l = 0; l < FFT_LANES; l += WIDE) {
            float *at = h + (size_t)j * FFT_ROW + l;
            const pair before = pair_load(at);
            wide s, c;
            sincos_turns(wide_load(phase + l), &s, &c);
            pair_store(at, (pair){before.re * c - before.im * s, before.re * s + before.im * c});
        }
    }
}

// ---- fields ---------------------------------------------------------------------------------------------------------

static inline pair pair_times(pair a, wide f) { return (pair){a.re * f, a.im * f}; }
static inline pair pair_times_i(pair a, wide f) { return (pair){-(a.im * f), a.re * f}; }

// The spectrum of a field at row j.
static ALWAYS_INLINE pair spectrum(const column_strip s, int field, uint32_t j) {
    const pair h = pair_load(s.h + (size_t)j * FFT_ROW);
    const wide g = wide_load(s.g + (size_t)j * FFT_LANES);
    const wide cubic = s.i_cubic * s.cubic[j], linear = s.i_linear * s.linear[j];
    const wide kx = s.i_cos - s.k_sin[j], ky = s.i_sin + s.k_cos[j];
    switch (field) { // a constant
    case FIELD_HEIGHT: return pair_times(h, cubic);
    case FIELD_DX: return pair_times_i(h, g * cubic * kx);
    case FIELD_DY: return pair_times_i(h, g * cubic * ky);
    case FIELD_SLOPE_X: return pair_times_i(h, linear * kx);
    case FIELD_SLOPE_Y: return pair_times_i(h, linear * ky);
    case FIELD_DXX: return pair_times(h, -(g * linear * kx * kx));
    case FIELD_DYY: return pair_times(h, -(g * linear * ky * ky));
    default: return pair_times(h, -(g * linear * kx * ky)); // FIELD_DXY
    }
}

// The first stage of a field's transform, from the modes to `work`, at the rows j = first .. end - 1 and those 1/8 n
// apart from them: the blocks of low j alone that hold modes in one of these rows, and as many of high j.
#define BEGIN(name, blocks, butterfly)                                                                         \
    static ALWAYS_INLINE void name(const column_strip s, int field, const float *twiddle, uint32_t first,      \
                                   uint32_t end, float *work) {                                                \
        const uint32_t q = s.n / 8;                                                                            \
        const pair zero = {(wide){0}, (wide){0}};                                                              \
        for (uint32_t j = first; j < end; j++) {                                                               \
            const float *turn = twiddle + 14 * (size_t)j;                                                      \
            float *at = work + (size_t)j * FFT_ROW;                                                            \
            pair a[8], b[8];                                                                                   \
            _Pragma("GCC unroll 8") for (uint32_t i = 0; i < 8; i++) if (i < blocks || i >= 8 - blocks) a[i] = \
                has_modes(s.n, s.reach, j + i * q) ? spectrum(s, field, j + i * q) : zero;                     \
            butterfly(a, b);                                                                                   \
            pair_store(at, b[0]);                                                                              \
            _Pragma("GCC unroll 8") for (uint32_t i = 1; i < 8; i++)                                           \
                pair_store(at + (size_t)i * q * FFT_ROW, pair_turn(b[i], turn + 2 * (i - 1)));                 \
        }                                                                                                      \
    }
BEGIN(begin_two, 1, butterfly8_two)
BEGIN(begin_four, 2, butterfly8_four)
BEGIN(begin_open, 3, butterfly8_open)
#undef BEGIN

// Modes reach into `most` blocks on either side, and into the last of them by `edge` rows: which of the first and of
// the last rows of a block.
static ALWAYS_INLINE void begin_field(const column_strip s, int field, const float *twiddle, float *work) {
    const uint32_t q = s.n / 8, most = (s.reach + q - 1) / q, edge = s.reach - (most - 1) * q;
    const uint32_t back = q - edge + 1 > edge ? q - edge + 1 : edge, ends[] = {edge, back, q};
    for (uint32_t part = 0, first = 0; part < 3; first = ends[part++]) {
        switch (part == 1 ? most - 1 : most) {
        case 3: begin_open(s, field, twiddle, first, ends[part], work); break;
        case 2: begin_four(s, field, twiddle, first, ends[part], work); break;
        default: begin_two(s, field, twiddle, first, ends[part], work); break;
        }
    }
}

static void begin(const column_strip *s, int field, const float *twiddle, float *work) {
    switch (field) { // a constant in each case, so that nothing is computed that is not used
    case FIELD_HEIGHT: begin_field(*s, FIELD_HEIGHT, twiddle, work); break;
    case FIELD_DX: begin_field(*s, FIELD_DX, twiddle, work); break;
    case FIELD_DY: begin_field(*s, FIELD_DY, twiddle, work); break;
    case FIELD_SLOPE_X: begin_field(*s, FIELD_SLOPE_X, twiddle, work); break;
    case FIELD_SLOPE_Y: begin_field(*s, FIELD_SLOPE_Y, twiddle, work); break;
    case FIELD_DXX: begin_field(*s, FIELD_DXX, twiddle, work); break;
    case FIELD_DYY: begin_field(*s, FIELD_DYY, twiddle, work); break;
    default: begin_field(*s, FIELD_DXY, twiddle, work); break;
    }
}

// The last stage of radix r; its outputs, n / r rows apart, go where the second pass reads them.
#define END(name, r, butterfly)                                                                              \
    static void name(const fft_plan *plan, const float *work, float *out, size_t block) {                    \
        const uint32_t apart = plan->n / r;                                                                  \
        for (uint32_t y = 0; y < apart; y++) {                                                               \
            const float *in = work + (size_t)plan->order[y] * FFT_ROW;                                       \
            float *at = out + y / SEA_ROWS * block + (size_t)(y % SEA_ROWS) * FFT_ROW;                       \
            for (uint32_t lane = 0; lane < FFT_LANES; lane += WIDE) {                                        \
                pair a[r], b[r];                                                                             \
                for (uint32_t i = 0; i < r; i++) a[i] = pair_load(in + lane + (size_t)i * FFT_ROW);          \
                butterfly(a, b);                                                                             \
                for (uint32_t i = 0; i < r; i++) pair_store(at + lane + apart / SEA_ROWS * i * block, b[i]); \
            }                                                                                                \
        }                                                                                                    \
    }
END(end4, 4, butterfly4)
END(end8, 8, butterfly8)
#undef END

void KERNEL(bolan_sea_columns)(const fft_plan *plan, const sea_cascade *cascade, const sea_planes *planes,
                               const sea_moment *moment, sea_half half, uint32_t strip, float *scratch) {
    float *h = planes->modes + (size_t)strip * plan->n * FFT_ROW, *work = scratch;
    const size_t block = (size_t)cascade->strips * SEA_CELL;
    if (moment->at.tick || moment->alone || half == SEA_DISPLACEMENT) evolve(cascade, strip, moment->at.shown, h);
    if (moment->at.tick) drift_rows(cascade, strip, moment->drift, h);
    for (uint32_t f = moment->at.tick ? SEA_DIVERGENCE : 0; f < SEA_HALF; f++) {
        for (uint32_t lane = 0; lane < FFT_LANES; lane += WIDE) {
            const column_strip s = strip_of(cascade, strip, h, lane);
            begin(&s, sea_half_field[half][f], plan->twiddle[0], work + lane);
        }
        fft_stages(plan, 1, plan->stages - 1, work);
        float *out = planes->middle + (size_t)strip * SEA_CELL + (size_t)f * SEA_PIECE;
        (plan->radix[plan->stages - 1] == 4 ? end4 : end8)(plan, work, out, block);
    }
}

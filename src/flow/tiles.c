// SPDX-License-Identifier: MIT
// The flow of cascades: their modes, prepared for four depths, and the synthesis of the potentials at a time.
//
// Two real fields A and B share a complex transform: P = A + iB at k, conj(A) + i conj(B) at -k. Modes are kept for
// j >= 0, in strips of 16 j (fft/strip.h). A step does, for each of the eight pairs of fields of a texel:
//
//     rows     16 values of j: modes -> FFT along i -> `middle`, transposed; and the same for -j
//     columns  16 values of x: FFT along j -> texels
#include "flow/tables.h"
#include "spectrum/portable.h"
#include "waves/cascades/cascades.h"

#include <string.h>

#define WIDE 8.2 // ratio of a band's ends beyond which four levels are not enough

// ---- modes ----------------------------------------------------------------------------------------------------------

typedef struct gathering {
    flow_tile *tile;
    const sea_cascade *cascade;
    double sea_depth, choppiness;
    const bolan_bound_weights *bound;
    double from, to;                 // the range of wave numbers that the tile takes
    double low, high;                // wave numbers of the modes
    uint32_t reach;                  // largest index along an axis, and 1
    uint32_t count[FLOW_MAX_STRIPS]; // modes of each strip
    double speed[FLOW_BINS], rate[FLOW_BINS], energy[FLOW_BINS], moment[FLOW_BINS];
} gathering;

static double length_of(const sea_mode *m) { return sqrt(m->kx * m->kx + m->ky * m->ky); }

static bool is_taken(const gathering *g, const sea_mode *m) { return length_of(m) >= g->from && length_of(m) < g->to; }

// A cascade keeps the modes of i >= 0. Here they are those of j >= 0, of j = 0 with either sign of i: the mode of -k is
// the conjugate of that of k.
typedef struct half_plane {
    gathering *g;
    void (*visit)(gathering *g, const sea_mode *m, int32_t i, int32_t j);
} half_plane;

static void turn_mode(void *context, const sea_mode *m) {
    const half_plane *half = context;
    const sea_cascade *c = half->g->cascade;
    if (!is_taken(half->g, m)) return;
    const double scale = c->length / (2.0 * BOLAN_PI);
    const int32_t i = (int32_t)floor((m->kx * c->cosine + m->ky * c->sine) * scale + 0.5);
    const int32_t j = (int32_t)floor((m->ky * c->cosine - m->kx * c->sine) * scale + 0.5);
    if (i == 0 && j < 0) return; // that of -k is an entry, too
    if (j >= 0) half->visit(half->g, m, i, j);
    if (j > 0 || i == 0) return;
    sea_mode other = *m;
    other.re = m->back_re, other.im = -m->back_im;
    other.back_re = m->re, other.back_im = -m->im;
    half->visit(half->g, &other, -i, -j);
}

static void count_mode(gathering *g, const sea_mode *m, int32_t i, int32_t j) {
    const uint32_t a = (uint32_t)(i < 0 ? -i : i) + 1, b = (uint32_t)j + 1;
    g->reach = a > g->reach ? a : g->reach;
    g->reach = b > g->reach ? b : g->reach;
    g->count[j / FFT_LANES]++;
    g->low = fmin(g->low, length_of(m));
    g->high = fmax(g->high, length_of(m));
}

static double bin_edge(const gathering *g, double index) {
    return g->low * portable_pow(g->high / g->low, index / FLOW_BINS);
}

static void bin_mode(void *context, const sea_mode *m) {
    gathering *g = context;
    if (!is_taken(g, m)) return;
    const double k = length_of(m), omega = 2.0 * BOLAN_PI * m->turns;
    const double x = portable_log(k / g->low) / portable_log(g->high / g->low) * FLOW_BINS;
    const int b = (int)fmin(fmax(x, 0.0), FLOW_BINS - 1.0);
    const double realised = m->re * m->re + m->im * m->im + m->back_re * m->back_re + m->back_im * m->back_im;
    const double energy = (m->paired ? 2.0 : 1.0) * realised;
    g->speed[b] += omega * omega * energy;
    g->rate[b] += omega * omega * omega * omega * energy;
    g->energy[b] += energy;
    g->moment[b] += energy * k;
    g->tile->levels.bin[b].energy += energy;
    g->tile->levels.bin[b].lift +=
        g->choppiness * energy * k * k * m->inverse_k -
        energy * bolan_sea_bound_mean(g->bound, k * m->inverse_k); // as waves/cascades/lift.c
}

// Bins of motion, and the wave number below which there is next to none.
static void set_bins(gathering *g) {
    flow_tile *t = g->tile;
    double speed = 1e-30, rate = 1e-30, below = 0.0;
    for (int b = 0; b < FLOW_BINS; b++) speed += g->speed[b], rate += g->rate[b];
    t->levels.k_low = g->low;
    t->levels.k_high = g->high;
    for (int b = 0; b < FLOW_BINS; b++) {
        t->levels.bin[b].motion = g->speed[b] / speed + g->rate[b] / rate;
        t->levels.bin[b].k = g->energy[b] > 0.0 ? g->moment[b] / g->energy[b] : bin_edge(g, b + 0.5);
        below += g->speed[b];
        if (below < 1e-4 * speed) t->levels.k_low = bin_edge(g, b + 1.0);
    }
}

// Response of the cubic B-spline to a wave of `index` cycles over n samples.
static double transfer(int32_t index, uint32_t n) {
    const double x = BOLAN_PI * index / n;
    double s, c;
    bolan_sincos(x, &s, &c);
    const double sinc = index == 0 ? 1.0 : s / x;
    return sinc * sinc * sinc * sinc;
}

// The waves of a mode are visited one after the other, and at j = 0 in turn with those of the mirrored mode.
static uint32_t first_of(const flow_tile *t, uint32_t wave, uint32_t from) {
    for (uint32_t back = 1; back <= 2 && from + back <= wave; back++) {
        const flow_mode *other = &t->modes[wave - back];
        if (other->row == t->modes[wave].row && other->lane == t->modes[wave].lane) return other->first;
    }
    return wave;
}

static void add_mode(gathering *g, const sea_mode *m, int32_t i, int32_t j) {
    flow_tile *t = g->tile;
    const double k = length_of(m), all = 1.0 - portable_exp(-2.0 * k * g->sea_depth);
    const double scale = 1.0 / (k * all * transfer(i, t->frame.n) * transfer(j, t->frame.n));
    const uint32_t from = t->first[j / FFT_LANES], wave = from + g->count[j / FFT_LANES]++;
    flow_mode *out = &t->modes[wave];
    out->turns = m->turns;
    out->re = (float)m->re;
    out->im = (float)m->im;
    out->back_re = (float)m->back_re;
    out->back_im = (float)m->back_im;
    for (int l = 0; l < FLOW_LEVELS; l++) out->level[l] = (float)(scale * portable_exp(-k * t->levels.depth[l]));
    out->row = (uint16_t)((uint32_t)(i + (int32_t)t->frame.n) & (t->frame.n - 1));
    out->lane = (uint16_t)(j % FFT_LANES);
    out->first = first_of(t, wave, from);
}

// Five samples a wave, as far as the FFT goes: with four, images of the shortest waves are 4 % of accelerations.
static uint32_t side_of(uint32_t reach) {
    uint32_t n = FFT_MIN;
    while (n < FFT_MAX && 5 * (reach - 1) > n) n *= 2;
    return n;
}

static void set_strips(gathering *g) {
    flow_tile *t = g->tile;
    t->strips = (g->reach + FFT_LANES - 1) / FFT_LANES;
    t->mode_count = 0;
    for (uint32_t s = 0; s < t->strips; s++) {
        t->first[s] = t->mode_count;
        t->mode_count += g->count[s];
        g->count[s] = 0;
    }
    t->first[t->strips] = t->mode_count;
}

static gathering gather(bolan_flow *flow, const sea_shared *sea, uint32_t band, double from, double to) {
    const sea_cascade *cascade = &cascade_tables_of(sea)->cascade[band];
    flow_tile *t = &flow->tile[flow->tiles];
    gathering g = {.tile = t,
                   .cascade = cascade,
                   .sea_depth = flow->depth,
                   .choppiness = sea->desc.choppiness,
                   .bound = &sea->bound[band],
                   .from = from,
                   .to = to,
                   .low = 1e30};
    memset(t, 0, sizeof *t);
    bolan_sea_each_mode(cascade, turn_mode, &(half_plane){&g, count_mode});
    if (!(g.high > g.low)) g.high = g.low * 1.0001; // one mode, or none
    if (g.reach == 0) return g;
    bolan_sea_each_mode(cascade, bin_mode, &g);
    set_bins(&g);
    return g;
}

// False when memory is short.
static bool add_tile(bolan_flow *flow, uint32_t band, gathering *g) {
    if (g->reach == 0) return true; // no waves
    const sea_cascade *cascade = g->cascade;
    flow_tile *t = &flow->tile[flow->tiles];
    t->band = band;
    t->frame.length = cascade->length;
    t->frame.cosine = cascade->cosine;
    t->frame.sine = cascade->sine;
    t->frame.n = side_of(g->reach);
    bolan_flow_fit(&t->levels, flow->depth);
    set_strips(g);
    if (!bolan_fft_plan_create(t->frame.n, &t->plan)) return false;
    flow->tiles++; // from here on it is released with the flow
    t->modes = bolan_sea_reserve(&flow->memory, t->mode_count * (sizeof *t->modes + sizeof *t->evolved));
    t->texels = t->modes
                    ? bolan_sea_reserve(&flow->memory, (size_t)t->frame.n * t->frame.n * FLOW_TEXEL * sizeof(float))
                    : NULL;
    if (!t->texels) return false;
    t->evolved = (float(*)[6])(void *)(t->modes + t->mode_count);
    bolan_sea_each_mode(cascade, turn_mode, &(half_plane){g, add_mode});
    return true;
}

// One tile, or two where the band is too wide for the levels of one.
static bool add_cascade(bolan_flow *flow, const sea_shared *sea, uint32_t band) {
    gathering g = gather(flow, sea, band, 0.0, INFINITY);
    const double low = g.tile->levels.k_low, high = g.tile->levels.k_high;
    if (g.reach == 0 || high < WIDE * low) return add_tile(flow, band, &g);
    const double between = sqrt(low * high);
    g = gather(flow, sea, band, 0.0, between);
    if (!add_tile(flow, band, &g)) return false;
    g = gather(flow, sea, band, between, INFINITY);
    return add_tile(flow, band, &g);
}

bool bolan_flow_create_tiles(bolan_flow *flow, const bolan_sea *sea) {
    uint32_t largest = FFT_MIN;
    for (uint32_t i = 0; i < sea->shared->cascades; i++)
        if (!add_cascade(flow, sea->shared, i)) return false;
    for (uint32_t i = 0; i < flow->tiles; i++)
        largest = flow->tile[i].frame.n > largest ? flow->tile[i].frame.n : largest;
    flow->transform = bolan_fft_strip_for(sea->shared->desc.cpu);
    flow->slots = bolan_threads();
    flow->scratch_floats = 2 * (size_t)largest * FFT_ROW;
    flow->scratch = bolan_sea_reserve(&flow->memory, flow->slots * flow->scratch_floats * sizeof(float));
    if (!flow->scratch) return false;
    flow->middle = bolan_sea_reserve(&flow->memory, 2 * (size_t)largest * largest * sizeof(float));
    return flow->middle != NULL;
}

// ---- a time ---------------------------------------------------------------------------------------------------------

typedef struct step {
    bolan_flow *flow;
    flow_tile *tile;
    double time;
    int pair;
} step;

static void run(step *s, uint32_t items, flow_work *work) {
    bolan_flow_share(s->flow, items, s->flow->scratch, s->flow->scratch_floats, work, s);
}

// h = h0(k) e^{-iwt} + conj(h0(-k)) e^{iwt} and its derivatives, of the waves of a strip, summed mode by mode.
static void evolve(void *context, uint32_t strip, float *scratch) {
    const step *s = context;
    (void)scratch;
    const flow_tile *t = s->tile;
    for (uint32_t i = t->first[strip]; i < t->first[strip + 1]; i++) {
        const flow_mode *m = &t->modes[i];
        const double turns = m->turns * s->time;
        float sine, cosine, h[6], *sum = t->evolved[m->first];
        bolan_sincosf((float)(2.0 * BOLAN_PI * (turns - floor(turns + 0.5))), &sine, &cosine);
        const float omega = (float)(2.0 * BOLAN_PI * m->turns);
        const float forth_re = m->re * cosine + m->im * sine, forth_im = m->im * cosine - m->re * sine;
        const float back_re = m->back_re * cosine - m->back_im * sine;
        const float back_im = m->back_im * cosine + m->back_re * sine;
        h[0] = forth_re + back_re;
        h[1] = forth_im + back_im;
        h[2] = -omega * (back_im - forth_im);
        h[3] = omega * (back_re - forth_re);
        h[4] = -omega * omega * h[0];
        h[5] = -omega * omega * h[1];
        for (int d = 0; d < 6; d++) sum[d] = m->first == i ? h[d] : sum[d] + h[d];
    }
}

static void put(float *strip, size_t row, uint32_t lane, float re, float im) {
    strip[row * FFT_ROW + lane] = re;
    strip[row * FFT_ROW + FFT_LANES + lane] = im;
}

// Row r of the transform stands at order[r]; lanes j become rows of `middle`.
static void transpose_out(const step *s, const float *rows, uint32_t first_j, bool mirrored) {
    const flow_tile *t = s->tile;
    for (uint32_t lane = 0; lane < FFT_LANES; lane++) {
        const uint32_t j = first_j + lane, to = mirrored ? (t->frame.n - j) & (t->frame.n - 1) : j;
        if ((mirrored && j == 0) || j >= t->frame.n / 2) continue;
        for (uint32_t x = 0; x < t->frame.n; x++) {
            const float *from = rows + (size_t)t->plan.order[x] * FFT_ROW + lane;
            float *out = s->flow->middle + ((size_t)(x / FFT_LANES) * t->frame.n + to) * FFT_ROW + x % FFT_LANES;
            out[0] = from[0];
            out[FFT_LANES] = from[FFT_LANES];
        }
    }
}

// Which derivative by time and which level a field of a texel is, and along which axis it is a gradient.
typedef struct field {
    int rate, level, axis; // axis 0: none, 1: u, 2: v
} field;
static const field fields[FLOW_TEXEL] = {
    {0, 0, 0}, {0, 1, 0}, {0, 2, 0}, {0, 3, 0}, {0, 0, 1}, {0, 0, 2}, {2, 0, 1}, {2, 0, 2},
    {1, 0, 0}, {1, 1, 0}, {1, 2, 0}, {1, 3, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}, {2, 3, 0},
};

// A field of one mode.
static void field_of(const flow_tile *t, const flow_mode *m, const float *h, uint32_t strip, int index, float out[2]) {
    const field f = fields[index];
    const float w = m->level[f.level], re = w * h[2 * f.rate], im = w * h[2 * f.rate + 1];
    if (f.axis == 0) {
        out[0] = re, out[1] = im;
        return;
    }
    const int32_t i = m->row < t->frame.n / 2 ? (int32_t)m->row : (int32_t)m->row - (int32_t)t->frame.n;
    const int32_t along = f.axis == 1 ? i : (int32_t)(strip * FFT_LANES + m->lane);
    const float k = (float)(2.0 * BOLAN_PI * along / t->frame.length);
    out[0] = -k * im;
    out[1] = k * re;
}

static void do_rows(void *context, uint32_t strip, float *scratch) {
    const step *s = context;
    const flow_tile *t = s->tile;
    float *plus = scratch, *minus = scratch + (size_t)t->frame.n * FFT_ROW;
    memset(scratch, 0, 2 * (size_t)t->frame.n * FFT_ROW * sizeof(float));
    for (uint32_t i = t->first[strip]; i < t->first[strip + 1]; i++) {
        const flow_mode *m = &t->modes[i];
        if (m->first != i) continue;
        float a[2], b[2];
        field_of(t, m, t->evolved[i], strip, 2 * s->pair, a);
        field_of(t, m, t->evolved[i], strip, 2 * s->pair + 1, b);
        put(plus, m->row, m->lane, a[0] - b[1], a[1] + b[0]);
        put(minus, (t->frame.n - m->row) & (t->frame.n - 1), m->lane, a[0] + b[1], b[0] - a[1]);
    }
    s->flow->transform(&t->plan, plus);
    s->flow->transform(&t->plan, minus);
    transpose_out(s, plus, strip * FFT_LANES, false);
    transpose_out(s, minus, strip * FFT_LANES, true);
}

static void do_columns(void *context, uint32_t strip, float *scratch) {
    const step *s = context;
    const flow_tile *t = s->tile;
    const size_t floats = (size_t)t->frame.n * FFT_ROW;
    memcpy(scratch, s->flow->middle + strip * floats, floats * sizeof(float));
    s->flow->transform(&t->plan, scratch);
    for (uint32_t y = 0; y < t->frame.n; y++) {
        const float *row = scratch + (size_t)t->plan.order[y] * FFT_ROW;
        float *out =
            t->texels + ((size_t)y * t->frame.n + (size_t)strip * FFT_LANES) * FLOW_TEXEL + 2 * (size_t)s->pair;
        for (uint32_t lane = 0; lane < FFT_LANES; lane++, out += FLOW_TEXEL) {
            out[0] = row[lane];
            out[1] = row[FFT_LANES + lane];
        }
    }
}

void bolan_flow_evolve_tiles(bolan_flow *flow, double shown) {
    for (uint32_t i = 0; i < flow->tiles; i++) {
        flow_tile *t = &flow->tile[i];
        if (t->mode_count == 0) continue;
        step s = {.flow = flow, .tile = t, .time = shown};
        run(&s, t->strips, evolve);
        memset(flow->middle, 0, 2 * (size_t)t->frame.n * t->frame.n * sizeof(float)); // rows without modes
        for (s.pair = 0; s.pair < FLOW_PAIRS; s.pair++) {
            run(&s, t->strips, do_rows);
            run(&s, t->frame.n / FFT_LANES, do_columns);
        }
    }
}

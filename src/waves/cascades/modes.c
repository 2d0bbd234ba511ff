// SPDX-License-Identifier: MIT
// The random modes of each cascade, from the spectrum.
//
//     h0(k) = sqrt(E(k) / 2) e^{i phase(k)},   E(k) = integral of Psi over the part of the cell of k in the ring
//     h(k, t) = h0(k) e^{-i w t} + conj(h0(-k)) e^{+i w t},   eta(x, t) = sum_k h(k, t) e^{i k.x}
//
// so that waves run toward +k and the variance of eta is the sum of E (Tessendorf 2001, section 3, with the signs and
// the factor put right for one-sided spectra). Amplitudes are those of the spectrum, phases are random: each
// realisation has the whole energy of every band, and with a hundred waves and more in the peak the heights at a point
// are Gaussian (Tucker, Challenor & Carter 1984 have what fixed amplitudes take from the statistics of groups where
// waves are few). The phase depends on nothing but the seed, the tile's number and the lattice index: a finer grid
// holds the same waves and some more.
//
// Where a tile begins, at 6 modes, a cell is as wide as a tenth of an octave of frequency. One wave a cell has all of
// its energy at one frequency: bands of that width are off by a quarter (tests/physics/test_sea_bands.c). So modes near
// the origin are sums of SEA_PARTS waves of one wave vector. Each has the energy of a slice of the cell between two
// wave numbers, and the frequency of the slice:
//
//     |k| ->     .  1  :  2  :  3  :  4  .        h(k, t) = sum over slices of the h(k, t) above
//
// In space nothing changes: the lattice had rounded wave vectors before. Frequencies do not depend on the spectrum, so
// that the waves of a sea an hour later are the same.
#include "spectrum/portable.h"
#include "waves/cascades/cascades.h"

// The unit number of a mode: a random direction in the complex plane.
typedef struct unit {
    double re, im;
} unit;

static unit random_unit(uint64_t key, uint32_t part, int32_t i, int32_t j) {
    const uint64_t index = ((uint64_t)(uint32_t)i << 32 | (uint32_t)j) ^ (uint64_t)part << 16;
    unit u;
    bolan_sincos((double)(bolan_sea_mix(key ^ bolan_sea_mix(index)) >> 11) * (2.0 * BOLAN_PI * 0x1p-53), &u.im, &u.re);
    return u;
}

typedef struct fill {
    const sea_shared *shared;
    sea_cascade *cascade;
    const spectrum_eval *eval;
    const sea_radial *radial;
    const cascade_fine_spectrum *fine; // instead of the two; or NULL
    uint64_t key;
} fill;

static double density_at(const fill *f, double kx, double ky) {
    return f->fine ? bolan_cascade_fine_density(f->fine, kx, ky) : bolan_spectrum_eval_psi(f->eval, kx, ky);
}

static bool has_parts(int32_t i, int32_t j) { return i < SEA_PART_REACH && j < SEA_PART_REACH && -j < SEA_PART_REACH; }

// Samples along a side of a cell: many where it is cut to slices or the ring ends within it, and where the spectrum
// changes within a cell.
static int cell_samples(const fill *f, int32_t i, int32_t j) {
    const sea_cascade *c = f->cascade;
    const double k = sqrt((double)i * i + (double)j * j), scale = c->length / (2.0 * BOLAN_PI);
    const bool edge = fabs(k - c->k_min * scale) < 0.75 || fabs(k - c->k_max * scale) < 0.75;
    return has_parts(i, j) || edge ? 8 : k <= 20.0 ? 4 : k <= 40.0 ? 2 : 1;
}

// Sums over the samples of a slice.
typedef struct slice {
    double count, k, forth, back;
} slice;

// Adds the samples of the cell of (i, j) in the ring to `parts` slices between wave numbers `low` and `high`.
static void sample_cell(const fill *f, int32_t i, int32_t j, double low, double high, uint32_t parts, slice *out) {
    const sea_cascade *c = f->cascade;
    const double dk = 2.0 * BOLAN_PI / c->length;
    const int samples = cell_samples(f, i, j);
    for (int b = 0; b < samples; b++) {
        for (int a = 0; a < samples; a++) {
            const double u = (i + (a + 0.5) / samples - 0.5) * dk, v = (j + (b + 0.5) / samples - 0.5) * dk;
            const double k = sqrt(u * u + v * v);
            if (k < c->k_min || k >= c->k_max) continue;
            const double kx = u * c->cosine - v * c->sine, ky = u * c->sine + v * c->cosine;
            const uint32_t part = (uint32_t)fmin(fmax((k - low) / (high - low), 0.0) * parts, parts - 1.0);
            out[part].count += 1.0;
            out[part].k += k;
            out[part].forth += density_at(f, kx, ky);
            out[part].back += density_at(f, -kx, -ky);
        }
    }
}

// The least and the largest wave number in the cell of (i, j) and in the ring.
static void cell_ends(const sea_cascade *c, int32_t i, int32_t j, double *low, double *high) {
    const double dk = 2.0 * BOLAN_PI / c->length, u = fabs((double)i), v = fabs((double)j);
    const double near_u = fmax(u - 0.5, 0.0), near_v = fmax(v - 0.5, 0.0);
    *low = fmax(dk * sqrt(near_u * near_u + near_v * near_v), c->k_min);
    *high = fmin(dk * sqrt((u + 0.5) * (u + 0.5) + (v + 0.5) * (v + 0.5)), c->k_max);
}

// Frequency in turns a second; with a loop, the nearest multiple of 1 / period, but never standing still.
static double turns_of(const sea_shared *shared, double k) {
    const double turns = bolan_omega_from_k(k, shared->desc.sea_state.depth) / (2.0 * BOLAN_PI);
    const double period = shared->period;
    return period > 0.0 ? fmax(floor(turns * period + 0.5), 1.0) / period : turns;
}

#define HALF_CELL 0.70711 // from the middle of a cell to its corner

// A wave of a mode: its frequency, E(k) and E(-k).
typedef struct wave {
    double turns, forth, back;
} wave;

// `forth` and `back` are the unit numbers of the wave.
static void put_wave(const wave *w, unit forth, unit back, sea_waves *waves, size_t row, uint32_t lane) {
    const double ef = sqrt(0.5 * w->forth), eb = sqrt(0.5 * w->back);
    const double a = forth.re * ef, b = forth.im * ef, p = back.re * eb, q = -back.im * eb;
    float *amplitude = waves->amplitude + row * 4 * FFT_LANES + lane;
    amplitude[0] = (float)(a + p);
    amplitude[FFT_LANES] = (float)(b - q);
    amplitude[2 * FFT_LANES] = (float)(b + q);
    amplitude[3 * FFT_LANES] = (float)(p - a);
    waves->turns[row * FFT_LANES + lane] = w->turns;
    waves->expected[row * 2 * FFT_LANES + lane] = (float)w->forth;
    waves->expected[row * 2 * FFT_LANES + FFT_LANES + lane] = (float)w->back;
}

// The waves of the mode (i, j), one for each slice of its cell. Slices that a loop gives one frequency are one wave:
// two would add up to more energy or less, forever.
static uint32_t waves_of(const fill *f, int32_t i, int32_t j, double k, wave out[SEA_PARTS]) {
    const uint32_t parts = has_parts(i, j) ? SEA_PARTS : 1;
    const int samples = cell_samples(f, i, j);
    const double side = 2.0 * BOLAN_PI / f->cascade->length / samples;
    double low, high;
    slice slices[SEA_PARTS] = {{0}};
    cell_ends(f->cascade, i, j, &low, &high);
    sample_cell(f, i, j, low, high, parts, slices);
    uint32_t count = 0;
    for (const slice *s = slices; s < slices + parts; s++) {
        if (s->count == 0.0) continue;
        const double own = parts > 1 ? s->k / s->count : k;
        const double scale = side * side * (f->radial ? bolan_sea_radial_keep(f->radial, own) : 1.0);
        const wave w = {turns_of(f->shared, own), s->forth * scale, s->back * scale};
        if (w.forth + w.back < 1e-24) continue; // less than a picometre, and out of the denormal numbers
        if (count > 0 && out[count - 1].turns == w.turns) {
            out[count - 1].forth += w.forth;
            out[count - 1].back += w.back;
        } else {
            out[count++] = w;
        }
    }
    return count;
}

static void fill_mode(const fill *f, int32_t i, int32_t j, size_t row, uint32_t lane) {
    sea_cascade *c = f->cascade;
    const double dk = 2.0 * BOLAN_PI / c->length, k = dk * sqrt((double)i * i + (double)j * j);
    if (k < c->k_min - HALF_CELL * dk || k > c->k_max + HALF_CELL * dk || k == 0.0) return;
    wave waves[SEA_PARTS];
    const uint32_t count = waves_of(f, i, j, k, waves);
    for (uint32_t part = 0; part < count; part++)
        put_wave(&waves[part], random_unit(f->key, part, i, j), random_unit(f->key, part, -i, -j),
                 part == 0 ? &c->modes : &c->parts, part == 0 ? row : sea_part_row(part, j), lane);
    if (count > 0)
        c->inverse_k[row * FFT_LANES + lane] = (float)(1.0 / (k * portable_tanh(k * f->shared->desc.sea_state.depth)));
}

// Task: the strips [begin, end) of one cascade.
static void fill_strips(void *context, uint32_t begin, uint32_t end, uint32_t worker) {
    (void)worker;
    const fill *f = context;
    const int32_t n = (int32_t)f->cascade->n;
    for (uint32_t strip = begin; strip < end; strip++) {
        for (int32_t row = 0; row < n; row++) {
            const int32_t j = row < n / 2 ? row : row - n;
            if (j == -n / 2) continue; // the Nyquist row is its own mirror image
            for (int32_t lane = 0; lane < FFT_LANES; lane++)
                fill_mode(f, (int32_t)strip * FFT_LANES + lane, j, (size_t)strip * (uint32_t)n + (uint32_t)row,
                          (uint32_t)lane);
        }
    }
}

static double outer_of(const sea_cascade *c) { return c->k_max / (2.0 * BOLAN_PI / c->length) + HALF_CELL; }
static double rows_of(const sea_cascade *c) { return fmin(ceil(outer_of(c)), 0.375 * c->n); } // i < outer

void bolan_cascade_set_reach(sea_cascade *c) {
    const double outer = outer_of(c), most = 0.375 * c->n;
    BOLAN_ASSERT(outer <= most); // layout.c ends the rings at 0.35 n, and the kernels leave out what lies beyond
    c->strips = ((uint32_t)rows_of(c) + FFT_LANES - 1) / FFT_LANES;
    for (uint32_t strip = 0; strip < c->strips; strip++) {
        const double i = strip * FFT_LANES, left = outer * outer - i * i;
        c->reach[strip] = (uint32_t)fmin(ceil(sqrt(fmax(left, 0.0))), most);
    }
}

enum { PARTS = (SEA_PARTS - 1) * SEA_PART_ROWS * FFT_LANES, WAVE_FLOATS = 8 };

size_t bolan_cascade_table_bytes(const sea_cascade *c) {
    const size_t n = c->n, modes = n * c->strips * FFT_LANES;
    return ((modes + PARTS) * WAVE_FLOATS + modes + 4 * n) * sizeof(float);
}

// The tables of `count` waves; returns what is behind them.
static float *lay_waves(float *next, size_t count, sea_waves *out) {
    out->turns = (double *)(void *)next;
    out->amplitude = next + 2 * count;
    out->expected = out->amplitude + 4 * count;
    return next + WAVE_FLOATS * count;
}

static bool reserve_tables(sea_memory *memory, sea_cascade *c) {
    const size_t n = c->n, modes = n * c->strips * FFT_LANES;
    float *next = bolan_sea_reserve(memory, bolan_cascade_table_bytes(c));
    if (!next) return false;
    next = lay_waves(next, modes, &c->modes);
    c->inverse_k = lay_waves(next, PARTS, &c->parts);
    c->k_cos = c->inverse_k + modes;
    c->k_sin = c->k_cos + n;
    c->cubic = c->k_sin + n;
    c->linear = c->cubic + n;
    return true;
}

static double sinc(double x) {
    double s, c;
    bolan_sincos(x, &s, &c);
    return fabs(x) > 1e-9 ? s / x : 1.0;
}

// Wave numbers and divisors (spline.h).
static void fill_factors(sea_cascade *c) {
    const double dk = 2.0 * BOLAN_PI / c->length;
    for (uint32_t i = 0; i < c->n; i++) {
        const double index = i < c->n / 2 ? (double)i : (double)i - c->n, k = dk * index;
        const double left = sinc(BOLAN_PI * index / c->n), cubic = 1.0 / (left * left * left * left);
        double sine, cosine;
        bolan_sincos(2.0 * BOLAN_PI * index / c->n, &sine, &cosine);
        const double linear = 1.0 / sqrt((2.0 + cosine) / 3.0);
        c->k_cos[i] = (float)(k * c->cosine);
        c->k_sin[i] = (float)(k * c->sine);
        c->cubic[i] = (float)cubic;
        c->linear[i] = (float)linear;
    }
}

uint32_t bolan_sea_mode_rows(const bolan_sea *sea, uint32_t cascade) {
    BOLAN_ASSERT(sea && cascade < sea->shared->cascades);
    const sea_cascade *c = &cascade_tables_of(sea->shared)->cascade[cascade];
    return (uint32_t)rows_of(c);
}

// The table has i >= 0 alone: h(-k) is the conjugate of h(k). j >= 0.
static bolan_sea_mode mode_at(const sea_cascade *c, uint32_t part, uint32_t i, uint32_t j) {
    const bool mirrored = i >= c->n / 2;
    const uint32_t column = mirrored ? c->n - i : i, row = mirrored ? (c->n - j) % c->n : j;
    const size_t at = (size_t)(column / FFT_LANES) * c->n + row, lane = column % FFT_LANES;
    const float sign = mirrored ? -1.0f : 1.0f;
    const bool there = part == 0 ? column / FFT_LANES < c->strips : has_parts((int32_t)column, (int32_t)j);
    if (!there) return (bolan_sea_mode){.turns = 0.0};
    const sea_waves *waves = part == 0 ? &c->modes : &c->parts;
    const size_t from = part == 0 ? at : sea_part_row(part, mirrored ? -(int32_t)j : (int32_t)j);
    const float *a = waves->amplitude + from * 4 * FFT_LANES + lane;
    return (bolan_sea_mode){
        .a = {a[0], a[FFT_LANES], sign * a[2 * FFT_LANES], sign * a[3 * FFT_LANES]},
        .inverse_k = c->inverse_k[at * FFT_LANES + lane],
        .turns = waves->turns[from * FFT_LANES + lane],
    };
}

void bolan_sea_modes(const bolan_sea *sea, uint32_t cascade, uint32_t part, uint32_t j, bolan_sea_mode *out) {
    BOLAN_ASSERT(sea && out && part < SEA_PARTS && j < bolan_sea_mode_rows(sea, cascade));
    const sea_cascade *c = &cascade_tables_of(sea->shared)->cascade[cascade];
    for (uint32_t i = 0; i < c->n; i++) {
        out[i] = mode_at(c, part, i, j);
        out[i].cubic = c->cubic[i] * c->cubic[j];
        out[i].linear = c->linear[i] * c->linear[j];
    }
}

// The wave in a lane of a row of a table, of the mode (i, j).
static sea_mode wave_at(const sea_cascade *c, const sea_waves *waves, size_t row, uint32_t lane, uint32_t i,
                        int32_t j) {
    const double dk = 2.0 * BOLAN_PI / c->length, u = dk * i, v = dk * j;
    const float *a = waves->amplitude + row * 4 * FFT_LANES + lane;
    const float *e = waves->expected + row * 2 * FFT_LANES + lane;
    const double a0 = a[0], a1 = a[FFT_LANES], a2 = a[2 * FFT_LANES], a3 = a[3 * FFT_LANES];
    const size_t mode = (size_t)(i / FFT_LANES) * c->n + ((uint32_t)j & (c->n - 1));
    return (sea_mode){.kx = u * c->cosine - v * c->sine,
                      .ky = u * c->sine + v * c->cosine,
                      .turns = waves->turns[row * FFT_LANES + lane],
                      .inverse_k = c->inverse_k[mode * FFT_LANES + lane],
                      .re = 0.5 * (a0 - a3),
                      .im = 0.5 * (a1 + a2),
                      .back_re = 0.5 * (a0 + a3),
                      .back_im = 0.5 * (a2 - a1),
                      .expected = e[0],
                      .expected_back = e[FFT_LANES],
                      .paired = i > 0};
}

void bolan_sea_each_mode(const sea_cascade *c, sea_visit *visit, void *context) {
    for (size_t row = 0; row < (size_t)c->strips * c->n; row++) {
        const uint32_t index = (uint32_t)row % c->n, strip = (uint32_t)row / c->n;
        const int32_t j = index < c->n / 2 ? (int32_t)index : (int32_t)index - (int32_t)c->n;
        for (uint32_t lane = 0; lane < FFT_LANES; lane++) {
            const uint32_t i = strip * FFT_LANES + lane, parts = has_parts((int32_t)i, j) ? SEA_PARTS : 1;
            for (uint32_t part = 0; part < parts; part++) {
                const sea_waves *waves = part == 0 ? &c->modes : &c->parts;
                const size_t from = part == 0 ? row : sea_part_row(part, j);
                if (waves->turns[from * FFT_LANES + lane] == 0.0) continue;
                const sea_mode mode = wave_at(c, waves, from, lane, i, j);
                visit(context, &mode);
            }
        }
    }
}

// On i = 0 both k and -k are entries, each with both directions: count the forward one of each.
static void add_expected(void *context, const sea_mode *m) {
    sea_cascade *c = context;
    const double e = m->expected + (m->paired ? m->expected_back : 0.0);
    const double k2 = m->kx * m->kx + m->ky * m->ky, g = k2 * m->inverse_k * m->inverse_k;
    c->band->variance += e;
    c->slope[0] += e * m->kx * m->kx;
    c->slope[1] += e * m->kx * m->ky;
    c->slope[2] += e * m->ky * m->ky;
    c->displacement += e * g;
}

bool bolan_cascade_fill(sea_shared *shared, sea_cascade *c, uint32_t index, const spectrum_eval *eval,
                        const sea_radial *radial, const cascade_fine_spectrum *fine) {
    bolan_cascade_set_reach(c);
    if (!reserve_tables(&shared->memory, c)) return false;
    fill_factors(c);
    fill f = {shared, c, eval, radial, fine, bolan_sea_mix(bolan_sea_mix(shared->desc.seed) ^ (index + 1))};
    bolan_parallel(c->strips, 1, fill_strips, &f);
    bolan_sea_each_mode(c, add_expected, c);
    return true;
}

bool bolan_cascades_modes(sea_shared *shared, const spectrum_eval *eval, const sea_radial *radial) {
    cascade_tables *t = shared->tables;
    for (uint32_t i = 0; i < shared->cascades; i++)
        if (!bolan_cascade_fill(shared, &t->cascade[i], i, eval, radial, NULL)) return false;
    return true;
}

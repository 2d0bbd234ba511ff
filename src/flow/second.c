// SPDX-License-Identifier: MIT
// The potential of second order of each cascade: its waves, and its fields at a time (second.h has the plan).
#include "flow/second.h"
#include "spectrum/portable.h"
#include "waves/sea.h"

#include <string.h>

// Bands whose waves have less than this share of the sea's velocity at the surface have no potential of their own.
#define LEAST_SHARE 2e-3
#define LEAST_BED 1e-5 // of second_wave.bed

// ---- creation -------------------------------------------------------------------------------------------------------

static void add_wave(flow_second *s, const flow_mode *m, double re, double im, int32_t i, int32_t j, double depth) {
    const double unit = 2.0 * BOLAN_PI / s->frame.length, k = unit * sqrt((double)(i * i + j * j));
    const double tanh = portable_tanh(k * depth), bed = 1.0 / (tanh * tanh) - 1.0, omega = 2.0 * BOLAN_PI * m->turns;
    const double energy = 2.0 * (re * re + im * im);
    if (!(energy > 0.0)) return;
    s->waves[s->wave_count++] =
        (second_wave){.turns = m->turns,
                      .re = (float)(2.0 * re),
                      .im = (float)(2.0 * im),
                      .omega = (float)omega,
                      .across = {(float)(unit * i / (k * tanh)), (float)(unit * j / (k * tanh))},
                      .bed = (float)(bed > LEAST_BED ? bed : 0.0),
                      .i = (int16_t)i,
                      .j = (int16_t)j};
    s->head += 0.5 * omega * omega * bed * energy;
}

// The waves along k and along -k of a mode of a tile; at j = 0 both are modes.
static void add_mode(flow_second *s, const flow_tile *t, uint32_t strip, const flow_mode *m, double depth) {
    const int32_t i = m->row < t->frame.n / 2 ? (int32_t)m->row : (int32_t)m->row - (int32_t)t->frame.n;
    const int32_t j = (int32_t)(strip * FFT_LANES + m->lane);
    if (i > s->reach || i < -s->reach || j > s->reach) return;
    add_wave(s, m, (double)m->re, (double)m->im, i, j, depth);
    if (j > 0) add_wave(s, m, (double)m->back_re, -(double)m->back_im, -i, -j, depth);
}

static uint32_t most_waves(const bolan_flow *flow, uint32_t band) {
    uint32_t count = 0;
    for (uint32_t i = 0; i < flow->tiles; i++)
        if (flow->tile[i].band == band) count += 2 * flow->tile[i].mode_count;
    return count;
}

// Variance of the velocity at the surface, in deep water.
static double motion_of(const bolan_flow *flow, uint32_t band) {
    double sum = 0.0;
    for (uint32_t i = 0; i < flow->tiles; i++) {
        const flow_tile *t = &flow->tile[i];
        for (int b = 0; b < FLOW_BINS; b++)
            if (t->band == band) sum += t->levels.bin[b].energy * t->levels.bin[b].k * BOLAN_GRAVITY;
    }
    return sum;
}

static void gather(const bolan_flow *flow, flow_second *s) {
    for (uint32_t i = 0; i < flow->tiles; i++) {
        const flow_tile *t = &flow->tile[i];
        for (uint32_t strip = 0; t->band == s->band && strip < t->strips; strip++)
            for (uint32_t m = t->first[strip]; m < t->first[strip + 1]; m++)
                add_mode(s, t, strip, &t->modes[m], flow->depth);
    }
}

static bool add_band(bolan_flow *flow, uint32_t band, double keep) {
    flow_second *s = &flow->second[flow->seconds];
    memset(s, 0, sizeof *s);
    s->band = band;
    for (uint32_t i = 0; i < flow->tiles; i++) {
        const flow_tile *t = &flow->tile[i];
        if (t->band == band) s->frame = t->frame;
    }
    s->frame.n = flow->seconds == 0 ? SECOND_FINE : SECOND_COARSE;
    s->reach = (int32_t)s->frame.n / 3;
    const uint32_t most = most_waves(flow, band), row = (uint32_t)s->reach + 1;
    const size_t samples = (size_t)s->frame.n * s->frame.n;
    s->texels = bolan_sea_reserve(&flow->memory, samples * FLOW_TEXEL * sizeof(float) + row * row * sizeof *s->cells +
                                                     most * (sizeof *s->waves + sizeof *s->evolved));
    if (!s->texels) return false;
    s->waves = (second_wave *)(void *)(s->texels + samples * FLOW_TEXEL);
    s->evolved = (float(*)[2])(void *)(s->waves + most);
    s->cells = (second_cell *)(void *)(s->evolved + most);
    gather(flow, s);
    bolan_flow_second_gains(s, flow->depth, keep);
    flow->seconds++;
    return true;
}

// The plans and the planes of the grids that there are.
static bool reserve_planes(bolan_flow *flow) {
    static const uint32_t sides[2] = {SECOND_COARSE, SECOND_FINE};
    size_t samples = 0;
    for (uint32_t i = 0; i < flow->seconds; i++) {
        const uint32_t n = flow->second[i].frame.n;
        fft_plan *plan = &flow->second_plan[n == SECOND_FINE];
        samples = samples > (size_t)n * n ? samples : (size_t)n * n;
        if (plan->n == 0 && !bolan_fft_plan_create(sides[n == SECOND_FINE], plan)) return false;
    }
    const size_t planes = SECOND_PLANES + flow->slots;
    flow->second_planes = bolan_sea_reserve(&flow->memory, planes * 2 * samples * sizeof(float));
    return flow->second_planes != NULL;
}

bool bolan_flow_create_second(bolan_flow *flow, const bolan_sea *sea) {
    double all = 0.0;
    flow->is_second = true;
    flow->second = bolan_sea_reserve(&flow->memory, BOLAN_MAX_CASCADES * sizeof *flow->second);
    if (!flow->second) return false;
    for (uint32_t b = 0; b < flow->bands; b++) all += motion_of(flow, b);
    for (uint32_t b = 0; b < flow->bands; b++) {
        if (!(motion_of(flow, b) > LEAST_SHARE * LEAST_SHARE * all)) continue;
        if (!add_band(flow, b, sea->shared->bound_keep)) return false;
    }
    return flow->seconds == 0 || reserve_planes(flow);
}

// ---- a time ---------------------------------------------------------------------------------------------------------

typedef struct step {
    bolan_flow *flow;
    flow_second *second;
} step;

// A complex plane: [strip of y][x][FFT_ROW].
static size_t plane_floats(const step *s) { return 2 * (size_t)s->second->frame.n * s->second->frame.n; }
static float *plane_of(const step *s, uint32_t index) { return s->flow->second_planes + index * plane_floats(s); }

// Each thread owns a plane.
static void run(step *s, uint32_t items, flow_work *work) {
    bolan_flow_share(s->flow, items, plane_of(s, SECOND_PLANES), plane_floats(s), work, s);
}

// Place of the complex value (i, j) of a plane, whose imaginary part is FFT_LANES farther.
static size_t at(const step *s, uint32_t i, uint32_t j) {
    return ((size_t)(j / FFT_LANES) * s->second->frame.n + i) * FFT_ROW + j % FFT_LANES;
}
static uint32_t wrapped(const step *s, int32_t index) {
    const uint32_t n = s->second->frame.n;
    return ((uint32_t)index + n) & (n - 1);
}

// A strip holds an index of at most `reach`.
static bool is_within(const step *s, uint32_t strip, int32_t reach) {
    const int32_t n = (int32_t)s->second->frame.n, first = (int32_t)strip * FFT_LANES;
    return first <= reach || first + FFT_LANES - 1 >= n - reach;
}

// FFT along the rows of a plane into another, whose axes are exchanged. Rows beyond `reach` count as 0.
static void transform_rows(const step *s, float *from, float *to, int32_t reach) {
    const uint32_t n = s->second->frame.n;
    const fft_plan *plan = &s->flow->second_plan[n == SECOND_FINE];
    for (uint32_t strip = 0; strip < n / FFT_LANES; strip++) {
        float *rows = from + (size_t)strip * n * FFT_ROW;
        const bool any = is_within(s, strip, reach);
        if (any) s->flow->transform(plan, rows);
        for (uint32_t lane = 0; lane < FFT_LANES; lane++) {
            for (uint32_t x = 0; x < n; x++) {
                const float *value = rows + (size_t)plan->order[x] * FFT_ROW + lane;
                float *out = to + at(s, strip * FFT_LANES + lane, x);
                out[0] = any ? value[0] : 0.0f;
                out[FFT_LANES] = any ? value[FFT_LANES] : 0.0f;
            }
        }
    }
}

// sum of plane e^{+ik.x}, not normalised, in place. Index j of what there is, and i of what is wanted, is at most
// `given` and `wanted`.
static void transform(const step *s, float *plane, float *scratch, int32_t given, int32_t wanted) {
    transform_rows(s, plane, scratch, given);
    transform_rows(s, scratch, plane, wanted);
}

// ---- fields ---------------------------------------------------------------------------------------------------------

// A field is (-i w)^rate times a factor of its kind times A.
typedef enum kind { SURFACE, EAST, NORTH, BED } kind; // 1; w across; w^2 bed
enum { U, U1, U2, V, V1, V2, ETA, W, W1, W2, T, T1 };
static const struct {
    kind what;
    int rate;
} fields[SECOND_FIELDS] = {[U] = {EAST, 0},     [U1] = {EAST, 1},    [U2] = {EAST, 2},     [V] = {NORTH, 0},
                           [V1] = {NORTH, 1},   [V2] = {NORTH, 2},   [ETA] = {SURFACE, 0}, [W] = {SURFACE, 1},
                           [W1] = {SURFACE, 2}, [W2] = {SURFACE, 3}, [T] = {BED, 1},       [T1] = {BED, 2}};

static void evolve_waves(flow_second *second, double time) {
    for (uint32_t i = 0; i < second->wave_count; i++) {
        const second_wave *w = &second->waves[i];
        const double turns = w->turns * time;
        float sine, cosine;
        bolan_sincosf((float)(2.0 * BOLAN_PI * (turns - floor(turns + 0.5))), &sine, &cosine);
        second->evolved[i][0] = w->re * cosine + w->im * sine;
        second->evolved[i][1] = w->im * cosine - w->re * sine;
    }
}

static float factor_of(const second_wave *w, kind what) {
    switch (what) {
    case EAST: return w->omega * w->across[0];
    case NORTH: return w->omega * w->across[1];
    case BED: return w->omega * w->omega * w->bed;
    default: return 1.0f;
    }
}

static void make_field(void *context, uint32_t index, float *scratch) {
    const step *s = context;
    float *plane = plane_of(s, index);
    int32_t reach = 0;
    memset(plane, 0, plane_floats(s) * sizeof *plane);
    for (uint32_t n = 0; n < s->second->wave_count; n++) {
        const second_wave *w = &s->second->waves[n];
        const float f = factor_of(w, fields[index].what);
        float re = f * s->second->evolved[n][0], im = f * s->second->evolved[n][1];
        for (int rate = 0; rate < fields[index].rate; rate++) { // times -i w
            const float turned = w->omega * im;
            im = -w->omega * re;
            re = turned;
        }
        float *out = plane + at(s, wrapped(s, w->i), wrapped(s, w->j));
        out[0] += re;
        out[FFT_LANES] += im;
        reach = w->j > reach ? w->j : -w->j > reach ? -w->j : reach;
    }
    transform(s, plane, scratch, reach, (int32_t)s->second->frame.n);
}

// ---- products -------------------------------------------------------------------------------------------------------

// Re(a conj b) with sign 1, Re(a b) with sign -1.
static float product(const step *s, size_t p, int a, int b, float sign) {
    const float *x = plane_of(s, (uint32_t)a) + p, *y = plane_of(s, (uint32_t)b) + p;
    return x[0] * y[0] + sign * (x[FFT_LANES] * y[FFT_LANES]);
}

// Q of differences and of sums, dQ/dt likewise: horizontal part, and as the imaginary part the vertical one.
static void multiply(void *context, uint32_t strip, float *scratch) {
    const step *s = context;
    (void)scratch;
    const size_t rows = (size_t)s->second->frame.n * FFT_ROW, first = strip * rows;
    for (int sums = 0; sums < 2; sums++) {
        const float sign = sums ? -1.0f : 1.0f;
        float *q = plane_of(s, SECOND_FIELDS + (uint32_t)sums), *rate = plane_of(s, SECOND_FIELDS + 2 + (uint32_t)sums);
        for (size_t row = first; row < first + rows; row += FFT_ROW) {
            for (size_t p = row; p < row + FFT_LANES; p++) {
                q[p] = -(product(s, p, U1, U, sign) + product(s, p, V1, V, sign));
                q[p + FFT_LANES] = -product(s, p, W1, W, sign) - 0.5f * product(s, p, ETA, T, sign);
                rate[p] = -(product(s, p, U2, U, sign) + product(s, p, U1, U1, sign)) -
                          (product(s, p, V2, V, sign) + product(s, p, V1, V1, sign));
                rate[p + FFT_LANES] = -(product(s, p, W2, W, sign) + product(s, p, W1, W1, sign)) -
                                      0.5f * (product(s, p, W, T, sign) + product(s, p, ETA, T1, sign));
            }
        }
    }
}

static void transform_products(void *context, uint32_t item, float *scratch) {
    const step *s = context;
    transform(s, plane_of(s, SECOND_FIELDS + item), scratch, (int32_t)s->second->frame.n, s->second->reach);
}

// ---- potentials -----------------------------------------------------------------------------------------------------

// phi2 (rate 0) or dphi2/dt (rate 1) of K = (i, j). Two real fields A and B share a plane X, whose transform has the
// other sign: A = (X(-K) + conj X(K)) / 2, B = (X(-K) - conj X(K)) / 2i.
static void potential(const step *s, uint32_t rate, int32_t i, int32_t j, const second_cell *cell, float out[2]) {
    out[0] = out[1] = 0.0f;
    for (uint32_t sums = 0; sums < 2; sums++) {
        const float *plane = plane_of(s, SECOND_FIELDS + 2 * rate + sums);
        const float *x = plane + at(s, wrapped(s, i), wrapped(s, j));
        const float *y = plane + at(s, wrapped(s, -i), wrapped(s, -j));
        const float re = y[0], im = y[FFT_LANES], cre = x[0], cim = -x[FFT_LANES];
        const float h = cell->gain[2 * sums], v = cell->gain[2 * sums + 1];
        out[0] += h * (re + cre) + v * (im - cim);
        out[1] += h * (im + cim) - v * (re - cre);
    }
    const float n = (float)s->second->frame.n, scale = 0.5f / (n * n);
    out[0] *= scale;
    out[1] *= scale;
}

// Fields 2 item and 2 item + 1 of the texels: two levels of phi2 or of dphi2/dt.
static void make_levels(void *context, uint32_t item, float *scratch) {
    const step *s = context;
    float *plane = plane_of(s, item); // the fields are done with
    const uint32_t n = s->second->frame.n, rate = 2 * item / SECOND_LEVELS, level = 2 * item % SECOND_LEVELS;
    const int32_t reach = s->second->reach;
    memset(plane, 0, plane_floats(s) * sizeof *plane);
    for (int32_t i = -reach; i <= reach; i++) {
        for (int32_t j = -reach; j <= reach; j++) {
            const int32_t row = i < 0 ? -i : i, column = j < 0 ? -j : j;
            const second_cell *cell = &s->second->cells[row * (reach + 1) + column];
            const float a = cell->level[level], b = cell->level[level + 1];
            float phi[2], *out = plane + at(s, wrapped(s, i), wrapped(s, j));
            if (a == 0.0f && b == 0.0f) continue;
            potential(s, rate, i, j, cell, phi);
            out[0] = a * phi[0] - b * phi[1];
            out[FFT_LANES] = a * phi[1] + b * phi[0];
        }
    }
    transform(s, plane, scratch, reach, (int32_t)n);
    for (uint32_t y = 0; y < n; y++) {
        for (uint32_t x = 0; x < n; x++) {
            const float *from = plane + at(s, x, y);
            float *out = s->second->texels + ((size_t)y * n + x) * FLOW_TEXEL + 2 * (size_t)item;
            out[0] = from[0];
            out[1] = from[FFT_LANES];
        }
    }
}

void bolan_flow_evolve_second(bolan_flow *flow, double shown) {
    for (uint32_t i = 0; i < flow->seconds; i++) {
        step s = {.flow = flow, .second = &flow->second[i]};
        evolve_waves(s.second, shown);
        run(&s, SECOND_FIELDS, make_field);
        run(&s, s.second->frame.n / FFT_LANES, multiply);
        run(&s, SECOND_PACKS, transform_products);
        run(&s, SECOND_LEVELS, make_levels);
    }
}

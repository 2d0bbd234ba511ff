// SPDX-License-Identifier: MIT
// A sea taken apart into wind sea and swells: the basins of the surface S(f, th), a watershed (Hanson & Phillips,
// J. Atmos. Oceanic Technol. 18, 2001; Portilla, Ocampo-Torres & Monbaliu, ibid. 26, 2009).
//
//     sample ──► smooth ──► flood from the peaks down ──► fold small ones ──► merge near ones ──► wind sea or swell
//                           (basins that meet high join)   into the nearest    (spread criterion)
//
// Every cell with energy belongs to one partition, so that the variances add up to that of the sea.
#include "bolan/math.h"
#include "bolan/spectrum.h"
#include "spectrum/measured.h"
#include "spectrum/portable.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { NONE = -1, SMALL = -2, MOST_BASINS = 128 };

#define VALLEY 0.65      // peaks that meet above this share of the lower one are one (Hanson & Phillips, 4.b)
#define SPREAD 0.4       // kappa: and peaks that lie within this share of either spread (ibid.)
#define LEAST_SHARE 0.01 // of the variance: a smaller basin is noise
#define WAVE_AGE 1.5     // waves slower than this many wind speeds along the wind are driven by it (ibid., eq. 2)
#define PM_ALPHA 0.0081

typedef struct cell {
    double energy; // smoothed
    uint32_t index;
} cell;

typedef struct sampled {
    uint32_t rows, columns;
    const double *omega, *theta, *energy; // [row], [column], [row][column]: S(w, th)
    double *peak;                         // energy of each basin's peak; begins the one allocation of this and
    cell *cells;                          // the smoothed surface
    int32_t *basin;                       // of each cell, NONE or SMALL
    int32_t *parent;                      // of basins that joined another
    size_t bytes;
} sampled;

// Sums over a basin.
typedef struct sums {
    double m0, x, y, xx; // of fx, fy, fx^2 + fy^2
    double cosine, sine;
    uint32_t row, column; // of the peak
    bool wind_sea;
} sums;

// ---- the surface ----------------------------------------------------------------------------------------------------

static bolan_result allocate(const bolan_measured_spectrum *spectrum, sampled *s) {
    *s = (sampled){.rows = spectrum->frequency_count,
                   .columns = spectrum->direction_count,
                   .omega = spectrum->omega,
                   .theta = spectrum->theta,
                   .energy = spectrum->density};
    const size_t n = (size_t)s->rows * s->columns;
    s->bytes = (sizeof(double) + sizeof(cell) + 2 * sizeof(int32_t)) * n;
    s->peak = bolan_allocate(s->bytes);
    if (!s->peak) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY,
                  "the partition of a sea needs %zu bytes, which could not be allocated", s->bytes);
        return BOLAN_ERROR_MEMORY;
    }
    s->cells = (cell *)(void *)(s->peak + n);
    s->basin = (int32_t *)(void *)(s->cells + n);
    s->parent = s->basin + n;
    return BOLAN_OK;
}

static uint32_t neighbour(const sampled *s, uint32_t row, uint32_t column, int rows, int columns) {
    const int r = (int)row + rows, last = (int)s->rows - 1, n = (int)s->columns;
    return (uint32_t)(r < 0 ? 0 : r > last ? last : r) * s->columns + (uint32_t)(((int)column + columns + n) % n);
}

// One pass of the binomial filter over 3 x 3 cells, for the borders alone: energies are summed unsmoothed.
static void smooth(sampled *s) {
    for (uint32_t i = 0; i < s->rows; i++)
        for (uint32_t j = 0; j < s->columns; j++) {
            double sum = 0.0;
            for (int r = -1; r <= 1; r++)
                for (int c = -1; c <= 1; c++) sum += (2 - abs(r)) * (2 - abs(c)) * s->energy[neighbour(s, i, j, r, c)];
            const uint32_t index = i * s->columns + j;
            s->cells[index] = (cell){sum / 16.0, index};
        }
}

// ---- the flood ------------------------------------------------------------------------------------------------------

static int by_energy(const void *a, const void *b) {
    const cell *x = a, *y = b;
    if (x->energy != y->energy) return x->energy > y->energy ? -1 : 1;
    return (x->index > y->index) - (x->index < y->index);
}

static int32_t root_of(sampled *s, int32_t basin) {
    while (s->parent[basin] != basin) basin = s->parent[basin] = s->parent[s->parent[basin]];
    return basin;
}

// From the highest cell down: a cell without labelled neighbours is a peak; one between two basins is where they meet.
static int32_t flood(sampled *s) {
    const uint32_t n = s->rows * s->columns;
    int32_t count = 0;
    qsort(s->cells, n, sizeof *s->cells, by_energy);
    for (uint32_t i = 0; i < n; i++) s->basin[i] = NONE;
    for (uint32_t k = 0; k < n && s->cells[k].energy > 0.0; k++) {
        const uint32_t row = s->cells[k].index / s->columns, column = s->cells[k].index % s->columns;
        int32_t mine = NONE;
        for (int i = 0; i < 9; i++) {
            const uint32_t at = neighbour(s, row, column, i / 3 - 1, i % 3 - 1);
            if (s->basin[at] == NONE) continue;
            const int32_t other = root_of(s, s->basin[at]);
            if (mine == NONE || other == mine) {
                mine = other;
                continue;
            }
            const int32_t high = s->peak[mine] >= s->peak[other] ? mine : other, low = mine + other - high;
            if (s->cells[k].energy >= VALLEY * s->peak[low]) s->parent[low] = high;
            mine = high;
        }
        if (mine == NONE) {
            mine = count++;
            s->parent[mine] = mine;
            s->peak[mine] = s->cells[k].energy;
        }
        s->basin[s->cells[k].index] = mine;
    }
    for (uint32_t i = 0; i < n; i++)
        if (s->basin[i] != NONE) s->basin[i] = root_of(s, s->basin[i]);
    return count;
}

// ---- basins ---------------------------------------------------------------------------------------------------------

static double weight_of(const sampled *s, uint32_t row) {
    return bolan_spectrum_trapezoid_weight(s->omega, s->rows, row) * 2.0 * BOLAN_PI / s->columns;
}

static void add_cell(const sampled *s, uint32_t index, sums *sum) {
    const uint32_t row = index / s->columns, column = index % s->columns;
    const double e = s->energy[index] * weight_of(s, row), w = s->omega[row];
    double sine, cosine;
    bolan_sincos(s->theta[column], &sine, &cosine);
    const bool first = !(sum->m0 > 0.0);
    sum->m0 += e;
    sum->x += e * w * cosine;
    sum->y += e * w * sine;
    sum->xx += e * w * w;
    sum->cosine += e * cosine;
    sum->sine += e * sine;
    if (!first && s->energy[index] <= s->energy[sum->row * s->columns + sum->column]) return;
    sum->row = row;
    sum->column = column;
}

// The sums of every basin, and the numbers 0, 1, ... for those with a share of the variance.
static uint32_t sum_basins(sampled *s, int32_t count, sums out[MOST_BASINS]) {
    double *m0 = s->peak, whole = 0.0; // the peaks have done their duty
    uint32_t kept = 0;
    memset(m0, 0, (size_t)count * sizeof *m0);
    for (uint32_t i = 0; i < s->rows * s->columns; i++)
        if (s->basin[i] != NONE) m0[s->basin[i]] += s->energy[i] * weight_of(s, i / s->columns);
    for (int32_t b = 0; b < count; b++) whole += m0[b];
    for (int32_t b = 0; b < count; b++)
        s->parent[b] = m0[b] >= LEAST_SHARE * whole && m0[b] > 0.0 && kept < MOST_BASINS ? (int32_t)kept++ : NONE;
    for (uint32_t b = 0; b < kept; b++) out[b] = (sums){.m0 = 0.0};
    for (uint32_t i = 0; i < s->rows * s->columns; i++) {
        if (s->basin[i] == NONE) continue;
        s->basin[i] = s->parent[s->basin[i]];
        if (s->basin[i] == NONE) {
            s->basin[i] = SMALL;
        } else {
            add_cell(s, i, &out[s->basin[i]]);
        }
    }
    return kept;
}

// Squared distance [(rad/s)^2] of two points of the plane (w cos th, w sin th).
static double distance2(const sampled *s, uint32_t row, uint32_t column, const sums *to) {
    const double a = s->omega[row], b = s->omega[to->row];
    double sine, cosine;
    bolan_sincos(s->theta[column] - s->theta[to->column], &sine, &cosine);
    return a * a + b * b - 2.0 * a * b * cosine;
}

// The cells of small basins go to the nearest peak.
static void fold_small(sampled *s, sums *basins, uint32_t count) {
    for (uint32_t i = 0; i < s->rows * s->columns; i++) {
        if (s->basin[i] != SMALL) continue;
        uint32_t best = 0;
        double least = HUGE_VAL;
        for (uint32_t b = 0; b < count; b++) {
            const double d = distance2(s, i / s->columns, i % s->columns, &basins[b]);
            if (d < least) least = d, best = b;
        }
        s->basin[i] = (int32_t)best;
        const uint32_t row = basins[best].row, column = basins[best].column;
        add_cell(s, i, &basins[best]);
        basins[best].row = row, basins[best].column = column; // the peak stays
    }
}

// Variance of (w cos th, w sin th) over a basin.
static double spread2(const sums *b) { return b->xx / b->m0 - (b->x * b->x + b->y * b->y) / (b->m0 * b->m0); }

static void join(sampled *s, sums *basins, uint32_t *count, uint32_t into, uint32_t from) {
    sums *a = &basins[into], *b = &basins[from];
    const double ea = s->energy[a->row * s->columns + a->column], eb = s->energy[b->row * s->columns + b->column];
    if (eb > ea) a->row = b->row, a->column = b->column;
    a->m0 += b->m0, a->x += b->x, a->y += b->y, a->xx += b->xx;
    a->cosine += b->cosine, a->sine += b->sine;
    const uint32_t last = --*count;
    for (uint32_t i = 0; i < s->rows * s->columns; i++) {
        if (s->basin[i] == (int32_t)from) s->basin[i] = (int32_t)into;
        if (s->basin[i] == (int32_t)last && last != from) s->basin[i] = (int32_t)from;
    }
    if (last != from) basins[from] = basins[last];
}

static bool touch(const sampled *s, uint32_t a, uint32_t b) {
    for (uint32_t i = 0; i < s->rows * s->columns; i++) {
        if (s->basin[i] != (int32_t)a) continue;
        for (int k = 0; k < 9; k++)
            if (s->basin[neighbour(s, i / s->columns, i % s->columns, k / 3 - 1, k % 3 - 1)] == (int32_t)b) return true;
    }
    return false;
}

// Neighbours whose peaks lie within the spread of either are one system.
static void merge_near(sampled *s, sums *basins, uint32_t *count) {
    for (uint32_t a = 0; a < *count; a++)
        for (uint32_t b = a + 1; b < *count; b++) {
            const double d = distance2(s, basins[a].row, basins[a].column, &basins[b]);
            if (d > SPREAD * fmax(spread2(&basins[a]), spread2(&basins[b])) || !touch(s, a, b)) continue;
            join(s, basins, count, a, b);
            a = (uint32_t)-1; // from the start, since the spread has grown
            break;
        }
}

// ---- wind sea or swell ----------------------------------------------------------------------------------------------

// With a wind: by wave age. Without: a peak above that of Pierson-Moskowitz at its frequency is young (Portilla et
// al.).
static bool is_wind_sea(const sampled *s, const bolan_sea_state *sea_state, uint32_t number, const sums *b) {
    const double w = s->omega[b->row];
    if (sea_state->wind_speed > 0.0) {
        double sine, cosine;
        bolan_sincos(s->theta[b->column] - bolan_compass_from_to_math(sea_state->wind_from_deg), &sine, &cosine);
        return BOLAN_GRAVITY / w < WAVE_AGE * sea_state->wind_speed * cosine;
    }
    double density = 0.0;
    for (uint32_t j = 0; j < s->columns; j++) {
        const uint32_t i = b->row * s->columns + j;
        if (s->basin[i] == (int32_t)number) density += s->energy[i] * 2.0 * BOLAN_PI / s->columns;
    }
    return density > PM_ALPHA * BOLAN_GRAVITY * BOLAN_GRAVITY * portable_exp(-1.25) / (w * w * w * w * w);
}

static void merge_wind_sea(sampled *s, const bolan_sea_state *sea_state, sums *basins, uint32_t *count) {
    for (uint32_t b = 0; b < *count; b++) basins[b].wind_sea = is_wind_sea(s, sea_state, b, &basins[b]);
    if (!(sea_state->wind_speed > 0.0)) return;
    for (uint32_t a = 0; a < *count; a++)
        for (uint32_t b = a + 1; b < *count;)
            if (basins[a].wind_sea && basins[b].wind_sea)
                join(s, basins, count, a, b);
            else
                b++;
}

// More than a list has room for: the smallest joins the nearest.
static void merge_smallest(sampled *s, sums *basins, uint32_t *count) {
    while (*count > BOLAN_MAX_PARTITIONS) {
        uint32_t small = 0, best = 0;
        double least = HUGE_VAL;
        for (uint32_t b = 1; b < *count; b++)
            if (basins[b].m0 < basins[small].m0) small = b;
        for (uint32_t b = 0; b < *count; b++) {
            const double d = distance2(s, basins[small].row, basins[small].column, &basins[b]);
            if (b != small && d < least) least = d, best = b;
        }
        join(s, basins, count, best, small);
    }
}

// ---- the list -------------------------------------------------------------------------------------------------------

// The period of the peak of S(w) over the partition.
static double peak_omega(const sampled *s, uint32_t number) {
    double best = 0.0, omega = 0.0;
    for (uint32_t i = 0; i < s->rows; i++) {
        double sum = 0.0;
        for (uint32_t j = 0; j < s->columns; j++)
            if (s->basin[i * s->columns + j] == (int32_t)number) sum += s->energy[i * s->columns + j];
        if (sum > best) best = sum, omega = s->omega[i];
    }
    return omega;
}

static int by_kind_and_height(const void *a, const void *b) {
    const bolan_partition *x = a, *y = b;
    if (x->wind_sea != y->wind_sea) return x->wind_sea ? -1 : 1;
    return (x->hs < y->hs) - (x->hs > y->hs);
}

static void describe(const sampled *s, const sums *b, uint32_t number, bolan_partition *out) {
    const double r1 = fmin(sqrt(b->cosine * b->cosine + b->sine * b->sine) / b->m0, 1.0);
    *out = (bolan_partition){
        .wind_sea = b->wind_sea,
        .hs = 4.0 * sqrt(b->m0),
        .tp = 2.0 * BOLAN_PI / peak_omega(s, number),
        .from_deg = bolan_math_to_compass_from(portable_angle(b->sine, b->cosine)),
        .spread_deg = bolan_degrees(sqrt(2.0 * (1.0 - r1))),
    };
}

static void find_partitions(sampled *s, const bolan_sea_state *sea_state, bolan_partition *out, uint32_t *count) {
    sums basins[MOST_BASINS];
    smooth(s);
    uint32_t found = sum_basins(s, flood(s), basins);
    if (found > 0) {
        fold_small(s, basins, found);
        merge_near(s, basins, &found);
        merge_wind_sea(s, sea_state, basins, &found);
        merge_smallest(s, basins, &found);
    }
    for (uint32_t b = 0; b < found; b++) describe(s, &basins[b], b, &out[b]);
    *count = found;
    qsort(out, found, sizeof *out, by_kind_and_height);
}

bolan_result bolan_sea_state_partition(const bolan_sea_state *sea_state, bolan_partition out[BOLAN_MAX_PARTITIONS],
                                       uint32_t *count) {
    BOLAN_ASSERT(sea_state && out && count);
    *count = 0;
    sampled s;
    bolan_measured_spectrum *spectrum = NULL;
    bolan_result result = bolan_measured_spectrum_sample(sea_state, &spectrum);
    if (!result) result = allocate(spectrum, &s);
    if (!result) {
        find_partitions(&s, sea_state, out, count);
        bolan_release(s.peak, s.bytes);
    }
    bolan_measured_spectrum_destroy(&spectrum);
    return result;
}

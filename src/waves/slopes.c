// SPDX-License-Identifier: MIT
// Slope variance that a footprint cannot resolve (Bruneton, Neyret & Holzschuch 2010, section 4): the modes' slope
// covariance, gathered over wave number and direction, times what a Gaussian footprint removes, 1 - exp(-sigma^2 k^2).
#include "shared/constants.glsl"
#include "spectrum/portable.h"
#include "waves/model.h"

#include <string.h>

// 4 bins an octave from 1e-4 rad/m; directions over half a turn, because k and -k have the same slopes.
enum { BINS = 112, DIRECTIONS = 16 };
#define BINS_PER_OCTAVE 4.0

typedef struct bin {
    double power, k2, xx, xy, yy; // k2: the sum of power k^2
} bin;

// Only the bins that hold waves are kept.
struct slope_map {
    uint32_t count;
    struct {
        double kx, ky, xx, xy, yy;
    } at[BINS * DIRECTIONS];
};

typedef struct gathering {
    double ratio; // of slope variance to k^2 variance
    bin bins[BINS][DIRECTIONS];
} gathering;

static void gather_mode(void *context, const sea_mode *m) {
    gathering *g = context;
    const double k2 = m->kx * m->kx + m->ky * m->ky,
                 power = g->ratio * (m->expected + (m->paired ? m->expected_back : 0.0));
    const double octave = 0.5 * portable_log(k2 * 1e8) / 0.69314718055994531;
    const int row = (int)fmin(fmax(octave * BINS_PER_OCTAVE, 0.0), BINS - 1.0);
    const int column = (int)(portable_angle(m->ky, m->kx) / BOLAN_PI * DIRECTIONS + 0.5) % DIRECTIONS;
    bin *b = &g->bins[row][column];
    b->power += power;
    b->k2 += power * k2;
    b->xx += power * m->kx * m->kx;
    b->xy += power * m->kx * m->ky;
    b->yy += power * m->ky * m->ky;
}

static void compact(const gathering *g, struct slope_map *map) {
    for (int row = 0; row < BINS; row++) {
        for (int column = 0; column < DIRECTIONS; column++) {
            const bin *b = &g->bins[row][column];
            if (!(b->power > 0.0)) continue;
            double s, c;
            bolan_sincos(BOLAN_PI * column / DIRECTIONS, &s, &c);
            const double k = sqrt(b->k2 / b->power);
            map->at[map->count].kx = k * c;
            map->at[map->count].ky = k * s;
            map->at[map->count].xx = b->xx;
            map->at[map->count].xy = b->xy;
            map->at[map->count++].yy = b->yy;
        }
    }
}

// Adds the slope covariance that a footprint removes of the waves of a map.
static void add_removed(const struct slope_map *map, double major, double minor, double angle, double out[3]) {
    double s, c;
    bolan_sincos(angle, &s, &c);
    const double ax = major * c, ay = major * s, bx = -minor * s, by = minor * c;
    for (uint32_t i = 0; i < map->count; i++) {
        const double a = ax * map->at[i].kx + ay * map->at[i].ky, b = bx * map->at[i].kx + by * map->at[i].ky;
        const double x = a * a + b * b, removed = x < 40.0 ? 1.0 - portable_exp(-x) : 1.0;
        out[0] += removed * map->at[i].xx;
        out[1] += removed * map->at[i].xy;
        out[2] += removed * map->at[i].yy;
    }
}

static void unresolved(const sea_shared *shared, double major, double minor, double angle, double out[3]) {
    memcpy(out, shared->rest_slope, 3 * sizeof(double));
    add_removed(shared->slope_map, major, minor, angle, out);
}

static void unresolved_floats(const sea_shared *shared, double major, double minor, double angle, float out[3]) {
    double covariance[3];
    const double turned = isfinite(angle) ? fmod(angle, 2.0 * BOLAN_PI) : 0.0;
    unresolved(shared, major, minor, turned, covariance);
    for (int i = 0; i < 3; i++) out[i] = (float)covariance[i];
}

void bolan_sea_unresolved_slopes(const bolan_sea *sea, double major, double minor, double angle, float out[3]) {
    BOLAN_ASSERT(sea && out);
    unresolved_floats(sea->shared, major, minor, angle, out);
}

const float *bolan_sea_slope_table(const bolan_sea *sea) {
    BOLAN_ASSERT(sea);
    return sea->shared->slope_table;
}

_Static_assert(SLOPE_TABLE_MAJOR == BOLAN_SLOPE_TABLE_MAJOR && SLOPE_TABLE_ASPECT == BOLAN_SLOPE_TABLE_ASPECT &&
                   SLOPE_TABLE_ANGLE == BOLAN_SLOPE_TABLE_ANGLE,
               "the shaders read the table that the public header states");

// What a footprint removes of the fine waves, over their variance; 1 where there are none.
static double removed_share(const struct slope_map *fine, double major, double minor, double angle) {
    double all = 0.0, removed[3] = {0.0};
    for (uint32_t i = 0; i < fine->count; i++) all += fine->at[i].xx + fine->at[i].yy;
    if (!(all > 0.0)) return 1.0;
    add_removed(fine, major, minor, angle, removed);
    return (removed[0] + removed[2]) / all;
}

typedef struct filling {
    sea_shared *shared;
    const struct slope_map *fine;
} filling;

// Task: rows [begin, end) of the table, one for each (angle, aspect).
static void fill_table(void *context, uint32_t begin, uint32_t end, uint32_t worker) {
    (void)worker;
    const filling *f = context;
    const sea_shared *shared = f->shared;
    for (uint32_t row = begin; row < end; row++) {
        const uint32_t l = row / BOLAN_SLOPE_TABLE_ASPECT, j = row % BOLAN_SLOPE_TABLE_ASPECT;
        for (uint32_t i = 0; i < BOLAN_SLOPE_TABLE_MAJOR; i++) {
            const double major = portable_pow(2.0, i / SLOPE_TABLE_PER_OCTAVE + SLOPE_TABLE_FIRST);
            float *texel = shared->slope_table + ((size_t)row * BOLAN_SLOPE_TABLE_MAJOR + i) * 4;
            const double minor = ldexp(major, -(int)j), angle = l * BOLAN_PI / BOLAN_SLOPE_TABLE_ANGLE;
            unresolved_floats(shared, major, minor, angle, texel);
            texel[3] = (float)removed_share(f->fine, major, minor, angle);
        }
    }
}

// Cox & Munk's up- and crosswind variance less what the waves hold; where one is exceeded, the other is lowered, so
// that the total is Cox & Munk's as long as the cascades hold less.
static void set_rest(sea_shared *shared) {
    double held[3] = {0.0}, up, cross, s, c;
    shared->model->slopes(shared, held);
    const double xx = held[0], xy = held[1], yy = held[2];
    bolan_cox_munk(shared->desc.sea_state.wind_speed, &up, &cross);
    bolan_sincos(bolan_compass_from_to_math(shared->desc.sea_state.wind_from_deg), &s, &c);
    up -= c * c * xx + 2.0 * c * s * xy + s * s * yy;
    cross -= s * s * xx - 2.0 * c * s * xy + c * c * yy;
    const double total = fmax(up + cross, 0.0);
    up = fmin(fmax(up, 0.0), total);
    cross = total - up;
    shared->rest_slope[0] = c * c * up + s * s * cross;
    shared->rest_slope[1] = c * s * (up - cross);
    shared->rest_slope[2] = s * s * up + c * c * cross;
}

static const size_t table_bytes =
    (size_t)BOLAN_SLOPE_TABLE_MAJOR * BOLAN_SLOPE_TABLE_ASPECT * BOLAN_SLOPE_TABLE_ANGLE * 4 * sizeof(float);

size_t bolan_sea_slopes_bytes(void) { return sizeof(struct slope_map) + table_bytes; }

// The table, with the fine waves gathered in `g` and `fine` meanwhile.
static void make_table(sea_shared *shared, gathering *g, struct slope_map *fine) {
    g->ratio = shared->slope_ratio;
    shared->model->each_wave(shared, gather_mode, g);
    compact(g, shared->slope_map);
    memset(g, 0, sizeof *g);
    g->ratio = 1.0;
    if (shared->model->each_fine) shared->model->each_fine(shared, gather_mode, g);
    compact(g, fine);
    filling f = {shared, fine};
    bolan_parallel(BOLAN_SLOPE_TABLE_ANGLE * BOLAN_SLOPE_TABLE_ASPECT, 1, fill_table, &f);
}

typedef struct gathered {
    gathering bins;
    struct slope_map fine;
} gathered;

bool bolan_sea_slopes_create(sea_shared *shared) {
    set_rest(shared);
    if (shared->model->create_fine && !shared->model->create_fine(shared)) return false;
    shared->slope_map = bolan_sea_reserve(&shared->memory, sizeof *shared->slope_map);
    shared->slope_table = shared->slope_map ? bolan_sea_reserve(&shared->memory, table_bytes) : NULL;
    gathered *g = shared->slope_table ? bolan_sea_borrow(sizeof *g) : NULL;
    if (!g) return false;
    make_table(shared, &g->bins, &g->fine);
    bolan_release(g, sizeof *g);
    return true;
}

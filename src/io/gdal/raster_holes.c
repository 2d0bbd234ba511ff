// SPDX-License-Identifier: MIT
// Fills samples without a value: with the ground around them, or with a sea bed.
//
// A sea bed begins at the coast and falls off like a sandy beach, depth = 0.1 m^(1/3) distance^(2/3) (Dean, J.
// Coastal Research 7, 1991, eq. 1, for sand of 0.2 mm), down to a shelf. It lies nowhere above the data around it, so
// that a hole in a survey of deep water stays deep. Distances are exact: Felzenszwalb & Huttenlocher, Theory of
// Computing 8, 2012.
#include "io/gdal/raster.h"

#include <string.h>

#define DEAN_A 0.1f       // [m^(1/3)]
#define SHELF_DEPTH 50.0f // [m]
#define MUCH_ZERO 0.1     // share of samples that are exactly 0 and get a warning

enum { DATA, HOLE, SEA };

typedef struct hole_map {
    int width, height;
    uint8_t *kind; // of each sample
    size_t known, holes, seas;
} hole_map;

// ---- which holes are sea --------------------------------------------------------------------------------------------

typedef struct seeds {
    uint32_t *at;
    size_t count, capacity;
} seeds;

static bool push(seeds *s, size_t index) {
    if (s->count == s->capacity) {
        const size_t capacity = s->capacity ? 2 * s->capacity : 4096;
        uint32_t *larger = bolan_enlarge(s->at, s->capacity * sizeof *larger, capacity * sizeof *larger);
        if (!larger) return false;
        s->at = larger, s->capacity = capacity;
    }
    s->at[s->count++] = (uint32_t)index;
    return true;
}

// One seed for every run of holes in [from, to] of a row.
static bool push_runs(const hole_map *m, seeds *s, int from, int to, int row) {
    if (row < 0 || row >= m->height) return true;
    const uint8_t *kind = m->kind + (size_t)row * (size_t)m->width;
    for (int i = from; i <= to; i++)
        if (kind[i] == HOLE && (i == from || kind[i - 1] != HOLE) &&
            !push(s, (size_t)row * (size_t)m->width + (size_t)i))
            return false;
    return true;
}

// Holes that reach the rim become sea, run by run.
static bool flood_from_rim(hole_map *m) {
    seeds s = {NULL, 0, 0};
    bool ok = push_runs(m, &s, 0, m->width - 1, 0) && push_runs(m, &s, 0, m->width - 1, m->height - 1);
    for (int j = 1; j < m->height - 1 && ok; j++)
        ok = push_runs(m, &s, 0, 0, j) && push_runs(m, &s, m->width - 1, m->width - 1, j);
    while (s.count > 0 && ok) {
        const uint32_t at = s.at[--s.count];
        if (m->kind[at] != HOLE) continue;
        const int row = (int)(at / (uint32_t)m->width);
        uint8_t *kind = m->kind + (size_t)row * (size_t)m->width;
        int from = (int)(at % (uint32_t)m->width), to = from;
        while (from > 0 && kind[from - 1] == HOLE) from--;
        while (to + 1 < m->width && kind[to + 1] == HOLE) to++;
        memset(kind + from, SEA, (size_t)(to - from + 1));
        ok = push_runs(m, &s, from, to, row - 1) && push_runs(m, &s, from, to, row + 1);
    }
    bolan_release(s.at, s.capacity * sizeof *s.at);
    return ok;
}

static void warn_of_zeros(const raster_source *s, const float *values, size_t count) {
    size_t zeros = 0, below = 0;
    for (size_t i = 0; i < count; i++) zeros += values[i] == 0.0f, below += values[i] < 0.0f;
    if ((double)zeros < MUCH_ZERO * (double)count || zeros < below) return;
    bolan_log(
        BOLAN_LOG_WARNING, BOLAN_LOG_RASTER_VALUES,
        "%s: %.0f %% of its elevations are exactly 0 and are drawn as land; if they are the sea, say zero_is: sea "
        "(zero_is: land ends this warning)",
        s->path, 100.0 * (double)zeros / (double)count);
}

static void warn_of_holes(const raster_source *s, const hole_map *m, size_t count) {
    const double percent = 100.0 / (double)count;
    if (m->holes + m->seas == 0 || s->desc->nodata != BOLAN_NODATA_AUTO) return;
    bolan_log(
        BOLAN_LOG_WARNING, BOLAN_LOG_RASTER_HOLES,
        "%s: %.3g %% of its samples are no-data: %.3g %% reach the rim and become sea, %.3g %% take the elevation "
        "around them (nodata: fill or sea says otherwise)",
        s->path, percent * (double)(m->holes + m->seas), percent * (double)m->seas, percent * (double)m->holes);
}

static void count_kinds(hole_map *m, size_t count) {
    m->known = m->holes = m->seas = 0;
    for (size_t i = 0; i < count; i++) {
        m->known += m->kind[i] == DATA;
        m->holes += m->kind[i] == HOLE;
        m->seas += m->kind[i] == SEA;
    }
}

static bool classify(const raster_source *s, float *values, hole_map *m) {
    const size_t count = (size_t)m->width * (size_t)m->height;
    const uint8_t hole = s->desc->nodata == BOLAN_NODATA_SEA ? SEA : HOLE;
    for (size_t i = 0; i < count; i++) m->kind[i] = isnan(values[i]) ? hole : DATA;
    if (s->desc->nodata == BOLAN_NODATA_AUTO && !flood_from_rim(m)) return false;
    count_kinds(m, count);
    if (m->known > 0) warn_of_holes(s, m, count);
    if (s->desc->zero == BOLAN_ZERO_AUTO) warn_of_zeros(s, values, count);
    for (size_t i = 0; s->desc->zero == BOLAN_ZERO_SEA && i < count; i++)
        if (values[i] == 0.0f) m->kind[i] = SEA, values[i] = NAN;
    count_kinds(m, count);
    return true;
}

// ---- the bed --------------------------------------------------------------------------------------------------------

#define FAR 1e15f // squared metres, beyond everything

// Squares of the distance along each column to its nearest data [m^2].
static void column_distances(const hole_map *m, float step, float *d) {
    for (int i = 0; i < m->width; i++) {
        float *column = d + i;
        const size_t stride = (size_t)m->width;
        float run = FAR;
        for (int j = 0; j < m->height; j++) {
            run = m->kind[(size_t)j * stride + (size_t)i] != SEA ? 0.0f : run + step;
            column[(size_t)j * stride] = run;
        }
        run = FAR;
        for (int j = m->height - 1; j >= 0; j--) {
            float *at = column + (size_t)j * stride;
            run = fminf(*at, run + step);
            *at = run;
        }
        for (int j = 0; j < m->height; j++) {
            float *at = column + (size_t)j * stride;
            *at = fminf(*at * *at, FAR);
        }
    }
}

typedef struct envelope {
    int *parabola; // of each piece of the lower envelope
    double *from;  // where the piece begins [samples]
    float *row;    // a copy of the row
} envelope;

// Where parabola q comes below parabola p < q.
static double crossing(const float *f, int p, int q, double step2) {
    return (((double)f[q] - (double)f[p]) / step2 + (double)q * q - (double)p * p) / (2.0 * (q - p));
}

static void row_distances(float *d, int width, double step, envelope *e) {
    const double step2 = step * step;
    memcpy(e->row, d, (size_t)width * sizeof *d);
    int last = 0;
    e->parabola[0] = 0, e->from[0] = -HUGE_VAL;
    for (int q = 1; q < width; q++) {
        double x = crossing(e->row, e->parabola[last], q, step2);
        while (last > 0 && x <= e->from[last]) x = crossing(e->row, e->parabola[--last], q, step2);
        last++;
        e->parabola[last] = q, e->from[last] = x;
    }
    for (int q = 0, k = 0; q < width; q++) {
        while (k < last && e->from[k + 1] < q) k++;
        const double across = (q - e->parabola[k]) * step;
        d[q] = (float)(across * across + (double)e->row[e->parabola[k]]);
    }
}

static bool distances(const hole_map *m, double width, double height, float *d) {
    const size_t n = (size_t)m->width;
    envelope e = {bolan_allocate(n * sizeof(int)), bolan_allocate(n * sizeof(double)),
                  bolan_allocate(n * sizeof(float))};
    const bool ok = e.parabola && e.from && e.row;
    if (ok) column_distances(m, (float)height, d);
    for (int j = 0; j < m->height && ok; j++) row_distances(d + (size_t)j * n, m->width, width, &e);
    bolan_release(e.parabola, n * sizeof(int));
    bolan_release(e.from, n * sizeof(double));
    bolan_release(e.row, n * sizeof(float));
    return ok;
}

static bool lay_bed(const hole_map *m, double width, double height, float *values) {
    const size_t count = (size_t)m->width * (size_t)m->height;
    float *d = bolan_allocate(count * sizeof *d);
    const bool ok = d && distances(m, width, height, d);
    const float half = 0.5f * (float)fmin(width, height); // the coast lies between two samples
    for (size_t i = 0; i < count && ok; i++) {
        if (m->kind[i] != SEA) continue;
        const float root = cbrtf(fmaxf(sqrtf(d[i]) - half, 0.0f));
        values[i] = fminf(values[i], -fminf(DEAN_A * root * root, SHELF_DEPTH));
    }
    bolan_release(d, count * sizeof *d);
    return ok;
}

bolan_result bolan_raster_holes(const raster_source *source, raster_window *w, double width, double height) {
    const size_t count = (size_t)w->width * (size_t)w->height;
    hole_map m = {w->width, w->height, bolan_allocate(count), 0, 0, 0};
    if (!m.kind || !classify(source, w->values, &m)) {
        bolan_release(m.kind, count);
        return bolan_raster_no_memory(source->path, count, "samples");
    }
    bolan_result result = BOLAN_OK;
    const bool sea_was_said = source->desc->nodata == BOLAN_NODATA_SEA || source->desc->zero == BOLAN_ZERO_SEA;
    if (m.known == 0 && sea_was_said) { // open water, far from all land
        for (size_t i = 0; i < count; i++) w->values[i] = -SHELF_DEPTH;
    } else {
        result = bolan_raster_fill(source->path, w->values, w->width, w->height);
        if (!result && m.seas > 0 && !lay_bed(&m, width, height, w->values))
            result = bolan_raster_no_memory(source->path, count, "samples");
    }
    bolan_release(m.kind, count);
    if (result == BOLAN_ERROR_FORMAT)
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_RASTER_EMPTY,
                  "%s: there is no elevation around the place that was asked for, only no-data", source->path);
    return result;
}

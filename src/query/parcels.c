// SPDX-License-Identifier: MIT
// Parcels of the surface at their rest points: a query block (block.h) that is evaluated and never solved.
//
// For a mesh the waves are low-passed as bolan_cascades_sample_grid() does it: each cascade fades as a whole, and the
// rest is the mean of a square of two spacings, read at up to 4 x 4 taps. The taps of a point are the same for all
// cascades, as many as the shortest that is left needs.
#include "bolan/query.h"

#include "query/block.h"

#include <math.h>

enum { GRAIN_BLOCKS = 16, MOST_TAPS = 4, FOAM_BATCH = 256 };

typedef struct parcels {
    query q;
    const bolan_dvec2 *rest;
    const float *spacing; // or NULL
    uint32_t count;
    double k_min[BOLAN_MAX_CASCADES], length[BOLAN_MAX_CASCADES], cell[BOLAN_MAX_CASCADES]; // of the cascades
    bolan_parcel *out;
} parcels;

// Sums of what a block evaluates to, over the taps.
typedef struct mean {
    float x[QUERY_LANES], y[QUERY_LANES], height[QUERY_LANES], slope_x[QUERY_LANES], slope_y[QUERY_LANES];
    float jxx[QUERY_LANES], jxy[QUERY_LANES], jyx[QUERY_LANES], jyy[QUERY_LANES];
} mean;

static void add_tap(const query_block *b, uint32_t lanes, float share, mean *m) {
    for (uint32_t l = 0; l < QUERY_LANES; l++) {
        if (!(lanes >> l & 1)) continue;
        m->x[l] += share * (b->rx[l] - b->ox[l]);
        m->y[l] += share * (b->ry[l] - b->oy[l]);
        m->height[l] += share * b->height[l];
        m->slope_x[l] += share * b->slope_x[l];
        m->slope_y[l] += share * b->slope_y[l];
        m->jxx[l] += share * b->jxx[l];
        m->jxy[l] += share * b->jxy[l];
        m->jyx[l] += share * b->jyx[l];
        m->jyy[l] += share * b->jyy[l];
    }
}

// The mean becomes what the block was evaluated to, at its rest points.
static void set_mean(const mean *m, query_block *b) {
    for (uint32_t l = 0; l < QUERY_LANES; l++) {
        b->ox[l] = b->oy[l] = 0.0f;
        b->rx[l] = m->x[l];
        b->ry[l] = m->y[l];
        b->height[l] = m->height[l];
        b->slope_x[l] = m->slope_x[l];
        b->slope_y[l] = m->slope_y[l];
        b->jxx[l] = m->jxx[l];
        b->jxy[l] = m->jxy[l];
        b->jyx[l] = m->jyx[l];
        b->jyy[l] = m->jyy[l];
    }
}

// Fades the cascades of a lane for its spacing, and returns the taps along a side of the square. `lift` receives what
// the lift of the grid is over that of a point, times the squares that are kept.
static int fade_lane(const parcels *p, float spacing, uint32_t l, query_block *b, float *lift) {
    double taps = 1.0;
    *lift = 0.0f;
    for (uint32_t c = 0; c < p->q.sea.count; c++) {
        const float fade = (float)bolan_cascade_fade(p->k_min[c], p->length[c], (double)spacing);
        b->attenuation[c][l] *= fade;
        b->lean_x[c][l] *= fade;
        b->lean_y[c][l] *= fade;
        const float keep = b->attenuation[c][l] * b->attenuation[c][l];
        *lift += keep * ((float)bolan_sea_lift(p->q.water->sea, c, (double)spacing) - p->q.sea.lift[c]);
        if (fade > 0.0f) taps = fmax(taps, ceil(2.0 * (double)spacing / p->cell[c]));
    }
    return (int)fmin(taps, MOST_TAPS);
}

// The lanes of `lanes` by taps x taps taps.
static void evaluate_taps(const parcels *p, const float *spacing, uint32_t lanes, int taps, query_block *b, mean *m) {
    const float share = 1.0f / (float)(taps * taps);
    for (int j = 0; j < taps; j++)
        for (int i = 0; i < taps; i++) {
            for (uint32_t l = 0; l < QUERY_LANES; l++) {
                b->ox[l] = (((float)i + 0.5f) / (float)taps - 0.5f) * 2.0f * spacing[l];
                b->oy[l] = (((float)j + 0.5f) / (float)taps - 0.5f) * 2.0f * spacing[l];
            }
            p->q.kernels->evaluate(&p->q.sea, lanes, b);
            add_tap(b, lanes, share, m);
        }
}

// The lanes of a block of cascades, low-passed for `spacing` of each lane.
static void evaluate_cascades(const parcels *p, const float *spacing, query_block *b) {
    uint32_t lanes_of[MOST_TAPS + 1] = {0}; // by their taps
    float lift[QUERY_LANES];
    mean m = {0};
    for (uint32_t l = 0; l < QUERY_LANES; l++) lanes_of[fade_lane(p, spacing[l], l, b, &lift[l])] |= 1u << l;
    for (int taps = 1; taps <= MOST_TAPS; taps++)
        if (lanes_of[taps]) evaluate_taps(p, spacing, lanes_of[taps], taps, b, &m);
    set_mean(&m, b);
    for (uint32_t l = 0; l < QUERY_LANES; l++) b->height[l] += lift[l];
}

// The lanes of a block of a sum, whose waves fade one by one.
static void evaluate_sum(const parcels *p, const float *spacing, query_block *b) {
    float fade[QUERY_LANES];
    for (uint32_t l = 0; l < QUERY_LANES; l++) fade[l] = 0.5f / spacing[l];
    b->fade = fade;
    p->q.kernels->evaluate(&p->q.sea, QUERY_ALL_LANES, b);
    b->fade = NULL;
    for (uint32_t l = 0; l < QUERY_LANES; l++) {
        const float keep = b->attenuation[0][l];
        b->height[l] +=
            keep * keep * ((float)bolan_sea_lift(p->q.water->sea, 0, (double)spacing[l]) - p->q.sea.lift[0]);
    }
}

static void evaluate(const parcels *p, uint32_t first, uint32_t lanes, query_block *b) {
    float spacing[QUERY_LANES], widest = 0.0f;
    for (uint32_t l = 0; l < QUERY_LANES; l++) {
        spacing[l] = p->spacing && l < lanes ? p->spacing[first + l] : 0.0f;
        widest = fmaxf(widest, spacing[l]);
    }
    if (widest <= 0.0f) {
        p->q.kernels->evaluate(&p->q.sea, QUERY_ALL_LANES, b);
    } else if (p->q.sea.sum) {
        evaluate_sum(p, spacing, b);
    } else {
        evaluate_cascades(p, spacing, b);
    }
    if (p->q.water->layer_count > 0) bolan_query_add_layers(&p->q, b);
}

// Task: blocks [begin, end).
static void do_blocks(void *context, uint32_t begin, uint32_t end, uint32_t worker) {
    (void)worker;
    const parcels *p = context;
    query_block b;
    for (uint32_t i = begin; i < end; i++) {
        const uint32_t first = i * QUERY_LANES, rest = p->count - first;
        const uint32_t lanes = rest < QUERY_LANES ? rest : QUERY_LANES;
        bolan_query_open_block(&p->q, p->rest + first, lanes, &b);
        evaluate(p, first, lanes, &b);
        for (uint32_t l = 0; l < lanes; l++) {
            const bool valid = isfinite(p->rest[first + l].x) && isfinite(p->rest[first + l].y);
            p->out[first + l] = valid ? (bolan_parcel){{b.rx[l], b.ry[l], b.height[l]},
                                                       bolan_query_normal(&b, l),
                                                       query_determinant(&b, l)}
                                      : (bolan_parcel){{0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 1.0f}, 1.0f};
        }
    }
}

void bolan_query_parcels(const bolan_water *water, const bolan_dvec2 *rest, const float *spacing, uint32_t count,
                         bolan_parcel *out) {
    const bool valid = bolan_water_is_valid(water) && (count == 0 || (rest && out));
    BOLAN_ASSERT(valid);
    if (!valid) return;
    parcels p = {.rest = rest, .spacing = spacing, .count = count, .out = out};
    bolan_query_prepare(water, &p.q);
    for (uint32_t c = 0; c < bolan_sea_cascade_count(water->sea); c++) {
        const bolan_cascade_view v = bolan_sea_cascade_layout(water->sea, c);
        p.k_min[c] = v.k_min;
        p.length[c] = v.length;
        p.cell[c] = v.length / v.n;
    }
    const uint32_t blocks = count / QUERY_LANES + (count % QUERY_LANES != 0);
    if (blocks <= GRAIN_BLOCKS) {
        do_blocks(&p, 0, blocks, 0);
    } else {
        bolan_parallel(blocks, GRAIN_BLOCKS, do_blocks, &p);
    }
}

// ---- foam -----------------------------------------------------------------------------------------------------------

typedef struct foam_points {
    query q;
    const bolan_dvec2 *xy;
    uint32_t count;
    float *foam;
} foam_points;

// Task: batches [begin, end).
static void find_foam(void *context, uint32_t begin, uint32_t end, uint32_t worker) {
    (void)worker;
    const foam_points *p = context;
    bolan_vec2 offset[FOAM_BATCH];
    bolan_dvec2 rest[FOAM_BATCH];
    bolan_sea_sample sample[FOAM_BATCH];
    for (uint32_t i = begin; i < end; i++) {
        const uint32_t first = i * FOAM_BATCH, left = p->count - first, count = left < FOAM_BATCH ? left : FOAM_BATCH;
        bolan_query_rest_points(&p->q, p->xy + first, count, NULL, offset);
        for (uint32_t k = 0; k < count; k++) {
            const bolan_dvec2 at = p->xy[first + k];
            const bool valid = isfinite(at.x) && isfinite(at.y);
            rest[k].x = valid ? at.x + (double)offset[k].x : 0.0;
            rest[k].y = valid ? at.y + (double)offset[k].y : 0.0;
        }
        bolan_sea_sample_grid(p->q.water->sea, rest, NULL, count, sample);
        for (uint32_t k = 0; k < count; k++)
            p->foam[first + k] = isfinite(p->xy[first + k].x + p->xy[first + k].y) ? sample[k].foam : 0.0f;
    }
}

void bolan_query_foam(const bolan_water *water, const bolan_dvec2 *xy, uint32_t count, float *foam) {
    const bool valid = bolan_water_is_valid(water) && (count == 0 || (xy && foam));
    BOLAN_ASSERT(valid);
    if (!valid) return;
    foam_points p = {.xy = xy, .count = count, .foam = foam};
    bolan_query_prepare(water, &p.q);
    const uint32_t batches = count / FOAM_BATCH + (count % FOAM_BATCH != 0);
    if (batches <= 1) {
        find_foam(&p, 0, batches, 0);
    } else {
        bolan_parallel(batches, 1, find_foam, &p);
    }
}

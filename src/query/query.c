// SPDX-License-Identifier: MIT
// Questions to the sea. A batch is cut into blocks of 16 points (block.h), which are solved by the kernels. Lanes that
// need more are collected from all blocks into full ones, solved by Newton steps, and those near a fold are searched
// for more roots (folds.c).
#include "bolan/query.h"
#include "bolan/coast.h"

#include "query/block.h"
#include "water/layer.h"

#include <math.h>
#include <string.h>

enum { GRAIN_BLOCKS = 16 };
// What the shore map of the renderer resolves close to the eye [m]: finer ground does not shape the waves.
static const double GROUND_RESOLUTION = 2.0;
static const double LEAN_STEP = 0.25; // [m] to either side, of the difference that the gradient of the coast is

typedef struct batch {
    query q;
    const bolan_dvec2 *xy;
    uint32_t count;
    float *height;          // or NULL
    bolan_query_point *out; // or NULL
    bolan_vec2 *offset;     // or NULL
} batch;

// Depth [m] under a place near the rest point of a lane.
static float depth_at(const query *q, const query_block *b, uint32_t l, double dx, double dy) {
    const double x = b->x[l] + (double)b->ox[l] + dx, y = b->y[l] + (double)b->oy[l] + dy;
    return (float)(q->water->level - (double)bolan_ground_elevation(q->water->ground, x, y, GROUND_RESOLUTION));
}

static void attenuate_lane(const query *q, float depth, query_block *b, uint32_t l) {
    float keep[BOLAN_MAX_CASCADES];
    bolan_coast_attenuations(depth, q->band_hs, q->sea.count, keep);
    for (uint32_t c = 0; c < q->sea.count; c++) b->attenuation[c][l] = keep[c];
}

// The gradient of the attenuation: over a slope of the bed it leans the water, too.
static void lean_lane(const query *q, query_block *b, uint32_t l) {
    float east[BOLAN_MAX_CASCADES], west[BOLAN_MAX_CASCADES], north[BOLAN_MAX_CASCADES], south[BOLAN_MAX_CASCADES];
    bolan_coast_attenuations(depth_at(q, b, l, LEAN_STEP, 0.0), q->band_hs, q->sea.count, east);
    bolan_coast_attenuations(depth_at(q, b, l, -LEAN_STEP, 0.0), q->band_hs, q->sea.count, west);
    bolan_coast_attenuations(depth_at(q, b, l, 0.0, LEAN_STEP), q->band_hs, q->sea.count, north);
    bolan_coast_attenuations(depth_at(q, b, l, 0.0, -LEAN_STEP), q->band_hs, q->sea.count, south);
    for (uint32_t c = 0; c < q->sea.count; c++) {
        b->lean_x[c][l] = (east[c] - west[c]) * (float)(0.5 / LEAN_STEP);
        b->lean_y[c][l] = (north[c] - south[c]) * (float)(0.5 / LEAN_STEP);
    }
    b->leans = true;
}

// Ground is dear to evaluate. Beyond 8 Hs of depth the attenuation is 1, on land it is 0, and a rest point is about Hs
// away at most: twice that depth, or half of it on land, settles the lane for all its steps.
// Returns the lanes that are settled.
static uint32_t settle(const query *q, query_block *b) {
    if (!q->water->ground) return QUERY_ALL_LANES;
    uint32_t lanes = 0;
    for (uint32_t l = 0; l < QUERY_LANES; l++) {
        const float depth = depth_at(q, b, l, 0.0, 0.0);
        attenuate_lane(q, depth, b, l);
        b->settled[l] = depth > 16.0f * q->hs || depth < -4.0f * q->hs;
        lanes |= (uint32_t)b->settled[l] << l;
    }
    return lanes;
}

static void attenuate(const query *q, uint32_t lanes, bool lean, query_block *b) {
    for (uint32_t l = 0; l < QUERY_LANES; l++) {
        if (b->settled[l] || !(lanes >> l & 1)) continue;
        attenuate_lane(q, depth_at(q, b, l, 0.0, 0.0), b, l);
        if (lean) lean_lane(q, b, l);
    }
}

// What the coast leaves of a layer at the rest point of a lane, and its gradient.
typedef struct layer_share {
    float keep, by_x, by_y;
} layer_share;

static layer_share share_of(const query *q, const query_block *b, uint32_t l, float hs) {
    if (!q->water->ground) return (layer_share){1.0f, 0.0f, 0.0f};
    layer_share s = {.keep = bolan_coast_attenuation(depth_at(q, b, l, 0.0, 0.0), hs)};
    if (b->settled[l]) return s;
    const float half = (float)(0.5 / LEAN_STEP);
    s.by_x = half * (bolan_coast_attenuation(depth_at(q, b, l, LEAN_STEP, 0.0), hs) -
                     bolan_coast_attenuation(depth_at(q, b, l, -LEAN_STEP, 0.0), hs));
    s.by_y = half * (bolan_coast_attenuation(depth_at(q, b, l, 0.0, LEAN_STEP), hs) -
                     bolan_coast_attenuation(depth_at(q, b, l, 0.0, -LEAN_STEP), hs));
    return s;
}

// Adds the layers at the rest points. They move no parcel sideways, so the solver need not know them.
void bolan_query_add_layers(const query *q, query_block *b) {
    double x[QUERY_LANES], y[QUERY_LANES];
    for (uint32_t l = 0; l < QUERY_LANES; l++) {
        x[l] = b->x[l] + (double)b->ox[l];
        y[l] = b->y[l] + (double)b->oy[l];
    }
    for (uint32_t i = 0; i < q->water->layer_count; i++) {
        const bolan_wave_layer *layer = q->water->layers[i];
        bolan_wave_layer_sample waves[QUERY_LANES];
        layer->kind->sample(layer, q->time, QUERY_LANES, x, y, waves);
        for (uint32_t l = 0; l < QUERY_LANES; l++) {
            const layer_share share = share_of(q, b, l, layer->hs);
            b->height[l] += share.keep * waves[l].height;
            b->slope_x[l] += share.keep * waves[l].slope_x + share.by_x * waves[l].height;
            b->slope_y[l] += share.keep * waves[l].slope_y + share.by_y * waves[l].height;
        }
    }
}

static void newton(uint32_t lanes, query_block *b) {
    for (uint32_t l = 0; l < QUERY_LANES; l++)
        if (lanes >> l & 1) query_newton(b, l);
}

static bool has_converged(const query_block *b, uint32_t l) {
    return b->rx[l] * b->rx[l] + b->ry[l] * b->ry[l] <= QUERY_CONVERGED * QUERY_CONVERGED;
}

// Those of `lanes` that have not converged.
static uint32_t left_of(uint32_t lanes, const query_block *b) {
    uint32_t left = 0;
    for (uint32_t l = 0; l < QUERY_LANES; l++)
        if ((lanes >> l & 1) && !has_converged(b, l)) left |= 1u << l;
    return left;
}

// Half a millimetre from the rest point the height is off by that much of the slope: what is left of it, by the
// tangent.
static void correct_heights(query_block *b) {
    for (uint32_t l = 0; l < QUERY_LANES; l++) {
        const float determinant = query_determinant(b, l);
        if (determinant < QUERY_FOLD || !has_converged(b, l)) continue;
        const float sx = (b->jyy[l] * b->rx[l] - b->jxy[l] * b->ry[l]) / determinant;
        const float sy = (b->jxx[l] * b->ry[l] - b->jyx[l] * b->rx[l]) / determinant;
        b->height[l] -= b->slope_x[l] * sx + b->slope_y[l] * sy;
    }
}

void bolan_query_solve(const query *q, uint32_t lanes, uint32_t steps, query_block *block) {
    for (uint32_t i = 0;; i++) {
        attenuate(q, lanes, i < 2, block); // later steps are of millimetres
        q->kernels->evaluate(&q->sea, lanes, block);
        lanes = left_of(lanes, block);
        if (lanes == 0 || i >= steps) break;
        newton(lanes, block);
    }
    correct_heights(block);
    if (q->water->layer_count > 0) bolan_query_add_layers(q, block);
}

// True if the last step was not small enough, or the map is nearly singular there.
static bool is_hard(const query_block *b, uint32_t l) {
    return !has_converged(b, l) || query_determinant(b, l) < QUERY_FOLD;
}

// Loads the points [first, first + lanes); the lanes that are left over and points that are not finite stand at the
// origin.
static void load_block(const bolan_dvec2 *xy, uint32_t lanes, query_block *b) {
    for (uint32_t l = 0; l < QUERY_LANES; l++) {
        const bool valid = l < lanes && isfinite(xy[l].x) && isfinite(xy[l].y);
        b->x[l] = valid ? xy[l].x : 0.0;
        b->y[l] = valid ? xy[l].y : 0.0;
        b->ox[l] = b->oy[l] = 0.0f;
    }
}

// Of block i of `count` points.
static uint32_t lanes_of(uint32_t count, uint32_t i) {
    const uint32_t rest = count - i * QUERY_LANES;
    return rest < QUERY_LANES ? rest : QUERY_LANES;
}

// A block of deep water.
static void clear_block(query_block *b) {
    memset(b, 0, sizeof *b);
    for (uint32_t l = 0; l < QUERY_LANES; l++) {
        for (uint32_t c = 0; c < BOLAN_MAX_CASCADES; c++) b->attenuation[c][l] = 1.0f;
        b->settled[l] = true;
    }
}

void bolan_query_open_block(const query *q, const bolan_dvec2 *rest, uint32_t lanes, query_block *b) {
    clear_block(b);
    load_block(rest, lanes, b);
    q->kernels->locate(&q->sea, b);
    (void)settle(q, b);
    attenuate(q, QUERY_ALL_LANES, true, b);
}

// Normal of the displaced surface: the cross product of its tangents along the rest axes, with the sign that points up.
bolan_vec3 bolan_query_normal(const query_block *b, uint32_t l) {
    const float determinant = query_determinant(b, l), sign = determinant < 0.0f ? -1.0f : 1.0f;
    const bolan_vec3 n = {-(b->slope_x[l] * b->jyy[l] - b->slope_y[l] * b->jyx[l]) * sign,
                          -(b->slope_y[l] * b->jxx[l] - b->slope_x[l] * b->jxy[l]) * sign, determinant * sign};
    return bolan_v3_length(n) > 0.0f ? bolan_v3_normalize(n) : bolan_v3(0.0f, 0.0f, 1.0f);
}

static bolan_query_point point_of(const query *q, const query_block *b, uint32_t l) {
    bolan_query_point p;
    p.height = (float)(q->water->level + (double)b->height[l]);
    p.normal = bolan_query_normal(b, l);
    p.jacobian = query_determinant(b, l);
    p.residual = sqrtf(b->rx[l] * b->rx[l] + b->ry[l] * b->ry[l]);
    return p;
}

static void write_lane(const batch *t, uint32_t index, const query_block *b, uint32_t l) {
    const bool valid = isfinite(t->xy[index].x) && isfinite(t->xy[index].y);
    if (t->height) t->height[index] = (float)(t->q.water->level + (valid ? (double)b->height[l] : 0.0));
    if (t->offset) t->offset[index] = (bolan_vec2){b->ox[l], b->oy[l]};
    if (!t->out) return;
    const bolan_query_point mean = {(float)t->q.water->level, {0.0f, 0.0f, 1.0f}, 1.0f, 0.0f};
    t->out[index] = valid ? point_of(&t->q, b, l) : mean;
}

// Lanes of several blocks that the kernels alone cannot answer.
typedef struct leftover {
    uint32_t count, index[QUERY_LANES]; // in the batch
    query_block block;
} leftover;

// Answers the first `count` lanes of a block; lane l is point index[l] of the batch.
static void answer_leftover(const batch *t, leftover *left) {
    query_block *b = &left->block;
    b->leans = false;
    bolan_query_solve(&t->q, (1u << left->count) - 1, QUERY_STEPS, b);
    for (uint32_t l = 0; l < left->count; l++) {
        if (is_hard(b, l)) bolan_query_search_folds(&t->q, b, l);
        write_lane(t, left->index[l], b, l);
    }
    left->count = 0;
}

static void leave_lane(const batch *t, const query_block *b, uint32_t l, uint32_t index, leftover *left) {
    bolan_query_copy_place(&t->q, b, l, &left->block, left->count);
    left->index[left->count++] = index;
    if (left->count == QUERY_LANES) answer_leftover(t, left);
}

// `lanes` points from `first` on, whose block is solved; `certain`: the lanes that need no more.
static void write_block(const batch *t, uint32_t first, uint32_t lanes, uint32_t certain, query_block *b,
                        leftover *left) {
    if (t->out && certain) t->q.kernels->surface(&t->q.sea, b);
    if (certain && t->q.water->layer_count > 0) bolan_query_add_layers(&t->q, b);
    for (uint32_t l = 0; l < lanes; l++) {
        if (certain >> l & 1) {
            write_lane(t, first + l, b, l);
        } else {
            leave_lane(t, b, l, first + l, left);
        }
    }
}

// The points [first, first + count), of as many blocks as they fill.
static void answer_blocks(const batch *t, uint32_t first, uint32_t count, query_block *blocks, leftover *left) {
    const query *q = &t->q;
    const uint32_t block_count = (count + QUERY_LANES - 1) / QUERY_LANES;
    uint32_t settled[QUERY_BLOCKS], certain[QUERY_BLOCKS] = {0};
    for (uint32_t i = 0; i < block_count; i++) {
        load_block(t->xy + first + i * QUERY_LANES, lanes_of(count, i), &blocks[i]);
        q->kernels->locate(&q->sea, &blocks[i]);
        settled[i] = settle(q, &blocks[i]);
    }
    if (q->kernels->approach) q->kernels->approach(&q->sea, blocks, block_count, certain);
    for (uint32_t i = 0; i < block_count; i++)
        write_block(t, first + i * QUERY_LANES, lanes_of(count, i), certain[i] & settled[i], &blocks[i], left);
}

static void do_blocks(void *context, uint32_t begin, uint32_t end, uint32_t worker) {
    (void)worker;
    const batch *t = context;
    const uint32_t points = QUERY_LANES * end < t->count ? QUERY_LANES * end : t->count;
    query_block blocks[QUERY_BLOCKS];
    leftover left;
    for (uint32_t i = 0; i < QUERY_BLOCKS && i < end - begin; i++) clear_block(&blocks[i]);
    clear_block(&left.block);
    left.count = 0;
    for (uint32_t first = QUERY_LANES * begin; first < points; first += QUERY_BLOCKS * QUERY_LANES) {
        const uint32_t rest = points - first, most = QUERY_BLOCKS * QUERY_LANES;
        answer_blocks(t, first, rest < most ? rest : most, blocks, &left);
    }
    if (left.count > 0) answer_leftover(t, &left);
}

// Half of the error of a linear fetch of spline coefficients, of a wave k, is the factor 1 + (k cell)^2 / 12; the
// waves of a cascade are spread out, and 10 is best.
#define LINEAR_EXCESS 10.0

static query_cascade cascade_of(const bolan_cascade_view *v, const bolan_sea_desc *desc) {
    const float drift = (float)v->bound.drift, drift_long = (float)v->bound.drift_long;
    double s, c;
    bolan_sincos(v->angle, &s, &c);
    const double cell = v->length / v->n, k2 = v->variance > 0.0 ? v->mss / v->variance : 0.0; // [m], mean of k^2
    const double travel = k2 > 0.0 ? 1.0 + 1.0 / (sqrt(k2) * desc->sea_state.depth) : 1.0;     // above coth(kh)
    return (query_cascade){.texels = &v->displacement->dx,
                           .n = v->n,
                           .pitch = v->pitch,
                           .cells_per_metre = (float)(v->n / v->length),
                           .c = (float)c,
                           .s = (float)s,
                           .tile_c = c / v->length,
                           .tile_s = s / v->length,
                           .linear = (float)(1.0 / (1.0 + cell * cell * k2 / LINEAR_EXCESS)),
                           .own = {drift, drift, (float)v->bound.height},
                           .longer = {drift_long, drift_long, (float)v->bound.height_long},
                           .curvature = (float)(desc->choppiness * travel * v->k_max * sqrt(v->mss))};
}

// The cascade from which on query_kernels.surface reads again. Bound waves are products of all cascades.
static uint32_t again_from(const query_sea *sea) {
    uint32_t c = 0;
    if (sea->bound) return 0;
    while (c + 1 < sea->count &&
           2.0f * QUERY_DOUBTFUL * sea->cascade[c].curvature < QUERY_SLOPE_ERROR * QUERY_SLOPE_ERROR)
        c++;
    return c;
}

void bolan_query_prepare(const bolan_water *water, query *out) {
    const bolan_sea *sea = water->sea;
    const bolan_sea_desc *desc = bolan_sea_get_desc(sea);
    query q = {.kernels = bolan_query_kernels_for(desc->cpu), .water = water, .time = bolan_sea_time(sea)};
    q.sea.bound = desc->order > 1;
    q.sea.choppiness = (float)desc->choppiness;
    q.sea.warp = *bolan_sea_warp_of(sea);
    q.sea.sum = bolan_sea_sum(sea);
    if (q.sea.sum) {
        q.sea.sum_fields = bolan_sum_fields_for(desc->cpu);
        q.kernels = &bolan_query_sum_kernels;
    }
    for (uint32_t i = 0; i < bolan_sea_cascade_count(sea); i++) {
        const bolan_cascade_view v = bolan_sea_cascade(sea, i);
        q.sea.cascade[i] = cascade_of(&v, desc);
        q.sea.origin_x = v.origin_x;
        q.sea.origin_y = v.origin_y;
    }
    double variance = 0.0;
    const sea_band *band = bolan_sea_bands(sea, &q.sea.count);
    q.sea.again = again_from(&q.sea);
    for (uint32_t i = 0; i < q.sea.count; i++) {
        q.sea.lift[i] = (float)bolan_sea_lift(sea, i, 0.0);
        q.band_hs[i] = (float)(4.0 * sqrt(band[i].variance));
        variance += band[i].variance;
    }
    q.hs = (float)(4.0 * sqrt(variance));
    // Each of two parcels at one place has moved by about a standard deviation, towards the other.
    q.reach = (float)(4.0 * desc->choppiness * sqrt(variance));
    *out = q;
}

void bolan_query_rest_points(const query *q, const bolan_dvec2 *xy, uint32_t count, float *height, bolan_vec2 *offset) {
    batch t = {.q = *q, .xy = xy, .count = count, .height = height, .offset = offset};
    do_blocks(&t, 0, (count + QUERY_LANES - 1) / QUERY_LANES, 0);
}

static void run(batch *t) {
    const uint32_t blocks = t->count / QUERY_LANES + (t->count % QUERY_LANES != 0);
    if (blocks <= GRAIN_BLOCKS) {
        do_blocks(t, 0, blocks, 0); // not worth waking anybody
    } else {
        bolan_parallel(blocks, GRAIN_BLOCKS, do_blocks, t);
    }
}

void bolan_query_heights(const bolan_water *water, const bolan_dvec2 *xy, uint32_t count, float *height) {
    const bool valid = bolan_water_is_valid(water) && (count == 0 || (xy && height));
    BOLAN_ASSERT(valid);
    if (!valid) return;
    batch t = {.xy = xy, .count = count, .height = height};
    bolan_query_prepare(water, &t.q);
    run(&t);
}

void bolan_query_surface(const bolan_water *water, const bolan_dvec2 *xy, uint32_t count, bolan_query_point *out) {
    const bool valid = bolan_water_is_valid(water) && (count == 0 || (xy && out));
    BOLAN_ASSERT(valid);
    if (!valid) return;
    batch t = {.xy = xy, .count = count, .out = out};
    bolan_query_prepare(water, &t.q);
    run(&t);
}

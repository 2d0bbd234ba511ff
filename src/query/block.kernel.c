// SPDX-License-Identifier: MIT
// The lanes of a query block, compiled once per instruction set. The shader twin is cascade_displacement() of
// shaders/common/sea.glsl.
#include "query/splines.h"
#include "shared/cascade.glsl"
#include "shared/warp.glsl"

#include <math.h>
#include <string.h>

#define LANES(l) for (int l = 0; l < QUERY_LANES; l++)

void KERNEL(bolan_query_locate)(const query_sea *sea, query_block *block);
void KERNEL(bolan_query_approach)(const query_sea *sea, query_block *blocks, uint32_t count, uint32_t *certain);
void KERNEL(bolan_query_surface)(const query_sea *sea, query_block *block);
void KERNEL(bolan_query_evaluate)(const query_sea *sea, uint32_t lanes, query_block *block);

// ---- places ---------------------------------------------------------------------------------------------------------

static inline int32_t floor_to_int(float x) {
    const int32_t i = (int32_t)x;
    return i - (x < (float)i);
}

static inline double fraction(double x) { return x - floor(x); } // 1 of a tiny negative

// The places of the warped plane that the points are read at, and the gradient of the warp: xx, xy, yx, yy.
static void warp(const query_sea *sea, const query_block *block, double *x, double *y, float gradient[4][QUERY_LANES]) {
    const bolan_sea_warp *w = &sea->warp;
    _Alignas(64) double own_x[QUERY_LANES], own_y[QUERY_LANES];
    LANES(l) {
        own_x[l] = x[l] = block->x[l] - sea->origin_x; // the water drifts
        own_y[l] = y[l] = block->y[l] - sea->origin_y;
        gradient[0][l] = gradient[3][l] = 1.0f;
        gradient[1][l] = gradient[2][l] = 0.0f;
    }
    for (uint32_t i = 0; i < w->count; i++) {
        const double kx = w->wave[i].kx, ky = w->wave[i].ky, ax = w->wave[i].ax, ay = w->wave[i].ay;
        const float xx = (float)(ax * kx), xy = (float)(ax * ky), yx = (float)(ay * kx), yy = (float)(ay * ky);
        LANES(l) {
            const double turn = fraction(kx * own_x[l] + ky * own_y[l] + w->wave[i].phase);
            const double value = warp_wave(turn);
            const float slope = (float)warp_slope(turn);
            x[l] += ax * value;
            y[l] += ay * value;
            gradient[0][l] += xx * slope;
            gradient[1][l] += xy * slope;
            gradient[2][l] += yx * slope;
            gradient[3][l] += yy * slope;
        }
    }
}

void KERNEL(bolan_query_locate)(const query_sea *sea, query_block *block) {
    _Alignas(64) double x[QUERY_LANES], y[QUERY_LANES];
    _Alignas(64) float g[4][QUERY_LANES];
    warp(sea, block, x, y, g);
    for (uint32_t c = 0; c < sea->count; c++) {
        const query_cascade *t = &sea->cascade[c];
        const double n = t->n;
        LANES(l) {
            const double u = fraction(along_tile(x[l], y[l], t->tile_c, t->tile_s)) * n;
            const double v = fraction(across_tile(x[l], y[l], t->tile_c, t->tile_s)) * n;
            block->cell_u[c][l] = (int32_t)u;
            block->cell_v[c][l] = (int32_t)v;
            block->part_u[c][l] = (float)(u - (double)block->cell_u[c][l]);
            block->part_v[c][l] = (float)(v - (double)block->cell_v[c][l]);
        }
        const float cu = t->c * t->cells_per_metre, su = t->s * t->cells_per_metre;
        query_axes *axes = &block->axes[c];
        LANES(l) {
            axes->ux[l] = cu * g[0][l] + su * g[2][l];
            axes->uy[l] = cu * g[1][l] + su * g[3][l];
            axes->vx[l] = cu * g[2][l] - su * g[0][l];
            axes->vy[l] = cu * g[3][l] - su * g[1][l];
        }
    }
}

// Places of the present offsets in a tile, in cells from that of the point.
static inline float place_u(const query_block *b, uint32_t c, int l) {
    return b->part_u[c][l] + (b->axes[c].ux[l] * b->ox[l] + b->axes[c].uy[l] * b->oy[l]);
}
static inline float place_v(const query_block *b, uint32_t c, int l) {
    return b->part_v[c][l] + (b->axes[c].vx[l] * b->ox[l] + b->axes[c].vy[l] * b->oy[l]);
}

// Offsets lead to places of the warped plane by its tangent.
static inline void find_spots(const query_cascade *t, const query_block *block, uint32_t c, spots *out) {
    const int32_t pitch = (int32_t)t->pitch, mask = (int32_t)t->n - 1;
    LANES(l) {
        const float u = place_u(block, c, l), v = place_v(block, c, l);
        const int32_t iu = floor_to_int(u), iv = floor_to_int(v);
        out->u[l] = u - (float)iu;
        out->v[l] = v - (float)iv;
        const int32_t column = (block->cell_u[c][l] + iu - 1) & mask, row = (block->cell_v[c][l] + iv - 1) & mask;
        out->first[l] = row * pitch + column;
    }
}

// ---- tangents -------------------------------------------------------------------------------------------------------

static const query_tangent no_tangent;

// Of each cascade of a block.
typedef struct query_tangents {
    query_tangent of[BOLAN_MAX_CASCADES];
} query_tangents;

// A lane of it. One loop over the lanes does all with a lane that is read once, in registers.
typedef struct lane_tangent {
    float x, y, xx, xy, yx, yy;
} lane_tangent;

static inline lane_tangent get_lane(const query_tangent *t, int l) {
    return (lane_tangent){t->x[l], t->y[l], t->xx[l], t->xy[l], t->yx[l], t->yy[l]};
}

static inline void put_lane(lane_tangent a, int l, query_tangent *out) {
    out->x[l] = a.x, out->y[l] = a.y;
    out->xx[l] = a.xx, out->xy[l] = a.xy, out->yx[l] = a.yx, out->yy[l] = a.yy;
}

static inline lane_tangent plus(lane_tangent a, lane_tangent b) {
    return (lane_tangent){a.x + b.x, a.y + b.y, a.xx + b.xx, a.xy + b.xy, a.yx + b.yx, a.yy + b.yy};
}

// Newton's step: the offset where (1) holds for the tangents of all cascades. Near a fold it stays where it is.
static inline void go_to_root(lane_tangent sum, int l, query_block *b) {
    const float xx = 1.0f + sum.xx, yy = 1.0f + sum.yy, xy = sum.xy, yx = sum.yx;
    const float det = xx * yy - xy * yx;
    const bool regular = det > QUERY_REGULAR;
    const float inverse = 1.0f / (regular ? det : 1.0f);
    const float x = (xy * sum.y - yy * sum.x) * inverse, y = (yx * sum.x - xx * sum.y) * inverse;
    const bool near = x < QUERY_MAX_OFFSET && x > -QUERY_MAX_OFFSET && y < QUERY_MAX_OFFSET && y > -QUERY_MAX_OFFSET;
    b->ox[l] = regular && near ? x : b->ox[l];
    b->oy[l] = regular && near ? y : b->oy[l];
}

// The tangent of a cascade at the present offset, from what was read of dx and dy there; `scale` is a factor on it.
static inline lane_tangent tangent_of(const query_block *b, uint32_t c, float scale, const spline_values *f, int l) {
    const float weight = scale * b->attenuation[c][l], ox = b->ox[l], oy = b->oy[l];
    const float ux = b->axes[c].ux[l], uy = b->axes[c].uy[l], vx = b->axes[c].vx[l], vy = b->axes[c].vy[l];
    const float xx = weight * (f->along[0][l] * ux + f->across[0][l] * vx);
    const float xy = weight * (f->along[0][l] * uy + f->across[0][l] * vy);
    const float yx = weight * (f->along[1][l] * ux + f->across[1][l] * vx);
    const float yy = weight * (f->along[1][l] * uy + f->across[1][l] * vy);
    return (lane_tangent){
        weight * f->value[0][l] - (xx * ox + xy * oy), weight * f->value[1][l] - (yx * ox + yy * oy), xx, xy, yx, yy};
}

// ---- a guess --------------------------------------------------------------------------------------------------------

// Takes a cascade in, whose factor is `scale`.
static inline void guess_lanes(uint32_t c, float scale, const spline_values *f, query_tangent *restrict own,
                               query_tangent *restrict sum, query_block *restrict b) {
    LANES(l) {
        const lane_tangent one = tangent_of(b, c, scale, f, l), all = plus(get_lane(sum, l), one);
        put_lane(one, l, own);
        put_lane(all, l, sum);
        go_to_root(all, l, b);
    }
}

// Leaves in rest[c] the sum of the tangents of the cascades behind c.
static void guess(const query_sea *sea, query_block *blocks, uint32_t count, query_tangents *rest) {
    query_tangents own[QUERY_BLOCKS];
    query_tangent sum[QUERY_BLOCKS];
    spots at[QUERY_BLOCKS];
    memset(sum, 0, sizeof sum);
    for (uint32_t c = 0; c < sea->count; c++) {
        const query_cascade *t = &sea->cascade[c];
        for (uint32_t i = 0; i < count; i++) find_spots(t, &blocks[i], c, &at[i]);
        for (uint32_t i = 0; i < count; i++) {
            spline_values f;
            read_linearly(t, &at[i], &f);
            guess_lanes(c, sea->choppiness * t->linear, &f, &own[i].of[c], &sum[i], &blocks[i]);
        }
    }
    for (uint32_t i = 0; i < count; i++) {
        rest[i].of[sea->count - 1] = no_tangent;
        for (uint32_t c = sea->count - 1; c > 0; c--) LANES(l) {
                put_lane(plus(get_lane(&rest[i].of[c], l), get_lane(&own[i].of[c], l)), l, &rest[i].of[c - 1]);
            }
    }
}

// ---- bound waves ----------------------------------------------------------------------------------------------------

// dx, dy and height of a cascade, or of all of them, and their gradients by the rest point.
typedef struct fields {
    _Alignas(64) float value[SPLINE_FIELDS][QUERY_LANES], by_x[SPLINE_FIELDS][QUERY_LANES],
        by_y[SPLINE_FIELDS][QUERY_LANES];
} fields;

static inline void set_fields(const query_block *b, uint32_t c, const spline_values *f, fields *out) {
    const query_axes *axes = &b->axes[c];
    const float *weight = b->attenuation[c];
    for (int p = 0; p < SPLINE_FIELDS; p++) LANES(l) {
            out->value[p][l] = weight[l] * f->value[p][l];
            out->by_x[p][l] = weight[l] * (f->along[p][l] * axes->ux[l] + f->across[p][l] * axes->vx[l]);
            out->by_y[p][l] = weight[l] * (f->along[p][l] * axes->uy[l] + f->across[p][l] * axes->vy[l]);
        }
}

// Height and slope of the bound waves (bolan_bound_weights; twin of add_bound() in waves/cascades/sample.c), and the
// weighted sums over the longer cascades.
typedef struct bound {
    _Alignas(64) float height[QUERY_LANES], x[QUERY_LANES], y[QUERY_LANES];
    fields longer;
} bound;

static inline void add_bound_height(const query_cascade *t, const fields *f, bound *b) {
    for (int p = 0; p < SPLINE_FIELDS; p++) LANES(l) {
            const float value = f->value[p][l];
            b->height[l] += value * (value * t->own[p] + b->longer.value[p][l]);
            b->longer.value[p][l] += value * t->longer[p];
        }
}

// Before the height of the same cascade.
static inline void add_bound_slope(const query_cascade *t, const fields *f, bound *b) {
    for (int p = 0; p < SPLINE_FIELDS; p++) LANES(l) {
            const float value = f->value[p][l], twice = 2.0f * (value * t->own[p]) + b->longer.value[p][l];
            b->x[l] += f->by_x[p][l] * twice + value * b->longer.by_x[p][l];
            b->y[l] += f->by_y[p][l] * twice + value * b->longer.by_y[p][l];
            b->longer.by_x[p][l] += f->by_x[p][l] * t->longer[p];
            b->longer.by_y[p][l] += f->by_y[p][l] * t->longer[p];
        }
}

// ---- splines --------------------------------------------------------------------------------------------------------

static inline void add_height(float lift, uint32_t c, const query_block *b, const spline_values *f, int l,
                              query_height_tangent *height) {
    const float weight = b->attenuation[c][l];
    const float x = weight * (f->along[2][l] * b->axes[c].ux[l] + f->across[2][l] * b->axes[c].vx[l]);
    const float y = weight * (f->along[2][l] * b->axes[c].uy[l] + f->across[2][l] * b->axes[c].vy[l]);
    const float value = weight * f->value[2][l] + weight * weight * lift;
    height->value[l] += value - (x * b->ox[l] + y * b->oy[l]);
    height->x[l] += x;
    height->y[l] += y;
}

// What refine() has of a block.
typedef struct refined {
    _Alignas(64) float at_x[BOLAN_MAX_CASCADES][QUERY_LANES],
        at_y[BOLAN_MAX_CASCADES][QUERY_LANES]; // offsets of reading
    query_tangent sum;
    query_height_tangent height;
    fields read[BOLAN_MAX_CASCADES]; // where there are bound waves
} refined;

// Adds the bound waves to the heights, from what was read, by its tangents.
static void add_bound_heights(const query_sea *sea, refined *r, query_block *b) {
    bound all;
    memset(&all, 0, sizeof all);
    for (uint32_t c = 0; c < sea->count; c++) {
        for (int p = 0; p < SPLINE_FIELDS; p++) LANES(l) {
                const float x = b->ox[l] - r->at_x[c][l], y = b->oy[l] - r->at_y[c][l];
                r->read[c].value[p][l] += r->read[c].by_x[p][l] * x + r->read[c].by_y[p][l] * y;
            }
        add_bound_height(&sea->cascade[c], &r->read[c], &all);
    }
    LANES(l) b->height[l] += all.height[l];
}

// A cascade of a block, at `at`.
static inline void refine_cascade(const query_sea *sea, uint32_t c, const spots *at, const query_tangent *restrict rest,
                                  refined *restrict r, query_block *restrict b) {
    const float choppiness = sea->choppiness, lift = sea->lift[c];
    spline_values f;
    read_splines(&sea->cascade[c], at, QUERY_ALL_LANES, &f);
    if (sea->bound) set_fields(b, c, &f, &r->read[c]);
    LANES(l) {
        r->at_x[c][l] = b->ox[l];
        r->at_y[c][l] = b->oy[l];
        add_height(lift, c, b, &f, l, &r->height);
        const lane_tangent all = plus(get_lane(&r->sum, l), tangent_of(b, c, choppiness, &f, l));
        put_lane(all, l, &r->sum);
        go_to_root(plus(all, get_lane(rest, l)), l, b);
    }
}

// The lanes that are certain, of a block that all cascades were read for.
static inline uint32_t conclude(const query_sea *sea, refined *r, query_block *b) {
    float doubt[QUERY_LANES];
    LANES(l) {
        b->height[l] = r->height.value[l] + (r->height.x[l] * b->ox[l] + r->height.y[l] * b->oy[l]);
        b->jxx[l] = 1.0f + r->sum.xx[l];
        b->jxy[l] = r->sum.xy[l];
        b->jyx[l] = r->sum.yx[l];
        b->jyy[l] = 1.0f + r->sum.yy[l];
        doubt[l] = 0.0f;
    }
    if (sea->bound) add_bound_heights(sea, r, b);
    for (uint32_t c = 0; c < sea->count; c++) {
        const float half = 0.5f * sea->cascade[c].curvature;
        LANES(l) {
            const float x = b->ox[l] - r->at_x[c][l], y = b->oy[l] - r->at_y[c][l];
            doubt[l] += half * (x * x + y * y);
        }
    }
    uint32_t certain = 0;
    LANES(l) {
        const float determinant = b->jxx[l] * b->jyy[l] - b->jxy[l] * b->jyx[l];
        certain |= doubt[l] <= QUERY_DOUBTFUL && determinant >= QUERY_FOLD ? 1u << l : 0u;
    }
    return certain;
}

// `rest` as guess() leaves it.
static void refine(const query_sea *sea, const query_tangents *rest, query_block *blocks, uint32_t count,
                   uint32_t *certain) {
    refined r[QUERY_BLOCKS];
    spots at[QUERY_BLOCKS];
    for (uint32_t i = 0; i < count; i++) {
        r[i].sum = no_tangent;
        memset(&r[i].height, 0, sizeof r[i].height);
    }
    for (uint32_t c = 0; c < sea->count; c++) {
        for (uint32_t i = 0; i < count; i++) find_spots(&sea->cascade[c], &blocks[i], c, &at[i]);
        for (uint32_t i = 0; i < count; i++) {
            if (c == sea->again) blocks[i].kept = (query_kept){r[i].sum, r[i].height};
            refine_cascade(sea, c, &at[i], &rest[i].of[c], &r[i], &blocks[i]);
        }
    }
    for (uint32_t i = 0; i < count; i++) certain[i] = conclude(sea, &r[i], &blocks[i]);
}

void KERNEL(bolan_query_approach)(const query_sea *sea, query_block *blocks, uint32_t count, uint32_t *certain) {
    query_tangents rest[QUERY_BLOCKS];
    if (sea->choppiness > 0.0f) {
        guess(sea, blocks, count, rest);
    } else {
        memset(rest, 0, sizeof rest);
    }
    refine(sea, rest, blocks, count, certain);
}

// ---- one place ------------------------------------------------------------------------------------------------------

static inline void add_cascade(const query_sea *sea, uint32_t c, const query_block *b, const spline_values *f,
                               fields *out) {
    const query_axes *axes = &b->axes[c];
    const float *weight = b->attenuation[c];
    for (int p = 0; p < SPLINE_FIELDS; p++) LANES(l) {
            out->value[p][l] += weight[l] * f->value[p][l];
            out->by_x[p][l] += weight[l] * (f->along[p][l] * axes->ux[l] + f->across[p][l] * axes->vx[l]);
            out->by_y[p][l] += weight[l] * (f->along[p][l] * axes->uy[l] + f->across[p][l] * axes->vy[l]);
        }
    LANES(l) out->value[SPLINE_HEIGHT][l] += weight[l] * weight[l] * sea->lift[c];
}

// Where the attenuation changes, it leans the water as well. The lift goes with its square.
static inline void add_lean(const query_sea *sea, uint32_t c, const query_block *b, const spline_values *f,
                            fields *out) {
    for (int p = 0; p < SPLINE_FIELDS; p++) LANES(l) {
            const float lift = p == SPLINE_HEIGHT ? 2.0f * b->attenuation[c][l] * sea->lift[c] : 0.0f;
            out->by_x[p][l] += (f->value[p][l] + lift) * b->lean_x[c][l];
            out->by_y[p][l] += (f->value[p][l] + lift) * b->lean_y[c][l];
        }
}

static inline void add_bound(const query_sea *sea, uint32_t c, const query_block *b, const spline_values *f,
                             bound *all) {
    fields own;
    set_fields(b, c, f, &own);
    if (b->leans)
        for (int p = 0; p < SPLINE_FIELDS; p++) LANES(l) {
                own.by_x[p][l] += f->value[p][l] * b->lean_x[c][l];
                own.by_y[p][l] += f->value[p][l] * b->lean_y[c][l];
            }
    add_bound_slope(&sea->cascade[c], &own, all);
    add_bound_height(&sea->cascade[c], &own, all);
}

// The cascades from `first` on, at the present offsets.
static inline void sum_cascades(const query_sea *sea, uint32_t first, uint32_t lanes, const query_block *block,
                                fields *sum) {
    bound all;
    memset(sum, 0, sizeof *sum);
    if (sea->bound) memset(&all, 0, sizeof all);
    for (uint32_t c = first; c < sea->count; c++) {
        spots at;
        spline_values f;
        find_spots(&sea->cascade[c], block, c, &at);
        read_splines(&sea->cascade[c], &at, lanes, &f);
        add_cascade(sea, c, block, &f, sum);
        if (block->leans) add_lean(sea, c, block, &f, sum);
        if (sea->bound) add_bound(sea, c, block, &f, &all);
    }
    if (sea->bound) LANES(l) {
            sum->value[SPLINE_HEIGHT][l] += all.height[l];
            sum->by_x[SPLINE_HEIGHT][l] += all.x[l];
            sum->by_y[SPLINE_HEIGHT][l] += all.y[l];
        }
}

void KERNEL(bolan_query_evaluate)(const query_sea *sea, uint32_t lanes, query_block *block) {
    const float lambda = sea->choppiness;
    fields sum;
    sum_cascades(sea, 0, lanes, block, &sum);
    LANES(l) {
        const bool on = lanes >> l & 1;
        block->rx[l] = on ? block->ox[l] + lambda * sum.value[SPLINE_DX][l] : block->rx[l];
        block->ry[l] = on ? block->oy[l] + lambda * sum.value[SPLINE_DY][l] : block->ry[l];
        block->height[l] = on ? sum.value[SPLINE_HEIGHT][l] : block->height[l];
        block->slope_x[l] = on ? sum.by_x[SPLINE_HEIGHT][l] : block->slope_x[l];
        block->slope_y[l] = on ? sum.by_y[SPLINE_HEIGHT][l] : block->slope_y[l];
        block->jxx[l] = on ? 1.0f + lambda * sum.by_x[SPLINE_DX][l] : block->jxx[l];
        block->jxy[l] = on ? lambda * sum.by_y[SPLINE_DX][l] : block->jxy[l];
        block->jyx[l] = on ? lambda * sum.by_x[SPLINE_DY][l] : block->jyx[l];
        block->jyy[l] = on ? 1.0f + lambda * sum.by_y[SPLINE_DY][l] : block->jyy[l];
    }
}

void KERNEL(bolan_query_surface)(const query_sea *sea, query_block *block) {
    const float lambda = sea->choppiness;
    const query_tangent *k = &block->kept.sum;
    fields sum;
    sum_cascades(sea, sea->again, QUERY_ALL_LANES, block, &sum);
    LANES(l) {
        const float ox = block->ox[l], oy = block->oy[l];
        block->rx[l] = ox + ((k->x[l] + (k->xx[l] * ox + k->xy[l] * oy)) + lambda * sum.value[SPLINE_DX][l]);
        block->ry[l] = oy + ((k->y[l] + (k->yx[l] * ox + k->yy[l] * oy)) + lambda * sum.value[SPLINE_DY][l]);
        block->slope_x[l] = block->kept.height.x[l] + sum.by_x[SPLINE_HEIGHT][l];
        block->slope_y[l] = block->kept.height.y[l] + sum.by_y[SPLINE_HEIGHT][l];
        block->jxx[l] = 1.0f + (k->xx[l] + lambda * sum.by_x[SPLINE_DX][l]);
        block->jxy[l] = k->xy[l] + lambda * sum.by_y[SPLINE_DX][l];
        block->jyx[l] = k->yx[l] + lambda * sum.by_x[SPLINE_DY][l];
        block->jyy[l] = 1.0f + (k->yy[l] + lambda * sum.by_y[SPLINE_DY][l]);
    }
}

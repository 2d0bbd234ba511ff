// SPDX-License-Identifier: MIT
// The lanes of a query block, compiled once per instruction set: cubic splines in the planes of all cascades for the
// equation of block.h. The shader twin is cascade_displacement() of shaders/common/sea.glsl.
#include "query/block.h"
#include "shared/cascade.glsl"
#include "shared/warp.glsl"

#include <math.h>
#include <string.h>

#define QUERY_JOIN2(a, b) a##_##b
#define QUERY_JOIN(a, b) QUERY_JOIN2(a, b)
#define KERNEL(name) QUERY_JOIN(name, BOLAN_KERNEL_SUFFIX)
#define LANES(l) for (int l = 0; l < QUERY_LANES; l++)

void KERNEL(bolan_query_locate)(const query_sea *sea, query_block *block);
void KERNEL(bolan_query_approach)(const query_sea *sea, query_block *block);
void KERNEL(bolan_query_evaluate)(const query_sea *sea, uint32_t lanes, query_block *block);

// ---- places ---------------------------------------------------------------------------------------------------------

static inline int32_t floor_to_int(float x) {
    const int32_t i = (int32_t)x;
    return i - (x < (float)i);
}

static inline double fraction(double x) {
    const double f = x - floor(x);
    return f >= 0.0 && f < 1.0 ? f : 0.0; // 1 by rounding of a tiny negative, or not a number
}

// The places of the warped plane that the points are read at.
static void warp(const query_sea *sea, query_block *block, double *x, double *y) {
    const bolan_sea_warp *w = &sea->warp;
    LANES(l) {
        x[l] = block->x[l] - sea->origin_x; // the water drifts
        y[l] = block->y[l] - sea->origin_y;
        block->warp[0][l] = block->warp[3][l] = 1.0f;
        block->warp[1][l] = block->warp[2][l] = 0.0f;
    }
    for (uint32_t i = 0; i < w->count; i++) {
        const double kx = w->wave[i].kx, ky = w->wave[i].ky, ax = w->wave[i].ax, ay = w->wave[i].ay;
        const float xx = (float)(ax * kx), xy = (float)(ax * ky), yx = (float)(ay * kx), yy = (float)(ay * ky);
        LANES(l) {
            const double turn =
                fraction(kx * (block->x[l] - sea->origin_x) + ky * (block->y[l] - sea->origin_y) + w->wave[i].phase);
            const double value = warp_wave(turn);
            const float slope = (float)warp_slope(turn);
            x[l] += ax * value;
            y[l] += ay * value;
            block->warp[0][l] += xx * slope;
            block->warp[1][l] += xy * slope;
            block->warp[2][l] += yx * slope;
            block->warp[3][l] += yy * slope;
        }
    }
}

void KERNEL(bolan_query_locate)(const query_sea *sea, query_block *block) {
    double x[QUERY_LANES], y[QUERY_LANES];
    warp(sea, block, x, y);
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
    }
}

// ---- splines --------------------------------------------------------------------------------------------------------

// Four floats: samples side by side, or (dx, dy, height, 0).
typedef float four __attribute__((vector_size(16)));
typedef int32_t four_int __attribute__((vector_size(16)));

static inline four load_four(const float *p) {
    four v;
    memcpy(&v, p, sizeof v);
    return v;
}

#ifdef __clang__
#define SHUFFLE(a, b, ...) __builtin_shufflevector(a, b, __VA_ARGS__)
#else
#define SHUFFLE(a, b, ...) __builtin_shuffle(a, b, (four_int){__VA_ARGS__})
#endif

// The sums of the elements of each.
static inline four sums_of(four a, four b, four c) {
    const four ab = SHUFFLE(a, b, 0, 4, 1, 5) + SHUFFLE(a, b, 2, 6, 3, 7); // a0 + a2, b0 + b2, a1 + a3, b1 + b3
    const four cc = c + SHUFFLE(c, c, 2, 3, 0, 1);
    return SHUFFLE(ab, cc, 0, 1, 4, 4) + SHUFFLE(ab, cc, 2, 3, 5, 5);
}

static inline four spread(float x) { return (four){x, x, x, x}; }

// Where each lane's place lies among the samples of one cascade: the first of four columns and of four rows, fractions.
typedef struct spots {
    int32_t column[QUERY_LANES], row[QUERY_LANES];
    float u[QUERY_LANES], v[QUERY_LANES];
} spots;

// Offsets lead to places of the warped plane by its tangent.
static inline void find_spots(const query_cascade *t, const query_block *block, uint32_t c, spots *out) {
    const float cu = t->c * t->cells_per_metre, su = t->s * t->cells_per_metre;
    const int32_t mask = (int32_t)t->n - 1;
    LANES(l) {
        const float ox = block->ox[l], oy = block->oy[l];
        const float x = block->warp[0][l] * ox + block->warp[1][l] * oy;
        const float y = block->warp[2][l] * ox + block->warp[3][l] * oy;
        const float u = block->part_u[c][l] + (x * cu + y * su), v = block->part_v[c][l] + (y * cu - x * su);
        const int32_t iu = floor_to_int(u), iv = floor_to_int(v);
        out->u[l] = u - (float)iu;
        out->v[l] = v - (float)iv;
        out->column[l] = (block->cell_u[c][l] + iu - 1) & mask;
        out->row[l] = (block->cell_v[c][l] + iv - 1) & mask;
    }
}

// The four weights of spline.h at a fraction, and their derivatives.
static inline four weights(four t) {
    const four c0 = {1.0f / 6.0f, 2.0f / 3.0f, 1.0f / 6.0f, 0.0f}, c1 = {-0.5f, 0.0f, 0.5f, 0.0f},
               c2 = {0.5f, -1.0f, 0.5f, 0.0f}, c3 = {-1.0f / 6.0f, 0.5f, -0.5f, 1.0f / 6.0f};
    return c0 + t * (c1 + t * (c2 + t * c3));
}
static inline four slopes(four t) {
    const four c1 = {-0.5f, 0.0f, 0.5f, 0.0f}, c2 = {1.0f, -2.0f, 1.0f, 0.0f}, c3 = {-0.5f, 1.5f, -1.5f, 0.5f};
    return c1 + t * (c2 + t * c3);
}

// The samples around a spot: 4 rows of 4 in each plane.
typedef struct patch {
    const float *plane[3];
    size_t row[4];
} patch;

// Where the samples go round the end of the tile: copied side by side.
static __attribute__((noinline)) void copy_patch(const query_cascade *t, uint32_t column, uint32_t row,
                                                 float out[3][16]) {
    const float *const planes[3] = {t->dx, t->dy, t->height};
    const uint32_t mask = t->n - 1;
    for (int p = 0; p < 3; p++)
        for (uint32_t j = 0; j < 4; j++)
            for (uint32_t i = 0; i < 4; i++)
                out[p][4 * j + i] = planes[p][((row + j) & mask) * t->n + ((column + i) & mask)];
}

static inline patch patch_of(const query_cascade *t, const spots *at, int l, float room[3][16]) {
    const uint32_t n = t->n, mask = n - 1, column = (uint32_t)at->column[l], row = (uint32_t)at->row[l];
    if (column + 3 > mask) {
        copy_patch(t, column, row, room);
        return (patch){{room[0], room[1], room[2]}, {0, 4, 8, 12}};
    }
    return (patch){{t->dx + column, t->dy + column, t->height + column},
                   {(size_t)row * n, (size_t)((row + 1) & mask) * n, (size_t)((row + 2) & mask) * n,
                    (size_t)((row + 3) & mask) * n}};
}

// (dx, dy, height, 0) and its derivatives along and across the tile, by its cells.
typedef struct cell_fields {
    four value, along, across;
} cell_fields;

// The weighted rows of a plane, with the weights and with their derivatives across.
typedef struct row_sums {
    four value, across;
} row_sums;

static inline row_sums rows_of(const float *plane, const size_t row[4], const four w[4], const four d[4]) {
    const four r0 = load_four(plane + row[0]), r1 = load_four(plane + row[1]), r2 = load_four(plane + row[2]),
               r3 = load_four(plane + row[3]);
    return (row_sums){(r0 * w[0] + r1 * w[1]) + (r2 * w[2] + r3 * w[3]),
                      (r0 * d[0] + r1 * d[1]) + (r2 * d[2] + r3 * d[3])};
}

static inline cell_fields fields_at(const query_cascade *t, const spots *at, int l, bool with_height) {
    float room[3][16];
    const patch p = patch_of(t, at, l, room);
    const four u = weights(spread(at->u[l])), du = slopes(spread(at->u[l]));
    const four v = weights(spread(at->v[l])), dv = slopes(spread(at->v[l]));
    const four w[4] = {SHUFFLE(v, v, 0, 0, 0, 0), SHUFFLE(v, v, 1, 1, 1, 1), SHUFFLE(v, v, 2, 2, 2, 2),
                       SHUFFLE(v, v, 3, 3, 3, 3)};
    const four d[4] = {SHUFFLE(dv, dv, 0, 0, 0, 0), SHUFFLE(dv, dv, 1, 1, 1, 1), SHUFFLE(dv, dv, 2, 2, 2, 2),
                       SHUFFLE(dv, dv, 3, 3, 3, 3)};
    const row_sums x = rows_of(p.plane[0], p.row, w, d), y = rows_of(p.plane[1], p.row, w, d);
    const row_sums z = with_height ? rows_of(p.plane[2], p.row, w, d) : (row_sums){{0}, {0}};
    return (cell_fields){sums_of(x.value * u, y.value * u, z.value * u),
                         sums_of(x.value * du, y.value * du, z.value * du),
                         sums_of(x.across * u, y.across * u, z.across * u)};
}

// The same in metres along the world's axes, by the place read or by the rest point, as they are summed over the
// cascades.
typedef struct fields {
    four value, by_x, by_y;
} fields;

static inline void add_fields(const query_cascade *t, float weight, const cell_fields *f, fields *sum) {
    const float cu = weight * t->c * t->cells_per_metre, su = weight * t->s * t->cells_per_metre;
    sum->value += f->value * weight;
    sum->by_x += f->along * cu - f->across * su;
    sum->by_y += f->along * su + f->across * cu;
}

// Where the attenuation changes, it leans the water as well. The lift goes with its square.
static inline void add_lean(const query_sea *sea, uint32_t c, const query_block *block, int l, four value,
                            fields *lean) {
    const four with_lift = value + (four){0.0f, 0.0f, 2.0f * block->attenuation[c][l] * sea->lift[c], 0.0f};
    lean->by_x += with_lift * block->lean_x[c][l];
    lean->by_y += with_lift * block->lean_y[c][l];
}

// Residual, slopes and Jacobian matrix from sums over the cascades.
static inline void put_fields(const query_sea *sea, const fields *sum, const fields *lean, int l, query_block *block) {
    const float lambda = sea->choppiness;
    const four by_x = sum->by_x * block->warp[0][l] + sum->by_y * block->warp[2][l] + lean->by_x;
    const four by_y = sum->by_x * block->warp[1][l] + sum->by_y * block->warp[3][l] + lean->by_y;
    block->rx[l] = block->ox[l] + lambda * sum->value[0];
    block->ry[l] = block->oy[l] + lambda * sum->value[1];
    block->height[l] = sum->value[2];
    block->slope_x[l] = by_x[2];
    block->slope_y[l] = by_y[2];
    block->jxx[l] = 1.0f + lambda * by_x[0];
    block->jxy[l] = lambda * by_y[0];
    block->jyx[l] = lambda * by_x[1];
    block->jyy[l] = 1.0f + lambda * by_y[1];
}

// ---- the kernels ----------------------------------------------------------------------------------------------------

void KERNEL(bolan_query_approach)(const query_sea *sea, query_block *block) {
    const fields none = {{0}, {0}, {0}};
    fields sum[QUERY_LANES];
    memset(sum, 0, sizeof sum);
    for (uint32_t c = 0; c < sea->count; c++) {
        const query_cascade *t = &sea->cascade[c];
        spots at;
        find_spots(t, block, c, &at);
        LANES(l) {
            const cell_fields f = fields_at(t, &at, l, false);
            add_fields(t, block->attenuation[c][l], &f, &sum[l]);
            put_fields(sea, &sum[l], &none, l, block);
        }
        float x[QUERY_LANES], y[QUERY_LANES];
        LANES(l) {
            x[l] = block->ox[l];
            y[l] = block->oy[l];
            query_newton(block, (uint32_t)l);
        }
        LANES(l) sum[l].value += sum[l].by_x * (block->ox[l] - x[l]) + sum[l].by_y * (block->oy[l] - y[l]);
    }
}

void KERNEL(bolan_query_evaluate)(const query_sea *sea, uint32_t lanes, query_block *block) {
    fields sum[QUERY_LANES], lean[QUERY_LANES];
    memset(sum, 0, sizeof sum);
    memset(lean, 0, sizeof lean);
    for (uint32_t c = 0; c < sea->count; c++) {
        const query_cascade *t = &sea->cascade[c];
        spots at;
        find_spots(t, block, c, &at);
        LANES(l) {
            if (!(lanes >> l & 1)) continue;
            const cell_fields f = fields_at(t, &at, l, true);
            add_fields(t, block->attenuation[c][l], &f, &sum[l]);
            if (block->leans) add_lean(sea, c, block, l, f.value, &lean[l]);
        }
    }
    LANES(l) {
        if (!(lanes >> l & 1)) continue;
        put_fields(sea, &sum[l], &lean[l], l, block);
        for (uint32_t c = 0; c < sea->count; c++)
            block->height[l] += block->attenuation[c][l] * block->attenuation[c][l] * sea->lift[c];
    }
}

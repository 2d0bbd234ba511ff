// SPDX-License-Identifier: MIT
// The lanes of a query block, compiled once per instruction set. Bilinear look-ups in the planes of all cascades, and
// Newton's method on the equation of block.h. The shader twin of the look-up is the texture unit, in the vertex shader
// of shaders/common/water_vertex.glsl.
#include "query/block.h"
#include "shared/cascade.glsl"

#include <math.h>

#define QUERY_JOIN2(a, b) a##_##b
#define QUERY_JOIN(a, b) QUERY_JOIN2(a, b)
#define KERNEL(name) QUERY_JOIN(name, BOLAN_KERNEL_SUFFIX)
#define LANES(l) for (int l = 0; l < QUERY_LANES; l++)

void KERNEL(bolan_query_locate)(const query_sea *sea, query_block *block);
void KERNEL(bolan_query_step)(const query_sea *sea, uint32_t cascades, query_block *block);
void KERNEL(bolan_query_evaluate)(const query_sea *sea, bool full, query_block *block);

// Where each lane's rest point lies in one cascade: the four samples around it, and the weights.
typedef struct corners {
    int32_t i00[QUERY_LANES], i10[QUERY_LANES], i01[QUERY_LANES], i11[QUERY_LANES];
    float fu[QUERY_LANES], fv[QUERY_LANES];
} corners;

static inline int32_t floor_to_int(float x) {
    const int32_t i = (int32_t)x;
    return i - (x < (float)i);
}

static inline double fraction(double x) {
    const double f = x - floor(x);
    return f >= 0.0 && f < 1.0 ? f : 0.0; // 1 by rounding of a tiny negative, or not a number
}

void KERNEL(bolan_query_locate)(const query_sea *sea, query_block *block) {
    for (uint32_t c = 0; c < sea->count; c++) {
        const query_cascade *t = &sea->cascade[c];
        const double n = t->n;
        LANES(l) {
            const double x = block->x[l] - sea->origin_x, y = block->y[l] - sea->origin_y;
            const double u = fraction(along_tile(x, y, t->tile_c, t->tile_s)) * n;
            const double v = fraction(across_tile(x, y, t->tile_c, t->tile_s)) * n;
            block->cell_u[c][l] = (int32_t)u;
            block->cell_v[c][l] = (int32_t)v;
            block->part_u[c][l] = (float)(u - (double)block->cell_u[c][l]);
            block->part_v[c][l] = (float)(v - (double)block->cell_v[c][l]);
        }
    }
}

static inline void find_corners(const query_cascade *t, const query_block *block, uint32_t c, corners *out) {
    const float cu = t->c * t->cells_per_metre, su = t->s * t->cells_per_metre;
    const int32_t n = (int32_t)t->n, mask = n - 1;
    LANES(l) {
        const float u = block->part_u[c][l] + (block->ox[l] * cu + block->oy[l] * su);
        const float v = block->part_v[c][l] + (block->oy[l] * cu - block->ox[l] * su);
        const int32_t iu = floor_to_int(u), iv = floor_to_int(v);
        const int32_t u0 = (block->cell_u[c][l] + iu) & mask, u1 = (u0 + 1) & mask;
        const int32_t v0 = ((block->cell_v[c][l] + iv) & mask) * n, v1 = (v0 + n) & (n * n - 1);
        out->fu[l] = u - (float)iu;
        out->fv[l] = v - (float)iv;
        out->i00[l] = v0 + u0;
        out->i10[l] = v0 + u1;
        out->i01[l] = v1 + u0;
        out->i11[l] = v1 + u1;
    }
}

// sum += weight * the plane, bilinear.
static inline void add_plane(const float *restrict plane, const corners *restrict at, const float *restrict weight,
                             float *restrict sum) {
    LANES(l) {
        const float south = plane[at->i00[l]] + (plane[at->i10[l]] - plane[at->i00[l]]) * at->fu[l];
        const float north = plane[at->i01[l]] + (plane[at->i11[l]] - plane[at->i01[l]]) * at->fu[l];
        sum[l] += weight[l] * (south + (north - south) * at->fv[l]);
    }
}

// The same with the gradient of the interpolated plane along the tile's axes, per cell: it costs no further look-up,
// and it is the derivative of exactly what Newton's method iterates on.
static inline void add_plane_gradient(const float *restrict plane, const corners *restrict at,
                                      const float *restrict weight, float *restrict sum, float *restrict sum_u,
                                      float *restrict sum_v) {
    LANES(l) {
        const float p00 = plane[at->i00[l]], p10 = plane[at->i10[l]], p01 = plane[at->i01[l]], p11 = plane[at->i11[l]];
        const float south = p00 + (p10 - p00) * at->fu[l], north = p01 + (p11 - p01) * at->fu[l];
        sum[l] += weight[l] * (south + (north - south) * at->fv[l]);
        sum_u[l] = weight[l] * ((p10 - p00) + ((p11 - p01) - (p10 - p00)) * at->fv[l]);
        sum_v[l] = weight[l] * (north - south);
    }
}

void KERNEL(bolan_query_step)(const query_sea *sea, uint32_t cascades, query_block *block) {
    float dx[QUERY_LANES] = {0}, dy[QUERY_LANES] = {0};
    float xx[QUERY_LANES] = {0}, xy[QUERY_LANES] = {0}, yx[QUERY_LANES] = {0}, yy[QUERY_LANES] = {0};
    float xu[QUERY_LANES], xv[QUERY_LANES], yu[QUERY_LANES], yv[QUERY_LANES];
    for (uint32_t i = 0; i < cascades; i++) {
        const query_cascade *t = &sea->cascade[i];
        corners at;
        find_corners(t, block, i, &at);
        add_plane_gradient(t->dx, &at, block->attenuation[i], dx, xu, xv);
        add_plane_gradient(t->dy, &at, block->attenuation[i], dy, yu, yv);
        const float cu = t->c * t->cells_per_metre, su = t->s * t->cells_per_metre;
        LANES(l) { // per cell along the tile's axes -> per metre along the world's
            xx[l] += xu[l] * cu - xv[l] * su;
            xy[l] += xu[l] * su + xv[l] * cu;
            yx[l] += yu[l] * cu - yv[l] * su;
            yy[l] += yu[l] * su + yv[l] * cu;
        }
    }
    const float lambda = sea->choppiness;
    LANES(l) {
        block->rx[l] = block->ox[l] + lambda * dx[l];
        block->ry[l] = block->oy[l] + lambda * dy[l];
        query_newton(block, l, 1.0f + lambda * xx[l], lambda * xy[l], lambda * yx[l], 1.0f + lambda * yy[l]);
    }
}

void KERNEL(bolan_query_evaluate)(const query_sea *sea, bool full, query_block *block) {
    float dx[QUERY_LANES] = {0}, dy[QUERY_LANES] = {0}, height[QUERY_LANES] = {0};
    float slope_x[QUERY_LANES] = {0}, slope_y[QUERY_LANES] = {0};
    float dxx[QUERY_LANES] = {0}, dyy[QUERY_LANES] = {0}, dxy[QUERY_LANES] = {0};
    for (uint32_t i = 0; i < sea->count; i++) {
        const query_cascade *t = &sea->cascade[i];
        const float *weight = block->attenuation[i];
        corners at;
        find_corners(t, block, i, &at);
        add_plane(t->dx, &at, weight, dx);
        add_plane(t->dy, &at, weight, dy);
        add_plane(t->height, &at, weight, height);
        LANES(l) height[l] += weight[l] * weight[l] * sea->lift[i]; // a product of two that are attenuated
        if (!full) continue;
        add_plane(t->slope_x, &at, weight, slope_x);
        add_plane(t->slope_y, &at, weight, slope_y);
        add_plane(t->dxx, &at, weight, dxx);
        add_plane(t->dyy, &at, weight, dyy);
        add_plane(t->dxy, &at, weight, dxy);
    }
    const float lambda = sea->choppiness;
    LANES(l) {
        block->rx[l] = block->ox[l] + lambda * dx[l];
        block->ry[l] = block->oy[l] + lambda * dy[l];
        block->height[l] = height[l];
        block->slope_x[l] = slope_x[l];
        block->slope_y[l] = slope_y[l];
        block->jxx[l] = 1.0f + lambda * dxx[l];
        block->jyy[l] = 1.0f + lambda * dyy[l];
        block->jxy[l] = lambda * dxy[l];
    }
}

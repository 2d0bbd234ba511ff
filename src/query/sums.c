// SPDX-License-Identifier: MIT
// A query block over a sea that is a sum of waves (waves/sum/sum.h): the same equation, with fields summed from
// the waves, so the result is the surface without interpolation.
#include "query/block.h"

static void locate(const query_sea *sea, query_block *block) { // no cells; they are copied with the block
    (void)sea;
    for (int l = 0; l < QUERY_LANES; l++) {
        block->cell_u[0][l] = block->cell_v[0][l] = 0;
        block->part_u[0][l] = block->part_v[0][l] = 0.0f;
    }
}

typedef struct fields {
    float at[SEA_FIELDS][QUERY_LANES];
} fields;

_Static_assert((int)QUERY_LANES == (int)SUM_LANES, "a block of points is one call of the sum's kernel");

// The fields at the rest points, as shallow water leaves them.
static void fields_of(const query_sea *sea, const query_block *block, fields *out) {
    double x[QUERY_LANES], y[QUERY_LANES];
    for (int l = 0; l < QUERY_LANES; l++) {
        x[l] = block->x[l] + (double)block->ox[l];
        y[l] = block->y[l] + (double)block->oy[l];
    }
    sea->sum_fields(sea->sum, x, y, NULL, out->at);
    for (int f = 0; f < SEA_FIELDS; f++) {
        for (int l = 0; l < QUERY_LANES; l++) out->at[f][l] *= block->attenuation[0][l];
    }
}

static void set_residual(const query_sea *sea, const fields *f, query_block *block) {
    for (int l = 0; l < QUERY_LANES; l++) {
        block->rx[l] = block->ox[l] + sea->choppiness * f->at[FIELD_DX][l];
        block->ry[l] = block->oy[l] + sea->choppiness * f->at[FIELD_DY][l];
    }
}

static void step(const query_sea *sea, uint32_t cascades, query_block *block) {
    (void)cascades;
    const float c = sea->choppiness;
    fields f;
    fields_of(sea, block, &f);
    set_residual(sea, &f, block);
    for (int l = 0; l < QUERY_LANES; l++) {
        const float xy = c * f.at[FIELD_DXY][l];
        query_newton(block, l, 1.0f + c * f.at[FIELD_DXX][l], xy, xy, 1.0f + c * f.at[FIELD_DYY][l]);
    }
}

static void evaluate(const query_sea *sea, bool full, query_block *block) {
    (void)full; // all fields come at once
    const float c = sea->choppiness;
    fields f;
    fields_of(sea, block, &f);
    set_residual(sea, &f, block);
    for (int l = 0; l < QUERY_LANES; l++) {
        const float keep = block->attenuation[0][l];
        block->height[l] = f.at[FIELD_HEIGHT][l] + keep * keep * sea->lift[0]; // a product of two that are attenuated
        block->slope_x[l] = f.at[FIELD_SLOPE_X][l];
        block->slope_y[l] = f.at[FIELD_SLOPE_Y][l];
        block->jxx[l] = 1.0f + c * f.at[FIELD_DXX][l];
        block->jyy[l] = 1.0f + c * f.at[FIELD_DYY][l];
        block->jxy[l] = c * f.at[FIELD_DXY][l];
    }
}

const query_kernels bolan_query_sum_kernels = {locate, step, evaluate};

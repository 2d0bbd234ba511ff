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

// The fields at the rest points, in deep water.
static void fields_of(const query_sea *sea, const query_block *block, fields *out) {
    double x[QUERY_LANES], y[QUERY_LANES];
    for (int l = 0; l < QUERY_LANES; l++) {
        x[l] = block->x[l] + (double)block->ox[l];
        y[l] = block->y[l] + (double)block->oy[l];
    }
    sea->sum_fields(sea->sum, x, y, block->fade, out->at);
}

static void evaluate(const query_sea *sea, uint32_t lanes, query_block *block) {
    const float c = sea->choppiness;
    fields f;
    fields_of(sea, block, &f);
    for (int l = 0; l < QUERY_LANES; l++) {
        if (!(lanes >> l & 1)) continue;
        const float keep = block->attenuation[0][l], lift = keep * sea->lift[0]; // a product of two that are attenuated
        const float dx = f.at[FIELD_DX][l], dy = f.at[FIELD_DY][l], height = f.at[FIELD_HEIGHT][l];
        const float lean_x = block->lean_x[0][l], lean_y = block->lean_y[0][l], twice = height + 2.0f * lift;
        block->rx[l] = block->ox[l] + c * (keep * dx);
        block->ry[l] = block->oy[l] + c * (keep * dy);
        block->height[l] = keep * (height + lift);
        block->slope_x[l] = keep * f.at[FIELD_SLOPE_X][l] + twice * lean_x;
        block->slope_y[l] = keep * f.at[FIELD_SLOPE_Y][l] + twice * lean_y;
        block->jxx[l] = 1.0f + c * (keep * f.at[FIELD_DXX][l] + dx * lean_x);
        block->jyy[l] = 1.0f + c * (keep * f.at[FIELD_DYY][l] + dy * lean_y);
        block->jxy[l] = c * (keep * f.at[FIELD_DXY][l] + dx * lean_y);
        block->jyx[l] = c * (keep * f.at[FIELD_DXY][l] + dy * lean_x);
    }
}

const query_kernels bolan_query_sum_kernels = {locate, NULL, NULL, evaluate};

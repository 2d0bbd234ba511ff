// SPDX-License-Identifier: MIT
// Several parcels at one place. Where choppy water folds over itself, equation (1) of block.h has more than one root:
// the layers of the fold. The highest layer is seen from above and is returned. All roots lie near a
// line along which the map is compressed most; the search starts Newton's method from a ladder of points on it, 16
// starts at once in a block of their own, since a fold may be as wide as a long crest or as narrow as a ripple.
#include "query/block.h"

#include <math.h>

static const float FOUND = 1e-3f; // [m] a residual below this is a root

bolan_vec2 bolan_query_compressed_direction(float xx, float yy, float xy) {
    const float half = 0.5f * (xx - yy);
    const float root = sqrtf(half * half + xy * xy);
    // Of the two rows of (M - least I) the larger one, turned by 90 degrees.
    const float x = half > 0.0f ? -xy : root - half;
    const float y = half > 0.0f ? half + root : -xy;
    const float length = sqrtf(x * x + y * y);
    return length > 0.0f ? (bolan_vec2){x / length, y / length} : (bolan_vec2){1.0f, 0.0f};
}

void bolan_query_copy_place(const query *q, const query_block *from, uint32_t lane, query_block *to, uint32_t l) {
    to->x[l] = from->x[lane];
    to->y[l] = from->y[lane];
    for (uint32_t c = 0; c < q->sea.count; c++) {
        to->cell_u[c][l] = from->cell_u[c][lane];
        to->cell_v[c][l] = from->cell_v[c][lane];
        to->part_u[c][l] = from->part_u[c][lane];
        to->part_v[c][l] = from->part_v[c][lane];
        to->axes[c].ux[l] = from->axes[c].ux[lane];
        to->axes[c].uy[l] = from->axes[c].uy[lane];
        to->axes[c].vx[l] = from->axes[c].vx[lane];
        to->axes[c].vy[l] = from->axes[c].vy[lane];
        to->attenuation[c][l] = from->attenuation[c][lane];
        to->lean_x[c][l] = from->lean_x[c][lane];
        to->lean_y[c][l] = from->lean_y[c][lane];
    }
    to->settled[l] = from->settled[lane];
    to->ox[l] = from->ox[lane];
    to->oy[l] = from->oy[lane];
}

// Sets starts around the result of `lane` of `from` (which may be `to` itself): lane 0 continues from the result, lane
// 1 starts at the point itself, the other lanes at +-reach / 2^i along the direction of compression.
static void spread_starts(const query *q, const query_block *from, uint32_t lane, query_block *to) {
    const float jxy = 0.5f * (from->jxy[lane] + from->jyx[lane]);
    const bolan_vec2 along = bolan_query_compressed_direction(from->jxx[lane], from->jyy[lane], jxy);
    const float ox = from->ox[lane], oy = from->oy[lane];
    float distance = q->reach;
    to->ox[0] = ox;
    to->oy[0] = oy;
    to->ox[1] = 0.0f;
    to->oy[1] = 0.0f;
    for (uint32_t l = 2; l < QUERY_LANES; l += 2) {
        for (uint32_t side = 0; side < 2; side++) {
            const float s = side ? -distance : distance;
            to->ox[l + side] = ox + s * along.x;
            to->oy[l + side] = oy + s * along.y;
        }
        distance *= 0.5f;
    }
}

// The highest lane that is a root; if none is, the lane with the smallest residual.
static uint32_t choose(const query_block *b) {
    uint32_t best = 0, nearest = 0;
    float top = -INFINITY, least = INFINITY;
    for (uint32_t l = 0; l < QUERY_LANES; l++) {
        const float residual = sqrtf(b->rx[l] * b->rx[l] + b->ry[l] * b->ry[l]);
        if (residual < least) {
            least = residual;
            nearest = l;
        }
        if (residual < FOUND && b->height[l] > top) {
            top = b->height[l];
            best = l;
        }
    }
    return least < FOUND ? best : nearest;
}

void bolan_query_search_folds(const query *q, query_block *block, uint32_t lane) {
    query_block starts;
    const query_block *from = block;
    uint32_t best = lane;
    starts.leans = block->leans;
    starts.fade = block->fade;
    for (uint32_t l = 0; l < QUERY_LANES; l++) bolan_query_copy_place(q, block, lane, &starts, l);
    for (int round = 0; round < 2; round++) { // the second from the best of the first, along its own direction
        spread_starts(q, from, best, &starts);
        bolan_query_solve(q, QUERY_ALL_LANES, QUERY_SEARCH_STEPS, &starts);
        best = choose(&starts);
        from = &starts;
    }
    block->ox[lane] = starts.ox[best];
    block->oy[lane] = starts.oy[best];
    block->rx[lane] = starts.rx[best];
    block->ry[lane] = starts.ry[best];
    block->height[lane] = starts.height[best];
    block->slope_x[lane] = starts.slope_x[best];
    block->slope_y[lane] = starts.slope_y[best];
    block->jxx[lane] = starts.jxx[best];
    block->jyy[lane] = starts.jyy[best];
    block->jxy[lane] = starts.jxy[best];
    block->jyx[lane] = starts.jyx[best];
}

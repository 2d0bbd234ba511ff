// SPDX-License-Identifier: MIT
// The projector of the static grid: from a place in the unit square (column, row) to mean water round the eye. Pure;
// the twin of bolan_surface_projector_vertices() in src/surface/projected.c, which says why it is so.

#include "shared/earth.glsl"
#include "shared/grid.glsl"

// Where a corner of a cell of a block (0..GRID_BLOCK each way) lies in the unit square: blocks stand row by row, the
// nearest first. cells: along both sides of the whole grid.
vec2 grid_place(vec2 corner, int block, vec2 cells) {
    int across = int(cells.x) / GRID_BLOCK;
    return (vec2(block % across, block / across) * float(GRID_BLOCK) + corner) / cells;
}

// reach: s of the first row, from there to the last row, height that sets the steps [m], of the eye over the water [m];
// azimuth: middle, half [rad], guard [m], earth radius [m]; cells along both sides. Gives eye-relative position and
// spacing [m].
vec4 grid_point(vec2 place, vec4 reach, vec4 azimuth, vec2 cells) {
    float s = reach.x + reach.y * place.y, x = grid_distance(s), r = reach.z * x;
    float radial = reach.z * grid_steepness(x) * reach.y / cells.y;
    float half_angle = grid_half_angle(azimuth.y, azimuth.z, r), a = azimuth.x + half_angle * (2.0 * place.x - 1.0);
    return vec4(r * sin(a), r * cos(a), -reach.w - earth_drop(r * r, azimuth.w),
                max(radial, r * 2.0 * half_angle / cells.x));
}

// SPDX-License-Identifier: MIT
// Lists of tiles of 8 x 8 pixels, by what a compute shader must do to shade them: compute/water_tiles.glsl fills the
// lists, common/pixels.glsl reads them. Twin of src/render/pixel_tiles.c.
const int TILES_OPEN = 0, TILES_DEEP = 1, TILES_NEAR = 2, TILE_CLASSES = 3;
const uint TILE_COLUMNS = 64u; // of the groups of an indirect dispatch
layout(std430, binding = 0) buffer Tiles {
    uvec4 run_of[TILE_CLASSES]; // x, y, z: groups of an indirect dispatch; w: tiles in the list
    uint land_in_sight;
    uint tiles[];               // column, row << 16: a list for each class, of the same capacity
};

uint tile_place(int list, uint i) { return uint(tiles.length()) / uint(TILE_CLASSES) * uint(list) + i; }

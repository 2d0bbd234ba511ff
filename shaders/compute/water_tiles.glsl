// SPDX-License-Identifier: MIT
// Sorts the tiles of the water that the physical optics shades where land or objects are in the scene. Tiles without
// water go into no list.
//
//   class  every pixel's water is                                    the shader leaves out
//   OPEN   deep, with nothing behind it; no land is in the image     all that land does
//   DEEP   so deep that the bed leaves waves and foam alone          waves and foam of shallow water
//   NEAR   any                                                       nothing
//
// BEGIN: one group, which runs first, empties the lists and looks for land in the image. Then, one group a tile.
#ifdef COMPUTE
#include "common/tiles.glsl"
layout(local_size_x = 8, local_size_y = 8) in; // PIXEL_GROUP of src/render/pixels.h
shared uint found;

#ifdef BEGIN
#include "shared/constants.glsl"
#pragma unit land_mirror 19
uniform sampler2D land_mirror;

void main() {
    const int level = int(LAND_MIRROR_LEVELS); // the coarsest that every pixel of the image is part of
    ivec2 size = textureSize(land_mirror, level);
    if (gl_LocalInvocationIndex == 0u) found = 0u;
    barrier();
    bool land = false;
    for (int i = int(gl_LocalInvocationIndex); i < size.x * size.y; i += 64)
        land = land || texelFetch(land_mirror, ivec2(i % size.x, i / size.x), level).a > 0.0;
    if (land) atomicOr(found, 1u);
    barrier();
    if (gl_LocalInvocationIndex > 0u) return;
    for (int i = 0; i < TILE_CLASSES; ++i) run_of[i] = uvec4(TILE_COLUMNS, 0u, 1u, 0u);
    land_in_sight = found;
}

#else
#include "common/frame.glsl"
#include "common/water_block.glsl"
#include "common/shape.glsl"
#include "common/shore_foam.glsl"
#include "common/shape_maps.glsl"
#include "common/behind.glsl"
uniform vec4 region; // of the target: left, bottom, right, top [px]

// What a tile has.
const uint WATER = 1u, SHALLOW = 2u, BED = 4u;
uint here(vec2 centre) {
    ivec2 pixel = sampled_pixel(centre);
    uvec4 texel = texelFetch(surface_shape, pixel, 0);
    vec3 where;
    uint bed = behind((vec2(pixel) + 0.5) * pixel_size, where).w > 0.0 ? BED : 0u;
    uint shallow = is_shallow(shape_of(texel, vec2(0.0)).depth) ? SHALLOW : 0u;
    return texel.x == 0u ? 0u : WATER | shallow | bed;
}

void main() {
    ivec2 at = ivec2(region.xy) + ivec2(gl_GlobalInvocationID.xy);
    if (gl_LocalInvocationIndex == 0u) found = 0u;
    barrier();
    if (float(at.x) < region.z && float(at.y) < region.w) atomicOr(found, here(vec2(at) + 0.5));
    barrier();
    if (gl_LocalInvocationIndex > 0u || found == 0u) return;
    bool open = found == WATER && land_in_sight == 0u;
    int list = open ? TILES_OPEN : (found & SHALLOW) == 0u ? TILES_DEEP : TILES_NEAR;
    uint i = atomicAdd(run_of[list].w, 1u);
    atomicMax(run_of[list].y, i / TILE_COLUMNS + 1u);
    tiles[tile_place(list, i)] = gl_WorkGroupID.x | gl_WorkGroupID.y << 16;
}
#endif
#endif

// SPDX-License-Identifier: MIT
// The two entry points of a pass over pixels: a fragment shader, and a compute shader that writes an image. Both call
// bool shade(vec2 centre, out vec4 color), which returns false where the pixel keeps its color. `centre` counts from
// the corner of the target [px]. TILES: the compute shader shades the tiles of a list.
#ifdef FRAGMENT
out vec4 color;
void main() {
    if (!shade(gl_FragCoord.xy, color)) discard;
}
#endif
#ifdef COMPUTE
layout(local_size_x = 8, local_size_y = 8) in; // PIXEL_GROUP of src/render/pixels.h
layout(rgba16f, binding = 0) uniform writeonly image2D target;
uniform vec4 region; // of the target: left, bottom, right, top [px]

#ifdef TILES
#include "common/tiles.glsl"
uniform int tile_class;

// False: the list is shorter.
bool find_tile(out ivec2 at) {
    uint i = gl_WorkGroupID.y * TILE_COLUMNS + gl_WorkGroupID.x;
    at = ivec2(0);
    if (i >= run_of[tile_class].w) return false;
    uint tile = tiles[tile_place(tile_class, i)];
    at = ivec2(tile & 65535u, tile >> 16);
    return true;
}
#else
bool find_tile(out ivec2 at) {
    at = ivec2(gl_WorkGroupID.xy);
    return true;
}
#endif

void main() {
    ivec2 tile;
    if (!find_tile(tile)) return;
    ivec2 at = ivec2(region.xy) + 8 * tile + ivec2(gl_LocalInvocationID.xy);
    vec4 color;
    if (float(at.x) < region.z && float(at.y) < region.w && shade(vec2(at) + 0.5, color)) imageStore(target, at, color);
}
#endif

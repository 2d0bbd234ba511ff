// SPDX-License-Identifier: MIT
// Foam at the shore in the physical optics, and the depth beyond which the bed leaves foam and waves alone:
// water_physical.glsl shades by the one, compute/water_tiles.glsl sorts by the other. Needs common/frame.glsl.
#include "common/shore.glsl"
#include "common/surf.glsl"

// The look of the shore in this optics, chosen by eye.
const surf_look SURF_LOOK = surf_look(0.35, 1.6, 0.1, 0.02, 0.35, 0.75, 0.0);
const float SURF_WOBBLE = 1.0; // most by which noise moves the zone of bores, in significant heights
const float ROCKS_DRY = 1.5, ROCKS_DEEP = 0.8; // heights that the surge covers: this much dry [m], this much drowned
const float ROCKS_MEAN = 0.55, ROCKS_PULSE = 0.45; // cover by surge

// The least depth of the mean water within a few metres [m]; `depth` where no rocks can be so near.
const float ROCKS_NEAR = 5.0, ROCKS_STEEP = 3.0; // [m]; rise of the bed over its run
const float ROCKS_REACH = ROCKS_DEEP + ROCKS_STEEP * ROCKS_NEAR; // depth without rocks [m]
float least_depth(vec2 rest, float depth) {
    float least = depth;
    for (int i = 0; i < 4 && depth < ROCKS_REACH; ++i) {
        vec2 d = ROCKS_NEAR * vec2(i < 2 ? 1.0 : -1.0, (i & 1) == 0 ? 1.0 : -1.0);
        least = min(least, -shore_elevation(rest + d));
    }
    return least;
}

// Bores, swash at the edge, and surge at rocks. water_path: depth under the pixel [m]. noise: 0 to 1, bends the fronts
// and lets the surge come at different times.
float shore_cover(vec2 rest, float depth, float water_path, vec2 noise) {
    float wobble = 2.0 * (noise.x - 0.5); // as wide as a uniform distribution
    float bore = bore_foam(behind_front(rest, depth, 0.9 * wobble + noise.y));
    float broken = surf_cover(depth / shore_height + SURF_WOBBLE * wobble, bore, SURF_LOOK);
    float rocks = shallows(least_depth(rest, depth), -ROCKS_DRY, ROCKS_DEEP);
    rocks *= surge(ROCKS_MEAN, ROCKS_PULSE, surf_time + 2.0 * wobble);
    return clamp(max(max(broken, rocks), swash_cover(water_path, surf_time, SURF_LOOK)), 0.0, 1.0);
}

// False: the water is so deep that shore_cover() is 0, and every wave that of deep water. The edge, where the swash is,
// lies no deeper than a trough.
bool is_shallow(float depth) {
    vec4 bands = vec4(cascade_band[0].x, cascade_band[1].x, cascade_band[2].x, cascade_band[3].x);
    bool shallow = depth < max((SURF_LOOK.zone_none + SURF_WOBBLE) * shore_height, ROCKS_REACH);
    shallow = shallow || feels_bed(depth, max(significant_height, length(bands)));
    for (int i = 0; i < layer_count; ++i) shallow = shallow || feels_bed(depth, layer_extent[i].w);
    return shallow;
}

// SPDX-License-Identifier: MIT
// The vertices of the nested levels, from their places in a level. Pure but for the uniform blocks; the twin of
// bolan_surface_nested_vertices() in src/surface/nested_vertices.c, which says why it is so.
//
// nested_level counts from an anchor near the eye, by whole multiples of the finest spacing. So places of vertices that
// two levels share are equal to the last bit before the eye is subtracted, and after it.
#include "shared/earth.glsl"

struct nested_vertex {
    vec4 at;     // eye-relative mean water, spacing [m]
    vec2 stitch; // to the neighbours whose mean this vertex is [m]; (0, 0): none
};

bool nested_on_border(vec2 cell, float cells) {
    return min(cell.x, cell.y) < 0.5 || max(cell.x, cell.y) > cells - 0.5;
}

// From the level's spacing in the middle, and on the border of its hole, to twice that on its own border.
float nested_spacing(vec2 cell, vec4 level) {
    if (nested_on_border(cell, level.w)) return 2.0 * level.z;
    vec2 from = abs(level.xy + cell * level.z - nested_centre.xy) / level.z;
    return level.z * clamp(1.0 + (max(from.x, from.y) - nested_centre.z) * nested_centre.w, 1.0, 2.0);
}

vec3 nested_place(vec2 cell, vec4 level) {
    vec2 at = (level.xy + cell * level.z) - nested_eye.xy;
    return vec3(at, -nested_eye.z - earth_drop(dot(at, at), earth_radius));
}

// cell: whole numbers, 0 to those of the level each way.
nested_vertex nested_vertex_of(vec2 cell, int index) {
    vec4 level = nested_level[index];
    float spacing = max(nested_spacing(cell, level), nested_eye.w);
    bool odd = mod(cell.x + cell.y, 2.0) > 0.5;
    bool stitched = index > 0 && odd && nested_on_border(cell, level.w);
    if (!stitched) return nested_vertex(vec4(nested_place(cell, level), spacing), vec2(0.0));
    vec2 along = min(cell.y, level.w - cell.y) < 0.5 ? vec2(1.0, 0.0) : vec2(0.0, 1.0);
    vec3 mean = 0.5 * (nested_place(cell - along, level) + nested_place(cell + along, level));
    return nested_vertex(vec4(mean, spacing), along * level.z);
}

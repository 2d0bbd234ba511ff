// SPDX-License-Identifier: MIT
// Where a water ends: a polygon, cut exactly where the displaced surface crosses its sides. src/render/bounds.c fills
// the block. A point is inside where a ray towards east crosses an odd number of sides.
layout(std140) uniform Bounds {
    vec4 bounds_side[64]; // eye-relative: xy from, zw to [m]
    int bounds_count;     // of the sides; 0: the water has no end
};

bool is_within_bounds(vec2 place) {
    bool inside = bounds_count == 0;
    for (int i = 0; i < bounds_count; ++i) {
        vec4 side = bounds_side[i];
        bool crosses = (side.y > place.y) != (side.w > place.y);
        if (crosses && place.x < side.x + (side.z - side.x) * (place.y - side.y) / (side.w - side.y)) inside = !inside;
    }
    return inside;
}

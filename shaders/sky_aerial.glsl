// SPDX-License-Identifier: MIT
// Table: light that the air between the eye and a distance adds; one slice a draw (common/sky_table.glsl).
#include "common/fullscreen.glsl"
#ifdef VERTEX
void main() { fullscreen(0.5); }
#endif
#ifdef FRAGMENT
#include "common/scatter.glsl"
#include "common/sky_table.glsl"
uniform float slice; // 0..1
out vec4 color;

void main() {
    vec2 x = (uv * AERIAL_SIZE.xy - 0.5) / (AERIAL_SIZE.xy - 1.0);
    float h = max(eye_height, 0.0), dip = horizon_dip(h), side = 2.0 * x.y - 1.0;
    float range = side > 0.0 ? 0.5 * PI + dip : 0.5 * PI - dip;
    vec3 dir = sky_direction(x.x, sign(side) * side * side * range, h), left;
    // Past the sea's surface the ray goes on along it (height 0), so that the table is smooth across the horizon.
    float reach = min(aerial_distance(slice), distance_to_top(h, dir.z));
    color = vec4(scattered_light(h, dir, reach, 20, left), dot(left, vec3(1.0 / 3.0)));
}
#endif

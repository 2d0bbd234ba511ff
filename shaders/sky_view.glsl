// SPDX-License-Identifier: MIT
// Table: radiance of the clear sky, without the sun's disc, as seen from `view_height` (common/sky_table.glsl).
#include "common/fullscreen.glsl"
#ifdef VERTEX
void main() { fullscreen(0.5); }
#endif
#ifdef FRAGMENT
#include "common/scatter.glsl"
#include "common/sky_table.glsl"
uniform float view_height;
out vec4 color;

void main() {
    vec2 x = (uv * SKY_VIEW_SIZE - 0.5) / (SKY_VIEW_SIZE - 1.0);
    float h = max(view_height, 0.0), above = x.y * x.y * (0.5 * PI + horizon_dip(h));
    vec3 dir = sky_direction(x.x, above, h), left;
    vec3 light = scattered_light(h, dir, distance_to_top(h, dir.z), 48, left);
    color = vec4(light + night_radiance() * left, 1.0);
}
#endif

// SPDX-License-Identifier: MIT
// Clear sky and clouds together, as sky.glsl draws them: with the layout of the cloud panorama, texel for
// texel, so that no resolution is lost. Sky below the horizon is not in it.
#include "common/fullscreen.glsl"
#ifdef VERTEX
void main() { fullscreen(0.5); }
#endif
#ifdef FRAGMENT
#include "common/frame.glsl"
#include "common/atmosphere.glsl"
out vec4 color;

void main() {
    float azimuth = 2.0 * PI * uv.x;
    vec2 sky = vec2(sun_azimuth_coordinate(vec2(cos(azimuth), sin(azimuth))), uv.y);
    vec3 air_light = textureLod(sky_view_table, to_texel_centres(sky, SKY_VIEW_SIZE), 0.0).rgb;
    float row = eye_above_clouds > 0.5 ? mix(CLOUD_HORIZON, 1.0, uv.y) : uv.y;
    vec4 clouds = textureLod(cloud_map, vec3(uv.x, row, 0.0), 0.0);
    color = vec4(air_light * (1.0 - clouds.a) + clouds.rgb, 1.0);
}
#endif

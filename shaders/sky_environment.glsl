// SPDX-License-Identifier: MIT
// The environment map: sky and clouds as the sea reflects them. For an eye under the clouds their panorama is used. An
// eye above them has a panorama of their tops only, so the map holds a clear sky.
#include "common/fullscreen.glsl"
#ifdef VERTEX
void main() { fullscreen(0.5); }
#endif
#ifdef FRAGMENT
#include "common/atmosphere.glsl"
uniform sampler2D sea_view_table; // sky radiance as seen from the sea
#pragma unit sea_view_table 15
out vec4 color;

void main() {
    vec3 dir = environment_direction(uv);
    vec3 sky = textureLod(sea_view_table, sky_view_uv(dir, 2.0), 0.0).rgb;
    vec4 clouds = cloud_radiance(dir) * (1.0 - eye_above_clouds);
    color = vec4(sky * (1.0 - clouds.a) + clouds.rgb, 1.0);
}
#endif

// SPDX-License-Identifier: MIT
// The environment map: sky and clouds as the sea mirrors them. Under the clouds their panorama is as good from the eye as
// from the water; from above them only their mean is known here.
#include "common/fullscreen.glsl"
#ifdef VERTEX
void main() { fullscreen(0.5); }
#endif
#ifdef FRAGMENT
#include "common/atmosphere.glsl"
uniform sampler2D sea_view_table; // sky radiance as seen from the sea
#pragma unit sea_view_table 15
uniform vec4 cloud_mean;          // premultiplied radiance and cover of the clouds from below, when the eye is above them
out vec4 color;

void main() {
    vec3 dir = environment_direction(uv);
    vec3 sky = textureLod(sea_view_table, sky_view_uv(dir, 2.0), 0.0).rgb;
    vec4 clouds = air.y > 0.5 ? cloud_mean * smoothstep(0.0, 0.1, dir.z) : cloud_radiance(dir);
    color = vec4(sky * (1.0 - clouds.a) + clouds.rgb, 1.0);
}
#endif

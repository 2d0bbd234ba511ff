// SPDX-License-Identifier: MIT
// What common/atmosphere.glsl answers, one question a pixel: x selects the question, `ask` holds its arguments.
#include "common/fullscreen.glsl"
#ifdef VERTEX
void main() { fullscreen(0.5); }
#endif
#ifdef FRAGMENT
#include "common/atmosphere.glsl"
uniform vec4 ask; // xyz: direction or position, w: a distance, height or roughness
out vec4 color;

void main() {
    int question = int(gl_FragCoord.x);
    vec3 transmittance, inscatter;
    aerial_perspective(ask.xyz, transmittance, inscatter);
    color = vec4(0.0, 0.0, 0.0, 1.0);
    if (question == 0) color.rgb = sky_radiance(normalize(ask.xyz));
    if (question == 1) color.rgb = transmittance;
    if (question == 2) color.rgb = inscatter;
    if (question == 3) color.rgb = environment_radiance(normalize(ask.xyz), ask.w);
    if (question == 4) color.rgb = sun_transmittance(ask.w);
    if (question == 5)
        color.rgb = vec3(cloud_shadow(ask.xy), horizon_dip(ask.w),
                         air_height(ask.w, normalize(ask.xyz).z, length(ask.xyz)));
    if (question == 6) color.rgb = environment_direction(environment_uv(normalize(ask.xyz)));
}
#endif

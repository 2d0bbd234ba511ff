// SPDX-License-Identifier: MIT
// The triangles of the water's surface, where its waves put them: FILL, a plain face to hide what is behind; else their
// edges.
#include "common/frame.glsl"
#include "common/water_vertex.glsl"

#ifdef VERTEX
void main() {
    water_vertex();
#ifdef FILL // a little behind its edges: depth is reversed
    float far = clip_zero_to_one > 0.5 ? 0.0 : -gl_Position.w;
    gl_Position.z = mix(gl_Position.z, far, 0.01);
#endif
}
#endif

#ifdef FRAGMENT
out vec4 color;

void main() {
    water_pixel p = water_here();
#ifdef FILL
    vec3 paint = vec3(0.03, 0.06, 0.10);
#else
    vec3 paint = vec3(0.55, 0.62, 0.65);
#endif
    float light = max(sky_light.r + sun_light.r * max(sun_direction.z, 0.0), 1e-3) * 0.5;
    color = vec4(paint * light * p.transmittance + p.inscatter, 1.0);
}
#endif

// SPDX-License-Identifier: MIT
// The depth of the water alone, before anything else is drawn: see pass_water_cover(). A little farther than the water
// is, so that the water passes wherever this did.
#include "common/depth.glsl"
#include "common/frame.glsl"
#include "common/water_vertex.glsl"

#ifdef VERTEX
void main() {
    water_vertex();
    gl_Position.z -= gl_Position.w * DEPTH_ROUNDING * (clip_zero_to_one > 0.5 ? 1.0 : 2.0);
}
#endif

#ifdef FRAGMENT
out vec4 color;
void main() {
    color = vec4(0.0);
#ifdef TRIM
    color.a = round_earth(water_place.xy); // ends where the quad does
#endif
}
#endif

// SPDX-License-Identifier: MIT
// A quarter-size copy of the image for the glow: the mean of 4 x 4 pixels, with a limit so that a single glint does not
// dominate.
#include "common/fullscreen.glsl"
#ifdef VERTEX
void main() { fullscreen(0.5); }
#endif
#ifdef FRAGMENT
#include "common/frame.glsl"
uniform sampler2D source;
#pragma unit source 15
out vec4 color;

const float BRIGHTEST = 40.0; // exposed

void main() {
    ivec2 corner = ivec2(gl_FragCoord.xy) * 4, last = textureSize(source, 0) - 1;
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 16; ++i) {
        vec3 c = texelFetch(source, min(corner + ivec2(i & 3, i >> 2), last), 0).rgb * exposure;
        sum += c * min(1.0, BRIGHTEST / max(max(c.r, c.g), max(c.b, 1e-6)));
    }
    color = vec4(sum / 16.0, 1.0);
}
#endif

// SPDX-License-Identifier: MIT
// The yardstick of the benchmarks: six bilinear texture fetches per pixel and nothing else.
#include "common/fullscreen.glsl"

#ifdef VERTEX
void main() { fullscreen(0.0); }
#endif

#ifdef FRAGMENT
out vec4 color;
uniform sampler2D image;

void main() {
    vec4 sum = vec4(0.0);
    for (int i = 0; i < 6; ++i) sum += texture(image, uv * (1.0 + 0.37 * float(i)) + 0.013 * float(i));
    color = sum;
}
#endif

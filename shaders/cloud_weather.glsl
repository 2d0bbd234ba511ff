// SPDX-License-Identifier: MIT
// What varies between clouds over the country, a square that repeats: r where they gather, g how high they grow.
#include "common/fullscreen.glsl"
#ifdef VERTEX
void main() { fullscreen(0.5); }
#endif
#ifdef FRAGMENT
#include "common/noise.glsl"
out vec4 color;

// Three octaves of gradient noise about 0.5, from `cells` to a side.
float octaves(vec3 p, int cells) {
    float sum = 0.0, amplitude = 1.0, total = 0.0;
    for (int i = 0; i < 3; ++i) {
        sum += amplitude * gradient_noise(p * float(cells), cells);
        total += amplitude;
        amplitude *= 0.5;
        cells *= 2;
    }
    return 0.5 + 0.75 * sum / total;
}

void main() { color = vec4(octaves(vec3(uv, 0.37), 4), octaves(vec3(uv, 0.81), 8), 0.0, 0.0); }
#endif

// SPDX-License-Identifier: MIT
// One slice of the cloud noise, a volume that repeats: r billows (gradient noise swelled by cells), g the cells'
// finer octaves, b plain gradient noise, a fine gradient noise. After Schneider 2015, "The real-time volumetric
// cloudscapes of Horizon".
#include "common/fullscreen.glsl"
#ifdef VERTEX
void main() { fullscreen(0.5); }
#endif
#ifdef FRAGMENT
#include "common/noise.glsl"
uniform float slice; // 0..1
out vec4 color;

void main() {
    vec3 p = vec3(uv, slice);
    float plain = 0.0, fine = 0.0, amplitude = 1.0, total = 0.0;
    for (int i = 0; i < 3; ++i) {
        int cells = 4 << i;
        plain += amplitude * gradient_noise(p * float(cells), cells);
        fine += amplitude * gradient_noise(p * float(cells * 2) + 17.3, cells * 2);
        total += amplitude;
        amplitude *= 0.5;
    }
    plain = clamp(0.5 + 0.75 * plain / total, 0.0, 1.0);
    fine = clamp(0.5 + 0.75 * fine / total, 0.0, 1.0);
    float c4 = cellular_noise(p * 4.0, 4), c8 = cellular_noise(p * 8.0, 8), c16 = cellular_noise(p * 16.0, 16);
    float swell = 0.625 * c4 + 0.25 * c8 + 0.125 * c16;
    float billows = clamp(0.55 * plain + 0.55 * swell - 0.05, 0.0, 1.0);
    color = vec4(billows, 0.6 * c8 + 0.4 * c16, plain, fine);
}
#endif

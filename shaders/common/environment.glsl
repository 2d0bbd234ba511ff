// SPDX-License-Identifier: MIT
// How directions lie in the environment map: the upper hemisphere as seen from the sea, projected from the nadir onto a
// disc (stereographic: angles stay, and nothing is folded, so that interpolation has no seam). The horizon is a circle;
// beyond it the sky goes on as its mirror image, so that a blur and an interpolation there meet what they should.

const float ENVIRONMENT_SIZE = 512.0;
const float ENVIRONMENT_RIM = 0.9; // radius of the horizon: a margin for the texels of the coarser levels

vec2 environment_uv(vec3 dir) { return dir.xy * (0.5 * ENVIRONMENT_RIM / (1.0 + max(dir.z, 0.0))) + 0.5; }

vec3 environment_direction(vec2 square) {
    vec2 p = (square * 2.0 - 1.0) / ENVIRONMENT_RIM;
    float r2 = dot(p, p);
    return vec3(2.0 * p, abs(1.0 - r2)) / (1.0 + r2);
}

// Side of a texel of a level [rad].
float environment_texel(vec3 dir, float level) {
    return exp2(level) * 2.0 / (ENVIRONMENT_SIZE * ENVIRONMENT_RIM) * (1.0 + dir.z);
}

// Standard deviation of the blur of a level from 1 on [rad]: 1.8 texels at the horizon, 0.9 overhead.
float environment_blur(float level) { return exp2(level) * 4.0 / ENVIRONMENT_SIZE; }
float environment_level(float blur) { return clamp(log2(max(blur * (ENVIRONMENT_SIZE / 4.0), 1.0)), 0.0, 7.0); }

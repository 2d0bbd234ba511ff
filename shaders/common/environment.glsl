// SPDX-License-Identifier: MIT
// How directions lie in the environment map: the upper hemisphere as seen from the sea, folded onto a square. The horizon is its
// rim, and the corners are its four cardinal points.

const float ENVIRONMENT_SIZE = 512.0;

vec2 environment_uv(vec3 dir) {
    vec2 p = dir.xy / max(abs(dir.x) + abs(dir.y) + max(dir.z, 0.0), 1e-6);
    return vec2(p.x + p.y, p.x - p.y) * 0.5 + 0.5;
}

vec3 environment_direction(vec2 square) {
    vec2 t = square * 2.0 - 1.0, p = vec2(t.x + t.y, t.x - t.y) * 0.5;
    return normalize(vec3(p, 1.0 - abs(p.x) - abs(p.y)));
}

// Standard deviation of the blur of a level from 1 on [rad]: 1.3 to 1.8 of its texels.
float environment_blur(float level) { return exp2(level) * 4.0 / ENVIRONMENT_SIZE; }
float environment_level(float blur) { return clamp(log2(max(blur * (ENVIRONMENT_SIZE / 4.0), 1.0)), 0.0, 7.0); }

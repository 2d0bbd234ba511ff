// SPDX-License-Identifier: MIT
// Bores: broken waves that run in over the shallows, each a steep front with foam that thins out behind it. Up a slope
// the fronts follow the depth; over flats they travel the way the sea goes. Phases of the eye's place and of the time
// come reduced from the CPU (fill_surf() in src/render/frame.c): a phase of wrapped coordinates would tear where they
// wrap. Needs common/frame.glsl and common/water_block.glsl.

float bore_length() { return inversesqrt(max(dot(surf_wave, surf_wave), 1e-12)); } // from front to front over flats [m]

// Place between two fronts: 0 at a front, growing to 1 at the one that follows. rest: eye-relative [m]; shift: in
// cycles.
float behind_front(vec2 rest, float depth, float shift) {
    return fract(depth / (0.9 * shore_height) - dot(rest, surf_wave) + surf_phase + shift);
}

// Cover by foam behind a front.
float bore(float behind) { return smoothstep(0.0, 0.06, behind) * exp(-3.0 * behind); }

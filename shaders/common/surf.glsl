// SPDX-License-Identifier: MIT
// Where the bores of shared/surf.glsl are. Up a slope the fronts follow the depth; over flats they travel the way the
// sea goes. Phases of the eye's place and of the time come reduced from the CPU (fill_surf() in src/render/step.c): a
// phase of wrapped coordinates would tear where they wrap. Needs common/frame.glsl and common/water_block.glsl.
#include "shared/surf.glsl"

float bore_length() { return inversesqrt(max(dot(surf_wave, surf_wave), 1e-12)); } // from front to front over flats [m]

// Place between two fronts: 0 at a front, growing to 1 at the one that follows. rest: eye-relative [m]; shift: in
// cycles.
float behind_front(vec2 rest, float depth, float shift) {
    return between_fronts(depth, shore_height, surf_phase - dot(rest, surf_wave) + shift);
}

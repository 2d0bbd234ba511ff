// SPDX-License-Identifier: MIT
// What the passes of a synthesis know of the sea: see src/render/sea_compute.c, which sets it.
uniform vec4 cascade_axes[4]; // cosine and sine of the angle, wave number of the lattice [rad/m], rows of modes
uniform vec4 cascade_parts[4]; // where a cascade begins among the modes, and among the transformed rows; its parts
uniform vec4 moments[4];      // times: see phase_of() in sea_rows.glsl; the first alone, or those of ticks
uniform vec4 tick_drifts[16]; // of ticks, 4 cascades each: drift of the foam along both axes of the tile, as numbers of
                              // 32 bits, each in two halves, the lower first
uniform vec4 drifted[4];      // of the last tick's foam memory until now: samples along both axes, and the part of one
uniform float choppiness;

// SPDX-License-Identifier: MIT
// The first pass of a synthesis: modes at the time, spectra of the fields, and transforms along i. Twin of
// src/waves/cascades/synth_columns.kernel.c.
//
// A transform is that of a row j, -rows < j < rows, and of a set; a value of it holds two complex numbers, each of
// which packs two real fields, A + i B:
//
//     set   xy                     zw                     read by
//     0     dx + i dy              height + i dxy         splines, but for dxy
//     1     slope x + i slope y    dxx + i dyy            linear fetches
//     TICKS div + i div            div + i div            of four ticks of the foam memory
//
// Only rows j >= 0 are stored: h(-k) is the conjugate of h(k).
#ifdef COMPUTE
#define SLOT(i, f) ((f) * SIZE + spread(i))
#include "shared/constants.glsl"
#include "compute/transform.glsl"
#include "compute/sea_block.glsl"

// A wave of a mode; see bolan_sea_mode in bolan/waves.h.
struct mode {
    vec4 amplitude;
    uvec2 step; // turns in a quarter of a second, its fraction as a number of 64 bits: low, high
    float turns, inverse_k;
};
layout(std430, binding = 0) readonly buffer Modes { mode modes[]; };
layout(std430, binding = 1) readonly buffer Divisors { vec2 divisors[]; }; // 1 / divisor along an axis: cubic, linear
layout(std430, binding = 2) writeonly buffer Rows { vec4 row_values[]; };

// Phase at a moment [turns], -1/2 .. 1/2. Time is n quarters of a second, n a number of 64 bits (x, y, z: its lowest,
// second and next 16 bits, the last signed), and w seconds. Products of whole numbers modulo 2^64 lose nothing, however
// long the sea has run: 1e-7 turns in the first 2000 years.
float phase_of(mode m, vec4 moment) {
    uint low = uint(moment.x) | uint(moment.y) << 16, high = uint(int(moment.z)), carry, unused;
    umulExtended(m.step.x, low, carry, unused);
    float whole = float(int(carry + m.step.y * low + m.step.x * high)) * 2.3283064365386963e-10;
    float turns = whole + m.turns * moment.w;
    return turns - floor(turns + 0.5);
}

vec2 wave_height(mode m, vec4 moment) {
    vec2 w = turn_of(phase_of(m, moment));
    return vec2(dot(m.amplitude.xy, w), dot(m.amplitude.zw, w));
}

// Of a mode's first wave and the others, the second of which is `others`; -1: it is alone.
vec2 height_of(mode m, int others, vec4 moment) {
    vec2 h = wave_height(m, moment);
    if (others >= 0)
        for (int p = 0; p < MODE_PARTS - 1; ++p)
            h += wave_height(modes[others + p * 2 * MODE_PART_REACH * MODE_PART_REACH], moment);
    return h;
}

#ifdef TICKS
// e^{i k drift} of a mode: the phase is modulo a turn, so that nothing is lost.
vec2 drift_of(ivec2 at, vec4 drift) {
    uvec2 axes = uvec2(drift.xz) | uvec2(drift.yw) << 16u, turns = uvec2(at) * axes;
    return turn_of(float(int(turns.x + turns.y)) * 2.3283064365386963e-10);
}

vec4 fields_of(mode m, int others, ivec2 at, int c, vec2 k, float conjugate, vec2 divisor, int set) {
    float scale = -dot(k, k) * m.inverse_k * divisor.y;
    vec2 tick[4];
    for (int i = 0; i < 4; ++i)
        tick[i] = product(height_of(m, others, moments[i]) * vec2(scale, scale * conjugate),
                          drift_of(at, tick_drifts[4 * i + c]));
    return vec4(tick[0].x - tick[1].y, tick[0].y + tick[1].x, tick[2].x - tick[3].y, tick[2].y + tick[3].x);
}
#else
vec4 fields_of(mode m, int others, ivec2 at, int c, vec2 k, float conjugate, vec2 divisor, int set) {
    vec2 h = height_of(m, others, moments[0]) * vec2(1.0, conjugate), u = h * m.inverse_k, gradient = vec2(-k.y, k.x);
    if (set == 0) return vec4(product(u, gradient) * divisor.x,
                              h * divisor.x + vec2(u.y, -u.x) * (k.x * k.y * divisor.y));
    return vec4(product(h, gradient), -product(u, k * k)) * divisor.y;
}
#endif

// Where the second wave of the mode (i, j) is, -1 of a mode with one.
int others_of(int i, int j, int c) {
    if (max(abs(i), abs(j)) >= MODE_PART_REACH) return -1;
    return int(cascade_parts[c].z) + abs(j) * 2 * MODE_PART_REACH + (j < 0 ? -i : i) + MODE_PART_REACH;
}

void main() {
    int f = int(gl_LocalInvocationID.x) / STEP, t = int(gl_LocalInvocationID.x) % STEP;
    int set = int(gl_WorkGroupID.y), c = int(gl_WorkGroupID.z), rows = int(cascade_axes[c].w), count = 2 * rows - 1;
    int row = int(gl_WorkGroupID.x) * TRANSFORMS + f, j = row - (rows - 1), from = int(cascade_parts[c].x);
    bool filled = row < count;
    vec4 axes = cascade_axes[c], e[8];
    for (int n = 0; n < 8; ++n) {
        int x = t + n * STEP, i = x < SIZE / 2 ? x : x - SIZE;
        e[n] = vec4(0.0);
        if (!filled || i == -SIZE / 2) continue; // that column is its own mirror image, and empty
        mode m = modes[from + abs(j) * SIZE + (j < 0 ? (SIZE - x) & (SIZE - 1) : x)];
        vec2 tile = vec2(i, j) * axes.z, k = vec2(tile.x * axes.x - tile.y * axes.y, tile.x * axes.y + tile.y * axes.x);
        vec2 divisor = divisors[abs(i)] * divisors[abs(j)];
        if (m.turns > 0.0) e[n] = fields_of(m, others_of(i, j, c), ivec2(i, j), c, k, j < 0 ? -1.0 : 1.0, divisor, set);
    }
    transform(e, t, f);
    int to = int(cascade_parts[c].y) + (set * count + row) * SIZE + t;
    for (int n = 0; n < 8 && filled; ++n) row_values[to + n * STEP] = e[n];
}
#endif

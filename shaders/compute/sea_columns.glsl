// SPDX-License-Identifier: MIT
// The second pass of a synthesis: transforms along j, and what readers want: images of half floats, foam memory. Twin
// of src/waves/cascades/synth_rows.kernel.c; the layouts are those of src/render/sea_gpu.h.
//
// A group has TRANSFORMS columns that stand side by side, and neighbouring threads neighbouring columns, so that rows
// are read and images written in runs. TICKS: the foam memory alone. PACKED, HOST: see sea_layout of sea_compute.h.
#ifdef COMPUTE
#define SLOT(i, f) (spread(i) * TRANSFORMS + (f))
#include "compute/transform.glsl"
#include "compute/sea_block.glsl"
#include "compute/halfs.glsl"

layout(std430, binding = 2) readonly buffer Rows { vec4 row_values[]; };
layout(std430, binding = 3) buffer Memory { float foam_memory[]; }; // at the last tick

uniform vec4 foam; // what is left at the next tick or now, as factor and loss; 0: nothing is remembered; ticks
#define MOST_FOAM 3.0

void load(out vec4 e[8], int t, int x, int c, int set) {
    int rows = int(cascade_axes[c].w), from = int(cascade_parts[c].y) + set * (2 * rows - 1) * SIZE + x;
    for (int n = 0; n < 8; ++n) {
        int y = t + n * STEP, j = y < SIZE / 2 ? y : y - SIZE;
        e[n] = abs(j) < rows ? row_values[from + (j + rows - 1) * SIZE] : vec4(0.0);
    }
}

// What is left of the foam, or the present pinch where it is more.
float foam_of(float memory, float divergence) {
    return max(max(memory * foam.x - foam.y, min(-divergence * choppiness, MOST_FOAM)), 0.0);
}

int texel_of(int x, int y, int c) { return (c * SIZE + y) * SIZE + x; }

#ifdef TICKS
void store(vec4 e[8], int t, int x, int c) {
    for (int n = 0; n < 8; ++n) {
        int at = texel_of(x, t + n * STEP, c);
        float memory = foam.z > 0.0 ? foam_memory[at] : 0.0;
        for (int i = 0; i < int(foam.w); ++i) memory = foam_of(memory, e[n][i]);
        foam_memory[at] = memory;
    }
}
#else
layout(rgba16f, binding = 0) writeonly uniform image2DArray displacement_image;
layout(rgba16f, binding = 1) writeonly uniform image2DArray slope_image;
#ifndef PACKED
layout(rgba16f, binding = 2) writeonly uniform image2DArray third_image;
#endif

void store_displacement(vec4 e[8], int t, int x, int c) {
    for (int n = 0; n < 8; ++n) imageStore(displacement_image, ivec3(x, t + n * STEP, c), halfs(e[n]));
}

// Of the last tick, where it lies now.
float memory_at(int x, int y, int c) {
    ivec2 high = (ivec2(x, y) - ivec2(drifted[c].xy)) & (SIZE - 1), low = (high - 1) & (SIZE - 1);
    vec4 m = vec4(foam_memory[texel_of(low.x, low.y, c)], foam_memory[texel_of(high.x, low.y, c)],
                  foam_memory[texel_of(low.x, high.y, c)], foam_memory[texel_of(high.x, high.y, c)]);
    vec2 part = drifted[c].zw, along = m.xy * part.y + m.zw * (1.0 - part.y);
    return along.x * part.x + along.y * (1.0 - part.x);
}

// fold: dxy of the column, where it is wanted.
void store_slopes(vec4 e[8], float fold[8], int t, int x, int c) {
    for (int n = 0; n < 8; ++n) {
        int y = t + n * STEP;
        float memory = foam.z > 0.0 ? memory_at(x, y, c) : 0.0;
        float divergence = e[n].z + e[n].w, now = foam_of(memory, divergence);
#ifdef PACKED
        imageStore(slope_image, ivec3(x, y, c), halfs(vec4(e[n].xy, divergence, now)));
#else
        imageStore(slope_image, ivec3(x, y, c), halfs(e[n]));
#ifdef HOST
        imageStore(third_image, ivec3(x, y, c), halfs(vec4(now, 0.0, 0.0, 0.0)));
#else
        imageStore(third_image, ivec3(x, y, c), halfs(vec4(fold[n], now, 0.0, 0.0)));
#endif
#endif
    }
}
#endif

void main() {
    int f = int(gl_LocalInvocationID.x) % TRANSFORMS, t = int(gl_LocalInvocationID.x) / TRANSFORMS;
    int x = int(gl_WorkGroupID.x) * TRANSFORMS + f, set = int(gl_WorkGroupID.y), c = int(gl_WorkGroupID.z);
    vec4 e[8];
    load(e, t, x, c, set);
    transform(e, t, f);
#ifdef TICKS
    store(e, t, x, c);
#else
    float fold[8] = float[8](0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
#ifdef PACKED
    if (set == 0) {
        store_displacement(e, t, x, c);
        return;
    }
#else
    store_displacement(e, t, x, c); // one group for both sets, since dxy and the foam share a texel
    for (int n = 0; n < 8; ++n) fold[n] = e[n].w;
    load(e, t, x, c, 1);
    transform(e, t, f);
#endif
    store_slopes(e, fold, t, x, c);
#endif
}
#endif

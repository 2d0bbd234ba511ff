// SPDX-License-Identifier: MIT
// Where old foam begins, by the moments of the foam memory, for the uniform blocks of the optics: twin of
// src/render/foam_statistics.c. One group.
#ifdef COMPUTE
#include "shared/foam.glsl"
layout(local_size_x = 128) in;
#ifdef PACKED
#define MEMORY w
#else
#define MEMORY y
#endif
#pragma unit memory_map 15
uniform sampler2DArray memory_map;
uniform vec4 weights; // bolan_foam_weights()
uniform vec2 law; // standard deviations from the mean to where old foam begins; variance of the Jacobian
layout(std430, binding = 0) writeonly buffer Law { float result[4]; }; // see FOAM_LAW_THRESHOLD in sea_compute.h
shared vec2 sums[128];
#define APART 61 // prime to every size

void main() {
    int thread = int(gl_LocalInvocationID.x);
    ivec3 size = textureSize(memory_map, 0);
    float mean = 0.0, variance = 0.0;
    for (int c = 0; c < size.z; ++c) {
        vec2 sum = vec2(0.0);
        int count = (size.x * size.y + APART - 1) / APART;
        for (int i = thread; i < count; i += 128) {
            int at = i * APART;
            float memory = texelFetch(memory_map, ivec3(at % size.x, at / size.x, c), 0).MEMORY;
            sum += vec2(memory, memory * memory);
        }
        barrier();
        sums[thread] = sum;
        barrier();
        for (int half_count = 64; half_count > 0; half_count /= 2) {
            if (thread < half_count) sums[thread] += sums[thread + half_count];
            barrier();
        }
        vec2 moments = sums[0] / float(count);
        mean += weights[c] * moments.x;
        variance += weights[c] * weights[c] * max(moments.y - moments.x * moments.x, 0.0);
    }
    if (thread != 0) return;
    bool none = law.x >= FOAM_NEVER || variance <= 0.0;
    result[0] = none ? FOAM_NEVER : mean + softened_offset(law.x * sqrt(variance), variance, OLD_FOAM_EDGE * variance);
    result[1] = max(variance, 1e-9);
    result[2] = max(variance * OLD_FOAM_EDGE, 1e-9);
    result[3] = variance / law.y;
}
#endif

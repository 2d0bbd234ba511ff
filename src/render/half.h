// SPDX-License-Identifier: MIT
// 16-bit floats, for textures that are filled on the CPU.
#ifndef BOLAN_RENDER_HALF_H
#define BOLAN_RENDER_HALF_H

#include <stdint.h>
#include <string.h>

// Round to nearest (halves away from zero); too small becomes 0, too large the largest finite half.
static inline uint16_t half_from_float(float x) {
    uint32_t u;
    memcpy(&u, &x, sizeof u);
    uint32_t sign = u >> 16 & 0x8000u;
    int32_t m = (int32_t)(u & 0x7fffffffu) + 0x1000; // half of the last kept bit
    int32_t h = (m >> 13) - (112 << 10);
    return (uint16_t)(sign | (uint32_t)(h < 0x400 ? 0 : h > 0x7bff ? 0x7bff : h));
}

static inline float float_from_half(uint16_t h) {
    uint32_t u = (uint32_t)(h & 0x8000u) << 16 | ((h & 0x7fffu) ? (uint32_t)((h & 0x7fff) + (112 << 10)) << 13 : 0u);
    float x;
    memcpy(&x, &u, sizeof x);
    return x;
}

#endif

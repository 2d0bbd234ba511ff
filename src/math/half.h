// SPDX-License-Identifier: MIT
// IEEE half floats by integer operations; float -> half rounds to nearest, ties to even. The vector twin is
// waves/cascades/wide_half.h.
#ifndef BOLAN_MATH_HALF_H
#define BOLAN_MATH_HALF_H

#include <stdint.h>
#include <string.h>

#define HALF_LARGEST 65504.0f // finite

static inline uint16_t half_from_float(float value) {
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    const uint32_t sign = bits >> 16 & 0x8000u;
    bits &= 0x7fffffffu;
    if (bits >= 0x47800000u) // too large, or no number
        return (uint16_t)(sign | (bits > 0x7f800000u ? 0x7e00u : 0x7c00u));
    if (bits < 0x38800000u) { // a half below 2^-14 has no hidden bit: let a float addition round at 2^-24
        float magnitude;
        memcpy(&magnitude, &bits, sizeof magnitude);
        const float shifted = magnitude + 0.5f;
        uint32_t mantissa;
        memcpy(&mantissa, &shifted, sizeof mantissa);
        return (uint16_t)(sign | (mantissa - 0x3f000000u));
    }
    const uint32_t rounded = bits + 0xfffu + (bits >> 13 & 1u); // may carry into infinity, as it should
    return (uint16_t)(sign | ((rounded - 0x38000000u) >> 13));
}

static inline float float_from_half(uint16_t half) {
    const uint32_t sign = (uint32_t)(half & 0x8000u) << 16, exponent = half >> 10 & 31u, mantissa = half & 0x3ffu;
    float value = (float)mantissa * 0x1p-24f; // without a hidden bit
    uint32_t bits;
    if (exponent == 31u)
        bits = 0x7f800000u | mantissa << 13;
    else if (exponent > 0u)
        bits = (exponent + 112u) << 23 | mantissa << 13;
    else
        memcpy(&bits, &value, sizeof bits);
    bits |= sign;
    memcpy(&value, &bits, sizeof value);
    return value;
}

#endif

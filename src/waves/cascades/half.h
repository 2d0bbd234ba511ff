// SPDX-License-Identifier: MIT
// float -> IEEE half, rounding to nearest, ties to even, by integers. wide_half.h has the lanes.
#ifndef BOLAN_WAVES_HALF_H
#define BOLAN_WAVES_HALF_H

#include <stdint.h>
#include <string.h>

static inline uint16_t half_from_float(float value) {
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    const uint32_t sign = bits >> 16 & 0x8000u;
    bits &= 0x7fffffffu;
    if (bits >= 0x47800000u)
        return (uint16_t)(sign | (bits > 0x7f800000u ? 0x7e00u : 0x7c00u)); // too large, or no
                                                                            // number
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

#endif

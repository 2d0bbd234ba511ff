// SPDX-License-Identifier: MIT
// Rounding to half floats, to nearest and even as half_from_float() of src/math/half.h does. What imageStore() does
// with more bits is left to the driver, and some cut them off. Numbers below 2^-14 are left to it.
vec4 halfs(vec4 v) {
    uvec4 bits = floatBitsToUint(v);
    return uintBitsToFloat((bits + 0xfffu + (bits >> 13 & 1u)) & ~0x1fffu);
}

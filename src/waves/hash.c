// SPDX-License-Identifier: MIT
// A digest of every field, and the uniform hash behind random phases.
#include "waves/model.h"

#include <string.h>

// FNV-1a over words, with a rotation so that high bits reach the low ones.
uint64_t bolan_sea_hash_plane(uint64_t hash, const float *plane, size_t count) {
    for (size_t i = 0; i < count; i++) {
        uint32_t bits;
        memcpy(&bits, plane + i, sizeof bits);
        hash = (hash ^ bits) * 0x100000001b3u;
        hash ^= hash >> 29;
    }
    return hash;
}

// The finaliser of SplitMix64 (Steele, Lea & Flood 2014): a bijection that leaves no visible relation of input and
// output.
uint64_t bolan_sea_mix(uint64_t x) {
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

void bolan_sea_hash(const bolan_sea *sea, char out[17]) {
    BOLAN_ASSERT(sea && out);
    bolan_sea_fields(sea);
    const uint64_t hash = sea->shared->model->hash(sea, 0xcbf29ce484222325u);
    for (int digit = 0; digit < 16; digit++) out[digit] = "0123456789abcdef"[hash >> (60 - 4 * digit) & 15u];
    out[16] = 0;
}

// SPDX-License-Identifier: MIT
// A digest of every field: the bits of each float, in the order cascade, field, sample.
#include "waves/sea.h"

#include <string.h>

// FNV-1a over words, with a rotation so that high bits reach the low ones.
static uint64_t add_plane(uint64_t hash, const float *plane, size_t count) {
    for (size_t i = 0; i < count; i++) {
        uint32_t bits;
        memcpy(&bits, plane + i, sizeof bits);
        hash = (hash ^ bits) * 0x100000001b3u;
        hash ^= hash >> 29;
    }
    return hash;
}

void bolan_sea_hash(const bolan_sea *sea, char out[17]) {
    uint64_t hash = 0xcbf29ce484222325u;
    for (uint32_t i = 0; i < sea->count; i++) {
        const sea_cascade *c = &sea->cascade[i];
        for (int f = 0; f < SEA_FIELDS; f++) hash = add_plane(hash, c->field[f], (size_t)c->n * c->n);
    }
    for (int digit = 0; digit < 16; digit++) out[digit] = "0123456789abcdef"[hash >> (60 - 4 * digit) & 15u];
    out[16] = 0;
}

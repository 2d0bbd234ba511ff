// SPDX-License-Identifier: MIT
// A digest of every field: the bits of each float, in the order cascade, field, sample; of a sum, at fixed places.
#include "waves/sum.h"

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

enum { SUM_HASH_POINTS = 4096 };

// A sum has no planes: its fields at some of the places where it is measured.
static uint64_t add_sum(uint64_t hash, const bolan_sea *sea) {
    sum_fields_function *const fields = bolan_sum_fields_for(sea->desc.cpu);
    for (uint32_t first = 0; first < SUM_HASH_POINTS; first += SUM_LANES) {
        double x[SUM_LANES], y[SUM_LANES];
        float field[SEA_FIELDS][SUM_LANES];
        for (uint32_t l = 0; l < SUM_LANES; l++) {
            const bolan_dvec2 place = bolan_sea_place(sea, first + l);
            x[l] = place.x;
            y[l] = place.y;
        }
        fields(&sea->sum->tables, x, y, NULL, field);
        for (int f = 0; f < SEA_FIELDS; f++) hash = add_plane(hash, field[f], SUM_LANES);
    }
    return hash;
}

void bolan_sea_hash(const bolan_sea *sea, char out[17]) {
    BOLAN_ASSERT(sea && out);
    uint64_t hash = 0xcbf29ce484222325u;
    if (sea->sum) hash = add_sum(hash, sea);
    for (uint32_t i = 0; i < sea->count; i++) {
        const sea_cascade *c = &sea->cascade[i];
        for (int f = 0; f < SEA_FIELDS; f++) hash = add_plane(hash, c->field[f], (size_t)c->n * c->n);
    }
    for (int digit = 0; digit < 16; digit++) out[digit] = "0123456789abcdef"[hash >> (60 - 4 * digit) & 15u];
    out[16] = 0;
}

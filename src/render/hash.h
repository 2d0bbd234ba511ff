// SPDX-License-Identifier: MIT
// Random numbers of a lattice: the same for a cell at every run.
#ifndef BOLAN_RENDER_HASH_H
#define BOLAN_RENDER_HASH_H

#include <stdint.h>

static inline uint32_t cell_hash(uint32_t x, uint32_t y, uint32_t salt) {
    uint32_t h = x * 0x9E3779B1u ^ y * 0x85EBCA77u ^ salt * 0xC2B2AE3Du;
    h = (h ^ (h >> 15)) * 0x2C1B3C6Du;
    h = (h ^ (h >> 12)) * 0x297A2D39u;
    return h ^ (h >> 15);
}

// 0..1
static inline float hash_unit(uint32_t h) { return (float)(h >> 8) * (1.0f / 16777216.0f); }

#endif

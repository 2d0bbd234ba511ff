// SPDX-License-Identifier: MIT
// See water_block.h.
#include "water_block.h"

enum { RING_BYTES = 1 << 17 };

bolan_result bolan_water_blocks_create(water_block_buffers *b) {
    *b = (water_block_buffers){.water = {0}};
    return bolan_gl_ring_create(RING_BYTES, &b->ring);
}

void bolan_water_blocks_upload(water_block_buffers *b, const water_block *block) {
    b->water = bolan_gl_ring_put(&b->ring, block, sizeof *block);
    bolan_gl_range_bind_uniform(&b->water, BLOCK_WATER);
}

void bolan_water_blocks_upload_optics(water_block_buffers *b, const void *block, size_t bytes) {
    BOLAN_ASSERT(bytes <= OPTICS_BLOCK_BYTES);
    b->optics = bolan_gl_ring_put(&b->ring, block, bytes);
    bolan_gl_range_bind_uniform(&b->optics, BLOCK_OPTICS);
}

void bolan_water_blocks_patch_optics(water_block_buffers *b, size_t offset, const gl_buffer *from, size_t first,
                                     size_t count) {
    bolan_gl_range_patch(&b->optics, offset, from, first * sizeof(float), count * sizeof(float));
}

void bolan_water_blocks_free(water_block_buffers *b) { bolan_gl_ring_free(&b->ring); }

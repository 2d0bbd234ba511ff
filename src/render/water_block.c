// SPDX-License-Identifier: MIT
// See water_block.h.
#include "water_block.h"

bolan_result bolan_water_blocks_create(water_block_buffers *b) {
    bolan_result result =
        bolan_gl_buffer_create(GL_BUFFER_UNIFORM, GL_USAGE_STREAM, sizeof(water_block), NULL, &b->water);
    if (result == BOLAN_OK)
        result = bolan_gl_buffer_create(GL_BUFFER_UNIFORM, GL_USAGE_STREAM, OPTICS_BLOCK_BYTES, NULL, &b->optics);
    return result;
}

void bolan_water_blocks_upload(water_block_buffers *b, const water_block *block) {
    bolan_gl_buffer_update(&b->water, 0, sizeof *block, block);
    bolan_gl_buffer_bind_uniform(&b->water, BLOCK_WATER);
}

void bolan_water_blocks_upload_optics(water_block_buffers *b, const void *block, size_t bytes) {
    BOLAN_ASSERT(bytes <= OPTICS_BLOCK_BYTES);
    bolan_gl_buffer_update(&b->optics, 0, bytes, block);
    bolan_gl_buffer_bind_uniform(&b->optics, BLOCK_OPTICS);
}

void bolan_water_blocks_patch_optics(water_block_buffers *b, size_t offset, const gl_buffer *from, size_t first,
                                     size_t count) {
    bolan_gl_buffer_copy(from, first * sizeof(float), &b->optics, offset, count * sizeof(float));
}

void bolan_water_blocks_free(water_block_buffers *b) {
    bolan_gl_buffer_free(&b->water);
    bolan_gl_buffer_free(&b->optics);
}

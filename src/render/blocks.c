// SPDX-License-Identifier: MIT
// See blocks.h.
#include "blocks.h"

enum { RING_BYTES = 1 << 16 };

bolan_result bolan_blocks_create(block_buffers *b) {
    *b = (block_buffers){.frame = {0}};
    return bolan_gl_ring_create(RING_BYTES, &b->ring);
}

void bolan_blocks_bind(const block_buffers *b) {
    bolan_gl_range_bind_uniform(&b->frame, BLOCK_FRAME);
    bolan_gl_range_bind_uniform(&b->view, BLOCK_VIEW);
}

void bolan_blocks_upload_frame(block_buffers *b, const frame_block *values) {
    b->frame = bolan_gl_ring_put(&b->ring, values, sizeof *values);
    bolan_gl_range_bind_uniform(&b->frame, BLOCK_FRAME);
}

void bolan_blocks_upload_view(block_buffers *b, const view_block *values) {
    b->view = bolan_gl_ring_put(&b->ring, values, sizeof *values);
    bolan_gl_range_bind_uniform(&b->view, BLOCK_VIEW);
}

void bolan_blocks_upload(block_buffers *b, const block_values *values) {
    bolan_blocks_upload_frame(b, &values->frame);
    bolan_blocks_upload_view(b, &values->view);
}

void bolan_blocks_free(block_buffers *b) { bolan_gl_ring_free(&b->ring); }

void bolan_view_block_resize(view_block *b, uint32_t width, uint32_t height) {
    b->viewport_size = (bolan_vec2){(float)width, (float)height};
    b->pixel_size = (bolan_vec2){1.0f / (float)width, 1.0f / (float)height};
}

// SPDX-License-Identifier: MIT
// See blocks.h.
#include "blocks.h"

bolan_result bolan_blocks_create(block_buffers *b) {
    bolan_result result =
        bolan_gl_buffer_create(GL_BUFFER_UNIFORM, GL_USAGE_STREAM, sizeof(frame_block), NULL, &b->frame);
    if (result == BOLAN_OK)
        result = bolan_gl_buffer_create(GL_BUFFER_UNIFORM, GL_USAGE_STREAM, sizeof(view_block), NULL, &b->view);
    return result;
}

void bolan_blocks_bind(const block_buffers *b) {
    bolan_gl_buffer_bind_uniform(&b->frame, BLOCK_FRAME);
    bolan_gl_buffer_bind_uniform(&b->view, BLOCK_VIEW);
}

void bolan_blocks_upload_frame(block_buffers *b, const frame_block *values) {
    bolan_gl_buffer_update(&b->frame, 0, sizeof *values, values);
    bolan_gl_buffer_bind_uniform(&b->frame, BLOCK_FRAME);
}

void bolan_blocks_upload_view(block_buffers *b, const view_block *values) {
    bolan_gl_buffer_update(&b->view, 0, sizeof *values, values);
    bolan_gl_buffer_bind_uniform(&b->view, BLOCK_VIEW);
}

void bolan_blocks_upload(block_buffers *b, const block_values *values) {
    bolan_blocks_upload_frame(b, &values->frame);
    bolan_blocks_upload_view(b, &values->view);
}

void bolan_blocks_free(block_buffers *b) {
    bolan_gl_buffer_free(&b->frame);
    bolan_gl_buffer_free(&b->view);
}

void bolan_view_block_resize(view_block *b, uint32_t width, uint32_t height) {
    b->viewport_size = (bolan_vec2){(float)width, (float)height};
    b->pixel_size = (bolan_vec2){1.0f / (float)width, 1.0f / (float)height};
}

// SPDX-License-Identifier: MIT
// The uniform blocks Frame and View of shaders/common/frame.glsl. The members stand once, in shaders/shared/, for both
// languages; tests/shaders/test_blocks.c compares the offsets.
#ifndef BOLAN_BLOCKS_H
#define BOLAN_BLOCKS_H

#include "bolan/math.h"
#include "gl/gl.h"

enum { BLOCK_FRAME = 0, BLOCK_VIEW = 1 }; // their uniform slots, GL_UNIFORM_SLOTS

typedef bolan_vec2 vec2;
typedef bolan_vec3 vec3;
typedef bolan_mat4 mat4;

typedef struct frame_block {
#include "shared/frame_block.glsl"
} frame_block;

typedef struct view_block {
#include "shared/view_block.glsl"
} view_block;

typedef struct block_values {
    frame_block frame;
    view_block view;
} block_values;

// The two blocks on the GPU.
typedef struct block_buffers {
    gl_ring ring;
    gl_range frame, view; // the last of each
} block_buffers;

bolan_result bolan_blocks_create(block_buffers *b);
void bolan_blocks_upload(block_buffers *b, const block_values *values); // and binds both
void bolan_blocks_upload_frame(block_buffers *b, const frame_block *values);
void bolan_blocks_upload_view(block_buffers *b, const view_block *values);
void bolan_blocks_bind(const block_buffers *b);
void bolan_blocks_free(block_buffers *b);

// Sets viewport_size and pixel_size.
void bolan_view_block_resize(view_block *b, uint32_t width, uint32_t height);

#endif

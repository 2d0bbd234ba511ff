// SPDX-License-Identifier: MIT
// The uniform blocks of the water: Water, which all its shaders share (shaders/shared/water_block.glsl), and Optics,
// whose members are those of the optics that draws. Neither changes between the draw calls of one optics.
#ifndef BOLAN_WATER_BLOCK_H
#define BOLAN_WATER_BLOCK_H

#include "blocks.h"

enum { BLOCK_WATER = 2, BLOCK_OPTICS = 3, OPTICS_BLOCK_BYTES = 256 };

typedef bolan_vec4 vec4;

typedef struct water_block {
#include "shared/water_block.glsl"
} water_block;

// The two blocks on the GPU.
typedef struct water_block_buffers {
    gl_ring ring;
    gl_range water, optics; // the last of each
} water_block_buffers;

bolan_result bolan_water_blocks_create(water_block_buffers *b);
// Uploads the block and binds it. @p bytes of an optics' block: at most OPTICS_BLOCK_BYTES.
void bolan_water_blocks_upload(water_block_buffers *b, const water_block *block);
void bolan_water_blocks_upload_optics(water_block_buffers *b, const void *block, size_t bytes);
// Copies floats of a buffer that the GPU wrote into the uploaded block of an optics.
void bolan_water_blocks_patch_optics(water_block_buffers *b, size_t offset, const gl_buffer *from, size_t first,
                                     size_t count);
void bolan_water_blocks_free(water_block_buffers *b);

#endif

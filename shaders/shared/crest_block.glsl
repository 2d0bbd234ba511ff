// SPDX-License-Identifier: MIT
// Members of the uniform block Optics of the crest optics, written by src/render/papers/crest.c.
float breaking_pinch;         // sum dxx + dyy (choppiness applied) where a crest breaks
float old_foam_memory;        // foam memory where old foam begins
float fresh_edge;             // variance that softens the edge of breaking crests
float old_edge;               // variance that softens the edge of old foam
float slopes_beyond_cascades; // slope variance of the waves that no cascade has
float memory_share;           // variance of the foam memory over that of the slopes
float to_the_letter;          // 1: light and foam as the paper has them
float crest_padding;          // the block's size is a multiple of 16 bytes

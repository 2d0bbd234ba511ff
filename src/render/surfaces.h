// SPDX-License-Identifier: MIT
// What stands at each pixel of a view, read back: land and objects are drawn once more, with their normals and labels
// for colours, into a target of their own; the water is what the picture has nearer than those, and its normal, foam
// and motion are the answers of the query at the place of the pixel. Shader: surfaces.glsl. Made at the first reading.
#ifndef BOLAN_RENDER_SURFACES_H
#define BOLAN_RENDER_SURFACES_H

#include "gl/gl.h"
#include "view.h"

typedef struct surface_reader {
    gl_program land, object;
    gl_texture color, depth;
    gl_target target;
} surface_reader;

// Programs, and a target of this size.
bolan_result bolan_surface_reader_fit(surface_reader *s, uint32_t width, uint32_t height);
void bolan_surface_reader_free(surface_reader *s);

// What was read of a view, bottom row first.
typedef struct surface_pixels {
    const float *depth;             // of the picture: 4 floats a pixel, of which the first
    const float *land_depth, *land; // of land and objects; normal and label
} surface_pixels;
// Fills what @p out asks for, top row first. False: no memory (logged).
bool bolan_surfaces_fill(const render_view *v, const surface_pixels *pixels, const bolan_surfaces *out);

#endif

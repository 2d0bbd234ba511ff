// SPDX-License-Identifier: MIT
// Half-rate shading of the water: one sample for several pixels of a row, upsampled to the resolution of the view.
//
// At grazing angles the footprint of a pixel is far longer along the view than wide, and texture fetches average over
// round footprints: with one fetch in a footprint v times as long as wide, v neighbouring pixels read the same texels.
// Below the high qualities one sample therefore serves `columns` pixels of a row. The shape of the water, its edges and
// its depth keep the full rate. An optics that keeps its shape (water_optics.shape) is shaded from the shape; for
// other optics the mesh is drawn twice, the second time with hardly any work for a pixel.
#ifndef BOLAN_RENDER_WATER_SPARSE_H
#define BOLAN_RENDER_WATER_SPARSE_H

#include "kept_sizes.h"
#include "water_optics.h"

// What has the size of a view: 12 bytes for each sample.
typedef struct half_rate_targets {
    gl_texture color, depth; // alpha: there is water
    gl_target target;
} half_rate_targets;

typedef struct half_rate {
    kept_sizes kept;
    half_rate_targets sizes[KEPT_SIZES];
    half_rate_targets now; // those of the present size
    gl_program farthest; // fills the depth
} half_rate;

// Notes and compiles the programs of this stage. False: they cannot be had (logged).
bool bolan_half_rate_prepare(half_rate *s, const water_setup *setup, bool keeps_shape, water_programs *all);
// How many columns of this view one sample serves, at most `most`; 1: each pixel has its own.
uint32_t bolan_half_rate_columns(const render_view *f, uint32_t most);
// The frame to light the water in: cleared, and with the depth of what stands before the water where
// something is `opaque`. Where it cannot be had (logged), it is `f` itself, and its shade_columns is 1.
render_view bolan_half_rate_begin(half_rate *s, const render_view *f, uint32_t columns, bool keeps_shape, bool opaque);
// Into the frame's picture, by the mesh; d->view is the frame that bolan_half_rate_begin() had.
void bolan_half_rate_lay_mesh(const half_rate *s, const water_draw *d);
// Likewise these rows from the bottom, over the shape that the optics keeps, which must be bound.
void bolan_half_rate_lay_shape(const half_rate *s, const water_draw *d, bool opaque, uint32_t rows);
bolan_result bolan_half_rate_reload(half_rate *s);
void bolan_half_rate_free(half_rate *s);

#endif

// SPDX-License-Identifier: MIT
// The picture for an eye in the water, of an optics whose mesh is seen from either side: see shaders/below.glsl.
#ifndef BOLAN_RENDER_BELOW_H
#define BOLAN_RENDER_BELOW_H

#include "kept_sizes.h"
#include "water_optics.h"

// The image of what stands above the water, 12 bytes a pixel of it.
typedef struct window_targets {
    gl_texture color, depth;
    gl_target target;
} window_targets;

typedef struct below_water {
    kept_sizes kept;
    window_targets sizes[KEPT_SIZES];
    const gl_texture *window; // of this view; NULL: nothing stands above the water, or it is not to be seen
} below_water;

// Which side of the surface an eye is on. At the waterline its near plane, which then lies WATERLINE_NEAR away, may cut
// the surface.
#define WATERLINE_NEAR 0.12 // [m]: as far as the glass of a diver's mask is
view_medium bolan_below_medium(const frame *f, bolan_dvec3 eye);
// Factor on the exposure of an eye in the water.
float bolan_below_exposure(const frame *f, bolan_dvec3 eye);
// Draws the image of what stands above the water, as a level surface refracts it.
void bolan_below_behind(below_water *b, const water_draw *d, const world_drawer *world);
// Notes the programs that bolan_below_draw() needs.
void bolan_below_list(const water_setup *s, water_programs *all);
// Over a frame that shows what an eye above the water sees; the surface's shape is bound.
void bolan_below_draw(below_water *b, const water_draw *d);
void bolan_below_free(below_water *b);

#endif

// SPDX-License-Identifier: MIT
// Planar views, which the optics of two papers fetch: the world on the eye's side of the water mirrored in its plane,
// and the world on the other side raised as refraction raises it.
#ifndef BOLAN_RENDER_PLANAR_VIEWS_H
#define BOLAN_RENDER_PLANAR_VIEWS_H

#include "render/kept_sizes.h"
#include "render/water_optics.h"

// What has the size of a view: 27 bytes for each of their pixels.
typedef struct planar_targets {
    gl_texture reflection, refraction, reflection_depth, refraction_depth;
    gl_target reflection_target, refraction_target;
} planar_targets;

typedef struct planar_views {
    kept_sizes kept;
    planar_targets sizes[KEPT_SIZES];
} planar_views;

// Draws both for this view and binds them: UNIT_REFLECTION, UNIT_REFRACTION and their depths. `sky`: the reflection
// shows the sky too. Nothing is drawn where there is no memory for them (logged).
void bolan_planar_views_draw(planar_views *p, const water_draw *d, bool sky, const world_drawer *world);
// Share of the view's width and height that they have.
double bolan_planar_views_share(const render_view *v);
void bolan_planar_views_free(planar_views *p);

#endif

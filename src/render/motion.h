// SPDX-License-Identifier: MIT
// Motion vectors of a view: where each pixel's surface stood in the frame before. One pass over the depth of the image
// for land, sky and water, one over the objects. Shaders: motion.glsl, surfaces.glsl, common/motion.glsl.
#ifndef BOLAN_RENDER_MOTION_H
#define BOLAN_RENDER_MOTION_H

#include "view.h"

typedef struct motion_pass {
    gl_program camera, object; // made by the first view that asks
} motion_pass;

// Where the vectors go, and the frame before.
typedef struct motion_request {
    uint32_t framebuffer, x, y; // the target, and the lower left corner of the image in it [px]
    const bolan_view *before;   // NULL: the camera has not moved
    double time;                // of the sea then [s]
    const bolan_host *host;     // whose water alone is drawn; NULL: the whole world
} motion_request;

struct bolan_renderer;
// After the frame that `v` draws of `to`, whose block View is in use. What cannot be compiled is logged and not drawn.
void bolan_motion_draw(struct bolan_renderer *r, render_view *v, const bolan_view *to, const motion_request *request);
// What `to` itself asks for.
void bolan_motion_draw_asked(struct bolan_renderer *r, render_view *v, const bolan_view *to, const bolan_host *host);
bolan_result bolan_motion_reload(motion_pass *m);
void bolan_motion_free(motion_pass *m);

#endif

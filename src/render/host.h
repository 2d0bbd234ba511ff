// SPDX-License-Identifier: MIT
// A host's frame: its opaque scene comes in as colour and depth, the water goes out with its depth tested.
#ifndef BOLAN_RENDER_HOST_H
#define BOLAN_RENDER_HOST_H

#include "view.h"

typedef struct host_frame {
    gl_program import[2];              // of 2D and of multisampled textures; ES has the first alone
    gl_program resolve[2], tonemap[2]; // without and with a mask
    gl_sampler sampler; // nearest texels, no comparison, whatever the host's texture says
} host_frame;

// Window depth of a projection at distance t along the view axis is offset + scale / t.
typedef struct host_depth {
    double offset, scale;
} host_depth;
host_depth bolan_host_depth_of(const bolan_view *view);

bolan_result bolan_host_create(const gl_caps *caps, host_frame *h);
bolan_result bolan_host_reload(host_frame *h);
// Fills the view's target with the host's scene.
void bolan_host_import(host_frame *h, const render_view *v, const bolan_view *to, const bolan_host *host);
// Draws the water of the view's target into the host's framebuffer. The scene's depth must be on UNIT_SCENE_DEPTH.
void bolan_host_resolve(host_frame *h, const render_view *v, const bolan_view *to, const bolan_host *host,
                        const gl_texture *color);
void bolan_host_free(host_frame *h);

#endif

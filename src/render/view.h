// SPDX-License-Identifier: MIT
// One picture of a step: where the eye is, what its frustum covers, and which target it fills. Reflections, refractions
// and half-rate shading are views too: copies of a view with another target, another side of the clip plane or another
// number of pixels, whose block is filled anew.
#ifndef BOLAN_RENDER_VIEW_H
#define BOLAN_RENDER_VIEW_H

#include "blocks.h"
#include "bolan/render.h"

typedef struct frame frame;

// The frustum of the whole picture as angles, whatever part of it a view draws. The picture's middle lies `shift` half
// widths right of the axis and half heights above it.
typedef struct view_lens {
    double heading_deg, pitch_deg, roll_deg;
    double fov_y;  // of a frustum of this size about the axis [rad]
    double aspect; // width / height
    double shift_x, shift_y;
    uint32_t pixel_height;
} view_lens;

// What the sky pass finds for this eye.
typedef struct view_light {
    bolan_vec3 sun, sky, exposure;
    bool above_clouds;
    bolan_vec2 cloud_offset;
} view_light;

// Where the eye is, for an optics whose mesh is seen from either side.
typedef enum view_medium { EYE_IN_AIR, EYE_AT_WATERLINE, EYE_IN_WATER } view_medium;

// The part of the world that a view shows, and how it raises what it refracts: see shaders/shared/view_block.glsl.
typedef struct view_clip {
    float side, elevation, raise, mode;
} view_clip;

typedef struct render_view {
    frame *frame;
    bolan_dvec3 eye; // world, z above the datum
    view_lens lens;
    bolan_mat4 view, projection;        // world -> eye, without translation; eye -> clip, reversed Z, infinite far
    double near_distance;               // [m]
    bool zero_to_one;                   // clip depth is [0,1]
    uint32_t width, height;             // [px]
    bolan_vec2 tile_corner, tile_share; // as of the block View
    bool progressive;
    bool without_water; // all but the water is drawn
    bool bake;          // the optics may bake anew what another sun has lit
    // Inputs of the block.
    bolan_mat4 mirror;   // applied to the eye-relative world before the camera
    bool under;          // the eye is below the mean water, and the optics draws such views of two triangles
    view_medium medium;  // see below.h
    bool mirrored_under; // the mirrored picture of such an eye
    bool fog;            // under water
    float shade_columns;
    float pixel_scale; // size of its pixels over radians_per_pixel
    view_clip clip;
    view_light light;
    bolan_vec2 caustic_place, caustic_spread, caustic_near_place;
    float caustic_near_blur;
    view_block block;
    block_buffers *uniforms; // where the block is uploaded
    // Targets.
    gl_target hdr; // RGBA16F colour + depth
    const gl_texture *hdr_depth;
    uint64_t depth_serial;         // of the making of that depth; 0: not the frame's
    bolan_vec4 background;         // of a picture, where nothing is drawn
    bool picture;                  // drawn for the water to read, or from under it: see clip and under
    const struct shore_map *shore; // set by bolan_pass_ground_prepare's caller
    const float *casters;          // of shadows: see common/object_shadow.glsl
    uint32_t caster_count;
    uint32_t triangles, water_triangles; // counted by the passes
} render_view;

// What is wrong with a caller's view, as the end of a sentence; NULL: nothing.
const char *bolan_view_problem(const bolan_view *from);
// The view of a caller: lens, matrices, near plane and size. `zero_to_one`: clip depth is [0,1].
void bolan_view_open(render_view *v, frame *f, const bolan_view *from, bool zero_to_one);
#define LEVEL_ROLL 1e-3 // [deg] a camera that rolls less stands upright
// Moves the near plane [m].
void bolan_view_set_near(render_view *v, double distance);
// The row of the picture, from the bottom, where the vertical plane through the view's axis shows what stands at the
// angle with tangent t above the axis.
double bolan_view_row(const render_view *v, double t);
// Moves the picture by parts of a pixel.
void bolan_view_shift(render_view *v, bolan_vec2 pixels);
// Whether a box, eye-relative, lies wholly beyond a side of the image or behind the eye.
bool bolan_outside_frustum(const bolan_mat4 *view_projection, const float low[3], const float high[3]);
// The one function that writes the block View.
void bolan_view_fill(render_view *v);
// Fills the block and uploads it: what is drawn from here on is drawn from this view.
void bolan_view_use(render_view *v);

#endif

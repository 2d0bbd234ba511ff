// SPDX-License-Identifier: MIT
// The renderer's insides, shared by renderer.c (life and read-back), targets.c (textures), frame.c (one picture),
// prepare.c (the step), read_view.c (surfaces and sky) and yardstick.c.
#ifndef BOLAN_RENDERER_H
#define BOLAN_RENDERER_H

#include "bounds.h"
#include "fields.h"
#include "frame.h"
#include "host.h"
#include "kept_sizes.h"
#include "motion.h"
#include "sea_compute.h"
#include "surfaces.h"
#include "temporal.h"

// The timed parts of a frame, in order.
typedef enum frame_part {
    PART_SKY_TABLES,
    PART_SEA,  // the stages of sea_compute.h are parts of it
    PART_VIEW, // what an eye needs of ground, objects and water
    PART_TERRAIN,
    PART_MODELS,
    PART_COPY,
    PART_MIRROR,
    PART_WATER,
    PART_SKY,
    PART_MOTION, // motion vectors
    PART_TONEMAP,
    PART_COUNT
} frame_part;
extern const char *const bolan_frame_part_names[PART_COUNT];

// Calls of a frame, which cannot fail: what they refuse they say once.
typedef enum renderer_call {
    CALL_DRAW,
    CALL_PREPARE,
    CALL_READ_LINEAR,
    CALL_READ_RGB8,
    CALL_READ_SURFACES,
    CALL_YARDSTICK,
    CALL_MEMORY_RATE,
    CALL_BIND_FIELDS,
    CALL_COUNT
} renderer_call;

enum { DIRECTORY_BYTES = 1024, REFUSAL_BYTES = 256 };
enum { MOST_PIXELS = 16384, MOST_SAMPLES = 256 }; // of a picture each way; of a pixel
static inline bool bolan_is_picture_size(uint32_t pixels) { return pixels >= 1 && pixels <= MOST_PIXELS; }

struct bolan_view_cache {
    bolan_renderer *renderer;
    pass_sky *sky;
    pass_ground *ground;
    temporal temporal;
    bolan_view_cache *next; // of the renderer's caches
};
// Shares the programs of `from`, which must live longer; NULL: makes its own.
// compute: BOLAN_PIXELS_COMPUTE.
bolan_result bolan_view_cache_open(const gl_caps *caps, bool compute, const bolan_view_cache *from,
                                   bolan_view_cache *cache);
// Takes the programs of `from` again, which has reloaded them.
void bolan_view_cache_share(bolan_view_cache *cache, const bolan_view_cache *from);
void bolan_view_cache_close(bolan_view_cache *cache);

// What has the size of a view: 24 bytes a pixel.
typedef struct frame_targets {
    gl_texture hdr_color, hdr_depth, behind_color, behind_depth;
    gl_target hdr, behind;
    uint64_t serial; // of their making: GL gives names of deleted textures to new ones
} frame_targets;

struct bolan_renderer {
    bolan_renderer_desc desc;
    gl_caps caps;
    gl_saved saved;                          // the caller's state, while a call runs
    bolan_gl_state declared;                 // see bolan_restore
    gl_known known;                          // names of the caller's that were checked
    char shader_directory[DIRECTORY_BYTES];  // "": the built-in shaders
    char refusal[CALL_COUNT][REFUSAL_BYTES]; // the last sentence of each call, "" after one that was done
    frame frame;                             // the step
    bool prepared;                           // it can be drawn
    bolan_view_cache own_cache;              // of views that bring none; all caches share its programs
    bolan_view_cache *caches;                // made by the host
    pass_objects *models;
    pass_water *water;
    pass_tonemap *tonemap;
    host_frame host;     // pictures into a host's frame
    host_fields fields;  // for programs of the host's
    sea_compute compute; // of BOLAN_BACKEND_COMPUTE
    gl_ring bounds;      // the polygon of a host's water
    block_buffers uniforms;
    gl_program yardstick;
    gl_mesh empty; // for passes without vertices
    kept_sizes kept;
    frame_targets sizes[KEPT_SIZES];
    frame_targets targets;  // those of the present size
    uint64_t target_serial; // of the last that were made
    uint32_t width, height;
    // reading back
    gl_depth_reader depth_reader;
    surface_reader surfaces;
    motion_pass motion_pass;
    bool motion; // a view has asked for motion vectors
    void *scratch;
    size_t scratch_bytes;
    // timing
    gl_timer timers[PART_COUNT];
    uint32_t part_calls[PART_COUNT]; // of OpenGL, in the last run of each
    uint32_t part_begun;             // the thread's calls when the present part began
    bool measure;
    bool bake;                 // asked for, by the next frame
    bool stale;                // the last frame showed what was baked for another sun
    double near_plane;         // of the last picture [m]
    float radiance_unit;       // of the last picture: stored / unit is radiance
    uint32_t programs_before;  // compiled by this thread when the present call began
    gl_uploads uploads_before; // by this thread, then
    gl_calls calls_before;
    bolan_frame_statistics statistics;
};

// Makes the targets fit; logs and returns GL when they cannot be had.
bolan_result bolan_renderer_resize(bolan_renderer *r, uint32_t width, uint32_t height);
void bolan_renderer_free_targets(bolan_renderer *r);

// Saves the caller's state, or gives it back. Between the two the shaders come from this renderer's directory.
void bolan_renderer_enter(bolan_renderer *r);
void bolan_renderer_leave(bolan_renderer *r);

// Refuses the call where no context is current on this thread.
bool bolan_renderer_has_context(bolan_renderer *r, renderer_call call, const char *name);

// Logs why the call is refused, unless the same call was refused for the same reason the last time. Returns false.
#if defined(__GNUC__)
__attribute__((format(printf, 4, 5)))
#endif
bool bolan_renderer_refuse(bolan_renderer *r, renderer_call call, bolan_log_id id, const char *format, ...);
// The next refusal of this call is a new one.
void bolan_renderer_accept(bolan_renderer *r, renderer_call call);

// Parts of frame.c for its neighbours.
gl_timing bolan_frame_timing(const bolan_renderer *r);
void bolan_frame_begin_part(bolan_renderer *r, frame_part part);
void bolan_frame_end_part(bolan_renderer *r, frame_part part);
// Makes the targets fit and fills the view. False: they cannot be had (logged).
bool bolan_frame_open_view(bolan_renderer *r, render_view *v, const bolan_view *from);
void bolan_frame_use(bolan_renderer *r); // uploads the block Frame
// Everything that does not depend on the sub-pixel shift.
void bolan_frame_prepare_view(bolan_renderer *r, render_view *v, bolan_view_cache *cache);

// prepare.c: uploads the step of the water. `world`: objects and tiles are drawn too; NULL: the water alone.
void bolan_frame_prepare(bolan_renderer *r, const bolan_water *water, const bolan_lighting *lighting,
                         const bolan_world *world);

// Whether this step can be prepared, and this view drawn; if not, the log says why. The last asks about the
// framebuffer, and binds it: between bolan_renderer_enter() and bolan_renderer_leave() only.
bool bolan_step_is_valid(bolan_renderer *r, const bolan_water *water, const bolan_lighting *lighting);
bool bolan_view_is_valid(bolan_renderer *r, const bolan_view *view);
bool bolan_view_has_framebuffer(bolan_renderer *r, const bolan_view *v);
// Whether the host's textures, stencil and polygon can be used; if not, the log says why.
bool bolan_host_is_valid(bolan_renderer *r, const bolan_host *host, uint32_t framebuffer);

#endif

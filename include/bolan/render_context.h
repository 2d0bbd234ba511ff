// SPDX-License-Identifier: MIT
/// @file render_context.h
/// Tier 4, library bolan_render. OpenGL without a window: a context, and a framebuffer to draw into.
/// A program that has its own context needs neither.
#ifndef BOLAN_RENDER_CONTEXT_H
#define BOLAN_RENDER_CONTEXT_H

#include "bolan/base.h"

#ifdef __cplusplus
extern "C" {
#endif

// ---- a context without a window -------------------------------------------------------------------------------------

/// Kind of OpenGL.
typedef enum bolan_gl_api {
    /// Desktop OpenGL, core profile.
    BOLAN_GL_CORE,
    /// OpenGL ES.
    BOLAN_GL_ES,
} bolan_gl_api;

/// An OpenGL context of Bolan's, without a window (EGL, surfaceless).
/// Belongs to one thread at a time.
typedef struct bolan_context bolan_context;

/// Makes a context and makes it current on this thread.
/// @param out receives the context; NULL after an error.
/// Errors: GL (the machine has none), MEMORY.
BOLAN_API bolan_result bolan_context_create(bolan_gl_api api, bolan_context **out);

/// Makes the context current on this thread.
BOLAN_API void bolan_context_make_current(bolan_context *context);

/// Releases the context.
/// Destroy everything that was made in it before.
/// NULL-safe; NULLs the pointer.
BOLAN_API void bolan_context_destroy(bolan_context **context);

// ---- what a context is ----------------------------------------------------------------------------------------------

/// Properties of a context.
typedef struct bolan_gl_info {
    /// What the driver says of itself: static strings, "" without a context.
    const char *renderer, *vendor, *version, *shading_language;
    /// The renderer runs on the CPU.
    bool software;
    /// The context has clip control: see bolan_renderer_desc::no_clip_control.
    bool clip_control;
    /// The context has what the compute backend needs: see bolan_renderer_desc::backend.
    bool compute;
    /// Largest image that the context can draw at once [px], each way; a view has at most 16384. 0 without a context.
    uint32_t max_picture;
} bolan_gl_info;

/// The properties of the context that is current on this thread.
BOLAN_API bolan_gl_info bolan_gl_get_info(void);

// ---- your state in it ----------------------------------------------------------------------------------------------

/// What a renderer's calls do with your state of OpenGL.
typedef enum bolan_restore {
    /// Each call asks OpenGL for your state and puts it back, whatever it was; default.
    BOLAN_RESTORE_FULL,
    /// You say what the state is, by bolan_renderer_declare_state(). Calls ask for nothing and put that back.
    BOLAN_RESTORE_DECLARED,
    /// Calls ask for nothing and put nothing back: for programs that set what they need before each of their passes.
    BOLAN_RESTORE_NONE,
} bolan_restore;

/// State of a context, in numbers and names of OpenGL.
/// What has no field here is in OpenGL's initial state.
typedef struct bolan_gl_state {
    /// Default 0.
    uint32_t draw_framebuffer, read_framebuffer;
    /// Default 0.
    uint32_t program, vertex_array;
    /// Bound to GL_ARRAY_BUFFER and GL_UNIFORM_BUFFER; default 0.
    uint32_t array_buffer, uniform_buffer;
    /// The active texture unit, from 0; default 0.
    uint32_t active_unit;
    /// True: sampler objects may be bound to units 0 to 28. A call unbinds them. Default false.
    bool samplers;
    /// x, y, width, height; default all 0. With a width of 0 the viewport is not put back.
    int32_t viewport[4];
    /// GL_SCISSOR_TEST; default false.
    bool scissor_test;
    /// x, y, width, height; default all 0. With a width of 0 the box is not put back.
    int32_t scissor_box[4];
    /// GL_DEPTH_TEST; default false.
    bool depth_test;
    /// Default true.
    bool depth_mask;
    /// Default GL_LESS.
    uint32_t depth_function;
    /// Default 1.
    float depth_clear;
    /// GL_BLEND of all draw buffers; default false.
    bool blend;
    /// Source and destination of colour, then of alpha; default GL_ONE, GL_ZERO, GL_ONE, GL_ZERO.
    uint32_t blend_function[4];
    /// Of all draw buffers; default true.
    bool color_mask[4];
    /// Default 0.
    float color_clear[4];
    /// GL_CULL_FACE; default false.
    bool cull_face;
    /// Default GL_BACK.
    uint32_t cull_mode;
    /// Default GL_CCW.
    uint32_t front_face;
    /// GL_STENCIL_TEST; default false.
    bool stencil_test;
    /// GL_FRAMEBUFFER_SRGB, which OpenGL ES has not; default false.
    bool framebuffer_srgb;
    /// GL_DITHER; default true.
    bool dither;
    /// Clip control: origin at the upper left; default false.
    bool clip_upper_left;
    /// Clip control: clip depth in [0,1]; default false.
    bool clip_zero_to_one;
} bolan_gl_state;

/// OpenGL's initial state: the defaults named above.
/// Thread-safe.
BOLAN_API bolan_gl_state bolan_gl_state_default(void);

// ---- a framebuffer without a window ---------------------------------------------------------------------------------

/// A framebuffer of 8-bit sRGB colours.
/// All its calls belong on the thread where its context is current.
typedef struct bolan_target bolan_target;

/// Makes a target of @p width x @p height pixels, 1..16384 each, in the current context.
/// @param out receives the target; NULL after an error.
/// Errors: ARGUMENT (another size), GL (no context, or one that is too old), MEMORY.
BOLAN_API bolan_result bolan_target_create(uint32_t width, uint32_t height, bolan_target **out);

/// The GL name of its framebuffer, for bolan_view::framebuffer.
BOLAN_API uint32_t bolan_target_framebuffer(const bolan_target *target);

/// Copies the image into the whole of @p framebuffer (GL name; 0 is the window), which is @p width x @p height pixels.
/// Where the sizes differ the image is scaled with bilinear filtering.
/// A framebuffer that cannot be drawn into, or a size that is not 1..16384 each way: nothing is copied, logged once.
BOLAN_API void bolan_target_show(bolan_target *target, uint32_t framebuffer, uint32_t width, uint32_t height);

/// Releases the target.
/// The context must be current. Without one, the log says so, and only the memory of the CPU is released.
/// NULL-safe; NULLs the pointer.
BOLAN_API void bolan_target_destroy(bolan_target **target);

#ifdef __cplusplus
}
#endif
#endif

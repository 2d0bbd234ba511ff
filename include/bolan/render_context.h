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

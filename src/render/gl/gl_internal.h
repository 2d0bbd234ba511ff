// SPDX-License-Identifier: MIT
// What the files of this folder share: the loader, and the format table.
#ifndef BOLAN_GL_INTERNAL_H
#define BOLAN_GL_INTERNAL_H

#include "gl.h"
#include "loader.h"

// Passes bind units 0..23; the layer itself binds on this one, so that creating or filling a texture disturbs no pass.
// Every GL 3.3 has 48 combined units, every ES 3.0 has 32.
enum { SCRATCH_UNIT = 28 };

typedef struct format_info {
    GLenum internal_format, format, type; // type of what an upload hands over (floats or bytes)
    bool half;                            // stored as 16-bit floats: may be handed over as halfs
    bool wide;                            // 32-bit floats: linear filtering is an extension on ES
    uint32_t components;
} format_info;
const format_info *bolan_gl_format_info(gl_format format);

void bolan_gl_set_enabled(GLenum name, bool on);
void bolan_gl_set_clip(const gl_caps *caps, GLenum origin, GLenum depth);
// What our calls take for granted: see saved.c.
void bolan_gl_set_defaults(const gl_caps *caps);

// Calls that bound.c leaves out where they would change nothing.
// `empty`: a vertex array without buffers, which is made when it is first needed and freed by the caller; NULL: none.
// `at_once`: glBindTextureUnit() is there.
void bolan_gl_track(gl_mesh *empty, bool at_once);
void bolan_gl_bind_to_unit(GLuint unit, GLenum target, GLuint texture);
void bolan_gl_untrack(void);
gl_mesh *bolan_gl_empty_mesh(void); // NULL: none was lent
void bolan_gl_tracked_active_texture(GLenum unit);
void bolan_gl_tracked_bind_texture(GLenum target, GLuint texture);
void bolan_gl_tracked_delete_textures(GLsizei count, const GLuint *textures);
void bolan_gl_tracked_use_program(GLuint program);
void bolan_gl_tracked_delete_program(GLuint program);
void bolan_gl_tracked_bind_vertex_array(GLuint array);
void bolan_gl_tracked_delete_vertex_arrays(GLsizei count, const GLuint *arrays);
void bolan_gl_tracked_bind_framebuffer(GLenum target, GLuint framebuffer);
void bolan_gl_tracked_delete_framebuffers(GLsizei count, const GLuint *framebuffers);
void bolan_gl_tracked_viewport(GLint x, GLint y, GLsizei width, GLsizei height);
void bolan_gl_tracked_enable(GLenum name);
void bolan_gl_tracked_disable(GLenum name);
void bolan_gl_tracked_depth_mask(GLboolean mask);
void bolan_gl_tracked_depth_func(GLenum function);
void bolan_gl_tracked_color_mask(GLboolean r, GLboolean g, GLboolean b, GLboolean a);
void bolan_gl_tracked_blend_func(GLenum source, GLenum destination, GLenum source_alpha, GLenum destination_alpha);
#ifndef BOLAN_GL_UNTRACKED
#undef glActiveTexture
#define glActiveTexture bolan_gl_tracked_active_texture
#undef glBindTexture
#define glBindTexture bolan_gl_tracked_bind_texture
#undef glDeleteTextures
#define glDeleteTextures bolan_gl_tracked_delete_textures
#undef glUseProgram
#define glUseProgram bolan_gl_tracked_use_program
#undef glDeleteProgram
#define glDeleteProgram bolan_gl_tracked_delete_program
#undef glBindVertexArray
#define glBindVertexArray bolan_gl_tracked_bind_vertex_array
#undef glDeleteVertexArrays
#define glDeleteVertexArrays bolan_gl_tracked_delete_vertex_arrays
#undef glBindFramebuffer
#define glBindFramebuffer bolan_gl_tracked_bind_framebuffer
#undef glDeleteFramebuffers
#define glDeleteFramebuffers bolan_gl_tracked_delete_framebuffers
#undef glViewport
#define glViewport bolan_gl_tracked_viewport
#undef glEnable
#define glEnable bolan_gl_tracked_enable
#undef glDisable
#define glDisable bolan_gl_tracked_disable
#undef glDepthMask
#define glDepthMask bolan_gl_tracked_depth_mask
#undef glDepthFunc
#define glDepthFunc bolan_gl_tracked_depth_func
#undef glColorMask
#define glColorMask bolan_gl_tracked_color_mask
#undef glBlendFuncSeparate
#define glBlendFuncSeparate bolan_gl_tracked_blend_func
#endif

// The driver's messages go to the log from here on, and to the caller's own callback; or to that callback alone again.
void bolan_gl_listen(gl_saved *s);
void bolan_gl_stop_listening(const gl_saved *s);

#endif

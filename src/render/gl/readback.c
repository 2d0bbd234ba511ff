// SPDX-License-Identifier: MIT
// Reading a target back without waiting: the GPU copies it into a buffer, and a fence tells when that is done.
#include "gl_internal.h"
#include <string.h>

bool bolan_gl_readback_is_possible(void) {
#ifdef __EMSCRIPTEN__
    return false; // WebGL maps no buffers
#else
    return bolan_gl_functions.MapBufferRange != NULL && bolan_gl_functions.UnmapBuffer != NULL;
#endif
}

static void drop_fence(gl_readback *r) {
    if (r->fence != NULL) glDeleteSync(r->fence);
    r->fence = NULL;
}

void bolan_gl_readback_begin(gl_readback *r, const gl_target *t) {
    const size_t bytes = (size_t)t->width * t->height * 4 * sizeof(float);
    drop_fence(r);
    if (r->id == 0) glGenBuffers(1, &r->id);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, r->id);
    if (r->bytes != bytes) glBufferData(GL_PIXEL_PACK_BUFFER, (GLsizeiptr)bytes, NULL, GL_STREAM_READ);
    r->bytes = bytes;
    bolan_gl_target_bind(t);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, (GLsizei)t->width, (GLsizei)t->height, GL_RGBA, GL_FLOAT, NULL);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    r->fence = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
}

bool bolan_gl_readback_is_under_way(const gl_readback *r) { return r->fence != NULL; }

bool bolan_gl_readback_end(gl_readback *r, float *rgba) {
    if (r->fence == NULL) return false;
    if (glClientWaitSync(r->fence, GL_SYNC_FLUSH_COMMANDS_BIT, 0) == GL_TIMEOUT_EXPIRED) return false;
    drop_fence(r);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, r->id);
    const void *mapped = glMapBufferRange(GL_PIXEL_PACK_BUFFER, 0, (GLsizeiptr)r->bytes, GL_MAP_READ_BIT);
    if (mapped != NULL) memcpy(rgba, mapped, r->bytes);
    if (mapped != NULL) glUnmapBuffer(GL_PIXEL_PACK_BUFFER);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    return mapped != NULL;
}

void bolan_gl_readback_cancel(gl_readback *r) { drop_fence(r); }

void bolan_gl_readback_free(gl_readback *r) {
    if (!bolan_gl_has_context()) r->fence = NULL;
    drop_fence(r);
    if (r->id && bolan_gl_has_context()) glDeleteBuffers(1, &r->id);
    *r = (gl_readback){0};
}

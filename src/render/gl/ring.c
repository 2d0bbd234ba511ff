// SPDX-License-Identifier: MIT
// A ring of memory for what changes from draw to draw: three regions of one buffer, filled one after the other. The GPU
// reads a range while later ones are written, so nothing waits and nothing is allocated:
//
//     | a b c d . . . | e f g h i j k | l m n . . . . |
//       the oldest      full: a fence    being filled
//
// A region is filled again when the fence at its end has passed, which it has long since: a frame puts a few kilobytes.
// Where buffers can stay mapped (OpenGL 4.4, EXT_buffer_storage) putting is copying; else it is one glBufferSubData(),
// which OpenGL itself keeps in order with the draws, so that there are no fences.
#include "gl_internal.h"
#include <string.h>

#define WAIT_NS 1000000000u

enum { BLOCK_BYTES = 16 }; // sizes of uniform blocks are multiples of it, those of structs in C may be less

static bool can_stay_mapped(void) {
    const gl_functions *f = &bolan_gl_functions;
    if (bolan_gl_is_es()) return bolan_gl_has_extension("GL_EXT_buffer_storage") && f->BufferStorageEXT;
    return (bolan_gl_version() >= 44 || bolan_gl_has_extension("GL_ARB_buffer_storage")) && f->BufferStorage;
}

static void allocate(gl_ring *r, size_t bytes) {
    const GLbitfield flags = GL_MAP_WRITE_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
    if (!can_stay_mapped()) {
        glBufferData(GL_UNIFORM_BUFFER, (GLsizeiptr)bytes, NULL, GL_DYNAMIC_DRAW);
        return;
    }
    if (bolan_gl_is_es()) {
        glBufferStorageEXT(GL_UNIFORM_BUFFER, (GLsizeiptr)bytes, NULL, flags);
    } else {
        glBufferStorage(GL_UNIFORM_BUFFER, (GLsizeiptr)bytes, NULL, flags);
    }
    r->mapped = glMapBufferRange(GL_UNIFORM_BUFFER, 0, (GLsizeiptr)bytes, flags);
}

bolan_result bolan_gl_ring_create(size_t region, gl_ring *out) {
    gl_ring r = {.region = region};
    GLint alignment = 1;
    GLint64 got = 0;
    glGetIntegerv(GL_UNIFORM_BUFFER_OFFSET_ALIGNMENT, &alignment);
    r.alignment = alignment > BLOCK_BYTES ? (size_t)alignment : BLOCK_BYTES;
    glGenBuffers(1, &r.id);
    glBindBuffer(GL_UNIFORM_BUFFER, r.id);
    allocate(&r, GL_RING_REGIONS * region);
    glGetBufferParameteri64v(GL_UNIFORM_BUFFER, GL_BUFFER_SIZE, &got);
    if (got != (GLint64)(GL_RING_REGIONS * region)) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY, "GL has no memory for a buffer of %zu bytes",
                  GL_RING_REGIONS * region);
        bolan_gl_ring_free(&r);
        return BOLAN_ERROR_MEMORY;
    }
    *out = r;
    return BOLAN_OK;
}

static void enter_next_region(gl_ring *r) {
    if (r->mapped != NULL) r->fences[r->filling] = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    r->filling = (r->filling + 1) % GL_RING_REGIONS;
    r->used = 0;
    const GLsync passed = r->fences[r->filling];
    if (passed == NULL) return;
    while (glClientWaitSync(passed, GL_SYNC_FLUSH_COMMANDS_BIT, WAIT_NS) == GL_TIMEOUT_EXPIRED) continue;
    glDeleteSync(passed);
    r->fences[r->filling] = NULL;
}

gl_range bolan_gl_ring_put(gl_ring *r, const void *data, size_t bytes) {
    BOLAN_ASSERT(r->id && bytes <= r->region);
    if (r->used + bytes > r->region) // a region is a multiple of every alignment
        enter_next_region(r);
    const size_t whole = (bytes + r->alignment - 1) / r->alignment * r->alignment;
    const gl_range range = {r->id, r->filling * r->region + r->used, whole};
    r->used += whole;
    if (r->mapped != NULL) {
        memcpy(r->mapped + range.offset, data, bytes);
        return range;
    }
    glBindBuffer(GL_UNIFORM_BUFFER, r->id);
    glBufferSubData(GL_UNIFORM_BUFFER, (GLintptr)range.offset, (GLsizeiptr)bytes, data);
    return range;
}

void bolan_gl_range_bind_uniform(const gl_range *range, uint32_t slot) {
    if (range->size == 0) return;
    glBindBufferRange(GL_UNIFORM_BUFFER, slot, range->buffer, (GLintptr)range->offset, (GLsizeiptr)range->size);
}

void bolan_gl_range_patch(const gl_range *to, size_t to_offset, const gl_buffer *from, size_t from_offset,
                          size_t size) {
    BOLAN_ASSERT(from_offset + size <= from->size && to_offset + size <= to->size);
    glBindBuffer(GL_ARRAY_BUFFER, from->id);
    glBindBuffer(GL_UNIFORM_BUFFER, to->buffer);
    glCopyBufferSubData(GL_ARRAY_BUFFER, GL_UNIFORM_BUFFER, (GLintptr)from_offset, (GLintptr)(to->offset + to_offset),
                        (GLsizeiptr)size);
}

void bolan_gl_ring_free(gl_ring *r) {
    const bool current = bolan_gl_has_context();
    for (int i = 0; i < GL_RING_REGIONS && current; i++)
        if (r->fences[i] != NULL) glDeleteSync(r->fences[i]);
    if (r->id && current) glDeleteBuffers(1, &r->id); // which unmaps it
    *r = (gl_ring){0};
}

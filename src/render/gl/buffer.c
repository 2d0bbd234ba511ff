// SPDX-License-Identifier: MIT
// Buffers and meshes.
#include "gl_internal.h"

// Binds a vertex array without buffers: the one that the renderer has lent, else one of its own that the caller frees.
static void bind_empty(gl_mesh *own) {
    gl_mesh *lent = bolan_gl_empty_mesh(), *empty = lent != NULL ? lent : own;
    if (empty->vao == 0) glGenVertexArrays(1, &empty->vao);
    glBindVertexArray(empty->vao);
}

// Indices go through the element binding, since WebGL keeps a buffer for indices, or for other data, as it was bound
// first. That binding belongs to a vertex array.
static GLenum bind_buffer(const gl_buffer *b, gl_mesh *own) {
    const GLenum target = b->kind == GL_BUFFER_UNIFORM ? GL_UNIFORM_BUFFER
                          : b->kind == GL_BUFFER_INDEX ? GL_ELEMENT_ARRAY_BUFFER
                                                       : GL_ARRAY_BUFFER;
    if (b->kind == GL_BUFFER_INDEX) bind_empty(own);
    glBindBuffer(target, b->id);
    return target;
}

static void unbind_buffer(const gl_buffer *b, gl_mesh *own) {
    if (b->kind == GL_BUFFER_INDEX) glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0); // a deleted buffer would live on in there
    bolan_gl_mesh_free(own);
}

bolan_result bolan_gl_buffer_create(gl_buffer_kind kind, gl_usage usage, size_t size, const void *data,
                                    gl_buffer *out) {
    BOLAN_ASSERT(out && size > 0);
    gl_buffer b = {.size = size, .kind = kind, .usage = usage};
    GLint64 got = 0;
    gl_mesh own = {0};
    glGenBuffers(1, &b.id);
    const GLenum target = bind_buffer(&b, &own);
    glBufferData(target, (GLsizeiptr)size, data, usage == GL_USAGE_STREAM ? GL_STREAM_DRAW : GL_STATIC_DRAW);
    glGetBufferParameteri64v(target, GL_BUFFER_SIZE, &got);
    unbind_buffer(&b, &own);
    if (got != (GLint64)size) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY, "GL has no memory for a buffer of %zu bytes", size);
        bolan_gl_buffer_free(&b);
        return BOLAN_ERROR_MEMORY;
    }
    *out = b;
    return BOLAN_OK;
}

void bolan_gl_buffer_update(gl_buffer *b, size_t offset, size_t size, const void *data) {
    BOLAN_ASSERT(b->id && offset + size <= b->size);
    gl_mesh own = {0};
    const GLenum target = bind_buffer(b, &own);
    if (offset == 0 && b->usage == GL_USAGE_STREAM) {
        glBufferData(target, (GLsizeiptr)b->size, NULL, GL_STREAM_DRAW); // fresh memory: no wait for the last frame
    }
    glBufferSubData(target, (GLintptr)offset, (GLsizeiptr)size, data);
    unbind_buffer(b, &own);
}

void bolan_gl_buffer_bind_uniform(const gl_buffer *b, uint32_t slot) {
    glBindBufferBase(GL_UNIFORM_BUFFER, slot, b->id);
}

void bolan_gl_buffer_copy(const gl_buffer *from, size_t from_offset, gl_buffer *to, size_t to_offset, size_t size) {
    BOLAN_ASSERT(from->id && to->id && from_offset + size <= from->size && to_offset + size <= to->size);
    glBindBuffer(GL_ARRAY_BUFFER, from->id);
    glBindBuffer(GL_UNIFORM_BUFFER, to->id);
    glCopyBufferSubData(GL_ARRAY_BUFFER, GL_UNIFORM_BUFFER, (GLintptr)from_offset, (GLintptr)to_offset,
                        (GLsizeiptr)size);
}

void bolan_gl_buffer_free(gl_buffer *b) {
    if (b->id && bolan_gl_has_context()) glDeleteBuffers(1, &b->id);
    *b = (gl_buffer){0};
}

// The vertex array is bound.
static void point_attributes(const gl_buffer *vertices, uint32_t first, const uint8_t *components, uint32_t attributes,
                             uint32_t stride) {
    glBindBuffer(GL_ARRAY_BUFFER, vertices->id);
    size_t offset = 0;
    for (uint32_t i = 0; i < attributes; i++) {
        glEnableVertexAttribArray(first + i);
        glVertexAttribPointer(first + i, components[i], GL_FLOAT, GL_FALSE, (GLsizei)stride, (const void *)offset);
        offset += components[i] * sizeof(float);
    }
    BOLAN_ASSERT(offset <= stride);
}

bolan_result bolan_gl_mesh_create(const gl_buffer *vertices, const gl_buffer *indices, const uint8_t *components,
                                  uint32_t attributes, uint32_t stride, gl_mesh *out) {
    BOLAN_ASSERT(vertices && indices && components && out);
    glGenVertexArrays(1, &out->vao);
    glBindVertexArray(out->vao);
    point_attributes(vertices, 0, components, attributes, stride);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices->id);
    glBindVertexArray(0);
    return BOLAN_OK;
}

void bolan_gl_mesh_attach(gl_mesh *m, const gl_buffer *vertices, uint32_t first, const uint8_t *components,
                          uint32_t attributes, uint32_t stride) {
    glBindVertexArray(m->vao);
    point_attributes(vertices, first, components, attributes, stride);
    glBindVertexArray(0);
}

void bolan_gl_mesh_attach_instances(gl_mesh *m, const gl_buffer *instances, uint32_t first, const uint8_t *components,
                                    uint32_t attributes, uint32_t stride) {
    glBindVertexArray(m->vao);
    point_attributes(instances, first, components, attributes, stride);
    for (uint32_t i = 0; i < attributes; i++) glVertexAttribDivisor(first + i, 1);
    glBindVertexArray(0);
}

void bolan_gl_mesh_draw(const gl_mesh *m, uint32_t first_index, uint32_t index_count) {
    glBindVertexArray(m->vao);
    const size_t offset = first_index * sizeof(uint32_t);
    glDrawElements(GL_TRIANGLES, (GLsizei)index_count, GL_UNSIGNED_INT, (const void *)offset);
}

void bolan_gl_mesh_draw_instances(const gl_mesh *m, uint32_t index_count, uint32_t instances) {
    glBindVertexArray(m->vao);
    glDrawElementsInstanced(GL_TRIANGLES, (GLsizei)index_count, GL_UNSIGNED_INT, NULL, (GLsizei)instances);
}

void bolan_gl_mesh_draw_lines(const gl_mesh *m, uint32_t index_count) {
    glBindVertexArray(m->vao);
    glDrawElements(GL_LINES, (GLsizei)index_count, GL_UNSIGNED_INT, NULL);
}

void bolan_gl_mesh_free(gl_mesh *m) {
    if (m->vao && bolan_gl_has_context()) glDeleteVertexArrays(1, &m->vao);
    *m = (gl_mesh){0};
}

// The core profile draws nothing without a vertex array.
void bolan_gl_draw_fullscreen(void) {
    gl_mesh own = {0};
    bind_empty(&own);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    bolan_gl_mesh_free(&own);
}

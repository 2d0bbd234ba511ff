// SPDX-License-Identifier: MIT
// Compute shaders: storage buffers, images, dispatches and barriers.
#include "gl_internal.h"

static void save_image(gl_compute_saved *s, GLuint i) {
    glGetIntegeri_v(GL_IMAGE_BINDING_NAME, i, &s->image[i].name);
    glGetIntegeri_v(GL_IMAGE_BINDING_LEVEL, i, &s->image[i].level);
    glGetIntegeri_v(GL_IMAGE_BINDING_LAYERED, i, &s->image[i].layered);
    glGetIntegeri_v(GL_IMAGE_BINDING_LAYER, i, &s->image[i].layer);
    glGetIntegeri_v(GL_IMAGE_BINDING_ACCESS, i, &s->image[i].access);
    glGetIntegeri_v(GL_IMAGE_BINDING_FORMAT, i, &s->image[i].format);
}

void bolan_gl_compute_begin(gl_compute_saved *s) {
    if (!bolan_gl_may_ask()) return;
    glGetIntegerv(GL_SHADER_STORAGE_BUFFER_BINDING, &s->buffer);
    glGetIntegerv(GL_DISPATCH_INDIRECT_BUFFER_BINDING, &s->arguments);
    for (GLuint i = 0; i < GL_STORAGE_SLOTS; i++) {
        glGetIntegeri_v(GL_SHADER_STORAGE_BUFFER_BINDING, i, &s->slot[i]);
        glGetInteger64i_v(GL_SHADER_STORAGE_BUFFER_START, i, &s->offset[i]);
        glGetInteger64i_v(GL_SHADER_STORAGE_BUFFER_SIZE, i, &s->size[i]);
    }
    for (GLuint i = 0; i < GL_IMAGES; i++) save_image(s, i);
}

void bolan_gl_compute_end(const gl_compute_saved *s) {
    if (!bolan_gl_may_ask()) return;
    for (GLuint i = 0; i < GL_STORAGE_SLOTS; i++) {
        if (s->slot[i] != 0 && s->size[i] > 0) {
            glBindBufferRange(GL_SHADER_STORAGE_BUFFER, i, (GLuint)s->slot[i], (GLintptr)s->offset[i],
                              (GLsizeiptr)s->size[i]);
        } else {
            glBindBufferBase(GL_SHADER_STORAGE_BUFFER, i, (GLuint)s->slot[i]);
        }
    }
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, (GLuint)s->buffer);
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, (GLuint)s->arguments);
    for (GLuint i = 0; i < GL_IMAGES; i++)
        glBindImageTexture(i, (GLuint)s->image[i].name, s->image[i].level, s->image[i].layered != 0, s->image[i].layer,
                           (GLenum)s->image[i].access, (GLenum)s->image[i].format);
}

void bolan_gl_storage_bind(const gl_buffer *b, uint32_t slot) {
    BOLAN_ASSERT(b->id && slot < GL_STORAGE_SLOTS);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, slot, b->id);
}

void bolan_gl_image_bind(const gl_texture *t, uint32_t level, uint32_t slot) {
    BOLAN_ASSERT(t->id && t->storage && level < t->levels && slot < GL_IMAGES);
    glBindImageTexture(slot, t->id, (GLint)level, GL_TRUE, 0, GL_WRITE_ONLY,
                       bolan_gl_format_info(t->format)->internal_format);
}

void bolan_gl_dispatch(uint32_t x, uint32_t y, uint32_t z) { glDispatchCompute(x, y, z); }

void bolan_gl_arguments_bind(const gl_buffer *b) {
    BOLAN_ASSERT(b->id);
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, b->id);
}

void bolan_gl_dispatch_indirect(size_t offset) { glDispatchComputeIndirect((GLintptr)offset); }

void bolan_gl_wait_for(gl_barrier what) {
    static const GLbitfield bits[] = {[GL_BARRIER_STORAGE] = GL_SHADER_STORAGE_BARRIER_BIT,
                                      [GL_BARRIER_ARGUMENTS] = GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT,
                                      [GL_BARRIER_TEXTURES] = GL_TEXTURE_FETCH_BARRIER_BIT,
                                      [GL_BARRIER_ALL] = GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT |
                                                         GL_BUFFER_UPDATE_BARRIER_BIT | GL_UNIFORM_BARRIER_BIT |
                                                         GL_FRAMEBUFFER_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT};
    glMemoryBarrier(bits[what]);
}

// SPDX-License-Identifier: MIT
// What is set in programs of the host's, and what is bound for them and stays bound.
#include "gl_internal.h"

const char *bolan_gl_guest_slots(uint32_t count, uint32_t first, uint32_t slot) {
    GLint units = 0, slots = 0;
    glGetIntegerv(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS, &units);
    glGetIntegerv(GL_MAX_UNIFORM_BUFFER_BINDINGS, &slots);
    if (first >= (uint32_t)units || count > (uint32_t)units - first) return "the context has not so many texture units";
    return slot >= (uint32_t)slots ? "the context has not so many uniform buffer slots" : NULL;
}

const char *bolan_gl_guest_link(uint32_t program, const char *block, const char *const *samplers, uint32_t count,
                                uint32_t first, uint32_t slot) {
    GLint linked = GL_FALSE, current = 0;
    const char *problem = bolan_gl_guest_slots(count, first, slot);
    if (problem != NULL) return problem;
    if (!glIsProgram(program)) return "that is no program";
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    if (!linked) return "the program is not linked";
    const GLuint index = glGetUniformBlockIndex(program, block);
    if (index == GL_INVALID_INDEX) return "the program does not use the fields";
    glUniformBlockBinding(program, index, slot);
    glGetIntegerv(GL_CURRENT_PROGRAM, &current);
    glUseProgram(program);
    for (uint32_t i = 0; i < count; ++i) {
        const GLint location = glGetUniformLocation(program, samplers[i]);
        if (location >= 0) glUniform1i(location, (GLint)(first + i)); // a sampler that is not used is not there
    }
    glUseProgram((GLuint)current);
    return NULL;
}

void bolan_gl_guest_bind(const gl_texture *const *textures, uint32_t count, uint32_t first, const gl_buffer *block,
                         uint32_t slot) {
    GLint active = 0, buffer = 0;
    if (bolan_gl_may_ask()) glGetIntegerv(GL_ACTIVE_TEXTURE, &active);
    if (bolan_gl_may_ask()) glGetIntegerv(GL_UNIFORM_BUFFER_BINDING, &buffer);
    for (uint32_t i = 0; i < count; ++i) {
        if (textures[i]->id == 0) continue;
        glActiveTexture(GL_TEXTURE0 + first + i);
        glBindTexture(textures[i]->target, textures[i]->id);
        glBindSampler(first + i, 0);
    }
    glBindBufferBase(GL_UNIFORM_BUFFER, slot, block->id);
    if (!bolan_gl_may_ask()) return;
    glBindBuffer(GL_UNIFORM_BUFFER, (GLuint)buffer);
    glActiveTexture((GLenum)active);
}

// ---- textures ------------------------------------------------------------------------------------------------------

void bolan_gl_sampler_create(gl_sampler *out, bool linear) {
    const GLint filter = linear ? GL_LINEAR : GL_NEAREST;
    glGenSamplers(1, &out->id);
    glSamplerParameteri(out->id, GL_TEXTURE_MIN_FILTER, filter);
    glSamplerParameteri(out->id, GL_TEXTURE_MAG_FILTER, filter);
    glSamplerParameteri(out->id, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glSamplerParameteri(out->id, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glSamplerParameteri(out->id, GL_TEXTURE_WRAP_R, GL_CLAMP_TO_EDGE);
    glSamplerParameteri(out->id, GL_TEXTURE_COMPARE_MODE, GL_NONE);
}

void bolan_gl_sampler_free(gl_sampler *s) {
    if (s->id && bolan_gl_has_context()) glDeleteSamplers(1, &s->id);
    s->id = 0;
}

static GLuint swap_cube(GLuint name) {
    GLint before = 0;
    if (bolan_gl_may_ask()) glGetIntegerv(GL_TEXTURE_BINDING_CUBE_MAP, &before);
    glBindTexture(GL_TEXTURE_CUBE_MAP, name);
    return (GLuint)before;
}

// OpenGL before 4.5 cannot tell a texture's kind; there one of another kind leaves an error of OpenGL.
static bool is_texture(GLuint name, GLenum kind) {
    GLint target = (GLint)kind;
    if (!glIsTexture(name)) return false;
    if (!bolan_gl_is_es() && bolan_gl_version() >= 45) glGetTextureParameteriv(name, GL_TEXTURE_TARGET, &target);
    return target == (GLint)kind;
}

bool bolan_gl_is_cube(uint32_t name) { return is_texture(name, GL_TEXTURE_CUBE_MAP); }
bool bolan_gl_is_2d(uint32_t name) { return is_texture(name, GL_TEXTURE_2D); }

void bolan_gl_guest_texture_bind(uint32_t name, uint32_t unit, const gl_sampler *sampler) {
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_2D, name);
    glBindSampler(unit, sampler != NULL ? sampler->id : 0);
}

uint32_t bolan_gl_cube_bind(uint32_t name, const gl_sampler *sampler, uint32_t unit) {
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindSampler(unit, sampler->id);
    return swap_cube(name);
}

void bolan_gl_cube_unbind(uint32_t before, uint32_t unit) {
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindSampler(unit, 0);
    (void)swap_cube(before);
}

static GLuint swap_multisampled(GLuint name) {
    GLint before = 0;
    if (bolan_gl_may_ask()) glGetIntegerv(GL_TEXTURE_BINDING_2D_MULTISAMPLE, &before);
    glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, name);
    return (GLuint)before;
}

bool bolan_gl_is_multisampled(uint32_t name) {
    return !bolan_gl_is_es() && is_texture(name, GL_TEXTURE_2D_MULTISAMPLE);
}

uint32_t bolan_gl_multisampled_bind(uint32_t name, uint32_t unit) {
    glActiveTexture(GL_TEXTURE0 + unit);
    return swap_multisampled(name);
}

void bolan_gl_multisampled_unbind(uint32_t before, uint32_t unit) {
    glActiveTexture(GL_TEXTURE0 + unit);
    (void)swap_multisampled(before);
}

// ---- the stencil of a framebuffer -----------------------------------------------------------------------------------

static const GLenum sides[2] = {GL_FRONT, GL_BACK};

void bolan_gl_stencil_begin(gl_stencil *s, uint8_t reference, uint8_t mask) {
    static const GLenum names[2][6] = {{GL_STENCIL_FUNC, GL_STENCIL_REF, GL_STENCIL_VALUE_MASK, GL_STENCIL_FAIL,
                                        GL_STENCIL_PASS_DEPTH_FAIL, GL_STENCIL_PASS_DEPTH_PASS},
                                       {GL_STENCIL_BACK_FUNC, GL_STENCIL_BACK_REF, GL_STENCIL_BACK_VALUE_MASK,
                                        GL_STENCIL_BACK_FAIL, GL_STENCIL_BACK_PASS_DEPTH_FAIL,
                                        GL_STENCIL_BACK_PASS_DEPTH_PASS}};
    *s = (gl_stencil){.function = {GL_ALWAYS, GL_ALWAYS}, .mask = {-1, -1}};
    for (int i = 0; i < 2; ++i)
        for (int k = 0; k < 3; ++k) s->operations[i][k] = GL_KEEP;
    for (int i = 0; bolan_gl_may_ask() && i < 2; ++i) {
        glGetIntegerv(names[i][0], &s->function[i]);
        glGetIntegerv(names[i][1], &s->reference[i]);
        glGetIntegerv(names[i][2], &s->mask[i]);
        for (int k = 0; k < 3; ++k) glGetIntegerv(names[i][3 + k], &s->operations[i][k]);
    }
    glEnable(GL_STENCIL_TEST);
    glStencilFuncSeparate(GL_FRONT_AND_BACK, GL_NOTEQUAL, reference, mask);
    glStencilOpSeparate(GL_FRONT_AND_BACK, GL_KEEP, GL_KEEP, GL_KEEP);
}

void bolan_gl_stencil_end(const gl_stencil *s) {
    glDisable(GL_STENCIL_TEST);
    for (int i = 0; i < 2; ++i) {
        const GLint *o = s->operations[i];
        glStencilFuncSeparate(sides[i], (GLenum)s->function[i], s->reference[i], (GLuint)s->mask[i]);
        glStencilOpSeparate(sides[i], (GLenum)o[0], (GLenum)o[1], (GLenum)o[2]);
    }
}

bool bolan_gl_has_stencil(uint32_t framebuffer) {
    GLint before = 0, object = GL_NONE;
    if (framebuffer != 0 && !glIsFramebuffer(framebuffer)) return false;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &before);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, framebuffer != 0 ? GL_STENCIL_ATTACHMENT : GL_STENCIL,
                                          GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, &object);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, (GLuint)before);
    return object != GL_NONE;
}

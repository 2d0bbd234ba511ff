// SPDX-License-Identifier: MIT
// Framebuffers over our own textures, and reading them back.
#include "gl_internal.h"

enum { MAX_COLORS = 4 };

static void attach(GLenum attachment, const gl_texture *t, int layer, uint32_t level) {
    if (t->target == GL_TEXTURE_2D) {
        glFramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D, t->id, (GLint)level);
    } else {
        glFramebufferTextureLayer(GL_FRAMEBUFFER, attachment, t->id, (GLint)level, layer < 0 ? 0 : layer);
    }
}

static void set_draw_buffers(uint32_t count) {
    GLenum buffers[MAX_COLORS] = {GL_NONE};
    for (uint32_t i = 0; i < count; i++) buffers[i] = GL_COLOR_ATTACHMENT0 + i;
    glDrawBuffers(count ? (GLsizei)count : 1, buffers);
    glReadBuffer(count ? GL_COLOR_ATTACHMENT0 : GL_NONE);
}

bolan_result bolan_gl_target_create(const gl_texture *const *color, uint32_t count, const gl_texture *depth, int layer,
                                    uint32_t level, gl_target *out) {
    BOLAN_ASSERT(out && count <= MAX_COLORS && (count > 0 || depth));
    const gl_texture *first = count ? color[0] : depth;
    gl_target t = {.width = first->width >> level, .height = first->height >> level};
    if (count) t.color = *color[0];
    if (!t.width) t.width = 1;
    if (!t.height) t.height = 1;
    GLint draw = 0, read = 0;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &draw);
    glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read);
    glGenFramebuffers(1, &t.id);
    glBindFramebuffer(GL_FRAMEBUFFER, t.id);
    for (uint32_t i = 0; i < count; i++)
        attach(GL_COLOR_ATTACHMENT0 + i, color[i], layer < 0 ? layer : layer + (int)i, level);
    if (depth) attach(GL_DEPTH_ATTACHMENT, depth, layer, level);
    set_draw_buffers(count);
    const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, (GLuint)draw);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, (GLuint)read);
    if (status != GL_FRAMEBUFFER_COMPLETE) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_GL_TARGET,
                  "GL cannot draw into a %u x %u target of format %d (status 0x%x)", t.width, t.height,
                  (int)first->format, status);
        bolan_gl_target_free(&t);
        return BOLAN_ERROR_GL;
    }
    *out = t;
    return BOLAN_OK;
}

void bolan_gl_target_bind(const gl_target *t) { bolan_gl_target_bind_external(t->id, 0, 0, t->width, t->height); }

void bolan_gl_target_bind_part(const gl_target *t, uint32_t x, uint32_t y, uint32_t width, uint32_t height) {
    glBindFramebuffer(GL_FRAMEBUFFER, t->id);
    glViewport((GLint)x, (GLint)y, (GLsizei)width, (GLsizei)height);
}

void bolan_gl_target_bind_external(uint32_t framebuffer, uint32_t x, uint32_t y, uint32_t width, uint32_t height) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport((GLint)x, (GLint)y, (GLsizei)width, (GLsizei)height);
}

void bolan_gl_clip_rows(uint32_t rows) {
    if (rows == 0) {
        glDisable(GL_SCISSOR_TEST);
        return;
    }
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, 16384, (GLsizei)rows);
}

void bolan_gl_target_clear_color(float r, float g, float b, float a) {
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glClearColor(r, g, b, a);
    glClear(GL_COLOR_BUFFER_BIT);
}

void bolan_gl_target_clear_integers(void) {
    const GLuint zero[4] = {0};
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glClearBufferuiv(GL_COLOR, 0, zero);
}

void bolan_gl_target_clear_depth(float depth) {
    glDepthMask(GL_TRUE);
    glClearDepthf(depth);
    glClear(GL_DEPTH_BUFFER_BIT);
}

static void blit(const gl_target *from, const gl_target *to, GLbitfield what) {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, from->id);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to->id);
    glBlitFramebuffer(0, 0, (GLint)from->width, (GLint)from->height, 0, 0, (GLint)to->width, (GLint)to->height, what,
                      GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, to->id);
}

void bolan_gl_target_copy_color(const gl_target *from, const gl_target *to) { blit(from, to, GL_COLOR_BUFFER_BIT); }
void bolan_gl_target_copy_depth(const gl_target *from, const gl_target *to) { blit(from, to, GL_DEPTH_BUFFER_BIT); }

void bolan_gl_target_show(const gl_target *from, uint32_t framebuffer, uint32_t width, uint32_t height) {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, from->id);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    glBlitFramebuffer(0, 0, (GLint)from->width, (GLint)from->height, 0, 0, (GLint)width, (GLint)height,
                      GL_COLOR_BUFFER_BIT, GL_LINEAR);
}

void bolan_gl_target_read_float(const gl_target *t, uint32_t attachment, float *rgba) {
    GLint read = 0;
    glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, t->id);
    glReadBuffer(GL_COLOR_ATTACHMENT0 + attachment);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, (GLsizei)t->width, (GLsizei)t->height, GL_RGBA, GL_FLOAT, rgba);
    glReadBuffer(GL_COLOR_ATTACHMENT0);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, (GLuint)read);
}

// ES cannot read depth, so the depth texture is drawn into a float one, which both APIs can read.
static bolan_result fit_reader(gl_depth_reader *r, uint32_t width, uint32_t height) {
    if (r->target.id && r->target.width == width && r->target.height == height) return BOLAN_OK;
    const gl_texture *color = &r->copy;
    const gl_texture_desc d = {.format = GL_FMT_RGBA32F, .width = width, .height = height};
    bolan_gl_target_free(&r->target);
    bolan_gl_texture_free(&r->copy);
    bolan_result result = r->program.id ? BOLAN_OK : bolan_gl_program_create("depth_copy", NULL, &r->program);
    if (result == BOLAN_OK) result = bolan_gl_texture_create(&d, &r->copy);
    if (result == BOLAN_OK) result = bolan_gl_target_create(&color, 1, NULL, -1, 0, &r->target);
    return result;
}

bolan_result bolan_gl_depth_read(gl_depth_reader *r, const gl_texture *depth, float *rgba) {
    const bolan_result result = fit_reader(r, depth->width, depth->height);
    if (result != BOLAN_OK) return result;
    bolan_gl_target_bind(&r->target);
    bolan_gl_set_state(&(gl_state){.color_write = true});
    bolan_gl_program_use(&r->program);
    glActiveTexture(GL_TEXTURE0 + SCRATCH_UNIT);
    glBindTexture(GL_TEXTURE_2D, depth->id);
    bolan_gl_program_int(&r->program, "depth_source", SCRATCH_UNIT);
    bolan_gl_draw_fullscreen();
    bolan_gl_target_read_float(&r->target, 0, rgba);
    return BOLAN_OK;
}

void bolan_gl_depth_reader_free(gl_depth_reader *r) {
    bolan_gl_target_free(&r->target);
    bolan_gl_texture_free(&r->copy);
    bolan_gl_program_free(&r->program);
}

// RGBA is the one byte format that every ES framebuffer can be read in.
void bolan_gl_read_rgb8(uint32_t framebuffer, uint32_t width, uint32_t height, uint8_t *rgba, uint8_t *rgb) {
    GLint read = 0;
    glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, (GLsizei)width, (GLsizei)height, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, (GLuint)read);
    for (uint32_t y = 0; y < height; y++) {
        const uint8_t *from = rgba + (size_t)(height - 1 - y) * width * 4;
        uint8_t *to = rgb + (size_t)y * width * 3;
        for (uint32_t x = 0; x < width; x++) {
            for (uint32_t c = 0; c < 3; c++) to[3 * x + c] = from[4 * x + c];
        }
    }
}

void bolan_gl_target_free(gl_target *t) {
    if (t->id && bolan_gl_has_context()) glDeleteFramebuffers(1, &t->id);
    *t = (gl_target){0};
}

// ---- the caller's framebuffers --------------------------------------------------------------------------------------

// Of the bound framebuffer's colour buffer; `buffer` is its attachment point.
static const char *attachment_problem(GLenum buffer, gl_purpose purpose) {
    const GLenum target = purpose == GL_TO_READ ? GL_READ_FRAMEBUFFER : GL_DRAW_FRAMEBUFFER;
    GLint object = GL_NONE, type = GL_NONE;
    glGetFramebufferAttachmentParameteriv(target, buffer, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, &object);
    if (object == GL_NONE) return "has no colour buffer";
    glGetFramebufferAttachmentParameteriv(target, buffer, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE, &type);
    if (type == GL_INT || type == GL_UNSIGNED_INT) return "holds integers, not colours";
    if (type == GL_FLOAT && purpose == GL_TO_READ && bolan_gl_is_es())
        return "holds floats, which OpenGL ES reads as no bytes";
    return NULL;
}

const char *bolan_gl_framebuffer_problem(uint32_t framebuffer, gl_purpose purpose) {
    if (framebuffer != 0 && !glIsFramebuffer(framebuffer)) return "is no framebuffer of this context";
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    if (status == GL_FRAMEBUFFER_UNDEFINED) return "is the window's, and this context has no window";
    if (status != GL_FRAMEBUFFER_COMPLETE) return "is not complete";
    GLint samples = 0, buffer = GL_NONE;
    glGetIntegerv(GL_SAMPLE_BUFFERS, &samples);
    if (samples > 0 && purpose == GL_TO_READ) return "has several samples a pixel: copy it into one that has one first";
    if (samples > 0 && purpose == GL_TO_COPY && bolan_gl_is_es())
        return "has several samples a pixel, and OpenGL ES copies into none such";
    glGetIntegerv(purpose == GL_TO_READ ? GL_READ_BUFFER : GL_DRAW_BUFFER0, &buffer);
    if (buffer == GL_NONE) return purpose == GL_TO_READ ? "has no read buffer" : "has no draw buffer";
    return framebuffer != 0 ? attachment_problem((GLenum)buffer, purpose) : NULL;
}

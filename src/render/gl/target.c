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

bolan_result gl_target_create(const gl_texture *const *color, uint32_t count, const gl_texture *depth, int layer,
                              uint32_t level, gl_target *out) {
    BOLAN_ASSERT(out && count <= MAX_COLORS && (count > 0 || depth));
    const gl_texture *first = count ? color[0] : depth;
    gl_target t = {0, first->width >> level, first->height >> level};
    if (!t.width) t.width = 1;
    if (!t.height) t.height = 1;
    GLint draw = 0, read = 0;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &draw);
    glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read);
    glGenFramebuffers(1, &t.id);
    glBindFramebuffer(GL_FRAMEBUFFER, t.id);
    for (uint32_t i = 0; i < count; i++) attach(GL_COLOR_ATTACHMENT0 + i, color[i], layer, level);
    if (depth) attach(GL_DEPTH_ATTACHMENT, depth, layer, level);
    set_draw_buffers(count);
    const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, (GLuint)draw);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, (GLuint)read);
    if (status != GL_FRAMEBUFFER_COMPLETE) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_GL_TARGET,
                  "GL cannot draw into a %u x %u target of format %d (status 0x%x)", t.width, t.height,
                  (int)first->format, status);
        gl_target_free(&t);
        return BOLAN_ERROR_GL;
    }
    *out = t;
    return BOLAN_OK;
}

void gl_target_bind(const gl_target *t) { gl_target_bind_external(t->id, t->width, t->height); }

void gl_target_bind_part(const gl_target *t, uint32_t x, uint32_t y, uint32_t width, uint32_t height) {
    glBindFramebuffer(GL_FRAMEBUFFER, t->id);
    glViewport((GLint)x, (GLint)y, (GLsizei)width, (GLsizei)height);
}

void gl_target_bind_external(uint32_t framebuffer, uint32_t width, uint32_t height) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, (GLsizei)width, (GLsizei)height);
}

void gl_clip_rows(uint32_t rows) {
    if (rows == 0) {
        glDisable(GL_SCISSOR_TEST);
        return;
    }
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, 16384, (GLsizei)rows);
}

void gl_target_clear_color(float r, float g, float b, float a) {
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glClearColor(r, g, b, a);
    glClear(GL_COLOR_BUFFER_BIT);
}

void gl_target_clear_depth(float depth) {
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

void gl_target_copy_color(const gl_target *from, const gl_target *to) { blit(from, to, GL_COLOR_BUFFER_BIT); }
void gl_target_copy_depth(const gl_target *from, const gl_target *to) { blit(from, to, GL_DEPTH_BUFFER_BIT); }

void gl_target_show(const gl_target *from, uint32_t framebuffer, uint32_t width, uint32_t height) {
    GLint draw = 0, read = 0;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &draw);
    glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read);
    const GLboolean scissor = glIsEnabled(GL_SCISSOR_TEST); // it would cut the copy
    glDisable(GL_SCISSOR_TEST);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, from->id);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    glBlitFramebuffer(0, 0, (GLint)from->width, (GLint)from->height, 0, 0, (GLint)width, (GLint)height,
                      GL_COLOR_BUFFER_BIT, GL_LINEAR);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, (GLuint)read);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, (GLuint)draw);
    if (scissor) glEnable(GL_SCISSOR_TEST);
}

void gl_target_read_float(const gl_target *t, uint32_t attachment, float *rgba) {
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
static bool draw_depth(const gl_texture *depth, float *rgba) {
    gl_program program = {0};
    gl_texture copy = {0};
    gl_target target = {0};
    const gl_texture *color = &copy;
    const gl_texture_desc d = {.format = GL_FMT_RGBA32F, .width = depth->width, .height = depth->height};
    bool ok = gl_program_create("depth_copy", NULL, &program) == BOLAN_OK && gl_texture_create(&d, &copy) == BOLAN_OK &&
              gl_target_create(&color, 1, NULL, -1, 0, &target) == BOLAN_OK;
    if (ok) {
        gl_target_bind(&target);
        const gl_state state = {.color_write = true};
        gl_set_state(&state);
        gl_program_use(&program);
        glActiveTexture(GL_TEXTURE0 + SCRATCH_UNIT);
        glBindTexture(GL_TEXTURE_2D, depth->id);
        gl_program_int(&program, "depth_source", SCRATCH_UNIT);
        gl_draw_fullscreen();
        gl_target_read_float(&target, 0, rgba);
    }
    gl_target_free(&target);
    gl_texture_free(&copy);
    gl_program_free(&program);
    return ok;
}

void gl_target_read_depth(const gl_target *t, const gl_texture *depth, float *out) {
    const size_t pixels = (size_t)t->width * t->height;
    float *rgba = bolan_allocate(pixels * 4 * sizeof(float));
    if (!rgba) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY, "no memory to read a depth buffer of %u x %u", t->width,
                  t->height);
        return;
    }
    GLint draw = 0, read = 0, viewport[4];
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &draw);
    glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read);
    glGetIntegerv(GL_VIEWPORT, viewport);
    if (draw_depth(depth, rgba)) {
        for (size_t i = 0; i < pixels; i++) out[i] = rgba[4 * i];
    }
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, (GLuint)draw);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, (GLuint)read);
    glViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
    bolan_release(rgba, pixels * 4 * sizeof(float));
}

void gl_read_rgb8(uint32_t framebuffer, uint32_t width, uint32_t height, uint8_t *rgb) {
    const size_t size = (size_t)width * height * 4;
    uint8_t *rgba = bolan_allocate(size); // RGBA is the one byte format that every ES framebuffer can be read in
    if (!rgba) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY, "no memory to read a picture of %u x %u", width, height);
        return;
    }
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
    bolan_release(rgba, size);
}

void gl_target_free(gl_target *t) {
    if (t->id) glDeleteFramebuffers(1, &t->id);
    *t = (gl_target){0};
}

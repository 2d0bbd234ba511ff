// SPDX-License-Identifier: MIT
// Programs: compile, link, and set uniforms by name.
#include "gl_internal.h"
#include "source.h"
#include <stdio.h>
#include <string.h>

enum { MESSAGES_MAX = 4096 };

static GLuint compile(const shader_text *source, GLenum type, const char *stage) {
    const GLuint shader = glCreateShader(type);
    const GLchar *text = source->text;
    glShaderSource(shader, 1, &text, NULL);
    glCompileShader(shader);
    GLint ok = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
    if (ok) return shader;
    char messages[MESSAGES_MAX] = "";
    glGetShaderInfoLog(shader, sizeof messages, NULL, messages);
    bolan_shader_text_log(source, stage, messages[0] ? messages : "the driver refused the shader without a message");
    glDeleteShader(shader);
    return 0;
}

static GLuint link(GLuint vertex, GLuint fragment, const char *stem) {
    const GLuint id = glCreateProgram();
    glAttachShader(id, vertex);
    glAttachShader(id, fragment);
    glLinkProgram(id);
    GLint ok = GL_FALSE;
    glGetProgramiv(id, GL_LINK_STATUS, &ok);
    if (ok) return id;
    char messages[MESSAGES_MAX] = "";
    glGetProgramInfoLog(id, sizeof messages, NULL, messages);
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_GL_SHADER, "%s.glsl does not link: %s", stem, messages);
    glDeleteProgram(id);
    return 0;
}

static void set_units(GLuint program, const shader_text *source) {
    for (uint32_t i = 0; i < source->unit_count; i++) {
        const GLint location = glGetUniformLocation(program, source->units[i].name);
        if (location >= 0) glUniform1i(location, source->units[i].unit);
    }
}

static void set_defaults(GLuint id, const shader_text *vertex, const shader_text *fragment) {
    static const char *const blocks[GL_UNIFORM_SLOTS] = {"Frame", "View", "Water", "Optics", "Bounds"};
    for (GLuint slot = 0; slot < GL_UNIFORM_SLOTS; slot++) {
        const GLuint block = glGetUniformBlockIndex(id, blocks[slot]);
        if (block != GL_INVALID_INDEX) glUniformBlockBinding(id, block, slot);
    }
    glUseProgram(id);
    set_units(id, vertex);
    set_units(id, fragment);
    glUseProgram(0);
}

// Members of blocks have no location.
static void find_uniforms(gl_program *p) {
    GLint count = 0;
    p->uniform_count = 0;
    glGetProgramiv(p->id, GL_ACTIVE_UNIFORMS, &count);
    for (GLint i = 0; i < count; i++) {
        char name[64];
        GLsizei length = 0;
        GLint size = 0;
        GLenum type = 0;
        glGetActiveUniform(p->id, (GLuint)i, sizeof name, &length, &size, &type, name);
        const GLint location = glGetUniformLocation(p->id, name);
        name[strcspn(name, "[")] = '\0';
        if (location < 0) continue;
        BOLAN_ASSERT(p->uniform_count < GL_PROGRAM_UNIFORMS && strlen(name) < GL_UNIFORM_NAME);
        snprintf(p->uniforms[p->uniform_count].name, GL_UNIFORM_NAME, "%.*s", GL_UNIFORM_NAME - 1, name);
        p->uniforms[p->uniform_count++].location = location;
    }
}

static _Thread_local uint32_t compiled; // by this thread
uint32_t bolan_gl_programs_compiled(void) { return compiled; }

static bolan_result build(const char *stem, const char *defines, GLuint *out) {
    shader_text source[2] = {{0}};
    GLuint vertex = 0, fragment = 0, id = 0;
    const bool es = bolan_gl_is_es();
    bolan_result result = bolan_shader_text_build(stem, "VERTEX", defines, es, &source[0]);
    if (result == BOLAN_OK) result = bolan_shader_text_build(stem, "FRAGMENT", defines, es, &source[1]);
    if (result == BOLAN_OK) {
        vertex = compile(&source[0], GL_VERTEX_SHADER, "vertex");
        fragment = compile(&source[1], GL_FRAGMENT_SHADER, "fragment");
    }
    if (vertex && fragment) id = link(vertex, fragment, stem);
    compiled += id != 0;
    if (id) set_defaults(id, &source[0], &source[1]);
    if (vertex) glDeleteShader(vertex);
    if (fragment) glDeleteShader(fragment);
    bolan_shader_text_free(&source[0]);
    bolan_shader_text_free(&source[1]);
    *out = id;
    return result == BOLAN_OK && !id ? BOLAN_ERROR_GL : result;
}

bolan_result bolan_gl_program_create(const char *stem, const char *defines, gl_program *out) {
    BOLAN_ASSERT(stem && out && strlen(stem) < sizeof out->stem);
    BOLAN_ASSERT(!defines || strlen(defines) < sizeof out->defines);
    gl_program p = {0};
    snprintf(p.stem, sizeof p.stem, "%s", stem);
    snprintf(p.defines, sizeof p.defines, "%s", defines ? defines : "");
    const bolan_result result = build(p.stem, p.defines, &p.id);
    if (p.id) find_uniforms(&p);
    *out = p;
    return result;
}

bolan_result bolan_gl_program_reload(gl_program *p) {
    GLuint id = 0;
    const bolan_result result = build(p->stem, p->defines, &id);
    if (result != BOLAN_OK) return result;
    glDeleteProgram(p->id);
    p->id = id;
    find_uniforms(p);
    return BOLAN_OK;
}

void bolan_gl_program_use(const gl_program *p) { glUseProgram(p->id); }

// A uniform that the compiler removed has location -1, which GL ignores: so a pass may set what a variant does not use.
// The driver is not asked: some answer only when they have finished what was drawn before.
static GLint locate(const gl_program *p, const char *name) {
    glUseProgram(p->id);
    for (uint32_t i = 0; i < p->uniform_count; i++)
        if (strcmp(p->uniforms[i].name, name) == 0) return p->uniforms[i].location;
    return -1;
}

void bolan_gl_program_int(const gl_program *p, const char *name, int value) { glUniform1i(locate(p, name), value); }
void bolan_gl_program_float(const gl_program *p, const char *name, float value) { glUniform1f(locate(p, name), value); }
void bolan_gl_program_vec2(const gl_program *p, const char *name, float x, float y) {
    glUniform2f(locate(p, name), x, y);
}

void bolan_gl_program_vec4(const gl_program *p, const char *name, bolan_vec4 v) {
    glUniform4f(locate(p, name), v.x, v.y, v.z, v.w);
}

void bolan_gl_program_vec4_array(const gl_program *p, const char *name, const float *xyzw, uint32_t count) {
    glUniform4fv(locate(p, name), (GLsizei)count, xyzw);
}

void bolan_gl_program_free(gl_program *p) {
    if (p->id && bolan_gl_has_context()) glDeleteProgram(p->id);
    *p = (gl_program){0};
}

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

static GLuint link(const GLuint shader[2], const char *stem) {
    const GLuint id = glCreateProgram();
    for (int i = 0; i < 2 && shader[i]; i++) glAttachShader(id, shader[i]);
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

static void set_defaults(GLuint id, const shader_text source[2]) {
    static const char *const blocks[GL_UNIFORM_SLOTS] = {"Frame", "View", "Water", "Optics", "Bounds"};
    for (GLuint slot = 0; slot < GL_UNIFORM_SLOTS; slot++) {
        const GLuint block = glGetUniformBlockIndex(id, blocks[slot]);
        if (block != GL_INVALID_INDEX) glUniformBlockBinding(id, block, slot);
    }
    glUseProgram(id);
    set_units(id, &source[0]);
    set_units(id, &source[1]);
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

typedef struct stage {
    const char *define, *name;
    GLenum type;
} stage;

// Of a program for drawing, and of one for computing, which has one stage.
static const stage drawing[] = {{"VERTEX", "vertex", GL_VERTEX_SHADER}, {"FRAGMENT", "fragment", GL_FRAGMENT_SHADER}},
                   computing[] = {{"COMPUTE", "compute", GL_COMPUTE_SHADER}};

static bolan_result build(const gl_program *p, GLuint *out) {
    shader_text source[2] = {{0}};
    GLuint shader[2] = {0}, id = 0;
    const stage *stages = p->compute ? computing : drawing;
    const int count = p->compute ? 1 : 2;
    bolan_result result = BOLAN_OK;
    for (int i = 0; i < count && result == BOLAN_OK; i++)
        result = bolan_shader_text_build(p->stem, stages[i].define, p->defines, bolan_gl_is_es(), &source[i]);
    bool all = result == BOLAN_OK;
    for (int i = 0; i < count && result == BOLAN_OK; i++) {
        shader[i] = compile(&source[i], stages[i].type, stages[i].name);
        all = all && shader[i];
    }
    if (all) id = link(shader, p->stem);
    compiled += id != 0;
    if (id) set_defaults(id, source);
    for (int i = 0; i < count; i++) {
        if (shader[i]) glDeleteShader(shader[i]);
        bolan_shader_text_free(&source[i]);
    }
    *out = id;
    return result == BOLAN_OK && !id ? BOLAN_ERROR_GL : result;
}

static bolan_result create(const char *stem, const char *defines, bool compute, gl_program *out) {
    BOLAN_ASSERT(stem && out && strlen(stem) < sizeof out->stem);
    BOLAN_ASSERT(!defines || strlen(defines) < sizeof out->defines);
    gl_program p = {.compute = compute};
    snprintf(p.stem, sizeof p.stem, "%s", stem);
    snprintf(p.defines, sizeof p.defines, "%s", defines ? defines : "");
    const bolan_result result = build(&p, &p.id);
    if (p.id) find_uniforms(&p);
    *out = p;
    return result;
}

bolan_result bolan_gl_program_create(const char *stem, const char *defines, gl_program *out) {
    return create(stem, defines, false, out);
}

bolan_result bolan_gl_program_create_compute(const char *stem, const char *defines, gl_program *out) {
    return create(stem, defines, true, out);
}

bolan_result bolan_gl_program_reload(gl_program *p) {
    GLuint id = 0;
    const bolan_result result = build(p, &id);
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

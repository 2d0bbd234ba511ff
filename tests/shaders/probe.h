// SPDX-License-Identifier: MIT
// Runs a piece of GLSL that includes shaders/common and shaders/shared, and reads what it computes as floats: the
// shader's own code, tested at its own precision.
#ifndef BOLAN_TESTS_PROBE_H
#define BOLAN_TESTS_PROBE_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "gl_support.h"
#include "render/gl/gl.h"

#define PROBE_WIDTH 256

// What a probe needs beyond its input: called with the program in use.
typedef void probe_setup(const gl_program *program, const void *context);

// `body` is GLSL that defines `vec4 probe(vec4 x)`. Evaluates it for `count` <= 256 inputs.
static inline void probe_run_with(const char *includes, const char *body, const char *defines, probe_setup *setup,
                                  const void *context, float (*in)[4], uint32_t count, float (*out)[4]) {
    static const char *const folders[] = {"common", "shared"};
    char folder[] = "probe_XXXXXX", path[2][512], link_to[512];
    assert_non_null(mkdtemp(folder));
    for (int i = 0; i < 2; ++i) {
        snprintf(path[i], sizeof path[i], "%s/%s", folder, folders[i]);
        snprintf(link_to, sizeof link_to, "%s/shaders/%s", BOLAN_SOURCE_DIR, folders[i]);
        assert_int_equal(symlink(link_to, path[i]), 0);
    }
    char file_path[512];
    snprintf(file_path, sizeof file_path, "%s/probe.glsl", folder);
    FILE *file = fopen(file_path, "w");
    assert_non_null(file);
    fprintf(file,
            "#include \"common/fullscreen.glsl\"\n#ifdef VERTEX\nvoid main() { fullscreen(0.0); }\n#endif\n#ifdef "
            "FRAGMENT\n%s\n"
            "uniform sampler2D inputs;\nlayout(location = 0) out vec4 result;\n%s\n"
            "void main() { result = probe(texelFetch(inputs, ivec2(gl_FragCoord.xy), 0)); }\n#endif\n",
            includes, body);
    fclose(file);
    bolan_gl_program_set_directory(folder);
    gl_program program = {0};
    assert_int_equal(bolan_gl_program_create("probe", defines, &program), BOLAN_OK);
    bolan_gl_program_set_directory(NULL);
    unlink(file_path);
    for (int i = 0; i < 2; ++i) unlink(path[i]);
    rmdir(folder);
    float padded[PROBE_WIDTH][4] = {{0}};
    memcpy(padded, in, count * sizeof *in);
    gl_texture_desc desc = {.format = GL_FMT_RGBA32F, .width = PROBE_WIDTH, .height = 1, .filter = GL_FILTER_NEAREST};
    gl_texture input = {0}, output = {0};
    assert_int_equal(bolan_gl_texture_create(&desc, &input), BOLAN_OK);
    assert_int_equal(bolan_gl_texture_create(&desc, &output), BOLAN_OK);
    bolan_gl_texture_upload(&input, 0, -1, padded, false);
    gl_target target = {0};
    const gl_texture *colors[] = {&output};
    assert_int_equal(bolan_gl_target_create(colors, 1, NULL, -1, 0, &target), BOLAN_OK);
    bolan_gl_target_bind(&target);
    bolan_gl_set_state(&(gl_state){.color_write = true});
    bolan_gl_texture_bind(&input, 15);
    bolan_gl_program_use(&program);
    bolan_gl_program_int(&program, "inputs", 15);
    if (setup) setup(&program, context);
    bolan_gl_draw_fullscreen();
    float result[PROBE_WIDTH][4];
    bolan_gl_target_read_float(&target, 0, &result[0][0]);
    memcpy(out, result, count * sizeof *out);
    bolan_gl_target_free(&target);
    bolan_gl_texture_free(&input);
    bolan_gl_texture_free(&output);
    bolan_gl_program_free(&program);
}

static inline void probe_run(const char *includes, const char *body, float (*in)[4], uint32_t count, float (*out)[4]) {
    probe_run_with(includes, body, NULL, NULL, NULL, in, count, out);
}

#endif

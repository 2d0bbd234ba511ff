// SPDX-License-Identifier: MIT
// From a shader's stem to the text that the compiler gets.
#ifndef BOLAN_GL_SOURCE_H
#define BOLAN_GL_SOURCE_H

#include "gl.h"

enum { SOURCE_MAX_FILES = 64, SOURCE_MAX_UNITS = 32, SOURCE_NAME = 48 };

// A shader put together: one text, the files it came from, and its #pragma unit lines.
typedef struct shader_text {
    char *text; // release with bolan_shader_text_free()
    size_t size, capacity;
    uint32_t file_count, unit_count;
    char files[SOURCE_MAX_FILES][SOURCE_NAME];
    struct {
        char name[SOURCE_NAME];
        int unit;
    } units[SOURCE_MAX_UNITS];
} shader_text;

// stage: "VERTEX", "FRAGMENT" or "COMPUTE"; defines: "A 1\nB 2\n" or NULL. On failure the log says which file and line.
bolan_result bolan_shader_text_build(const char *stem, const char *stage, const char *defines, bool es,
                                     shader_text *out);
void bolan_shader_text_free(shader_text *s);
// Logs a compiler's messages with the file and line in the place of the driver's line number.
void bolan_shader_text_log(const shader_text *s, const char *stage, const char *messages);

#endif

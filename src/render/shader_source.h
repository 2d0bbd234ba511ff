// SPDX-License-Identifier: MIT
// The shader files, embedded by cmake/embed_text.cmake. Paths are relative to shaders/ ("shared/fresnel.glsl"), sorted.
#ifndef BOLAN_RENDER_SHADER_SOURCE_H
#define BOLAN_RENDER_SHADER_SOURCE_H

typedef struct bolan_shader_source {
    const char *path;
    const char *text;
} bolan_shader_source;

extern const bolan_shader_source bolan_shader_sources[];
extern const unsigned bolan_shader_source_count;

#endif

// SPDX-License-Identifier: MIT
// The programs of the water. Each shader file of the water is compiled in several variants: by the wave model, the
// surface, the ground, and what its optics defines besides. prepare() lists every variant that a frame of its setup can
// need and compiles those that are missing; a draw call only looks one up. So no program is compiled inside a frame:
// not when the eye climbs, dives, or comes to a coast.
#ifndef BOLAN_RENDER_PROGRAMS_H
#define BOLAN_RENDER_PROGRAMS_H

#include "bolan/render.h"
#include "gl/gl.h"
#include "sea_gpu.h"

// What all shaders of the water share: one define each, in this order, see shaders/common/waves.glsl and
// water_vertex.glsl.
enum {
    WATER_FEATURE_EXP = 1 << 0,     // WAVES_EXP
    WATER_FEATURE_SUM = 1 << 1,     // WAVES_SUM
    WATER_FEATURE_MESH = 1 << 2,    // WAVES_MESH
    WATER_FEATURE_QUAD = 1 << 3,    // QUAD
    WATER_FEATURE_TRIM = 1 << 4,    // TRIM: the corners of the quad can be seen
    WATER_FEATURE_LAND = 1 << 5,    // LAND
    WATER_FEATURE_GRID = 1 << 6,    // STATIC_GRID
    WATER_FEATURE_PACKED = 1 << 7,  // PACKED
    WATER_FEATURE_BOUNDS = 1 << 8,  // BOUNDS: the water lies in a polygon
    WATER_FEATURE_LAYERS = 1 << 9,  // LAYERS: the water has wave layers
    WATER_FEATURE_BOUND = 1 << 10,  // BOUND_WAVES: of cascades of order 2
    WATER_FEATURE_NESTED = 1 << 11, // NESTED_GRID
    WATER_FEATURE_COUNT = 12,
    WATER_FEATURE_CASCADES = WATER_FEATURE_PACKED | WATER_FEATURE_BOUND,
    WATER_FEATURE_WAVES =
        WATER_FEATURE_EXP | WATER_FEATURE_SUM | WATER_FEATURE_MESH | WATER_FEATURE_CASCADES | WATER_FEATURE_LAYERS,
    WATER_FEATURE_ALL = (1 << WATER_FEATURE_COUNT) - 1
};

enum { WATER_SHADER_DEFINES = 10 }; // of one shader file, besides the features

// A shader file of the water. Static data: a variant is known by the address of its shader.
typedef struct water_shader {
    const char *stem;
    uint32_t reads;                            // features that the file depends on
    bool pixels;                               // the file has both entry points of shaders/common/pixels.glsl
    bool dispatched;                           // the file is a compute shader
    const char *defines[WATER_SHADER_DEFINES]; // bit i of a variant's `own` adds line i, "NAME VALUE\n"
} water_shader;

// One variant of a shader file.
typedef struct water_variant {
    const water_shader *shader;
    uint32_t features; // of WATER_FEATURE_..., those that the file reads
    uint32_t own;      // bits of the file's own defines
    uint32_t waves;    // number of exp-cosine waves, 0 for every other model
    bool compute;      // a compute shader, in the place of a vertex and a fragment shader
} water_variant;

typedef struct water_program {
    water_variant variant;
    gl_program program; // id 0: it does not compile, and the log has said so
    bool compiled;      // or tried
} water_program;

typedef struct water_programs {
    uint32_t count, capacity;
    water_program *list;
    bool refused; // by the present preparation: memory for the list ran out, and the log says so
} water_programs;

// What decides which programs a frame of the water can need. It does not change while the eye moves.
typedef struct water_setup {
    bolan_quality quality;
    water_waves waves, waves_below;                              // seen from above and from under the water
    bolan_surface_kind surface;                                  // from above; from below it is the quad
    bool below;                                                  // the optics has a picture for an eye under water
    bool land, static_grid, packed, bounds, layers, bound_waves; // as the features of these names
    bool compute;                                                // BOLAN_PIXELS_COMPUTE
    const bolan_look *look;
    bool foams;          // the sea does: bolan_foam_can_form()
    bool streaks;        // the wind blows foam into streaks
    bool shares_samples; // half-rate shading: see half_rate.h
    bool edges;          // BOLAN_SHOW_MESH
    uint32_t wave_count; // exp-cosine waves
    uint32_t cascades;   // 1 to BOLAN_MAX_CASCADES
} water_setup;

// Notes that frames of this setup use this variant of the shader, seen from above or from `below` the surface. Of the
// quad from above both variants are noted, with and without TRIM. Returns false when there is no memory (logged).
bool bolan_water_programs_add(water_programs *all, const water_setup *s, bool below, const water_shader *shader,
                              uint32_t own);
// The feature of a surface whose vertices the vertex shader makes.
uint32_t bolan_water_grid_feature(bolan_surface_kind surface);
// How many of the noted variants are still to be compiled.
uint32_t bolan_water_programs_missing(const water_programs *all);
// Compiles them. `progress` may be NULL. What does not compile is logged once, and draws nothing.
void bolan_water_programs_compile(water_programs *all, bolan_progress *progress, void *user);
// Whether every noted variant has compiled.
bool bolan_water_programs_are_whole(const water_programs *all);
// The variant of a shader by which something is drawn: `features` are those of the surface and the ground. `compute`:
// by a compute shader, where the file has one.
water_variant bolan_water_variant_of(const water_shader *shader, uint32_t own, water_waves waves, uint32_t wave_count,
                                     uint32_t features, bool compute);
// The lines "NAME VALUE\n" that a variant defines.
void bolan_water_variant_defines(const water_variant *v, char *defines, size_t size);
// The program of a variant; NULL: it was never noted (an assertion), or does not compile.
const gl_program *bolan_water_programs_find(const water_programs *all, const water_variant *v);
bolan_result bolan_water_programs_reload(water_programs *all);
void bolan_water_programs_free(water_programs *all);

#endif

// SPDX-License-Identifier: MIT
// The synthesis of cascades on the GPU by compute shaders: the twin of src/waves/cascades, into the textures of
// sea_gpu.h.
//
//     modes ──► sea_rows ──► rows ──► sea_columns ──► level 0 ──► sea_levels ──► all levels
//                                       ▲    │                       └─────────► sea_foam_law ──► law
//                  sea_rows, sea_columns with TICKS ──► foam memory
//
// All cascades are in each dispatch. The tables of a sea are uploaded once; a step sends times and a few factors as
// uniforms. Ticks of the foam memory run four at a time, when the sea has passed one.
//
// Errors against the CPU, which tests/shaders/test_sea_compute.c binds: 4e-6 of the rms before the rounding to half
// floats, at any time of the sea, as phases are products of whole numbers.
#ifndef BOLAN_RENDER_SEA_COMPUTE_H
#define BOLAN_RENDER_SEA_COMPUTE_H

#include "bolan/waves.h"
#include "gl/gl.h"

// What the GPU knows of one sea.
typedef struct sea_tables {
    uint64_t sea;    // 0: none
    gl_buffer modes; // of all cascades, and the divisors of the readers
    gl_buffer divisors;
    gl_buffer memory;              // foam at the last tick
    gl_buffer law;                 // four floats, by FOAM_LAW_THRESHOLD ...
    bolan_vec4 weights;            // bolan_foam_weights()
    float offset;                  // of the law: from the mean to where old foam begins [standard deviations]
    float variance;                // and the variance of the Jacobian
    bool remembers;                // `memory` is of these ticks:
    double from, tick;             // bolan_sea_clock.foam_from, and the last tick
    float axes[4][4], parts[4][4]; // uniforms of sea_block.glsl
    uint32_t count, most_rows;     // cascades; the most transforms along i of one
    uint64_t bytes;                // of the modes, and of the rows between the passes
} sea_tables;

enum { FOAM_LAW_THRESHOLD, FOAM_LAW_VARIANCE, FOAM_LAW_EDGE, FOAM_LAW_SHARE, FOAM_LAW_COUNT }; // of sea_tables.law

// The timed stages.
typedef enum sea_stage { SEA_STAGE_TICKS, SEA_STAGE_ROWS, SEA_STAGE_COLUMNS, SEA_STAGE_LEVELS, SEA_STAGES } sea_stage;
extern const char *const bolan_sea_stage_names[SEA_STAGES];

typedef struct sea_compute sea_compute;

// What the images hold besides the displacement. WHOLE and PACKED: see water_textures of sea_gpu.h. HOST: as
// bolan_fields.glsl has it, slopes as in WHOLE, and the foam alone in the third.
typedef enum sea_layout { SEA_LAYOUT_WHOLE, SEA_LAYOUT_PACKED, SEA_LAYOUT_HOST, SEA_LAYOUTS } sea_layout;

enum { SEA_SIZES = 6 }; // 32, 64 .. 1024
// The programs of a size.
typedef struct sea_programs {
    gl_program rows, tick_rows, tick_columns, columns[SEA_LAYOUTS];
    bool compiled[SEA_LAYOUTS], whole[SEA_LAYOUTS]; // tried; all of them are there
} sea_programs;

struct sea_compute {
    sea_programs programs[SEA_SIZES];
    gl_program levels, law[SEA_LAYOUT_HOST]; // a host has no law of foam
    gl_buffer rows;                          // between the passes; as large as the largest sea needs
    gl_timer timers[SEA_STAGES];
    uint64_t bytes; // of the last synthesis: see bolan_frame_statistics.sea_bytes
};

// The images that a synthesis fills: arrays of RGBA16F with storage, a layer for each cascade.
typedef struct sea_images {
    sea_layout layout;
    const gl_texture *displacement, *slopes, *third; // third: fold, or a host's foam; unused where packed
} sea_images;

// Compiles what seas of n x n samples need. False: it does not compile (logged).
bool bolan_sea_compute_compile(sea_compute *p, uint32_t n, sea_layout layout);
// Fills the images with the present time of the sea, and the law of its foam. Tables of another sea are made anew.
// False: there is no memory, or a program that does not compile (logged).
bool bolan_sea_compute_run(sea_compute *p, sea_tables *t, const bolan_sea *sea, const sea_images *images,
                           gl_timing timing);
bolan_result bolan_sea_compute_reload(sea_compute *p);
void bolan_sea_tables_free(sea_tables *t);
void bolan_sea_compute_free(sea_compute *p);

#endif

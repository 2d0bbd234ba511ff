// SPDX-License-Identifier: MIT
// The sea on the GPU, whichever model makes its waves: textures and uniforms of shaders/common/waves.glsl.
#ifndef BOLAN_RENDER_WATER_FIELDS_H
#define BOLAN_RENDER_WATER_FIELDS_H

#include "frame.h"
#include "sea_compute.h"
#include "water_block.h"

// Which of the four ways of waves.glsl.
typedef enum water_waves { WATER_CASCADES, WATER_EXP, WATER_SUM, WATER_MESH } water_waves;
// The sums of cosines are made on the CPU for each vertex; the quad has no vertices to speak of, so there in each
// pixel.
water_waves bolan_water_waves_of(bolan_wave_form form, bolan_surface_kind surface);
// "WAVES_EXP 1\n" and so on; "" for cascades.
const char *bolan_water_waves_define(water_waves waves);

// What an optics reads of the cascades' textures, besides the displacement.
typedef enum water_textures {
    WATER_TEXTURES_ALL,    // slope_map: slope, dxx, dyy; fold_map: dxy, foam memory
    WATER_TEXTURES_PACKED, // slope_map0...: slope, dxx + dyy, foam memory; no fold_map: one look-up a cascade for all
    WATER_TEXTURES_NONE,   // only the table of unresolved slopes (the optics has the waves by other means)
} water_textures;

// What the GPU holds of one sea. The optics binds `fine`.
typedef struct sea_fields {
    gl_texture displacement, slopes, fold;        // cascades: arrays, a layer each
    gl_texture displacement_before;               // of another step, for motion vectors; id 0: nobody has asked
    double time, time_before;                     // of both displacements; NAN: they hold none
    gl_texture packed_slopes[BOLAN_MAX_CASCADES]; // instead of slopes and fold; where computed, the layers of slopes
    bool packed;                                  // which of them hold this step's waves
    sea_tables tables;                            // of the compute backend
    gl_texture fine;                              // slopes of the fine waves, with WATER_TEXTURES_ALL
    gl_texture slope_table;
    uint64_t sea, serial;    // of the slope table, and of the fields; 0: none
    water_textures textures; // what was uploaded of that serial
    uint64_t used;           // when it was prepared, in preparations
} sea_fields;

typedef struct sea_gpu {
    sea_fields kept[BOLAN_KEPT_SEAS];
    sea_fields *now;                                   // of the step that is drawn
    uint64_t preparations;                             // since creation
    struct water_texel_work *work[BOLAN_MAX_CASCADES]; // levels made on the CPU
    uint32_t work_n;
    gl_texture table; // WATER_SUM, WATER_MESH: a texel a wave
    uint16_t *cpu_fold;
    size_t cpu_fold_bytes;
} sea_gpu;

// Of the textures of `count` cascades of n samples a side; `storage`: compute shaders write them.
gl_texture_desc bolan_sea_array_desc(uint32_t n, uint32_t count, bool storage);
bolan_result bolan_sea_gpu_create(sea_gpu *p);
// Takes the fields of this step: those of its serial where they are kept; else uploads or computes them, into those of
// the same sea or those that were prepared the longest time ago. Sets f->foam_law. False: they cannot be had (logged).
bool bolan_sea_gpu_prepare(sea_gpu *p, frame *f, water_textures textures);
// Compiles the compute shaders of a sea of cascades. False: one does not compile (logged).
bool bolan_sea_gpu_compile(const frame *f, bool packed);
// The fine waves, as shared/physical_block.glsl has them; all 0 where there are none.
typedef struct fine_values {
    vec4 tile;
    bolan_vec3 slopes;
    float widest, texel;
} fine_values;
fine_values bolan_fine_values(const render_view *v);
// Uploads what belongs to a view's eye, and binds all.
void bolan_sea_gpu_view(sea_gpu *p, const render_view *v, water_waves waves);
// Binds the textures again, for a pass that follows one which used their units.
void bolan_sea_gpu_bind(const sea_gpu *p, water_waves waves);
// Waves of a sum stand in a table: those of the vertices of a mesh too, for they cast caustics (caustics.c).
bool bolan_water_waves_have_table(water_waves waves);
// A wave of a sum as the shaders have it: kx, ky [turns/m], amplitude [m], phase at the eye now [turns].
void bolan_sea_wave_at(const render_view *v, uint32_t index, double amplitude_factor, float out[4]);
// Fills what waves.glsl reads of the block Water: the sea's own members, and where the eye stands in its fields.
void bolan_sea_gpu_fill(water_block *b, const render_view *v, water_waves waves);
// The displacement of the present sea at the time of the step before; NULL: it is not kept, or that is no step of it.
const gl_texture *bolan_sea_gpu_before(const sea_gpu *p, double time);
void bolan_sea_gpu_free(sea_gpu *p);
// The waves of the warped plane with their phases at an origin, as warp_wave_of of shaders/shared/water_block.glsl;
// returns how many.
uint32_t bolan_warp_waves_at(const bolan_sea_warp *warp, bolan_dvec3 origin, vec4 out[BOLAN_WARP_WAVES]);

#endif

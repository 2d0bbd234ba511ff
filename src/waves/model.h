// SPDX-License-Identifier: MIT
// A wave model computes the waves of a sea; it is a table of functions. Private to src/waves.
//
//     folder       models                    a sea is                               fields of one time
//     cascades/    FFT                       up to four tiles of random modes       planes of each tile, foam memory
//     loop/        TEXTURES                  one such tile, in a loop of frames     the same
//     sum/         COSINES, EXP_COSINE       a sum of some waves                    the phase of each wave
//
// The tables of a sea (`sea_shared`, sea.h) are written by create() and only read afterwards, so that forks on several
// threads share them. The fields (`bolan_sea.fields`) belong to one sea. What all models have in common, such as ids,
// foam rules, slope tables, statistics and validation, stands in src/waves and asks the model by this table alone.
#ifndef BOLAN_WAVES_MODEL_H
#define BOLAN_WAVES_MODEL_H

#include "waves/sea.h"

typedef void sea_visit(void *context, const sea_mode *mode);

typedef struct sea_model {
    // What readers of the fields find: cascades, or components of one law.
    bolan_wave_form form;
    // The fields remember the seconds before, so settling has something to do.
    bool remembers;

    // Writes shared->tables, the bands and counts, and the defaults of desc that depend on the sea state. False when
    // memory is short (logged); what was reserved by then is released with `shared`.
    bool (*create)(sea_shared *shared, const spectrum_eval *eval);
    // Adds what create() and create_fields() reserve; shared has a desc, a summary and a limit, and no memory.
    void (*size)(sea_shared *shared, const spectrum_eval *eval, bolan_sea_bytes *bytes);
    // Frees what create() holds beside the memory reserved by bolan_sea_reserve(). NULL: nothing.
    void (*destroy)(sea_shared *shared);
    // Reserves sea->fields. False when memory is short (logged).
    bool (*create_fields)(bolan_sea *sea);

    // The time [s] of the fields that are shown at `time`, and the frame of a loop; frame may be NULL.
    double (*shown_time)(const sea_shared *shared, double time, uint32_t *frame);
    // Makes the fields of an instant. Ticks are asked of models that remember alone.
    void (*step)(const bolan_sea *sea, const sea_instant *instant);

    // See bolan_sea_sample_rest() and bolan_sea_sample_grid(), whose arguments were checked.
    void (*sample_rest)(const bolan_sea *sea, const bolan_dvec2 *points, uint32_t count, bolan_sea_sample *out);
    void (*sample_grid)(const bolan_sea *sea, const bolan_dvec2 *points, const float *spacing, uint32_t count,
                        bolan_sea_sample *out);
    // Adds the exact fields at a rest point to `out`, without the lift.
    void (*sample_direct)(const sea_shared *shared, bolan_dvec2 at, bolan_dvec2 drift, double shown, sea_sums *out);

    // Calls `visit` for every mode or wave, in a fixed order.
    void (*each_wave)(const sea_shared *shared, sea_visit *visit, void *context);
    // Expected slope covariance of all waves: xx, xy, yy.
    void (*slopes)(const sea_shared *shared, double out[3]);
    // See bolan_sea_bounds().
    void (*bounds)(const sea_shared *shared, double *vertical, double *horizontal);
    // Peak period of the waves [s]. NULL: the general estimate of statistics.c, for a dense spectrum.
    double (*peak_period)(const sea_shared *shared);
    // The fine waves of cascades (bolan_sea_fine()), all NULL where the model has none. Their tables, from
    // shared->rest_slope; each of them; their fields at the sea's time; a view of these.
    bool (*create_fine)(sea_shared *shared);
    void (*each_fine)(const sea_shared *shared, sea_visit *visit, void *context);
    void (*step_fine)(const bolan_sea *sea);
    bolan_sea_fine_view (*fine)(const bolan_sea *sea);
    // Side of the square over which the sea is measured [m], > 0.
    double (*side)(const sea_shared *shared);
    // Continues a digest over every field.
    uint64_t (*hash)(const bolan_sea *sea, uint64_t hash);

    // One of these two is NULL, and the count of the other in sea_shared is 0. cascade() has the planes too.
    bolan_cascade_view (*cascade)(const bolan_sea *sea, uint32_t index);
    bolan_sea_component (*component)(const sea_shared *shared, uint32_t index);
} sea_model;

// The table of a model.
const sea_model *bolan_sea_model_of(bolan_wave_model waves);

extern const sea_model bolan_sea_model_fft, bolan_sea_model_textures, bolan_sea_model_cosines,
    bolan_sea_model_exp_cosine;

// The shown_time() of models without frames: `time` reduced by the loop, or by 2^36 s.
double bolan_sea_reduced_time(const sea_shared *shared, double time, uint32_t *frame);

#endif

// SPDX-License-Identifier: MIT
// A sea from creation to destruction, its forks, and its steps through time.
#include "spectrum/portable.h"
#include "waves/model.h"

#include <stdio.h>
#include <string.h>

bolan_sea_desc bolan_sea_desc_default(void) {
    bolan_sea_desc desc;
    memset(&desc, 0, sizeof desc); // the padding too: equal descs are equal bytes
    bolan_params_default(&bolan_sea_params, &desc);
    desc.sea_state = bolan_sea_state_from_wind(8.0, 240.0, 200e3);
    return desc;
}

// ---- memory ---------------------------------------------------------------------------------------------------------

void *bolan_sea_borrow(size_t bytes) {
    void *memory = bolan_allocate(bytes);
    if (!memory)
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY, "no memory for a sea: %zu bytes were refused", bytes);
    return memory;
}

void *bolan_sea_reserve(sea_memory *memory, size_t bytes) {
    BOLAN_ASSERT(memory->count < SEA_MAX_BLOCKS);
    void *at = bolan_sea_borrow(bytes);
    if (!at) return NULL;
    memory->block[memory->count].at = at;
    memory->block[memory->count++].bytes = bytes;
    return at;
}

static void release(const sea_memory *memory) {
    for (uint32_t i = 0; i < memory->count; i++) bolan_release(memory->block[i].at, memory->block[i].bytes);
}

// ---- creation -------------------------------------------------------------------------------------------------------

// Sets the summary, and the factor that brings the waves down to what their depth carries. Says so if `aloud`.
static void set_limit(sea_shared *s, bool aloud) {
    const bolan_sea_limit limit = bolan_sea_state_limit(&s->desc.sea_state);
    s->summary = bolan_sea_state_summary(&s->desc.sea_state);
    const double asked = s->summary.hs;
    s->limit = fmin(limit.by_depth, limit.by_steepness);
    if (s->limit == 1.0) return;
    s->summary.hs *= s->limit;
    s->summary.m0 *= s->limit * s->limit;
    if (!aloud) return;
    if (limit.by_depth <= limit.by_steepness) {
        bolan_log(BOLAN_LOG_WARNING, BOLAN_LOG_SEA_LIMITED,
                  "the sea is too high for its depth of %.4g m: Hs lowered from %.3g to %.3g m, 0.6 of the depth",
                  s->desc.sea_state.depth, asked, s->summary.hs);
    } else {
        bolan_log(BOLAN_LOG_WARNING, BOLAN_LOG_SEA_LIMITED,
                  "the sea is too steep: Hs lowered from %.3g to %.3g m, by Miche's limit 0.142 L tanh(2 pi depth / L) "
                  "at its peak period of %.3g s",
                  asked, s->summary.hs, s->summary.tp);
    }
}

#define NEARLY_ALL 0.01 // of the energy is left

static void say_blocked(const sea_shared *s) {
    bolan_sea_state still = s->desc.sea_state;
    if (still.frame == BOLAN_FRAME_WATER || (still.current_x == 0.0 && still.current_y == 0.0)) return;
    const double current = sqrt(still.current_x * still.current_x + still.current_y * still.current_y);
    still.current_x = still.current_y = 0.0;
    const double given = bolan_sea_state_summary(&still).m0;
    if (!(s->summary.m0 < NEARLY_ALL * given)) return;
    bolan_log(BOLAN_LOG_WARNING, BOLAN_LOG_SEA_BLOCKED,
              "the current of %.3g m/s blocks the waves: %.2g %% of their energy is left", current,
              100.0 * s->summary.m0 / given);
}

// What is kept of the measured spectrum, which need not live on.
static void forget_measured(sea_shared *s) {
    const bolan_measured_spectrum *measured = s->desc.sea_state.measured;
    if (measured) snprintf(s->record_time, sizeof s->record_time, "%s", bolan_measured_spectrum_view(measured).time);
    s->is_measured = measured != NULL;
    s->desc.sea_state.measured = NULL;
}

uint64_t bolan_sea_next_number(void) {
    static atomic_uint_fast64_t last;
    return atomic_fetch_add_explicit(&last, 1, memory_order_relaxed) + 1;
}

// Releases the tables with their last owner. The release order makes what other threads read here happen before.
static void leave(sea_shared *shared) {
    if (atomic_fetch_sub_explicit(&shared->owners, 1, memory_order_acq_rel) > 1) return;
    if (shared->model->destroy) shared->model->destroy(shared);
    release(&shared->memory);
    bolan_release(shared, sizeof *shared);
}

static void set_order(sea_shared *shared, bool aloud) {
    if (shared->desc.order < 2 || shared->model->form == BOLAN_FORM_CASCADES) return;
    shared->desc.order = 1;
    if (aloud)
        bolan_log(BOLAN_LOG_WARNING, BOLAN_LOG_SEA_ORDER,
                  "a sea of %s has no bound waves: its order is 1, not 2; expected the waves fft or textures",
                  bolan_wave_model_names[shared->desc.waves]);
}

// What a sea is before it has any memory.
static void describe(sea_shared *shared, const bolan_sea_desc *desc, bool aloud) {
    shared->desc = *desc;
    shared->model = bolan_sea_model_of(desc->waves);
    shared->period = desc->loop_period;
    shared->slope_ratio = 1.0;
    set_order(shared, aloud);
    set_limit(shared, aloud);
    if (aloud) say_blocked(shared);
}

static spectrum_eval eval_of(const sea_shared *shared) {
    spectrum_eval eval = bolan_spectrum_eval_prepare(&shared->desc.sea_state);
    bolan_spectrum_eval_scale(&eval, shared->limit);
    return eval;
}

static bool create_tables(sea_shared *shared) {
    const spectrum_eval eval = eval_of(shared);
    if (!shared->model->create(shared, &eval)) return false;
    bolan_sea_foam_prepare(shared);
    for (uint32_t i = 0; i < shared->bands; i++) shared->lift += shared->band[i].lift.level[0];
    return bolan_sea_slopes_create(shared);
}

// The tables of a desc that is valid; NULL when memory is short.
static sea_shared *create_shared(const bolan_sea_desc *desc) {
    sea_shared *shared = bolan_sea_borrow(sizeof *shared);
    if (!shared) return NULL;
    atomic_init(&shared->owners, 1);
    shared->id = bolan_sea_next_number();
    describe(shared, desc, true);
    if (create_tables(shared)) return shared;
    leave(shared);
    return NULL;
}

// A sea of these tables, which owns a share of them from now on, also after a failure. Its fields are of no time yet.
static bolan_sea *create_on(sea_shared *shared) {
    bolan_sea *sea = bolan_sea_borrow(sizeof *sea);
    if (!sea) {
        leave(shared);
        return NULL;
    }
    sea->shared = shared;
    sea->made = &sea->own_made;
    if (!shared->model->create_fields(sea)) bolan_sea_destroy(&sea);
    return sea;
}

static bolan_result validate(const bolan_sea_desc *desc) {
    bolan_result result = bolan_params_validate(&bolan_sea_params, desc, "bolan_sea_desc.");
    if (!result) result = bolan_sea_state_validate(&desc->sea_state);
    const bool drifts = desc->sea_state.current_x != 0.0 || desc->sea_state.current_y != 0.0;
    if (result || !drifts || desc->waves != BOLAN_WAVES_FFT || desc->loop_period == 0.0) return result;
    bolan_log(
        BOLAN_LOG_ERROR, BOLAN_LOG_BAD_ARGUMENT,
        "bolan_sea_desc.loop_period is %g and the sea has a current; expected one of the two: tiles that drift do not "
        "come back, the waves of cosines and exp-cosine do",
        desc->loop_period);
    return BOLAN_ERROR_ARGUMENT;
}

bolan_sea_bytes bolan_sea_size(const bolan_sea_desc *desc) {
    BOLAN_ASSERT(desc);
    bolan_sea_bytes bytes = {0, 0};
    if (validate(desc) != BOLAN_OK) return bytes;
    sea_shared shared;
    memset(&shared, 0, sizeof shared);
    describe(&shared, desc, false);
    const spectrum_eval eval = eval_of(&shared);
    bytes.tables = sizeof(sea_shared) + bolan_sea_slopes_bytes();
    bytes.fields = sizeof(bolan_sea);
    shared.model->size(&shared, &eval, &bytes);
    return bytes;
}

bolan_result bolan_sea_create(const bolan_sea_desc *desc, bolan_sea **out) {
    BOLAN_ASSERT(desc && out);
    *out = NULL;
    const bolan_result valid = validate(desc);
    if (valid != BOLAN_OK) return valid;
    sea_shared *shared = create_shared(desc);
    bolan_sea *sea = shared ? create_on(shared) : NULL;
    if (!sea) return BOLAN_ERROR_MEMORY;
    if (!bolan_sea_whitecaps_create(sea)) {
        bolan_sea_destroy(&sea);
        return BOLAN_ERROR_MEMORY;
    }
    forget_measured(shared);
    *out = sea;
    return BOLAN_OK;
}

bolan_result bolan_sea_fork(const bolan_sea *sea, bolan_sea **out) {
    BOLAN_ASSERT(sea && out);
    *out = NULL;
    atomic_fetch_add_explicit(&sea->shared->owners, 1, memory_order_relaxed); // the caller's share keeps them alive
    bolan_sea *fork = create_on(sea->shared);
    if (!fork) return BOLAN_ERROR_MEMORY;
    bolan_sea_step(fork, 0.0);
    *out = fork;
    return BOLAN_OK;
}

void bolan_sea_destroy(bolan_sea **sea) {
    if (!sea || !*sea) return;
    leave((*sea)->shared);
    release(&(*sea)->memory);
    bolan_release(*sea, sizeof **sea);
    *sea = NULL;
}

// ---- reading --------------------------------------------------------------------------------------------------------

double bolan_sea_time(const bolan_sea *sea) {
    BOLAN_ASSERT(sea);
    return sea->time;
}

const bolan_sea_desc *bolan_sea_get_desc(const bolan_sea *sea) {
    BOLAN_ASSERT(sea);
    return &sea->shared->desc;
}

uint64_t bolan_sea_id(const bolan_sea *sea) {
    BOLAN_ASSERT(sea);
    return sea->shared->id;
}

uint64_t bolan_sea_serial(const bolan_sea *sea) {
    BOLAN_ASSERT(sea);
    return sea->serial;
}

const bolan_sea_summary *bolan_sea_get_summary(const bolan_sea *sea) {
    BOLAN_ASSERT(sea);
    return &sea->shared->summary;
}

const char *bolan_sea_record_time(const bolan_sea *sea) {
    BOLAN_ASSERT(sea);
    return sea->shared->record_time;
}

bolan_wave_form bolan_sea_form(const bolan_sea *sea) {
    BOLAN_ASSERT(sea);
    return sea->shared->model->form;
}

bolan_sea_loop bolan_sea_get_loop(const bolan_sea *sea) {
    BOLAN_ASSERT(sea);
    return (bolan_sea_loop){.period = sea->shared->period, .frames = sea->shared->frames, .frame = sea->frame};
}

bolan_dvec2 bolan_sea_place_read(const bolan_sea *sea, double x, double y, double gradient[4]) {
    BOLAN_ASSERT(sea && gradient);
    const bolan_dvec2 drift =
        sea->shared->cascades > 0 ? bolan_sea_drift(sea->shared, sea->time) : (bolan_dvec2){0.0, 0.0};
    return bolan_sea_warped(&sea->shared->warp, x - drift.x, y - drift.y, gradient);
}

bolan_sea_warp bolan_sea_get_warp(const bolan_sea *sea) {
    BOLAN_ASSERT(sea);
    return sea->shared->warp;
}

const bolan_sea_warp *bolan_sea_warp_of(const bolan_sea *sea) { return &sea->shared->warp; }

const sea_band *bolan_sea_bands(const bolan_sea *sea, uint32_t *count) {
    *count = sea->shared->bands;
    return sea->shared->band;
}

uint32_t bolan_sea_cascade_count(const bolan_sea *sea) {
    BOLAN_ASSERT(sea);
    return sea->shared->cascades;
}

bolan_cascade_view bolan_sea_cascade(const bolan_sea *sea, uint32_t index) {
    BOLAN_ASSERT(sea && index < sea->shared->cascades);
    bolan_sea_fields(sea);
    return sea->shared->model->cascade(sea, index);
}

bolan_cascade_view bolan_sea_cascade_layout(const bolan_sea *sea, uint32_t index) {
    BOLAN_ASSERT(sea && index < sea->shared->cascades);
    bolan_cascade_view v = sea->shared->model->cascade(sea, index);
    v.displacement = NULL;
    v.slope_x = v.slope_y = v.dxx = v.dyy = v.foam = NULL;
    v.displacement_half = v.slope_half = v.foam_half = NULL;
    return v;
}

uint32_t bolan_sea_component_count(const bolan_sea *sea) {
    BOLAN_ASSERT(sea);
    return sea->shared->components;
}

bolan_sea_component bolan_sea_get_component(const bolan_sea *sea, uint32_t index) {
    BOLAN_ASSERT(sea && index < sea->shared->components);
    return sea->shared->model->component(sea->shared, index);
}

void bolan_sea_bounds(const bolan_sea *sea, double *vertical, double *horizontal) {
    BOLAN_ASSERT(sea && vertical && horizontal);
    sea->shared->model->bounds(sea->shared, vertical, horizontal);
}

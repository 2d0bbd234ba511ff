// SPDX-License-Identifier: MIT
// A sea from creation to destruction, and its step through time.
#include "spectrum/portable.h"
#include "waves/sum.h"
#include "waves/synth.h"

#include <sched.h>
#include <stdatomic.h>
#include <stdio.h>
#include <string.h>

#define LONGEST_TICK 0.5    // [s] a step forward that the foam memory survives
#define SETTLE_TICK 0.25    // [s]
#define SAMPLE_BYTES 54.0   // 9 planes of float, 9 of half
#define LARGE_OUTPUT 1e7    // [bytes] all planes: more than second-level caches hold
#define HUGE_OUTPUT 4e7     // [bytes] more than third-level caches hold for one process
#define LARGEST_TIME 0x1p36 // [s]: 2000 years; beyond, phases would lose their meaning in double

const char *const bolan_wave_model_names[BOLAN_WAVE_MODELS + 1] = {"fft", "cosines", "exp-cosine", "textures", NULL};

bolan_sea_desc bolan_sea_desc_default(void) {
    bolan_sea_desc desc;
    memset(&desc, 0, sizeof desc); // the padding too: equal descs are equal bytes
    bolan_params_default(&bolan_sea_params, &desc);
    desc.sea_state = bolan_sea_state_from_wind(8.0, 240.0, 200e3);
    return desc;
}

void *bolan_sea_borrow(size_t bytes) {
    void *memory = bolan_allocate(bytes);
    if (!memory)
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY, "no memory for a sea: %zu bytes were refused", bytes);
    return memory;
}

void *bolan_sea_reserve(bolan_sea *sea, size_t bytes) {
    BOLAN_ASSERT(sea->block_count < SEA_MAX_BLOCKS);
    void *memory = bolan_sea_borrow(bytes);
    if (memory) sea->block[sea->block_count++] = (sea_block){memory, bytes};
    return memory;
}

// Everything that needs memory. A worker that a later bolan_set_threads() adds finds no scratch and stays idle.
static bool build(bolan_sea *sea) {
    spectrum_eval eval = bolan_spectrum_eval_prepare(&sea->desc.sea_state);
    bolan_spectrum_eval_scale(&eval, sea->limit);
    if (sea->desc.waves == BOLAN_WAVES_COSINES || sea->desc.waves == BOLAN_WAVES_EXP_COSINE)
        return bolan_sea_sum_create(sea, &eval) && bolan_sea_lift_create(sea) && bolan_sea_slopes_create(sea) &&
               bolan_sea_whitecaps_create(sea);
    double up, cross;
    bolan_cox_munk(sea->desc.sea_state.wind_speed, &up, &cross);
    sea_radial radial;
    bolan_sea_radial_prepare(&eval, bolan_sea_wind_peak(&sea->desc.sea_state, &sea->summary), up + cross, &radial);
    bolan_sea_layout(sea, &radial);
    sea->slots = bolan_threads();
    sea->scratch_floats = SEA_SCRATCH_BUFFERS * sea_scratch_pitch(sea->desc.resolution);
    sea->scratch = bolan_sea_reserve(sea, sea->slots * sea->scratch_floats * sizeof(float));
    return sea->scratch && bolan_fft_plan_create(sea->desc.resolution, &sea->plan) &&
           bolan_sea_modes_create(sea, &eval, &radial) && bolan_sea_lift_create(sea) && bolan_sea_slopes_create(sea) &&
           bolan_sea_whitecaps_create(sea);
}

// Sets the summary, and the factor that brings the waves down to what their depth carries.
static void set_limit(bolan_sea *sea) {
    const bolan_sea_limit limit = bolan_sea_state_limit(&sea->desc.sea_state);
    sea->summary = bolan_sea_state_summary(&sea->desc.sea_state);
    const double asked = sea->summary.hs;
    sea->limit = fmin(limit.by_depth, limit.by_steepness);
    if (sea->limit == 1.0) return;
    sea->summary.hs *= sea->limit;
    sea->summary.m0 *= sea->limit * sea->limit;
    if (limit.by_depth <= limit.by_steepness) {
        bolan_log(BOLAN_LOG_WARNING, BOLAN_LOG_SEA_LIMITED,
                  "the sea is too high for its depth of %.4g m: Hs lowered from %.3g to %.3g m, 0.6 of the depth",
                  sea->desc.sea_state.depth, asked, sea->summary.hs);
    } else {
        bolan_log(BOLAN_LOG_WARNING, BOLAN_LOG_SEA_LIMITED,
                  "the sea is too steep: Hs lowered from %.3g to %.3g m, by Miche's limit 0.142 L tanh(2 pi depth / L) "
                  "at its peak period of %.3g s",
                  asked, sea->summary.hs, sea->summary.tp);
    }
}

// What is kept of the measured spectrum, which need not live on.
static void forget_measured(bolan_sea *sea) {
    const bolan_measured_spectrum *measured = sea->desc.sea_state.measured;
    if (measured)
        snprintf(sea->record_time, sizeof sea->record_time, "%s", bolan_measured_spectrum_view(measured).time);
    sea->is_measured = measured != NULL;
    sea->desc.sea_state.measured = NULL;
}

// Numbers of seas and of their fields, one row for both: never 0, never twice.
static uint64_t next_number(void) {
    static atomic_uint_fast64_t last;
    return atomic_fetch_add_explicit(&last, 1, memory_order_relaxed) + 1;
}

static bolan_result validate(const bolan_sea_desc *desc) {
    const bolan_result result = bolan_params_validate(&bolan_sea_params, desc, "bolan_sea_desc.");
    return result ? result : bolan_sea_state_validate(&desc->sea_state);
}

bolan_result bolan_sea_create(const bolan_sea_desc *desc, bolan_sea **out) {
    BOLAN_ASSERT(desc && out);
    *out = NULL;
    const bolan_result valid = validate(desc);
    if (valid != BOLAN_OK) return valid;
    bolan_sea *sea = bolan_sea_borrow(sizeof *sea);
    if (!sea) return BOLAN_ERROR_MEMORY;
    sea->desc = *desc;
    sea->id = next_number();
    sea->kernels = bolan_sea_kernels_for(desc->cpu);
    set_limit(sea);
    if (!build(sea)) {
        bolan_sea_destroy(&sea);
        return BOLAN_ERROR_MEMORY;
    }
    forget_measured(sea);
    *out = sea;
    return BOLAN_OK;
}

void bolan_sea_destroy(bolan_sea **sea) {
    if (!sea || !*sea) return;
    for (uint32_t i = 0; i < (*sea)->block_count; i++) bolan_release((*sea)->block[i].memory, (*sea)->block[i].bytes);
    bolan_fft_plan_destroy(&(*sea)->plan);
    bolan_release(*sea, sizeof **sea);
    *sea = NULL;
}

// ---- stepping -------------------------------------------------------------------------------------------------------

// A step is one queue of strips: the rows of a cascade, then its columns while what lies between them is still in the
// cache. Columns wait until the rows of their cascade are done. All rows were taken from the queue before, and
// whoever took them waits for nothing later, so the queue cannot lock up, however few workers there are.
typedef struct step {
    bolan_sea *sea;
    sea_moment moment;
    atomic_uint next; // item of the queue
    atomic_uint rows_done[BOLAN_MAX_CASCADES];
} step;

static void do_rows(step *s, uint32_t index, uint32_t strip, float *scratch) {
    s->sea->kernels->rows(&s->sea->plan, &s->sea->cascade[index], &s->moment, strip, scratch);
    atomic_fetch_add_explicit(&s->rows_done[index], 1, memory_order_release);
}

static void do_columns(step *s, uint32_t index, uint32_t strip, float *scratch) {
    const sea_cascade *c = &s->sea->cascade[index];
    while (atomic_load_explicit(&s->rows_done[index], memory_order_acquire) < c->strips) sched_yield();
    s->sea->kernels->columns(&s->sea->plan, c, &s->moment, strip, scratch);
}

// False when the queue is empty.
static bool do_next_item(step *s, float *scratch) {
    uint32_t item = atomic_fetch_add_explicit(&s->next, 1, memory_order_relaxed);
    for (uint32_t i = 0; i < s->sea->count; i++) {
        const sea_cascade *c = &s->sea->cascade[i];
        const uint32_t rows = c->strips, columns = c->n / FFT_LANES;
        if (item < rows) {
            do_rows(s, i, item, scratch);
            return true;
        }
        if (item < rows + columns) {
            do_columns(s, i, item - rows, scratch);
            return true;
        }
        item -= rows + columns;
    }
    return false;
}

// Task: slots [begin, end). Each slot owns scratch memory; a slice of several uses that of its first.
static void run_slots(void *context, uint32_t begin, uint32_t end, uint32_t worker) {
    (void)end;
    (void)worker;
    step *s = context;
    while (do_next_item(s, s->sea->scratch + begin * s->sea->scratch_floats)) {}
}

double bolan_sea_period(const bolan_sea *sea) {
    return sea->desc.waves == BOLAN_WAVES_TEXTURES ? sea->desc.textures.period : sea->desc.loop_period;
}

double bolan_sea_shown_time(const bolan_sea *sea, double time, uint32_t *frame) {
    const double period = bolan_sea_period(sea), frames = sea->desc.textures.frames;
    if (frame) *frame = 0;
    if (sea->desc.waves != BOLAN_WAVES_TEXTURES) return fmod(time, period > 0.0 ? period : LARGEST_TIME);
    const double loops = time / period, on = fmin(floor((loops - floor(loops)) * frames), frames - 1.0);
    if (frame) *frame = (uint32_t)on;
    return on * period / frames;
}

static void synthesise(bolan_sea *sea, double time, float decay) {
    step s = {.sea = sea};
    s.moment.time = bolan_sea_shown_time(sea, time, &sea->loop_frame);
    s.moment.decay = decay;
    s.moment.choppiness = (float)sea->desc.choppiness;
    const double bytes = SAMPLE_BYTES * sea->count * sea->plan.n * sea->plan.n;
    s.moment.stream = bytes > HUGE_OUTPUT ? SEA_STREAM_ALL : bytes > LARGE_OUTPUT ? SEA_STREAM_PLANES : SEA_STREAM_NONE;
    bolan_parallel(sea->slots, 1, run_slots, &s);
}

void bolan_sea_step(bolan_sea *sea, double time) {
    BOLAN_ASSERT(sea && isfinite(time));
    const double dt = time - sea->time;
    const bool continues = sea->foam_holds && dt >= 0.0 && dt <= LONGEST_TICK;
    if (continues && dt == 0.0) return; // the same fields, and a foam memory that has not aged
    if (sea->sum) {
        bolan_sea_sum_step(sea, bolan_sea_shown_time(sea, time, NULL));
    } else {
        synthesise(sea, time, continues ? (float)portable_exp(-dt / sea->desc.foam_decay) : 0.0f);
    }
    sea->time = time;
    sea->foam_holds = true;
    sea->serial = next_number();
}

void bolan_sea_settle(bolan_sea *sea, double time) {
    BOLAN_ASSERT(sea && isfinite(time));
    const double first = floor((time - 4.0 * sea->desc.foam_decay) / SETTLE_TICK);
    sea->foam_holds = false;
    for (double tick = first; tick * SETTLE_TICK < time && !sea->sum; tick += 1.0) {
        bolan_sea_step(sea, tick * SETTLE_TICK);
        if (tick + 1.0 == tick) break; // a time so large that ticks cannot be told apart
    }
    bolan_sea_step(sea, time);
}

void bolan_sea_each_wave(const bolan_sea *sea, void (*visit)(void *context, const sea_mode *mode), void *context) {
    if (sea->sum) bolan_sea_sum_each(sea->sum, visit, context);
    for (uint32_t i = 0; i < sea->count; i++) bolan_sea_each_mode(&sea->cascade[i], visit, context);
}

// ---- reading --------------------------------------------------------------------------------------------------------

double bolan_sea_time(const bolan_sea *sea) {
    BOLAN_ASSERT(sea);
    return sea->time;
}

const bolan_sea_desc *bolan_sea_get_desc(const bolan_sea *sea) {
    BOLAN_ASSERT(sea);
    return &sea->desc;
}

uint64_t bolan_sea_id(const bolan_sea *sea) {
    BOLAN_ASSERT(sea);
    return sea->id;
}

uint64_t bolan_sea_serial(const bolan_sea *sea) {
    BOLAN_ASSERT(sea);
    return sea->serial;
}

const bolan_sea_summary *bolan_sea_get_summary(const bolan_sea *sea) {
    BOLAN_ASSERT(sea);
    return &sea->summary;
}

const char *bolan_sea_record_time(const bolan_sea *sea) {
    BOLAN_ASSERT(sea);
    return sea->record_time;
}

uint32_t bolan_sea_cascade_count(const bolan_sea *sea) {
    BOLAN_ASSERT(sea);
    return sea->count;
}

bolan_cascade_view bolan_sea_cascade(const bolan_sea *sea, uint32_t index) {
    BOLAN_ASSERT(sea && index < sea->count);
    const sea_cascade *c = &sea->cascade[index];
    return (bolan_cascade_view){.n = c->n,
                                .length = c->length,
                                .angle = c->angle,
                                .k_min = c->k_min,
                                .k_max = c->k_max,
                                .variance = c->variance,
                                .mss = c->slope[0] + c->slope[2],
                                .height = c->field[FIELD_HEIGHT],
                                .dx = c->field[FIELD_DX],
                                .dy = c->field[FIELD_DY],
                                .slope_x = c->field[FIELD_SLOPE_X],
                                .slope_y = c->field[FIELD_SLOPE_Y],
                                .dxx = c->field[FIELD_DXX],
                                .dyy = c->field[FIELD_DYY],
                                .dxy = c->field[FIELD_DXY],
                                .foam = c->foam,
                                .displacement_half = c->displacement_half,
                                .slope_half = c->slope_half,
                                .foam_half = c->foam_half};
}

uint32_t bolan_sea_component_count(const bolan_sea *sea) {
    BOLAN_ASSERT(sea);
    return sea->sum ? sea->sum->tables.count : 0;
}

bolan_sea_component bolan_sea_get_component(const bolan_sea *sea, uint32_t index) {
    BOLAN_ASSERT(sea && index < bolan_sea_component_count(sea));
    return sea->sum->component[index];
}

uint32_t bolan_sea_loop_frame(const bolan_sea *sea) {
    BOLAN_ASSERT(sea);
    return sea->loop_frame;
}

// The sum of few waves may not even reach 6 standard deviations.
static void sum_bounds(const sea_sum *sum, double choppiness, double *vertical, double *horizontal) {
    *vertical = fmin(6.0 * sqrt(sum->total), sum->highest) + sum->lift.level[0];
    *horizontal = fmin(6.0 * sqrt(sum->displacement), sum->farthest) * choppiness;
}

void bolan_sea_bounds(const bolan_sea *sea, double *vertical, double *horizontal) {
    BOLAN_ASSERT(sea && vertical && horizontal);
    if (sea->sum) {
        sum_bounds(sea->sum, sea->desc.choppiness, vertical, horizontal);
        return;
    }
    double variance = 0.0, displacement = 0.0;
    for (uint32_t i = 0; i < sea->count; i++) {
        variance += sea->cascade[i].variance;
        displacement += sea->cascade[i].displacement;
    }
    *vertical = 6.0 * sqrt(variance) + sea->lift;
    *horizontal = 6.0 * sqrt(displacement) * sea->desc.choppiness;
}

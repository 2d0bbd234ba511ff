// SPDX-License-Identifier: MIT
// Steps through time, and the memory of foam.
//
//     ticks     k-W ......... k-2    k-1     k        a tick every 0.25 s, at the same times whatever the steps
//     foam_tick  present pinch of each tick, fading   F(k) = max(keep F(k-1) - lose, pinch(k)), pinch <= SEA_MOST_FOAM
//     foam                                    | t     F(k) faded by t - k, or the pinch at t where it is more
//
// `lose` is so large that nothing is left of SEA_MOST_FOAM after W ticks, about 5 foam_decay. All of this is monotone,
// so F(k) is the largest of what the last W + 1 ticks have left, bit for bit, and it does not matter where a run began:
// foam is a function of time, as the waves are. With a loop the ticks divide its period.
//
// Foam drifts with the wind over the water. Its memory is kept over places that drift with it: sample x of F(k) is
// pinched by the water at x + drift(k), by a turn of the modes, which is exact. So nothing is resampled from tick to
// tick, and a long memory is as sharp as a short one. Readers find it resampled once, where it lies at present.
//
// A jump in time forgets, so the foam is a function of the tick of the last jump too: `foam_from`. A settled sea has
// one so long ago that it no longer matters. The fields are made from these two ticks when they are read (sea.h).
#include "shared/foam.glsl"
#include "spectrum/portable.h"
#include "waves/model.h"

#include <sched.h>

#define TICK 0.25           // [s] about; with a loop the nearest part of it
#define MEMORY 5.0          // [foam_decay]
#define TIME_GRID 0x1p-20   // [s] of the time in a loop, so that a time and the same one a loop later have equal bits
#define LARGEST_TIME 0x1p36 // [s]: 2000 years; beyond, phases would lose their meaning in double
enum { MOST_TICKS = 5 };    // in a step, that the foam memory survives: 1 s

void bolan_sea_foam_prepare(sea_shared *shared) {
    const double period = shared->period;
    shared->loop_ticks = period > 0.0 ? fmax(floor(period / TICK + 0.5), 1.0) : 0.0;
    shared->tick = period > 0.0 ? period / shared->loop_ticks : TICK;
    shared->memory_ticks = ceil(MEMORY * shared->desc.foam_decay / shared->tick);
    const double keep = portable_exp(-shared->tick / shared->desc.foam_decay);
    const double left = portable_exp(-shared->memory_ticks * shared->tick / shared->desc.foam_decay);
    shared->tick_loss = 1.001 * (double)SEA_MOST_FOAM * left * (1.0 - keep) / (1.0 - left);
}

double bolan_sea_reduced_time(const sea_shared *shared, double time, uint32_t *frame) {
    if (frame) *frame = 0;
    if (!(shared->period > 0.0)) return fmod(time, LARGEST_TIME);
    const double left = fmod(time, shared->period), in = left < 0.0 ? left + shared->period : left;
    const double reduced = floor(in / TIME_GRID + 0.5) * TIME_GRID;
    return reduced < shared->period ? reduced : 0.0;
}

bolan_dvec2 bolan_sea_drift(const sea_shared *shared, double time) {
    const double t = fmod(time, LARGEST_TIME);
    return (bolan_dvec2){shared->desc.sea_state.current_x * t, shared->desc.sea_state.current_y * t};
}

// Where a time stands among the ticks.
typedef struct place_in_time {
    double tick;  // the number of the last one
    double since; // and how long ago it was [s]
} place_in_time;

static place_in_time place_of(const sea_shared *shared, double time) {
    const double reduced = bolan_sea_reduced_time(shared, time, NULL), tick = floor(reduced / shared->tick);
    const double loops = shared->period > 0.0 ? floor((time - reduced) / shared->period + 0.5) : 0.0;
    return (place_in_time){loops * shared->loop_ticks + tick, fmax(reduced - tick * shared->tick, 0.0)};
}

static double time_of(const sea_shared *shared, double tick) {
    const double in = shared->loop_ticks > 0.0 ? fmod(tick, shared->loop_ticks) : tick;
    return (in < 0.0 ? in + shared->loop_ticks : in) * shared->tick;
}

// Tiles of that length that a speed passes in a second; with a loop, whole ones in the loop.
static double tiles_in_second(const sea_shared *shared, double speed, double length) {
    const double period = shared->period;
    return period > 0.0 ? floor(speed * period / length + 0.5) / period : speed / length;
}

void bolan_sea_foam_drift(const bolan_sea *sea, uint32_t cascade, double tick, uint32_t out[2]) {
    BOLAN_ASSERT(sea && cascade < sea->shared->cascades && isfinite(tick));
    const sea_shared *shared = sea->shared;
    const bolan_cascade_view v = shared->model->cascade(sea, cascade);
    const bolan_sea_state *state = &shared->desc.sea_state;
    double along[2]; // cosine and sine of the wind's angle in the axes of the tile
    bolan_sincos(bolan_compass_from_to_math(state->wind_from_deg) - v.angle, &along[1], &along[0]);
    for (int e = 0; e < 2; e++) {
        const double speed = FOAM_DRIFT * state->wind_speed * along[e];
        const double tiles = time_of(shared, tick) * tiles_in_second(shared, speed, v.length);
        out[e] = (uint32_t)(uint64_t)((tiles - floor(tiles)) * 0x1p32);
    }
}

// `at`: number of the tick, or between two; `since`: of the foam memory that it goes on with [s].
static sea_instant instant_of(const bolan_sea *sea, double shown, double at, double since, bool tick) {
    const sea_shared *shared = sea->shared;
    const double keep = portable_exp(-since / shared->desc.foam_decay);
    return (sea_instant){.shown = shown,
                         .tick = tick,
                         .keep = sea->made->empty ? 0.0f : (float)keep,
                         .lose = (float)(shared->tick_loss * (since / shared->tick)),
                         .at = at};
}

double bolan_sea_tick_time(const bolan_sea *sea, double tick) {
    BOLAN_ASSERT(sea && isfinite(tick));
    return sea->shared->model->shown_time(sea->shared, time_of(sea->shared, tick), NULL);
}

static void do_tick(const bolan_sea *sea) {
    sea->made->tick += 1.0;
    const double tick = sea->made->tick;
    const sea_instant instant = instant_of(sea, bolan_sea_tick_time(sea, tick), tick, sea->shared->tick, true);
    sea->shared->model->step(sea, &instant);
    sea->made->empty = false;
}

static double now_of(const bolan_sea *sea) { return sea->tick + sea->since / sea->shared->tick; }

// The earliest tick after which something of the foam at `time` may come from.
static double first_tick(const bolan_sea *sea) {
    return fmax(sea->foam_from, sea->tick - sea->shared->memory_ticks - 1.0);
}

// The foam memory of the last tick: what the fields hold goes on where it is of the same beginning.
static void remember(const bolan_sea *sea) {
    sea_made *m = sea->made;
    const double first = first_tick(sea);
    if (!(m->any && m->from == sea->foam_from && m->tick >= first && m->tick <= sea->tick)) {
        m->tick = first;
        m->empty = true;
    }
    m->any = true;
    m->from = sea->foam_from;
    while (m->tick < sea->tick) do_tick(sea);
}

// True: the caller makes what is stale, and then says that it is fresh. False: it is fresh.
static bool begin_making(atomic_uint *state) {
    if (atomic_load_explicit(state, memory_order_acquire) == SEA_FRESH) return false;
    unsigned expected = SEA_STALE;
    if (atomic_compare_exchange_strong_explicit(state, &expected, SEA_MAKING, memory_order_acquire,
                                                memory_order_acquire))
        return true;
    while (atomic_load_explicit(state, memory_order_acquire) != SEA_FRESH) sched_yield();
    return false;
}

bolan_sea_fine_view bolan_sea_fine_layout(const bolan_sea *sea) {
    BOLAN_ASSERT(sea);
    bolan_sea_fine_view v = {.n = 0};
    if (sea->shared->model->fine) v = sea->shared->model->fine(sea);
    v.slope_x = v.slope_y = NULL;
    v.slope_half = NULL;
    return v;
}

bolan_sea_fine_view bolan_sea_fine(const bolan_sea *sea) {
    BOLAN_ASSERT(sea);
    const struct sea_model *model = sea->shared->model;
    if (!model->fine) return (bolan_sea_fine_view){.n = 0};
    if (begin_making(&sea->made->fine)) {
        model->step_fine(sea);
        atomic_store_explicit(&sea->made->fine, SEA_FRESH, memory_order_release);
    }
    return model->fine(sea);
}

void bolan_sea_fields(const bolan_sea *sea) {
    BOLAN_ASSERT(sea);
    sea_made *m = sea->made;
    if (!begin_making(&m->state)) return;
    if (sea->shared->model->remembers) remember(sea);
    const sea_instant instant = instant_of(sea, sea->shown, now_of(sea), sea->since, false);
    sea->shared->model->step(sea, &instant);
    atomic_store_explicit(&m->state, SEA_FRESH, memory_order_release);
}

static void move_to(bolan_sea *sea, double time, place_in_time at) {
    sea->tick = at.tick;
    sea->since = at.since;
    sea->shown = sea->shared->model->shown_time(sea->shared, time, &sea->frame);
    sea->time = time;
    sea->stepped = true;
    sea->serial = bolan_sea_next_number();
    atomic_store_explicit(&sea->made->state, SEA_STALE, memory_order_relaxed);
    atomic_store_explicit(&sea->made->fine, SEA_STALE, memory_order_relaxed);
}

void bolan_sea_step(bolan_sea *sea, double time) {
    BOLAN_ASSERT(sea && isfinite(time));
    if (sea->stepped && time == sea->time) return;
    const place_in_time at = place_of(sea->shared, time);
    const double ticks = at.tick - sea->tick;
    if (!(sea->stepped && ticks >= 0.0 && ticks <= MOST_TICKS)) sea->foam_from = at.tick;
    move_to(sea, time, at);
}

void bolan_sea_settle(bolan_sea *sea, double time) {
    BOLAN_ASSERT(sea && isfinite(time));
    const place_in_time at = place_of(sea->shared, time);
    sea->foam_from = at.tick - sea->shared->memory_ticks - 1.0;
    move_to(sea, time, at);
}

bolan_sea_clock bolan_sea_get_clock(const bolan_sea *sea) {
    BOLAN_ASSERT(sea);
    const sea_shared *shared = sea->shared;
    return (bolan_sea_clock){.shown = sea->shown,
                             .tick = sea->tick,
                             .now = now_of(sea),
                             .first_tick = first_tick(sea),
                             .foam_from = sea->foam_from,
                             .keep = (float)portable_exp(-sea->since / shared->desc.foam_decay),
                             .lose = (float)(shared->tick_loss * (sea->since / shared->tick)),
                             .tick_keep = (float)portable_exp(-shared->tick / shared->desc.foam_decay),
                             .tick_lose = (float)shared->tick_loss};
}

// SPDX-License-Identifier: MIT
// A step of a sea of cascades: the schedule of its strips. cascades.h has the plan of a strip.
#include "waves/cascades/synth.h"

#include <sched.h>
#include <stdatomic.h>

#define SAMPLE_BYTES 54.0 // 9 planes of float, 9 of half
#define LARGE_OUTPUT 1e7  // [bytes] all planes: more than second-level caches hold
#define HUGE_OUTPUT 4e7   // [bytes] more than third-level caches hold for one process

// A step is one queue of strips: the rows of a cascade, then its columns while the intermediate data are still in the
// cache. Columns wait until the rows of their cascade are done. All rows were taken from the queue before, and a worker
// on rows never waits, so the queue cannot deadlock with any number of workers.
typedef struct step {
    const cascade_tables *tables;
    const cascade_fields *fields;
    uint32_t cascades;
    sea_moment moment;
    atomic_uint next; // item of the queue
    atomic_uint rows_done[BOLAN_MAX_CASCADES];
} step;

static void do_rows(step *s, uint32_t index, uint32_t strip, float *scratch) {
    s->tables->kernels->rows(&s->tables->plan, &s->tables->cascade[index], s->fields->planes[index].middle, &s->moment,
                             strip, scratch);
    atomic_fetch_add_explicit(&s->rows_done[index], 1, memory_order_release);
}

static void do_columns(step *s, uint32_t index, uint32_t strip, float *scratch) {
    const sea_cascade *c = &s->tables->cascade[index];
    while (atomic_load_explicit(&s->rows_done[index], memory_order_acquire) < c->strips) sched_yield();
    s->tables->kernels->columns(&s->tables->plan, c, &s->fields->planes[index], &s->moment, strip, scratch);
}

// False when the queue is empty.
static bool do_next_item(step *s, float *scratch) {
    uint32_t item = atomic_fetch_add_explicit(&s->next, 1, memory_order_relaxed);
    for (uint32_t i = 0; i < s->cascades; i++) {
        const sea_cascade *c = &s->tables->cascade[i];
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
    while (do_next_item(s, s->fields->scratch + begin * s->fields->scratch_floats)) {}
}

void bolan_cascades_step(bolan_sea *sea, const sea_instant *instant) {
    step s = {cascade_tables_of(sea->shared), cascade_fields_of(sea), sea->shared->cascades, .moment.at = *instant};
    s.moment.choppiness = (float)sea->shared->desc.choppiness;
    const double bytes = SAMPLE_BYTES * s.cascades * s.tables->plan.n * s.tables->plan.n;
    s.moment.stream = bytes > HUGE_OUTPUT ? SEA_STREAM_ALL : bytes > LARGE_OUTPUT ? SEA_STREAM_PLANES : SEA_STREAM_NONE;
    bolan_parallel(s.fields->slots, 1, run_slots, &s);
}

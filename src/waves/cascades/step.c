// SPDX-License-Identifier: MIT
// A step of a sea of cascades: the schedule of its strips and blocks. cascades.h has the plan of both.
#include "waves/cascades/synth.h"

#include <sched.h>
#include <stdatomic.h>

#define SAMPLE_BYTES 54.0 // 9 planes of float, 9 of half
#define LARGE_OUTPUT \
    1e7 // [bytes] all planes: more than second-level caches hold, and soon more than their share of a third

// Each cascade goes through phases: the columns of a half, strip by strip, and its rows, block by block. A worker stays
// with a cascade while there is work on it, so that the intermediate data remain in its own cache, and then helps with
// the next. A phase waits until all items of the one before are done. All of them were taken by then, and a worker that
// has an item never waits, so there is no deadlock with any number of workers.
typedef struct phase {
    atomic_uint next, done; // items
} phase;

typedef struct step {
    const cascade_tables *tables;
    const cascade_fields *fields;
    uint32_t cascades;
    sea_moment moment[BOLAN_MAX_CASCADES];
    phase columns[BOLAN_MAX_CASCADES][SEA_HALVES], rows[BOLAN_MAX_CASCADES][SEA_HALVES];
} step;

// False when no item of the `count` is left.
static bool take(phase *p, uint32_t count, uint32_t *item) {
    *item = atomic_fetch_add_explicit(&p->next, 1, memory_order_relaxed);
    return *item < count;
}
static void finish(phase *p) { atomic_fetch_add_explicit(&p->done, 1, memory_order_release); }
static void wait_for(phase *p, uint32_t count) {
    while (atomic_load_explicit(&p->done, memory_order_acquire) < count) sched_yield();
}

static void work_on(step *s, uint32_t index, float *scratch) {
    const cascade_tables *t = s->tables;
    const sea_cascade *c = &t->cascade[index];
    const sea_planes *planes = &s->fields->planes[index];
    const sea_moment *moment = &s->moment[index];
    const uint32_t blocks = c->n / SEA_ROWS;
    uint32_t item;
    for (sea_half half = moment->at.tick ? SEA_SLOPES : SEA_DISPLACEMENT; half < SEA_HALVES; half++) {
        phase *columns = &s->columns[index][half], *rows = &s->rows[index][half];
        while (take(columns, c->strips, &item)) {
            t->kernels->columns(&t->columns, c, planes, moment, half, item, scratch);
            finish(columns);
        }
        wait_for(columns, c->strips);
        while (take(rows, blocks, &item)) {
            t->kernels->rows(t, c, planes, moment, half, item, scratch);
            finish(rows);
        }
        if (half == SEA_DISPLACEMENT) wait_for(rows, blocks);
    }
}

// Task: slots [begin, end). Each slot owns scratch memory; a slice of several uses that of its first.
static void run_slots(void *context, uint32_t begin, uint32_t end, uint32_t worker) {
    (void)end;
    (void)worker;
    step *s = context;
    const uint32_t first = begin * s->cascades / s->fields->slots;
    for (uint32_t i = 0; i < s->cascades; i++)
        work_on(s, (first + i) % s->cascades, s->fields->scratch + begin * s->fields->scratch_floats);
}

void bolan_cascades_step(const bolan_sea *sea, const sea_instant *instant) {
    step s = {cascade_tables_of(sea->shared), cascade_fields_of(sea), sea->shared->cascades,
              .moment = {{.alone = false}}};
    const double bytes = SAMPLE_BYTES * s.cascades * s.tables->columns.n * s.tables->columns.n;
    for (uint32_t i = 0; i < s.cascades; i++) {
        s.moment[i] = (sea_moment){
            .at = *instant, .choppiness = (float)sea->shared->desc.choppiness, .stream = bytes > LARGE_OUTPUT};
        bolan_sea_foam_drift(sea, i, instant->at, s.moment[i].drift);
    }
    bolan_parallel(s.fields->slots, 1, run_slots, &s);
}

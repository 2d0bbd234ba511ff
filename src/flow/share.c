// SPDX-License-Identifier: MIT
// Work of a step, shared among threads: each takes the next item and has scratch memory of its own.
#include "flow/tables.h"

#include <stdatomic.h>

typedef struct shared_work {
    atomic_uint next;
    uint32_t items;
    float *scratch;
    size_t floats;
    flow_work *work;
    void *context;
} shared_work;

// Task: slots [begin, end), of one slot.
static void run_slots(void *context, uint32_t begin, uint32_t end, uint32_t worker) {
    (void)end, (void)worker;
    shared_work *s = context;
    for (;;) {
        const uint32_t item = atomic_fetch_add_explicit(&s->next, 1, memory_order_relaxed);
        if (item >= s->items) return;
        s->work(s->context, item, s->scratch + begin * s->floats);
    }
}

void bolan_flow_share(const bolan_flow *flow, uint32_t items, float *scratch, size_t floats, flow_work *work,
                      void *context) {
    shared_work s = {.items = items, .scratch = scratch, .floats = floats, .work = work, .context = context};
    atomic_init(&s.next, 0);
    bolan_parallel(flow->slots, 1, run_slots, &s);
}

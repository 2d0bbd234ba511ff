// SPDX-License-Identifier: MIT
// Parallel loops: every item once, worker numbers, nesting, concurrent callers, and a foreign task system.
#include "support.h"

#include "bolan/base.h"

#include <pthread.h>
#include <stdatomic.h>
#include <time.h>

enum { MAX_ITEMS = 100000, MAX_WORKERS = 64 };

typedef struct tally {
    atomic_int visits[MAX_ITEMS];
    atomic_int busy[MAX_WORKERS]; // slices in progress with this worker number
    atomic_int clashes;           // two at once with the same number
    atomic_int high_worker;
    uint32_t grain, count;
    atomic_int thin_slices; // shorter than the grain, other than the last
} tally;

static tally t;

static void count_visits(void *context, uint32_t begin, uint32_t end, uint32_t worker) {
    tally *a = context;
    if (atomic_fetch_add(&a->busy[worker], 1) != 0) atomic_fetch_add(&a->clashes, 1);
    if (end - begin < a->grain && end != a->count) atomic_fetch_add(&a->thin_slices, 1);
    int high = atomic_load(&a->high_worker);
    while ((int)worker > high && !atomic_compare_exchange_weak(&a->high_worker, &high, (int)worker)) {}
    for (uint32_t i = begin; i < end; i++) atomic_fetch_add_explicit(&a->visits[i], 1, memory_order_relaxed);
    atomic_fetch_sub(&a->busy[worker], 1);
}

static void reset(uint32_t count, uint32_t grain) {
    for (uint32_t i = 0; i < MAX_ITEMS; i++) atomic_store_explicit(&t.visits[i], 0, memory_order_relaxed);
    atomic_store(&t.high_worker, 0);
    t.count = count;
    t.grain = grain;
}

static void assert_each_once(uint32_t count, int times) {
    for (uint32_t i = 0; i < MAX_ITEMS; i++) assert_int_equal(atomic_load(&t.visits[i]), i < count ? times : 0);
    assert_int_equal(atomic_load(&t.clashes), 0);
    assert_int_equal(atomic_load(&t.thin_slices), 0);
    assert_true((uint32_t)atomic_load(&t.high_worker) < bolan_threads());
}

static void every_item_is_done_once(void **state) {
    (void)state;
    static const uint32_t threads[] = {1, 2, 3, 8}, counts[] = {1, 2, 7, 1000, MAX_ITEMS}, grains[] = {0, 1, 64, 5000};
    for (size_t i = 0; i < 4; i++) {
        bolan_set_threads(threads[i]);
        assert_int_equal(bolan_threads(), threads[i]);
        for (size_t c = 0; c < 5; c++) {
            for (size_t g = 0; g < 4; g++) {
                reset(counts[c], grains[g]);
                bolan_parallel(counts[c], grains[g], count_visits, &t);
                assert_each_once(counts[c], 1);
            }
        }
    }
    bolan_set_threads(1);
}

static void many_short_loops_in_a_row_lose_nothing(void **state) {
    (void)state;
    enum { LOOPS = 20000, ITEMS = 16 };
    bolan_set_threads(4);
    reset(ITEMS, 1);
    for (int i = 0; i < LOOPS; i++) bolan_parallel(ITEMS, 1, count_visits, &t);
    assert_each_once(ITEMS, LOOPS);
    bolan_set_threads(1);
}

static void dawdle(void *context, uint32_t begin, uint32_t end, uint32_t worker) {
    const struct timespec two_ms = {0, 2000000};
    if (worker != 0) nanosleep(&two_ms, NULL);
    count_visits(context, begin, end, worker);
}

static void the_caller_waits_for_slow_helpers(void **state) {
    (void)state;
    bolan_set_threads(4);
    for (int i = 0; i < 50; i++) { // a helper is not sure to wake in time for any one loop
        reset(64, 1);
        bolan_parallel(64, 1, dawdle, &t);
        assert_each_once(64, 1);
    }
    bolan_set_threads(1);
}

static void no_item_is_no_work(void **state) {
    (void)state;
    reset(0, 1);
    bolan_parallel(0, 1, count_visits, &t);
    assert_each_once(0, 0);
}

static void add_length(void *context, uint32_t begin, uint32_t end, uint32_t worker) {
    (void)worker;
    atomic_fetch_add((atomic_ullong *)context, end - begin);
}

static void the_largest_count_does_not_wrap_round(void **state) {
    (void)state;
    atomic_ullong total = 0;
    bolan_set_threads(2);
    bolan_parallel(UINT32_MAX, 1u << 30, add_length, &total);
    assert_int_equal(atomic_load(&total), UINT32_MAX);
    bolan_set_threads(1);
}

typedef struct nest {
    uint32_t outer_worker;
    atomic_int wrong;
} nest;

static void inner_loop(void *context, uint32_t begin, uint32_t end, uint32_t worker) {
    nest *n = context;
    if (worker != n->outer_worker || begin != 0 || end != 100) atomic_fetch_add(&n->wrong, 1);
    count_visits(&t, begin, end, worker);
}

static atomic_int wrong_nests;

static void outer_loop(void *context, uint32_t begin, uint32_t end, uint32_t worker) {
    (void)context;
    for (uint32_t i = begin; i < end; i++) {
        nest n = {.outer_worker = worker};
        bolan_parallel(100, 1, inner_loop, &n);
        atomic_fetch_add(&wrong_nests, atomic_load(&n.wrong));
    }
}

static void a_nested_loop_runs_on_its_own_thread(void **state) {
    (void)state;
    bolan_set_threads(4);
    reset(100, 1);
    bolan_parallel(50, 1, outer_loop, NULL);
    assert_each_once(100, 50);
    assert_int_equal(atomic_load(&wrong_nests), 0);
    bolan_set_threads(1);
}

static atomic_int sums[4];

static void add_up(void *context, uint32_t begin, uint32_t end, uint32_t worker) {
    (void)worker;
    atomic_fetch_add((atomic_int *)context, (int)(end - begin));
}

static void *one_caller(void *context) {
    for (int i = 0; i < 500; i++) bolan_parallel(1000, 10, add_up, context);
    return NULL;
}

static void several_threads_may_loop_at_once(void **state) {
    (void)state;
    pthread_t callers[4];
    bolan_set_threads(3);
    for (int i = 0; i < 4; i++) assert_int_equal(pthread_create(&callers[i], NULL, one_caller, &sums[i]), 0);
    for (int i = 0; i < 4; i++) pthread_join(callers[i], NULL);
    for (int i = 0; i < 4; i++) assert_int_equal(atomic_load(&sums[i]), 500 * 1000);
    bolan_set_threads(1);
}

// A task system that runs the slices last to first, as another engine might.
static void backwards(void *user, uint32_t count, uint32_t grain, bolan_task_fn *task, void *context) {
    ++*(int *)user;
    for (uint32_t begin = (count - 1) / grain * grain;; begin -= grain) {
        task(context, begin, begin + grain < count ? begin + grain : count, 5);
        if (begin == 0) return;
    }
}

static void the_callers_task_system_is_used(void **state) {
    (void)state;
    int loops = 0;
    const bolan_hooks hooks = {.user = &loops, .parallel = backwards, .parallel_workers = 6};
    bolan_set_hooks(&hooks);
    assert_int_equal(bolan_threads(), 6);
    reset(1001, 10);
    bolan_parallel(1001, 10, count_visits, &t);
    assert_each_once(1001, 1);
    assert_int_equal(loops, 1);
    reset(100, 1);
    bolan_parallel(3, 1, outer_loop, NULL); // and nested loops stay out of it
    assert_int_equal(loops, 2);
    assert_each_once(100, 3);
    bolan_set_hooks(NULL);
}

static void zero_threads_means_one_per_processor(void **state) {
    (void)state;
    bolan_set_threads(0);
    assert_true(bolan_threads() >= 1);
    bolan_set_threads(1);
    assert_int_equal(bolan_threads(), 1);
}

RUN_TESTS(cmocka_unit_test(every_item_is_done_once), cmocka_unit_test(many_short_loops_in_a_row_lose_nothing),
          cmocka_unit_test(the_caller_waits_for_slow_helpers), cmocka_unit_test(no_item_is_no_work),
          cmocka_unit_test(the_largest_count_does_not_wrap_round),
          cmocka_unit_test(a_nested_loop_runs_on_its_own_thread), cmocka_unit_test(several_threads_may_loop_at_once),
          cmocka_unit_test(the_callers_task_system_is_used), cmocka_unit_test(zero_threads_means_one_per_processor))

// SPDX-License-Identifier: MIT
// Parallel loops: the caller's task system, or the built-in pool.
//
// The pool is a set of sleeping threads and one loop at a time:
//
//     caller:  post the loop, wake helpers, take slices until none is left, close the loop, wait for its helpers
//     helper:  sleep -> woken -> loop still open? join with the next free worker number : sleep -> take slices -> leave
//
// Slices are taken from an atomic counter, so that a slow helper delays only its own slice. A helper that wakes after
// the loop was closed does not delay the caller. No thread spins. Which thread runs which slice varies from run to run:
// results do not depend on it, provided that a task writes only the data of its own items.
#include "base/hooks.h"

#include <pthread.h>
#include <stdatomic.h>
#include <unistd.h>

enum { MAX_THREADS = 64, SLICES_PER_WORKER = 4 };

typedef struct loop {
    bolan_task_fn *task;
    void *context;
    uint32_t count;
    uint32_t slice;             // items taken at once
    atomic_uint_least64_t next; // first item not taken; 64 bits, because every worker overshoots by a slice
} loop;

static struct {
    pthread_mutex_t in_loop; // held by the caller whose loop runs
    pthread_mutex_t lock;    // guards the members below
    pthread_cond_t posted;   // a loop was posted, or the threads must stop
    pthread_cond_t left;     // the last helper left the loop
    loop current;
    uint64_t generation; // counts loops, so that a helper does not join the same one twice
    uint32_t wanted;     // workers this loop can use; 0: closed
    uint32_t joined;     // worker numbers given out, the caller's 0 included
    uint32_t active;     // helpers inside the loop
    bool stop;
    uint32_t threads; // helpers + 1
    pthread_t helpers[MAX_THREADS - 1];
} pool = {.in_loop = PTHREAD_MUTEX_INITIALIZER,
          .lock = PTHREAD_MUTEX_INITIALIZER,
          .posted = PTHREAD_COND_INITIALIZER,
          .left = PTHREAD_COND_INITIALIZER,
          .threads = 1};

static _Thread_local bool inside;            // this thread runs a task
static _Thread_local uint32_t worker_number; // of that task

static void run_task(bolan_task_fn *task, void *context, uint32_t begin, uint32_t end, uint32_t worker) {
    const bool was_inside = inside;
    const uint32_t old_number = worker_number;
    inside = true;
    worker_number = worker;
    task(context, begin, end, worker);
    inside = was_inside;
    worker_number = old_number;
}

static void take_slices(loop *l, uint32_t worker) {
    for (;;) {
        const uint64_t begin = atomic_fetch_add_explicit(&l->next, l->slice, memory_order_relaxed);
        if (begin >= l->count) return;
        const uint64_t end = begin + l->slice < l->count ? begin + l->slice : l->count;
        run_task(l->task, l->context, (uint32_t)begin, (uint32_t)end, worker);
    }
}

static void *helper_main(void *unused) {
    (void)unused;
    uint64_t seen = 0;
    pthread_mutex_lock(&pool.lock);
    while (!pool.stop) {
        if (pool.generation == seen || pool.joined >= pool.wanted) {
            seen = pool.generation;
            pthread_cond_wait(&pool.posted, &pool.lock);
            continue;
        }
        seen = pool.generation;
        const uint32_t worker = pool.joined++;
        pool.active++;
        pthread_mutex_unlock(&pool.lock);
        take_slices(&pool.current, worker);
        pthread_mutex_lock(&pool.lock);
        if (--pool.active == 0) pthread_cond_signal(&pool.left);
    }
    pthread_mutex_unlock(&pool.lock);
    return NULL;
}

static void stop_helpers(void) {
    pthread_mutex_lock(&pool.lock);
    pool.stop = true;
    pthread_cond_broadcast(&pool.posted);
    pthread_mutex_unlock(&pool.lock);
    for (uint32_t i = 0; i + 1 < pool.threads; i++) pthread_join(pool.helpers[i], NULL);
    pool.threads = 1;
    pool.stop = false;
}

static uint32_t online_processors(void) {
    const long n = sysconf(_SC_NPROCESSORS_ONLN);
    return n < 1 ? 1 : n > MAX_THREADS ? MAX_THREADS : (uint32_t)n;
}

void bolan_set_threads(uint32_t threads) {
    BOLAN_ASSERT(threads <= MAX_THREADS);
    BOLAN_ASSERT(!inside);
    if (threads == 0) threads = online_processors();
    if (threads > MAX_THREADS) threads = MAX_THREADS;
    if (threads == pool.threads) return;
    stop_helpers();
    while (pool.threads < threads) {
        if (pthread_create(&pool.helpers[pool.threads - 1], NULL, helper_main, NULL) != 0) {
            bolan_log(BOLAN_LOG_WARNING, BOLAN_LOG_UNSUPPORTED, "asked for %u threads, the system gave only %u",
                      (unsigned)threads, (unsigned)pool.threads);
            return;
        }
        pool.threads++;
    }
}

uint32_t bolan_threads(void) {
    const bolan_hooks *hooks = bolan_active_hooks();
    if (!hooks->parallel) return pool.threads;
    return hooks->parallel_workers ? hooks->parallel_workers : 1; // 0 is misuse, which bolan_set_hooks() reported
}

// Posts the loop, works on it, and returns when the last helper has left it. The caller holds in_loop.
static void run_on_pool(uint32_t count, uint32_t slice, uint32_t workers, bolan_task_fn *task, void *context) {
    pthread_mutex_lock(&pool.lock);
    pool.current.task = task;
    pool.current.context = context;
    pool.current.count = count;
    pool.current.slice = slice;
    atomic_store_explicit(&pool.current.next, 0, memory_order_relaxed);
    pool.generation++;
    pool.wanted = workers;
    pool.joined = 1;
    for (uint32_t i = 1; i < workers; i++) pthread_cond_signal(&pool.posted);
    pthread_mutex_unlock(&pool.lock);

    take_slices(&pool.current, 0);

    pthread_mutex_lock(&pool.lock);
    pool.wanted = 0;
    while (pool.active > 0) pthread_cond_wait(&pool.left, &pool.lock);
    pthread_mutex_unlock(&pool.lock);
}

// The task that the task system of the host runs: a task of the library, with its thread marked as inside one.
typedef struct foreign {
    bolan_task_fn *task;
    void *context;
} foreign;

static void foreign_task(void *context, uint32_t begin, uint32_t end, uint32_t worker) {
    const foreign *f = context;
    run_task(f->task, f->context, begin, end, worker);
}

void bolan_parallel(uint32_t count, uint32_t grain, bolan_task_fn *task, void *context) {
    if (count == 0) return;
    if (grain == 0) grain = 1;
    const bolan_hooks *hooks = bolan_active_hooks();
    if (inside) {
        run_task(task, context, 0, count, worker_number);
        return;
    }
    if (hooks->parallel) {
        foreign f = {task, context};
        hooks->parallel(hooks->user, count, grain, foreign_task, &f);
        return;
    }
    const uint32_t slices = (count - 1) / grain + 1;
    const uint32_t workers = pool.threads < slices ? pool.threads : slices;
    // A loop from a second thread while the pool is taken runs on that thread alone.
    if (workers == 1 || pthread_mutex_trylock(&pool.in_loop) != 0) {
        run_task(task, context, 0, count, 0);
        return;
    }
    const uint32_t fair = count / (workers * SLICES_PER_WORKER);
    run_on_pool(count, fair > grain ? fair : grain, workers, task, context);
    pthread_mutex_unlock(&pool.in_loop);
}

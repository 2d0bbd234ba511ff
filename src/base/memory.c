// SPDX-License-Identifier: MIT
// Memory through the hooks, counted.
#ifdef __linux__
#define _DEFAULT_SOURCE // madvise()
#endif
#include "base/hooks.h"

#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>
#ifdef __linux__
#include <sys/mman.h>
#endif

enum { ALIGNMENT = 64 }; // a cache line, and the widest vector register
// Of blocks of at least that size. Fields are read and written at hundreds of places at once, which small pages have
// more of than a processor's table of translations: on huge ones a step of 4 cascades of 512 x 512 takes a fifth less.
enum { SMALL_PAGE = 4096, HUGE_PAGE = 2 << 20 };

static atomic_size_t in_use;

static void *built_in_allocate(size_t size) {
    if (size > SIZE_MAX - ALIGNMENT) return NULL;
    char *memory = aligned_alloc(ALIGNMENT, (size + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT);
#ifdef MADV_HUGEPAGE
    if (memory && size >= HUGE_PAGE) {
        const size_t before = (uintptr_t)memory % SMALL_PAGE;
        madvise(memory - before, size + before, MADV_HUGEPAGE); // a wish: small pages are as good otherwise
    }
#endif
    return memory;
}

void *bolan_allocate(size_t size) {
    if (size == 0) return NULL;
    const bolan_hooks *hooks = bolan_active_hooks();
    void *memory = hooks->allocate ? hooks->allocate(hooks->user, size, ALIGNMENT) : built_in_allocate(size);
    if (!memory) return NULL;
    atomic_fetch_add_explicit(&in_use, size, memory_order_relaxed);
    return memset(memory, 0, size);
}

void *bolan_enlarge(void *memory, size_t size, size_t larger) {
    void *moved = bolan_allocate(larger);
    if (!moved) return NULL;
    if (memory) memcpy(moved, memory, size);
    bolan_release(memory, size);
    return moved;
}

void bolan_release(void *memory, size_t size) {
    if (!memory) return;
    const bolan_hooks *hooks = bolan_active_hooks();
    atomic_fetch_sub_explicit(&in_use, size, memory_order_relaxed);
    if (hooks->release) {
        hooks->release(hooks->user, memory, size);
    } else {
        free(memory);
    }
}

size_t bolan_memory_in_use(void) { return atomic_load_explicit(&in_use, memory_order_relaxed); }

// SPDX-License-Identifier: MIT
// Which sizes of targets are kept, so that views of different sizes that take turns allocate nothing: the last
// KEPT_SIZES sizes, together at most KEPT_PIXELS pixels besides the present size. Each owner of targets has one of
// these, and as many slots of targets.
#ifndef BOLAN_RENDER_KEPT_SIZES_H
#define BOLAN_RENDER_KEPT_SIZES_H

#include <stdbool.h>
#include <stdint.h>

enum { KEPT_SIZES = 4, KEPT_PIXELS = 1 << 24 };

typedef struct kept_sizes {
    struct kept_size {
        uint32_t width, height; // 0: the slot is free
        uint64_t used;          // the clock when it was used last
    } slot[KEPT_SIZES];
    uint64_t clock;
} kept_sizes;

// The slot of this size. `fresh`: it is to be made, in a slot that may hold another size and is then freed before.
uint32_t bolan_kept_sizes_use(kept_sizes *k, uint32_t width, uint32_t height, bool *fresh);
// A slot that has to be freed, since the others together have too many pixels; it counts as free from now on. False:
// there is none.
bool bolan_kept_sizes_over(kept_sizes *k, uint32_t *slot);
// The slot could not be made.
void bolan_kept_sizes_forget(kept_sizes *k, uint32_t slot);

#endif

// SPDX-License-Identifier: MIT
// See kept_sizes.h.
#include "kept_sizes.h"

static uint64_t pixels_of(const struct kept_size *s) { return (uint64_t)s->width * s->height; }

uint32_t bolan_kept_sizes_use(kept_sizes *k, uint32_t width, uint32_t height, bool *fresh) {
    uint32_t oldest = 0;
    k->clock++;
    for (uint32_t i = 0; i < KEPT_SIZES; ++i) {
        if (k->slot[i].width == width && k->slot[i].height == height) {
            k->slot[i].used = k->clock;
            *fresh = false;
            return i;
        }
        if (k->slot[i].used < k->slot[oldest].used) oldest = i;
    }
    k->slot[oldest] = (struct kept_size){width, height, k->clock};
    *fresh = true;
    return oldest;
}

bool bolan_kept_sizes_over(kept_sizes *k, uint32_t *slot) {
    uint64_t sum = 0;
    uint32_t oldest = KEPT_SIZES;
    for (uint32_t i = 0; i < KEPT_SIZES; ++i) {
        const struct kept_size *s = &k->slot[i];
        if (s->width == 0 || s->used == k->clock) continue;
        sum += pixels_of(s);
        if (oldest == KEPT_SIZES || s->used < k->slot[oldest].used) oldest = i;
    }
    if (sum <= KEPT_PIXELS) return false;
    bolan_kept_sizes_forget(k, oldest);
    *slot = oldest;
    return true;
}

void bolan_kept_sizes_forget(kept_sizes *k, uint32_t slot) { k->slot[slot] = (struct kept_size){.width = 0}; }

// SPDX-License-Identifier: MIT
// What belongs to one eye: the sky's tables and clouds, the ground's tree and shore map.
#include "memory.h"
#include "renderer.h"

bolan_result bolan_view_cache_open(const gl_caps *caps, bolan_view_cache *cache) {
    bolan_result result = bolan_pass_sky_create(caps, &cache->sky);
    return result == BOLAN_OK ? bolan_pass_ground_create(caps, &cache->ground) : result;
}

void bolan_view_cache_close(bolan_view_cache *cache) {
    bolan_pass_sky_destroy(&cache->sky);
    bolan_pass_ground_destroy(&cache->ground);
}

bolan_result bolan_view_cache_create(bolan_renderer *r, bolan_view_cache **out) {
    BOLAN_ASSERT(r != NULL && out != NULL);
    if (r == NULL || out == NULL) return BOLAN_ERROR_ARGUMENT;
    *out = NULL;
    bolan_result result = bolan_gl_check_context("view cache");
    if (result != BOLAN_OK) return result;
    bolan_view_cache *cache = allocate_for("a view cache", sizeof *cache);
    if (cache == NULL) return BOLAN_ERROR_MEMORY;
    cache->renderer = r;
    bolan_renderer_enter(r);
    result = bolan_view_cache_open(&r->caps, cache);
    bolan_renderer_leave(r);
    if (result != BOLAN_OK)
        bolan_view_cache_destroy(&cache);
    else
        *out = cache;
    return result;
}

void bolan_view_cache_destroy(bolan_view_cache **cache) {
    if (cache == NULL || *cache == NULL) return;
    bolan_view_cache_close(*cache);
    bolan_release(*cache, sizeof **cache);
    *cache = NULL;
}

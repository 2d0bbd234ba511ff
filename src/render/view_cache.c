// SPDX-License-Identifier: MIT
// What belongs to one eye: the sky's tables and clouds, the ground's tree and shore map.
#include "memory.h"
#include "renderer.h"

bolan_result bolan_view_cache_open(const gl_caps *caps, bool compute, const bolan_view_cache *from,
                                   bolan_view_cache *cache) {
    const bolan_result result = bolan_pass_sky_create(caps, compute, from != NULL ? from->sky : NULL, &cache->sky);
    if (result != BOLAN_OK) return result;
    return bolan_pass_ground_create(caps, from != NULL ? from->ground : NULL, &cache->ground);
}

void bolan_view_cache_share(bolan_view_cache *cache, const bolan_view_cache *from) {
    bolan_pass_sky_share(cache->sky, from->sky);
    bolan_pass_ground_share(cache->ground, from->ground);
}

void bolan_view_cache_close(bolan_view_cache *cache) {
    bolan_pass_sky_destroy(&cache->sky);
    bolan_pass_ground_destroy(&cache->ground);
    bolan_temporal_free(&cache->temporal);
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
    result = bolan_view_cache_open(&r->caps, r->desc.pixels == BOLAN_PIXELS_COMPUTE, &r->own_cache, cache);
    bolan_renderer_leave(r);
    if (result != BOLAN_OK) {
        bolan_view_cache_close(cache);
        bolan_release(cache, sizeof *cache);
        return result;
    }
    cache->next = r->caches;
    r->caches = cache;
    *out = cache;
    return BOLAN_OK;
}

void bolan_view_cache_destroy(bolan_view_cache **cache) {
    if (cache == NULL || *cache == NULL) return;
    bolan_view_cache **link = &(*cache)->renderer->caches;
    while (*link != *cache) link = &(*link)->next;
    *link = (*cache)->next;
    bolan_view_cache_close(*cache);
    bolan_release(*cache, sizeof **cache);
    *cache = NULL;
}

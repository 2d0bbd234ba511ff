// SPDX-License-Identifier: MIT
// See tiles.h. Corners lie at multiples of BOLAN_TILE_STEP: pixels that share a sample in the whole share it in a tile.
#include "tiles.h"

#include <stdlib.h>
#include <string.h>

#include "options.h"

enum { GUARD = 2 * BOLAN_TILE_STEP, MOST_AT_ONCE = 16384, USUAL_TILE = 4096 };

static uint32_t least_of(uint32_t a, uint32_t b) { return a < b ? a : b; }

// Columns or rows of a tile that has `guard` on both sides and at most `most` in all.
static uint32_t core_of(uint32_t whole, uint32_t most, uint32_t guard) {
    if (guard == 0) return whole;
    const uint32_t core = most > 2 * guard ? (most - 2 * guard) / BOLAN_TILE_STEP * BOLAN_TILE_STEP : 0;
    return core > 0 ? core : BOLAN_TILE_STEP;
}

static void plan(tiles *t, uint32_t most) {
    const uint32_t able = least_of(bolan_gl_get_info().max_picture, MOST_AT_ONCE), limit = most > 0 ? most : able;
    const bool fits = t->width <= limit && t->height <= limit;
    const uint32_t side = most > 0 ? least_of(most, able) : least_of(able, USUAL_TILE);
    t->guard = fits ? 0 : GUARD;
    t->columns = core_of(t->width, side, t->guard);
    t->rows = core_of(t->height, side, t->guard);
    t->most_columns = least_of(t->columns + 2 * t->guard, t->width);
    t->most_rows = least_of(t->rows + 2 * t->guard, t->height);
}

bool tiles_open(tiles *t, bolan_renderer *renderer, uint32_t width, uint32_t height, uint32_t most, bool linear) {
    *t = (tiles){.renderer = renderer, .width = width, .height = height};
    plan(t, most);
    if (bolan_target_create(t->most_columns, t->most_rows, &t->target) != BOLAN_OK) return false;
    const size_t pixels = (size_t)t->most_columns * t->most_rows;
    t->pixels = pixels;
    t->rgb_bytes = 3 * pixels;
    t->linear_bytes = linear ? 3 * pixels * sizeof(float) : 0;
    t->distance_bytes = linear ? pixels * sizeof(float) : 0;
    t->rgb = bolan_allocate(t->rgb_bytes);
    if (linear) t->linear = bolan_allocate(t->linear_bytes);
    if (linear) t->distance = bolan_allocate(t->distance_bytes);
    if (t->rgb != NULL && (!linear || (t->linear != NULL && t->distance != NULL))) return true;
    failure("no memory for a tile of %ux%u", (unsigned)t->most_columns, (unsigned)t->most_rows);
    return false;
}

bool tiles_add_surfaces(tiles *t, const bolan_surfaces *wanted) {
    bolan_surfaces *s = &t->surfaces;
    if (wanted->label != NULL) s->label = malloc(t->pixels * sizeof *s->label);
    if (wanted->normal != NULL) s->normal = malloc(t->pixels * sizeof *s->normal);
    if (wanted->motion != NULL) s->motion = malloc(t->pixels * sizeof *s->motion);
    if (!s->label == !wanted->label && !s->normal == !wanted->normal && !s->motion == !wanted->motion) return true;
    failure("no memory for a tile of %ux%u", (unsigned)t->most_columns, (unsigned)t->most_rows);
    return false;
}

void tiles_close(tiles *t) {
    free(t->surfaces.label), free(t->surfaces.normal), free(t->surfaces.motion);
    bolan_release(t->rgb, t->rgb_bytes);
    bolan_release(t->linear, t->linear_bytes);
    bolan_release(t->distance, t->distance_bytes);
    bolan_target_destroy(&t->target);
}

// A rectangle of the whole; x and y: its lower left corner.
typedef struct rectangle {
    uint32_t x, y, width, height;
} rectangle;

static rectangle with_guard(const tiles *t, rectangle core) {
    const uint32_t left = least_of(core.x, t->guard), below = least_of(core.y, t->guard);
    const uint32_t right = least_of(t->width - core.x - core.width, t->guard);
    const uint32_t above = least_of(t->height - core.y - core.height, t->guard);
    return (rectangle){core.x - left, core.y - below, core.width + left + right, core.height + below + above};
}

// Cuts the core out of what was drawn; both have their top row first.
static void copy(const tiles *t, rectangle core, rectangle drawn, const void *from, void *to, size_t pixel) {
    for (uint32_t row = 0; row < core.height; ++row) {
        const uint32_t y = core.y + row;
        const size_t source = (size_t)(drawn.y + drawn.height - 1 - y) * drawn.width + (core.x - drawn.x);
        const size_t place = (size_t)(t->height - 1 - y) * t->width + core.x;
        memcpy((char *)to + place * pixel, (const char *)from + source * pixel, core.width * pixel);
    }
}

static void draw_surfaces(const tiles *t, const bolan_world *world, const bolan_view *view, rectangle core,
                          rectangle drawn, const bolan_surfaces *to) {
    bolan_surfaces part = t->surfaces;
    part.flow = to->flow;
    bolan_renderer_read_surfaces(t->renderer, world, view, &part);
    if (to->label != NULL) copy(t, core, drawn, part.label, to->label, sizeof *to->label);
    if (to->normal != NULL) copy(t, core, drawn, part.normal, to->normal, sizeof *to->normal);
    if (to->motion != NULL) copy(t, core, drawn, part.motion, to->motion, sizeof *to->motion);
}

void tiles_draw(const tiles *t, const bolan_world *world, const bolan_view *whole, uint8_t *rgb, float *linear,
                float *distance, const bolan_surfaces *surfaces) {
    bolan_view view = *whole;
    view.framebuffer = bolan_target_framebuffer(t->target);
    for (uint32_t y = 0; y < t->height; y += t->rows)
        for (uint32_t x = 0; x < t->width; x += t->columns) {
            const rectangle core = {x, y, least_of(t->columns, t->width - x), least_of(t->rows, t->height - y)};
            const rectangle drawn = with_guard(t, core);
            view.tile.x = drawn.x, view.tile.y = drawn.y;
            view.tile.whole_width = t->width, view.tile.whole_height = t->height;
            view.width = drawn.width, view.height = drawn.height;
            bolan_renderer_draw_world(t->renderer, world, &view);
            bolan_renderer_read_rgb8(t->renderer, view.framebuffer, drawn.width, drawn.height, t->rgb);
            copy(t, core, drawn, t->rgb, rgb, 3);
            if (linear == NULL) continue;
            bolan_renderer_read_linear(t->renderer, t->linear, t->distance);
            copy(t, core, drawn, t->linear, linear, 3 * sizeof(float));
            copy(t, core, drawn, t->distance, distance, sizeof(float));
            if (surfaces != NULL) draw_surfaces(t, world, &view, core, drawn, surfaces);
        }
}

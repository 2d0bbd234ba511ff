// SPDX-License-Identifier: MIT
// The quadtree of chunks. It is walked level by level from the root: all of a level's missing chunks are built in one
// parallel loop before the next level looks at them, so that parents always hold what their children ask of them.
#include "ground_tree.h"
#include "memory.h"
#include "view.h"

#include "bolan/earth.h"
#include "shared/earth.glsl"

#define HASH_SIZE 2048u
#define NO_SLOT UINT32_MAX
#define SMALLEST_CHUNK 25.0 // [m]; finer structure is the shader's
#define DEEPEST_BED 80.0    // [m] below the water level; what lies deeper is not seen

struct ground_tree {
    const bolan_ground *terrain;
    double west, south, size; // of the root
    uint32_t slot_count;
    chunk_slot *slots;
    uint32_t hash[HASH_SIZE];
    uint64_t frame, light;
    chunk_sun sun;
    double water_level;
    uint32_t *current, *next, *work, *draw; // slot indices, slot_count each
    uint32_t current_count, next_count, work_count, draw_count;
    uint32_t budget, total_work;
};

bolan_result bolan_ground_tree_create(uint32_t slots, ground_tree **out) {
    ground_tree *t = allocate_for("the tree of the ground", sizeof *t);
    *out = t;
    if (!t) {
        return BOLAN_ERROR_MEMORY;
    }
    t->slot_count = slots;
    t->slots = allocate_for("the tree of the ground", slots * sizeof *t->slots);
    if (t->slots) t->current = allocate_for("the tree of the ground", 4 * slots * sizeof *t->current);
    bool all = t->slots && t->current;
    for (uint32_t n = 0; all && n < slots; n++) { // now, so that a flight allocates nothing
        all = bolan_chunk_allocate(&t->slots[n].chunk) == BOLAN_OK;
    }
    if (!all) {
        bolan_ground_tree_destroy(out);
        return BOLAN_ERROR_MEMORY;
    }
    t->next = t->current + slots, t->work = t->next + slots, t->draw = t->work + slots;
    bolan_ground_tree_reset(t, NULL);
    return BOLAN_OK;
}

void bolan_ground_tree_destroy(ground_tree **tree) {
    if (!tree || !*tree) {
        return;
    }
    ground_tree *t = *tree;
    for (uint32_t n = 0; t->slots && n < t->slot_count; n++) {
        bolan_chunk_free(&t->slots[n].chunk);
    }
    uint32_t *lists = t->current < t->next ? t->current : t->next; // the two are exchanged while walking
    bolan_release(lists ? lists : t->current, 4 * t->slot_count * sizeof *t->current);
    bolan_release(t->slots, t->slot_count * sizeof *t->slots);
    bolan_release(t, sizeof *t);
    *tree = NULL;
}

void bolan_ground_tree_reset(ground_tree *t, const bolan_ground *terrain) {
    t->terrain = terrain;
    t->frame = 1, t->light = 1;
    t->draw_count = t->total_work = 0;
    for (uint32_t n = 0; n < HASH_SIZE; n++) {
        t->hash[n] = NO_SLOT;
    }
    for (uint32_t n = 0; n < t->slot_count; n++) {
        t->slots[n].used = 0;
        t->slots[n].next = NO_SLOT;
    }
    if (terrain) {
        bolan_ground_extent e = bolan_ground_get_extent(terrain);
        double side = fmax(e.east - e.west, e.north - e.south), margin = fmax(8.0 * e.step, 0.1 * side);
        t->size = side + 2.0 * margin;
        t->west = 0.5 * (e.west + e.east - t->size), t->south = 0.5 * (e.south + e.north - t->size);
    }
}

const uint32_t *bolan_ground_tree_draw_list(const ground_tree *t, uint32_t *count) {
    *count = t->draw_count;
    return t->draw;
}
chunk_slot *bolan_ground_tree_slot(ground_tree *t, uint32_t index) { return &t->slots[index]; }
uint32_t bolan_ground_tree_work(const ground_tree *t) { return t->total_work; }

// ---- the pool
// --------------------------------------------------------------------------------------------------------

static uint32_t *bucket(ground_tree *t, uint32_t level, uint32_t x, uint32_t y) {
    uint32_t h = (x * 0x9e3779b1u) ^ (y * 0x85ebca77u) ^ (level * 0xc2b2ae3du);
    return &t->hash[(h ^ (h >> 15)) % HASH_SIZE];
}

static uint32_t find(ground_tree *t, uint32_t level, uint32_t x, uint32_t y) {
    uint32_t n = *bucket(t, level, x, y);
    while (n != NO_SLOT && (t->slots[n].level != level || t->slots[n].x != x || t->slots[n].y != y)) {
        n = t->slots[n].next;
    }
    return n;
}

static void unlink_slot(ground_tree *t, uint32_t n) {
    chunk_slot *s = &t->slots[n];
    uint32_t *link = bucket(t, s->level, s->x, s->y);
    while (*link != n) {
        link = &t->slots[*link].next;
    }
    *link = s->next;
}

// The slot that was not used for the longest time, or NO_SLOT when this frame uses all of them.
static uint32_t oldest(const ground_tree *t) {
    uint32_t best = NO_SLOT;
    uint64_t used = t->frame;
    for (uint32_t n = 0; n < t->slot_count && used > 0; n++) {
        if (t->slots[n].used < used) {
            used = t->slots[n].used;
            best = n;
        }
    }
    return best;
}

static uint32_t take(ground_tree *t, uint32_t level, uint32_t x, uint32_t y) {
    uint32_t n = oldest(t);
    if (n == NO_SLOT) {
        return NO_SLOT;
    }
    chunk_slot *s = &t->slots[n];
    if (s->used > 0) {
        unlink_slot(t, n);
    }
    s->level = level, s->x = x, s->y = y;
    s->used = t->frame;
    s->lit = 0;
    s->fresh_mesh = s->fresh_map = true;
    uint32_t *head = bucket(t, level, x, y);
    s->next = *head;
    *head = n;
    s->chunk.size = t->size / (double)(1u << level);
    s->chunk.west = t->west + x * s->chunk.size;
    s->chunk.south = t->south + y * s->chunk.size;
    return n;
}

// ---- what a view sees
// ------------------------------------------------------------------------------------------------

// Eye-relative box with the earth's curvature taken off.
typedef struct box {
    float low[3], high[3];
    double distance; // level distance to the eye [m]
} box;

static box box_of(const tree_view *v, double west, double south, double size, float lowest, float highest) {
    double x0 = west - v->eye.x, y0 = south - v->eye.y, x1 = x0 + size, y1 = y0 + size;
    double nx = fmax(fmax(x0, -x1), 0.0), ny = fmax(fmax(y0, -y1), 0.0);
    double fx = fmax(fabs(x0), fabs(x1)), fy = fmax(fabs(y0), fabs(y1));
    double slack = 0.01 * size + 0.5;
    box b = {{(float)(x0 - slack), (float)(y0 - slack),
              (float)(lowest - v->eye.z - earth_drop(fx * fx + fy * fy, BOLAN_EARTH_RADIUS) - slack)},
             {(float)(x1 + slack), (float)(y1 + slack),
              (float)(highest - v->eye.z - earth_drop(nx * nx + ny * ny, BOLAN_EARTH_RADIUS) + slack)},
             sqrt(nx * nx + ny * ny)};
    return b;
}

static bool hidden(const tree_view *v, double west, double south, double size, float lowest, float highest) {
    if (highest < v->water_level - DEEPEST_BED) {
        return true;
    }
    box b = box_of(v, west, south, size, lowest, highest);
    // Below the horizon of the sea: sqrt(2 R h) to it, as much again beyond it for what stands high.
    double eye = v->eye.z - v->water_level, top = highest - v->water_level;
    double reach =
        earth_horizon(fmax(eye, 0.0), BOLAN_EARTH_RADIUS) + earth_horizon(fmax(top, 0.0), BOLAN_EARTH_RADIUS);
    if (eye > 0.0 && b.distance > reach * 1.05 + 1000.0) {
        return true;
    }
    return bolan_outside_frustum(&v->view_projection, b.low, b.high) &&
           !(v->mirrors && !bolan_outside_frustum(&v->mirrored, b.low, b.high));
}

// What a pixel covers at the nearest point of a chunk [m]. The bed blurs with the depth of the water over it.
static double pixel_at(const tree_view *v, const ground_chunk *c) {
    box b = box_of(v, c->west, c->south, c->size, c->lowest, c->highest);
    double dz = fmax(fmax(b.low[2], -b.high[2]), 0.0);
    double blur = 1.0 + fmax(v->water_level - c->highest, 0.0) / 8.0;
    return v->pixel * blur * fmax(sqrt(b.distance * b.distance + dz * dz), 1.0);
}

static bool wants_split(const tree_view *v, const ground_chunk *c, double pixel) {
    return c->size >= 2.0 * SMALLEST_CHUNK &&
           (c->size / CHUNK_TEXELS > v->texel_pixels * pixel || c->error[0] > 2.0 * v->error_pixels * pixel);
}

static uint32_t choose_mesh(const tree_view *v, const ground_chunk *c, double pixel) {
    uint32_t m = CHUNK_MESHES - 1;
    while (m > 0 && c->error[m] > v->error_pixels * pixel) {
        m--;
    }
    return m;
}

// ---- the walk
// --------------------------------------------------------------------------------------------------------

static void queue_work(ground_tree *t, uint32_t n) { t->work[t->work_count++] = n; }

// Makes the visible children of slot n part of the next level; false when they cannot all be had.
static bool split(ground_tree *t, const tree_view *v, uint32_t n) {
    const chunk_slot *s = &t->slots[n];
    double half = 0.5 * s->chunk.size;
    uint32_t visible[4], count = 0, missing = 0;
    for (uint32_t q = 0; q < 4; q++) {
        double west = s->chunk.west + (q & 1) * half, south = s->chunk.south + (q >> 1) * half;
        float low, high;
        bolan_ground_bounds(t->terrain, west, south, half, &low, &high);
        // A child's nodes are finer than its parent's: allow what the parent may have missed.
        low = fmaxf(low, s->chunk.lowest - s->chunk.skirt), high = fminf(high, s->chunk.highest + s->chunk.skirt);
        if (hidden(v, west, south, half, low, high)) {
            continue;
        }
        uint32_t child = find(t, s->level + 1, 2 * s->x + (q & 1), 2 * s->y + (q >> 1));
        if (child != NO_SLOT) {
            t->slots[child].used = t->frame;
        } else {
            missing++;
        }
        visible[count++] = q;
    }
    if (missing > t->budget || t->next_count + count > t->slot_count) {
        return false;
    }
    for (uint32_t k = 0; k < count; k++) {
        uint32_t x = 2 * s->x + (visible[k] & 1), y = 2 * s->y + (visible[k] >> 1);
        uint32_t child = find(t, s->level + 1, x, y);
        if (child == NO_SLOT && (child = take(t, s->level + 1, x, y)) == NO_SLOT) {
            t->next_count -= k; // the pool is too small for this view: stay coarse here
            return false;
        }
        t->slots[child].chunk.parent = &s->chunk;
        t->next[t->next_count++] = child;
    }
    t->budget -= missing;
    return true;
}

static void walk_level(ground_tree *t, const tree_view *v) {
    t->next_count = 0;
    for (uint32_t k = 0; k < t->current_count; k++) {
        uint32_t n = t->current[k];
        const ground_chunk *c = &t->slots[n].chunk;
        if (hidden(v, c->west, c->south, c->size, c->lowest - c->skirt, c->highest)) {
            continue;
        }
        double pixel = pixel_at(v, c);
        if (!wants_split(v, c, pixel) || !split(t, v, n)) {
            t->slots[n].mesh = choose_mesh(v, c, pixel);
            t->draw[t->draw_count++] = n;
        }
    }
}

static void work_on(void *context, uint32_t begin, uint32_t end, uint32_t worker) {
    ground_tree *t = context;
    (void)worker;
    for (uint32_t k = begin; k < end; k++) {
        chunk_slot *s = &t->slots[t->work[k]];
        if (s->lit == 0) {
            bolan_chunk_build(&s->chunk, t->terrain);
        }
        bolan_chunk_light(&s->chunk, &t->sun);
        s->lit = t->light;
        s->fresh_map = true;
    }
}

// Builds and lights what the level now has.
static void finish_level(ground_tree *t) {
    t->work_count = 0;
    for (uint32_t k = 0; k < t->next_count; k++) {
        if (t->slots[t->next[k]].lit != t->light) {
            queue_work(t, t->next[k]);
        }
    }
    bolan_parallel(t->work_count, 1, work_on, t);
    t->total_work += t->work_count;
    uint32_t *swap = t->current;
    t->current = t->next, t->next = swap;
    t->current_count = t->next_count;
}

static bool sun_moved(const chunk_sun *a, const chunk_sun *b) {
    return a->x != b->x || a->y != b->y || a->slope != b->slope;
}

void bolan_ground_tree_select(ground_tree *t, const tree_view *view) {
    t->frame++;
    t->draw_count = t->total_work = 0;
    if (sun_moved(&t->sun, &view->sun)) {
        t->sun = view->sun;
        t->light++;
    }
    t->budget = view->complete ? UINT32_MAX : view->budget;
    uint32_t root = find(t, 0, 0, 0);
    root = root != NO_SLOT ? root : take(t, 0, 0, 0);
    if (root == NO_SLOT) {
        return;
    }
    t->slots[root].used = t->frame;
    t->slots[root].chunk.parent = NULL;
    t->next[0] = root, t->next_count = 1;
    for (finish_level(t); t->current_count > 0; finish_level(t)) {
        walk_level(t, view);
    }
    for (uint32_t a = 0, b = t->draw_count; a + 1 < b; a++, b--) { // coarse ones are far: nearest first
        uint32_t n = t->draw[a];
        t->draw[a] = t->draw[b - 1], t->draw[b - 1] = n;
    }
}

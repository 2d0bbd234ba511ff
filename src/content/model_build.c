// SPDX-License-Identifier: MIT
// See model_build.h.
#include "content/model_build.h"

#include <string.h>

// ---- arrays that grow -----------------------------------------------------------------------------------------------

static bool grow(void **array, size_t element, uint32_t old, uint32_t fresh) {
    void *larger = bolan_enlarge(*array, element * old, element * fresh);
    if (!larger) return false;
    *array = larger;
    return true;
}

static bool room_for_vertex(model_builder *b) {
    if (b->failed || b->vertex_count < b->vertex_capacity) return !b->failed;
    const uint32_t n = b->vertex_count, old = b->vertex_capacity, fresh = old ? 2 * old : 1024;
    // All three arrays grow or none: each is released by its capacity.
    bolan_vec3 *positions = b->positions, *normals = b->normals;
    bolan_vec4 *colors = b->colors;
    b->positions = bolan_allocate(fresh * sizeof *positions);
    b->normals = bolan_allocate(fresh * sizeof *normals);
    b->colors = bolan_allocate(fresh * sizeof *colors);
    b->vertex_capacity = fresh;
    b->failed = !b->positions || !b->normals || !b->colors;
    if (n && !b->failed) {
        memcpy(b->positions, positions, n * sizeof *positions);
        memcpy(b->normals, normals, n * sizeof *normals);
        memcpy(b->colors, colors, n * sizeof *colors);
    }
    bolan_release(positions, old * sizeof *positions);
    bolan_release(normals, old * sizeof *normals);
    bolan_release(colors, old * sizeof *colors);
    return !b->failed;
}

void bolan_build_free(model_builder *b) {
    bolan_release(b->positions, b->vertex_capacity * sizeof *b->positions);
    bolan_release(b->normals, b->vertex_capacity * sizeof *b->normals);
    bolan_release(b->colors, b->vertex_capacity * sizeof *b->colors);
    bolan_release(b->indices, b->index_capacity * sizeof *b->indices);
    *b = (model_builder){.failed = false};
}

uint32_t bolan_build_vertex(model_builder *b, bolan_vec3 position, bolan_vec3 normal, bolan_vec3 color, float open) {
    if (!room_for_vertex(b)) return 0;
    const uint32_t n = b->vertex_count++;
    b->positions[n] = position;
    b->normals[n] = normal;
    b->colors[n] = (bolan_vec4){color.x, color.y, color.z, open};
    return n;
}

void bolan_build_triangle(model_builder *b, uint32_t i, uint32_t j, uint32_t k) {
    if (!b->failed && b->index_count + 3 > b->index_capacity) {
        const uint32_t fresh = b->index_capacity ? 2 * b->index_capacity : 3072;
        void *indices = b->indices;
        b->failed = !grow(&indices, sizeof *b->indices, b->index_capacity, fresh);
        if (!b->failed) b->index_capacity = fresh;
        b->indices = indices;
    }
    if (b->failed) return;
    b->indices[b->index_count++] = i;
    b->indices[b->index_count++] = j;
    b->indices[b->index_count++] = k;
}

// ---- flat things ----------------------------------------------------------------------------------------------------

static bolan_vec3 facing(bolan_vec3 p, bolan_vec3 q, bolan_vec3 r) {
    const bolan_vec3 n = bolan_v3_cross(bolan_v3_sub(q, p), bolan_v3_sub(r, p));
    const float length = bolan_v3_length(n);
    return length > 1e-12f ? bolan_v3_scale(n, 1.0f / length) : bolan_v3(0.0f, 0.0f, 1.0f);
}

void bolan_build_quad(model_builder *b, const bolan_vec3 c[4], bolan_vec3 color, float low, float high) {
    const bolan_vec3 n = facing(c[0], c[1], c[2]);
    const uint32_t first = b->vertex_count;
    for (int i = 0; i < 4; i++) bolan_build_vertex(b, c[i], n, color, i < 2 ? low : high);
    bolan_build_triangle(b, first, first + 1, first + 2);
    bolan_build_triangle(b, first, first + 2, first + 3);
}

void bolan_build_facet(model_builder *b, bolan_vec3 p, bolan_vec3 q, bolan_vec3 r, bolan_vec3 color, float open) {
    const bolan_vec3 n = facing(p, q, r);
    const uint32_t i = bolan_build_vertex(b, p, n, color, open), j = bolan_build_vertex(b, q, n, color, open);
    bolan_build_triangle(b, i, j, bolan_build_vertex(b, r, n, color, open));
}

void bolan_build_box(model_builder *b, bolan_vec3 l, bolan_vec3 h, bolan_vec3 color, bool open_below) {
    // Corner numbers: bit 0 east, bit 1 north, bit 2 up.
    static const uint8_t faces[6][4] = {{0, 1, 5, 4}, {3, 2, 6, 7}, {1, 3, 7, 5},
                                        {2, 0, 4, 6}, {4, 5, 7, 6}, {2, 3, 1, 0}};
    for (int f = 0; f < (open_below ? 5 : 6); f++) {
        bolan_vec3 corner[4];
        for (int i = 0; i < 4; i++) {
            const uint8_t n = faces[f][i];
            corner[i] = bolan_v3(n & 1 ? h.x : l.x, n & 2 ? h.y : l.y, n & 4 ? h.z : l.z);
        }
        bolan_build_quad(b, corner, color, f == 4 ? 1.0f : f == 5 ? 0.3f : 0.7f, f == 5 ? 0.3f : f == 4 ? 1.0f : 0.85f);
    }
}

// ---- round things ---------------------------------------------------------------------------------------------------

void bolan_build_tube(model_builder *b, const build_bar *t) {
    bolan_vec3 along = bolan_v3_sub(t->to, t->from);
    along = bolan_v3_normalize(along);
    const bolan_vec3 other = fabsf(along.z) < 0.8f ? bolan_v3(0.0f, 0.0f, 1.0f) : bolan_v3(1.0f, 0.0f, 0.0f);
    const bolan_vec3 side = bolan_v3_normalize(bolan_v3_cross(other, along)), up = bolan_v3_cross(along, side);
    const uint32_t first = b->vertex_count;
    for (uint32_t i = 0; i < t->sides; i++) {
        double s, c;
        bolan_sincos(2.0 * BOLAN_PI * i / t->sides, &s, &c);
        const bolan_vec3 n = bolan_v3_add(bolan_v3_scale(side, (float)c), bolan_v3_scale(up, (float)s));
        bolan_build_vertex(b, bolan_v3_add(t->from, bolan_v3_scale(n, t->from_radius)), n, t->from_color, t->open);
        bolan_build_vertex(b, bolan_v3_add(t->to, bolan_v3_scale(n, t->to_radius)), n, t->to_color, t->open);
    }
    for (uint32_t i = 0; i < t->sides; i++) {
        const uint32_t a = first + 2 * i, c = first + 2 * ((i + 1) % t->sides);
        bolan_build_triangle(b, a, c, c + 1);
        bolan_build_triangle(b, a, c + 1, a + 1);
    }
    if (t->open_end) return;
    const uint32_t middle = bolan_build_vertex(b, t->to, along, t->to_color, t->open);
    for (uint32_t i = 0; i < t->sides; i++)
        bolan_build_triangle(b, first + 2 * i + 1, first + 2 * ((i + 1) % t->sides) + 1, middle);
}

#define GOLDEN 0.85065081f // corners of the icosahedron: (0, +-SILVER, +-GOLDEN) and its turns
#define SILVER 0.52573111f
static const bolan_vec3 ball_corner[12] = {
    {-SILVER, GOLDEN, 0}, {SILVER, GOLDEN, 0}, {-SILVER, -GOLDEN, 0}, {SILVER, -GOLDEN, 0},
    {0, -SILVER, GOLDEN}, {0, SILVER, GOLDEN}, {0, -SILVER, -GOLDEN}, {0, SILVER, -GOLDEN},
    {GOLDEN, 0, -SILVER}, {GOLDEN, 0, SILVER}, {-GOLDEN, 0, -SILVER}, {-GOLDEN, 0, SILVER},
};
static const uint8_t ball_face[20][3] = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                         {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                         {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                         {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};

static uint32_t lump_vertex(model_builder *b, const build_lump *l, bolan_vec3 dir, uint32_t number) {
    uint32_t state = l->seed * 0x9e3779b9u + number * 0x85ebca6bu + 1u;
    const float swell = 1.0f + l->rough * (2.0f * bolan_build_random(&state) - 1.0f);
    const bolan_vec3 out = bolan_v3(dir.x * l->radius.x, dir.y * l->radius.y, dir.z * l->radius.z);
    const bolan_vec3 p = bolan_v3_add(l->center, bolan_v3_scale(out, swell));
    const bolan_vec3 heart = build_mix(l->center, l->core, 0.5f);
    const float t = 0.5f + 0.5f * dir.z;
    const bolan_vec3 color = bolan_build_vary(&state, build_mix(l->low_color, l->high_color, t), 0.22f);
    return bolan_build_vertex(b, p, bolan_v3_normalize(bolan_v3_sub(p, heart)), color,
                              l->low_open + (l->high_open - l->low_open) * t);
}

// The vertex in the middle of an edge, made once.
static uint32_t middle_of(model_builder *b, const build_lump *l, uint16_t made[12][12], int i, int j, uint32_t first) {
    const int low = i < j ? i : j, high = i < j ? j : i;
    if (!made[low][high]) {
        const bolan_vec3 dir = bolan_v3_normalize(bolan_v3_add(ball_corner[i], ball_corner[j]));
        const uint32_t number = (uint32_t)(12 + low * 12 + high);
        made[low][high] = (uint16_t)(lump_vertex(b, l, dir, number) - first + 1);
    }
    return first + made[low][high] - 1;
}

void bolan_build_blob(model_builder *b, const build_lump *l) {
    model_builder loose = {.failed = false}; // a faceted lump has separate vertices for each facet
    model_builder *to = l->faceted ? &loose : b;
    const uint32_t first = to->vertex_count;
    uint16_t made[12][12] = {{0}};
    for (uint32_t i = 0; i < 12; i++) lump_vertex(to, l, ball_corner[i], i);
    uint32_t triangles[80][3], count = 0;
    for (int f = 0; f < 20; f++) {
        const int i = ball_face[f][0], j = ball_face[f][1], k = ball_face[f][2];
        const uint32_t a = first + (uint32_t)i, c = first + (uint32_t)j, d = first + (uint32_t)k;
        if (!l->fine) {
            memcpy(triangles[count++], (uint32_t[]){a, c, d}, sizeof *triangles);
            continue;
        }
        const uint32_t ac = middle_of(to, l, made, i, j, first), cd = middle_of(to, l, made, j, k, first),
                       da = middle_of(to, l, made, k, i, first);
        const uint32_t four[4][3] = {{a, ac, da}, {ac, c, cd}, {da, cd, d}, {ac, cd, da}};
        memcpy(triangles[count], four, sizeof four);
        count += 4;
    }
    for (uint32_t n = 0; n < count && !to->failed; n++) {
        const uint32_t *t = triangles[n];
        if (!l->faceted) {
            bolan_build_triangle(b, t[0], t[1], t[2]);
            continue;
        }
        const bolan_vec4 c = to->colors[t[n % 3]];
        bolan_build_facet(b, to->positions[t[0]], to->positions[t[1]], to->positions[t[2]], bolan_v3(c.x, c.y, c.z),
                          c.w);
    }
    b->failed |= to->failed;
    bolan_build_free(&loose);
}

// ---- chance ---------------------------------------------------------------------------------------------------------

float bolan_build_random(uint32_t *state) {
    uint32_t h = *state += 0x9e3779b9u;
    h = (h ^ (h >> 16)) * 0x85ebca6bu;
    h = (h ^ (h >> 13)) * 0xc2b2ae35u;
    return (float)((h ^ (h >> 16)) >> 8) * 0x1p-24f;
}

float bolan_build_between(uint32_t *state, float low, float high) {
    return low + (high - low) * bolan_build_random(state);
}

bolan_vec3 bolan_build_direction(uint32_t *state) {
    double s, c;
    const float z = bolan_build_between(state, -1.0f, 1.0f), r = sqrtf(1.0f - z * z);
    bolan_sincos(2.0 * BOLAN_PI * (double)bolan_build_random(state), &s, &c);
    return bolan_v3(r * (float)c, r * (float)s, z);
}

bolan_vec3 bolan_build_vary(uint32_t *state, bolan_vec3 color, float share) {
    return bolan_v3_scale(color, 1.0f + bolan_build_between(state, -share, share));
}

// ---- leaves ---------------------------------------------------------------------------------------------------------

void bolan_build_leaf(model_builder *b, uint32_t *state, bolan_vec3 at, bolan_vec3 out, float size, bolan_vec3 color,
                      float open) {
    const bolan_vec3 u = bolan_build_direction(state);
    bolan_vec3 v = bolan_v3_cross(u, bolan_build_direction(state));
    v = bolan_v3_scale(v, 1.0f / fmaxf(bolan_v3_length(v), 0.2f));
    const bolan_vec3 c = bolan_build_vary(state, color, 0.3f);
    const uint32_t i = bolan_build_vertex(b, bolan_v3_add(at, bolan_v3_scale(u, size)), out, c, open);
    const uint32_t j =
        bolan_build_vertex(b, bolan_v3_add(at, bolan_v3_scale(v, 0.7f * size)), out, bolan_v3_scale(c, 0.85f), open);
    bolan_build_triangle(b, i, j,
                         bolan_build_vertex(b, bolan_v3_sub(at, bolan_v3_scale(u, 0.8f * size)), out, c, open));
}

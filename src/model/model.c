// SPDX-License-Identifier: MIT
// The life of models.
#include "bolan/model.h"

#include <string.h>

#define LARGEST (1u << 26) // vertices and indices: far beyond what is drawn, and their bytes fit into 32 bits

struct bolan_model {
    uint32_t vertex_count, index_count;
    bolan_vec3 *positions, *normals;
    bolan_vec4 *colors;
    uint32_t *indices;
    bolan_vec3 low, high;
    uint64_t id;
};

static uint64_t hash_bytes(uint64_t h, const void *bytes, size_t size) {
    const unsigned char *p = bytes;
    for (; size >= 4; p += 4, size -= 4) { // all arrays are of 4-byte values
        uint32_t word;
        memcpy(&word, p, sizeof word);
        h = (h ^ word) * 0x9e3779b97f4a7c15ULL;
        h ^= h >> 29;
    }
    return h;
}

static bolan_result refuse(const char *what, uint32_t at) {
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_BAD_ARGUMENT, "model: %s (at %u)", what, (unsigned)at);
    return BOLAN_ERROR_ARGUMENT;
}

static bool finite3(bolan_vec3 v) { return isfinite(v.x) && isfinite(v.y) && isfinite(v.z); }

static bolan_result check_view(const bolan_model_view *v) {
    if (!v->positions || !v->normals || !v->colors || !v->indices)
        return refuse("an array is missing; expected positions, normals, colors and indices", 0);
    if (v->vertex_count < 3 || v->vertex_count > LARGEST || v->index_count > LARGEST)
        return refuse("expected 3 to 67108864 vertices and at most as many indices", v->vertex_count);
    if (v->index_count < 3 || v->index_count % 3 != 0)
        return refuse("the number of indices is not that of whole triangles", v->index_count);
    for (uint32_t i = 0; i < v->index_count; i++)
        if (v->indices[i] >= v->vertex_count) return refuse("an index is beyond the last vertex", i);
    for (uint32_t i = 0; i < v->vertex_count; i++) {
        const bolan_vec4 *c = &v->colors[i];
        if (!finite3(v->positions[i]) || !finite3(v->normals[i]) || !isfinite(c->x + c->y + c->z + c->w))
            return refuse("a vertex is not finite", i);
    }
    return BOLAN_OK;
}

static void measure(bolan_model *m) {
    m->low = m->high = m->positions[0];
    for (uint32_t i = 1; i < m->vertex_count; i++) {
        const bolan_vec3 p = m->positions[i];
        m->low = bolan_v3(fminf(m->low.x, p.x), fminf(m->low.y, p.y), fminf(m->low.z, p.z));
        m->high = bolan_v3(fmaxf(m->high.x, p.x), fmaxf(m->high.y, p.y), fmaxf(m->high.z, p.z));
    }
    uint64_t h = 0x243f6a8885a308d3ULL ^ m->vertex_count;
    h = hash_bytes(h, m->positions, m->vertex_count * sizeof *m->positions);
    h = hash_bytes(h, m->normals, m->vertex_count * sizeof *m->normals);
    h = hash_bytes(h, m->colors, m->vertex_count * sizeof *m->colors);
    m->id = hash_bytes(h, m->indices, m->index_count * sizeof *m->indices);
}

static void *copy(const void *from, size_t size) {
    void *to = bolan_allocate(size);
    if (to) memcpy(to, from, size);
    return to;
}

bolan_result bolan_model_create(const bolan_model_view *view, bolan_model **out) {
    BOLAN_ASSERT(view && out);
    *out = NULL;
    const bolan_result result = check_view(view);
    if (result) return result;
    bolan_model *m = bolan_allocate(sizeof *m);
    if (m) {
        m->vertex_count = view->vertex_count;
        m->index_count = view->index_count;
        m->positions = copy(view->positions, view->vertex_count * sizeof *m->positions);
        m->normals = copy(view->normals, view->vertex_count * sizeof *m->normals);
        m->colors = copy(view->colors, view->vertex_count * sizeof *m->colors);
        m->indices = copy(view->indices, view->index_count * sizeof *m->indices);
    }
    if (!m || !m->positions || !m->normals || !m->colors || !m->indices) {
        bolan_model_destroy(&m);
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY, "no memory for a model of %u vertices",
                  (unsigned)view->vertex_count);
        return BOLAN_ERROR_MEMORY;
    }
    measure(m);
    *out = m;
    return BOLAN_OK;
}

void bolan_model_destroy(bolan_model **model) {
    if (!model || !*model) return;
    bolan_model *m = *model;
    bolan_release(m->positions, m->vertex_count * sizeof *m->positions);
    bolan_release(m->normals, m->vertex_count * sizeof *m->normals);
    bolan_release(m->colors, m->vertex_count * sizeof *m->colors);
    bolan_release(m->indices, m->index_count * sizeof *m->indices);
    bolan_release(m, sizeof *m);
    *model = NULL;
}

bolan_model_view bolan_model_get_view(const bolan_model *m) {
    BOLAN_ASSERT(m);
    return (bolan_model_view){m->vertex_count, m->index_count, m->positions, m->normals, m->colors, m->indices};
}

uint64_t bolan_model_id(const bolan_model *model) { return model->id; }

void bolan_model_bounds(const bolan_model *model, bolan_vec3 *low, bolan_vec3 *high) {
    *low = model->low;
    *high = model->high;
}

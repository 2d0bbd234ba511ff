// SPDX-License-Identifier: MIT
// The meshes of the scene's objects on the GPU, and their triangles sorted by their side of the water.
#include "pass_objects.h"

#include "memory.h"

#include <string.h>

#define VERTEX_FLOATS 10 // position, normal, colour and openness
#define OVERLAP 0.25f // [m], as in planar_views.c: what stands clear of the water by more is cut by no picture's plane

static void free_model(gpu_model *g) {
    bolan_gl_mesh_free(&g->mesh);
    bolan_gl_buffer_free(&g->vertices);
    bolan_gl_buffer_free(&g->indices);
    *g = (gpu_model){0};
}

static void free_sorted(sorted *s) {
    bolan_gl_mesh_free(&s->mesh);
    bolan_gl_buffer_free(&s->indices);
    *s = (sorted){0};
}

void bolan_object_meshes_free(pass_objects *p) {
    for (int i = 0; i < BOLAN_MAX_OBJECTS; i++) free_model(&p->models[i]);
    for (int i = 0; i < BOLAN_MAX_OBJECTS; i++) free_sorted(&p->sorted[i]);
}

static bool lies_flat(const bolan_model_view *v) {
    for (uint32_t i = 0; i < v->vertex_count; i++)
        if (v->normals[i].z < 0.2f) return false;
    return true;
}

static bolan_result upload(const bolan_model *model, gpu_model *g) {
    static const uint8_t components[] = {3, 3, 4};
    const bolan_model_view v = bolan_model_get_view(model);
    const size_t stride = VERTEX_FLOATS * sizeof(float), bytes = v.vertex_count * stride;
    float *staging = allocate_for("the vertices of an object", bytes);
    if (!staging) return BOLAN_ERROR_MEMORY;
    for (uint32_t i = 0; i < v.vertex_count; i++) {
        memcpy(staging + i * VERTEX_FLOATS, &v.positions[i], 3 * sizeof(float));
        memcpy(staging + i * VERTEX_FLOATS + 3, &v.normals[i], 3 * sizeof(float));
        memcpy(staging + i * VERTEX_FLOATS + 6, &v.colors[i], 4 * sizeof(float));
    }
    bolan_result r = bolan_gl_buffer_create(GL_BUFFER_VERTEX, GL_USAGE_STATIC, bytes, staging, &g->vertices);
    if (r == BOLAN_OK)
        r = bolan_gl_buffer_create(GL_BUFFER_INDEX, GL_USAGE_STATIC, v.index_count * sizeof *v.indices, v.indices,
                                   &g->indices);
    if (r == BOLAN_OK) r = bolan_gl_mesh_create(&g->vertices, &g->indices, components, 3, (uint32_t)stride, &g->mesh);
    bolan_release(staging, bytes);
    g->id = bolan_model_id(model);
    g->index_count = v.index_count;
    bolan_vec3 low, high;
    bolan_model_bounds(model, &low, &high);
    // Large things are looked at from afar.
    g->period = fminf(fmaxf(0.16f * fmaxf(high.x - low.x, high.z - low.z), 0.8f), 6.0f);
    g->flat = lies_flat(&v);
    if (r != BOLAN_OK) free_model(g);
    return r;
}

gpu_model *bolan_object_mesh_find(pass_objects *p, uint64_t id) {
    for (int i = 0; i < BOLAN_MAX_OBJECTS; i++)
        if (p->models[i].id == id && p->models[i].mesh.vao) return &p->models[i];
    return NULL;
}

gpu_model *bolan_object_mesh_keep(pass_objects *p, const bolan_model *model) {
    gpu_model *g = bolan_object_mesh_find(p, bolan_model_id(model));
    for (int i = 0; i < BOLAN_MAX_OBJECTS && !g; i++)
        if (!p->models[i].wanted) g = &p->models[i];
    if (!g) return NULL;
    if (!g->mesh.vao || g->id != bolan_model_id(model)) {
        free_model(g);
        if (upload(model, g) != BOLAN_OK) return NULL;
    }
    g->wanted = true;
    return g;
}

// ---- classes --------------------------------------------------------------------------------------------------------

static int class_of(double lowest, double highest) {
    return lowest > (double)OVERLAP ? ABOVE : highest < (double)-OVERLAP ? BELOW : ACROSS;
}

// place: the row of the matrix that makes heights over the water.
static int class_of_triangle(const bolan_model_view *v, const uint32_t *triangle, const float place[4]) {
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (int k = 0; k < 3; k++) {
        const bolan_vec3 at = v->positions[triangle[k]];
        const double z = (double)(place[0] * at.x + place[1] * at.y + place[2] * at.z + place[3]);
        low = fmin(low, z), high = fmax(high, z);
    }
    return class_of(low, high);
}

static bolan_result upload_sorted(const bolan_model_view *v, const gpu_model *g, sorted *s) {
    static const uint8_t components[] = {3, 3, 4};
    const size_t bytes = v->index_count * sizeof *v->indices;
    uint32_t *staging = allocate_for("the triangles of an object", bytes);
    if (!staging) return BOLAN_ERROR_MEMORY;
    uint32_t n = 0;
    for (int c = 0; c < CLASSES; c++) {
        const uint32_t start = n;
        for (uint32_t i = 0; i + 2 < v->index_count; i += 3) {
            if (class_of_triangle(v, v->indices + i, s->place) != c) continue;
            memcpy(staging + n, v->indices + i, 3 * sizeof *staging);
            n += 3;
        }
        s->counts[c] = n - start;
    }
    bolan_result r = bolan_gl_buffer_create(GL_BUFFER_INDEX, GL_USAGE_STATIC, bytes, staging, &s->indices);
    if (r == BOLAN_OK)
        r = bolan_gl_mesh_create(&g->vertices, &s->indices, components, 3, VERTEX_FLOATS * sizeof(float), &s->mesh);
    bolan_release(staging, bytes);
    return r;
}

void bolan_object_mesh_sort(sorted *s, placed *o, const bolan_model *model, bool floats, float eye_over_water) {
    const int whole = class_of(o->lowest, o->highest);
    o->mesh = &o->gpu->mesh;
    memset(o->counts, 0, sizeof o->counts);
    o->counts[whole] = o->gpu->index_count;
    if (whole != ACROSS || floats) return;
    float place[4];
    memcpy(place, o->rows + 8, sizeof place);
    place[3] += eye_over_water;
    const bool same = s->mesh.vao && s->id == o->gpu->id && memcmp(place, s->place, sizeof(float[3])) == 0;
    if (!same || fabsf(place[3] - s->place[3]) > 1e-3f) { // the eye's height is added to a rounded difference
        free_sorted(s);
        memcpy(s->place, place, sizeof place);
        const bolan_model_view v = bolan_model_get_view(model);
        s->id = o->gpu->id;
        if (upload_sorted(&v, o->gpu, s) != BOLAN_OK) {
            free_sorted(s);
            return;
        }
    }
    o->mesh = &s->mesh;
    memcpy(o->counts, s->counts, sizeof o->counts);
}

// SPDX-License-Identifier: MIT
// The water: the sea's waves on the GPU (water_fields.c), the surface of this view (water_mesh.c), and the optics that the scene's
// technique names (water_optics.h).
#include "memory.h"
#include "water_sparse.h"

#include <string.h>

struct pass_water {
    bolan_quality quality;
    water_fields fields;
    water_mesh mesh;
    water_programs programs;
    water_sparse sparse;
    void *state[BOLAN_OPTICS_KINDS]; // of the optics, made when it is first needed
    bool failed[BOLAN_OPTICS_KINDS]; // it could not be made, and the log says why
    bool ready;                      // the waves of this frame are on the GPU
};

static const water_optics *const optics_table[BOLAN_OPTICS_KINDS] = {
    [BOLAN_OPTICS_PHYSICAL] = &optics_physical, [BOLAN_OPTICS_MIRROR] = &optics_mirror,
    [BOLAN_OPTICS_PHONG] = &optics_phong,       [BOLAN_OPTICS_LIT] = &optics_lit,
    [BOLAN_OPTICS_CREST] = &optics_crest,
};

bolan_result pass_water_create(bolan_quality quality, uint32_t max_vertices, pass_water **out) {
    pass_water *p = allocate_for("the pass of the water", sizeof *p);
    if (p == NULL) return BOLAN_ERROR_MEMORY;
    p->quality = quality;
    bolan_result result = water_fields_create(&p->fields);
    if (result == BOLAN_OK) result = water_mesh_create(&p->mesh, quality, max_vertices);
    if (result != BOLAN_OK) {
        pass_water_destroy(&p);
        return result;
    }
    *out = p;
    return BOLAN_OK;
}

void pass_water_destroy(pass_water **pass) {
    if (pass == NULL || *pass == NULL) return;
    pass_water *p = *pass;
    for (int i = 0; i < BOLAN_OPTICS_KINDS; ++i) {
        if (p->state[i] != NULL) optics_table[i]->free(p->state[i]);
        bolan_release(p->state[i], optics_table[i]->size);
    }
    for (uint32_t i = 0; i < p->programs.count; ++i) gl_program_free(&p->programs.list[i].program);
    water_sparse_free(&p->sparse);
    water_fields_free(&p->fields);
    water_mesh_free(&p->mesh);
    bolan_release(p, sizeof *p);
    *pass = NULL;
}

bolan_result pass_water_reload(pass_water *p) {
    bolan_result result = BOLAN_OK;
    for (uint32_t i = 0; i < p->programs.count && result == BOLAN_OK; ++i)
        result = gl_program_reload(&p->programs.list[i].program);
    return result == BOLAN_OK ? water_sparse_reload(&p->sparse) : result;
}

static void make_state(pass_water *p, bolan_optics_kind kind) {
    const water_optics *o = optics_table[kind];
    if (p->state[kind] != NULL || p->failed[kind]) return;
    p->state[kind] = allocate_for("the optics of the water", o->size);
    p->failed[kind] = p->state[kind] == NULL || o->create(p->state[kind], p->quality) != BOLAN_OK;
}

static water_draw draw_of(pass_water *p, frame *f) {
    water_draw d = {.f = f,
                    .fields = &p->fields,
                    .mesh = &p->mesh,
                    .programs = &p->programs,
                    .waves = water_waves_of(bolan_sea_get_desc(f->desc->sea)->waves, water_surface(f))};
    double horizontal;
    bolan_sea_bounds(f->desc->sea, &d.vertical, &horizontal);
    return d;
}

bool pass_water_seen_from_below(const bolan_scene *s) { return optics_table[s->technique.optics]->from_below; }

uint32_t pass_water_rows(const frame *f) {
    double vertical, horizontal;
    bolan_sea_bounds(f->desc->sea, &vertical, &horizontal);
    return water_rows(f, vertical);
}

// The world behind the water is not looked at by an optics that has pictures of it, so it need not be shaded. Two triangles cost
// nothing to draw twice; a mesh would.
void pass_water_cover(pass_water *p, frame *f) {
    if (water_surface(f) != BOLAN_SURFACE_QUAD || !pass_water_mirrors(f) || water_mesh_triangles(&p->mesh) == 0) return;
    water_draw d = draw_of(p, f);
    if (!water_program(&d, "water_cover", 0, "")) return;
    gl_set_state(&(gl_state){.depth_test = true, .depth_write = true});
    water_mesh_draw(&p->mesh);
}

// Something other than water may be in the picture.
static bool is_opaque(const frame *f) {
    return f->desc->terrain != NULL || (f->desc->models != NULL && f->scene->object_count > 0);
}

bool pass_water_mirrors(const frame *f) {
    const water_optics *o = optics_table[f->scene->technique.optics];
    return o->mirrors && (!o->own_sky || is_opaque(f));
}

bool pass_water_mirrors_sky(const frame *f) { return !optics_table[f->scene->technique.optics]->own_sky; }

void pass_water_prepare(pass_water *p, frame *f) {
    const bolan_technique *t = &f->scene->technique;
    const water_optics *o = optics_table[t->optics];
    water_draw d = draw_of(p, f);
    make_state(p, t->optics);
    const bool table_only = o->table_only != NULL && o->table_only(f->scene);
    p->ready = water_fields_prepare(&p->fields, f, d.waves,
                                    table_only  ? WATER_TEXTURES_NONE
                                    : o->packed ? WATER_TEXTURES_PACKED
                                                : WATER_TEXTURES_ALL);
    const bool edges = f->scene->look.show == BOLAN_SHOW_MESH; // these are made of the mesh that the CPU has
    water_mesh_build(&p->mesh, f, water_surface(f), d.waves, o->static_grid && !edges);
    if (o->prepare != NULL && !p->failed[t->optics]) o->prepare(p->state[t->optics], &d);
}

// BOLAN_SHOW_MESH: the triangles, whichever optics would light them.
static void draw_edges(pass_water *p, const water_draw *d) {
    if (!water_mesh_find_edges(&p->mesh) || !water_program(d, "water_mesh", 1, "FILL 1\n")) return;
    water_draw_forward(d);
    if (water_program(d, "water_mesh", 0, "")) water_mesh_draw_edges(&p->mesh);
}

frame pass_water_sparse(pass_water *p, const frame *f) {
    const water_optics *o = optics_table[f->scene->technique.optics];
    const uint32_t columns = water_mesh_triangles(&p->mesh) > 0 ? water_sparse_columns(f, o->columns) : 1;
    return water_sparse_begin(&p->sparse, f, columns, o->keeps_shape, is_opaque(f));
}

void pass_water_lay(pass_water *p, frame *f) {
    water_draw d = draw_of(p, f);
    water_sparse_lay(&p->sparse, &d, optics_table[f->scene->technique.optics]->keeps_shape, is_opaque(f));
}

void pass_water_draw(pass_water *p, frame *f) {
    const bolan_optics_kind kind = f->scene->technique.optics;
    if (water_mesh_triangles(&p->mesh) == 0 || p->failed[kind] || !p->ready) return;
    water_draw d = draw_of(p, f);
    water_fields_bind(&p->fields, d.waves);
    if (f->scene->look.show == BOLAN_SHOW_MESH)
        draw_edges(p, &d);
    else
        optics_table[kind]->draw(p->state[kind], &d);
    f->triangles += water_mesh_triangles(&p->mesh);
    f->water_triangles += water_mesh_triangles(&p->mesh);
}

// SPDX-License-Identifier: MIT
// The water: the sea's waves on the GPU (sea_gpu.c), the surface of this view (water_mesh.c), and the optics that the
// scene's technique names (water_optics.h).
#include "below.h"
#include "foam_statistics.h"
#include "half_rate.h"
#include "memory.h"

#include <math.h>
#include <string.h>

struct pass_water {
    bolan_quality quality;
    sea_gpu fields;
    water_mesh mesh;
    water_programs programs;
    water_block_buffers blocks;
    half_rate sparse;
    void *state[BOLAN_OPTICS_KINDS]; // of the optics, made when it is first needed
    bool failed[BOLAN_OPTICS_KINDS]; // it could not be made, and the log says why
    bool ready;                      // the waves of this frame are on the GPU
};

static const water_optics *const optics_table[BOLAN_OPTICS_KINDS] = {
    [BOLAN_OPTICS_PHYSICAL] = &bolan_optics_physical, [BOLAN_OPTICS_MIRROR] = &bolan_optics_mirror,
    [BOLAN_OPTICS_PHONG] = &bolan_optics_phong,       [BOLAN_OPTICS_LIT] = &bolan_optics_lit,
    [BOLAN_OPTICS_CREST] = &bolan_optics_crest,
};

static const water_shader cover_shader = {.stem = "water_depth", .reads = WATER_FEATURE_ALL};
static const water_shader edge_shader = {.stem = "wireframe", .reads = WATER_FEATURE_ALL, .defines = {"FILL 1\n"}};
enum { EDGES_FILL = 1 };
static const water_shader motion_shader = {
    .stem = "motion", .reads = WATER_FEATURE_LAND | WATER_FEATURE_BOUND, .defines = {"WATER 1\n"}};
enum { MOTION_WATER = 1 };

bolan_result bolan_pass_water_create(bolan_quality quality, uint32_t max_vertices, pass_water **out) {
    pass_water *p = allocate_for("the pass of the water", sizeof *p);
    if (p == NULL) return BOLAN_ERROR_MEMORY;
    p->quality = quality;
    bolan_result result = bolan_sea_gpu_create(&p->fields);
    if (result == BOLAN_OK) result = bolan_water_blocks_create(&p->blocks);
    if (result == BOLAN_OK) result = bolan_water_mesh_create(&p->mesh, quality, max_vertices);
    if (result != BOLAN_OK) {
        bolan_pass_water_destroy(&p);
        return result;
    }
    *out = p;
    return BOLAN_OK;
}

void bolan_pass_water_destroy(pass_water **pass) {
    if (pass == NULL || *pass == NULL) return;
    pass_water *p = *pass;
    for (int i = 0; i < BOLAN_OPTICS_KINDS; ++i) {
        if (p->state[i] != NULL) optics_table[i]->free(p->state[i]);
        bolan_release(p->state[i], optics_table[i]->size);
    }
    bolan_water_programs_free(&p->programs);
    bolan_water_blocks_free(&p->blocks);
    bolan_half_rate_free(&p->sparse);
    bolan_sea_gpu_free(&p->fields);
    bolan_water_mesh_free(&p->mesh);
    bolan_release(p, sizeof *p);
    *pass = NULL;
}

bool bolan_pass_water_needs_baking(const pass_water *p, const frame *f) {
    const bolan_optics_kind kind = f->lighting.technique.optics;
    const water_optics *o = optics_table[kind];
    return o->stale != NULL && p->state[kind] != NULL && !p->failed[kind] && o->stale(p->state[kind]);
}

bolan_result bolan_pass_water_reload(pass_water *p) {
    bolan_result result = bolan_water_programs_reload(&p->programs);
    if (result == BOLAN_OK) result = bolan_half_rate_reload(&p->sparse);
    for (int i = 0; i < BOLAN_OPTICS_KINDS && result == BOLAN_OK; ++i)
        if (p->state[i] != NULL && !p->failed[i] && optics_table[i]->reload != NULL)
            result = optics_table[i]->reload(p->state[i]);
    return result;
}

static void make_state(pass_water *p, bolan_optics_kind kind) {
    const water_optics *o = optics_table[kind];
    if (p->state[kind] != NULL || p->failed[kind]) return;
    p->state[kind] = allocate_for("the optics of the water", o->size);
    p->failed[kind] = p->state[kind] == NULL || o->create(p->state[kind], p->quality) != BOLAN_OK;
}

static water_draw draw_of(pass_water *p, render_view *v) {
    water_draw d = {.view = v,
                    .fields = &p->fields,
                    .mesh = &p->mesh,
                    .programs = &p->programs,
                    .blocks = &p->blocks,
                    .packed = optics_table[v->frame->lighting.technique.optics]->packed,
                    .waves = bolan_water_waves_of(bolan_sea_form(v->frame->sea), bolan_water_surface(v))};
    double horizontal;
    bolan_water_bounds(&v->frame->water, &d.vertical, &horizontal);
    return d;
}

static const water_optics *optics_of(const frame *f) { return optics_table[f->lighting.technique.optics]; }

static bool can_draw(const pass_water *p, const frame *f) { return !p->failed[f->lighting.technique.optics]; }

bool bolan_pass_water_looks_through(const frame *f) { return optics_of(f)->looks_through; }

bool bolan_pass_water_has_body(const frame *f) { return optics_of(f)->draw_body != NULL; }

void bolan_pass_water_place(const frame *f, render_view *v) {
    v->medium = EYE_IN_AIR;
    if (optics_of(f)->draw_below == NULL || v->without_water) return;
    v->medium = bolan_below_medium(f, v->eye);
    if (v->medium == EYE_AT_WATERLINE) bolan_view_set_near(v, fmax(v->near_distance, WATERLINE_NEAR));
    if (v->medium == EYE_IN_WATER) bolan_view_set_near(v, fmin(v->near_distance, WATERLINE_NEAR));
}

bool bolan_pass_water_mirrors(const frame *f) {
    const water_optics *o = optics_of(f);
    return o->planar_mirrors && (!o->own_sky || f->behind);
}

// An optics with planar views does not look through the water at the world behind, so that need not be shaded. Two
// triangles cost nothing to draw twice; a mesh would.
void bolan_pass_water_cover(pass_water *p, render_view *v) {
    if (bolan_water_surface(v) != BOLAN_SURFACE_QUAD || !bolan_pass_water_mirrors(v->frame) ||
        bolan_water_mesh_triangles(&p->mesh) == 0)
        return;
    water_draw d = draw_of(p, v);
    if (!bolan_water_program(&d, &cover_shader, 0)) return;
    bolan_gl_set_state(&(gl_state){.depth_test = true, .depth_write = true});
    bolan_water_mesh_draw(&p->mesh);
}

// ---- programs -------------------------------------------------------------------------------------------------------

static uint32_t columns_of(const frame *f) {
    const water_optics *o = optics_of(f);
    return o->shade_columns != NULL ? o->shade_columns(&f->lighting.look, f->quality) : 1;
}

static const mesh_rules *rules_of(const frame *f) {
    const water_optics *o = optics_of(f);
    return o->mesh != NULL ? o->mesh(&f->lighting.look) : NULL;
}

static water_setup setup_of(const frame *f) {
    const bolan_technique *t = &f->lighting.technique;
    const water_optics *o = optics_of(f);
    const bolan_wave_form form = bolan_sea_form(f->sea);
    const water_waves waves = bolan_water_waves_of(form, t->surface);
    const bool edges = f->lighting.look.show == BOLAN_SHOW_MESH;
    return (water_setup){.quality = f->quality,
                         .waves = waves,
                         .waves_below = bolan_water_waves_of(form, BOLAN_SURFACE_QUAD),
                         .surface = t->surface,
                         .below = o->draw_body != NULL,
                         .land = f->behind,
                         .static_grid =
                             bolan_water_mesh_is_fixed(t->surface, waves, (mesh_wishes){.on_cpu = edges}, rules_of(f)),
                         .packed = o->packed,
                         .bounds = f->bounds_count > 0,
                         .layers = f->water.layer_count > 0,
                         .bound_waves = bolan_sea_get_desc(f->sea)->order > 1,
                         .compute = f->compute_pixels,
                         .look = &f->lighting.look,
                         .foams = bolan_foam_can_form(f->sea),
                         .streaks = bolan_foam_streak_share(f->sea) > 0.0,
                         .shares_samples = columns_of(f) > 1,
                         .edges = edges,
                         .wave_count = bolan_sea_component_count(f->sea),
                         .cascades = waves == WATER_CASCADES ? bolan_sea_cascade_count(f->sea) : 1};
}

// The quad's surface is flat, and the sums of cosines are on no texture.
static bool moves_with_cascades(water_waves waves, bolan_surface_kind surface) {
    return waves == WATER_CASCADES && surface != BOLAN_SURFACE_QUAD;
}

static void list_edges(pass_water *p, const water_setup *s) {
    for (int below = 0; below <= s->below; ++below) {
        bolan_water_programs_add(&p->programs, s, below, &edge_shader, EDGES_FILL);
        bolan_water_programs_add(&p->programs, s, below, &edge_shader, 0);
    }
}

// Everything that frames of this setup can need, wherever the eye goes.
static void list_programs(pass_water *p, const frame *f, const water_setup *s) {
    const bolan_optics_kind kind = f->lighting.technique.optics;
    const water_optics *o = optics_of(f);
    if (s->edges) list_edges(p, s);
    if (f->motion && moves_with_cascades(s->waves, s->surface))
        bolan_water_programs_add(&p->programs, s, false, &motion_shader, MOTION_WATER);
    if (!p->failed[kind]) o->list(p->state[kind], s, &p->programs);
    if (o->planar_mirrors && s->surface == BOLAN_SURFACE_QUAD)
        bolan_water_programs_add(&p->programs, s, false, &cover_shader, 0);
    if (o->planar_mirrors && s->below) bolan_water_programs_add(&p->programs, s, true, &cover_shader, 0);
    if (s->shares_samples) bolan_half_rate_prepare(&p->sparse, s, o->shape != NULL, &p->programs);
}

static void prepare_programs(pass_water *p, const frame *f) {
    const water_setup s = setup_of(f);
    p->programs.refused = false;
    list_programs(p, f, &s);
    bolan_water_programs_compile(&p->programs, NULL, NULL);
}

bolan_result bolan_pass_water_compile(pass_water *p, const frame *f, bolan_progress *progress, void *user) {
    water_setup s = setup_of(f);
    make_state(p, f->lighting.technique.optics);
    p->programs.refused = false;
    for (int land = f->ground != NULL; land <= 1; ++land)
        for (int rest = 0; rest < 4; ++rest) {
            s.land = land;
            s.bounds = rest & 1;
            s.layers = rest >> 1;
            list_programs(p, f, &s);
        }
    bolan_water_programs_compile(&p->programs, progress, user);
    if (f->compute != NULL && s.waves == WATER_CASCADES && !bolan_sea_gpu_compile(f, optics_of(f)->packed))
        return BOLAN_ERROR_GL;
    if (p->programs.refused) return BOLAN_ERROR_MEMORY;
    return can_draw(p, f) && bolan_water_programs_are_whole(&p->programs) ? BOLAN_OK : BOLAN_ERROR_GL;
}

void bolan_pass_water_prepare(pass_water *p, frame *f) {
    const bolan_technique *t = &f->lighting.technique;
    const water_optics *o = optics_table[t->optics];
    make_state(p, t->optics);
    const bool table_only = o->table_only != NULL && !p->failed[t->optics] && o->table_only(p->state[t->optics], f);
    p->ready = bolan_sea_gpu_prepare(&p->fields, f,
                                     table_only  ? WATER_TEXTURES_NONE
                                     : o->packed ? WATER_TEXTURES_PACKED
                                                 : WATER_TEXTURES_ALL);
}

void bolan_pass_water_view(pass_water *p, render_view *v) {
    const bolan_technique *t = &v->frame->lighting.technique;
    const water_optics *o = optics_table[t->optics];
    water_draw d = draw_of(p, v);
    bolan_sea_gpu_view(&p->fields, v, d.waves);
    const bool edges = v->frame->lighting.look.show == BOLAN_SHOW_MESH; // these are made of the mesh that the CPU has
    const mesh_wishes wishes = {.coarse = o->coarse_grid, .on_cpu = edges};
    bolan_water_mesh_build(&p->mesh, v, bolan_water_surface(v), d.waves, wishes, rules_of(v->frame));
    if (o->prepare != NULL && !p->failed[t->optics]) o->prepare(p->state[t->optics], &d);
    prepare_programs(p, v->frame);
    water_block block;
    bolan_water_fill(&block, &d);
    bolan_water_blocks_upload(&p->blocks, &block);
    if (o->gather == NULL || p->failed[t->optics] || !p->ready) return;
    bolan_sea_gpu_bind(&p->fields, d.waves);
    o->gather(p->state[t->optics], &d);
}

// BOLAN_SHOW_MESH: the triangles, whichever optics would light them.
static void draw_edges(pass_water *p, const water_draw *d) {
    if (!bolan_water_mesh_find_edges(&p->mesh) || !bolan_water_program(d, &edge_shader, EDGES_FILL)) return;
    bolan_water_draw_forward(d);
    if (bolan_water_program(d, &edge_shader, 0)) bolan_water_mesh_draw_edges(&p->mesh);
}

static void count_triangles(const pass_water *p, render_view *v) {
    v->triangles += bolan_water_mesh_triangles(&p->mesh);
    v->water_triangles += bolan_water_mesh_triangles(&p->mesh);
}

static void draw_surface(pass_water *p, render_view *v) {
    water_draw d = draw_of(p, v);
    bolan_sea_gpu_bind(&p->fields, d.waves);
    if (v->frame->lighting.look.show == BOLAN_SHOW_MESH)
        draw_edges(p, &d);
    else
        optics_of(v->frame)->draw(p->state[v->frame->lighting.technique.optics], &d);
    count_triangles(p, v);
}

void bolan_pass_water_behind(pass_water *p, render_view *v, const world_drawer *world) {
    if ((!bolan_pass_water_mirrors(v->frame) && v->medium == EYE_IN_AIR) || !can_draw(p, v->frame)) return;
    const water_draw d = draw_of(p, v);
    optics_of(v->frame)->behind(p->state[v->frame->lighting.technique.optics], &d, world);
}

// With fewer samples than pixels, by the mesh. False: each pixel needs its own, or they cannot be had (logged).
static bool draw_shared(pass_water *p, render_view *v, uint32_t columns) {
    render_view sparse = bolan_half_rate_begin(&p->sparse, v, columns, false, v->frame->behind);
    if (sparse.shade_columns <= 1.0f) return false;
    bolan_view_use(&sparse);
    bolan_gl_target_bind(&sparse.hdr);
    draw_surface(p, &sparse);
    v->triangles = sparse.triangles;
    v->water_triangles = sparse.water_triangles;
    bolan_view_use(v);
    const water_draw d = draw_of(p, v);
    bolan_half_rate_lay_mesh(&p->sparse, &d);
    return true;
}

// Shades the kept shape up to that row with fewer samples than pixels; false as above.
static bool light_shared(pass_water *p, render_view *v, uint32_t columns, uint32_t rows) {
    const water_optics *o = optics_of(v->frame);
    if (rows == 0) return false;
    render_view sparse = bolan_half_rate_begin(&p->sparse, v, columns, true, v->frame->behind);
    if (sparse.shade_columns <= 1.0f) return false;
    bolan_view_use(&sparse);
    water_draw d = draw_of(p, &sparse);
    o->light(p->state[o->kind], &d, (water_rows){0, rows});
    bolan_view_use(v);
    d = draw_of(p, v);
    bolan_half_rate_lay_shape(&p->sparse, &d, v->frame->behind, rows);
    return true;
}

static void draw_kept(pass_water *p, render_view *v, uint32_t columns) {
    const water_optics *o = optics_of(v->frame);
    const water_draw d = draw_of(p, v);
    const uint32_t all = bolan_water_rows(v, d.vertical);
    const uint32_t shared = columns <= 1 ? 0 : o->shared_rows != NULL ? o->shared_rows(&d, all) : all;
    bolan_sea_gpu_bind(&p->fields, d.waves);
    if (o->shape(p->state[o->kind], &d)) {
        const water_rows rest = {light_shared(p, v, columns, shared) ? shared : 0, all};
        if (rest.from < rest.to) o->light(p->state[o->kind], &d, rest);
    }
    bolan_gl_target_bind(&v->hdr);
    count_triangles(p, v);
}

void bolan_pass_water_draw(pass_water *p, render_view *v) {
    if (bolan_water_mesh_triangles(&p->mesh) == 0 || !can_draw(p, v->frame) || !p->ready) return;
    const uint32_t columns = bolan_half_rate_columns(v, v->medium == EYE_IN_AIR ? columns_of(v->frame) : 1);
    if (optics_of(v->frame)->shape != NULL && v->frame->lighting.look.show != BOLAN_SHOW_MESH) {
        draw_kept(p, v, columns);
        return;
    }
    if (draw_shared(p, v, columns)) return;
    bolan_gl_target_bind(&v->hdr);
    draw_surface(p, v);
}

void bolan_pass_water_draw_over(pass_water *p, render_view *v) {
    const water_optics *o = optics_of(v->frame);
    if (o->draw_over == NULL || v->medium != EYE_IN_AIR || !can_draw(p, v->frame) || !p->ready ||
        v->frame->lighting.look.show == BOLAN_SHOW_MESH || bolan_water_mesh_triangles(&p->mesh) == 0)
        return;
    const water_draw d = draw_of(p, v);
    bolan_sea_gpu_bind(&p->fields, d.waves);
    o->draw_over(p->state[o->kind], &d);
}

const gl_program *bolan_pass_water_use_motion(pass_water *p, render_view *v, double time_before) {
    const bolan_dvec2 now = bolan_frame_drift(v->frame), before = bolan_frame_drift_at(v->frame, time_before);
    const gl_texture *displacement = bolan_sea_gpu_before(&p->fields, time_before);
    const water_draw d = draw_of(p, v);
    if (!p->ready || v->without_water || v->medium != EYE_IN_AIR || displacement == NULL ||
        !moves_with_cascades(d.waves, bolan_water_surface(v)))
        return NULL;
    const gl_program *program = bolan_water_program(&d, &motion_shader, MOTION_WATER);
    if (program == NULL) return NULL;
    bolan_sea_gpu_bind(&p->fields, d.waves);
    bolan_gl_texture_bind(displacement, UNIT_OWN + 1);
    bolan_gl_program_vec2(program, "drift", (float)(now.x - before.x), (float)(now.y - before.y));
    return program;
}

void bolan_pass_water_draw_below(pass_water *p, render_view *v) {
    if (v->medium == EYE_IN_AIR || !can_draw(p, v->frame) || !p->ready) return;
    const water_optics *o = optics_of(v->frame);
    const uint32_t columns = bolan_half_rate_columns(v, v->medium == EYE_IN_WATER ? columns_of(v->frame) : 1);
    render_view sparse = bolan_half_rate_begin(&p->sparse, v, columns, true, false);
    water_draw d = draw_of(p, &sparse);
    bolan_sea_gpu_bind(&p->fields, d.waves);
    if (sparse.shade_columns > 1.0f) bolan_view_use(&sparse);
    o->draw_below(p->state[o->kind], &d);
    if (sparse.shade_columns <= 1.0f) return;
    bolan_view_use(v);
    d = draw_of(p, v);
    bolan_half_rate_lay_shape(&p->sparse, &d, false, v->hdr.height);
}

void bolan_pass_water_draw_body(pass_water *p, const frame *f) {
    if (can_draw(p, f)) optics_of(f)->draw_body(p->state[f->lighting.technique.optics]);
}

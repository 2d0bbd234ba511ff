// SPDX-License-Identifier: MIT
// The scene's objects: sets them on the waves and draws them. Shader: shaders/objects.glsl.
#include "pass_objects.h"

#include "bolan/query.h"
#include "memory.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define WIDEST_CASTER 30.0f // [m]: what is larger is a landscape

bolan_result bolan_pass_objects_create(const gl_caps *caps, pass_objects **out) {
    (void)caps;
    static const char *const defines[KINDS] = {[MAIN] = "",
                                               [WHOLE] = "PICTURE 1\n",
                                               [CUT] = "PICTURE 1\nCUT 1\n",
                                               [WET_WHOLE] = "PICTURE 1\nWET 1\n",
                                               [WET_CUT] = "PICTURE 1\nCUT 1\nWET 1\n"};
    *out = NULL;
    pass_objects *p = allocate_for("the pass of objects", sizeof *p);
    if (!p) return BOLAN_ERROR_MEMORY;
    bolan_result r = BOLAN_OK;
    for (int i = 0; i < 2 * KINDS && r == BOLAN_OK; i++) {
        char text[64];
        snprintf(text, sizeof text, "%s%s", i / KINDS ? "GROUND 1\n" : "", defines[i % KINDS]);
        r = bolan_gl_program_create("objects", text, &p->programs[i / KINDS][i % KINDS]);
    }
    if (r != BOLAN_OK) {
        bolan_pass_objects_destroy(&p);
        return r;
    }
    *out = p;
    return BOLAN_OK;
}

bolan_result bolan_pass_objects_reload(pass_objects *p) {
    bolan_result r = BOLAN_OK;
    for (int i = 0; i < 2 * KINDS && r == BOLAN_OK; i++)
        r = bolan_gl_program_reload(&p->programs[i / KINDS][i % KINDS]);
    return r;
}

void bolan_pass_objects_destroy(pass_objects **pass) {
    if (!pass || !*pass) return;
    pass_objects *p = *pass;
    bolan_object_meshes_free(p);
    for (int i = 0; i < 2 * KINDS; i++) bolan_gl_program_free(&p->programs[i / KINDS][i % KINDS]);
    bolan_release(p, sizeof *p);
    *pass = NULL;
}

// ---- places ---------------------------------------------------------------------------------------------------------

// The one place where doubles become eye-relative floats.
static void fill_rows(float to[12], const bolan_pose *p, double scale, bolan_dvec3 eye) {
    const float rows[12] = {(float)(scale * p->x.x),      (float)(scale * p->y.x),      (float)(scale * p->z.x),
                            (float)(p->origin.x - eye.x), (float)(scale * p->x.y),      (float)(scale * p->y.y),
                            (float)(scale * p->z.y),      (float)(p->origin.y - eye.y), (float)(scale * p->x.z),
                            (float)(scale * p->y.z),      (float)(scale * p->z.z),      (float)(p->origin.z - eye.z)};
    memcpy(to, rows, sizeof rows);
}

static bolan_vec3 transformed(const float rows[12], bolan_vec3 v) {
    return bolan_v3(rows[0] * v.x + rows[1] * v.y + rows[2] * v.z + rows[3],
                    rows[4] * v.x + rows[5] * v.y + rows[6] * v.z + rows[7],
                    rows[8] * v.x + rows[9] * v.y + rows[10] * v.z + rows[11]);
}

static bolan_vec3 corner_of(const placed *o, int i) {
    const bolan_vec3 corner = {i & 1 ? o->high.x : o->low.x, i & 2 ? o->high.y : o->low.y,
                               i & 4 ? o->high.z : o->low.z};
    return transformed(o->rows, corner);
}

// The object's height over the water and its distance: of the corners of its box.
static void measure_box(placed *to, double eye_over_water) {
    to->lowest = HUGE_VAL;
    to->highest = -HUGE_VAL;
    to->nearest = HUGE_VALF;
    for (int i = 0; i < 8; i++) {
        const bolan_vec3 corner = corner_of(to, i);
        const double z = (double)corner.z + eye_over_water;
        to->lowest = fmin(to->lowest, z);
        to->highest = fmax(to->highest, z);
        to->nearest = fminf(to->nearest, bolan_v3_length(corner));
    }
}

static int by_distance(const void *a, const void *b) {
    const float x = ((const placed *)a)->nearest, y = ((const placed *)b)->nearest;
    return (x > y) - (x < y);
}

// What stands up throws a shadow: an ellipsoid in the upper part of its box, where crowns and roofs are.
static void add_caster(pass_objects *p, placed *to, bolan_vec3 low, bolan_vec3 high, float scale) {
    const bolan_vec3 size = bolan_v3_scale(bolan_v3_sub(high, low), scale);
    to->caster = -1;
    if (p->caster_count == MAX_CASTERS || 0.25f * (size.x + size.y) > WIDEST_CASTER) return;
    if (fminf(size.x, fminf(size.y, size.z)) < 0.4f) return;
    const bolan_vec3 center = {0.5f * (low.x + high.x), 0.5f * (low.y + high.y), low.z + 0.56f * (high.z - low.z)};
    const bolan_vec3 at = transformed(to->rows, center);
    const float radius[3] = {0.5f * size.x, 0.5f * size.y, 0.44f * size.z};
    float *row = p->casters + CASTER_FLOATS * p->caster_count;
    for (int i = 0; i < 3; i++, row += 4) {
        const bolan_vec3 axis = {to->rows[i], to->rows[4 + i], to->rows[8 + i]}; // `scale` long
        const bolan_vec3 along = bolan_v3_scale(axis, 1.0f / (scale * radius[i]));
        const float map[4] = {along.x, along.y, along.z, -bolan_v3_dot(along, at)};
        memcpy(row, map, sizeof map);
    }
    to->caster = (int)p->caster_count++;
}

#define WET_FLOATING 0.06 // over the water or its crests [m]
#define WET_FIXED 0.5     // crests over the mean water, in significant wave heights, at what does not float

// Heights over the water level between which an object is wet.
static void measure_wet(placed *to, const bolan_object *o, const frame *f, double hs) {
    const bolan_dvec2 at = {o->position.x, o->position.y};
    float height = 0.0f;
    bolan_query_heights(&f->water, &at, 1, &height);
    to->wet[0] = height - (float)f->level;
    to->wet[1] = (o->floats ? to->wet[0] : (float)(WET_FIXED * hs)) + (float)WET_FLOATING;
}

// A second view of a step leaves the pose of the step before as it is.
static void note_motion(motion *m, const bolan_model *model, const bolan_pose *pose, double scale, double time) {
    if (m->id != bolan_model_id(model)) *m = (motion){.id = bolan_model_id(model), .time = NAN, .time_before = NAN};
    if (m->time != time) {
        m->time_before = m->time;
        m->before = m->pose;
        m->scale_before = m->scale;
    }
    m->time = time;
    m->pose = *pose;
    m->scale = scale;
}

// FNV-1a of numbers.
static void add_places(uint64_t *hash, const double *numbers, size_t count) {
    const uint8_t *bytes = (const uint8_t *)numbers;
    for (size_t i = 0; i < count * sizeof *numbers; i++) *hash = (*hash ^ bytes[i]) * 1099511628211u;
}

uint64_t bolan_pass_objects_places(const pass_objects *p) { return p->places; }

void bolan_pass_objects_prepare(pass_objects *p, render_view *v) {
    const bolan_scene *s = v->frame->scene;
    p->count = p->caster_count = 0;
    p->places = 14695981039346656037u;
    for (int i = 0; i < BOLAN_MAX_OBJECTS; i++) p->models[i].wanted = false;
    const uint32_t count = v->frame->models ? s->object_count : 0;
    const double hs = count > 0 && v->frame->sea ? bolan_sea_get_summary(v->frame->sea)->hs : 0.0;
    // First what is there already, so that nothing that is wanted makes way.
    for (uint32_t i = 0; i < count; i++) {
        gpu_model *g = v->frame->models[i] ? bolan_object_mesh_find(p, bolan_model_id(v->frame->models[i])) : NULL;
        if (g) g->wanted = true;
    }
    for (uint32_t i = 0; i < count; i++) {
        const bolan_model *model = v->frame->models[i];
        placed *to = &p->objects[p->count];
        if (!model || !(to->gpu = bolan_object_mesh_keep(p, model))) continue;
        to->index = i;
        bolan_model_bounds(model, &to->low, &to->high);
        const bolan_pose at = bolan_object_pose(&s->objects[i], model, &v->frame->water);
        fill_rows(to->rows, &at, s->objects[i].scale, v->eye);
        note_motion(&p->motions[i], model, &at, s->objects[i].scale, v->frame->time);
        add_places(&p->places, &at.origin.x, 3);
        add_places(&p->places, (const double[]){(double)at.x.x, (double)at.y.y, (double)at.z.z, (double)at.x.y}, 4);
        measure_box(to, v->eye.z - v->frame->level);
        measure_wet(to, &s->objects[i], v->frame, hs);
        add_caster(p, to, to->low, to->high, (float)s->objects[i].scale);
        bolan_object_mesh_sort(&p->sorted[i], to, model, s->objects[i].floats, v->block.eye_height);
        p->count++;
    }
    qsort(p->objects, p->count, sizeof *p->objects, by_distance);
    v->casters = p->casters;
    v->caster_count = p->caster_count;
}

// ---- drawing --------------------------------------------------------------------------------------------------------

// Whether all corners of its box lie beyond one side of the picture. Refraction raises what lies in the water, so
// nothing is told of its top and bottom.
static bool is_beside(const placed *o, const render_view *v) {
    int left = 0, right = 0, behind = 0;
    for (int i = 0; i < 8; i++) {
        const bolan_vec3 at = corner_of(o, i);
        const float *m = v->block.view_projection.m;
        const float x = m[0] * at.x + m[4] * at.y + m[8] * at.z + m[12],
                    w = m[3] * at.x + m[7] * at.y + m[11] * at.z + m[15];
        left += x<-w, right += x> w, behind += w <= 0.0f;
    }
    return left == 8 || right == 8 || behind == 8;
}

static int kind_of(const render_view *v, int class) {
    const float side = v->block.clip_side;
    if (!v->picture) return MAIN;
    return (side > 0.0f ? WHOLE : WET_WHOLE) + (class == ACROSS && side != 0.0f);
}

// A picture of one side has no use for what lies wholly on the other.
static bool is_wanted(int class, float side) {
    return class == ABOVE ? side >= 0.0f : class == BELOW ? side <= 0.0f : true;
}

static const gl_program *use(pass_objects *p, int flat, int kind, const render_view *v) {
    const gl_program *program = &p->programs[flat][kind];
    bolan_gl_program_use(program);
    bolan_gl_program_float(program, "pixel", v->block.radians_per_pixel * v->pixel_scale);
    return program;
}

// An object does not shadow itself. The ball holds it, and the places where the light of its drowned parts enters the
// water: at most 1.15 m aside for each metre of depth, and as high up.
static void use_casters(const gl_program *program, const placed *o, const render_view *v) {
    const bolan_vec3 middle = bolan_v3_scale(bolan_v3_add(corner_of(o, 0), corner_of(o, 7)), 0.5f);
    const float half = 0.5f * bolan_v3_length(bolan_v3_sub(corner_of(o, 0), corner_of(o, 7)));
    const float deep = fmaxf((float)-o->lowest, 0.0f);
    bolan_casters_use_near(v, program, middle, half + 1.6f * deep, 0.0f, o->caster);
}

static void draw_part(const gl_program *program, const placed *o, uint32_t first, uint32_t count, render_view *v) {
    bolan_gl_program_vec4_array(program, "place", o->rows, 3);
    bolan_gl_program_float(program, "grain_scale", 1.0f / o->gpu->period);
    use_casters(program, o, v);
    bolan_gl_program_vec2(program, "wet_band", o->wet[0], o->wet[1]);
    bolan_gl_mesh_draw(o->mesh, first, count);
    v->triangles += count / 3;
}

// All of one kind together, for a change of program costs.
static void draw_kind(pass_objects *p, render_view *v, int flat, int kind) {
    const float side = v->block.clip_side;
    const gl_program *program = NULL;
    for (uint32_t i = 0; i < p->count; i++) {
        const placed *o = &p->objects[i];
        if (o->gpu->flat != (flat == 1) || (side != 0.0f && is_beside(o, v))) continue;
        uint32_t first = 0, from = 0, count = 0;
        for (int c = 0; c < CLASSES; first += o->counts[c], c++) {
            if (o->counts[c] == 0 || !is_wanted(c, side) || kind_of(v, c) != kind) continue;
            from = count == 0 ? first : from; // classes of one kind follow each other
            count += o->counts[c];
        }
        if (count == 0) continue;
        if (!program) program = use(p, flat, kind, v);
        draw_part(program, o, from, count, v);
    }
}

void bolan_pass_objects_draw(pass_objects *p, render_view *v) {
    if (p->count == 0) return;
    bolan_gl_set_state(&(gl_state){.depth_test = true, .depth_write = true, .color_write = true});
    for (int flat = 0; flat < 2; flat++)
        for (int kind = v->picture ? WHOLE : MAIN; kind < (v->picture ? KINDS : WHOLE); kind++)
            draw_kind(p, v, flat, kind);
}

static void draw_whole(const placed *o, render_view *v) {
    uint32_t count = 0;
    for (int c = 0; c < CLASSES; c++) count += o->counts[c];
    bolan_gl_mesh_draw(o->mesh, 0, count);
    v->triangles += count / 3;
}

void bolan_pass_objects_draw_motion(pass_objects *p, render_view *v, const gl_program *program, double time_before) {
    for (uint32_t i = 0; i < p->count; i++) {
        const placed *o = &p->objects[i];
        const motion *m = &p->motions[o->index];
        if (m->time_before != time_before) continue; // as though it stood still
        float before[12];
        fill_rows(before, &m->before, m->scale_before, v->eye);
        bolan_gl_program_vec4_array(program, "place", o->rows, 3);
        bolan_gl_program_vec4_array(program, "place_before", before, 3);
        draw_whole(o, v);
    }
}

void bolan_pass_objects_draw_surfaces(pass_objects *p, render_view *v, const gl_program *program, uint32_t first) {
    bolan_gl_set_state(&(gl_state){.depth_test = true, .depth_write = true, .color_write = true});
    if (p->count > 0) bolan_gl_program_use(program);
    for (uint32_t i = 0; i < p->count; i++) {
        const placed *o = &p->objects[i];
        bolan_gl_program_vec4_array(program, "place", o->rows, 3);
        bolan_gl_program_float(program, "label", (float)(first + o->index));
        draw_whole(o, v);
    }
}

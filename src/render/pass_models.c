// SPDX-License-Identifier: MIT
// The scene's objects: keeps their meshes on the GPU, sets them on the waves, draws them. Shader: shaders/models.glsl.
#include "frame.h"

#include "bolan/query.h"
#include "scene/model.h"

#include <string.h>

#define VERTEX_FLOATS 10    // position, normal, colour and openness
#define MAX_CASTERS 32      // twin of caster[] in models.glsl
#define WIDEST_CASTER 30.0f // [m]: what is larger is a landscape
#define SOFTENING 0.7       // of the tilt: a hull averages over more than the points that are asked for

// A model on the GPU.
typedef struct gpu_model {
    uint64_t id; // 0: empty
    gl_buffer vertices, indices;
    gl_mesh mesh;
    uint32_t index_count;
    float period; // of its grain [m]
    bool flat;    // lies like ground
    bool wanted;  // by this frame
} gpu_model;

// An object as it stands in this frame.
typedef struct placed {
    const gpu_model *gpu;
    float rows[12];         // model to eye-relative world
    double lowest, highest; // of its box, above the water level [m]
    int caster;             // its own, or -1
} placed;

struct pass_models {
    gl_program programs[2][2]; // [flat][picture]
    gpu_model models[BOLAN_MAX_OBJECTS];
    placed objects[BOLAN_MAX_OBJECTS];
    uint32_t count;
    float casters[MAX_CASTERS * 2 * 4];
    uint32_t caster_count;
};

bolan_result pass_models_create(const gl_caps *caps, pass_models **out) {
    (void)caps;
    static const char *const defines[2][2] = {{NULL, "PICTURE 1\n"}, {"GROUND 1\n", "GROUND 1\nPICTURE 1\n"}};
    *out = NULL;
    pass_models *p = bolan_allocate(sizeof *p);
    if (!p) return BOLAN_ERROR_MEMORY;
    bolan_result r = BOLAN_OK;
    for (int i = 0; i < 4 && r == BOLAN_OK; i++)
        r = gl_program_create("models", defines[i / 2][i % 2], &p->programs[i / 2][i % 2]);
    if (r != BOLAN_OK) {
        pass_models_destroy(&p);
        return r;
    }
    *out = p;
    return BOLAN_OK;
}

bolan_result pass_models_reload(pass_models *p) {
    bolan_result r = BOLAN_OK;
    for (int i = 0; i < 4 && r == BOLAN_OK; i++) r = gl_program_reload(&p->programs[i / 2][i % 2]);
    return r;
}

static void free_model(gpu_model *g) {
    gl_mesh_free(&g->mesh);
    gl_buffer_free(&g->vertices);
    gl_buffer_free(&g->indices);
    *g = (gpu_model){0};
}

void pass_models_destroy(pass_models **pass) {
    if (!pass || !*pass) return;
    pass_models *p = *pass;
    for (int i = 0; i < BOLAN_MAX_OBJECTS; i++) free_model(&p->models[i]);
    for (int i = 0; i < 4; i++) gl_program_free(&p->programs[i / 2][i % 2]);
    bolan_release(p, sizeof *p);
    *pass = NULL;
}

// ---- meshes ---------------------------------------------------------------------------------------------------------

static bool lies_flat(const bolan_model_view *v) {
    for (uint32_t i = 0; i < v->vertex_count; i++)
        if (v->normals[i].z < 0.2f) return false;
    return true;
}

static bolan_result upload(const bolan_model *model, gpu_model *g) {
    static const uint8_t components[] = {3, 3, 4};
    const bolan_model_view v = bolan_model_get_view(model);
    const size_t stride = VERTEX_FLOATS * sizeof(float), bytes = v.vertex_count * stride;
    float *staging = bolan_allocate(bytes);
    if (!staging) return BOLAN_ERROR_MEMORY;
    for (uint32_t i = 0; i < v.vertex_count; i++) {
        memcpy(staging + i * VERTEX_FLOATS, &v.positions[i], 3 * sizeof(float));
        memcpy(staging + i * VERTEX_FLOATS + 3, &v.normals[i], 3 * sizeof(float));
        memcpy(staging + i * VERTEX_FLOATS + 6, &v.colors[i], 4 * sizeof(float));
    }
    bolan_result r = gl_buffer_create(GL_BUFFER_VERTEX, GL_USAGE_STATIC, bytes, staging, &g->vertices);
    if (r == BOLAN_OK)
        r = gl_buffer_create(GL_BUFFER_INDEX, GL_USAGE_STATIC, v.index_count * sizeof *v.indices, v.indices,
                             &g->indices);
    if (r == BOLAN_OK) r = gl_mesh_create(&g->vertices, &g->indices, components, 3, (uint32_t)stride, &g->mesh);
    bolan_release(staging, bytes);
    g->id = model_id(model);
    g->index_count = v.index_count;
    bolan_vec3 low, high;
    model_bounds(model, &low, &high);
    // Large things are looked at from afar.
    g->period = fminf(fmaxf(0.16f * fmaxf(high.x - low.x, high.z - low.z), 0.8f), 6.0f);
    g->flat = lies_flat(&v);
    if (r != BOLAN_OK) free_model(g);
    return r;
}

static gpu_model *find(pass_models *p, uint64_t id) {
    for (int i = 0; i < BOLAN_MAX_OBJECTS; i++)
        if (p->models[i].id == id && p->models[i].mesh.vao) return &p->models[i];
    return NULL;
}

// The model on the GPU; a place that this frame does not want is given to a new one. NULL when there is no memory.
static gpu_model *keep(pass_models *p, const bolan_model *model) {
    gpu_model *g = find(p, model_id(model));
    for (int i = 0; i < BOLAN_MAX_OBJECTS && !g; i++)
        if (!p->models[i].wanted) g = &p->models[i];
    if (!g) return NULL;
    if (!g->mesh.vao || g->id != model_id(model)) {
        free_model(g);
        if (upload(model, g) != BOLAN_OK) return NULL;
    }
    g->wanted = true;
    return g;
}

// ---- places ---------------------------------------------------------------------------------------------------------

typedef struct pose {
    bolan_dvec3 origin;  // world [m]
    bolan_dvec3 x, y, z; // unit axes of the model in the world
} pose;

static pose standing(const bolan_object *o) {
    double s, c;
    bolan_sincos(bolan_radians(o->heading_deg), &s, &c);
    return (pose){o->position, {c, -s, 0.0}, {s, c, 0.0}, {0.0, 0.0, 1.0}};
}

static bolan_dvec3 unit(bolan_dvec3 v) {
    const double length = sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
    return bolan_dv3(v.x / length, v.y / length, v.z / length);
}
static bolan_dvec3 cross(bolan_dvec3 a, bolan_dvec3 b) {
    return bolan_dv3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

// Rests on the water under five points of the hull: bow and stern give the pitch, the sides the roll.
static void float_on_water(pose *p, const frame *f, const bolan_object *o, bolan_vec3 low, bolan_vec3 high) {
    static const double at[5][2] = {{0, 0}, {0, 0.8}, {0, -0.8}, {0.8, 0}, {-0.8, 0}};
    const double half_x = 0.5 * o->scale * (double)(high.x - low.x), half_y = 0.5 * o->scale * (double)(high.y - low.y);
    const double mid_x = 0.5 * o->scale * (double)(high.x + low.x), mid_y = 0.5 * o->scale * (double)(high.y + low.y);
    bolan_dvec2 xy[5];
    bolan_query_point water[5];
    for (int i = 0; i < 5; i++) {
        const double u = mid_x + at[i][0] * half_x, v = mid_y + at[i][1] * half_y;
        xy[i] = (bolan_dvec2){p->origin.x + u * p->x.x + v * p->y.x, p->origin.y + u * p->x.y + v * p->y.y};
    }
    bolan_query_surface(f->desc->sea, f->desc->terrain, f->scene->water.level, xy, 5, water);
    double sum = 0.0;
    for (int i = 0; i < 5; i++) sum += (double)water[i].height;
    const double pitch = SOFTENING * ((double)water[1].height - (double)water[2].height) / fmax(1.6 * half_y, 1e-3);
    const double roll = SOFTENING * ((double)water[3].height - (double)water[4].height) / fmax(1.6 * half_x, 1e-3);
    p->origin.z = o->position.z + sum / 5.0;
    p->y = unit(bolan_dv3(p->y.x, p->y.y, pitch));
    p->z = unit(cross(bolan_dv3(p->x.x, p->x.y, roll), p->y));
    p->x = cross(p->y, p->z);
}

// The one place where doubles become eye-relative floats.
static void fill_rows(placed *to, const pose *p, double scale, bolan_dvec3 eye) {
    const float rows[12] = {(float)(scale * p->x.x),      (float)(scale * p->y.x),      (float)(scale * p->z.x),
                            (float)(p->origin.x - eye.x), (float)(scale * p->x.y),      (float)(scale * p->y.y),
                            (float)(scale * p->z.y),      (float)(p->origin.y - eye.y), (float)(scale * p->x.z),
                            (float)(scale * p->y.z),      (float)(scale * p->z.z),      (float)(p->origin.z - eye.z)};
    memcpy(to->rows, rows, sizeof rows);
}

static bolan_vec3 transformed(const float rows[12], bolan_vec3 v) {
    return bolan_v3(rows[0] * v.x + rows[1] * v.y + rows[2] * v.z + rows[3],
                    rows[4] * v.x + rows[5] * v.y + rows[6] * v.z + rows[7],
                    rows[8] * v.x + rows[9] * v.y + rows[10] * v.z + rows[11]);
}

// The object's height over the water: of the corners of its box.
static void measure_height(placed *to, bolan_vec3 low, bolan_vec3 high, double eye_over_water) {
    to->lowest = HUGE_VAL;
    to->highest = -HUGE_VAL;
    for (int i = 0; i < 8; i++) {
        const bolan_vec3 corner = {i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z};
        const double z = (double)transformed(to->rows, corner).z + eye_over_water;
        to->lowest = fmin(to->lowest, z);
        to->highest = fmax(to->highest, z);
    }
}

// What stands up throws a shadow: an ellipsoid in the upper part of its box, where crowns and roofs are.
static void add_caster(pass_models *p, placed *to, bolan_vec3 low, bolan_vec3 high, float scale) {
    const bolan_vec3 size = bolan_v3_scale(bolan_v3_sub(high, low), scale);
    const float radius = 0.25f * (size.x + size.y);
    to->caster = -1;
    if (p->caster_count == MAX_CASTERS || radius > WIDEST_CASTER || fminf(size.x, fminf(size.y, size.z)) < 0.4f) return;
    const bolan_vec3 center = {0.5f * (low.x + high.x), 0.5f * (low.y + high.y), low.z + 0.56f * (high.z - low.z)};
    const bolan_vec3 at = transformed(to->rows, center);
    const float pair[8] = {at.x, at.y, at.z, 1.0f / radius, 1.0f / (0.44f * size.z)};
    memcpy(p->casters + 8 * p->caster_count, pair, sizeof pair);
    to->caster = (int)p->caster_count++;
}

void pass_models_prepare(pass_models *p, frame *f) {
    const bolan_scene *s = f->scene;
    p->count = p->caster_count = 0;
    for (int i = 0; i < BOLAN_MAX_OBJECTS; i++) p->models[i].wanted = false;
    const uint32_t count = f->desc->models ? s->object_count : 0;
    // First what is there already, so that nothing that is wanted makes way.
    for (uint32_t i = 0; i < count; i++) {
        gpu_model *g = f->desc->models[i] ? find(p, model_id(f->desc->models[i])) : NULL;
        if (g) g->wanted = true;
    }
    for (uint32_t i = 0; i < count; i++) {
        const bolan_model *model = f->desc->models[i];
        placed *to = &p->objects[p->count];
        if (!model || !(to->gpu = keep(p, model))) continue;
        bolan_vec3 low, high;
        model_bounds(model, &low, &high);
        pose at = standing(&s->objects[i]);
        if (s->objects[i].floats) float_on_water(&at, f, &s->objects[i], low, high);
        fill_rows(to, &at, s->objects[i].scale, f->eye);
        measure_height(to, low, high, f->eye.z - s->water.level);
        add_caster(p, to, low, high, (float)s->objects[i].scale);
        p->count++;
    }
}

// ---- drawing --------------------------------------------------------------------------------------------------------

// The paper's three classes: fully above the water, fully below, straddling it. A picture of one side has no use for the other.
static bool is_wanted(const placed *o, float side) {
    if (o->lowest >= 0.0) return side >= 0.0f;
    return o->highest > 0.0 || side <= 0.0f;
}

void pass_models_draw(pass_models *p, frame *f) {
    if (p->count == 0) return;
    const float side = f->uniforms.clip.x;
    gl_set_state(&(gl_state){.depth_test = true, .depth_write = true, .color_write = true});
    for (int flat = 0; flat < 2; flat++) {
        const gl_program *program = &p->programs[flat][f->picture];
        gl_program_use(program);
        gl_program_int(program, "caster_count", (int)p->caster_count);
        if (p->caster_count) gl_program_vec4_array(program, "caster", p->casters, 2 * p->caster_count);
        for (uint32_t i = 0; i < p->count; i++) {
            const placed *o = &p->objects[i];
            if (o->gpu->flat != (flat == 1) || !is_wanted(o, side)) continue;
            gl_program_vec4_array(program, "place", o->rows, 3);
            gl_program_float(program, "grain_scale", 1.0f / o->gpu->period);
            gl_program_int(program, "own_caster", o->caster);
            gl_mesh_draw(&o->gpu->mesh, 0, o->gpu->index_count);
            f->triangles += o->gpu->index_count / 3;
        }
    }
}

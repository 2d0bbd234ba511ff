// SPDX-License-Identifier: MIT
// The scene's objects: keeps their meshes on the GPU, sets them on the waves, draws them. Shader: shaders/objects.glsl.
#include "frame.h"

#include "bolan/query.h"
#include "bolan/world.h"
#include "memory.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define VERTEX_FLOATS 10                          // position, normal, colour and openness
enum { CASTER_FLOATS = 3 * 4, MAX_CASTERS = 32 }; // twins of caster[] in common/object_shadow.glsl
#define CASTER_EDGE 1.12f                         // of its soft edge, in radii: the root of CASTER_NONE there
#define WIDEST_CASTER 30.0f                       // [m]: what is larger is a landscape
#define OVERLAP 0.25f // [m], as in planar_views.c: what stands clear of the water by more is cut by no picture's plane

enum { ABOVE, ACROSS, BELOW, CLASSES }; // the paper's three classes (section 2.2), of triangles

// What a program is for: models that lie flat or things; the main view, a picture's whole triangles, cut ones, and both
// where they may lie under the water.
enum { MAIN, WHOLE, CUT, WET_WHOLE, WET_CUT, KINDS };

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

// The indices of a still object that stands in the water, its triangles sorted by class.
typedef struct sorted {
    uint64_t id; // of the model; 0: empty
    float place[4];
    gl_buffer indices;
    gl_mesh mesh;
    uint32_t counts[CLASSES];
} sorted;

// Where an object stood in the last two steps.
typedef struct motion {
    uint64_t id;              // of its model; 0: none
    double time, time_before; // of the sea; NAN: none
    double scale, scale_before;
    bolan_pose pose, before;
} motion;

// An object as it stands in this frame.
typedef struct placed {
    const gpu_model *gpu;
    const gl_mesh *mesh;
    uint32_t counts[CLASSES]; // indices
    float rows[12];           // model to eye-relative world
    bolan_vec3 low, high;     // of its box in the model
    double lowest, highest;   // of its box, above the water level [m]
    float nearest;            // about as near as it comes to the eye [m]
    int caster;               // its own, or -1
    float wet[2];             // heights over the water level between which it is wet [m]
    uint32_t index;           // in the scene
} placed;

struct pass_objects {
    gl_program programs[2][KINDS]; // [flat]
    gpu_model models[BOLAN_MAX_OBJECTS];
    sorted sorted[BOLAN_MAX_OBJECTS];  // by the scene's order
    motion motions[BOLAN_MAX_OBJECTS]; // likewise
    uint64_t places;                   // a hash of where they stand
    placed objects[BOLAN_MAX_OBJECTS]; // the nearest first: what they hide is not shaded
    uint32_t count;
    float casters[MAX_CASTERS * CASTER_FLOATS];
    uint32_t caster_count;
};

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

void bolan_pass_objects_destroy(pass_objects **pass) {
    if (!pass || !*pass) return;
    pass_objects *p = *pass;
    for (int i = 0; i < BOLAN_MAX_OBJECTS; i++) free_model(&p->models[i]);
    for (int i = 0; i < BOLAN_MAX_OBJECTS; i++) free_sorted(&p->sorted[i]);
    for (int i = 0; i < 2 * KINDS; i++) bolan_gl_program_free(&p->programs[i / KINDS][i % KINDS]);
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

static gpu_model *find(pass_objects *p, uint64_t id) {
    for (int i = 0; i < BOLAN_MAX_OBJECTS; i++)
        if (p->models[i].id == id && p->models[i].mesh.vao) return &p->models[i];
    return NULL;
}

// The model on the GPU; a place that this frame does not want is given to a new one. NULL when there is no memory.
static gpu_model *keep(pass_objects *p, const bolan_model *model) {
    gpu_model *g = find(p, bolan_model_id(model));
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

// Which of the object's indices are of which class: by triangles where it stands still in the water, else as a whole.
static void sort_triangles(sorted *s, placed *o, const bolan_model *model, bool floats, float eye_over_water) {
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
        gpu_model *g = v->frame->models[i] ? find(p, bolan_model_id(v->frame->models[i])) : NULL;
        if (g) g->wanted = true;
    }
    for (uint32_t i = 0; i < count; i++) {
        const bolan_model *model = v->frame->models[i];
        placed *to = &p->objects[p->count];
        if (!model || !(to->gpu = keep(p, model))) continue;
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
        sort_triangles(&p->sorted[i], to, model, s->objects[i].floats, v->block.eye_height);
        p->count++;
    }
    qsort(p->objects, p->count, sizeof *p->objects, by_distance);
    v->casters = p->casters;
    v->caster_count = p->caster_count;
}

void bolan_casters_use(const render_view *v, const gl_program *program) {
    bolan_gl_program_int(program, "caster_count", (int)v->caster_count);
    if (v->caster_count > 0) bolan_gl_program_vec4_array(program, "caster", v->casters, 3 * v->caster_count);
}

// The ball round a caster's ellipsoid, whose axes are across each other.
static float ball_of(const float row[CASTER_FLOATS], bolan_vec3 *middle) {
    float widest = 0.0f;
    *middle = (bolan_vec3){0};
    for (int i = 0; i < 3; i++, row += 4) {
        const bolan_vec3 axis = {row[0], row[1], row[2]};
        const float square = bolan_v3_dot(axis, axis);
        *middle = bolan_v3_add(*middle, bolan_v3_scale(axis, -row[3] / square));
        widest = fmaxf(widest, 1.0f / sqrtf(square));
    }
    return CASTER_EDGE * widest;
}

void bolan_casters_use_near(const render_view *v, const gl_program *program, bolan_vec3 middle, float radius,
                            float least, int but) {
    float near[MAX_CASTERS * CASTER_FLOATS];
    uint32_t count = 0;
    for (uint32_t i = 0; i < v->caster_count; i++) {
        const float *row = v->casters + CASTER_FLOATS * i;
        bolan_vec3 from;
        const float ball = ball_of(row, &from), reach = ball + radius;
        const bolan_vec3 way = bolan_v3_sub(middle, from), sun = v->frame->sun_direction;
        const float along = bolan_v3_dot(way, sun);
        if ((int)i == but || ball < least || along > reach) continue;
        if (bolan_v3_length(bolan_v3_sub(way, bolan_v3_scale(sun, along))) > reach) continue;
        memcpy(near + CASTER_FLOATS * count++, row, sizeof(float[CASTER_FLOATS]));
    }
    bolan_gl_program_int(program, "caster_count", (int)count);
    if (count > 0) bolan_gl_program_vec4_array(program, "caster", near, 3 * count);
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

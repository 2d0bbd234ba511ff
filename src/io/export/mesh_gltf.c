// SPDX-License-Identifier: MIT
// Meshes as binary glTF 2.0 (.glb): a JSON chunk, which states the bounds of all positions, and a binary chunk.
//
//     for each part     vertices  40 bytes: POSITION, NORMAL, _FOAM, _VELOCITY;   indices  4 bytes
//     for frames 1 ...  24 bytes a vertex of the water: differences of POSITION, NORMAL from frame 0
//     for frames 0 ...  times, 4 bytes; then their weights, frames - 1 floats each
//
// The bounds stand before the data, so that all frames are made twice: for their bounds, and to be written.
#include "io/export/mesh_file.h"

#include <float.h>
#include <string.h>

enum { VERTEX = 40, DELTA = 24, JSON_CHUNK = 0x4E4F534A, BINARY_CHUNK = 0x004E4942 };
enum { FLOATS = 5126, WORDS = 5125, VERTICES = 34962, INDICES = 34963 }; // constants of glTF

typedef struct bounds {
    float least[3], most[3];
} bounds;

typedef struct gltf {
    mesh_rows *r;
    export_writer *w;
    double start; // time of frame 0 [s]
    uint32_t frames, parts;
    uint64_t vertices, triangles; // of a part
    bounds *of;                   // of the parts, then of frames 1 ...
    size_t bounds_bytes;
    float *first; // an animation: position and normal of frame 0
    size_t first_bytes;
    uint64_t done, total; // rows
} gltf;

static uint64_t binary_size(const gltf *g) {
    const uint64_t targets = g->frames - 1;
    uint64_t size = g->parts * (g->vertices * VERTEX + 12 * g->triangles) + targets * g->vertices * DELTA;
    if (targets) size += 4ull * g->frames * (1 + targets);
    return size;
}

// ---- the vertices of a frame ----------------------------------------------------------------------------------------

typedef void vertex_function(gltf *g, uint32_t target, uint64_t index, const mesh_vertex *v);

static void each_vertex(gltf *g, mesh_part part, uint32_t target, vertex_function *use) {
    mesh_rows *r = g->r;
    for (uint32_t row = 0; row < r->rows && !g->w->result; row += r->batch) {
        const uint32_t count = bolan_mesh_rows_make(r, part, row);
        for (uint32_t i = 0; i < count; i++) use(g, target, (uint64_t)row * r->columns + i, &r->vertices[i]);
        g->done += r->batch;
        bolan_mesh_progress(r, g->done < g->total ? g->done : g->total, g->total);
    }
}

static void widen(bounds *b, const float p[3]) {
    for (int k = 0; k < 3; k++) {
        if (p[k] < b->least[k]) b->least[k] = p[k];
        if (p[k] > b->most[k]) b->most[k] = p[k];
    }
}

// What a morph target adds to frame 0.
static void difference(const gltf *g, uint64_t index, const mesh_vertex *v, float out[6]) {
    float now[6];
    bolan_mesh_y_up(v->position, now);
    bolan_mesh_y_up(v->normal, now + 3);
    for (int k = 0; k < 6; k++) out[k] = now[k] - g->first[6 * index + k];
}

static void bound_vertex(gltf *g, uint32_t target, uint64_t index, const mesh_vertex *v) {
    float p[6];
    bolan_mesh_y_up(v->position, p);
    bolan_mesh_y_up(v->normal, p + 3);
    if (target > 0) difference(g, index, v, p);
    if (target == 0 && g->first) memcpy(g->first + 6 * index, p, sizeof p);
    widen(&g->of[target > 0 ? g->parts + target - 1 : 0], p);
}

static void bound_ground(gltf *g, uint32_t target, uint64_t index, const mesh_vertex *v) {
    (void)target, (void)index;
    float p[3];
    bolan_mesh_y_up(v->position, p);
    widen(&g->of[MESH_GROUND], p);
}

static void put_vector(export_writer *w, const float v[3]) {
    for (int k = 0; k < 3; k++) bolan_export_f32(w, v[k]);
}

static void write_vertex(gltf *g, uint32_t target, uint64_t index, const mesh_vertex *v) {
    (void)target, (void)index;
    float turned[3];
    bolan_mesh_y_up(v->position, turned), put_vector(g->w, turned);
    bolan_mesh_y_up(v->normal, turned), put_vector(g->w, turned);
    bolan_export_f32(g->w, v->foam);
    bolan_mesh_y_up(v->velocity, turned), put_vector(g->w, turned);
}

static void write_difference(gltf *g, uint32_t target, uint64_t index, const mesh_vertex *v) {
    (void)target;
    float d[6];
    difference(g, index, v, d);
    put_vector(g->w, d);
    put_vector(g->w, d + 3);
}

static void find_bounds(gltf *g) {
    for (uint32_t i = 0; i < g->parts + g->frames - 1; i++)
        g->of[i] = (bounds){{FLT_MAX, FLT_MAX, FLT_MAX}, {-FLT_MAX, -FLT_MAX, -FLT_MAX}};
    g->r->moves = false;
    for (uint32_t f = 0; f < g->frames; f++) {
        bolan_mesh_rows_step(g->r, g->start, f);
        each_vertex(g, MESH_WATER, f, bound_vertex);
    }
    if (g->parts > 1) each_vertex(g, MESH_GROUND, 0, bound_ground);
}

// ---- JSON -----------------------------------------------------------------------------------------------------------

// The same text is made twice: without a writer for its length.
typedef struct json {
    export_writer *w; // or NULL
    uint64_t length;
} json;

static void put(json *j, const char *text) {
    if (j->w) bolan_export_bytes(j->w, text, strlen(text));
    j->length += strlen(text);
}

static void put_whole(json *j, const char *before, uint64_t value) {
    char text[32];
    bolan_format(text, sizeof text, "%llu", (unsigned long long)value);
    put(j, before);
    put(j, text);
}

static void put_vector_text(json *j, const char *before, double x, double y, double z) {
    const double v[3] = {x, y, z};
    put(j, before);
    for (int k = 0; k < 3; k++) {
        char text[32];
        bolan_format_number(text, sizeof text, v[k], 9);
        put(j, k ? "," : "[");
        put(j, text);
    }
    put(j, "]");
}

static void put_view(json *j, uint64_t *offset, uint64_t size, uint32_t stride, uint32_t target) {
    put_whole(j, *offset ? ",{\"buffer\":0,\"byteOffset\":" : "{\"buffer\":0,\"byteOffset\":", *offset);
    put_whole(j, ",\"byteLength\":", size);
    if (stride) put_whole(j, ",\"byteStride\":", stride);
    if (target) put_whole(j, ",\"target\":", target);
    put(j, "}");
    *offset += size;
}

// Buffer views: 2 of each part, 1 of each target, times, weights.
static void put_views(json *j, const gltf *g) {
    uint64_t offset = 0;
    put(j, "\"bufferViews\":[");
    for (uint32_t p = 0; p < g->parts; p++) {
        put_view(j, &offset, g->vertices * VERTEX, VERTEX, VERTICES);
        put_view(j, &offset, 12 * g->triangles, 0, INDICES);
    }
    for (uint32_t f = 1; f < g->frames; f++) put_view(j, &offset, g->vertices * DELTA, DELTA, VERTICES);
    if (g->frames > 1) put_view(j, &offset, 4ull * g->frames, 0, 0);
    if (g->frames > 1) put_view(j, &offset, 4ull * g->frames * (g->frames - 1), 0, 0);
    put(j, "],");
}

static void put_accessor(json *j, uint32_t view, uint32_t offset, uint32_t component, uint64_t count,
                         const char *type) {
    put_whole(j, "{\"bufferView\":", view);
    if (offset) put_whole(j, ",\"byteOffset\":", offset);
    put_whole(j, ",\"componentType\":", component);
    put_whole(j, ",\"count\":", count);
    put(j, ",\"type\":\"");
    put(j, type);
    put(j, "\"");
}

static void put_bounds(json *j, const bounds *b) {
    put_vector_text(j, ",\"min\":", (double)b->least[0], (double)b->least[1], (double)b->least[2]);
    put_vector_text(j, ",\"max\":", (double)b->most[0], (double)b->most[1], (double)b->most[2]);
    put(j, "},");
}

// Accessors: 5 of each part (position, normal, foam, velocity, indices), 2 of each target, times, weights.
static void put_accessors(json *j, const gltf *g) {
    char text[32];
    uint32_t view = 0;
    put(j, "\"accessors\":[");
    for (uint32_t p = 0; p < g->parts; p++, view += 2) {
        if (p) put(j, ",");
        put_accessor(j, view, 0, FLOATS, g->vertices, "VEC3"), put_bounds(j, &g->of[p]);
        put_accessor(j, view, 12, FLOATS, g->vertices, "VEC3"), put(j, "},");
        put_accessor(j, view, 24, FLOATS, g->vertices, "SCALAR"), put(j, "},");
        put_accessor(j, view, 28, FLOATS, g->vertices, "VEC3"), put(j, "},");
        put_accessor(j, view + 1, 0, WORDS, 3 * g->triangles, "SCALAR"), put(j, "}");
    }
    for (uint32_t f = 1; f < g->frames; f++, view++) {
        put(j, ",");
        put_accessor(j, view, 0, FLOATS, g->vertices, "VEC3"), put_bounds(j, &g->of[g->parts + f - 1]);
        put_accessor(j, view, 12, FLOATS, g->vertices, "VEC3"), put(j, "}");
    }
    if (g->frames > 1) {
        put(j, ",");
        put_accessor(j, view, 0, FLOATS, g->frames, "SCALAR");
        bolan_format_number(text, sizeof text, (double)(float)((g->frames - 1) / g->r->desc->frames.fps), 9);
        put(j, ",\"min\":[0],\"max\":["), put(j, text), put(j, "]},");
        put_accessor(j, view + 1, 0, FLOATS, (uint64_t)g->frames * (g->frames - 1), "SCALAR"), put(j, "}");
    }
    put(j, "],");
}

static void put_meshes(json *j, const gltf *g) {
    put(j, "\"meshes\":[");
    for (uint32_t p = 0; p < g->parts; p++) {
        put(j, p ? ",{\"name\":\"ground\",\"primitives\":[{" : "{\"name\":\"water\",\"primitives\":[{");
        put_whole(j, "\"attributes\":{\"POSITION\":", 5 * p);
        put_whole(j, ",\"NORMAL\":", 5 * p + 1);
        put_whole(j, ",\"_FOAM\":", 5 * p + 2);
        put_whole(j, ",\"_VELOCITY\":", 5 * p + 3);
        put_whole(j, "},\"indices\":", 5 * p + 4);
        put_whole(j, ",\"material\":", p);
        for (uint32_t f = 1; f < g->frames && p == MESH_WATER; f++) {
            put_whole(j, f > 1 ? ",{\"POSITION\":" : ",\"targets\":[{\"POSITION\":", 5 * g->parts + 2 * (f - 1));
            put_whole(j, ",\"NORMAL\":", 5 * g->parts + 2 * (f - 1) + 1);
            put(j, f + 1 < g->frames ? "}" : "}]");
        }
        put(j, "}]}");
    }
    put(j, "],");
}

static void put_animation(json *j, const gltf *g) {
    const uint32_t times = 5 * g->parts + 2 * (g->frames - 1);
    put(j, "\"animations\":[{\"name\":\"waves\",\"channels\":[{\"sampler\":0,\"target\":{\"node\":0,\"path\":"
           "\"weights\"}}],");
    put_whole(j, "\"samplers\":[{\"input\":", times);
    put_whole(j, ",\"interpolation\":\"LINEAR\",\"output\":", times + 1);
    put(j, "}]}],");
}

static void put_json(json *j, const gltf *g) {
    const bolan_dvec3 o = g->r->desc->origin;
    put(j, "{\"asset\":{\"version\":\"2.0\",\"generator\":\"Bolan ");
    put(j, bolan_version());
    put_vector_text(j, "\",\"extras\":{\"axes\":\"x east, y up, z south\",\"origin_east_north_up\":", o.x, o.y, o.z);
    put(j, "}},\"scene\":0,\"scenes\":[{\"nodes\":");
    put(j, g->parts > 1 ? "[0,1]}],\"nodes\":[{\"name\":\"water\",\"mesh\":0},{\"name\":\"ground\",\"mesh\":1}],"
                        : "[0]}],\"nodes\":[{\"name\":\"water\",\"mesh\":0}],");
    put_meshes(j, g);
    if (g->frames > 1) put_animation(j, g);
    put_accessors(j, g);
    put_views(j, g);
    put(j, "\"materials\":[{\"name\":\"water\",\"doubleSided\":true,\"pbrMetallicRoughness\":{\"baseColorFactor\":"
           "[0.02,0.08,0.1,1],\"metallicFactor\":0,\"roughnessFactor\":0.1}},{\"name\":\"ground\","
           "\"pbrMetallicRoughness\":"
           "{\"baseColorFactor\":[0.4,0.35,0.25,1],\"metallicFactor\":0}}],");
    put_whole(j, "\"buffers\":[{\"byteLength\":", binary_size(g));
    put(j, "}]}");
    while (j->length % 4) put(j, " "); // chunks begin at multiples of four
}

// ---- the file -------------------------------------------------------------------------------------------------------

static void write_json(const gltf *g) {
    json measure = {.w = NULL}, text = {.w = g->w};
    put_json(&measure, g);
    bolan_export_bytes(g->w, "glTF", 4);
    bolan_export_u32(g->w, 2);
    bolan_export_u32(g->w, (uint32_t)(12 + 8 + measure.length + 8 + binary_size(g)));
    bolan_export_u32(g->w, (uint32_t)measure.length);
    bolan_export_u32(g->w, JSON_CHUNK);
    put_json(&text, g);
    bolan_export_u32(g->w, (uint32_t)binary_size(g));
    bolan_export_u32(g->w, BINARY_CHUNK);
}

static void write_indices(const gltf *g) {
    const mesh_rows *r = g->r;
    for (uint32_t row = 0; row + 1 < r->rows && !g->w->result; row++)
        for (uint32_t i = 0; i < 6 * (r->columns - 1); i++) bolan_export_u32(g->w, row * r->columns + r->strip[i]);
}

// Weight 1 of its own target at each frame; frame 0 has none.
static void write_keys(const gltf *g) {
    for (uint32_t f = 0; f < g->frames; f++) bolan_export_f32(g->w, (float)(f / g->r->desc->frames.fps));
    for (uint32_t f = 0; f < g->frames; f++)
        for (uint32_t t = 1; t < g->frames; t++) bolan_export_f32(g->w, f == t ? 1.0f : 0.0f);
}

static void write_binary(gltf *g) {
    g->r->moves = true;
    bolan_mesh_rows_step(g->r, g->start, 0);
    for (uint32_t p = 0; p < g->parts; p++) {
        each_vertex(g, (mesh_part)p, 0, write_vertex);
        write_indices(g);
    }
    g->r->moves = false;
    for (uint32_t f = 1; f < g->frames; f++) {
        bolan_mesh_rows_step(g->r, g->start, f);
        each_vertex(g, MESH_WATER, f, write_difference);
    }
    if (g->frames > 1) write_keys(g);
}

bolan_result bolan_mesh_write_glb(mesh_rows *r, export_writer *w) {
    gltf g = {.r = r, .w = w, .start = bolan_sea_time(r->water.sea), .frames = r->desc->frames.count};
    g.parts = bolan_mesh_parts(r);
    g.vertices = bolan_mesh_vertices(r);
    g.triangles = bolan_mesh_triangles(r);
    g.total = 2 * (uint64_t)(g.frames + g.parts - 1) * r->rows;
    if (binary_size(&g) > UINT32_MAX - (1u << 20) - 1000ull * g.frames) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_EXPORT_TOO_LARGE,
                  "%s: %.1f GB are more than a .glb can hold; expected 4.2 GB at most, or .ply", w->path,
                  (double)binary_size(&g) * 1e-9);
        return BOLAN_ERROR_FORMAT;
    }
    g.bounds_bytes = (g.parts + g.frames - 1) * sizeof *g.of;
    g.first_bytes = g.frames > 1 ? (size_t)g.vertices * 6 * sizeof *g.first : 0;
    g.of = bolan_allocate(g.bounds_bytes);
    g.first = bolan_allocate(g.first_bytes);
    const bool ready = g.of && (g.first || !g.first_bytes);
    if (ready) {
        find_bounds(&g);
        write_json(&g);
        write_binary(&g);
    } else {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY, "%s: no memory for the first frame", w->path);
    }
    bolan_release(g.of, g.bounds_bytes);
    bolan_release(g.first, g.first_bytes);
    return ready ? BOLAN_OK : BOLAN_ERROR_MEMORY;
}

// SPDX-License-Identifier: MIT
// Land and sea bed: chooses and builds the chunks of this view (ground_tree.c, ground_chunk.c), keeps their meshes and
// maps on the GPU, draws them, and fills the shore map (shore_map.c). Shader: shaders/ground.glsl.
#include "frame.h"

#include "ground_texture.h"
#include "ground_tree.h"
#include "memory.h"
#include "shore_map.h"
#include "sky_lattice.h"

#include <stdio.h>
#include <string.h>

// Chunks with smaller texels [m] show the grain of 16 m period.
#define FINEST_GRAIN 0.8

#define SHADOW_STEP 0.003 // between suns that shadows are cast for [rad]

// A slot's twin on the GPU.
typedef struct gpu_chunk {
    gl_buffer vertices;
    gl_mesh mesh;
    gl_texture map;
} gpu_chunk;

enum { NEAR = 1, PICTURE = 2, CASTERS = 4, PROGRAMS = 8 };

struct pass_ground {
    gl_program programs[PROGRAMS]; // by bits of the number: near, whose texels resolve the finest grain; the water is a
                                   // picture; objects throw shadows
    bool borrowed;                 // the programs are those of another
    gl_buffer indices;
    gl_texture noise;
    shore_builder shore;
    ground_tree *tree;
    gpu_chunk *gpu; // one per slot
    uint32_t slots;
    float *vertices; // staging
    const bolan_ground *terrain;
    uint64_t terrain_id;
    bool settled; // the view before this one was complete, so that work may be spread over frames
    bolan_dvec3 eye;
};

static const struct {
    float texel_pixels, error_pixels;
    uint32_t slots, budget;
} quality_table[] = {
    [BOLAN_QUALITY_LOW] = {6.0f, 2.4f, 128, 8},
    [BOLAN_QUALITY_MEDIUM] = {4.0f, 1.4f, 192, 12},
    [BOLAN_QUALITY_HIGH] = {2.5f, 0.9f, 384, 24},
    [BOLAN_QUALITY_ULTRA] = {1.5f, 0.5f, 768, 48},
};

static bolan_result create_indices(pass_ground *p) {
    const size_t bytes = bolan_chunk_first_index(CHUNK_MESHES) * sizeof(uint32_t);
    uint32_t *indices = allocate_for("the triangles of the ground", bytes);
    if (!indices) {
        return BOLAN_ERROR_MEMORY;
    }
    bolan_chunk_indices(indices);
    bolan_result r = bolan_gl_buffer_create(GL_BUFFER_INDEX, GL_USAGE_STATIC, bytes, indices, &p->indices);
    bolan_release(indices, bytes);
    return r;
}

static bolan_result create_noise(pass_ground *p) {
    const size_t bytes = (size_t)TERRAIN_TEXTURE_SIZE * TERRAIN_TEXTURE_SIZE * 4;
    uint8_t *texels = allocate_for("the texture of the ground", bytes);
    bolan_result r = texels ? bolan_ground_texture_fill(texels) : BOLAN_ERROR_MEMORY;
    gl_texture_desc d = {.format = GL_FMT_RGBA8,
                         .width = TERRAIN_TEXTURE_SIZE,
                         .height = TERRAIN_TEXTURE_SIZE,
                         .filter = GL_FILTER_MIPMAP_NEAREST,
                         .wrap = GL_WRAP_REPEAT};
    r = r == BOLAN_OK ? bolan_gl_texture_create(&d, &p->noise) : r;
    if (r == BOLAN_OK) {
        bolan_gl_texture_upload(&p->noise, 0, -1, texels, false);
        bolan_gl_texture_generate_mipmaps(&p->noise);
    }
    bolan_release(texels, bytes);
    return r;
}

void bolan_pass_ground_share(pass_ground *p, const pass_ground *from) {
    p->borrowed = true;
    memcpy(p->programs, from->programs, sizeof p->programs);
}

bolan_result bolan_pass_ground_create(const gl_caps *caps, const pass_ground *from, pass_ground **out) {
    (void)caps;
    *out = NULL;
    pass_ground *p = allocate_for("the pass of the ground", sizeof *p);
    if (!p) {
        return BOLAN_ERROR_MEMORY;
    }
    bolan_result r = BOLAN_OK;
    if (from != NULL) bolan_pass_ground_share(p, from);
    for (int i = 0; i < PROGRAMS && from == NULL && r == BOLAN_OK; i++) {
        char defines[64];
        snprintf(defines, sizeof defines, "%s%s%s", i & NEAR ? "NEAR 1\n" : "", i & PICTURE ? "PICTURE 1\n" : "",
                 i & CASTERS ? "CASTERS 1\n" : "");
        r = bolan_gl_program_create("ground", defines, &p->programs[i]);
    }
    r = r == BOLAN_OK ? create_indices(p) : r;
    r = r == BOLAN_OK ? create_noise(p) : r;
    r = r == BOLAN_OK ? bolan_shore_builder_create(&p->shore) : r;
    if (r == BOLAN_OK) {
        p->vertices = allocate_for("the vertices of the ground", CHUNK_VERTICES * 3 * sizeof(float));
        r = p->vertices ? BOLAN_OK : BOLAN_ERROR_MEMORY;
    }
    if (r != BOLAN_OK) {
        bolan_pass_ground_destroy(&p);
        return r;
    }
    *out = p;
    return BOLAN_OK;
}

static void free_chunks(pass_ground *p) {
    for (uint32_t n = 0; p->gpu && n < p->slots; n++) {
        bolan_gl_mesh_free(&p->gpu[n].mesh);
        bolan_gl_buffer_free(&p->gpu[n].vertices);
        bolan_gl_texture_free(&p->gpu[n].map);
    }
    bolan_release(p->gpu, p->slots * sizeof *p->gpu);
    p->gpu = NULL;
    bolan_ground_tree_destroy(&p->tree);
}

void bolan_pass_ground_destroy(pass_ground **pass) {
    if (!pass || !*pass) {
        return;
    }
    pass_ground *p = *pass;
    free_chunks(p);
    bolan_shore_builder_free(&p->shore);
    bolan_gl_texture_free(&p->noise);
    bolan_gl_buffer_free(&p->indices);
    for (int i = 0; i < PROGRAMS && !p->borrowed; i++) {
        bolan_gl_program_free(&p->programs[i]);
    }
    bolan_release(p->vertices, CHUNK_VERTICES * 3 * sizeof(float));
    bolan_release(p, sizeof *p);
    *pass = NULL;
}

bolan_result bolan_pass_ground_reload(pass_ground *p) {
    bolan_result r = BOLAN_OK;
    for (int i = 0; i < PROGRAMS && r == BOLAN_OK; i++) {
        r = bolan_gl_program_reload(&p->programs[i]);
    }
    return r;
}

const shore_map *bolan_pass_ground_shore(const pass_ground *p) { return &p->shore.map; }

// ---- chunks
// ----------------------------------------------------------------------------------------------------------

static bool create_gpu_chunk(pass_ground *p, gpu_chunk *g) {
    static const uint8_t components[] = {3};
    gl_texture_desc d = {.format = GL_FMT_RGBA16F,
                         .width = CHUNK_MAP,
                         .height = CHUNK_MAP,
                         .filter = GL_FILTER_MIPMAP,
                         .wrap = GL_WRAP_CLAMP};
    return bolan_gl_buffer_create(GL_BUFFER_VERTEX, GL_USAGE_STATIC, CHUNK_VERTICES * 3 * sizeof(float), NULL,
                                  &g->vertices) == BOLAN_OK &&
           bolan_gl_mesh_create(&g->vertices, &p->indices, components, 1, 3 * sizeof(float), &g->mesh) == BOLAN_OK &&
           bolan_gl_texture_create(&d, &g->map) == BOLAN_OK;
}

// All of the pool at once, so that a flight allocates nothing.
static bool create_chunks(pass_ground *p, uint32_t slots) {
    free_chunks(p);
    p->slots = slots;
    p->gpu = allocate_for("the chunks of the ground", slots * sizeof *p->gpu);
    bool all = p->gpu && bolan_ground_tree_create(slots, &p->tree) == BOLAN_OK;
    for (uint32_t n = 0; all && n < slots; n++) {
        all = create_gpu_chunk(p, &p->gpu[n]);
    }
    if (!all) {
        free_chunks(p);
    }
    p->terrain = NULL;
    return all;
}

// The pool of this quality, on this terrain; false when there is no memory or no terrain.
static bool fit_pool(pass_ground *p, const render_view *v) {
    const bolan_ground *terrain = v->frame->ground;
    uint32_t slots = quality_table[v->frame->quality].slots;
    if (!terrain || ((!p->tree || p->slots != slots) && !create_chunks(p, slots))) {
        p->terrain = NULL;
        return false;
    }
    uint64_t id = bolan_ground_id(terrain);
    if (terrain != p->terrain || id != p->terrain_id) {
        bolan_ground_tree_reset(p->tree, terrain);
        p->settled = false;
    }
    p->terrain = terrain;
    p->terrain_id = id;
    return true;
}

static void upload_chunk(pass_ground *p, uint32_t index) {
    chunk_slot *s = bolan_ground_tree_slot(p->tree, index);
    gpu_chunk *g = &p->gpu[index];
    if (s->fresh_mesh) {
        bolan_chunk_vertices(&s->chunk, p->vertices);
        bolan_gl_buffer_update(&g->vertices, 0, CHUNK_VERTICES * 3 * sizeof(float), p->vertices);
    }
    if (s->fresh_map) {
        bolan_gl_texture_upload(&g->map, 0, -1, s->chunk.map, true);
        bolan_gl_texture_generate_mipmaps(&g->map);
    }
    s->fresh_mesh = s->fresh_map = false;
}

static tree_view view_of(const pass_ground *p, const render_view *view) {
    bolan_dvec3 moved = bolan_dv3(view->eye.x - p->eye.x, view->eye.y - p->eye.y, view->eye.z - p->eye.z);
    double leap = sqrt(moved.x * moved.x + moved.y * moved.y + moved.z * moved.z);
    bolan_mat4 mirror = bolan_m4_identity();
    mirror.m[10] = -1.0f;
    mirror.m[14] = -2.0f * view->block.eye_height;
    tree_view v = {
        .eye = view->eye,
        .view_projection = view->block.view_projection,
        .mirrored = bolan_m4_mul(view->block.view_projection, mirror),
        .mirrors = bolan_pass_water_mirrors(view->frame),
        .pixel = view->block.radians_per_pixel,
        .water_level = view->frame->level,
        .sun = bolan_chunk_sun_from(bolan_sky_lattice_direction(view->frame->sun_direction, SHADOW_STEP)),
        // A jump of the eye is a new picture, and a picture is complete; a flight in a window spreads the work.
        .complete = !view->progressive || !p->settled || leap > 0.1 * fabs(view->eye.z - view->frame->level) + 20.0,
        .budget = quality_table[view->frame->quality].budget,
        .texel_pixels = quality_table[view->frame->quality].texel_pixels,
        .error_pixels = quality_table[view->frame->quality].error_pixels,
    };
    return v;
}

// The ground then only feeds the shore map.
static bool shown_by_object(const render_view *v) {
    if (v->frame->scene == NULL) return false;
    return v->frame->scene->terrain.shown_by_object && v->frame->scene->object_count > 0;
}

void bolan_pass_ground_prepare(pass_ground *p, render_view *v) {
    bolan_gl_texture_bind(&p->noise, UNIT_TERRAIN2);
    bolan_shore_builder_update(&p->shore, v);
    bolan_gl_texture_bind(&p->shore.map.texture, UNIT_SHORE);
    if (shown_by_object(v) || !fit_pool(p, v)) {
        return;
    }
    tree_view view = view_of(p, v);
    bolan_ground_tree_select(p->tree, &view);
    p->settled = true;
    p->eye = v->eye;
    uint32_t count;
    const uint32_t *list = bolan_ground_tree_draw_list(p->tree, &count);
    for (uint32_t n = 0; n < count; n++) {
        chunk_slot *s = bolan_ground_tree_slot(p->tree, list[n]);
        if (s->fresh_mesh || s->fresh_map) {
            upload_chunk(p, list[n]);
        }
    }
}

// The one place where doubles become eye-relative floats.
static void place_chunk(const ground_chunk *c, const gl_program *program, const render_view *v) {
    bolan_gl_program_vec4(
        program, "chunk",
        (bolan_vec4){(float)(c->west - v->eye.x), (float)(c->south - v->eye.y), (float)-v->eye.z, (float)c->size});
}

// Objects throw shadows on the chunk that its texels can show. The ball holds the chunk, and where the light of what
// lies under the water enters: under a low sun in water, a metre of depth aside.
static void use_casters(const ground_chunk *c, const gl_program *program, const render_view *v) {
    const double level = v->frame->level, half = 0.5 * c->size;
    const double low = fmax((double)c->lowest, level), high = fmax((double)c->highest, level);
    const double wide = half + 1.15 * fmax(level - (double)c->lowest, 0.0);
    const bolan_vec3 middle = {(float)(c->west + half - v->eye.x), (float)(c->south + half - v->eye.y),
                               (float)(0.5 * (low + high) - v->eye.z)};
    const double radius = sqrt(2.0 * wide * wide + 0.25 * (high - low) * (high - low));
    bolan_casters_use_near(v, program, middle, (float)radius, (float)(c->size / CHUNK_TEXELS), -1);
}

static void draw_chunk(const gpu_chunk *g, const chunk_slot *s, const gl_program *program, const render_view *v) {
    const ground_chunk *c = &s->chunk;
    place_chunk(c, program, v);
    if (v->caster_count > 0) use_casters(c, program, v);
    // A shadow's edge is as soft as the map's own grain.
    float slope = bolan_chunk_sun_from(v->frame->sun_direction).slope, texel = (float)(c->size / CHUNK_TEXELS);
    bolan_gl_program_float(program, "shadow_softness", 0.15f + 1.2f * texel * fminf(slope, 4.0f));
    bolan_gl_texture_bind(&g->map, UNIT_TERRAIN);
    bolan_gl_mesh_draw(&g->mesh, bolan_chunk_first_index(s->mesh), bolan_chunk_index_count(s->mesh));
}

void bolan_pass_ground_draw(pass_ground *p, render_view *v) {
    if (!p->terrain || !p->tree || shown_by_object(v)) {
        return;
    }
    bolan_gl_set_state(&(gl_state){.depth_test = true, .depth_write = true, .color_write = true});
    uint32_t count;
    const uint32_t *list = bolan_ground_tree_draw_list(p->tree, &count);
    for (uint32_t n = 0; n < count; n++) {
        const chunk_slot *s = bolan_ground_tree_slot(p->tree, list[n]);
        bool near_ground = s->chunk.size / CHUNK_TEXELS < FINEST_GRAIN;
        const int program = (near_ground ? NEAR : 0) | (v->picture ? PICTURE : 0) | (v->caster_count > 0 ? CASTERS : 0);
        draw_chunk(&p->gpu[list[n]], s, &p->programs[program], v);
        v->triangles += bolan_chunk_index_count(s->mesh) / 3;
    }
}

void bolan_pass_ground_draw_surfaces(pass_ground *p, render_view *v, const gl_program *program) {
    if (!p->terrain || !p->tree || shown_by_object(v)) return;
    bolan_gl_set_state(&(gl_state){.depth_test = true, .depth_write = true, .color_write = true});
    bolan_gl_program_use(program);
    bolan_gl_program_float(program, "label", (float)BOLAN_LABEL_LAND);
    uint32_t count;
    const uint32_t *list = bolan_ground_tree_draw_list(p->tree, &count);
    for (uint32_t n = 0; n < count; n++) {
        const chunk_slot *s = bolan_ground_tree_slot(p->tree, list[n]);
        place_chunk(&s->chunk, program, v);
        bolan_gl_texture_bind(&p->gpu[list[n]].map, UNIT_TERRAIN);
        bolan_gl_mesh_draw(&p->gpu[list[n]].mesh, bolan_chunk_first_index(s->mesh), bolan_chunk_index_count(s->mesh));
    }
}

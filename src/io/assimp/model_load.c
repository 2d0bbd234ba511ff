// SPDX-License-Identifier: MIT
// Models from files, by assimp's C interface: the meshes of all nodes with their transforms, turned from y-up to z-up,
// in one colour a vertex. The file is checked before the library reads it (model_check.c), and the counts, indices and
// numbers that the library returns are checked too.
#include "io/assimp/model_file.h"

#include <assimp/cimport.h>
#include <assimp/config.h>
#include <assimp/material.h>
#include <assimp/mesh.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <stdio.h>
#include <string.h>

#define CREASE 0.70710678f // cosine of 45 degrees
#define FLAT 2.0f          // no cosine: triangles are not averaged

// The mesh that is built: first counted, then filled.
typedef struct gathered {
    const struct aiScene *scene;
    const bolan_model_desc *desc;
    float crease; // for computed normals
    model_mesh mesh;
    uint32_t nodes;
    bolan_result result;
} gathered;

// ---- one mesh -------------------------------------------------------------------------------------------------------

static bool finite3(struct aiVector3D v) { return isfinite(v.x) && isfinite(v.y) && isfinite(v.z); }
static float share(float x) { return x >= 0.0f ? fminf(x, 1.0f) : 0.0f; } // 0 for NAN

// y-up: (x, y, z) of the file becomes (x, -z, y).
static bolan_vec3 turned(bolan_up up, float x, float y, float z) {
    return up == BOLAN_UP_Y ? bolan_v3(x, -z, y) : bolan_v3(x, y, z);
}

static bolan_vec4 base_color(const struct aiScene *scene, const struct aiMesh *mesh) {
    struct aiColor4D c = {0.6f, 0.6f, 0.6f, 1.0f};
    if (mesh->mMaterialIndex < scene->mNumMaterials) {
        const struct aiMaterial *m = scene->mMaterials[mesh->mMaterialIndex];
        if (aiGetMaterialColor(m, AI_MATKEY_BASE_COLOR, &c) != aiReturn_SUCCESS)
            aiGetMaterialColor(m, AI_MATKEY_COLOR_DIFFUSE, &c);
    }
    return (bolan_vec4){share(c.r), share(c.g), share(c.b), 1.0f};
}

// Subtracts the offset in double, so that the large parts cancel before the rounding to float.
static bolan_vec3 moved(const gathered *g, const struct aiMatrix4x4 *m, struct aiVector3D v) {
    const double x = (double)v.x, y = (double)v.y, z = (double)v.z;
    const bolan_dvec3 o = g->desc->offset;
    return turned(g->desc->up, (float)((double)m->a1 * x + (double)m->a2 * y + (double)m->a3 * z + (double)m->a4 - o.x),
                  (float)((double)m->b1 * x + (double)m->b2 * y + (double)m->b3 * z + (double)m->b4 - o.y),
                  (float)((double)m->c1 * x + (double)m->c2 * y + (double)m->c3 * z + (double)m->c4 - o.z));
}

static float determinant(const struct aiMatrix4x4 *m) {
    return m->a1 * (m->b2 * m->c3 - m->b3 * m->c2) - m->a2 * (m->b1 * m->c3 - m->b3 * m->c1) +
           m->a3 * (m->b1 * m->c2 - m->b2 * m->c1);
}

// By the cofactors: the inverse transpose up to a factor, which exist for singular matrices too. A mirroring node
// negates the cofactors; the sign of the determinant corrects the normal.
static bolan_vec3 moved_normal(bolan_up up, const struct aiMatrix4x4 *m, struct aiVector3D n, float sign) {
    const bolan_vec3 a = {m->a1, m->a2, m->a3}, b = {m->b1, m->b2, m->b3}, c = {m->c1, m->c2, m->c3};
    const bolan_vec3 v = {n.x, n.y, n.z};
    const bolan_vec3 t = turned(up, bolan_v3_dot(bolan_v3_cross(b, c), v), bolan_v3_dot(bolan_v3_cross(c, a), v),
                                bolan_v3_dot(bolan_v3_cross(a, b), v));
    const float length = bolan_v3_length(t);
    return length > 1e-20f && isfinite(length) ? bolan_v3_scale(t, sign / length) : bolan_v3(0.0f, 0.0f, 1.0f);
}

static void add_vertices(gathered *g, const struct aiMesh *mesh, const struct aiMatrix4x4 *m) {
    const bolan_vec4 base = base_color(g->scene, mesh);
    const struct aiColor4D *painted = mesh->mColors[0];
    const float sign = determinant(m) < 0.0f ? -1.0f : 1.0f;
    model_mesh *to = &g->mesh;
    for (uint32_t i = 0; i < mesh->mNumVertices; i++) {
        const uint32_t n = to->vertex_count++;
        const struct aiVector3D up = {0.0f, 1.0f, 0.0f};
        const bool known = mesh->mNormals && finite3(mesh->mNormals[i]);
        to->positions[n] = moved(g, m, mesh->mVertices[i]);
        to->normals[n] = moved_normal(g->desc->up, m, known ? mesh->mNormals[i] : up, sign);
        to->colors[n] = base;
        if (!painted) continue;
        to->colors[n].x *= share(painted[i].r);
        to->colors[n].y *= share(painted[i].g);
        to->colors[n].z *= share(painted[i].b);
    }
}

static void add_triangles(gathered *g, const struct aiMesh *mesh, uint32_t first, bool mirrored) {
    model_mesh *to = &g->mesh;
    for (uint32_t f = 0; f < mesh->mNumFaces; f++) {
        const struct aiFace *face = &mesh->mFaces[f];
        if (face->mNumIndices != 3) continue;
        const unsigned *i = face->mIndices;
        if (i[0] >= mesh->mNumVertices || i[1] >= mesh->mNumVertices || i[2] >= mesh->mNumVertices) continue;
        to->indices[to->index_count++] = first + i[0];
        to->indices[to->index_count++] = first + i[mirrored ? 2 : 1];
        to->indices[to->index_count++] = first + i[mirrored ? 1 : 2];
    }
}

// ---- the tree of nodes ----------------------------------------------------------------------------------------------

static bool is_drawn(const struct aiMesh *mesh) { return mesh->mVertices && mesh->mFaces && mesh->mNumVertices >= 3; }

// Counts the vertices of a mesh: one for each corner where normals are computed.
static void count_mesh(model_mesh *to, const struct aiMesh *mesh) {
    const uint32_t faces = mesh->mNumFaces < MODEL_VERTEX_LIMIT ? mesh->mNumFaces : MODEL_VERTEX_LIMIT;
    const uint32_t split = mesh->mNormals ? 0 : 3 * faces;
    to->vertex_count += mesh->mNumVertices > split ? mesh->mNumVertices : split;
    to->index_count += 3 * faces;
}

static void add_mesh(gathered *g, const struct aiMesh *mesh, const struct aiMatrix4x4 *m) {
    if (!g->mesh.positions) { // the first time
        count_mesh(&g->mesh, mesh);
        return;
    }
    const uint32_t first = g->mesh.vertex_count, first_index = g->mesh.index_count;
    add_vertices(g, mesh, m);
    add_triangles(g, mesh, first, determinant(m) < 0.0f);
    if (!mesh->mNormals && !g->result) g->result = bolan_model_make_normals(&g->mesh, first, first_index, g->crease);
}

// False when the file is larger or deeper than a model can be.
static bool walk(gathered *g, const struct aiNode *node, const struct aiMatrix4x4 *parent, int depth) {
    if (depth > MODEL_DEPTH_LIMIT || ++g->nodes > MODEL_VERTEX_LIMIT) return false;
    struct aiMatrix4x4 m = *parent;
    aiMultiplyMatrix4(&m, &node->mTransformation);
    for (uint32_t i = 0; i < node->mNumMeshes; i++) {
        if (node->mMeshes[i] >= g->scene->mNumMeshes) continue;
        const struct aiMesh *mesh = g->scene->mMeshes[node->mMeshes[i]];
        if (!is_drawn(mesh)) continue;
        if (mesh->mNumVertices > MODEL_VERTEX_LIMIT) return false;
        add_mesh(g, mesh, &m);
        if (g->mesh.vertex_count > MODEL_VERTEX_LIMIT || g->mesh.index_count > 3 * MODEL_VERTEX_LIMIT) return false;
    }
    for (uint32_t i = 0; i < node->mNumChildren; i++)
        if (!walk(g, node->mChildren[i], &m, depth + 1)) return false;
    return true;
}

// ---- the file -------------------------------------------------------------------------------------------------------

static bolan_result refuse(const char *path, const char *what) {
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_MODEL_FORMAT, "%s: %s", path, what);
    return BOLAN_ERROR_FORMAT;
}

static const struct aiScene *import(const char *path) {
    struct aiPropertyStore *store = aiCreatePropertyStore();
    if (!store) return NULL;
    aiSetImportPropertyInteger(store, AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    const unsigned steps = aiProcess_ValidateDataStructure | aiProcess_FindInvalidData | aiProcess_Triangulate |
                           aiProcess_SortByPType | aiProcess_JoinIdenticalVertices;
    const struct aiScene *scene = aiImportFileExWithProperties(path, steps, NULL, store);
    aiReleasePropertyStore(store);
    return scene;
}

static bolan_result cannot_import(const char *path) {
    char reason[200];
    const char *said = aiGetErrorString();
    snprintf(reason, sizeof reason, "%s", said && *said ? said : "the library gives no reason");
    for (char *c = reason; *c; c++)
        if ((unsigned char)*c < 32) *c = ' ';
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_MODEL_FORMAT, "%s: not a model that can be read (OBJ, glTF): %s", path,
              reason);
    return BOLAN_ERROR_FORMAT;
}

static bool allocate(model_mesh *m) {
    m->vertex_room = m->vertex_count;
    m->index_room = m->index_count;
    m->positions = bolan_allocate(m->vertex_room * sizeof *m->positions);
    m->normals = bolan_allocate(m->vertex_room * sizeof *m->normals);
    m->colors = bolan_allocate(m->vertex_room * sizeof *m->colors);
    m->indices = bolan_allocate(m->index_room * sizeof *m->indices);
    m->vertex_count = m->index_count = 0;
    return m->positions && m->normals && m->colors && m->indices;
}

static void release(model_mesh *m) {
    bolan_release(m->positions, m->vertex_room * sizeof *m->positions);
    bolan_release(m->normals, m->vertex_room * sizeof *m->normals);
    bolan_release(m->colors, m->vertex_room * sizeof *m->colors);
    bolan_release(m->indices, m->index_room * sizeof *m->indices);
}

static bolan_result check_positions(const char *path, const model_mesh *m) {
    for (uint32_t i = 0; i < m->vertex_count; i++) {
        const bolan_vec3 p = m->positions[i];
        if (!isfinite(p.x + p.y + p.z)) return refuse(path, "a vertex is not finite");
        if (fmaxf(fabsf(p.x), fmaxf(fabsf(p.y), fabsf(p.z))) > MODEL_REACH)
            return refuse(path, "a vertex lies more than 1e7 m from the origin; an offset brings it back");
    }
    return BOLAN_OK;
}

static bolan_result fill(gathered *g, const char *path, bolan_model **out) {
    const struct aiMatrix4x4 still = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    model_mesh *m = &g->mesh;
    if (!g->scene->mRootNode || !walk(g, g->scene->mRootNode, &still, 0))
        return refuse(path, "more than a model can hold; expected at most 8388608 vertices, and nodes 64 deep");
    if (m->vertex_count < 3 || m->index_count < 3) return refuse(path, "there is no triangle in it");
    if (!allocate(m)) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY, "%s: no memory for %u vertices", path,
                  (unsigned)m->vertex_room);
        return BOLAN_ERROR_MEMORY;
    }
    g->nodes = 0;
    walk(g, g->scene->mRootNode, &still, 0);
    if (g->result) return g->result;
    if (m->vertex_count < 3 || m->index_count < 3) return refuse(path, "there is no triangle in it");
    if (check_positions(path, m)) return BOLAN_ERROR_FORMAT;
    const bolan_model_view view = {m->vertex_count, m->index_count, m->positions, m->normals, m->colors, m->indices};
    return bolan_model_create(&view, out);
}

static bolan_result check_desc(const bolan_model_desc *d) {
    const bolan_dvec3 o = d->offset;
    if (fabs(o.x) <= 1e8 && fabs(o.y) <= 1e8 && fabs(o.z) <= 1e8 && (unsigned)d->up <= BOLAN_UP_Z) return BOLAN_OK;
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_RANGE, "%s: offset (%g, %g, %g), up %d; expected +-1e8 each, 0 or 1",
              d->path, o.x, o.y, o.z, (int)d->up);
    return BOLAN_ERROR_ARGUMENT;
}

bolan_result bolan_model_load(const bolan_model_desc *desc, bolan_model **out) {
    BOLAN_ASSERT(desc && desc->path && out);
    *out = NULL;
    model_format format;
    bolan_result result = check_desc(desc);
    if (!result) result = bolan_model_file_check(desc->path, &format);
    if (result) return result;
    gathered g = {.scene = import(desc->path), .desc = desc, .crease = format == MODEL_GLTF ? FLAT : CREASE};
    if (!g.scene) return cannot_import(desc->path);
    result = fill(&g, desc->path, out);
    release(&g.mesh);
    aiReleaseImport(g.scene);
    return result;
}

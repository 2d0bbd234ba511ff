// SPDX-License-Identifier: MIT
// Models from files, by assimp's C interface: the meshes of all nodes with their transforms, turned from y-up to z-up, in
// one colour a vertex. Nothing that the library hands over is trusted: counts, indices and numbers are checked.
#include "bolan/io.h"

#include <assimp/cimport.h>
#include <assimp/config.h>
#include <assimp/material.h>
#include <assimp/mesh.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#define FILE_LIMIT (256ull << 20)
#define VERTEX_LIMIT (1u << 24) // as many indices, too: more than anybody draws
#define DEPTH_LIMIT 64          // of nodes in nodes

// What is gathered: first counted, then filled.
typedef struct gathered {
    const struct aiScene *scene;
    uint32_t vertex_count, index_count, vertex_room, index_room, nodes;
    bolan_vec3 *positions, *normals;
    bolan_vec4 *colors;
    uint32_t *indices;
} gathered;

// ---- one mesh -------------------------------------------------------------------------------------------------------

static bool finite3(struct aiVector3D v) { return isfinite(v.x) && isfinite(v.y) && isfinite(v.z); }
static float share(float x) { return x >= 0.0f ? fminf(x, 1.0f) : 0.0f; } // also of what is no number

// Files are y-up: x stays, what was up becomes z, and what looked to the viewer (+z) looks to -y.
static bolan_vec3 turned(float x, float y, float z) { return bolan_v3(x, -z, y); }

static bolan_vec4 base_color(const struct aiScene *scene, const struct aiMesh *mesh) {
    struct aiColor4D c = {0.6f, 0.6f, 0.6f, 1.0f};
    if (mesh->mMaterialIndex < scene->mNumMaterials) {
        const struct aiMaterial *m = scene->mMaterials[mesh->mMaterialIndex];
        if (aiGetMaterialColor(m, AI_MATKEY_BASE_COLOR, &c) != aiReturn_SUCCESS)
            aiGetMaterialColor(m, AI_MATKEY_COLOR_DIFFUSE, &c);
    }
    return (bolan_vec4){share(c.r), share(c.g), share(c.b), 1.0f};
}

static bolan_vec3 moved(const struct aiMatrix4x4 *m, struct aiVector3D v) {
    return turned(m->a1 * v.x + m->a2 * v.y + m->a3 * v.z + m->a4, m->b1 * v.x + m->b2 * v.y + m->b3 * v.z + m->b4,
                  m->c1 * v.x + m->c2 * v.y + m->c3 * v.z + m->c4);
}

static float determinant(const struct aiMatrix4x4 *m) {
    return m->a1 * (m->b2 * m->c3 - m->b3 * m->c2) - m->a2 * (m->b1 * m->c3 - m->b3 * m->c1) +
           m->a3 * (m->b1 * m->c2 - m->b2 * m->c1);
}

// By the cofactors: the inverse transpose but for a factor, also where the matrix has none. A mirroring node turns the
// cofactors over; the sign turns the normal back.
static bolan_vec3 moved_normal(const struct aiMatrix4x4 *m, struct aiVector3D n, float sign) {
    const bolan_vec3 a = {m->a1, m->a2, m->a3}, b = {m->b1, m->b2, m->b3}, c = {m->c1, m->c2, m->c3};
    const bolan_vec3 v = {n.x, n.y, n.z};
    const bolan_vec3 t = turned(bolan_v3_dot(bolan_v3_cross(b, c), v), bolan_v3_dot(bolan_v3_cross(c, a), v),
                                bolan_v3_dot(bolan_v3_cross(a, b), v));
    const float length = bolan_v3_length(t);
    return length > 1e-20f && isfinite(length) ? bolan_v3_scale(t, sign / length) : bolan_v3(0.0f, 0.0f, 1.0f);
}

static void add_vertices(gathered *g, const struct aiMesh *mesh, const struct aiMatrix4x4 *m) {
    const bolan_vec4 base = base_color(g->scene, mesh);
    const struct aiColor4D *painted = mesh->mColors[0];
    const float sign = determinant(m) < 0.0f ? -1.0f : 1.0f;
    for (uint32_t i = 0; i < mesh->mNumVertices; i++) {
        const uint32_t n = g->vertex_count + i;
        const struct aiVector3D up = {0.0f, 1.0f, 0.0f};
        g->positions[n] = moved(m, mesh->mVertices[i]);
        g->normals[n] = moved_normal(m, mesh->mNormals && finite3(mesh->mNormals[i]) ? mesh->mNormals[i] : up, sign);
        g->colors[n] = base;
        if (!painted) continue;
        g->colors[n].x *= share(painted[i].r);
        g->colors[n].y *= share(painted[i].g);
        g->colors[n].z *= share(painted[i].b);
    }
}

static void add_triangles(gathered *g, const struct aiMesh *mesh, bool mirrored) {
    for (uint32_t f = 0; f < mesh->mNumFaces; f++) {
        const struct aiFace *face = &mesh->mFaces[f];
        if (face->mNumIndices != 3) continue;
        const unsigned *i = face->mIndices;
        if (i[0] >= mesh->mNumVertices || i[1] >= mesh->mNumVertices || i[2] >= mesh->mNumVertices) continue;
        g->indices[g->index_count++] = g->vertex_count + i[0];
        g->indices[g->index_count++] = g->vertex_count + i[mirrored ? 2 : 1];
        g->indices[g->index_count++] = g->vertex_count + i[mirrored ? 1 : 2];
    }
}

// ---- the tree of nodes ----------------------------------------------------------------------------------------------

static bool is_drawn(const struct aiMesh *mesh) { return mesh->mVertices && mesh->mFaces && mesh->mNumVertices >= 3; }

static void add_mesh(gathered *g, const struct aiMesh *mesh, const struct aiMatrix4x4 *m) {
    if (g->positions) { // the second time
        add_vertices(g, mesh, m);
        add_triangles(g, mesh, determinant(m) < 0.0f);
    }
    g->vertex_count += mesh->mNumVertices;
    if (!g->positions) g->index_count += 3 * (mesh->mNumFaces < VERTEX_LIMIT ? mesh->mNumFaces : VERTEX_LIMIT);
}

// False when the file is larger or deeper than a model can be.
static bool walk(gathered *g, const struct aiNode *node, const struct aiMatrix4x4 *parent, int depth) {
    if (depth > DEPTH_LIMIT || ++g->nodes > VERTEX_LIMIT) return false;
    struct aiMatrix4x4 m = *parent;
    aiMultiplyMatrix4(&m, &node->mTransformation);
    for (uint32_t i = 0; i < node->mNumMeshes; i++) {
        if (node->mMeshes[i] >= g->scene->mNumMeshes) continue;
        const struct aiMesh *mesh = g->scene->mMeshes[node->mMeshes[i]];
        if (!is_drawn(mesh)) continue;
        if (mesh->mNumVertices > VERTEX_LIMIT) return false;
        add_mesh(g, mesh, &m);
        if (g->vertex_count > VERTEX_LIMIT || g->index_count > 3 * VERTEX_LIMIT) return false;
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

static bolan_result check_file(const char *path) {
    struct stat s;
    if (stat(path, &s) != 0) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_FILE_OPEN, "%s: cannot be read: %s", path, strerror(errno));
        return BOLAN_ERROR_IO;
    }
    if (!S_ISREG(s.st_mode)) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_FILE_OPEN, "%s: is not a file; expected a model (OBJ, glTF)", path);
        return BOLAN_ERROR_IO;
    }
    if ((unsigned long long)s.st_size > FILE_LIMIT) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_FILE_TOO_LARGE, "%s: larger than a model can be; expected at most 256 MiB",
                  path);
        return BOLAN_ERROR_IO;
    }
    return BOLAN_OK;
}

static const struct aiScene *import(const char *path) {
    struct aiPropertyStore *store = aiCreatePropertyStore();
    if (!store) return NULL;
    aiSetImportPropertyInteger(store, AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    const unsigned steps = aiProcess_ValidateDataStructure | aiProcess_FindInvalidData | aiProcess_Triangulate |
                           aiProcess_SortByPType | aiProcess_GenSmoothNormals | aiProcess_JoinIdenticalVertices;
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

static bolan_result fill(gathered *g, const char *path, bolan_model **out) {
    const struct aiMatrix4x4 still = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    g->nodes = 0;
    if (!g->scene->mRootNode || !walk(g, g->scene->mRootNode, &still, 0))
        return refuse(path, "more than a model can hold; expected at most 16777216 vertices, and nodes 64 deep");
    if (g->vertex_count < 3 || g->index_count < 3) return refuse(path, "there is no triangle in it");
    g->vertex_room = g->vertex_count;
    g->index_room = g->index_count;
    g->positions = bolan_allocate(g->vertex_room * sizeof *g->positions);
    g->normals = bolan_allocate(g->vertex_room * sizeof *g->normals);
    g->colors = bolan_allocate(g->vertex_room * sizeof *g->colors);
    g->indices = bolan_allocate(g->index_room * sizeof *g->indices);
    if (!g->positions || !g->normals || !g->colors || !g->indices) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY, "%s: no memory for %u vertices", path,
                  (unsigned)g->vertex_count);
        return BOLAN_ERROR_MEMORY;
    }
    g->vertex_count = g->index_count = g->nodes = 0;
    walk(g, g->scene->mRootNode, &still, 0);
    if (g->index_count < 3) return refuse(path, "there is no triangle in it");
    for (uint32_t i = 0; i < g->vertex_count; i++)
        if (!isfinite(g->positions[i].x + g->positions[i].y + g->positions[i].z))
            return refuse(path, "a vertex is not finite");
    const bolan_model_view view = {g->vertex_count, g->index_count, g->positions, g->normals, g->colors, g->indices};
    return bolan_model_create(&view, out);
}

bolan_result bolan_model_load(const char *path, bolan_model **out) {
    BOLAN_ASSERT(path && out);
    *out = NULL;
    bolan_result result = check_file(path);
    if (result) return result;
    gathered g = {.scene = import(path)};
    if (!g.scene) return cannot_import(path);
    result = fill(&g, path, out);
    bolan_release(g.positions, g.vertex_room * sizeof *g.positions);
    bolan_release(g.normals, g.vertex_room * sizeof *g.normals);
    bolan_release(g.colors, g.vertex_room * sizeof *g.colors);
    bolan_release(g.indices, g.index_room * sizeof *g.indices);
    aiReleaseImport(g.scene);
    return result;
}

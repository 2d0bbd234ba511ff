// SPDX-License-Identifier: MIT
// Limits of a glTF 2.0 file that bound the cost of the importing library (Khronos, glTF 2.0 specification; section
// numbers below).
#include "io/assimp/model_file.h"
#include "io/file.h"
#include "io/json.h"

#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#define UNSTORED_LIMIT (1u << 20)                // elements of accessors without bytes in the file
#define COPIED_LIMIT (3ull * MODEL_VERTEX_LIMIT) // elements of all attributes that are copied out of accessors

typedef struct gltf {
    const char *path;
    json_text json;
    uint32_t accessor_count;
    uint64_t *counts; // of the accessors
} gltf;

static int member_of_root(const gltf *g, const char *key) { return bolan_json_member(&g->json, 0, key); }

static uint64_t whole_member(const gltf *g, int object, const char *key, uint64_t otherwise) {
    return bolan_json_whole(&g->json, bolan_json_member(&g->json, object, key), otherwise);
}

#define EACH(element, array, g)                                             \
    for (int element = bolan_json_first(&(g)->json, (array)); element >= 0; \
         element = bolan_json_after(&(g)->json, (array), element))

// ---- version and extensions (3.2, 3.12) -----------------------------------------------------------------------------

static bolan_result check_version(const gltf *g) {
    const int version = bolan_json_member(&g->json, member_of_root(g, "asset"), "version");
    if (version >= 0 && g->json.text[g->json.values[version].start] == '2') return BOLAN_OK;
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_MODEL_FORMAT, "%s: it is not of glTF 2: asset.version does not begin with 2",
              g->path);
    return BOLAN_ERROR_FORMAT;
}

// Extensions that do not affect the data that are read: materials, textures, and lights.
static bool is_harmless(const char *name, size_t length) {
    static const char *const harmless[] = {"KHR_materials_unlit", "KHR_texture_transform", "KHR_lights_punctual"};
    for (size_t i = 0; i < sizeof harmless / sizeof *harmless; i++)
        if (strlen(harmless[i]) == length && memcmp(harmless[i], name, length) == 0) return true;
    return false;
}

static bolan_result check_extensions(const gltf *g) {
    const int list = member_of_root(g, "extensionsRequired");
    EACH(e, list, g) {
        const json_value *v = &g->json.values[e];
        const char *name = g->json.text + v->start;
        if (is_harmless(name, v->length)) continue;
        char shown[64];
        snprintf(shown, sizeof shown, "%.*s", (int)(v->length < 60 ? v->length : 60), name);
        for (char *c = shown; *c; c++)
            if ((unsigned char)*c < 32 || (unsigned char)*c > 126) *c = '?';
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_MODEL_EXTENSION,
                  "%s: it requires the glTF extension %s, which is not read; export it without", g->path, shown);
        return BOLAN_ERROR_FORMAT;
    }
    return BOLAN_OK;
}

// ---- nodes (3.5.2): a forest ----------------------------------------------------------------------------------------

static bolan_result find_parents(const gltf *g, int nodes, uint32_t count, uint32_t *parent) {
    uint32_t n = 0;
    for (uint32_t i = 0; i < count; i++) parent[i] = count; // none
    EACH(node, nodes, g) {
        const int children = bolan_json_member(&g->json, node, "children");
        EACH(c, children, g) {
            const uint64_t child = bolan_json_whole(&g->json, c, UINT64_MAX);
            if (child >= count) return bolan_model_refuse(g->path, "a node has a child that is no node");
            if (parent[child] != count) return bolan_model_refuse(g->path, "a node has two parents");
            parent[child] = n;
        }
        n++;
    }
    return BOLAN_OK;
}

static bolan_result check_nodes(const gltf *g) {
    const int nodes = member_of_root(g, "nodes");
    uint32_t count = 0;
    EACH(node, nodes, g) count++;
    if (count == 0) return BOLAN_OK;
    uint32_t *parent = bolan_allocate(count * sizeof *parent);
    if (!parent) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY, "%s: no memory for %u nodes", g->path, (unsigned)count);
        return BOLAN_ERROR_MEMORY;
    }
    bolan_result result = find_parents(g, nodes, count, parent);
    for (uint32_t i = 0; i < count && !result; i++) {
        int depth = 0;
        for (uint32_t up = i; up != count && depth <= MODEL_DEPTH_LIMIT; up = parent[up]) depth++;
        if (depth > MODEL_DEPTH_LIMIT) result = bolan_model_refuse(g->path, "its nodes are nested more than 64 deep");
    }
    bolan_release(parent, count * sizeof *parent);
    return result;
}

// ---- buffers and accessors (3.6) ------------------------------------------------------------------------------------

// Checks the files that the glTF refers to. The library reports missing files.
static bolan_result check_buffers(const gltf *g) {
    uint64_t total = 0;
    const int buffers = member_of_root(g, "buffers");
    EACH(b, buffers, g) {
        const int uri = bolan_json_member(&g->json, b, "uri");
        if (uri < 0) continue;
        const json_value *v = &g->json.values[uri];
        char name[BOLAN_PATH_MAX], path[BOLAN_PATH_MAX];
        if (v->length > 5 && memcmp(g->json.text + v->start, "data:", 5) == 0) continue;
        snprintf(name, sizeof name, "%.*s", (int)v->length, g->json.text + v->start);
        struct stat s;
        if (!bolan_file_resolve(g->path, name, path) || stat(path, &s) != 0) continue;
        if (!S_ISREG(s.st_mode)) return bolan_model_refuse(g->path, "a buffer of it is no file");
        total += (uint64_t)s.st_size;
    }
    return total <= MODEL_FILE_LIMIT ? BOLAN_OK : bolan_model_refuse(g->path, "its buffers are larger than 64 MiB");
}

static bolan_result read_accessors(gltf *g) {
    const int accessors = member_of_root(g, "accessors");
    EACH(a, accessors, g) g->accessor_count++;
    if (g->accessor_count == 0) return BOLAN_OK;
    g->counts = bolan_allocate(g->accessor_count * sizeof *g->counts);
    if (!g->counts) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY, "%s: no memory for %u accessors", g->path,
                  (unsigned)g->accessor_count);
        return BOLAN_ERROR_MEMORY;
    }
    uint64_t unstored = 0;
    uint32_t n = 0;
    EACH(a, accessors, g) {
        const uint64_t count = whole_member(g, a, "count", 0);
        if (count > 3ull * MODEL_VERTEX_LIMIT)
            return bolan_model_refuse(g->path, "an accessor has more elements than a model can have vertices");
        if (bolan_json_member(&g->json, a, "bufferView") < 0) unstored += count;
        g->counts[n++] = count;
    }
    return unstored <= UNSTORED_LIMIT
               ? BOLAN_OK
               : bolan_model_refuse(g->path, "more than 1048576 elements have no bytes in a buffer");
}

static uint64_t count_of(const gltf *g, int object, const char *key) {
    const uint64_t n = whole_member(g, object, key, UINT64_MAX);
    return n < g->accessor_count ? g->counts[n] : 0;
}

// Elements that are copied out of accessors; an accessor may be used by many primitives.
static uint64_t copied_by_meshes(const gltf *g) {
    uint64_t total = 0;
    const int meshes = member_of_root(g, "meshes");
    EACH(mesh, meshes, g) {
        const int primitives = bolan_json_member(&g->json, mesh, "primitives");
        EACH(p, primitives, g) {
            const int attributes = bolan_json_member(&g->json, p, "attributes"),
                      targets = bolan_json_member(&g->json, p, "targets");
            uint64_t kinds = attributes < 0 ? 0 : 1;
            if (attributes >= 0) kinds += (uint64_t)(g->json.values[attributes].next - attributes) / 2;
            EACH(t, targets, g) kinds += 3;
            total += kinds * count_of(g, attributes, "POSITION") + count_of(g, p, "indices");
        }
    }
    return total;
}

static uint64_t copied_by_animations(const gltf *g) {
    uint64_t total = 0;
    const int animations = member_of_root(g, "animations");
    EACH(a, animations, g) {
        const int samplers = bolan_json_member(&g->json, a, "samplers"),
                  channels = bolan_json_member(&g->json, a, "channels");
        uint64_t most = 0, uses = 0;
        EACH(s, samplers, g) {
            const uint64_t count = count_of(g, s, "input") + count_of(g, s, "output");
            most = count > most ? count : most;
        }
        EACH(c, channels, g) uses++;
        total += most * uses;
    }
    return total;
}

// Bytes of embedded images, each copied by the library.
static uint64_t copied_by_images(const gltf *g) {
    const int views = member_of_root(g, "bufferViews"), images = member_of_root(g, "images");
    uint64_t longest = 0, uses = 0;
    EACH(v, views, g) {
        const uint64_t length = whole_member(g, v, "byteLength", 0);
        longest = length > longest ? length : longest;
    }
    EACH(i, images, g) uses += bolan_json_member(&g->json, i, "bufferView") >= 0;
    return longest > MODEL_FILE_LIMIT ? 0
                                      : longest * uses / 12; // a longer view than any buffer is refused by the library
}

bolan_result bolan_model_gltf_check(const char *path, const char *text, size_t size) {
    gltf g = {.path = path};
    bolan_result result = bolan_json_read(path, text, size, &g.json);
    if (!result) result = check_version(&g);
    if (!result) result = check_extensions(&g);
    if (!result) result = check_nodes(&g);
    if (!result) result = check_buffers(&g);
    if (!result) result = read_accessors(&g);
    if (!result && copied_by_meshes(&g) + copied_by_animations(&g) + copied_by_images(&g) > COPIED_LIMIT)
        result = bolan_model_refuse(path, "its meshes, animations or images use the same data too often");
    bolan_release(g.counts, g.accessor_count * sizeof *g.counts);
    bolan_json_release(&g.json);
    return result;
}

// SPDX-License-Identifier: MIT
// Models from files, and objects of scenes.
#include "bolan/io.h"
#include "io_support.h"

#include <sys/resource.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

// ---- files ----------------------------------------------------------------------------------------------------------

// A square of 2 m in the x-y plane of the file, which looks to the viewer (+z).
static const char *const square_obj = "mtllib square.mtl\n"
                                      "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\n"
                                      "usemtl red\n"
                                      "f 1 2 3 4\n";
static const char *const square_mtl = "newmtl red\nKd 0.8 0.1 0.2\n";

static bolan_result load(const char *path, bolan_model **out) {
    return bolan_model_load(&(bolan_model_desc){.path = path}, out);
}

static void test_an_obj_is_read_with_its_material(void **state) {
    (void)state;
    write_text("square.obj", square_obj);
    write_text("square.mtl", square_mtl);
    bolan_model *model = NULL;
    assert_int_equal(load("square.obj", &model), BOLAN_OK);
    const bolan_model_view v = bolan_model_get_view(model);
    assert_int_equal(v.index_count, 6);
    for (uint32_t i = 0; i < v.vertex_count; i++) {
        assert_near(v.colors[i].x, 0.8, 1e-6); // as text of few digits
        assert_near(v.colors[i].y, 0.1, 1e-6);
        assert_near(v.colors[i].w, 1.0, 0.0);
        // z up: what was up in the file (y) is z, and what looked to its viewer looks to -y.
        assert_near(v.positions[i].y, 0.0, 0.0);
        assert_true(v.positions[i].z == 0.0f || v.positions[i].z == 2.0f);
        assert_near(v.normals[i].y, -1.0, 1e-6);
    }
    const bolan_vec3 a = v.positions[v.indices[0]], b = v.positions[v.indices[1]], c = v.positions[v.indices[2]];
    assert_true(bolan_v3_cross(bolan_v3_sub(b, a), bolan_v3_sub(c, a)).y < 0.0f); // counter-clockwise from outside
    bolan_model_destroy(&model);
}

// One triangle (0,0,0) (1,0,0) (0,1,0) with a colour, under two nodes: moved by (10, 0, 0), inside one twice as large
// and mirrored in x. Buffer: 9 floats, then 3 uint16.
static const char *const triangle_gltf =
    "{\"asset\": {\"version\": \"2.0\"}, \"scene\": 0, \"scenes\": [{\"nodes\": [0]}],\n"
    " \"nodes\": [{\"scale\": [-2, 2, 2], \"children\": [1]}, {\"mesh\": 0, \"translation\": [10, 0, 0]}],\n"
    " \"meshes\": [{\"primitives\": [{\"attributes\": {\"POSITION\": 0}, \"indices\": 1, \"material\": 0}]}],\n"
    " \"materials\": [{\"pbrMetallicRoughness\": {\"baseColorFactor\": [0.25, 0.5, 0.75, 1]}}],\n"
    " \"accessors\": [\n"
    "  {\"bufferView\": 0, \"componentType\": 5126, \"count\": 3, \"type\": \"VEC3\", \"min\": [0, 0, 0], \"max\": [1, "
    "1, 0]},\n"
    "  {\"bufferView\": 1, \"componentType\": 5123, \"count\": 3, \"type\": \"SCALAR\"}],\n"
    " \"bufferViews\": [{\"buffer\": 0, \"byteOffset\": 0, \"byteLength\": 36}, {\"buffer\": 0, \"byteOffset\": 36, "
    "\"byteLength\": 6}],\n"
    " \"buffers\": [{\"byteLength\": 42, \"uri\": \"data:application/octet-stream;base64,"
    "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAABAAIA\"}]}\n";

static void test_a_gltf_is_read_with_its_nodes(void **state) {
    (void)state;
    write_text("triangle.gltf", triangle_gltf);
    bolan_model *model = NULL;
    assert_int_equal(load("triangle.gltf", &model), BOLAN_OK);
    const bolan_model_view v = bolan_model_get_view(model);
    assert_int_equal(v.index_count, 3);
    float west = 0.0f, top = 0.0f;
    for (uint32_t i = 0; i < v.vertex_count; i++) {
        west = fminf(west, v.positions[i].x);
        top = fmaxf(top, v.positions[i].z);
        assert_near(v.colors[i].x, 0.25, 1e-6);
        assert_near(v.colors[i].z, 0.75, 1e-6);
        assert_near(v.normals[i].y, -1.0, 1e-5); // the mirrored face still looks where it looked
    }
    assert_near(west, -22.0, 1e-5); // (1 + 10) x -2
    assert_near(top, 2.0, 1e-5);
    const bolan_vec3 a = v.positions[v.indices[0]], b = v.positions[v.indices[1]], c = v.positions[v.indices[2]];
    assert_true(bolan_v3_cross(bolan_v3_sub(b, a), bolan_v3_sub(c, a)).y < 0.0f); // and its order with it
    bolan_model_destroy(&model);
}

static void test_what_is_no_model_is_refused(void **state) {
    (void)state;
    bolan_model *model = NULL;
    assert_refusal(load("no-such.obj", &model), BOLAN_ERROR_IO, BOLAN_LOG_FILE_OPEN, "no-such.obj");
    assert_refusal(load(".", &model), BOLAN_ERROR_IO, BOLAN_LOG_FILE_OPEN, "is not a file");
    static const struct {
        const char *name, *text;
    } bad[] = {
        {"noise.obj", "v a b c\nf 9 9 9\nf -1 -2 -3\n"},
        {"empty.obj", ""},
        {"points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n"},
        {"lines.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n"},
        {"beyond.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 900\n"},
        {"cut.gltf", "{\"asset\": {\"version\": \"2.0\"}, \"meshes\": [{\"primitives\": ["},
        {"text.gltf", "not JSON at all"},
        {"what.xyz", "1 2 3"},
    };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        write_text(bad[i].name, bad[i].text);
        assert_refusal(load(bad[i].name, &model), BOLAN_ERROR_FORMAT, BOLAN_LOG_MODEL_FORMAT, bad[i].name);
        assert_null(model);
    }
}

// Accessors that point beyond the buffer, counts that lie, indices beyond the vertices: refused, or read without harm.
static void test_a_lying_gltf_does_no_harm(void **state) {
    (void)state;
    static const struct {
        const char *true_text, *lie;
    } lies[] = {
        {"\"count\": 3, \"type\": \"VEC3\"", "\"count\": 900000000, \"type\": \"VEC3\""},
        {"\"byteLength\": 36", "\"byteLength\": 36000"},
        {"\"byteOffset\": 36", "\"byteOffset\": 4000000000"},
        {"\"children\": [1]", "\"children\": [7]"},
        {"\"indices\": 1", "\"indices\": 0"},
        {"\"mesh\": 0", "\"mesh\": 3"},
        {"AAABAAIA", "AAABAP9/"},
        {"[-2, 2, 2]", "[0, 0, 0]"},
    };
    for (size_t i = 0; i < sizeof lies / sizeof *lies; i++) {
        char text[2048] = "";
        const char *at = strstr(triangle_gltf, lies[i].true_text);
        assert_non_null(at);
        snprintf(text, sizeof text, "%.*s%s%s", (int)(at - triangle_gltf), triangle_gltf, lies[i].lie,
                 at + strlen(lies[i].true_text));
        write_text("lie.gltf", text);
        bolan_model *model = NULL;
        const bolan_result result = load("lie.gltf", &model);
        assert_true((result == BOLAN_OK) == (model != NULL));
        bolan_model_destroy(&model);
    }
}

// ---- what takes too long --------------------------------------------------------------------------------------------

// Text that is put together: a head, a part so many times, a tail.
static void write_repeated(const char *path, const char *head, const char *part, int times, const char *tail) {
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    fputs(head, file);
    for (int i = 0; i < times; i++) fputs(part, file);
    fputs(tail, file);
    fclose(file);
}

#define GLTF "{\"asset\": {\"version\": \"2.0\"}, "
#define POINT_ACCESSOR \
    "\"nodes\": [{\"mesh\": 0}], \"accessors\": [{\"componentType\": 5126, \"count\": 1000000, \"type\": \"VEC3\"}], "

// Each is small, and took seconds, gigabytes or the stack in the importing library. Refused before it is asked: within
// 2 s and 256 MB, which is far above what the checks take, and far below what the library took.
static void test_what_would_take_too_long_is_refused_at_once(void **state) {
    (void)state;
    static const struct {
        const char *name, *head, *part;
        int times;
        const char *tail, *words;
    } files[] = {
        {"digits.obj", "v 0 0 0\nv ", "1", 200000, " 0 0\nv 0 1 0\nf 1 2 3\n",
         "digits.obj:2: a number has more than 64"},
        {"index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 ", "3", 400000, "\n", "index.obj:4: a number has more than"},
        {"face.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf", " 1 2 3", 30000, "\n", "face.obj:4: a face has more than 1024"},
        {"brackets.gltf", GLTF "\"x\":", "[", 200000, "", "brackets are nested more than 64 deep"},
        {"maps.gltf", GLTF "\"x\":", "{\"a\":", 50000, "", "brackets are nested more than 64 deep"},
        {"digits.gltf", GLTF "\n\"x\": ", "7", 200000, "}", "digits.gltf:2: a number is longer than 64"},
        {"values.gltf", GLTF "\"x\": [", "0,", 1100000, "0]}", "more JSON values"},
        {"masked.dat", GLTF "\"x\":", "[", 200000, "", "brackets are nested more than 64 deep"},
        {"count.gltf", GLTF "\"accessors\": [{\"count\": ", "9", 9, "}]}", "an accessor has more elements"},
        {"unstored.gltf", GLTF "\"accessors\": [", "{\"count\": 100000}, ", 11, "{}]}", "have no bytes in a buffer"},
        {"shared.gltf", GLTF POINT_ACCESSOR "\"meshes\": [{\"primitives\": [", "{\"attributes\": {\"POSITION\": 0}}, ",
         2000, "{}]}]}", "use the same data too often"},
        {"moved.gltf", GLTF POINT_ACCESSOR "\"animations\": [{\"samplers\": [{\"input\": 0}], \"channels\": [", "{}, ",
         100, "{}]}]}", "use the same data too often"},
        {"elements.dae", "<?xml version=\"1.0\"?><COLLADA>", "<node>", 100000, "", "nested more than 128 deep"},
        {"frames.x", "xof 0303txt 0032\n", "Frame a {\n", 50000, "", "frames.x:130: brackets or elements"},
        {"count.ply", "ply\nformat ascii 1.0\nelement vertex ", "9", 12, "\nend_header\n", "more elements than it has"},
    };
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        bolan_model *model = NULL;
        write_repeated(files[i].name, files[i].head, files[i].part, files[i].times, files[i].tail);
        const clock_t before = clock();
        assert_refusal(load(files[i].name, &model), BOLAN_ERROR_FORMAT, BOLAN_LOG_MODEL_LIMIT, files[i].words);
        assert_true((double)(clock() - before) < 2.0 * CLOCKS_PER_SEC);
        assert_null(model);
        remove(files[i].name);
    }
#ifndef __SANITIZE_ADDRESS__ // whose own memory counts too
    struct rusage use;
    getrusage(RUSAGE_SELF, &use);
    assert_true(use.ru_maxrss < 256 * 1024); // [KiB]
#endif
}

static void test_materials_are_checked_too(void **state) {
    (void)state;
    bolan_model *model = NULL;
    write_text("long.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nmtllib long.mtl\nf 1 2 3\n");
    write_repeated("long.mtl", "newmtl a\nKd ", "1", 200000, " 0 0\n");
    assert_refusal(load("long.obj", &model), BOLAN_ERROR_FORMAT, BOLAN_LOG_MODEL_LIMIT,
                   "long.mtl:2: a number has more than 64");
    remove("long.mtl");
    assert_int_equal(mkdir("long.mtl", 0700), 0);
    assert_refusal(load("long.obj", &model), BOLAN_ERROR_FORMAT, BOLAN_LOG_MODEL_LIMIT, "long.mtl: is not a file");
    rmdir("long.mtl");
    assert_int_equal(load("long.obj", &model), BOLAN_OK);
    bolan_model_destroy(&model);
    remove("long.obj");
}

// A chain of @p count nodes, the last of which has a mesh: 64 are read, more are not.
static void write_chain(const char *path, int count) {
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    const char *mesh = strstr(triangle_gltf, "\"meshes\"");
    fprintf(file, GLTF "\"scene\": 0, \"scenes\": [{\"nodes\": [0]}], \"nodes\": [");
    for (int i = 0; i + 1 < count; i++) fprintf(file, "{\"children\": [%d]}, ", i + 1);
    fprintf(file, "{\"mesh\": 0}], %s", mesh);
    fclose(file);
}

static void test_nodes_in_nodes(void **state) {
    (void)state;
    bolan_model *model = NULL;
    write_chain("chain.gltf", 60);
    assert_int_equal(load("chain.gltf", &model), BOLAN_OK);
    bolan_model_destroy(&model);
    const int deep[] = {65, 60000};
    for (int i = 0; i < 2; i++) {
        write_chain("chain.gltf", deep[i]);
        assert_refusal(load("chain.gltf", &model), BOLAN_ERROR_FORMAT, BOLAN_LOG_MODEL_LIMIT,
                       "nested more than 64 deep");
    }
    write_text("chain.gltf", GLTF "\"nodes\": [{\"children\": [1]}, {\"children\": [0]}]}");
    assert_refusal(load("chain.gltf", &model), BOLAN_ERROR_FORMAT, BOLAN_LOG_MODEL_LIMIT, "nested more than 64 deep");
    write_text("chain.gltf", GLTF "\"nodes\": [{\"children\": [2]}, {\"children\": [2]}, {}]}");
    assert_refusal(load("chain.gltf", &model), BOLAN_ERROR_FORMAT, BOLAN_LOG_MODEL_LIMIT, "a node has two parents");
    write_text("chain.gltf", GLTF "\"nodes\": [{\"children\": [1]}]}");
    assert_refusal(load("chain.gltf", &model), BOLAN_ERROR_FORMAT, BOLAN_LOG_MODEL_LIMIT, "a child that is no node");
    write_text("chain.gltf", GLTF "\"nod\\u0065s\": []}");
    assert_refusal(load("chain.gltf", &model), BOLAN_ERROR_FORMAT, BOLAN_LOG_MODEL_FORMAT,
                   "a plain letter as an escape");
    write_text("chain.gltf", "{\"asset\": {\"version\": \"1.0\"}}");
    assert_refusal(load("chain.gltf", &model), BOLAN_ERROR_FORMAT, BOLAN_LOG_MODEL_FORMAT, "it is not of glTF 2");
    remove("chain.gltf");
}

// A GLB: its JSON is checked as that of a .gltf, whatever the file is called.
static void test_a_glb_is_checked(void **state) {
    (void)state;
    bolan_model *model = NULL;
    const char *json = GLTF "\"extensionsRequired\": [\"EXT_of_nobody\"]}";
    const uint32_t length = (uint32_t)strlen(json), head[5] = {0x46546c67u, 2u, 20u + length, length, 0x4e4f534au};
    for (int i = 0; i < 2; i++) {
        const char *name = i ? "boat.glb" : "boat.bin";
        FILE *file = fopen(name, "wb");
        assert_non_null(file);
        fwrite(head, sizeof head, 1, file); // little-endian, as this machine
        fputs(json, file);
        fclose(file);
        assert_refusal(load(name, &model), BOLAN_ERROR_FORMAT, BOLAN_LOG_MODEL_EXTENSION,
                       "it requires the glTF extension EXT_of_nobody");
        remove(name);
    }
    FILE *file = fopen("short.glb", "wb");
    assert_non_null(file);
    fwrite(head, sizeof head, 1, file);
    fclose(file);
    assert_refusal(load("short.glb", &model), BOLAN_ERROR_FORMAT, BOLAN_LOG_MODEL_LIMIT,
                   "JSON is longer than the file");
    remove("short.glb");
}

static void test_required_extensions_are_refused_by_name(void **state) {
    (void)state;
    char path[1024];
    bolan_model *model = NULL;
    assert_refusal(load(test_data("models/quant.gltf", path, sizeof path), &model), BOLAN_ERROR_FORMAT,
                   BOLAN_LOG_MODEL_EXTENSION, "quant.gltf: it requires the glTF extension KHR_mesh_quantization");
    assert_refusal(load(test_data("models/unknownext.gltf", path, sizeof path), &model), BOLAN_ERROR_FORMAT,
                   BOLAN_LOG_MODEL_EXTENSION, "it requires the glTF extension EXT_mesh_gpu_instancing");
    char text[2048]; // one that changes nothing of what is read
    snprintf(text, sizeof text, "{\"extensionsRequired\": [\"KHR_materials_unlit\"], %s", triangle_gltf + 1);
    write_text("unlit.gltf", text);
    assert_int_equal(load("unlit.gltf", &model), BOLAN_OK);
    bolan_model_destroy(&model);
    remove("unlit.gltf");
}

static bolan_result load_cube(const char *name) {
    char path[1024];
    bolan_model *model = NULL;
    const bolan_result result = load(test_data(name, path, sizeof path), &model);
    bolan_model_destroy(&model);
    return result;
}
static bolan_result load_obj(void) { return load_cube("models/quads.obj"); }
static bolan_result load_gltf(void) { return load_cube("models/ok.gltf"); }

static void test_memory_that_runs_out_is_called_so(void **state) {
    (void)state;
    assert_memory_failures(load_obj);
    assert_memory_failures(load_gltf);
}

// ---- normals, axes, offset ------------------------------------------------------------------------------------------

// A cube of 10 m about the origin: six flat sides of four vertices, each normal along its own axis, away from the
// middle.
static void test_a_cube_without_normals_has_flat_sides(void **state) {
    (void)state;
    static const char *const names[] = {"models/ok.gltf", "models/quads.obj"};
    for (int n = 0; n < 2; n++) {
        char path[1024];
        bolan_model *model = NULL;
        assert_int_equal(load(test_data(names[n], path, sizeof path), &model), BOLAN_OK);
        const bolan_model_view v = bolan_model_get_view(model);
        assert_int_equal(v.vertex_count, 24);
        assert_int_equal(v.index_count, 36);
        bolan_vec3 sum = {0.0f, 0.0f, 0.0f};
        for (uint32_t i = 0; i < v.vertex_count; i++) {
            assert_near(bolan_v3_dot(v.normals[i], v.positions[i]), 5.0, 1e-5); // a rounded root
            const bolan_vec3 a = v.normals[i];
            assert_near(fmaxf(fabsf(a.x), fmaxf(fabsf(a.y), fabsf(a.z))), 1.0, 1e-6);
            sum = bolan_v3_add(sum, a);
        }
        assert_near(bolan_v3_length(sum), 0.0, 1e-5);
        for (uint32_t i = 0; i < v.index_count; i += 3) { // its order still looks outward
            const bolan_vec3 a = v.positions[v.indices[i]], b = v.positions[v.indices[i + 1]],
                             c = v.positions[v.indices[i + 2]];
            const bolan_vec3 across = bolan_v3_cross(bolan_v3_sub(b, a), bolan_v3_sub(c, a));
            assert_true(bolan_v3_dot(across, v.normals[v.indices[i]]) > 0.0f);
        }
        bolan_model_destroy(&model);
    }
}

// Two long quads that meet in the z axis of the file; the second turns off by @p degrees.
static float normal_at_the_fold(const char *suffix, double degrees) {
    char name[32], text[256];
    bolan_model *model = NULL;
    const double c = cos(degrees * BOLAN_PI / 180.0), s = sin(degrees * BOLAN_PI / 180.0);
    snprintf(name, sizeof name, "fold.%s", suffix);
    snprintf(text, sizeof text,
             "v -1 0 0\nv -1 0 9\nv 0 0 9\nv 0 0 0\nv %.9f %.9f 9\nv %.9f %.9f 0\nf 1 2 3 4\nf 4 3 5 6\n", c, s, c, s);
    write_text(name, text);
    assert_int_equal(load(name, &model), BOLAN_OK);
    const bolan_model_view v = bolan_model_get_view(model);
    float most = 0.0f; // how far the normals in the fold lean out of those of the first quad, which is level
    for (uint32_t i = 0; i < v.vertex_count; i++)
        if (fabsf(v.positions[i].x) < 1e-6f && v.normals[i].z > cosf((float)(0.9 * degrees * BOLAN_PI / 180.0)))
            most = fmaxf(most, fabsf(v.normals[i].x));
    bolan_model_destroy(&model);
    remove(name);
    return most;
}

static void test_edges_of_45_degrees_are_kept_in_an_obj(void **state) {
    (void)state;
    // The mean of two triangles a side that meet with equal angles leans by half the fold.
    assert_near(normal_at_the_fold("obj", 20.0), sin(10.0 * BOLAN_PI / 180.0), 1e-4);
    assert_near(normal_at_the_fold("obj", 44.0), sin(22.0 * BOLAN_PI / 180.0), 1e-4);
    assert_near(normal_at_the_fold("obj", 46.0), 0.0, 1e-6);
    assert_near(normal_at_the_fold("obj", 90.0), 0.0, 1e-6);
}

// The same fold of 20 degrees in a glTF without normals: flat, as 3.7.2.1 of its specification demands.
static void test_a_gltf_without_normals_is_flat_however_gentle_the_fold(void **state) {
    (void)state;
    const float c = (float)cos(BOLAN_PI / 9.0), s = (float)sin(BOLAN_PI / 9.0);
    const float positions[6][3] = {{-1, 0, 0}, {-1, 0, 9}, {0, 0, 9}, {0, 0, 0}, {c, s, 9}, {c, s, 0}};
    const uint16_t indices[12] = {0, 1, 2, 0, 2, 3, 3, 2, 4, 3, 4, 5};
    FILE *file = fopen("fold.bin", "wb");
    assert_non_null(file);
    fwrite(positions, sizeof positions, 1, file);
    fwrite(indices, sizeof indices, 1, file);
    fclose(file);
    write_text("fold.gltf",
               GLTF "\"scene\": 0, \"scenes\": [{\"nodes\": [0]}], \"nodes\": [{\"mesh\": 0}], \"meshes\": "
                    "[{\"primitives\": [{\"attributes\": {\"POSITION\": 0}, \"indices\": 1}]}], \"accessors\": "
                    "[{\"bufferView\": 0, \"componentType\": 5126, \"count\": 6, \"type\": \"VEC3\"}, "
                    "{\"bufferView\": 1, \"componentType\": 5123, \"count\": 12, \"type\": \"SCALAR\"}], "
                    "\"bufferViews\": [{\"buffer\": 0, \"byteLength\": 72}, "
                    "{\"buffer\": 0, \"byteOffset\": 72, \"byteLength\": 24}], "
                    "\"buffers\": [{\"uri\": \"fold.bin\", \"byteLength\": 96}]}");
    bolan_model *model = NULL;
    assert_int_equal(load("fold.gltf", &model), BOLAN_OK);
    const bolan_model_view v = bolan_model_get_view(model);
    assert_int_equal(v.vertex_count, 8);
    uint32_t level = 0;
    for (uint32_t i = 0; i < v.vertex_count; i++) {
        const bool first = v.normals[i].z > 0.99f;
        level += first;
        assert_near(v.normals[i].x, first ? 0.0 : -sin(BOLAN_PI / 9.0), 1e-5);
    }
    assert_int_equal(level, 4);
    bolan_model_destroy(&model);
    remove("fold.gltf");
    remove("fold.bin");
}

static void test_up_and_offset(void **state) {
    (void)state;
    // A triangle in UTM coordinates, z up; exact in floats, which hold halves of a metre there.
    write_text("utm.obj", "v 500000 4649770 12\nv 500010 4649770 12\nv 500000 4649790.5 12\nf 1 2 3\n");
    bolan_model *model = NULL;
    bolan_model_desc d = {.path = "utm.obj", .up = BOLAN_UP_Z, .offset = {500000.0, 4649771.0, 10.0}};
    assert_int_equal(bolan_model_load(&d, &model), BOLAN_OK);
    bolan_model_view v = bolan_model_get_view(model);
    for (uint32_t i = 0; i < v.vertex_count; i++) {
        assert_near(v.positions[i].z, 2.0, 0.0);
        assert_near(v.normals[i].z, 1.0, 1e-6);
        assert_true(v.positions[i].x == 0.0f || v.positions[i].x == 10.0f);
        assert_true(v.positions[i].y == -1.0f || v.positions[i].y == 19.5f);
    }
    bolan_model_destroy(&model);
    d.up = BOLAN_UP_Y; // the offset is in the file's axes: the file's z comes to -y
    assert_int_equal(bolan_model_load(&d, &model), BOLAN_OK);
    v = bolan_model_get_view(model);
    for (uint32_t i = 0; i < v.vertex_count; i++) {
        assert_near(v.positions[i].y, -2.0, 0.0);
        assert_near(v.normals[i].y, -1.0, 1e-6);
        assert_true(v.positions[i].z == -1.0f || v.positions[i].z == 19.5f);
    }
    bolan_model_destroy(&model);
    d.offset.x = 2e8;
    assert_refusal(bolan_model_load(&d, &model), BOLAN_ERROR_ARGUMENT, BOLAN_LOG_OUT_OF_RANGE, "offset (2e+08");
    write_text("utm.obj", "v 0 0 0\nv 1.1e7 0 0\nv 0 1 0\nf 1 2 3\n");
    assert_refusal(load("utm.obj", &model), BOLAN_ERROR_FORMAT, BOLAN_LOG_MODEL_FORMAT,
                   "more than 1e7 m from the origin");
    static const char *const far_away[] = {"0 0 -1.1e7", "0 1.1e7 0", "-1.1e7 0 0"};
    for (int i = 0; i < 3; i++) {
        char text[128];
        snprintf(text, sizeof text, "v 0 0 0\nv %s\nv 1 1 1\nf 1 2 3\n", far_away[i]);
        write_text("utm.obj", text);
        assert_refusal(load("utm.obj", &model), BOLAN_ERROR_FORMAT, BOLAN_LOG_MODEL_FORMAT, "more than 1e7 m from");
    }
    remove("utm.obj");
}

// ---- scenes ---------------------------------------------------------------------------------------------------------

static uint32_t triangles_of(const bolan_world *world) {
    uint32_t sum = 0;
    for (uint32_t i = 0; i < bolan_world_scene(world)->object_count; i++)
        sum += bolan_model_get_view(bolan_world_object_models(world)[i]).index_count / 3;
    return sum;
}

static uint32_t different_models(const bolan_world *world) {
    const bolan_model *const *models = bolan_world_object_models(world);
    uint32_t count = 0;
    for (uint32_t i = 0; i < bolan_world_scene(world)->object_count; i++) {
        uint32_t same = 0;
        while (models[same] != models[i]) same++;
        count += same == i;
    }
    return count;
}

static void test_the_pond_has_the_triangles_of_the_paper(void **state) {
    (void)state;
    bolan_scene scene;
    bolan_world *world = NULL;
    assert_int_equal(bolan_scene_load("pond", &scene), BOLAN_OK);
    assert_int_equal(scene.terrain.kind, BOLAN_GROUND_GENERATED);
    assert_string_equal(scene.terrain.generator.name, "pond");
    assert_true(scene.terrain.shown_by_object);
    assert_string_equal(scene.technique.name, "two-triangle");
    assert_int_equal(bolan_world_load("pond", &world), BOLAN_OK);
    assert_non_null(bolan_world_water(world)->ground);
    assert_int_equal(triangles_of(world), 13912);               // Ma, Zhu & Gong 2006, table 2
    assert_true(different_models(world) < scene.object_count); // each different model once
    bolan_world_destroy(&world);
    assert_null(world);
}

static void test_a_scene_finds_its_models_beside_it(void **state) {
    (void)state;
    bolan_scene scene;
    bolan_world *world = NULL;
    write_text("square.obj", square_obj);
    write_text("objects.yaml", "objects:\n  - {model: square.obj, position: [1, 2, 3], heading: 90, scale: 2}\n"
                               "  - {model: \"builtin:rock\", floats: yes}\n  - {model: square.obj}\n"
                               "  - {model: square.obj, up: z, offset: [1, 2, -3]}\n  - {model: square.obj, up: y}\n"
                               "  - {model: square.obj, up: z}\n  - {model: square.obj, offset: [1, 2, 0]}\n"
                               "  - {model: square.obj, offset: [1, 0, 0]}\n  - {model: square.obj, up: z}\n");
    assert_int_equal(bolan_scene_load("./objects.yaml", &scene), BOLAN_OK);
    assert_int_equal(scene.object_count, 9);
    assert_int_equal(scene.objects[3].up, BOLAN_UP_Z);
    assert_near(scene.objects[3].offset.x, 1.0, 0.0);
    assert_near(scene.objects[3].offset.z, -3.0, 0.0);
    assert_int_equal(scene.objects[0].up, BOLAN_UP_Y);
    assert_near(scene.objects[0].position.z, 3.0, 0.0);
    assert_near(scene.objects[0].heading_deg, 90.0, 0.0);
    assert_near(scene.objects[0].scale, 2.0, 0.0);
    assert_false(scene.objects[0].floats);
    assert_true(scene.objects[1].floats);
    assert_near(scene.objects[1].scale, 1.0, 0.0);
    assert_int_equal(bolan_world_load("./objects.yaml", &world), BOLAN_OK);
    assert_int_equal(different_models(world), 6); // the rock, and the file by its axes and offsets
    const bolan_model *const *models = bolan_world_object_models(world);
    assert_ptr_equal(models[5], models[8]);
    assert_ptr_equal(models[0], models[2]);
    assert_ptr_equal(models[0], models[4]);
    assert_near(bolan_model_get_view(models[3]).positions[0].z, 3.0, 0.0);
    bolan_world_destroy(&world);
}

static void test_a_model_that_is_not_there_is_named_with_its_line(void **state) {
    (void)state;
    bolan_scene scene;
    write_text("missing.yaml", "objects:\n  - {model: \"builtin:rock\"}\n  - {model: gone.obj}\n");
    assert_refusal(bolan_scene_load("./missing.yaml", &scene), BOLAN_ERROR_FORMAT, BOLAN_LOG_SCENE_BAD_VALUE,
                   "missing.yaml:3: the model ./gone.obj cannot be read");
    write_text("missing.yaml", "objects:\n  - {model: \"builtin:rock\", up: z}\n");
    assert_refusal(bolan_scene_load("./missing.yaml", &scene), BOLAN_ERROR_FORMAT, BOLAN_LOG_SCENE_BAD_VALUE,
                   "missing.yaml:2: up and offset are of model files");
    write_text("unknown.yaml", "objects:\n  - {model: \"builtin:castle\"}\n");
    assert_refusal(bolan_scene_load("./unknown.yaml", &scene), BOLAN_ERROR_FORMAT, BOLAN_LOG_SCENE_BAD_VALUE,
                   "unknown.yaml:2: there is no model builtin:castle; expected builtin: and one of pond-ground");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_an_obj_is_read_with_its_material),
        cmocka_unit_test(test_a_gltf_is_read_with_its_nodes),
        cmocka_unit_test(test_what_is_no_model_is_refused),
        cmocka_unit_test(test_a_lying_gltf_does_no_harm),
        cmocka_unit_test(test_what_would_take_too_long_is_refused_at_once),
        cmocka_unit_test(test_materials_are_checked_too),
        cmocka_unit_test(test_nodes_in_nodes),
        cmocka_unit_test(test_a_glb_is_checked),
        cmocka_unit_test(test_required_extensions_are_refused_by_name),
        cmocka_unit_test(test_a_cube_without_normals_has_flat_sides),
        cmocka_unit_test(test_edges_of_45_degrees_are_kept_in_an_obj),
        cmocka_unit_test(test_a_gltf_without_normals_is_flat_however_gentle_the_fold),
        cmocka_unit_test(test_up_and_offset),
        cmocka_unit_test(test_memory_that_runs_out_is_called_so),
        cmocka_unit_test(test_the_pond_has_the_triangles_of_the_paper),
        cmocka_unit_test(test_a_scene_finds_its_models_beside_it),
        cmocka_unit_test(test_a_model_that_is_not_there_is_named_with_its_line),
    };
    return cmocka_run_group_tests(tests, listen_to_log, NULL);
}

// SPDX-License-Identifier: MIT
// Models from files, and objects of scenes.
#include "bolan/io.h"
#include "io_support.h"

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

// ---- scenes ---------------------------------------------------------------------------------------------------------

static uint32_t triangles_of(const bolan_scene *scene, const bolan_scene_assets *assets) {
    uint32_t sum = 0;
    for (uint32_t i = 0; i < scene->object_count; i++)
        sum += bolan_model_get_view(assets->object_models[i]).index_count / 3;
    return sum;
}

static void test_the_pond_has_the_triangles_of_the_paper(void **state) {
    (void)state;
    bolan_scene scene;
    bolan_scene_assets assets;
    assert_int_equal(bolan_scene_load("pond", &scene), BOLAN_OK);
    assert_int_equal(scene.terrain.kind, BOLAN_TERRAIN_POND);
    assert_string_equal(scene.technique.name, "two-triangle");
    assert_int_equal(bolan_scene_assets_load(&scene, &assets), BOLAN_OK);
    assert_non_null(assets.terrain);
    assert_int_equal(triangles_of(&scene, &assets), 13912); // Ma, Zhu & Gong 2006, table 2
    assert_true(assets.model_count < scene.object_count);   // each different model once
    bolan_scene_assets_destroy(&assets);
    assert_null(assets.models[0]);
    assert_null(assets.object_models[0]);
    assert_int_equal(assets.model_count, 0);
}

static void test_a_scene_finds_its_models_beside_it(void **state) {
    (void)state;
    bolan_scene scene;
    bolan_scene_assets assets;
    write_text("square.obj", square_obj);
    write_text("objects.yaml", "objects:\n  - {model: square.obj, position: [1, 2, 3], heading: 90, scale: 2}\n"
                               "  - {model: \"builtin:rock\", floats: yes}\n  - {model: square.obj}\n");
    assert_int_equal(bolan_scene_load("./objects.yaml", &scene), BOLAN_OK);
    assert_int_equal(scene.object_count, 3);
    assert_near(scene.objects[0].position.z, 3.0, 0.0);
    assert_near(scene.objects[0].heading_deg, 90.0, 0.0);
    assert_near(scene.objects[0].scale, 2.0, 0.0);
    assert_false(scene.objects[0].floats);
    assert_true(scene.objects[1].floats);
    assert_near(scene.objects[1].scale, 1.0, 0.0);
    assert_int_equal(bolan_scene_assets_load(&scene, &assets), BOLAN_OK);
    assert_int_equal(assets.model_count, 2);
    assert_ptr_equal(assets.object_models[0], assets.object_models[2]);
    bolan_scene_assets_destroy(&assets);
}

static void test_a_model_that_is_not_there_is_named_with_its_line(void **state) {
    (void)state;
    bolan_scene scene;
    write_text("missing.yaml", "objects:\n  - {model: \"builtin:rock\"}\n  - {model: gone.obj}\n");
    assert_refusal(bolan_scene_load("./missing.yaml", &scene), BOLAN_ERROR_FORMAT, BOLAN_LOG_SCENE_BAD_VALUE,
                   "missing.yaml:3: the model ./gone.obj cannot be read");
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
        cmocka_unit_test(test_the_pond_has_the_triangles_of_the_paper),
        cmocka_unit_test(test_a_scene_finds_its_models_beside_it),
        cmocka_unit_test(test_a_model_that_is_not_there_is_named_with_its_line),
    };
    return cmocka_run_group_tests(tests, listen_to_log, NULL);
}

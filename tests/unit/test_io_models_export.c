// SPDX-License-Identifier: MIT
// Exported meshes, read back by assimp: every vertex is where a query has the water, in the axes that export.h states
// for the format. What assimp does not read (foam and velocity in PLY, glTF) is read from the bytes.
#include "io_support.h"

#include "bolan/export.h"
#include "bolan/io.h"
#include "bolan/query.h"

#include <assimp/cimport.h>
#include <assimp/scene.h>
#include <stdlib.h>
#include <unistd.h>

enum { COLUMNS = 13, ROWS = 7, POINTS = COLUMNS * ROWS };

static bolan_world *open_world(const char *name) {
    bolan_scene scene;
    bolan_world *world = NULL;
    assert_int_equal(bolan_scene_load(name, &scene), BOLAN_OK);
    scene.sea.resolution = 64;
    scene.object_count = 0;
    assert_int_equal(bolan_world_load_scene(&scene, &world), BOLAN_OK);
    return world;
}

static bolan_export_mesh_desc small_rectangle(void) {
    bolan_export_mesh_desc d = bolan_export_mesh_desc_default();
    d.vertices = BOLAN_EXPORT_RECTANGLE;
    d.grid = (bolan_export_grid){{105.0, -31.0}, {129.5, -18.5}, 2.0}; // the last column and row end within
    d.origin = bolan_dv3(100.0, -50.0, 1.0);
    return d;
}

static bolan_dvec2 rest[POINTS];
static bolan_parcel parcels[POINTS];

static void ask(const bolan_world *world) {
    for (uint32_t i = 0; i < POINTS; i++)
        rest[i] = (bolan_dvec2){105.0 + 2.0 * (i % COLUMNS), -31.0 + 2.0 * (i / COLUMNS)};
    bolan_query_parcels(bolan_world_water(world), rest, NULL, POINTS, parcels);
}

// Position of vertex i from the origin of small_rectangle(), in world axes.
static bolan_vec3 place_of(const bolan_world *world, uint32_t i) {
    return (bolan_vec3){(float)(rest[i].x + (double)parcels[i].displacement.x - 100.0),
                        (float)(rest[i].y + (double)parcels[i].displacement.y + 50.0),
                        (float)(bolan_world_water(world)->level + (double)parcels[i].displacement.z - 1.0)};
}

// From the axes of a file, where `up` tells whether they are y up, to the world's: written here anew.
static bolan_vec3 to_world(const struct aiVector3D *v, bool y_up) {
    return y_up ? (bolan_vec3){v->x, -v->z, v->y} : (bolan_vec3){v->x, v->y, v->z};
}

static void assert_close(bolan_vec3 a, bolan_vec3 b, float error) {
    assert_float_equal(a.x, b.x, error);
    assert_float_equal(a.y, b.y, error);
    assert_float_equal(a.z, b.z, error);
}

// PLY and OBJ: assimp keeps the order of the vertices or not, so that each is found by its place.
static void check_mesh(const char *path, bool y_up, const bolan_world *world) {
    const struct aiScene *scene = aiImportFile(path, 0);
    assert_non_null(scene);
    assert_int_equal(scene->mNumMeshes, 1);
    const struct aiMesh *m = scene->mMeshes[0];
    assert_int_equal(m->mNumFaces, 2 * (COLUMNS - 1) * (ROWS - 1));
    bool found[POINTS] = {false};
    for (unsigned k = 0; k < m->mNumVertices; k++) {
        const bolan_vec3 at = to_world(&m->mVertices[k], y_up), normal = to_world(&m->mNormals[k], y_up);
        uint32_t i = 0;
        while (i < POINTS && bolan_v3_length(bolan_v3_sub(at, place_of(world, i))) > 2e-5f) i++;
        assert_true(i < POINTS);
        assert_close(normal, parcels[i].normal, 1e-6f);
        found[i] = true;
    }
    for (uint32_t i = 0; i < POINTS; i++) assert_true(found[i]);
    for (unsigned k = 0; k < m->mNumFaces; k++) { // seen from above they turn counter-clockwise
        const unsigned *t = m->mFaces[k].mIndices;
        const bolan_vec3 a = to_world(&m->mVertices[t[0]], y_up), b = to_world(&m->mVertices[t[1]], y_up),
                         c = to_world(&m->mVertices[t[2]], y_up);
        assert_true(bolan_v3_cross(bolan_v3_sub(b, a), bolan_v3_sub(c, a)).z > 0.0f);
    }
    aiReleaseImport(scene);
}

static void assimp_reads_what_a_query_says(void **state) {
    (void)state;
    const bolan_export_mesh_desc d = small_rectangle();
    bolan_world *world = open_world("open-sea");
    ask(world);
    static const char *const paths[] = {"export.ply", "export.obj", "export.glb"};
    for (int i = 0; i < 3; i++) {
        assert_int_equal(bolan_export_mesh(world, &d, paths[i]), BOLAN_OK);
        check_mesh(paths[i], i > 0, world);
        remove(paths[i]);
    }
    bolan_world_destroy(&world);
}

static void obj_has_the_foam_as_colours(void **state) {
    (void)state;
    const bolan_export_mesh_desc d = small_rectangle();
    static bolan_sea_sample samples[POINTS];
    bolan_world *world = open_world("storm");
    bolan_world_settle(world, 20.0);
    ask(world);
    bolan_sea_sample_rest(bolan_world_water(world)->sea, rest, POINTS, samples);
    assert_int_equal(bolan_export_mesh(world, &d, "foam.obj"), BOLAN_OK);
    const struct aiScene *scene = aiImportFile("foam.obj", 0);
    assert_non_null(scene);
    float most = 0.0f;
    for (unsigned k = 0; k < scene->mMeshes[0]->mNumVertices; k++) {
        const bolan_vec3 at = to_world(&scene->mMeshes[0]->mVertices[k], true);
        for (uint32_t i = 0; i < POINTS; i++)
            if (bolan_v3_length(bolan_v3_sub(at, place_of(world, i))) <= 1e-4f)
                assert_float_equal(scene->mMeshes[0]->mColors[0][k].r, samples[i].foam, 1e-5f);
        most = fmaxf(most, scene->mMeshes[0]->mColors[0][k].r);
    }
    assert_true(most > 0.01f); // there is foam to compare
    aiReleaseImport(scene);
    remove("foam.obj");
    bolan_world_destroy(&world);
}

static uint8_t *read_file(const char *path, size_t *size) {
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    fseek(file, 0, SEEK_END);
    *size = (size_t)ftell(file);
    rewind(file);
    uint8_t *data = malloc(*size + 1);
    assert_int_equal(fread(data, 1, *size, file), *size);
    data[*size] = 0;
    fclose(file);
    return data;
}

static void velocities_are_those_of_the_water(void **state) {
    (void)state;
    const bolan_export_mesh_desc d = small_rectangle();
    bolan_world *world = open_world("open-sea");
    bolan_water water = *bolan_world_water(world);
    bolan_flow *flow = NULL;
    assert_int_equal(bolan_flow_create(water.sea, &flow), BOLAN_OK);
    water.flow = flow;
    ask(world);
    assert_int_equal(bolan_export_mesh(world, &d, "v.ply"), BOLAN_OK);
    assert_int_equal(bolan_export_mesh(world, &d, "v.glb"), BOLAN_OK);
    size_t size, glb_size;
    uint8_t *ply = read_file("v.ply", &size), *glb = read_file("v.glb", &glb_size);
    const uint8_t *data = (const uint8_t *)strstr((const char *)ply, "end_header\n") + strlen("end_header\n");
    uint32_t json;
    memcpy(&json, glb + 12, 4);
    for (uint32_t i = 0; i < POINTS; i++) {
        const bolan_dvec2 at = {rest[i].x + (double)parcels[i].displacement.x,
                                rest[i].y + (double)parcels[i].displacement.y};
        bolan_surface_motion m;
        float p[10], g[10];
        bolan_query_motion(&water, NULL, &at, 1, &m);
        memcpy(p, data + 40 * i, sizeof p);
        memcpy(g, glb + 20 + json + 8 + 40 * i, sizeof g);
        assert_close((bolan_vec3){p[7], p[8], p[9]}, m.velocity, 1e-5f);
        assert_close((bolan_vec3){g[7], -g[9], g[8]}, m.velocity, 1e-5f);
        assert_true(g[6] == p[6]); // the foam
    }
    free(ply), free(glb);
    remove("v.ply"), remove("v.glb");
    bolan_flow_destroy(&flow);
    bolan_world_destroy(&world);
}

static void animations_move_as_the_sea_does(void **state) {
    (void)state;
    enum { FRAMES = 3 };
    bolan_export_mesh_desc d = small_rectangle();
    d.frames = (bolan_export_frames){.count = FRAMES, .fps = 4.0};
    bolan_world *world = open_world("open-sea");
    const double start = bolan_world_scene(world)->time;
    assert_int_equal(bolan_export_mesh(world, &d, "a.glb"), BOLAN_OK);
    assert_true(bolan_sea_time(bolan_world_water(world)->sea) == start + 0.5);
    const struct aiScene *scene = aiImportFile("a.glb", 0);
    assert_non_null(scene);
    const struct aiMesh *m = scene->mMeshes[0];
    assert_int_equal(m->mNumAnimMeshes, FRAMES - 1);
    assert_int_equal(m->mNumVertices, POINTS);
    for (unsigned f = 1; f < FRAMES; f++) {
        bolan_world_step(world, start + f / 4.0);
        ask(world);
        for (uint32_t i = 0; i < POINTS; i++)
            assert_close(to_world(&m->mAnimMeshes[f - 1]->mVertices[i], true), place_of(world, i), 4e-5f);
    }
    assert_int_equal(scene->mNumAnimations, 1);
    assert_int_equal(scene->mAnimations[0]->mNumMorphMeshChannels, 1);
    const struct aiMeshMorphAnim *morph = scene->mAnimations[0]->mMorphMeshChannels[0];
    assert_int_equal(morph->mNumKeys, FRAMES);
    for (unsigned f = 0; f < FRAMES; f++)
        for (unsigned t = 0; t < morph->mKeys[f].mNumValuesAndWeights; t++)
            assert_true(morph->mKeys[f].mWeights[t] == (f == t + 1 ? 1.0 : 0.0));
    aiReleaseImport(scene);
    remove("a.glb");
    bolan_world_destroy(&world);
}

// The next number behind a word of a text, which moves on behind it.
static double number_behind(const char **text, const char *word) {
    const char *at = strstr(*text, word);
    assert_non_null(at);
    char *end = NULL;
    const double value = strtod(at + strlen(word), &end);
    *text = end;
    return value;
}

// glTF wants the exact bounds of each POSITION, and programs cull by them.
static void bounds_are_those_of_the_positions(void **state) {
    (void)state;
    enum { FRAMES = 3 };
    bolan_export_mesh_desc d = small_rectangle();
    d.frames = (bolan_export_frames){.count = FRAMES, .fps = 4.0};
    bolan_world *world = open_world("open-sea");
    assert_int_equal(bolan_export_mesh(world, &d, "b.glb"), BOLAN_OK);
    size_t size;
    uint8_t *glb = read_file("b.glb", &size);
    uint32_t json;
    memcpy(&json, glb + 12, 4);
    const char *text = strstr((const char *)glb + 20, "\"accessors\"");
    const size_t triangles = 2 * (COLUMNS - 1) * (ROWS - 1);
    for (int f = 0; f < FRAMES; f++) {
        const size_t stride = f ? 24 : 40, first = f ? POINTS * 40 + 12 * triangles + (size_t)(f - 1) * POINTS * 24 : 0;
        double stated[6];
        for (int k = 0; k < 6; k++) stated[k] = number_behind(&text, k == 0 ? "\"min\":[" : k == 3 ? "\"max\":[" : ",");
        for (int k = 0; k < 3; k++) {
            float least = 1e30f, most = -1e30f, value;
            for (size_t i = 0; i < POINTS; i++) {
                memcpy(&value, glb + 20 + json + 8 + first + i * stride + 4 * (size_t)k, 4);
                least = fminf(least, value), most = fmaxf(most, value);
            }
            assert_true((float)stated[k] == least && (float)stated[3 + k] == most);
        }
    }
    free(glb);
    remove("b.glb");
    bolan_world_destroy(&world);
}

static void the_ground_is_a_mesh_of_its_own(void **state) {
    (void)state;
    bolan_export_mesh_desc d = small_rectangle();
    d.origin = (bolan_dvec3){0.0, 0.0, 0.0};
    d.ground = true;
    bolan_world *world = open_world("island");
    assert_int_equal(bolan_export_mesh(world, &d, "g.glb"), BOLAN_OK);
    const struct aiScene *scene = aiImportFile("g.glb", 0);
    assert_non_null(scene);
    assert_int_equal(scene->mNumMeshes, 2);
    const struct aiMesh *m = scene->mMeshes[1];
    float steepest = 0.0f;
    ask(world);
    for (uint32_t i = 0; i < POINTS; i++) {
        const float z = bolan_ground_elevation(bolan_world_water(world)->ground, rest[i].x, rest[i].y, 2.0);
        assert_close(to_world(&m->mVertices[i], true), (bolan_vec3){(float)rest[i].x, (float)rest[i].y, z}, 1e-5f);
        const bolan_ground *ground = bolan_world_water(world)->ground;
        const float east = bolan_ground_elevation(ground, rest[i].x + 1.0, rest[i].y, 2.0) -
                           bolan_ground_elevation(ground, rest[i].x - 1.0, rest[i].y, 2.0);
        const float north = bolan_ground_elevation(ground, rest[i].x, rest[i].y + 1.0, 2.0) -
                            bolan_ground_elevation(ground, rest[i].x, rest[i].y - 1.0, 2.0);
        const bolan_vec3 normal = to_world(&m->mNormals[i], true), across = {2.0f, 0.0f, east},
                         along = {0.0f, 2.0f, north};
        assert_float_equal(bolan_v3_dot(normal, across), 0.0f, 1e-5f);
        assert_float_equal(bolan_v3_dot(normal, along), 0.0f, 1e-5f);
        assert_true(normal.z > 0.0f);
        steepest = fmaxf(steepest, fmaxf(fabsf(east), fabsf(north)));
    }
    assert_true(steepest > 0.01f);
    aiReleaseImport(scene);
    remove("g.glb");
    bolan_world_destroy(&world);
}

static void the_view_is_what_the_camera_sees(void **state) {
    (void)state;
    bolan_export_mesh_desc d = bolan_export_mesh_desc_default();
    d.most_vertices = 5000;
    bolan_world *world = open_world("open-sea");
    assert_int_equal(bolan_export_mesh(world, &d, "view.ply"), BOLAN_OK);
    const struct aiScene *scene = aiImportFile("view.ply", 0);
    assert_non_null(scene);
    const struct aiMesh *m = scene->mMeshes[0];
    const bolan_camera *c = &bolan_world_scene(world)->camera;
    uint32_t near = 0, far = 0;
    for (unsigned k = 0; k < m->mNumVertices; k++) {
        const double x = (double)m->mVertices[k].x - c->position.x, y = (double)m->mVertices[k].y - c->position.y;
        const double away = hypot(x, y),
                     along = x * sin(bolan_radians(c->heading_deg)) + y * cos(bolan_radians(c->heading_deg));
        near += away < 50.0;
        far += away > 1000.0;
        if (away > 200.0) assert_true(along > 0.4 * away);
    }
    assert_true(near > 100 && far > 100 && m->mNumVertices <= 5000);
    aiReleaseImport(scene);
    remove("view.ply");
    bolan_world_destroy(&world);
}

static void what_cannot_be_exported_is_refused(void **state) {
    (void)state;
    bolan_world *world = open_world("open-sea");
    bolan_export_mesh_desc d = small_rectangle();
    assert_refusal(bolan_export_mesh(world, &d, "x.stl"), BOLAN_ERROR_ARGUMENT, BOLAN_LOG_BAD_ARGUMENT,
                   ".ply, .obj or .glb");
    d.frames.count = 2;
    assert_refusal(bolan_export_mesh(world, &d, "x.ply"), BOLAN_ERROR_ARGUMENT, BOLAN_LOG_BAD_ARGUMENT,
                   "several frames");
    d = small_rectangle();
    d.ground = true;
    assert_refusal(bolan_export_mesh(world, &d, "x.ply"), BOLAN_ERROR_ARGUMENT, BOLAN_LOG_OUT_OF_RANGE, "no ground");
    d = small_rectangle();
    d.grid.spacing = 0.0;
    assert_refusal(bolan_export_mesh(world, &d, "x.ply"), BOLAN_ERROR_ARGUMENT, BOLAN_LOG_OUT_OF_RANGE, "spacing");
    d.grid = (bolan_export_grid){{0.0, 0.0}, {16000.0, 16000.0}, 1.0};
    d.frames.count = 1;
    assert_refusal(bolan_export_mesh(world, &d, "x.glb"), BOLAN_ERROR_FORMAT, BOLAN_LOG_EXPORT_TOO_LARGE, "4.2 GB");
    assert_int_not_equal(access("x.glb", F_OK), 0);
    bolan_world_destroy(&world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(assimp_reads_what_a_query_says),    cmocka_unit_test(obj_has_the_foam_as_colours),
        cmocka_unit_test(velocities_are_those_of_the_water), cmocka_unit_test(animations_move_as_the_sea_does),
        cmocka_unit_test(bounds_are_those_of_the_positions), cmocka_unit_test(the_ground_is_a_mesh_of_its_own),
        cmocka_unit_test(the_view_is_what_the_camera_sees),  cmocka_unit_test(what_cannot_be_exported_is_refused),
    };
    return cmocka_run_group_tests(tests, listen_to_log, NULL);
}

// SPDX-License-Identifier: MIT
// Models: what is taken and what is refused, and the built-in ones; and the pond's ground.
#include "bolan/scene.h"
#include "content_support.h"
#include "io_support.h"

static void test_a_model_is_a_copy(void **state) {
    (void)state;
    bolan_vec3 p[3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 2}}, n[3] = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
    bolan_vec4 c[3] = {{0.1f, 0.2f, 0.3f, 1}, {0.1f, 0.2f, 0.3f, 1}, {0.1f, 0.2f, 0.3f, 0.5f}};
    uint32_t i[3] = {0, 1, 2};
    const bolan_model_view view = {3, 3, p, n, c, i};
    bolan_model *model = NULL;
    const size_t before = bolan_memory_in_use();
    assert_int_equal(bolan_model_create(&view, &model), BOLAN_OK);
    p[1].x = 7.0f;
    i[0] = 2;
    const bolan_model_view got = bolan_model_get_view(model);
    assert_int_equal(got.vertex_count, 3);
    assert_int_equal(got.index_count, 3);
    assert_near(got.positions[1].x, 1.0, 0.0);
    assert_int_equal(got.indices[0], 0);
    assert_near(got.colors[2].w, 0.5, 0.0);
    bolan_vec3 low, high;
    bolan_model_bounds(model, &low, &high);
    assert_near(high.z, 2.0, 0.0);
    assert_near(low.x, 0.0, 0.0);
    bolan_model_destroy(&model);
    assert_null(model);
    bolan_model_destroy(&model);
    bolan_model_destroy(NULL);
    assert_int_equal(bolan_memory_in_use(), before);
}

static void test_what_is_no_mesh_is_refused(void **state) {
    (void)state;
    bolan_vec3 p[3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, n[3] = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
    bolan_vec4 c[3] = {{0}};
    uint32_t i[4] = {0, 1, 2, 0};
    bolan_model_view v = {3, 3, p, n, c, i};
    bolan_model *model = NULL;
    i[2] = 3;
    assert_refusal(bolan_model_create(&v, &model), BOLAN_ERROR_ARGUMENT, BOLAN_LOG_BAD_ARGUMENT,
                   "beyond the last vertex");
    i[2] = 2;
    v.index_count = 4;
    assert_refusal(bolan_model_create(&v, &model), BOLAN_ERROR_ARGUMENT, BOLAN_LOG_BAD_ARGUMENT, "whole triangles");
    v.index_count = 3;
    v.vertex_count = 2;
    assert_refusal(bolan_model_create(&v, &model), BOLAN_ERROR_ARGUMENT, BOLAN_LOG_BAD_ARGUMENT, "vertices");
    v.vertex_count = 3;
    v.normals = NULL;
    assert_refusal(bolan_model_create(&v, &model), BOLAN_ERROR_ARGUMENT, BOLAN_LOG_BAD_ARGUMENT, "missing");
    v.normals = n;
    p[1].y = NAN;
    assert_refusal(bolan_model_create(&v, &model), BOLAN_ERROR_ARGUMENT, BOLAN_LOG_BAD_ARGUMENT, "not finite");
    assert_null(model);
    assert_refusal(bolan_content_create_model("castle", &model), BOLAN_ERROR_ARGUMENT, BOLAN_LOG_UNKNOWN_NAME,
                   "castle; expected one of pond-ground, pond-wood, house");
    assert_null(model);
}

// FNV-1a over the 32-bit words of an array (Fowler, Noll & Vo).
static uint64_t hash_of(uint64_t h, const void *array, size_t bytes) {
    for (size_t n = 0; n < bytes; n += 4) {
        uint32_t word;
        memcpy(&word, (const char *)array + n, sizeof word);
        h = (h ^ word) * 0x100000001b3u;
    }
    return h;
}

// "The same on every machine" (scene.h): the bits of every array, as GCC and Clang make them at every optimisation. A
// change of a model on purpose changes its line.
static void test_builtin_models_have_the_same_bits_everywhere(void **state) {
    (void)state;
    static const struct {
        const char *name;
        uint64_t hash;
    } known[] = {
        {"pond-ground", UINT64_C(0x570343593daca836)}, {"pond-wood", UINT64_C(0x47f61696f8f73366)},
        {"house", UINT64_C(0x2a39228a194d99be)},       {"boat", UINT64_C(0x71f8a82d3c7e71e1)},
        {"stick", UINT64_C(0x607e8184350c2c37)},       {"tree", UINT64_C(0x8f9dbe784a328a2d)},
        {"conifer", UINT64_C(0xe6280fbca72ae477)},     {"reeds", UINT64_C(0x4d93190990c8036b)},
        {"jetty", UINT64_C(0xea8a3577fa5b1199)},       {"rock", UINT64_C(0xc541b2bd84fd1c99)},
        {"coral", UINT64_C(0xf133107176086dfe)},       {"staghorn", UINT64_C(0xbebe8d3377f202b8)},
    };
    uint32_t wrong = 0;
    for (uint32_t n = 0; n < sizeof known / sizeof *known || bolan_content_model_name(n); n++) {
        assert_true(n < sizeof known / sizeof *known);
        assert_string_equal(bolan_content_model_name(n), known[n].name);
        bolan_model *model = NULL;
        assert_int_equal(bolan_content_create_model(known[n].name, &model), BOLAN_OK);
        const bolan_model_view v = bolan_model_get_view(model);
        uint64_t h = hash_of(UINT64_C(0xcbf29ce484222325), v.positions, v.vertex_count * sizeof *v.positions);
        h = hash_of(h, v.normals, v.vertex_count * sizeof *v.normals);
        h = hash_of(h, v.colors, v.vertex_count * sizeof *v.colors);
        h = hash_of(h, v.indices, v.index_count * sizeof *v.indices);
        if (h != known[n].hash) {
            print_error("%s: 0x%016llx\n", known[n].name, (unsigned long long)h);
            wrong++;
        }
        bolan_model_destroy(&model);
    }
    assert_int_equal(wrong, 0);
}

static void check_builtin(const char *name) {
    bolan_model *model = NULL, *again = NULL;
    assert_int_equal(bolan_content_create_model(name, &model), BOLAN_OK);
    assert_int_equal(bolan_content_create_model(name, &again), BOLAN_OK);
    assert_true(bolan_model_id(model) == bolan_model_id(again));
    const bolan_model_view v = bolan_model_get_view(model);
    for (uint32_t i = 0; i < v.vertex_count; i++) {
        // Roots and divisions in single precision: a few ulp.
        assert_near(bolan_v3_length(v.normals[i]), 1.0, 1e-5);
        const bolan_vec4 c = v.colors[i];
        // Nothing out of doors is darker or lighter: soot has 0.01, fresh snow 0.85.
        assert_true(fminf(c.x, fminf(c.y, c.z)) > 0.004f && fmaxf(c.x, fmaxf(c.y, c.z)) < 0.85f);
        assert_true(c.w >= 0.0f && c.w <= 1.0f);
    }
    uint32_t thin = 0;
    for (uint32_t i = 0; i < v.index_count; i += 3) {
        const bolan_vec3 a = v.positions[v.indices[i]], b = v.positions[v.indices[i + 1]],
                         c = v.positions[v.indices[i + 2]];
        thin += bolan_v3_length(bolan_v3_cross(bolan_v3_sub(b, a), bolan_v3_sub(c, a))) < 1e-7f;
    }
    // At the keel and the stem of the boat, where the hull closes; nowhere else.
    assert_true(thin <= (strcmp(name, "boat") == 0 ? v.index_count / 30 : 0));
    bolan_model_destroy(&model);
    bolan_model_destroy(&again);
}

static void test_built_in_models_are_sound(void **state) {
    (void)state;
    const size_t before = bolan_memory_in_use();
    uint32_t count = 0;
    for (; bolan_content_model_name(count); count++) check_builtin(bolan_content_model_name(count));
    assert_true(count >= 9);
    assert_int_equal(bolan_memory_in_use(), before);
}

// Flat faces look outward: the house's walls away from its middle.
static void test_the_house_faces_out(void **state) {
    (void)state;
    bolan_model *model = NULL;
    assert_int_equal(bolan_content_create_model("house", &model), BOLAN_OK);
    const bolan_model_view v = bolan_model_get_view(model);
    for (uint32_t i = 0; i < v.index_count; i += 3) {
        const bolan_vec3 a = v.positions[v.indices[i]], b = v.positions[v.indices[i + 1]],
                         c = v.positions[v.indices[i + 2]];
        const bolan_vec3 n = bolan_v3_cross(bolan_v3_sub(b, a), bolan_v3_sub(c, a));
        assert_true(bolan_v3_dot(n, v.normals[v.indices[i]]) > 0.0f);
        // Walls and what hangs on them: 5 m from the middle to the ends, 3.5 m to the front and the back.
        if (a.z > 2.9f || b.z > 2.9f || c.z > 2.9f) continue;
        if (fabsf(n.x) > fabsf(n.y) && fabsf(a.x) > 4.9f) assert_true(n.x * a.x > 0.0f);
        if (fabsf(n.y) > fabsf(n.x) && fabsf(a.y) > 3.4f && fabsf(a.x) > 1.0f)
            assert_true(n.y * a.y > 0.0f); // the step has a back
    }
    bolan_model_destroy(&model);
}

static void test_the_pole_is_as_long_and_thick_as_it_says(void **state) {
    (void)state;
    bolan_model *model = NULL;
    assert_int_equal(bolan_content_create_model("stick", &model), BOLAN_OK);
    bolan_vec3 low, high;
    bolan_model_bounds(model, &low, &high);
    const bolan_model_view v = bolan_model_get_view(model);
    float longest = 0.0f;
    for (uint32_t i = 0; i < v.vertex_count; i++) longest = fmaxf(longest, bolan_v3_length(v.positions[i]));
    assert_near(longest, 3.5, 0.01); // the rim of its end is a little further than its axis
    bolan_model_destroy(&model);
}

// ---- the pond -------------------------------------------------------------------------------------------------------

static void test_the_pond_is_ninety_metres_across(void **state) {
    (void)state;
    double west = 0.0, east = 0.0, deepest = 0.0;
    while (bolan_pond_elevation(west, 0.0) < 0.0f) west -= 0.1;
    while (bolan_pond_elevation(east, 0.0) < 0.0f) east += 0.1;
    assert_near(east - west, 90.0, 5.0); // "about"
    for (double y = -30.0; y < 30.0; y += 0.5)
        for (double x = -44.0; x < 44.0; x += 0.5) deepest = fmin(deepest, (double)bolan_pond_elevation(x, y));
    assert_near(deepest, -4.0, 0.35);
    // The sandy shelf is shallow enough to stand on, and slopes gently.
    for (double y = -24.0; y < -16.0; y += 0.5) {
        const double z = (double)bolan_pond_elevation(0.0, y);
        assert_true(z < -0.2 && z > -1.9);
    }
}

static void test_no_water_is_seen_behind_the_meadow(void **state) {
    (void)state;
    // An eye 2.4 m over the water sees the plane of the water nowhere beyond the pond: on each ray the ground rises
    // above that height.
    for (int i = 0; i < 360; i++) {
        double s, c;
        float highest = 0.0f;
        bolan_sincos(bolan_radians(i), &s, &c);
        for (double r = 60.0; r < 300.0; r += 5.0) highest = fmaxf(highest, bolan_pond_elevation(c * r, s * r));
        assert_true(highest > 3.0f);
    }
}

static void test_the_terrain_is_that_ground(void **state) {
    (void)state;
    bolan_ground *terrain = NULL;
    const bolan_ground_generator generator = generator_named("pond");
    assert_int_equal(bolan_content_create_ground(&generator, &terrain), BOLAN_OK);
    for (int y = -150; y <= 150; y += 7)
        for (int x = -150; x <= 150; x += 7)
            assert_near(bolan_ground_elevation(terrain, x, y, 0.0), bolan_pond_elevation(x, y), 1e-4); // at its nodes
    bolan_ground_destroy(&terrain);
}

static void test_the_model_of_the_ground_lies_on_it(void **state) {
    (void)state;
    bolan_model *model = NULL;
    assert_int_equal(bolan_content_create_model("pond-ground", &model), BOLAN_OK);
    const bolan_model_view v = bolan_model_get_view(model);
    for (uint32_t i = 0; i < v.vertex_count; i++) {
        const bolan_vec3 p = v.positions[i];
        assert_near(p.z, bolan_pond_elevation((double)p.x, (double)p.y), 1e-4);
    }
    for (uint32_t i = 0; i < v.index_count; i += 3) { // counter-clockwise from above
        const bolan_vec3 a = v.positions[v.indices[i]], b = v.positions[v.indices[i + 1]],
                         c = v.positions[v.indices[i + 2]];
        assert_true((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) > 0.0f);
    }
    bolan_model_destroy(&model);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_builtin_models_have_the_same_bits_everywhere),
        cmocka_unit_test(test_a_model_is_a_copy),
        cmocka_unit_test(test_what_is_no_mesh_is_refused),
        cmocka_unit_test(test_built_in_models_are_sound),
        cmocka_unit_test(test_the_house_faces_out),
        cmocka_unit_test(test_the_pole_is_as_long_and_thick_as_it_says),
        cmocka_unit_test(test_the_pond_is_ninety_metres_across),
        cmocka_unit_test(test_no_water_is_seen_behind_the_meadow),
        cmocka_unit_test(test_the_terrain_is_that_ground),
        cmocka_unit_test(test_the_model_of_the_ground_lies_on_it),
    };
    return cmocka_run_group_tests(tests, listen_to_log, NULL);
}

// SPDX-License-Identifier: MIT
// Chunks of ground: cast shadows against geometry, normals, meshes. Needs no context.
#include "content_support.h"
#include "support.h"

#include "bolan/math.h"
#include "math/half.h"
#include "render/ground_chunk.h"

// A plain at 10 m with a wall of 100 m along x = 0, sampled finely.
static bolan_ground *wall(void) {
    enum { N = 513 };
    static float z[N * N];
    for (int n = 0; n < N * N; n++) {
        double x = -1280.0 + n % N * 5.0;
        z[n] = fabs(x) < 8.0 ? 110.0f : 10.0f;
    }
    bolan_ground_desc d = bolan_ground_desc_default();
    d.field = (bolan_heightfield){N, N, -1280.0, -1280.0, 5.0, 5.0, z};
    d.detail = 0.0;
    bolan_ground *t = NULL;
    assert_int_equal(bolan_ground_create(&d, &t), BOLAN_OK);
    return t;
}

static ground_chunk chunk(const bolan_ground *t, double west, double south, double size, const ground_chunk *parent) {
    ground_chunk c = {.west = west, .south = south, .size = size, .parent = parent};
    assert_int_equal(bolan_chunk_allocate(&c), BOLAN_OK);
    bolan_chunk_build(&c, t);
    return c;
}

static float channel(const ground_chunk *c, double x, double y, int k) {
    int i = (int)lround((x - c->west) / c->size * CHUNK_TEXELS),
        j = (int)lround((y - c->south) / c->size * CHUNK_TEXELS);
    return float_from_half(c->map[4 * (j * CHUNK_MAP + i) + k]);
}

static void a_wall_throws_a_shadow_of_its_height_over_the_tangent(void **state) {
    (void)state;
    bolan_ground *t = wall();
    ground_chunk c = chunk(t, -640.0, -640.0, 1280.0, NULL);
    const double elevations[] = {15.0, 30.0, 50.0};
    for (int n = 0; n < 3; n++) {
        double e = bolan_radians(elevations[n]), reach = 100.0 / tan(e);
        chunk_sun sun =
            bolan_chunk_sun_from(bolan_v3((float)cos(e), 0.0f, (float)sin(e))); // from the east: shadow to the west
        bolan_chunk_light(&c, &sun);
        // 10 m texels, and a wall whose flank is a cell wide
        assert_true(channel(&c, -fmax(reach - 25.0, 20.0), 0.0, 2) > 0.0f);
        assert_true(channel(&c, -(reach + 25.0), 0.0, 2) <= 0.0f);
        assert_true(channel(&c, 60.0, 0.0, 2) <= 0.0f);
        // the clearance itself: 100 m less what the ray falls on the way
        assert_near(channel(&c, -0.5 * reach - 8.0, 0.0, 2), 50.0, 12.0);
    }
    bolan_chunk_free(&c);
    bolan_ground_destroy(&t);
}

static void a_slanting_sun_shortens_it_by_the_cosine(void **state) {
    (void)state;
    bolan_ground *t = wall();
    ground_chunk c = chunk(t, -640.0, -640.0, 1280.0, NULL);
    double e = bolan_radians(25.0), azimuth = bolan_radians(60.0), reach = 100.0 / tan(e) * sin(azimuth);
    chunk_sun sun =
        bolan_chunk_sun_from(bolan_v3((float)(sin(azimuth) * cos(e)), (float)(cos(azimuth) * cos(e)), (float)sin(e)));
    bolan_chunk_light(&c, &sun);
    assert_true(channel(&c, -(reach - 30.0), -100.0, 2) > 0.0f);
    assert_true(channel(&c, -(reach + 30.0), -100.0, 2) <= 0.0f);
    bolan_chunk_free(&c);
    bolan_ground_destroy(&t);
}

static void shadows_reach_into_a_child_from_outside_it(void **state) {
    (void)state;
    bolan_ground *t = wall();
    ground_chunk root = chunk(t, -640.0, -640.0, 1280.0, NULL);
    ground_chunk child = chunk(t, -640.0, -640.0, 640.0, &root);
    ground_chunk leaf = chunk(t, -320.0, -320.0, 320.0, &child);     // ends at the wall's foot
    ground_chunk far_leaf = chunk(t, -320.0, -640.0, 160.0, &child); // does not touch it
    double e = bolan_radians(20.0), reach = 100.0 / tan(e);          // 275 m
    chunk_sun sun = bolan_chunk_sun_from(bolan_v3((float)cos(e), 0.0f, (float)sin(e)));
    bolan_chunk_light(&root, &sun), bolan_chunk_light(&child, &sun), bolan_chunk_light(&leaf, &sun),
        bolan_chunk_light(&far_leaf, &sun);
    assert_true(channel(&leaf, -(reach - 20.0), -100.0, 2) > 0.0f);
    assert_true(channel(&leaf, -(reach + 20.0), -100.0, 2) <= 0.0f);
    assert_true(channel(&far_leaf, -(reach - 20.0), -560.0, 2) > 0.0f);
    assert_true(channel(&far_leaf, -(reach + 20.0), -560.0, 2) <= 0.0f);
    bolan_chunk_free(&root), bolan_chunk_free(&child), bolan_chunk_free(&leaf), bolan_chunk_free(&far_leaf);
    bolan_ground_destroy(&t);
}

static void sky_is_open_on_a_slope_and_hidden_in_a_valley(void **state) {
    (void)state;
    enum { N = 257 };
    static float z[N * N];
    for (int n = 0; n < N * N; n++) {
        z[n] = 0.5f * fabsf((float)(n % N) * 5.0f - 640.0f); // flanks of 1 in 2
    }
    bolan_ground_desc d = bolan_ground_desc_default();
    d.field = (bolan_heightfield){N, N, -640.0, -640.0, 5.0, 5.0, z};
    d.detail = 0.0;
    bolan_ground *t = NULL;
    assert_int_equal(bolan_ground_create(&d, &t), BOLAN_OK);
    ground_chunk c = chunk(t, -500.0, -500.0, 1000.0, NULL);
    chunk_sun sun = bolan_chunk_sun_from(bolan_v3(0.0f, 0.0f, 1.0f));
    bolan_chunk_light(&c, &sun);
    assert_near(channel(&c, 300.0, 0.0, 3), 1.0, 2e-3); // a plane hides nothing from itself; half-float rounding
    // Flanks of 26.6 degrees on both sides hide sin^2 of that, a fifth of a cosine-weighted sky, as seen from the
    // bottom.
    assert_true(channel(&c, 0.0, 0.0, 3) < 0.8f && channel(&c, 0.0, 0.0, 3) > 0.4f);
    bolan_chunk_free(&c);
    bolan_ground_destroy(&t);
}

static void neighbours_share_their_rim_whatever_their_level(void **state) {
    (void)state;
    bolan_ground_generator d = generator_named("island");
    bolan_ground *t = NULL;
    assert_int_equal(bolan_content_create_ground(&d, &t), BOLAN_OK);
    ground_chunk a = chunk(t, -500.0, 0.0, 500.0, NULL), b = chunk(t, 0.0, 0.0, 250.0, NULL);
    static float va[CHUNK_VERTICES * 3], vb[CHUNK_VERTICES * 3];
    bolan_chunk_vertices(&a, va), bolan_chunk_vertices(&b, vb);
    const int row = CHUNK_CELLS + 1;
    for (int m = 0; m < CHUNK_MESHES; m++) { // b's finest against each mesh of a
        int step = 1 << m;
        for (int j = 0; j <= CHUNK_CELLS; j++) {
            double y = j * 250.0 / CHUNK_CELLS, u = y / (500.0 / CHUNK_CELLS) / step;
            int k = (int)u * step, k1 = k + step > CHUNK_CELLS ? CHUNK_CELLS : k + step;
            double f = u - (int)u;
            double za = (1.0 - f) * va[3 * (k * row + CHUNK_CELLS) + 2] + f * va[3 * (k1 * row + CHUNK_CELLS) + 2];
            assert_true(fabs(za - vb[3 * j * row + 2]) < a.skirt); // the skirt hangs over the gap
            assert_true(fabs(za - vb[3 * j * row + 2]) < b.skirt + a.skirt);
        }
    }
    bolan_chunk_free(&a), bolan_chunk_free(&b);
    bolan_ground_destroy(&t);
}

static void index_lists_stay_within_the_vertices_and_face_up(void **state) {
    (void)state;
    const uint32_t total = bolan_chunk_first_index(CHUNK_MESHES);
    uint32_t *indices = calloc(total, sizeof *indices);
    bolan_chunk_indices(indices);
    const uint32_t row = CHUNK_CELLS + 1;
    for (uint32_t m = 0; m < CHUNK_MESHES; m++) {
        double area = 0.0;
        const uint32_t *i = indices + bolan_chunk_first_index(m);
        for (uint32_t n = 0; n < bolan_chunk_index_count(m); n += 3, i += 3) {
            assert_true(i[0] < CHUNK_VERTICES && i[1] < CHUNK_VERTICES && i[2] < CHUNK_VERTICES);
            if (i[0] >= row * row || i[1] >= row * row || i[2] >= row * row) continue; // skirt
            double ax = i[0] % row, ay = i[0] / row, bx = i[1] % row, by = i[1] / row, cx = i[2] % row, cy = i[2] / row;
            double twice = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay);
            assert_true(twice > 0.0); // counter-clockwise from above
            area += 0.5 * twice;
        }
        assert_near(area, CHUNK_CELLS * CHUNK_CELLS, 1e-9); // the square, once
    }
    free(indices);
}

RUN_TESTS(cmocka_unit_test(a_wall_throws_a_shadow_of_its_height_over_the_tangent),
          cmocka_unit_test(a_slanting_sun_shortens_it_by_the_cosine),
          cmocka_unit_test(shadows_reach_into_a_child_from_outside_it),
          cmocka_unit_test(sky_is_open_on_a_slope_and_hidden_in_a_valley),
          cmocka_unit_test(neighbours_share_their_rim_whatever_their_level),
          cmocka_unit_test(index_lists_stay_within_the_vertices_and_face_up))

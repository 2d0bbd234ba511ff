// SPDX-License-Identifier: MIT
// Parcels at their rest points: the surface that queries find, with layers and over a ground; the low-pass of a mesh.
#include "sea_support.h"

#include "bolan/query.h"

#include <stdlib.h>

enum { SIDE = 40, POINTS = SIDE * SIDE };

static bolan_dvec2 rest[POINTS];
static bolan_parcel parcels[POINTS];
static float spacing[POINTS];

static void place(double step, double east) {
    for (uint32_t i = 0; i < POINTS; i++)
        rest[i] = (bolan_dvec2){east + step * (i % SIDE), -37.0 + 0.9 * step * (i / SIDE)};
}

static bolan_sea *make_sea(bolan_wave_model model, uint32_t order) {
    bolan_sea_desc d = bolan_sea_desc_default();
    d.waves = model;
    d.order = order;
    d.resolution = 128;
    bolan_sea *sea = test_sea(d);
    bolan_sea_step(sea, 31.5);
    return sea;
}

// Every parcel that stands alone is found again by a query at its place.
static void check_against_query(const bolan_water *water) {
    uint32_t alone = 0;
    bolan_query_parcels(water, rest, NULL, POINTS, parcels);
    for (uint32_t i = 0; i < POINTS; i++) {
        const bolan_parcel *p = &parcels[i];
        if (p->jacobian < 0.4f) continue;
        const bolan_dvec2 at = {rest[i].x + (double)p->displacement.x, rest[i].y + (double)p->displacement.y};
        bolan_query_point q;
        bolan_query_surface(water, &at, 1, &q);
        assert_float_equal(q.height, (float)(water->level + (double)p->displacement.z), 1e-3f);
        assert_true(bolan_v3_dot(q.normal, p->normal) > 0.9999f);
        assert_float_equal(q.jacobian, p->jacobian, 0.02f);
        alone++;
    }
    assert_true(alone > POINTS * 9 / 10);
}

static void queries_find_parcels_where_they_went(void **state) {
    (void)state;
    static const bolan_wave_model models[] = {BOLAN_WAVES_FFT, BOLAN_WAVES_FFT, BOLAN_WAVES_COSINES,
                                              BOLAN_WAVES_EXP_COSINE, BOLAN_WAVES_TEXTURES};
    place(3.1, 1e5);
    for (uint32_t i = 0; i < 5; i++) {
        bolan_sea *sea = make_sea(models[i], i == 1 ? 2 : 1);
        bolan_water water = bolan_water_default();
        water.sea = sea;
        water.level = 2.5;
        check_against_query(&water);
        bolan_sea_destroy(&sea);
    }
}

static void queries_find_parcels_over_a_beach_and_with_a_layer(void **state) {
    (void)state;
    bolan_sea *sea = make_sea(BOLAN_WAVES_FFT, 1);
    bolan_ground *ground = test_plane_ground(-120.0f, 100.0f); // the shore crosses the points
    bolan_wave_train_desc train = bolan_wave_train_desc_default();
    bolan_wave_layer *layer = NULL;
    assert_int_equal(bolan_wave_layer_create_train(&train, &layer), BOLAN_OK);
    const bolan_wave_layer *layers[] = {layer};
    bolan_water water = bolan_water_default();
    water.sea = sea;
    water.ground = ground;
    water.layers = layers;
    water.layer_count = 1;
    place(25.0, 0.0);
    check_against_query(&water);
    float most = 0.0f;
    for (uint32_t i = 0; i < POINTS; i++)
        if (rest[i].x > 600.0) most = fmaxf(most, bolan_v3_length(parcels[i].displacement));
    assert_true(most == 0.0f); // dry land
    bolan_wave_layer_destroy(&layer);
    bolan_ground_destroy(&ground);
    bolan_sea_destroy(&sea);
}

static void deep_water_has_the_samples_of_the_sea(void **state) {
    (void)state;
    static bolan_sea_sample samples[POINTS];
    place(1.7, -3000.0);
    for (int model = 0; model < BOLAN_WAVE_MODELS; model++) {
        bolan_sea *sea = make_sea((bolan_wave_model)model, 1);
        bolan_water water = bolan_water_default();
        water.sea = sea;
        bolan_query_parcels(&water, rest, NULL, POINTS, parcels);
        bolan_sea_sample_rest(sea, rest, POINTS, samples);
        for (uint32_t i = 0; i < POINTS; i++) {
            assert_float_equal(parcels[i].displacement.x, samples[i].dx, 2e-4f);
            assert_float_equal(parcels[i].displacement.y, samples[i].dy, 2e-4f);
            assert_float_equal(parcels[i].displacement.z, samples[i].height, 2e-4f);
        }
        bolan_sea_destroy(&sea);
    }
}

static double rms(double sum) { return sqrt(sum / POINTS); }

// What a grid keeps, of parcels and of bolan_sea_sample_grid(): the same waves to 4 % of their height, by other taps.
static void meshes_have_the_waves_that_their_spacing_can_carry(void **state) {
    (void)state;
    static bolan_sea_sample samples[POINTS];
    static const float spacings[] = {0.05f, 2.0f, 8.0f, 20.0f, 60.0f, 1000.0f};
    for (int model = 0; model < 2; model++) {
        bolan_sea *sea = make_sea((bolan_wave_model)model, 1);
        bolan_water water = bolan_water_default();
        water.sea = sea;
        place(7.7, 0.0);
        const double height = bolan_sea_get_summary(sea)->hs / 4.0;
        double kept = 1e9;
        for (uint32_t s = 0; s < sizeof spacings / sizeof *spacings; s++) {
            double differ = 0.0, own = 0.0;
            for (uint32_t i = 0; i < POINTS; i++) spacing[i] = spacings[s];
            bolan_query_parcels(&water, rest, spacing, POINTS, parcels);
            bolan_sea_sample_grid(sea, rest, spacing, POINTS, samples);
            for (uint32_t i = 0; i < POINTS; i++) {
                const double d = (double)parcels[i].displacement.z - (double)samples[i].height;
                differ += d * d;
                own += (double)parcels[i].displacement.z * (double)parcels[i].displacement.z;
            }
            assert_true(rms(differ) < 0.04 * height);
            assert_true(rms(own) < kept + 0.01 * height);
            kept = rms(own);
        }
        assert_true(kept < 0.01 * height);
        bolan_sea_destroy(&sea);
    }
}

static void a_parcel_depends_on_its_point_alone(void **state) {
    (void)state;
    bolan_sea *sea = make_sea(BOLAN_WAVES_FFT, 1);
    bolan_water water = bolan_water_default();
    water.sea = sea;
    place(2.3, 10.0);
    for (uint32_t i = 0; i < POINTS; i++) spacing[i] = 0.02f * (float)(i % 97);
    bolan_query_parcels(&water, rest, spacing, POINTS, parcels);
    for (uint32_t i = 0; i < POINTS; i += 7) {
        bolan_parcel one;
        bolan_query_parcels(&water, &rest[i], &spacing[i], 1, &one);
        assert_memory_equal(&one, &parcels[i], sizeof one);
    }
    const bolan_dvec2 nowhere = {NAN, 0.0};
    bolan_parcel still;
    bolan_query_parcels(&water, &nowhere, NULL, 1, &still);
    assert_true(still.displacement.z == 0.0f && still.normal.z == 1.0f);
    bolan_sea_destroy(&sea);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(queries_find_parcels_where_they_went),
        cmocka_unit_test(queries_find_parcels_over_a_beach_and_with_a_layer),
        cmocka_unit_test(deep_water_has_the_samples_of_the_sea),
        cmocka_unit_test(meshes_have_the_waves_that_their_spacing_can_carry),
        cmocka_unit_test(a_parcel_depends_on_its_point_alone),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

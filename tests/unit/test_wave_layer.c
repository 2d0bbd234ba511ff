// SPDX-License-Identifier: MIT
// Wave layers: a train against its closed form, and queries that add it to a sea.
#include "support.h"

#include "bolan/coast.h"
#include "bolan/query.h"

#include <math.h>
#include <string.h>

#define TURN (2.0 * BOLAN_PI)

static bolan_log_id last_id;
static char last_sentence[512];
static void hear(void *user, bolan_log_level level, bolan_log_id id, const char *sentence) {
    (void)user, (void)level;
    last_id = id;
    snprintf(last_sentence, sizeof last_sentence, "%s", sentence);
}

static bolan_wave_layer *train(const bolan_wave_train_desc *desc) {
    bolan_wave_layer *layer = NULL;
    assert_int_equal(bolan_wave_layer_create_train(desc, &layer), BOLAN_OK);
    return layer;
}

static bolan_wave_layer_sample at(const bolan_wave_layer *layer, double time, double x, double y) {
    bolan_wave_layer_sample s;
    bolan_wave_layer_sample_at(layer, time, &(bolan_dvec2){x, y}, 1, &s);
    return s;
}

// Without wind there are no waves: what is asked is the layer alone.
static bolan_sea *flat_sea(double time) {
    bolan_sea_desc desc = bolan_sea_desc_default();
    desc.sea_state = bolan_sea_state_from_wind(0.0, 0.0, 1e5);
    desc.resolution = 32;
    bolan_sea *sea = NULL;
    assert_int_equal(bolan_sea_create(&desc, &sea), BOLAN_OK);
    bolan_sea_step(sea, time);
    return sea;
}

static bolan_sea *windy_sea(double time) {
    bolan_sea_desc desc = bolan_sea_desc_default();
    desc.sea_state = bolan_sea_state_from_wind(9.0, 40.0, 1e5);
    desc.resolution = 64;
    bolan_sea *sea = NULL;
    assert_int_equal(bolan_sea_create(&desc, &sea), BOLAN_OK);
    bolan_sea_step(sea, time);
    return sea;
}

static void a_train_is_a_crest_at_its_centre_and_goes_where_it_should(void **state) {
    (void)state;
    bolan_wave_train_desc desc = bolan_wave_train_desc_default();
    desc.from_deg = 270.0; // from the west: towards +x
    desc.length = 80.0;
    desc.period = 8.0; // 10 m/s, whatever gravity says
    desc.height = 3.0;
    desc.centre = (bolan_dvec2){1000.0, -500.0};
    bolan_wave_layer *layer = train(&desc);
    assert_near(at(layer, 0.0, 1000.0, -500.0).height, 1.5, 1e-6);
    assert_near(at(layer, 0.0, 1040.0, -500.0).height, -1.5, 1e-6);
    assert_near(at(layer, 0.0, 1000.0, 77.0).height, 1.5, 1e-6);   // crests lie north and south
    assert_near(at(layer, 2.0, 1020.0, -500.0).height, 1.5, 1e-6); // 2 s later it is 20 m further east
    assert_near(at(layer, 2.0, 980.0, -500.0).height, -1.5, 1e-6);
    // Rising water ahead of the crest: the slope a quarter of a length to the east falls.
    assert_near(at(layer, 0.0, 1020.0, -500.0).slope_x, -1.5 * TURN / 80.0, 1e-6);
    assert_near(at(layer, 0.0, 1020.0, -500.0).slope_y, 0.0, 1e-6);
    assert_near(bolan_wave_layer_bound(layer), 1.5, 1e-12);
    bolan_wave_layer_destroy(&layer);
    assert_null(layer);

    desc.from_deg = 0.0; // from the north: towards -y
    desc.phase_deg = 90.0;
    layer = train(&desc);
    assert_near(at(layer, 0.0, 1000.0, -500.0).height, 0.0, 1e-6);
    assert_near(at(layer, 0.0, 1000.0, -480.0).height, 1.5, 1e-6); // cos(k (y to the south) + 90): a quarter behind
    assert_near(at(layer, 2.0, 1000.0, -500.0).height, 1.5, 1e-6);
    bolan_wave_layer_destroy(&layer);
}

static void its_period_is_that_of_free_waves(void **state) {
    (void)state;
    // omega^2 = g k in deep water, surface tension below 1e-5 of it; g k tanh(k d) in 10 m.
    static const double depths[2] = {BOLAN_DEEP, 10.0};
    for (int i = 0; i < 2; i++) {
        bolan_wave_train_desc desc = bolan_wave_train_desc_default();
        desc.length = 120.0;
        desc.depth = depths[i];
        const double k = TURN / 120.0, omega = sqrt(9.81 * k * tanh(k * depths[i])), period = TURN / omega;
        bolan_wave_layer *layer = train(&desc);
        assert_near(at(layer, period, 0.0, 0.0).height, 0.5, 1e-6);
        assert_near(at(layer, 0.25 * period, 0.0, 0.0).height, 0.0, 1e-4);
        assert_near(at(layer, 100.0 * period, 0.0, 0.0).height, 0.5, 1e-5); // and not only at first
        bolan_wave_layer_destroy(&layer);
    }
}

// Slopes are the derivatives of heights, envelope included; the envelope is 1 inside, 0 outside and smooth between.
static void its_edges_are_smooth_steps_and_slopes_the_derivatives(void **state) {
    (void)state;
    bolan_wave_train_desc desc = bolan_wave_train_desc_default();
    desc.from_deg = 233.0;
    desc.length = 40.0;
    desc.height = 2.0;
    desc.half_length = 200.0;
    desc.half_width = 90.0;
    desc.edge = 0.4;
    desc.centre = (bolan_dvec2){-30.0, 12.0};
    bolan_wave_layer *layer = train(&desc);
    const double going = bolan_compass_from_to_math(233.0), c = cos(going), s = sin(going);
    for (int i = 0; i < 200; i++) {
        const double along = 230.0 * sin(1.7 * i), across = 100.0 * sin(2.3 * i + 1.0), h = 1e-2;
        const double x = desc.centre.x + along * c - across * s, y = desc.centre.y + along * s + across * c;
        const bolan_wave_layer_sample here = at(layer, 3.0, x, y);
        // A step of 1 cm, curvature 0.025 a metre: 1e-5; floats of 1 m add 6e-6.
        assert_near(here.slope_x, (at(layer, 3.0, x + h, y).height - at(layer, 3.0, x - h, y).height) / (2.0f * 1e-2f),
                    5e-5);
        assert_near(here.slope_y, (at(layer, 3.0, x, y + h).height - at(layer, 3.0, x, y - h).height) / (2.0f * 1e-2f),
                    5e-5);
        if (fabs(along) >= 200.0 || fabs(across) >= 90.0) assert_true(here.height == 0.0f && here.slope_x == 0.0f);
    }
    // At time 0 and on the line of the crest through the centre the height is the envelope across.
    assert_near(at(layer, 0.0, desc.centre.x - 54.0 * s, desc.centre.y + 54.0 * c).height, 1.0, 1e-6);     // 0.6 of 90
    assert_near(at(layer, 0.0, desc.centre.x - 72.0 * s, desc.centre.y + 72.0 * c).height, 0.5, 1e-6);     // half way
    assert_near(at(layer, 0.0, desc.centre.x + 81.0 * s, desc.centre.y - 81.0 * c).height, 0.15625, 1e-6); // t = 1/4
    // Likewise along: two wave lengths on, 0.6 of the way out is 120 m.
    assert_near(at(layer, 0.0, desc.centre.x + 160.0 * c, desc.centre.y + 160.0 * s).height, 0.5, 1e-6);
    bolan_wave_layer_destroy(&layer);
}

static void a_query_adds_layers_to_the_sea(void **state) {
    (void)state;
    bolan_wave_train_desc one = bolan_wave_train_desc_default(), two = one;
    one.from_deg = 200.0, one.length = 60.0, one.height = 2.0;
    two.from_deg = 310.0, two.length = 17.0, two.height = 0.5, two.phase_deg = -40.0;
    bolan_wave_layer *a = train(&one), *b = train(&two);
    const bolan_wave_layer *both[] = {a, b}, *first[] = {a};
    bolan_sea *flat = flat_sea(7.5), *sea = windy_sea(7.5);
    const bolan_water still = {.sea = flat, .level = 2.5, .layers = both, .layer_count = 2};
    const bolan_water bare = {.sea = sea}, single = {.sea = sea, .layers = first, .layer_count = 1};
    for (int i = 0; i < 40; i++) {
        const bolan_dvec2 p = {1e6 + 13.0 * i, -3e5 + 7.0 * i * (i % 3)};
        const bolan_wave_layer_sample wa = at(a, 7.5, p.x, p.y), wb = at(b, 7.5, p.x, p.y);
        bolan_query_point got, plain, with;
        float height;
        bolan_query_surface(&still, &p, 1, &got);
        assert_near(got.height, 2.5 + (double)(wa.height + wb.height), 1e-6);
        const bolan_vec3 n = bolan_v3_normalize(bolan_v3(-wa.slope_x - wb.slope_x, -wa.slope_y - wb.slope_y, 1.0f));
        assert_near(got.normal.x, n.x, 1e-6);
        assert_near(got.normal.y, n.y, 1e-6);
        bolan_query_heights(&still, &p, 1, &height);
        assert_true(height == got.height);
        // Over waves it is added where the parcel rests, which is not where it stands: 1 m of displacement and a
        // slope of 0.1 at most.
        bolan_query_surface(&bare, &p, 1, &plain);
        bolan_query_surface(&single, &p, 1, &with);
        assert_near(with.height - plain.height, wa.height, 0.25);
        assert_true(with.jacobian == plain.jacobian && with.residual == plain.residual);
    }
    double vertical, horizontal, sea_vertical, sea_horizontal;
    bolan_sea_bounds(sea, &sea_vertical, &sea_horizontal);
    bolan_water_bounds(&(bolan_water){.sea = sea, .layers = both, .layer_count = 2}, &vertical, &horizontal);
    assert_near(vertical, sea_vertical + 1.25, 1e-9);
    assert_true(horizontal == sea_horizontal);
    bolan_sea_destroy(&flat);
    bolan_sea_destroy(&sea);
    bolan_wave_layer_destroy(&a);
    bolan_wave_layer_destroy(&b);
}

// Any number of places at once, the answers in their order.
static void many_places_are_answered_like_each(void **state) {
    (void)state;
    enum { PLACES = 2 * 16 + 5 };
    bolan_wave_train_desc desc = bolan_wave_train_desc_default();
    bolan_wave_layer *layer = train(&desc);
    bolan_dvec2 places[PLACES];
    bolan_wave_layer_sample all[PLACES];
    for (int i = 0; i < PLACES; i++) places[i] = (bolan_dvec2){3.1 * i, 50.0 - 2.7 * i};
    bolan_wave_layer_sample_at(layer, 5.0, places, PLACES, all);
    for (int i = 0; i < PLACES; i++) {
        const bolan_wave_layer_sample one = at(layer, 5.0, places[i].x, places[i].y);
        assert_memory_equal(&all[i], &one, sizeof one);
    }
    bolan_wave_layer_destroy(&layer);
}

static void shallow_water_lowers_a_layer_by_its_own_height(void **state) {
    (void)state;
    const float plane[4] = {-1.5f, -1.5f, -1.5f, -1.5f};
    bolan_ground_desc desc = bolan_ground_desc_default();
    desc.field = (bolan_heightfield){2, 2, -1000.0, -1000.0, 2000.0, 2000.0, plane};
    desc.detail = 0.0;
    bolan_ground *ground = NULL;
    assert_int_equal(bolan_ground_create(&desc, &ground), BOLAN_OK);
    bolan_wave_train_desc wave = bolan_wave_train_desc_default();
    wave.height = 2.0;
    bolan_wave_layer *layer = train(&wave);
    const bolan_wave_layer *layers[] = {layer};
    bolan_sea *flat = flat_sea(0.0);
    const bolan_dvec2 centre = {0.0, 0.0};
    bolan_query_point got;
    bolan_water water = {.sea = flat, .ground = ground, .level = 0.5, .layers = layers, .layer_count = 1};
    bolan_query_surface(&water, &centre, 1, &got);
    assert_near(got.height, 0.5 + tanh(0.6 * 2.0 / 2.0), 1e-5); // 2 m deep, 2 m high: tanh(0.6 depth / height)
    water.level = -2.0;                                         // dry
    bolan_query_surface(&water, &centre, 1, &got);
    assert_near(got.height, -2.0, 1e-6);
    bolan_sea_destroy(&flat);
    bolan_wave_layer_destroy(&layer);
    bolan_ground_destroy(&ground);
}

static void what_no_wave_is_like_is_refused(void **state) {
    (void)state;
    bolan_set_hooks(&(bolan_hooks){.log = hear});
    bolan_wave_train_desc desc = bolan_wave_train_desc_default();
    bolan_wave_layer *layer = (bolan_wave_layer *)&desc;
    desc.length = 10.0;
    desc.height = 1.43; // Miche: 1.42
    assert_int_equal(bolan_wave_layer_create_train(&desc, &layer), BOLAN_ERROR_ARGUMENT);
    assert_null(layer);
    assert_int_equal(last_id, BOLAN_LOG_LAYER_STEEP);
    assert_non_null(strstr(last_sentence, "1.42"));
    desc.height = 1.41;
    desc.depth = 1.0; // 1.42 tanh(0.628) = 0.79
    assert_int_equal(bolan_wave_layer_create_train(&desc, &layer), BOLAN_ERROR_ARGUMENT);
    desc.height = 0.78;
    assert_int_equal(bolan_wave_layer_create_train(&desc, &layer), BOLAN_OK);
    bolan_wave_layer_destroy(&layer);
    desc = bolan_wave_train_desc_default();
    desc.half_width = 0.0;
    assert_int_equal(bolan_wave_layer_create_train(&desc, &layer), BOLAN_ERROR_ARGUMENT);
    assert_non_null(strstr(last_sentence, "half_width"));
    desc = bolan_wave_train_desc_default();
    desc.period = (double)NAN;
    assert_int_equal(bolan_wave_layer_create_train(&desc, &layer), BOLAN_ERROR_ARGUMENT);
    bolan_wave_layer_destroy(NULL);
    bolan_set_hooks(NULL);
}

static void a_water_says_whether_it_can_be_used(void **state) {
    (void)state;
    bolan_water water = bolan_water_default();
    assert_near(water.foam, 1.0, 0.0);
    assert_near(water.optics.index, 1.34, 1e-6);
    assert_near(water.optics.kd.z, bolan_water_optics_from_jerlov(BOLAN_JERLOV_IB).kd.z, 0.0);
    assert_false(bolan_water_is_valid(NULL));
    assert_false(bolan_water_is_valid(&water));
    bolan_sea *sea = flat_sea(0.0);
    water.sea = sea;
    assert_true(bolan_water_is_valid(&water));
    water.layer_count = 1;
    assert_false(bolan_water_is_valid(&water));
    const bolan_wave_layer *none[BOLAN_MAX_WAVE_LAYERS + 1] = {NULL};
    water.layers = none;
    assert_false(bolan_water_is_valid(&water));
    const bolan_wave_train_desc desc = bolan_wave_train_desc_default();
    bolan_wave_layer *layer = train(&desc);
    for (int i = 0; i <= BOLAN_MAX_WAVE_LAYERS; i++) none[i] = layer;
    assert_true(bolan_water_is_valid(&water));
    water.layer_count = BOLAN_MAX_WAVE_LAYERS;
    assert_true(bolan_water_is_valid(&water));
    water.layer_count = BOLAN_MAX_WAVE_LAYERS + 1;
    assert_false(bolan_water_is_valid(&water));
    bolan_wave_layer_destroy(&layer);
    bolan_sea_destroy(&sea);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_train_is_a_crest_at_its_centre_and_goes_where_it_should),
        cmocka_unit_test(its_period_is_that_of_free_waves),
        cmocka_unit_test(its_edges_are_smooth_steps_and_slopes_the_derivatives),
        cmocka_unit_test(a_query_adds_layers_to_the_sea),
        cmocka_unit_test(many_places_are_answered_like_each),
        cmocka_unit_test(shallow_water_lowers_a_layer_by_its_own_height),
        cmocka_unit_test(what_no_wave_is_like_is_refused),
        cmocka_unit_test(a_water_says_whether_it_can_be_used),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

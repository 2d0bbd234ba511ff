// SPDX-License-Identifier: MIT
// Water optics against published tables: Jerlov's attenuation, pure water, and the colour of deep water.
#include "bolan/scene.h"
#include "io_support.h"

enum { TYPES = BOLAN_JERLOV_9C + 1 };

static void assert_rgb(bolan_vec3 found, double red, double green, double blue, double tolerance) {
    assert_near((double)found.x, red, tolerance);
    assert_near((double)found.y, green, tolerance);
    assert_near((double)found.z, blue, tolerance);
}

static void test_kd_is_jerlovs(void **state) {
    (void)state;
    static const double kd[TYPES][3] = {{.3559, .0640, .0176}, {.3601, .0674, .0257}, {.3652, .0715, .0355},
                                        {.3837, .0863, .0714}, {.4181, .1139, .1381}, {.4525, .1415, .2048},
                                        {.46, .19, .39},       {.54, .30, .56},       {.63, .46, .89},
                                        {.76, .63, 1.60}};
    for (int t = 0; t < TYPES; t++)
        assert_rgb(bolan_water_optics_from_jerlov((bolan_jerlov)t).kd, kd[t][0], kd[t][1], kd[t][2], 1e-6); // float
}

static void test_ten_metres_of_water_let_through_what_the_atlas_says(void **state) {
    (void)state;
    const bolan_vec3 clear = bolan_water_optics_from_jerlov(BOLAN_JERLOV_I).kd;
    const bolan_vec3 coast = bolan_water_optics_from_jerlov(BOLAN_JERLOV_1C).kd;
    const double m = -10.0; // published to four decimals
    assert_rgb(
        bolan_v3((float)exp(m * (double)clear.x), (float)exp(m * (double)clear.y), (float)exp(m * (double)clear.z)),
        .0285, .5273, .8386, 6e-5);
    assert_rgb(
        bolan_v3((float)exp(m * (double)coast.x), (float)exp(m * (double)coast.y), (float)exp(m * (double)coast.z)),
        .0108, .2429, .1290, 6e-5);
}

static void test_kd_absorption_and_backscatter_agree(void **state) {
    (void)state;
    for (int t = 0; t < TYPES; t++) {
        const bolan_water_optics o = bolan_water_optics_from_jerlov((bolan_jerlov)t);
        const float kd[3] = {o.kd.x, o.kd.y, o.kd.z}, a[3] = {o.absorption.x, o.absorption.y, o.absorption.z};
        const float bb[3] = {o.backscatter.x, o.backscatter.y, o.backscatter.z};
        const float b[3] = {o.scattering.x, o.scattering.y, o.scattering.z};
        static const double pure_a[3] = {.340, .0565, .00922},
                            pure_b[3] = {.00093, .00191, .00454}; // Pope & Fry, Morel
        for (int i = 0; i < 3; i++) {
            // 7 %: in the red, pure water by Pope & Fry absorbs more than the older Kd of the clearest types allow.
            assert_near((double)(a[i] + bb[i]) / 0.9 / (double)kd[i], 1.0, 0.07);
            assert_true((double)a[i] >= pure_a[i] * (1.0 - 1e-6));
            assert_true((double)b[i] >= pure_b[i] - 1e-5 && b[i] >= 2.0f * bb[i] * 0.99f);
        }
    }
}

// Pure sea: Rrs .0118 / .00083 / .00007 at 450 / 550 / 650 nm. The clearest type holds a trace of plankton, so it is a
// little darker in the blue and brighter elsewhere.
static void test_the_clearest_water_is_nearly_pure_water(void **state) {
    (void)state;
    const bolan_vec3 deep = bolan_water_optics_from_jerlov(BOLAN_JERLOV_I).deep;
    assert_near((double)deep.z, .0118, .0018);
    assert_near((double)deep.y, .00083, .0004);
    assert_near((double)deep.x, .00007, .00006);
}

static void test_deep_water_turns_from_blue_over_green_to_brown(void **state) {
    (void)state;
    for (int t = 0; t < TYPES; t++) {
        const bolan_vec3 deep = bolan_water_optics_from_jerlov((bolan_jerlov)t).deep;
        assert_true(deep.x > 0.0f && deep.y > 0.0f && deep.z > 0.0f && deep.z < 0.03f);
        if (t <= BOLAN_JERLOV_II) assert_true(deep.z > 2.0f * deep.y && deep.y > deep.x);
        if (t >= BOLAN_JERLOV_3C) assert_true(deep.y > 1.3f * deep.z);
    }
    const bolan_vec3 muddy = bolan_water_optics_from_jerlov(BOLAN_JERLOV_9C).deep;
    assert_true(muddy.x > muddy.z); // brown: more red than blue
}

static void test_names_go_both_ways(void **state) {
    (void)state;
    for (int t = 0; t < TYPES; t++) assert_int_equal(bolan_jerlov_from_name(bolan_jerlov_name((bolan_jerlov)t)), t);
    assert_int_equal(bolan_jerlov_from_name("iii"), BOLAN_JERLOV_III);
    assert_int_equal(bolan_jerlov_from_name("9c"), BOLAN_JERLOV_9C);
    assert_int_equal(bolan_jerlov_from_name("2C"), -1);
    assert_int_equal(bolan_jerlov_from_name(""), -1);
    assert_int_equal(bolan_jerlov_from_name("IIII"), -1);
}

// Coastal water holds minerals: 0.0183 of what particles scatter goes back (Petzold 1972), at every wave length; in the
// open ocean 0.002 + 0.02 (0.5 - 0.25 log10 C) 550 nm / l (Morel 1988), here of type II, C = 0.5. Pure water gives half
// of its own.
static void test_the_share_that_goes_back_is_petzold_s_at_the_coast(void **state) {
    (void)state;
    static const double pure[3] = {0.000927, 0.001908, 0.004540}, length[3] = {650.0, 550.0, 450.0};
    for (int type = BOLAN_JERLOV_I; type <= BOLAN_JERLOV_9C; type++) {
        const bolan_water_optics o = bolan_water_optics_from_jerlov((bolan_jerlov)type);
        const float b[3] = {o.scattering.x, o.scattering.y, o.scattering.z};
        const float bb[3] = {o.backscatter.x, o.backscatter.y, o.backscatter.z};
        for (int i = 0; i < 3; i++) {
            const double share = ((double)bb[i] - 0.5 * pure[i]) / ((double)b[i] - pure[i]);
            if (type >= BOLAN_JERLOV_1C) assert_true(fabs(share - 0.0183) < 2e-6);
            if (type == BOLAN_JERLOV_II)
                assert_true(fabs(share - (0.002 + 0.02 * (0.5 - 0.25 * log10(0.5)) * 550.0 / length[i])) < 2e-6);
        }
        // particles scatter 0.30 C^0.62 at 550 nm (Gordon & Morel 1983)
        if (type == BOLAN_JERLOV_1C) assert_true(fabs((double)b[1] - pure[1] - 0.30 * pow(3.0, 0.62)) < 1e-6);
        if (type == BOLAN_JERLOV_9C) assert_true(fabs((double)b[1] - pure[1] - 0.30 * pow(40.0, 0.62)) < 1e-6);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_kd_is_jerlovs),
        cmocka_unit_test(test_ten_metres_of_water_let_through_what_the_atlas_says),
        cmocka_unit_test(test_kd_absorption_and_backscatter_agree),
        cmocka_unit_test(test_the_share_that_goes_back_is_petzold_s_at_the_coast),
        cmocka_unit_test(test_the_clearest_water_is_nearly_pure_water),
        cmocka_unit_test(test_deep_water_turns_from_blue_over_green_to_brown),
        cmocka_unit_test(test_names_go_both_ways),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

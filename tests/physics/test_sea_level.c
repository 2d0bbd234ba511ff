// SPDX-License-Identifier: MIT
// The mean of the surface at fixed points is the water level, whatever makes the waves, asked or carried by a grid, in
// deep water and over a bed.
#include "sea_support.h"

#include "bolan/query.h"

enum { POINTS = 160000 };
static bolan_dvec2 at[POINTS];
static float height[POINTS], spacing[POINTS];
static bolan_sea_sample sample[POINTS];

static double turn(double x) { return x - floor(x); }

// Of POINTS waves of height Hs the mean is known to Hs / 4 / sqrt(POINTS) = 0.0006 Hs; 0.002 is three of these.
static void scatter(double side) {
    for (int i = 0; i < POINTS; i++)
        at[i] = (bolan_dvec2){side * turn(i * 0.7548776662466927), side * turn(0.5 + i * 0.5698402909980532)};
}

static bolan_sea *make(bolan_wave_model model, double wind, double depth, double choppiness) {
    bolan_sea_desc d = bolan_sea_desc_default();
    d.sea_state = bolan_sea_state_from_wind(wind, 250.0, 300e3);
    d.sea_state.depth = depth;
    d.waves = model;
    d.choppiness = choppiness;
    bolan_sea *sea = test_sea(d);
    bolan_sea_step(sea, 20.0);
    return sea;
}

static double whole_lift(const bolan_sea *sea, double grid) {
    double sum = bolan_sea_cascade_count(sea) == 0 ? bolan_sea_lift(sea, 0, grid) : 0.0;
    for (uint32_t c = 0; c < bolan_sea_cascade_count(sea); c++) sum += bolan_sea_lift(sea, c, grid);
    return sum;
}

static double hs_of(const bolan_sea *sea) { return bolan_sea_get_summary(sea)->hs; }

static void queries_have_the_level_as_their_mean(void **state) {
    (void)state;
    static const struct {
        bolan_wave_model model;
        double wind, depth, choppiness;
    } seas[] = {{BOLAN_WAVES_FFT, 5.0, BOLAN_DEEP, 1.0},      {BOLAN_WAVES_FFT, 10.0, BOLAN_DEEP, 1.0},
                {BOLAN_WAVES_FFT, 10.0, BOLAN_DEEP, 1.6},     {BOLAN_WAVES_FFT, 10.0, 6.0, 1.0},
                {BOLAN_WAVES_FFT, 30.0, BOLAN_DEEP, 1.0},     {BOLAN_WAVES_TEXTURES, 10.0, BOLAN_DEEP, 1.0},
                {BOLAN_WAVES_COSINES, 10.0, BOLAN_DEEP, 1.0}, {BOLAN_WAVES_COSINES, 10.0, 6.0, 1.5},
                {BOLAN_WAVES_EXP_COSINE, 10.0, 8.0, 1.0}};
    for (size_t i = 0; i < sizeof seas / sizeof *seas; i++) {
        bolan_sea *sea = make(seas[i].model, seas[i].wind, seas[i].depth, seas[i].choppiness);
        double sum = 0.0;
        scatter(bolan_sea_cascade_count(sea) > 0 ? 6.0 * bolan_sea_cascade(sea, 0).length : 2e4);
        bolan_query_heights(&(bolan_water){.sea = sea}, at, POINTS, height);
        for (int p = 0; p < POINTS; p++) sum += (double)height[p] / POINTS;
        assert_near(sum / hs_of(sea), 0.0, 0.002);
        // without the lift it would not be: the test can fail
        if (seas[i].model != BOLAN_WAVES_EXP_COSINE) assert_true(whole_lift(sea, 0.0) > 0.006 * hs_of(sea));
        assert_near(bolan_sea_measure(sea).mean_level / hs_of(sea), 0.0, 0.003); // 65536 places
        bolan_sea_destroy(&sea);
    }
}

// A grid low-passes the waves, and their lift with them. Parcels count by the area that they cover.
static void a_grid_has_the_level_as_its_mean(void **state) {
    (void)state;
    for (int model = BOLAN_WAVES_FFT; model <= BOLAN_WAVES_COSINES; model++) {
        bolan_sea *sea = make((bolan_wave_model)model, 12.0, BOLAN_DEEP, 1.0);
        scatter(model == BOLAN_WAVES_FFT ? bolan_sea_cascade(sea, 0).length : 5e3);
        double previous = whole_lift(sea, 0.0);
        for (double grid = 0.25; grid < 200.0; grid *= 2.3) {
            double sum = 0.0, area = 0.0;
            for (int p = 0; p < POINTS; p++) spacing[p] = (float)grid;
            bolan_sea_sample_grid(sea, at, spacing, POINTS, sample);
            for (int p = 0; p < POINTS; p++) {
                area += (double)sample[p].jacobian;
                sum += (double)(sample[p].jacobian * sample[p].height);
            }
            assert_near(sum / area / hs_of(sea), 0.0, 0.002);
            assert_true(whole_lift(sea, grid) <= previous);
            previous = whole_lift(sea, grid);
        }
        assert_near(whole_lift(sea, 1e5), 0.0, 1e-12);
        bolan_sea_destroy(&sea);
    }
}

// One cosine: choppiness a^2 k coth(kd) / 2, and of a grid of a third of its length the square of what is left.
static void one_wave_is_lifted_by_the_closed_form(void **state) {
    (void)state;
    bolan_sea_desc d = bolan_sea_desc_default();
    d.sea_state = bolan_sea_state_from_wind(7.0, 100.0, 300e3);
    d.sea_state.depth = 4.0;
    d.waves = BOLAN_WAVES_COSINES;
    d.cosines.frequencies = d.cosines.directions = 1;
    d.choppiness = 1.25;
    bolan_sea *sea = test_sea(d);
    const bolan_sea_component c = bolan_sea_get_component(sea, 0);
    const double k = hypot(c.kx, c.ky), length = 2.0 * BOLAN_PI / k, a = c.amplitude;
    const double lift = 1.25 * 0.5 * a * a * k / tanh(4.0 * k);
    assert_near(bolan_sea_lift(sea, 0, 0.0) / lift, 1.0, 1e-9);
    assert_near(bolan_sea_lift(sea, 0, length / 5.0) / lift, 1.0, 1e-9);
    assert_near(bolan_sea_lift(sea, 0, length / 3.0) / lift, 0.25, 0.05); // between two levels of the table
    assert_near(bolan_sea_lift(sea, 0, length / 1.9), 0.0, 1e-12);
    double vertical, horizontal;
    bolan_sea_bounds(sea, &vertical, &horizontal); // of one wave: its crest, and as far as it moves water
    assert_near(vertical / (a + lift), 1.0, 1e-9);
    assert_near(horizontal / (1.25 * a / tanh(4.0 * k)), 1.0, 1e-9);
    bolan_dvec2 here = {3.0, 4.0};
    bolan_sea_sample s;
    bolan_sea_sample_rest(sea, &here, 1, &s);
    assert_near(s.height, lift + a * cos(c.kx * 3.0 + c.ky * 4.0 + c.phase), 1e-5);
    assert_near(bolan_sea_sample_direct(sea, 3.0, 4.0, 0.0).height, s.height, 1e-5);
    bolan_sea_destroy(&sea);
}

// The integral of k S dw, by the public spectrum over the rings, bounds the lift of the interpolated fields: these keep
// nearly all of the longest waves and .42 of the shortest. Three cascades end before the waves are rolled off.
static void the_lift_is_that_of_the_spectrum(void **state) {
    (void)state;
    bolan_sea_desc d = bolan_sea_desc_default();
    d.sea_state = bolan_sea_state_from_wind(10.0, 250.0, HUGE_VAL);
    d.resolution = 512;
    d.fft.cascade_count = 2;
    bolan_sea *sea = test_sea(d);
    double integral = 0.0;
    const double top = bolan_sea_cascade(sea, 1).k_max, w_top = sqrt(9.81 * top);
    for (double w = 0.2; w < w_top; w += 1e-3)
        integral += w * w / 9.81 * bolan_system_density(&d.sea_state.systems[0], w, BOLAN_DEEP) * 1e-3;
    assert_near(whole_lift(sea, 0.0) / integral, 0.93, 0.07);
    bolan_sea_destroy(&sea);
    d.choppiness = 0.0;
    sea = test_sea(d);
    assert_true(whole_lift(sea, 0.0) == 0.0);
    bolan_sea_destroy(&sea);
}

// Over a level bed waves are lower by f, and their lift by f squared.
static void shallow_water_keeps_the_level(void **state) {
    (void)state;
    enum { SIDE = 300 };
    const float grid[4] = {-1.5f, -1.5f, -1.5f, -1.5f};
    bolan_ground_desc ground = bolan_ground_desc_default();
    ground.field = (bolan_heightfield){2, 2, -5e4, -5e4, 1e5, 1e5, grid};
    ground.detail = 0.0;
    ground.edge_elevation = -1.5;
    bolan_ground *terrain = NULL;
    assert_int_equal(bolan_ground_create(&ground, &terrain), BOLAN_OK);
    static bolan_query_point answer[SIDE * SIDE];
    for (int model = BOLAN_WAVES_FFT; model <= BOLAN_WAVES_COSINES; model++) {
        bolan_sea *sea = make((bolan_wave_model)model, 10.0, BOLAN_DEEP, 1.6);
        const double side = model == BOLAN_WAVES_FFT ? bolan_sea_cascade(sea, 0).length : 3e3;
        for (int p = 0; p < SIDE * SIDE; p++) // in rows and columns, which average the tile out
            at[p] = (bolan_dvec2){side * (p % SIDE) / SIDE - 0.4 * side, side * (p / SIDE) / SIDE - 0.4 * side};
        bolan_query_surface(&(bolan_water){.sea = sea, .ground = terrain, .level = 0.5}, at, SIDE * SIDE, answer);
        double sum = 0.0, square = 0.0;
        for (int p = 0; p < SIDE * SIDE; p++) {
            const double h = (double)answer[p].height - 0.5;
            sum += h / (SIDE * SIDE);
            square += h * h / (SIDE * SIDE);
        }
        const double hs = 4.0 * sqrt(square);
        assert_true(hs < 0.6 * 2.0 * 1.1 && hs > 0.8); // sampling
        assert_near(sum / hs, 0.0, 0.002);
        bolan_sea_destroy(&sea);
    }
    bolan_ground_destroy(&terrain);
}

RUN_TESTS(cmocka_unit_test(queries_have_the_level_as_their_mean), cmocka_unit_test(a_grid_has_the_level_as_its_mean),
          cmocka_unit_test(one_wave_is_lifted_by_the_closed_form), cmocka_unit_test(the_lift_is_that_of_the_spectrum),
          cmocka_unit_test(shallow_water_keeps_the_level))

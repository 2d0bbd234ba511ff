// SPDX-License-Identifier: MIT
// What query.h promises, whatever the sea: parcels are found again where they went, residuals, independence of batch,
// threads and instruction set, bad input, no allocation, shallow water.
#include "sea_support.h"

#include "bolan/coast.h"
#include "bolan/query.h"

#include "query/block.h"

#include <stdlib.h>
#include <string.h>

enum { POINTS = 3000 };

static bolan_dvec2 points[POINTS];
static bolan_query_point answers[POINTS];
static float heights[POINTS];

static bolan_sea *make(const bolan_sea_desc *desc) {
    bolan_sea *sea = NULL;
    assert_int_equal(bolan_sea_create(desc, &sea), BOLAN_OK);
    bolan_sea_step(sea, 12.5);
    return sea;
}

static bolan_sea *make_sea(double wind, double choppiness, uint32_t cascades, bolan_cpu cpu) {
    bolan_sea_desc d = bolan_sea_desc_default();
    d.sea_state = bolan_sea_state_from_wind(wind, 240.0, 300e3);
    d.choppiness = choppiness;
    d.fft.cascade_count = cascades;
    d.resolution = 128;
    d.cpu = cpu;
    return make(&d);
}

// Steeper than any wind makes it, so that it folds.
static bolan_sea *make_folded_sea_of(uint64_t seed, double from_deg, uint32_t cascades) {
    bolan_sea_desc d = bolan_sea_desc_default();
    d.sea_state = bolan_sea_state_from_wind(20.0, from_deg, 300e3);
    d.sea_state.systems[0].hs *= 1.6;
    d.choppiness = 2.0;
    d.fft.cascade_count = cascades;
    d.resolution = 128;
    d.seed = seed;
    return make(&d);
}

static bolan_sea *make_folded_sea(uint32_t cascades) { return make_folded_sea_of(1, 240.0, cascades); }

// Points of a square of 2 km, the same ones every time.
static void scatter(bolan_dvec2 *xy, uint32_t count) {
    uint64_t state = 88172645463325252u;
    for (uint32_t i = 0; i < count; i++) {
        double r[2];
        for (int k = 0; k < 2; k++) {
            state ^= state << 13, state ^= state >> 7, state ^= state << 17; // Marsaglia 2003
            r[k] = (double)(state >> 11) / 9007199254740992.0;
        }
        xy[i] = (bolan_dvec2){(r[0] - 0.5) * 2000.0, (r[1] - 0.5) * 2000.0};
    }
}

static void test_a_parcel_is_found_where_it_went(void **state) {
    (void)state;
    static bolan_sea_sample parcels[POINTS];
    static bolan_dvec2 moved[POINTS];
    bolan_sea *sea = make_sea(10.0, 1.0, 4, BOLAN_CPU_AUTO);
    scatter(points, POINTS);
    bolan_sea_sample_rest(sea, points, POINTS, parcels);
    double travel = 0.0;
    for (uint32_t i = 0; i < POINTS; i++) {
        moved[i] = (bolan_dvec2){points[i].x + (double)parcels[i].dx, points[i].y + (double)parcels[i].dy};
        travel += hypot((double)parcels[i].dx, (double)parcels[i].dy) / POINTS;
    }
    assert_true(travel > 0.2); // the question would be idle if nothing had moved
    bolan_query_surface(&(bolan_water){.sea = sea}, moved, POINTS, answers);
    for (uint32_t i = 0; i < POINTS; i++) {
        if (parcels[i].jacobian < 0.3f) continue; // a fold is near: another parcel may lie above this one
        // Half the promised residual of 1 mm down a slope of at most 1, and the rounding of both float paths.
        assert_float_equal(answers[i].height, parcels[i].height, 1e-3);
        assert_float_equal(answers[i].jacobian, parcels[i].jacobian, 2e-2);
        const bolan_vec3 n = answers[i].normal;
        // Slopes of the shortest waves change by some 0.1 a centimetre, and the place is off by up to half a
        // millimetre.
        assert_float_equal(-n.x / n.z, parcels[i].slope_x, 1e-2);
        assert_float_equal(-n.y / n.z, parcels[i].slope_y, 1e-2);
    }
    bolan_sea_destroy(&sea);
}

static void test_heights_and_surface_agree_to_the_bit(void **state) {
    (void)state;
    bolan_sea *sea = make_folded_sea(4);
    scatter(points, POINTS);
    bolan_query_heights(&(bolan_water){.sea = sea}, points, POINTS, heights);
    bolan_query_surface(&(bolan_water){.sea = sea}, points, POINTS, answers);
    for (uint32_t i = 0; i < POINTS; i++) assert_true(heights[i] == answers[i].height);
    bolan_sea_destroy(&sea);
}

// Nearly all far below the promise: Newton's steps converge by squares.
static void check_residuals(const bolan_sea *sea) {
    scatter(points, POINTS);
    bolan_query_surface(&(bolan_water){.sea = sea}, points, POINTS, answers);
    uint32_t unfolded = 0, exact = 0;
    for (uint32_t i = 0; i < POINTS; i++) {
        if (answers[i].jacobian <= 0.2f) continue;
        unfolded++;
        exact += answers[i].residual < 2e-5f;
        assert_true(answers[i].residual < 1e-3f);
    }
    assert_true(exact > unfolded * 99 / 100);
    assert_true(unfolded > POINTS * 9 / 10);
}

static void test_the_residual_is_below_a_millimetre_where_the_surface_does_not_fold(void **state) {
    (void)state;
    static const double winds[] = {3.0, 10.0, 20.0, 20.0};
    for (int i = 0; i < 4; i++) {
        bolan_sea *sea = make_sea(winds[i], i == 3 ? 1.5 : 1.0, 4, BOLAN_CPU_AUTO);
        check_residuals(sea);
        bolan_sea_destroy(&sea);
    }
    bolan_sea_desc d = bolan_sea_desc_default();
    d.waves = BOLAN_WAVES_COSINES;
    d.sea_state = bolan_sea_state_from_wind(15.0, 240.0, 300e3);
    bolan_sea *sum = make(&d);
    check_residuals(sum);
    bolan_sea_destroy(&sum);
}

static void test_folded_water_is_finite_and_its_normals_point_up(void **state) {
    (void)state;
    bolan_sea *sea = make_folded_sea(4);
    scatter(points, POINTS);
    bolan_query_surface(&(bolan_water){.sea = sea}, points, POINTS, answers);
    double vertical, horizontal;
    bolan_sea_bounds(sea, &vertical, &horizontal);
    for (uint32_t i = 0; i < POINTS; i++) {
        assert_true(isfinite(answers[i].height) && fabs((double)answers[i].height) <= vertical);
        assert_float_equal(bolan_v3_length(answers[i].normal), 1.0, 1e-5);
        assert_true(answers[i].normal.z >= 0.0f);
        assert_true(isfinite(answers[i].jacobian) && isfinite(answers[i].residual));
    }
    bolan_sea_destroy(&sea);
}

enum { SIDE = 301 };
static bolan_dvec2 rest[SIDE * SIDE];
static bolan_sea_sample parcels[SIDE * SIDE];

// The parcels of a square of rest points around a place.
static void sample_square(const bolan_sea *sea, bolan_dvec2 centre, double step) {
    for (int k = 0; k < SIDE * SIDE; k++) {
        rest[k].x = centre.x + step * (k % SIDE - SIDE / 2);
        rest[k].y = centre.y + step * (k / SIDE - SIDE / 2);
    }
    bolan_sea_sample_rest(sea, rest, SIDE * SIDE, parcels);
}

static bolan_dvec2 place_of(int k) {
    return (bolan_dvec2){rest[k].x + (double)parcels[k].dx, rest[k].y + (double)parcels[k].dy};
}

// Places over folds: where parcels land around which the map turns over. Returns how many were found.
static int find_folds(const bolan_sea *sea, bolan_dvec2 *places, int capacity) {
    int count = 0;
    for (int part = 0; part < 20 && count < capacity; part++) {
        sample_square(sea, (bolan_dvec2){500.0 * part, -300.0 * part}, 0.37);
        for (int k = 0; k < SIDE * SIDE && count < capacity; k += 1) {
            if (parcels[k].jacobian > -0.05f) continue;
            places[count++] = place_of(k);
            k += 7 * SIDE; // on to another crest
        }
    }
    return count;
}

// How many of the answers over `count` folds have a layer above them.
static int count_covered(const bolan_sea *sea, const bolan_dvec2 *place, int count) {
    int covered = 0;
    bolan_query_surface(&(bolan_water){.sea = sea}, place, (uint32_t)count, answers);
    for (int i = 0; i < count; i++) {
        assert_true(answers[i].residual < 1e-2f); // the promise of 1 mm is for unfolded water
        // All rest points within 3 m at 2 cm: a parcel that lands within 1 cm of the place must not be higher than the
        // answer by more than that distance up a slope of 2.
        sample_square(sea, place[i], 0.02);
        bool above = false;
        for (int k = 0; k < SIDE * SIDE; k++) {
            const bolan_dvec2 at = place_of(k);
            above |=
                hypot(at.x - place[i].x, at.y - place[i].y) < 0.01 && parcels[k].height > answers[i].height + 0.02f;
        }
        covered += above;
    }
    return covered;
}

// Several seas, whose waves run along x, along y and between: folds lie across each.
static void test_no_parcel_lies_above_the_answer_in_a_fold(void **state) {
    (void)state;
    enum { PLACES = 24 };
    static const double from[] = {240.0, 270.0, 0.0};
    int covered = 0, count = 0;
    for (int i = 0; i < 3; i++) {
        bolan_dvec2 place[PLACES];
        bolan_sea *sea = make_folded_sea_of((uint64_t)i + 1, from[i], 4);
        const int found = find_folds(sea, place, PLACES);
        assert_true(found >= PLACES / 2);
        const int above = count_covered(sea, place, found);
        covered += above;
        count += found;
        bolan_sea_destroy(&sea);
    }
    print_message("%d of %d folds have a layer above the answer\n", covered, count);
    // The search tries sixteen starts, not all: it misses one in twelve of these, at twice the displacement of linear
    // waves.
    assert_true(covered <= count / 8);
}

// M v = least v for the symmetric M = (xx, xy; xy, yy), whichever axis is compressed.
static void test_the_direction_of_compression_is_an_eigenvector(void **state) {
    (void)state;
    static const float m[][3] = {{0.1f, 1.0f, 0.0f},  {1.0f, 0.1f, 0.0f},  {0.5f, 0.5f, 0.4f},   {0.5f, 0.5f, -0.4f},
                                 {0.2f, 0.9f, 0.3f},  {0.9f, 0.2f, 0.3f},  {0.9f, 0.2f, -0.3f},  {0.2f, 0.9f, -0.3f},
                                 {-0.4f, 1.1f, 0.1f}, {1.1f, -0.4f, 0.1f}, {1.3f, 0.7f, -0.01f}, {0.7f, 1.3f, 0.01f}};
    for (size_t i = 0; i < sizeof m / sizeof *m; i++) {
        const double xx = (double)m[i][0], yy = (double)m[i][1], xy = (double)m[i][2];
        const bolan_vec2 v = bolan_query_compressed_direction(m[i][0], m[i][1], m[i][2]);
        const double x = (double)v.x, y = (double)v.y;
        const double least = 0.5 * (xx + yy) - sqrt(0.25 * (xx - yy) * (xx - yy) + xy * xy);
        assert_true(fabs(x * x + y * y - 1.0) < 1e-6);
        assert_true(fabs(xx * x + xy * y - least * x) < 1e-6 && fabs(xy * x + yy * y - least * y) < 1e-6);
    }
}

static void test_a_batch_gives_what_single_questions_give_on_any_number_of_threads(void **state) {
    (void)state;
    static bolan_query_point other[POINTS];
    bolan_sea *sea = make_folded_sea(4);
    scatter(points, POINTS);
    bolan_query_surface(&(bolan_water){.sea = sea}, points, POINTS, answers);
    for (uint32_t i = 0; i < POINTS; i++) bolan_query_surface(&(bolan_water){.sea = sea}, points + i, 1, other + i);
    assert_memory_equal(answers, other, sizeof answers);
    for (uint32_t threads = 2; threads <= 5; threads++) {
        bolan_set_threads(threads);
        memset(other, 0, sizeof other);
        bolan_query_surface(&(bolan_water){.sea = sea}, points, POINTS, other);
        assert_memory_equal(answers, other, sizeof answers);
    }
    bolan_set_threads(1);
    bolan_sea_destroy(&sea);
}

static void test_instruction_sets_agree_to_the_bit(void **state) {
    (void)state;
    static bolan_query_point other[POINTS];
    scatter(points, POINTS);
    for (int cpu = BOLAN_CPU_SCALAR; cpu <= (int)bolan_cpu_best(); cpu++) {
        bolan_sea *sea = make_sea(15.0, 1.8, 4, (bolan_cpu)cpu);
        bolan_query_surface(&(bolan_water){.sea = sea}, points, POINTS, cpu == BOLAN_CPU_SCALAR ? answers : other);
        if (cpu != BOLAN_CPU_SCALAR) assert_memory_equal(answers, other, sizeof answers);
        bolan_sea_destroy(&sea);
    }
}

static void test_a_tile_away_is_the_same_even_a_thousand_kilometres_off(void **state) {
    (void)state;
    static float far_away[POINTS];
    bolan_sea_desc d = bolan_sea_desc_default();
    d.waves = BOLAN_WAVES_TEXTURES; // of the open sea no tile is like another
    bolan_sea *sea = NULL;
    assert_int_equal(bolan_sea_create(&d, &sea), BOLAN_OK);
    bolan_sea_step(sea, 7.0);
    const bolan_cascade_view tile = bolan_sea_cascade(sea, 0);
    const double shift = floor(1e6 / tile.length) * tile.length;
    scatter(points, POINTS);
    bolan_query_heights(&(bolan_water){.sea = sea}, points, POINTS, heights);
    for (uint32_t i = 0; i < POINTS; i++) {
        points[i].x += shift * cos(tile.angle);
        points[i].y += shift * sin(tile.angle);
    }
    bolan_query_heights(&(bolan_water){.sea = sea}, points, POINTS, far_away);
    // Positions at 1e6 m are doubles with steps of 1e-10 m; the rest is the rounding of the fraction of a cell.
    for (uint32_t i = 0; i < POINTS; i++) assert_float_equal(heights[i], far_away[i], 1e-5);
    bolan_sea_destroy(&sea);
}

static void test_points_that_are_not_finite_give_the_mean_level(void **state) {
    (void)state;
    bolan_sea *sea = make_sea(12.0, 1.0, 4, BOLAN_CPU_AUTO);
    bolan_dvec2 xy[5] = {{NAN, 0.0}, {0.0, INFINITY}, {3.0, 4.0}, {-INFINITY, NAN}, {1e300, -1e300}};
    float height[5];
    bolan_query_point point[5];
    bolan_query_heights(&(bolan_water){.sea = sea}, xy, 5, height);
    bolan_query_surface(&(bolan_water){.sea = sea, .level = 2.0}, xy, 5, point);
    assert_true(height[0] == 0.0f && height[1] == 0.0f && height[3] == 0.0f);
    assert_true(point[0].height == 2.0f && point[1].height == 2.0f && point[3].height == 2.0f);
    assert_true(height[2] != 0.0f);
    assert_float_equal(point[2].height, 2.0f + height[2], 1e-6); // not disturbed by its neighbours
    assert_true(isfinite(height[4]) && isfinite(point[4].height));
    bolan_query_heights(&(bolan_water){.sea = sea}, NULL, 0, NULL);
    bolan_query_surface(&(bolan_water){.sea = sea}, NULL, 0, NULL);
    bolan_sea_destroy(&sea);
}

static uint32_t allocations;

static void *counting_allocate(void *user, size_t size, size_t align) {
    (void)user;
    allocations++;
    return aligned_alloc(align, (size + align - 1) / align * align);
}

static void plain_release(void *user, void *memory, size_t size) {
    (void)user, (void)size;
    free(memory);
}

static void test_a_query_allocates_nothing(void **state) {
    (void)state;
    const bolan_hooks hooks = {.allocate = counting_allocate, .release = plain_release};
    bolan_set_hooks(&hooks);
    bolan_sea *sea = make_sea(20.0, 1.8, 4, BOLAN_CPU_AUTO);
    scatter(points, POINTS);
    allocations = 0;
    bolan_query_heights(&(bolan_water){.sea = sea}, points, POINTS, heights);
    bolan_query_surface(&(bolan_water){.sea = sea}, points, POINTS, answers);
    assert_int_equal(allocations, 0);
    bolan_sea_destroy(&sea);
    bolan_set_hooks(NULL);
}

static double mean_square(const bolan_query_point *p, double level) {
    double sum = 0.0;
    for (uint32_t i = 0; i < POINTS; i++) sum += ((double)p[i].height - level) * ((double)p[i].height - level) / POINTS;
    return sum;
}

static void test_shallow_water_lowers_the_waves_and_land_has_none(void **state) {
    (void)state;
    static bolan_query_point deep[POINTS];
    bolan_sea *sea = make_sea(10.0, 1.0, 3, BOLAN_CPU_AUTO);
    scatter(points, POINTS);
    bolan_query_surface(&(bolan_water){.sea = sea, .level = 1.0}, points, POINTS, deep);

    bolan_ground *terrain = test_plane_ground(-999.0f, -999.0f);
    bolan_query_surface(&(bolan_water){.sea = sea, .ground = terrain, .level = 1.0}, points, POINTS, answers);
    assert_memory_equal(answers, deep, sizeof deep); // a kilometre is deep for a sea of 2 m
    bolan_ground_destroy(&terrain);

    for (float land = 1.5f; land < 100.0f; land *= 8.0f) {
        terrain = test_plane_ground(land, land);
        bolan_query_surface(&(bolan_water){.sea = sea, .ground = terrain, .level = 1.0}, points, POINTS, answers);
        for (uint32_t i = 0; i < POINTS; i++) {
            assert_true(answers[i].height == 1.0f && answers[i].normal.z == 1.0f && answers[i].jacobian == 1.0f);
        }
        bolan_ground_destroy(&terrain);
    }

    // 1 m of water over a level bed: band c keeps the fraction f_c of its amplitude, so the variance is sum f_c^2
    // var_c. Choppy water gathers at crests, which changes the variance at fixed points by a few percent; 3000 points
    // know theirs to about sqrt(2 / independent waves), some 10 %.
    double expected = 0.0, unattenuated = 0.0;
    float band_hs[BOLAN_MAX_CASCADES], keep[BOLAN_MAX_CASCADES];
    for (uint32_t c = 0; c < bolan_sea_cascade_count(sea); c++)
        band_hs[c] = (float)(4.0 * sqrt(bolan_sea_cascade(sea, c).variance));
    bolan_coast_attenuations(1.0f, band_hs, bolan_sea_cascade_count(sea), keep);
    for (uint32_t c = 0; c < bolan_sea_cascade_count(sea); c++) {
        const bolan_cascade_view v = bolan_sea_cascade(sea, c);
        expected += (double)(keep[c] * keep[c]) * v.variance;
        unattenuated += v.variance;
    }
    assert_true(expected < 0.5 * unattenuated);
    terrain = test_plane_ground(0.0f, 0.0f);
    bolan_query_surface(&(bolan_water){.sea = sea, .ground = terrain, .level = 1.0}, points, POINTS, answers);
    const double ratio = mean_square(answers, 1.0) / mean_square(deep, 1.0) / (expected / unattenuated);
    assert_float_equal(ratio, 1.0, 0.15);
    bolan_ground_destroy(&terrain);
    bolan_sea_destroy(&sea);
}

static void test_a_parcel_over_a_sloping_bed_is_found_where_it_went(void **state) {
    (void)state;
    static bolan_sea_sample parcel[POINTS];
    static bolan_dvec2 moved[POINTS];
    bolan_sea *sea =
        make_sea(10.0, 1.0, 1, BOLAN_CPU_AUTO); // one cascade: one attenuation for all of a parcel's motion
    const float band_hs = (float)(4.0 * sqrt(bolan_sea_cascade(sea, 0).variance));
    bolan_ground *bed = test_plane_ground(-2000.0f, 2000.0f); // rises by 0.4, a shore in the middle
    scatter(points, POINTS);
    bolan_sea_sample_rest(sea, points, POINTS, parcel);
    for (int i = 0; i < POINTS; i++) {
        const float depth = 0.5f - bolan_ground_elevation(bed, points[i].x, points[i].y, 2.0);
        const float keep = bolan_coast_attenuation(depth, band_hs);
        const float lift = (float)bolan_sea_lift(sea, 0, 0.0); // comes of two fields that are attenuated
        parcel[i].height = keep * (parcel[i].height - lift) + keep * keep * lift;
        moved[i] =
            (bolan_dvec2){points[i].x + (double)(keep * parcel[i].dx), points[i].y + (double)(keep * parcel[i].dy)};
    }
    bolan_query_surface(&(bolan_water){.sea = sea, .ground = bed, .level = 0.5}, moved, POINTS, answers);
    for (int i = 0; i < POINTS; i++) {
        if (parcel[i].jacobian < 0.3f) continue;
        assert_true(answers[i].residual < 1e-3f);
        assert_float_equal(answers[i].height, 0.5f + parcel[i].height, 1e-3); // as over deep water
    }
    bolan_ground_destroy(&bed);
    bolan_sea_destroy(&sea);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_parcel_is_found_where_it_went),
        cmocka_unit_test(test_heights_and_surface_agree_to_the_bit),
        cmocka_unit_test(test_the_residual_is_below_a_millimetre_where_the_surface_does_not_fold),
        cmocka_unit_test(test_folded_water_is_finite_and_its_normals_point_up),
        cmocka_unit_test(test_no_parcel_lies_above_the_answer_in_a_fold),
        cmocka_unit_test(test_the_direction_of_compression_is_an_eigenvector),
        cmocka_unit_test(test_a_batch_gives_what_single_questions_give_on_any_number_of_threads),
        cmocka_unit_test(test_instruction_sets_agree_to_the_bit),
        cmocka_unit_test(test_a_tile_away_is_the_same_even_a_thousand_kilometres_off),
        cmocka_unit_test(test_points_that_are_not_finite_give_the_mean_level),
        cmocka_unit_test(test_a_query_allocates_nothing),
        cmocka_unit_test(test_shallow_water_lowers_the_waves_and_land_has_none),
        cmocka_unit_test(test_a_parcel_over_a_sloping_bed_is_found_where_it_went),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

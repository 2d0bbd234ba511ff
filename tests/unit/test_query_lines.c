// SPDX-License-Identifier: MIT
// Rays and crests against the height field itself, by brute force.
#include "sea_support.h"

#include "bolan/query.h"

static bolan_sea *windy(uint32_t cascades) {
    bolan_sea_desc d = bolan_sea_desc_default();
    d.sea_state = bolan_sea_state_from_wind(14.0, 240.0, 200e3);
    d.resolution = 128;
    d.fft.cascade_count = cascades;
    bolan_sea *sea = test_sea(d);
    bolan_sea_step(sea, 20.0);
    return sea;
}

static double over(const bolan_water *water, const bolan_ray *r, double t) {
    const double n =
        sqrt(r->direction.x * r->direction.x + r->direction.y * r->direction.y + r->direction.z * r->direction.z);
    const bolan_dvec2 xy = {r->origin.x + t * r->direction.x / n, r->origin.y + t * r->direction.y / n};
    float h;
    bolan_query_heights(water, &xy, 1, &h);
    return r->origin.z + t * r->direction.z / n - (double)h;
}

// Every centimetre up to 60 m; only crossings by more than 5 mm must be found.
static double brute(const bolan_water *water, const bolan_ray *r) {
    enum { PLACES = 6001 };
    static bolan_dvec2 xy[PLACES];
    static float height[PLACES];
    const double n =
        sqrt(r->direction.x * r->direction.x + r->direction.y * r->direction.y + r->direction.z * r->direction.z);
    for (int i = 0; i < PLACES; i++) {
        const double t = 0.01 * i / n;
        xy[i] = (bolan_dvec2){r->origin.x + t * r->direction.x, r->origin.y + t * r->direction.y};
    }
    bolan_query_heights(water, xy, PLACES, height);
    const bool above = r->origin.z > (double)height[0];
    for (int i = 0; i < PLACES; i++) {
        const double f = r->origin.z + 0.01 * i / n * r->direction.z - (double)height[i];
        if (above ? f < -0.005 : f > 0.005) return 0.01 * i;
    }
    return -1.0;
}

static void a_ray_meets_the_surface_where_brute_force_does(void **state) {
    (void)state;
    bolan_sea *sea = windy(4);
    const bolan_water water = {.sea = sea, .level = 1.5};
    int hits = 0;
    for (int i = 0; i < 40; i++) {
        const double a = 0.7 * i, down = 0.02 + 0.03 * (i % 9);
        const bool under = i % 5 == 4;
        const bolan_ray ray = {.origin = {31.0 * i, -17.0 * i, under ? -6.0 : 7.0},
                               .direction = {3.0 * cos(a), 3.0 * sin(a), under ? 3.0 * down : -3.0 * down},
                               .length = 60.0};
        bolan_ray_hit hit;
        bolan_query_rays(&water, NULL, &ray, 1, &hit);
        const double want = brute(&water, &ray);
        if (want < 0.0) {
            if (hit.hit) assert_true(hit.distance > 59.9 || fabs(over(&water, &ray, hit.distance)) < 1e-3); // grazes
            continue;
        }
        hits++;
        assert_true(hit.hit);
        assert_true(hit.distance <= want);                          // no later than what must be found
        assert_true(fabs(over(&water, &ray, hit.distance)) < 1e-3); // on the surface
        assert_near(hit.point.z, ray.origin.z + hit.distance * ray.direction.z / hypot(3.0, ray.direction.z), 1e-9);
        assert_near(hypot(hit.point.x - ray.origin.x, hit.point.y - ray.origin.y),
                    3.0 / hypot(3.0, ray.direction.z) * hit.distance, 1e-9);
    }
    assert_true(hits > 15);
    bolan_sea_destroy(&sea);
}

// Level rays at the height of crests cut some of them by centimetres.
static void a_ray_that_grazes_a_crest_meets_it(void **state) {
    (void)state;
    bolan_sea *sea = windy(4);
    const bolan_water water = {.sea = sea};
    int hits = 0;
    for (int i = 0; i < 150; i++) {
        const bolan_ray ray = {{77.0 * i, -31.0 * i, 0.6 + 0.01 * (i % 60)}, {cos(1.3 * i), sin(1.3 * i), 0.0}, 60.0};
        bolan_ray_hit hit;
        bolan_query_rays(&water, NULL, &ray, 1, &hit);
        const double want = brute(&water, &ray);
        if (want < 0.0) continue;
        hits++;
        assert_true(hit.hit && hit.distance <= want);
    }
    assert_true(hits > 75);
    bolan_sea_destroy(&sea);
}

static void a_ray_that_goes_away_or_ends_meets_nothing(void **state) {
    (void)state;
    bolan_sea *sea = windy(4);
    const bolan_water water = {.sea = sea};
    const bolan_ray rays[] = {
        {{0.0, 0.0, 30.0}, {0.0, 0.0, 1.0}, 1e6},  {{0.0, 0.0, 30.0}, {0.0, 0.0, -1.0}, 20.0},
        {{0.0, 0.0, 30.0}, {0.0, 0.0, 0.0}, 1e6},  {{(double)NAN, 0.0, 30.0}, {0.0, 0.0, -1.0}, 1e6},
        {{0.0, 0.0, 30.0}, {0.0, 0.0, -1.0}, 1e6}, {{0.0, 0.0, -30.0}, {0.0, 0.0, 5.0}, 1e6},
    };
    bolan_ray_hit hit[6];
    bolan_query_rays(&water, NULL, rays, 6, hit);
    for (int i = 0; i < 4; i++) assert_true(!hit[i].hit && hit[i].distance == 0.0);
    float h;
    bolan_query_heights(&water, &(bolan_dvec2){0.0, 0.0}, 1, &h);
    assert_true(hit[4].hit && hit[5].hit);
    assert_near(hit[4].distance, 30.0 - (double)h, 1e-3);
    assert_near(hit[5].distance, 30.0 + (double)h, 1e-3);
    bolan_sea_destroy(&sea);
}

// Far over the horizon of a scan's blocks: from 10 km up at 45 degrees.
static void a_ray_from_high_up_is_as_exact(void **state) {
    (void)state;
    bolan_sea *sea = windy(4);
    const bolan_water water = {.sea = sea};
    const bolan_ray ray = {{0.0, 0.0, 10000.0}, {1.0, 0.0, -1.0}, 1e6};
    bolan_ray_hit hit;
    bolan_query_rays(&water, NULL, &ray, 1, &hit);
    assert_true(hit.hit);
    assert_true(fabs(over(&water, &ray, hit.distance)) < 1e-3);
    bolan_sea_destroy(&sea);
}

// Along a line of 1000 m to the heading (0.6, 0.8).
static void check_crests(const bolan_water *water, bolan_dvec2 from) {
    enum { MOST = 1000, PLACES = 4001 };
    static bolan_crest crest[MOST];
    static bolan_dvec2 xy[PLACES];
    static float h[PLACES];
    const bolan_dvec2 to = {from.x + 600.0, from.y + 800.0};
    const uint32_t count = bolan_query_crests(water, NULL, from, to, 0.25, MOST, crest);
    uint32_t want = 0;
    for (int i = 0; i < PLACES; i++) xy[i] = (bolan_dvec2){from.x + 0.15 * i, from.y + 0.2 * i};
    bolan_query_heights(water, xy, PLACES, h);
    for (int i = 1; i + 1 < PLACES; i++) {
        if (!(h[i] > h[i - 1] && h[i] >= h[i + 1])) continue;
        assert_true(want < count);
        assert_near(crest[want].distance, 0.25 * i, 0.26);
        assert_true(crest[want].height >= h[i]);
        want++;
    }
    assert_int_equal(count, want);
    assert_true(count > 20);
    for (uint32_t i = 0; i < count; i++) { // nothing higher within a step
        for (int k = -50; k <= 50; k++) {
            const double t = crest[i].distance + 0.005 * k;
            bolan_query_heights(water, &(bolan_dvec2){from.x + 0.6 * t, from.y + 0.8 * t}, 1, h);
            assert_true(h[0] <= crest[i].height + 1e-3f);
        }
    }
    bolan_crest two[2];
    assert_int_equal(bolan_query_crests(water, NULL, from, to, 0.25, 2, two), count);
    assert_true(two[1].distance == crest[1].distance);
}

static void crests_are_the_maxima_of_the_heights(void **state) {
    (void)state;
    bolan_sea *sea = windy(2);
    const bolan_water water = {.sea = sea, .level = -3.0};
    for (int i = 0; i < 8; i++) check_crests(&water, (bolan_dvec2){-100.0 + 211.0 * i, 40.0 - 97.0 * i});
    bolan_sea_destroy(&sea);
}

// A long hull: fewer crests, and lower ones.
static void a_least_wavelength_leaves_the_long_waves(void **state) {
    (void)state;
    enum { MOST = 400 };
    bolan_sea *sea = windy(4);
    bolan_flow *flow = NULL;
    assert_int_equal(bolan_flow_create(sea, &flow), BOLAN_OK);
    const bolan_water water = {.sea = sea, .flow = flow};
    const bolan_question long_waves = {.least_wavelength = 40.0};
    static bolan_crest crest[MOST];
    const bolan_dvec2 from = {0.0, 0.0}, to = {800.0, 500.0};
    const uint32_t all = bolan_query_crests(&water, NULL, from, to, 0.5, MOST, crest);
    const uint32_t few = bolan_query_crests(&water, &long_waves, from, to, 0.5, MOST, crest);
    print_message("%u crests, %u of waves of 40 m and more\n", all, few);
    assert_true(few > 5 && few < all / 2);
    const bolan_ray ray = {{0.0, 0.0, 3.0}, {1.0, 0.0, -0.2}, 200.0};
    bolan_ray_hit hit;
    bolan_query_rays(&water, &long_waves, &ray, 1, &hit);
    bolan_surface_motion m;
    assert_true(hit.hit);
    bolan_query_motion(&water, &long_waves, &(bolan_dvec2){hit.point.x, hit.point.y}, 1, &m);
    assert_near(m.height, hit.point.z, 1e-3);
    bolan_flow_destroy(&flow);
    bolan_sea_destroy(&sea);
}

RUN_TESTS(cmocka_unit_test(a_ray_meets_the_surface_where_brute_force_does),
          cmocka_unit_test(a_ray_that_grazes_a_crest_meets_it),
          cmocka_unit_test(a_ray_that_goes_away_or_ends_meets_nothing),
          cmocka_unit_test(a_ray_from_high_up_is_as_exact), cmocka_unit_test(crests_are_the_maxima_of_the_heights),
          cmocka_unit_test(a_least_wavelength_leaves_the_long_waves))

// SPDX-License-Identifier: MIT
// The generated island: what it promises about heights, shores and depths.
#include "content_support.h"
#include "support.h"

#include "bolan/ground.h"

#include <string.h>

static bolan_ground *create(const bolan_ground_generator *d) {
    bolan_ground *t = NULL;
    assert_int_equal(bolan_content_create_ground(d, &t), BOLAN_OK);
    return t;
}

// Areas in square radii, by elevation; `lee` counts the lagoon's half only, the other the rest.
typedef struct census {
    double land, shallow, lagoon_side, windward_side;
} census;

static census count(const bolan_ground *t, const bolan_ground_generator *d) {
    census c = {0};
    double a = bolan_radians(d->lagoon_from_deg), step = 0.02;
    for (double v = -2.0; v < 2.0; v += step) {
        for (double u = -2.0; u < 2.0; u += step) {
            double x = d->radius * (u * sin(a) - v * cos(a)), y = d->radius * (u * cos(a) + v * sin(a));
            float z = bolan_ground_elevation(t, x, y, step * d->radius);
            c.land += z > 0.0f;
            if (z > -6.0f && z < -1.0f) {
                c.shallow++;
                *(u > 0.0 ? &c.lagoon_side : &c.windward_side) += 1.0;
            }
        }
    }
    c.land *= step * step, c.shallow *= step * step, c.lagoon_side *= step * step, c.windward_side *= step * step;
    return c;
}

static void land_and_lagoon_have_sane_proportions(void **state) {
    (void)state;
    bolan_ground_generator d = generator_named("island");
    for (d.seed = 1; d.seed < 3; d.seed++, d.lagoon_from_deg += 100.0) {
        bolan_ground *t = create(&d);
        census c = count(t, &d);
        assert_true(c.land > 1.0 && c.land < 3.2); // a disc of one radius has 3.1
        assert_true(c.lagoon_side > 0.4 && c.lagoon_side < 2.0);
        assert_true(c.lagoon_side > 3.0 * c.windward_side); // the shallows lie where they were asked for
        bolan_ground_destroy(&t);
    }
}

static void summit_and_sea_floor_are_as_asked(void **state) {
    (void)state;
    const double peaks[] = {40.0, 620.0, 2500.0};
    for (int n = 0; n < 3; n++) {
        bolan_ground_generator d = generator_named("island");
        d.peak = peaks[n];
        d.radius = 2.5 * peaks[n] + 300.0;
        bolan_ground *t = create(&d);
        bolan_ground_extent e = bolan_ground_get_extent(t);
        assert_near(e.highest, d.peak, 1e-3 * d.peak);
        assert_true(e.lowest > d.sea_floor - 30.0);
        for (int k = 0; k < 12; k++) { // beyond three radii there is only the floor
            double a = k * BOLAN_PI / 6.0, r = 3.2 * d.radius;
            assert_near(bolan_ground_elevation(t, r * cos(a), r * sin(a), 0.0), d.sea_floor, 0.06 * -d.sea_floor + 5.0);
        }
        bolan_ground_destroy(&t);
    }
}

static int by_value(const void *a, const void *b) {
    float x = *(const float *)a, y = *(const float *)b;
    return (x > y) - (x < y);
}

static void beaches_slope_gently_through_the_waterline(void **state) {
    (void)state;
    bolan_ground_generator d = generator_named("island");
    bolan_ground *t = create(&d);
    double a = bolan_radians(d.lagoon_from_deg), ux = sin(a), uy = cos(a);
    static float slopes[4000];
    int n = 0;
    for (double v = -0.9; v < 0.9; v += 0.002) {
        for (double u = 0.0; u < 1.1 && n < 4000; u += 0.002) { // outward, to the first waterline
            double x = d.radius * (u * ux - v * uy), y = d.radius * (u * uy + v * ux), s = 4.0;
            if (bolan_ground_elevation(t, x, y, 4.0) < 0.0f && u > 0.0) {
                float dx = bolan_ground_elevation(t, x + s, y, 4.0) - bolan_ground_elevation(t, x - s, y, 4.0);
                float dy = bolan_ground_elevation(t, x, y + s, 4.0) - bolan_ground_elevation(t, x, y - s, 4.0);
                slopes[n++] = sqrtf(dx * dx + dy * dy) / (float)(2.0 * s);
                break;
            }
        }
    }
    assert_true(n > 300);
    qsort(slopes, (size_t)n, sizeof *slopes, by_value);
    // Beaches between rocky headlands: the gentler third of that shore is sand of about 1:15, and some of it is rock.
    assert_true(slopes[n / 6] > 1.0f / 40.0f && slopes[n / 6] < 1.0f / 8.0f);
    assert_true(slopes[n - 1] > 0.25f);
    bolan_ground_destroy(&t);
}

static void the_same_seed_makes_the_same_island(void **state) {
    (void)state;
    bolan_ground_generator d = generator_named("island");
    bolan_ground *a = create(&d);
    bolan_set_threads(3);
    bolan_ground *b = create(&d);
    bolan_set_threads(1);
    assert_true(bolan_ground_id(a) == bolan_ground_id(b));
    bolan_ground_destroy(&b);
    d.seed++;
    b = create(&d);
    assert_true(bolan_ground_id(a) != bolan_ground_id(b));
    bolan_ground_destroy(&b);
    bolan_ground_destroy(&a);
}

// The id covers every node of the island. It stays the same for every compiler, optimisation level and instruction set,
// and changes only when the island's shape is changed on purpose.
static void the_default_island_has_the_same_bits_everywhere(void **state) {
    (void)state;
    bolan_ground_generator d = generator_named("island");
    bolan_ground *t = create(&d);
    assert_true(bolan_ground_id(t) == UINT64_C(0x528067ad5f4f25a8));
    uint64_t h = 0; // of elevations with all their detail
    for (int n = 0; n < 4000; n++) {
        float z = bolan_ground_elevation(t, n * 0.77 - 1500.0, n * 0.53 - 1000.0, n % 5 * 0.7);
        uint32_t bits;
        memcpy(&bits, &z, sizeof bits);
        h = h * 31 + bits;
    }
    assert_true(h == UINT64_C(0x6d42f80706e9998f));
    bolan_ground_destroy(&t);
}

static void wrong_descriptions_are_refused(void **state) {
    (void)state;
    bolan_ground *t;
    bolan_ground_generator d = generator_named("island");
    d.radius = 100.0;
    assert_int_equal(bolan_content_create_ground(&d, &t), BOLAN_ERROR_ARGUMENT);
    d = generator_named("island"), d.sea_floor = 5.0;
    assert_int_equal(bolan_content_create_ground(&d, &t), BOLAN_ERROR_ARGUMENT);
    d = generator_named("island"), d.lagoon_from_deg = NAN;
    assert_int_equal(bolan_content_create_ground(&d, &t), BOLAN_ERROR_ARGUMENT);
    d = generator_named("isle");
    assert_int_equal(bolan_content_create_ground(&d, &t), BOLAN_ERROR_ARGUMENT);
    memset(d.name, 'i', sizeof d.name); // not ended
    assert_int_equal(bolan_content_create_ground(&d, &t), BOLAN_ERROR_ARGUMENT);
    assert_null(t);
    assert_int_equal(bolan_memory_in_use(), 0);
    assert_string_equal(bolan_content_ground_name(0), "island");
    assert_string_equal(bolan_content_ground_name(1), "pond");
    assert_null(bolan_content_ground_name(2));
}

RUN_TESTS(cmocka_unit_test(land_and_lagoon_have_sane_proportions), cmocka_unit_test(summit_and_sea_floor_are_as_asked),
          cmocka_unit_test(beaches_slope_gently_through_the_waterline),
          cmocka_unit_test(the_same_seed_makes_the_same_island),
          cmocka_unit_test(the_default_island_has_the_same_bits_everywhere),
          cmocka_unit_test(wrong_descriptions_are_refused))

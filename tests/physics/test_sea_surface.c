// SPDX-License-Identifier: MIT
// The surface that queries return, measured as an instrument would, against the sea that was asked for.
//
// Finite differences, correlations over distance and time, and the same seed at several resolutions; test_sea_buoys.c
// has the spectrum. The short version is the test; BOLAN_LONG=1 measures every sea at more places and of more seeds;
// BOLAN_ONLY=nothing* runs the tests whose names match.
#include "sea_kinds.h"

#include "bolan/ground.h"
#include "bolan/query.h"

// ---- variance and slopes of one realisation -------------------------------------------------------------------------

enum { POINTS = 1 << 16 };
static bolan_dvec2 place[POINTS];
static bolan_query_point answer[POINTS];
static float height[POINTS], other[POINTS];

// Over places of a square that is many tiles wide, at a few times: the energy of a sea beats by some percent.
static void check_variance(which which_sea, uint32_t n, uint32_t seeds, double tolerance, double slope_tolerance) {
    enum { TIMES = 16, SPOTS = POINTS / TIMES };
    double mean = 0.0, worst = 0.0, spread = 0.0, slopes = 0.0, kurtosis = 0.0;
    for (uint32_t seed = 1; seed <= seeds; seed++) {
        bolan_sea *sea = test_sea(desc_of(which_sea, n, seed));
        double m2 = 0.0, m4 = 0.0, mss = 0.0, asked = 0.0;
        for (int t = 0; t < TIMES; t++) {
            bolan_sea_step(sea, 1211.0 * t);
            for (uint32_t i = 0; i < SPOTS; i++) place[i] = scattered(i + 7919u * (uint32_t)t, 3e5);
            bolan_query_surface(&(bolan_water){.sea = sea}, place, SPOTS, answer);
            for (int i = 0; i < SPOTS; i++) {
                const double h = (double)answer[i].height;
                const bolan_vec3 normal = answer[i].normal;
                m2 += h * h / POINTS, m4 += h * h * h * h / POINTS;
                mss += (double)((normal.x * normal.x + normal.y * normal.y) / (normal.z * normal.z)) / POINTS;
            }
        }
        for (uint32_t c = 0; c < bolan_sea_cascade_count(sea); c++) asked += bolan_sea_cascade(sea, c).mss;
        const double ratio = m2 / m0_of(sea);
        mean += ratio / seeds, spread += ratio * ratio / seeds, slopes += mss / asked / seeds,
            kurtosis += m4 / m2 / m2 / seeds;
        worst = fabs(ratio - 1.0) > fabs(worst) ? ratio - 1.0 : worst;
        bolan_sea_destroy(&sea);
    }
    print_message("%s, N %u: variance / m0 %.4f, sd over %u seeds %.4f, worst %+.4f; slope variance / modes %.4f; "
                  "kurtosis %.3f\n",
                  names[which_sea], n, mean, seeds, sqrt(fmax(spread - mean * mean, 0.0)), worst, slopes, kurtosis);
    assert_near(mean, 1.0, tolerance);
    assert_near(slopes, 1.0, slope_tolerance);
}

// ---- normals --------------------------------------------------------------------------------------------------------

// rms of (normal's slope - finite difference of heights) over the rms slope, at the first `count` places.
static double normal_error(const bolan_water *water, uint32_t count) {
    const bolan_cascade_view last = bolan_sea_cascade(water->sea, bolan_sea_cascade_count(water->sea) - 1);
    const double e = 0.1 / last.k_max; // a sixtieth of the shortest wave
    static bolan_query_point around[4];
    double error = 0.0, slope = 0.0;
    bolan_query_surface(water, place, count, answer);
    for (uint32_t i = 0; i < count; i++) {
        const bolan_dvec2 x = place[i], near[4] = {{x.x + e, x.y}, {x.x - e, x.y}, {x.x, x.y + e}, {x.x, x.y - e}};
        bolan_query_surface(water, near, 4, around);
        if (answer[i].jacobian < 0.3f) continue; // a fold may lie between the points
        const double sx = -(double)(answer[i].normal.x / answer[i].normal.z),
                     sy = -(double)(answer[i].normal.y / answer[i].normal.z),
                     dx = (double)(around[0].height - around[1].height) / (2.0 * e),
                     dy = (double)(around[2].height - around[3].height) / (2.0 * e);
        if (hypot(dx - sx, dy - sy) > 3.0) continue; // the water jumps to another layer of a fold
        error += (dx - sx) * (dx - sx) + (dy - sy) * (dy - sy);
        slope += sx * sx + sy * sy;
    }
    return sqrt(error / slope);
}

static void check_normals(which which_sea, uint32_t n, double choppiness, uint32_t order, double tolerance) {
    bolan_sea_desc d = desc_of(which_sea, n, 3);
    d.choppiness = choppiness;
    d.order = order;
    bolan_sea *sea = test_sea(d);
    bolan_sea_step(sea, 33.0);
    for (uint32_t i = 0; i < 2000; i++) place[i] = scattered(i, 2e3);
    const double error = normal_error(&(bolan_water){.sea = sea}, 2000);
    print_message("%s, N %u, choppiness %g, order %u: normals off by %.4f of the rms slope\n", names[which_sea], n,
                  choppiness, order, error);
    assert_true(error < tolerance);
    bolan_sea_destroy(&sea);
}

// On a beach that rises by `slope` towards east the attenuation leans the water as well.
static void check_beach(double slope, uint32_t order, double tolerance) {
    enum { WIDE = 64 };
    static float grid[WIDE * 2];
    bolan_ground_desc ground = bolan_ground_desc_default();
    for (int i = 0; i < 2 * WIDE; i++) grid[i] = (float)(-20.0 + 40.0 * (i % WIDE) / (WIDE - 1.0));
    const double length = 40.0 / slope; // from 20 m below to 20 m above
    ground.field = (bolan_heightfield){WIDE, 2, 0.0, -1e3, length / (WIDE - 1), 2e3, grid};
    ground.detail = 0.0;
    ground.edge_elevation = -20.0;
    bolan_ground *terrain = NULL;
    assert_int_equal(bolan_ground_create(&ground, &terrain), BOLAN_OK);
    bolan_sea_desc d = desc_of(WIND10, 256, 3);
    d.choppiness = 1.0;
    d.order = order;
    bolan_sea *sea = test_sea(d);
    bolan_sea_step(sea, 33.0);
    for (uint32_t i = 0; i < 2000; i++) { // from 6 to 1 m of depth
        const bolan_dvec2 p = scattered(i, 1.0);
        place[i] = (bolan_dvec2){length * (14.0 + 5.0 * p.x) / 40.0, 1e3 * (p.y - 0.5)};
    }
    const double error = normal_error(&(bolan_water){.sea = sea, .ground = terrain}, 2000);
    print_message("beach 1:%g, order %u: normals off by %.4f of the rms slope\n", 1.0 / slope, order, error);
    bolan_ground_destroy(&terrain);
    bolan_sea_destroy(&sea);
    assert_true(error < tolerance);
}

// ---- repetition -----------------------------------------------------------------------------------------------------

enum { LINE = 4096, PADDED = 2 * LINE };

static double continuous(const bolan_sea_state *state, double rx, double ry, double m0) {
    double sum = 0.0;
    for (int i = 0; i < 400; i++) {
        const double w = 0.2 + 2.3 * (i + 0.5) / 400, k = bolan_k_from_omega(w, state->depth);
        for (int d = 0; d < 90; d++) {
            double s, c;
            const double theta = 2.0 * BOLAN_PI * d / 90;
            bolan_sincos(theta, &s, &c);
            sum += bolan_sea_state_density(state, w, theta) * cos(k * (rx * c + ry * s));
        }
    }
    return sum * 2.3 / 400 * 2.0 * BOLAN_PI / 90 / m0;
}

// Correlation of heights along lines in a direction, over seeds and parallel lines, at lags to 20 km; the most that it
// exceeds that of the spectrum by.
static double excess(which which_sea, double direction, uint32_t seeds, uint32_t lines, double step, double *where) {
    static double sum[LINE];
    static double complex x[PADDED];
    double s, c, worst = -1.0;
    bolan_sincos(direction, &s, &c);
    memset(sum, 0, sizeof sum);
    for (uint32_t seed = 1; seed <= seeds; seed++) {
        bolan_sea *sea = test_sea(desc_of(which_sea, 128, seed));
        for (uint32_t l = 0; l < lines; l++) {
            bolan_sea_step(sea, 500.0 * l);
            const bolan_dvec2 from = scattered(l + 100 * seed, 1e6);
            for (int i = 0; i < LINE; i++) place[i] = (bolan_dvec2){from.x + step * i * c, from.y + step * i * s};
            bolan_query_heights(&(bolan_water){.sea = sea}, place, LINE, height);
            memset(x, 0, sizeof x);
            for (int i = 0; i < LINE; i++) x[i] = (double)height[i];
            fft(x, PADDED);
            for (int i = 0; i < PADDED; i++) x[i] = x[i] * conj(x[i]);
            fft(x, PADDED);
            for (int i = 0; i < LINE; i++) sum[i] += creal(x[i]) / PADDED / (LINE - i);
        }
        bolan_sea_destroy(&sea);
    }
    const bolan_sea_desc d = desc_of(which_sea, 128, 1);
    const double m0 = bolan_sea_state_summary(&d.sea_state).m0;
    for (int i = 1; i < LINE && i * step < 20e3; i++) {
        if (sum[i] / sum[0] < fmax(worst, 0.05)) continue;
        const double more = sum[i] / sum[0] - continuous(&d.sea_state, step * i * c, step * i * s, m0);
        if (more > worst) worst = more, *where = step * i;
    }
    return worst;
}

static void check_repetition(which which_sea, double step, uint32_t seeds, uint32_t lines, double tolerance) {
    bolan_sea *sea = test_sea(desc_of(which_sea, 128, 1));
    const uint32_t tiles = bolan_sea_cascade_count(sea);
    double worst = -1.0, at = 0.0, along = 0.0;
    for (uint32_t t = 0; t < 2 && t < tiles; t++) {
        const double side[] = {0.0, 1.0, 1e9, -1.0, 0.5}; // along the tile's lattice
        for (int i = 0; i < (t == 0 ? 5 : 2); i++) {
            double where = 0.0;
            const double direction = bolan_sea_cascade(sea, t).angle + atan(side[i]);
            const double more = excess(which_sea, direction, seeds, lines, step, &where);
            if (is_long())
                print_message("      along %.1f degrees: %.3f at %.0f m\n", bolan_degrees(direction), more, where);
            if (more > worst) worst = more, at = where, along = direction;
        }
    }
    print_message("%s: correlation exceeds that of the spectrum by %.3f, at %.0f m along %.1f degrees\n",
                  names[which_sea], worst, at, bolan_degrees(along));
    assert_true(worst < tolerance);
    bolan_sea_destroy(&sea);
}

// The correlation of the heights at a point over time is that of the modes' frequencies. `turned`: the sea comes from
// so many degrees farther [degrees], while its tiles lie in steps.
static void check_return(which which_sea, double turned, double tolerance) {
    enum { STEPS = 3600 };
    static double sum[STEPS];
    bolan_sea_desc desc = desc_of(which_sea, 128, 1);
    for (uint32_t i = 0; i < desc.sea_state.system_count; i++) desc.sea_state.systems[i].from_deg += turned;
    bolan_sea *sea = test_sea(desc);
    gather(sea);
    memset(sum, 0, sizeof sum);
    double all = 0.0, fourth = 0.0;
    for (uint32_t i = 0; i < wave_count; i++) all += waves[i].variance;
    for (uint32_t i = 0; i < wave_count; i++) {
        if (waves[i].variance < 1e-6 * all) continue;
        fourth += waves[i].variance * waves[i].variance / all / all;
        const double complex turn1 = cexp(2.0 * I * BOLAN_PI * waves[i].turns);
        double complex at = waves[i].variance / all;
        for (int t = 0; t < STEPS; t++, at *= turn1) sum[t] += creal(at);
    }
    double worst = 0.0;
    int when = 0;
    for (int t = 120; t < STEPS; t++) // the groups of a narrow swell last a minute or two
        if (fabs(sum[t]) > worst) worst = fabs(sum[t]), when = t;
    print_message("%s, turned by %g: at a point the waves return by %.3f after %d s; %.0f waves count\n",
                  names[which_sea], turned, worst, when, 1.0 / fourth);
    assert_true(worst < tolerance);
    bolan_sea_destroy(&sea);
}

// ---- one sea at any quality -----------------------------------------------------------------------------------------

// Correlation of the heights of two resolutions, on a grid that both resolve.
static double likeness(which which_sea, uint32_t n, uint32_t m) {
    bolan_sea *a = test_sea(desc_of(which_sea, n, 5)), *b = test_sea(desc_of(which_sea, m, 5));
    bolan_sea_step(a, 77.0);
    bolan_sea_step(b, 77.0);
    double ab = 0.0, aa = 0.0, bb = 0.0;
    for (uint32_t i = 0; i < POINTS; i++) place[i] = scattered(i, 2e4);
    bolan_query_heights(&(bolan_water){.sea = a}, place, POINTS, height);
    bolan_query_heights(&(bolan_water){.sea = b}, place, POINTS, other);
    for (int i = 0; i < POINTS; i++)
        ab += (double)(height[i] * other[i]), aa += (double)(height[i] * height[i]),
            bb += (double)(other[i] * other[i]);
    bolan_sea_destroy(&a);
    bolan_sea_destroy(&b);
    return ab / sqrt(aa * bb);
}

static void check_quality(which which_sea, double least) {
    const double low = likeness(which_sea, 128, 256), high = likeness(which_sea, 256, 512);
    print_message("%s: correlation of N 128 with 256 %.5f, of 256 with 512 %.5f\n", names[which_sea], low, high);
    assert_true(low > least && high > least);
}

// ---- the tests ------------------------------------------------------------------------------------------------------

static void one_realisation_has_the_height_that_was_asked_for(void **state) {
    (void)state;
    for (int s = 0; s < SEAS; s++) check_variance((which)s, 128, is_long() ? 16 : 2, 0.01, 0.03);
    if (is_long())
        for (uint32_t n = 64; n <= 1024; n *= 2) check_variance(WIND10, n, 2, 0.01, 0.03);
}

static void normals_are_those_of_the_heights(void **state) {
    (void)state;
    for (int s = 0; s < SEAS; s++) check_normals((which)s, s % 2 ? 128 : 256, s % 3 == 2 ? 0.0 : 1.0, 1, 0.02);
    for (int s = WIND5; s <= SWELL14; s++) check_normals((which)s, 128, 1.0, 2, 0.02);
    for (uint32_t order = 1; order <= 2; order++) {
        check_beach(1.0 / 30.0, order, 0.02);
        check_beach(1.0 / 5.0, order, 0.005);
    }
}

static void nothing_repeats_within_sight(void **state) {
    (void)state;
    check_repetition(WIND10, 20.0, is_long() ? 8 : 2, is_long() ? 8 : 4, 0.15);
    check_repetition(SWELL14, 60.0, is_long() ? 8 : 4, 16, 0.15);
    if (is_long()) {
        check_repetition(WIND5, 6.0, 4, 8, 0.15);
        check_repetition(WIND20, 60.0, 4, 16, 0.15);
        check_repetition(NARROW14, 60.0, 8, 32, 0.15);
        check_repetition(OPEN_SEA, 20.0, 4, 16, 0.15);
        check_repetition(SWAN4, 20.0, 4, 16, 0.15);
    }
}

static void nothing_returns_within_an_hour(void **state) {
    (void)state;
    for (int s = 0; s < SEAS; s++) check_return((which)s, 0.0, 0.3);
    check_return(NARROW14, 11.0, 0.3);
    check_return(NARROW14, -11.0, 0.3);
}

static void every_quality_shows_the_same_waves(void **state) {
    (void)state;
    check_quality(WIND10, 0.999);
    check_quality(OPEN_SEA, 0.999);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_realisation_has_the_height_that_was_asked_for),
        cmocka_unit_test(normals_are_those_of_the_heights), cmocka_unit_test(nothing_repeats_within_sight),
        cmocka_unit_test(nothing_returns_within_an_hour), cmocka_unit_test(every_quality_shows_the_same_waves)};
    if (getenv("BOLAN_ONLY")) cmocka_set_test_filter(getenv("BOLAN_ONLY"));
    return cmocka_run_group_tests(tests, open_swan, close_swan);
}

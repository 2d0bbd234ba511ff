// SPDX-License-Identifier: MIT
// Seas of order 2: their third moment, crests and mean level against second-order theory, whose kernels
// test_second_order.c checks, and against Forristall's (2000) fit to his own simulations.
#include "sea_support.h"

#include "bolan/query.h"
#include "waves/cascades/cascades.h"
#include "waves/second_order.h"

#include <string.h>

#define TURN (2.0 * BOLAN_PI)
static double part(double x) { return x - floor(x); }

// ---- the log --------------------------------------------------------------------------------------------------------

static bolan_log_id said;
static int said_count;
static void listen(void *user, bolan_log_level level, bolan_log_id id, const char *sentence) {
    (void)user, (void)level, (void)sentence;
    said = id;
    said_count++;
}
static void start_listening(void) {
    said_count = 0;
    bolan_set_hooks(&(bolan_hooks){.log = listen});
}

// ---- theory ---------------------------------------------------------------------------------------------------------

enum { MOST_WAVES = 1 << 19, PAIRS = 200000 };
static struct wave {
    bolan_dvec2 k;
    double upto; // variance of the waves up to this one
} waves[MOST_WAVES];
static uint32_t wave_count;

static void add_wave(double kx, double ky, double variance) {
    assert_true(wave_count < MOST_WAVES);
    if (!(variance > 0.0)) return;
    waves[wave_count] = (struct wave){{kx, ky}, variance + (wave_count > 0 ? waves[wave_count - 1].upto : 0.0)};
    wave_count++;
}

static void keep_wave(void *context, const sea_mode *m) {
    (void)context;
    add_wave(m->kx, m->ky, m->expected);
    if (m->paired) add_wave(-m->kx, -m->ky, m->expected_back);
}

static uint64_t random_bits = 1;
static double uniform(void) {
    random_bits = random_bits * 6364136223846793005u + 1442695040888963407u;
    return ((double)(random_bits >> 11) + 0.5) * 0x1p-53;
}

// A wave, by its share in the variance.
static const struct wave *draw(void) {
    const double at = uniform() * waves[wave_count - 1].upto;
    uint32_t low = 0, high = wave_count - 1;
    while (low < high) {
        const uint32_t middle = (low + high) / 2;
        if (waves[middle].upto < at) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return &waves[low];
}

// Skewness of a Gaussian sea with all its bound waves, (3/2) sum sum m_i m_j (sum + difference) / m0^1.5, by pairs
// drawn from the very modes of the sea: to 0.0003.
static double skewness_by_theory(const bolan_sea *sea) {
    wave_count = 0;
    bolan_cascades_each_wave(sea->shared, keep_wave, NULL);
    double sum = 0.0;
    for (int i = 0; i < PAIRS; i++) {
        const struct wave *a = draw(), *b = draw();
        const second_order pair = bolan_second_order(a->k, b->k, bolan_sea_get_desc(sea)->sea_state.depth);
        if (a != b) sum += pair.sum + pair.difference;
    }
    return 1.5 * sqrt(waves[wave_count - 1].upto) * sum / PAIRS;
}

// ---- seas -----------------------------------------------------------------------------------------------------------

typedef struct sea_case {
    const char *name;
    double hs, tp, spread; // of a JONSWAP sea; hs 0: wind
    double wind, depth;
} sea_case;

static const sea_case cases[] = {
    {"wind 10 m/s", .wind = 10.0, .depth = BOLAN_DEEP},
    {"wind 20 m/s", .wind = 20.0, .depth = BOLAN_DEEP},
    {"narrow swell", 3.0, 9.0, 75.0, .depth = BOLAN_DEEP},
    {"wind 10 m/s, 15 m deep", .wind = 10.0, .depth = 15.0},
    {"waves of 10 s, 20 m deep", 4.0, 10.0, 15.0, .depth = 20.0},
};
enum { CASES = sizeof cases / sizeof *cases };

static bolan_sea_desc desc_of(const sea_case *c, uint32_t order, uint64_t seed) {
    bolan_sea_desc d = bolan_sea_desc_default();
    d.sea_state = c->wind > 0.0 ? bolan_sea_state_from_wind(c->wind, 250.0, 300e3) : bolan_sea_state_default();
    if (c->hs > 0.0) {
        bolan_wave_system *s = &d.sea_state.systems[d.sea_state.system_count++];
        *s = bolan_wave_system_default();
        s->hs = c->hs;
        s->peak_omega = TURN / c->tp;
        s->spreading = BOLAN_SPREADING_COS2S;
        s->spread_s = c->spread;
    }
    d.sea_state.depth = c->depth;
    d.order = order;
    d.seed = seed;
    d.resolution = 128;
    return d;
}

enum { POINTS = 25000, TIMES = 16 };
static bolan_dvec2 at[POINTS];
static float height[POINTS];

typedef struct moments {
    double mean, sigma, skewness;
} moments;

// At fixed points over many tiles, at times far apart: the energy of a sea, and its bound level with it, beats.
static moments measure(const bolan_sea_desc *desc) {
    double s[4] = {0.0};
    bolan_sea *sea = test_sea(*desc);
    for (int t = 0; t < TIMES; t++) {
        bolan_sea_step(sea, 20.0 + 973.0 * t);
        for (int i = 0; i < POINTS; i++)
            at[i] = (bolan_dvec2){4e4 * part(i * 0.7548776662466927 + 0.37 * t), 4e4 * part(i * 0.5698402909980532)};
        bolan_query_heights(&(bolan_water){.sea = sea}, at, POINTS, height);
        for (int i = 0; i < POINTS; i++) {
            const double h = (double)height[i];
            s[1] += h, s[2] += h * h, s[3] += h * h * h;
        }
    }
    bolan_sea_destroy(&sea);
    const double n = (double)POINTS * TIMES, a = s[1] / n, variance = s[2] / n - a * a;
    return (moments){a, sqrt(variance),
                     (s[3] / n - 3.0 * a * s[2] / n + 2.0 * a * a * a) / (variance * sqrt(variance))};
}

// ---- tests ----------------------------------------------------------------------------------------------------------

// The third moment of the products: 6 p of a cascade with itself, 6 of two of them, each with their variances.
static double skewness_by_weights(const bolan_sea *sea) {
    double third = 0.0, longer = 0.0, all = 0.0;
    for (uint32_t c = 0; c < bolan_sea_cascade_count(sea); c++) {
        const bolan_cascade_view v = bolan_sea_cascade(sea, c);
        third += 6.0 * v.variance * (v.variance * v.bound.height + longer);
        longer += v.variance * v.bound.height_long;
        all += v.variance;
    }
    return third / (all * sqrt(all));
}

static void the_weights_hold_the_third_moment_of_theory(void **state) {
    (void)state;
    for (int i = 0; i < CASES; i++) {
        for (uint32_t cascades = 1; cascades <= BOLAN_MAX_CASCADES; cascades += 3) {
            bolan_sea_desc d = desc_of(&cases[i], 2, 1);
            d.fft.cascade_count = cascades;
            bolan_sea *sea = test_sea(d);
            const double theory = skewness_by_theory(sea), held = skewness_by_weights(sea);
            print_message("%s, %u cascades: skewness %.4f, of theory %.4f\n", cases[i].name, cascades, held, theory);
            assert_near(held / theory, 1.0, 0.015);
            bolan_sea_destroy(&sea);
        }
    }
}

// Records of the same points at both orders have the same scatter; the linear sea's skewness is that scatter.
static void queries_are_as_skew_as_theory_says(void **state) {
    (void)state;
    enum { SEEDS = 3 };
    for (int i = 0; i < CASES; i++) {
        double skewness = 0.0, linear = 0.0, level = 0.0;
        bolan_sea_desc d = desc_of(&cases[i], 2, 1);
        bolan_sea *sea = test_sea(d);
        const double theory = skewness_by_theory(sea);
        bolan_sea_destroy(&sea);
        for (uint64_t seed = 1; seed <= SEEDS; seed++) {
            const bolan_sea_desc one = desc_of(&cases[i], 1, seed), two = desc_of(&cases[i], 2, seed);
            const moments first = measure(&one), second = measure(&two);
            linear += first.skewness / SEEDS;
            skewness += second.skewness / SEEDS;
            assert_near(second.sigma / first.sigma, 1.0, 0.02); // bound waves have the variance of a fourth order
            assert_near(first.mean / (4.0 * first.sigma), 0.0, 0.0016); // 4 standard errors of the mean
            level += (second.mean - first.mean) / (4.0 * first.sigma) / SEEDS;
        }
        print_message("%s: skewness %.3f at order 1, %.3f at order 2, of theory %.3f\n", cases[i].name, linear,
                      skewness, theory);
        assert_near(level, 0.0, 2e-4); // the mean is known to 5e-5
        assert_near(skewness, theory, 0.03);
        assert_near(linear, 0.0, 0.03);
        assert_near(skewness - linear, theory, 0.02);
    }
}

// Forristall (2000), eq. 20 to 23, short-crested: P(crest > z) = exp(-(z / (alpha Hs))^beta).
static double forristall(double hs, double t1, double depth, double probability) {
    const double k1 = bolan_k_from_omega(TURN / t1, depth), s1 = TURN * hs / (9.81 * t1 * t1);
    const double ursell = depth < 1e4 ? hs / (k1 * k1 * depth * depth * depth) : 0.0;
    const double alpha = 0.3536 + 0.2568 * s1 + 0.0800 * ursell;
    const double beta = 2.0 - 1.7912 * s1 - 0.5302 * ursell + 0.284 * ursell * ursell;
    return alpha * hs * pow(-log(probability), 1.0 / beta);
}

static int compare(const void *a, const void *b) {
    const double x = *(const double *)a, y = *(const double *)b;
    return (x < y) - (x > y);
}

enum { BUOYS = 512, STEPS = 1600, MOST_CRESTS = 1 << 18 };
static double crest[MOST_CRESTS];

// Crests between upward crossings of the level, as buoys would see them.
static uint32_t collect(const bolan_sea_desc *desc, double step, uint32_t count) {
    static double before[BUOYS], highest[BUOYS];
    bolan_sea *sea = test_sea(*desc);
    for (int b = 0; b < BUOYS; b++) {
        at[b] = (bolan_dvec2){1e5 * part(b * 0.7548776662466927), 1e5 * part(b * 0.5698402909980532)};
        before[b] = 1.0, highest[b] = -1.0; // not counted before the first crossing
    }
    for (int i = 0; i < STEPS; i++) {
        bolan_sea_step(sea, i * step);
        bolan_query_heights(&(bolan_water){.sea = sea}, at, BUOYS, height);
        for (int b = 0; b < BUOYS; b++) {
            const double here = (double)height[b];
            const bool up = before[b] < 0.0 && here >= 0.0;
            if (up && highest[b] >= 0.0 && count < MOST_CRESTS) crest[count++] = highest[b];
            highest[b] = up ? here : highest[b] < 0.0 ? -1.0 : fmax(highest[b], here);
            before[b] = here;
        }
    }
    bolan_sea_destroy(&sea);
    return count;
}

// Waves of frequencies that Forristall had; every probability has ten crests and more beyond it.
static void check_crests(const sea_case *c) {
    bolan_sea_desc d = desc_of(c, 2, 1);
    d.fft.cascade_count = 2;
    double m0 = 0.0, m1 = 0.0;
    bolan_sea *sea = test_sea(d);
    const double last = bolan_omega_from_k(bolan_sea_cascade(sea, 1).k_max, c->depth);
    bolan_sea_destroy(&sea);
    for (double w = 0.2; w < last; w += 1e-3) {
        const double m = bolan_system_density(&d.sea_state.systems[0], w, c->depth);
        m0 += m * 1e-3, m1 += m * w * 1e-3;
    }
    const uint32_t count = collect(&d, 0.05 * c->tp, 0);
    assert_true(count > 40000);
    qsort(crest, count, sizeof *crest, compare);
    const double hs = 4.0 * sqrt(m0);
    for (double probability = 0.1; probability > 5e-4; probability *= 0.1) {
        const double expected = forristall(hs, TURN * m0 / m1, c->depth, probability),
                     got = crest[(uint32_t)(probability * count)];
        print_message("%s: 1 crest in %.0f of %u higher than %.2f m, Forristall %.2f, Rayleigh %.2f\n", c->name,
                      1.0 / probability, count, got, expected, 0.3536 * hs * sqrt(-log(probability)));
        assert_near(got / expected, 1.0, 0.03);
    }
}

static void crests_are_as_high_as_forristall_found_them(void **state) {
    (void)state;
    static const sea_case steep = {"storm", 8.0, 10.0, 15.0, .depth = BOLAN_DEEP};
    check_crests(&steep);
    check_crests(&cases[4]);
}

// One wave in a cascade, by itself: crest a + k a^2 / 2, trough -a + k a^2 / 2 (Lamb 1932, section 250).
static void a_wave_alone_is_that_of_stokes(void **state) {
    (void)state;
    bolan_sea_desc d = desc_of(&cases[2], 2, 1);
    d.fft.cascade_count = 1;
    d.sea_state.depth = BOLAN_DEEP;
    bolan_sea *sea = test_sea(d);
    sea_cascade *c = &((cascade_tables *)sea->shared->tables)->cascade[0];
    const double k = TURN / c->length * sqrt(20.0 * 20.0 + 5.0 * 5.0), a = 0.1 / k;
    const size_t row = 20, lane = 5;
    memset(c->modes.amplitude, 0, (size_t)c->strips * c->n * 4 * FFT_LANES * sizeof(float));
    memset(c->modes.expected, 0, (size_t)c->strips * c->n * 2 * FFT_LANES * sizeof(float));
    memset(c->parts.amplitude, 0, (SEA_PARTS - 1) * SEA_PART_ROWS * 4 * FFT_LANES * sizeof(float));
    memset(c->parts.expected, 0, (SEA_PARTS - 1) * SEA_PART_ROWS * 2 * FFT_LANES * sizeof(float));
    c->modes.amplitude[row * 4 * FFT_LANES + lane] = (float)(0.5 * a);
    c->modes.amplitude[row * 4 * FFT_LANES + 3 * FFT_LANES + lane] = (float)(-0.5 * a);
    c->modes.expected[row * 2 * FFT_LANES + lane] = (float)(0.5 * a * a);
    sea_lift *lift = &sea->shared->band[0].lift;
    memset(lift, 0, sizeof *lift);
    bolan_cascades_bound(sea->shared);
    assert_true(bolan_cascade_lift(c, 1.0, &sea->shared->bound[0]));
    sea->shared->lift = lift->level[0];
    sea->stepped = false; // the fields at time 0 are of the modes before
    bolan_sea_step(sea, 0.0);
    const bolan_cascade_view v = bolan_sea_cascade(sea, 0);
    assert_near(v.bound.height / (0.5 * k), 1.0, 0.01);
    assert_near(v.bound.drift / (0.5 * k), 1.0, 0.01);
    double top = 0.0, bottom = 0.0, sum = 0.0;
    sea->shared->warp.count = 0;
    enum { SIDE = 211 }; // a lattice whose mean is that of the tile
    for (int i = 0; i < SIDE * SIDE; i++) {
        const double x = v.length * (i % SIDE) / SIDE, y = v.length * (i / SIDE) / SIDE;
        const bolan_dvec2 p = {x * cos(v.angle) - y * sin(v.angle), x * sin(v.angle) + y * cos(v.angle)};
        bolan_sea_sample s;
        bolan_sea_sample_rest(sea, &p, 1, &s);
        top = fmax(top, (double)s.height), bottom = fmin(bottom, (double)s.height);
        sum += (double)(s.height * s.jacobian) / (SIDE * SIDE);
    }
    print_message("crest %.5f, trough %.5f, mean %.6f of the amplitude\n", top / a, bottom / a, sum / a);
    assert_near((top + bottom) / (k * a * a), 1.0, 0.02);
    assert_near((top - bottom) / (2.0 * a), 1.0, 0.01);
    assert_near(sum / a, 0.0, 1e-5);
    bolan_sea_destroy(&sea);
}

// The mean of one tile over a lattice, where parcels count by the area that they cover, is known without scatter. What
// is left is of fourth order.
static void the_mean_level_stays(void **state) {
    (void)state;
    enum { SIDE = 701 };
    for (int i = 0; i < CASES; i++) {
        bolan_sea_desc d = desc_of(&cases[i], 2, 1);
        d.waves = BOLAN_WAVES_TEXTURES;
        bolan_sea *sea = test_sea(d);
        const bolan_cascade_view v = bolan_sea_cascade(sea, 0);
        double sum = 0.0;
        for (int p = 0; p < SIDE * SIDE; p++) {
            const double x = v.length * (p % SIDE) / SIDE, y = v.length * (p / SIDE) / SIDE;
            const bolan_dvec2 at_rest = {x * cos(v.angle) - y * sin(v.angle), x * sin(v.angle) + y * cos(v.angle)};
            bolan_sea_sample s;
            bolan_sea_sample_rest(sea, &at_rest, 1, &s);
            sum += (double)(s.height * s.jacobian) / (SIDE * SIDE);
        }
        const double hs = bolan_sea_get_summary(sea)->hs;
        print_message("%s, one tile: the mean is %.1e of Hs\n", cases[i].name, sum / hs);
        assert_near(sum / hs, 0.0, 1e-4);
        bolan_sea_destroy(&sea);
    }
}

static void samples_grids_and_modes_agree(void **state) {
    (void)state;
    const bolan_sea_desc d = desc_of(&cases[3], 2, 5);
    bolan_sea *sea = test_sea(d);
    bolan_sea_step(sea, 7.0);
    double error = 0.0, slopes = 0.0, bound = 0.0, bound_slopes = 0.0;
    bolan_sea_desc flat = d;
    flat.order = 1;
    bolan_sea *linear = test_sea(flat);
    bolan_sea_step(linear, 7.0);
    enum { PLACES = 60 };
    for (int i = 0; i < PLACES; i++) {
        const bolan_dvec2 p = {3e3 * part(i * 0.7548776662466927), 3e3 * part(i * 0.5698402909980532)};
        bolan_sea_sample rest, grid, first;
        bolan_sea_sample_rest(sea, &p, 1, &rest);
        bolan_sea_sample_grid(sea, &p, NULL, 1, &grid);
        bolan_sea_sample_rest(linear, &p, 1, &first);
        assert_memory_equal(&rest, &grid, sizeof rest);
        const bolan_sea_sample direct = bolan_sea_sample_direct(sea, p.x, p.y, 7.0),
                               plain = bolan_sea_sample_direct(linear, p.x, p.y, 7.0);
        const double raised = (double)(rest.height - first.height), sx = (double)(rest.slope_x - first.slope_x),
                     sy = (double)(rest.slope_y - first.slope_y);
        error += pow(raised - (double)(direct.height - plain.height), 2.0);
        slopes += pow(sx - (double)(direct.slope_x - plain.slope_x), 2.0) +
                  pow(sy - (double)(direct.slope_y - plain.slope_y), 2.0);
        bound += raised * raised;
        bound_slopes += sx * sx + sy * sy;
    }
    print_message("bound waves: heights off by %.4f of their rms, slopes by %.4f\n", sqrt(error / bound),
                  sqrt(slopes / bound_slopes));
    assert_true(sqrt(bound / PLACES) > 0.03 * 0.25 * bolan_sea_get_summary(sea)->hs);
    assert_true(error < pow(0.03, 2.0) * bound); // images of the splines, as of the waves themselves (spline.h)
    assert_true(slopes < pow(0.06, 2.0) * bound_slopes);
    bolan_sea_destroy(&sea);
    bolan_sea_destroy(&linear);
}

// The kernels of queries, in float, have heights and slopes of the samples, in double.
static void queries_and_samples_agree(void **state) {
    (void)state;
    bolan_sea *sea = test_sea(desc_of(&cases[3], 2, 5));
    bolan_sea_step(sea, 7.0);
    for (int i = 0; i < 300; i++) {
        const bolan_dvec2 p = {3e3 * part(i * 0.7548776662466927), 3e3 * part(i * 0.5698402909980532)};
        bolan_sea_sample s;
        bolan_query_point q;
        bolan_sea_sample_rest(sea, &p, 1, &s);
        bolan_query_surface(&(bolan_water){.sea = sea}, &(bolan_dvec2){p.x + (double)s.dx, p.y + (double)s.dy}, 1, &q);
        if (s.jacobian < 0.5f) continue; // near a fold another parcel may be higher
        assert_near(q.height, s.height, 1e-4);
        assert_near(-q.normal.x / q.normal.z, s.slope_x, 1e-3);
        assert_near(-q.normal.y / q.normal.z, s.slope_y, 1e-3);
    }
    bolan_sea_destroy(&sea);
}

// In water this shallow the expansion fails: bound waves are lowered, and the log says so once.
static void waves_too_high_for_their_depth_have_lower_bound_waves(void **state) {
    (void)state;
    static const sea_case shallow = {"surf", 2.0, 14.0, 20.0, .depth = 4.0};
    const bolan_sea_desc d = desc_of(&shallow, 2, 1);
    start_listening();
    bolan_sea *sea = test_sea(d);
    bolan_set_hooks(NULL);
    assert_int_equal(said_count, 1);
    assert_int_equal(said, BOLAN_LOG_SEA_BOUND_LIMITED);
    assert_true(skewness_by_weights(sea) < 0.7 && skewness_by_theory(sea) > 1.0);
    bolan_sea_destroy(&sea);
}

static void sums_have_order_one_alone(void **state) {
    (void)state;
    bolan_sea_desc d = desc_of(&cases[0], 2, 1);
    for (int model = BOLAN_WAVES_COSINES; model <= BOLAN_WAVES_EXP_COSINE; model++) {
        d.waves = (bolan_wave_model)model;
        start_listening();
        bolan_sea *sea = test_sea(d);
        bolan_set_hooks(NULL);
        assert_int_equal(said_count, 1);
        assert_int_equal(said, BOLAN_LOG_SEA_ORDER);
        assert_int_equal(bolan_sea_get_desc(sea)->order, 1);
        bolan_sea_destroy(&sea);
    }
}

RUN_TESTS(cmocka_unit_test(the_weights_hold_the_third_moment_of_theory),
          cmocka_unit_test(queries_are_as_skew_as_theory_says),
          cmocka_unit_test(crests_are_as_high_as_forristall_found_them),
          cmocka_unit_test(a_wave_alone_is_that_of_stokes), cmocka_unit_test(samples_grids_and_modes_agree),
          cmocka_unit_test(queries_and_samples_agree), cmocka_unit_test(the_mean_level_stays),
          cmocka_unit_test(waves_too_high_for_their_depth_have_lower_bound_waves),
          cmocka_unit_test(sums_have_order_one_alone))

// SPDX-License-Identifier: MIT
// The sea far from the origin and long after time 0: the same sum of waves, in long double and by the dispersion
// relation itself; continuous, of the same variance, with the same foam.
#include "sea_support.h"

#include "bolan/query.h"
#include "waves/cascades/cascades.h"

// ---- the sum over every mode ----------------------------------------------------------------------------------------

enum { MOST_MODES = 1 << 16 };

typedef struct wave {
    long double kx, ky, omega, re, im;
} wave;

static wave waves[MOST_MODES];
static uint32_t wave_count;
static double water_depth;

static void add_wave(double kx, double ky, double omega, double re, double im) {
    if (re == 0.0 && im == 0.0) return;
    assert_true(wave_count < MOST_MODES);
    waves[wave_count++] = (wave){kx, ky, omega, re, im};
}

// A mode is h0(k) e^{i (k.x - w t)} with its conjugate, and conj(h0(-k)) e^{i (k.x + w t)} with its own. Where a cell
// of the lattice is divided among several waves, each has a frequency from within the cell.
static void keep_mode(void *context, const sea_mode *m) {
    const sea_cascade *c = context;
    const double k = hypot(m->kx, m->ky), dk = 2.0 * BOLAN_PI / c->length, exact = bolan_omega_from_k(k, water_depth);
    const double i = fabs(m->kx * c->cosine + m->ky * c->sine) / dk, j = fabs(m->ky * c->cosine - m->kx * c->sine) / dk;
    double omega = exact;
    if (fmax(i, j) < SEA_PART_REACH - 0.5) {
        omega = 2.0 * BOLAN_PI * m->turns;
        assert_true(omega > bolan_omega_from_k(fmax(k - 0.7072 * dk, 0.0), water_depth) * (1.0 - 1e-9));
        assert_true(omega < bolan_omega_from_k(k + 0.7072 * dk, water_depth));
    }
    add_wave(m->kx, m->ky, omega, 2.0 * m->re, 2.0 * m->im);
    if (m->paired) add_wave(-m->kx, -m->ky, omega, 2.0 * m->back_re, -2.0 * m->back_im);
}

static void gather_waves(const bolan_sea *sea) {
    wave_count = 0;
    water_depth = bolan_sea_get_desc(sea)->sea_state.depth;
    for (uint32_t i = 0; i < bolan_sea_cascade_count(sea); i++) {
        const sea_cascade *c = &cascade_tables_of(sea->shared)->cascade[i];
        bolan_sea_each_mode(c, keep_mode, (void *)c);
    }
    for (uint32_t i = 0; i < bolan_sea_component_count(sea); i++) {
        const bolan_sea_component c = bolan_sea_get_component(sea, i);
        add_wave(c.kx, c.ky, bolan_omega_from_k(hypot(c.kx, c.ky), water_depth), c.amplitude * cos(c.phase),
                 c.amplitude * sin(c.phase));
    }
    assert_true(wave_count > 100);
}

// Without choppiness, so that the rest point is the point itself. On a current the water has drifted by U t since time
// 0, at which `start`, a fork, stands.
static double sum_of_waves(const bolan_sea *start, bolan_dvec2 at, double time) {
    const bolan_sea_state *state = &bolan_sea_get_desc(start)->sea_state;
    double gradient[4];
    bolan_dvec2 read = {at.x - state->current_x * time, at.y - state->current_y * time};
    if (bolan_sea_form(start) == BOLAN_FORM_CASCADES) read = bolan_sea_place_read(start, read.x, read.y, gradient);
    const long double x = read.x, y = read.y;
    long double sum = 0.0L;
    for (uint32_t i = 0; i < wave_count; i++) {
        const wave *w = &waves[i];
        const long double phase = remainderl(w->kx * x + w->ky * y - w->omega * time, 2.0L * 3.14159265358979323846L);
        sum += w->re * cosl(phase) - w->im * sinl(phase);
    }
    return (double)sum;
}

static bolan_sea *sea_of_wind(bolan_wave_model model, double depth, double current) {
    bolan_sea_desc d = bolan_sea_desc_default();
    d.waves = model;
    d.sea_state = bolan_sea_state_from_wind(9.0, 240.0, 200e3);
    d.sea_state.depth = depth;
    d.sea_state.current_x = current, d.sea_state.current_y = -0.5 * current;
    d.resolution = 128;
    d.choppiness = 0.0;
    return test_sea(d);
}

// ---- heights --------------------------------------------------------------------------------------------------------

enum { PLACES = 32 };

// Error of queried heights against the sum, over the standard deviation.
static double error_at(bolan_sea *sea, const bolan_sea *start, double far, double time) {
    bolan_dvec2 at[PLACES];
    float height[PLACES];
    double error = 0.0;
    for (int i = 0; i < PLACES; i++) at[i] = (bolan_dvec2){far + 37.31 * i, 17.77 * i * i - 0.7 * far};
    bolan_sea_step(sea, time);
    bolan_query_heights(&(bolan_water){.sea = sea}, at, PLACES, height);
    for (int i = 0; i < PLACES; i++) error += pow((double)height[i] - sum_of_waves(start, at[i], time), 2.0);
    return sqrt(error / PLACES / bolan_sea_get_summary(sea)->m0);
}

static void heights_are_the_sum_of_waves_of_the_dispersion_relation(void **state) {
    (void)state;
    static const struct {
        bolan_wave_model model;
        double depth, current, tolerance;
    } seas[] = {{BOLAN_WAVES_FFT, BOLAN_DEEP, 0.0, 0.015},
                {BOLAN_WAVES_FFT, 8.0, 0.0, 0.015},
                {BOLAN_WAVES_FFT, 30.0, 1.3, 0.015},
                {BOLAN_WAVES_COSINES, 20.0, 0.0, 1e-4}};
    static const double far[] = {0.0, 1e6, -1e8, 1e8}, times[] = {0.0, 60.0, 1e9, -1e9};
    for (size_t s = 0; s < sizeof seas / sizeof *seas; s++) {
        bolan_sea *sea = sea_of_wind(seas[s].model, seas[s].depth, seas[s].current), *start = NULL;
        assert_int_equal(bolan_sea_fork(sea, &start), BOLAN_OK);
        gather_waves(sea);
        for (int i = 0; i < 4; i++) {
            const double error = error_at(sea, start, far[i], times[i]);
            const double crossed = error_at(sea, start, far[i], times[3 - i]);
            print_message("%s, depth %g m, %g m away: %.2g at %g s, %.2g at %g s\n",
                          bolan_wave_model_names[seas[s].model], seas[s].depth, far[i], error, times[i], crossed,
                          times[3 - i]);
            assert_true(error < seas[s].tolerance && crossed < seas[s].tolerance);
        }
        bolan_sea_destroy(&start);
        bolan_sea_destroy(&sea);
    }
}

// ---- continuity and variance ----------------------------------------------------------------------------------------

enum { MANY = 4096 };
static bolan_dvec2 place[MANY], beside[MANY];
static float height[MANY], before[MANY], after[MANY];
static bolan_query_point point[MANY];
static bolan_surface_motion motion[MANY];

static void scatter(double far, double side) {
    for (int i = 0; i < MANY; i++) {
        const double x = i * 0.7548776662466927, y = i * 0.5698402909980532;
        place[i] = (bolan_dvec2){far + side * (x - floor(x)), -far + side * (y - floor(y))};
    }
}

#define APART 0.005  // [m]
#define LATER 0.0125 // [s]
static void the_surface_is_continuous_in_place_and_time(void **state) {
    (void)state;
    const double now = 1e9 + 0.3;
    bolan_sea *sea = sea_of_wind(BOLAN_WAVES_FFT, BOLAN_DEEP, 0.0);
    bolan_flow *flow = NULL;
    scatter(1e8, 1e4);
    bolan_sea_step(sea, now);
    assert_int_equal(bolan_flow_create(sea, &flow), BOLAN_OK);
    const bolan_water water = {.sea = sea, .flow = flow};
    bolan_query_surface(&water, place, MANY, point);
    bolan_query_motion(&water, NULL, place, MANY, motion);
    double slope = 0.0, slope_error = 0.0, rise = 0.0, rise_error = 0.0, step = 0.0;
    for (int axis = 0; axis < 2; axis++) {
        for (int i = 0; i < MANY; i++)
            beside[i] = (bolan_dvec2){place[i].x + (axis ? 0.0 : APART), place[i].y + (axis ? APART : 0.0)};
        bolan_query_heights(&water, beside, MANY, after);
        for (int i = 0; i < MANY; i++)
            beside[i] = (bolan_dvec2){place[i].x - (axis ? 0.0 : APART), place[i].y - (axis ? APART : 0.0)};
        bolan_query_heights(&water, beside, MANY, before);
        for (int i = 0; i < MANY; i++) {
            const bolan_vec3 n = point[i].normal;
            const double s = (double)(-(axis ? n.y : n.x) / n.z), d = (double)(after[i] - before[i]) / (2.0 * APART);
            slope += s * s, slope_error += (s - d) * (s - d);
            step = fmax(step, fabs((double)(after[i] - before[i])));
        }
    }
    for (int side = -1; side <= 1; side += 2) {
        bolan_sea_step(sea, now + side * LATER);
        bolan_query_heights(&(bolan_water){.sea = sea}, place, MANY, side < 0 ? before : after);
    }
    for (int i = 0; i < MANY; i++) {
        const double r = (double)motion[i].rise, d = (double)(after[i] - before[i]) / (2.0 * LATER);
        rise += r * r, rise_error += (r - d) * (r - d);
        step = fmax(step, fabs((double)(after[i] - before[i])));
    }
    print_message("error of the slope %.4f, of the rise %.4f of their rms; largest step %.3f m\n",
                  sqrt(slope_error / slope), sqrt(rise_error / rise), step);
    assert_true(slope_error < 0.02 * 0.02 * slope);
    assert_true(rise_error < 0.03 * 0.03 * rise);
    assert_true(step < 0.1); // 25 ms at 4 m/s
    bolan_flow_destroy(&flow);
    bolan_sea_destroy(&sea);
}

static double variance_at(bolan_sea *sea, double far, double time) {
    double sum = 0.0;
    scatter(far, 1e5);
    for (int t = 0; t < 16; t++) {
        bolan_sea_step(sea, time + 13.7 * t);
        bolan_query_heights(&(bolan_water){.sea = sea}, place, MANY, height);
        for (int i = 0; i < MANY; i++) sum += (double)height[i] * (double)height[i];
    }
    return sum / (16.0 * MANY) / bolan_sea_get_summary(sea)->m0;
}

static void the_variance_stays(void **state) {
    (void)state;
    bolan_sea *sea = sea_of_wind(BOLAN_WAVES_FFT, BOLAN_DEEP, 0.0);
    const double here = variance_at(sea, 0.0, 0.0), far = variance_at(sea, 1e8, 1e9);
    const double past = variance_at(sea, 1e8, -1e9);
    print_message("variance over the request: %.4f here, %.4f far away, %.4f long ago\n", here, far, past);
    assert_near(here, 1.0, 0.03); // sampling
    assert_near(far, 1.0, 0.03);
    assert_near(past, 1.0, 0.03);
    bolan_sea_destroy(&sea);
}

// Foam remembers by ticks, whose numbers are of the size of the time.
static void foam_is_a_function_of_time_after_thirty_years(void **state) {
    (void)state;
    bolan_sea_desc d = bolan_sea_desc_default();
    d.resolution = 64;
    d.foam_decay = 1.0;
    bolan_sea *alone = test_sea(d), *run = test_sea(d);
    for (int sign = -1; sign <= 1; sign += 2) {
        bolan_sea_settle(alone, sign * 1e9 + 0.1);
        bolan_sea_settle(run, sign * 1e9 - 3.9);
        for (int i = 1; i <= 8; i++) bolan_sea_step(run, sign * 1e9 - 3.9 + 0.5 * i);
        assert_true(bolan_sea_time(alone) == bolan_sea_time(run));
        char hashes[2][17];
        bolan_sea_hash(alone, hashes[0]), bolan_sea_hash(run, hashes[1]);
        assert_string_equal(hashes[0], hashes[1]);
    }
    bolan_sea_destroy(&alone);
    bolan_sea_destroy(&run);
}

RUN_TESTS(cmocka_unit_test(heights_are_the_sum_of_waves_of_the_dispersion_relation),
          cmocka_unit_test(the_surface_is_continuous_in_place_and_time), cmocka_unit_test(the_variance_stays),
          cmocka_unit_test(foam_is_a_function_of_time_after_thirty_years))

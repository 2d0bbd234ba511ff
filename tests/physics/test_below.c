// SPDX-License-Identifier: MIT
// The moving water against linear theory: a single wave in closed form (Dean & Dalrymple 1991, table 3.1), random seas
// against the sum over every mode, and the surface against differences in time.
#include "sea_support.h"

#include "bolan/query.h"

#include "waves/model.h"

#include <stdlib.h>
#include <string.h>

typedef struct answer {
    double v[3], a[3], p;
} answer;

static answer answer_of(const bolan_kinematics *k) {
    return (answer){{(double)k->velocity.x, (double)k->velocity.y, (double)k->velocity.z},
                    {(double)k->acceleration.x, (double)k->acceleration.y, (double)k->acceleration.z},
                    (double)k->pressure / BOLAN_SEA_WATER_DENSITY};
}

static bolan_flow *test_flow(const bolan_sea *sea) {
    bolan_flow *flow = NULL;
    assert_int_equal(bolan_flow_create(sea, &flow), BOLAN_OK);
    return flow;
}

// ---- the sum over every mode ----------------------------------------------------------------------------------------

// Displacement, velocity, acceleration and pressure over density at a rest point, from the modes' own numbers.
typedef struct truth {
    double x, y, below, depth, time;
    double least_wavelength;
    double dx, dy, height;
    answer at;
} truth;

static void add_mode(void *context, const sea_mode *m) {
    truth *t = context;
    const double k = hypot(m->kx, m->ky), omega = 2.0 * BOLAN_PI * m->turns, twice = m->paired ? 2.0 : 1.0;
    const double sinh_kh = k * t->depth < 300.0 ? sinh(k * t->depth) : INFINITY;
    // The filter as query.h has it: e^{-kl}, l = 0.29258 of the wavelength.
    const double left = 1.0 - pow(1.0 - exp(-k * 0.29258 * t->least_wavelength), 4.0);
    const double kept = t->least_wavelength > 0.0 ? left : 1.0;
    const double across = isinf(sinh_kh) ? exp(-k * t->below) : cosh(k * (t->depth - t->below)) / sinh_kh;
    const double up = isinf(sinh_kh) ? exp(-k * t->below) : sinh(k * (t->depth - t->below)) / sinh_kh;
    const double phase = m->kx * t->x + m->ky * t->y, forth = phase - omega * t->time, back = phase + omega * t->time;
    // Both waves of the mode: Re h e^{ik.x}, its quadrature, and those of dh/dt.
    const double energy = kept * twice;
    const double re =
        energy * (m->re * cos(forth) - m->im * sin(forth) + m->back_re * cos(back) - m->back_im * sin(back));
    const double im =
        energy * (m->re * sin(forth) + m->im * cos(forth) + m->back_re * sin(back) + m->back_im * cos(back));
    const double rate_re =
        energy * omega * (m->re * sin(forth) + m->im * cos(forth) - m->back_re * sin(back) - m->back_im * cos(back));
    const double rate_im =
        energy * omega * (-m->re * cos(forth) + m->im * sin(forth) + m->back_re * cos(back) - m->back_im * sin(back));
    const double ux = m->kx / k, uy = m->ky / k, o2 = omega * omega;
    t->dx -= ux * across * im;
    t->dy -= uy * across * im;
    t->height += up * re;
    t->at.v[0] -= ux * across * rate_im;
    t->at.v[1] -= uy * across * rate_im;
    t->at.v[2] += up * rate_re;
    t->at.a[0] += o2 * ux * across * im;
    t->at.a[1] += o2 * uy * across * im;
    t->at.a[2] -= o2 * up * re;
    t->at.p += o2 / k * across * re;
}

static truth sum_all(const bolan_sea *sea, double x, double y, double below, double least_wavelength) {
    double gradient[4];
    const bolan_dvec2 read = bolan_sea_place_read(sea, x, y, gradient);
    truth t = {.x = read.x,
               .y = read.y,
               .below = below,
               .least_wavelength = least_wavelength,
               .depth = bolan_sea_get_desc(sea)->sea_state.depth};
    t.time = sea->shared->model->shown_time(sea->shared, bolan_sea_time(sea), NULL);
    sea->shared->model->each_wave(sea->shared, add_mode, &t);
    return t;
}

// The parcel over (x, y).
static truth invert(const bolan_sea *sea, double x, double y, double below, double least_wavelength) {
    const double choppiness = bolan_sea_get_desc(sea)->choppiness;
    double rx = x, ry = y;
    truth t = {0};
    for (int i = 0; i < 40; i++) {
        t = sum_all(sea, rx, ry, below, least_wavelength);
        const double ex = rx + choppiness * t.dx - x, ey = ry + choppiness * t.dy - y;
        if (hypot(ex, ey) < 1e-4) break;
        rx -= ex, ry -= ey;
    }
    return t;
}

enum { PLACES = 24, DEPTHS = 5 };
static const double depths[DEPTHS] = {0.0, 1.0, 5.0, 20.0, 50.0};

static double square(double x) { return x * x; }

// Root mean square errors and values: velocity, acceleration, pressure over density.
typedef struct errors {
    double error[3], value[3];
    int used;
} errors;

static void add_error(errors *e, const answer *got, const answer *want) {
    for (int c = 0; c < 3; c++) {
        e->error[0] += square(got->v[c] - want->v[c]), e->value[0] += square(want->v[c]);
        e->error[1] += square(got->a[c] - want->a[c]), e->value[1] += square(want->a[c]);
    }
    e->error[2] += square(got->p - want->p), e->value[2] += square(want->p);
    e->used++;
}

static errors errors_at(const bolan_water *water, double depth, double least_wavelength) {
    const bolan_question question = {.least_wavelength = least_wavelength};
    errors e = {0};
    for (int i = 0; i < PLACES; i++) {
        const bolan_dvec3 at = {211.7 * i - 900.0, 173.9 * (i % 5) + 31.0 * i, -depth};
        bolan_kinematics k;
        bolan_query_below(water, &question, &at, 1, &k);
        if (!k.wet) continue; // in a trough
        const truth t = invert(water->sea, at.x, at.y, depth, least_wavelength);
        const answer got = answer_of(&k);
        add_error(&e, &got, &t.at);
    }
    assert_true(e.used > PLACES / 4);
    for (int q = 0; q < 3; q++) e.value[q] = sqrt(e.value[q] / e.used), e.error[q] = sqrt(e.error[q] / e.used);
    return e;
}

// flow.h: 1 % of the values at the surface, at every depth.
static void check_sea(bolan_sea_desc desc, const char *name) {
    bolan_sea *sea = test_sea(desc);
    bolan_sea_step(sea, 37.3);
    bolan_flow *flow = test_flow(sea);
    const bolan_water water = {.sea = sea, .flow = flow};
    errors surface = {0};
    for (int d = 0; d < DEPTHS; d++) {
        if (depths[d] > desc.sea_state.depth) continue;
        const errors e = errors_at(&water, depths[d], 0.0);
        if (d == 0) surface = e;
        print_message("%s, %2.0f m, %2d places: velocity %.4f m/s error %.3f %%; acceleration %.4f m/s2 error %.3f %%; "
                      "pressure / density %.4f error %.3f %% of the surface\n",
                      name, depths[d], e.used, e.value[0], 100.0 * e.error[0] / surface.value[0], e.value[1],
                      100.0 * e.error[1] / surface.value[1], e.value[2], 100.0 * e.error[2] / surface.value[2]);
        for (int q = 0; q < 3; q++) assert_true(e.error[q] < 0.01 * surface.value[q]);
    }
    bolan_flow_destroy(&flow);
    bolan_sea_destroy(&sea);
}

static bolan_sea_desc wind_desc(void) {
    bolan_sea_desc d = bolan_sea_desc_default();
    d.sea_state = bolan_sea_state_from_wind(12.0, 200.0, 200e3);
    d.resolution = 128;
    return d;
}

static bolan_sea_desc mixed_desc(void) {
    bolan_sea_desc d = bolan_sea_desc_default();
    d.sea_state = bolan_sea_state_from_wind(8.0, 20.0, 100e3);
    assert_int_equal(bolan_sea_state_add_swell(&d.sea_state, 2.0, 14.0, 290.0, 75.0), BOLAN_OK);
    d.resolution = 128;
    return d;
}

static void below_is_the_sum_over_every_mode(void **state) {
    (void)state;
    check_sea(wind_desc(), "wind sea");
    check_sea(mixed_desc(), "mixed sea");
    bolan_sea_desc d = wind_desc();
    d.choppiness = 0.0;
    check_sea(d, "choppiness 0");
    d = mixed_desc();
    d.resolution = 64;
    check_sea(d, "64 samples");
    d = wind_desc();
    d.waves = BOLAN_WAVES_TEXTURES;
    check_sea(d, "textures");
}

static void below_is_the_sum_over_every_mode_in_finite_depth(void **state) {
    (void)state;
    bolan_sea_desc d = wind_desc();
    d.sea_state.depth = 30.0;
    check_sea(d, "30 m of water");
    d = mixed_desc();
    d.sea_state.depth = 8.0;
    check_sea(d, "8 m of water");
}

static void a_least_wavelength_is_its_filter_on_every_mode(void **state) {
    (void)state;
    static const double lengths[] = {0.5, 5.0, 40.0, 200.0};
    bolan_sea_desc d[2] = {wind_desc(), mixed_desc()};
    d[1].sea_state.depth = 25.0;
    for (int s = 0; s < 2; s++) {
        bolan_sea *sea = test_sea(d[s]);
        bolan_flow *flow = test_flow(sea);
        const bolan_water water = {.sea = sea, .flow = flow};
        const errors whole = errors_at(&water, 0.0, 0.0);
        for (int i = 0; i < 4; i++) {
            const errors e = errors_at(&water, 0.0, lengths[i]);
            print_message("least wavelength %g m: velocity %.4f m/s error %.5f, acceleration %.4f error %.5f, pressure "
                          "/ density %.4f error %.5f\n",
                          lengths[i], e.value[0], e.error[0], e.value[1], e.error[1], e.value[2], e.error[2]);
            for (int q = 0; q < 3; q++) assert_true(e.error[q] < 0.01 * whole.value[q]);
        }
        bolan_flow_destroy(&flow);
        bolan_sea_destroy(&sea);
    }
}

// ---- one wave in closed form ----------------------------------------------------------------------------------------

// One cosine: 1 m high, so flat that choppiness and the level do not matter.
static bolan_sea *one_wave(double depth, double from_deg) {
    bolan_sea_desc d = test_calm_desc(32);
    d.waves = BOLAN_WAVES_COSINES;
    d.cosines.frequencies = d.cosines.directions = 1;
    d.sea_state.depth = depth;
    d.choppiness = 0.0;
    assert_int_equal(bolan_sea_state_add_swell(&d.sea_state, 0.5, 10.0, from_deg, 75.0), BOLAN_OK);
    bolan_sea *sea = test_sea(d);
    assert_int_equal(bolan_sea_component_count(sea), 1);
    return sea;
}

// Dean & Dalrymple 1991, section 4.2, with eta = a cos(kx - omega t + phase) and z upwards from the mean level:
// u = a omega cosh k(h+z) / sinh kh cos, w = a omega sinh k(h+z) / sinh kh sin, p = rho g a cosh k(h+z) / cosh kh cos.
static answer textbook(const bolan_sea_component *c, double h, double x, double y, double z, double t) {
    const double k = hypot(c->kx, c->ky), o = c->omega, a = c->amplitude;
    const double th = c->kx * x + c->ky * y - o * t + c->phase, q = k * (h + z);
    const bool deep = k * h > 300.0;
    const double over_sinh = deep ? exp(k * z) : cosh(q) / sinh(k * h), up = deep ? exp(k * z) : sinh(q) / sinh(k * h);
    const double over_cosh = deep ? exp(k * z) : cosh(q) / cosh(k * h);
    const double u = a * o * over_sinh * cos(th), ut = a * o * o * over_sinh * sin(th);
    return (answer){{u * c->kx / k, u * c->ky / k, a * o * up * sin(th)},
                    {ut * c->kx / k, ut * c->ky / k, -a * o * o * up * cos(th)},
                    BOLAN_GRAVITY * a * over_cosh * cos(th)};
}

static void check_answer(const answer *got, const answer *want, double tolerance) {
    for (int c = 0; c < 3; c++) {
        assert_near(got->v[c], want->v[c], tolerance);
        assert_near(got->a[c], want->a[c], tolerance);
    }
    assert_near(got->p, want->p, 10.0 * tolerance);
}

static void one_wave_is_that_of_the_textbook(void **state) {
    (void)state;
    static const double waters[] = {BOLAN_DEEP, 60.0, 12.0, 3.0}, heights[] = {-0.3, -1.0, -2.9, -11.0, -50.0};
    for (int w = 0; w < 4; w++) {
        bolan_sea *sea = one_wave(waters[w], 30.0 + 100.0 * w);
        bolan_sea_step(sea, 1234.5);
        bolan_flow *flow = test_flow(sea);
        const bolan_water water = {.sea = sea, .flow = flow};
        const bolan_sea_component c = bolan_sea_get_component(sea, 0);
        for (int i = 0; i < 5 * 7; i++) {
            const bolan_dvec3 at = {17.3 * i, -23.1 * (i % 7), heights[i / 7]};
            if (-at.z > waters[w]) continue;
            bolan_kinematics k;
            bolan_query_below(&water, NULL, &at, 1, &k);
            assert_true(k.wet);
            const answer got = answer_of(&k), want = textbook(&c, waters[w], at.x, at.y, at.z, 1234.5);
            check_answer(&got, &want, 2e-6 * 10.0); // surface tension moves omega^2 = g k tanh kh by 1e-6
        }
        bolan_flow_destroy(&flow);
        bolan_sea_destroy(&sea);
    }
}

// A crest 0.25 m high: above the mean level as at it; by Wheeler z is at H (z - eta) / (H + eta).
static void stretching_is_what_it_says(void **state) {
    (void)state;
    const double h = 12.0;
    bolan_sea *sea = one_wave(h, 270.0);
    const bolan_sea_component c = bolan_sea_get_component(sea, 0);
    bolan_sea_step(sea, (c.phase + 2.0 * BOLAN_PI) / c.omega); // the crest stands at the origin
    bolan_flow *flow = test_flow(sea);
    const bolan_water water = {.sea = sea, .flow = flow, .level = 2.0};
    const bolan_question wheeler = {.stretching = BOLAN_STRETCH_WHEELER};
    const double eta = c.amplitude, t = bolan_sea_time(sea);
    static const double share[] = {1.0, 0.6, 0.1, -0.5, -4.0, -20.0};
    for (int i = 0; i < 6; i++) {
        const double z = share[i] * eta;
        const bolan_dvec3 at = {0.0, 0.0, 2.0 + z};
        bolan_kinematics k;
        bolan_query_below(&water, NULL, &at, 1, &k);
        answer got = answer_of(&k), want = textbook(&c, h, 0.0, 0.0, fmin(z, 0.0), t);
        assert_true(k.wet);
        check_answer(&got, &want, 2e-5);
        bolan_query_below(&water, &wheeler, &at, 1, &k);
        got = answer_of(&k), want = textbook(&c, h, 0.0, 0.0, h * (z - eta) / (h + eta), t);
        check_answer(&got, &want, 2e-5);
        // Hydrostatic and dynamic pressure end at the crest.
        if (i == 0) assert_near(-BOLAN_GRAVITY * z + got.p, 0.0, 1e-4);
    }
    const bolan_dvec3 air = {0.0, 0.0, 2.0 + eta + 0.01};
    bolan_kinematics k;
    bolan_query_below(&water, NULL, &air, 1, &k);
    assert_true(!k.wet && k.pressure == 0.0f && k.velocity.x == 0.0f);
    bolan_flow_destroy(&flow);
    bolan_sea_destroy(&sea);
}

// ---- the surface in time --------------------------------------------------------------------------------------------

static bolan_surface_motion motion_at(const bolan_water *water, double x, double y) {
    bolan_surface_motion m;
    bolan_query_motion(water, NULL, &(bolan_dvec2){x, y}, 1, &m);
    return m;
}

static double height_after(bolan_water water, bolan_sea *sea, bolan_flow *flow, double time, double x, double y) {
    bolan_sea_step(sea, time);
    bolan_flow_step(flow, sea);
    return (double)motion_at(&water, x, y).height;
}

// The rise at a point is the difference of heights in time, and the normal that of heights in space.
static void check_motion(bolan_sea_desc desc, const char *name) {
    bolan_sea *sea = test_sea(desc);
    bolan_flow *flow = test_flow(sea);
    const bolan_water water = {.sea = sea, .flow = flow};
    double error = 0.0, value = 0.0, slope_error = 0.0, slope = 0.0;
    const double dt = 1e-3, d = 0.01, time = 50.0;
    for (int i = 0; i < 40; i++) {
        const double x = 37.3 * i - 300.0, y = 23.9 * i;
        const double rise =
            (height_after(water, sea, flow, time + dt, x, y) - height_after(water, sea, flow, time - dt, x, y)) /
            (2.0 * dt);
        height_after(water, sea, flow, time, x, y);
        const bolan_surface_motion m = motion_at(&water, x, y);
        error += square((double)m.rise - rise), value += square(rise);
        const double east = (double)(motion_at(&water, x + d, y).height - motion_at(&water, x - d, y).height) / (2 * d);
        const double north =
            (double)(motion_at(&water, x, y + d).height - motion_at(&water, x, y - d).height) / (2 * d);
        slope_error +=
            square((double)(m.normal.x / m.normal.z) + east) + square((double)(m.normal.y / m.normal.z) + north);
        slope += square(east) + square(north);
    }
    print_message("%s: rise %.3f m/s, error %.2f %%; slope %.4f, error %.2f %%\n", name, sqrt(value / 40),
                  100.0 * sqrt(error / value), sqrt(slope / 40), 100.0 * sqrt(slope_error / slope));
    assert_true(error < square(desc.order > 1 ? 0.005 : 0.02) * value); // order 2 has the same interpolation
    assert_true(slope_error < square(0.03) * slope);
    bolan_flow_destroy(&flow);
    bolan_sea_destroy(&sea);
}

static void the_rise_of_the_surface_is_its_rate_in_time(void **state) {
    (void)state;
    // Waves that a difference over a centimetre resolves.
    bolan_sea_desc d = wind_desc();
    d.fft.cascade_count = 2;
    check_motion(d, "fft");
    d.order = 2;
    check_motion(d, "fft, order 2");
    d.sea_state.depth = 12.0;
    check_motion(d, "fft, order 2, 12 m of water");
    d.sea_state.depth = BOLAN_DEEP;
    d.order = 1;
    d.choppiness = 0.4;
    check_motion(d, "fft, choppiness 0.4");
    d.sea_state.current_x = 1.5, d.sea_state.current_y = -0.7;
    check_motion(d, "fft on a current");
    d = wind_desc();
    d.waves = BOLAN_WAVES_COSINES;
    check_motion(d, "cosines");
    d.sea_state.current_x = 1.5, d.sea_state.current_y = -0.7;
    check_motion(d, "cosines on a current");
    d.waves = BOLAN_WAVES_EXP_COSINE;
    check_motion(d, "exp-cosine on a current");
}

// Without waves that fold, and where a query's own interpolation is fine: a swell.
static void the_surface_is_that_of_the_query(void **state) {
    (void)state;
    bolan_sea_desc d = test_calm_desc(256);
    assert_int_equal(bolan_sea_state_add_swell(&d.sea_state, 3.0, 12.0, 290.0, 20.0), BOLAN_OK);
    for (int model = 0; model < 3; model++) {
        d.waves = model == 1 ? BOLAN_WAVES_COSINES : BOLAN_WAVES_FFT;
        d.order = model == 2 ? 2 : 1;
        bolan_sea *sea = test_sea(d);
        bolan_flow *flow = test_flow(sea);
        const bolan_water water = {.sea = sea, .flow = flow, .level = 3.5};
        double error = 0.0;
        for (int i = 0; i < 200; i++) {
            const bolan_dvec2 at = {61.7 * i - 4000.0, 33.3 * i};
            float height;
            bolan_query_heights(&water, &at, 1, &height);
            error += square((double)(height - motion_at(&water, at.x, at.y).height)) / 200;
        }
        print_message("heights of both queries differ by %.4f m\n", sqrt(error));
        assert_true(sqrt(error) < (model == 1 ? 1e-3 : 0.01)); // of 0.75 m
        bolan_flow_destroy(&flow);
        bolan_sea_destroy(&sea);
    }
}

// ---- what else is in the water --------------------------------------------------------------------------------------

static void a_layer_adds_its_own_flow(void **state) {
    (void)state;
    bolan_sea *sea = test_sea(test_calm_desc(32));
    bolan_sea_step(sea, 3.3);
    bolan_flow *flow = test_flow(sea);
    bolan_wave_train_desc d = bolan_wave_train_desc_default();
    d.from_deg = 215.0, d.length = 60.0, d.height = 0.2, d.depth = 15.0, d.phase_deg = 40.0;
    bolan_wave_layer *layer = NULL;
    assert_int_equal(bolan_wave_layer_create_train(&d, &layer), BOLAN_OK);
    const bolan_wave_layer *layers[1] = {layer};
    const bolan_water water = {.sea = sea, .flow = flow, .layers = layers, .layer_count = 1};
    const double k = 2.0 * BOLAN_PI / 60.0, to = bolan_compass_from_to_math(215.0);
    const bolan_sea_component c = {k * cos(to),         k * sin(to), bolan_omega_from_k(k, 15.0),
                                   bolan_radians(40.0), 0.1,         0.0};
    for (int i = 0; i < 20; i++) {
        const bolan_dvec3 at = {7.7 * i, -3.1 * i, -0.2 - 0.7 * i};
        bolan_kinematics got_k;
        bolan_query_below(&water, NULL, &at, 1, &got_k);
        const answer got = answer_of(&got_k), want = textbook(&c, 15.0, at.x, at.y, at.z, 3.3);
        check_answer(&got, &want, 2e-5);
        const bolan_question half = {.least_wavelength = 60.0};
        bolan_query_below(&water, &half, &at, 1, &got_k);
        assert_near((double)got_k.velocity.x, 0.5 * want.v[0], 2e-5);
    }
    bolan_wave_layer_destroy(&layer);
    bolan_flow_destroy(&flow);
    bolan_sea_destroy(&sea);
}

// A plane bed: what the surface keeps over it, the water below keeps; the ground is dry, and so is land.
static void a_bed_attenuates_and_is_dry(void **state) {
    (void)state;
    bolan_sea_desc d = test_calm_desc(256);
    assert_int_equal(bolan_sea_state_add_swell(&d.sea_state, 3.0, 12.0, 290.0, 20.0), BOLAN_OK);
    bolan_sea *sea = test_sea(d);
    bolan_flow *flow = test_flow(sea);
    bolan_ground *bed = test_plane_ground(-3.0f, -3.0f);
    const bolan_water open = {.sea = sea, .flow = flow}, shallow = {.sea = sea, .flow = flow, .ground = bed};
    double whole = 0.0, kept = 0.0, error = 0.0;
    for (int i = 0; i < 60; i++) {
        const bolan_dvec3 at[2] = {{30.0 * i - 900.0, 17.0 * i, -1.5}, {30.0 * i - 900.0, 17.0 * i, -3.5}};
        bolan_kinematics a[2], b[2];
        bolan_query_below(&open, NULL, at, 2, a);
        bolan_query_below(&shallow, NULL, at, 2, b);
        float height;
        bolan_query_heights(&shallow, &(bolan_dvec2){at[0].x, at[0].y}, 1, &height);
        error += square((double)(motion_at(&shallow, at[0].x, at[0].y).height - height)) / 60;
        assert_true(b[0].wet && !b[1].wet && b[1].pressure == 0.0f && b[1].velocity.x == 0.0f);
        if (a[0].wet) whole += square((double)a[0].pressure), kept += square((double)b[0].pressure);
    }
    assert_true(kept < 0.5 * whole && kept > 0.1 * whole); // tanh(0.6 3 / 3) = 0.54
    assert_true(sqrt(error) < 0.02);
    bolan_ground_destroy(&bed);
    bed = test_plane_ground(2.0f, 2.0f);
    const bolan_water land = {.sea = sea, .flow = flow, .ground = bed};
    bolan_kinematics k;
    bolan_query_below(&land, NULL, &(bolan_dvec3){0.0, 0.0, -1.0}, 1, &k);
    assert_true(!k.wet);
    const bolan_surface_motion m = motion_at(&land, 0.0, 0.0);
    assert_true(m.height == 0.0f && m.rise == 0.0f && m.velocity.z == 0.0f);
    bolan_ground_destroy(&bed);
    bolan_flow_destroy(&flow);
    bolan_sea_destroy(&sea);
}

// ---- promises -------------------------------------------------------------------------------------------------------

static void check_bits(uint32_t order) {
    enum { COUNT = 500 };
    static bolan_dvec3 at[COUNT];
    static bolan_kinematics first[COUNT], other[COUNT];
    memset(first, 0, sizeof first), memset(other, 0, sizeof other);
    for (int i = 0; i < COUNT; i++) at[i] = (bolan_dvec3){13.7 * i - 1e6, 7.1 * i + 3e5, -0.1 * i + 1.0};
    for (int cpu = BOLAN_CPU_SCALAR; cpu <= (int)bolan_cpu_best(); cpu++) {
        bolan_sea_desc d = mixed_desc();
        d.cpu = (bolan_cpu)cpu;
        d.order = order;
        bolan_set_threads(cpu == BOLAN_CPU_GENERIC4 ? 3 : 1);
        bolan_sea *sea = test_sea(d);
        bolan_sea_step(sea, 77.7);
        bolan_flow *flow = test_flow(sea);
        bolan_query_below(&(bolan_water){.sea = sea, .flow = flow}, NULL, at, COUNT,
                          cpu == BOLAN_CPU_SCALAR ? first : other);
        if (cpu > BOLAN_CPU_SCALAR) {
            for (int i = 0; i < COUNT; i++) {
                assert_memory_equal(&first[i].velocity, &other[i].velocity, sizeof other[i].velocity);
                assert_memory_equal(&first[i].acceleration, &other[i].acceleration, sizeof other[i].acceleration);
                assert_true(first[i].pressure == other[i].pressure && first[i].wet == other[i].wet);
            }
        }
        bolan_flow_destroy(&flow);
        bolan_sea_destroy(&sea);
    }
    bolan_set_threads(1);
}

static void answers_do_not_depend_on_threads_and_instruction_set(void **state) {
    (void)state;
    check_bits(1);
    check_bits(2);
}

static void check_memory(uint32_t order) {
    const size_t before = bolan_memory_in_use();
    bolan_sea_desc d = mixed_desc();
    d.order = order;
    bolan_sea *sea = test_sea(d);
    const size_t with_sea = bolan_memory_in_use();
    bolan_flow *flow = test_flow(sea);
    const size_t with_flow = bolan_memory_in_use();
    assert_int_equal(with_flow - with_sea, bolan_flow_size(flow));
    bolan_sea_step(sea, 5.0);
    bolan_flow_step(flow, sea);
    assert_true(bolan_flow_time(flow) == 5.0 && bolan_flow_sea_id(flow) == bolan_sea_id(sea));
    bolan_kinematics k;
    bolan_query_below(&(bolan_water){.sea = sea, .flow = flow}, NULL, &(bolan_dvec3){1.0, 2.0, -3.0}, 1, &k);
    assert_true(k.wet);
    bolan_query_below(&(bolan_water){.sea = sea, .flow = flow}, NULL, &(bolan_dvec3){NAN, 2.0, -3.0}, 1, &k);
    assert_true(!k.wet);
    assert_int_equal(bolan_memory_in_use(), with_flow);
    bolan_sea_destroy(&sea); // the flow keeps nothing of it
    bolan_flow_destroy(&flow);
    bolan_flow_destroy(&flow);
    assert_int_equal(bolan_memory_in_use(), before);
}

static void a_step_and_a_question_allocate_nothing(void **state) {
    (void)state;
    check_memory(1);
    check_memory(2);
}

static int misuses;
static void count_misuse(void *user, const char *expression, const char *file, int line) {
    (void)user, (void)expression, (void)file, (void)line;
    misuses++;
}

static void a_water_without_the_flow_of_its_time_is_misuse(void **state) {
    (void)state;
    bolan_set_hooks(&(bolan_hooks){.assert_failed = count_misuse});
    bolan_sea *sea = test_sea(test_calm_desc(32)), *other = test_sea(test_calm_desc(32));
    bolan_flow *flow = test_flow(sea);
    const bolan_dvec3 at = {0.0, 0.0, -1.0};
    bolan_kinematics k;
    bolan_query_below(&(bolan_water){.sea = sea}, NULL, &at, 1, &k);
    assert_int_equal(misuses, 1);
    bolan_query_below(&(bolan_water){.sea = other, .flow = flow}, NULL, &at, 1, &k);
    assert_int_equal(misuses, 2);
    bolan_sea_step(sea, 1.0);
    bolan_query_below(&(bolan_water){.sea = sea, .flow = flow}, NULL, &at, 1, &k);
    assert_int_equal(misuses, 3);
    bolan_flow_step(flow, other);
    assert_int_equal(misuses, 4);
    bolan_flow_step(flow, sea);
    bolan_query_below(&(bolan_water){.sea = sea, .flow = flow}, &(bolan_question){.least_wavelength = -1.0}, &at, 1,
                      &k);
    assert_int_equal(misuses, 5);
    bolan_query_below(&(bolan_water){.sea = sea, .flow = flow}, NULL, &at, 1, &k);
    assert_int_equal(misuses, 5);
    assert_true(k.wet && k.pressure == 0.0f); // a calm
    bolan_flow_destroy(&flow);
    bolan_sea_destroy(&sea);
    bolan_sea_destroy(&other);
    bolan_set_hooks(NULL);
}

// Points near the surface are looked for together, and a batch at one depth shares weights: no point must feel that.
static void check_batch(uint32_t order) {
    enum { POINTS = 200 };
    static const double heights[] = {0.0, -0.4, 0.2, -5.0, -5.0, -30.0, 9.0};
    static const bolan_question wheeler = {.stretching = BOLAN_STRETCH_WHEELER};
    bolan_dvec3 at[POINTS];
    bolan_dvec2 xy[POINTS];
    bolan_kinematics one, all[POINTS];
    bolan_surface_motion moved, motion[POINTS];
    bolan_sea_desc d = wind_desc();
    d.order = order;
    bolan_sea *sea = test_sea(d);
    bolan_sea_step(sea, 11.0);
    bolan_flow *flow = test_flow(sea);
    const bolan_water water = {.sea = sea, .flow = flow, .level = 3.0};
    for (int i = 0; i < POINTS; i++) {
        at[i] = (bolan_dvec3){17.3 * i, 3.1 * (i % 13), 3.0 + heights[i % 7]};
        xy[i] = (bolan_dvec2){at[i].x, at[i].y};
    }
    for (int q = 0; q < 2; q++) {
        const bolan_question *question = q ? &wheeler : NULL;
        bolan_query_below(&water, question, at, POINTS, all);
        for (int i = 0; i < POINTS; i++) {
            bolan_query_below(&water, question, &at[i], 1, &one);
            assert_memory_equal(&one.velocity, &all[i].velocity, sizeof one.velocity);
            assert_true(one.wet == all[i].wet && one.pressure == all[i].pressure);
        }
    }
    bolan_query_motion(&water, NULL, xy, POINTS, motion);
    for (int i = 0; i < POINTS; i++) {
        bolan_query_motion(&water, NULL, &xy[i], 1, &moved);
        assert_memory_equal(&moved, &motion[i], sizeof moved);
    }
    bolan_flow_destroy(&flow);
    bolan_sea_destroy(&sea);
}

// Levels in any order, above the surface and deep below it, are the points one by one.
static void check_levels(uint32_t order) {
    enum { PLACES_ASKED = 150, LEVELS = 5 };
    static const double z[LEVELS] = {2.5, -30.0, 3.2, 15.0, 0.0};
    static bolan_dvec2 xy[PLACES_ASKED];
    static bolan_kinematics all[LEVELS * PLACES_ASKED];
    bolan_sea_desc d = wind_desc();
    d.order = order;
    bolan_sea *sea = test_sea(d);
    bolan_sea_step(sea, 11.0);
    bolan_flow *flow = test_flow(sea);
    const bolan_water water = {.sea = sea, .flow = flow, .level = 3.0};
    int wet = 0;
    for (int i = 0; i < PLACES_ASKED; i++) xy[i] = (bolan_dvec2){17.3 * i, 3.1 * (i % 13)};
    for (int q = 0; q < 2; q++) {
        const bolan_question question = {.stretching = q ? BOLAN_STRETCH_WHEELER : BOLAN_STRETCH_NONE};
        bolan_query_levels(&water, &question, xy, PLACES_ASKED, z, LEVELS, all);
        for (int p = 0; p < LEVELS * PLACES_ASKED; p++) {
            const bolan_dvec2 at = xy[p % PLACES_ASKED];
            bolan_kinematics one;
            bolan_query_below(&water, &question, &(bolan_dvec3){at.x, at.y, z[p / PLACES_ASKED]}, 1, &one);
            assert_memory_equal(&one.velocity, &all[p].velocity, sizeof one.velocity);
            assert_memory_equal(&one.acceleration, &all[p].acceleration, sizeof one.acceleration);
            assert_true(one.wet == all[p].wet && one.pressure == all[p].pressure);
            wet += one.wet;
        }
    }
    assert_true(wet > 4 * PLACES_ASKED && wet < 9 * PLACES_ASKED);
    bolan_query_levels(&water, NULL, NULL, 0, NULL, 0, NULL);
    bolan_flow_destroy(&flow);
    bolan_sea_destroy(&sea);
}

static void levels_are_their_points(void **state) {
    (void)state;
    check_levels(1);
    check_levels(2);
}

static void a_batch_is_its_points(void **state) {
    (void)state;
    check_batch(1);
    check_batch(2);
}

RUN_TESTS(cmocka_unit_test(one_wave_is_that_of_the_textbook), cmocka_unit_test(stretching_is_what_it_says),
          cmocka_unit_test(below_is_the_sum_over_every_mode),
          cmocka_unit_test(below_is_the_sum_over_every_mode_in_finite_depth),
          cmocka_unit_test(a_least_wavelength_is_its_filter_on_every_mode),
          cmocka_unit_test(the_rise_of_the_surface_is_its_rate_in_time),
          cmocka_unit_test(the_surface_is_that_of_the_query), cmocka_unit_test(a_layer_adds_its_own_flow),
          cmocka_unit_test(a_bed_attenuates_and_is_dry),
          cmocka_unit_test(answers_do_not_depend_on_threads_and_instruction_set),
          cmocka_unit_test(levels_are_their_points), cmocka_unit_test(a_batch_is_its_points),
          cmocka_unit_test(a_step_and_a_question_allocate_nothing),
          cmocka_unit_test(a_water_without_the_flow_of_its_time_is_misuse))

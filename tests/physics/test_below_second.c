// SPDX-License-Identifier: MIT
// The water under a sea of order 2 against the sum over all pairs of its waves, with the potentials of Sharma & Dean
// (1981) as Forristall (2000), eq. 5 to 9, prints them; and against the surface that it belongs to.
#include "sea_support.h"

#include "bolan/query.h"

#include "flow/tables.h"
#include "waves/cascades/cascades.h"

#include <complex.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static double square(double x) { return x * x; }

typedef long double real;
typedef long double complex phasor;
#define G 9.81L

// ---- the oracle -----------------------------------------------------------------------------------------------------

enum { MOST_WAVES = 40000, PLACES = 12, DEPTHS = 5 };
static const double depths[DEPTHS] = {0.0, 1.0, 5.0, 20.0, 50.0};

// What a point has: velocity, acceleration, pressure over density.
enum { VALUES = 7 };

typedef struct wave {
    real kx, ky, k, r, omega; // r = k tanh kH
    phasor amplitude;         // at time 0
    phasor at[PLACES];        // a e^{i psi}
} wave;
static wave waves[MOST_WAVES];
static uint32_t wave_count;
static real water_depth;

static void add_wave(double kx, double ky, double turns, double re, double im) {
    wave *w = &waves[wave_count];
    if (!(re * re + im * im > 0.0)) return;
    assert_true(wave_count < MOST_WAVES - 1);
    wave_count++;
    memset(w, 0, sizeof *w);
    w->kx = kx, w->ky = ky, w->k = hypotl(kx, ky), w->omega = 2.0L * acosl(-1.0L) * turns;
    w->r = w->k * tanhl(w->k * water_depth);
    w->amplitude = 2.0L * (re + I * (real)im);
}

// Of a mode that stands for -k as well there are two waves.
static void add_mode(void *context, const sea_mode *m) {
    (void)context;
    add_wave(m->kx, m->ky, m->turns, m->re, m->im);
    if (m->paired) add_wave(-m->kx, -m->ky, m->turns, m->back_re, -m->back_im);
}

static void sum_pair(const wave *a, const wave *b, int sign, real out[DEPTHS][PLACES][VALUES]) {
    const real kx = a->kx + sign * b->kx, ky = a->ky + sign * b->ky, k = hypotl(kx, ky), w = a->omega + sign * b->omega;
    if (k < 1e-9L) return;
    const real ra = sqrtl(a->r), rb = sqrtl(b->r), root = ra + sign * rb, dot = a->kx * b->kx + a->ky * b->ky;
    const real first = rb * (a->k * a->k - a->r * a->r) + sign * ra * (b->k * b->k - b->r * b->r);
    const real d =
        (root * first + 2.0L * root * root * (dot - sign * a->r * b->r)) / (root * root - k * tanhl(k * water_depth));
    // 1/4 for both orders of the pair; sin of the phase. D / (wa +- wb) has a limit where both are 0.
    if (fabsl(w) < 1e-12L) return;
    const real scale = 0.5L * G * G / (a->omega * b->omega) * d / w;
    for (int z = 0; z < DEPTHS; z++) {
        if (depths[z] > (double)water_depth) continue;
        const real q = k * (water_depth - depths[z]), kh = k * water_depth;
        const real across = kh > 300.0L ? expl(-k * depths[z]) : coshl(q) / coshl(kh);
        const real up = kh > 300.0L ? across : sinhl(q) / coshl(kh);
        for (int p = 0; p < PLACES; p++) {
            const phasor e = scale * a->at[p] * (sign > 0 ? b->at[p] : conjl(b->at[p]));
            const real c = creall(e), s = cimagl(e);
            real *v = out[z][p];
            v[0] += kx * across * c, v[1] += ky * across * c, v[2] += k * up * s;
            v[3] += w * kx * across * s, v[4] += w * ky * across * s, v[5] -= w * k * up * c;
            v[6] += w * across * c;
        }
    }
}

// First order at a point: velocity, its gradient and rate.
typedef struct linear {
    real v[3], a[3], shear[3][3], pressure;
} linear;

static linear first_order(int place, double depth) {
    linear l = {0};
    for (uint32_t i = 0; i < wave_count; i++) {
        const wave *w = &waves[i];
        const real q = w->k * (water_depth - depth), kh = w->k * water_depth;
        const real across = kh > 300.0L ? expl(-w->k * depth) : coshl(q) / sinhl(kh);
        const real up = kh > 300.0L ? across : sinhl(q) / sinhl(kh);
        const real c = creall(w->at[place]) * w->omega, s = cimagl(w->at[place]) * w->omega;
        const real ux = w->kx / w->k, uy = w->ky / w->k;
        l.v[0] += ux * across * c, l.v[1] += uy * across * c, l.v[2] += up * s;
        l.a[0] += w->omega * ux * across * s, l.a[1] += w->omega * uy * across * s, l.a[2] -= w->omega * up * c;
        l.pressure += w->omega / w->k * across * c;
        l.shear[0][0] -= ux * w->kx * across * s, l.shear[0][1] -= ux * w->ky * across * s;
        l.shear[1][1] -= uy * w->ky * across * s;
        l.shear[0][2] += w->kx * up * c, l.shear[1][2] += w->ky * up * c, l.shear[2][2] += w->k * across * s;
    }
    l.shear[1][0] = l.shear[0][1], l.shear[2][0] = l.shear[0][2], l.shear[2][1] = l.shear[1][2];
    return l;
}

// The mean of (u^2 - w^2) / 2 at the surface keeps the mean level.
static real head(void) {
    real sum = 0.0L;
    for (uint32_t i = 0; i < wave_count; i++) {
        const real t = tanhl(waves[i].k * water_depth), a = cabsl(waves[i].amplitude);
        sum += 0.25L * a * a * waves[i].omega * waves[i].omega * (1.0L / (t * t) - 1.0L);
    }
    return sum;
}

static bolan_dvec2 place_of(int p) { return (bolan_dvec2){61.3 * p - 200.0, 47.9 * (p % 5) - 11.0 * p}; }

static void set_places(double time) {
    for (uint32_t i = 0; i < wave_count; i++)
        for (int p = 0; p < PLACES; p++) {
            const bolan_dvec2 x = place_of(p);
            waves[i].at[p] =
                waves[i].amplitude * cexpl(I * (waves[i].kx * x.x + waves[i].ky * x.y - waves[i].omega * (real)time));
        }
}

// Everything of second order.
static void second_order_sum(real out[DEPTHS][PLACES][VALUES]) {
    memset(out, 0, sizeof(real) * DEPTHS * PLACES * VALUES);
    for (uint32_t i = 0; i < wave_count; i++) sum_pair(&waves[i], &waves[i], 1, out); // half of a pair
    for (int z = 0; z < DEPTHS; z++)
        for (int p = 0; p < PLACES; p++)
            for (int v = 0; v < VALUES; v++) out[z][p][v] *= 0.5L;
    for (uint32_t i = 0; i < wave_count; i++)
        for (uint32_t j = 0; j < i; j++)
            for (int sign = -1; sign < 2; sign += 2) sum_pair(&waves[i], &waves[j], sign, out);
    for (int z = 0; z < DEPTHS; z++)
        for (int p = 0; p < PLACES; p++) {
            const linear l = first_order(p, depths[z]);
            for (int e = 0; e < 3; e++) {
                for (int f = 0; f < 3; f++) out[z][p][3 + e] += l.shear[e][f] * l.v[f];
                out[z][p][6] -= 0.5L * l.v[e] * l.v[e];
            }
            out[z][p][6] += head();
        }
}

// ---- seas -----------------------------------------------------------------------------------------------------------

enum { MOST_ENTRIES = 1 << 18 };
static double strength[MOST_ENTRIES];
static uint32_t strengths;

// Visits the modes of a table: notes how strong each is, or silences those below `least`.
static void visit_modes(const sea_waves *table, size_t rows, double least) {
    for (size_t e = 0; e < rows * FFT_LANES; e++) {
        float *a = table->amplitude + e / FFT_LANES * 4 * FFT_LANES + e % FFT_LANES;
        double sum = 0.0;
        for (int part = 0; part < 4; part++) sum += square((double)a[part * FFT_LANES] * table->turns[e]);
        if (!(sum > 0.0)) continue;
        if (least == 0.0) {
            assert_true(strengths < MOST_ENTRIES);
            strength[strengths++] = sum;
        } else if (sum < least) {
            for (int part = 0; part < 4; part++) a[part * FFT_LANES] = 0.0f;
        }
    }
}

static void visit_sea(const bolan_sea *sea, double least) {
    for (uint32_t i = 0; i < sea->shared->cascades; i++) {
        const sea_cascade *c = &cascade_tables_of(sea->shared)->cascade[i];
        visit_modes(&c->modes, (size_t)c->strips * c->n, least);
        visit_modes(&c->parts, (SEA_PARTS - 1) * SEA_PART_ROWS, least);
    }
}

// A coarse lattice has several frequencies for a wave vector (modes.c), of which theory knows one: it stays.
static void follow_dispersion(bolan_sea *sea) {
    for (uint32_t n = 0; n < sea->shared->cascades; n++) {
        const sea_cascade *c = &cascade_tables_of(sea->shared)->cascade[n];
        memset(c->parts.amplitude, 0, (SEA_PARTS - 1) * SEA_PART_ROWS * 4 * FFT_LANES * sizeof(float));
        for (size_t e = 0; e < (size_t)c->strips * c->n * FFT_LANES; e++) {
            const size_t row = e / FFT_LANES % c->n;
            const double i = (double)(e / FFT_LANES / c->n * FFT_LANES + e % FFT_LANES);
            const double j = row < c->n / 2 ? (double)row : (double)row - c->n;
            const double k = 2.0 * BOLAN_PI / c->length * hypot(i, j);
            if (c->modes.turns[e] > 0.0)
                c->modes.turns[e] =
                    sqrt(BOLAN_GRAVITY * k * tanh(k * bolan_sea_get_desc(sea)->sea_state.depth)) / (2.0 * BOLAN_PI);
        }
    }
}

static int descending(const void *a, const void *b) {
    const double x = *(const double *)a, y = *(const double *)b;
    return (x < y) - (x > y);
}

// Leaves the strongest modes of a sea, and lists their waves.
static void reduce(bolan_sea *sea, uint32_t most) {
    double all = 0.0, left = 0.0;
    strengths = wave_count = 0;
    follow_dispersion(sea);
    visit_sea(sea, 0.0);
    qsort(strength, strengths, sizeof *strength, descending);
    for (uint32_t i = 0; i < strengths; i++) all += strength[i], left += i < most ? strength[i] : 0.0;
    if (most < strengths) visit_sea(sea, strength[most]);
    water_depth = (real)bolan_sea_get_desc(sea)->sea_state.depth;
    bolan_cascades_each_wave(sea->shared, add_mode, NULL);
    print_message("%u of %u modes, with %.0f %% of the motion: %u waves\n", most, strengths, 100.0 * left / all,
                  wave_count);
    sea->shared->warp.count = 0;
}

// ---- tests ----------------------------------------------------------------------------------------------------------

typedef struct error {
    double error, value;
} error;
static const char *const names[] = {"velocity", "acceleration", "pressure / density"};

static void add_errors(error e[3], const double got[VALUES], const real want[VALUES]) {
    for (int v = 0; v < VALUES; v++) {
        error *to = &e[v / 3];
        to->error += square(got[v] - (double)want[v]);
        to->value += square((double)want[v]);
    }
}

static void values_of(const flow_water *w, double out[VALUES]) {
    for (int e = 0; e < 3; e++) out[e] = w->velocity[e], out[3 + e] = w->acceleration[e];
    out[6] = w->pressure;
}

static real sums[DEPTHS][PLACES][VALUES];
static const float whole[BOLAN_MAX_CASCADES] = {1.0f, 1.0f, 1.0f, 1.0f};
static const float mirrored[BOLAN_MAX_CASCADES] = {-1.0f, -1.0f, -1.0f, -1.0f};

// The part of a flow that does not change its sign with the waves is that of second order, but for one of fourth; the
// other is that of first order.
static void split(const bolan_flow *flow, int place, double depth, double odd[VALUES], double even[VALUES]) {
    const bolan_dvec2 p = place_of(place);
    double x[VALUES], y[VALUES];
    flow_water w;
    bolan_flow_ride(flow, p.x, p.y, depth, true, 0.0, whole, whole, &w);
    values_of(&w, x);
    bolan_flow_ride(flow, p.x, p.y, depth, true, 0.0, mirrored, whole, &w);
    values_of(&w, y);
    for (int v = 0; v < VALUES; v++) odd[v] = 0.5 * (x[v] - y[v]), even[v] = 0.5 * (x[v] + y[v]);
}

// A sea so low that the fourth order is nothing, and its steepness beside that of a real one.
typedef struct low_sea {
    const char *name;
    double depth, period, spread;
    uint32_t cascades, modes;
    double of_bound; // largest error of velocity as a share of that of second order at the surface
    double of_all;   // of every value, of first order at the surface, were the sea 3 m high
} low_sea;

static void check_pairs(const low_sea *c) {
    const double time = 37.3, hs = 0.1, steeper = 3.0 / hs;
    bolan_sea_desc d = test_calm_desc(128);
    assert_int_equal(bolan_sea_state_add_swell(&d.sea_state, hs, c->period, 290.0, c->spread), BOLAN_OK);
    d.sea_state.depth = c->depth;
    d.order = 2;
    d.fft.cascade_count = c->cascades;
    bolan_sea *sea = test_sea(d);
    reduce(sea, c->modes);
    bolan_sea_step(sea, time);
    bolan_flow *flow = NULL;
    assert_int_equal(bolan_flow_create(sea, &flow), BOLAN_OK);
    set_places(time);
    second_order_sum(sums);
    double surface[3] = {0.0}, bound[3] = {0.0};
    for (int z = 0; z < DEPTHS; z++) {
        if (depths[z] > c->depth) continue;
        error e[3] = {{0.0, 0.0}};
        for (int p = 0; p < PLACES; p++) {
            double odd[VALUES], even[VALUES];
            split(flow, p, depths[z], odd, even);
            for (int v = 0; v < VALUES && z == 0; v++) surface[v / 3] += square(odd[v]);
            add_errors(e, even, sums[z][p]);
        }
        for (int q = 0; q < 3; q++) {
            if (z == 0) bound[q] = e[q].value;
            const double of_bound = sqrt(e[q].error / bound[q]), of_all = steeper * sqrt(e[q].error / surface[q]);
            print_message(
                "%s, %2.0f m: %s of order 2 is %.2f %% of order 1 at the surface; error %.1f %% of it there, %.1f "
                "%% here, %.2f %% of order 1\n",
                c->name, depths[z], names[q], 100.0 * steeper * sqrt(e[q].value / surface[q]), 100.0 * of_bound,
                100.0 * sqrt(e[q].error / e[q].value), 100.0 * of_all);
            assert_true(of_bound < (q == 0 ? c->of_bound : 0.5 * c->of_bound));
            assert_true(of_all < c->of_all);
        }
    }
    bolan_flow_destroy(&flow);
    bolan_sea_destroy(&sea);
}

static void the_flow_is_the_sum_over_all_pairs(void **state) {
    (void)state;
    check_pairs(&(low_sea){"one cascade", BOLAN_DEEP, 8.0, 12.0, 1, 200, 0.18, 0.004});
    check_pairs(&(low_sea){"30 m of water", 30.0, 8.0, 12.0, 1, 200, 0.18, 0.004});
    check_pairs(&(low_sea){"two cascades", BOLAN_DEEP, 8.0, 12.0, 2, 300, 0.15, 0.01});
    check_pairs(&(low_sea){"narrow swell", BOLAN_DEEP, 12.0, 75.0, 1, 200, 0.18, 0.004});
}

// 12 m of water under waves of 74 m: sums of waves have a potential here, also those of the shorter ones, and the gains
// fit worst, to 7 % of the velocity of second order.
static void the_flow_is_near_the_sum_in_shallow_water(void **state) {
    (void)state;
    check_pairs(&(low_sea){"12 m of water", 12.0, 8.0, 12.0, 1, 600, 0.15, 0.01});
}

// ---- the surface ----------------------------------------------------------------------------------------------------

static double surface_residuals(uint32_t order, double hs, double *kinematic) {
    bolan_sea_desc d = test_calm_desc(128);
    assert_int_equal(bolan_sea_state_add_swell(&d.sea_state, hs, 8.0, 290.0, 40.0), BOLAN_OK);
    d.order = order;
    d.fft.cascade_count = 1;
    bolan_sea *sea = test_sea(d);
    follow_dispersion(sea);
    sea->shared->warp.count = 0;
    sea->stepped = false; // the fields at time 0 are of the modes before
    bolan_sea_step(sea, 11.0);
    bolan_flow *flow = NULL;
    assert_int_equal(bolan_flow_create(sea, &flow), BOLAN_OK);
    const bolan_water water = {.sea = sea, .flow = flow};
    double dynamic = 0.0, height = 0.0, slip = 0.0, rise = 0.0;
    for (int i = 0; i < 300; i++) {
        const bolan_dvec2 at = {61.7 * i - 4000.0, 33.3 * i};
        bolan_surface_motion m;
        bolan_kinematics k;
        bolan_query_motion(&water, NULL, &at, 1, &m);
        bolan_query_below(&water, NULL, &(bolan_dvec3){at.x, at.y, (double)m.height}, 1, &k);
        if (!k.wet) continue;
        const double z = (double)m.height;
        dynamic += square((double)k.pressure / (BOLAN_SEA_WATER_DENSITY * BOLAN_GRAVITY) - z);
        height += square(z);
        const double w =
            (double)m.velocity.z + (double)((m.velocity.x * m.normal.x + m.velocity.y * m.normal.y) / m.normal.z);
        slip += square(w - (double)m.rise);
        rise += square((double)m.rise);
    }
    bolan_flow_destroy(&flow);
    bolan_sea_destroy(&sea);
    *kinematic = sqrt(slip / rise);
    return sqrt(dynamic / height);
}

static void the_surface_moves_with_the_water_and_has_no_pressure(void **state) {
    (void)state;
    for (double hs = 0.25; hs < 5.0; hs *= 2.0) {
        double first, second;
        const double p1 = surface_residuals(1, hs, &first), p2 = surface_residuals(2, hs, &second);
        print_message(
            "Hs %.2f m: pressure at the surface %.4f of it at order 1, %.4f at order 2; slip %.4f and %.4f of "
            "the rise\n",
            hs, p1, p2, first, second);
        assert_true(p2 < 0.006 + 0.0009 * hs * hs);
        assert_true(second < 0.003 * hs + 0.0005 * hs * hs);
        if (hs > 3.0) assert_true(p1 > 4.0 * p2);
    }
}

// ---- means ----------------------------------------------------------------------------------------------------------

// No mean flow at a fixed point: parcels drift with the waves (Stokes), and water returns under groups alone.
// The mean pressure is -density <w^2>, whatever the depth of the sea.
static void the_mean_flow_is_none_and_the_mean_pressure_that_of_the_vertical_motion(void **state) {
    (void)state;
    enum { SIDE = 96 };
    for (double depth = 12.0; depth < 2e4; depth *= 20.0) {
        bolan_sea_desc d = test_calm_desc(128);
        assert_int_equal(bolan_sea_state_add_swell(&d.sea_state, 1.5, 8.0, 290.0, 12.0), BOLAN_OK);
        d.sea_state.depth = fmin(depth, BOLAN_DEEP);
        d.order = 2;
        d.fft.cascade_count = 1;
        bolan_sea *sea = test_sea(d);
        sea->shared->warp.count = 0;
        bolan_flow *flow = NULL;
        assert_int_equal(bolan_flow_create(sea, &flow), BOLAN_OK);
        const bolan_cascade_view v = bolan_sea_cascade(sea, 0);
        for (double below = 0.0; below < 8.0; below += 4.0) {
            double mean[3] = {0.0}, up = 0.0, along = 0.0, pressure = 0.0;
            for (int i = 0; i < SIDE * SIDE; i++) {
                const double x = v.length * (i % SIDE) / SIDE, y = v.length * (i / SIDE) / SIDE;
                flow_water w;
                bolan_flow_ride(flow, x * cos(v.angle) - y * sin(v.angle), x * sin(v.angle) + y * cos(v.angle), below,
                                true, 0.0, whole, whole, &w);
                for (int e = 0; e < 3; e++) mean[e] += w.velocity[e] / (SIDE * SIDE);
                up += square(w.velocity[2]) / (SIDE * SIDE);
                along += (square(w.velocity[0]) + square(w.velocity[1])) / (SIDE * SIDE);
                pressure += w.pressure / (SIDE * SIDE);
            }
            print_message(
                "%5.0f m of water, %.0f m below: mean velocity %.1e %.1e %.1e of %.3f m/s, pressure / density "
                "%.5f, -w^2 %.5f\n",
                d.sea_state.depth, below, mean[0], mean[1], mean[2], sqrt(along + up), pressure, -up);
            for (int e = 0; e < 3; e++) assert_near(mean[e], 0.0, 1e-4 * sqrt(along + up));
            assert_near(pressure / up, -1.0, 0.02);
        }
        bolan_flow_destroy(&flow);
        bolan_sea_destroy(&sea);
    }
}

RUN_TESTS(cmocka_unit_test(the_flow_is_the_sum_over_all_pairs),
          cmocka_unit_test(the_flow_is_near_the_sum_in_shallow_water),
          cmocka_unit_test(the_surface_moves_with_the_water_and_has_no_pressure),
          cmocka_unit_test(the_mean_flow_is_none_and_the_mean_pressure_that_of_the_vertical_motion))

// SPDX-License-Identifier: MIT
// How the sea moves: phase speed, direction, periods in space and time; and the fields against the direct sum.
#include "sea_support.h"

#include "spectrum/spectrum_eval.h"
#include "waves/cascades/cascades.h"

#include <complex.h>
#include <string.h>

// A sea whose cascade 0 holds one wave alone: amplitude [m] along lattice vector (i, j), every other mode silenced. It
// has the frequency of its wave number where i or j is at least SEA_PART_REACH.
static double complex single(bolan_sea *sea, uint32_t i, uint32_t j, double amplitude, double *k_out) {
    const sea_cascade *c = &cascade_tables_of(sea->shared)->cascade[0];
    const size_t row = (size_t)(i / FFT_LANES) * c->n + j, lane = i % FFT_LANES;
    const double dk = 2.0 * BOLAN_PI / c->length;
    memset(c->modes.amplitude, 0, (size_t)c->strips * c->n * 4 * FFT_LANES * sizeof(float));
    memset(c->parts.amplitude, 0, (SEA_PARTS - 1) * SEA_PART_ROWS * 4 * FFT_LANES * sizeof(float));
    // h0 = a/2, conj(h0(-k)) = 0: (A0, A1, A2, A3) = (h0, 0, 0, -h0).
    c->modes.amplitude[row * 4 * FFT_LANES + lane] = (float)(0.5 * amplitude);
    c->modes.amplitude[row * 4 * FFT_LANES + 3 * FFT_LANES + lane] = (float)(-0.5 * amplitude);
    sea->stepped = false; // the fields at time 0 are of the modes before: a step to 0 has to make them again
    *k_out = dk * hypot(i, j);
    return dk * i + I * (dk * j);
}

static bolan_sea_desc one_cascade(double depth) {
    bolan_sea_desc desc = bolan_sea_desc_default();
    desc.sea_state = bolan_sea_state_from_wind(10.0, 250.0, 100e3); // goes to 20 degrees north of east
    desc.sea_state.depth = depth;
    desc.fft.cascade_count = 1;
    desc.length = 500.0;
    desc.resolution = 128;
    return desc;
}

// Phase of the mode in the height field.
static double phase_of(const bolan_cascade_view *v, double kx, double ky) {
    double complex sum = 0.0;
    for (uint32_t j = 0; j < v->n; j++)
        for (uint32_t i = 0; i < v->n; i++)
            sum += v->displacement[(size_t)j * v->pitch + i].height * cexp(-I * (kx * i + ky * j) * (v->length / v->n));
    return carg(sum);
}

static void a_wave_keeps_its_phase_speed_for_a_minute(void **state) {
    (void)state;
    const double depths[] = {BOLAN_DEEP, 5.0};
    for (int d = 0; d < 2; d++) {
        bolan_sea *sea = test_sea(one_cascade(depths[d]));
        double k;
        const double complex kv = single(sea, 18, 8, 0.5, &k);
        const bolan_cascade_view v = bolan_sea_cascade(sea, 0);
        const double dt = 0.25;
        double travelled = 0.0, previous = 0.0;
        for (int i = 0; i <= 240; i++) {
            bolan_sea_step(sea, i * dt);
            bolan_sea_fields(sea);
            const double phase = phase_of(&v, creal(kv), cimag(kv));
            if (i > 0)
                travelled -= remainder(phase - previous, 2.0 * BOLAN_PI); // e^{i (k.x - w t)}: falls as it
                                                                          // runs to +k
            previous = phase;
        }
        const double omega = sqrt((9.81 * k + 7.17e-5 * k * k * k) * tanh(k * depths[d])); // Lamb 1932, section 267
        assert_near(travelled / 60.0 / omega, 1.0, 1e-3);
        bolan_sea_destroy(&sea);
    }
}

// What planes hold less than the waves: what a spline of phase kh from sample to sample keeps of its amplitude, and a
// linear fetch of its power.
static double cubic_divisor(double kh) { return kh == 0.0 ? 1.0 : pow(sin(0.5 * kh) / (0.5 * kh), 4.0); }
static double linear_divisor(double kh) { return sqrt((2.0 + cos(kh)) / 3.0); }

static void crests_gather_the_water(void **state) {
    (void)state;
    const double depths[] = {BOLAN_DEEP, 10.0}, amplitude = 0.4;
    for (int d = 0; d < 2; d++) {
        bolan_sea_desc desc = one_cascade(depths[d]);
        desc.choppiness = 1.3;
        bolan_sea *sea = test_sea(desc);
        double k;
        const double complex kv = single(sea, 17, 4, amplitude, &k);
        bolan_sea_step(sea, 3.21);
        const bolan_cascade_view v = bolan_sea_cascade(sea, 0);
        const double deepening = 1.0 / tanh(k * depths[d]);
        const double complex to = kv * cexp(I * v.angle); // in the world's axes
        const double cubic = cubic_divisor(creal(kv) * v.length / v.n) * cubic_divisor(cimag(kv) * v.length / v.n);
        const double linear = linear_divisor(creal(kv) * v.length / v.n) * linear_divisor(cimag(kv) * v.length / v.n);
        double lowest = 1.0;
        for (uint32_t j = 0; j < v.n; j++) {
            for (uint32_t i = 0; i < v.n; i++) {
                const size_t p = (size_t)j * v.n + i;
                const double angle = (creal(kv) * i + cimag(kv) * j) * v.length / v.n -
                                     2.0 * BOLAN_PI * bolan_omega_from_k(k, depths[d]) / (2.0 * BOLAN_PI) * 3.21;
                const double eta = amplitude * cos(angle), push = -amplitude * sin(angle) * deepening;
                const bolan_sea_texel texel = v.displacement[(size_t)j * v.pitch + i];
                assert_near(texel.height * cubic, eta, 1e-5);
                assert_near(texel.dx * cubic, push * creal(to) / k, 1e-5);
                assert_near(texel.dy * cubic, push * cimag(to) / k, 1e-5);
                const double l = 1.3 * linear, xx = 1.0 + l * v.dxx[p], yy = 1.0 + l * v.dyy[p], xy = l * texel.dxy;
                lowest = fmin(lowest, xx * yy - xy * xy);
            }
        }
        assert_near(lowest, 1.0 - 1.3 * k * amplitude * deepening, 1e-3);
        bolan_sea_destroy(&sea);
    }
}

static void the_mean_jacobian_is_one(void **state) {
    (void)state;
    for (uint32_t seed = 0; seed < 5; seed++) {
        bolan_sea_desc desc = bolan_sea_desc_default();
        desc.seed = seed;
        desc.resolution = 128;
        bolan_sea *sea = test_sea(desc);
        bolan_sea_step(sea, 10.0 * seed);
        assert_near(bolan_sea_measure(sea).jacobian_mean, 1.0, 1e-3);
        bolan_sea_destroy(&sea);
    }
}

static void the_tiles_repeat(void **state) {
    (void)state;
    bolan_sea_desc desc = bolan_sea_desc_default();
    desc.waves = BOLAN_WAVES_TEXTURES; // of the open sea no tile is like another
    desc.resolution = 64;
    bolan_sea *sea = test_sea(desc);
    const bolan_cascade_view v = bolan_sea_cascade(sea, 0);
    double hs = 4.0 * sqrt(v.variance), sum = 0.0;
    for (int i = 0; i < 50; i++) {
        const bolan_sea_sample a = bolan_sea_sample_direct(sea, 13.7 * i, 3.1 * i * i, 5.0);
        const bolan_sea_sample b = bolan_sea_sample_direct(sea, 13.7 * i + v.length, 3.1 * i * i - 2.0 * v.length, 5.0);
        sum += pow(a.height - b.height, 2.0);
    }
    assert_true(sqrt(sum / 50.0) < 1e-5 * hs);
    bolan_sea_destroy(&sea);
}

// In a sea with a loop a time and the same one a loop later have the same bits, foam too; before 0 as well.
static void a_loop_closes(void **state) {
    (void)state;
    static const double times[] = {12.3, 0.0, 199.999, 57.125};
    bolan_sea_desc desc = bolan_sea_desc_default();
    desc.resolution = 64;
    desc.foam_decay = 0.7;
    for (int i = 0; i < 3; i++) {
        desc.loop_period = (double[]){200.0, 33.3, 10.0}[i];
        bolan_sea *sea = test_sea(desc), *later = test_sea(desc);
        const bolan_cascade_view v = bolan_sea_cascade(sea, 1), w = bolan_sea_cascade(later, 1);
        const size_t bytes = (size_t)v.n * v.n * sizeof(float);
        const size_t texels = (size_t)v.n * v.pitch * sizeof *v.displacement;
        for (int t = 0; t < 4; t++) {
            for (int loops = -3; loops <= 40; loops += 43) {
                bolan_sea_settle(sea, times[t]);
                bolan_sea_settle(later, times[t] + loops * desc.loop_period);
                bolan_sea_fields(sea);
                bolan_sea_fields(later);
                assert_memory_equal(v.displacement, w.displacement, texels);
                assert_memory_equal(v.foam, w.foam, bytes);
            }
            bolan_sea_settle(later, times[t] + 0.5 * desc.loop_period); // it does move in between
            bolan_sea_fields(later);
            assert_memory_not_equal(v.displacement, w.displacement, texels);
        }
        bolan_sea_destroy(&sea);
        bolan_sea_destroy(&later);
    }
}

// The sums over the modes that the eight planes should hold at sample (i, j), in double.
typedef struct exact {
    const bolan_cascade_view *v;
    double x, y, time, plane[8];
} exact;

static void add_exact(void *context, const sea_mode *m) {
    exact *e = context;
    const double h = e->v->length / e->v->n, c = cos(e->v->angle), s = sin(e->v->angle);
    const double ku = m->kx * c + m->ky * s, kv = m->ky * c - m->kx * s;
    const double cubic = cubic_divisor(ku * h) * cubic_divisor(kv * h),
                 linear = linear_divisor(ku * h) * linear_divisor(kv * h);
    const double complex turned = cexp(-2.0 * I * BOLAN_PI * remainder(m->turns * e->time, 1.0));
    const double complex wave = cexp(I * (ku * e->x + kv * e->y)) * (m->paired ? 2.0 : 1.0) *
                                ((m->re + I * m->im) * turned + (m->back_re + I * m->back_im) * conj(turned));
    const double g = m->inverse_k, re = creal(wave), im = cimag(wave);
    const double plane[8] = {re / cubic,
                             -im * m->kx * g / cubic,
                             -im * m->ky * g / cubic,
                             -im * m->kx / linear,
                             -im * m->ky / linear,
                             -re * m->kx * m->kx * g / linear,
                             -re * m->ky * m->ky * g / linear,
                             -re * m->kx * m->ky * g / linear};
    for (int f = 0; f < 8; f++) e->plane[f] += plane[f];
}

// Every plane at samples of a cascade against the sum over its modes.
static void the_planes_are_the_direct_sum(void **state) {
    (void)state;
    bolan_sea_desc desc = bolan_sea_desc_default();
    desc.fft.cascade_count = 1;
    for (uint32_t n = 32; n <= 1024; n *= 4) {
        desc.resolution = n;
        bolan_sea *sea = test_sea(desc);
        bolan_sea_step(sea, 86400.25); // a day: phases of 1e5 turns
        const bolan_cascade_view v = bolan_sea_cascade(sea, 0);
        const twin_field fields[8] = {TWIN_TEXELS(&v, height), TWIN_TEXELS(&v, dx),     TWIN_TEXELS(&v, dy),
                                      TWIN_PLANE(&v, slope_x), TWIN_PLANE(&v, slope_y), TWIN_PLANE(&v, dxx),
                                      TWIN_PLANE(&v, dyy),     TWIN_TEXELS(&v, dxy)};
        double error[8] = {0};
        const double hs = 4.0 * sqrt(v.variance);
        const int count = n > 256 ? 8 : 40;
        for (int s = 0; s < count; s++) {
            const uint32_t i = (uint32_t)(s * 37) % n, j = (uint32_t)(s * s * 11 + 5) % n;
            exact e = {.v = &v, .x = i * v.length / n, .y = j * v.length / n, .time = 86400.25};
            bolan_sea_each_mode(&cascade_tables_of(sea->shared)->cascade[0], add_exact, &e);
            for (int f = 0; f < 8; f++) error[f] += pow(twin_at(fields[f], i, j) - e.plane[f], 2.0) / count;
        }
        for (int f = 0; f < 3; f++) assert_true(sqrt(error[f]) < 1e-5 * hs); // 32-bit synthesis, phases reduced in 64
        for (int f = 3; f < 8; f++) assert_true(sqrt(error[f]) < 1e-5);      // of quantities of order 0.1 and 1
        bolan_sea_destroy(&sea);
    }
}

// Between samples too: what is left are the images of the shortest waves (cascades/spline.h). The rms of each quantity
// relative to its own.
static void the_surface_is_the_direct_sum(void **state) {
    (void)state;
    bolan_sea_desc desc = bolan_sea_desc_default();
    desc.resolution = 128;
    bolan_sea *sea = test_sea(desc);
    bolan_sea_step(sea, 86400.25);
    enum { COUNT = 100 };
    double error[6] = {0}, size[6] = {0};
    for (int s = 0; s < COUNT; s++) {
        const bolan_dvec2 at = {731.7 * s - 3e4, 13.3 * s * s};
        const bolan_sea_sample d = bolan_sea_sample_direct(sea, at.x, at.y, 86400.25);
        bolan_sea_sample f;
        bolan_sea_sample_rest(sea, &at, 1, &f);
        const double truth[6] = {d.height, d.dx, d.dy, d.slope_x, d.slope_y, d.jacobian - 1.0},
                     found[6] = {f.height, f.dx, f.dy, f.slope_x, f.slope_y, f.jacobian - 1.0};
        for (int q = 0; q < 6; q++) error[q] += pow(found[q] - truth[q], 2.0), size[q] += truth[q] * truth[q];
    }
    for (int q = 0; q < 6; q++) {
        print_message("rms error %.5f of the rms\n", sqrt(error[q] / size[q]));
        assert_true(sqrt(error[q] / size[q]) < (q < 3 ? 0.015 : 0.05));
    }
    bolan_sea_destroy(&sea);
}

// Halfs are the fields to 11 bits.
static void half_fields_are_the_float_fields(void **state) {
    (void)state;
    bolan_sea_desc desc = bolan_sea_desc_default();
    desc.resolution = 64;
    bolan_sea *sea = test_sea(desc);
    for (uint32_t c = 0; c < bolan_sea_cascade_count(sea); c++) {
        const bolan_cascade_view v = bolan_sea_cascade(sea, c);
        const twin_field fields[8] = {TWIN_TEXELS(&v, dx),  TWIN_TEXELS(&v, dy),     TWIN_TEXELS(&v, height),
                                      TWIN_TEXELS(&v, dxy), TWIN_PLANE(&v, slope_x), TWIN_PLANE(&v, slope_y),
                                      TWIN_PLANE(&v, dxx),  TWIN_PLANE(&v, dyy)};
        for (uint32_t p = 0; p < v.n * v.n; p++) {
            for (int f = 0; f < 8; f++) {
                const uint16_t h = (f < 4 ? v.displacement_half : v.slope_half)[4 * p + (uint32_t)(f % 4)];
                const double want = twin_at(fields[f], p % v.n, p / v.n);
                const double magnitude =
                    (h >> 10 & 31) == 0 ? ldexp(h & 1023, -24) : ldexp(1024 + (h & 1023), (h >> 10 & 31) - 25);
                assert_near(h & 0x8000 ? -magnitude : magnitude, want, fmax(fabs(want) * 0x1p-11, 0x1p-25));
            }
        }
    }
    bolan_sea_destroy(&sea);
}

// Finite differences of the displaced surface against the analytic normals.
static void normals_are_those_of_the_displaced_surface(void **state) {
    (void)state;
    bolan_sea_desc desc = bolan_sea_desc_default();
    desc.fft.cascade_count = 2;
    desc.resolution = 64;
    bolan_sea *sea = test_sea(desc);
    const double e = 0.01;
    double sum = 0.0;
    const int count = 40;
    for (int s = 0; s < count; s++) {
        const double x = 17.3 * s, y = 5.1 * s * s;
        bolan_sea_sample q[4];
        for (int c = 0; c < 4; c++)
            q[c] = bolan_sea_sample_direct(sea,
                                           x + (c == 0   ? e
                                                : c == 1 ? -e
                                                         : 0.0),
                                           y + (c == 2   ? e
                                                : c == 3 ? -e
                                                         : 0.0),
                                           7.0);
        const bolan_sea_sample at = bolan_sea_sample_direct(sea, x, y, 7.0);
        const double ux = 2.0 * e + q[0].dx - q[1].dx, uy = q[0].dy - q[1].dy, uz = q[0].height - q[1].height;
        const double vx = q[2].dx - q[3].dx, vy = 2.0 * e + q[2].dy - q[3].dy, vz = q[2].height - q[3].height;
        const double nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx;
        const double dot = (-nx * at.slope_x - ny * at.slope_y + nz) / sqrt(nx * nx + ny * ny + nz * nz) /
                           sqrt(1.0 + at.slope_x * at.slope_x + at.slope_y * at.slope_y);
        sum += pow(bolan_degrees(acos(fmin(dot, 1.0))), 2.0) / count;
    }
    assert_true(sqrt(sum) < 0.5);
    bolan_sea_destroy(&sea);
}

RUN_TESTS(cmocka_unit_test(a_wave_keeps_its_phase_speed_for_a_minute), cmocka_unit_test(crests_gather_the_water),
          cmocka_unit_test(the_mean_jacobian_is_one), cmocka_unit_test(the_tiles_repeat),
          cmocka_unit_test(a_loop_closes), cmocka_unit_test(the_planes_are_the_direct_sum),
          cmocka_unit_test(the_surface_is_the_direct_sum), cmocka_unit_test(half_fields_are_the_float_fields),
          cmocka_unit_test(normals_are_those_of_the_displaced_surface))

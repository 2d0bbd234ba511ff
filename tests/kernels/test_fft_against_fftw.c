// SPDX-License-Identifier: MIT
// A whole cascade against FFTW in double: the modes, put into a complex spectrum by the definition, transformed by a
// library that nobody here wrote.
#include "support.h"

#include "waves/cascades/cascades.h"

#include <fftw3.h> // before complex.h: its numbers are then arrays of two

#include <complex.h>

typedef struct spectrum {
    uint32_t n;
    double step, c, s, time;
    fftwf_complex *h;
} spectrum;

static double sinc4(double x) { return x != 0.0 ? pow(sin(x) / x, 4.0) : 1.0; }

static void put(spectrum *g, double kx, double ky, double re, double im) {
    const int i = (int)lround((kx * g->c + ky * g->s) / g->step), j = (int)lround((ky * g->c - kx * g->s) / g->step);
    const uint32_t mask = g->n - 1, at = ((uint32_t)j & mask) * g->n + ((uint32_t)i & mask);
    const double inverse = sinc4(BOLAN_PI * i / g->n) * sinc4(BOLAN_PI * j / g->n); // planes are read by cubic splines
    g->h[at][0] += (float)(re / inverse); // a mode may have several waves
    g->h[at][1] += (float)(im / inverse);
}

static void put_mode(void *context, const sea_mode *m) {
    spectrum *g = context;
    const double phase = 2.0 * BOLAN_PI * m->turns * g->time;
    const double complex forth = m->re + I * m->im, back = m->back_re + I * m->back_im;
    const double complex h = forth * cexp(-I * phase) + back * cexp(I * phase);
    put(g, m->kx, m->ky, creal(h), cimag(h));
    if (m->paired) put(g, -m->kx, -m->ky, creal(h), -cimag(h));
}

static void compare(uint32_t n) {
    bolan_sea_desc desc = bolan_sea_desc_default();
    desc.resolution = n;
    bolan_sea *sea = NULL;
    assert_int_equal(bolan_sea_create(&desc, &sea), BOLAN_OK);
    bolan_sea_step(sea, 123.4);
    for (uint32_t index = 0; index < bolan_sea_cascade_count(sea); index++) {
        const sea_cascade *c = &cascade_tables_of(sea->shared)->cascade[index];
        const bolan_cascade_view v = bolan_sea_cascade(sea, index);
        spectrum g = {n, 2.0 * BOLAN_PI / c->length, c->cosine, c->sine, 123.4, fftwf_alloc_complex((size_t)n * n)};
        fftwf_plan plan = fftwf_plan_dft_2d((int)n, (int)n, g.h, g.h, FFTW_BACKWARD, FFTW_ESTIMATE);
        for (size_t p = 0; p < (size_t)n * n; p++) g.h[p][0] = g.h[p][1] = 0.0f;
        bolan_sea_each_mode(c, put_mode, &g);
        fftwf_execute(plan);
        double error = 0.0, imaginary = 0.0;
        for (size_t p = 0; p < (size_t)n * n; p++) {
            error += pow(g.h[p][0] - v.displacement[p / n * v.pitch + p % n].height, 2.0);
            imaginary += pow(g.h[p][1], 2.0);
        }
        const double hs = 4.0 * sqrt(c->band->variance);
        assert_near(sqrt(error) / n, 0.0, 1e-4 * hs); // 1e-4 Hs: what 32-bit floats allow
        assert_near(sqrt(imaginary) / n, 0.0, 1e-6 * 0.25 * hs);
        fftwf_destroy_plan(plan);
        fftwf_free(g.h);
    }
    bolan_sea_destroy(&sea);
}

static void heights_are_the_transform_of_the_modes(void **state) {
    (void)state;
    for (uint32_t n = 32; n <= 512; n *= 2) compare(n);
}

RUN_TESTS(cmocka_unit_test(heights_are_the_transform_of_the_modes))

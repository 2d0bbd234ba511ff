// SPDX-License-Identifier: MIT The distribution of maximum entropy with given Fourier moments: D(th) = exp(l0 + l1
// cos th + l2 sin th + l3 cos 2th + l4 sin 2th) (Kobune & Hashimoto, "Estimation of directional spectra from the
// maximum entropy principle", OMAE 1986; by Newton's method: Kim, Lin & Wang, "Numerical algorithm for the maximum
// entropy method", 1995). The multipliers minimise the convex function  ln Z(l) - l.m , Z = the sum of the
// exponentials, whose gradient is (moments of D) - m.
//
// The plain Fourier sum is negative in every eighth bin of a real buoy record, and clipping it turns and widens the
// spread by degrees; this form keeps the reported direction and spread exactly.
#include "formats/directional.h"

#include "bolan/math.h"
#include "spectrum/portable.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

enum { BINS = DIRECTIONAL_BINS, MOMENTS = 4 };

double bolan_directional_angle(uint32_t j) { return 2.0 * BOLAN_PI * j / BINS; }

static void normalize(double density[BINS]) {
    double sum = 0.0;
    for (uint32_t j = 0; j < BINS; j++) sum += density[j];
    for (uint32_t j = 0; j < BINS; j++) density[j] /= sum * (2.0 * BOLAN_PI / BINS);
}

static void basis(uint32_t j, double phi[MOMENTS]) {
    const double th = bolan_directional_angle(j);
    bolan_sincos(th, &phi[1], &phi[0]);
    bolan_sincos(2.0 * th, &phi[3], &phi[2]);
}

// Probabilities of the bins for multipliers l; returns ln Z - l.m.
static double evaluate(double phi[BINS][MOMENTS], const double *l, const double *m, double p[BINS]) {
    double largest = -HUGE_VAL, z = 0.0, dot = 0.0;
    for (uint32_t j = 0; j < BINS; j++) {
        p[j] = l[0] * phi[j][0] + l[1] * phi[j][1] + l[2] * phi[j][2] + l[3] * phi[j][3];
        largest = fmax(largest, p[j]);
    }
    for (uint32_t j = 0; j < BINS; j++) z += p[j] = portable_exp(p[j] - largest);
    for (uint32_t j = 0; j < BINS; j++) p[j] /= z;
    for (int a = 0; a < MOMENTS; a++) dot += l[a] * m[a];
    return largest + portable_log(z) - dot;
}

// Gradient and Hessian (the covariance of the basis); returns the largest component of the gradient.
static double derivatives(double phi[BINS][MOMENTS], const double *p, const double *m, double gradient[MOMENTS],
                          double hessian[MOMENTS][MOMENTS]) {
    double mean[MOMENTS] = {0}, worst = 0.0;
    memset(hessian, 0, sizeof(double[MOMENTS][MOMENTS]));
    for (uint32_t j = 0; j < BINS; j++)
        for (int a = 0; a < MOMENTS; a++) {
            mean[a] += p[j] * phi[j][a];
            for (int b = 0; b < MOMENTS; b++) hessian[a][b] += p[j] * phi[j][a] * phi[j][b];
        }
    for (int a = 0; a < MOMENTS; a++) {
        for (int b = 0; b < MOMENTS; b++) hessian[a][b] -= mean[a] * mean[b];
        hessian[a][a] += 1e-12; // a sharp peak leaves the covariance singular
        gradient[a] = mean[a] - m[a];
        worst = fmax(worst, fabs(gradient[a]));
    }
    return worst;
}

// x := A^-1 x for a symmetric positive matrix, by elimination.
static void solve(double a[MOMENTS][MOMENTS], double x[MOMENTS]) {
    for (int i = 0; i < MOMENTS; i++)
        for (int r = i + 1; r < MOMENTS; r++) {
            const double f = a[r][i] / a[i][i];
            for (int c = i; c < MOMENTS; c++) a[r][c] -= f * a[i][c];
            x[r] -= f * x[i];
        }
    for (int i = MOMENTS - 1; i >= 0; i--) {
        for (int c = i + 1; c < MOMENTS; c++) x[i] -= a[i][c] * x[c];
        x[i] /= a[i][i];
    }
}

// Newton with halved steps; false when the moments fit no distribution.
static bool maximum_entropy(const double m[MOMENTS], double p[BINS]) {
    double phi[BINS][MOMENTS], l[MOMENTS] = {0};
    for (uint32_t j = 0; j < BINS; j++) basis(j, phi[j]);
    double value = evaluate(phi, l, m, p);
    for (int iteration = 0; iteration < 60; iteration++) {
        double step[MOMENTS], hessian[MOMENTS][MOMENTS], trial[MOMENTS], trial_value = HUGE_VAL;
        if (derivatives(phi, p, m, step, hessian) < 1e-7) return true;
        solve(hessian, step);
        for (double size = 1.0; size > 1e-4 && !(trial_value <= value); size *= 0.5) {
            for (int a = 0; a < MOMENTS; a++) trial[a] = l[a] - size * step[a];
            trial_value = evaluate(phi, trial, m, p);
        }
        if (!(trial_value <= value)) return false;
        value = trial_value;
        memcpy(l, trial, sizeof l);
    }
    return false;
}

static void clipped_fourier(const double m[MOMENTS], double density[BINS]) {
    for (uint32_t j = 0; j < BINS; j++) {
        double phi[MOMENTS];
        basis(j, phi);
        density[j] = fmax(0.5 + m[0] * phi[0] + m[1] * phi[1] + m[2] * phi[2] + m[3] * phi[3], 0.0);
    }
}

void bolan_directional_from_moments(directional_moments d, double density[BINS]) {
    double m[MOMENTS];
    bolan_sincos(d.a1, &m[1], &m[0]);
    bolan_sincos(2.0 * d.a2, &m[3], &m[2]);
    m[0] *= d.r1;
    m[1] *= d.r1;
    m[2] *= d.r2;
    m[3] *= d.r2;
    if (!maximum_entropy(m, density)) clipped_fourier(m, density);
    normalize(density);
}

void bolan_directional_cos2s(double mean, double s, double density[BINS]) {
    for (uint32_t j = 0; j < BINS; j++) {
        double sine, cosine;
        bolan_sincos(bolan_directional_angle(j) - mean, &sine, &cosine);
        density[j] = portable_pow(fmax(0.5 * (1.0 + cosine), 1e-300), s); // cos^2(th/2) = (1 + cos th) / 2
    }
    normalize(density);
}

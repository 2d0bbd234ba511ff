// SPDX-License-Identifier: MIT
// Any depth of a band from four: the weights of the levels.
//
// The functions e^{-kd} of k, for all d >= 0, over a band whose ends are R apart, are nearly a space of few dimensions:
// the part that r exponentials cannot give falls by a constant factor with every one. Of r = 4 well-chosen depths the
// worst error over all d and k is 4e-3 for R = 6.4 and 1.5e-2 for R = 16 where the band counts evenly, a third of that
// root mean square, and less by energy. The depths of the levels, in units of the band's ends, are those of the least
// error of accelerations in seas of wind and swell (tests/physics/test_below.c prints it).
//
// For one d the weights a minimise  sum over bins of m_b (sum_l a_l e^{-k_b d_l} - target(k_b))^2,  so they are linear
// in the target. The table holds them at nodes in d with their derivatives by d, which are the weights of the target's
// derivative, and a cubic Hermite polynomial runs between nodes.
#include "flow/tables.h"
#include "spectrum/portable.h"

#include <string.h>

#define FIRST_DEPTH 0.75 // of level 1, over the shortest wave's 1/k
#define LAST_DEPTH 1.55  // of level 3, over the longest wave's 1/k
#define BETWEEN 0.68     // where level 2 lies between, in the logarithm
#define FLOOR 1e-3       // least weight of a bin, as a share of all
#define RIDGE 1e-9       // keeps weights small where levels are nearly the same function
#define FINEST 0.5       // unit of the table, over the shortest wave's 1/k

typedef double matrix[FLOW_LEVELS][FLOW_LEVELS];

// Cholesky's factor of a positive definite matrix, in its lower part.
static void factorise(matrix a) {
    for (int i = 0; i < FLOW_LEVELS; i++) {
        for (int j = 0; j <= i; j++) {
            double sum = a[i][j];
            for (int m = 0; m < j; m++) sum -= a[i][m] * a[j][m];
            a[i][j] = i == j ? sqrt(fmax(sum, 1e-30)) : sum / a[j][j];
        }
    }
}

static void solve(const matrix factor, double x[FLOW_LEVELS]) {
    for (int i = 0; i < FLOW_LEVELS; i++) {
        for (int m = 0; m < i; m++) x[i] -= factor[i][m] * x[m];
        x[i] /= factor[i][i];
    }
    for (int i = FLOW_LEVELS - 1; i >= 0; i--) {
        for (int m = i + 1; m < FLOW_LEVELS; m++) x[i] -= factor[m][i] * x[m];
        x[i] /= factor[i][i];
    }
}

// A least squares problem: weights and values of the levels at the bins.
typedef struct problem {
    double weight[FLOW_BINS], level[FLOW_BINS][FLOW_LEVELS];
    matrix factor;
} problem;

static void set_problem(const flow_levels *levels, const double weight[FLOW_BINS], problem *p) {
    memset(p, 0, sizeof *p);
    for (int b = 0; b < FLOW_BINS; b++) {
        p->weight[b] = weight[b];
        for (int l = 0; l < FLOW_LEVELS; l++) p->level[b][l] = portable_exp(-levels->bin[b].k * levels->depth[l]);
    }
    double trace = 0.0;
    for (int i = 0; i < FLOW_LEVELS; i++) {
        for (int j = 0; j < FLOW_LEVELS; j++)
            for (int b = 0; b < FLOW_BINS; b++) p->factor[i][j] += weight[b] * p->level[b][i] * p->level[b][j];
        trace += p->factor[i][i];
    }
    for (int i = 0; i < FLOW_LEVELS; i++) p->factor[i][i] += RIDGE * trace;
    factorise(p->factor);
}

// The weights of k^power e^{-kd}.
static void solve_target(const flow_levels *levels, const problem *p, double d, int power, float out[FLOW_LEVELS]) {
    double x[FLOW_LEVELS] = {0.0};
    for (int b = 0; b < FLOW_BINS; b++) {
        const double k = levels->bin[b].k;
        double target = p->weight[b] * portable_exp(-k * d);
        for (int i = 0; i < power; i++) target *= k;
        for (int l = 0; l < FLOW_LEVELS; l++) x[l] += target * p->level[b][l];
    }
    solve(p->factor, x);
    for (int l = 0; l < FLOW_LEVELS; l++) out[l] = (float)x[l];
}

// Depth of a node: cells of equal width in each octave of d + finest.
static double node_depth(const flow_levels *levels, int node) {
    return levels->finest * (ldexp(1.0 + (double)(node % FLOW_CELLS) / FLOW_CELLS, node / FLOW_CELLS) - 1.0);
}

static void set_node(flow_levels *levels, const problem *across, const problem *up, int node) {
    flow_node *n = &levels->node[node];
    const double d = node_depth(levels, node);
    solve_target(levels, across, d, 0, n->across);
    solve_target(levels, across, d, 1, n->across_slope);
    solve_target(levels, up, d, 1, n->up);
    solve_target(levels, up, d, 2, n->up_slope);
    for (int l = 0; l < FLOW_LEVELS; l++) { // d/dd e^{-kd} = -k e^{-kd}
        n->across_slope[l] = -n->across_slope[l];
        n->up_slope[l] = -n->up_slope[l];
    }
}

static void set_depths(flow_levels *levels) {
    const double first = FIRST_DEPTH / levels->k_high, last = LAST_DEPTH / levels->k_low,
                 span = portable_log(last / first);
    levels->depth[0] = 0.0;
    levels->depth[1] = first;
    levels->depth[2] = first * portable_exp(BETWEEN * span);
    levels->depth[3] = last;
    levels->finest = FINEST / levels->k_high;
}

void bolan_flow_fit(flow_levels *levels, double sea_depth) {
    double across[FLOW_BINS], up[FLOW_BINS], total = 0.0;
    for (int b = 0; b < FLOW_BINS; b++) total += levels->bin[b].motion;
    for (int b = 0; b < FLOW_BINS; b++) {
        const double k = levels->bin[b].k, all = 1.0 - portable_exp(-2.0 * k * sea_depth);
        across[b] = (levels->bin[b].motion + FLOOR * total + 1e-30) / (all * all);
        up[b] = across[b] / (k * k);
    }
    set_depths(levels);
    problem p, q;
    set_problem(levels, across, &p);
    set_problem(levels, up, &q);
    for (int node = 0; node < FLOW_NODES; node++) set_node(levels, &p, &q, node);
}

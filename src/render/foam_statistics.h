// SPDX-License-Identifier: MIT
// What the optics need to cover a given share of the sea with foam.
#ifndef BOLAN_FOAM_STATISTICS_H
#define BOLAN_FOAM_STATISTICS_H

#include "bolan/waves.h"

// The x at which the standard normal distribution reaches p.
double bolan_foam_quantile(double p);
// Slope variance of all waves, whichever model makes them.
double bolan_foam_slope_variance(const bolan_sea *sea);

// Weights of the cascades' foam memories in the foam that is drawn: short waves carry no whitecaps of their own.
bolan_vec4 bolan_foam_weights(const bolan_sea *sea);

// Standard deviation of the noise of fresh foam, in Jacobian.
double bolan_foam_breaking_edge(const bolan_sea *sea);

// Whether foam can form at some time, by the wind and by how steep the waves are.
bool bolan_foam_can_form(const bolan_sea *sea);

// Share of the sea under streaks of foam. Where nothing breaks, nothing is blown into streaks.
double bolan_foam_streak_share(const bolan_sea *sea);

// The law of shaders/shared/foam.glsl for a sea. Thresholds are those of a soft edge: the covered share is kept.
typedef struct foam_law {
    double breaking;          // a crest breaks where the Jacobian less 1 is below this: by the sea's own Jacobians
    double breaking_gaussian; // the same by the quantile of a Gaussian Jacobian; -FOAM_NEVER in a calm
    double variance;          // of the Jacobian, all waves
    double edge;              // variance that softens the edge of breaking crests
    double slopes_beyond;     // slope variance of what is no part of the waves
    double memory;            // foam memory where old foam begins; FOAM_NEVER in a calm and where there is no memory
    double memory_variance;   // of the foam memory
} foam_law;

// edge: standard deviation that softens the edge of breaking crests, in Jacobian. `memory`: its members are wanted,
// which takes the fields of the sea; else they are 0, and a GPU that has the fields makes them (sea_foam_law.glsl).
foam_law bolan_foam_law(const bolan_sea *sea, double edge, bool memory);
// What a GPU cannot know: how many standard deviations above the mean of the foam memory old foam begins, FOAM_NEVER
// where there is none, and the variance of the Jacobian.
void bolan_foam_law_constants(const bolan_sea *sea, float *offset, float *variance);

#endif

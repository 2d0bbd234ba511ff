// SPDX-License-Identifier: MIT
// What the optics need to cover a given share of the sea with foam.
#ifndef BOLAN_FOAM_STATISTICS_H
#define BOLAN_FOAM_STATISTICS_H

#include "bolan/waves.h"

// The x at which the standard normal distribution reaches p.
double bolan_foam_quantile(double p);
// Slope variance of all waves, whichever model makes them.
double bolan_foam_slope_variance(const bolan_sea *sea);
// Far above every sum of foam memories, and of the pinch of the surface: nothing foams.
#define FOAM_NEVER 1e3
// The foam memory above which `share` of the sea is covered by old foam, its edge softened by `softness` of its
// variance, which is set. FOAM_NEVER in a calm, and where there is no memory: with sums of waves.
double bolan_foam_memory_threshold(const bolan_sea *sea, double share, double softness, double *variance);
// The sum dxx + dyy, choppiness applied, below which a crest breaks: their sum is normal with variance choppiness^2 mss (*spread),
// so what covers the share of Monahan & O'Muircheartaigh (1980) is a quantile. A soft edge, of a normal distribution's standard
// deviation `edge`, widens the distribution, and the quantile with it. -FOAM_NEVER where no wind blows.
double bolan_foam_breaking_pinch(const bolan_sea *sea, double edge, double *spread);

#endif

// SPDX-License-Identifier: MIT
// What the optics need to cover a given share of the sea with foam.
#ifndef BOLAN_FOAM_STATISTICS_H
#define BOLAN_FOAM_STATISTICS_H

#include "bolan/waves.h"

// The x at which the standard normal distribution reaches p.
double foam_quantile(double p);
// Mean and variance of the summed foam memory, from a sparse lattice of each cascade.
void foam_memory_moments(const bolan_sea *sea, double *mean, double *variance);
// The sum dxx + dyy, choppiness applied, below which a crest breaks: their sum is normal with variance choppiness^2 mss (*spread),
// so what covers the share of Monahan & O'Muircheartaigh (1980) is a quantile. A soft edge, of a normal distribution's standard
// deviation `edge`, widens the distribution, and the quantile with it. -1e3 where no wind blows.
double foam_breaking_pinch(const bolan_sea *sea, double edge, double *spread);

#endif

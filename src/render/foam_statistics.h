// SPDX-License-Identifier: MIT
// What the optics need to cover a given share of the sea with foam.
#ifndef BOLAN_FOAM_STATISTICS_H
#define BOLAN_FOAM_STATISTICS_H

#include "bolan/waves.h"

// The x at which the standard normal distribution reaches p.
double foam_quantile(double p);
// Mean and variance of the summed foam memory, from a sparse lattice of each cascade.
void foam_memory_moments(const bolan_sea *sea, double *mean, double *variance);

#endif

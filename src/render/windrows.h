// SPDX-License-Identifier: MIT
// The tile of windrows: lines along the wind in which Langmuir's cells gather foam.
#ifndef BOLAN_RENDER_WINDROWS_H
#define BOLAN_RENDER_WINDROWS_H

#include "bolan/base.h"

#define WINDROWS_SIZE 512 // samples along a side

#define WINDROWS_DEVIATION 0.1

// Writes a periodic Gaussian field of mean 1/2 and standard deviation WINDROWS_DEVIATION, larger where more foam is:
// out[stride * (WINDROWS_SIZE * v + u)], u across and v along the wind. MEMORY when the scratch memory cannot be had.
bolan_result bolan_windrows_fill(float *out, uint32_t stride);

#endif

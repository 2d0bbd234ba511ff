// SPDX-License-Identifier: MIT
// Second-order bound waves: how two free waves raise the surface by the square of their steepness.
// Private to src/waves.
//
// With eta1 = sum a_i cos psi_i, psi_i = k_i.x - w_i t + phase_i, the surface to second order is eta1 + eta2,
//
//     eta2 = 1/4 sum_i sum_j a_i a_j [ sum(i, j) cos(psi_i + psi_j) + difference(i, j) cos(psi_i - psi_j) ].
//
// Sharma & Dean, Soc. Petrol. Eng. J. 21 (1981), as Forristall, J. Phys. Oceanogr. 30 (2000), has it; deep water:
// Longuet-Higgins, J. Fluid Mech. 17 (1963). Waves along one line in deep water have sum = k_i + k_j and
// difference = -|k_i - k_j|. Gravity alone; capillary waves have bound waves of their own.
#ifndef BOLAN_WAVES_SECOND_ORDER_H
#define BOLAN_WAVES_SECOND_ORDER_H

#include "bolan/math.h"

// Kernels of a pair [1/m].
typedef struct second_order {
    double sum, difference;
} second_order;

// Of wave vectors k1 and k2 [rad/m], neither 0, in water of `depth` [m]. Symmetric in k1 and k2.
// The difference of a wave with itself is 0: the mean level stays.
second_order bolan_second_order(bolan_dvec2 k1, bolan_dvec2 k2, double depth);

#endif

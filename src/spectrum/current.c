// SPDX-License-Identifier: MIT
// Spectra on a uniform current U: from the frame in which a spectrum is given to the water that carries the waves.
//
// A wave k has sigma(k) in the water and omega = sigma + k.U over the ground. With c = U.k/|k|, along one direction
// d omega / d sigma = (cg + c) / cg. Where that is not positive the current blocks the wave.
//
//     ground   S(sigma) = S(omega) d omega / d sigma                 one who stands in the current
//     still    S(sigma) = S0(omega) (sigma / omega) (cg0 / cg)       one in still water
//
// The second keeps the flux of action, S(omega) (cg + c) / sigma = S0(omega) cg0 / omega, cg0 and S0 being those of
// still water (Bretherton & Garrett, Proc. R. Soc. A 302 (1968)); in deep water it is eq. 2.17 of Huang, Chen, Tung &
// Smith, J. Phys. Oceanogr. 2 (1972).
//
// Group speeds fall with k as far as the gravity-capillary waves of 43 mm and rise from there. A current above the
// least group speed blocks all waves beyond the first that it blocks: ripples that outrun it have not come through it.
#include "spectrum/spectrum_eval.h"

#define LEAST_GROUP_K 145.49     // [rad/m]: (sqrt(4/3) - 1)^(1/2) (g rho / sigma)^(1/2)
#define LEAST_GROUP_SPEED 0.1769 // [m/s]

spectrum_seen bolan_spectrum_seen(const spectrum_eval *eval, double sigma, double k, double group, double ux,
                                  double uy) {
    const double along = ux * eval->current_x + uy * eval->current_y, omega = sigma + k * along;
    const bool beyond = along < -LEAST_GROUP_SPEED && k > LEAST_GROUP_K;
    if (beyond || !(group + along > 0.0) || !(omega > 0.0)) return (spectrum_seen){0.0, 0.0};
    if (eval->frame == BOLAN_FRAME_GROUND) return (spectrum_seen){omega, (group + along) / group};
    const double still = bolan_group_speed(bolan_k_from_omega(omega, eval->depth), eval->depth);
    return (spectrum_seen){omega, sigma / omega * (still / group)};
}

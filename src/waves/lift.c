// SPDX-License-Identifier: MIT
// The lift: what keeps the mean of the surface at fixed points at the water level.
//
// Parcels gather at crests, where they stand closer, but a parcel counts by the area that it covers: the Jacobian of
// the horizontal map. With eta = a cos th and choppiness * D = -c a coth(kh) sin th the mean at fixed points is
//
//     <eta J> = <eta (1 + c div D)> = -c k coth(kh) a^2 / 2                                                         (1)
//
// and of a spectrum -c int k coth(kh) S dw, exactly so while nothing folds: the second-order part of J is the product
// of three Gaussians with eta, whose mean is 0. That is the set-down of a "choppy" sea (Nouguier, Guerin & Chapron
// 2009). Every parcel is raised by its opposite.
//
// The surface that is asked and drawn has every wave at its amplitude (cascades/spline.h), and so this mean. A coarse
// grid low-passes it: a square of two spacings s, averaged, leaves (sin(kx s)/(kx s) * sin(ky s)/(ky s))^2 of it. So
// the lift is a table over the logarithm of the spacing, one for each band of waves. Waves of different lengths do not
// mix in (1): the lifts add. cascades/lift.c and sum/build.c fill the tables.
#include "spectrum/portable.h"
#include "waves/sea.h"

double bolan_sea_lift_spacing(const sea_lift *lift, int level) {
    return level > 0 ? lift->finest * portable_pow(2.0, level / LIFT_PER_OCTAVE) : 0.0;
}

double bolan_sea_lift_at(const sea_lift *lift, double spacing) {
    if (!(spacing > lift->finest) || !(lift->finest > 0.0)) return lift->level[0];
    const double x = LIFT_PER_OCTAVE * portable_log(spacing / lift->finest) / 0.69314718055994531;
    if (x >= LIFT_LEVELS - 1) return 0.0;
    const int i = (int)x;
    return lift->level[i] + (lift->level[i + 1] - lift->level[i]) * (x - i);
}

double bolan_sea_lift(const bolan_sea *sea, uint32_t index, double spacing) {
    BOLAN_ASSERT(sea && index < sea->shared->bands);
    return bolan_sea_lift_at(&sea->shared->band[index].lift, spacing);
}

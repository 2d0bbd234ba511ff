// SPDX-License-Identifier: MIT
// The warped plane (bolan/waves.h): which waves it has.
//
// The correlation of a wave k with itself a vector r of the lattice away is, averaged over places, the product over the
// warp's waves of J0(2 (k . a) sin(pi q . r)). Six waves of 4 to 69 tiles, their lengths and directions found by trying
// some ten thousand sets, keep it below 0.15 for every sea of 16 peak wavelengths a tile within 40 tiles. Each moves
// water across its own direction, so that areas stay what they are, and bends it by STEEPNESS at most, all together by
// 5 % rms.
#include "shared/warp.glsl"
#include "spectrum/portable.h"
#include "waves/cascades/cascades.h"

#define STEEPNESS 0.036 // largest gradient of each wave

static const struct {
    double length, angle; // [tiles], and direction against the first tile [rad]
} waves[BOLAN_WARP_WAVES] = {{3.6738, 2.5670},  {6.5971, 5.3014},  {11.8465, 4.6603},
                             {21.2729, 4.1216}, {38.1998, 3.6918}, {68.5956, 3.1631}};

void bolan_sea_warp_prepare(double length, double angle, bolan_sea_warp *out) {
    out->count = BOLAN_WARP_WAVES;
    for (int i = 0; i < BOLAN_WARP_WAVES; i++) {
        double s, c;
        bolan_sincos(angle + waves[i].angle, &s, &c);
        const double wavelength = length * waves[i].length, amplitude = STEEPNESS * wavelength / WARP_STEEPEST;
        out->wave[i].kx = c / wavelength;
        out->wave[i].ky = s / wavelength;
        out->wave[i].phase = 0.37 + 0.61 * i;
        out->wave[i].ax = -s * amplitude;
        out->wave[i].ay = c * amplitude;
    }
}

bolan_dvec2 bolan_sea_warped(const bolan_sea_warp *warp, double x, double y, double gradient[4]) {
    bolan_dvec2 at = {x, y};
    gradient[0] = gradient[3] = 1.0;
    gradient[1] = gradient[2] = 0.0;
    for (uint32_t i = 0; i < warp->count; i++) {
        const double kx = warp->wave[i].kx, ky = warp->wave[i].ky, ax = warp->wave[i].ax, ay = warp->wave[i].ay;
        const double turns = kx * x + ky * y + warp->wave[i].phase, in = turns - floor(turns);
        const double value = warp_wave(in), slope = warp_slope(in);
        at.x += ax * value;
        at.y += ay * value;
        gradient[0] += ax * slope * kx;
        gradient[1] += ax * slope * ky;
        gradient[2] += ay * slope * kx;
        gradient[3] += ay * slope * ky;
    }
    return at;
}

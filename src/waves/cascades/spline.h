// SPDX-License-Identifier: MIT
// How the fields of a cascade are read between its samples, and what that does to a wave.
//
// A uniform B-spline of degree d over samples h apart takes a wave of wave number k along an axis to
// sinc^{d+1}(k h / 2) of its amplitude, and adds images of it at k + 2 pi m / h. Every mode is divided, before it is
// transformed, by what its reader does to it along both axes:
//
//     planes              read by        divisor
//     height, dx, dy      cubic spline   sinc^4(k h / 2)        so the wave itself is exact at every point
//     their derivatives   linear fetch   sqrt((2 + cos kh) / 3) so its power, images included, is exact in the mean
//
// What is left are images. A wave along an axis has, after the spline, 0.084 of its amplitude and 0.16 of its slope
// where it is the shortest (kh = 0.7 pi, 2.9 samples), 0.012 and 0.037 with four samples. A linear fetch leaves 0.96
// of the wave itself, and 0.99 with four samples.
//
// So the planes of a cascade hold coefficients, not samples of the surface. The gradient of the cubic spline is
// continuous and exactly that of the surface, so queries take slopes and Jacobians from height, dx and dy as well
// (Unser 1999, "Splines: a perfect fit for signal and image processing"). Shaders evaluate it by four linear fetches
// (Sigg & Hadwiger 2005), and its gradient from 16 texels: shaders/common/sea.glsl. Pixels whose footprint is shorter
// than a texel take that gradient where the quality allows its cost; others fetch the derivatives linearly.
#ifndef BOLAN_WAVES_SPLINE_H
#define BOLAN_WAVES_SPLINE_H

// Weights of the four samples around a fraction t of a cell, from the one before the cell on, and their derivatives by
// t: of the type of t, double or float.
#define SPLINE_WEIGHTS(real, t, w, d)                                            \
    do {                                                                         \
        const real t2 = (t) * (t), t3 = t2 * (t), r = (real)1 - (t), r2 = r * r; \
        (w)[0] = r2 * r * (real)(1.0 / 6.0);                                     \
        (w)[1] = (real)0.5 * t3 - t2 + (real)(2.0 / 3.0);                        \
        (w)[2] = (real)0.5 * (t2 + (t)-t3) + (real)(1.0 / 6.0);                  \
        (w)[3] = t3 * (real)(1.0 / 6.0);                                         \
        (d)[0] = (real)-0.5 * r2;                                                \
        (d)[1] = (real)1.5 * t2 - (real)2 * (t);                                 \
        (d)[2] = (t) + (real)0.5 - (real)1.5 * t2;                               \
        (d)[3] = (real)0.5 * t2;                                                 \
    } while (0)

#endif

// SPDX-License-Identifier: MIT
// How much window depth may differ between two ways of drawing the same surface.

// Depth is interpolated between vertices, of which the nearest lie at 1: each GPU rounds it by some 2^-23 of that,
// however small the depth itself is. Far water, at 2^-16, is lost to a test that allows for less.
const float DEPTH_ROUNDING = 9.5e-7; // 2^-20

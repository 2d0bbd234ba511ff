// SPDX-License-Identifier: MIT
// Members of the uniform block Optics of the lit optics, written by src/render/papers/lit.c.
float foam_jacobian;       // Jacobian below which water foams
float foam_edge;           // softness of that edge, in Jacobian
float slopes_beyond_waves; // slope variance of what is no part of the waves
float lit_padding;         // the block's size is a multiple of 16 bytes

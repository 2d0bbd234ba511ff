// SPDX-License-Identifier: MIT
// Members of the uniform block Optics of the phong optics, written by src/render/papers/phong.c.
vec4 wander_eye;       // the eye in the two tiles of wander_of() [0,1)
float wander_fine;     // tiles per metre
float wander_broad;    // likewise of the broader tile
float reflection_push; // dC of the paper: how far a fetch of the reflection moves for a normal of 1 [m]
float refraction_push; // likewise of the refraction

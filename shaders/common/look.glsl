// SPDX-License-Identifier: MIT
// How a technique is carried out: bolan_look for the shaders; src/render/water_optics.c sets it.
#include "shared/constants.glsl"
uniform vec4 look_light; // ambient, diffuse, specular, shininess
uniform vec4 look_mix;   // distortion, blend, paper: 1, what is shown: a bolan_show
uniform int look_effects;

bool effect_is_on(int effect) { return (look_effects & effect) != 0; }

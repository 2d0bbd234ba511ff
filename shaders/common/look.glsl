// SPDX-License-Identifier: MIT
// How a technique is carried out: bolan_look for the shaders; src/render/water_optics.c sets it.
uniform vec4 look_light; // ambient, diffuse, specular, shininess
uniform vec4 look_mix;   // distortion, blend, paper: 1, what is shown: a bolan_show
uniform int look_effects;

const int EFFECT_REFLECTION = 1, EFFECT_REFRACTION = 2, EFFECT_BUMP = 4, EFFECT_DISTORTION = 8, EFFECT_GLITTER = 16,
          EFFECT_CAUSTICS = 32, EFFECT_AMBIENT = 64, EFFECT_DIFFUSE = 128, EFFECT_SPECULAR = 256,
          EFFECT_SCATTERING = 512, EFFECT_FOAM = 1024, EFFECT_FOG = 2048;

bool effect_is_on(int effect) { return (look_effects & effect) != 0; }

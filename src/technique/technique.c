// SPDX-License-Identifier: MIT
// The techniques: a wave model, a surface and an optics under one name.
#include "bolan/technique.h"
#include "shared/constants.glsl"

#include <string.h>

#define OCEAN \
    { "ocean", BOLAN_WAVES_FFT, BOLAN_SURFACE_PROJECTED, BOLAN_OPTICS_PHYSICAL, -1 }
#define TWO_TRIANGLE \
    { "two-triangle", BOLAN_WAVES_TEXTURES, BOLAN_SURFACE_QUAD, BOLAN_OPTICS_MIRROR, -1 }
#define EXP_COSINE \
    { "exp-cosine", BOLAN_WAVES_EXP_COSINE, BOLAN_SURFACE_QUAD, BOLAN_OPTICS_PHONG, -1 }
#define NESTED_GRID \
    { "nested-grid", BOLAN_WAVES_COSINES, BOLAN_SURFACE_NESTED, BOLAN_OPTICS_LIT, BOLAN_SPECTRUM_PIERSON_MOSKOWITZ }
#define FLIGHT_SIM \
    { "flight-sim", BOLAN_WAVES_FFT, BOLAN_SURFACE_PROJECTED, BOLAN_OPTICS_CREST, BOLAN_SPECTRUM_PHILLIPS }

const bolan_technique bolan_technique_ocean = OCEAN;
const bolan_technique bolan_technique_two_triangle = TWO_TRIANGLE;
const bolan_technique bolan_technique_exp_cosine = EXP_COSINE;
const bolan_technique bolan_technique_nested_grid = NESTED_GRID;
const bolan_technique bolan_technique_flight_sim = FLIGHT_SIM;

static const bolan_technique techniques[] = {OCEAN, TWO_TRIANGLE, EXP_COSINE, NESTED_GRID, FLIGHT_SIM};

const char *const bolan_optics_kind_names[BOLAN_OPTICS_KINDS + 1] = {"physical", "mirror", "phong",
                                                                     "lit",      "crest",  NULL};

_Static_assert(EFFECT_REFLECTION == BOLAN_EFFECT_REFLECTION && EFFECT_REFRACTION == BOLAN_EFFECT_REFRACTION &&
                   EFFECT_BUMP == BOLAN_EFFECT_BUMP && EFFECT_DISTORTION == BOLAN_EFFECT_DISTORTION &&
                   EFFECT_GLITTER == BOLAN_EFFECT_GLITTER && EFFECT_CAUSTICS == BOLAN_EFFECT_CAUSTICS &&
                   EFFECT_AMBIENT == BOLAN_EFFECT_AMBIENT && EFFECT_DIFFUSE == BOLAN_EFFECT_DIFFUSE &&
                   EFFECT_SPECULAR == BOLAN_EFFECT_SPECULAR && EFFECT_SCATTERING == BOLAN_EFFECT_SCATTERING &&
                   EFFECT_FOAM == BOLAN_EFFECT_FOAM && EFFECT_FOG == BOLAN_EFFECT_FOG,
               "the shaders test the bits that the public header states");

const char *const bolan_effect_names[BOLAN_EFFECTS + 1] = {
    "reflection", "refraction", "bump",       "distortion", "glitter", "caustics", "ambient",
    "diffuse",    "specular",   "scattering", "foam",       "fog",     NULL};
const char *const bolan_show_names[BOLAN_SHOWS + 1] = {"picture", "mask", "mesh", NULL};

const bolan_technique *bolan_techniques(uint32_t *count) {
    *count = sizeof techniques / sizeof *techniques;
    return techniques;
}

const bolan_technique *bolan_technique_find(const char *name) {
    for (size_t i = 0; i < sizeof techniques / sizeof *techniques; i++)
        if (strcmp(techniques[i].name, name) == 0) return &techniques[i];
    return NULL;
}

bolan_look bolan_look_default(void) {
    bolan_look look;
    memset(&look, 0, sizeof look);
    bolan_params_default(&bolan_look_params, &look);
    return look;
}

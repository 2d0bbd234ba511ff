// SPDX-License-Identifier: MIT
// The techniques: a wave model, a surface and an optics under one name.
#include "bolan/technique.h"
#include "shared/constants.glsl"

#include <string.h>

// X(id, name, waves, surface, optics, spectrum of a wind sea: a bolan_spectrum_kind, or -1), the default first.
#define TECHNIQUES(X)                                                                     \
    X(ocean, "ocean", FFT, PROJECTED, PHYSICAL, -1)                                       \
    X(two_triangle, "two-triangle", TEXTURES, QUAD, MIRROR, -1)                           \
    X(exp_cosine, "exp-cosine", EXP_COSINE, QUAD, PHONG, -1)                              \
    X(nested_grid, "nested-grid", COSINES, NESTED, LIT, BOLAN_SPECTRUM_PIERSON_MOSKOWITZ) \
    X(flight_sim, "flight-sim", FFT, PROJECTED, CREST, BOLAN_SPECTRUM_PHILLIPS)

#define TECHNIQUE(name, waves, surface, optics, spectrum) \
    { (name), BOLAN_WAVES_##waves, BOLAN_SURFACE_##surface, BOLAN_OPTICS_##optics, (spectrum) }
#define CONSTANT(id, ...) const bolan_technique bolan_technique_##id = TECHNIQUE(__VA_ARGS__);
#define ENTRY(id, ...) TECHNIQUE(__VA_ARGS__),
#define NAME_OF(id, name, waves, surface, optics, spectrum) name,

TECHNIQUES(CONSTANT)
static const bolan_technique techniques[BOLAN_TECHNIQUES] = {TECHNIQUES(ENTRY)};
const char *const bolan_technique_names[BOLAN_TECHNIQUES + 1] = {TECHNIQUES(NAME_OF) NULL};

const char *const bolan_optics_kind_names[BOLAN_OPTICS_KINDS + 1] = {"physical", "mirror", "phong",
                                                                     "lit",      "crest",  NULL};

bool bolan_optics_seen_from_below(bolan_optics_kind optics) {
    return optics == BOLAN_OPTICS_PHYSICAL || optics == BOLAN_OPTICS_MIRROR;
}

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

const char *const bolan_quality_names[BOLAN_QUALITIES + 1] = {"low", "medium", "high", "ultra", NULL};
const char *const bolan_backend_names[BOLAN_BACKENDS + 1] = {"auto", "cpu", "compute", NULL};

const char *const bolan_pixels_names[BOLAN_PIXELS + 1] = {"auto", "fragment", "compute", NULL};

const bolan_technique *bolan_techniques(uint32_t *count) {
    *count = BOLAN_TECHNIQUES;
    return techniques;
}

const bolan_technique *bolan_technique_find(const char *name) {
    for (size_t i = 0; i < BOLAN_TECHNIQUES; i++)
        if (strcmp(techniques[i].name, name) == 0) return &techniques[i];
    return NULL;
}

bolan_look bolan_look_default(void) {
    bolan_look look;
    memset(&look, 0, sizeof look);
    bolan_params_default(&bolan_look_params, &look);
    return look;
}

// SPDX-License-Identifier: MIT
/// @file technique.h
/// Tier 3. How water is made and shaded: techniques, shading options, quality, backends. Plain data.
#ifndef BOLAN_TECHNIQUE_H
#define BOLAN_TECHNIQUE_H

#include "bolan/params.h"
#include "bolan/surface.h"
#include "bolan/waves.h"

#ifdef __cplusplus
extern "C" {
#endif

// ---- technique ------------------------------------------------------------------------------------------------------

/// How the surface is shaded.
typedef enum bolan_optics_kind {
    /// Filtered slopes, Fresnel, sky, absorption, foam.
    BOLAN_OPTICS_PHYSICAL,
    /// Images of the reflected and refracted scene, fetched where the waves bend the ray (Ma, Zhu & Gong 2006).
    BOLAN_OPTICS_MIRROR,
    /// Fresnel blend of such images, with ambient, diffuse and specular light (Liu & Xie 2010).
    BOLAN_OPTICS_PHONG,
    /// Vertex normals and one light (Liu, Xu & Chen 2009).
    BOLAN_OPTICS_LIT,
    /// Light through the crests, foam ramps at the shore (Ni, Zhang & Tan).
    BOLAN_OPTICS_CREST,
} bolan_optics_kind;
/// Number of optics.
#define BOLAN_OPTICS_KINDS 5
/// The names that the command line and scene files use, "physical" ...; by bolan_optics_kind, NULL at the end.
BOLAN_API extern const char *const bolan_optics_kind_names[BOLAN_OPTICS_KINDS + 1];

/// Whether the optics draws views from an eye under the water: PHYSICAL and MIRROR do.
/// A kind that is none: false.
/// Thread-safe.
BOLAN_API bool bolan_optics_seen_from_below(bolan_optics_kind optics);

/// A way to make water: a wave model x a surface x an optics. Every mix works.
typedef struct bolan_technique {
    /// The name that the command line and scene files use. Static storage.
    const char *name;
    /// The wave model.
    bolan_wave_model waves;
    /// The geometry.
    bolan_surface_kind surface;
    /// The shading.
    bolan_optics_kind optics;
    /// A bolan_spectrum_kind: the spectrum that the technique makes of a wind. -1: the scene's own wind_spectrum.
    int wind_spectrum;
} bolan_technique;
/// Cascades of FFTs of any spectrum, physical shading; the default.
BOLAN_API extern const bolan_technique bolan_technique_ocean;
/// Ma, Zhu & Gong 2006: two triangles, everything else is textures.
BOLAN_API extern const bolan_technique bolan_technique_two_triangle;
/// Liu & Xie 2010: a sum of exp(cos) in each pixel.
BOLAN_API extern const bolan_technique bolan_technique_exp_cosine;
/// Liu, Xu & Chen 2009: Pierson-Moskowitz waves on nested grids.
BOLAN_API extern const bolan_technique bolan_technique_nested_grid;
/// Ni, Zhang & Tan: Phillips waves on a projected grid.
BOLAN_API extern const bolan_technique bolan_technique_flight_sim;

/// How many techniques there are.
#define BOLAN_TECHNIQUES 5
/// Their names, "ocean" ..., in the order of bolan_techniques(); NULL at the end.
BOLAN_API extern const char *const bolan_technique_names[BOLAN_TECHNIQUES + 1];
/// All techniques, the default first; @p count receives their number.
/// Static storage.
/// Thread-safe.
BOLAN_API const bolan_technique *bolan_techniques(uint32_t *count);
/// The technique of that name; NULL when there is none.
/// Thread-safe.
BOLAN_API const bolan_technique *bolan_technique_find(const char *name);

// ---- shading options ------------------------------------------------------------------------------------------------

/// Parts of the shading, as bits; each can be switched off.
/// Bits of parts that an optics does not have are ignored.
typedef enum bolan_effect {
    /// Reflection of sky and objects.
    BOLAN_EFFECT_REFLECTION = 1 << 0,
    /// Light from under the surface.
    BOLAN_EFFECT_REFRACTION = 1 << 1,
    /// Shading by the slope of the waves.
    BOLAN_EFFECT_BUMP = 1 << 2,
    /// Waves bend reflections and refractions.
    BOLAN_EFFECT_DISTORTION = 1 << 3,
    /// Reflection of the sun.
    BOLAN_EFFECT_GLITTER = 1 << 4,
    /// Sunlight focused on the sea bed by the waves.
    BOLAN_EFFECT_CAUSTICS = 1 << 5,
    /// The water's own colour.
    BOLAN_EFFECT_AMBIENT = 1 << 6,
    /// Diffuse light of PHONG and LIT.
    BOLAN_EFFECT_DIFFUSE = 1 << 7,
    /// Highlights of PHONG and LIT.
    BOLAN_EFFECT_SPECULAR = 1 << 8,
    /// Light through crests.
    BOLAN_EFFECT_SCATTERING = 1 << 9,
    /// Whitecaps, surf.
    BOLAN_EFFECT_FOAM = 1 << 10,
    /// Extinction under water.
    BOLAN_EFFECT_FOG = 1 << 11,
} bolan_effect;
/// All effects, the default.
#define BOLAN_EFFECTS_ALL 0xfffu
/// Number of effects.
#define BOLAN_EFFECTS 12
/// Names of the effects by bit, "reflection" ...; NULL at the end.
BOLAN_API extern const char *const bolan_effect_names[BOLAN_EFFECTS + 1];

/// What is drawn of the water.
typedef enum bolan_show {
    /// The shaded water.
    BOLAN_SHOW_PICTURE,
    /// False colours: open sea, crests, shore, land.
    BOLAN_SHOW_MASK,
    /// The edges of the triangles of the water.
    BOLAN_SHOW_MESH,
} bolan_show;
/// Number of views of the water.
#define BOLAN_SHOWS 3
/// Names by bolan_show, "picture" ...; NULL at the end.
BOLAN_API extern const char *const bolan_show_names[BOLAN_SHOWS + 1];

/// Shading options.
typedef struct bolan_look {
    /// Follow the technique's paper to the letter, also where a better way is known; default false.
    bool paper;
    /// Bits of bolan_effect; default all.
    uint32_t effects;
    /// What is drawn of the water; default PICTURE.
    bolan_show show;
    /// Factor on how far waves bend reflections and refractions (MIRROR, PHONG), 0..4; default 1.
    double distortion;
    /// Share of reflection and refraction over the water's own texture (MIRROR; lerpScale of the paper), 0..1;
    /// default 0.85.
    double blend;
    /// Strength of ambient light (PHONG, LIT; Ka of the papers), 0..2; default 1.
    double ambient;
    /// Strength of diffuse light (PHONG, LIT; Kd of the papers), 0..2; default 0.05.
    double diffuse;
    /// Strength of specular light (PHONG, LIT; Ks of the papers), 0..4; default 1.
    double specular;
    /// Exponent of the highlight (PHONG, LIT), 1..4096; default 300. Raised: smaller and sharper.
    double shininess;
} bolan_look;
/// The defaults named above the fields.
BOLAN_API bolan_look bolan_look_default(void);

/// How much a picture may cost: grid steps, texture fetches and target sizes. Raised: finer and slower.
typedef enum bolan_quality {
    BOLAN_QUALITY_LOW,
    BOLAN_QUALITY_MEDIUM,
    BOLAN_QUALITY_HIGH,
    BOLAN_QUALITY_ULTRA,
} bolan_quality;
/// Number of qualities.
#define BOLAN_QUALITIES 4
/// The names that the command line uses, "low" ...; by bolan_quality, NULL at the end.
BOLAN_API extern const char *const bolan_quality_names[BOLAN_QUALITIES + 1];

/// What makes the fields of a sea of cascades.
typedef enum bolan_backend {
    /// COMPUTE on a GPU that has compute shaders, else CPU.
    BOLAN_BACKEND_AUTO,
    /// The CPU, by bolan_sea_fields(); the renderer uploads them. On software OpenGL the faster of the two.
    BOLAN_BACKEND_CPU,
    /// Compute shaders, from tables that are uploaded once for each sea. The CPU makes no fields, unless it is asked.
    /// Heights differ from those of queries by less than 5e-3 of Hs, which is what half floats leave.
    BOLAN_BACKEND_COMPUTE,
} bolan_backend;
/// Number of backends.
#define BOLAN_BACKENDS 3
/// The names that the command line uses, "auto" ...; by bolan_backend, NULL at the end.
BOLAN_API extern const char *const bolan_backend_names[BOLAN_BACKENDS + 1];

/// What shades the pixels of water by BOLAN_OPTICS_PHYSICAL. Both make the same image, but for rounding.
typedef enum bolan_pixels {
    /// COMPUTE on a GPU that has compute shaders, else FRAGMENT.
    BOLAN_PIXELS_AUTO,
    /// Fragment shaders. On software OpenGL the faster of the two.
    BOLAN_PIXELS_FRAGMENT,
    /// Compute shaders.
    BOLAN_PIXELS_COMPUTE,
} bolan_pixels;
/// Number of such kinds.
#define BOLAN_PIXELS 3
/// The names that the command line uses, "auto" ...; by bolan_pixels, NULL at the end.
BOLAN_API extern const char *const bolan_pixels_names[BOLAN_PIXELS + 1];

/// The parameters of bolan_technique and bolan_look.
BOLAN_API extern const bolan_param_table bolan_technique_params, bolan_look_params;

#ifdef __cplusplus
}
#endif
#endif

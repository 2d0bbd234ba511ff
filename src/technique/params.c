// SPDX-License-Identifier: MIT
// The parameters of techniques and shading options.
#include "bolan/technique.h"
#include "params/rows.h"

#define STRUCT bolan_technique
static const bolan_param technique_rows[] = {
    NAME(waves, .option = "waves", .names = bolan_wave_model_names, .high = BOLAN_WAVE_MODELS - 1,
         .help = "the wave model of the technique"),
    NAME(surface, .option = "surface", .names = bolan_surface_kind_names, .high = BOLAN_SURFACE_KINDS - 1,
         .help = "the geometry of the technique"),
    NAME(optics, .option = "optics", .names = bolan_optics_kind_names, .high = BOLAN_OPTICS_KINDS - 1,
         .help = "the shading of the technique"),
};
#undef STRUCT
const bolan_param_table bolan_technique_params = TABLE("bolan_technique", technique_rows);

#define STRUCT bolan_look
static const bolan_param look_rows[] = {
    FLAG(paper, .key = "paper", .option = "paper",
         .help = "follow the technique's paper to the letter, also where we know better"),
    SET(effects, .key = "effects", .option = "effects", .names = bolan_effect_names, .high = BOLAN_EFFECTS_ALL,
        .fallback = BOLAN_EFFECTS_ALL, .help = "only these parts of the light"),
    NAME(show, .key = "show", .option = "show", .names = bolan_show_names, .high = BOLAN_SHOWS - 1,
         .help = "the water, its parts in false colours, or the edges of its triangles"),
    NUMBER(distortion, .key = "distortion", .low = 0, .high = 4, .fallback = 1,
           .help = "how far waves shift reflections and refractions"),
    NUMBER(blend, .key = "blend", .low = 0, .high = 1, .fallback = 0.85,
           .help = "share of reflection and refraction over the water's own texture"),
    NUMBER(ambient, .key = "ambient", .low = 0, .high = 2, .fallback = 1, .help = "strength of ambient light"),
    NUMBER(diffuse, .key = "diffuse", .low = 0, .high = 2, .fallback = 0.05, .help = "strength of diffuse light"),
    NUMBER(specular, .key = "specular", .low = 0, .high = 4, .fallback = 1, .help = "strength of specular light"),
    NUMBER(shininess, .key = "shininess", .low = 1, .high = 4096, .fallback = 300,
           .help = "exponent of the highlight; larger: smaller and sharper"),
};
#undef STRUCT
const bolan_param_table bolan_look_params = TABLE("bolan_look", look_rows);

// SPDX-License-Identifier: MIT
// Clouds: marched once into a panorama round the eye and a map of their shadow on the sea, and again when the eye or
// the sun has moved to another place of the lattice (sky_lattice.h). Shaders: cloud_noise, cloud_weather,
// cloud_panorama, cloud_shadow.
#ifndef BOLAN_RENDER_CLOUDS_H
#define BOLAN_RENDER_CLOUDS_H

#include "frame.h"

// What a pair of maps was made for.
typedef struct cloud_maps {
    gl_texture map; // layer 0 panorama, layer 1 shadow (see common/atmosphere.glsl)
    gl_target panorama, shadow;
    bolan_dvec3 eye; // where, on the lattice
    bolan_vec3 sun;  // on the lattice
    uint64_t seed;
    float cover, base, visibility, unit;
    bool above; // the eye stood above the base
    bolan_quality quality;
} cloud_maps;

typedef struct clouds {
    gl_program noise_program, weather_program, panorama_program, shadow_program;
    gl_texture noise, weather;
    cloud_maps maps[2]; // what is seen, and what is in the making
    int shown;
    bool filled, noise_filled;
    bool borrowed;         // the programs are those of another
    uint32_t strip;        // next of the one in the making; 0: nothing is
    block_values uniforms; // that the maps in the making are drawn with
} clouds;

typedef enum cloud_work { CLOUDS_KEEP, CLOUDS_ALL, CLOUDS_STRIP } cloud_work;

// Shares the programs of `from`, which must live longer; NULL: makes its own.
bolan_result bolan_clouds_create(clouds *c, const clouds *from);
// Takes the programs of `from` again, which has reloaded them.
void bolan_clouds_share(clouds *c, const clouds *from);
bolan_result bolan_clouds_reload(clouds *c);
// What this frame must do: nothing, make the maps at once, or one strip of new ones. Strips are for progressive frames,
// where a moving eye never waits, unless it is the first frame, another sky or a jump. Sets c->uniforms.
cloud_work bolan_clouds_plan(clouds *c, const render_view *v);
// Does it. c->uniforms and the air's tables must be bound, the sea's view at UNIT_OWN. True when other maps are shown
// now.
bool bolan_clouds_march(clouds *c, const render_view *v, cloud_work work);
// Sets what of the view's light says where the maps shown were made.
void bolan_clouds_place(const clouds *c, render_view *v);
const gl_texture *bolan_clouds_map(const clouds *c);
double bolan_clouds_rise(const clouds *c, const render_view *v); // of the eye since the maps shown were made [m]
void bolan_clouds_free(clouds *c);

#endif

// SPDX-License-Identifier: MIT
// The tables of clear air: transmittance, multiple scattering, sky radiance from the eye and from the sea, aerial
// perspective. Shaders: sky_transmittance, sky_multiple, sky_view, sky_aerial.
#ifndef BOLAN_RENDER_ATMOSPHERE_H
#define BOLAN_RENDER_ATMOSPHERE_H

#include "frame.h"

#include "shared/constants.glsl"

typedef struct atmosphere {
    gl_program transmittance_program, multiple_program, view_program, aerial_program;
    gl_texture transmittance, multiple, eye_view, sea_view, aerial;
    gl_target transmittance_target, multiple_target, eye_view_target, sea_view_target, aerial_target[SKY_AERIAL_SLICES];
    bool filled;
    bool borrowed; // the programs are those of another
    float visibility, cover, cloud_base, sun_height, eye_height, unit; // what the tables were made for
} atmosphere;

// Shares the programs of `from`, which must live longer; NULL: makes its own.
bolan_result bolan_atmosphere_create(atmosphere *a, const atmosphere *from);
// Takes the programs of `from` again, which has reloaded them.
void bolan_atmosphere_share(atmosphere *a, const atmosphere *from);
bolan_result bolan_atmosphere_reload(atmosphere *a);
// Refills what was not made for these uniforms, which must be bound in slot 0, with sun and eye on the lattice of
// sky_lattice.h. True when something changed.
bool bolan_atmosphere_update(atmosphere *a, const block_values *u);
// Binds what common/atmosphere.glsl reads.
void bolan_atmosphere_bind(const atmosphere *a);
void bolan_atmosphere_free(atmosphere *a);

#endif

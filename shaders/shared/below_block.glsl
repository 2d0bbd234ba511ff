// SPDX-License-Identifier: MIT
// Members of the uniform block Optics of below.glsl. See frame_block.glsl for who reads this and how. All of it is
// written by src/render/below.c.
vec4 fine_tile;          // this and the other fine_ members: as physical_block.glsl has them
vec3 fine_slopes;
float fine_texel;
vec3 beam_attenuation;   // of an image: absorption and scattering by more than the blur of an image [1/m]
float sun_below_z;       // cosine of the refracted sun's angle from the vertical
vec3 wide_scattering;    // scattering by more than that blur [1/m]
float blur_cosine;       // of that blur
vec3 diffuse_source;     // source of the veil per irradiance on the surface: radiance per metre [1/(m sr)]
float window_present;    // 1: there is an image of what stands above the water
vec3 particle_exponent;  // of the phase function's particles, at 650, 550 and 450 nm
float fine_widest;

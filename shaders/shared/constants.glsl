// SPDX-License-Identifier: MIT
// Constants that C and the shaders share.
#ifndef BOLAN_SHARED_CONSTANTS
#define BOLAN_SHARED_CONSTANTS

#define PI 3.14159265358979323846

// ---- units ----------------------------------------------------------------------------------------------------------

// Shaders see the eye's place modulo these lengths [m]. The period of a texture or noise over world places divides one.
#define WORLD_WRAP 4096.0
#define WORLD_WRAP_WIDE 131072.0 // gusts of wind
#define LAND_MIRROR_PART 4     // pixels to one of land_mirror.glsl, along each axis
#define LAND_MIRROR_LEVELS 4.0 // of its mip chain that are read; its size is a multiple of their texels

// ---- the table of unresolved slopes (bolan_sea_slope_table)
// -----------------------------------------------------------

#define SLOPE_TABLE_MAJOR 29  // texel i: a footprint's standard deviation is 2^(i / PER_OCTAVE + FIRST) m
#define SLOPE_TABLE_ASPECT 8  // texel j: minor over major is 2^-j
#define SLOPE_TABLE_ANGLE 8   // texel l: the major axis points along l pi / 8
#define SLOPE_TABLE_LAYERS 9  // on the GPU the first layer repeats after the last, so that linear filtering wraps
#define SLOPE_TABLE_PER_OCTAVE 1.5
#define SLOPE_TABLE_FIRST (-11.0)
// Texture fetches average over about half a pixel's width at each end: a footprint's standard deviation over its width.
#define FOOTPRINT_DEVIATION 0.4

// Slope variance along an axis that the sun's disc adds: a facet that leans by half of the sun's angular radius,
// 0.00465 rad, still reflects its rim, (0.00465 / 2)^2 = 5.4e-6. It keeps a glint finite on flat water.
#define SUN_DISC_SLOPES 6e-6

// ---- the modes of a cascade (bolan_sea_mode) -----------------------------------------------------------------------

#define MODE_PARTS 4       // waves of a mode near the origin of the lattice
#define MODE_PART_REACH 16 // |i| and |j| of such modes are smaller

// ---- the tables of clear air [texels]
// ---------------------------------------------------------------------------------

#define SKY_TRANSMITTANCE_WIDTH 256
#define SKY_TRANSMITTANCE_HEIGHT 64
#define SKY_MULTIPLE_WIDTH 64
#define SKY_MULTIPLE_HEIGHT 32
#define SKY_VIEW_WIDTH 192
#define SKY_VIEW_HEIGHT 128
#define SKY_AERIAL_AZIMUTHS 32
#define SKY_AERIAL_ELEVATIONS 65 // row 32 is the horizon
#define SKY_AERIAL_SLICES 32

// ---- parts of the shading: bits of bolan_effect
// -----------------------------------------------------------------------

#define EFFECT_REFLECTION 1
#define EFFECT_REFRACTION 2
#define EFFECT_BUMP 4
#define EFFECT_DISTORTION 8
#define EFFECT_GLITTER 16
#define EFFECT_CAUSTICS 32
#define EFFECT_AMBIENT 64
#define EFFECT_DIFFUSE 128
#define EFFECT_SPECULAR 256
#define EFFECT_SCATTERING 512
#define EFFECT_FOAM 1024
#define EFFECT_FOG 2048

#endif

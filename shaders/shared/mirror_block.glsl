// SPDX-License-Identifier: MIT
// Members of the uniform block Optics of the mirror optics, written by src/render/papers/mirror.c.
vec4 tile_place;      // xy: the eye in the tile [0,1), zw: cos, sin of its angle over its side [1/m]
vec4 ripple_place;    // likewise of the ripples' tile
vec4 sun_slide[3];    // rows x, y, w of bias P_sun V_sun: reflected directions to the slide's coordinates
vec3 own_radiance;    // of the water's own texture, mean in the light on flat water; PAPER: of a texel of 1
float tile_texels;    // log2 of the texels a metre of the tile
float ripple_texels;  // likewise of the ripples
float ripple_share;   // factor on the slopes of the ripples
float missing_slopes; // slope variance of what neither tile has
float picture_push;   // Co of eq. 9
float glitter_push;   // Cpo of eq. 10
float blur_texels;    // texels of the reflection that twice a radian covers
float slide_radius;   // rms radius of the slide's sun [rad]
float mirror_padding; // the block's size is a multiple of 16 bytes

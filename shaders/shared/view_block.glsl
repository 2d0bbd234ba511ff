// SPDX-License-Identifier: MIT
// Members of the uniform block View: one image of a step. See frame_block.glsl for the readers and the layout.
mat4 view_projection;         // eye-relative world -> clip; reversed Z, infinite far
mat4 inverse_view_projection; // clip -> eye-relative world
vec2 eye_wrapped;             // place of the eye modulo 4096 m, for noise and small tiles
vec2 eye_wrapped_wide;        // the same modulo 131072 m, for large noise
vec2 viewport_size;           // [px]
vec2 pixel_size;              // 1 / viewport_size
float eye_height;             // over mean water [m]
float radians_per_pixel;      // at the middle of the picture
float near_distance;          // of the near plane [m]; window depth is near_distance over distance along the view axis
float clip_zero_to_one;       // 1: clip depth is [0,1], 0: [-1,1]
float eye_under_water;        // 1: the eye is below the mean water, and the water is drawn from below
float under_fog;              // strength of the fog under water, 0: none
float mirrored_under_water;   // 1: the reflection view of an eye under water
float shade_columns;          // columns of the image that share a sample of the water (half-rate shading)
float clip_side;              // 1: only what is above the clip plane, -1: only what is below it, 0: everything
float clip_elevation;         // of the clip plane over mean water [m]
float refraction_raise;       // factor on heights of refracted points about the water level, where refraction_mode is 1
float refraction_mode;        // raises refracted points: 0 not, 1 by refraction_raise, 2 each vertex by its own angle
vec3 sun_light;               // irradiance of the sun at the eye, at normal incidence, through the air
float eye_above_clouds;       // 1: the eye is above the base of the clouds
vec3 sky_light;               // irradiance of the sky on a horizontal surface
float surf_phase;             // of the bores at the eye [cycles]
vec3 exposure;                // factor before the tone map: exposure and white balance
float caustic_near_blur;      // of the near patch, a metre of depth [m]
vec2 cloud_offset;            // of the eye from the middle of the clouds' maps [m]
vec2 streak_place;            // of the eye in the tile of wind streaks [0,1)
vec2 caustic_place;           // of the eye in the caustics' tile, or in the wide patch of the drawn waves
vec2 tile_corner;             // lower left corner of the picture in the whole of which it is a tile [px]
vec2 tile_share;              // size of the picture over that of the whole; 1 where it is the whole
vec2 water_wrapped;           // as eye_wrapped, over the water, which drifts with the current
vec2 caustic_spread;          // of caustics, a metre of depth: their blur [m]; light that leaves them [1/m]
vec2 foam_wrapped;            // as water_wrapped, over bubbles and small nets of foam, which drift with the wind too
vec2 eddies_wrapped;          // as foam_wrapped, over patches and broad nets, which drift less
vec2 caustic_near_place;      // of the eye in the near patch

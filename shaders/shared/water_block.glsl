// SPDX-License-Identifier: MIT
// Members of the uniform block Water: the sea's fields as the shaders read them, where the eye stands in them, and the
// shading options. Which waves are there says the variant of the program: see common/waves.glsl. See frame_block.glsl
// for who reads this and how. All of it is written by src/render/water_block.c.
vec4 cascade_tile[4];     // xy: the eye in the tile [0,1), zw: cos, sin of its angle over its side [1/m]
vec4 cascade_band[4];     // x: significant height of the band [m], y: texel [m], z: longest wave [m], w: log2 of y
vec4 cascade_bound[4];    // bolan_bound_weights: height, drift, height_long, drift_long [1/m]
vec4 cascade_lift[13];    // of each cascade [m], by log2 of the mesh's spacing in texels, plus 2: bolan_sea_lift()
vec4 warp_wave_of[6];     // of the warped plane: kx, ky [turns/m], phase at the eye [turns], amplitude / |k| [m2]
vec4 wave_component[16];  // exp-cosine waves: kx, ky [turns/m], amplitude [m], phase at the eye [turns]
vec4 exp_slope[2];        // c0 to c7: the derivative of exp(s cos) by the phase, see wave_derivative()
vec4 shore_level[4];      // of the shore map: west, south (eye-relative), side, texel [m]
vec4 ripple_tile[2];      // of both layers of ripples: the eye in the tile [0,1), unit vector of its u axis
vec4 ripple_size[2];      // likewise 1 / its side [1/m], its slope variance, log2 of the side, rms slope
vec4 layer_wave[8];       // wave layers: kx, ky [rad/m], amplitude [m], phase at the eye [rad]; see common/layers.glsl
vec4 layer_area[8];       // xy: centre of the area, eye-relative [m]; zw: unit vector of travel
vec4 layer_extent[8];     // 1 / half length, 1 / half width [1/m], share of the edge, height that the coast sees [m]
vec4 nested_level[16];    // of the nested levels: first vertex, spacing [m], cells along a side: common/nested.glsl
vec4 nested_centre;       // xy: what the levels lie round [m], z: cells from there where spacings rise, w: their rise
vec4 nested_eye;          // xy: [m], z: height over the water [m], w: the least spacing of a vertex [m]
vec4 foam_weights;        // of the cascades' foam memories: bolan_foam_weights()
vec4 grid_reach;          // of the static grid, see common/grid.glsl
vec4 grid_azimuth;
vec3 wave_slopes;         // of a sum: covariance xx, xy, yy of its slopes and of what is no part of its waves
float wave_slope_share;   // of one wave's: mean square of its slope over (amplitude * turns/m)^2
vec3 slope_total;         // covariance xx, xy, yy of the slopes of all waves
float height_deviation;   // standard deviation of the height of all waves [m]
vec2 grid_cells;          // of the static grid
vec2 warp_at_eye;         // what the warp adds to the eye's place [m]
float significant_height; // [m]
float peak_length;        // of the waves at the peak of the spectrum [m]
float shore_height;       // significant height that the shore sees [m]
float choppiness;
float exp_sharpness;      // s of exp(s cos)
float exp_mean;           // mean e^-s I0(s) of the shape
float mesh_lift;          // in the heights of vertices that carry the waves [m]: bolan_sea_lift()
float look_distortion;    // bolan_look: factor on how far waves bend a fetch
float look_blend;         // share of reflection and refraction over the water's own texture
float look_shininess;
float look_ambient;
float look_diffuse;
float look_specular;
float look_show;          // a bolan_show
int look_effects;         // bits of bolan_effect
int cascade_count;
int wave_count;
int shore_present;        // 1: there is ground
int layer_count;
int warp_count;

// SPDX-License-Identifier: MIT
// Members of the uniform block Frame: what every view of one step shares. Read by common/frame.glsl (std140) and by
// src/render/blocks.h (a C struct). A vec3 is followed by a float and a vec2 by a vec2 or two floats, so that both
// languages give each member the same offset.
vec3 sun_direction;      // to the sun
float radiance_unit;     // stored radiance is true radiance times this: 1 by day, more in twilight
vec3 water_reflectance;  // remote-sensing reflectance of deep water [1/sr]
float water_index;       // index of refraction
vec3 water_attenuation;  // diffuse attenuation of the water [1/m]
float foam_strength;     // factor of the density of foam
vec2 wind_direction;     // unit vector, the wind blows towards it
float cloud_cover;       // 0..1
float cloud_base;        // over mean water [m]
vec2 surf_wave;          // of the bores: cycles per metre, the way they run
float surf_time;         // time in their periods, modulo 1
float visibility;        // [m]
vec2 streak_scale;       // tiles of wind streaks per metre, across and along the wind
vec2 caustic_turn;       // cosine and sine of the turn of the caustics' tile, over its side [1/m]
vec2 caustic_travel;     // level travel of sunlight in the water for each metre that it falls
float caustic_strength;  // 0..1
float water_level;       // of the mean water over the datum [m]
float earth_radius;      // [m]
float wind_speed;        // 10 m above the water [m/s]
vec2 gust_travel;        // of the gusts since time 0, modulo WORLD_WRAP_WIDE [m]
vec3 given_haze_radiance;   // of endless haze, where the host gives it
float haze_given;           // 1: haze by given_haze_radiance and given_haze_extinction, 0: Bolan's air
vec3 given_haze_extinction; // [1/m]
float frame_padding_end;    // the block's size is a multiple of 16 bytes

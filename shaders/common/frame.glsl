// SPDX-License-Identifier: MIT
// The uniform block that every pass reads; std140 twin of frame_uniforms in src/render/frame.h.
layout(std140) uniform Frame {
    mat4 view_projection;         // eye-relative world -> clip
    mat4 inverse_view_projection; // clip -> eye-relative world
    vec4 eye;        // xy: eye position modulo 4096 m, z: height above mean water [m], w: water level [m]
    vec4 sun;        // direction to the sun; w: cosine of its angular radius
    vec4 sun_light;  // solar irradiance at the eye's height (rgb); w: exposure factor
    vec4 sky_light;  // irradiance of the sky on a horizontal surface (rgb)
    vec4 viewport;   // width, height, 1/width, 1/height [px]
    vec4 lens;       // x: radians per pixel, y: near [m], z: 1 if clip depth is [0,1], w: earth radius [m]
    vec4 wind;       // xy: unit direction it blows TO, z: U10 [m/s], w: cloud cover
    vec4 haze;       // x: visibility [m], y: cloud base [m], zw: eye position modulo 131072 m
    vec4 water_deep; // remote-sensing reflectance rgb [1/sr]; w: index of refraction
    vec4 water_kd;   // diffuse attenuation rgb [1/m]; w: foam strength
    vec4 air;        // x: radiance unit, y: 1 when the eye is above the clouds, zw: eye from the cloud maps' centre [m]
    vec4 clip;        // x: only above (1) or below (-1) the plane, y: its elevation over the mean water [m]; w: what is refracted is
                      // raised, 1: by the factor z about the water, 2: each vertex by its own angle
    vec4 under;       // light under water: x: 1 when the eye is there, y: strength of its fog, z: of the caustics, w: 1 in the
                      // mirrored picture of an eye under water
    vec4 caustic;     // xy: eye in the caustics' tile; zw: cos, sin of its turn over its side [1/m]
    vec4 caustic_sun; // xy: level travel of sunlight in the water for each metre it falls; z: their disturbance
    vec4 sampling;    // x: columns of the picture that a sample of the water stands for (half_rate.h)
    vec4 surf;        // bores; xy: cycles per metre the way they run, z: phase at the eye [cycles], w: time in periods
    vec4 streaks;     // tile of wind streaks; xy: the eye in it [0,1), zw: tiles per metre across, along the wind
};

#ifdef FRAGMENT
// The pixel of the picture whose kept shape is lit here.
ivec2 sampled_pixel() { return ivec2(min(gl_FragCoord.xy * vec2(sampling.x, 1.0), viewport.xy - 0.5)); }
#endif

// Eye-relative direction through a point of the picture, uv in [0,1], not normalised. Depth 1 is the near plane.
vec3 frame_ray(vec2 uv) {
    vec4 p = inverse_view_projection * vec4(uv * 2.0 - 1.0, 1.0, 1.0);
    return p.xyz / p.w;
}

// Distance along the view axis [m] of a window depth (reversed-Z: near / distance).
float frame_distance(float depth) { return lens.y / max(depth, 1e-12); }

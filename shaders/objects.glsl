// SPDX-License-Identifier: MIT
// Objects. All light is computed at the vertices, so that the pixels cost little, because objects are drawn up to three
// times a frame. GROUND is defined for models that lie flat, PICTURE for planar views and for an eye under water; CUT
// where the clip plane cuts the triangles, WET where they may lie under the water. As in ground.glsl, points under the
// water are shaded as if dry and without haze; the water pass adds the water.
#include "common/frame.glsl"
#include "common/atmosphere.glsl"
#include "common/under.glsl"
#include "common/object_shadow.glsl"
#include "shared/wet.glsl"
#ifndef PICTURE
#include "common/gathered.glsl"
#endif
#if defined(WET) || !defined(PICTURE)
#define LIT_BELOW
#endif

uniform vec4 place[3];     // rows of the matrix from model to eye-relative world
uniform float grain_scale; // 1 / period of the grain [1/m]
uniform float pixel;       // of this picture [rad]
uniform vec2 wet_band;     // where it is wet: from the water at it to the wet line, over the water level [m]

#ifdef VERTEX
layout(location = 0) in vec3 vertex;
layout(location = 1) in vec3 vertex_normal;
layout(location = 2) in vec4 vertex_color; // albedo; open sky
out vec3 light;     // radiance of the surface as it arrives
out vec3 inscatter; // of the air before it
out vec4 wet;       // share of the light that is left where it is wet; height over the water level [m]
out vec4 grain;     // noise coordinates, strength, level
#ifdef CUT
out float over;     // height above the clip level [m]
#endif
#ifdef LIT_BELOW
out vec3 bottom;    // level place relative to the eye, depth under the water [m]
#endif

const float NOISE_SIZE = 256.0; // texels

void main() {
    vec4 v = vec4(vertex, 1.0);
    vec3 position = vec3(dot(place[0], v), dot(place[1], v), dot(place[2], v));
    vec3 n = normalize(vec3(dot(place[0].xyz, vertex_normal), dot(place[1].xyz, vertex_normal),
                            dot(place[2].xyz, vertex_normal)));
    vec3 albedo = vertex_color.rgb;
    float open = vertex_color.a, height = position.z + eye_height;
    position.z -= earth_drop(dot(position.xy, position.xy), earth_radius);

    // Green is taken for leaves: light passes through them, and their crowns stand in their own shade.
    float leafy = smoothstep(0.05, 0.3, (albedo.g - max(albedo.r, albedo.b)) / max(albedo.g, 1e-4));
    float facing = dot(n, sun_direction);
#ifdef GROUND
    float lit = max(facing, 0.0);
#else
    float lit = mix(max(facing, 0.0), max((facing + 0.4) / 1.4, 0.0) * smoothstep(0.05, 0.75, open), leafy);
#endif
    lit *= object_shadow_below(position, height) * cloud_shadow(position.xy);
    float up = 0.5 + 0.5 * n.z;
    vec3 around = (sun_light * max(sun_direction.z, 0.0) * 0.6 + sky_light) * vec3(0.13, 0.14, 0.08);
    vec3 ambient = open * (sky_light * up + around * (1.0 - up + 0.25 * (1.0 - open)));
    light = albedo / PI * (sun_light * lit + ambient);

    wet = vec4(wet_albedo(albedo.r, water_index), wet_albedo(albedo.g, water_index), wet_albedo(albedo.b, water_index),
               height);
    wet.rgb /= max(albedo, 1e-3);

    vec3 transmittance;
    float away = length(position);
#ifndef PICTURE
    aerial_perspective(position, transmittance, inscatter);
#else // near and blurred: haze of one extinction
    transmittance = exp(-away * (RAYLEIGH + mie_extinction()));
    inscatter = sky_light / PI * (1.0 - transmittance);
#endif
    float dry = smoothstep(-0.3, 0.0, height);
    light *= mix(vec3(1.0), transmittance, dry);
    inscatter *= dry;

#ifdef GROUND
    // The noise's period must divide the 4096 m after which eye_wrapped wraps.
    float period = 4.0;
    grain = vec4((eye_wrapped + position.xy) / period, mix(0.7, 1.1, leafy), 0.0);
#else
    // Along no axis, so that walls show the grain.
    float period = 1.0 / grain_scale;
    grain = vec4((vertex.xz + vertex.y * vec2(0.61, 0.37)) * grain_scale, mix(0.3, 1.3, leafy), 0.0);
#endif
    float tilted = max(abs(dot(n, position)), 0.03 * away) / max(away, 1e-3); // the long side of a footprint
    grain.w = log2(max(away * pixel * NOISE_SIZE / (period * tilted), 1.0));
#ifdef LIT_BELOW
    bottom = vec3(position.xy, -height);
#endif
#ifdef PICTURE
    vec3 through, veil;
    through_water(position, height, through, veil);
    light *= through;
    inscatter = inscatter * through + veil;
#ifdef CUT
    over = clip_side * (height - clip_elevation);
#endif
    position.z += seen_height(position.xy, height) - height;
#endif
    gl_Position = view_projection * vec4(position, 1.0);
}
#endif

#ifdef FRAGMENT
in vec3 light;
in vec3 inscatter;
in vec4 wet;
in vec4 grain;
#ifdef CUT
in float over;
#endif
#ifdef LIT_BELOW
in vec3 bottom;
#endif
out vec4 color;

#pragma unit ground_noise 12
uniform sampler2D ground_noise; // billows, their gradient, patches; mean 0.5

const float WET_EDGE = 0.04; // half the height over which it dries [m]

void main() {
#ifdef CUT
    if (over < 0.0) discard;
#endif
    // One level: software OpenGL blends two at twice the cost.
    vec4 noise = textureLod(ground_noise, grain.xy, floor(grain.w + 0.5));
    float tone = noise.r + noise.a - 1.0;
    // Under the water it is as bright as dry: what a film reflects back, there the surface does (BED_LEAVES).
    float dry = smoothstep(-WET_EDGE, WET_EDGE, wet.w - wet_band.y + WET_EDGE * tone);
    vec3 left = mix(wet.rgb, vec3(1.0), wet.w < wet_band.x ? 1.0 : dry);
    vec3 radiance = light * left * max(1.0 + grain.z * tone, 0.2);
#ifdef LIT_BELOW
    const float SUN_SHARE = 0.75; // of the light; the rest is the sky's
#ifdef WET
    radiance *= mix(1.0, gathered_light(bottom.xy, bottom.z), SUN_SHARE);
#else
    radiance *= mix(1.0, gathered_at(bottom.xy, bottom.z, 0.0), SUN_SHARE);
#endif
#endif
    color = vec4(radiance + inscatter, 1.0);
}
#endif

// SPDX-License-Identifier: MIT
// Spindrift (shared/spray.glsl): each veil is a rectangle that lies along the wind and faces the eye. Drops of spray
// are much wider than a wavelength and scatter forwards, so that veils glow before the sun and are pale away from it.
#include "common/frame.glsl"
#include "shared/spray.glsl"

#ifdef VERTEX
#include "common/waves.glsl"
#include "common/atmosphere.glsl"
#include "common/noise.glsl"

layout(std140) uniform Optics {
#include "shared/physical_block.glsl"
};
#pragma unit fold_map 10
uniform sampler2DArray fold_map; // r: dxy

layout(location = 0) in vec4 sprite; // corner of the rectangle, -1..1; cell of the block; which veil of the cell
// Eye-relative corner [m]; side of a cell [m]; the cell at that corner: column + 1024 row.
uniform vec4 spray_block[SPRAY_BLOCKS];

out vec2 veil_corner;
out vec4 veil_noise;      // places in the noise of foam, broad and fine
flat out float veil_depth; // optical depth at its middle
flat out vec3 veil_light;  // radiance of an endless veil, through the air
flat out vec3 veil_air;    // what the air adds before it

// The look of the veils, by eye. Half lengths and widths at the start and at the end of their life [m], of the inner
// ring; those of wider cells are larger and thinner.
const vec2 VEIL_LENGTH = vec2(1.2, 4.5), VEIL_WIDTH = vec2(0.2, 0.7);
const float VEIL_GROWS = 0.75, VEIL_THINS = -0.45; // exponents of the cells' side
const float VEIL_RISE = 0.9;    // of its middle over the crest, in its life [m]
const float VEIL_DRIFT = 0.4;   // of the wind's speed, over the crest that goes along
const float VEIL_DEPTH = 8.0;   // optical depth in a hurricane
const vec2 VEIL_NEAR = vec2(8.0, 25.0); // an eye in a veil does not see it [m]
const float VEIL_TWICE = 0.4;   // share of the light that is scattered more than once, all around
const float VEIL_SKY = 0.7;     // of the sky that it scatters, over a white wall
const float VEIL_CLOUD = 2.2;   // width along the wind, over that across it
// Metres of a turn of the noise, along and across.
const vec2 VEIL_BROAD = vec2(16.0, 3.0), VEIL_FINE = vec2(8.0, 1.0);
// Crests that the wind tears: standard deviations by which the water is squeezed, in a gale and in a hurricane, and the
// range in which all of them begin to. Deep between the waves there is no wind: standard deviations of the height.
const float CREST_GALE = 0.9, CREST_HURRICANE = -0.2, CREST_RANGE = 1.4, CREST_LOW = -2.0, CREST_HIGH = 0.5;

// Of the waves that are wider than `spacing`: displacement at a place, and the Jacobian. Nearly: places and heights of
// veils are loose.
vec3 spray_offset(vec2 rest, float spacing, vec4 kept) {
    vec2 at = place_of(rest).at;
    vec3 offset = vec3(0.0);
    for (int c = 0; c < cascade_count; ++c) {
        if (spacing > cascade_band[c].z) break;
        float lod = max(log2(spacing) - cascade_band[c].w, 0.0);
        offset += kept[c] * textureLod(displacement_map, vec3(cascade_uv(c, at), float(c)), lod).xyz;
    }
    return vec3(choppiness * offset.xy, offset.z);
}

float spray_jacobian(vec2 rest, float spacing, vec4 kept) {
    vec2 place = place_of(rest).at;
    vec3 squeeze = vec3(0.0);
    for (int c = 0; c < cascade_count; ++c) {
        if (spacing > cascade_band[c].z) break;
        vec3 at = vec3(cascade_uv(c, place), float(c));
        float lod = max(log2(spacing) - cascade_band[c].w, 0.0);
        squeeze += kept[c] * vec3(textureLod(slope_map, at, lod).zw, textureLod(fold_map, at, lod).x);
    }
    squeeze *= choppiness;
    return (1.0 + squeeze.x) * (1.0 + squeeze.y) - squeeze.z * squeeze.z;
}

// A ring shows between the distances at which its neighbours fade in and out; the innermost from the eye on.
float ring_share(float dist, float side) {
    float outer = 2.0 * float(SPRAY_SIDE) * side, inner = side > 1.5 * SPRAY_CELL ? 0.5 * outer : 0.0;
    return smoothstep(0.75 * inner, inner + 1e-3, dist) * (1.0 - smoothstep(0.75 * outer, outer, dist));
}

vec3 hashed(uint h) { return vec3(h & 1023u, (h >> 10) & 1023u, (h >> 20) & 1023u) / 1023.0; }

// Optical depth of a veil over that crest, at the middle of its life.
float torn(float squeeze, float height) {
    float strength = spindrift_share(wind_speed);
    float over = squeeze * inversesqrt(jacobian_variance) - mix(CREST_GALE, CREST_HURRICANE, strength);
    return VEIL_DEPTH * strength * smoothstep(0.0, CREST_RANGE, over) *
           smoothstep(CREST_LOW, CREST_HIGH, height / height_deviation);
}

// Half of its length and width, as the eye sees it in the direction `to`, and its axes. seen: how much of its length:
// 0 along the wind, where it is a round cloud, wider and thinner, since veils of many crests stand behind each other.
vec2 veil_axes(vec3 to, float scale, float life, out vec3 along, out vec3 across, out float seen) {
    float grown = sqrt(life), broad = scale * mix(VEIL_WIDTH.x, VEIL_WIDTH.y, grown);
    along = vec3(wind_direction, 0.0) - to * dot(wind_direction, to.xy);
    seen = length(along);
    along = seen > 1e-3 ? along / seen : normalize(vec3(to.y, -to.x, 0.0) + vec3(1e-6, 0.0, 0.0));
    across = cross(to, along);
    broad *= mix(VEIL_CLOUD, 1.0, seen);
    return vec2(mix(broad, scale * mix(VEIL_LENGTH.x, VEIL_LENGTH.y, grown), seen), broad);
}

void main() {
    vec4 block = spray_block[gl_InstanceID];
    int cell = int(sprite.z), corner = int(block.w);
    ivec2 within = ivec2(cell % SPRAY_SIDE, cell / SPRAY_SIDE);
    uvec2 id = uvec2(ivec2(corner & 1023, corner >> 10) + within);
    uint own = noise_hash(uvec3(id, 8u * uint(block.z) + uint(sprite.w)));
    float turn = spray_time + hashed(own).x, life = fract(turn), age = life * SPRAY_LIFE;
    vec3 chance = hashed(noise_hash(uvec3(own, uint(turn), 5u)));
    float wider = block.z / SPRAY_CELL, scale = pow(wider, VEIL_GROWS) * (0.7 + 0.6 * chance.z);
    vec2 rest = block.xy + block.z * (vec2(within) + chance.xy);

    // A veil flies level from its crest, but over the water.
    float spacing = 0.25 * block.z;
    vec2 drift = wind_direction * (VEIL_DRIFT * wind_speed * age);
    vec4 kept = cascades_kept(water_depth(rest));
    vec3 crest = spray_offset(rest, spacing, kept), here = spray_offset(rest + drift, spacing, kept);
    float above = VEIL_RISE * scale * (0.15 + life * chance.z) - earth_drop(dot(rest, rest), earth_radius);
    vec3 middle = vec3(rest + drift + crest.xy, max(crest.z, here.z) + above - eye_height);

    float dist = max(length(middle), 1e-3), seen;
    vec3 to = middle / dist, along, across;
    vec2 size = veil_axes(to, scale, life, along, across, seen), metres = sprite.xy * size;
    float fades = min(8.0 * life, 1.0) * (1.0 - life) * (1.0 - life) * ring_share(length(rest), block.z);
    fades *= smoothstep(VEIL_NEAR.x, VEIL_NEAR.y, dist) * (1.0 - smoothstep(0.5 * SPRAY_HIGH, SPRAY_HIGH, eye_height));
    veil_depth = pow(wider, VEIL_THINS) * foam_strength * fades *
                 torn(1.0 - spray_jacobian(rest, spacing, kept), crest.z);
    veil_corner = sprite.xy;
    veil_depth *= mix(1.0 / (VEIL_CLOUD * VEIL_CLOUD), 1.0, seen);
    vec2 broad = mix(VEIL_BROAD.yy, VEIL_BROAD, seen), fine = mix(VEIL_FINE.yy, VEIL_FINE, seen);
    veil_noise = vec4(metres / broad + chance.xy, metres / fine + chance.yz) - vec2(0.1, 0.0).xyxy * life;
    vec3 transmittance;
    aerial_perspective(middle, transmittance, veil_air);
    float phase = mix(mie_phase(dot(sun_direction, to)), 0.25 / PI, VEIL_TWICE);
    veil_light = transmittance * (sun_light * (cloud_shadow(middle.xy) * phase) + sky_light * (VEIL_SKY / PI));
    gl_Position = view_projection * vec4(middle + along * metres.x + across * metres.y, 1.0);
    if (veil_depth < 0.004) gl_Position = vec4(0.0, 0.0, -2.0, 1.0); // nothing of it
}
#endif

#ifdef FRAGMENT
#pragma unit foam_noise 7
uniform sampler2D foam_noise;

in vec2 veil_corner;
in vec4 veil_noise;
flat in float veil_depth;
flat in vec3 veil_light;
flat in vec3 veil_air;

out vec4 color;

void main() {
    float from = dot(veil_corner, veil_corner), round = max(1.0 - from, 0.0);
    float broad = texture(foam_noise, veil_noise.xy).g, fine = texture(foam_noise, veil_noise.zw).g;
    float left = exp(-veil_depth * round * round * (0.3 + 1.4 * broad) * clamp(3.6 * fine - 1.1, 0.02, 1.6));
    color = vec4((veil_light + veil_air) * (1.0 - left), 1.0 - left);
}
#endif

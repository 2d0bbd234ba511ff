// SPDX-License-Identifier: MIT
// Sunlight at a place in the water as a share of what flat water lets through, from the images of caustics.glsl: one
// depth a channel, the bed's in the last. Layer 0 is the wide patch. Layer 1, finer and near the eye, shows the bed
// alone; its third channel has that light times the depth of the bed. Deep images are as blurred as the sun's disc and
// the waves that a patch lacks make them. Needs common/frame.glsl.
#include "common/level.glsl"
#include "shared/caustic_patches.glsl"
#include "shared/constants.glsl"
#pragma unit caustic_map 24
uniform highp sampler2DArray caustic_map;

#define CAUSTIC_DEPTHS vec3(1.5, 4.0, 10.0) // of the first three channels [m]

float caustic_texels() { return caustic_turn.x * float(textureSize(caustic_map, 0).x); } // of the wide patch [1/m]

// Share of the patch at a place in it; beyond it 0.
float caustic_share(vec2 uv) {
    vec2 from_middle = abs(uv - 0.5);
    return caustic_spread.x > 0.0 ? 1.0 - smoothstep(0.36, 0.46, max(from_middle.x, from_middle.y)) : 0.0;
}

vec2 caustic_entry(vec2 position, float depth) { return (position - caustic_travel * depth) * caustic_turn.x; }
float caustic_left(float depth) { return caustic_strength * exp(-caustic_spread.y * depth); }

// Twice the standard deviation of an image [m]: of the light at that depth, and of a pixel of that width. blur: of a
// metre of depth.
float caustic_blur(float blur, float depth, float width) {
    return length(vec2(blur * depth, 2.0 * FOOTPRINT_DEVIATION * width));
}

// A bilinear look-up at level L has a standard deviation of 2^L / 2 texels, but keeps 0.44 / 4^L of the variance of a
// pattern finer than that, where a Gaussian of that deviation keeps 1 / pi. The wider one of the same contrast is read.
const float AS_GAUSSIAN = 1.18;
vec4 caustic_texel_wide(vec2 uv, float blur) {
    return textureLod(caustic_map, vec3(uv, 0.0), fetched_level(log2(max(blur * caustic_texels(), 1.0))));
}
vec4 caustic_wide(vec2 uv, float blur) { return caustic_texel_wide(uv, AS_GAUSSIAN * blur); }

vec4 caustic_texel(vec2 uv, float level) { return textureLod(caustic_map, vec3(uv, 1.0), level); }

// Four look-ups half a level below, whose places make up for that, are nearer to a Gaussian, and show no squares.
vec4 caustic_near(vec2 uv, float blur) {
    float texels = blur * CAUSTIC_FINER * caustic_texels();
    float level = max(log2(max(texels, 1.0)) - 0.5, 0.0), finer = exp2(level);
    float apart = sqrt(0.5 * max(texels * texels - finer * finer, 0.0)) / float(textureSize(caustic_map, 0).x);
    vec2 a = vec2(0.92, 0.39) * apart, b = vec2(-a.y, a.x); // along no axis of the texels
    return 0.25 * (caustic_texel(uv + a, level) + caustic_texel(uv - a, level) + caustic_texel(uv + b, level) +
                   caustic_texel(uv - b, level));
}

// Of the images at CAUSTIC_DEPTHS, at that depth.
float caustic_between(vec3 image, float depth) {
    vec3 at = CAUSTIC_DEPTHS;
    float near = mix(1.0, image.r, min(depth / at.x, 1.0));
    return depth < at.x ? near
           : depth < at.y ? mix(image.r, image.g, (depth - at.x) / (at.y - at.x))
                          : mix(image.g, image.b, min((depth - at.y) / (at.z - at.y), 1.0));
}

struct caustics_at {
    vec2 wide, near;        // places in the patches
    float blur, near_blur;  // of the look-ups there: see caustic_blur()
    float left, near_share; // share of the sunlight that is in the pattern; of that, in the near patch
};
caustics_at caustic_places(vec2 position, float depth, float width) {
    vec2 entry = caustic_entry(position, depth), near = caustic_near_place + entry * CAUSTIC_FINER;
    return caustics_at(caustic_place + entry, near, caustic_blur(caustic_spread.x, depth, width),
                       caustic_blur(caustic_near_blur, depth, width),
                       caustic_share(caustic_place + entry) * caustic_left(depth),
                       caustic_near_blur > 0.0 ? caustic_share(near) : 0.0);
}

// On the bed, depth [m] below eye-relative xy, under a pixel of that width [m].
float gathered_on_bed(vec2 position, float depth, float width) {
    if (depth <= 0.0 || caustic_spread.x <= 0.0) return 1.0;
    caustics_at c = caustic_places(position, depth, width);
    float light = mix(caustic_wide(c.wide, c.blur).a, caustic_near(c.near, c.near_blur).a, c.near_share);
    return mix(1.0, light, c.left * smoothstep(0.0, 0.3, depth));
}

// On a thing at any depth [m]: near the bed by the bed's image.
float gathered_at(vec2 position, float depth, float width) {
    if (depth <= 0.0 || caustic_spread.x <= 0.0) return 1.0;
    caustics_at c = caustic_places(position, depth, width);
    vec4 bed = caustic_near(c.near, c.near_blur);
    c.near_share *= smoothstep(0.4, 0.7, depth * bed.a / max(bed.b, 1e-3));
    return mix(1.0, mix(caustic_between(caustic_wide(c.wide, c.blur).rgb, depth), bed.a, c.near_share), c.left);
}

// In the water itself, where a view adds up many places, whose light entered `apart` metres from one another: from the
// wide patch alone.
float gathered_in_water(vec2 position, float depth, float apart) {
    if (depth <= 0.0 || caustic_spread.x <= 0.0) return 1.0;
    vec2 uv = caustic_place + caustic_entry(position, depth);
    vec3 image = caustic_texel_wide(uv, length(vec2(caustic_spread.x * depth, apart))).rgb;
    return mix(1.0, caustic_between(image, depth), caustic_share(uv) * caustic_left(depth));
}

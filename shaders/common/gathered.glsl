// SPDX-License-Identifier: MIT
// Sunlight at a place in the water as a share of what flat water lets through, from the images of caustics.glsl: one
// depth a channel, the bed's in the last. Deep images are as blurred as the sun's disc and the waves that the patch
// lacks make them. Needs common/frame.glsl.
#pragma unit caustic_map 24
uniform sampler2D caustic_map;

#define CAUSTIC_DEPTHS vec3(1.5, 4.0, 10.0) // of the first three channels [m]

// Places beyond the patch have a share of 0.
float caustic_share(vec2 uv) {
    vec2 from_middle = abs(uv - 0.5);
    return caustic_spread.x > 0.0 ? 1.0 - smoothstep(0.36, 0.46, max(from_middle.x, from_middle.y)) : 0.0;
}

vec4 caustic_images(vec2 position, float depth, out float share) {
    vec2 uv = caustic_place + (position - caustic_travel * depth) * caustic_turn.x;
    share = caustic_share(uv) * caustic_strength * exp(-caustic_spread.y * depth);
    float texels = caustic_spread.x * depth * caustic_turn.x * float(textureSize(caustic_map, 0).x);
    return textureLod(caustic_map, uv, log2(max(texels, 1.0)));
}

// On the bed, depth [m] below eye-relative xy.
float gathered_on_bed(vec2 position, float depth) {
    if (depth <= 0.0 || caustic_spread.x <= 0.0) return 1.0;
    float share;
    vec4 image = caustic_images(position, depth, share);
    return mix(1.0, image.a, share * smoothstep(0.0, 0.3, depth));
}

// At any depth [m].
float gathered_at(vec2 position, float depth) {
    if (depth <= 0.0 || caustic_spread.x <= 0.0) return 1.0;
    float share;
    vec3 image = caustic_images(position, depth, share).rgb, at = CAUSTIC_DEPTHS;
    float near = mix(1.0, image.r, min(depth / at.x, 1.0));
    float light = depth < at.x ? near
                  : depth < at.y ? mix(image.r, image.g, (depth - at.x) / (at.y - at.x))
                                 : mix(image.g, image.b, min((depth - at.y) / (at.z - at.y), 1.0));
    return mix(1.0, light, share);
}

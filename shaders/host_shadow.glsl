// SPDX-License-Identifier: MIT
// Shadows of a host's objects on the water: the share of the sun that is left for a pixel times the share
// that the host's shadow map lets through, by blending. Four texels are compared and weighed by their distance.
#include "common/fullscreen.glsl"
#ifdef VERTEX
void main() { fullscreen(0.0); }
#endif
#ifdef FRAGMENT
#include "common/frame.glsl"
#include "common/shape.glsl"
#include "common/shape_maps.glsl"
#pragma unit shadow_map 15
uniform highp sampler2D shadow_map;
uniform vec4 shadow_matrix[4]; // columns: eye-relative world -> place in the map, and depth as it holds it
uniform float shadow_bias;     // in that depth
out vec4 color;

// 1: the sun reaches that depth over the texel.
float is_lit(ivec2 texel, float depth) {
    ivec2 last = textureSize(shadow_map, 0) - 1;
    return depth - shadow_bias <= texelFetch(shadow_map, clamp(texel, ivec2(0), last), 0).r ? 1.0 : 0.0;
}

float lit_share(vec3 at) {
    if (any(lessThan(at.xy, vec2(0.0))) || any(greaterThan(at.xy, vec2(1.0)))) return 1.0;
    vec2 place = at.xy * vec2(textureSize(shadow_map, 0)) - 0.5, part = fract(place);
    ivec2 corner = ivec2(floor(place));
    float lower = mix(is_lit(corner, at.z), is_lit(corner + ivec2(1, 0), at.z), part.x);
    float upper = mix(is_lit(corner + ivec2(0, 1), at.z), is_lit(corner + ivec2(1, 1), at.z), part.x);
    return mix(lower, upper, part.y);
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float depth = shape_depth(texelFetch(surface_shape, pixel, 0));
    if (depth <= 0.0) discard; // no water here
    vec3 p = frame_ray((vec2(pixel) + 0.5) * pixel_size) / depth;
    vec4 at = shadow_matrix[0] * p.x + shadow_matrix[1] * p.y + shadow_matrix[2] * p.z + shadow_matrix[3];
    color = vec4(lit_share(at.xyz / at.w));
}
#endif

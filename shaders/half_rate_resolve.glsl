// SPDX-License-Identifier: MIT
// Half-rate shading, the resolve: upsamples the shaded samples into the image (src/render/half_rate.c). KEPT: the shape
// that the optics keeps states where there is water, else the mesh does. OPAQUE: the image has other objects. These are
// defines, because `discard` is expensive: software OpenGL then tests depth late.
#include "common/frame.glsl"
#ifdef KEPT
#include "common/fullscreen.glsl"
#else
#include "common/water_vertex.glsl"
#endif

#ifdef VERTEX
#ifdef KEPT
void main() { fullscreen(0.0); }
#else
void main() { water_vertex(); }
#endif
#endif

#ifdef FRAGMENT
out vec4 color;
#pragma unit sparse_light 23
uniform sampler2D sparse_light; // premultiplied by the share of water
// x, y: from a pixel's column to the samples': scale, origin; z: the last of those; w: pixels that they lie to the left
uniform vec4 places;
#ifdef KEPT
#include "common/shape.glsl"
#include "common/shape_maps.glsl"

// Samples of nearer or farther water, across the edge of a wave, count little. `share`: of the samples in those
// columns.
const float OTHER_WATER = 0.1, OTHER_SHARE = 0.01; // difference of the distance over it
vec2 edges_kept(vec2 share, ivec2 from, int next) {
    vec2 at = (vec2(from.x, next) + 0.5) / places.x - places.w;
    at = clamp(at, vec2(0.0), vec2(textureSize(surface_shape, 0).x) - 0.5);
    float here = shape_depth(texelFetch(surface_shape, ivec2(gl_FragCoord.xy), 0));
    vec2 there = vec2(shape_depth(texelFetch(surface_shape, ivec2(int(at.x), from.y), 0)),
                      shape_depth(texelFetch(surface_shape, ivec2(int(at.y), from.y), 0)));
    share *= mix(vec2(1.0), vec2(OTHER_SHARE), greaterThan(abs(there - here), vec2(OTHER_WATER * here)));
    return share / (share.x + share.y);
}
#endif

void main() {
#if defined(KEPT) && defined(OPAQUE)
    if (texelFetch(surface_shape, ivec2(gl_FragCoord.xy), 0).x == 0u) discard;
#endif
#ifdef TRIM
    round_earth(water_place.xy);
#endif
    // columns of the samples on both sides; none of them lies between rows
    float at = gl_FragCoord.x * places.x + places.y, left = floor(at);
    ivec2 from = ivec2(max(int(left), 0), int(gl_FragCoord.y));
    ivec2 next = ivec2(min(int(left) + 1, int(places.z)), from.y);
    vec2 share = vec2(1.0 - (at - left), at - left);
#ifdef KEPT
    share = edges_kept(share, from, next.x);
#endif
    vec4 light = share.x * texelFetch(sparse_light, from, 0) + share.y * texelFetch(sparse_light, next, 0);
#ifdef KEPT // a wave's tip between two samples stands over water in the row below
    from.y = next.y = max(from.y - 1, 0);
    vec4 lower = share.x * texelFetch(sparse_light, from, 0) + share.y * texelFetch(sparse_light, next, 0);
    light = light.a < 0.05 ? lower : light;
#endif
    // no sample covers this pixel: a wave's tip between two samples, water between objects, or the rim of the quad
#if defined(KEPT) || defined(QUAD) // the pixel's depth keeps the sky pass out: fall back to skylight
    float water = 1.0;
#ifdef KEPT
    water = texelFetch(surface_shape, ivec2(gl_FragCoord.xy), 0).x == 0u ? 0.0 : 1.0;
#endif
    if (light.a < 0.05) light = vec4(water * sky_light * 0.31830989, 1.0);
#else
    if (light.a < 0.05) discard;
#endif
    color = vec4(light.rgb / max(light.a, 0.05), 1.0);
}
#endif

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
uniform vec4 places;            // x, y: from a pixel's column to the samples': scale, origin; z: the last of those
#ifdef KEPT
#pragma unit shape_rest 16
uniform highp sampler2D shape_rest; // w: 0 where there is no water
#endif

void main() {
#if defined(KEPT) && defined(OPAQUE)
    if (texelFetch(shape_rest, ivec2(gl_FragCoord.xy), 0).w == 0.0) discard;
#endif
#ifdef TRIM
    round_earth(water_place.xy);
#endif
    // columns of the samples on both sides; none of them lies between rows
    float at = gl_FragCoord.x * places.x + places.y, left = floor(at);
    ivec2 from = ivec2(int(left), int(gl_FragCoord.y));
    ivec2 next = ivec2(min(from.x + 1, int(places.z)), from.y);
    vec4 light = mix(texelFetch(sparse_light, max(from, 0), 0), texelFetch(sparse_light, next, 0), at - left);
    // no sample covers this pixel: a wave's tip between two samples, water between objects, or the rim of the quad
#if defined(KEPT) || defined(QUAD) // the pixel's depth keeps the sky pass out: fall back to skylight
    if (light.a < 0.05) light = vec4(sky_light * 0.31830989, 1.0);
#else
    if (light.a < 0.05) discard;
#endif
    color = vec4(light.rgb / max(light.a, 0.05), 1.0);
}
#endif

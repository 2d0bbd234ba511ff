// SPDX-License-Identifier: MIT
// Exposure, film curve, display encoding, dither. With GLOW: what a lens and an eye scatter of bright light. With
// ACCUMULATE: adds the display value to a sum and the radiance to another, and writes both. With RESOLVE: writes out
// the mean of the first sum. With LINEAR: writes out the source times a factor, neither tone mapped nor dithered. As a
// compute shader it writes the display value into an image, which RESOLVE writes out.
#include "common/fullscreen.glsl"
#ifdef VERTEX
void main() { fullscreen(0.5); }
#endif
#ifndef VERTEX
#include "common/frame.glsl"
#include "common/tonemap.glsl"
uniform sampler2D source;
#pragma unit source 15
uniform sampler2D glow;
#pragma unit glow 17
// x: share of the glow, y: 1 encode sRGB, z: dither [1/255], w: weight of the source (RESOLVE, LINEAR), of the old sum
// (ACCUMULATE)
uniform vec4 settings;

// What is displayed for radiance c at that place of the picture.
vec3 displayed(vec3 c, vec2 place) {
    c *= exposure;
#ifdef GLOW
    vec3 around = 0.5 * textureLod(glow, place, 1.0).rgb + 0.3 * textureLod(glow, place, 3.0).rgb +
                  0.2 * textureLod(glow, place, 5.0).rgb;
    c = mix(c, around, settings.x);
#endif
    return tonemap(c);
}
#endif

#ifdef COMPUTE
bool shade(vec2 centre, out vec4 color) {
    color = vec4(displayed(texelFetch(source, ivec2(centre), 0).rgb, centre * pixel_size), 1.0);
    return true;
}
#include "common/pixels.glsl"
#endif

#ifdef FRAGMENT
uniform sampler2D sum;
#pragma unit sum 18
uniform vec2 origin; // lower left corner of the picture in its framebuffer [px]
#ifdef ACCUMULATE
uniform sampler2D radiance_sum;
#pragma unit radiance_sum 16
layout(location = 0) out vec4 color;
layout(location = 1) out vec4 radiance;
#else
out vec4 color;
#endif

// Interleaved gradient noise (Jimenez 2014), -1..1: at half a level either way the mean is the value.
float dither_noise(vec2 p) { return 2.0 * fract(52.9829189 * fract(dot(p, vec2(0.06711056, 0.00583715)))) - 1.0; }

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy - origin);
    vec3 c = texelFetch(source, at, 0).rgb;
#ifdef ACCUMULATE
    bool first = settings.w <= 0.0;
    radiance = vec4(c + (first ? vec3(0.0) : texelFetch(radiance_sum, at, 0).rgb), 1.0);
#endif
#ifdef LINEAR
    color = vec4(c * settings.w, 1.0);
    return;
#endif
#ifdef RESOLVE
    vec3 display = c * settings.w;
#else
    vec3 display = displayed(c, uv);
#endif
#ifdef ACCUMULATE
    color = vec4(display + (first ? vec3(0.0) : texelFetch(sum, at, 0).rgb), 1.0);
    return;
#endif
    if (settings.y > 0.5) display = srgb_encode(display);
    vec2 place = vec2(at) + 0.5 + tile_corner; // in the whole picture, so that tiles have the dither of the whole
    color = vec4(display + settings.z / 255.0 * dither_noise(place), 1.0);
}
#endif

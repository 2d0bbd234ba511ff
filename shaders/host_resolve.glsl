// SPDX-License-Identifier: MIT
// The water into a host's framebuffer: its colour, and its depth in the host's convention, where it is nearer than the
// host's scene. The host's depth test decides for each sample. TONEMAP: as bolan_output has it, else linear radiance.
#include "common/fullscreen.glsl"
#ifdef VERTEX
void main() { fullscreen(0.0); }
#endif
#ifdef FRAGMENT
#include "common/frame.glsl"
#include "common/tonemap.glsl"
#pragma unit water 15
#pragma unit water_depth 16
#pragma unit scene_depth 4
uniform sampler2D water;
uniform sampler2D water_depth;
uniform sampler2D scene_depth;
uniform vec4 host_depth;  // offset, scale; z: factor of radiance, w: 1 encode sRGB
uniform vec2 host_origin; // lower left corner of the rectangle in the framebuffer [px]
#ifdef MASK
#pragma unit mask 17
uniform sampler2D mask;   // no water where its red is above a half
uniform vec2 mask_origin; // lower left corner of the rectangle in it [px]
#endif
out vec4 color;

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy - host_origin);
    float depth = texelFetch(water_depth, at, 0).r;
    if (depth <= texelFetch(scene_depth, at, 0).r) discard;
#ifdef MASK
    if (texelFetch(mask, at + ivec2(mask_origin), 0).r > 0.5) discard;
#endif
    vec3 c = texelFetch(water, at, 0).rgb;
#ifdef TONEMAP
    c = tonemap(c * exposure);
    if (host_depth.w > 0.5) c = srgb_encode(c);
#else
    c *= host_depth.z;
#endif
    color = vec4(c, 1.0);
    gl_FragDepth = clamp(host_depth.x + host_depth.y * depth, 0.0, 1.0);
}
#endif

// SPDX-License-Identifier: MIT
// A host's opaque scene as the water passes read it: linear radiance in our unit, and reversed depth with an infinite
// far plane. Window depth of the host is host_depth.x + host_depth.y * ours, for every perspective: see host.c.
#include "common/fullscreen.glsl"
#ifdef VERTEX
void main() { fullscreen(0.0); }
#endif
#ifdef FRAGMENT
#pragma unit host_scene 15
#pragma unit host_scene_depth 16
uniform sampler2D host_scene;
uniform sampler2D host_scene_depth;
uniform vec4 host_depth; // offset, scale; z: factor of radiance
uniform vec2 host_origin; // lower left corner of the rectangle in the host's textures [px]
out vec4 color;

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy) + ivec2(host_origin);
    float depth = texelFetch(host_scene_depth, at, 0).r;
    color = vec4(texelFetch(host_scene, at, 0).rgb * host_depth.z, 1.0);
    gl_FragDepth = clamp((depth - host_depth.x) / host_depth.y, 0.0, 1.0);
}
#endif

// SPDX-License-Identifier: MIT
// A host's opaque scene as the water passes read it: linear radiance in our unit, and reversed depth with an infinite
// far plane. Window depth of the host is host_depth.x + host_depth.y * ours, for every perspective: see host.c.
// MULTISAMPLED: of a pixel's samples the farthest is taken.
#include "common/fullscreen.glsl"
#ifdef VERTEX
void main() { fullscreen(0.0); }
#endif
#ifdef FRAGMENT
#pragma unit host_scene 15
#pragma unit host_scene_depth 16
#ifdef MULTISAMPLED
uniform sampler2DMS host_scene;
uniform sampler2DMS host_scene_depth;
#else
uniform sampler2D host_scene;
uniform sampler2D host_scene_depth;
#endif
uniform vec4 host_depth; // offset, scale; z: factor of radiance, w: samples a pixel (MULTISAMPLED)
uniform vec2 host_origin; // lower left corner of the rectangle in the host's textures [px]
out vec4 color;

// Where a host with a finite far plane has drawn nothing, there is the sky, not a wall at that plane.
float our_depth(ivec2 at, int i) {
    float depth = texelFetch(host_scene_depth, at, i).r;
    if (depth == (host_depth.y > 0.0 ? 0.0 : 1.0)) return 0.0;
    return clamp((depth - host_depth.x) / host_depth.y, 0.0, 1.0);
}

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy) + ivec2(host_origin);
    int farthest = 0;
#ifdef MULTISAMPLED
    for (int i = 1; i < int(host_depth.w); ++i)
        if (our_depth(at, i) < our_depth(at, farthest)) farthest = i;
#endif
    color = vec4(texelFetch(host_scene, at, farthest).rgb * host_depth.z, 1.0);
    gl_FragDepth = our_depth(at, farthest);
}
#endif

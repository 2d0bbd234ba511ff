// SPDX-License-Identifier: MIT
// The depth of what stands before or behind the water, for a picture with fewer columns
// (src/render/half_rate.c): the minimum depth of the covered pixels (reversed, so the farthest), biased away so
// that coplanar water passes.
#include "common/depth.glsl"
#include "common/fullscreen.glsl"

#ifdef VERTEX
void main() { fullscreen(0.0); }
#endif

#ifdef FRAGMENT
#pragma unit picture_depth 23
uniform highp sampler2D picture_depth;
uniform int columns;

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy) * ivec2(columns, 1);
    int last = textureSize(picture_depth, 0).x - 1;
    float depth = 1.0;
    for (int i = 0; i < columns; ++i)
        depth = min(depth, texelFetch(picture_depth, ivec2(min(at.x + i, last), at.y), 0).x);
    gl_FragDepth = max(depth * 0.99999 - DEPTH_ROUNDING, 0.0); // the first: a sample lies between its pixels
}
#endif

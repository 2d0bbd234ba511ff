// SPDX-License-Identifier: MIT
// Copies a depth texture into a float colour target (src/render/gl/target.c), since ES cannot read depth back.
#include "common/fullscreen.glsl"
#ifdef VERTEX
void main() { fullscreen(0.5); }
#endif
#ifdef FRAGMENT
uniform sampler2D depth_source;
out vec4 color;
void main() { color = vec4(texelFetch(depth_source, ivec2(gl_FragCoord.xy), 0).r); }
#endif

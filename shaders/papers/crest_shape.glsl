// SPDX-License-Identifier: MIT
// The shape of the water for crest.glsl: the rest point of the surface in each pixel. Small triangles cost software GL
// several times their pixels: keep this stage minimal.
#include "common/frame.glsl"
#include "common/water_vertex.glsl"

#ifdef VERTEX
void main() { water_vertex(); }
#endif

#ifdef FRAGMENT
#include "common/shape.glsl"
layout(location = 0) out uvec4 out_shape;

void main() {
    water_pixel p = water_here();
    vec4 mesh = vec4(0.0);
#ifdef WAVES_MESH
    mesh = p.mesh; // foam in the place of the depth
#endif
    out_shape = shape_texel(water_shape(p.rest, mesh.xy, mesh.z, mesh.w), seen_position(p), gl_FragCoord.w);
}
#endif

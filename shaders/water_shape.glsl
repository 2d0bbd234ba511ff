// SPDX-License-Identifier: MIT
// The shape of the water, a few numbers per pixel. water_physical.glsl shades each pixel once from them, because the
// triangles are so small that shading them one by one would shade most pixels several times.
#include "common/frame.glsl"
#include "common/water_vertex.glsl"

#ifdef VERTEX
void main() { water_vertex(); }
#endif

#ifdef FRAGMENT
#include "common/shape.glsl"
layout(location = 0) out uvec4 out_shape;

const float FLAT_SPACING = 10000.0; // of a mesh without waves [m]: longer than any

void main() {
    water_pixel p = water_here();
#ifdef WAVES_MESH
    float spacing = p.mesh.z;
#elif defined(QUAD)
    float spacing = log2(FLAT_SPACING);
#else
    float spacing = log2(max(p.spacing, 1e-3));
#endif
    out_shape = shape_texel(water_shape(p.rest, p.mesh.xy, spacing, p.depth), seen_position(p), gl_FragCoord.w);
}
#endif

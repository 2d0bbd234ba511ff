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
layout(location = 0) out vec4 out_mesh; // slope of the mesh; 16 + log2 of its spacing [m], or where it carries the
                                        // waves 4 + its jacobian; depth of the mean water [m]
layout(location = 1) out vec4 out_bend; // bend of sea_place; w: share of the sun that passes the clouds
layout(location = 2) out vec4 out_rest; // common/shape.glsl

const float FLAT_SPACING = 10000.0; // of a mesh without waves [m]: longer than any

void main() {
    water_pixel p = water_here();
    out_rest = shape_texel(p.rest, p.place, gl_FragCoord.z);
#ifdef WAVES_MESH
    float coded = 4.0 + clamp(p.mesh.z, -3.0, 3.0);
#elif defined(QUAD)
    float coded = 16.0 + log2(FLAT_SPACING);
#else
    float coded = 16.0 + log2(max(p.spacing, 1e-3));
#endif
    out_mesh = vec4(p.mesh.xy, coded, p.depth);
    out_bend = vec4(p.place.bend, p.shade);
}
#endif

// SPDX-License-Identifier: MIT
// The shape of the water, a few numbers per pixel. water_physical.glsl shades each pixel once from them, because the
// triangles are so small that shading them one by one would shade most pixels several times.
#include "common/frame.glsl"
#include "common/water_vertex.glsl"

#ifdef VERTEX
void main() { water_vertex(); }
#endif

#ifdef FRAGMENT
layout(location = 0) out vec4 out_rest;          // undisplaced xy, mean depth of the water [m]; w: window depth
layout(location = 1) out vec4 out_slope;         // slope of the mesh, gust factor, sun through the clouds 0..1
layout(location = 2) out vec4 out_transmittance; // of the air to the eye; w: 16 + log2 of the mesh's spacing [m], or
                                                 // where it carries the waves 4 + its jacobian; 0: no water here
layout(location = 3) out vec4 out_inscatter;     // of the air to the eye; w: least depth within a few metres [m]

const float FLAT_SPACING = 10000.0; // of a mesh without waves [m]: longer than any

void main() {
    water_pixel p = water_here();
    out_rest = vec4(p.rest, p.depth, gl_FragCoord.z);
    out_slope = vec4(p.mesh.xy, p.gust, p.shade);
#ifdef WAVES_MESH
    float coded = 4.0 + clamp(p.mesh.z, -3.0, 3.0);
#elif defined(QUAD)
    float coded = 16.0 + log2(FLAT_SPACING);
#else
    float coded = 16.0 + log2(max(p.spacing, 1e-3));
#endif
    out_transmittance = vec4(p.transmittance, coded);
    out_inscatter = vec4(p.inscatter, p.least);
}
#endif

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
layout(location = 0) out vec4 out_rest; // common/shape.glsl
#if defined(WAVES_MESH) || defined(WAVES_CASCADES)
layout(location = 1) out vec4 out_fields; // WAVES_MESH: slope, jacobian, foam of the mesh; cascades: bend of sea_place
#endif

void main() {
    water_pixel p = water_here();
    out_rest = shape_texel(p.rest, p.place, gl_FragCoord.z);
#ifdef WAVES_MESH
    out_fields = p.mesh;
#elif defined(WAVES_CASCADES)
    out_fields = vec4(p.place.bend, 0.0);
#endif
}
#endif

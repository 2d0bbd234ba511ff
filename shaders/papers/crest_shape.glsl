// SPDX-License-Identifier: MIT
// The shape of the water for crest.glsl: the rest point of the surface in each pixel. Small triangles cost software GL
// several times their pixels: keep this stage minimal.
#include "common/frame.glsl"
#include "common/water_vertex.glsl"

#ifdef VERTEX
void main() { water_vertex(); }
#endif

#ifdef FRAGMENT
layout(location = 0) out vec4 out_rest; // undisplaced xy, 0, window depth; all 0: no water
#ifdef WAVES_MESH
layout(location = 1) out vec4 out_mesh; // slope, jacobian, foam of the mesh
#endif

void main() {
    water_pixel p = water_here();
    out_rest = vec4(p.rest, 0.0, gl_FragCoord.z);
#ifdef WAVES_MESH
    out_mesh = p.mesh;
#endif
}
#endif

// SPDX-License-Identifier: MIT
// Normals of the mesh and one light (Liu, Xu & Chen 2009, section 3).
#include "common/frame.glsl"
#include "common/water_vertex.glsl"

#ifdef VERTEX
void main() { water_vertex(); }
#endif

#ifdef FRAGMENT
#include "common/look.glsl"
#include "common/fresnel.glsl"
out vec4 color;

void main() {
    water_pixel p = water_here();
    float dist = length(p.position);
    vec3 view = -p.position / dist;
    footprint f = pixel_footprint(view, dist, p.mesh.xy);
    wave_fields w = waves_at(p.rest, f, p.gust, p.depth, p.mesh);
    vec3 normal = normalize(vec3(-w.slope, 1.0));
    float reflectance = fresnel(clamp(dot(view, normal), 0.02, 1.0), water_deep.w);
    vec3 mirrored = reflect(-view, normal);
    vec3 sky = environment_radiance(vec3(mirrored.xy, abs(mirrored.z)), 0.1);
    vec3 below = water_deep.rgb * (sun_light.rgb * max(dot(sun.xyz, normal), 0.0) + sky_light.rgb);
    color = vec4((mix(below, sky, reflectance)) * p.transmittance + p.inscatter, 1.0);
}
#endif

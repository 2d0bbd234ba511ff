// SPDX-License-Identifier: MIT
// The shape of the water: the mesh displaced by the cascades, written as a few numbers per pixel that water.glsl shades
// afterwards, each pixel once: the triangles are so small that shading them one by one would pay for most pixels several times.
// What varies slowly (haze, gusts, cloud shadow, depth) is computed here, at the vertices.
//
// LAND: there is terrain, and shallow water attenuates the waves.
#include "common/frame.glsl"

#ifdef VERTEX
#include "common/sea.glsl"
#include "common/gusts.glsl"
#include "common/atmosphere.glsl"
#ifdef LAND
#include "common/shore.glsl"
#endif
layout(location = 0) in vec4 vertex; // eye-relative mean water; w: spacing [m]
out vec3 rest_depth;   // undisplaced xy, mean depth of the water
out vec4 slope_light;
out vec3 transmittance;
out vec4 inscatter;

void main() {
    vec2 rest = vertex.xy;
    vec3 offset = vec3(0.0);
    vec2 slope = vec2(0.0);
    float depth = 1000.0, least = 1000.0;
#ifdef LAND
    depth = -shore_elevation(rest);
    least = depth;
    for (int i = 0; i < 4; ++i) {
        vec2 d = 5.0 * vec2(i < 2 ? 1.0 : -1.0, (i & 1) == 0 ? 1.0 : -1.0);
        least = min(least, -shore_elevation(rest + d));
    }
#endif
    for (int c = 0; c < cascade_count; ++c) {
        vec4 band = cascade_band[c];
        if (vertex.w > band.z) break; // every wave of it is shorter than the mesh
        float lod = max(log2(vertex.w) - band.w - 0.5, 0.0); // the triangles blur too: half a level is theirs
        vec3 uv = vec3(cascade_uv(c, rest), float(c));
        vec4 s = textureLod(displacement_map, uv, lod);
        float keep = 1.0;
#ifdef LAND
        keep = shore_attenuation(depth, band.x);
#endif
        offset += keep * vec3(choppiness * s.xy, s.z);
        slope += keep * textureLod(slope_map, uv, lod).xy;
    }
    vec3 position = vertex.xyz + offset;
    rest_depth = vec3(rest, depth);
    slope_light = vec4(slope, gustiness(haze.zw + rest, vertex.w), cloud_shadow(position.xy));
    vec3 haze_light;
    aerial_perspective(position, transmittance, haze_light);
    inscatter = vec4(haze_light, least);
    gl_Position = view_projection * vec4(position, 1.0);
}
#endif

#ifdef FRAGMENT
in vec3 rest_depth;
in vec4 slope_light;
in vec3 transmittance;
in vec4 inscatter;
layout(location = 0) out vec4 out_rest;          // undisplaced xy, mean depth of the water [m]; w: window depth
layout(location = 1) out vec4 out_slope;         // slope of the mesh, gust factor, share of the sun that passes the clouds
layout(location = 2) out vec4 out_transmittance; // of the air to the eye; w: 1, there is water
layout(location = 3) out vec4 out_inscatter;     // of the air to the eye; w: least depth within a few metres [m]

void main() {
    out_rest = vec4(rest_depth, gl_FragCoord.z);
    out_slope = slope_light;
    out_transmittance = vec4(transmittance, 1.0);
    out_inscatter = inscatter;
}
#endif

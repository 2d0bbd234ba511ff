// SPDX-License-Identifier: MIT
// Normal and label of land and objects, for bolan_renderer_read_surfaces(): the same places as ground.glsl and, with
// OBJECT defined, objects.glsl give.
#include "common/frame.glsl"
#include "common/atmosphere.glsl"

uniform float label;
#ifdef OBJECT
uniform vec4 place[3]; // rows of the matrix from model to eye-relative world
#else
uniform vec4 chunk;    // xyz: eye-relative south-west corner at elevation 0, w: side [m]
#endif

#ifdef VERTEX
layout(location = 0) in vec3 vertex;
#ifdef OBJECT
layout(location = 1) in vec3 vertex_normal;
out vec3 normal;
#else
out vec2 map_place;
#endif

void main() {
#ifdef OBJECT
    vec4 v = vec4(vertex, 1.0);
    vec3 position = vec3(dot(place[0], v), dot(place[1], v), dot(place[2], v));
    normal = vec3(dot(place[0].xyz, vertex_normal), dot(place[1].xyz, vertex_normal), dot(place[2].xyz, vertex_normal));
#else
    vec3 position = chunk.xyz + vertex;
    map_place = (vertex.xy / chunk.w * 128.0 + 0.5) / 129.0;
#endif
    position.z -= earth_drop(dot(position.xy, position.xy), earth_radius);
    gl_Position = view_projection * vec4(position, 1.0);
}
#endif

#ifdef FRAGMENT
#ifdef OBJECT
in vec3 normal;
#else
in vec2 map_place;
#pragma unit chunk_map 11
uniform sampler2D chunk_map; // normal x, y
#endif
out vec4 color;

void main() {
#ifdef OBJECT
    color = vec4(normalize(normal), label);
#else
    vec2 slope = textureLod(chunk_map, map_place, 0.0).xy;
    color = vec4(normalize(vec3(slope, sqrt(max(1.0 - dot(slope, slope), 0.02)))), label);
#endif
}
#endif

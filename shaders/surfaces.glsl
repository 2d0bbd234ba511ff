// SPDX-License-Identifier: MIT
// Normal and label of land and objects, for bolan_renderer_read_surfaces(): the same places as ground.glsl and, with
// OBJECT defined, objects.glsl give. With MOTION the motion vectors of objects.
#include "common/frame.glsl"
#include "common/atmosphere.glsl"

#ifdef MOTION
#include "common/motion.glsl"
uniform vec4 place_before[3]; // as place, of the step before, relative to the eye of now
#else
uniform float label;
#endif
#ifdef OBJECT
uniform vec4 place[3]; // rows of the matrix from model to eye-relative world
#else
uniform vec4 chunk;    // xyz: eye-relative south-west corner at elevation 0, w: side [m]
#endif

#ifdef VERTEX
layout(location = 0) in vec3 vertex;
#ifdef OBJECT
#ifdef MOTION
out vec3 now;
out vec3 before;
#else
layout(location = 1) in vec3 vertex_normal;
out vec3 normal;
#endif
#else
out vec2 map_place;
#endif

void main() {
#ifdef OBJECT
    vec4 v = vec4(vertex, 1.0);
    vec3 position = vec3(dot(place[0], v), dot(place[1], v), dot(place[2], v));
#ifdef MOTION
    before = vec3(dot(place_before[0], v), dot(place_before[1], v), dot(place_before[2], v));
    before.z -= earth_drop(dot(before.xy, before.xy), earth_radius);
#else
    normal = vec3(dot(place[0].xyz, vertex_normal), dot(place[1].xyz, vertex_normal), dot(place[2].xyz, vertex_normal));
#endif
#else
    vec3 position = chunk.xyz + vertex;
    map_place = (vertex.xy / chunk.w * 128.0 + 0.5) / 129.0;
#endif
    position.z -= earth_drop(dot(position.xy, position.xy), earth_radius);
#ifdef MOTION
    now = position;
#endif
    gl_Position = view_projection * vec4(position, 1.0);
}
#endif

#ifdef FRAGMENT
#ifdef MOTION
in vec3 now;
in vec3 before;
#elif defined(OBJECT)
in vec3 normal;
#else
in vec2 map_place;
#pragma unit chunk_map 11
uniform sampler2D chunk_map; // normal x, y
#endif
out vec4 color;

void main() {
#ifdef MOTION
    // the picture shows it where the depths agree, up to the rounding of two programs
    float depth = texelFetch(frame_depth, ivec2(gl_FragCoord.xy - origin), 0).r;
    if (abs(gl_FragCoord.z - depth) > 1e-4 * depth + DEPTH_ROUNDING) discard;
    color = vec4(motion_of(vec4(now, 1.0), vec4(before, 1.0)), 0.0, 1.0);
#elif defined(OBJECT)
    color = vec4(normalize(normal), label);
#else
    vec2 slope = textureLod(chunk_map, map_place, 0.0).xy;
    color = vec4(normalize(vec3(slope, sqrt(max(1.0 - dot(slope, slope), 0.02)))), label);
#endif
}
#endif

// SPDX-License-Identifier: MIT
// The shaders of the engine in 04_in_your_engine.c: a sky, lit cubes, a tone map. Nothing of Bolan's is in them.
#ifndef EXAMPLE_SHADERS_H
#define EXAMPLE_SHADERS_H

#define SKY                                                         \
    "vec3 sky(vec3 d) { float h = pow(1.0 - max(d.z, 0.0), 4.0);\n" \
    "  return mix(vec3(0.10, 0.19, 0.38), vec3(0.42, 0.48, 0.55), h); }\n"

static const char sky_vertex[] =
    "uniform mat4 from_clip; out vec3 ray;\n"
    "void main() { vec2 p = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);\n"
    "  vec4 v = from_clip * vec4(p, 1.0, 1.0); ray = v.xyz / v.w;\n"
    "  gl_Position = vec4(p, 0.0, 1.0); }\n"; // reversed depth: 0 is far
static const char sky_fragment[] =
    "in vec3 ray; out vec4 color;\n" SKY "void main() { color = vec4(sky(normalize(ray)), 1.0); }\n";
static const char cube_vertex[] =
    "uniform mat4 to_clip; uniform vec4 place; out vec3 normal;\n" // 36 corners, without a buffer
    "void main() { int face = gl_VertexID / 6, c = gl_VertexID % 6;\n"
    "  vec2 q = vec2(c == 1 || c == 2 || c == 4 ? 1.0 : -1.0, c == 2 || c == 4 || c == 5 ? 1.0 : -1.0);\n"
    "  float s = face < 3 ? 1.0 : -1.0; vec3 p = vec3(q, s);\n"
    "  p = face % 3 == 0 ? p.zxy : face % 3 == 1 ? p.yzx : p;\n"
    "  normal = face % 3 == 0 ? vec3(s, 0, 0) : face % 3 == 1 ? vec3(0, s, 0) : vec3(0, 0, s);\n"
    "  gl_Position = to_clip * vec4(place.xyz + place.w * p, 1.0); }\n";
static const char cube_fragment[] =
    "uniform vec3 albedo, sun; in vec3 normal; out vec4 color;\n"
    "void main() { float light = 0.9 * max(dot(normal, sun), 0.0) + 0.5 + 0.2 * normal.z;\n"
    "  color = vec4(albedo * light / 3.14159, 1.0); }\n";
static const char show_vertex[] = "void main() { gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0,\n"
                                  "  gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0); }\n";
static const char show_fragment[] = "uniform sampler2D hdr; out vec4 color;\n"
                                    "void main() { vec3 c = texelFetch(hdr, ivec2(gl_FragCoord.xy), 0).rgb;\n"
                                    "  color = vec4(pow(1.0 - exp(-3.0 * c), vec3(1.0 / 2.2)), 1.0); }\n";

#endif

#include "common/fullscreen.glsl"
#ifdef VERTEX
void main() { fullscreen(0.0); }
#endif
#ifdef FRAGMENT
#define main crest_main
#include "common/../water_crest.glsl"
#undef main
uniform sampler2D inputs;
layout(location = 0) out vec4 result;
vec4 probe(vec4 x) { vec3 v = normalize(x.xyz); return vec4(crest_light(0.5, v, vec3(2.0)), -dot(v, sun_direction)); }
void main() { result = probe(texelFetch(inputs, ivec2(gl_FragCoord.xy), 0)); }
#endif

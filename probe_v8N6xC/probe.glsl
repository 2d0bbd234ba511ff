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
vec4 probe(vec4 x) { crest_pixel p; p.position = vec3(0.0); p.rest = vec2(0.0); return vec4(crest_mask(p, wave_fields(x.z * x.xy, 0.7, 0.0), x.w, x.xy), crest_mask(p, wave_fields(x.z * x.xy, 1.0, 0.0), x.w, x.xy), 0.0, 0.0); }
void main() { result = probe(texelFetch(inputs, ivec2(gl_FragCoord.xy), 0)); }
#endif

// SPDX-License-Identifier: MIT
// One level of the environment map, blurred: round each direction a Gaussian of environment_blur() in angle, whatever
// the size of the texels there, over the sphere on which the sky goes on below the horizon as its mirror image. Wider
// than the texels, so that a texture fetch between those of even the coarsest level shows no grid (a plain mip chain
// would). Reads a plain mip chain of the same map.
#include "common/fullscreen.glsl"
#ifdef VERTEX
void main() { fullscreen(0.5); }
#endif
#ifdef FRAGMENT
#include "common/environment.glsl"
uniform sampler2D plain_map;
#pragma unit plain_map 15
uniform float level;
out vec4 color;

// Places along each axis of the pattern, and their distance in standard deviations: it reaches to 2.25 of them.
const int PLACES = 6;
const float STEP = 0.9;

// What the texels blur by themselves, as a variance along each side [sides squared]: the plain map's are means (1/12)
// between which it is interpolated (1/6), and so is the level that is made here (1/6).
const float OWN_VARIANCE = 0.417;

void main() {
    if (level < 0.5) {
        color = textureLod(plain_map, uv, 0.0);
        return;
    }
    vec3 to = environment_direction(uv);
    vec3 side = normalize(cross(to, abs(to.z) < 0.9 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0))), up = cross(side, to);
    float blur = environment_blur(level), texel = environment_texel(to, level);
    float spread = sqrt(blur * blur - OWN_VARIANCE * texel * texel), weights = 0.0;
    vec3 sum = vec3(0.0);
    for (int i = 0; i < PLACES; ++i) {
        for (int j = 0; j < PLACES; ++j) {
            vec2 place = STEP * (vec2(float(i), float(j)) - 0.5 * float(PLACES - 1));
            float w = exp(-0.5 * dot(place, place)), angle = spread * length(place);
            vec2 turn = spread * place * (sin(angle) / max(angle, 1e-6));
            vec3 from = to * cos(angle) + side * turn.x + up * turn.y;
            sum += w * textureLod(plain_map, environment_uv(vec3(from.xy, abs(from.z))), level).rgb;
            weights += w;
        }
    }
    color = vec4(sum / weights, 1.0);
}
#endif

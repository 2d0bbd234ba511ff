// SPDX-License-Identifier: MIT
// From a covered share to bubbles: a tiled texture whose values are uniformly distributed, so that the texels above
// 1 - share cover the share. src/render/foam_texture.c makes it: r, g two nets of bubbles, coarse and fine; b, a smooth
// noise. Needs common/slopes.glsl for normal_cdf().
#include "shared/constants.glsl"
#pragma unit foam_detail 7
uniform sampler2D foam_detail;

struct foam_texels { vec4 broad, middle, streak; };

// `detail`: log2 of the texels of a 1 m tile under the pixel.
vec4 foam_texel(vec2 p, float log2_tile, float detail) {
    return textureLod(foam_detail, p * exp2(-log2_tile), max(detail - log2_tile, 0.0));
}

// rest: eye-relative [m]; width of the pixel on the water [m].
foam_texels foam_look_up(vec2 rest, float width) {
    vec2 p = mod(water_wrapped + rest, WORLD_WRAP);
    // Old foam is drawn out along the wind. This tile lies turned, so the CPU finds the eye's place in it.
    vec2 drawn_out = streak_place + streak_scale *
                     vec2(dot(rest, vec2(-wind_direction.y, wind_direction.x)), dot(rest, wind_direction));
    float detail = log2(width * 512.0);
    return foam_texels(foam_texel(p, 6.0, detail), foam_texel(p.yx, 3.0, detail),
                       textureLod(foam_detail, drawn_out, max(detail + log2(streak_scale.x), 0.0)));
}

// The part of a value's range above 1 - share, with a soft edge; the mean over all values is the share.
float foam_pattern(float value, float share, float soft) {
    soft = min(soft, 2.0 * min(share, 1.0 - share)) + 1e-4;
    if (share <= 0.0) return 0.0; // the soft edge would leave specks
    return smoothstep(1.0 - share - soft * 0.5, 1.0 - share + soft * 0.5, value);
}

// A weighted mean of uniform values is nearly Gaussian; back to uniform.
float foam_flatten(vec3 values, vec3 weights) {
    return normal_cdf(dot(values - 0.5, weights) * 3.4641016 * inversesqrt(dot(weights, weights)));
}

// The look of foam, chosen by eye. Weights of the nets of bubbles (broad, middle, and fine where the pixel is narrow)
// of fresh and of old foam:
const vec3 DENSE_WEIGHTS = vec3(0.5, 0.45, 0.35), LACE_WEIGHTS = vec3(0.7, 0.25, 0.3);
const float DENSE_EDGE = 0.8, LACE_EDGE = 0.6;      // width of the soft edge, in shares
const float DENSE_FULL = 0.6;                       // cover from which on fresh foam is opaque
const float DENSE_LEAST = 0.5;                      // opacity of a wisp of it
const float LACE_LEAST = 0.35, LACE_MORE = 0.4;     // opacity of old foam: of little, and what the share adds
const float LACE_FAR = 0.5;                         // its mean
const float LACE_PATCHES = 0.4, LACE_NOISE = 1.2;   // patches of old foam: factor on its share, least and by noise
const float LACE_MOST = 0.9;                        // share that old foam covers at most
const float BUBBLES_DARK = 0.7;                     // opacity in the holes of the middle net
const float FINE_ALL = 0.03, FINE_NONE = 0.08;     // widths of a pixel [m]: the fine net is all there, and gone
const float FAR_WIDTH = 5.0;                        // [m], from which on only means are left

// Opacity of the foam where breaking crests cover `fresh` and decaying foam covers `old` of the water.
float foam_alpha(foam_texels t, float width, float fresh, float old) {
    float near = clamp((FINE_NONE - width) / (FINE_NONE - FINE_ALL), 0.0, 1.0);
    float far = clamp(width / FAR_WIDTH, 0.0, 1.0);
    vec3 fine = vec3(1.0, 1.0, near);
    float dense = foam_flatten(vec3(t.broad.r, t.middle.r, t.middle.g), DENSE_WEIGHTS * fine);
    float lace = foam_flatten(vec3(t.streak.r, t.middle.r, t.middle.g), LACE_WEIGHTS * fine);
    // fresh foam is thick in the middle of a patch and frayed at its edge; old foam is a net that thins out
    float thick = mix(DENSE_LEAST, 1.0, smoothstep(0.0, DENSE_FULL, fresh));
    float a = mix(foam_pattern(dense, fresh, DENSE_EDGE) * thick, fresh, far);
    float share = clamp(old * (LACE_PATCHES + LACE_NOISE * t.streak.a), 0.0, LACE_MOST);
    float b = mix(foam_pattern(lace, share, LACE_EDGE) * (LACE_LEAST + LACE_MORE * old), LACE_FAR * old, far);
    return clamp(a + b * (1.0 - a), 0.0, 1.0) * mix(mix(BUBBLES_DARK, 1.0, t.middle.g), 1.0, far);
}

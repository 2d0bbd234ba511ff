// SPDX-License-Identifier: MIT
// From the fields of foam to what a pixel shows. The thickness of foam is a field: the excess of the Jacobian or of the
// foam memory over its threshold, plus a Gaussian noise of patches, nets and bubbles; foam is where it is above 0. A
// pixel resolves a part of this field and hides the rest. Both parts are Gaussian, so the mean opacity, foam_opacity(),
// is the same at every distance (Dupuy & Bruneton 2012). src/render/foam_texture.c makes the noise.
#include "common/level.glsl"
#include "shared/constants.glsl"
#include "shared/foam.glsl"
#pragma unit foam_noise 7
uniform sampler2D foam_noise;

// Texture fetches of the noise: tiles of 64 m, 8 m and 1 m. 0..1.
struct foam_texels { vec4 broad, middle, fine; };

// `detail`: log2 of the texels of a 1 m tile under the pixel.
vec4 foam_texel(vec2 p, float log2_tile, float detail) {
    return textureLod(foam_noise, p * exp2(-log2_tile), fetched_level(max(detail - log2_tile, 0.0)));
}

// Where a rest point, eye-relative [m], lies among bubbles and small nets, and among patches and broad nets.
vec2 foam_place(vec2 rest) { return mod(foam_wrapped + rest, WORLD_WRAP); }
vec2 eddies_place(vec2 rest) { return mod(eddies_wrapped + rest, WORLD_WRAP); }

// rest: eye-relative [m]; width of the pixel on the water [m].
foam_texels foam_look_up(vec2 rest, float width) {
    vec2 p = foam_place(rest);
    float detail = log2(width * FOAM_TEXELS);
    return foam_texels(foam_texel(eddies_place(rest), 6.0, detail), foam_texel(p.yx, 3.0, detail),
                       foam_texel(p, 0.0, detail));
}

// Width across the wind of a pixel that lies along `axis` [m]; what it spans along the wind, windrows are drawn out by.
float windrow_width(vec2 axis, float minor, float major) {
    float cosine = dot(axis, wind_direction), sine = dot(axis, vec2(-wind_direction.y, wind_direction.x));
    vec2 along = vec2(major * cosine, minor * sine), across = vec2(minor * cosine, major * sine);
    return sqrt(max(dot(across, across), dot(along, along) / (WINDROW_STRETCH * WINDROW_STRETCH)));
}

// Windrows of a tile, and of WINDROWS_FINER tiles in its place. They lie turned, so the CPU finds the eye's place.
vec2 windrow_texels(vec2 rest, float width) {
    vec2 at = streak_place + streak_scale *
              vec2(dot(rest, vec2(-wind_direction.y, wind_direction.x)), dot(rest, wind_direction));
    float detail = log2(width * streak_scale.x * FOAM_TEXELS);
    return vec2(textureLod(foam_noise, at, max(detail, 0.0)).a,
                textureLod(foam_noise, at * WINDROWS_FINER, max(detail + log2(WINDROWS_FINER), 0.0)).a);
}

// Heights of the walls of small nets and of bubbles, a standard deviation of each [m], by eye.
const float NETS_HEIGHT = 0.012, BUBBLES_HEIGHT = 0.002;

// Slope of the foam itself towards the sun, times the sine of the sun's angle from the zenith: walls that face the sun
// are bright, those behind are in their own shadow, at a low sun most. The mean over a place is 0, and a pixel wider
// than the walls sees none of it: from RELIEF_FADES on it is not fetched.
const float RELIEF_FADES = 0.15, RELIEF_ENDS = 0.3; // [m]
float foam_relief(foam_texels here, vec2 rest, float width) {
    if (width >= RELIEF_ENDS) return 0.0;
    float far = length(sun_direction.xy), nets = max(0.04, width), bubbles = max(0.005, width);
    vec2 towards = sun_direction.xy / max(far, 1e-3), p = foam_place(rest);
    float detail = log2(width * FOAM_TEXELS);
    vec2 rise = vec2(foam_texel((p + nets * towards).yx, 3.0, detail).g - here.middle.g,
                     foam_texel(p + bubbles * towards, 0.0, detail).b - here.fine.b);
    float kept = clamp((RELIEF_ENDS - width) / (RELIEF_ENDS - RELIEF_FADES), 0.0, 1.0);
    return kept * far * FOAM_NOISE_RANGE * dot(rise, vec2(NETS_HEIGHT / nets, BUBBLES_HEIGHT / bubbles));
}

// Light of the sky on the foam, over that on a flat film: the hollows of bubbles of 3 to 25 cm see less of the sky than
// their walls. These cells do not shape the film, so that the mean light of foam is the same at every distance.
const vec2 HOLLOWS = vec2(0.09, 0.12); // of a standard deviation of the cells of 8 m and of 1 m tiles, by eye
float foam_hollows(foam_texels here) {
    return 1.0 + FOAM_NOISE_RANGE * dot(vec2(here.middle.b, here.fine.g) - FOAM_NOISE_MIDDLE / 255.0, HOLLOWS);
}

// Smooth patches of some metres, 0..1: x and y are independent.
const float SMOOTH_LEVEL = 5.0; // [log2 of texels of 64 m]
vec2 smooth_patches(vec2 rest, float width) {
    vec2 at = eddies_place(rest) / 64.0;
    float level = max(log2(width * (FOAM_TEXELS / 64.0)), SMOOTH_LEVEL);
    return vec2(textureLod(foam_noise, at, level).r, textureLod(foam_noise, at.yx + 0.5, level).r);
}

// Weights of the noises, by eye; each sum of squares is 1. Fresh and old foam: broad patches, broad nets, small nets,
// bubbles. Streaks: windrows, fine windrows, broad nets, small nets; and broad patches, bubbles.
const vec4 FRESH_WEIGHTS = vec4(0.5, 0.45, 0.55, 0.5), OLD_WEIGHTS = vec4(0.4, 0.52, 0.6, 0.45),
           STREAK_WEIGHTS = vec4(0.64, 0.38, 0.3, 0.36), STREAK_PIECES = vec4(0.3, 0.368, 0.0, 0.0);
// Widths of a pixel at which it averages over half of a noise's variance [texels]: patches, nets, bubbles, windrows.
const float PATCHES_WIDTH = 62.0, NETS_WIDTH = 11.0, BUBBLES_WIDTH = 4.9, WINDROWS_WIDTH = 5.5;

// A noise of foam in standard deviations, the part that the pixel resolves, and the variance that it hides.
struct foam_grain { float value, hidden; };

// widths: those of the pixel over those that hide half.
foam_grain foam_grain_of(vec4 texels, vec4 weights, vec4 widths) {
    float value = dot(texels - FOAM_NOISE_MIDDLE / 255.0, weights) * FOAM_NOISE_RANGE;
    return foam_grain(value, 1.0 - dot(weights * weights, 1.0 / (1.0 + widths * widths)));
}

// Of foam that lies as the waves left it, with FRESH_WEIGHTS or OLD_WEIGHTS.
foam_grain patch_grain(foam_texels t, vec4 weights, float width) {
    const vec4 HALF = vec4(64.0 * PATCHES_WIDTH, 64.0 * NETS_WIDTH, 8.0 * NETS_WIDTH, BUBBLES_WIDTH) / FOAM_TEXELS;
    return foam_grain_of(vec4(t.broad.r, t.broad.g, t.middle.g, t.fine.b), weights, width / HALF);
}

// windrows: windrow_texels() of a pixel of that windrow_width().
foam_grain streak_grain(foam_texels t, float width, vec2 windrows, float across) {
    float tiles = across * streak_scale.x;
    vec4 widths = vec4(vec2(tiles, tiles * WINDROWS_FINER) / WINDROWS_WIDTH,
                       width / (vec2(64.0, 8.0) * NETS_WIDTH)) * FOAM_TEXELS;
    foam_grain g = foam_grain_of(vec4(windrows, t.broad.g, t.middle.g), STREAK_WEIGHTS, widths);
    foam_grain pieces = foam_grain_of(vec4(t.broad.r, t.fine.b, vec2(FOAM_NOISE_MIDDLE / 255.0)), STREAK_PIECES,
                                      width * FOAM_TEXELS / vec2(64.0 * PATCHES_WIDTH, BUBBLES_WIDTH).xyxy);
    return foam_grain(g.value + pieces.value, g.hidden + pieces.hidden - 1.0);
}

// Opacity of a film of foam: `excess` and `hidden`, mean and variance of the field in the pixel, over its threshold;
// `deviation` of the noise in the field's unit; density per unit.
float foam_film(float excess, float hidden, float deviation, foam_grain grain, float density) {
    float variance = max(hidden + deviation * deviation * grain.hidden, 1e-9);
    return foam_opacity(excess + deviation * grain.value, variance, density);
}

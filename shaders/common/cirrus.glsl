// SPDX-License-Identifier: MIT
// High clouds of ice as a thin sheet: tufts whose crystals fall and are drawn out by the shear of the wind into fibres
// (cirrus), and a few fields of small grains (cirrocumulus). Needs common/clouds.glsl.

const float CIRRUS_HEIGHT = 9000.0;                 // [m]
const float CIRRUS_DEPTH = 0.55;                    // greatest optical depth, straight up
const float BAND_LENGTH = 210000.0, BAND_WIDTH = 34000.0; // of tiles of the noise: gatherings of fibres [m]
const float TUFT_LENGTH = 60000.0, TUFT_WIDTH = 13000.0;
const vec3 FIBRE_LENGTHS = vec3(120000.0, 75000.0, 42000.0), FIBRE_WIDTHS = vec3(8300.0, 3700.0, 1700.0);
const vec3 FIBRE_TURNS = vec3(0.0, 0.07, -0.05); // the wind turns over the height through which crystals fall
const float GRAIN_TILE = 3100.0, FIELD_TILE = 130000.0;

// How far the wind's course bends aside [m]: it turns by 22 degrees at most. Sines, for a noise texture's steps of
// 1 / 255 would be stairs in the fibres.
float wind_bend(vec2 q) {
    vec3 phase = q.x / vec3(23000.0, 9700.0, 4100.0) + q.y / vec3(61000.0, -23000.0, 13000.0) + vec3(0.4, 2.1, 4.4);
    return dot(vec3(5200.0, 2300.0, 420.0), sin(phase));
}

// The texture takes the nearest level, and the sheet would have a line where that changes.
vec4 between_levels(vec3 p, float level) {
    float coarse = floor(level) + 1.0;
    return mix(textureLod(cloud_noise, p, coarse), textureLod(cloud_noise, p, coarse - 1.0), coarse - level);
}

// Noise drawn out along x, about -1..1; aslant through the volume, so that its tiles do not repeat.
float drawn_out(vec2 q, float along, float across, float slice, float footprint) {
    vec3 p = vec3(q / vec2(along, across), slice + q.y / (5.3 * across));
    return 4.0 * between_levels(p, cloud_level(footprint, across)).a - 2.0;
}

// Optical depth straight up at a place of the pattern [m], seen over a footprint across the fibres, and along them.
float cirrus_depth(vec2 p, vec2 along, vec2 footprint) {
    vec2 q = vec2(dot(p, along), dot(p, vec2(-along.y, along.x)));
    q.y += wind_bend(q);
    float band = textureLod(cloud_noise, vec3(q / vec2(BAND_LENGTH, BAND_WIDTH), 0.5), 0.0).b;
    float tuft = textureLod(cloud_noise, vec3(q / vec2(TUFT_LENGTH, TUFT_WIDTH), 0.7), 0.0).b;
    float gathered = smoothstep(0.48, 0.80, band + 0.9 * (tuft - 0.5));
    vec3 fibre;
    for (int i = 0; i < 3; ++i)
        fibre[i] = drawn_out(q + vec2(0.0, FIBRE_TURNS[i] * q.x), FIBRE_LENGTHS[i], FIBRE_WIDTHS[i], 0.1 + 0.3 * float(i), footprint.x);
    float strand = dot(fibre, vec3(0.5, 0.4, 0.35));
    float depth = gathered * smoothstep(-0.5, 0.9, strand);
    float field = textureLod(cloud_noise, vec3(p / FIELD_TILE, 0.85), 0.0).b + 0.25 * (tuft - 0.5);
    vec4 grain = between_levels(vec3(p / GRAIN_TILE, 0.4 + p.y / 41000.0), cloud_level(footprint.y, GRAIN_TILE));
    float grains = smoothstep(0.62, 0.72, field) * clamp(3.5 * (grain.g - 0.42), 0.0, 1.0);
    return CIRRUS_DEPTH * max(depth, 0.6 * grains);
}

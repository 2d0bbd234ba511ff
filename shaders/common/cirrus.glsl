// SPDX-License-Identifier: MIT
// High clouds of ice as a thin sheet: tufts whose crystals fall and are drawn out by the shear of the wind into fibres
// (cirrus), and a few fields of small grains (cirrocumulus). Needs common/clouds.glsl.

const float CIRRUS_HEIGHT = 9000.0; // [m]
const float CIRRUS_DEPTH = 0.55;    // greatest optical depth, straight up

// Sizes of tiles of the noise, along and across the wind [m]: of gatherings of fibres, and of the fibres. A tile has 4
// to 16 gatherings and 8 to 32 fibres.
const float BAND_LENGTH = 210000.0, BAND_WIDTH = 34000.0, TUFT_LENGTH = 60000.0, TUFT_WIDTH = 13000.0;
const vec3 FIBRE_LENGTHS = vec3(120000.0, 75000.0, 42000.0), FIBRE_WIDTHS = vec3(8300.0, 3700.0, 1700.0);
const vec3 FIBRE_TURNS = vec3(0.0, 0.07, -0.05); // the wind turns over the height through which crystals fall
const float FIELD_TILE = 130000.0, GRAIN_TILE = 3100.0; // of cirrocumulus [m]

// How far the wind's course bends aside [m]: it turns by 30 degrees at most. Sines, for a noise texture's steps of
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

// Fibres at a place of the pattern with x along the wind [m], as a share of the greatest depth. width: of a sample,
// across them [m].
float cirrus_fibres(vec2 q, float width) {
    q.y += wind_bend(q);
    float band = textureLod(cloud_noise, vec3(q / vec2(BAND_LENGTH, BAND_WIDTH), 0.5), 0.0).b;
    float tuft = textureLod(cloud_noise, vec3(q / vec2(TUFT_LENGTH, TUFT_WIDTH), 0.7), 0.0).b;
    vec3 fibre;
    for (int i = 0; i < 3; ++i)
        fibre[i] = drawn_out(q + vec2(0.0, FIBRE_TURNS[i] * q.x), FIBRE_LENGTHS[i], FIBRE_WIDTHS[i],
                             0.1 + 0.3 * float(i), width);
    float strands = smoothstep(-0.5, 0.9, dot(fibre, vec3(0.5, 0.4, 0.35)));
    return smoothstep(0.48, 0.80, band + 0.9 * (tuft - 0.5)) * strands;
}

// Fields of grains, likewise.
float cirrocumulus(vec2 p, float width) {
    float field = textureLod(cloud_noise, vec3(p / FIELD_TILE, 0.85), 0.0).b;
    float cells = between_levels(vec3(p / GRAIN_TILE, 0.4 + p.y / 41000.0), cloud_level(width, GRAIN_TILE)).g;
    return 0.6 * smoothstep(0.60, 0.72, field) * clamp(3.5 * (cells - 0.42), 0.0, 1.0);
}

// Optical depth straight up at a place of the pattern [m]. width: of a sample, across the wind and along it [m].
float cirrus_depth(vec2 p, vec2 wind, vec2 width) {
    vec2 q = vec2(dot(p, wind), dot(p, vec2(-wind.y, wind.x)));
    return CIRRUS_DEPTH * max(cirrus_fibres(q, width.x), cirrocumulus(q, max(width.x, width.y)));
}

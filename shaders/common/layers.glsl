// SPDX-License-Identifier: MIT
// Wave layers in shaders: waves that are added to those of the sea. Twin of src/water/train.c and of add_layers() in
// src/query/query.c; the formula stands in shaders/shared/wave_train.glsl. src/render/wave_layers.c fills the block.
// common/waves.glsl includes it, which has footprints and the block.
#include "shared/wave_train.glsl"

#ifdef LAYERS
#define LAYER_COUNT layer_count
#else
// Software OpenGL pays for the body of a loop that no pixel enters: half of the flight-sim's water.
#define LAYER_COUNT 0
#endif

// A layer at a rest point.
struct layer_waves {
    float height;  // [m]
    vec2 slope;
    float share;   // of the amplitude, by envelope and coast
};

layer_waves layer_at(int i, vec2 rest, float depth) {
    vec4 wave = layer_wave[i], area = layer_area[i], extent = layer_extent[i];
    vec2 p = rest - area.xy;
    float along = dot(p, area.zw) * extent.x, across = (p.y * area.z - p.x * area.w) * extent.y;
    float e = train_edge(along, extent.z), f = train_edge(across, extent.z), keep = 1.0;
    if (e * f <= 0.0) return layer_waves(0.0, vec2(0.0), 0.0);
#ifdef LAND
    keep = coast_attenuation(depth, extent.w);
#endif
    float phase = dot(wave.xy, rest) + wave.w, amplitude = keep * wave.z;
    vec2 gradient = vec2(train_edge_slope(along, extent.z) * f * extent.x,
                         train_edge_slope(across, extent.z) * e * extent.y);
    vec2 envelope = vec2(gradient.x * area.z - gradient.y * area.w, gradient.x * area.w + gradient.y * area.z);
    return layer_waves(amplitude * e * f * cos(phase),
                       amplitude * (envelope * cos(phase) - e * f * sin(phase) * wave.xy),
                       keep * e * f);
}

// Length of a layer's waves [m].
float layer_length(int i) { return 2.0 * PI * inversesqrt(max(dot(layer_wave[i].xy, layer_wave[i].xy), 1e-12)); }

#ifdef VERTEX
// Adds the layers to a vertex of a mesh of that spacing.
void add_layers(vec2 rest, float spacing, float depth, inout vec3 offset, inout vec2 slope) {
    for (int i = 0; i < LAYER_COUNT; ++i) {
        layer_waves w = layer_at(i, rest, depth);
        float keep = train_on_grid(layer_length(i), spacing);
        offset.z += keep * w.height;
        slope += keep * w.slope;
    }
}
#endif

// Share of a layer's amplitude under a footprint: a Gaussian of 0.4 of its widths, as for the waves of a sum.
float layer_kept(int i, footprint f) {
    vec2 k = layer_wave[i].xy;
    float along = dot(f.axis, k), all = dot(k, k), major = 0.4 * f.major, minor = 0.4 * f.minor;
    return exp(-0.5 * (major * major * along * along + minor * minor * max(all - along * along, 0.0)));
}

#ifdef LAND
// Slope that the coast adds where its share of a layer changes: by its height in water of other depths.
vec2 layer_lean(int i, vec2 rest, float depth) {
    vec2 lean = vec2(0.0);
    if (shore_present == 1 && feels_bed(depth, layer_extent[i].w))
        lean = shore_fall(rest) * ((layer_at(i, rest, depth + LEAN_STEP).height -
                                    layer_at(i, rest, depth - LEAN_STEP).height) / (2.0 * LEAN_STEP));
    return lean;
}
#else
vec2 layer_lean(int i, vec2 rest, float depth) { return vec2(0.0); }
#endif

// Slope of the layers under a footprint.
vec2 layers_slope(vec2 rest, footprint f, float depth) {
    vec2 slope = vec2(0.0);
    for (int i = 0; i < LAYER_COUNT; ++i)
        slope += layer_kept(i, f) * (layer_at(i, rest, depth).slope + layer_lean(i, rest, depth));
    return slope;
}

// Slope covariance (xx, xy, yy) of the layers that the footprint removes: roughness.
vec3 layers_hidden(vec2 rest, footprint f, float depth) {
    vec3 hidden = vec3(0.0);
    for (int i = 0; i < LAYER_COUNT; ++i) {
        float kept = layer_kept(i, f), amplitude = layer_wave[i].z * layer_at(i, rest, depth).share;
        vec2 k = layer_wave[i].xy;
        hidden += 0.5 * amplitude * amplitude * (1.0 - kept * kept) * vec3(k.x * k.x, k.x * k.y, k.y * k.y);
    }
    return hidden;
}

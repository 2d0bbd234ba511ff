// SPDX-License-Identifier: MIT
// Land and sea bed. The mesh gives the shape; the chunk's map gives normals four times finer, cast shadows and open
// sky; a tiled noise, fetched at the footprint of the pixel, gives the finer grain of rock, crowns and sand. NEAR is
// defined for chunks fine enough to show the finest grain, PICTURE for planar views and for an eye under water. Points
// under the water are shaded as if dry and without haze; the water pass adds the water.
#include "common/frame.glsl"
#include "common/atmosphere.glsl"
#include "common/under.glsl"
#ifndef PICTURE
#include "common/gathered.glsl"
#endif

uniform vec4 chunk; // xyz: eye-relative south-west corner at elevation 0, w: side [m]

#ifdef VERTEX
layout(location = 0) in vec3 vertex; // east, north of the corner, elevation [m]
out vec3 position;      // eye-relative, with the earth's curvature
out vec3 place;         // map coordinates, elevation above the water level [m]
out vec3 transmittance; // of the air
out vec3 inscatter;

void main() {
    position = chunk.xyz + vertex;
    position.z -= earth_drop(dot(position.xy, position.xy), earth_radius);
    place = vec3((vertex.xy / chunk.w * 128.0 + 0.5) / 129.0, vertex.z - water_level);
    aerial_perspective(position, transmittance, inscatter);
#ifdef PICTURE
    position.z += seen_height(position.xy, place.z) - place.z;
#endif
    gl_Position = view_projection * vec4(position, 1.0);
}
#endif

#ifdef FRAGMENT
#ifdef CASTERS
#include "common/object_shadow.glsl"
#endif
in vec3 position;
in vec3 place;
in vec3 transmittance;
in vec3 inscatter;
out vec4 color;

#pragma unit chunk_map 11
#pragma unit ground_noise 12
uniform sampler2D chunk_map;    // normal x, y; shadow clearance [m]; open sky
uniform sampler2D ground_noise; // billows, their gradient, patches; periodic
uniform float shadow_softness;  // [m] of clearance


// The inputs of the materials.
struct ground {
    vec3 normal;
    float steep;      // tangent of the slope
    float elevation;  // above the water level [m]
    float open;       // sky that is not hidden
    float clearance;  // height of the shadow over the ground [m]
    float footprint;  // width of the pixel on the ground [m]
    vec4 wide, mid, near, fine; // noise of periods 1024, 64, 16 and 2 m
};

struct material {
    vec3 albedo;
    float bump;       // strength of the mid and near billows in the normal
    float rough;      // Oren-Nayar sigma
};

// A width between the short and the long side of the footprint: sharp at grazing angles, without noise.
float footprint_level(vec2 uv) {
    vec2 a = dFdx(uv) * 129.0, b = dFdy(uv) * 129.0;
    float area = abs(a.x * b.y - a.y * b.x), major = max(dot(a, a), dot(b, b));
    return max(0.5 * log2(max(area, 1e-8)), 0.5 * log2(max(major, 1e-8)) - 1.6);
}

// A period must divide the 4096 m after which eye_wrapped wraps. Below two texels a pixel, the mean: no grain is better
// than noise.
vec4 noise(vec2 p, float period, float footprint) {
    return textureLod(ground_noise, p / period, log2(max(footprint * 256.0 / period, 1e-3)));
}

material blend(material a, material b, float t) {
    return material(mix(a.albedo, b.albedo, t), mix(a.bump, b.bump, t), mix(a.rough, b.rough, t));
}

material sand(ground g) {
    vec3 tone = mix(vec3(0.62, 0.53, 0.38), vec3(0.72, 0.65, 0.51), g.wide.a);
    tone *= (0.88 + 0.24 * g.near.a) * (0.80 + 0.40 * g.fine.r);
    // Shells and bits of coral.
    tone = mix(tone, vec3(0.80, 0.77, 0.70), smoothstep(0.80, 0.92, g.fine.a) * smoothstep(0.45, 0.65, g.near.r) * 0.7);
    // Wet up to where the last waves ran; wet sand is darker and smoother.
    float wet = 1.0 - smoothstep(0.15, 0.75, g.elevation + 0.5 * (g.mid.a - 0.5) + 0.25 * (g.wide.a - 0.5));
    return material(tone * mix(1.0, 0.52, wet * step(-0.6, g.elevation)), mix(0.15, 0.04, wet), mix(0.45, 0.2, wet));
}

// Basalt: dark, rusty in places, layered where it stands steep.
material rock(ground g) {
    float light = clamp(g.mid.r * 1.1 - 0.1 + 0.5 * (g.wide.a - 0.5), 0.0, 1.0);
    vec3 tone = mix(vec3(0.052, 0.048, 0.045), vec3(0.165, 0.142, 0.115), light);
    tone = mix(tone, vec3(0.155, 0.090, 0.055), smoothstep(0.50, 0.85, g.wide.a) * 0.4);
    float layer = g.elevation + 9.0 * (g.wide.r - 0.5) + 1.5 * (g.mid.a - 0.5);
    float bands = sin(layer * 0.9) * 0.6 + sin(layer * 2.3 + 1.7) * 0.4;
    tone *= 1.0 + 0.16 * bands * smoothstep(0.9, 2.0, g.steep) * (1.0 - smoothstep(0.4, 2.5, g.footprint));
    tone *= mix(0.70, 1.20, g.near.r) * mix(0.75, 1.2, g.fine.r);
    tone *= mix(0.50, 1.15, smoothstep(0.25, 0.62, g.mid.r));
    return material(tone, -1.0, 0.55); // billows turned over: cracks stand out as ridges
}

material grass(ground g, float high) {
    vec3 lush = mix(vec3(0.052, 0.074, 0.021), vec3(0.100, 0.118, 0.040), g.mid.a);
    vec3 dry = mix(vec3(0.13, 0.115, 0.055), vec3(0.20, 0.170, 0.090), g.mid.a);
    float parched = clamp(smoothstep(0.45, 0.75, g.wide.a + 0.35 * (g.open - 0.8)) * 0.75 + high, 0.0, 1.0);
    float blades = mix(0.6, 1.4, g.near.r) * mix(0.45, 1.55, smoothstep(0.2, 0.8, g.fine.r));
    return material(mix(lush, dry, parched) * blades, 0.4, 0.6);
}

material forest(ground g) {
    // Crowns: bright tops, dark gaps; seen from far they melt into one dark green.
    float crown = smoothstep(0.05, 0.80, g.mid.r);
    vec3 tone = mix(vec3(0.011, 0.022, 0.008), vec3(0.052, 0.078, 0.024), crown);
    tone *= mix(vec3(0.80, 0.92, 0.95), vec3(1.30, 1.12, 0.85), g.wide.a);
    tone *= mix(0.35, 1.55, smoothstep(0.2, 0.8, g.near.r)) * mix(0.45, 1.45, smoothstep(0.2, 0.8, g.fine.r));
    tone *= mix(vec3(0.85, 0.97, 0.95), vec3(1.22, 1.06, 0.85), smoothstep(0.3, 0.7, g.mid.a)); // trees differ
    return material(tone, 0.9, 0.7);
}

material sea_bed(ground g) {
    float depth = -g.elevation;
    vec3 sand = mix(vec3(0.62, 0.56, 0.42), vec3(0.72, 0.67, 0.54), g.mid.a);
    material m = material(sand * (0.94 + 0.12 * g.near.a) * (0.70 + 0.60 * g.fine.r), 0.12, 0.3);
    material reef = material(mix(vec3(0.075, 0.070, 0.040), vec3(0.25, 0.20, 0.12), g.mid.r), -0.5, 0.5);
    material weed = material(mix(vec3(0.045, 0.065, 0.026), vec3(0.10, 0.115, 0.05), g.near.r), 0.4, 0.6);
    float patches = g.wide.a * 0.65 + g.mid.a * 0.35;
    m = blend(m, weed, smoothstep(0.60, 0.68, patches) * smoothstep(0.8, 2.5, depth) * 0.85);
    float rough = g.steep + 0.5 * (g.mid.r - 0.5) + 0.25 * (g.wide.r - 0.5);
    m = blend(m, reef, smoothstep(0.16, 0.34, rough));
    float deep = smoothstep(10.0, 30.0, depth);
    m.albedo *= mix(1.0, 0.6, deep);
    return m;
}

material land(ground g) {
    float height = g.elevation + 120.0 * (g.wide.a - 0.5);
    float alpine = smoothstep(1900.0, 2700.0, height);
    material m = grass(g, 0.9 * smoothstep(900.0, 2000.0, height));
    // Trees fill the valleys and the wet slopes, and leave the ridges and dry flats.
    float trees = 0.40 + 1.5 * (1.0 - g.open) + 1.4 * (g.wide.a - 0.42) + 0.2 * (g.mid.a - 0.5) +
                  0.25 * smoothstep(0.15, 0.5, g.steep);
    trees *= smoothstep(2.8, 6.0, g.elevation + 2.0 * (g.mid.a - 0.5)) * (1.0 - smoothstep(1300.0, 2000.0, height));
    m = blend(m, forest(g), smoothstep(0.25, 0.45, trees));
    float surf = 1.0 - smoothstep(4.0, 26.0, g.elevation + 14.0 * (g.mid.a - 0.5)); // where spray keeps the rock bare
    float bare = g.steep + 0.55 * (g.mid.r - 0.5) + 0.5 * (g.wide.a - 0.5);
    float threshold = mix(mix(1.25, 0.38, surf), 0.35, alpine);
    m = blend(m, rock(g), max(smoothstep(threshold, threshold + 0.35, bare), 0.85 * alpine));
    float ragged = 1.6 * (g.mid.a - 0.5) + 1.5 * (g.wide.a - 0.5) + 1.1 * (g.near.r - 0.5) + 0.5 * (g.fine.r - 0.5);
    float beach = 1.0 - smoothstep(2.75, 3.2, g.elevation + ragged);
    m = blend(m, sand(g), beach * (1.0 - smoothstep(0.22, 0.34, g.steep + 0.15 * (g.mid.r - 0.5))));
    float dark = (1.0 - smoothstep(0.4, 1.6, g.elevation + 1.2 * (g.mid.a - 0.5))) * smoothstep(0.22, 0.36, g.steep);
    m.albedo *= 1.0 - 0.45 * dark;
    float high = smoothstep(3900.0, 4100.0, g.elevation + 160.0 * (g.wide.a - 0.5));
    float snow = high * (1.0 - smoothstep(0.7, 1.1, g.steep));
    return blend(m, material(vec3(0.82, 0.84, 0.87), 0.1, 0.3), snow);
}

// Oren & Nayar 1994 in Fujii's form: rough ground does not darken towards its edges as Lambert's does.
float oren_nayar(vec3 n, vec3 l, vec3 v, float sigma) {
    float nl = dot(n, l), nv = max(dot(n, v), 0.02);
    if (nl <= 0.0) return 0.0;
    float s = dot(l, v) - nl * nv, t = s > 0.0 ? max(nl, nv) : 1.0;
    float a = 1.0 / (1.0 + (0.5 - 2.0 / (3.0 * PI)) * sigma);
    return nl * a * (1.0 + sigma * s / t);
}

ground look(vec2 p, float level) {
    vec4 map = textureLod(chunk_map, place.xy, level);
    ground g;
    g.normal = vec3(map.xy, sqrt(max(1.0 - dot(map.xy, map.xy), 0.02)));
    g.steep = length(g.normal.xy) / g.normal.z;
    g.elevation = place.z;
    g.clearance = map.z;
    g.open = map.w;
    g.footprint = exp2(level) * chunk.w / 128.0;
    g.wide = noise(p, 1024.0, g.footprint);
    // Standing rock: the grain lies in its face, not in the plan.
    vec2 plan = p.yx + 31.0, face = vec2(abs(g.normal.x) > abs(g.normal.y) ? p.y : p.x, g.elevation);
    g.mid = noise(g.steep > 1.25 ? face : plan, 64.0, g.footprint);
#ifdef NEAR
    g.near = noise(p, 16.0, g.footprint);
    g.fine = noise(p.yx, 2.0, g.footprint);
#else
    g.near = g.fine = vec4(0.5); // no texel of this chunk resolves them
#endif
    return g;
}

// Ripples of the sand, only where the pixel resolves them: those of the wind on a beach, and the longer ones that the
// waves leave on the bed. Fine dark grains gather in their troughs.
const vec2 RIPPLE_WAY = vec2(0.8, 0.6);
vec2 ripples(ground g, vec2 p, inout material m) {
#ifdef NEAR
    float gentle = 1.0 - smoothstep(0.1, 0.2, g.steep), depth = -g.elevation;
    float wander = dot(p, RIPPLE_WAY) * 7.0 + 2.2 * g.near.a + 3.0 * g.mid.a;
    float dry = (1.0 - smoothstep(0.02, 0.06, g.footprint)) * smoothstep(0.4, 0.9, g.elevation) *
                smoothstep(0.35, 0.6, g.mid.r);
    float wet = (1.0 - smoothstep(0.03, 0.10, g.footprint)) * smoothstep(0.6, 1.6, depth) *
                (1.0 - smoothstep(10.0, 18.0, depth)) * smoothstep(0.3, 0.5, g.mid.r + 0.4 * (g.near.a - 0.5));
    float phase = 2.0 * PI * wander, slow = 0.8 * phase + 4.0 * (g.near.r - 0.5) + 5.0 * (g.fine.a - 0.5);
    wet *= gentle * step(0.05, m.albedo.r - 0.25); // not on coral and weed
    m.albedo *= 1.0 + wet * (0.15 * sin(slow) + 0.05 * sin(2.0 * slow));
    return RIPPLE_WAY * (0.10 * gentle * dry * cos(phase) + wet * (0.45 * cos(slow) + 0.20 * cos(2.0 * slow)));
#else
    return vec2(0.0);
#endif
}

void main() {
#ifdef PICTURE
    if (clip_side * (place.z - clip_elevation) < 0.0) discard;
#endif
    float level = footprint_level(place.xy);
    vec2 p = eye_wrapped + position.xy;
    ground g = look(p, level);
    material m;
    if (g.elevation < -0.5) m = sea_bed(g);
    else if (g.elevation > 0.3) m = land(g);
    else m = blend(sea_bed(g), land(g), smoothstep(-0.5, 0.3, g.elevation));

    // The gradients of the billows as bumps; the mip levels of the noise fade them with distance.
    vec2 grain = (g.mid.gb - 0.5).yx * 2.2 + (g.near.gb - 0.5) * 1.8 + (g.fine.gb - 0.5).yx * 1.4;
    vec3 n = normalize(vec3(g.normal.xy - m.bump * grain - ripples(g, p, m), g.normal.z));
    vec3 view = -normalize(position);

    float lit = (1.0 - smoothstep(0.0, shadow_softness, g.clearance)) * cloud_shadow(position.xy);
#ifdef CASTERS
    lit *= object_shadow_below(vec3(position.xy, g.elevation - eye_height), g.elevation);
#endif
    vec3 sunlight = sun_light * lit * oren_nayar(n, sun_direction, view, m.rough);
#ifdef PICTURE
    sunlight *= gathered_light(position.xy, -g.elevation);
#else
    sunlight *= gathered_on_bed(position.xy, -g.elevation, g.footprint);
#endif
    float up = 0.5 + 0.5 * n.z;
    vec3 around = (sun_light * max(sun_direction.z, 0.0) * 0.6 + sky_light) * vec3(0.13, 0.14, 0.08);
    vec3 ambient = g.open * (sky_light * up + around * (1.0 - up + 0.25 * (1.0 - g.open)));
    vec3 radiance = m.albedo / PI * (sunlight + ambient);
#ifndef PICTURE
    if (g.elevation < 0.0) { // what the surface reflects down again is even
        vec3 left = exp(water_attenuation * g.elevation);
        vec3 again = vec3(bed_again(m.albedo.r, left.r), bed_again(m.albedo.g, left.g), bed_again(m.albedo.b, left.b));
        radiance += m.albedo / PI * again * (lit * max(sun_direction.z, 0.0) * sun_light + ambient);
    }
#endif
    if (g.elevation > 0.0) radiance = radiance * transmittance + inscatter;
#ifdef PICTURE
    vec3 through, veil;
    through_water(vec3(position.xy, g.elevation - eye_height), g.elevation, through, veil);
    radiance = radiance * through + veil;
#endif
    color = vec4(radiance, 1.0);
}
#endif

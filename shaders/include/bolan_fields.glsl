// SPDX-License-Identifier: MIT
// The fields of a sea in a program of yours: displacement, slope, normal, Jacobian and foam at a point. GLSL 330 core
// and 300 es, either stage. Put this text after your #version line, or let your own #include find it.
//
// Call bolan_renderer_link_fields() once after your program has been linked, and bolan_renderer_bind_fields() in each
// frame before you draw: together they set everything that is declared here. The file declares 4 samplers and one
// uniform block, and every name in it begins with bolan_.
//
// Positions are level, in metres east and north of the point that you gave to bolan_renderer_bind_fields(), usually
// your eye: a float resolves them to 1 mm within 8 km.
//
// A parcel of water that is at rest at x0 is found at x0 + displacement.xy, displacement.z above the mean water.
// - bolan_fields_at_rest(): the parcel that is at rest at a point. Twin of bolan_sea_sample_rest(). It displaces a mesh
//   of rest points.
// - bolan_fields_at(): the surface above a fixed point. Twin of bolan_query_surface(); decals, foam on a hull, spray.
// - bolan_fields_on_grid(): like bolan_fields_at_rest(), low-passed for a mesh of that spacing.
//
// Heights and displacements are cubic splines over 16 texels, so their slopes and Jacobians are exact; on a coarse mesh
// levels of the textures take their place.
//
// `depth` is the depth of the still water under the rest point [m], by which shallow water attenuates the waves as
// bolan_coast_attenuations() does; BOLAN_DEEP where there is no ground.
#ifndef BOLAN_FIELDS_GLSL
#define BOLAN_FIELDS_GLSL
#ifdef GL_ES
precision highp float;
precision highp int;
#endif

const float BOLAN_DEEP = 1e6; // [m]

// The sea at a point.
struct bolan_fields {
    vec3 displacement; // of the parcel from its rest point: east, north, up from the mean water [m]
    vec2 slope;        // dz/dx, dz/dy of the displaced surface
    vec3 normal;       // unit, up
    float jacobian;    // of the horizontal map; below 0 the surface is folded
    float foam;        // foam memory, >= 0
};

layout(std140) uniform bolan_sea_block {
    vec4 bolan_cascade_tile[4];  // xy: the origin in the tile [tiles], zw: cos, sin of its angle over its side [1/m]
    vec4 bolan_cascade_band[4];  // x: significant height, y: texel (of a sum: unit of the spacing), z: longest wave [m]
    vec4 bolan_cascade_bound[4]; // bolan_bound_weights: height, drift, height_long, drift_long [1/m]
    vec4 bolan_cascade_lift[13]; // by log2 of the mesh's spacing in texels plus 2 [m]; a sum has the first
    vec4 bolan_layer_wave[8];   // of a wave train: k east, north [rad/m], half height [m], phase at the origin [rad]
    vec4 bolan_layer_area[8];   // xy: its middle [m], zw: unit direction of travel
    vec4 bolan_layer_extent[8]; // xy: 1 / half extent along, across [1/m], z: share of the edge, w: coast height [m]
    vec4 bolan_warp_wave[6];    // of the warped plane: k east, north [turns/m], phase here, amplitude / |k| [m2]
    int bolan_cascade_count;
    int bolan_wave_count;       // of a sum
    float bolan_wave_sharpness; // of exp(s cos); 0: cosines
    float bolan_wave_mean;      // of that shape
    float bolan_wave_height;    // significant height of a sum [m]
    float bolan_choppiness;
    float bolan_foam_threshold; // the surface foams where the Jacobian is below it
    float bolan_water_level;    // of the mean water, above the origin [m]
    int bolan_layer_count;
    int bolan_warp_count;
    vec2 bolan_warp_at_origin;  // what the warp adds to the origin [m]
};
uniform highp sampler2DArray bolan_displacement_map; // dx, dy, height, dxy
uniform highp sampler2DArray bolan_slope_map;        // slope x, slope y, dxx, dyy
uniform highp sampler2DArray bolan_foam_map;         // foam memory
uniform highp sampler2D bolan_wave_map;              // of a sum, two texels a wave: kx, ky, phase, amplitude; drift

// The fields before the horizontal displacement is applied to them.
struct bolan_raw {
    vec3 offset;  // dx, dy, height
    vec2 slope;   // by the rest point
    vec4 stretch; // dDx/dx, dDx/dy, dDy/dx, dDy/dy
    float foam;
};

float bolan_tanh(float x) {
    float e = exp(-2.0 * min(abs(x), 10.0));
    return sign(x) * (1.0 - e) / (1.0 + e);
}

// Twins of bolan_coast_attenuation() and bolan_coast_attenuations().
float bolan_attenuation(float depth, float height) {
    if (depth <= 0.0) return 0.0;
    return height > 0.0 ? bolan_tanh(min(0.6 * depth / height, 10.0)) : 1.0;
}

vec4 bolan_attenuations(float depth) {
    vec4 height = vec4(bolan_cascade_band[0].x, bolan_cascade_band[1].x, bolan_cascade_band[2].x,
                       bolan_cascade_band[3].x);
    vec4 alone = vec4(bolan_attenuation(depth, height.x), bolan_attenuation(depth, height.y),
                      bolan_attenuation(depth, height.z), bolan_attenuation(depth, height.w));
    vec4 left = alone * height;
    float deep = dot(height, height), local = dot(left, left), whole = bolan_attenuation(depth, sqrt(deep));
    return local > 0.0 ? alone * sqrt(whole * whole * deep / local) : alone;
}

float bolan_lift(int cascade, float spacing) {
    float at = clamp(log2(max(spacing, 1e-6) / bolan_cascade_band[cascade].y) + 2.0, 0.0, 12.0);
    int i = int(min(at, 11.0));
    return mix(bolan_cascade_lift[i][cascade], bolan_cascade_lift[i + 1][cascade], at - float(i));
}

// The place of the warped plane that is read for a rest point, and its gradient: xx, xy, yx, yy.
vec2 bolan_place_of(vec2 rest, out vec4 gradient) {
    vec2 place = rest - bolan_warp_at_origin;
    gradient = vec4(1.0, 0.0, 0.0, 1.0);
    for (int i = 0; i < bolan_warp_count; ++i) {
        vec4 wave = bolan_warp_wave[i];
        float x = 2.0 * fract(dot(wave.xy, rest) + wave.z) - 1.0; // two parabolas
        vec2 across = vec2(-wave.y, wave.x) * wave.w;
        place += across * (4.0 * x * (1.0 - abs(x)));
        gradient += 8.0 * (1.0 - 2.0 * abs(x)) * across.xxyy * wave.xyxy;
    }
    return place;
}

// dx, dy, height at full resolution by a cubic spline, and their derivatives by the tile's coordinates.
void bolan_spline(int c, vec2 uv, out vec3 value, out vec3 along, out vec3 across) {
    int n = textureSize(bolan_displacement_map, 0).x;
    vec2 at = uv * float(n) - 0.5, t = fract(at), r = 1.0 - t;
    ivec2 first = ivec2(at - t) - 1;
    vec4 u = vec4(r.x * r.x * r.x / 6.0, t.x * t.x * (0.5 * t.x - 1.0) + 2.0 / 3.0, 0.0, t.x * t.x * t.x / 6.0);
    vec4 v = vec4(r.y * r.y * r.y / 6.0, t.y * t.y * (0.5 * t.y - 1.0) + 2.0 / 3.0, 0.0, t.y * t.y * t.y / 6.0);
    vec4 du = vec4(-0.5 * r.x * r.x, t.x * (1.5 * t.x - 2.0), 0.0, 0.5 * t.x * t.x) * float(n);
    vec4 dv = vec4(-0.5 * r.y * r.y, t.y * (1.5 * t.y - 2.0), 0.0, 0.5 * t.y * t.y) * float(n);
    u.z = 1.0 - u.x - u.y - u.w, v.z = 1.0 - v.x - v.y - v.w;
    du.z = -du.x - du.y - du.w, dv.z = -dv.x - dv.y - dv.w;
    value = along = across = vec3(0.0);
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i) {
            vec3 texel = texelFetch(bolan_displacement_map, ivec3((first + ivec2(i, j)) & (n - 1), c), 0).xyz;
            value += u[i] * v[j] * texel;
            along += du[i] * v[j] * texel;
            across += u[i] * dv[j] * texel;
        }
}

// Bound waves of second order, 0 in a sea of order 1: twin of add_bound() in src/waves/cascades/sample.c.
struct bolan_bound {
    vec3 sum; // height and slope of the place
    vec3 longer, longer_by_x, longer_by_y; // weighted sums over the longer cascades: dx, dy, height
};

void bolan_add_bound(int c, vec3 d, vec3 by_x, vec3 by_y, inout bolan_bound b) {
    vec4 w = bolan_cascade_bound[c];
    vec3 own = w.yyx * d, all = own + b.longer;
    b.sum += vec3(dot(d, all), dot(by_x, all + own) + dot(d, b.longer_by_x), dot(by_y, all + own) +
                  dot(d, b.longer_by_y));
    b.longer += w.wwz * d;
    b.longer_by_x += w.wwz * by_x;
    b.longer_by_y += w.wwz * by_y;
}

void bolan_add_cascades(vec2 rest, float depth, float spacing, inout bolan_raw sum) {
    vec4 kept = bolan_attenuations(depth), gradient;
    vec2 place = bolan_place_of(rest, gradient);
    vec3 by_x = vec3(0.0), by_y = vec3(0.0); // derivatives of dx, dy, height by the place
    bolan_bound bound = bolan_bound(vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0));
    for (int c = 0; c < bolan_cascade_count; ++c) {
        vec4 tile = bolan_cascade_tile[c], band = bolan_cascade_band[c];
        if (spacing > band.z) break; // the longest waves come first
        vec2 uv = tile.xy + vec2(place.x * tile.z + place.y * tile.w, place.y * tile.z - place.x * tile.w);
        // triangles blur by half a level
        float lod = max(log2(max(spacing, 1e-6) / band.y) - 0.5, 0.0), keep = kept[c], coarse = min(lod, 1.0);
        vec3 d = vec3(0.0), dx = vec3(0.0), dy = vec3(0.0);
        if (lod < 1.0) {
            vec3 along, across;
            bolan_spline(c, uv, d, along, across);
            d *= 1.0 - coarse;
            dx = (1.0 - coarse) * (along * tile.z - across * tile.w);
            dy = (1.0 - coarse) * (along * tile.w + across * tile.z);
        }
        if (lod > 0.0) {
            vec4 e = textureLod(bolan_displacement_map, vec3(uv, float(c)), max(lod, 1.0));
            vec4 s = textureLod(bolan_slope_map, vec3(uv, float(c)), max(lod, 1.0));
            d += coarse * e.xyz;
            dx += coarse * vec3(s.z, e.w, s.x);
            dy += coarse * vec3(e.w, s.w, s.y);
        }
        sum.offset += keep * vec3(bolan_choppiness * d.xy, d.z + keep * bolan_lift(c, spacing));
        by_x += keep * dx;
        by_y += keep * dy;
        bolan_add_bound(c, keep * d, keep * dx, keep * dy, bound);
        sum.foam += textureLod(bolan_foam_map, vec3(uv, float(c)), lod).x;
    }
    sum.offset.z += bound.sum.x;
    by_x.z += bound.sum.y;
    by_y.z += bound.sum.z;
    vec3 x = by_x * gradient.x + by_y * gradient.z, y = by_x * gradient.y + by_y * gradient.w;
    sum.slope += vec2(x.z, y.z);
    sum.stretch += bolan_choppiness * vec4(x.x, y.x, x.y, y.y);
}

void bolan_add_waves(vec2 rest, float depth, float spacing, inout bolan_raw sum) {
    float keep = bolan_attenuation(depth, bolan_wave_height);
    vec4 stretch = vec4(0.0);
    for (int i = 0; i < bolan_wave_count; ++i) {
        vec4 wave = texelFetch(bolan_wave_map, ivec2(2 * (i & 31), i >> 5), 0);
        float drift = texelFetch(bolan_wave_map, ivec2(2 * (i & 31) + 1, i >> 5), 0).x;
        float turns_per_metre = max(length(wave.xy), 1e-9), turns = dot(wave.xy, rest) + wave.z;
        float fade = keep * smoothstep(2.0, 4.0, 1.0 / (turns_per_metre * max(spacing, 1e-6))); // by spacings in a wave
        float angle = 6.28318531 * (turns - floor(turns + 0.5)), c = cos(angle), s = sin(angle);
        vec2 k = 6.28318531 * wave.xy, to = wave.xy / turns_per_metre;
        if (bolan_wave_sharpness > 0.0) {
            float shape = exp(bolan_wave_sharpness * (c - 1.0));
            sum.offset.z += fade * wave.w * (shape - bolan_wave_mean);
            sum.slope -= fade * wave.w * bolan_wave_sharpness * s * shape * k;
        } else {
            sum.offset.z += fade * wave.w * c;
            sum.slope -= fade * wave.w * s * k;
            sum.offset.xy -= fade * bolan_choppiness * drift * s * to;
            stretch -= fade * bolan_choppiness * drift * c * k.xyxy * to.xxyy;
        }
    }
    if (bolan_wave_count > 0) sum.offset.z += keep * keep * bolan_lift(0, spacing);
    sum.stretch += stretch;
    sum.foam += max(-(stretch.x + stretch.w), 0.0);
}

// 1 in the middle, 0 from u = +-1 on; y: its derivative.
vec2 bolan_edge(float u, float edge) {
    float t = clamp((1.0 - abs(u)) / edge, 0.0, 1.0);
    return vec2(t * t * (3.0 - 2.0 * t), (u < 0.0 ? 6.0 : -6.0) * t * (1.0 - t) / edge);
}

// Wave trains: they move parcels up and down only.
void bolan_add_layers(vec2 rest, float depth, float spacing, inout bolan_raw sum) {
    for (int i = 0; i < bolan_layer_count; ++i) {
        vec4 wave = bolan_layer_wave[i], area = bolan_layer_area[i], extent = bolan_layer_extent[i];
        vec2 p = rest - area.xy, to = area.zw, aside = vec2(-to.y, to.x);
        vec2 along = bolan_edge(dot(p, to) * extent.x, extent.z);
        vec2 across = bolan_edge(dot(p, aside) * extent.y, extent.z);
        float samples = 6.28318531 / (max(length(wave.xy), 1e-9) * max(spacing, 1e-6)); // of a wave
        float amplitude = wave.z * bolan_attenuation(depth, extent.w) * clamp(0.5 * samples - 1.0, 0.0, 1.0);
        float phase = dot(wave.xy, rest) + wave.w, share = along.x * across.x;
        vec2 envelope = along.y * across.x * extent.x * to + across.y * along.x * extent.y * aside;
        sum.offset.z += amplitude * share * cos(phase);
        sum.slope += amplitude * (envelope * cos(phase) - share * sin(phase) * wave.xy);
    }
}

bolan_raw bolan_raw_at(vec2 rest, float depth, float spacing) {
    bolan_raw sum = bolan_raw(vec3(0.0), vec2(0.0), vec4(0.0), 0.0);
    bolan_add_cascades(rest, depth, spacing, sum);
    bolan_add_waves(rest, depth, spacing, sum);
    bolan_add_layers(rest, depth, spacing, sum);
    return sum;
}

// Where the surface folds it is vertical: the slope is that of a Jacobian of 0.1.
bolan_fields bolan_displaced(bolan_raw raw) {
    vec4 m = raw.stretch + vec4(1.0, 0.0, 0.0, 1.0);
    float jacobian = m.x * m.w - m.y * m.z;
    float divisor = (jacobian < 0.0 ? -1.0 : 1.0) * max(abs(jacobian), 0.1);
    vec2 slope = vec2(raw.slope.x * m.w - raw.slope.y * m.z, raw.slope.y * m.x - raw.slope.x * m.y) / divisor;
    return bolan_fields(raw.offset, slope, normalize(vec3(-slope, 1.0)), jacobian, raw.foam);
}

bolan_fields bolan_fields_on_grid(vec2 rest, float depth, float spacing) {
    return bolan_displaced(bolan_raw_at(rest, depth, spacing));
}

bolan_fields bolan_fields_at_rest(vec2 rest, float depth) { return bolan_fields_on_grid(rest, depth, 0.0); }

// The surface above a point: Newton's method finds the parcel that stands there. Where the surface folds over itself it
// finds one of the parcels, not always the highest.
bolan_fields bolan_fields_at(vec2 place, float depth) {
    vec2 rest = place;
    bolan_raw raw = bolan_raw_at(rest, depth, 0.0);
    for (int i = 0; i < 5; ++i) {
        vec4 m = raw.stretch + vec4(1.0, 0.0, 0.0, 1.0);
        vec2 residual = rest + raw.offset.xy - place;
        float det = m.x * m.w - m.y * m.z;
        vec2 step = vec2(m.w * residual.x - m.y * residual.y, m.x * residual.y - m.z * residual.x) / det;
        rest -= abs(det) > 0.1 ? step : residual;
        raw = bolan_raw_at(rest, depth, 0.0);
    }
    return bolan_displaced(raw);
}

// Height of the surface above the origin that you gave [m].
float bolan_height_at(vec2 place, float depth) {
    return bolan_water_level + bolan_fields_at(place, depth).displacement.z;
}
#endif

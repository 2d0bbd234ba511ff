// SPDX-License-Identifier: MIT
// Motion vectors of an image by its depth: of land and sky by the camera alone; with WATER, of the cascades' water by
// its parcels. Objects come after: surfaces.glsl.
#include "common/fullscreen.glsl"
#ifdef VERTEX
void main() { fullscreen(0.5); }
#endif
#ifdef FRAGMENT
#include "common/frame.glsl"
#include "common/motion.glsl"
#pragma unit scene_depth 4
#pragma unit mask 17
uniform sampler2D scene_depth; // of what stood there before the water
uniform sampler2D mask;        // no water where its red is above a half
uniform vec4 wanted;           // x: 1 there is scene_depth, y: 1 the water alone, z: 1 there is a mask
uniform vec2 mask_origin;      // lower left corner of the rectangle in it [px]
out vec4 color;

#ifdef WATER
#include "common/waves.glsl"
#pragma unit displacement_before 16
uniform sampler2DArray displacement_before; // as displacement_map, of the step before
uniform vec2 drift;                         // of the water between the two [m]

const int SEARCHES = 3; // of the rest point: what is left of its error is (slope of the displacement)^3 of it

// The displacement at a rest point on a mesh of that spacing, fetched linearly: only differences are taken of it.
vec3 displacement_of(sampler2DArray map, vec2 rest, float spacing, vec4 kept) {
    vec3 offset = vec3(0.0), longer = vec3(0.0);
    vec2 at = place_of(rest).at;
    for (int c = 0; c < cascade_count; ++c) {
        vec4 band = cascade_band[c];
        if (spacing > band.z) break;
        float lod = max(log2(spacing) - band.w - 0.5, 0.0);
        vec2 uv = cascade_uv(c, at);
        vec3 s = lod < 0.5 ? spline_of(map, c, uv) : textureLod(map, vec3(uv, float(c)), lod).xyz;
        offset += kept[c] * vec3(choppiness * s.xy, s.z);
#ifdef BOUND_WAVES
        offset.z += bound_height(c, kept[c] * s, longer);
#endif
    }
    return offset;
}

// Where the parcel of water at an eye-relative position was in the step before, less where it is [m].
vec3 parcel_travel(vec3 position) {
    float spacing = max(length(position) * radians_per_pixel, 1e-4);
    vec4 kept = vec4(1.0);
#ifdef LAND
    kept = cascades_kept(-shore_elevation(position.xy));
#endif
    vec3 now = vec3(0.0);
    for (int i = 0; i < SEARCHES; ++i) now = displacement_of(displacement_map, position.xy - now.xy, spacing, kept);
    vec2 rest = position.xy - now.xy;
    return displacement_of(displacement_before, rest, spacing, kept) -
           displacement_of(displacement_map, rest, spacing, kept) - vec3(drift, 0.0);
}
#endif

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy - origin);
    float depth = texelFetch(frame_depth, at, 0).r;
    bool is_water = depth > 0.0 && (wanted.x < 0.5 || depth > texelFetch(scene_depth, at, 0).r);
    if (wanted.y > 0.5) {
        if (!is_water) discard;
        if (wanted.z > 0.5 && texelFetch(mask, at + ivec2(mask_origin), 0).r > 0.5) discard;
    }
    // the ray ends at the near plane, of depth 1: a point over its w, and at the sky a direction
    vec4 now = vec4(frame_ray((vec2(at) + 0.5) * pixel_size), depth), before = now;
#ifdef WATER
    if (is_water) before.xyz += depth * parcel_travel(now.xyz / depth);
#endif
    color = vec4(motion_of(now, before), is_water ? 1.0 : 0.0, 1.0); // blue: for temporal.glsl
}
#endif

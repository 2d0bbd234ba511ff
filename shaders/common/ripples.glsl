// SPDX-License-Identifier: MIT
// Waves shorter than those of a sum, from a tile (src/render/ripple_texture.c). The slope variance that a texture
// fetch removes is kept (Olano & Baker 2010: the tile holds the square of the slope too). RIPPLES: how often the tile
// is laid, 1 or 2; set by quality.
#ifndef WAVES_CASCADES
#pragma unit ripple_map 18
uniform sampler2D ripple_map;
#ifndef RIPPLES // serves an offline compiler
#define RIPPLES 2
#endif
#endif

// Adds the resolved ripples to a slope, and subtracts their variance from the covariance.
void add_ripples(vec2 rest, footprint f, float gust, float depth, inout vec2 slope, inout vec3 covariance) {
#ifndef WAVES_CASCADES
    float width = 0.5 * log2(f.minor * f.major) + 10.0, seen = 0.0; // in texels of a tile of 1 m
    vec2 sum = vec2(0.0);
    // the second layer is gone where a pixel is half as wide as its longest waves
    for (int i = 0; i < RIPPLES && (i == 0 || width - ripple_size[i].z < 4.5); ++i) {
        vec2 u = ripple_tile[i].zw;
        vec2 at = ripple_tile[i].xy + vec2(dot(rest, u), dot(rest, vec2(-u.y, u.x))) * ripple_size[i].x;
        float detail = width - ripple_size[i].z, share = i == 0 ? 1.0 : clamp(4.5 - detail, 0.0, 1.0);
        vec4 t = textureLod(ripple_map, at, max(detail, 0.0));
        t.xyz *= vec3(share, share, share * share);
        sum += ripple_size[i].w * (t.x * u + t.y * vec2(-u.y, u.x));
        seen += ripple_size[i].y * min(share * share - t.z + dot(t.xy, t.xy), 1.0);
    }
    float keep = gust;
#ifdef LAND
    keep *= clamp(2.0 * depth, 0.0, 1.0);
#endif
    slope += keep * sum;
    covariance -= vec3(0.5, 0.0, 0.5) * (keep * keep * seen);
    covariance.xz = max(covariance.xz, vec2(1e-4) + abs(covariance.yy));
#endif
}

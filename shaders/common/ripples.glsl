// SPDX-License-Identifier: MIT
// Waves shorter than those of a sum, from a tile (src/render/ripple_texture.c). What a look-up averages away stays as variance
// (Olano & Baker 2010: the tile holds the square of the slope too).
#ifndef WAVES_CASCADES
#pragma unit ripple_map 18
uniform sampler2D ripple_map;
uniform vec4 ripple_tile[2]; // where the eye stands in it, unit vector of its u axis
uniform vec4 ripple_size[2]; // x: its side [m], y: its slope variance
#endif

// Adds the ripples to a slope, and takes from the covariance what is seen of them.
void add_ripples(vec2 rest, footprint f, float gust, float depth, inout vec2 slope, inout vec3 covariance) {
#ifndef WAVES_CASCADES
    float width = sqrt(f.minor * f.major), seen = 0.0;
    vec2 sum = vec2(0.0);
    for (int i = 0; i < 2; ++i) {
        vec2 u = ripple_tile[i].zw;
        float turns = 1.0 / ripple_size[i].x;
        vec2 at = ripple_tile[i].xy + vec2(dot(rest, u), dot(rest, vec2(-u.y, u.x))) * turns;
        vec4 t = textureLod(ripple_map, at, max(log2(width * turns * 512.0), 0.0));
        sum += sqrt(ripple_size[i].y) * (t.x * u + t.y * vec2(-u.y, u.x));
        seen += ripple_size[i].y * min(1.0 - t.z + dot(t.xy, t.xy), 1.0);
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

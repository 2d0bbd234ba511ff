// SPDX-License-Identifier: MIT
// Fast rough water for the papers' optics: the quantities of common/slopes.glsl and common/reflection.glsl by square
// roots in place of distribution functions (facing_fast() of shared/microfacets.glsl).
// tests/shaders/test_water_rough.c has the errors.
#include "shared/fresnel.glsl"
#include "shared/microfacets.glsl"

struct rough_facets {
    float area;  // plan-projected area that a unit of plan area shows
    float shift; // mean extra slope towards the observer
    float sigma; // rms slope of the visible facets along the view
};

// Variance of the slope along a horizontal direction of length 1; c: slope covariance (xx, xy, yy).
float rough_variance(vec2 h, vec3 c) { return max(c.x * h.x * h.x + 2.0 * c.y * h.x * h.y + c.z * h.y * h.y, 1e-7); }

// v: unit direction to the observer; m: mean slope.
rough_facets rough_seen(vec3 v, vec2 m, vec3 c) {
    float horizontal = max(length(v.xy), 1e-4);
    vec2 h = v.xy / horizontal;
    float sigma = sqrt(rough_variance(h, c)), z = clamp(v.z / horizontal - dot(m, h), -1.0, 1e3);
    facing_facets f = facing_fast(z / sigma);
    return rough_facets(horizontal * sigma * f.area, sigma * f.tilt, sigma * f.kept);
}

// Mean reflectance, facing `v` with mean slope m: that of a facet which leans by 0.6 of the mean shift gives the curve
// of Bruneton, Neyret & Holzschuch 2010, eq. 17, where it is measured (85 degrees), and the exact dielectric for a
// mirror.
float rough_fresnel(vec3 v, vec2 m, rough_facets seen, float index) {
    vec2 lean = m - v.xy * (0.6 * seen.shift / max(length(v.xy), 1e-4));
    vec3 n = vec3(-lean, 1.0);
    return fresnel(clamp(dot(v, n) * inversesqrt(dot(n, n)), 0.01, 1.0), index);
}

// Radiance of the reflected sun for an irradiance of 1 across its rays. middle: unit bisector of the directions to the
// observer and to the sun; reflectance of a facet across it; lit: see glint_radiance().
float rough_glint_at(vec3 middle, float reflectance, vec2 m, vec3 c, float area, float lit) {
    float up = max(middle.z, 0.02);
    vec2 off = -middle.xy / up - m;
    return glint_radiance(slope_density(off.x, off.y, c.x, c.y, c.z), reflectance, up, area, lit);
}

// Like above, with the exact dielectric. A low sun lights less of the plan than it shows of facets.
float rough_glint(vec3 v, vec3 to_sun, vec2 m, vec3 c, rough_facets seen, float index) {
    vec3 middle = v + to_sun;
    middle *= inversesqrt(max(dot(middle, middle), 1e-6));
    float level = max(length(to_sun.xy), 1e-4);
    float lit = lit_fast(to_sun.z, level * sqrt(rough_variance(to_sun.xy / level, c)));
    return rough_glint_at(middle, fresnel(clamp(dot(v, middle), 0.0, 1.0), index), m, c, seen.area, lit);
}

// SPDX-License-Identifier: MIT
// Rough water for the optics that have little time: what common/slopes.glsl does with distribution functions, here by square
// roots. With u = z / sigma, the mean of max(0, u + t) over a standard normal t is u Phi(u) + phi(u), nearly
//     A(u) = (u + sqrt(u^2 + 0.64)) / 2,     whose derivative A' = A / sqrt(u^2 + 0.64) is nearly Phi(u),
// so that the mean tilt Phi / A of the facets in sight is 1 / sqrt(u^2 + 0.64). tests/shaders/test_water_rough.c has the errors.
// Needs shared/fresnel.glsl.

struct rough_facets {
    float area;  // plan-projected area that a unit of plan area shows
    float shift; // mean extra slope towards the observer
    float sigma; // rms slope of the facets in sight along the view
};

// c: slope covariance (xx, xy, yy); m: mean slope.
rough_facets rough_seen(vec3 v, vec2 m, vec3 c) {
    float horizontal = max(length(v.xy), 1e-4);
    vec2 h = v.xy / horizontal;
    float variance = max(c.x * h.x * h.x + 2.0 * c.y * h.x * h.y + c.z * h.y * h.y, 1e-7);
    float z = clamp(v.z / horizontal - dot(m, h), -1.0, 1e3), s = sqrt(z * z + 0.64 * variance);
    // turned away, a facet must lean at least as far as hides it
    float shift = variance / s + max(-z, 0.0);
    float steady = clamp(0.5 + 0.5 * z / s, 0.0, 1.0); // of the variance stays: half of it at grazing
    return rough_facets(horizontal * 0.5 * (max(z, 0.0) + s), shift, sqrt(variance * steady));
}

// Mean reflectance, facing `v` with mean slope m: that of a facet which leans by 0.6 of the mean shift gives the curve of
// Bruneton, Neyret & Holzschuch 2010, eq. 17, where it is measured (85 degrees), and the exact dielectric for a mirror.
float rough_fresnel(vec3 v, vec2 m, rough_facets seen, float index) {
    vec2 lean = m - v.xy * (0.6 * seen.shift / max(length(v.xy), 1e-4));
    vec3 n = vec3(-lean, 1.0);
    return fresnel(clamp(dot(v, n) * inversesqrt(dot(n, n)), 0.01, 1.0), index);
}

// Radiance of the mirrored sun for an irradiance of 1: the density of the slope that mirrors it (Ross, Dion & Potvin 2005).
float rough_glint(vec3 v, vec3 sun_direction, vec2 m, vec3 c, rough_facets seen, float index) {
    vec3 middle = v + sun_direction;
    middle *= inversesqrt(max(dot(middle, middle), 1e-6));
    float up = max(middle.z, 0.02), up2 = up * up;
    vec2 d = -middle.xy / up - m;
    float det = max(c.x * c.z - c.y * c.y, 1e-14);
    float q = (c.z * d.x * d.x - 2.0 * c.y * d.x * d.y + c.x * d.y * d.y) / det;
    float density = exp2(-0.72134752 * min(q, 80.0)) * 0.15915494 * inversesqrt(det);
    // a low sun lights less of the plan than it shows of facets
    float z = sun_direction.z, s = sqrt(z * z + 0.64 * max(c.x, c.z)), lit = 2.0 * max(z, 0.0) / (max(z, 0.0) + s);
    float f = fresnel(clamp(dot(v, middle), 0.0, 1.0), index);
    return min(density * f * min(lit, 1.0) / (4.0 * up2 * up2 * max(seen.area, 0.01)), 400.0);
}

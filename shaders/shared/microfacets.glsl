// SPDX-License-Identifier: MIT
// The facets of rough water that an observer sees. Slopes are Gaussian. Along the observer's horizontal direction this
// is a one-dimensional problem: with t the tilt of a facet towards the observer and u the observer's elevation (as a
// slope), both over the mean plane and in standard deviations of the slope, a facet shows the area max(0, u + t) of its
// plan. With the normal distribution P and its density p:
//
//   area   mean of max(0, u + t)            u P + p
//   tilt   mean of t over the visible area  P / (u P + p)
//   kept   standard deviation of that       sqrt(1 + p / (u P + p) - tilt^2)
#ifndef BOLAN_SHARED_MICROFACETS
#define BOLAN_SHARED_MICROFACETS
#include "shared/normal.glsl"

STRUCT(facing_facets)
struct facing_facets {
    real area; // plan area that a unit of plan area shows, over (length of the view's level part) x deviation
    real tilt; // mean extra slope towards the observer, in deviations
    real kept; // rms slope of the visible facets along the view, over that of all
};

// From u = -1 on to 1e-4 of the area and of the tilt and 0.12 % of what is kept; at -1.5 these are 3e-4, 4e-4 and 0.6
// %. An observer more than 2.5 deviations under the mean plane counts as being there. The upper bound lets a calm be
// seen from straight above.
SHARED facing_facets facing_exact(real elevation) {
    real u = clamp(elevation, -2.5, 1e7);
    real pdf = normal_pdf(u), cdf = normal_below(u, pdf), norm = max(u * cdf + pdf, 1e-4);
    facing_facets f;
    f.area = norm;
    f.tilt = cdf / norm;
    f.kept = sqrt(max((u * cdf + 2.0 * pdf) / norm - f.tilt * f.tilt, 0.05));
    return f;
}

// Fast, by square roots. For u >= 0: area at most 5.3 % too large (near u = 0.7), tilt within 8 %, kept within 9.5 %.
// Down to u = -1: area up to 0.07 too large, tilt within 8 %, kept within 15 %. Far below, a facet must lean at least
// as far as hides it, and tilt goes with -u.
SHARED facing_facets facing_fast(real u) {
    real s2 = u * u + 0.63661977, per_s = inversesqrt(s2);
    facing_facets f;
    f.area = 0.5 * (u + s2 * per_s);
    f.tilt = per_s + max(-u, 0.0);
    f.kept = sqrt(clamp(0.43 + 0.57 * u * inversesqrt(u * u + 2.4), 0.25, 1.0));
    return f;
}

// Share of the facets turned to a distant light that no other facet shadows: their area over the plan that the light
// falls on. up: height of the light's unit direction; deviation: of the slope along its level part, times the
// length of that part.
SHARED real lit_fast(real up, real deviation) {
    return clamp(up / max(deviation * facing_fast(max(up, 0.0) / deviation).area, 1e-3), 0.0, 1.0);
}

// Smith's ratio of the hidden to the visible share, along a ray whose elevation is u standard deviations of
// the slope: L(u) = phi(u) / u - Phi(-u), in the rational form of Walter et al. 2007 (within 0.005). Rays under the
// mean plane are hidden.
SHARED real smith_ratio(real u) {
    real a = 0.70710678 * max(u, 1e-4);
    return a < 1.6 ? (1.0 - 1.259 * a + 0.396 * a * a) / (3.535 * a + 2.181 * a * a) : 0.0;
}

// Waves of all lengths hide one another. The mean slope about a facet, over lengths that shrink from the longest waves
// to the facet, is a Brownian motion from the slope of the plane to the slope of the facet. Where it is steeper than a
// ray, a wave of that length hides the facet: the ray is a barrier for the motion. Elevations u and w of rays over the
// plane and `tilt`, of the facet towards the first ray, are in standard deviations of the facets' slopes.
//
// Waves differ in length by some least ratio, so that the motion has steps. These act as a barrier that lies `step`
// farther off (Broadie, Glasserman & Kou 1997). With 0 the visible area is exactly that of the plane. With many the
// plane has waves of one length, which hide all facets alike, as Smith's do.

// Share of the facets of that tilt which are hidden from a ray.
SHARED real motion_hidden(real u, real tilt, real step) {
    return exp(-2.0 * max(u + step, 0.0) * max(u + step + tilt, 0.0));
}

// Area of the facets that motion_hidden() leaves, over (length of the ray's level part x deviation); it should be u.
// area: facing_exact(u).area.
SHARED real motion_area_exact(real u, real area, real step) {
    return max(area - facing_exact(-u - 2.0 * step).area, 1e-3);
}

// u over that area, fast: within 10 % for u >= 0.1 and steps up to 0.2.
SHARED real motion_lit_fast(real u, real step) {
    real far = max(u, 0.0) + step, q = max(u, 0.0) * (1.0 + far * (0.8 + 0.9 * far));
    return q / (q + step);
}

// Share of the facets of that tilt which neither of two rays to opposite sides misses, by the first images of both
// barriers: to 0.02 where u + w + 2 step is 1.4 or more. hidden_u, hidden_w: motion_hidden() of either ray.
SHARED real motion_between_fast(real u, real w, real tilt, real step, real hidden_u, real hidden_w) {
    real l = max(u + step, 0.0) + max(w + step, 0.0);
    real images = exp(-2.0 * l * max(l + tilt, 0.0)) + exp(-2.0 * l * max(l - tilt, 0.0));
    return max(1.0 - hidden_u - hidden_w + images, 0.0);
}

// The same with the next images: to 0.01 where u + w + 2 step is 0.8 or more.
SHARED real motion_between_exact(real u, real w, real tilt, real step, real hidden_u, real hidden_w) {
    real a = max(u + step, 0.0), b = max(w + step, 0.0), al = 2.0 * a + b, bl = 2.0 * b + a;
    real images = exp(-2.0 * al * max(al + tilt, 0.0)) + exp(-2.0 * bl * max(bl - tilt, 0.0));
    return max(motion_between_fast(u, w, tilt, step, hidden_u, hidden_w) - images, 0.0);
}

// Probability density of a slope that is (x, y) off the mean; xx, xy, yy: covariance of the slopes.
SHARED real slope_density(real x, real y, real xx, real xy, real yy) {
    real det = max(xx * yy - xy * xy, 1e-14);
    real q = (yy * x * x - 2.0 * xy * x * y + xx * y * y) / det;
    return 0.15915494 * exp(-0.5 * min(q, 80.0)) * inversesqrt(det);
}

// The brightest glint [1/sr]: half floats, and the glow about the sun's image, end there.
#define MOST_GLINT 400.0

// Radiance of the reflected sun for an irradiance of 1 across its rays: density of the slope that reflects it (Cox &
// Munk 1954; Ross, Dion & Potvin 2005). reflectance: of that facet; up: height of its unit normal; area: plan area that
// a unit of plan area shows the observer; lit: share of such facets that see the sun.
SHARED real glint_radiance(real density, real reflectance, real up, real area, real lit) {
    real up2 = up * up;
    return min(density * reflectance * lit / (4.0 * up2 * up2 * max(area, 0.01)), MOST_GLINT);
}

#endif

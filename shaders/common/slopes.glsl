// SPDX-License-Identifier: MIT
// Statistics of the facets of rough water that an observer sees. Slopes are Gaussian with mean `m` and covariance
// `c` = (xx, xy, yy). A facet of slope s has the normal (-s, 1) / |..|; from direction v (to the observer) it shows the
// area max(0, v.z - s . v.xy) per unit of plan area. Along the observer's horizontal direction this is a
// one-dimensional problem in the tilt towards the observer, with closed forms.
#include "shared/microfacets.glsl"


// The facets that an observer sees, their plan-projected area being the weight.
struct visible_facets {
    float area;   // that a unit of plan area shows (>= v.z): integral of max(0, v.z - s . v.xy) p(s)
    float shift;  // mean extra slope towards the observer
    float sigma;  // rms slope of the visible facets along the view, about that mean
    float narrow; // 1 - sigma over that of all facets: 0 from above, 0.345 at grazing
    float across; // rms slope across the view of facets that share their slope along it
    vec2 toward;  // slope of a facet that leans by 1 towards the observer, on the average over its slope across
};

// Level part of a direction; from straight above any will do.
vec2 level_part(vec3 v) { return dot(v.xy, v.xy) > 1e-6 ? v.xy : vec2(1e-3, 0.0); }

// Covariance of the slope with its part along a horizontal direction of length 1; and the variance of that part.
vec2 slope_along(vec2 h, vec3 c) { return vec2(c.x * h.x + c.y * h.y, c.y * h.x + c.z * h.y); }
float slope_variance(vec2 h, vec3 c) { return dot(slope_along(h, c), h); }

visible_facets facets_seen(vec3 v, vec2 m, vec3 c) {
    vec2 h = level_part(v);
    float horizontal = length(h);
    h /= horizontal;
    vec2 along = slope_along(h, c);
    float variance = max(dot(along, h), 1e-8), sigma = sqrt(variance);
    float z = v.z - dot(m, h) * horizontal;
    facing_facets facing = facing_exact(z / (horizontal * sigma));
    visible_facets f;
    f.area = horizontal * sigma * facing.area;
    f.shift = sigma * facing.tilt;
    f.sigma = sigma * facing.kept;
    f.narrow = 1.0 - facing.kept;
    f.across = sqrt(max(c.x * c.z - c.y * c.y, 0.0)) / sigma;
    f.toward = -along / variance;
    return f;
}

// Three tilts and weights that stand for all visible facets: means of polynomials to the fifth degree are exact
// (Gauss's quadrature for the weight max(0, u + t) exp(-t^2 / 2); u is the observer's elevation in standard
// deviations). `offset`: from the mean, in units of the rms. Cubics in `narrow`, good to 0.03: they keep the weights
// positive and mean and variance exact.
void facet_nodes(visible_facets f, out vec3 offset, out vec3 weight) {
    float x = f.narrow;
    offset = vec3(-1.7320508, 0.0, 1.7320508) +
             x * (vec3(2.70599, 1.44674, 1.71310) +
                  x * (vec3(-2.89540, -0.57469, 1.35003) + x * vec3(1.18576, 0.04205, -0.53444)));
    vec3 next = offset.yzx, last = offset.zxy;
    weight = (1.0 + next * last) / ((offset - next) * (offset - last));
}

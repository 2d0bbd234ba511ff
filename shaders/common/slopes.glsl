// SPDX-License-Identifier: MIT
// Statistics of the facets of rough water that an observer sees. Slopes are Gaussian with mean `m` and covariance
// `c` = (xx, xy, yy). A facet of slope s has the normal (-s, 1) / |..|; from direction v (to the observer) it shows the area
// max(0, v.z - s . v.xy) per unit of plan area. Along the observer's horizontal direction this is a one-dimensional problem
// in the tilt towards the observer, with closed forms.
#include "shared/constants.glsl"


// Standard normal distribution function, to 2e-4 (logistic form of tanh(sqrt(2/pi) (x + 0.044715 x^3)), one
// exponential).
float normal_cdf(float x) {
    float t = clamp(x, -9.0, 9.0);
    return 1.0 / (1.0 + exp(-1.59576912 * (t + 0.044715 * t * t * t)));
}
float normal_pdf(float x) { return 0.39894228 * exp(-0.5 * x * x); }

// The same function to 1e-5, relative to the density for x < 0, where the density is known (Abramowitz & Stegun
// 26.2.16).
float normal_below(float x, float pdf) {
    float t = 1.0 / (1.0 + 0.33267 * abs(x));
    float tail = pdf * t * (0.4361836 + t * (-0.1201676 + t * 0.9372980));
    return x < 0.0 ? tail : 1.0 - tail;
}

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

// Mean of max(0, u + t) over a standard normal t: plan-projected area in units of the slope's deviation.
float mean_facing(float u) {
    u = clamp(u, -2.5, 1e4);
    float pdf = normal_pdf(u);
    return max(u * normal_below(u, pdf) + pdf, 1e-4);
}

visible_facets facets_seen(vec3 v, vec2 m, vec3 c) {
    vec2 h = level_part(v);
    float horizontal = length(h);
    h /= horizontal;
    vec2 along = slope_along(h, c);
    float variance = max(dot(along, h), 1e-8), sigma = sqrt(variance);
    float z = v.z - dot(m, h) * horizontal;
    float u = clamp(z / (horizontal * sigma), -2.5, 1e4);
    float pdf = normal_pdf(u), cdf = normal_below(u, pdf);
    float norm = max(u * cdf + pdf, 1e-4);
    float mean = cdf / norm, kept = sqrt(max((u * cdf + 2.0 * pdf) / norm - mean * mean, 0.05));
    visible_facets f;
    f.area = horizontal * sigma * norm;
    f.shift = sigma * mean;
    f.sigma = sigma * kept;
    f.narrow = 1.0 - kept;
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

// Smith's ratio of what other facets hide to what they leave, along a ray whose elevation is u standard deviations of
// the slope: L(u) = phi(u) / u - Phi(-u), in the rational form of Walter et al. 2007 (within 0.005). Rays under the
// mean plane are hidden.
float smith_ratio(float u) {
    float a = 0.70710678 * max(u, 1e-4);
    return a < 1.6 ? (1.0 - 1.259 * a + 0.396 * a * a) / (3.535 * a + 2.181 * a * a) : 0.0;
}

// Probability density of slope s.
float slope_density(vec2 s, vec2 m, vec3 c) {
    float det = max(c.x * c.z - c.y * c.y, 1e-14);
    vec2 d = s - m;
    float q = (c.z * d.x * d.x - 2.0 * c.y * d.x * d.y + c.x * d.y * d.y) / det;
    return exp(-0.5 * min(q, 80.0)) / (2.0 * PI * sqrt(det));
}

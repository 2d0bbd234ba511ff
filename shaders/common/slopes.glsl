// SPDX-License-Identifier: MIT
// Statistics of the facets of rough water that an observer sees. Slopes are Gaussian with mean `m` and covariance
// `c` = (xx, xy, yy). A facet of slope s has the normal (-s, 1) / |..|; from direction v (to the observer) it shows the area
// max(0, v.z - s . v.xy) per unit of plan area. Along the observer's horizontal direction this is a one-dimensional problem
// in the tilt towards the observer, with closed forms.

const float SLOPES_PI = 3.14159265;

// Standard normal distribution function, to 2e-4 (logistic form of tanh(sqrt(2/pi) (x + 0.044715 x^3)), one exponential).
float normal_cdf(float x) {
    float t = clamp(x, -9.0, 9.0);
    return 1.0 / (1.0 + exp(-1.59576912 * (t + 0.044715 * t * t * t)));
}
float normal_pdf(float x) { return 0.39894228 * exp(-0.5 * x * x); }

// What the visible facets look like: how much plan-projected area a unit of plan area shows (>= v.z), and the mean and the
// standard deviation of the tilt towards the observer [standard deviations of the slope].
struct visible_facets {
    float area;  // integral of max(0, v.z - s . v.xy) p(s)
    float shift; // mean extra slope towards the observer
    float sigma; // rms slope of the visible facets along the view
};

visible_facets facets_seen(vec3 v, vec2 m, vec3 c) {
    float horizontal = max(length(v.xy), 1e-4);
    vec2 h = v.xy / horizontal;
    float sigma = sqrt(max(c.x * h.x * h.x + 2.0 * c.y * h.x * h.y + c.z * h.y * h.y, 1e-8));
    float u = clamp((v.z / horizontal - dot(m, h)) / sigma, -2.5, 1e4);
    float cdf = normal_cdf(u), pdf = normal_pdf(u);
    float norm = max(u * cdf + pdf, 1e-4);
    float mean = cdf / norm;
    visible_facets f;
    f.area = horizontal * sigma * norm;
    f.shift = sigma * mean;
    f.sigma = sigma * sqrt(max((u * cdf + 2.0 * pdf) / norm - mean * mean, 0.05));
    return f;
}

// Probability density of slope s.
float slope_density(vec2 s, vec2 m, vec3 c) {
    float det = max(c.x * c.z - c.y * c.y, 1e-14);
    vec2 d = s - m;
    float q = (c.z * d.x * d.x - 2.0 * c.y * d.x * d.y + c.x * d.y * d.y) / det;
    return exp(-0.5 * min(q, 80.0)) / (2.0 * SLOPES_PI * sqrt(det));
}

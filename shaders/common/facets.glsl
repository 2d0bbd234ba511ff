// SPDX-License-Identifier: MIT
// The facets of rough water that an observer sees, in rational forms: cheaper cousins of facets_seen() in
// common/slopes.glsl and of the mean reflectance in common/reflection.glsl. With u the distance of the horizon of tilts
// from the mean, in standard deviations, the exact forms hold the normal distribution P and its density p:
//   area  u P + p          ~ (u + sqrt(u^2 + 2/pi)) / 2         exact at 0 and for large u
//   tilt  P / (u P + p)    ~ 2 / (u + sqrt(u^2 + 8/pi))         likewise
// tests/shaders/test_crest_shader.c has how far they are off.

struct facets {
    float area; // plan area that a unit of plan area shows
    float tilt; // mean extra slope towards the observer
    float rms;  // slope of the visible facets along the view
};

// Variance of the slope along a horizontal direction, of any length. c: covariance xx, xy, yy.
float facets_variance(vec3 c, vec2 direction) {
    float length2 = max(dot(direction, direction), 1e-8);
    return max((c.x * direction.x * direction.x + 2.0 * c.y * direction.x * direction.y + c.z * direction.y * direction.y) / length2, 1e-8);
}

// up, flat_length: of the direction to the observer; slope: mean along it; sigma: standard deviation.
facets facets_toward(float up, float flat_length, float slope, float sigma) {
    float u = max((up / flat_length - slope) / sigma, -1.5), u2 = u * u;
    float tilt = 2.0 / (u + sqrt(u2 + 2.5464791));
    float spread = clamp(2.0 - tilt * (u + tilt), 0.05, 1.0); // exact for the exact tilt
    return facets(flat_length * sigma * 0.5 * (u + sqrt(u2 + 0.63661977)), sigma * tilt, sigma * sqrt(spread));
}

// Mean Fresnel reflectance of facets whose mean normal is seen at cosine c, their slopes spreading by rms: Schlick's curve and its
// curvature times the variance. Half the second derivative would be 10 g^3; the facets seen are skewed towards the eye, where
// the curve is flat, and 5.5 fits the mean over them.
float facets_fresnel(float c, float rms, float index) {
    float f0 = (index - 1.0) * (index - 1.0) / ((index + 1.0) * (index + 1.0));
    float g = 1.0 - min(c, 1.0), g3 = g * g * g;
    return f0 + (1.0 - f0) * g3 * (g * g + 5.5 * rms * rms * (1.0 - c * c));
}

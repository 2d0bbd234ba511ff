// SPDX-License-Identifier: MIT
// From exposed linear radiance to display values. The curve works on each channel of a slightly desaturated mix, so that a
// bright colour runs to white the way film does, and keeps a hue that a curve per channel would twist.

// The response of film and of photoreceptors (Naka & Rushton 1966): x^n / (x^n + s^n), straight in the middle of a logarithmic
// scale, with a toe and a long shoulder. Middle grey 0.18 maps to itself.
float film_curve(float x) {
    float y = pow(max(x, 0.0), 1.3);
    return y / (y + 0.4903);
}

vec3 tonemap(vec3 c) {
    c = clamp(c, 0.0, 60000.0);
    float y = dot(c, vec3(0.2126, 0.7152, 0.0722));
    // What is far brighter than the display loses its colour before the curve.
    float wash = y / (y + 6.0);
    c = mix(c, vec3(y), 0.55 * wash);
    return vec3(film_curve(c.r), film_curve(c.g), film_curve(c.b));
}

vec3 srgb_encode(vec3 c) {
    c = clamp(c, 0.0, 1.0);
    return mix(1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, 12.92 * c, vec3(lessThan(c, vec3(0.0031308))));
}

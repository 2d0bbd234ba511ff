// SPDX-License-Identifier: MIT
// From exposed linear radiance to display values. A curve on each channel alone turns every bright colour white, a
// curve on the brightest one alone keeps it garish: the picture is a mix, and sunsets stay golden.

// The response of film and of photoreceptors (Naka & Rushton 1966): x^n / (x^n + s^n), straight in the middle of a
// logarithmic scale, with a toe and a long shoulder. Middle grey 0.18 maps to itself.
float film_curve(float x) {
    float y = pow(max(x, 0.0), 1.3);
    return y / (y + 0.4903);
}

vec3 tonemap(vec3 c) {
    c = clamp(c, 0.0, 60000.0);
    // What is far brighter than the display, the sun's disc and its glitter, burns out to white.
    float y = dot(c, vec3(0.2126, 0.7152, 0.0722)), burnt = 0.7 * y / (y + 40.0);
    c = mix(c, vec3(y), burnt);
    float peak = max(max(c.r, c.g), max(c.b, 1e-6));
    vec3 each = vec3(film_curve(c.r), film_curve(c.g), film_curve(c.b));
    return mix(each, c * (film_curve(peak) / peak), 0.38 / (1.0 + 0.3 * y));
}

vec3 srgb_encode(vec3 c) {
    c = clamp(c, 0.0, 1.0);
    return mix(1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, 12.92 * c, vec3(lessThan(c, vec3(0.0031308))));
}

// SPDX-License-Identifier: MIT
// From exposed linear radiance to display values. A curve on each channel alone turns every bright colour white, a
// curve on the brightest one alone keeps it garish: the picture is a mix, and sunsets stay golden.
// Powers cost a software rasteriser more than all the rest, so both curves are ratios in the square root, fitted
// (minimax in the encoded value) to the exact ones; tests/shaders/test_tonemap.c holds the two together against those.
// One reciprocal serves several quotients: it is worth five multiplications.

// The response of film and of photoreceptors (Naka & Rushton 1966): x^1.3 / (x^1.3 + 0.4903), straight in the middle of
// a logarithmic scale, with a toe and a long shoulder. Middle grey 0.18 maps to itself. For x^1.3 / 0.4903 stands
// x (0.1711 + 4.3104 t + 2.0106 t^2) / (1 + 2.1958 t), t = sqrt(x): off by 0.13 / 255 at most.
vec3 film_curve(vec3 c, float peak, out float inverse_peak) {
    vec3 t = sqrt(c), n = c * (0.1711087 + 4.310449 * t + 2.010606 * c), d = n + (1.0 + 2.195759 * t);
    vec3 others = d.yzx * d.zxy;
    float product = d.x * others.x, inverse = 1.0 / (product * peak); // below 1e28
    inverse_peak = product * inverse;
    return n * others * (peak * inverse);
}

vec3 tonemap(vec3 c) {
    c = clamp(c, 0.0, 60000.0);
    // What is far brighter than the display, the sun's disc and its glitter, burns out to white.
    float y = dot(c, vec3(0.2126, 0.7152, 0.0722)), far = y + 40.0, dim = 1.0 + 0.3 * y, inverse = 1.0 / (far * dim);
    c = mix(c, vec3(y), 0.7 * y * dim * inverse);
    float inverse_peak;
    vec3 each = film_curve(c, max(max(c.r, c.g), max(c.b, 1e-6)), inverse_peak);
    float top = max(max(each.r, each.g), each.b); // the peak's, for the curve rises
    return mix(each, c * (top * inverse_peak), 0.38 * far * inverse);
}

// Of c in [0,1]. IEC 61966-2-1; for 1.055 c^(1/2.4) - 0.055 stands a ratio in sqrt(c), off by 0.16 / 255 at most.
vec3 srgb_encode(vec3 c) {
    vec3 s = sqrt(c), n = 0.6935922 * s + (0.8163407 * c - 0.0189349), d = s + 0.4900882, others = d.yzx * d.zxy;
    return mix(n * others * (1.0 / (d.x * others.x)), 12.92 * c, lessThan(c, vec3(0.0031308)));
}

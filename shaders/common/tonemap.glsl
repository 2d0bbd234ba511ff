// SPDX-License-Identifier: MIT
// From exposed linear radiance to display values. A curve on each channel alone turns every bright colour white, a
// curve on the brightest one alone keeps it garish: the picture is a mix, and sunsets stay golden.
// Powers cost a software rasteriser more than all the rest, so both curves are ratios in the square root, fitted
// (minimax in the encoded value) to the exact ones; tests/shaders/test_tonemap.c holds the two together against those.
// One reciprocal serves several quotients: it is worth five multiplications.

// A toe and a long shoulder, as film has them: (x / (x + 0.3846))^1.5. Middle grey 0.18 maps to itself, a sunlit cloud
// keeps its shape and glitter, four stops above grey, its points. For f / (1 - f) stands
// x t (4.08735 + 9.75601 t) / (1 + t (1.95269 + 5.75104 t)), t = sqrt(x): off by 0.04 / 255 at most.
vec3 film_curve(vec3 c, float peak, out float inverse_peak) {
    vec3 t = sqrt(c), n = c * t * (4.087349 + 9.756008 * t), d = n + (1.0 + t * (1.952685 + 5.751039 * t));
    vec3 others = d.yzx * d.zxy;
    float product = d.x * others.x, inverse = 1.0 / (product * peak); // below 1e31
    inverse_peak = product * inverse;
    return n * others * (peak * inverse);
}

vec3 tonemap(vec3 c) {
    c = clamp(c, 0.0, 60000.0);
    // A print has more color than the light has, where the light has little. What is far brighter than the display, the
    // sun's disc and its glitter, burns out to white instead.
    float y = dot(c, vec3(0.2126, 0.7152, 0.0722)), far = y + 40.0, dim = 1.0 + 0.12 * y;
    float peak = max(max(c.r, c.g), max(c.b, 1e-6)), least = min(min(c.r, c.g), c.b);
    float inverse = 1.0 / (far * dim * peak); // above 1e-14
    c = mix(vec3(y), c, (dim * peak + 0.4 * least) * (far - 0.7 * y) * inverse);
    float inverse_peak;
    vec3 each = film_curve(c, max(max(c.r, c.g), max(c.b, 1e-6)), inverse_peak);
    float top = max(max(each.r, each.g), each.b); // the peak's, for the curve rises
    return mix(each, c * (top * inverse_peak), 0.4 * far * peak * inverse);
}

// Of c in [0,1]. IEC 61966-2-1; for 1.055 c^(1/2.4) - 0.055 stands a ratio in sqrt(c), off by 0.16 / 255 at most.
vec3 srgb_encode(vec3 c) {
    vec3 s = sqrt(c), n = 0.6935922 * s + (0.8163407 * c - 0.0189349), d = s + 0.4900882, others = d.yzx * d.zxy;
    return mix(n * others * (1.0 / (d.x * others.x)), 12.92 * c, lessThan(c, vec3(0.0031308)));
}

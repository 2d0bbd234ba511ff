// SPDX-License-Identifier: MIT
// Where things seem to lie through a flat water surface: Ma, Zhu & Gong 2006, section 2.2.3, and Fermat's path in place of its
// one angle for all. Twin of src/optics/refraction.c.

// Tangent of the angle in the air of the path between a point `air` above the water and one `water` below it, `aside` apart [m].
// h t + d t / sqrt(n^2 + (n^2 - 1) t^2) = D: concave in t, so Newton's steps from below never overshoot.
float refraction_tangent(float air, float water, float aside, float index) {
    float n2 = index * index, m2 = n2 - 1.0;
    air = max(air, 1e-3);
    float t = max(aside / (air + water / index), (aside - water * inversesqrt(m2)) / air);
    for (int i = 0; i < 4; ++i) {
        float q = n2 + m2 * t * t, r = inversesqrt(q);
        t += (aside - air * t - water * t * r) / (air + water * n2 * r * r * r);
    }
    return t;
}

// Apparent depth over depth at that tangent: eq. 7.
float refraction_k(float tangent, float index) {
    float n2 = index * index;
    return inversesqrt(n2 + (n2 - 1.0) * tangent * tangent);
}

// Height over the water [m], < 0 below, at which a point of height z and horizontal distance `aside` seems to stand to an eye of
// height `eye_z` on the other side.
float apparent_height(float eye_z, float z, float aside, float index) {
    if (eye_z > 0.0) return z * refraction_k(refraction_tangent(eye_z, max(-z, 0.0), aside, index), index);
    float over = max(z, 1e-3); // from below: what stands above the water seems taller
    return over / refraction_k(refraction_tangent(over, -eye_z, aside, index), index) + min(z, 0.0);
}

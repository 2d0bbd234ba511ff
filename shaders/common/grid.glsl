// SPDX-License-Identifier: MIT
// The projector of the static grid: from a place in the unit square (column, row) to mean water round the eye. Pure; the twin of
// bolan_surface_projector_vertices() in src/surface/projected.c, which says why it is so.

// reach: s of the first row, from there to the last row, height that sets the steps [m], of the eye over the water [m];
// azimuth: middle, half [rad], guard [m], earth radius [m]; cells along both sides. Gives eye-relative position and spacing [m].
vec4 grid_point(vec2 place, vec4 reach, vec4 azimuth, vec2 cells) {
    float s = reach.x + reach.y * place.y;
    bool near = s < 1.4259205; // atan x1; beyond x1 the steps grow with the distance
    float x = near ? tan(s) : 6.8541020 * exp(7.0 * (s - 1.4259205));
    float r = reach.z * x, radial = reach.z * (near ? 1.0 + x * x : 7.0 * x) * reach.y / cells.y;
    float share = min(azimuth.z / max(r, 1e-6), 1.0);
    float half_angle = mix(azimuth.y, 3.14159265, share * sqrt(share));
    float a = azimuth.x + half_angle * (2.0 * place.x - 1.0);
    float drop = r * r / (2.0 * azimuth.w);
    return vec4(r * sin(a), r * cos(a), -reach.w - drop, max(radial, r * 2.0 * half_angle / cells.x));
}

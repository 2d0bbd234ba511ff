// SPDX-License-Identifier: MIT
// Haze for the quad, whose vertices lie far away, so that its pixels must compute the haze cheaply. The density of the
// air between the eye and the flat sea depends on height alone, so one extinction serves the whole image. The
// in-scattered radiance is a parabola of the cosine of the azimuth from the sun, through three texture fetches
// of the table. Needs common/atmosphere.glsl. Henyey and Greenstein's shape for g = 0.88.
float forward_lobe(float c) {
    float q = 1.0 / (1.7744 - 1.76 * c);
    return q * sqrt(q);
}

#ifdef VERTEX
flat out vec3 haze_extinction; // of the mean density between the eye's height and the sea [1/m]
flat out vec3 haze_level;      // radiance of endless haze: level + slope c + lobe forward(c)
flat out vec3 haze_slope;
flat out vec3 haze_lobe;

float mean_density(float h, float scale) { return h > 1.0 ? scale / h * (1.0 - exp(-h / scale)) : 1.0; }

vec3 haze_towards(float azimuth, float h) {
    const float REACH = 12000.0;
    vec3 dir = sky_direction(sqrt(azimuth / PI), -0.5 * h / REACH, h);
    vec3 light = textureLod(aerial_table, aerial_uv(dir, h, REACH), 0.0).rgb;
    return light / (1.0 - exp(-haze_extinction * REACH));
}

void haze_vertex() {
    if (haze_given > 0.5) {
        haze_extinction = given_haze_extinction;
        haze_level = given_haze_radiance;
        haze_slope = haze_lobe = vec3(0.0);
        return;
    }
    float h = max(eye_height, 0.0), haze_scale = 1000.0 * clamp(visibility / 5000.0, 0.25, 1.0);
    haze_extinction = RAYLEIGH * mean_density(h, RAYLEIGH_SCALE) + mie_extinction() * mean_density(h, haze_scale);
    vec3 ahead = haze_towards(0.0, h), aside = haze_towards(PI / 3.0, h), behind = haze_towards(PI, h);
    float c = length(sun_direction.xy); // ahead; half of it aside
    vec3 lobe = vec3(forward_lobe(c), forward_lobe(0.5 * c), forward_lobe(-c));
    float bent = lobe.y - lobe.z - 0.75 * (lobe.x - lobe.z);
    // No lobe where the sun is overhead.
    haze_lobe = (aside - behind - 0.75 * (ahead - behind)) * (bent / (bent * bent + 1e-6));
    haze_slope = (ahead - behind - haze_lobe * (lobe.x - lobe.z)) * (c / (2.0 * c * c + 1e-6));
    haze_level = behind + c * haze_slope - lobe.z * haze_lobe;
}
#endif

#ifdef FRAGMENT
flat in vec3 haze_extinction;
flat in vec3 haze_level;
flat in vec3 haze_slope;
flat in vec3 haze_lobe;

vec3 haze_transmittance(float dist) {
    vec3 x = haze_extinction * dist, q = 1.0 + x * (0.25 + x * (0.03125 + x * 0.0026041667));
    q *= q;
    return 1.0 / (q * q); // exp(-x), to 0.003
}

// Radiance that the haze adds along `to`, where it transmits `left`.
vec3 haze_inscatter(vec3 to, vec3 left) {
    float c = dot(to.xy, sun_direction.xy) * inversesqrt(max(dot(to.xy, to.xy), 1e-9));
    return max(haze_level + c * haze_slope + forward_lobe(c) * haze_lobe, vec3(0.0)) * (1.0 - left);
}

// Light that arrives from the water at that distance along `to`.
vec3 through_haze(vec3 light, vec3 to, float dist) {
    vec3 left = haze_transmittance(dist);
    return light * left + haze_inscatter(to, left);
}
#endif

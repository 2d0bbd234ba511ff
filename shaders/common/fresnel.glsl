// SPDX-License-Identifier: MIT
// Reflectance of the water surface. The exact dielectric is the twin of bolan_fresnel() in src/optics/fresnel.c.

// Unpolarised light at cos_incident (0..1); eta = n_transmitted / n_incident.
float fresnel(float cos_incident, float eta) {
    float sin2 = (1.0 - cos_incident * cos_incident) / (eta * eta);
    if (sin2 >= 1.0) return 1.0; // total reflection
    float cos_transmitted = sqrt(1.0 - sin2);
    float rs = (cos_incident - eta * cos_transmitted) / (cos_incident + eta * cos_transmitted);
    float rp = (eta * cos_incident - cos_transmitted) / (eta * cos_incident + cos_transmitted);
    return 0.5 * (rs * rs + rp * rp);
}

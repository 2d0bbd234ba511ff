// SPDX-License-Identifier: MIT
// Reflectance of the water surface. The exact dielectric is the twin of bolan_fresnel() in src/scene/fresnel.c.

// Unpolarised light at cos_incident (0..1); eta = n_transmitted / n_incident.
float fresnel(float cos_incident, float eta) {
    float sin2 = (1.0 - cos_incident * cos_incident) / (eta * eta);
    if (sin2 >= 1.0) return 1.0; // total reflection
    float cos_transmitted = sqrt(1.0 - sin2);
    float rs = (cos_incident - eta * cos_transmitted) / (cos_incident + eta * cos_transmitted);
    float rp = (eta * cos_incident - cos_transmitted) / (eta * cos_incident + cos_transmitted);
    return 0.5 * (rs * rs + rp * rp);
}

// Mean over rough water with rms slope `sigma` along the view (Bruneton, Neyret & Holzschuch 2010, eq. 17), made exact for a mirror by
// the ratio of the exact curve to Schlick's, which fades as the roughness takes over.
float mean_fresnel(float cos_incident, float eta, float sigma) {
    float f0 = (eta - 1.0) * (eta - 1.0) / ((eta + 1.0) * (eta + 1.0));
    float grazing = 1.0 - cos_incident;
    float grazing2 = grazing * grazing, schlick = f0 + (1.0 - f0) * grazing2 * grazing2 * grazing;
    float rough = f0 + (1.0 - f0) * pow(grazing, 5.0 * exp(-2.69 * sigma)) / (1.0 + 22.7 * sigma * sqrt(sigma));
    return rough * mix(fresnel(cos_incident, eta) / schlick, 1.0, min(1.0, sigma * 10.0));
}

// SPDX-License-Identifier: MIT
// Clear air over a round earth: geometry, constituents, scattering. Heights and distances in metres,
// coefficients in 1/m at 650, 550 and 450 nm. After Hillaire 2020, "A scalable and production ready sky and
// atmosphere rendering technique"; needs common/frame.glsl. tests/shaders/test_atmosphere.c holds the CPU twin.
#include "common/frame.glsl"
#include "shared/constants.glsl"
#include "shared/earth.glsl"

const float AIR_TOP = 100000.0;          // above it, nothing
const float RAYLEIGH_SCALE = 8000.0;     // scale height
// Vertical Rayleigh optical depth at sea level, Bodhaine et al. 1999 eq. 30, over the scale height.
const vec3 RAYLEIGH = vec3(0.049184, 0.097070, 0.221110) / RAYLEIGH_SCALE;
// 300 Dobson units in a tent 10..40 km. The Chappuis band peaks at 600 nm, between the sample wavelengths, so its
// cross-section (Gorshelev et al. 2014) is averaged over the display's primaries: 4.2, 3.2 and 0.25e-21 cm2. It makes
// the blue hour blue.
const vec3 OZONE = vec3(0.03384, 0.02578, 0.00201) / 15000.0;
const float MIE_ALBEDO = 0.97;           // sea salt absorbs little
const vec3 MIE_COLOR = vec3(0.8896, 1.0, 1.1508); // Angstrom exponent 0.7
// The picture is balanced, as a camera's daylight setting is, for the sun above the air: its colour is white,
// luminance 1.
const vec3 SUN_COLOR = vec3(1.0);
const float SUN_RADIUS = 0.00465;        // angular [rad]
const float SEA_ALBEDO = 0.07;


// ---- geometry; h above the sea, mu = cosine of the zenith angle

float air_height(float h, float mu, float d) { return earth_height_along(h, mu, d, earth_radius); }

float horizon_dip(float h) { return earth_dip_exact(h, earth_radius); }
float horizon_mu(float h) { return -earth_horizon_exact(h, earth_radius) / (earth_radius + h); }

float distance_to_top(float h, float mu) {
    float r = earth_radius, b = (r + h) * mu;
    float e = earth_shell(AIR_TOP, h, r), s = sqrt(b * b + e);
    return b > 0.0 ? e / (b + s) : s - b;
}

// Negative: the ray misses the sea.
float distance_to_sea(float h, float mu) { return earth_meets_exact(h, mu, earth_radius); }

// ---- content

// Scale height of the haze [m]: fog lies lower than haze.
float haze_scale() { return 1000.0 * clamp(visibility / 5000.0, 0.25, 1.0); }

vec3 air_density(float h) { // of air, haze and ozone, relative to their reference
    h = max(h, 0.0);
    return vec3(exp(-h / RAYLEIGH_SCALE), exp(-h / haze_scale()), max(0.0, 1.0 - abs(h - 25000.0) / 15000.0));
}

// Koschmieder: the visibility is where contrast falls to 2 %, by air and haze together.
vec3 mie_extinction() { return MIE_COLOR * max(3.912 / visibility - RAYLEIGH.g, 2e-6); }

vec3 air_extinction(vec3 density) { return RAYLEIGH * density.x + mie_extinction() * density.y + OZONE * density.z; }

float rayleigh_phase(float c) { return 3.0 / (16.0 * PI) * (1.0 + c * c); }

float henyey_greenstein(float c, float g) {
    float k = 1.0 + g * g - 2.0 * g * c;
    return (1.0 - g * g) / (4.0 * PI * k * sqrt(k));
}

// Sea salt: a narrow forward lobe and a wide one, mean cosine 0.71 as of maritime haze.
float mie_phase(float c) { return 0.7 * henyey_greenstein(c, 0.88) + 0.3 * henyey_greenstein(c, 0.3); }

// ---- optical depth from a height to the top of the air: a table over (distance to the top, height), after Bruneton &
// Neyret 2008

uniform sampler2D transmittance_table;
#pragma unit transmittance_table 0
const vec2 TRANSMITTANCE_SIZE = vec2(SKY_TRANSMITTANCE_WIDTH, SKY_TRANSMITTANCE_HEIGHT);

vec2 transmittance_uv(float h, float mu) {
    float longest = earth_horizon_exact(AIR_TOP, earth_radius), rho = earth_horizon_exact(h, earth_radius);
    float shortest = AIR_TOP - h;
    vec2 x = vec2((distance_to_top(h, mu) - shortest) / max(rho + longest - shortest, 1.0), rho / longest);
    return (clamp(x, 0.0, 1.0) * (TRANSMITTANCE_SIZE - 1.0) + 0.5) / TRANSMITTANCE_SIZE;
}

void transmittance_ray(vec2 uv, out float h, out float mu) { // the inverse
    float r = earth_radius;
    vec2 x = (uv * TRANSMITTANCE_SIZE - 0.5) / (TRANSMITTANCE_SIZE - 1.0);
    float longest = earth_horizon_exact(AIR_TOP, r), rho = x.y * longest;
    h = rho * rho / (r + sqrt(r * r + rho * rho));
    float shortest = AIR_TOP - h, d = shortest + x.x * (rho + longest - shortest);
    mu = d < 1.0 ? 1.0 : clamp((earth_shell(AIR_TOP, h, r) - d * d) / (2.0 * (r + h) * d), -1.0, 1.0);
}

// To space along mu, as if the earth were not in the way; at most what is left above the local horizon.
vec3 transmittance_to_space(float h, float mu) {
    h = clamp(h, 0.0, AIR_TOP);
    return exp(-textureLod(transmittance_table, transmittance_uv(h, max(mu, horizon_mu(h))), 0.0).rgb);
}

// How much of the sun's disc stands above the horizon.
float sun_above_horizon(float h, float mu) {
    float above = (mu - horizon_mu(h)) / SUN_RADIUS; // near the horizon a cosine difference is an angle
    return smoothstep(-1.0, 1.0, above);
}

vec3 sun_transmittance_at(float h, float mu) { return transmittance_to_space(h, mu) * sun_above_horizon(h, mu); }

// Airglow and starlight: 2e-4 cd/m2 (Leinert et al. 1998, table 1) of the sun's 128 klx; what is left at the end of
// twilight.
vec3 night_radiance() { return vec3(0.85, 1.0, 1.2) * 1.6e-9 * radiance_unit; }

// Solar irradiance above the air, in the unit of every stored radiance: radiance_unit is 1 by day and grows in
// twilight, so that half floats hold it.
vec3 solar_irradiance() { return SUN_COLOR * radiance_unit; }

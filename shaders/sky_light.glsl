// SPDX-License-Identifier: MIT
// Four pixels of light at the sea, read back by the CPU: 0 irradiance of the sky on a horizontal surface, 1 direct
// solar irradiance at normal incidence, 2 the same at the eye, 3 mean transmission of the clouds round the eye.
#include "common/fullscreen.glsl"
#ifdef VERTEX
void main() { fullscreen(0.5); }
#endif
#ifdef FRAGMENT
#include "common/atmosphere.glsl"
out vec4 color;

const int RINGS = 32, SECTORS = 64;
const float LEVEL = 2.0; // its texels are as far apart as the places that are summed

vec3 sky_irradiance() {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < RINGS; ++i) {
        float s = sqrt((float(i) + 0.5) / float(RINGS)); // equal parts of cos(theta) dOmega
        for (int j = 0; j < SECTORS; ++j) {
            float azimuth = 2.0 * PI * (float(j) + 0.5) / float(SECTORS);
            vec3 dir = vec3(s * cos(azimuth), s * sin(azimuth), sqrt(1.0 - s * s));
            sum += textureLod(environment_map, environment_uv(dir), LEVEL).rgb;
        }
    }
    return sum * PI / float(RINGS * SECTORS);
}

float mean_shadow() {
    float sum = 0.0;
    for (int i = 0; i < 256; ++i) sum += cloud_shadow((vec2(float(i % 16), float(i / 16)) - 7.5) * 800.0);
    return sum / 256.0;
}

void main() {
    int which = int(gl_FragCoord.x);
    vec3 c = which == 0   ? sky_irradiance()
             : which == 1 ? solar_irradiance() * sun_transmittance(0.0)
             : which == 2 ? solar_irradiance() * sun_transmittance(eye_height)
                          : vec3(mean_shadow());
    color = vec4(c, 1.0);
}
#endif

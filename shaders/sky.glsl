// SPDX-License-Identifier: MIT
// The sky behind everything: clear air, the sun's disc, clouds; and below the horizon, should no water have been drawn there,
// a plain far sea.
#include "common/fullscreen.glsl"
#include "common/frame.glsl"

#ifdef VERTEX
void main() { fullscreen(lens.z > 0.5 ? 0.0 : -1.0); } // the far plane: window depth 0
#endif

#ifdef FRAGMENT
#include "common/atmosphere.glsl"
out vec4 color;

// The disc, darker to its rim (Hestroffer & Magnan 1998 at 650, 550, 450 nm), smoothed over a pixel.
vec3 sun_disc(vec3 dir) {
    float angle = length(cross(dir, sun.xyz)), pixel = lens.x;
    if (dot(dir, sun.xyz) < 0.9 || angle > SUN_RADIUS + pixel) return vec3(0.0);
    float r = angle / SUN_RADIUS, edge = clamp((SUN_RADIUS - angle) / pixel + 0.5, 0.0, 1.0);
    float mu = sqrt(max(1.0 - r * r, 0.0));
    vec3 power = vec3(0.42, 0.52, 0.65), limb = pow(vec3(max(mu, 0.05)), power);
    vec3 mean = 2.0 / (2.0 + power); // of the disc: 2 int mu^p r dr
    vec3 radiance = solar_irradiance() / (AIR_PI * SUN_RADIUS * SUN_RADIUS) * limb / mean;
    return min(radiance * edge * transmittance_to_space(max(eye.z, 0.0), dir.z), vec3(30000.0));
}

vec3 far_sea(vec3 dir, float d) {
    vec3 transmittance, inscatter;
    aerial_perspective(dir * d, transmittance, inscatter);
    vec3 mirrored = environment_radiance(vec3(dir.xy, abs(dir.z) + 0.1), 0.15);
    vec3 sea = mix(water_deep.rgb * (sun_light.rgb * max(sun.z, 0.0) + sky_light.rgb), mirrored, 0.35);
    return sea * transmittance + inscatter;
}

void main() {
    vec3 dir = normalize(frame_ray(uv));
    float h = max(eye.z, 0.0), d = distance_to_sea(h, dir.z);
    if (d >= 0.0) {
        color = vec4(far_sea(dir, d), 1.0);
        return;
    }
    vec4 clouds = cloud_radiance(dir);
    color = vec4((sky_radiance(dir) + sun_disc(dir)) * (1.0 - clouds.a) + clouds.rgb, 1.0);
}
#endif

// SPDX-License-Identifier: MIT
// The sky behind everything: clear air and clouds, two look-ups a pixel. The sun's disc is drawn over it by
// sky_sun.glsl. Below the horizon, should no water have been drawn there, the horizon's own light.
#include "common/fullscreen.glsl"
#include "common/frame.glsl"
#include "common/atmosphere.glsl"

#ifdef VERTEX
out vec3 ray;          // eye-relative direction; linear over the picture
flat out vec3 horizon; // its dip [rad], 1 over the angle from it to the zenith, the sun's azimuth [rad]

void main() {
    fullscreen(lens.z > 0.5 ? 0.0 : -1.0); // the far plane: window depth 0
    ray = frame_ray(uv);
    float dip = horizon_dip(max(eye.z, 0.0));
    horizon = vec3(dip, 1.0 / (0.5 * AIR_PI + dip), length(sun.xy) > 1e-6 ? atan(sun.y, sun.x) : 0.0);
}
#endif

#ifdef FRAGMENT
in vec3 ray;
flat in vec3 horizon;
out vec4 color;

// sky_radiance() and cloud_radiance() with what they share worked out once.
void main() {
    vec3 dir = normalize(ray);
    float above = asin(clamp(dir.z, -1.0, 1.0)) + horizon.x, y = sqrt(max(above, 0.0) * horizon.y);
    float azimuth = atan(dir.y, dir.x), from_sun = abs(azimuth - horizon.z);
    from_sun = min(from_sun, 2.0 * AIR_PI - from_sun);
    vec3 sky = textureLod(sky_view_table, to_texel_centres(vec2(sqrt(from_sun / AIR_PI), y), SKY_VIEW_SIZE), 0.0).rgb;
    vec2 panorama = vec2(azimuth / (2.0 * AIR_PI), air.y > 0.5 ? 0.5 + 0.5 * y : y);
    vec4 clouds = textureLod(cloud_map, vec3(panorama, 0.0), 0.0) * step(0.0, above);
    color = vec4(sky * (1.0 - clouds.a) + clouds.rgb, 1.0);
}
#endif

// SPDX-License-Identifier: MIT
// The sun's disc, added to the sky: one small triangle round it.
#include "common/frame.glsl"
#include "common/atmosphere.glsl"

#ifdef VERTEX
out vec3 ray;

void main() {
    vec3 side = normalize(cross(sun_direction, abs(sun_direction.z) < 0.9 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0)));
    vec3 up = cross(side, sun_direction);
    float angle = 2.0 * PI / 3.0 * float(gl_VertexID), radius = 2.0 * (SUN_RADIUS + 2.0 * radians_per_pixel);
    ray = sun_direction + radius * (cos(angle) * side + sin(angle) * up);
    gl_Position = view_projection * vec4(ray, 0.0);
    gl_Position.z = clip_zero_to_one > 0.5 ? 0.0 : -gl_Position.w; // behind everything
}
#endif

#ifdef FRAGMENT
in vec3 ray;
out vec4 color;

// Darker to its rim by the power of the cosine (Hestroffer & Magnan 1998), smoothed over a pixel.
void main() {
    vec3 dir = normalize(ray);
    float angle = length(cross(dir, sun_direction)), r = min(angle / SUN_RADIUS, 1.0);
    float edge = clamp((SUN_RADIUS - angle) / radians_per_pixel + 0.5, 0.0, 1.0);
    float above = angle_above_horizon(dir, max(eye_height, 0.0));
    float visible = edge * smoothstep(-radians_per_pixel, radians_per_pixel, above);
    // The march of the clouds ends at a transmittance of 1 %, through which the sun's disc would still be too bright.
    float through = clamp(1.0 - 1.04 * cloud_radiance(dir).a, 0.0, 1.0);
    vec3 power = vec3(0.42, 0.52, 0.65), limb = pow(vec3(max(sqrt(1.0 - r * r), 0.05)), power);
    vec3 mean = 2.0 / (2.0 + power); // of the disc: 2 int mu^p r dr
    vec3 radiance = solar_irradiance() / (PI * SUN_RADIUS * SUN_RADIUS) * limb / mean;
    radiance *= transmittance_to_space(max(eye_height, 0.0), dir.z) * visible * through * through;
    color = vec4(min(radiance, vec3(30000.0)), 0.0); // half floats end at 65504
}
#endif

// SPDX-License-Identifier: MIT
// The sky behind everything: one texture fetch a pixel, in clear air and clouds drawn together (sky_panorama.glsl). The
// sun's disc is drawn over it by sky_sun.glsl. The picture is drawn in two parts, which meet under the lowest point of
// the horizon. The part below (BELOW) shows the radiance of the horizon where no water was drawn. Everything that
// differs between views is in the uniform block. As a compute shader it does both parts, where nothing was drawn.
#include "common/frame.glsl"
#include "common/atmosphere.glsl"

#ifndef FRAGMENT
// Light below the horizon, at that azimuth.
vec3 light_below(vec3 ray) {
    vec2 sky = vec2(sun_azimuth_coordinate(ray.xy), 0.0);
    return textureLod(sky_view_table, to_texel_centres(sky, SKY_VIEW_SIZE), 0.0).rgb;
}

// Its dip [rad], 1 over the angle from it to the zenith.
vec2 horizon_from(float height) {
    float dip = horizon_dip(height);
    return vec2(dip, 1.0 / (0.5 * PI + dip));
}

// Whether directions below the horizon fill the picture up to a height: they are a convex cone, so its corners tell.
bool is_below(float height, float mu) {
    return normalize(frame_ray(vec2(0.0, height))).z < mu && normalize(frame_ray(vec2(1.0, height))).z < mu;
}

// The parts meet so much under the horizon, for water ends at facets, not at a circle [px].
const float UNDER_HORIZON = 6.0;
#endif

#ifdef VERTEX
layout(location = 0) in vec2 corner; // x: 0..1 across the picture; y: 0 the part's lower edge, 1 its upper edge

#ifdef BELOW
out vec3 light;
#else
out vec3 ray; // eye-relative direction; linear over the picture
flat out vec2 horizon;
#endif

// Where the parts meet, 0..1 up the picture.
float meeting_height(float mu) {
    if (!is_below(0.0, mu)) return 0.0;
    float below = 0.0, above = 1.0;
    for (int i = 0; i < 12; ++i) {
        float middle = 0.5 * (below + above);
        if (is_below(middle, mu)) below = middle;
        else above = middle;
    }
    return max(below - UNDER_HORIZON * pixel_size.y, 0.0);
}

void main() {
    float h = max(eye_height, 0.0), meet = meeting_height(horizon_mu(h));
#ifdef BELOW
    vec2 at = vec2(corner.x, corner.y * meet);
    light = light_below(frame_ray(at));
#else
    vec2 at = vec2(corner.x, mix(meet, 1.0, corner.y));
    ray = frame_ray(at);
    horizon = horizon_from(h);
#endif
    gl_Position = vec4(at * 2.0 - 1.0, clip_zero_to_one > 0.5 ? 0.0 : -1.0, 1.0); // the far plane: window depth 0
}
#endif

#if defined(FRAGMENT) && defined(BELOW)
in vec3 light;
out vec4 color;
void main() { color = vec4(light, 1.0); }
#elif !defined(VERTEX)
uniform sampler2D panorama;
#pragma unit panorama 15

// Arc tangents of quotients in [0,1], to 1e-5 (Abramowitz & Stegun 4.4.49), which is far below a pixel.
vec2 arc_tangent(vec2 t) {
    vec2 q = t * t;
    return t * (0.9998660 + q * (-0.3302995 + q * (0.1801410 + q * (-0.0851330 + q * 0.0208351))));
}

// Azimuth and elevation of the ray [rad]: atan(y, x) and atan(z, length(xy)), with one reciprocal for both.
vec2 ray_angles(vec3 ray) {
    vec3 size = abs(ray);
    float across = sqrt(dot(ray.xy, ray.xy));
    vec2 near = vec2(max(size.x, size.y), max(across, size.z)), far = vec2(min(size.x, size.y), min(across, size.z));
    vec2 angle = arc_tangent(far * near.yx * (1.0 / max(near.x * near.y, 1e-30)));
    angle.x = size.y > size.x ? 0.5 * PI - angle.x : angle.x;
    angle.x = ray.x < 0.0 ? PI - angle.x : angle.x;
    angle.y = size.z > across ? 0.5 * PI - angle.y : angle.y;
    return vec2(ray.y < 0.0 ? -angle.x : angle.x, ray.z < 0.0 ? -angle.y : angle.y);
}

vec4 sky_along(vec3 ray, vec2 horizon) {
    vec2 angle = ray_angles(ray);
    float y = sqrt(max((angle.y + horizon.x) * horizon.y, 0.0));
    return textureLod(panorama, vec2(angle.x * (0.5 / PI), y), 0.0);
}

#ifdef FRAGMENT
in vec3 ray;
flat in vec2 horizon;
out vec4 color;
void main() { color = sky_along(ray, horizon); }
#else
uniform sampler2D drawn_depth; // of the target
#pragma unit drawn_depth 16

bool shade(vec2 centre, out vec4 color) {
    color = vec4(0.0);
    if (texelFetch(drawn_depth, ivec2(centre), 0).r > 0.0) return false;
    float h = max(eye_height, 0.0), mu = horizon_mu(h);
    vec3 ray = frame_ray(centre * pixel_size);
    bool above = !is_below((centre.y + UNDER_HORIZON) * pixel_size.y, mu);
    color = above ? sky_along(ray, horizon_from(h)) : vec4(light_below(ray), 1.0);
    return true;
}
#include "common/pixels.glsl"
#endif
#endif

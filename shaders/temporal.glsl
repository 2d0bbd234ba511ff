// SPDX-License-Identifier: MIT
// Temporal antialiasing: the mean of this image and the history. See src/render/temporal.h.
#include "common/fullscreen.glsl"
#ifdef VERTEX
void main() { fullscreen(0.5); }
#endif
#ifdef FRAGMENT
#include "common/frame.glsl"
#pragma unit image 15
#pragma unit history 16
#pragma unit motion 17
#pragma unit frame_depth 18
uniform sampler2D image;       // sum of display values
uniform sampler2D history;     // display values; w: of how many images they are the mean
uniform sampler2D motion;      // [px], to the frame before
uniform sampler2D frame_depth;
// x: 1 / images in the sum, y: 1 nothing has changed, z: most images of a mean, w: 1 there is a history
uniform vec4 settings;
uniform vec2 shift;            // of the present image [px]

// Standard deviations by which the history may differ, and most images of a mean of water: waves run faster than their
// parcels, so that its history is soon wrong. Looks, by the error against 16 samples in tests/images/test_temporal.c.
const float CLIP = 1.5, WATER_CLIP = 0.5, WATER_IMAGES = 3.0;

vec3 to_ycocg(vec3 c) {
    return vec3(dot(c, vec3(0.25, 0.5, 0.25)), 0.5 * (c.r - c.b), dot(c, vec3(-0.25, 0.5, -0.25)));
}
vec3 from_ycocg(vec3 c) { return vec3(c.x + c.y - c.z, c.x + c.z, c.x - c.y - c.z); }

ivec2 inside(ivec2 at) { return clamp(at, ivec2(0), ivec2(viewport_size) - 1); }

vec3 image_at(ivec2 at) { return texelFetch(image, inside(at), 0).rgb * settings.x; }

vec4 cubic_weights(float t) { // Catmull-Rom
    return vec4(t * (t * (1.0 - 0.5 * t) - 0.5), 1.0 + t * t * (1.5 * t - 2.5), t * (0.5 + t * (2.0 - 1.5 * t)),
                t * t * (0.5 * t - 0.5));
}

// A floating-point texture is not filtered everywhere. The number of images is that of the nearest texel.
vec4 history_at(vec2 place) {
    vec2 at = place - 0.5, first = floor(at), t = at - first;
    vec4 wx = cubic_weights(t.x), wy = cubic_weights(t.y);
    vec3 sum = vec3(0.0);
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i)
            sum += wx[i] * wy[j] * texelFetch(history, inside(ivec2(first) + ivec2(i, j) - 1), 0).rgb;
    return vec4(max(sum, 0.0), texelFetch(history, inside(ivec2(floor(place))), 0).w);
}

// Of the nearest surface round a pixel, so that edges move with what they are the edge of.
vec3 motion_at(ivec2 at) {
    float nearest = -1.0;
    ivec2 from = at;
    for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i) {
            ivec2 there = inside(at + ivec2(i, j));
            float depth = texelFetch(frame_depth, there, 0).r;
            if (depth > nearest) {
                nearest = depth;
                from = there;
            }
        }
    return texelFetch(motion, from, 0).xyz;
}

// What the pixel's middle shows, from the samples around it.
vec3 middle_at(ivec2 at) {
    vec2 place = vec2(at) + shift, first = floor(place), t = place - first;
    vec4 wx = cubic_weights(t.x), wy = cubic_weights(t.y);
    vec3 sum = vec3(0.0);
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i) sum += wx[i] * wy[j] * image_at(ivec2(first) + ivec2(i, j) - 1);
    return max(sum, 0.0);
}

// Towards the present value, until it lies within CLIP standard deviations of it: of the neighbours, less what a plane
// through them explains. So far the present value may be off by where the samples lie in their pixels; where the image
// is smooth it is not, and an old wave leaves nothing.
vec3 clipped(vec3 old, vec3 here, ivec2 at, float clip) {
    vec3 sum = vec3(0.0), squares = vec3(0.0), east = vec3(0.0), north = vec3(0.0);
    for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i) {
            vec3 c = to_ycocg(image_at(at + ivec2(i, j)));
            sum += c;
            squares += c * c;
            east += float(i) * c;
            north += float(j) * c;
        }
    vec3 mean = sum / 9.0, plane = (east * east + north * north) / 54.0; // slopes are east / 6 and north / 6
    vec3 reach = clip * sqrt(max(squares / 9.0 - mean * mean - plane, 0.0)) + 1e-4;
    vec3 present = to_ycocg(here), off = to_ycocg(old) - present, beyond = abs(off / reach);
    return from_ycocg(present + off / max(max(beyond.x, max(beyond.y, beyond.z)), 1.0));
}

out vec4 color;
void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    vec3 here = image_at(at);
    vec4 old = vec4(0.0);
    float most = settings.z;
    if (settings.w > 0.5 && settings.y > 0.5) {
        old = texelFetch(history, at, 0);
    } else if (settings.w > 0.5) {
        vec3 moved = motion_at(at);
        vec2 place = gl_FragCoord.xy + moved.xy;
        if (moved.z > 0.5) most = min(most, WATER_IMAGES);
        here = middle_at(at);
        bool seen = all(greaterThanEqual(place, vec2(0.0))) && all(lessThan(place, viewport_size));
        if (seen) {
            old = history_at(place);
            old.rgb = clipped(old.rgb, here, at, moved.z > 0.5 ? WATER_CLIP : CLIP);
        }
    }
    float count = min(old.w, most - 1.0);
    color = vec4(mix(old.rgb, here, 1.0 / (count + 1.0)), count + 1.0);
}
#endif

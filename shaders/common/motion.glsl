// SPDX-License-Identifier: MIT
// Motion vectors: from where a pixel's surface stands to where it stood in the frame before [px], both without jitter.
#ifdef FRAGMENT
#include "common/depth.glsl"
#pragma unit frame_depth 15
uniform sampler2D frame_depth;
uniform vec2 origin;           // lower left corner of the image in its framebuffer [px]
uniform vec4 camera_now[3];    // from the world relative to the eye of now: w times x, y [px] of the image, w
uniform vec4 camera_before[3]; // likewise, of the frame before

vec2 pixel_of(vec4 x, vec4 y, vec4 w, vec4 p) {
    float away = dot(w, p);
    return away > 0.0 ? vec2(dot(x, p), dot(y, p)) / away : vec2(1e5); // behind the camera: far outside the image
}

// Of a point (w 1) or a direction (w 0).
vec2 motion_of(vec4 now, vec4 before) {
    return pixel_of(camera_before[0], camera_before[1], camera_before[2], before) -
           pixel_of(camera_now[0], camera_now[1], camera_now[2], now);
}
#endif

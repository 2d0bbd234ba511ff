// SPDX-License-Identifier: MIT
// The water around an eye under water, where no object is drawn.
#define PICTURE
#include "common/fullscreen.glsl"
#include "common/frame.glsl"
#include "common/under.glsl"

#ifdef VERTEX
out vec3 ray; // eye-relative direction; linear over the picture

void main() {
    fullscreen(clip_zero_to_one > 0.5 ? 0.0 : -1.0); // the far plane: window depth 0
    ray = frame_ray(uv);
}
#endif

#ifdef FRAGMENT
in vec3 ray;
out vec4 color;

void main() {
    vec3 dir = normalize(ray);
    float upward = mirrored_under_water > 0.5 ? -abs(dir.z) : dir.z; // undoes the mirror
    color = vec4(water_glow(upward, -eye_height), 1.0);
}
#endif

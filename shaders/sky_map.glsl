// SPDX-License-Identifier: MIT
// The sky as an equirectangular map, read from the panorama that sky.glsl draws: the middle is north, columns run
// clockwise, the top row is the zenith. Directions below the horizon have its radiance. The sun's disc is not in it.
#include "common/fullscreen.glsl"
#ifdef VERTEX
void main() { fullscreen(0.5); }
#endif
#ifdef FRAGMENT
#include "common/frame.glsl"
#include "common/atmosphere.glsl"
uniform sampler2D panorama;
#pragma unit panorama 15
out vec4 color;

void main() {
    float compass = 2.0 * PI * (uv.x - 0.5), elevation = PI * (uv.y - 0.5), dip = horizon_dip(max(eye_height, 0.0));
    float y = sqrt(max((elevation + dip) / (0.5 * PI + dip), 0.0));
    color = textureLod(panorama, vec2(0.25 - compass * (0.5 / PI), y), 0.0);
}
#endif

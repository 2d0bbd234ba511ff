// SPDX-License-Identifier: MIT
// The environment map from the host's cube map: its upper half, resampled onto the disc of common/environment.glsl.
// Below the horizon the map is its mirror image, so that the lower half of the cube is never read.
#include "common/fullscreen.glsl"
#ifdef VERTEX
void main() { fullscreen(0.5); }
#endif
#ifdef FRAGMENT
#include "common/environment.glsl"
uniform samplerCube host_cube; // linear radiance
#pragma unit host_cube 15
uniform vec4 cube_turn[3]; // columns of the rotation from the world to the cube's axes
out vec4 color;

void main() {
    vec3 dir = environment_direction(uv);
    vec3 to = cube_turn[0].xyz * dir.x + cube_turn[1].xyz * dir.y + cube_turn[2].xyz * dir.z;
    color = vec4(max(textureLod(host_cube, to, 0.0).rgb, vec3(0.0)), 1.0);
}
#endif

// SPDX-License-Identifier: MIT
// Shadows of the scene's objects on the water: the share of the sun that is left for a pixel times the
// share that passes the objects, by blending.
#include "common/fullscreen.glsl"
#ifdef VERTEX
void main() { fullscreen(0.0); }
#endif
#ifdef FRAGMENT
#include "common/frame.glsl"
#include "common/shape.glsl"
#include "common/shape_maps.glsl"
#include "common/object_shadow.glsl"
out vec4 color;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float depth = shape_depth(texelFetch(surface_shape, pixel, 0));
    if (depth <= 0.0) discard; // no water here
    vec3 position = frame_ray((vec2(pixel) + 0.5) * pixel_size) / depth;
    color = vec4(object_shadow(position));
}
#endif

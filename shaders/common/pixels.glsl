// SPDX-License-Identifier: MIT
// The two entry points of a pass over pixels: a fragment shader, and a compute shader that writes an image. Both call
// bool shade(vec2 centre, out vec4 color), which returns false where the pixel keeps its color. `centre` counts from
// the corner of the target [px].
#ifdef FRAGMENT
out vec4 color;
void main() {
    if (!shade(gl_FragCoord.xy, color)) discard;
}
#endif
#ifdef COMPUTE
layout(local_size_x = 8, local_size_y = 8) in; // PIXEL_GROUP of src/render/pixels.h
layout(rgba16f, binding = 0) uniform writeonly image2D target;
uniform vec4 region; // of the target: left, bottom, right, top [px]

void main() {
    ivec2 at = ivec2(region.xy) + ivec2(gl_GlobalInvocationID.xy);
    vec4 color;
    if (float(at.x) < region.z && float(at.y) < region.w && shade(vec2(at) + 0.5, color)) imageStore(target, at, color);
}
#endif

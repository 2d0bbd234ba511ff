// SPDX-License-Identifier: MIT
// What rough water mirrors of the land: a quarter-size copy of the picture that holds only what stands above the water,
// its color times its share of the pixel, and that share. Its mip levels are the means over lobes of any width.
#include "common/frame.glsl"
#include "common/fullscreen.glsl"

#ifdef VERTEX
void main() { fullscreen(0.0); }
#endif

#ifdef FRAGMENT
#include "common/behind.glsl"
#include "shared/constants.glsl"
out vec4 color;

void main() {
    ivec2 size = textureSize(scene_depth, 0), corner = ivec2(gl_FragCoord.xy) * LAND_MIRROR_PART;
    vec4 sum = vec4(0.0);
    for (int i = 0; i < LAND_MIRROR_PART * LAND_MIRROR_PART; ++i) {
        ivec2 at = min(corner + ivec2(i % LAND_MIRROR_PART, i / LAND_MIRROR_PART), size - 1);
        vec3 where;
        vec4 seen = behind((vec2(at) + 0.5) / vec2(size), where);
        if (seen.w > 0.0 && is_dry(where)) sum += vec4(seen.rgb, 1.0);
    }
    color = sum / float(LAND_MIRROR_PART * LAND_MIRROR_PART);
}
#endif

// SPDX-License-Identifier: MIT
// Up to four mip levels of all cascades in one dispatch: means of 2 x 2 texels, as src/render/sea_texels.kernel.c makes
// them. A group has 16 x 16 texels of level `from`.
#ifdef COMPUTE
#include "compute/halfs.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
#pragma unit source 15
uniform sampler2DArray source;
uniform int from;
uniform int count; // of levels, 1 to 4
layout(rgba16f, binding = 0) writeonly uniform image2DArray level1;
layout(rgba16f, binding = 1) writeonly uniform image2DArray level2;
layout(rgba16f, binding = 2) writeonly uniform image2DArray level3;
layout(rgba16f, binding = 3) writeonly uniform image2DArray level4;
shared vec4 mean[8][8];

vec4 texel(ivec3 at, int dx, int dy) { return texelFetch(source, at + ivec3(dx, dy, 0), from); }
vec4 mean_of(ivec2 at) {
    vec4 west = mean[at.y][at.x] + mean[at.y + 1][at.x], east = mean[at.y][at.x + 1] + mean[at.y + 1][at.x + 1];
    return 0.25 * (west + east);
}

void main() {
    ivec2 local = ivec2(gl_LocalInvocationID.xy), group = ivec2(gl_WorkGroupID.xy);
    int c = int(gl_WorkGroupID.z), size = textureSize(source, from).x;
    ivec3 at = ivec3(2 * (8 * group + local), c);
    bool inside = max(at.x, at.y) < size;
    vec4 value = vec4(0.0);
    if (inside) {
        value = 0.25 * ((texel(at, 0, 0) + texel(at, 0, 1)) + (texel(at, 1, 0) + texel(at, 1, 1)));
        imageStore(level1, ivec3(8 * group + local, c), halfs(value));
    }
    for (int l = 1; l < 4; ++l) {
        mean[local.y][local.x] = value;
        barrier();
        int width = 8 >> l; // of the group's part of this level
        ivec3 to = ivec3(width * group + local, c);
        if (l < count && max(local.x, local.y) < width && max(to.x, to.y) < size >> (l + 1)) {
            value = mean_of(2 * local);
            if (l == 1) imageStore(level2, to, halfs(value));
            if (l == 2) imageStore(level3, to, halfs(value));
            if (l == 3) imageStore(level4, to, halfs(value));
        }
        barrier();
    }
}
#endif

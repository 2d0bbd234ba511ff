// SPDX-License-Identifier: MIT
// The two uniform blocks that every pass reads: Frame, shared by all views of a step, and View.
layout(std140) uniform Frame {
#include "shared/frame_block.glsl"
};

layout(std140) uniform View {
#include "shared/view_block.glsl"
};

// The pixel of the image whose kept shape is shaded for the pixel of the target with that centre.
ivec2 sampled_pixel(vec2 centre) {
    vec2 pixel = centre * vec2(shade_columns, 1.0) - vec2(mod(tile_corner.x, shade_columns), 0.0);
    return ivec2(clamp(pixel, vec2(0.0), viewport_size - 0.5));
}

// Eye-relative direction through a point of the picture, uv in [0,1], not normalised. Depth 1 is the near plane.
vec3 frame_ray(vec2 uv) {
    vec4 p = inverse_view_projection * vec4(uv * 2.0 - 1.0, 1.0, 1.0);
    return p.xyz / p.w;
}

// Distance along the view axis [m] of a window depth (reversed-Z: near / distance).
float frame_distance(float depth) { return near_distance / max(depth, 1e-12); }

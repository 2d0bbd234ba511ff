// SPDX-License-Identifier: MIT
// Sunlight gathered by the waves, at a few depths and on the bed: the patch of rays of caustic_source.glsl, drawn where
// they land. The light of a texel is the area of the surface that it comes from over its own, summed over all sheets of
// the fold, so that none is lost and the mean is 1. Places are moved back along the refracted sun, so that the images
// of all depths lie over the place where their light entered.
#include "common/frame.glsl"

#ifdef VERTEX
layout(location = 0) in vec2 node;
out vec2 from;  // place on the surface [texels]
out vec2 light; // over flat water's; the same times the depth

#pragma unit rays 15
#pragma unit lights 16
uniform highp sampler2D rays; // caustic_source.glsl's outputs
uniform highp sampler2D lights;
uniform vec4 patch_place; // eye-relative corner, cell [m], texel [m]
uniform vec4 layer;       // depth [m], < 0: that of the bed; 1 / side [1/m]; 1: the third channel has the depth

void main() {
    vec4 ray = texelFetch(rays, ivec2(node), 0), at = texelFetch(lights, ivec2(node), 0);
    float depth = layer.x < 0.0 ? at.z : layer.x;
    vec2 place = node * patch_place.z + ray.xy; // from the corner
    vec2 lands = place + ray.zw * max(depth + at.x, 0.0) + caustic_travel * at.x;
    from = place / patch_place.w;
    light = at.y * vec2(1.0, depth * layer.z);
    gl_Position = vec4(lands * layer.y * 2.0 - 1.0, 0.0, 1.0);
}
#endif

#ifdef FRAGMENT
in vec2 from;
in vec2 light;
out vec4 color;

uniform vec4 channel; // 1 in the one that is drawn

const float BRIGHTEST = 60.0; // a half float adds up thousands; a texel that is brighter is a chance hit

void main() {
    vec2 x = dFdx(from), y = dFdy(from);
    float gain = abs(x.x * y.y - x.y * y.x);
    color = min((channel * light.x + vec4(0.0, 0.0, light.y, 0.0)) * gain, BRIGHTEST);
}
#endif

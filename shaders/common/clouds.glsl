// SPDX-License-Identifier: MIT
// How much cloud there is at a point: fair-weather cumulus that closes to a stratocumulus deck as the cover grows.
#include "common/air.glsl"

uniform sampler3D cloud_noise;
#pragma unit cloud_noise 3
uniform vec4 cloud_origin; // xy: eye in the clouds' pattern [m], z: thickness of the layer [m], w: threshold of the billows

const float CLOUD_EXTINCTION = 0.035;   // in their middle [1/m]
const float BILLOW_TILE = 5760.0, DETAIL_TILE = 1152.0, WEATHER_TILE = 57600.0;

float cloud_base() { return haze.y; }
float cloud_top() { return haze.y + cloud_origin.z; }

// 0..1 over the country: where clouds gather.
float cloud_weather(vec2 p) { return textureLod(cloud_noise, vec3(p / WEATHER_TILE, 0.37), 0.0).b; }

// Extinction [1/m] at eye-relative xy and height h; `fine` false: without the small structure.
float cloud_extinction(vec2 position, float h, bool fine) {
    float level = (h - cloud_base()) / cloud_origin.z;
    if (level <= 0.0 || level >= 1.0) return 0.0;
    vec2 p = position + cloud_origin.xy;
    float gather = cloud_weather(p) - 0.5;
    vec3 q = vec3(p, h * 1.6);
    float billows = textureLod(cloud_noise, q / BILLOW_TILE, 0.0).r;
    // flat below, heaped above: the threshold rises with height, less where clouds gather
    float shape = billows + 0.55 * gather - cloud_origin.w - 0.26 * level * level * level - 0.10 * level;
    shape = clamp(shape * 6.0, 0.0, 1.0) * smoothstep(0.0, 0.07, level);
    if (shape <= 0.0) return 0.0;
    if (fine) {
        float cells = textureLod(cloud_noise, (q + vec3(0.0, 0.0, 37.0)) / DETAIL_TILE, 0.0).g;
        shape = clamp((shape - 0.55 * (1.0 - cells) * (1.0 - 0.6 * shape)) * 1.35, 0.0, 1.0);
    }
    return CLOUD_EXTINCTION * shape;
}

// SPDX-License-Identifier: MIT
// How much cloud there is at a point: fair-weather cumulus that closes to a stratocumulus deck as the cover grows.
#include "common/air.glsl"

uniform sampler3D cloud_noise;
#pragma unit cloud_noise 16
uniform sampler2D cloud_weather; // r: where clouds gather, g: how high they grow; 0..1
#pragma unit cloud_weather 17
uniform vec4 cloud_origin; // xy: eye in the clouds' pattern, z: thickness of the layer [m], w: threshold of billows

const float CLOUD_EXTINCTION = 0.035;   // in their middle [1/m]
const float BILLOW_TILE = 5760.0, DETAIL_TILE = 1920.0, WEATHER_TILE = 57600.0;

float cloud_top() { return cloud_base + cloud_origin.z; }

// Level of a noise texture fetch whose tile has that size [m], for a footprint [m]: 64 texels to a tile.
float cloud_level(float footprint, float tile) { return max(log2(footprint * 64.0 / tile), 0.0); }

// Extinction [1/m] at eye-relative xy and height h, for a sample as wide as `footprint`; 0: without the small
// structure.
float cloud_extinction(vec2 position, float h, float footprint) {
    float level = (h - cloud_base) / cloud_origin.z;
    if (level <= 0.0 || level >= 1.0) return 0.0;
    vec2 p = position + cloud_origin.xy;
    vec2 weather = textureLod(cloud_weather, p / WEATHER_TILE, 0.0).rg;
    vec3 q = vec3(p + (weather.r - 0.5) * vec2(6500.0, -4500.0), h * 1.6); // shifted, so that the tiles do not show
    float billows = textureLod(cloud_noise, q / BILLOW_TILE, cloud_level(footprint, BILLOW_TILE)).r;
    level /= mix(0.45, 1.0, smoothstep(0.3, 0.7, weather.g));
    // flat below, heaped above: the threshold rises with height, less where clouds gather
    float shape = billows + 0.55 * (weather.r - 0.5) - cloud_origin.w - 0.26 * level * level * level - 0.10 * level;
    float contrast = mix(6.0, 2.5, cloud_cover * cloud_cover); // a deck varies more softly
    shape = clamp(shape * contrast, 0.0, 1.0) * smoothstep(0.0, 0.07, level);
    // a loop: with a branch in its place, software OpenGL takes a third longer to draw the clouds' panorama
    for (int inside = 0; inside < 1 && shape > 0.0 && footprint > 0.0; ++inside) {
        float lod = cloud_level(footprint, DETAIL_TILE);
        float cells = textureLod(cloud_noise, (q + vec3(0.0, 0.0, 37.0)) / DETAIL_TILE, lod).g;
        shape = clamp((shape - 0.75 * (1.0 - cells) * (1.0 - 0.6 * shape)) * 3.0, 0.0, 1.0);
    }
    return CLOUD_EXTINCTION * shape;
}

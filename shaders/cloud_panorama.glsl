// SPDX-License-Identifier: MIT
// The clouds around the eye by ray marching: premultiplied radiance and cover, with the air before them. Low clouds are
// marched with a rational law for multiple scattering; cirrus is a thin sheet.
#include "common/fullscreen.glsl"
#ifdef VERTEX
void main() { fullscreen(0.5); }
#endif
#ifdef FRAGMENT
#include "common/atmosphere.glsl"
#include "common/clouds.glsl"
#include "common/cirrus.glsl"
uniform sampler2D sea_view_table;
#pragma unit sea_view_table 15
uniform vec2 strip; // of the map that is drawn now: its first u, its width
uniform float texel_angle; // of the panorama [rad]
out vec4 color;

// Steps grow with the distance, up to a share of the layer. With equal shares alone, the samples of all rays of an eye
// at the base of the clouds would lie at the same heights, and cut the clouds into slices.
const int STEPS = 48, MOST_STEPS = 192, LIGHT_STEPS = 4;
const float LEAST_STEP = 25.0, STEP_GROWS = 0.035; // [m], share of the distance
const float INSIDE = 0.4; // of a step outside clouds, at whose ends light changes too much for the coarse step
const float STEEP_STEP = 70.0;                     // least share of the layer [m]
const float FARTHEST = 120000.0;

vec3 panorama_direction() { // inverse of cloud_uv()
    float h = max(eye_height, 0.0), dip = horizon_dip(h), horizon = eye_above_clouds > 0.5 ? CLOUD_HORIZON : 0.0;
    float up = max(uv.y - horizon, 0.0) / (1.0 - horizon), down = max(horizon - uv.y, 0.0) / CLOUD_HORIZON;
    float elevation = up * up * (0.5 * PI + dip) - pow(down, 1.5) * (0.5 * PI - dip) - dip;
    float azimuth = 2.0 * PI * (strip.x + strip.y * uv.x);
    return vec3(cos(azimuth) * cos(elevation), sin(azimuth) * cos(elevation), sin(elevation));
}

// Where the ray meets the shell of height H: near and far root, or x > y.
vec2 shell(float h, float mu, float shell_height) {
    float b = (earth_radius + h) * mu, c = earth_shell(h, shell_height, earth_radius), q = b * b - c;
    if (q < 0.0) return vec2(1.0, -1.0);
    return vec2(-b - sqrt(q), -b + sqrt(q));
}

vec2 layer_interval(float h, float mu) {
    vec2 base = shell(h, mu, cloud_base), top = shell(h, mu, cloud_top());
    float sea = distance_to_sea(h, mu);
    vec2 span;
    if (h < cloud_base) {
        span = sea >= 0.0 ? vec2(1.0, -1.0) : vec2(base.y, top.y);
    } else if (top.x > top.y || top.y < 0.0) {
        span = vec2(1.0, -1.0);
    } else {
        span = vec2(max(top.x, 0.0), base.x < base.y && base.x > 0.0 ? base.x : top.y);
    }
    return vec2(span.x, min(span.y, span.x + 60000.0));
}

float depth_towards_sun(vec2 position, float h, float footprint) {
    float sum = 0.0, step_length = 70.0, d = 0.0, up = max(sun_direction.z, 0.04);
    for (int i = 0; i < LIGHT_STEPS; ++i) {
        float at = d + 0.5 * step_length;
        sum += cloud_extinction(position + sun_direction.xy * at, h + up * at, i < 2 ? footprint : 0.0) * step_length;
        d += step_length;
        step_length *= 2.2;
    }
    return sum;
}

// Light of the whole sky on the clouds, as a radiance.
vec3 ambient_radiance() {
    vec3 sum = 2.0 * textureLod(sea_view_table, sky_view_uv(vec3(0.0, 0.0, 1.0), 2.0), 0.0).rgb;
    for (int i = 0; i < 4; ++i) {
        float azimuth = 0.5 * PI * (float(i) + 0.5);
        sum += textureLod(sea_view_table, sky_view_uv(vec3(cos(azimuth) * 0.8, sin(azimuth) * 0.8, 0.6), 2.0), 0.0).rgb;
    }
    return sum / 6.0;
}

// Premultiplied radiance and cover; mean distance.
vec4 march(vec3 dir, vec2 span, out float mean_distance) {
    float c = dot(dir, sun_direction), h0 = max(eye_height, 0.0);
    vec3 sun_above = solar_irradiance() * sun_transmittance(cloud_base + 0.7 * cloud_origin.z);
    vec3 ambient = ambient_radiance();
    // Light from a thick deck comes from the sun and from the blue sky: nearly white.
    vec3 entering = sun_above + PI * ambient;
    entering = mix(entering, vec3(dot(entering, vec3(0.2126, 0.7152, 0.0722))), 0.85 * cloud_cover * cloud_cover);
    float forward = 0.6 * henyey_greenstein(c, 0.85) + 0.4 * henyey_greenstein(c, 0.1);
    vec3 light = vec3(0.0);
    float across = span.y - span.x, longest = across / clamp(across / STEEP_STEP, 16.0, float(STEPS));
    float left = 1.0, weight = 0.0, d = floor(span.x / LEAST_STEP) * LEAST_STEP;
    float fine_until = 0.0;
    mean_distance = 0.0;
    for (int i = 0; i < MOST_STEPS; ++i) {
        float step_length = min(max(STEP_GROWS * d, LEAST_STEP), longest);
        bool fine = d < fine_until;
        if (fine) step_length *= INSIDE;
        float at = d + 0.5 * step_length, h = air_height(h0, dir.z, at);
        vec2 position = dir.xy * at;
        float footprint = at * texel_angle, extinction = cloud_extinction(position, h, footprint);
        if (extinction > 0.0 && !fine) { // the same stretch again
            fine_until = d + step_length;
            continue;
        }
        if (extinction > 0.0) {
            float depth = depth_towards_sun(position, h, footprint);
            float level = clamp((h - cloud_base) / cloud_origin.z, 0.0, 1.0);
            // light scattered many times falls off as by diffusion; thin edges scatter once
            float many = 2.5 / (4.0 * PI * (1.0 + 0.16 * depth)) * (1.0 - 0.35 * exp(-2.0 * depth));
            vec3 source = sun_above * (0.55 * forward * exp(-depth)) + entering * many +
                          ambient * mix(0.25, 0.60, level);
            float through = exp(-extinction * step_length), gained = left * (1.0 - through);
            light += gained * source;
            mean_distance += gained * at;
            weight += gained;
            left *= through;
            fine_until = max(fine_until, d + 2.0 * step_length);
        }
        d += step_length;
        if (left < 0.01 || d >= span.y) break;
    }
    mean_distance = weight > 0.0 ? mean_distance / weight : span.x;
    return vec4(light, 1.0 - left);
}

const float CIRRUS_BLUR = 1.5; // texels of the panorama: fibres that are finer show its rows

// The sheet of cirrus. row_height: of the panorama [v].
vec4 cirrus(vec3 dir, float row_height, out float d) {
    float h = max(eye_height, 0.0);
    vec2 roots = shell(h, dir.z, CIRRUS_HEIGHT);
    d = h < CIRRUS_HEIGHT ? roots.y : -1.0;
    if (d < 0.0 || distance_to_sea(h, dir.z) >= 0.0) return vec4(0.0);
    vec2 wind = normalize(wind_direction + vec2(1e-4, 0.3)), away = normalize(dir.xy + vec2(1e-9, 0.0));
    // Rows of the panorama are widest overhead, and the sheet lies aslant.
    float slant = 1.0 / max(dir.z, 0.08), horizon = eye_above_clouds > 0.5 ? CLOUD_HORIZON : 0.0;
    float row = PI * row_height * max(uv.y - horizon, 0.0) / ((1.0 - horizon) * (1.0 - horizon));
    vec2 texel = CIRRUS_BLUR * d * vec2(texel_angle * max(length(dir.xy), 0.1), row * slant);
    vec2 turned = vec2(away.x * wind.y - away.y * wind.x, dot(away, wind));
    vec2 sample_width = vec2(length(texel * turned.yx), length(texel * turned));
    float amount = cirrus_depth(dir.xy * d + cloud_origin.xy, wind, sample_width) * smoothstep(0.0, 0.15, cloud_cover);
    float cover = 1.0 - exp(-amount * min(slant, 5.0));
    float cosine = dot(dir, sun_direction);
    float phase = 0.7 * henyey_greenstein(cosine, 0.7) + 0.5 * henyey_greenstein(cosine, 0.0);
    vec3 light = solar_irradiance() * sun_transmittance(CIRRUS_HEIGHT) * phase + ambient_radiance() * 0.5;
    return vec4(light * cover, cover);
}

vec4 behind_air(vec4 clouds, vec3 dir, float d) {
    vec3 transmittance, inscatter;
    aerial_perspective(dir * d, transmittance, inscatter);
    float fade = 1.0 - smoothstep(0.5 * FARTHEST, FARTHEST, d);
    return vec4(clouds.rgb * transmittance + inscatter * clouds.a, clouds.a) * fade;
}

void main() {
    vec3 dir = panorama_direction();
    color = vec4(0.0);
    float d;
    vec4 high = cirrus(dir, abs(dFdy(uv.y)), d);
    if (high.a > 0.0) color = vec4(high.rgb * air_transmittance(max(eye_height, 0.0), dir.z, d), high.a);
    if (high.a > 0.0) { // the air before it, not the sky's whole
        vec3 transmittance, inscatter;
        aerial_perspective(dir * d, transmittance, inscatter);
        color.rgb += inscatter * high.a;
    }
    vec2 span = layer_interval(max(eye_height, 0.0), dir.z);
    if (span.y <= span.x || span.x > FARTHEST) return;
    vec4 low = behind_air(march(dir, span, d), dir, d);
    color = color * (1.0 - low.a) + low;
}
#endif

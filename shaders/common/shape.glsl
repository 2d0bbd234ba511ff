// SPDX-License-Identifier: MIT
// The kept shape of a pixel, 16 bytes. The optics that shade each pixel once write it by one shader and read it by
// another. Four whole numbers: the bits of a float, 1 over the distance along the view axis, 0 where there is no water;
// 20 bits of the offset x of the rest point, 12 of `spacing` and `depth`; the same of y; the slope of the mesh. Where
// the waves are read follows from the rest point by place_of(). Needs common/frame.glsl.
struct water_shape {
    vec2 rest;     // undisplaced xy, eye-relative
    vec2 slope;    // of the mesh
    float spacing; // log2 of the spacing of the mesh [m]; where it carries the waves, their jacobian
    float depth;   // of the mean water [m]
};

// A whole number of 0..2 * steps for any x: within half a step of squeezed(x), which is finest about 0.
float squeezed(float x) { return x / (1.0 + abs(x)); }
uint squeezed_code(float x, float steps) { return uint(squeezed(x) * steps + (steps + 0.5)); }
float squeezed_value(uint code, float steps) {
    float c = float(code) / steps - 1.0;
    return c / (1.0 - min(abs(c), 0.999999));
}

// The offset is that from the pixel's position, over its distance along the view axis. With OFFSET_SCALE, half a step
// of 20 bits is .12 millionths of that distance: a ten thousandth of a pixel of a picture 1000 pixels wide. Water
// displaced by n times its distance has (1 + 8 n)^2 times that error.
const float REST_STEPS = 524287.0, SLOPE_STEPS = 32767.0, DEPTH_STEPS = 8191.0;
const float OFFSET_SCALE = 8.0;
const float DEPTH_SCALE = 4.0; // depths below it are known best: to a quarter of a millimetre by the shore [m]
#ifdef WAVES_MESH
const float SPACING_FIRST = -1.5, SPACING_STEPS = 256.0; // a unit of the jacobian; 10 bits: to 2.5
#else
const float SPACING_FIRST = -12.0, SPACING_STEPS = 32.0; // an octave; 10 bits: to 2^20 m
#endif

// position: eye-relative, of the pixel's water; axis: 1 / its distance along the view axis.
uvec4 shape_texel(water_shape s, vec2 position, float axis) {
    vec2 offset = (s.rest - position) * (OFFSET_SCALE * axis);
    float spacing = clamp((s.spacing - SPACING_FIRST) * SPACING_STEPS + 0.5, 0.0, 1023.0);
    uint rough = uint(spacing) << 14 | squeezed_code(s.depth / DEPTH_SCALE, DEPTH_STEPS);
    return uvec4(floatBitsToUint(axis),
                 squeezed_code(offset.x, REST_STEPS) << 12 | rough >> 12,
                 squeezed_code(offset.y, REST_STEPS) << 12 | (rough & 4095u),
                 squeezed_code(s.slope.x, SLOPE_STEPS) << 16 | squeezed_code(s.slope.y, SLOPE_STEPS));
}

float shape_depth(uvec4 texel) { return near_distance * uintBitsToFloat(texel.x); }

// position: by that depth.
water_shape shape_of(uvec4 texel, vec2 position) {
    water_shape s;
    s.rest = position + (1.0 / (OFFSET_SCALE * uintBitsToFloat(texel.x))) *
                            vec2(squeezed_value(texel.y >> 12, REST_STEPS), squeezed_value(texel.z >> 12, REST_STEPS));
    uint rough = (texel.y & 4095u) << 12 | (texel.z & 4095u);
    s.spacing = float(rough >> 14) / SPACING_STEPS + SPACING_FIRST;
    s.depth = DEPTH_SCALE * squeezed_value(rough & 16383u, DEPTH_STEPS);
    s.slope = vec2(squeezed_value(texel.w >> 16, SLOPE_STEPS), squeezed_value(texel.w & 65535u, SLOPE_STEPS));
    return s;
}

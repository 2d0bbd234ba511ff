// SPDX-License-Identifier: MIT
/// @file math.h
/// Tier 0. Vectors, matrices, angles; the axes and units of all headers.
///
/// @code
///          z up                      compass (heading):  0 = north (+y), 90 = east (+x), clockwise
///          |   y north               mathematical angle: 0 = east (+x), pi/2 = north (+y), counter-clockwise
///          |  /                      math = pi/2 - compass
///          | /                       a wind or sea is named by where it comes FROM (compass degrees);
///          |/_______ x east          a wave vector k points where the wave GOES (TO = FROM + 180)
/// @endcode
/// SI units throughout. World positions are double on the CPU. Matrices are column-major, column vectors, right-handed;
/// camera space is x right, y up, -z forward. Time is double seconds.
#ifndef BOLAN_MATH_H
#define BOLAN_MATH_H

#include "bolan/base.h"

#include <math.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/// Half a turn [rad].
#define BOLAN_PI 3.14159265358979323846
/// Acceleration of gravity [m/s2].
#define BOLAN_GRAVITY 9.81

/// Two floats.
typedef struct bolan_vec2 {
    float x, y;
} bolan_vec2;
/// Three floats: a direction, a colour, or a position near the eye.
typedef struct bolan_vec3 {
    float x, y, z;
} bolan_vec3;
/// Four floats; a homogeneous position where w is one.
typedef struct bolan_vec4 {
    float x, y, z, w;
} bolan_vec4;
/// A place on the map: x east, y north [m].
typedef struct bolan_dvec2 {
    double x, y;
} bolan_dvec2;
/// A place in the world: x east, y north, z up [m].
typedef struct bolan_dvec3 {
    double x, y, z;
} bolan_dvec3;
/// Column-major: m[4 * column + row].
typedef struct bolan_mat4 {
    float m[16];
} bolan_mat4;

static inline double bolan_radians(double degrees) { return degrees * (BOLAN_PI / 180.0); }
static inline double bolan_degrees(double radians) { return radians * (180.0 / BOLAN_PI); }
/// Returns @p degrees reduced to [0, 360).
BOLAN_API double bolan_wrap_degrees(double degrees);
/// Converts the compass direction that waves come FROM [deg] to the mathematical angle where they GO, [0, 2 pi) [rad].
BOLAN_API double bolan_compass_from_to_math(double from_degrees);
/// Converts the mathematical angle where waves GO [rad] to the compass direction they come FROM, [0, 360) [deg].
BOLAN_API double bolan_math_to_compass_from(double to_radians);

/// Sine and cosine of @p x [rad], |x| < 1e6, with an error below 2 ulp of 1.
/// The bits are the same with every machine, compiler and instruction set, because neither libm nor fused multiply-add
/// is used. Called wherever a result must be reproducible.
BOLAN_API void bolan_sincos(double x, double *sine, double *cosine);
/// The float twin of bolan_sincos(), as the wide kernels compute it: |x| <= 8192, error < 2e-7.
/// The bits are the same everywhere too.
BOLAN_API void bolan_sincosf(float x, float *sine, float *cosine);

static inline bolan_vec3 bolan_v3(float x, float y, float z) {
    bolan_vec3 v;
    v.x = x;
    v.y = y;
    v.z = z;
    return v;
}
static inline bolan_dvec3 bolan_dv3(double x, double y, double z) {
    bolan_dvec3 v;
    v.x = x;
    v.y = y;
    v.z = z;
    return v;
}
static inline bolan_vec3 bolan_v3_add(bolan_vec3 a, bolan_vec3 b) { return bolan_v3(a.x + b.x, a.y + b.y, a.z + b.z); }
static inline bolan_vec3 bolan_v3_sub(bolan_vec3 a, bolan_vec3 b) { return bolan_v3(a.x - b.x, a.y - b.y, a.z - b.z); }
static inline bolan_vec3 bolan_v3_scale(bolan_vec3 a, float s) { return bolan_v3(a.x * s, a.y * s, a.z * s); }
static inline float bolan_v3_dot(bolan_vec3 a, bolan_vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static inline bolan_vec3 bolan_v3_cross(bolan_vec3 a, bolan_vec3 b) {
    return bolan_v3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}
static inline float bolan_v3_length(bolan_vec3 a) { return sqrtf(bolan_v3_dot(a, a)); }
static inline bolan_vec3 bolan_v3_normalize(bolan_vec3 a) { return bolan_v3_scale(a, 1.0f / bolan_v3_length(a)); }

/// Returns the identity matrix.
BOLAN_API bolan_mat4 bolan_m4_identity(void);
/// Returns a * b: b is applied first.
BOLAN_API bolan_mat4 bolan_m4_mul(bolan_mat4 a, bolan_mat4 b);
/// Returns the transposed matrix, which is the inverse of a rotation.
BOLAN_API bolan_mat4 bolan_m4_transpose(bolan_mat4 a);
/// Returns the inverse of a regular matrix, computed in double.
BOLAN_API bolan_mat4 bolan_m4_inverse(bolan_mat4 a);
/// Returns a * v.
BOLAN_API bolan_vec4 bolan_m4_mul_v4(bolan_mat4 a, bolan_vec4 v);
/// Returns the rotation from world axes to camera axes.
/// Heading by compass, pitch up, roll clockwise, all in [deg].
BOLAN_API bolan_mat4 bolan_m4_view(double heading_deg, double pitch_deg, double roll_deg);
/// Returns a reversed-Z projection with an infinite far plane.
/// Depth is near / distance: 1 at the near plane, 0 at infinity.
/// @param fov_y vertical field of view [rad].
/// @param aspect width / height.
/// @param near_m distance of the near plane [m], > 0.
/// @param zero_to_one true: clip depth is [0, 1] (clip control). False: it is [-1, 1]; window depth is the same.
BOLAN_API bolan_mat4 bolan_m4_projection(double fov_y, double aspect, double near_m, int zero_to_one);

#ifdef __cplusplus
}
#endif
#endif

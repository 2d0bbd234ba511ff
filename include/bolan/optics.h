// SPDX-License-Identifier: MIT
/// @file optics.h
/// Tier 1. Light at the water: Jerlov's water types, Fresnel, reflection, refraction. Every function here is pure and
/// thread-safe.
#ifndef BOLAN_OPTICS_H
#define BOLAN_OPTICS_H

#include "bolan/base.h"
#include "bolan/math.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Jerlov's water types: five of the ocean, from the clearest, and five of the coast, to the most turbid.
typedef enum bolan_jerlov {
    BOLAN_JERLOV_I,
    BOLAN_JERLOV_IA,
    BOLAN_JERLOV_IB,
    BOLAN_JERLOV_II,
    BOLAN_JERLOV_III,
    BOLAN_JERLOV_1C,
    BOLAN_JERLOV_3C,
    BOLAN_JERLOV_5C,
    BOLAN_JERLOV_7C,
    BOLAN_JERLOV_9C,
} bolan_jerlov;
/// How many there are.
#define BOLAN_JERLOV_TYPES 10
/// "I", "IA" ... "9C"; by bolan_jerlov, NULL at the end.
extern const char *const bolan_jerlov_names[BOLAN_JERLOV_TYPES + 1];

/// Optical coefficients at red, green, blue = 650, 550, 450 nm. They fit together: kd = (absorption + backscatter) /
/// 0.9 within 7 %, and absorption is never below that of pure water.
typedef struct bolan_water_optics {
    bolan_vec3 kd;          ///< diffuse attenuation of downward irradiance [1/m]
    bolan_vec3 absorption;  ///< a [1/m]
    bolan_vec3 scattering;  ///< b [1/m]
    bolan_vec3 backscatter; ///< bb [1/m]
    bolan_vec3 deep;        ///< radiance leaving deep water (above it) per unit downward irradiance, Rrs [1/sr]
    float index;            ///< of refraction; 1.34
} bolan_water_optics;
/// Jerlov's types by Kd (Austin & Petzold 1986 for I..1C, Jerlov 1976 for 3C..9C), pure water by Pope & Fry 1997 and
/// Morel 1974, particles after Gordon & Morel 1983, Rrs by Gordon et al. 1988. I is the clearest ocean, 9C a muddy
/// estuary.
bolan_water_optics bolan_water_optics_from_jerlov(bolan_jerlov type);
/// "I", "IA", "IB", "II", "III", "1C", "3C", "5C", "7C", "9C", in any case; -1 when unknown. And back; static storage.
int bolan_jerlov_from_name(const char *name);
/// The name of a type, "IB". Static storage.
const char *bolan_jerlov_name(bolan_jerlov type);

/// Fresnel reflectance of unpolarised light, exact dielectric. @p cos_incident 0..1; @p eta = n_transmitted /
/// n_incident (1.34 from air into the sea, 1/1.34 from below: total reflection included).
float bolan_fresnel(float cos_incident, float eta);

/// The direction a mirror with unit normal @p n sends the direction @p i to, which points towards the mirror: i - 2 n (n . i).
/// Ma, Zhu & Gong 2006, eq. 1, with its sign put right.
bolan_vec3 bolan_reflect(bolan_vec3 i, bolan_vec3 n);
/// Apparent depth over depth of what lies in water of index @p index > 1, seen from the air at @p theta [rad] from the vertical,
/// 0..pi/2: cos theta / sqrt(index^2 - sin^2 theta). Ma, Zhu & Gong 2006, eq. 7 (there with index 1.333).
double bolan_refraction_k(double theta, double index);
/// The paper's two straight lines for it, its eq. 8: 0.75 - 0.16 theta up to 0.8 rad, 1.26 - 0.8 theta beyond. At most 0.037 from
/// eq. 7 on the first, 0.081 on the second, and 22 % off near the horizon.
double bolan_refraction_k_paper(double theta);
/// Fermat's path from an eye @p height > 0 over the water to a point @p depth >= 0 under it, @p distance >= 0 aside [m]: where it
/// crosses the surface, from the eye [m]. Newton's method on the tangent of the angle in the air, which comes from below without overshooting;
/// the shaders do four steps of it.
double bolan_refraction_crossing(double height, double depth, double distance, double index);
/// How deep that point seems to lie, straight above where it is [m]: depth times eq. 7 at the angle of the path.
double bolan_apparent_depth(double height, double depth, double distance, double index);

#ifdef __cplusplus
}
#endif
#endif

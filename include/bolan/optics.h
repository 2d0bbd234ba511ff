// SPDX-License-Identifier: MIT
/// @file optics.h
/// Tier 1. Light at the water: Jerlov's water types, Fresnel, reflection, refraction.
/// Every function here is pure and thread-safe.
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
/// Number of water types.
#define BOLAN_JERLOV_TYPES 10
/// "I", "IA" ... "9C"; by bolan_jerlov, NULL at the end.
BOLAN_API extern const char *const bolan_jerlov_names[BOLAN_JERLOV_TYPES + 1];

/// Optical coefficients at red, green, blue = 650, 550, 450 nm.
/// They are consistent: kd = (absorption + backscatter) / 0.9 within 7 %.
/// Absorption is never below that of pure water.
typedef struct bolan_water_optics {
    /// Diffuse attenuation of downward irradiance, Kd [1/m].
    bolan_vec3 kd;
    /// Absorption a [1/m].
    bolan_vec3 absorption;
    /// Scattering b [1/m].
    bolan_vec3 scattering;
    /// Backscattering bb [1/m].
    bolan_vec3 backscatter;
    /// Radiance that leaves deep water, above the surface, per unit downward irradiance: Rrs [1/sr].
    bolan_vec3 deep;
    /// Refractive index; 1.34.
    float index;
} bolan_water_optics;

/// The coefficients of a water type; I is the clearest ocean, 9C a muddy estuary.
/// Sources:
/// - Kd: Austin & Petzold 1986 (I..1C), Jerlov 1976 (3C..9C);
/// - pure water: Pope & Fry 1997, Morel 1974;
/// - particles: after Gordon & Morel 1983;
/// - Rrs: Gordon et al. 1988.
BOLAN_API bolan_water_optics bolan_water_optics_from_jerlov(bolan_jerlov type);

/// The type of a name ("I", "IA", "IB", "II", "III", "1C", "3C", "5C", "7C", "9C", in any case); -1 when unknown.
BOLAN_API int bolan_jerlov_from_name(const char *name);
/// The name of a type, "IB".
/// Static storage.
BOLAN_API const char *bolan_jerlov_name(bolan_jerlov type);

/// Fresnel reflectance of a dielectric for unpolarised light, exact.
/// @param cos_incident 0..1.
/// @param eta n_transmitted / n_incident: 1.34 from air into the sea, 1/1.34 from below.
/// Total reflection is included.
BOLAN_API float bolan_fresnel(float cos_incident, float eta);

/// The reflection i - 2 n (n . i) of a direction at a mirror.
/// @param i direction that points towards the mirror.
/// @param n unit normal of the mirror.
/// Source: Ma, Zhu & Gong 2006, eq. 1, with its sign corrected.
BOLAN_API bolan_vec3 bolan_reflect(bolan_vec3 i, bolan_vec3 n);

/// Apparent depth over depth of a point in water, seen from the air: cos theta / sqrt(index^2 - sin^2 theta).
/// @param theta angle of the ray in the air from the vertical [rad], 0..pi/2.
/// @param index refractive index, > 1.
/// Source: Ma, Zhu & Gong 2006, eq. 7 (with index 1.333).
BOLAN_API double bolan_refraction_k(double theta, double index);

/// The paper's approximation of bolan_refraction_k() by two straight lines, its eq. 8.
/// 0.75 - 0.16 theta up to 0.8 rad, 1.26 - 0.8 theta beyond.
/// It differs from eq. 7 by at most 0.037 on the first line and 0.081 on the second, and by 22 % near the horizon.
BOLAN_API double bolan_refraction_k_paper(double theta);

/// Distance from the eye, in plan, at which the refracted path to a point under water crosses the surface [m].
/// The path is that of least time (Fermat).
/// Solved by Newton's method on the tangent of the angle in the air, which rises to the root without overshooting.
/// The shaders do four steps of it.
/// @param height of the eye over the water [m], > 0.
/// @param depth of the point under the water [m], >= 0.
/// @param distance of the point in plan [m], >= 0.
BOLAN_API double bolan_refraction_crossing(double height, double depth, double distance, double index);

/// Apparent depth of the point of bolan_refraction_crossing(), vertically above its place [m].
/// It is the depth times bolan_refraction_k() at the angle of the path.
BOLAN_API double bolan_apparent_depth(double height, double depth, double distance, double index);

#ifdef __cplusplus
}
#endif
#endif

// SPDX-License-Identifier: MIT
// The ground between the nodes of the data: octaves from twice the spacing down to a metre.
//
// A hillside is shaped by water, so its detail is not isotropic: ridges and gullies run downhill and branch. Each
// octave adds directed noise across the slope that the coarser octaves have built, which makes smaller gullies run into
// larger ones; where the ground is flat there is only a little isotropic noise. Amplitudes go with the slope of the
// data: a coastline is moved sideways by amplitude / slope, so a gentle and a steep coast become equally ragged.
#include "ground/ground.h"
#include "ground/noise.h"

#define SHORTEST_WAVELENGTH 1.0 // [m]
#define MOST_OCTAVES 25         // from twice the coarsest step, 2e7 m, to a metre
#define FAINT 0.003f            // amplitude per wavelength below which short octaves are skipped
#define GULLY_SHORTEST 12.0     // below this there is rubble, not drainage [m]

// Amplitude per wavelength of a gully on a slope: its flanks are about as steep as the hillside, up to a limit.
static float gully_depth(float slope) { return 0.22f * slope / (0.35f + slope); }

// Long waves make relief, short ones only roughness.
static float roll_off(double wavelength) { return (float)(0.24 + 0.76 * wavelength / (wavelength + 400.0)); }

// Roughness of the ground by height and slope: the sea bed is smoother, and a beach is smooth.
static float roughness(float z, float slope) {
    float bed = 1.0f - 0.6f * smoothstepf(0.0f, 1.0f, clamp01((-2.0f - z) / 40.0f));
    float shoreline = smoothstepf(-3.0f, 0.0f, z) * (1.0f - smoothstepf(2.5f, 6.0f, z));
    float beach = shoreline * (1.0f - smoothstepf(0.12f, 0.3f, slope));
    return bed * (1.0f - 0.85f * beach);
}

float bolan_detail_bound(const bolan_ground *t) {
    // Amplitudes fall nearly with the wavelength: the sum over octaves is at most twice the first.
    return (float)(t->detail * 0.5 * t->detail_wavelength * roll_off(t->detail_wavelength));
}

float bolan_detail_octave(const detail_lattice *o, float slope, float gully, float rubble, float *dx, float *dy) {
    float height = 0.0f, gx = 0.0f, gy = 0.0f;
    float total = sqrtf(*dx * *dx + *dy * *dy);
    if (gully > 0.0f && total > 1e-4f) {
        float ax = -*dy / total, ay = *dx / total; // level direction
        noise_value n = directed_noise(o->x, o->y, o->c * ax - o->s * ay, o->s * ax + o->c * ay, o->seed);
        // Sharp crests between rounded beds, half and half with the wave itself.
        float fold = sqrtf(n.v * n.v + 0.03f);
        // Where the ground levels off, the downhill direction turns abruptly: gullies fade out before.
        float k = gully * o->wavelength * smoothstepf(0.0f, 0.9f * slope + 0.05f, total);
        height += k * (0.45f * n.v + 0.9f * (0.6f - fold));
        float slope_of_fold = 0.45f - 0.9f * n.v / fold;
        gx += k * slope_of_fold * n.dx, gy += k * slope_of_fold * n.dy;
    }
    if (rubble <= 0.0f) {
        return height;
    }
    noise_value n = gradient_noise(o->x + 0.5, o->y + 0.5, o->seed + 1u);
    height += rubble * o->wavelength * n.v;
    gx += rubble * o->wavelength * n.dx, gy += rubble * o->wavelength * n.dy;
    // Lattice -> world.
    *dx += (o->c * gx + o->s * gy) / o->wavelength;
    *dy += (-o->s * gx + o->c * gy) / o->wavelength;
    return height;
}

// A coast is not a plane through the waterline: mostly a beach flattens it, in places the land breaks off.
static float coast_profile(const bolan_ground *t, float z, float slope, double x, double y, float strength) {
    if (z < -12.0f || z > 12.0f || t->step < 50.0) { // a fine grid resolves the coast
        return z;
    }
    float sandy = smoothstepf(-0.25f, 0.15f, gradient_noise(x / 900.0, y / 900.0, t->seed + 91u).v) *
                  (1.0f - smoothstepf(0.15f, 0.4f, slope));
    float near_shore = 1.0f - smoothstepf(0.0f, 12.0f, fabsf(z));
    return z * (1.0f - 0.65f * strength * sandy * near_shore);
}

float bolan_detail_apply(const bolan_ground *t, surface_point base, double x, double y, double resolution,
                         float inside) {
    float strength = (float)t->detail * inside;
    if (strength <= 0.0f || t->detail_wavelength <= 2.0 * resolution) {
        return base.z;
    }
    float z = base.z, dx = base.dx, dy = base.dy;
    float slope = sqrtf(dx * dx + dy * dy);
    float rough = strength * roughness(z, slope);
    detail_lattice o = {0.0, 0.0, 1.0f, 0.0f, 0.0f, t->seed};
    double c = 1.0, s = 0.0, wavelength = t->detail_wavelength;
    for (int n = 0; n < MOST_OCTAVES && wavelength >= SHORTEST_WAVELENGTH; n++, wavelength *= 0.5) {
        float band = resolution > 0.0 ? smoothstepf(2.0f, 4.0f, (float)fmin(wavelength / resolution, 8.0)) : 1.0f;
        if (band <= 0.0f) {
            break;
        }
        o.wavelength = (float)wavelength;
        o.x = (c * x - s * y) / wavelength, o.y = (s * x + c * y) / wavelength;
        o.c = (float)c, o.s = (float)s;
        float k = band * rough * roll_off(wavelength);
        float faint = FAINT * 50.0f / (o.wavelength + 50.0f); // beaches and lagoons skip the octave
        float gully = wavelength >= GULLY_SHORTEST ? fmaxf(k * gully_depth(slope) - faint, 0.0f) : 0.0f;
        float rubble = fmaxf(k * (0.004f + 0.16f * slope / (0.5f + slope)) - faint, 0.0f);
        z += bolan_detail_octave(&o, slope, gully, rubble, &dx, &dy);
        o.seed += 0x9e3779b9u;
        double turned = 0.8 * c - 0.6 * s;
        s = 0.6 * c + 0.8 * s, c = turned;
    }
    return coast_profile(t, z, slope, x, y, strength);
}

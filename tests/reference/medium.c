// SPDX-License-Identifier: MIT
// The water: coefficients and sources of common/below_medium.glsl, which are not checked here; and a level bed, whose
// sunlight is that of the photons (photons.c).
#include "shared/bed.glsl"
#include "shared/fournier_forand.glsl"
#include "shared/refraction.glsl"
#include "tracer.h"

#include <stdio.h>

#define IMAGE_BLUR 5.0 // [deg]

// ---- the water ------------------------------------------------------------------------------------------------------

// Exponent of the phase function that scatters this share back, in the model's range.
static double exponent_of(double share) {
    double low = 3.05, high = 4.9;
    while (high - low > 1e-7) {
        const double m = 0.5 * (low + high), back = 1.0 - fournier_forand_within(0.0, fournier_forand_index(m), m);
        *(back < share ? &low : &high) = m;
    }
    return low;
}

void medium_open(tracer *t) {
    const bolan_water_optics *o = &t->water->optics;
    const double down = refracted_cosine(t->sun.z, WATER_INDEX), passes = 1.0 - fresnel(t->sun.z, WATER_INDEX);
    medium *m = &t->medium;
    m->blur_cosine = cos(bolan_radians(IMAGE_BLUR));
    m->pattern = 0.5 * channel_of(o->scattering, 1) / down;
    m->sun = (vec){t->sun.x / WATER_INDEX, t->sun.y / WATER_INDEX, down};
    for (int c = 0; c < 3; ++c) {
        const double b = channel_of(o->scattering, c), sun = channel_of(t->light.sun_irradiance, c) * t->sun.z * passes;
        const double e = exponent_of(channel_of(o->backscatter, c) / b);
        m->kd[c] = channel_of(o->kd, c), m->exponent[c] = e;
        m->wide[c] = b * (1.0 - fournier_forand_within(m->blur_cosine, fournier_forand_index(e), e));
        m->beam[c] = channel_of(o->absorption, c) + m->wide[c];
        m->field[c] = channel_of(o->deep, c) / BED_LEAVES * (m->beam[c] + m->kd[c]);
        m->entering[c] = sun + channel_of(t->light.sky_irradiance, c) * SKY_ENTERS;
        m->sunny[c] = sun / down;
    }
}

// Integral of exp(-k x) from 0 to `reach`.
static double path_of(double k, double reach) { return fabs(k * reach) < 1e-9 ? reach : -expm1(-k * reach) / k; }

static double phase_of(const medium *m, vec dir, int k) {
    const double cosine = fmin(dot3(dir, m->sun), m->blur_cosine), e = m->exponent[k], n = fournier_forand_index(e);
    return fmax(fournier_forand(cosine, n, e) - fournier_forand(-1.0, n, e), 0.0);
}

static double field_veil(const medium *m, double depth, vec dir, double reach, int k) {
    return m->field[k] * m->entering[k] * exp(-m->kd[k] * depth) * path_of(m->beam[k] - m->kd[k] * dir.z, reach);
}

double water_veil(const tracer *t, double depth, vec dir, double reach, int c) {
    const medium *m = &t->medium;
    const int k = color_of(c);
    const double beam = m->beam[k], down = beam / m->sun.z, d = fmax(depth, 0.0);
    return field_veil(m, d, dir, reach, k) +
           m->wide[k] * m->sunny[k] * phase_of(m, dir, k) * exp(-down * d) * path_of(beam - down * dir.z, reach);
}

// Sunlight at a place as a share of flat water's: what is scattered leaves the pattern.
static double pattern_at(const tracer *t, vec at) {
    return 1.0 + (gathered_at(&t->photons, at) - 1.0) * exp(-t->medium.pattern * fmax(-at.z, 0.0));
}

#define SHAFTS 20.0 // as far as they are added up [m]
enum { SHAFT_STEPS = 80 };

void shaft_veil(tracer *t, vec from, vec dir, double reach, double out[LIGHT]) {
    const medium *m = &t->medium;
    const double step = fmin(reach, SHAFTS) / SHAFT_STEPS;
    double more[SHAFT_STEPS], depth[SHAFT_STEPS], far[SHAFT_STEPS];
    for (int i = 0; i < SHAFT_STEPS; ++i) {
        far[i] = step * (i + uniform(&t->random));
        const vec at = along(from, far[i], dir);
        more[i] = pattern_at(t, at) - 1.0, depth[i] = fmax(-at.z, 0.0);
    }
    for (int k = 0; k < 3; ++k) {
        const double beam = m->beam[k], down = beam / m->sun.z;
        double sum = 0.0;
        for (int i = 0; i < SHAFT_STEPS; ++i) sum += step * more[i] * exp(-beam * far[i] - down * depth[i]);
        out[k] = water_veil(t, -from.z, dir, reach, k) + m->wide[k] * m->sunny[k] * phase_of(m, dir, k) * sum;
    }
    out[SUNLESS] = out[1];
}

// ---- the bed --------------------------------------------------------------------------------------------------------

#define SIDE 30.0 // of the square of bed that the sky is measured from [m]

double bed_radiance(const tracer *t, double x, double y, int c) {
    const sea_bed *b = &t->bed;
    const int k = color_of(c);
    const double left = exp(-t->medium.kd[k] * b->depth), sun = channel_of(t->light.sun_irradiance, k) * b->sun;
    const double again = REFERENCE_ALBEDO * b->again * left * left * b->irradiance[k];
    const double first = left * (b->sky[k] + sun * pattern_at(t, (vec){x, y, -b->depth}));
    return REFERENCE_ALBEDO / 3.141592653589793 * (first + again);
}

// Rays from the bed, evenly over what a level plane receives.
static void see_sky(tracer *t, uint32_t count) {
    sea_bed *b = &t->bed;
    ray *rays = malloc(sizeof(ray) * count);
    place *places = malloc(sizeof(place) * count);
    for (uint32_t i = 0; i < count; ++i) {
        const double r = sqrt(uniform(&t->random)), a = 6.283185307179586 * uniform(&t->random);
        const double x = SIDE * (uniform(&t->random) - 0.5), y = SIDE * (uniform(&t->random) - 0.5);
        rays[i] = (ray){.from = {x, y, -b->depth}, .dir = {r * cos(a), r * sin(a), sqrt(fmax(1.0 - r * r, 1e-4))}};
    }
    march(t, rays, count, -1);
    places_of(t, rays, count, places);
    for (uint32_t i = 0; i < count; ++i) {
        facet f = facet_under(t, &places[i], rays[i].dir);
        const double through = WATER_INDEX * WATER_INDEX * (1.0 - f.reflectance);
        b->again += f.reflectance / count;
        f.air.z = fabs(f.air.z);
        for (int c = 0; c < 3; ++c) b->sky[c] += 3.141592653589793 / count * through * sky_in(t, f.air, c);
    }
    free(rays), free(places);
}

void bed_open(tracer *t, double depth, uint32_t most) {
    sea_bed *b = &t->bed;
    if (depth == 0.0) return;
    b->depth = depth;
    b->sun = t->sun.z * (1.0 - fresnel(t->sun.z, WATER_INDEX));
    see_sky(t, most);
    const double mean = gathered_mean(&t->photons);
    for (int c = 0; c < 3; ++c) {
        const double left = exp(-t->medium.kd[c] * depth), sun = channel_of(t->light.sun_irradiance, c) * b->sun * mean;
        b->irradiance[c] = left * (b->sky[c] + sun) / (1.0 - REFERENCE_ALBEDO * b->again * left * left);
    }
    printf("bed: sunlight %.3f of flat water's; sky %.3f %.3f %.3f of what falls on it; reflected again %.3f\n", mean,
           b->sky[0] / channel_of(t->light.sky_irradiance, 0), b->sky[1] / channel_of(t->light.sky_irradiance, 1),
           b->sky[2] / channel_of(t->light.sky_irradiance, 2), b->again);
}

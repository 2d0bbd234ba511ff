// SPDX-License-Identifier: MIT
// The water: coefficients and sources of common/below_medium.glsl, which are not checked here; and a level bed, whose
// sunlight is that of photons that waves have turned.
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

double water_veil(const tracer *t, double depth, vec dir, double reach, int c) {
    const medium *m = &t->medium;
    const int k = color_of(c);
    const double beam = m->beam[k], down = beam / m->sun.z, d = fmax(depth, 0.0);
    const double cosine = fmin(dot3(dir, m->sun), m->blur_cosine), e = m->exponent[k], n = fournier_forand_index(e);
    const double phase = fmax(fournier_forand(cosine, n, e) - fournier_forand(-1.0, n, e), 0.0);
    return m->field[k] * m->entering[k] * exp(-m->kd[k] * d) * path_of(beam - m->kd[k] * dir.z, reach) +
           m->wide[k] * m->sunny[k] * phase * exp(-down * d) * path_of(beam - down * dir.z, reach);
}

// ---- the bed --------------------------------------------------------------------------------------------------------

enum { CELLS = 800, PHOTONS_A_CELL = 64 };
#define SIDE 32.0  // of the cells' square, whose middle is AHEAD of the eye [m]
#define AHEAD 8.0  // [m]
#define MARGIN 2.0 // by which waves turn photons aside [m]

double bed_radiance(const tracer *t, double x, double y, int c) {
    const sea_bed *b = &t->bed;
    const double u = (x - b->west) / SIDE * CELLS - 0.5, v = (y - b->south) / SIDE * CELLS - 0.5;
    const int k = color_of(c), i = (int)floor(u), j = (int)floor(v);
    double gathered = 1.0;
    if (i >= 0 && j >= 0 && i + 1 < CELLS && j + 1 < CELLS) {
        const double a = u - i, f = v - j;
        const float *g = &b->gathered[j * CELLS + i];
        gathered = (1 - f) * ((1 - a) * (double)g[0] + a * (double)g[1]) +
                   f * ((1 - a) * (double)g[CELLS] + a * (double)g[CELLS + 1]);
    }
    const double left = exp(-t->medium.kd[k] * b->depth), sun = channel_of(t->light.sun_irradiance, k) * b->sun;
    const double pattern = 1.0 + (gathered - 1.0) * exp(-t->medium.pattern * b->depth);
    const double again = REFERENCE_ALBEDO * b->again * left * left * b->irradiance[k];
    return REFERENCE_ALBEDO / 3.141592653589793 * (left * (b->sky[k] + sun * pattern) + again);
}

// Where a photon that enters at a place lands, and the light that it carries.
static double send_photon(tracer *t, const place *p, vec *lands) {
    const double r = 0.00465 * sqrt(uniform(&t->random)), a = 6.283185307179586 * uniform(&t->random);
    double sx, sy;
    gaussian_slope(&t->random, t->beyond, &sx, &sy);
    const vec n = normal_of(p->sx + sx, p->sy + sy);
    const vec to_sun = unit(along(t->sun, r, (vec){cos(a), sin(a), 0.0})); // a disc on a level plane, near enough
    const double cosine = dot3(n, to_sun);
    if (cosine <= 0.0) return 0.0;
    const vec d = refracted(to_sun, n, WATER_INDEX);
    *lands = along(p->at, (p->at.z + t->bed.depth) / -d.z, d);
    return cosine / n.z * (1.0 - fresnel(fmin(cosine, 1.0), WATER_INDEX));
}

// Adds the photons that enter at `n` places.
static void send_photons(tracer *t, uint32_t n, double share) {
    sea_bed *b = &t->bed;
    bolan_query_surface(t->water, t->xy, n, t->points);
    for (uint32_t i = 0; i < n; ++i) {
        const place p = place_at(t, &t->points[i], t->xy[i]);
        vec lands = p.at;
        const double light = send_photon(t, &p, &lands);
        const int x = (int)floor((lands.x - b->west) / SIDE * CELLS),
                  y = (int)floor((lands.y - b->south) / SIDE * CELLS);
        if (x >= 0 && y >= 0 && x < CELLS && y < CELLS) b->gathered[y * CELLS + x] += (float)(light * share);
    }
}

// Photons enter the surface at even distances, each at a random place of its square.
static void gather(tracer *t, uint32_t most) {
    sea_bed *b = &t->bed;
    const double step = SIDE / CELLS / sqrt(PHOTONS_A_CELL), share = 1.0 / PHOTONS_A_CELL / b->sun;
    const double travel = b->depth / t->medium.sun.z;
    const double west = b->west + travel * t->medium.sun.x - MARGIN,
                 south = b->south + travel * t->medium.sun.y - MARGIN;
    const uint32_t side = (uint32_t)ceil((SIDE + 2.0 * MARGIN) / step);
    for (uint64_t first = 0; first < (uint64_t)side * side; first += most) {
        const uint64_t left = (uint64_t)side * side - first;
        const uint32_t n = left < most ? (uint32_t)left : most;
        for (uint32_t i = 0; i < n; ++i) {
            const uint64_t k = first + i;
            t->xy[i].x = west + step * ((double)(k % side) + uniform(&t->random));
            t->xy[i].y = south + step * ((double)(k / side) + uniform(&t->random));
        }
        send_photons(t, n, share);
    }
}

// Rays from the bed, evenly over what a level plane receives.
static void see_sky(tracer *t, uint32_t count) {
    sea_bed *b = &t->bed;
    ray *rays = malloc(sizeof(ray) * count);
    place *places = malloc(sizeof(place) * count);
    for (uint32_t i = 0; i < count; ++i) {
        const double r = sqrt(uniform(&t->random)), a = 6.283185307179586 * uniform(&t->random);
        const double x = b->west + SIDE * uniform(&t->random), y = b->south + SIDE * uniform(&t->random);
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

void bed_open(tracer *t, double depth, double heading, uint32_t most) {
    sea_bed *b = &t->bed;
    if (depth == 0.0) return;
    b->depth = depth;
    b->gathered = calloc(CELLS * CELLS, sizeof *b->gathered);
    b->west = AHEAD * sin(bolan_radians(heading)) - 0.5 * SIDE;
    b->south = AHEAD * cos(bolan_radians(heading)) - 0.5 * SIDE;
    b->sun = t->sun.z * (1.0 - fresnel(t->sun.z, WATER_INDEX));
    gather(t, most);
    see_sky(t, most);
    double mean = 0.0;
    for (int i = 0; i < CELLS * CELLS; ++i) mean += (double)b->gathered[i] / (CELLS * CELLS);
    for (int c = 0; c < 3; ++c) {
        const double left = exp(-t->medium.kd[c] * depth), sun = channel_of(t->light.sun_irradiance, c) * b->sun * mean;
        b->irradiance[c] = left * (b->sky[c] + sun) / (1.0 - REFERENCE_ALBEDO * b->again * left * left);
    }
    printf("bed: sunlight %.3f of flat water's; sky %.3f %.3f %.3f of what falls on it; reflected again %.3f\n", mean,
           b->sky[0] / channel_of(t->light.sky_irradiance, 0), b->sky[1] / channel_of(t->light.sky_irradiance, 1),
           b->sky[2] / channel_of(t->light.sky_irradiance, 2), b->again);
}

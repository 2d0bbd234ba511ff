// SPDX-License-Identifier: MIT
// Light for an eye in the water:
//
//   the surface from below -> a visible facet -> the air: sky, or the sea again
//                                             -> the sun, unless a wave stands before it
//                                             -> the water: bed, or the surface again
//   bed, or the water alone
#include "tracer.h"

#define DISC 0.00465 // radius of the sun [rad]

// How far a ray in the water goes that does not meet the surface.
static double reach_of(const tracer *t, vec from, vec dir) {
    return t->bed.depth == 0.0 || dir.z > -1e-3 ? t->farthest : (from.z + t->bed.depth) / -dir.z;
}

// Of the bed where such a ray meets it, 0 in deep water: its radiance at the ray's beginning.
static double bed_along(const tracer *t, vec from, vec dir, double reach, int c) {
    const vec lands = along(from, reach, dir);
    if (reach == t->farthest) return 0.0;
    return bed_radiance(t, lands.x, lands.y, c) * exp(-t->medium.beam[color_of(c)] * reach);
}

// Radiance along it.
static double in_water(const tracer *t, vec from, vec dir, int c) {
    if (t->furnace) return WATER_INDEX * WATER_INDEX;
    const double reach = reach_of(t, from, dir);
    return bed_along(t, from, dir, reach, c) + water_veil(t, -from.z, dir, reach, c);
}

static vec turned(vec v) { return (vec){v.x, v.y, -v.z}; }

facet facet_under(tracer *t, const place *p, vec dir) {
    const vec to_eye = turned(back(dir)), n = visible_facet(&t->random, to_eye, -p->sx, -p->sy, t->beyond);
    const double cosine = fmin(fmax(dot3(n, to_eye), 0.0), 1.0);
    facet f = {.reflectance = fresnel(cosine, 1.0 / WATER_INDEX), .water = turned(mirrored(to_eye, n))};
    f.air = f.reflectance < 1.0 ? turned(refracted(to_eye, n, 1.0 / WATER_INDEX)) : (vec){0, 0, 1};
    return f;
}

// A ray of the sun's disc, and what of it a place turns into the ray that sees it.
static ray sun_ray(tracer *t, const place *p, vec dir, double *sun) {
    const double r = DISC * sqrt(uniform(&t->random)), a = 6.283185307179586 * uniform(&t->random);
    const vec side = unit((vec){t->sun.y, -t->sun.x, 0.0}), up = unit((vec){-t->sun.x, -t->sun.y, 0.0});
    const vec rise = along((vec){0, 0, hypot(t->sun.x, t->sun.y)}, t->sun.z, up);
    const vec to_sun = unit(along(along(t->sun, r * cos(a), side), r * sin(a), rise));
    *sun = t->furnace ? 0.0 : sun_through_facets(dir, to_sun, p->sx, p->sy, t->beyond);
    return (ray){.from = off_surface(p, 1), .dir = to_sun, .done = *sun < 1e-6};
}

// Radiance that the second place on a path within the water sends down.
static void second_under(tracer *t, const place *p, vec dir, double out[LIGHT]) {
    facet f = facet_under(t, p, dir);
    f.water.z = -fabs(f.water.z);
    f.air.z = fabs(f.air.z);
    for (int c = 0; c < LIGHT; ++c)
        out[c] = f.reflectance * in_water(t, p->at, f.water, c) +
                 (1.0 - f.reflectance) * WATER_INDEX * WATER_INDEX * sky_in(t, f.air, c);
}

// Adds the share `weight` of what rays find in the air; places: room.
static void add_air(tracer *t, ray *air, const double *reflectance, uint32_t count, place *places, double *out) {
    march(t, air, count, 1);
    places_of(t, air, count, places);
    for (uint32_t i = 0; i < count; ++i) {
        double light[LIGHT];
        if (air[i].hit) second_light(t, &places[i], back(air[i].dir), 0.0, light);
        for (int c = 0; c < LIGHT; ++c)
            out[LIGHT * i + (uint32_t)c] +=
                (1.0 - reflectance[i]) * WATER_INDEX * WATER_INDEX * (air[i].hit ? light[c] : sky_in(t, air[i].dir, c));
    }
}

static void add_water(tracer *t, ray *water, const double *reflectance, uint32_t count, place *places, double *out) {
    march(t, water, count, -1);
    places_of(t, water, count, places);
    for (uint32_t i = 0; i < count; ++i) {
        double light[LIGHT];
        if (water[i].hit) second_under(t, &places[i], water[i].dir, light);
        for (int c = 0; c < LIGHT; ++c)
            out[LIGHT * i + (uint32_t)c] +=
                reflectance[i] * (water[i].hit ? light[c] : in_water(t, water[i].from, water[i].dir, c));
    }
}

// Radiance of the surface at places that rays from below have hit.
static void surface_light(tracer *t, const ray *rays, const place *places, uint32_t count, const room *r, double *out) {
    for (uint32_t i = 0; i < count; ++i) r->suns[i] = sun_ray(t, &places[i], rays[i].dir, &r->sun[i]);
    shadow(t, r->suns, count, r->sun);
    for (uint32_t i = 0; i < count; ++i) {
        const facet f = facet_under(t, &places[i], rays[i].dir);
        r->reflectance[i] = f.reflectance;
        r->second[i] = (ray){.from = off_surface(&places[i], 1), .dir = f.air, .done = f.reflectance == 1.0};
        r->suns[i] = (ray){.from = off_surface(&places[i], -1), .dir = f.water};
        for (int c = 0; c < LIGHT; ++c)
            out[LIGHT * i + (uint32_t)c] = c == SUNLESS ? 0.0 : r->sun[i] * channel_of(t->light.sun_irradiance, c);
    }
    add_air(t, r->second, r->reflectance, count, r->again, out);
    add_water(t, r->suns, r->reflectance, count, r->again, out);
}

void shade_under(tracer *t, const ray *rays, const place *places, uint32_t count, const room *r, double *out) {
    surface_light(t, rays, places, count, r, out);
    for (uint32_t i = 0; i < count; ++i) {
        const vec from = rays[i].from, dir = rays[i].dir;
        const double reach = rays[i].hit ? rays[i].t : reach_of(t, from, dir);
        double veil[LIGHT] = {0}, *light = &out[LIGHT * i];
        if (!t->furnace) shaft_veil(t, from, dir, reach, veil);
        for (int c = 0; c < LIGHT; ++c) {
            const double left = t->furnace ? 1.0 : exp(-t->medium.beam[color_of(c)] * reach);
            if (rays[i].hit)
                light[c] = light[c] * left + veil[c];
            else
                light[c] = t->furnace ? WATER_INDEX * WATER_INDEX : bed_along(t, from, dir, reach, c) + veil[c];
        }
    }
}

// SPDX-License-Identifier: MIT
// Light of the sea for an eye in the air:
//
//   place on the sea -> a visible facet -> sky, or a second place -> a facet -> sky
//                    -> sun, unless a wave stands before it
//                    -> light that leaves the water, or the bed through it
#include "shared/bed.glsl"
#include "tracer.h"

double sky_in(const tracer *t, vec d, int channel) {
    if (t->furnace) return 1.0;
    channel = color_of(channel);
    double x = (atan2(d.x, d.y) / 6.283185307179586 + 0.5) * SKY_WIDTH - 0.5;
    double y = (0.5 - asin(fmin(fmax(d.z, 0.0), 1.0)) / 3.141592653589793) * SKY_HEIGHT - 0.5;
    y = fmin(fmax(y, 0.0), SKY_HEIGHT / 2 - 1);
    const double a = x - floor(x), b = y - floor(y);
    const int i = ((int)floor(x) + SKY_WIDTH) % SKY_WIDTH, i1 = (i + 1) % SKY_WIDTH, j = (int)y, j1 = j + 1;
    const float *s = t->sky + channel;
    return (1 - b) * ((1 - a) * (double)s[3 * (j * SKY_WIDTH + i)] + a * (double)s[3 * (j * SKY_WIDTH + i1)]) +
           b * ((1 - a) * (double)s[3 * (j1 * SKY_WIDTH + i)] + a * (double)s[3 * (j1 * SKY_WIDTH + i1)]);
}

static double below_in(const tracer *t, int c) { return t->furnace ? 1.0 : (&t->below.x)[color_of(c)]; }
static double sun_in(const tracer *t, int c) { return c == SUNLESS ? 0.0 : channel_of(t->light.sun_irradiance, c); }

// What a place reflects of the sun, if no wave stands between; the ray that finds out is marched by the caller.
static ray sun_ray(const tracer *t, const place *p, vec to_eye, double *sun) {
    ray r = {.from = off_surface(p, 1), .dir = t->sun};
    *sun = t->furnace ? 0.0 : sun_by_facets(to_eye, t->sun, p->sx, p->sy, t->beyond);
    r.done = *sun < 1e-6;
    return r;
}

void shadow(tracer *t, ray *suns, uint32_t count, double *sun) {
    march(t, suns, count, 1);
    for (uint32_t i = 0; i < count; ++i)
        if (suns[i].hit) sun[i] = 0.0;
}

// What comes out of the water through a facet of a place that lets all of it through, over index squared.
static double light_through(const tracer *t, const place *p, vec to_eye, vec normal, int c) {
    if (t->furnace || t->bed.depth == 0.0) return below_in(t, c);
    const vec d = refracted(to_eye, normal, WATER_INDEX);
    const double path = (p->at.z + t->bed.depth) / fmax(-d.z, 0.1), kd = t->medium.kd[color_of(c)];
    const vec lands = along(p->at, path, d);
    return bed_radiance(t, lands.x, lands.y, c) * exp(-kd * path) / (WATER_INDEX * WATER_INDEX) +
           below_in(t, c) * (1.0 - exp(-kd * (t->bed.depth + path)));
}

// Of one facet of a place: the ray it reflects, its reflectance, and the light it lets through.
static ray facet_ray(tracer *t, const place *p, vec to_eye, double *reflectance, double out[LIGHT]) {
    const vec n = visible_facet(&t->random, to_eye, p->sx, p->sy, t->beyond);
    *reflectance = fresnel(fmin(fmax(dot3(n, to_eye), 0.0), 1.0), WATER_INDEX);
    for (int c = 0; c < LIGHT; ++c) out[c] = (1.0 - *reflectance) * light_through(t, p, to_eye, n, c);
    return (ray){.from = off_surface(p, 1), .dir = mirrored(to_eye, n)};
}

void second_light(tracer *t, const place *p, vec to_eye, double sun, double out[LIGHT]) {
    double f;
    vec d = facet_ray(t, p, to_eye, &f, out).dir;
    d.z = fabs(d.z);
    for (int c = 0; c < LIGHT; ++c) out[c] += f * sky_in(t, d, c) + sun * sun_in(t, c);
}

void shade(tracer *t, const ray *hits, const place *places, uint32_t count, const room *r, double *out) {
    for (uint32_t i = 0; i < count; ++i) {
        const vec to_eye = back(hits[i].dir);
        r->second[i] = facet_ray(t, &places[i], to_eye, &r->reflectance[i], &out[LIGHT * i]);
        r->suns[i] = sun_ray(t, &places[i], to_eye, &r->sun[i]);
        const double order = facets_lit(to_eye, r->second[i].dir, places[i].sx, places[i].sy, t->beyond);
        r->second[i].hit = r->second[i].done = uniform(&t->random) > order; // by a facet of the same place
    }
    shadow(t, r->suns, count, r->sun);
    march(t, r->second, count, 1);
    places_of(t, r->second, count, r->again);
    for (uint32_t i = 0; i < count; ++i) {
        for (int c = 0; c < LIGHT; ++c) out[LIGHT * i + (uint32_t)c] += r->sun[i] * sun_in(t, c);
        r->suns[i] = sun_ray(t, &r->again[i], back(r->second[i].dir), &r->sun[i]);
        r->suns[i].done |= !r->second[i].hit;
    }
    shadow(t, r->suns, count, r->sun);
    for (uint32_t i = 0; i < count; ++i) {
        double light[LIGHT];
        const vec d = r->second[i].dir;
        if (r->second[i].hit) second_light(t, &r->again[i], back(d), r->sun[i], light);
        for (int c = 0; c < LIGHT; ++c)
            out[LIGHT * i + (uint32_t)c] += r->reflectance[i] * (r->second[i].hit ? light[c] : sky_in(t, d, c));
    }
}

// Irradiance under the surface, and the radiance that the water sends up, as light_below() of water_physical.glsl has
// them, with the sum over facets in place of its formula.
void light_the_water(tracer *t) {
    float total[3];
    double facing = 0.0, enters = 0.0;
    bolan_sea_unresolved_slopes(t->water->sea, 1e5, 1e5, 0.0, total);
    for (int i = 0; i < 100000; ++i) {
        double sx, sy;
        gaussian_slope(&t->random, (covariance){(double)total[0], (double)total[1], (double)total[2]}, &sx, &sy);
        const double area = fmax(t->sun.z - sx * t->sun.x - sy * t->sun.y, 0.0);
        facing += area;
        enters += area * (1.0 - fresnel(fmin(dot3(normal_of(sx, sy), t->sun), 1.0) * (area > 0.0), WATER_INDEX));
    }
    for (int c = 0; c < 3; ++c)
        (&t->below.x)[c] = channel_of(t->water->optics.deep, c) *
                           (channel_of(t->light.sun_irradiance, c) * fmax(t->sun.z, 0.0) * enters / facing +
                            channel_of(t->light.sky_irradiance, c) * SKY_ENTERS);
}

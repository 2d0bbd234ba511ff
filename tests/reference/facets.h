// SPDX-License-Identifier: MIT
// Vectors, random numbers, and the facets of rough water one by one: the part of the reference path tracer that closed
// forms check (tests/unit/test_reference_facets.c). No mean over facets is taken by formula here, except for the sun,
// whose disc a random ray hardly ever meets.
#ifndef BOLAN_REFERENCE_FACETS_H
#define BOLAN_REFERENCE_FACETS_H

#include "shared/fresnel.glsl"
#include "shared/microfacets.glsl"

#include <stdint.h>

#define WATER_INDEX 1.34
#define DISC_SLOPES 1.35e-6 // variance of the slopes that reflect the sun's disc, radius 0.00465 rad, to one point

typedef struct vec {
    double x, y, z;
} vec;
typedef struct covariance {
    double xx, xy, yy;
} covariance;

static inline double dot3(vec a, vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static inline vec along(vec a, double s, vec b) { return (vec){a.x + s * b.x, a.y + s * b.y, a.z + s * b.z}; }
static inline vec unit(vec a) {
    const double s = 1.0 / sqrt(dot3(a, a));
    return (vec){a.x * s, a.y * s, a.z * s};
}
static inline vec normal_of(double sx, double sy) { return unit((vec){-sx, -sy, 1.0}); }
static inline vec mirrored(vec to_eye, vec normal) {
    return along((vec){-to_eye.x, -to_eye.y, -to_eye.z}, 2.0 * dot3(to_eye, normal), normal);
}
// The ray that goes on from a facet, which meets it from the side of to_eye. eta: index beyond the facet over the index
// before it. Not for total reflection.
static inline vec refracted(vec to_eye, vec normal, double eta) {
    const double c = dot3(to_eye, normal), r = 1.0 / eta, k = 1.0 - r * r * (1.0 - c * c);
    return unit(along((vec){-r * to_eye.x, -r * to_eye.y, -r * to_eye.z}, r * c - sqrt(fmax(k, 0.0)), normal));
}

// PCG32, O'Neill 2014.
static inline double uniform(uint64_t *state) {
    const uint64_t s = *state;
    *state = s * 6364136223846793005u + 1442695040888963407u;
    const uint32_t x = (uint32_t)(((s >> 18) ^ s) >> 27), r = (uint32_t)(s >> 59);
    return ((x >> r | x << (-r & 31u)) + 0.5) * 0x1p-32;
}

static inline void gaussian_slope(uint64_t *random, covariance c, double *sx, double *sy) {
    const double r = sqrt(-2.0 * log(uniform(random))), a = 6.283185307179586 * uniform(random);
    const double x = r * cos(a), y = r * sin(a), l = sqrt(fmax(c.xx, 1e-12)), m = c.xy / l;
    *sx = l * x;
    *sy = m * x + sqrt(fmax(c.yy - m * m, 0.0)) * y;
}

// One of the facets that the eye sees over a place of slope (mx, my): each in proportion to the area that it shows.
// The first of several draws that a random share of the largest area accepts.
enum { DRAWS = 512 }; // of which one in ten is accepted where the eye is lowest
static inline vec visible_facet(uint64_t *random, vec to_eye, double mx, double my, covariance c) {
    const double x = to_eye.x, y = to_eye.y, spread = sqrt(c.xx * x * x + 2.0 * c.xy * x * y + c.yy * y * y);
    const double most = fmax(to_eye.z - mx * x - my * y, 0.0) + 4.0 * spread + 1e-9;
    vec n = normal_of(mx, my);
    for (int i = 0; i < DRAWS; ++i) {
        double sx, sy;
        gaussian_slope(random, c, &sx, &sy);
        sx += mx, sy += my;
        n = normal_of(sx, sy);
        if (to_eye.z - sx * to_eye.x - sy * to_eye.y > most * uniform(random)) break;
    }
    return n;
}

// Smith's ratio of the hidden to the visible share of the facets of covariance c over a place of that slope, seen from
// afar in a direction; many where the place itself is in the way. Walter et al. 2007.
static inline double facets_hidden(vec to, double mx, double my, covariance c) {
    const double level = fmax(hypot(to.x, to.y), 1e-6), hx = to.x / level, hy = to.y / level;
    const double deviation = sqrt(fmax(c.xx * hx * hx + 2.0 * c.xy * hx * hy + c.yy * hy * hy, 1e-9));
    const double elevation = to.z / level - mx * hx - my * hy;
    return elevation <= 0.0 ? 1e6 : smith_ratio(elevation / deviation);
}

// Share of the facets in sight of the eye which a light reaches too: heights of both sights correlate (Ross, Dion &
// Potvin 2005, eq. 19).
static inline double facets_lit(vec to_eye, vec to_light, double mx, double my, covariance c) {
    const double eye = fmin(facets_hidden(to_eye, mx, my, c), 1e3);
    return (1.0 + eye) / (1.0 + eye + facets_hidden(to_light, mx, my, c));
}

// Radiance of the reflected sun, for an irradiance of 1 across its rays, by the facets of covariance c over a place of
// that slope, unless another place stands between.
static inline double sun_by_facets(vec to_eye, vec to_sun, double mx, double my, covariance c) {
    const vec h = unit(along(to_eye, 1.0, to_sun));
    const double cosine = dot3(to_eye, h), level = fmax(hypot(to_eye.x, to_eye.y), 1e-4);
    if (h.z < 0.05 || cosine <= 0.0) return 0.0;
    c.xx += DISC_SLOPES, c.yy += DISC_SLOPES;
    const double ex = to_eye.x / level, ey = to_eye.y / level;
    const double deviation = level * sqrt(c.xx * ex * ex + 2.0 * c.xy * ex * ey + c.yy * ey * ey);
    const double facing = to_eye.z - mx * to_eye.x - my * to_eye.y;
    const double area = fmax(deviation * facing_exact(facing / deviation).area, 1e-3);
    const double density = slope_density(-h.x / h.z - mx, -h.y / h.z - my, c.xx, c.xy, c.yy);
    return density * fresnel(fmin(cosine, 1.0), WATER_INDEX) * facets_lit(to_eye, to_sun, mx, my, c) /
           (4.0 * h.z * h.z * h.z * h.z * area);
}

// Slope of the facet that turns a ray of the sun to a direction `to_sun` in the water.
static inline void slope_through(vec view, vec to_sun, double *sx, double *sy) {
    const vec h = along((vec){-to_sun.x, -to_sun.y, -to_sun.z}, WATER_INDEX, view);
    *sx = -h.x / h.z, *sy = -h.y / h.z;
}

// Radiance of the sun in the water along `view`, the way an eye in it looks, for an irradiance of 1 across its rays in
// the air, by the facets of covariance c over a place of that slope. The slopes that serve a solid angle of the eye are
// found by differences.
static inline double sun_through_facets(vec view, vec to_sun, double mx, double my, covariance c) {
    const double step = 1e-5, level = fmax(hypot(view.x, view.y), 1e-6);
    const vec across = {-view.y / level, view.x / level, 0.0};
    const vec up = {-view.x * view.z / level, -view.y * view.z / level, level};
    double sx, sy, ax, ay, ux, uy;
    slope_through(view, to_sun, &sx, &sy);
    const vec n = normal_of(sx, sy);
    const double cosine = dot3(n, to_sun), out = dot3(n, view);
    if (WATER_INDEX * view.z - to_sun.z < 0.02 || cosine <= 0.0 || out <= 0.0 || WATER_INDEX * out < cosine) return 0.0;
    slope_through(unit(along(view, step, across)), to_sun, &ax, &ay);
    slope_through(unit(along(view, step, up)), to_sun, &ux, &uy);
    const double solid = fabs((ax - sx) * (uy - sy) - (ay - sy) * (ux - sx)) / (step * step);
    const double ex = -view.x / level, ey = -view.y / level; // the facets shown from below lean the other way
    const double deviation = level * sqrt(fmax(c.xx * ex * ex + 2.0 * c.xy * ex * ey + c.yy * ey * ey, 1e-9));
    const double facing = view.z - mx * view.x - my * view.y;
    const double area = fmax(deviation * facing_exact(facing / deviation).area, 1e-3);
    return slope_density(sx - mx, sy - my, c.xx, c.xy, c.yy) * solid * (1.0 - fresnel(fmin(cosine, 1.0), WATER_INDEX)) *
           cosine / (n.z * area);
}

#endif

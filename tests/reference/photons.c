// SPDX-License-Identifier: MIT
// Sunlight in the water, over that of flat water: photons enter the surface at even distances, are turned by the facet
// that they meet, and are counted where they cross levels of the water. Cells lie where flat water's light entered, so
// that those of all levels belong to the same place of the surface.
#include "tracer.h"

enum { CELLS = 800, LEVELS = 24, PHOTONS_A_CELL = 64 };
#define SIDE 32.0    // of the cells' square, whose middle is AHEAD of the eye [m]
#define AHEAD 8.0    // [m]
#define MARGIN 2.0   // by which waves turn photons aside [m]
#define DISC 0.00465 // radius of the sun [rad]

static bool cell_of(const photons *p, vec at, double *u, double *v) {
    const double depth = -at.z;
    *u = (at.x - p->travel_x * depth - p->west) / SIDE * CELLS;
    *v = (at.y - p->travel_y * depth - p->south) / SIDE * CELLS;
    return *u >= 0.5 && *v >= 0.5 && *u < CELLS - 0.5 && *v < CELLS - 0.5;
}

// Of one level; 0: the surface.
static double at_level(const photons *p, int level, double u, double v) {
    if (level == 0) return 1.0;
    const int i = (int)(u - 0.5), j = (int)(v - 0.5);
    const double a = u - 0.5 - i, b = v - 0.5 - j;
    const float *g = &p->light[((size_t)(level - 1) * CELLS + (size_t)j) * CELLS + (size_t)i];
    return (1 - b) * ((1 - a) * (double)g[0] + a * (double)g[1]) +
           b * ((1 - a) * (double)g[CELLS] + a * (double)g[CELLS + 1]);
}

double gathered_at(const photons *p, vec at) {
    double u, v;
    const double level = fmin(fmax(-at.z / p->depth * LEVELS, 0.0), LEVELS);
    if (!cell_of(p, at, &u, &v)) return 1.0;
    const int above = (int)fmin(level, LEVELS - 1);
    return at_level(p, above, u, v) * (above + 1 - level) + at_level(p, above + 1, u, v) * (level - above);
}

double gathered_mean(const photons *p) {
    double sum = 0.0;
    for (int i = 0; i < CELLS * CELLS; ++i) sum += (double)p->light[(size_t)(LEVELS - 1) * CELLS * CELLS + (size_t)i];
    return sum / (CELLS * CELLS);
}

// The photon that enters at a place: its way, and its light over that of flat water.
static double photon_of(tracer *t, const place *p, vec *way) {
    const double r = DISC * sqrt(uniform(&t->random)), a = 6.283185307179586 * uniform(&t->random);
    double sx, sy;
    gaussian_slope(&t->random, t->beyond, &sx, &sy);
    const vec n = normal_of(p->sx + sx, p->sy + sy);
    const vec across = unit((vec){t->sun.y, -t->sun.x, 1e-9}), up = unit((vec){-t->sun.x, -t->sun.y, 1e-9});
    const vec rise = along((vec){0, 0, hypot(t->sun.x, t->sun.y)}, t->sun.z, up);
    const vec to_sun = unit(along(along(t->sun, r * cos(a), across), r * sin(a), rise));
    const double cosine = dot3(n, to_sun), flat = t->sun.z * (1.0 - fresnel(t->sun.z, WATER_INDEX));
    if (cosine <= 0.0) return 0.0;
    *way = refracted(to_sun, n, WATER_INDEX);
    return cosine / n.z * (1.0 - fresnel(fmin(cosine, 1.0), WATER_INDEX)) / flat;
}

// One photon in four is counted at all levels, each at the last.
static void count_photon(photons *p, const place *from, vec way, double light, bool everywhere) {
    for (int level = everywhere ? 1 : LEVELS; level <= LEVELS; ++level) {
        double u, v;
        const double depth = p->depth * level / LEVELS, share = level == LEVELS ? 1.0 : 4.0;
        const vec at = along(from->at, (from->at.z + depth) / -way.z, way);
        if (!cell_of(p, at, &u, &v)) continue;
        p->light[((size_t)(level - 1) * CELLS + (size_t)v) * CELLS + (size_t)u] +=
            (float)(light * share / PHOTONS_A_CELL);
    }
}

void photons_open(tracer *t, double depth, double heading, uint32_t most) {
    photons *p = &t->photons;
    const double step = SIDE / CELLS / sqrt(PHOTONS_A_CELL);
    const uint64_t side = (uint64_t)ceil((SIDE + 2.0 * MARGIN) / step);
    p->depth = depth;
    p->west = AHEAD * sin(bolan_radians(heading)) - 0.5 * SIDE;
    p->south = AHEAD * cos(bolan_radians(heading)) - 0.5 * SIDE;
    p->travel_x = -t->medium.sun.x / t->medium.sun.z, p->travel_y = -t->medium.sun.y / t->medium.sun.z;
    p->light = calloc((size_t)LEVELS * CELLS * CELLS, sizeof *p->light);
    for (uint64_t first = 0; first < side * side; first += most) {
        const uint32_t n = side * side - first < most ? (uint32_t)(side * side - first) : most;
        for (uint32_t i = 0; i < n; ++i) {
            const double x = (double)((first + i) % side) + uniform(&t->random);
            const double y = (double)((first + i) / side) + uniform(&t->random);
            t->xy[i] = (bolan_dvec2){p->west - MARGIN + step * x, p->south - MARGIN + step * y};
        }
        bolan_query_surface(t->water, t->xy, n, t->points);
        for (uint32_t i = 0; i < n; ++i) {
            const place from = place_at(t, &t->points[i], t->xy[i]);
            vec way = {0, 0, -1};
            const double light = photon_of(t, &from, &way);
            if (light > 0.0) count_photon(p, &from, way, light, uniform(&t->random) < 0.25);
        }
    }
}

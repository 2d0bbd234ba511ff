// SPDX-License-Identifier: MIT
// Rays to the surface: heights of bolan_query_heights() and of the fine waves, no filter by pixel. Rays of a row of
// pixels are marched together.
#include "tracer.h"

enum { STEPS = 4000 };
#define STEEPEST 0.7        // slope that steps allow for; a steeper wave is passed and found again by bisection
#define SHORTEST_STEP 0.008 // [m]; the shortest fine wave has 0.01 m
#define ON_SURFACE 2e-5     // [m]; a fine wave is a millimetre high

// Halves the stretch between `before`, on this side of the surface, and `after`, beyond it.
static void halve(ray *r, double gap) {
    if (gap >= 0.0)
        r->before = r->t;
    else
        r->after = r->t;
    r->hit = r->done = fabs(gap) < ON_SURFACE || r->after - r->before < ON_SURFACE;
    r->t = r->done ? r->before : 0.5 * (r->before + r->after);
}

static void step_ray(const tracer *t, ray *r, double height, int side) {
    const double z = r->from.z + r->t * r->dir.z, gap = side * (z - height), away = side * r->dir.z;
    if (r->after > 0.0 || gap < 0.0) {
        halve(r, gap);
        return;
    }
    r->before = r->t;
    r->t += fmax(gap / fmax(STEEPEST * hypot(r->dir.x, r->dir.y) - away, 1e-3), SHORTEST_STEP);
    r->done = r->t > t->farthest || (away >= 0.0 && side * (r->from.z + r->t * r->dir.z) > t->highest);
}

void march(tracer *t, ray *rays, uint32_t count, int side) {
    for (int step = 0; step < STEPS; ++step) {
        uint32_t n = 0;
        for (uint32_t i = 0; i < count; ++i) {
            if (rays[i].done) continue;
            const vec p = along(rays[i].from, rays[i].t, rays[i].dir);
            t->active[n] = i, t->xy[n++] = (bolan_dvec2){p.x, p.y};
        }
        if (n == 0) return;
        bolan_query_heights(t->water, t->xy, n, t->heights);
        for (uint32_t i = 0; i < n; ++i)
            step_ray(t, &rays[t->active[i]], (double)t->heights[i] + fine_at(&t->fine, t->xy[i]).height, side);
    }
    for (uint32_t i = 0; i < count; ++i) rays[i].hit |= !rays[i].done && side * rays[i].dir.z < 0.0;
}

place place_at(const tracer *t, const bolan_query_point *p, bolan_dvec2 at) {
    const double up = fmax((double)p->normal.z, 0.1);
    const fine_point fine = fine_at(&t->fine, at);
    return (place){{at.x, at.y, (double)p->height + fine.height},
                   fine.sx - (double)p->normal.x / up,
                   fine.sy - (double)p->normal.y / up};
}

void places_of(tracer *t, const ray *rays, uint32_t count, place *out) {
    for (uint32_t i = 0; i < count; ++i) {
        const vec p = along(rays[i].from, rays[i].t, rays[i].dir);
        t->xy[i] = (bolan_dvec2){p.x, p.y};
    }
    bolan_query_surface(t->water, t->xy, count, t->points);
    for (uint32_t i = 0; i < count; ++i) out[i] = place_at(t, &t->points[i], t->xy[i]);
}

vec off_surface(const place *p, int side) { return along(p->at, 1e-4 * side, (vec){0, 0, 1}); }

// SPDX-License-Identifier: MIT
// See world.h.
#include "world.h"

#include "bolan/query.h"

#include <math.h>
#include <time.h>

double seconds_now(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static double ground_at(const bolan_water *water, double x, double y) {
    return water->ground != NULL ? (double)bolan_ground_elevation(water->ground, x, y, 0.0) : -INFINITY;
}

double world_surface(const bolan_world *w, double x, double y, bool *land) {
    const bolan_water *water = bolan_world_water(w);
    bolan_query_point point = {0};
    bolan_query_surface(water, &(bolan_dvec2){x, y}, 1, &point);
    double ground = ground_at(water, x, y);
    *land = ground > point.height;
    return *land ? ground : point.height;
}

double world_floor(const bolan_world *w, double x, double y) {
    const bolan_water *water = bolan_world_water(w);
    bool land = false;
    double surface = world_surface(w, x, y, &land);
    if (!land && bolan_optics_seen_from_below(bolan_world_scene(w)->technique.optics))
        return fmax(ground_at(water, x, y) + 0.3, water->level - 30.0);
    // On land the height of a standing person's eyes; over water above the waves.
    return surface + (land ? 1.7 : 0.5);
}

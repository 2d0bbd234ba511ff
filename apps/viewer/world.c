// SPDX-License-Identifier: MIT
// The scene that is shown and its sea.
#include "world.h"

#include "bolan/query.h"

#include <math.h>
#include <time.h>

double seconds_now(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

// Puts a fresh sea in the place of the old one.
static bolan_result make_sea(world *w, double time) {
    bolan_sea *sea = NULL;
    bolan_result result = bolan_scene_create_sea(&w->scene, &w->assets, &sea);
    if (result != BOLAN_OK) return result;
    bolan_sea_settle(sea, time);
    w->statistics = bolan_sea_measure(sea);
    bolan_sea_destroy(&w->sea);
    w->sea = sea;
    return BOLAN_OK;
}

bolan_result world_open(world *w, const bolan_scene *scene) {
    *w = (world){.scene = *scene, .home = scene->camera};
    bolan_result result = bolan_scene_assets_load(&w->scene, &w->assets);
    if (result == BOLAN_OK) result = make_sea(w, scene->time);
    if (result != BOLAN_OK) world_close(w);
    return result;
}

void world_close(world *w) {
    bolan_sea_destroy(&w->sea);
    bolan_scene_assets_destroy(&w->assets);
}

bolan_result world_rebuild_sea(world *w) { return make_sea(w, bolan_sea_time(w->sea)); }

void world_step(world *w, double time) {
    double start = seconds_now();
    bolan_sea_step(w->sea, time);
    w->synthesis_ms = (seconds_now() - start) * 1e3;
    w->scene.time = time;
}

double world_surface(const world *w, double x, double y, bool *land) {
    bolan_query_point point = {0};
    bolan_query_surface(&(bolan_water){.sea = w->sea, .ground = w->assets.terrain, .level = w->scene.water.level}, &(bolan_dvec2){x, y}, 1, &point);
    double ground = w->assets.terrain != NULL ? bolan_ground_elevation(w->assets.terrain, x, y, 0.0) : -INFINITY;
    *land = ground > point.height;
    return *land ? ground : point.height;
}

double world_floor(const world *w, double x, double y) {
    bool land = false;
    double surface = world_surface(w, x, y, &land);
    if (!land && w->scene.technique.optics == BOLAN_OPTICS_MIRROR) { // which has views from below
        double ground = w->assets.terrain != NULL ? bolan_ground_elevation(w->assets.terrain, x, y, 0.0) : -INFINITY;
        return fmax(ground + 0.3, w->scene.water.level - 30.0);
    }
    // On land the eye of somebody standing; over water it may come close, but no wave runs over the lens.
    return surface + (land ? 1.7 : 0.5);
}

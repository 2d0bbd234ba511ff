// SPDX-License-Identifier: MIT
// The scene that is shown, with all that it refers to, and its sea.
#ifndef VIEWER_WORLD_H
#define VIEWER_WORLD_H

#include "bolan/io.h"

typedef struct world {
    bolan_scene scene;
    bolan_camera home; // the camera the scene came with
    bolan_scene_assets assets;
    bolan_sea *sea;
    bolan_sea_statistics statistics; // when it was made
    double synthesis_ms;             // of the last step
} world;

// Loads what @p scene refers to and makes its sea, settled at the scene's time.
bolan_result world_open(world *w, const bolan_scene *scene);
void world_close(world *w);
// Makes the sea again from the scene, at the time of the old one, which stays on failure.
bolan_result world_rebuild_sea(world *w);
void world_step(world *w, double time);
// The surface under (x, y), water or ground, whichever is higher [m]; *land tells which.
double world_surface(const world *w, double x, double y, bool *land);
// The lowest place for an eye there [m].
double world_floor(const world *w, double x, double y);
double seconds_now(void);

#endif

// SPDX-License-Identifier: MIT
// See session.h.
#include "session.h"

#include <math.h>
#include <stdio.h>

static int open_world(const options *o, bool open_sea, bolan_world **world) {
    *world = NULL;
    bolan_scene scene;
    const int result = options_scene(o, &scene);
    if (result) return result;
    bolan_set_threads(isnan(o->threads) ? 0 : (uint32_t)o->threads);
    if (open_sea && option_given(o, "buoy") && !o->quiet &&
        (scene.terrain.kind != BOLAN_GROUND_NONE || scene.train_count > 0))
        fprintf(stderr, "bolan: warning: the buoy rides on the open sea; the ground and the wave trains of the scene "
                        "are left out\n");
    if (open_sea) scene.terrain.kind = BOLAN_GROUND_NONE, scene.object_count = 0;
    return bolan_world_load_scene(&scene, world) ? EXIT_FAILED : EXIT_OK;
}

int session_open(const options *o, bolan_world **world) { return open_world(o, false, world); }

int session_open_sea(const options *o, bolan_world **world) { return open_world(o, true, world); }

int session_check_camera(const bolan_world *w) {
    const bolan_scene *scene = bolan_world_scene(w);
    const double below = scene->water.level - bolan_world_camera_at(w, scene->time).position.z;
    if (below <= 0.0 || bolan_optics_seen_from_below(scene->technique.optics)) return EXIT_OK;
    return usage_error(
        "the camera stands %g m below the water; expected above it: only the optics physical and mirror have views "
        "from below",
        below);
}

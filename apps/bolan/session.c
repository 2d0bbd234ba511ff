// SPDX-License-Identifier: MIT
// See session.h.
#include "session.h"

#include <math.h>

void session_lift_camera(session *s) {
    if (!s->assets.terrain) return;
    bolan_dvec3 *p = &s->scene.camera.position;
    const double ground = (double)bolan_ground_elevation(s->assets.terrain, p->x, p->y, 0.0);
    p->z = fmax(p->z, ground + (ground > s->scene.water.level ? 1.8 : 0.3)); // a diver's mask, over the sea bed
}

static int open_scene(const options *o, session *s, bool with_terrain) {
    *s = (session){.sea = NULL};
    const int result = options_scene(o, &s->scene);
    if (result) return result;
    bolan_set_threads(isnan(o->threads) ? 0 : (uint32_t)o->threads);
    if (!with_terrain) s->scene.terrain.kind = BOLAN_GROUND_NONE, s->scene.object_count = 0;
    if (bolan_scene_assets_load(&s->scene, &s->assets)) return EXIT_FAILED;
    session_lift_camera(s);
    if (bolan_scene_create_sea(&s->scene, &s->assets, &s->sea)) {
        session_close(s);
        return EXIT_FAILED;
    }
    return EXIT_OK;
}

int session_open(const options *o, session *s) { return open_scene(o, s, true); }

int session_open_sea(const options *o, session *s) { return open_scene(o, s, false); }

void session_close(session *s) {
    bolan_sea_destroy(&s->sea);
    bolan_scene_assets_destroy(&s->assets);
}

// SPDX-License-Identifier: MIT
// See refine.h.
#include "refine.h"

#include <stdio.h>
#include <string.h>

#define STILL_TIME 0.3 // [s] a hand that flies or drags pauses for less

void refine_restart(refine *r) {
    r->any = false;
    r->step = REFINE_MOVING;
    r->samples = 0;
    r->settled = false;
}

static bool is_seen(const refine *r, const refine_view *view) {
    return r->any && memcmp(&r->seen.scene, &view->scene, sizeof view->scene) == 0 && r->seen.time == view->time &&
           r->seen.scale == view->scale && r->seen.width == view->width && r->seen.height == view->height &&
           r->seen.quality == view->quality;
}

static refine_step next_of(const refine *r) {
    if (r->still < STILL_TIME) return REFINE_MOVING;
    if (!r->settled) return REFINE_SIZE;
    return r->samples < r->most ? REFINE_ADD : REFINE_DONE;
}

refine_step refine_next(refine *r, const refine_view *view, double seconds) {
    const bool changed = !is_seen(r, view);
    r->still = changed ? 0.0 : r->still + seconds;
    if (changed) {
        refine_restart(r);
        memcpy(&r->seen, view, sizeof *view); // with the padding
        r->any = true;
    }
    return r->step = next_of(r);
}

void refine_drawn(refine *r, const bolan_frame_statistics *drawn) {
    // At the full size finer ground comes over several frames: the mean begins when all of it is there.
    if (r->step == REFINE_SIZE) r->settled = drawn->uploads == r->uploads;
    r->uploads = drawn->uploads;
    if (r->step == REFINE_ADD) r->samples = drawn->samples;
}

void refine_say(const refine *r, char *text, size_t size) {
    text[0] = '\0';
    if (r->step == REFINE_SIZE) snprintf(text, size, "refined: full size");
    if (r->step >= REFINE_ADD) snprintf(text, size, "refined: %u sample%s", r->samples, r->samples == 1 ? "" : "s");
}

// SPDX-License-Identifier: MIT
// The internal resolution in steps, with a dead band so that it does not flutter.
#include "pace.h"

#include <stddef.h>

#define SLOW_MS 75.0 // above this a step down; at 13 frames a second motion is still visible
#define FAST_MS 55.0 // a step up if it is expected to stay below this
#define PATIENCE 5   // frames after a change before the next: new targets and caches disturb the first ones

static const double steps[] = {1.0, 0.75, 0.6, 0.5, 0.4, 0.33, 0.25};
#define STEPS (sizeof steps / sizeof steps[0])

void pace_start(pace *p, bool software) {
    *p = (pace){.scale = software ? 0.6 : 1.0, .slow_ms = SLOW_MS, .fast_ms = FAST_MS};
}

void pace_limit(pace *p, double slow_ms, double fast_ms) {
    p->slow_ms = slow_ms;
    p->fast_ms = fast_ms;
}

static size_t step_of(double scale) {
    size_t i = 0;
    while (i + 1 < STEPS && steps[i] > scale + 1e-6) ++i;
    return i;
}

static void change(pace *p, double scale) {
    p->frame_ms *= scale * scale / (p->scale * p->scale); // the expected time if only pixels cost
    p->scale = scale;
    p->settled = 0;
}

void pace_frame(pace *p, double ms, bool automatic) {
    p->frame_ms = p->frame_ms > 0.0 ? p->frame_ms + 0.2 * (ms - p->frame_ms) : ms;
    if (p->settled == 1) p->frame_ms = ms; // the first frame after a change was not typical
    p->settled++;
    if (!automatic || p->settled < PATIENCE) return;
    size_t i = step_of(p->scale);
    if (p->frame_ms > p->slow_ms && i + 1 < STEPS) {
        size_t down = p->frame_ms > 2.0 * p->slow_ms && i + 2 < STEPS ? 2 : 1; // far off: quicker
        change(p, steps[i + down]);
    } else if (i > 0) {
        double growth = steps[i - 1] * steps[i - 1] / (p->scale * p->scale);
        if (p->frame_ms * growth < p->fast_ms) change(p, steps[i - 1]);
    }
}

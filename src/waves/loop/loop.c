// SPDX-License-Identifier: MIT
// TEXTURES: one tile of cascades/ whose time stands still for a frame and runs in a loop, as tiles that were baked into
// textures do (Ma, Zhu & Gong 2006). Every mode turns a whole number of times in the loop, so that the last frame joins
// the first.
#include "waves/cascades/cascades.h"

// The whole number of peak periods that is nearest to 10 s: so the highest waves keep their own speed.
static double automatic_period(double tp) {
    if (!(tp > 0.0)) return 10.0;
    return tp * fmax(floor(10.0 / tp + 0.5), 1.0);
}

static const cascade_extent loop_extent = {7.0, 5.0, false};

static void size(sea_shared *shared, const spectrum_eval *eval, bolan_sea_bytes *bytes) {
    bolan_cascades_size(shared, eval, 1, loop_extent, bytes);
}

// The one tile holds 7 peak wavelengths, not 16: its resolution has to do for the short waves, too.
static bool create(sea_shared *shared, const spectrum_eval *eval) {
    bolan_sea_desc *d = &shared->desc;
    if (d->textures.period == 0.0) d->textures.period = automatic_period(shared->summary.tp);
    shared->period = d->textures.period;
    shared->frames = d->textures.frames;
    return bolan_cascades_create(shared, eval, 1, loop_extent);
}

static double shown_time(const sea_shared *shared, double time, uint32_t *frame) {
    const double frames = shared->frames, loops = time / shared->period;
    const double on = fmin(floor((loops - floor(loops)) * frames), frames - 1.0);
    if (frame) *frame = (uint32_t)on;
    return on * shared->period / frames;
}

const sea_model bolan_sea_model_textures = {CASCADES_MODEL, .create = create, .size = size, .shown_time = shown_time};

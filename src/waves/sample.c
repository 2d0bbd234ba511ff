// SPDX-License-Identifier: MIT
// Samples at rest points: the sums of the model, displaced by the choppiness.
#include "waves/model.h"

#define STEEPEST 0.1 // smallest |Jacobian| that a slope is divided by: where the surface folds it is vertical

bolan_sea_sample bolan_sea_displaced(const sea_sums *v, double choppiness) {
    const double xx = 1.0 + choppiness * v->dxx, yy = 1.0 + choppiness * v->dyy;
    const double xy = choppiness * v->dxy, yx = choppiness * v->dyx, jacobian = xx * yy - xy * yx;
    const double divisor = fabs(jacobian) > STEEPEST ? jacobian : jacobian < 0.0 ? -STEEPEST : STEEPEST;
    return (bolan_sea_sample){
        .height = (float)v->height,
        .dx = (float)(choppiness * v->dx),
        .dy = (float)(choppiness * v->dy),
        .slope_x = (float)((v->sx * yy - v->sy * yx) / divisor),
        .slope_y = (float)((v->sy * xx - v->sx * xy) / divisor),
        .jacobian = (float)jacobian,
        .foam = (float)v->foam,
    };
}

void bolan_sea_sample_rest(const bolan_sea *sea, const bolan_dvec2 *points, uint32_t count, bolan_sea_sample *out) {
    BOLAN_ASSERT(sea && (count == 0 || (points && out)));
    bolan_sea_fields(sea);
    sea->shared->model->sample_rest(sea, points, count, out);
}

void bolan_sea_sample_grid(const bolan_sea *sea, const bolan_dvec2 *points, const float *spacing, uint32_t count,
                           bolan_sea_sample *out) {
    BOLAN_ASSERT(sea && (count == 0 || (points && out)));
    bolan_sea_fields(sea);
    sea->shared->model->sample_grid(sea, points, spacing, count, out);
}

bolan_sea_sample bolan_sea_sample_direct(const bolan_sea *sea, double x, double y, double time) {
    BOLAN_ASSERT(sea && isfinite(time));
    const sea_shared *shared = sea->shared;
    const bolan_dvec2 drift = shared->cascades > 0 ? bolan_sea_drift(shared, time) : (bolan_dvec2){0.0, 0.0};
    sea_sums v = {.height = shared->lift};
    shared->model->sample_direct(shared, (bolan_dvec2){x, y}, drift, shared->model->shown_time(shared, time, NULL), &v);
    return bolan_sea_displaced(&v, shared->desc.choppiness);
}

// SPDX-License-Identifier: MIT
// A flow from creation to destruction, and its steps.
#include "flow/tables.h"

static void release(bolan_flow *flow) {
    for (uint32_t i = 0; i < flow->tiles; i++) bolan_fft_plan_destroy(&flow->tile[i].plan);
    for (int i = 0; i < 2; i++) bolan_fft_plan_destroy(&flow->second_plan[i]);
    for (uint32_t i = 0; i < flow->memory.count; i++)
        bolan_release(flow->memory.block[i].at, flow->memory.block[i].bytes);
    bolan_release(flow, sizeof *flow);
}

static void set_bands(bolan_flow *flow, const bolan_sea *sea) {
    const sea_band *band = bolan_sea_bands(sea, &flow->bands);
    for (uint32_t i = 0; i < flow->bands; i++) flow->band_hs[i] = (float)(4.0 * sqrt(band[i].variance));
}

static void evolve(bolan_flow *flow, const bolan_sea *sea) {
    const double shown = flow->model->shown_time(sea->shared, bolan_sea_time(sea), NULL);
    bolan_flow_evolve_tiles(flow, shown);
    bolan_flow_evolve_waves(flow, shown);
    bolan_flow_evolve_second(flow, shown);
    flow->time = bolan_sea_time(sea);
    flow->origin = bolan_sea_drift(sea->shared, flow->time);
}

bolan_result bolan_flow_create(const bolan_sea *sea, bolan_flow **out) {
    BOLAN_ASSERT(sea && out);
    *out = NULL;
    bolan_flow *flow = bolan_sea_borrow(sizeof *flow);
    if (!flow) return BOLAN_ERROR_MEMORY;
    const bolan_sea_desc *desc = bolan_sea_get_desc(sea);
    flow->sea_id = bolan_sea_id(sea);
    flow->model = sea->shared->model;
    flow->depth = desc->sea_state.depth;
    flow->current_x = (float)desc->sea_state.current_x;
    flow->current_y = (float)desc->sea_state.current_y;
    flow->warp = *bolan_sea_warp_of(sea);
    flow->kernels = bolan_flow_kernels_for(desc->cpu);
    flow->choppiness = flow->model->form == BOLAN_FORM_EXP_COSINES ? 0.0f : (float)desc->choppiness;
    set_bands(flow, sea);
    const bool cascades = flow->model->form == BOLAN_FORM_CASCADES;
    bool ready = cascades ? bolan_flow_create_tiles(flow, sea) : bolan_flow_create_waves(flow, sea);
    if (ready && cascades && desc->order > 1) ready = bolan_flow_create_second(flow, sea);
    if (!ready) {
        release(flow);
        return BOLAN_ERROR_MEMORY;
    }
    evolve(flow, sea);
    *out = flow;
    return BOLAN_OK;
}

void bolan_flow_destroy(bolan_flow **flow) {
    if (!flow || !*flow) return;
    release(*flow);
    *flow = NULL;
}

void bolan_flow_step(bolan_flow *flow, const bolan_sea *sea) {
    const bool own = flow && sea && bolan_sea_id(sea) == flow->sea_id;
    BOLAN_ASSERT(own);
    if (own && bolan_sea_time(sea) != flow->time) evolve(flow, sea);
}

double bolan_flow_time(const bolan_flow *flow) {
    BOLAN_ASSERT(flow);
    return flow->time;
}

uint64_t bolan_flow_sea_id(const bolan_flow *flow) {
    BOLAN_ASSERT(flow);
    return flow->sea_id;
}

size_t bolan_flow_size(const bolan_flow *flow) {
    BOLAN_ASSERT(flow);
    size_t bytes = sizeof *flow + flow->second_plan[0].bytes + flow->second_plan[1].bytes;
    for (uint32_t i = 0; i < flow->tiles; i++) bytes += flow->tile[i].plan.bytes;
    for (uint32_t i = 0; i < flow->memory.count; i++) bytes += flow->memory.block[i].bytes;
    return bytes;
}

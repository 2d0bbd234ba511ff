// SPDX-License-Identifier: MIT
// Creation, reading and destruction of cascades. The model FFT.
#include "waves/cascades/synth.h"

// ---- creation -------------------------------------------------------------------------------------------------------

static size_t turns_bytes(uint32_t n) { return 2 * (size_t)n * sizeof(float); }

// Counts, lengths and rings in shared->tables.
static void plan_cascades(sea_shared *shared, const spectrum_eval *eval, uint32_t count, cascade_extent extent,
                          sea_radial *radial) {
    cascade_tables *t = shared->tables;
    shared->cascades = shared->bands = count;
    for (uint32_t i = 0; i < count; i++) t->cascade[i].band = &shared->band[i];
    const bolan_sea_state *state = &shared->desc.sea_state;
    double up, cross;
    bolan_cox_munk(state->wind_speed, &up, &cross);
    bolan_sea_radial_prepare(eval, bolan_sea_asked_end(state, &shared->summary), up + cross, radial);
    bolan_cascades_layout(shared, radial, extent);
}

// The plans of both passes, and the turns between the halves of an FFT along a row (synth_rows.kernel.c).
static bool create_plans(sea_shared *shared, cascade_tables *t) {
    const uint32_t n = shared->desc.resolution;
    if (!bolan_fft_plan_create(n, &t->columns) || !bolan_fft_plan_create(n / FFT_LANES, &t->rows)) return false;
    t->turns = bolan_sea_reserve(&shared->memory, turns_bytes(n));
    if (!t->turns) return false;
    for (uint32_t b = 0; b < n / FFT_LANES; b++)
        for (uint32_t l = 0; l < FFT_LANES; l++) {
            double sine, cosine;
            bolan_sincos(2.0 * BOLAN_PI * (double)(b * l) / n, &sine, &cosine);
            t->turns[b * FFT_ROW + l] = (float)cosine;
            t->turns[b * FFT_ROW + FFT_LANES + l] = (float)sine;
        }
    return true;
}

bool bolan_cascades_create(sea_shared *shared, const spectrum_eval *eval, uint32_t count, cascade_extent extent) {
    cascade_tables *t = shared->tables = bolan_sea_reserve(&shared->memory, sizeof *t);
    if (!t) return false;
    t->kernels = bolan_sea_kernels_for(shared->desc.cpu, shared->desc.resolution);
    sea_radial radial;
    plan_cascades(shared, eval, count, extent, &radial);
    if (extent.open) bolan_sea_warp_prepare(shared->desc.length, t->cascade[0].angle, &shared->warp);
    if (!create_plans(shared, t)) return false;
    if (!bolan_cascades_modes(shared, eval, &radial)) return false;
    bolan_cascades_bound(shared);
    for (uint32_t i = 0; i < count; i++)
        if (!bolan_cascade_lift(&t->cascade[i], shared->desc.choppiness, &shared->bound[i])) return false;
    return true;
}

static const cascade_extent fft_extent = {16.0, 12.0, true};

static bool create_fft(sea_shared *shared, const spectrum_eval *eval) {
    return bolan_cascades_create(shared, eval, shared->desc.fft.cascade_count, fft_extent);
}

static void size_fft(sea_shared *shared, const spectrum_eval *eval, bolan_sea_bytes *bytes) {
    bolan_cascades_size(shared, eval, shared->desc.fft.cascade_count, fft_extent, bytes);
}

void bolan_cascades_destroy(sea_shared *shared) {
    cascade_tables *t = shared->tables;
    if (!t) return;
    bolan_fft_plan_destroy(&t->columns);
    bolan_fft_plan_destroy(&t->rows);
}

// Planes begin some lines after a multiple of their size: written row by row at once, they would otherwise all
// compete for one set of the cache.
enum { PLANE_SHIFT = 7 * 16 }; // floats

static size_t plane_floats(const sea_cascade *c) { return (size_t)c->n * c->n + PLANE_SHIFT; }
static uint32_t pitch_of(const sea_cascade *c) { return c->n + BOLAN_CASCADE_GUARD; }
static size_t texels_floats(const sea_cascade *c) { return SEA_HALF * (size_t)pitch_of(c) * pitch_of(c) + PLANE_SHIFT; }
static size_t middle_floats(const sea_cascade *c) { return (size_t)(c->n / SEA_ROWS) * c->strips * SEA_CELL; }
static size_t modes_floats(const sea_cascade *c) { return (size_t)c->n * c->strips * FFT_ROW; }
// What the slopes need; the fine waves have nothing else.
static size_t slopes_floats(const sea_cascade *c) {
    return modes_floats(c) + middle_floats(c) + plane_floats(c) * (SEA_HALF + 5);
}
static size_t planes_floats(const sea_cascade *c) { return slopes_floats(c) + texels_floats(c) + plane_floats(c) * 2; }

// Returns what is behind the slopes.
static float *lay_slopes(float *next, const sea_cascade *c, sea_planes *p) {
    const size_t plane = plane_floats(c);
    p->modes = next;
    next += modes_floats(c);
    p->middle = next;
    next += middle_floats(c);
    for (int f = 0; f < SEA_HALF; f++, next += plane) p->slope[f] = next;
    p->foam = next;
    p->foam_tick = next + plane;
    p->slope_half = (uint16_t *)(void *)(next + 2 * plane);
    p->foam_half = (uint16_t *)(void *)(next + 4 * plane);
    return next + 5 * plane;
}

static bool reserve_planes(sea_memory *memory, const sea_cascade *c, sea_planes *p) {
    float *next = bolan_sea_reserve(memory, planes_floats(c) * sizeof *next);
    if (!next) return false;
    next = lay_slopes(next, c, p);
    p->displacement_half = (uint16_t *)(void *)next;
    p->displacement = (bolan_sea_texel *)(void *)(next + 2 * plane_floats(c));
    return true;
}

static bool reserve_fine(sea_memory *memory, const sea_cascade *c, sea_planes *p) {
    if (c->n == 0) return true;
    float *next = bolan_sea_reserve(memory, slopes_floats(c) * sizeof *next);
    if (next) lay_slopes(next, c, p);
    return next != NULL;
}

// A worker that a later bolan_set_threads() adds finds no scratch and stays idle.
bool bolan_cascades_create_fields(bolan_sea *sea) {
    const cascade_tables *t = cascade_tables_of(sea->shared);
    cascade_fields *f = sea->fields = bolan_sea_reserve(&sea->memory, sizeof *f);
    if (!f) return false;
    f->slots = bolan_threads();
    f->scratch_floats = sea_scratch_floats(t->columns.n);
    f->scratch = bolan_sea_reserve(&sea->memory, f->slots * f->scratch_floats * sizeof(float));
    if (!f->scratch) return false;
    for (uint32_t i = 0; i < sea->shared->cascades; i++)
        if (!reserve_planes(&sea->memory, &t->cascade[i], &f->planes[i])) return false;
    return reserve_fine(&sea->memory, &t->fine, &f->fine);
}

void bolan_cascades_size(sea_shared *shared, const spectrum_eval *eval, uint32_t count, cascade_extent extent,
                         bolan_sea_bytes *bytes) {
    cascade_tables t = {.kernels = NULL};
    sea_radial radial;
    shared->tables = &t;
    plan_cascades(shared, eval, count, extent, &radial);
    const uint32_t n = shared->desc.resolution;
    bytes->tables += sizeof t + bolan_fft_plan_bytes(n) + bolan_fft_plan_bytes(n / FFT_LANES) + turns_bytes(n);
    bytes->fields += sizeof(cascade_fields);
    bytes->fields += bolan_threads() * sea_scratch_floats(n) * sizeof(float);
    for (uint32_t i = 0; i < count; i++) {
        bolan_cascade_set_reach(&t.cascade[i]);
        bytes->tables += bolan_cascade_table_bytes(&t.cascade[i]);
        bytes->fields += planes_floats(&t.cascade[i]) * sizeof(float);
    }
    if (t.fine.n > 0) {
        bolan_cascade_set_reach(&t.fine);
        bytes->tables += bolan_cascade_table_bytes(&t.fine);
        bytes->fields += slopes_floats(&t.fine) * sizeof(float);
    }
    shared->tables = NULL;
}

// ---- reading --------------------------------------------------------------------------------------------------------

void bolan_cascades_each_wave(const sea_shared *shared, sea_visit *visit, void *context) {
    for (uint32_t i = 0; i < shared->cascades; i++)
        bolan_sea_each_mode(&cascade_tables_of(shared)->cascade[i], visit, context);
}

void bolan_cascades_slopes(const sea_shared *shared, double out[3]) {
    for (uint32_t i = 0; i < shared->cascades; i++)
        for (int e = 0; e < 3; e++) out[e] += cascade_tables_of(shared)->cascade[i].slope[e];
}

// The bound waves of a crest, or of a trough, of `sigmas` standard deviations, to which each cascade gives its share.
static double bound_height(const sea_shared *shared, double sigmas, double variance) {
    double sum = 0.0, longer = 0.0;
    for (uint32_t i = 0; i < shared->cascades; i++) {
        const bolan_bound_weights *w = &shared->bound[i];
        const double m = shared->band[i].variance, drift = cascade_tables_of(shared)->cascade[i].displacement;
        sum += m * longer + m * fmax(fabs(w->height) * m, fabs(w->drift) * drift);
        longer += fmax(fabs(w->height_long) * m, fabs(w->drift_long) * drift);
    }
    return variance > 0.0 ? sigmas * sigmas * sum / variance : 0.0;
}

void bolan_cascades_bounds(const sea_shared *shared, double *vertical, double *horizontal) {
    double variance = 0.0, displacement = 0.0;
    for (uint32_t i = 0; i < shared->cascades; i++) {
        variance += shared->band[i].variance;
        displacement += cascade_tables_of(shared)->cascade[i].displacement;
    }
    *vertical = 6.0 * sqrt(variance) + fmax(shared->lift, 0.0) + bound_height(shared, 6.0, variance);
    *horizontal = 6.0 * sqrt(displacement) * shared->desc.choppiness;
}

double bolan_cascades_side(const sea_shared *shared) { return cascade_tables_of(shared)->cascade[0].length; }

uint64_t bolan_cascades_hash(const bolan_sea *sea, uint64_t hash) {
    for (uint32_t i = 0; i < sea->shared->cascades; i++) {
        const sea_cascade *c = &cascade_tables_of(sea->shared)->cascade[i];
        const sea_planes *p = &cascade_fields_of(sea)->planes[i];
        for (size_t j = 0; j < c->n; j++)
            hash = bolan_sea_hash_plane(hash, &p->displacement[j * pitch_of(c)].dx, SEA_HALF * (size_t)c->n);
        for (int f = 0; f < SEA_HALF; f++) hash = bolan_sea_hash_plane(hash, p->slope[f], (size_t)c->n * c->n);
    }
    const bolan_dvec2 drift = bolan_sea_drift(sea->shared, sea->time);
    const float moved[2] = {(float)drift.x, (float)drift.y};
    return drift.x != 0.0 || drift.y != 0.0 ? bolan_sea_hash_plane(hash, moved, 2) : hash;
}

bolan_cascade_view bolan_cascades_view(const bolan_sea *sea, uint32_t index) {
    const sea_cascade *c = &cascade_tables_of(sea->shared)->cascade[index];
    const sea_planes *p = &cascade_fields_of(sea)->planes[index];
    const bolan_dvec2 drift = bolan_sea_drift(sea->shared, sea->time);
    return (bolan_cascade_view){.n = c->n,
                                .origin_x = drift.x,
                                .origin_y = drift.y,
                                .length = c->length,
                                .angle = c->angle,
                                .k_min = c->k_min,
                                .k_max = c->k_max,
                                .variance = c->band->variance,
                                .mss = c->slope[0] + c->slope[2],
                                .bound = sea->shared->bound[index],
                                .displacement = p->displacement,
                                .pitch = pitch_of(c),
                                .slope_x = p->slope[0],
                                .slope_y = p->slope[1],
                                .dxx = p->slope[2],
                                .dyy = p->slope[3],
                                .foam = p->foam,
                                .displacement_half = p->displacement_half,
                                .slope_half = p->slope_half,
                                .foam_half = p->foam_half};
}

const sea_model bolan_sea_model_fft = {CASCADES_MODEL, .create = create_fft, .size = size_fft,
                                       .shown_time = bolan_sea_reduced_time};

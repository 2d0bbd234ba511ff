// SPDX-License-Identifier: MIT
// Questions to the moving water. Each point is answered by itself: its depth at rest, its rest point by Newton's method
// on the displacement at that depth, and the gradients of the flow's potentials there (flow/tables.h).
//
// A texel of the flow is a cache line, and a point reads 16 of each tile: it is these reads that cost. Surface and rest
// point of a point near the surface are those of bolan_query_heights(), whose fields are far smaller, so that the flow
// is read once there. Below, it is read once for a Newton step and once for the answer.
#include "bolan/coast.h"
#include "bolan/query.h"

#include "flow/tables.h"
#include "query/block.h"
#include "water/layer.h"

#include <math.h>

enum { GRAIN_POINTS = 64, STEPS = 10, BATCH = 64 };
#define CONVERGED 5e-4        // [m] of the rest point
#define REGULAR 0.1           // determinant below which Newton's matrix says nothing
#define WET_MARGIN 1e-3       // [m] above the surface
#define GROUND_RESOLUTION 2.0 // [m] as in query.c
#define STEEPEST 1e-3         // least z of a normal that has a slope

typedef struct asked {
    const bolan_water *water;
    const bolan_flow *flow;
    bolan_question question;
    double smoothing;
    double highest; // no surface is farther from the level [m]
    float lift[BOLAN_MAX_CASCADES];
    bool bound;                      // the sea has bound waves
    float share[BOLAN_MAX_CASCADES]; // of the rms height of each band, left by the least wavelength
    flow_depth surface, all;         // depth 0, and there without the filter of a least wavelength
    bool filtered;                   // waves are left out: the surface is not that of `heights`
    query heights;                   // of all waves
    // One of two questions.
    const bolan_dvec3 *xyz;
    bolan_kinematics *below;
    const double *z; // of levels, where columns are asked
    uint32_t levels, columns;
    const bolan_dvec2 *xy;
    bolan_surface_motion *motion;
} asked;

// A parcel at rest, what shallow water leaves of each band there, and the flow there without layers.
typedef struct rest {
    double x, y, depth; // of the water under it [m]
    float keep[BOLAN_MAX_CASCADES];
    flow_bend bend;
    flow_motion motion;
} rest;

// A point as it is looked for.
typedef struct sought {
    double x, y;
    flow_spot spot;
    bolan_dvec2 near; // its rest point at the surface, where it is known, or the point itself
    bool is_known;    // it is, and so is
    float eta;        // the surface over the level [m]
} sought;

bolan_question bolan_question_default(void) {
    return (bolan_question){.least_wavelength = 0.0, .stretching = BOLAN_STRETCH_NONE};
}

static void attenuate(const asked *a, rest *r) {
    if (!a->water->ground) return;
    r->depth = a->water->level - (double)bolan_ground_elevation(a->water->ground, r->x, r->y, GROUND_RESOLUTION);
    bolan_coast_attenuations((float)r->depth, a->flow->band_hs, a->flow->bands, r->keep);
}

// One step from a residual by the matrix 1 + choppiness grad D; near a fold the plain fixed point.
static void advance(rest *r, double choppiness, double rx, double ry) {
    const double xx = 1.0 + choppiness * r->bend.dxx, yy = 1.0 + choppiness * r->bend.dyy,
                 xy = choppiness * r->bend.dxy;
    const double determinant = xx * yy - xy * xy;
    const bool regular = fabs(determinant) > REGULAR;
    r->x -= regular ? (yy * rx - xy * ry) / determinant : rx;
    r->y -= regular ? (xx * ry - xy * rx) / determinant : ry;
}

// The parcel that stands over a point, at the depth of rest `at`. The search begins at `start`; `close`: next to it.
static void find_rest(const asked *a, const flow_depth *at, const sought *p, bolan_dvec2 start, bool close, rest *r) {
    const double choppiness = (double)a->flow->choppiness;
    r->x = start.x;
    r->y = start.y;
    r->depth = INFINITY;
    for (uint32_t i = 0; i < BOLAN_MAX_CASCADES; i++) r->keep[i] = 1.0f;
    for (int i = 0; i < STEPS; i++) {
        attenuate(a, r);
        const bool last = i > 0 || close || choppiness == 0.0; // or so it seems
        bolan_flow_read(a->flow, at, &p->spot, r->x, r->y, r->keep, &r->bend, last ? &r->motion : NULL);
        const double rx = r->x - p->x + choppiness * r->bend.dx, ry = r->y - p->y + choppiness * r->bend.dy;
        if (choppiness == 0.0 || (last && rx * rx + ry * ry < CONVERGED * CONVERGED)) return;
        advance(r, choppiness, rx, ry);
    }
    attenuate(a, r);
    bolan_flow_read(a->flow, at, &p->spot, r->x, r->y, r->keep, &r->bend, &r->motion);
}

// ---- layers ---------------------------------------------------------------------------------------------------------

// What a layer keeps: of its amplitude over the bed, and of a wave that the question may leave out.
static double layer_keep(const asked *a, const bolan_wave_layer *layer, const rest *r) {
    const double k = sqrt(layer->kx * layer->kx + layer->ky * layer->ky);
    const double bed = a->water->ground ? (double)bolan_coast_attenuation((float)r->depth, layer->hs) : 1.0;
    return bed * bolan_flow_kept(k, a->smoothing);
}

static void add_layer_flows(const asked *a, const rest *r, double below, flow_motion *m) {
    for (uint32_t i = 0; i < a->water->layer_count; i++) {
        const bolan_wave_layer *layer = a->water->layers[i];
        const double keep = layer_keep(a, layer, r);
        wave_layer_flow f;
        layer->kind->flow(layer, a->flow->time, r->x, r->y, below, &f);
        m->vx += keep * f.vx, m->vy += keep * f.vy, m->vz += keep * f.vz;
        m->ax += keep * f.ax, m->ay += keep * f.ay, m->az += keep * f.az;
        m->potential += keep * f.potential;
    }
}

static void add_bound_waves(const asked *a, const rest *r, flow_motion *m) {
    float keep[BOLAN_MAX_CASCADES];
    double height, slope[2];
    for (uint32_t i = 0; i < a->flow->bands; i++) keep[i] = r->keep[i] * a->share[i];
    bolan_sea_bound_at(a->water->sea, (bolan_dvec2){r->x, r->y}, keep, &height, slope);
    m->height += height;
    m->slope_x += slope[0];
    m->slope_y += slope[1];
}

// Height over the level at a rest point of the surface; `m` holds that of the sea.
static void add_layer_heights(const asked *a, const rest *r, flow_motion *m) {
    for (uint32_t i = 0; i < a->flow->bands; i++)
        m->height += (double)(r->keep[i] * r->keep[i] * a->lift[i]); // a product of two that are attenuated
    if (a->bound) add_bound_waves(a, r, m);
    for (uint32_t i = 0; i < a->water->layer_count; i++) {
        const bolan_wave_layer *layer = a->water->layers[i];
        const double keep = layer_keep(a, layer, r);
        bolan_wave_layer_sample s;
        layer->kind->sample(layer, a->flow->time, 1, &r->x, &r->y, &s);
        m->height += keep * (double)s.height;
        m->slope_x += keep * (double)s.slope_x;
        m->slope_y += keep * (double)s.slope_y;
    }
}

// ---- below ----------------------------------------------------------------------------------------------------------

// Of the surface over the level.
static double height_over_level(const asked *a, const sought *p, rest *r) {
    find_rest(a, &a->surface, p, p->near, p->is_known, r);
    flow_motion m = r->motion;
    add_layer_heights(a, r, &m);
    return m.height;
}

static bool is_buried(const asked *a, bolan_dvec3 p) {
    return a->water->ground && p.z < (double)bolan_ground_elevation(a->water->ground, p.x, p.y, GROUND_RESOLUTION);
}

// Depth at rest of a point that is in the water; < 0 of one that is not. *found: r is its rest point at the surface.
static double depth_at_rest(const asked *a, bolan_dvec3 p, const sought *s, rest *r, bool *found) {
    const double z = p.z - a->water->level;
    const bool stretched = a->question.stretching == BOLAN_STRETCH_WHEELER;
    *found = false;
    if (is_buried(a, p) || z > a->highest + WET_MARGIN) return -1.0;
    if (!stretched && z < -a->highest) return -z; // whatever the surface does
    double eta = (double)s->eta;
    if (!s->is_known) eta = height_over_level(a, s, r), *found = true;
    const double total = a->flow->depth + eta;
    if (z > eta + WET_MARGIN || !(total > 0.0)) return -1.0;
    return fmax(stretched ? a->flow->depth * (eta - z) / total : -z, 0.0);
}

static void set_kinematics(const asked *a, const flow_motion *m, bolan_kinematics *out) {
    out->velocity = bolan_v3((float)m->vx + a->flow->current_x, (float)m->vy + a->flow->current_y, (float)m->vz);
    out->acceleration = bolan_v3((float)m->ax, (float)m->ay, (float)m->az);
    out->pressure = (float)(-BOLAN_SEA_WATER_DENSITY * m->potential);
    out->wet = true;
}

// What a sea of order 2 has at a point, `below` under the mean level. Layers are of first order.
static void answer_second(const asked *a, double x, double y, double below, bool stretched, bolan_kinematics *out) {
    rest r = {.x = x, .y = y, .depth = INFINITY};
    for (uint32_t i = 0; i < BOLAN_MAX_CASCADES; i++) r.keep[i] = 1.0f;
    attenuate(a, &r);
    flow_water w;
    bolan_flow_ride(a->flow, x, y, below, !stretched, a->smoothing, r.keep, a->share, &w);
    flow_motion m = {.vx = w.velocity[0],
                     .vy = w.velocity[1],
                     .vz = w.velocity[2],
                     .ax = w.acceleration[0],
                     .ay = w.acceleration[1],
                     .az = w.acceleration[2],
                     .potential = -w.pressure};
    add_layer_flows(a, &r, fmax(below, 0.0), &m);
    set_kinematics(a, &m, out);
}

// `at` holds the weights of the last depth.
static void answer_below(const asked *a, bolan_dvec3 p, sought *s, flow_depth *at, bolan_kinematics *out) {
    rest r;
    bool found;
    *out = (bolan_kinematics){0};
    if (!isfinite(p.x) || !isfinite(p.y) || !isfinite(p.z)) return;
    const double below = depth_at_rest(a, p, s, &r, &found);
    if (below < 0.0) return;
    if (a->bound) {
        const bool stretched = a->question.stretching == BOLAN_STRETCH_WHEELER;
        answer_second(a, p.x, p.y, stretched ? below : a->water->level - p.z, stretched, out);
        return;
    }
    if (at->below != below) bolan_flow_depth(a->flow, below, a->smoothing, at);
    if (!found || below > 0.0) {
        if (found) s->near = (bolan_dvec2){r.x, r.y};
        const bolan_dvec2 start = below <= a->highest ? s->near : (bolan_dvec2){p.x, p.y};
        find_rest(a, at, s, start, s->is_known && below == 0.0, &r);
    }
    flow_motion m = r.motion;
    add_layer_flows(a, &r, below, &m);
    set_kinematics(a, &m, out);
}

// ---- the surface ----------------------------------------------------------------------------------------------------

// As normal_of() of query.c.
static bolan_vec3 normal_of(const asked *a, const rest *r, const flow_motion *m) {
    const double c = (double)a->flow->choppiness;
    const double xx = 1.0 + c * r->bend.dxx, yy = 1.0 + c * r->bend.dyy, xy = c * r->bend.dxy, j = xx * yy - xy * xy;
    const double sign = j < 0.0 ? -1.0 : 1.0;
    const bolan_vec3 n = {(float)(-sign * (m->slope_x * yy - m->slope_y * xy)),
                          (float)(-sign * (m->slope_y * xx - m->slope_x * xy)), (float)(sign * j)};
    return bolan_v3_length(n) > 0.0f ? bolan_v3_normalize(n) : bolan_v3(0.0f, 0.0f, 1.0f);
}

// Rate of the height at a fixed point: parcels bring their own heights along. They move as the picture shows them.
static double rise_of(const asked *a, const flow_motion *sea, double vz, bolan_vec3 normal) {
    if (!((double)normal.z > STEEPEST)) return vz;
    const double c = (double)a->flow->choppiness;
    const double ux = (double)a->flow->current_x + c * sea->vx, uy = (double)a->flow->current_y + c * sea->vy;
    return vz + (ux * (double)normal.x + uy * (double)normal.y) / (double)normal.z;
}

// Rate of the height of the bound waves at a rest point: that of their products (bolan_bound_weights).
static double rate_of_bound_waves(const asked *a, const flow_spot *spot, const rest *r) {
    double sum = 0.0, height = 0.0, dx = 0.0, dy = 0.0, vx = 0.0, vy = 0.0,
           vz = 0.0; // of the longer cascades, weighted
    for (uint32_t i = 0; i < a->flow->bands; i++) {
        const bolan_bound_weights *w = &a->water->sea->shared->bound[i];
        float keep[BOLAN_MAX_CASCADES] = {0.0f};
        keep[i] = r->keep[i] * a->share[i];
        flow_bend d;
        flow_motion m;
        bolan_flow_read(a->flow, &a->all, spot, r->x, r->y, keep, &d, &m);
        sum += m.vz * (2.0 * w->height * m.height + height) + m.height * vz;
        sum += m.vx * (2.0 * w->drift * d.dx + dx) + d.dx * vx + m.vy * (2.0 * w->drift * d.dy + dy) + d.dy * vy;
        height += w->height_long * m.height, vz += w->height_long * m.vz;
        dx += w->drift_long * d.dx, vx += w->drift_long * m.vx;
        dy += w->drift_long * d.dy, vy += w->drift_long * m.vy;
    }
    return sum;
}

static void answer_motion(const asked *a, bolan_dvec2 p, sought *s, bolan_surface_motion *out) {
    rest r;
    *out = (bolan_surface_motion){.height = (float)a->water->level, .normal = {0.0f, 0.0f, 1.0f}};
    if (!isfinite(p.x) || !isfinite(p.y)) return;
    find_rest(a, &a->surface, s, s->near, s->is_known, &r);
    flow_motion m = r.motion;
    add_layer_heights(a, &r, &m);
    add_layer_flows(a, &r, 0.0, &m);
    out->height = (float)(a->water->level + m.height);
    out->normal = normal_of(a, &r, &m);
    if (r.depth <= 0.0) return; // land
    bolan_kinematics k;
    if (a->bound) {
        const bool stretched = a->question.stretching == BOLAN_STRETCH_WHEELER;
        answer_second(a, p.x, p.y, stretched ? 0.0 : -m.height, stretched, &k);
        m.vz += rate_of_bound_waves(a, &s->spot, &r);
    } else {
        set_kinematics(a, &m, &k);
    }
    out->velocity = k.velocity;
    out->acceleration = k.acceleration;
    out->rise = (float)rise_of(a, &r.motion, m.vz, out->normal);
}

// ---- batches --------------------------------------------------------------------------------------------------------

// The surface over points, by all waves; `known` says for which it is asked. What one point gets does not depend on the
// others.
static void seek(const asked *a, const bolan_dvec2 *xy, const bool *known, uint32_t count, sought *out) {
    float height[BATCH];
    bolan_vec2 offset[BATCH];
    bool any = false;
    for (uint32_t i = 0; i < count; i++) {
        out[i] = (sought){.x = xy[i].x, .y = xy[i].y, .near = xy[i], .is_known = known[i] && !a->filtered};
        any |= out[i].is_known;
    }
    if (any) bolan_query_rest_points(&a->heights, xy, count, height, offset);
    for (uint32_t i = 0; i < count; i++) {
        if (isfinite(xy[i].x) && isfinite(xy[i].y)) bolan_flow_spot(a->flow, xy[i].x, xy[i].y, &out[i].spot);
        if (!out[i].is_known) continue;
        out[i].near = (bolan_dvec2){xy[i].x + (double)offset[i].x, xy[i].y + (double)offset[i].y};
        out[i].eta = (float)((double)height[i] - a->water->level);
    }
}

// While point i is answered, what the next one reads comes to the cache.
static void look_ahead(const asked *a, const flow_depth *at, const sought *s, uint32_t i, uint32_t count) {
    if (i + 1 < count) bolan_flow_prefetch(a->flow, at, &s[i + 1].spot, s[i + 1].near.x, s[i + 1].near.y);
}

static bool is_near_surface(const asked *a, double z) {
    return a->question.stretching == BOLAN_STRETCH_WHEELER || fabs(z - a->water->level) <= a->highest + WET_MARGIN;
}

static void answer_batch_below(const asked *a, uint32_t first, uint32_t count, flow_depth *at) {
    bolan_dvec2 xy[BATCH];
    bool known[BATCH];
    sought s[BATCH];
    for (uint32_t i = 0; i < count; i++) {
        const bolan_dvec3 p = a->xyz[first + i];
        xy[i] = (bolan_dvec2){p.x, p.y};
        known[i] = is_near_surface(a, p.z);
    }
    seek(a, xy, known, count, s);
    for (uint32_t i = 0; i < count; i++) {
        look_ahead(a, at, s, i, count);
        answer_below(a, a->xyz[first + i], &s[i], at, &a->below[first + i]);
    }
}

// Level by level, so that the weights of a depth are made once.
static void answer_batch_columns(const asked *a, uint32_t first, uint32_t count, flow_depth *at) {
    bool known[BATCH], any = false;
    sought s[BATCH];
    for (uint32_t l = 0; l < a->levels; l++) any |= is_near_surface(a, a->z[l]);
    for (uint32_t i = 0; i < count; i++) known[i] = any;
    seek(a, a->xy + first, known, count, s);
    for (uint32_t l = 0; l < a->levels; l++) {
        bolan_kinematics *out = a->below + (size_t)l * a->columns + first;
        for (uint32_t i = 0; i < count; i++) {
            sought one = s[i];
            look_ahead(a, at, s, i, count);
            one.is_known = one.is_known && is_near_surface(a, a->z[l]);
            if (!one.is_known) one.near = a->xy[first + i];
            answer_below(a, (bolan_dvec3){a->xy[first + i].x, a->xy[first + i].y, a->z[l]}, &one, at, &out[i]);
        }
    }
}

static void answer_batch_motion(const asked *a, uint32_t first, uint32_t count) {
    sought s[BATCH];
    bool known[BATCH];
    for (uint32_t i = 0; i < count; i++) known[i] = true;
    seek(a, a->xy + first, known, count, s);
    for (uint32_t i = 0; i < count; i++) {
        look_ahead(a, &a->surface, s, i, count);
        answer_motion(a, a->xy[first + i], &s[i], &a->motion[first + i]);
    }
}

// Task: points [begin, end).
static void answer_points(void *context, uint32_t begin, uint32_t end, uint32_t worker) {
    (void)worker;
    const asked *a = context;
    flow_depth at = a->surface;
    for (uint32_t first = begin; first < end; first += BATCH) {
        const uint32_t count = end - first < BATCH ? end - first : BATCH;
        if (a->z) {
            answer_batch_columns(a, first, count, &at);
        } else if (a->below) {
            answer_batch_below(a, first, count, &at);
        } else {
            answer_batch_motion(a, first, count);
        }
    }
}

static bool is_answerable(const bolan_water *water, const bolan_question *q) {
    if (!bolan_water_is_valid(water) || !water->flow) return false;
    if (water->flow->sea_id != bolan_sea_id(water->sea) || water->flow->time != bolan_sea_time(water->sea))
        return false;
    return !q || (q->least_wavelength >= 0.0 && q->least_wavelength <= 1e5);
}

static void ask(asked *a, const bolan_water *water, const bolan_question *question, uint32_t count) {
    double horizontal;
    a->water = water;
    a->flow = water->flow;
    a->question = question ? *question : bolan_question_default();
    a->smoothing = flow_smoothing(a->question.least_wavelength);
    bolan_water_bounds(water, &a->highest, &horizontal);
    bolan_flow_lifts(a->flow, a->smoothing, a->lift);
    a->bound = bolan_sea_get_desc(water->sea)->order > 1;
    if (a->bound) bolan_flow_shares(a->flow, a->smoothing, a->share);
    bolan_flow_depth(a->flow, 0.0, a->smoothing, &a->surface);
    if (a->bound) bolan_flow_depth(a->flow, 0.0, 0.0, &a->all);
    bolan_query_prepare(water, &a->heights);
    a->filtered = a->smoothing > 0.0 || !a->heights.kernels->approach;
    if (count <= GRAIN_POINTS) {
        answer_points(a, 0, count, 0); // not worth waking anybody
    } else {
        bolan_parallel(count, GRAIN_POINTS, answer_points, a);
    }
}

void bolan_query_below(const bolan_water *water, const bolan_question *question, const bolan_dvec3 *xyz, uint32_t count,
                       bolan_kinematics *out) {
    const bool valid = is_answerable(water, question) && (count == 0 || (xyz && out));
    BOLAN_ASSERT(valid);
    if (!valid) return;
    asked a = {.xyz = xyz, .below = out};
    ask(&a, water, question, count);
}

void bolan_query_levels(const bolan_water *water, const bolan_question *question, const bolan_dvec2 *xy, uint32_t count,
                        const double *z, uint32_t levels, bolan_kinematics *out) {
    const bool valid = is_answerable(water, question) && (count == 0 || levels == 0 || (xy && z && out));
    BOLAN_ASSERT(valid);
    if (!valid || count == 0 || levels == 0) return;
    asked a = {.xy = xy, .columns = count, .z = z, .levels = levels, .below = out};
    ask(&a, water, question, count);
}

void bolan_query_motion(const bolan_water *water, const bolan_question *question, const bolan_dvec2 *xy, uint32_t count,
                        bolan_surface_motion *out) {
    const bool valid = is_answerable(water, question) && (count == 0 || (xy && out));
    BOLAN_ASSERT(valid);
    if (!valid) return;
    asked a = {.xy = xy, .motion = out};
    ask(&a, water, question, count);
}

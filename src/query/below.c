// SPDX-License-Identifier: MIT
// Questions to the moving water. Each point is answered by itself: its depth at rest, its rest point by Newton's method
// on the displacement at that depth, and the gradients of the flow's potentials there (flow/tables.h).
#include "bolan/coast.h"
#include "bolan/query.h"

#include "flow/tables.h"
#include "water/layer.h"

#include <math.h>

enum { GRAIN_POINTS = 64, STEPS = 10 };
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
    flow_depth surface; // depth 0
    // One of two questions.
    const bolan_dvec3 *xyz;
    bolan_kinematics *below;
    const bolan_dvec2 *xy;
    bolan_surface_motion *motion;
} asked;

// A parcel at rest, and what shallow water leaves of each band there.
typedef struct rest {
    double x, y, depth; // of the water under it [m]
    float keep[BOLAN_MAX_CASCADES];
    flow_bend bend;
} rest;

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

// The parcel that stands over (x, y), at the depth of rest `at`; the search begins at `start`.
static rest find_rest(const asked *a, const flow_depth *at, double x, double y, bolan_dvec2 start) {
    rest r = {.x = start.x, .y = start.y, .depth = INFINITY};
    const double choppiness = (double)a->flow->choppiness;
    for (uint32_t i = 0; i < BOLAN_MAX_CASCADES; i++) r.keep[i] = 1.0f;
    for (int i = 0; i < STEPS; i++) {
        attenuate(a, &r);
        if (choppiness == 0.0) break; // parcels stand where they rest
        bolan_flow_bend(a->flow, at, r.x, r.y, r.keep, &r.bend);
        const double rx = r.x - x + choppiness * r.bend.dx, ry = r.y - y + choppiness * r.bend.dy;
        if (rx * rx + ry * ry < CONVERGED * CONVERGED) break;
        advance(&r, choppiness, rx, ry);
    }
    return r;
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

// Height over the level at a rest point of the surface; `m` holds that of the sea.
static void add_layer_heights(const asked *a, const rest *r, flow_motion *m) {
    for (uint32_t i = 0; i < a->flow->bands; i++)
        m->height += (double)(r->keep[i] * r->keep[i] * a->lift[i]); // a product of two that are attenuated
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

// *over: the rest point of the parcel that is there.
static double height_over_level(const asked *a, double x, double y, bolan_dvec2 *over) {
    const rest r = find_rest(a, &a->surface, x, y, *over);
    *over = (bolan_dvec2){r.x, r.y};
    flow_motion m;
    bolan_flow_motion(a->flow, &a->surface, r.x, r.y, r.keep, &m);
    add_layer_heights(a, &r, &m);
    return m.height;
}

static bool is_buried(const asked *a, bolan_dvec3 p) {
    return a->water->ground && p.z < (double)bolan_ground_elevation(a->water->ground, p.x, p.y, GROUND_RESOLUTION);
}

// Depth at rest of a point that is in the water; < 0 of one that is not. *near becomes a place near its rest point.
static double depth_at_rest(const asked *a, bolan_dvec3 p, bolan_dvec2 *near) {
    const double z = p.z - a->water->level;
    const bool stretched = a->question.stretching == BOLAN_STRETCH_WHEELER;
    if (is_buried(a, p) || z > a->highest + WET_MARGIN) return -1.0;
    if (!stretched && z < -a->highest) return -z; // whatever the surface does
    const double eta = height_over_level(a, p.x, p.y, near), total = a->flow->depth + eta;
    if (z > eta + WET_MARGIN || !(total > 0.0)) return -1.0;
    return fmax(stretched ? a->flow->depth * (eta - z) / total : -z, 0.0);
}

static void answer_below(const asked *a, bolan_dvec3 p, bolan_kinematics *out) {
    *out = (bolan_kinematics){0};
    if (!isfinite(p.x) || !isfinite(p.y) || !isfinite(p.z)) return;
    bolan_dvec2 near = {p.x, p.y};
    const double below = depth_at_rest(a, p, &near);
    if (below < 0.0) return;
    flow_depth at;
    flow_motion m;
    bolan_flow_depth(a->flow, below, a->smoothing, &at);
    const rest r = find_rest(a, &at, p.x, p.y, near);
    bolan_flow_motion(a->flow, &at, r.x, r.y, r.keep, &m);
    add_layer_flows(a, &r, below, &m);
    out->velocity = bolan_v3((float)m.vx + a->flow->current_x, (float)m.vy + a->flow->current_y, (float)m.vz);
    out->acceleration = bolan_v3((float)m.ax, (float)m.ay, (float)m.az);
    out->pressure = (float)(-BOLAN_SEA_WATER_DENSITY * m.potential);
    out->wet = true;
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

static void answer_motion(const asked *a, bolan_dvec2 p, bolan_surface_motion *out) {
    *out = (bolan_surface_motion){.height = (float)a->water->level, .normal = {0.0f, 0.0f, 1.0f}};
    if (!isfinite(p.x) || !isfinite(p.y)) return;
    const rest r = find_rest(a, &a->surface, p.x, p.y, p);
    flow_motion sea;
    bolan_flow_motion(a->flow, &a->surface, r.x, r.y, r.keep, &sea);
    flow_motion m = sea;
    add_layer_heights(a, &r, &m);
    add_layer_flows(a, &r, 0.0, &m);
    out->height = (float)(a->water->level + m.height);
    out->normal = normal_of(a, &r, &m);
    if (r.depth <= 0.0) return; // land
    out->velocity = bolan_v3((float)m.vx + a->flow->current_x, (float)m.vy + a->flow->current_y, (float)m.vz);
    out->acceleration = bolan_v3((float)m.ax, (float)m.ay, (float)m.az);
    out->rise = (float)rise_of(a, &sea, m.vz, out->normal);
}

// ---- batches --------------------------------------------------------------------------------------------------------

// Task: points [begin, end).
static void answer_points(void *context, uint32_t begin, uint32_t end, uint32_t worker) {
    (void)worker;
    const asked *a = context;
    for (uint32_t i = begin; i < end; i++) {
        if (a->below) {
            answer_below(a, a->xyz[i], &a->below[i]);
        } else {
            answer_motion(a, a->xy[i], &a->motion[i]);
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
    bolan_flow_depth(a->flow, 0.0, a->smoothing, &a->surface);
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

void bolan_query_motion(const bolan_water *water, const bolan_question *question, const bolan_dvec2 *xy, uint32_t count,
                        bolan_surface_motion *out) {
    const bool valid = is_answerable(water, question) && (count == 0 || (xy && out));
    BOLAN_ASSERT(valid);
    if (!valid) return;
    asked a = {.xy = xy, .motion = out};
    ask(&a, water, question, count);
}

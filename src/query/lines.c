// SPDX-License-Identifier: MIT
// The surface along lines: the first hit of a ray, and crests.
//
// A ray is clipped to the slab that the surface does not leave, and scanned in intervals of 16. Let f be the height of
// the ray over the surface and L a bound of |df/dt|: between two points at distance D f is at least (f0 + f1 - L D) /
// 2, so the surface is not met where that is positive. Other intervals are cut into 16 again, until L D is so small
// that the ray can cut no more than a grazing crest.
#include "bolan/query.h"

#include "water/layer.h"
#include "waves/model.h"

#include <math.h>

enum { PARTS = 16, LEVELS = 6, CREST_BATCH = 256, CREST_ROUNDS = 4 };
#define BLOCK 32.0       // [m] of a ray that are scanned at once
#define GRAZING 0.01     // [m] L D of the last intervals: twice what may be passed over
#define CLOSE 5e-4       // [m] of a hit, along the vertical
#define SLOPE_SIGMAS 8.0 // steepest slope, in standard deviations
#define LEAST_SLOPE 0.2
#define GREATEST_SLOPE 2.5

typedef struct line {
    const bolan_water *water;
    const bolan_question *question;
    bolan_dvec3 origin, along; // along: unit vector
    double steepness;          // L
} line;

static bool has_filter(const bolan_question *q) { return q && q->least_wavelength > 0.0; }

// Heights at up to CREST_BATCH places.
static void heights_at(const bolan_water *water, const bolan_question *question, const bolan_dvec2 *xy, uint32_t count,
                       float *out) {
    if (!has_filter(question)) {
        bolan_query_heights(water, xy, count, out);
        return;
    }
    for (uint32_t i = 0; i < count; i++) {
        bolan_surface_motion m;
        bolan_query_motion(water, question, &xy[i], 1, &m);
        out[i] = m.height;
    }
}

// ---- rays -----------------------------------------------------------------------------------------------------------

// Height of the line over the surface at `count` <= PARTS + 1 equal steps from t0.
static void over_surface(const line *l, double t0, double step, uint32_t count, double *out) {
    bolan_dvec2 xy[PARTS + 1];
    float height[PARTS + 1];
    for (uint32_t i = 0; i < count; i++) {
        const double t = t0 + step * i;
        xy[i] = (bolan_dvec2){l->origin.x + t * l->along.x, l->origin.y + t * l->along.y};
    }
    heights_at(l->water, l->question, xy, count, height);
    for (uint32_t i = 0; i < count; i++) out[i] = l->origin.z + (t0 + step * i) * l->along.z - (double)height[i];
}

// The root between a and b, where f has different signs (Dowell & Jarratt 1971, the Illinois rule).
static double root(const line *l, double a, double fa, double b, double fb) {
    for (int i = 0; i < 60; i++) {
        const double t = (fb * a - fa * b) / (fb - fa);
        double f;
        over_surface(l, t, 0.0, 1, &f);
        if (fabs(f) < CLOSE || fabs(b - a) < 1e-9) return t;
        if ((f < 0.0) == (fb < 0.0)) {
            fa *= 0.5;
        } else {
            a = b, fa = fb;
        }
        b = t, fb = f;
    }
    return b;
}

// The first hit in [t0, t1]; false where there is none.
static bool scan(const line *l, double t0, double t1, int level, double *hit) {
    const double step = (t1 - t0) / PARTS;
    double f[PARTS + 1];
    over_surface(l, t0, step, PARTS + 1, f);
    for (int i = 0; i < PARTS; i++) {
        const double a = t0 + step * i, b = a + step, reach = l->steepness * step;
        const bool crosses = (f[i] < 0.0) != (f[i + 1] < 0.0);
        if (!crosses && fabs(f[i] + f[i + 1]) > reach) continue;
        if (reach > GRAZING && level < LEVELS) {
            if (scan(l, a, b, level + 1, hit)) return true;
        } else if (crosses) {
            *hit = root(l, a, f[i], b, f[i + 1]);
            return true;
        }
    }
    return false;
}

// Slopes of the whole sea: a layer adds its steepest.
static double steepest(const bolan_water *water) {
    double slope[3] = {0.0};
    water->sea->shared->model->slopes(water->sea->shared, slope);
    double sum = SLOPE_SIGMAS * sqrt(slope[0] + slope[2]);
    for (uint32_t i = 0; i < water->layer_count; i++) {
        const bolan_wave_layer *layer = water->layers[i];
        sum += sqrt(layer->kx * layer->kx + layer->ky * layer->ky) * layer->bound;
    }
    return fmin(fmax(sum, LEAST_SLOPE), GREATEST_SLOPE);
}

// The part of the ray in the slab between low and high.
static bool clip(const bolan_ray *r, double dz, double low, double high, double *t0, double *t1) {
    *t0 = 0.0, *t1 = r->length;
    if (dz == 0.0) return r->origin.z >= low && r->origin.z <= high;
    const double a = (low - r->origin.z) / dz, b = (high - r->origin.z) / dz;
    *t0 = fmax(*t0, fmin(a, b));
    *t1 = fmin(*t1, fmax(a, b));
    return *t0 <= *t1;
}

static void follow(const bolan_water *water, const bolan_question *question, double slope, double bound,
                   const bolan_ray *r, bolan_ray_hit *out) {
    const double length =
        sqrt(r->direction.x * r->direction.x + r->direction.y * r->direction.y + r->direction.z * r->direction.z);
    *out = (bolan_ray_hit){.hit = false};
    if (!(length > 0.0) || !isfinite(length + r->origin.x + r->origin.y + r->origin.z) || !(r->length > 0.0)) return;
    line l = {
        water, question, r->origin, {r->direction.x / length, r->direction.y / length, r->direction.z / length}, 0.0};
    l.steepness = fabs(l.along.z) + slope * sqrt(l.along.x * l.along.x + l.along.y * l.along.y);
    double t0, t1, t;
    if (!clip(r, l.along.z, water->level - bound, water->level + bound, &t0, &t1)) return;
    for (double from = t0; from < t1; from += BLOCK) {
        if (!scan(&l, from, fmin(from + BLOCK, t1), 0, &t)) continue;
        *out = (bolan_ray_hit){
            .hit = true,
            .distance = t,
            .point = {r->origin.x + t * l.along.x, r->origin.y + t * l.along.y, r->origin.z + t * l.along.z},
        };
        return;
    }
}

typedef struct rays {
    const bolan_water *water;
    const bolan_question *question;
    double slope, bound;
    const bolan_ray *rays;
    bolan_ray_hit *out;
} rays;

// Task: rays [begin, end).
static void follow_rays(void *context, uint32_t begin, uint32_t end, uint32_t worker) {
    (void)worker;
    const rays *r = context;
    for (uint32_t i = begin; i < end; i++) follow(r->water, r->question, r->slope, r->bound, &r->rays[i], &r->out[i]);
}

void bolan_query_rays(const bolan_water *water, const bolan_question *question, const bolan_ray *ray, uint32_t count,
                      bolan_ray_hit *out) {
    const bool valid =
        bolan_water_is_valid(water) && (count == 0 || (ray && out)) && (!has_filter(question) || water->flow);
    BOLAN_ASSERT(valid);
    if (!valid) return;
    rays r = {.water = water, .question = question, .slope = steepest(water), .rays = ray, .out = out};
    double horizontal;
    bolan_water_bounds(water, &r.bound, &horizontal);
    r.bound += GRAZING;
    bolan_parallel(count, 1, follow_rays, &r);
}

// ---- crests ---------------------------------------------------------------------------------------------------------

typedef struct walk {
    const bolan_water *water;
    const bolan_question *question;
    bolan_dvec2 from, along; // along: per metre
} walk;

static void heights_along(const walk *w, double t0, double step, uint32_t count, float *out) {
    bolan_dvec2 xy[CREST_BATCH];
    for (uint32_t i = 0; i < count; i++) {
        const double t = t0 + step * i;
        xy[i] = (bolan_dvec2){w->from.x + t * w->along.x, w->from.y + t * w->along.y};
    }
    heights_at(w->water, w->question, xy, count, out);
}

// The top between t - step and t + step: the highest of 17 places, and again around it.
static bolan_crest refine(const walk *w, double t, double step) {
    float height[PARTS + 1];
    bolan_crest best = {t, 0.0f};
    for (int round = 0; round < CREST_ROUNDS; round++, step *= 2.0 / PARTS) {
        const double first = best.distance - step;
        uint32_t top = 0;
        heights_along(w, first, 2.0 * step / PARTS, PARTS + 1, height);
        for (uint32_t i = 1; i <= PARTS; i++) top = height[i] > height[top] ? i : top;
        best = (bolan_crest){first + 2.0 * step / PARTS * top, height[top]};
    }
    return best;
}

uint32_t bolan_query_crests(const bolan_water *water, const bolan_question *question, bolan_dvec2 from, bolan_dvec2 to,
                            double step, uint32_t capacity, bolan_crest *out) {
    const double length = hypot(to.x - from.x, to.y - from.y);
    const bool valid = bolan_water_is_valid(water) && (capacity == 0 || out) && step >= 0.001 && step <= 1e4 &&
                       length <= 1e7 * step && (!has_filter(question) || water->flow);
    BOLAN_ASSERT(valid);
    if (!valid || !(length > 0.0)) return 0;
    const walk w = {water, question, from, {(to.x - from.x) / length, (to.y - from.y) / length}};
    const uint32_t steps = (uint32_t)(length / step);
    uint32_t found = 0;
    float height[CREST_BATCH];
    for (uint32_t first = 0; first + 2 <= steps; first += CREST_BATCH - 2) { // batches share two places
        const uint32_t left = steps + 1 - first, count = left < CREST_BATCH ? left : CREST_BATCH;
        heights_along(&w, step * first, step, count, height);
        for (uint32_t i = 1; i + 1 < count; i++) {
            if (!(height[i] > height[i - 1] && height[i] >= height[i + 1])) continue;
            if (found < capacity) out[found] = refine(&w, step * (first + i), step);
            found++;
        }
    }
    return found;
}

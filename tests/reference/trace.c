// SPDX-License-Identifier: MIT
// A path tracer of Bolan's sea, for the shading of physical optics to be compared with: see README.md.
//
// Rays march over the heights of bolan_query_heights(): all cascades, no filter by pixel. Fine waves and capillaries
// beyond them are slopes of the place that is hit. Rays of a row of pixels are marched together.
//
//   eye -> place on the sea -> a visible facet -> sky, or a second place -> a facet -> sky
//                           -> sun, unless a wave stands before it
//                           -> light that leaves the water
#include "exr.h"
#include "facets.h"
#include "shared/bed.glsl"

#include "bolan/io.h"
#include "bolan/query.h"
#include "bolan/render.h"
#include "bolan/world.h"

#include <stdlib.h>

enum { SKY_WIDTH = 2048, SKY_HEIGHT = 1024, STEPS = 600 };
#define STEEPEST 0.7     // slope that steps allow for; a steeper wave is passed and found again by bisection
#define FARTHEST 30000.0 // [m]

typedef struct ray {
    vec from, dir;
    double t, before, after; // [m]; the last place over the surface, and the first under it (0: none yet)
    bool done, hit;
    uint32_t pixel;
} ray;

typedef struct place {
    vec at;
    double sx, sy;
    double shown; // area that the facets show to the ray, over that of the marched surface
} place;

typedef struct tracer {
    const bolan_water *water;
    bolan_sea_fine_view fine;
    covariance beyond; // slopes of no wave
    double highest;    // of the surface [m]
    float *sky;
    bolan_sky_light light;
    vec sun, below; // below: radiance under the surface over index squared, by channel
    bool furnace;   // everything around shines with radiance 1
    uint64_t random;
    bolan_dvec2 *xy;
    float *heights;
    uint32_t *active;
    bolan_query_point *points;
} tracer;

// ---- rays over the sea ----------------------------------------------------------------------------------------------

// Halves the stretch between `before`, over the surface, and `after`, under it.
static void halve(ray *r, double gap, double fine) {
    if (gap >= 0.0)
        r->before = r->t;
    else
        r->after = r->t;
    r->hit = r->done = fabs(gap) < fine || r->after - r->before < 1e-5 * (1.0 + r->t);
    r->t = 0.5 * (r->before + r->after);
}

static void step_ray(const tracer *t, ray *r, double height) {
    const double gap = r->from.z + r->t * r->dir.z - height, level = hypot(r->dir.x, r->dir.y);
    const double fine = 2e-4 + 2e-5 * r->t;
    if (r->after > 0.0 || gap < 0.0) {
        halve(r, gap, fine);
        return;
    }
    r->before = r->t;
    r->t += fmax(gap / fmax(STEEPEST * level - r->dir.z, 1e-3), 0.01 + 2e-4 * r->t);
    r->done = r->t > FARTHEST || (r->dir.z >= 0.0 && r->from.z + r->t * r->dir.z > t->highest);
}

static void march(tracer *t, ray *rays, uint32_t count) {
    for (int step = 0; step < STEPS; ++step) {
        uint32_t n = 0;
        for (uint32_t i = 0; i < count; ++i) {
            if (rays[i].done) continue;
            const vec p = along(rays[i].from, rays[i].t, rays[i].dir);
            t->active[n] = i, t->xy[n++] = (bolan_dvec2){p.x, p.y};
        }
        if (n == 0) return;
        bolan_query_heights(t->water, t->xy, n, t->heights);
        for (uint32_t i = 0; i < n; ++i) step_ray(t, &rays[t->active[i]], (double)t->heights[i]);
    }
    for (uint32_t i = 0; i < count; ++i) rays[i].hit |= !rays[i].done && rays[i].dir.z < 0.0;
}

static void fine_slope(const tracer *t, bolan_dvec2 at, double *sx, double *sy) {
    const bolan_sea_fine_view *f = &t->fine;
    if (f->n == 0) return;
    const double c = cos(f->angle), s = sin(f->angle), n = f->n;
    double u = (at.x * c + at.y * s) / f->length, v = (at.y * c - at.x * s) / f->length;
    u = (u - floor(u)) * n, v = (v - floor(v)) * n;
    const uint32_t i = (uint32_t)u % f->n, j = (uint32_t)v % f->n, i1 = (i + 1) % f->n, j1 = (j + 1) % f->n;
    const double a = u - floor(u), b = v - floor(v);
    const double w[4] = {(1 - a) * (1 - b), a * (1 - b), (1 - a) * b, a * b};
    const uint32_t at4[4] = {j * f->n + i, j * f->n + i1, j1 * f->n + i, j1 * f->n + i1};
    double gx = 0.0, gy = 0.0; // in the axes of the tile
    for (int k = 0; k < 4; ++k) gx += w[k] * (double)f->slope_x[at4[k]], gy += w[k] * (double)f->slope_y[at4[k]];
    *sx += gx, *sy += gy;
}

static void places_of(tracer *t, const ray *rays, uint32_t count, place *out) {
    for (uint32_t i = 0; i < count; ++i) {
        const vec p = along(rays[i].from, rays[i].t, rays[i].dir);
        t->xy[i] = (bolan_dvec2){p.x, p.y};
    }
    bolan_query_surface(t->water, t->xy, count, t->points);
    for (uint32_t i = 0; i < count; ++i) {
        const bolan_vec3 n = t->points[i].normal;
        const double up = fmax((double)n.z, 0.1);
        out[i] =
            (place){{t->xy[i].x, t->xy[i].y, (double)t->points[i].height}, -(double)n.x / up, -(double)n.y / up, 1.0};
        const vec d = rays[i].dir;
        const double whole = fmax(out[i].sx * d.x + out[i].sy * d.y - d.z, 0.02);
        fine_slope(t, t->xy[i], &out[i].sx, &out[i].sy);
        out[i].shown = fmax(out[i].sx * d.x + out[i].sy * d.y - d.z, 0.0) / whole;
    }
}

// ---- light ----------------------------------------------------------------------------------------------------------

static double sky_in(const tracer *t, vec d, int channel) {
    if (t->furnace) return 1.0;
    double x = (atan2(d.x, d.y) / 6.283185307179586 + 0.5) * SKY_WIDTH - 0.5;
    double y = (0.5 - asin(fmin(fmax(d.z, 0.0), 1.0)) / 3.141592653589793) * SKY_HEIGHT - 0.5;
    y = fmin(fmax(y, 0.0), SKY_HEIGHT / 2 - 1);
    const double a = x - floor(x), b = y - floor(y);
    const int i = ((int)floor(x) + SKY_WIDTH) % SKY_WIDTH, i1 = (i + 1) % SKY_WIDTH, j = (int)y, j1 = j + 1;
    const float *s = t->sky + channel;
    return (1 - b) * ((1 - a) * (double)s[3 * (j * SKY_WIDTH + i)] + a * (double)s[3 * (j * SKY_WIDTH + i1)]) +
           b * ((1 - a) * (double)s[3 * (j1 * SKY_WIDTH + i)] + a * (double)s[3 * (j1 * SKY_WIDTH + i1)]);
}

static double channel_of(bolan_vec3 v, int c) { return (double)(&v.x)[c]; }
static double below_in(const tracer *t, int c) { return t->furnace ? 1.0 : (&t->below.x)[c]; }

// Of the second place on a path: its mirrored ray ends in the sky.
static void second_light(tracer *t, const place *p, vec to_eye, double out[3]) {
    const vec n = visible_facet(&t->random, to_eye, p->sx, p->sy, t->beyond);
    const double f = fresnel(fmin(fmax(dot3(n, to_eye), 0.0), 1.0), WATER_INDEX);
    vec d = mirrored(to_eye, n);
    d.z = fabs(d.z);
    const double sun = t->furnace ? 0.0 : sun_by_facets(to_eye, t->sun, p->sx, p->sy, t->beyond);
    for (int c = 0; c < 3; ++c)
        out[c] = f * sky_in(t, d, c) + (1.0 - f) * below_in(t, c) + sun * channel_of(t->light.sun_irradiance, c);
}

static ray ray_from(const place *p, vec dir, uint32_t pixel) {
    const vec lifted = along(p->at, 2e-3, (vec){0, 0, 1});
    return (ray){.from = lifted, .dir = dir, .pixel = pixel};
}

// Light of `count` places that rays have hit, added to `sum` (per pixel and channel). second, suns: room for as many.
static void shade(tracer *t, const ray *hits, const place *places, uint32_t count, ray *second, ray *suns, place *again,
                  double *out) {
    double *f = malloc(sizeof(double) * count);
    for (uint32_t i = 0; i < count; ++i) {
        const vec to_eye = {-hits[i].dir.x, -hits[i].dir.y, -hits[i].dir.z};
        const vec n = visible_facet(&t->random, to_eye, places[i].sx, places[i].sy, t->beyond);
        f[i] = fresnel(fmin(fmax(dot3(n, to_eye), 0.0), 1.0), WATER_INDEX);
        second[i] = ray_from(&places[i], mirrored(to_eye, n), i);
        suns[i] = ray_from(&places[i], t->sun, i);
        const double sun = t->furnace ? 0.0 : sun_by_facets(to_eye, t->sun, places[i].sx, places[i].sy, t->beyond);
        suns[i].done = sun < 1e-6;
        for (int c = 0; c < 3; ++c) out[3 * i + (uint32_t)c] = sun * channel_of(t->light.sun_irradiance, c);
    }
    march(t, suns, count);
    march(t, second, count);
    places_of(t, second, count, again);
    for (uint32_t i = 0; i < count; ++i) {
        double mirrored_light[3];
        const vec d = second[i].dir;
        if (second[i].hit) second_light(t, &again[i], (vec){-d.x, -d.y, -d.z}, mirrored_light);
        for (int c = 0; c < 3; ++c) {
            double *o = &out[3 * i + (uint32_t)c];
            if (suns[i].hit) *o = 0.0;
            *o += f[i] * (second[i].hit ? mirrored_light[c] : sky_in(t, d, c)) + (1.0 - f[i]) * below_in(t, c);
        }
    }
    free(f);
}

// ---- the picture ----------------------------------------------------------------------------------------------------

typedef struct camera {
    vec eye, ahead, right, up;
    double half; // tangent of half the field of view
} camera;

static camera camera_of(const reference_view *v) {
    const double h = bolan_radians(v->heading), p = bolan_radians(v->pitch);
    return (camera){.eye = {0, 0, v->height},
                    .ahead = {sin(h) * cos(p), cos(h) * cos(p), sin(p)},
                    .right = {cos(h), -sin(h), 0},
                    .up = {-sin(h) * sin(p), -cos(h) * sin(p), cos(p)},
                    .half = tan(bolan_radians(0.5 * REFERENCE_FOV))};
}

static ray eye_ray(tracer *t, const camera *c, uint32_t x, uint32_t y) {
    const double u = (2.0 * (x + uniform(&t->random)) - REFERENCE_WIDTH) / REFERENCE_HEIGHT * c->half;
    const double v = (1.0 - 2.0 * (y + uniform(&t->random)) / REFERENCE_HEIGHT) * c->half;
    ray r = {.from = c->eye, .dir = unit(along(along(c->ahead, u, c->right), v, c->up)), .pixel = x};
    r.t = r.dir.z < 0.0 ? fmax((t->highest - c->eye.z) / r.dir.z, 0.0) : 0.0;
    r.done = r.dir.z > -5e-4;
    return r;
}

static void trace_row(tracer *t, const camera *c, uint32_t y, uint32_t samples, float *out) {
    const uint32_t count = REFERENCE_WIDTH * samples;
    ray *rays = malloc(sizeof(ray) * count), *second = malloc(sizeof(ray) * count), *suns = malloc(sizeof(ray) * count);
    place *places = malloc(sizeof(place) * count), *again = malloc(sizeof(place) * count);
    double *light = malloc(sizeof(double) * 3 * count), sums[REFERENCE_WIDTH][7] = {{0}};
    for (uint32_t i = 0; i < count; ++i) rays[i] = eye_ray(t, c, i / samples, y);
    march(t, rays, count);
    uint32_t hits = 0;
    for (uint32_t i = 0; i < count; ++i)
        if (rays[i].hit) rays[hits++] = rays[i];
    places_of(t, rays, hits, places);
    shade(t, rays, places, hits, second, suns, again, light);
    for (uint32_t i = 0; i < hits; ++i) {
        double *s = sums[rays[i].pixel];
        const double *l = &light[3 * i], w = places[i].shown;
        s[0] += w * l[0], s[1] += w * l[1], s[2] += w * l[2], s[3] += w;
        s[4] += w * w, s[5] += w * w * l[1], s[6] += w * w * l[1] * l[1];
    }
    for (uint32_t x = 0; x < REFERENCE_WIDTH; ++x, out += REFERENCE_CHANNELS) {
        const double *s = sums[x], n = fmax(s[3], 1e-3), mean = s[1] / n;
        for (int k = 0; k < 3; ++k) out[k] = (float)(s[k] / n);
        out[3] = (float)(sqrt(fmax(s[6] - 2.0 * mean * s[5] + mean * mean * s[4], 0.0)) / n); // of a ratio of sums
    }
    free(rays), free(second), free(suns), free(places), free(again), free(light);
}

// Irradiance under the surface, and the radiance that the water sends up, as light_below() of water_physical.glsl has
// them, with the sum over facets in place of its formula.
static void light_the_water(tracer *t) {
    float total[3];
    double facing = 0.0, enters = 0.0;
    bolan_sea_unresolved_slopes(t->water->sea, 1e5, 1e5, 0.0, total);
    for (int i = 0; i < 100000; ++i) {
        double sx, sy;
        gaussian_slope(&t->random, (covariance){(double)total[0], (double)total[1], (double)total[2]}, &sx, &sy);
        const double area = fmax(t->sun.z - sx * t->sun.x - sy * t->sun.y, 0.0);
        facing += area;
        enters += area * (1.0 - fresnel(fmin(dot3(normal_of(sx, sy), t->sun), 1.0) * (area > 0.0), WATER_INDEX));
    }
    for (int c = 0; c < 3; ++c)
        (&t->below.x)[c] = channel_of(t->water->optics.deep, c) *
                           (channel_of(t->light.sun_irradiance, c) * fmax(t->sun.z, 0.0) * enters / facing +
                            channel_of(t->light.sky_irradiance, c) * SKY_ENTERS);
}

static bool open_tracer(tracer *t, const bolan_world *world, const bolan_scene *scene, uint32_t samples) {
    const uint32_t most = REFERENCE_WIDTH * samples;
    const bolan_lighting lighting = bolan_lighting_from_scene(scene);
    const bolan_renderer_desc desc = bolan_renderer_desc_default();
    bolan_renderer *renderer = NULL;
    double horizontal;
    float hidden[3];
    t->water = bolan_world_water(world);
    t->random = 0x853c49e6748fea9bu;
    t->xy = malloc(sizeof *t->xy * most), t->heights = malloc(sizeof *t->heights * most);
    t->active = malloc(sizeof *t->active * most), t->points = malloc(sizeof *t->points * most);
    t->sky = malloc(sizeof(float) * 3 * SKY_WIDTH * SKY_HEIGHT);
    if (bolan_renderer_create(&desc, &renderer) != BOLAN_OK) return false;
    bolan_renderer_prepare(renderer, t->water, &lighting);
    const bool good =
        bolan_renderer_read_sky(renderer, bolan_dv3(0, 0, 5), SKY_WIDTH, SKY_HEIGHT, t->sky, &t->light) == BOLAN_OK;
    bolan_renderer_destroy(&renderer);
    t->sun =
        (vec){(double)t->light.sun_direction.x, (double)t->light.sun_direction.y, (double)t->light.sun_direction.z};
    bolan_water_bounds(t->water, &t->highest, &horizontal);
    t->fine = bolan_sea_fine(t->water->sea);
    bolan_sea_unresolved_slopes(t->water->sea, 0.0, 0.0, 0.0, hidden);
    t->beyond = (covariance){fmax((double)hidden[0] - t->fine.slopes[0], 1e-6), (double)hidden[1] - t->fine.slopes[1],
                             fmax((double)hidden[2] - t->fine.slopes[2], 1e-6)};
    light_the_water(t);
    return good;
}

static void close_tracer(tracer *t) { free(t->xy), free(t->heights), free(t->active), free(t->points), free(t->sky); }

static bool trace_view(const reference_view *v, const char *folder, uint32_t samples, bool furnace) {
    const bolan_scene scene = reference_scene(v);
    bolan_world *world = NULL;
    tracer t = {.furnace = furnace};
    float *pixels = malloc(sizeof(float) * REFERENCE_CHANNELS * REFERENCE_PIXELS);
    char path[1024];
    if (bolan_world_load_scene(&scene, &world) != BOLAN_OK) return false;
    bolan_world_settle(world, scene.time);
    bool good = open_tracer(&t, world, &scene, samples);
    const camera c = camera_of(v);
    for (uint32_t y = 0; y < REFERENCE_HEIGHT && good; ++y)
        trace_row(&t, &c, y, samples, pixels + (size_t)y * REFERENCE_WIDTH * REFERENCE_CHANNELS);
    snprintf(path, sizeof path, "%s/%s.exr", folder, v->name);
    good = good && reference_write(path, pixels);
    printf("%s: slopes of no wave %.5f %.5f, of fine waves %.5f %.5f\n", path, t.beyond.xx, t.beyond.yy,
           t.fine.slopes[0], t.fine.slopes[2]);
    close_tracer(&t);
    free(pixels);
    bolan_world_destroy(&world);
    return good;
}

int main(int argc, char **argv) {
    if (argc < 3) {
        fprintf(stderr, "usage: %s FOLDER SAMPLES [furnace | VIEW]\n", argv[0]);
        return 2;
    }
    bolan_context *context = NULL;
    bool good = bolan_context_create(BOLAN_GL_CORE, &context) == BOLAN_OK;
    const bool furnace = argc > 3 && strcmp(argv[3], "furnace") == 0;
    for (int i = 0; i < REFERENCE_VIEWS && good; ++i)
        if (argc < 4 || furnace || strcmp(argv[3], reference_views[i].name) == 0)
            good = trace_view(&reference_views[i], argv[1], (uint32_t)atoi(argv[2]), furnace);
    bolan_context_destroy(&context);
    return good ? 0 : 1;
}

// SPDX-License-Identifier: MIT
// A path tracer of Bolan's sea, for the shading of physical optics to be compared with: see README.md.
//
// Rays march over the heights of bolan_query_heights() and of the fine waves (fine.h): no filter by pixel. Capillaries
// beyond them are facets of the place that is hit, and hide one another by Smith's function. Rays of a row of pixels
// are marched together.
//
//   eye -> place on the sea -> a visible facet -> sky, or a second place -> a facet -> sky
//                           -> sun, unless a wave stands before it
//                           -> light that leaves the water
#include "exr.h"
#include "facets.h"
#include "fine.h"
#include "shared/bed.glsl"
#include "shared/constants.glsl"

#include "bolan/io.h"
#include "bolan/query.h"
#include "bolan/render.h"
#include "bolan/world.h"

#include <stdlib.h>

enum { SKY_WIDTH = 2048, SKY_HEIGHT = 1024, STEPS = 4000 };
#define STEEPEST 0.7         // slope that steps allow for; a steeper wave is passed and found again by bisection
enum { SUNLESS = 3, LIGHT }; // of a ray: red, green, blue, green without the sun's reflection
#define FARTHEST 30000.0     // [m]
#define SHORTEST_STEP 0.008  // [m]; the shortest fine wave has 0.01 m
#define ON_SURFACE 2e-5      // [m]; a fine wave is a millimetre high

typedef struct ray {
    vec from, dir;
    double t, before, after; // [m]; the last place over the surface, and the first under it (0: none yet)
    bool done, hit;
    uint32_t pixel;
} ray;

typedef struct place {
    vec at;
    double sx, sy;
} place;

// For the rays of one row.
typedef struct room {
    ray *second, *suns;
    place *again;
    double *sun, *reflectance;
} room;

typedef struct tracer {
    const bolan_water *water;
    fine_waves fine;
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
static void halve(ray *r, double gap) {
    if (gap >= 0.0)
        r->before = r->t;
    else
        r->after = r->t;
    r->hit = r->done = fabs(gap) < ON_SURFACE || r->after - r->before < ON_SURFACE;
    r->t = r->done ? r->before : 0.5 * (r->before + r->after);
}

static void step_ray(const tracer *t, ray *r, double height) {
    const double gap = r->from.z + r->t * r->dir.z - height, level = hypot(r->dir.x, r->dir.y);
    if (r->after > 0.0 || gap < 0.0) {
        halve(r, gap);
        return;
    }
    r->before = r->t;
    r->t += fmax(gap / fmax(STEEPEST * level - r->dir.z, 1e-3), SHORTEST_STEP);
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
        for (uint32_t i = 0; i < n; ++i)
            step_ray(t, &rays[t->active[i]], (double)t->heights[i] + fine_at(&t->fine, t->xy[i]).height);
    }
    for (uint32_t i = 0; i < count; ++i) rays[i].hit |= !rays[i].done && rays[i].dir.z < 0.0;
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
        const fine_point fine = fine_at(&t->fine, t->xy[i]);
        out[i] = (place){{t->xy[i].x, t->xy[i].y, (double)t->points[i].height + fine.height},
                         fine.sx - (double)n.x / up,
                         fine.sy - (double)n.y / up};
    }
}

// ---- light ----------------------------------------------------------------------------------------------------------

static double sky_in(const tracer *t, vec d, int channel) {
    if (t->furnace) return 1.0;
    channel = channel == SUNLESS ? 1 : channel;
    double x = (atan2(d.x, d.y) / 6.283185307179586 + 0.5) * SKY_WIDTH - 0.5;
    double y = (0.5 - asin(fmin(fmax(d.z, 0.0), 1.0)) / 3.141592653589793) * SKY_HEIGHT - 0.5;
    y = fmin(fmax(y, 0.0), SKY_HEIGHT / 2 - 1);
    const double a = x - floor(x), b = y - floor(y);
    const int i = ((int)floor(x) + SKY_WIDTH) % SKY_WIDTH, i1 = (i + 1) % SKY_WIDTH, j = (int)y, j1 = j + 1;
    const float *s = t->sky + channel;
    return (1 - b) * ((1 - a) * (double)s[3 * (j * SKY_WIDTH + i)] + a * (double)s[3 * (j * SKY_WIDTH + i1)]) +
           b * ((1 - a) * (double)s[3 * (j1 * SKY_WIDTH + i)] + a * (double)s[3 * (j1 * SKY_WIDTH + i1)]);
}

static vec lifted(const place *p) { return along(p->at, 1e-4, (vec){0, 0, 1}); }
static double channel_of(bolan_vec3 v, int c) { return (double)(&v.x)[c]; }
static double below_in(const tracer *t, int c) { return t->furnace ? 1.0 : (&t->below.x)[c == SUNLESS ? 1 : c]; }
static double sun_in(const tracer *t, int c) { return c == SUNLESS ? 0.0 : channel_of(t->light.sun_irradiance, c); }

// What a place reflects of the sun, if no wave stands between; the ray that finds out is marched by the caller.
static ray sun_ray(const tracer *t, const place *p, vec to_eye, double *sun) {
    ray r = {.from = lifted(p), .dir = t->sun};
    *sun = t->furnace ? 0.0 : sun_by_facets(to_eye, t->sun, p->sx, p->sy, t->beyond);
    r.done = *sun < 1e-6;
    return r;
}

// Marches the sun's rays and drops the sun where a wave stops them.
static void shadow(tracer *t, ray *suns, uint32_t count, double *sun) {
    march(t, suns, count);
    for (uint32_t i = 0; i < count; ++i)
        if (suns[i].hit) sun[i] = 0.0;
}

// Of one facet of a place: the ray it reflects, and its reflectance.
static ray facet_ray(tracer *t, const place *p, vec to_eye, double *reflectance) {
    const vec n = visible_facet(&t->random, to_eye, p->sx, p->sy, t->beyond);
    *reflectance = fresnel(fmin(fmax(dot3(n, to_eye), 0.0), 1.0), WATER_INDEX);
    return (ray){.from = lifted(p), .dir = mirrored(to_eye, n)};
}

static vec back(vec d) { return (vec){-d.x, -d.y, -d.z}; }

// Light of the second place on a path, whose own mirrored ray ends in the sky.
static void second_light(tracer *t, const place *p, vec to_eye, double sun, double out[LIGHT]) {
    double f;
    vec d = facet_ray(t, p, to_eye, &f).dir;
    d.z = fabs(d.z);
    for (int c = 0; c < LIGHT; ++c) out[c] = f * sky_in(t, d, c) + (1.0 - f) * below_in(t, c) + sun * sun_in(t, c);
}

// Light of `count` places that rays have hit, LIGHT numbers each.
static void shade(tracer *t, const ray *hits, const place *places, uint32_t count, const room *r, double *out) {
    for (uint32_t i = 0; i < count; ++i) {
        const vec to_eye = back(hits[i].dir);
        r->second[i] = facet_ray(t, &places[i], to_eye, &r->reflectance[i]);
        r->suns[i] = sun_ray(t, &places[i], to_eye, &r->sun[i]);
        const double order = facets_lit(to_eye, r->second[i].dir, places[i].sx, places[i].sy, t->beyond);
        r->second[i].hit = r->second[i].done = uniform(&t->random) > order; // by a facet of the same place
    }
    shadow(t, r->suns, count, r->sun);
    march(t, r->second, count);
    places_of(t, r->second, count, r->again);
    for (uint32_t i = 0; i < count; ++i) {
        for (int c = 0; c < LIGHT; ++c)
            out[LIGHT * i + (uint32_t)c] = r->sun[i] * sun_in(t, c) + (1.0 - r->reflectance[i]) * below_in(t, c);
        r->suns[i] = sun_ray(t, &r->again[i], back(r->second[i].dir), &r->sun[i]);
        r->suns[i].done |= !r->second[i].hit;
    }
    shadow(t, r->suns, count, r->sun);
    for (uint32_t i = 0; i < count; ++i) {
        double light[LIGHT];
        const vec d = r->second[i].dir;
        if (r->second[i].hit) second_light(t, &r->again[i], back(d), r->sun[i], light);
        for (int c = 0; c < LIGHT; ++c)
            out[LIGHT * i + (uint32_t)c] += r->reflectance[i] * (r->second[i].hit ? light[c] : sky_in(t, d, c));
    }
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

// The pixel's filter is that of the picture, a Gaussian; a box keeps 1.3 to 1.5 times the contrast of neighbours.
static ray eye_ray(tracer *t, const camera *c, uint32_t x, uint32_t y) {
    const double variance = FOOTPRINT_DEVIATION * FOOTPRINT_DEVIATION;
    double dx, dy;
    gaussian_slope(&t->random, (covariance){variance, 0.0, variance}, &dx, &dy);
    const double u = (2.0 * (x + 0.5 + dx) - REFERENCE_WIDTH) / REFERENCE_HEIGHT * c->half;
    const double v = (1.0 - 2.0 * (y + 0.5 + dy) / REFERENCE_HEIGHT) * c->half;
    ray r = {.from = c->eye, .dir = unit(along(along(c->ahead, u, c->right), v, c->up)), .pixel = x};
    r.t = r.dir.z < 0.0 ? fmax((t->highest - c->eye.z) / r.dir.z, 0.0) : 0.0;
    r.done = r.dir.z > -5e-4;
    return r;
}

static void trace_row(tracer *t, const camera *c, uint32_t y, uint32_t samples, float *out) {
    const uint32_t count = REFERENCE_WIDTH * samples;
    ray *rays = malloc(sizeof(ray) * count);
    place *places = malloc(sizeof(place) * count);
    const room r = {malloc(sizeof(ray) * count), malloc(sizeof(ray) * count), malloc(sizeof(place) * count),
                    malloc(sizeof(double) * count), malloc(sizeof(double) * count)};
    double *light = malloc(sizeof(double) * LIGHT * count), sums[REFERENCE_WIDTH][LIGHT + 2] = {{0}};
    for (uint32_t i = 0; i < count; ++i) rays[i] = eye_ray(t, c, i / samples, y);
    march(t, rays, count);
    uint32_t hits = 0;
    for (uint32_t i = 0; i < count; ++i)
        if (rays[i].hit) rays[hits++] = rays[i];
    places_of(t, rays, hits, places);
    shade(t, rays, places, hits, &r, light);
    for (uint32_t i = 0; i < hits; ++i) {
        double *s = sums[rays[i].pixel];
        const double *l = &light[LIGHT * i];
        for (int c = 0; c < LIGHT; ++c) s[c] += l[c];
        s[LIGHT] += l[SUNLESS] * l[SUNLESS], s[LIGHT + 1] += 1.0;
    }
    for (uint32_t x = 0; x < REFERENCE_WIDTH; ++x, out += REFERENCE_CHANNELS) {
        const double *s = sums[x], n = fmax(s[LIGHT + 1], 1e-3), mean = s[SUNLESS] / n;
        for (int c = 0; c < 3; ++c) out[c] = (float)(s[c] / n);
        out[REFERENCE_SIGMA] = (float)sqrt(fmax(s[LIGHT] / n - mean * mean, 0.0) / n);
        out[REFERENCE_SUNLESS] = (float)mean;
    }
    free(rays), free(places), free(light);
    free(r.second), free(r.suns), free(r.again), free(r.sun), free(r.reflectance);
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
    const bolan_sea_fine_view fine = bolan_sea_fine(t->water->sea);
    t->fine = fine_open(&fine);
    bolan_sea_unresolved_slopes(t->water->sea, 0.0, 0.0, 0.0, hidden);
    t->beyond = (covariance){fmax((double)hidden[0] - fine.slopes[0], 1e-6), (double)hidden[1] - fine.slopes[1],
                             fmax((double)hidden[2] - fine.slopes[2], 1e-6)};
    light_the_water(t);
    return good;
}

static void close_tracer(tracer *t) {
    free(t->xy), free(t->heights), free(t->active), free(t->points), free(t->sky), free(t->fine.samples);
}

static bool trace_view(const reference_view *v, const char *folder, bool furnace) {
    const uint32_t samples = furnace ? 64 : v->samples;
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
    printf("%s: slopes of no wave %.5f %.5f\n", path, t.beyond.xx, t.beyond.yy);
    close_tracer(&t);
    free(pixels);
    bolan_world_destroy(&world);
    return good;
}

int main(int argc, char **argv) {
    if (argc < 2) {
        fprintf(stderr, "usage: %s FOLDER [furnace | VIEW]\n", argv[0]);
        return 2;
    }
    bolan_context *context = NULL;
    bool good = bolan_context_create(BOLAN_GL_CORE, &context) == BOLAN_OK;
    const bool furnace = argc > 2 && strcmp(argv[2], "furnace") == 0;
    for (int i = 0; i < REFERENCE_VIEWS && good; ++i)
        if (argc < 3 || furnace || strcmp(argv[2], reference_views[i].name) == 0)
            good = trace_view(&reference_views[i], argv[1], furnace);
    bolan_context_destroy(&context);
    return good ? 0 : 1;
}

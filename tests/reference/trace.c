// SPDX-License-Identifier: MIT
// A path tracer of Bolan's sea, for the shading of physical optics to be compared with: see README.md. Its parts:
// tracer.h.
#include "exr.h"
#include "tracer.h"

#include "bolan/io.h"
#include "shared/constants.glsl"

#include <stdlib.h>

#define FARTHEST 30000.0       // [m]
#define FARTHEST_UNDER 10000.0 // in the water [m]
#define DEEPEST 12.0           // of the photons of deep water [m]

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
    const int side = c->eye.z > 0.0 ? 1 : -1;
    ray r = {.from = c->eye, .dir = unit(along(along(c->ahead, u, c->right), v, c->up)), .pixel = x};
    const double towards = -side * r.dir.z;
    r.t = towards > 0.0 ? fmax((side * c->eye.z - t->highest) / towards, 0.0) : 0.0;
    r.done = towards < 5e-4;
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
    const bool under = c->eye.z < 0.0;
    march(t, rays, count, under ? -1 : 1);
    uint32_t hits = 0;
    for (uint32_t i = 0; i < count; ++i)
        if (rays[i].hit || under) rays[hits++] = rays[i];
    places_of(t, rays, hits, places);
    (under ? shade_under : shade)(t, rays, places, hits, &r, light);
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

static bool open_tracer(tracer *t, const bolan_world *world, const reference_view *v, uint32_t samples) {
    const uint32_t most = REFERENCE_WIDTH * samples;
    const bolan_lighting lighting = bolan_lighting_from_scene(bolan_world_scene(world));
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
    t->farthest = v->height > 0.0 ? FARTHEST : FARTHEST_UNDER;
    light_the_water(t);
    medium_open(t);
    if (v->bed > 0.0 || v->height < 0.0) photons_open(t, v->bed > 0.0 ? v->bed : DEEPEST, v->heading, most);
    bed_open(t, v->bed, most);
    return good;
}

static void close_tracer(tracer *t) {
    free(t->xy), free(t->heights), free(t->active), free(t->points), free(t->sky);
    free(t->fine.samples), free(t->photons.light);
}

static bool trace_view(const reference_view *v, const char *folder, bool furnace) {
    const uint32_t samples = furnace ? 64 : v->samples;
    bolan_world *world = NULL;
    tracer t = {.furnace = furnace};
    float *pixels = malloc(sizeof(float) * REFERENCE_CHANNELS * REFERENCE_PIXELS);
    char path[1024];
    if (!reference_world(v, &world)) return false;
    bool good = open_tracer(&t, world, v, samples);
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

// SPDX-License-Identifier: MIT
// The parts of the reference path tracer, and what they share.
//
//   trace.c   views, rays of the eye, images
//   march.c   rays through the air and the water to the surface
//   over.c    light of a place on the surface for an eye in the air
//   under.c   light along a ray for an eye in the water
//   medium.c  the water and its bed
//   photons.c sunlight in the water
#ifndef BOLAN_REFERENCE_TRACER_H
#define BOLAN_REFERENCE_TRACER_H

#include "facets.h"
#include "fine.h"
#include "views.h"

#include "bolan/query.h"
#include "bolan/render.h"

enum { SKY_WIDTH = 2048, SKY_HEIGHT = 1024 };
enum { SUNLESS = 3, LIGHT }; // of a ray: red, green, blue, green without the image of the sun

typedef struct ray {
    vec from, dir;
    double t, before, after; // [m]; the last place on this side of the surface, and the first beyond it (0: none yet)
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

// Sunlight in the water over that of flat water, by cells of levels.
typedef struct photons {
    double west, south, depth; // corner of the cells, the deepest level [m]
    double travel_x, travel_y; // level way of flat water's light, a metre of depth
    float *light;
} photons;

typedef struct sea_bed {
    double depth;         // of the mean water [m]; 0: there is none
    double sun;           // irradiance under a flat surface, of one of 1 across the sun's rays
    double sky[3];        // irradiance of the sky under the surface
    double again;         // share of the light leaving the bed that the surface reflects down
    double irradiance[3]; // mean, on the bed
} sea_bed;

// The water as common/below_medium.glsl has it: coefficients [1/m] by channel.
typedef struct medium {
    double kd[3], beam[3], wide[3], field[3], exponent[3];
    double blur_cosine, pattern;  // pattern: light that leaves the pattern of the bed, a metre of depth [1/m]
    double entering[3], sunny[3]; // irradiance just under the surface: on a level, and across the sun's rays
    vec sun;                      // direction to it in the water
} medium;

typedef struct tracer {
    const bolan_water *water;
    fine_waves fine;
    covariance beyond; // slopes of no wave
    double highest;    // of the surface [m]
    double farthest;   // that rays go [m]
    float *sky;
    bolan_sky_light light;
    vec sun, below; // below: radiance under the surface over index squared, by channel
    bool furnace;   // everything around shines with radiance 1
    uint64_t random;
    photons photons;
    sea_bed bed;
    medium medium;
    bolan_dvec2 *xy;
    float *heights;
    uint32_t *active;
    bolan_query_point *points;
} tracer;

// The channel of radiance that stands at c: SUNLESS is a green.
static inline int color_of(int c) { return c == SUNLESS ? 1 : c; }
static inline double channel_of(bolan_vec3 v, int c) { return (double)(&v.x)[color_of(c)]; }
static inline vec back(vec d) { return (vec){-d.x, -d.y, -d.z}; }

// ---- march.c --------------------------------------------------------------------------------------------------------

// Follows rays to the surface, from the air (side 1) or from the water (side -1).
void march(tracer *t, ray *rays, uint32_t count, int side);
void places_of(tracer *t, const ray *rays, uint32_t count, place *out);
place place_at(const tracer *t, const bolan_query_point *p, bolan_dvec2 at);
// A place a little way off the surface, where the next ray begins.
vec off_surface(const place *p, int side);

// ---- over.c ---------------------------------------------------------------------------------------------------------

double sky_in(const tracer *t, vec d, int channel);
// Light of `count` places that rays from the air have hit, LIGHT numbers each.
void shade(tracer *t, const ray *hits, const place *places, uint32_t count, const room *r, double *out);
// Light of the second place on a path, whose own mirrored ray ends in the sky.
void second_light(tracer *t, const place *p, vec to_eye, double sun, double out[LIGHT]);
// Marches the sun's rays and drops the sun where a wave stops them.
void shadow(tracer *t, ray *suns, uint32_t count, double *sun);
// Irradiance under the surface, and the radiance that the water sends up.
void light_the_water(tracer *t);

// ---- under.c --------------------------------------------------------------------------------------------------------

// A visible facet of a place that a ray from below meets: its reflectance, and how the ray goes on in the air and in
// the water.
typedef struct facet {
    double reflectance;
    vec air, water;
} facet;
facet facet_under(tracer *t, const place *p, vec dir);

// Light along marched rays of an eye in the water.
void shade_under(tracer *t, const ray *rays, const place *places, uint32_t count, const room *r, double *out);

// ---- medium.c -------------------------------------------------------------------------------------------------------

void medium_open(tracer *t);
// Measures how much of the sky's light reaches the bed; most: rays at once.
void bed_open(tracer *t, double depth, uint32_t most);
// Radiance of the bed at a place, in the water just over it.
double bed_radiance(const tracer *t, double x, double y, int c);
// Radiance that the water puts before what lies `reach` metres away, along a ray that begins at a depth.
double water_veil(const tracer *t, double depth, vec dir, double reach, int c);
// The same with the shafts of sunlight that waves gather.
void shaft_veil(tracer *t, vec from, vec dir, double reach, double out[LIGHT]);

// ---- photons.c ------------------------------------------------------------------------------------------------------

// Down to a depth, ahead of the eye; most: photons at once.
void photons_open(tracer *t, double depth, double heading, uint32_t most);
double gathered_at(const photons *p, vec at);
double gathered_mean(const photons *p); // of the deepest level

#endif

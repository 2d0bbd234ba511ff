// SPDX-License-Identifier: MIT
// The pose of an object that stands on the ground or floats.
#include "bolan/world.h"

#include "bolan/query.h"

#define SOFTENING 0.7 // factor on the tilt: a hull averages over more water than the queried points

static bolan_pose standing(const bolan_object *o) {
    double s, c;
    bolan_sincos(bolan_radians(o->heading_deg), &s, &c);
    return (bolan_pose){o->position, {c, -s, 0.0}, {s, c, 0.0}, {0.0, 0.0, 1.0}};
}

static bolan_dvec3 unit(bolan_dvec3 v) {
    const double length = sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
    return bolan_dv3(v.x / length, v.y / length, v.z / length);
}
static bolan_dvec3 cross(bolan_dvec3 a, bolan_dvec3 b) {
    return bolan_dv3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

// The height of the water under the five points: the middle, bow, stern, starboard, port; and half the hull's size.
typedef struct hull {
    double height[5], half_x, half_y;
} hull;

static hull ask(const bolan_pose *p, const bolan_object *o, const bolan_model *model, const bolan_water *water) {
    static const double at[5][2] = {{0, 0}, {0, 0.8}, {0, -0.8}, {0.8, 0}, {-0.8, 0}};
    bolan_vec3 low, high;
    bolan_model_bounds(model, &low, &high);
    hull h = {.half_x = 0.5 * o->scale * (double)(high.x - low.x), .half_y = 0.5 * o->scale * (double)(high.y - low.y)};
    const double mid_x = 0.5 * o->scale * (double)(high.x + low.x), mid_y = 0.5 * o->scale * (double)(high.y + low.y);
    bolan_dvec2 xy[5];
    bolan_query_point answer[5];
    for (int i = 0; i < 5; i++) {
        const double u = mid_x + at[i][0] * h.half_x, v = mid_y + at[i][1] * h.half_y;
        xy[i] = (bolan_dvec2){p->origin.x + u * p->x.x + v * p->y.x, p->origin.y + u * p->x.y + v * p->y.y};
    }
    bolan_query_surface(water, xy, 5, answer);
    for (int i = 0; i < 5; i++) h.height[i] = (double)answer[i].height;
    return h;
}

bolan_pose bolan_object_pose(const bolan_object *object, const bolan_model *model, const bolan_water *water) {
    BOLAN_ASSERT(object && model && water);
    bolan_pose p = standing(object);
    if (!object->floats || !water->sea) return p;
    const hull h = ask(&p, object, model, water);
    const double pitch = SOFTENING * (h.height[1] - h.height[2]) / fmax(1.6 * h.half_y, 1e-3);
    const double roll = SOFTENING * (h.height[3] - h.height[4]) / fmax(1.6 * h.half_x, 1e-3);
    double sum = 0.0;
    for (int i = 0; i < 5; i++) sum += h.height[i];
    p.origin.z = object->position.z + sum / 5.0;
    p.y = unit(bolan_dv3(p.y.x, p.y.y, pitch));
    p.z = unit(cross(bolan_dv3(p.x.x, p.x.y, roll), p.y));
    p.x = cross(p.y, p.z);
    return p;
}

// SPDX-License-Identifier: MIT
// The placement of nested grids (Liu, Xu & Chen 2009, section 1). Level 0 is the coarsest. Each further level has as
// many cells, half as long, and lies in a hole of its parent:
//
//      +---+---+---+---+---+---+---+---+      n = 8 cells along a side of every level
//      |   |   |   |   |   |   |   |   |      ring: the outermost cells, next to the parent's coarser ones
//      +---+---+---+---+---+---+---+---+      hole: n/2 cells of this level = n cells of the next
//      |   |   +-+-+-+-+-+-+-+-+   |   |
//      +---+---+-+-+-+-+-+-+-+-+---+---+      c: the point looked at; the middle of each level is the vertex of its
//      |   |   +-+-+-+-+-+-+-+-+   |   |         parent nearest to c, so c is within a cell of every middle
//      +---+---+-+-+-+c+-+-+-+-+---+---+
//
// A vertex's world position is a whole multiple of its level's spacing. The spacing has at most 24 bits and the
// multiple at most 29, so positions, and those of the levels that share them, are exact in double.
#include "surface/view_cone.h"

#include "shared/earth.glsl"

// The centre lies at most NEAR_SHARE times as far as the nearest water in view. With 2, no water in the direction
// of view is farther from the centre than from the eye, so that cells (which grow with the distance from the centre)
// look as large near as far.
#define NEAR_SHARE 2.0
#define LEAST_PIXELS 2.0

bolan_nested_desc bolan_nested_desc_default(void) { return (bolan_nested_desc){.cells = 32, .levels = 6}; }

// The inputs of the placement; distances over mean water are from the point under the eye [m].
typedef struct outlook {
    double height;  // of the eye, on whichever side of the water
    double nearest; // water in the picture
    double centre;  // the levels' centre, along the heading
    double edge;    // as far as there must be water
    double cosine;  // of the widest azimuth off the heading in the picture
    double pixel;   // [rad]
} outlook;

static double plan_length(bolan_dvec3 d) { return sqrt(d.x * d.x + d.y * d.y); }

// Where a ray that sinks by `down` over `plan` meets the round mean water: plan * h = down * r - plan * r^2 / 2R.
static double distance_along(double plan, double down, double h) {
    double distance = plan > 0.0 ? earth_meets(down / plan, h, BOLAN_EARTH_RADIUS) : down > 0.0 ? 0.0 : -1.0;
    return distance >= 0.0 ? distance : earth_horizon(h, BOLAN_EARTH_RADIUS); // over the horizon
}

static outlook look_out(const bolan_surface_view *v) {
    double above = v->eye.z - v->water_level, side = above < 0.0 ? -1.0 : 1.0; // from below, the water is up
    outlook o = {.height = fmax(fabs(above), 0.5), .cosine = 1.0};
    o.pixel = v->fov_y / (v->pixel_height > 0 ? v->pixel_height : 1);
    o.nearest = earth_horizon(o.height, BOLAN_EARTH_RADIUS);
    for (int k = 0; k < 9; ++k) {
        bolan_dvec3 d = bolan_surface_view_direction(v, k % 3 - 1.0, k / 3 - 1.0);
        double plan = plan_length(d);
        o.nearest = fmin(o.nearest, distance_along(plan, -side * d.z, o.height));
        o.cosine = fmin(o.cosine, plan > 0.0 ? d.y / plan : -1.0);
    }
    if (bolan_surface_sees_nadir(v)) o.cosine = -1.0;
    bolan_dvec3 middle = bolan_surface_view_direction(v, 0.0, 0.0);
    double looked_at = distance_along(plan_length(middle), -side * middle.z, o.height);
    o.centre = fmin(looked_at, NEAR_SHARE * fmax(o.nearest, o.height));
    double dip = earth_dip(o.height, BOLAN_EARTH_RADIUS);
    o.edge = distance_along(1.0, dip + 0.5 * o.pixel, o.height);
    return o;
}

// Half the side that level 0 must have round the centre: to the farthest corner of the sector of water in the picture.
static double reach_of(const outlook *o, const bolan_surface_view *v) {
    double square = o->edge * o->edge + o->centre * o->centre - 2.0 * o->edge * o->centre * o->cosine;
    return fmax(sqrt(fmax(square, 0.0)), o->centre) + v->horizontal;
}

static double power_of_two_from(double x) { // the least that is not less
    int exponent;
    double mantissa = frexp(x, &exponent);
    return ldexp(1.0, mantissa > 0.5 ? exponent : exponent - 1);
}

// Lower left corner of the hole: half a hole before the vertex nearest to c, and one cell from the border at least.
static uint32_t hole_at(double c, double x0, double spacing, uint32_t n) {
    double at = floor((c - x0) / spacing + 0.5) - n / 4;
    return (uint32_t)fmin(fmax(at, 1.0), n / 2 - 1);
}

static void stack_levels(bolan_nested *nested, double spacing) {
    uint32_t n = nested->cells;
    bolan_nested_level *level = nested->level;
    // as if level 0 had a parent too: then it does not move when the spacing doubles and it becomes level 1
    double step = n > 4 ? 2.0 * spacing : spacing;
    level[0].spacing = spacing;
    level[0].x0 = floor(nested->centre.x / step + 0.5) * step - n / 2 * spacing;
    level[0].y0 = floor(nested->centre.y / step + 0.5) * step - n / 2 * spacing;
    for (uint32_t l = 0; l + 1 < nested->levels; ++l) {
        double d = level[l].spacing;
        level[l].hole_i = hole_at(nested->centre.x, level[l].x0, d, n);
        level[l].hole_j = hole_at(nested->centre.y, level[l].y0, d, n);
        level[l + 1] = (bolan_nested_level){
            .x0 = level[l].x0 + d * level[l].hole_i, .y0 = level[l].y0 + d * level[l].hole_j, .spacing = 0.5 * d};
    }
}

static uint32_t within(uint32_t x, uint32_t low, uint32_t high) { return x < low ? low : x > high ? high : x; }

bolan_nested bolan_surface_nested_place(const bolan_nested_desc *desc, const bolan_surface_view *view) {
    BOLAN_ASSERT(desc != NULL && view != NULL);
    BOLAN_ASSERT(desc->cells >= 4 && desc->cells <= 256 && desc->cells % 4 == 0);
    BOLAN_ASSERT(desc->levels >= 1 && desc->levels <= BOLAN_NESTED_MAX_LEVELS && desc->spacing >= 0.0);
    bolan_nested nested = {.cells = within(desc->cells & ~3u, 4, 256)};
    uint32_t most = within(desc->levels, 1, BOLAN_NESTED_MAX_LEVELS);
    outlook o = look_out(view);
    double sine, cosine;
    bolan_sincos(bolan_radians(view->heading_deg), &sine, &cosine);
    nested.centre = (bolan_dvec2){view->eye.x + o.centre * sine, view->eye.y + o.centre * cosine};

    double close = fmin(o.nearest, o.centre);
    nested.least_spacing = LEAST_PIXELS * o.pixel * sqrt(o.height * o.height + close * close);
    double spacing = (float)desc->spacing;
    if (!(spacing > 0.0)) {
        double needed = reach_of(&o, view) / (nested.cells / 2 - 1); // c is up to one cell from the middle
        spacing = power_of_two_from(needed);
        // the finest level is about to leave where needed nears the power of two; its waves leave before
        nested.least_spacing = fmax(nested.least_spacing, ldexp(2.0 * needed, 1 - (int)most));
    }
    nested.levels = 1;
    for (double d = spacing; nested.levels < most && d > nested.least_spacing; d *= 0.5) ++nested.levels;
    stack_levels(&nested, spacing);
    return nested;
}

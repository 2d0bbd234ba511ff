// SPDX-License-Identifier: MIT
// The vertices of nested grids: positions, spacing, stitches (Liu, Xu & Chen 2009, section 2) and visibility (section
// 4).
//
// The spacing of a vertex at p in a level of spacing d, by its distance |p - c| = max(|x - cx|, |y - cy|) in cells:
//
//      2 d |                   ______      from m0 = max(n/4 + 1/2, 0.3 n), where the hole has ended for certain, to
//          |               _--'            m1 = n/2 - 1, where no border can be nearer
//        d |____________--'
//          +-----------m0----m1----|-->    so it is continuous in p from level to level, and in time when levels step
//
// Level l's border is at 2 d_l and its parent's hole at d_(l-1): the same. No wave appears or disappears when a level
// moves.
#include "surface/view_cone.h"

#include "shared/earth.glsl"
#include "shared/grid.glsl"

// The part of plan that the picture covers.
typedef struct sight {
    bool sector;                 // two sides suffice
    bolan_dvec2 left, right;     // unit vectors along them
    bolan_dvec3 plane[4];        // inward normals of the side planes of the picture
    double bound_in_plan, bound; // of the displacement [m]
} sight;

typedef struct place {
    const bolan_nested *nested;
    const bolan_nested_level *level;
    uint32_t index;         // of the level
    bolan_dvec3 eye;        // z: above the water
    double rise_from, rise; // of the spacing: distance from the centre [m], growth per metre
} place;

static bolan_dvec2 rest_at(const place *p, uint32_t i, uint32_t j) {
    return (bolan_dvec2){p->level->x0 + i * p->level->spacing, p->level->y0 + j * p->level->spacing};
}

static bool on_border(const place *p, uint32_t i, uint32_t j) {
    uint32_t n = p->nested->cells;
    return i == 0 || j == 0 || i == n || j == n;
}

static bool in_hole(const place *p, uint32_t i, uint32_t j) { // its border included
    uint32_t m = p->nested->cells / 2, hi = p->level->hole_i, hj = p->level->hole_j;
    return p->index + 1 < p->nested->levels && i >= hi && i <= hi + m && j >= hj && j <= hj + m;
}

static bool stitched(const place *p, uint32_t i, uint32_t j) {
    return p->index > 0 && on_border(p, i, j) && (i + j) % 2 == 1; // n is even: one of two is 0 or n
}

// The spacing before the least: d in the middle to 2 d on the border. The borders are decided by index: with n = 4 the
// centre may be anywhere, and rounding must not separate the vertices that two levels share.
static double spacing_at(const place *p, uint32_t i, uint32_t j, bolan_dvec2 at) {
    double d = p->level->spacing;
    if (in_hole(p, i, j)) return d;
    if (on_border(p, i, j)) return 2.0 * d;
    double away = fmax(fabs(at.x - p->nested->centre.x), fabs(at.y - p->nested->centre.y));
    return away <= p->rise_from ? d : fmin(d + (away - p->rise_from) * p->rise, 2.0 * d);
}

static bolan_surface_vertex plain_vertex(const place *p, bolan_dvec2 at, double spacing) {
    double x = at.x - p->eye.x, y = at.y - p->eye.y;
    return (bolan_surface_vertex){.x = (float)x,
                                  .y = (float)y,
                                  .z = (float)(-p->eye.z - earth_drop(x * x + y * y, BOLAN_EARTH_RADIUS)),
                                  .spacing = (float)fmax(spacing, p->nested->least_spacing)};
}

// Section 2: the odd points of the border are put on the straight edges of the parent; on the round earth too.
static bolan_surface_vertex stitched_vertex(const place *p, uint32_t i, uint32_t j, double spacing) {
    bool along_x = j == 0 || j == p->nested->cells, along_y = !along_x;
    bolan_surface_vertex a = plain_vertex(p, rest_at(p, i - along_x, j - along_y), spacing);
    bolan_surface_vertex b = plain_vertex(p, rest_at(p, i + along_x, j + along_y), spacing);
    float d = (float)p->level->spacing;
    return (bolan_surface_vertex){.x = 0.5f * (a.x + b.x),
                                  .y = 0.5f * (a.y + b.y),
                                  .z = 0.5f * (a.z + b.z),
                                  .spacing = a.spacing,
                                  .stitch_x = along_x ? d : 0.0f,
                                  .stitch_y = along_y ? d : 0.0f};
}

static bolan_dvec3 turned(bolan_dvec3 d, double sine, double cosine) { // by the heading, clockwise
    return bolan_dv3(d.x * cosine + d.y * sine, d.y * cosine - d.x * sine, d.z);
}

static bolan_dvec3 plane_through(bolan_dvec3 a, bolan_dvec3 b, bolan_dvec3 inside) {
    bolan_dvec3 n = bolan_dv3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
    double length = sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
    if (n.x * inside.x + n.y * inside.y + n.z * inside.z < 0.0) length = -length;
    return bolan_dv3(n.x / length, n.y / length, n.z / length);
}

#define WIDEST_SINE 0.98 // of the sides off the heading: near a half turn the two sides become one line

static sight sight_of(const bolan_surface_view *v) {
    double sine, cosine;
    bolan_sincos(bolan_radians(v->heading_deg), &sine, &cosine);
    bolan_dvec3 corner[4], middle = turned(bolan_surface_view_direction(v, 0.0, 0.0), sine, cosine);
    sight s = {.sector = !bolan_surface_sees_nadir(v),
               .bound_in_plan = v->horizontal,
               .bound = sqrt(v->horizontal * v->horizontal + v->vertical * v->vertical)};
    double leftmost = 2.0, rightmost = -2.0; // sines of the azimuths off the heading
    for (int k = 0; k < 4; ++k) {
        bolan_dvec3 d = bolan_surface_view_direction(v, k == 1 || k == 2 ? 1.0 : -1.0, k < 2 ? -1.0 : 1.0);
        corner[k] = turned(d, sine, cosine);
        double plan = sqrt(d.x * d.x + d.y * d.y), off = plan > 0.0 ? d.x / plan : 1.0;
        if (d.y <= 0.0 || fabs(off) > WIDEST_SINE) s.sector = false;
        if (off < leftmost) leftmost = off, s.left = (bolan_dvec2){corner[k].x / plan, corner[k].y / plan};
        if (off > rightmost) rightmost = off, s.right = (bolan_dvec2){corner[k].x / plan, corner[k].y / plan};
    }
    for (int k = 0; k < 4; ++k) s.plane[k] = plane_through(corner[k], corner[(k + 1) % 4], middle);
    return s;
}

// Section 4, figure 4: (P - E) x L and R x (P - E) both upwards; here each may be short by the guard [m].
static bool in_sight(const sight *s, bolan_dvec3 p, double cell) {
    double diagonal = sqrt(2.0) * cell, guard = diagonal + s->bound;
    if (s->sector) {
        guard = diagonal + s->bound_in_plan;
        return p.x * s->left.y - p.y * s->left.x >= -guard && s->right.x * p.y - s->right.y * p.x >= -guard;
    }
    for (int k = 0; k < 4; ++k)
        if (p.x * s->plane[k].x + p.y * s->plane[k].y + p.z * s->plane[k].z < -guard) return false;
    return true;
}

// The cell of the guard is that of the spacing, so that both levels of a border say the same; for a stitched vertex its
// own half of that, so that its neighbours are visible where it is.
static bool visible_at(const place *p, const sight *s, bolan_dvec2 at, double cell) {
    double x = at.x - p->eye.x, y = at.y - p->eye.y;
    double z = -p->eye.z - earth_drop(x * x + y * y, BOLAN_EARTH_RADIUS);
    return in_sight(s, bolan_dv3(x, y, z), cell);
}

static void enter_level(place *p, uint32_t index) {
    double n = p->nested->cells, from = nested_rise_from(n), to = nested_rise_to(n);
    p->index = index;
    p->level = &p->nested->level[index];
    p->rise_from = from * p->level->spacing;
    p->rise = to > from ? 1.0 / (to - from) : 0.0; // n = 4 has nothing between the hole and the border
}

uint32_t bolan_surface_nested_vertex_count(const bolan_nested *nested) {
    BOLAN_ASSERT(nested != NULL);
    return (nested->cells + 1) * (nested->cells + 1) * nested->levels;
}

void bolan_surface_nested_vertices(const bolan_nested *nested, const bolan_surface_view *view, bolan_dvec2 *rest,
                                   bolan_surface_vertex *vertices, uint8_t *visible) {
    BOLAN_ASSERT(nested != NULL && (view != NULL || (vertices == NULL && visible == NULL)));
    place p = {.nested = nested};
    sight s = {.sector = false};
    if (view) p.eye = bolan_dv3(view->eye.x, view->eye.y, view->eye.z - view->water_level);
    if (visible) s = sight_of(view);
    size_t k = 0;
    for (uint32_t l = 0; l < nested->levels; ++l) {
        enter_level(&p, l);
        for (uint32_t j = 0; j <= nested->cells; ++j)
            for (uint32_t i = 0; i <= nested->cells; ++i, ++k) {
                bolan_dvec2 at = rest_at(&p, i, j);
                bool odd = stitched(&p, i, j);
                double spacing = spacing_at(&p, i, j, at);
                if (rest) rest[k] = at;
                if (vertices) vertices[k] = odd ? stitched_vertex(&p, i, j, spacing) : plain_vertex(&p, at, spacing);
                if (visible) visible[k] = visible_at(&p, &s, at, odd ? p.level->spacing : spacing);
            }
    }
}

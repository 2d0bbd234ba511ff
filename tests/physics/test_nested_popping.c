// SPDX-License-Identifier: MIT
// Nested grids under a moving camera: between two frames no point of the drawn sea may jump by a pixel. The sea stands
// still, so that whatever moves is the mesh's doing. 64 cosines of the spectrum of Pierson and Moskowitz, Hs = 3 m,
// leave the geometry where they become shorter than the spacing resolves.
#include "support.h"

#include "bolan/surface.h"

#include <string.h>

#define WAVES 64
#define CAPACITY 70000

static struct { double a, kx, ky, phase, length; } wave[WAVES];

static uint64_t seed;
static double uniform(double low, double high) { // the same on every machine
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * ((double)(seed >> 11) * 0x1p-53);
}
static uint32_t below(uint32_t n) { return (uint32_t)uniform(0, n); }

// S(w) = 0.78 / w^5 exp(-3.11 / (w^4 H^2)); equal shares of the energy: w_i = (B / ln(2 M / (2 i - 1)))^(1/4).
static void make_sea(double hs) {
    double b = 3.11 / (hs * hs), m0 = 0.78 / (4.0 * b);
    seed = 4;
    for (int i = 0; i < WAVES; ++i) {
        double w = pow(b / log(2.0 * WAVES / (2.0 * i + 1.0)), 0.25), k = w * w / BOLAN_GRAVITY,
               to = uniform(-1.5, 1.5);
        wave[i].a = sqrt(2.0 * m0 / WAVES);
        wave[i].kx = k * cos(to), wave[i].ky = k * sin(to);
        wave[i].phase = uniform(0, 2 * BOLAN_PI);
        wave[i].length = 2 * BOLAN_PI / k;
    }
}

// Waves shorter than twice the spacing are gone, those longer than eight times are whole.
static double height_at(double x, double y, double spacing) {
    double sum = 0.0;
    for (int i = 0; i < WAVES; ++i) {
        double t = fmin(fmax(0.5 * log2(wave[i].length / (2.0 * spacing)), 0.0), 1.0);
        if (t > 0.0) sum += t * t * (3 - 2 * t) * wave[i].a * cos(wave[i].kx * x + wave[i].ky * y + wave[i].phase);
    }
    return sum;
}

typedef struct mesh {
    bolan_nested nested;
    bolan_dvec2 rest[CAPACITY];
    bolan_surface_vertex vertices[CAPACITY];
} mesh;
static mesh meshes[2];

static void build(mesh *m, const bolan_nested_desc *desc, const bolan_surface_view *view) {
    m->nested = bolan_surface_nested_place(desc, view);
    assert_true(bolan_surface_nested_vertex_count(&m->nested) <= CAPACITY);
    bolan_surface_nested_vertices(&m->nested, view, m->rest, m->vertices, NULL);
}

static double vertex_height(const mesh *m, size_t v) {
    bolan_surface_vertex s = m->vertices[v];
    bolan_dvec2 p = m->rest[v];
    if (s.stitch_x == 0.0f && s.stitch_y == 0.0f) return height_at(p.x, p.y, s.spacing);
    return 0.5 * (height_at(p.x - s.stitch_x, p.y - s.stitch_y, s.spacing) +
                  height_at(p.x + s.stitch_x, p.y + s.stitch_y, s.spacing));
}

// Height of the drawn triangle over a point; false outside level 0.
static bool drawn_height(const mesh *m, double x, double y, double *height) {
    for (uint32_t l = m->nested.levels; l-- > 0;) {
        const bolan_nested_level *at = &m->nested.level[l];
        double u = (x - at->x0) / at->spacing, w = (y - at->y0) / at->spacing, n = m->nested.cells;
        if (u < 0 || w < 0 || u >= n || w >= n) continue;
        size_t stride = m->nested.cells + 1, a = (l * stride + (size_t)w) * stride + (size_t)u;
        u -= floor(u), w -= floor(w);
        double hb = vertex_height(m, a + 1), hc = vertex_height(m, a + stride);
        if (u + w < 1.0) {
            double ha = vertex_height(m, a);
            *height = ha + u * (hb - ha) + w * (hc - ha);
        } else {
            double hd = vertex_height(m, a + stride + 1);
            *height = hd + (1 - u) * (hc - hd) + (1 - w) * (hb - hd);
        }
        return true;
    }
    return false;
}

typedef struct jumps {
    double worst; // [pixels]
    int count, steps;
} jumps;

// Any point of the water in the picture.
static bolan_dvec2 point_in_view(const bolan_surface_view *view) {
    double down = fmax(bolan_radians(-view->pitch_deg) + uniform(-0.5, 0.5) * view->fov_y, 0.003);
    double azimuth = bolan_radians(view->heading_deg) + uniform(-0.5, 0.5) * view->fov_y * view->aspect;
    double r = view->eye.z / tan(down);
    return (bolan_dvec2){view->eye.x + r * sin(azimuth), view->eye.y + r * cos(azimuth)};
}

// A point within three cells of the border of a level, on either side: the next step changes the triangles there.
static bolan_dvec2 point_by_border(const bolan_nested *nested) {
    const bolan_nested_level *at = &nested->level[below(nested->levels)];
    double across = uniform(-3, 3) + (below(2) ? nested->cells : 0), along = uniform(0, nested->cells);
    bool x = below(2);
    return (bolan_dvec2){at->x0 + at->spacing * (x ? along : across), at->y0 + at->spacing * (x ? across : along)};
}

static bool in_view(const bolan_surface_view *view, bolan_dvec2 p) {
    double x = p.x - view->eye.x, y = p.y - view->eye.y, r = hypot(x, y);
    double off = remainder(atan2(x, y) - bolan_radians(view->heading_deg), 2.0 * BOLAN_PI);
    double up = -atan2(view->eye.z, r) - bolan_radians(view->pitch_deg);
    return fabs(off) < 0.5 * view->fov_y * view->aspect && fabs(up) < 0.5 * view->fov_y;
}

static void compare_frames(const mesh *before, const mesh *after, const bolan_surface_view *view, jumps *j) {
    double pixel = view->fov_y / view->pixel_height, h = view->eye.z;
    for (int k = 0; k < 200; ++k) {
        bolan_dvec2 p = k % 2 ? point_in_view(view) : point_by_border(&after->nested);
        double was, is;
        if (!in_view(view, p)) continue;
        if (!drawn_height(before, p.x, p.y, &was) || !drawn_height(after, p.x, p.y, &is)) continue;
        double r = hypot(p.x - view->eye.x, p.y - view->eye.y), away = hypot(r, h);
        j->worst = fmax(j->worst, fabs(is - was) * (r / away) / away / pixel);
        ++j->count;
    }
}

// Two seconds at 60 frames a second. Velocity [m/s], turn and nod [deg/s].
static jumps fly(bolan_nested_desc desc, bolan_surface_view view, bolan_dvec3 velocity, double turn, double nod) {
    jumps j = {0};
    build(&meshes[0], &desc, &view);
    for (int frame = 1; frame <= 120; ++frame) {
        view.eye.x += velocity.x / 60, view.eye.y += velocity.y / 60, view.eye.z += velocity.z / 60;
        view.heading_deg += turn / 60, view.pitch_deg += nod / 60;
        mesh *before = &meshes[(frame + 1) % 2], *after = &meshes[frame % 2];
        build(after, &desc, &view);
        j.steps += memcmp(before->nested.level, after->nested.level, sizeof before->nested.level) != 0;
        compare_frames(before, after, &view, &j);
    }
    return j;
}

static bolan_surface_view view_at(double height, double pitch) {
    return (bolan_surface_view){.eye = {100.3, -20.7, height},
                                .heading_deg = 35,
                                .pitch_deg = pitch,
                                .fov_y = 0.9,
                                .aspect = 16.0 / 9.0,
                                .pixel_height = 720};
}

// The acceptance bound is one pixel between two frames.
static void assert_calm(bolan_nested_desc desc) {
    const struct {
        double height, pitch;
        bolan_dvec3 velocity;
        double turn, nod;
    } flights[] = {
        {5, -5, {5, 8, 0}, 0, 0},       {10, -5, {5, 8, 0}, 0, 0},        {30, -15, {30, 50, 0}, 0, 0},
        {100, -10, {60, 100, 0}, 0, 0}, {1000, -15, {120, 200, 0}, 0, 0}, {20, -20, {0, 0, 10}, 0, 0},
        {20, -20, {0, 0, 0}, 20, 0},    {20, -20, {0, 0, 0}, 0, 5},
    };
    int steps = 0, count = 0;
    for (size_t k = 0; k < sizeof flights / sizeof flights[0]; ++k) {
        bolan_surface_view view = view_at(flights[k].height, flights[k].pitch);
        jumps j = fly(desc, view, flights[k].velocity, flights[k].turn, flights[k].nod);
        print_message("from %4g m: %3d steps, at most %.3f px\n", flights[k].height, j.steps, j.worst);
        assert_true(j.worst < 1.0);
        steps += j.steps, count += j.count;
    }
    assert_true(steps > 50 && count > 50000);
}

static void no_point_of_the_papers_grid_jumps_by_a_pixel(void **state) {
    (void)state;
    make_sea(3.0);
    bolan_nested_desc desc = bolan_nested_desc_default();
    desc.spacing = 64.0; // fine enough for the waves: by itself it reaches to the horizon, with cells that carry few
    assert_calm(desc);
    desc.spacing = 0.0;
    desc.levels = 10;
    assert_calm(desc);
}

static void no_point_of_a_fine_grid_jumps_by_a_pixel(void **state) {
    (void)state;
    make_sea(3.0);
    assert_calm((bolan_nested_desc){.cells = 64, .levels = 12});
}

RUN_TESTS(cmocka_unit_test(no_point_of_the_papers_grid_jumps_by_a_pixel),
          cmocka_unit_test(no_point_of_a_fine_grid_jumps_by_a_pixel))

// SPDX-License-Identifier: MIT
// Nested grids under a moving camera: between two frames no point of the drawn sea may jump by a pixel. The sea stands
// still, so that whatever moves is the mesh's doing. 64 cosines of the spectrum of Pierson and Moskowitz, Hs = 3 m, leave the
// geometry where they become shorter than the spacing resolves.
#include "support.h"

#include "bolan/surface.h"

#include <string.h>

#define WAVES 64
#define CAPACITY 70000

static struct { double a, kx, ky, phase, length; } wave[WAVES];

static double uniform(double low, double high) { return low + (high - low) * ((double)rand() / RAND_MAX); }

// S(w) = 0.78 / w^5 exp(-3.11 / (w^4 H^2)); equal shares of the energy: w_i = (B / ln(2 M / (2 i - 1)))^(1/4).
static void make_sea(double hs) {
    double b = 3.11 / (hs * hs), m0 = 0.78 / (4.0 * b);
    srand(4);
    for (int i = 0; i < WAVES; ++i) {
        double w = pow(b / log(2.0 * WAVES / (2.0 * i + 1.0)), 0.25), k = w * w / BOLAN_GRAVITY,
               to = uniform(-1.5, 1.5);
        wave[i].a = sqrt(2.0 * m0 / WAVES);
        wave[i].kx = k * cos(to), wave[i].ky = k * sin(to);
        wave[i].phase = uniform(0, 2 * BOLAN_PI);
        wave[i].length = 2 * BOLAN_PI / k;
    }
}

// Waves shorter than twice the spacing are gone, those longer than four times are whole.
static double height_at(double x, double y, double spacing) {
    double sum = 0.0;
    for (int i = 0; i < WAVES; ++i) {
        double t = fmin(fmax(wave[i].length / (2.0 * spacing) - 1.0, 0.0), 1.0);
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
static bool drawn_height(const mesh *m, double x, double y, double *height, double *border) {
    for (uint32_t l = m->nested.levels; l-- > 0;) {
        const bolan_nested_level *at = &m->nested.level[l];
        double u = (x - at->x0) / at->spacing, w = (y - at->y0) / at->spacing, n = m->nested.cells;
        if (u < 0 || w < 0 || u >= n || w >= n) continue;
        size_t stride = m->nested.cells + 1, a = (l * stride + (size_t)w) * stride + (size_t)u;
        *border = fmin(fmin(u, n - u), fmin(w, n - w));
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
    double worst, square; // [pixels]
    int count, steps;
} jumps;

// Points spread evenly over the lower half of the picture: that is where jumps are seen.
static void compare_frames(const mesh *before, const mesh *after, const bolan_surface_view *view, jumps *j) {
    double pixel = view->fov_y / view->pixel_height, h = view->eye.z;
    for (int k = 0; k < 150; ++k) {
        double down = bolan_radians(-view->pitch_deg) + uniform(-0.5, 0.5) * view->fov_y;
        double azimuth = bolan_radians(view->heading_deg) + uniform(-0.5, 0.5) * view->fov_y * view->aspect;
        if (down < 0.003) continue;
        double r = h / tan(down), x = view->eye.x + r * sin(azimuth), y = view->eye.y + r * cos(azimuth);
        double was, is, border;
        if (!drawn_height(before, x, y, &was, &border) || !drawn_height(after, x, y, &is, &border)) continue;
        double seen = fabs(is - was) * cos(down) / hypot(r, h) / pixel;
        j->worst = fmax(j->worst, seen);
        j->square += seen * seen;
        ++j->count;
    }
}

static jumps fly(bolan_nested_desc desc, bolan_surface_view view, bolan_dvec3 velocity, double turn, double nod) {
    jumps j = {0};
    build(&meshes[0], &desc, &view);
    for (int frame = 1; frame <= 240; ++frame) {
        view.eye.x += velocity.x / 60, view.eye.y += velocity.y / 60, view.eye.z += velocity.z / 60;
        view.heading_deg += turn / 60, view.pitch_deg += nod / 60;
        mesh *before = &meshes[(frame + 1) % 2], *after = &meshes[frame % 2];
        build(after, &desc, &view);
        j.steps += memcmp(before->nested.level, after->nested.level, sizeof before->nested.level) != 0;
        compare_frames(before, after, &view, &j);
    }
    print_message("n %u L %u d0 %g df %g: %d steps, worst %.3f px, rms %.4f\n", desc.cells, meshes[0].nested.levels,
                  meshes[0].nested.level[0].spacing, meshes[0].nested.level[meshes[0].nested.levels - 1].spacing,
                  j.steps, j.worst, sqrt(j.square / j.count));
    assert_true(j.count > 10000);
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

static void no_point_jumps_by_a_pixel(void **state) {
    (void)state;
    make_sea(3.0);
    bolan_nested_desc paper = bolan_nested_desc_default(), fine = {.cells = 64, .levels = 12};
    for (int k = 0; k < 2; ++k) {
        bolan_nested_desc d = k ? fine : paper;
        fly(d, view_at(5, -5), bolan_dv3(5, 8, 0), 0, 0);
        fly(d, view_at(10, -5), bolan_dv3(5, 8, 0), 0, 0);
        fly(d, view_at(30, -15), bolan_dv3(30, 50, 0), 0, 0);
        fly(d, view_at(100, -10), bolan_dv3(60, 100, 0), 0, 0);
        fly(d, view_at(1000, -15), bolan_dv3(120, 200, 0), 0, 0);
        fly(d, view_at(20, -20), bolan_dv3(0, 0, 10), 0, 0);
        fly(d, view_at(20, -20), bolan_dv3(0, 0, 0), 20, 0);
        fly(d, view_at(20, -20), bolan_dv3(0, 0, 0), 0, 5);
    }
}

RUN_TESTS(cmocka_unit_test(no_point_jumps_by_a_pixel))

// SPDX-License-Identifier: MIT
// Nested grids: the template of the paper, where the levels stand, what of them is seen, and their normals. And the
// quad.
#include "support.h"

#include "bolan/earth.h"
#include "bolan/surface.h"

#include <string.h>

#define CAPACITY 70000
static bolan_dvec2 rest[CAPACITY], rest_after[CAPACITY];
static bolan_surface_vertex vertices[CAPACITY], vertices_after[CAPACITY];
static uint8_t visible[CAPACITY];

static double uniform(double low, double high) { return low + (high - low) * ((double)rand() / RAND_MAX); }

static bolan_surface_view view_at(double height, double heading, double pitch) {
    return (bolan_surface_view){.eye = {1200.5, -330.25, height},
                                .heading_deg = heading,
                                .pitch_deg = pitch,
                                .fov_y = 0.9,
                                .aspect = 16.0 / 9.0,
                                .pixel_height = 720,
                                .vertical = 3.0,
                                .horizontal = 3.0};
}

static bolan_surface_view random_view(void) {
    bolan_surface_view v = view_at(pow(10.0, uniform(-0.3, 4.3)), uniform(0, 360), uniform(-90, 40));
    v.eye.x = uniform(-1e6, 1e6), v.eye.y = uniform(-1e6, 1e6);
    v.roll_deg = uniform(-30, 30);
    v.fov_y = uniform(0.05, 1.6);
    return v;
}

static uint32_t count_indices(const bolan_nested *nested) {
    uint32_t count = 0;
    for (uint32_t l = 0; l < nested->levels; ++l)
        for (uint32_t part = 0; part < BOLAN_NESTED_PARTS; ++part)
            count += bolan_surface_nested_indices(nested, l, part, NULL);
    return count;
}

static bolan_nested place(uint32_t cells, uint32_t levels, double spacing, bolan_surface_view view) {
    bolan_nested_desc desc = {.cells = cells, .levels = levels, .spacing = spacing};
    return bolan_surface_nested_place(&desc, &view);
}

// Counted on the figures of the paper: n = 4 with two levels, n = 8 with three, and the 32 cells and 6 levels of
// section 6.
static void the_papers_templates_have_their_counts_of_triangles(void **state) {
    (void)state;
    const uint32_t table[][4] = {{4, 2, 56, 50}, {8, 3, 320, 243}, {32, 6, 9728, 6534}};
    for (size_t k = 0; k < 3; ++k) {
        bolan_nested nested = place(table[k][0], table[k][1], 100.0, view_at(10, 20, -10));
        assert_int_equal(nested.levels, table[k][1]);
        assert_int_equal(count_indices(&nested), 3 * table[k][2]);
        assert_int_equal(bolan_surface_nested_vertex_count(&nested), table[k][3]);
    }
}

static void the_paper_is_the_default(void **state) {
    (void)state;
    bolan_nested_desc desc = bolan_nested_desc_default();
    assert_int_equal(desc.cells, 32);
    assert_int_equal(desc.levels, 6);
    bolan_surface_view view = view_at(3, 0, -8);
    bolan_nested nested = bolan_surface_nested_place(&desc, &view);
    assert_int_equal(count_indices(&nested), 3 * 9728);
}

static void the_triangles_cover_the_square_of_the_coarsest_level(void **state) {
    (void)state;
    static uint32_t indices[6 * 64 * 64];
    for (int k = 0; k < 50; ++k) {
        bolan_nested nested = place(4 * (1 + k % 16), 1 + k % 6, uniform(0.5, 900.0), random_view());
        bolan_surface_nested_vertices(&nested, NULL, rest, NULL, NULL);
        double area = 0.0, side = nested.cells * nested.level[0].spacing;
        for (uint32_t l = 0; l < nested.levels; ++l)
            for (uint32_t part = 0; part < BOLAN_NESTED_PARTS; ++part) {
                uint32_t count = bolan_surface_nested_indices(&nested, l, part, indices);
                for (uint32_t t = 0; t < count; t += 3) {
                    bolan_dvec2 a = rest[indices[t]], b = rest[indices[t + 1]], c = rest[indices[t + 2]];
                    double twice = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
                    assert_true(twice > 0.0);
                    area += 0.5 * twice;
                }
            }
        assert_near(area / (side * side), 1.0, 1e-12); // rounding of the sum of some thousand areas
    }
}

// Whole multiples, exactly: a vertex's place does not depend on where the camera was.
static void every_level_stands_on_its_own_grid_round_the_centre(void **state) {
    (void)state;
    for (int k = 0; k < 2000; ++k) {
        uint32_t n = 4u * (1 + rand() % 64), levels = 1 + rand() % BOLAN_NESTED_MAX_LEVELS;
        bolan_nested nested = place(n, levels, k % 2 ? uniform(1.0, 900.0) : 0.0, random_view());
        assert_int_equal(nested.cells, n);
        assert_true(nested.levels >= 1 && nested.levels <= levels);
        for (uint32_t l = 0; l < nested.levels; ++l) {
            const bolan_nested_level *at = &nested.level[l];
            double d = at->spacing, i = at->x0 / d, j = at->y0 / d;
            assert_true(i == floor(i) && j == floor(j) && i * d == at->x0 && j * d == at->y0);
            if (n > 4) { // a hole of n = 4 cannot move
                assert_true(fabs(at->x0 + 0.5 * n * d - nested.centre.x) <= d * (1 + 1e-9));
                assert_true(fabs(at->y0 + 0.5 * n * d - nested.centre.y) <= d * (1 + 1e-9));
            }
            if (l + 1 == nested.levels) break;
            assert_true(at->hole_i >= 1 && at->hole_i <= n / 2 - 1 && at->hole_j >= 1 && at->hole_j <= n / 2 - 1);
            assert_true(nested.level[l + 1].spacing == 0.5 * d);
            assert_true(nested.level[l + 1].x0 == at->x0 + at->hole_i * d);
            assert_true(nested.level[l + 1].y0 == at->y0 + at->hole_j * d);
        }
    }
}

static void a_level_stays_where_it_is_when_a_coarser_one_comes(void **state) {
    (void)state;
    for (int k = 0; k < 500; ++k) {
        bolan_surface_view view = random_view();
        view.eye.z = uniform(2, 8); // low, so that no level is left out
        bolan_nested few = place(8 + 4 * (k % 8), 3, 64.0, view), more = place(few.cells, 5, 256.0, view);
        assert_int_equal(few.levels, 3);
        assert_int_equal(more.levels, 5);
        assert_memory_equal(few.level, more.level + 2, 3 * sizeof few.level[0]);
    }
}

static void the_centre_is_what_is_looked_at_unless_that_is_far(void **state) {
    (void)state;
    bolan_nested down = place(16, 4, 0.0, view_at(100, 70, -90));
    assert_near(down.centre.x, 1200.5, 1e-6); // rounding of cos(90 deg) at 100 m
    assert_near(down.centre.y, -330.25, 1e-6);
    bolan_nested slanted = place(16, 4, 0.0, view_at(100, 90, -45));
    assert_near(slanted.centre.x - 1200.5, 100.0, 0.01); // the drop of the earth over 100 m is 0.8 mm
    assert_near(slanted.centre.y + 330.25, 0.0, 1e-6);
    // level, 0.9 rad high: the nearest water is at 100 m / tan 0.45; twice that, not the horizon at 36 km
    bolan_nested level = place(16, 4, 0.0, view_at(100, 0, 0));
    assert_near(level.centre.y + 330.25, 2.0 * 100.0 / tan(0.45), 0.1);
    bolan_nested up = place(16, 4, 0.0, view_at(100, 0, 80));
    assert_true(up.centre.y + 330.25 < 36000.0);
    // from below, up is where the water is
    bolan_nested below = place(16, 4, 0.0, view_at(-20, 90, 45));
    assert_near(below.centre.x - 1200.5, 20.0, 0.01);
}

static void high_eyes_get_fewer_levels(void **state) {
    (void)state;
    uint32_t before = 99;
    for (double height = 1.0; height < 3e4; height *= 1.5) {
        bolan_nested nested = place(64, 16, 512.0, view_at(height, 0, -45));
        assert_true(nested.levels <= before);
        before = nested.levels;
        double pixel = 0.9 / 720, finest = nested.level[nested.levels - 1].spacing;
        if (nested.levels > 1) assert_true(finest >= pixel * height); // less than a pixel straight below is wasted
    }
    assert_true(before < 8);
}

// Whatever ray of the picture meets mean water more than half a pixel under the horizon meets it inside level 0.
static void the_coarsest_level_reaches_half_a_pixel_below_the_horizon(void **state) {
    (void)state;
    int tried = 0;
    for (int k = 0; k < 500; ++k) {
        bolan_surface_view view = random_view();
        double h = fmax(view.eye.z, 0.5);
        bolan_nested nested = place(4 + 4 * (k % 20), 1 + k % 9, 0.0, view);
        const bolan_nested_level *out = &nested.level[0];
        bolan_mat4 camera = bolan_m4_transpose(bolan_m4_view(view.heading_deg, view.pitch_deg, view.roll_deg));
        for (int i = 0; i < 40; ++i) {
            double t = tan(0.5 * view.fov_y), sx = i < 4 ? i % 2 * 2 - 1 : uniform(-1, 1);
            double sy = i < 4 ? i / 2 * 2 - 1 : uniform(-1, 1);
            bolan_vec4 d =
                bolan_m4_mul_v4(camera, (bolan_vec4){(float)(sx * t * view.aspect), (float)(sy * t), -1.0f, 0.0f});
            double plan = hypot(d.x, d.y), slope = -d.z / plan, dip = sqrt(2.0 * h / BOLAN_EARTH_RADIUS);
            if (slope < dip + 0.5 * view.fov_y / view.pixel_height) continue;
            double r = BOLAN_EARTH_RADIUS * (slope - sqrt(slope * slope - dip * dip));
            double x = view.eye.x + r * d.x / plan, y = view.eye.y + r * d.y / plan, side = nested.cells * out->spacing;
            double slack = 1e-4 * r; // the matrix is float
            assert_true(x > out->x0 - slack && x < out->x0 + side + slack);
            assert_true(y > out->y0 - slack && y < out->y0 + side + slack);
            ++tried;
        }
    }
    assert_true(tried > 5000);
}

static void all_is_finite_for_any_view(void **state) {
    (void)state;
    const double heights[] = {-50, -0.1, 0, 0.1, 2, 1e3, 2e4}, pitches[] = {-90, -89.9, -45, -1, 0, 1, 45, 90};
    const uint32_t cells[] = {4, 8, 60, 64}, levels[] = {1, 2, 16};
    for (int k = 0; k < 7 * 8 * 4 * 3; ++k) {
        bolan_surface_view view = view_at(heights[k % 7], 33, pitches[k / 7 % 8]);
        view.fov_y = k % 2 ? 2.8 : 0.001;
        view.roll_deg = k % 5 ? 0 : 90;
        bolan_nested nested = place(cells[k / 56 % 4], levels[k / 224], 0.0, view);
        bolan_surface_nested_vertices(&nested, &view, rest, vertices, visible);
        uint32_t count = bolan_surface_nested_vertex_count(&nested);
        for (uint32_t v = 0; v < count; ++v) {
            assert_true(isfinite(vertices[v].x) && isfinite(vertices[v].y) && isfinite(vertices[v].z));
            assert_true(vertices[v].spacing > 0.0f && isfinite(vertices[v].spacing));
        }
    }
}

static void the_largest_grid_fits_its_counts(void **state) {
    (void)state;
    bolan_nested nested = place(256, BOLAN_NESTED_MAX_LEVELS, 4096.0, view_at(0.6, 0, -30));
    assert_int_equal(nested.cells, 256);
    uint32_t n2 = 256 * 256;
    assert_int_equal(count_indices(&nested), 6 * (n2 + (nested.levels - 1) * (n2 - n2 / 4)));
}

// Eye-relative places, the drop of the round earth, and the spacing within a level.
static void vertices_are_rest_positions_seen_from_the_eye(void **state) {
    (void)state;
    for (int k = 0; k < 100; ++k) {
        bolan_surface_view view = random_view();
        view.water_level = uniform(-5, 5);
        bolan_nested nested = place(32, 6, 0.0, view);
        bolan_surface_nested_vertices(&nested, &view, rest, vertices, NULL);
        uint32_t square = 33 * 33;
        for (uint32_t v = 0; v < square * nested.levels; ++v) {
            double x = rest[v].x - view.eye.x, y = rest[v].y - view.eye.y, d = nested.level[v / square].spacing;
            double z = view.water_level - view.eye.z - (x * x + y * y) / (2 * 6371000.0);
            double rounding = 2e-7 * (fabs(x) + fabs(y) + fabs(z)); // a few units of float
            assert_near(vertices[v].x, x, rounding);
            assert_near(vertices[v].y, y, rounding);
            // a stitched vertex lies on a chord of the earth, d^2 / 2R below it
            assert_near(vertices[v].z, z, rounding + d * d / (2 * 6371000.0));
            assert_true(vertices[v].spacing >= fmaxf((float)d, (float)nested.least_spacing));
            assert_true(vertices[v].spacing <= fmaxf((float)(2 * d), (float)nested.least_spacing));
        }
    }
}

// The vertex of the finest level that stands there: whether there is one, and its spacing.
static bool drawn_at(const bolan_nested *nested, const bolan_surface_vertex *of, bolan_dvec2 p, float *spacing) {
    for (uint32_t l = nested->levels; l-- > 0;) {
        const bolan_nested_level *at = &nested->level[l];
        double i = (p.x - at->x0) / at->spacing, j = (p.y - at->y0) / at->spacing, n = nested->cells;
        if (i < 0 || j < 0 || i > n || j > n) continue;
        if (i != floor(i) || j != floor(j)) return false;
        *spacing = of[(size_t)l * (nested->cells + 1) * (nested->cells + 1) + (size_t)(j * (n + 1) + i)].spacing;
        return true;
    }
    return false;
}

// Over many steps of the levels: who stands there before and after hardly changes what it carries.
static void fly_and_climb(double spacing, int *stepped, int *fewer) {
    const uint32_t n = 16;
    bolan_surface_view view = view_at(20, 30, -12);
    bolan_nested before = place(n, 5, spacing, view);
    bolan_surface_nested_vertices(&before, &view, rest, vertices, NULL);
    int common = 0;
    for (int frame = 0; frame < 400; ++frame) {
        double centre = before.centre.x, high = before.least_spacing;
        view.eye.x += 0.8, view.eye.y += 0.5;
        view.eye.z *= 1.01; // from 20 m to 1 km
        bolan_nested after = place(n, 5, spacing, view);
        bolan_surface_nested_vertices(&after, &view, rest_after, vertices_after, NULL);
        double moved = fmax(fabs(after.centre.x - centre), fabs(after.centre.y - before.centre.y));
        *stepped += memcmp(before.level, after.level, sizeof before.level) != 0;
        *fewer += before.levels > after.levels || before.level[0].spacing < after.level[0].spacing;
        for (uint32_t v = 0; v < (n + 1) * (n + 1) * after.levels; ++v) {
            float was, is;
            if (!drawn_at(&before, vertices, rest_after[v], &was)) continue;
            if (!drawn_at(&after, vertices_after, rest_after[v], &is)) continue;
            ++common;
            // d more over the 7 - 4.8 cells of the rise, where the centre moves one cell
            double bound = moved / 2.2 + fabs(after.least_spacing - high);
            assert_near(is, was, bound * 1.0001 + 1e-5 * was);
        }
        before = after;
        memcpy(vertices, vertices_after, sizeof vertices);
    }
    assert_true(common > 100000);
}

static void spacing_changes_smoothly_while_levels_step_come_and_go(void **state) {
    (void)state;
    int stepped = 0, fewer = 0;
    fly_and_climb(0.0, &stepped, &fewer);
    fly_and_climb(16.0, &stepped, &fewer);
    assert_true(stepped > 100 && fewer > 3);
}

// Figure 4 with the angle instead of the cross products. Where the sides are moved outwards by g they meet at g /
// sin(half) behind the eye; a point is between them where its azimuth from there is within half of the heading.
static void two_cross_products_agree_with_the_angle(void **state) {
    (void)state;
    int tried = 0, seen = 0, mismatches = 0;
    while (tried < 100000) {
        bolan_surface_view view = view_at(uniform(2, 200), uniform(0, 360), 0);
        view.fov_y = uniform(0.2, 1.2), view.aspect = uniform(0.6, 1.8);
        bolan_nested nested = place(16, 3, uniform(1, 200), view);
        bolan_surface_nested_vertices(&nested, &view, rest, vertices, visible);
        double half = atan(tan(0.5 * view.fov_y) * view.aspect), heading = bolan_radians(view.heading_deg);
        for (uint32_t v = 0; v < 17 * 17 * nested.levels; ++v) {
            uint32_t l = v / 289, i = v % 17, j = v % 289 / 17, m = nested.level[l].hole_i, w = nested.level[l].hole_j;
            bool border = i == 0 || j == 0 || i == 16 || j == 16;
            bool hole = l + 1 < nested.levels && i >= m && i <= m + 8 && j >= w && j <= w + 8;
            if (!border && !hole) continue; // whose cell is known without the rule of the spacing
            double cell =
                nested.level[l].spacing * (border && vertices[v].stitch_x + vertices[v].stitch_y == 0 ? 2 : 1);
            double guard = sqrt(2.0) * cell + view.horizontal, back = guard / sin(half);
            double x = rest[v].x - view.eye.x + back * sin(heading), y = rest[v].y - view.eye.y + back * cos(heading);
            double off = remainder(atan2(x, y) - heading, 2.0 * BOLAN_PI);
            mismatches += (fabs(off) <= half) != visible[v];
            seen += visible[v];
            ++tried;
        }
    }
    assert_int_equal(mismatches, 0);
    assert_true(seen > 20000 && seen < 80000);
}

static uint32_t find_cell(const bolan_nested *nested, double x, double y) { // the index of its south-west vertex
    for (uint32_t l = nested->levels; l-- > 0;) {
        double i = floor((x - nested->level[l].x0) / nested->level[l].spacing);
        double j = floor((y - nested->level[l].y0) / nested->level[l].spacing), n = nested->cells;
        if (i >= 0 && j >= 0 && i < n && j < n) return (uint32_t)((l * (n + 1) + j) * (n + 1) + i);
    }
    return UINT32_MAX;
}

// Water that stands up to the bounds beside its place comes into the picture: its whole cell must be visible.
static void every_cell_that_the_picture_can_show_is_visible(void **state) {
    (void)state;
    int tried = 0, hidden = 0, vertices_tried = 0;
    for (int k = 0; k < 1500; ++k) {
        bolan_surface_view view = random_view();
        view.eye.x *= 1e-3, view.eye.y *= 1e-3;
        view.vertical = uniform(0, 5), view.horizontal = uniform(0, 8);
        bolan_nested nested = place(16, 5, 0.0, view);
        bolan_surface_nested_vertices(&nested, NULL, rest, NULL, NULL);
        bolan_surface_nested_vertices(&nested, &view, NULL, NULL, visible);
        bolan_mat4 camera = bolan_m4_transpose(bolan_m4_view(view.heading_deg, view.pitch_deg, view.roll_deg));
        for (int i = 0; i < 40; ++i) {
            double t = tan(0.5 * view.fov_y);
            bolan_vec4 d = bolan_m4_mul_v4(camera, (bolan_vec4){(float)(uniform(-1, 1) * t * view.aspect),
                                                                (float)(uniform(-1, 1) * t), -1.0f, 0.0f});
            double up = uniform(-1, 1) * view.vertical, h = view.eye.z - up, plan = hypot(d.x, d.y),
                   slope = -d.z / plan;
            double under = slope * slope - 2.0 * h / BOLAN_EARTH_RADIUS;
            if (slope <= 0.0 || under < 0.0 || h <= 0.0) continue;
            double r = 2.0 * h / (slope + sqrt(under)), turn = uniform(0, 2.0 * BOLAN_PI);
            uint32_t v = find_cell(&nested, view.eye.x + r * d.x / plan + view.horizontal * cos(turn),
                                   view.eye.y + r * d.y / plan + view.horizontal * sin(turn));
            if (v == UINT32_MAX) continue;
            assert_true(visible[v] && visible[v + 1] && visible[v + 17] && visible[v + 18]);
            ++tried;
        }
        for (uint32_t v = 0; v < 289 * nested.levels; ++v, ++vertices_tried) hidden += !visible[v];
    }
    assert_true(tried > 10000);
    assert_true(hidden > vertices_tried / 5); // and it does save work
}

// ---- normals --------------------------------------------------------------------------------------------------------

static bolan_vec3 wave_at(bolan_dvec2 p) {
    return bolan_v3((float)p.x, (float)p.y, (float)(0.3 * sin(1.1 * p.x + 0.4) * cos(0.7 * p.y) + 0.2 * p.x));
}
static bolan_vec3 wave_normal(bolan_dvec2 p) {
    double sx = 0.33 * cos(1.1 * p.x + 0.4) * cos(0.7 * p.y) + 0.2, sy = -0.21 * sin(1.1 * p.x + 0.4) * sin(0.7 * p.y);
    return bolan_v3_normalize(bolan_v3((float)-sx, (float)-sy, 1.0f));
}

// No seam in the light: both levels of a border have one normal, and a stitched vertex that of the edge it lies on.
static void assert_one_normal_where_levels_meet(const bolan_nested *nested, const bolan_vec3 *normals) {
    for (uint32_t l = 1; l < nested->levels; ++l)
        for (uint32_t k = 0; k < 17 * 17; ++k) {
            uint32_t i = k % 17, j = k / 17, v = l * 289 + k;
            if (i != 0 && j != 0 && i != 16 && j != 16) continue;
            if ((i + j) % 2 == 1) {
                uint32_t step = j == 0 || j == 16 ? 1 : 17;
                bolan_vec3 mean = bolan_v3_normalize(bolan_v3_add(normals[v - step], normals[v + step]));
                assert_near(bolan_v3_length(bolan_v3_sub(normals[v], mean)), 0.0, 1e-6); // float
                continue;
            }
            const bolan_nested_level *parent = &nested->level[l - 1];
            uint32_t outer = (l - 1) * 289 + (parent->hole_j + j / 2) * 17 + parent->hole_i + i / 2;
            assert_memory_equal(&normals[v], &normals[outer], sizeof normals[v]);
        }
}

// Largest angle [rad] between the normals of the mesh and the surface's own, over the vertices that triangles use.
static double worst_normal(double spacing) {
    static bolan_vec3 positions[CAPACITY], normals[CAPACITY];
    bolan_surface_view view = view_at(2, 0, -60);
    view.eye = bolan_dv3(3.0, 2.0, 2.0);
    view.pixel_height = 1000000; // no level is too fine
    bolan_nested nested = place(16, 3, spacing, view);
    assert_int_equal(nested.levels, 3);
    bolan_surface_nested_vertices(&nested, &view, rest, vertices, NULL);
    for (uint32_t v = 0; v < 3 * 289; ++v) {
        bolan_dvec2 s = {vertices[v].stitch_x, vertices[v].stitch_y};
        bolan_vec3 a = wave_at((bolan_dvec2){rest[v].x - s.x, rest[v].y - s.y});
        positions[v] = bolan_v3_scale(bolan_v3_add(a, wave_at((bolan_dvec2){rest[v].x + s.x, rest[v].y + s.y})), 0.5f);
    }
    bolan_surface_nested_normals(&nested, positions, normals);
    assert_one_normal_where_levels_meet(&nested, normals);
    double worst = 0.0;
    for (uint32_t v = 0; v < 3 * 289; ++v) {
        uint32_t l = v / 289, i = v % 17, j = v % 289 / 17, hi = nested.level[l].hole_i, hj = nested.level[l].hole_j;
        assert_near(bolan_v3_length(normals[v]), 1.0, 1e-6); // float
        if (l < 2 && i > hi && i < hi + 8 && j > hj && j < hj + 8) continue;
        if (l == 0 && (i == 0 || j == 0 || i == 16 || j == 16)) continue; // one side only: first order
        bolan_vec3 off = bolan_v3_cross(normals[v], wave_normal(rest[v]));
        worst = fmax(worst, bolan_v3_length(off));
    }
    return worst;
}

static void normals_converge_to_those_of_the_surface(void **state) {
    (void)state;
    double coarse = worst_normal(0.4), fine = worst_normal(0.1);
    // at the borders of the levels triangles of two sizes meet, which leaves an error of first order: a quarter, and a
    // tenth for what is of higher order
    assert_true(coarse < 0.15);
    assert_true(fine < 0.28 * coarse);
    assert_true(worst_normal(0.05) < 0.55 * fine);
}

static void a_plane_has_one_normal(void **state) {
    (void)state;
    static bolan_vec3 positions[6 * 33 * 33], normals[6 * 33 * 33];
    bolan_nested nested = place(32, 6, 32.0, view_at(2, 0, -30));
    bolan_surface_nested_vertices(&nested, NULL, rest, NULL, NULL);
    for (uint32_t v = 0; v < 6 * 33 * 33; ++v)
        positions[v] = bolan_v3((float)(rest[v].x - 1200), (float)(rest[v].y + 330),
                                (float)(0.25 * (rest[v].x - 1200) - 0.5 * (rest[v].y + 330)));
    bolan_surface_nested_normals(&nested, positions, normals);
    bolan_vec3 plane = bolan_v3_normalize(bolan_v3(-0.25f, 0.5f, 1.0f));
    for (uint32_t l = 0; l < nested.levels; ++l)
        for (uint32_t j = 0; j < 33; ++j)
            for (uint32_t i = 0; i < 33; ++i) {
                const bolan_nested_level *at = &nested.level[l];
                bool inside = l + 1 < nested.levels && i > at->hole_i && i < at->hole_i + 16 && j > at->hole_j &&
                              j < at->hole_j + 16;
                bolan_vec3 n = normals[(l * 33 + j) * 33 + i], want = inside ? bolan_v3(0, 0, 1) : plane;
                assert_near(bolan_v3_length(bolan_v3_sub(n, want)), 0.0,
                            1e-4); // float, 1 km from the origin, cells of 1 m
            }
}

// ---- the rest -------------------------------------------------------------------------------------------------------

// FNV-1a over the bits of everything, for 300 views: the same on every machine and at every level of optimisation.
static uint64_t hash_views(void) {
    uint64_t hash = 0xcbf29ce484222325u, state = 9;
    for (int k = 0; k < 300; ++k) {
        double u[6];
        for (int i = 0; i < 6; ++i) {
            state = state * 6364136223846793005u + 1442695040888963407u;
            u[i] = (double)(state >> 11) * 0x1p-53;
        }
        bolan_surface_view view = view_at(1.0 + 4000.0 * u[0] * u[0] * u[0], 360.0 * u[1], -90.0 + 120.0 * u[2]);
        view.eye.x = 1e6 * u[3], view.roll_deg = 40.0 * u[4], view.fov_y = 0.2 + u[5];
        bolan_nested nested = place(4 + 4 * (k % 6), 1 + k % 7, 0.0, view);
        bolan_surface_nested_vertices(&nested, &view, rest, vertices, visible);
        uint32_t count = bolan_surface_nested_vertex_count(&nested);
        const void *parts[] = {rest, vertices, visible};
        const size_t sizes[] = {count * sizeof *rest, count * sizeof *vertices, count};
        for (int p = 0; p < 3; ++p)
            for (size_t b = 0; b < sizes[p]; ++b) hash = (hash ^ ((const uint8_t *)parts[p])[b]) * 0x100000001b3u;
    }
    return hash;
}

static void the_same_bits_come_out_each_time_and_everywhere(void **state) {
    (void)state;
    uint64_t hash = hash_views();
    assert_true(hash == hash_views());
    if (hash != 0xa7d3e3d31b0bb795u)
        fail_msg("the hash is 0x%llx", (unsigned long long)hash); // changes with the rules of placement only
}

static int misuses;
static void count_misuse(void *user, const char *expression, const char *file, int line) {
    (void)user, (void)expression, (void)file, (void)line;
    ++misuses;
}

static void a_description_out_of_range_is_reported_and_clamped(void **state) {
    (void)state;
    const bolan_nested_desc bad[] = {{.cells = 0, .levels = 3},    {.cells = 30, .levels = 3},
                                     {.cells = 1024, .levels = 3}, {.cells = 8, .levels = 0},
                                     {.cells = 8, .levels = 17},   {.cells = 8, .levels = 3, .spacing = -1.0}};
    bolan_set_hooks(&(bolan_hooks){.assert_failed = count_misuse});
    bolan_surface_view view = view_at(10, 0, -10);
    for (int k = 0; k < 6; ++k) {
        misuses = 0;
        bolan_nested nested = bolan_surface_nested_place(&bad[k], &view);
        assert_int_equal(misuses, 1);
        assert_true(nested.cells >= 4 && nested.cells <= 256 && nested.cells % 4 == 0);
        assert_true(nested.levels >= 1 && nested.levels <= BOLAN_NESTED_MAX_LEVELS && nested.level[0].spacing > 0.0);
    }
    bolan_set_hooks(NULL);
}

// Distances to the geometric horizon, R = 6371 km.
static void the_quad_lies_as_low_as_the_horizon(void **state) {
    (void)state;
    const double table[][2] = {{2, 5050}, {10, 11290}, {100, 35700}, {1000, 112900}, {10000, 357100}};
    for (size_t k = 0; k < 5; ++k) {
        bolan_surface_view view = view_at(table[k][0], 77, -3);
        view.vertical = 0.0;
        bolan_surface_vertex q[4];
        bolan_surface_quad(&view, q);
        for (int v = 0; v < 4; ++v) {
            // to the digits of the table and to the first order of h / R
            assert_near(fabsf(q[v].x), 0.5 * table[k][1], 0.0005 * table[k][1]);
            assert_near(fabsf(q[v].y), 0.5 * table[k][1], 0.0005 * table[k][1]);
            const double dip = acos(6371e3 / (6371e3 + table[k][0]));
            assert_near(atan(table[k][0] / fabs((double)q[v].x)), dip, 0.001 * dip);
            assert_true(q[v].z == (float)-table[k][0]);
            assert_true(q[v].stitch_x == 0.0f && q[v].stitch_y == 0.0f);
            assert_true(q[v].spacing == q[1].x - q[0].x);
        }
        assert_true(q[0].x < 0 && q[0].y < 0 && q[1].x > 0 && q[1].y < 0 && q[2].x < 0 && q[2].y > 0 && q[3].x > 0);
    }
}

static void the_quads_two_triangles_face_up_and_share_a_diagonal(void **state) {
    (void)state;
    bolan_surface_view view = view_at(10, 0, 0);
    bolan_surface_vertex q[4];
    bolan_surface_quad(&view, q);
    const uint32_t *at = bolan_surface_quad_indices;
    double area = 0.0;
    for (int t = 0; t < 6; t += 3) {
        bolan_surface_vertex a = q[at[t]], b = q[at[t + 1]], c = q[at[t + 2]];
        double twice = ((double)b.x - a.x) * ((double)c.y - a.y) - ((double)b.y - a.y) * ((double)c.x - a.x);
        assert_true(twice > 0.0);
        area += 0.5 * twice;
    }
    assert_near(area / ((double)q[0].spacing * q[0].spacing), 1.0, 1e-6); // float
}

RUN_TESTS(cmocka_unit_test(the_papers_templates_have_their_counts_of_triangles),
          cmocka_unit_test(the_paper_is_the_default),
          cmocka_unit_test(the_triangles_cover_the_square_of_the_coarsest_level),
          cmocka_unit_test(every_level_stands_on_its_own_grid_round_the_centre),
          cmocka_unit_test(a_level_stays_where_it_is_when_a_coarser_one_comes),
          cmocka_unit_test(the_centre_is_what_is_looked_at_unless_that_is_far),
          cmocka_unit_test(high_eyes_get_fewer_levels),
          cmocka_unit_test(the_coarsest_level_reaches_half_a_pixel_below_the_horizon),
          cmocka_unit_test(all_is_finite_for_any_view), cmocka_unit_test(the_largest_grid_fits_its_counts),
          cmocka_unit_test(vertices_are_rest_positions_seen_from_the_eye),
          cmocka_unit_test(spacing_changes_smoothly_while_levels_step_come_and_go),
          cmocka_unit_test(two_cross_products_agree_with_the_angle),
          cmocka_unit_test(every_cell_that_the_picture_can_show_is_visible),
          cmocka_unit_test(normals_converge_to_those_of_the_surface), cmocka_unit_test(a_plane_has_one_normal),
          cmocka_unit_test(the_same_bits_come_out_each_time_and_everywhere),
          cmocka_unit_test(a_description_out_of_range_is_reported_and_clamped),
          cmocka_unit_test(the_quad_lies_as_low_as_the_horizon),
          cmocka_unit_test(the_quads_two_triangles_face_up_and_share_a_diagonal))

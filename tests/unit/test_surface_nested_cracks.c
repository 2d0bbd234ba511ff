// SPDX-License-Identifier: MIT
// No crack in ten thousand views. Every drawn vertex is displaced by random numbers that depend on the bits of its
// place, its spacing and nothing else, so that the least difference between two levels tears the surface; then every
// edge must be found again on its other side, whole or in two halves that lie on it, and the areas must add up.
#include "support.h"

#include "bolan/surface.h"

#include <string.h>

#define MAX_VERTICES 7000
#define MAX_TRIANGLES 10000
#define SLOTS 65536 // of the tables, more than twice what they hold

static uint64_t seed = 1;
static double uniform(void) { // 0..1
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(seed >> 11) * 0x1p-53;
}
static uint32_t below(uint32_t n) { return (uint32_t)(uniform() * n); }

static uint64_t mix(uint64_t h, const void *bytes, size_t size) {
    uint64_t word = 0;
    memcpy(&word, bytes, size);
    h = (h ^ word) * 0x9e3779b97f4a7c15u;
    return h ^ h >> 29;
}

// ---- a table from pairs of numbers to one ---------------------------------------------------------------------------

typedef struct table {
    struct slot {
        int64_t a, b;
        uint32_t value, age;
    } slot[SLOTS];
    uint32_t age; // slots of another age are empty
} table;

static struct slot *find(table *t, int64_t a, int64_t b) {
    uint64_t h = mix(mix(7, &a, sizeof a), &b, sizeof b);
    for (h &= SLOTS - 1;; h = (h + 1) & (SLOTS - 1)) {
        struct slot *s = &t->slot[h];
        if (s->age != t->age || (s->a == a && s->b == b)) return s;
    }
}

static const uint32_t *look_up(table *t, int64_t a, int64_t b) {
    struct slot *s = find(t, a, b);
    return s->age == t->age ? &s->value : NULL;
}

static bool insert(table *t, int64_t a, int64_t b, uint32_t value) { // false where it is there
    struct slot *s = find(t, a, b);
    if (s->age == t->age) return false;
    *s = (struct slot){a, b, value, t->age};
    return true;
}

// ---- the surface ----------------------------------------------------------------------------------------------------

static bolan_nested nested;
static bolan_dvec2 rest[MAX_VERTICES];
static bolan_surface_vertex vertices[MAX_VERTICES];
static uint8_t visible[MAX_VERTICES];
static bolan_dvec3 displaced[MAX_VERTICES];
static uint32_t joint[MAX_VERTICES]; // the first vertex at the same place
static uint32_t triangles[MAX_TRIANGLES][3], triangle_count;
static table places, edges;

static double unit; // the finest spacing
static int64_t column(double x) { return (int64_t)llround((x - nested.level[0].x0) / unit); }
static int64_t row(double y) { return (int64_t)llround((y - nested.level[0].y0) / unit); }

static bool stitched(uint32_t v) { return vertices[v].stitch_x != 0.0f || vertices[v].stitch_y != 0.0f; }

static bolan_dvec3 random_displacement(uint32_t v) {
    uint64_t h = mix(mix(3, &rest[v].x, 8), &rest[v].y, 8);
    h = mix(mix(h, &vertices[v].x, 4), &vertices[v].y, 4);
    h = mix(mix(h, &vertices[v].z, 4), &vertices[v].spacing, 4);
    double s = vertices[v].spacing;
    bolan_dvec3 d = bolan_dv3((double)(h & 65535), (double)(h >> 16 & 65535), (double)(h >> 32 & 65535));
    return bolan_dv3(rest[v].x + s * (d.x / 65535 - 0.5), rest[v].y + s * (d.y / 65535 - 0.5), s * (d.z / 65535 - 0.5));
}

static void take_triangles(void) {
    static uint32_t indices[3 * MAX_TRIANGLES];
    triangle_count = 0;
    for (uint32_t l = 0; l < nested.levels; ++l)
        for (uint32_t part = 0; part < BOLAN_NESTED_PARTS; ++part) {
            uint32_t count = bolan_surface_nested_indices(&nested, l, part, NULL);
            assert_int_equal(bolan_surface_nested_indices(&nested, l, part, indices), count);
            assert_true(triangle_count + count / 3 <= MAX_TRIANGLES);
            memcpy(triangles[triangle_count], indices, count * sizeof *indices);
            triangle_count += count / 3;
        }
}

// Vertices at the same place must be displaced to the same place.
static void displace(void) {
    ++places.age;
    for (uint32_t t = 0; t < triangle_count; ++t)
        for (int k = 0; k < 3; ++k) {
            uint32_t v = triangles[t][k];
            joint[v] = v;
            if (stitched(v)) continue;
            displaced[v] = random_displacement(v);
            int64_t x = column(rest[v].x), y = row(rest[v].y);
            assert_true(rest[v].x == nested.level[0].x0 + (double)x * unit &&
                        rest[v].y == nested.level[0].y0 + (double)y * unit);
            if (insert(&places, x, y, v)) continue;
            joint[v] = *look_up(&places, x, y);
            assert_memory_equal(&displaced[v], &displaced[joint[v]], sizeof displaced[v]);
            assert_int_equal(visible[v], visible[joint[v]]);
        }
}

// As the header says: to the mean of the neighbours at -stitch and +stitch, which are ordinary vertices.
static void stitch(void) {
    for (uint32_t t = 0; t < triangle_count; ++t)
        for (int k = 0; k < 3; ++k) {
            uint32_t v = triangles[t][k];
            if (!stitched(v)) continue;
            int64_t x = column(rest[v].x), y = row(rest[v].y);
            int64_t dx = llround(vertices[v].stitch_x / unit), dy = llround(vertices[v].stitch_y / unit);
            const uint32_t *a = look_up(&places, x - dx, y - dy), *b = look_up(&places, x + dx, y + dy);
            assert_true(a && b);
            assert_true(vertices[*a].spacing == vertices[v].spacing && vertices[*b].spacing == vertices[v].spacing);
            // the round earth too: the mean water of the parent's edge is straight
            assert_true(vertices[v].z == 0.5f * (vertices[*a].z + vertices[*b].z));
            if (visible[v]) assert_true(visible[*a] && visible[*b]);
            displaced[v] =
                bolan_dv3(0.5 * (displaced[*a].x + displaced[*b].x), 0.5 * (displaced[*a].y + displaced[*b].y),
                          0.5 * (displaced[*a].z + displaced[*b].z));
        }
    for (uint32_t t = 0; t < triangle_count; ++t)
        for (int k = 0; k < 3; ++k) {
            uint32_t v = triangles[t][k];
            if (!stitched(v) || insert(&places, column(rest[v].x), row(rest[v].y), v)) continue;
            joint[v] = *look_up(&places, column(rest[v].x), row(rest[v].y));
            assert_int_equal(joint[v], v); // nobody else stands there
        }
}

static void take_edges(void) {
    ++edges.age;
    for (uint32_t t = 0; t < triangle_count; ++t)
        for (int k = 0; k < 3; ++k) // an edge that is there already belongs to two triangles on the same side
            assert_true(insert(&edges, joint[triangles[t][k]], joint[triangles[t][(k + 1) % 3]], t));
}

static bool has_edge(uint32_t a, uint32_t b) { return look_up(&edges, a, b) != NULL; }

// The end of the parent's edge of which (s, end) is a half.
static const uint32_t *other_end(uint32_t s, uint32_t end) {
    return look_up(&places, 2 * column(rest[s].x) - column(rest[end].x), 2 * row(rest[s].y) - row(rest[end].y));
}

static void assert_on_edge(uint32_t s, uint32_t a, uint32_t b) {
    double bound = 1e-6 * vertices[s].spacing; // the acceptance bound
    assert_near(displaced[s].x, 0.5 * (displaced[a].x + displaced[b].x), bound);
    assert_near(displaced[s].y, 0.5 * (displaced[a].y + displaced[b].y), bound);
    assert_near(displaced[s].z, 0.5 * (displaced[a].z + displaced[b].z), bound);
}

// Is there somebody on the other side of a -> b? 1: a triangle; 2: two halves or the whole of which it is a half; 0:
// the outermost border.
static int other_side(uint32_t a, uint32_t b) {
    if (has_edge(b, a)) return 1;
    int64_t side = (int64_t)nested.cells << (nested.levels - 1);
    int64_t xa = column(rest[a].x), ya = row(rest[a].y), xb = column(rest[b].x), yb = row(rest[b].y);
    if (xa == xb && (xa == 0 || xa == side)) return 0;
    if (ya == yb && (ya == 0 || ya == side)) return 0;
    if (stitched(a) || stitched(b)) {
        const uint32_t *c = stitched(a) ? other_end(a, b) : other_end(b, a);
        assert_true(c != NULL);
        assert_true(stitched(a) ? has_edge(b, *c) : has_edge(*c, a));
        return 2;
    }
    const uint32_t *middle =
        (xa + xb) % 2 == 0 && (ya + yb) % 2 == 0 ? look_up(&places, (xa + xb) / 2, (ya + yb) / 2) : NULL;
    assert_true(middle != NULL && stitched(*middle));
    assert_true(has_edge(b, *middle) && has_edge(*middle, a));
    assert_on_edge(*middle, a, b);
    return 2;
}

static int64_t twice_area(const uint32_t *t) {
    int64_t x = column(rest[t[0]].x), y = row(rest[t[0]].y);
    return (column(rest[t[1]].x) - x) * (row(rest[t[2]].y) - y) - (column(rest[t[2]].x) - x) * (row(rest[t[1]].y) - y);
}

static void assert_watertight(void) {
    int found[3] = {0};
    int64_t area = 0, side = (int64_t)nested.cells << (nested.levels - 1);
    for (uint32_t t = 0; t < triangle_count; ++t) {
        assert_true(twice_area(triangles[t]) > 0); // counter-clockwise seen from above
        area += twice_area(triangles[t]);
        for (int k = 0; k < 3; ++k) ++found[other_side(joint[triangles[t][k]], joint[triangles[t][(k + 1) % 3]])];
    }
    // with matched edges and no triangle turned over, the sum leaves room for neither a hole nor an overlap
    assert_true(area == 2 * side * side);
    assert_int_equal(found[0], 4 * nested.cells);
    // 2 n edges of the parent and 4 n halves along the border of each inner level: 3 * 2 n * (L - 1)
    assert_int_equal(found[2], 6 * nested.cells * (nested.levels - 1));
}

static bolan_surface_view random_view(void) {
    return (bolan_surface_view){
        .eye = {4e5 * (uniform() - 0.5), 1e7 * (uniform() - 0.5), pow(10.0, 4.5 * uniform() - 0.5)},
        .heading_deg = 360.0 * uniform(),
        .pitch_deg = -90.0 + 130.0 * uniform(),
        .roll_deg = 60.0 * (uniform() - 0.5),
        .fov_y = 0.02 + 1.8 * uniform(),
        .aspect = 0.5 + 2.0 * uniform(),
        .pixel_height = 240 + below(1000),
        .vertical = 3.0,
        .horizontal = 5.0};
}

static void check_view(bolan_nested_desc desc) {
    bolan_surface_view view = random_view();
    nested = bolan_surface_nested_place(&desc, &view);
    assert_true(bolan_surface_nested_vertex_count(&nested) <= MAX_VERTICES);
    unit = nested.level[nested.levels - 1].spacing;
    bolan_surface_nested_vertices(&nested, &view, rest, vertices, visible);
    take_triangles();
    displace();
    stitch();
    take_edges();
    assert_watertight();
}

static void ten_thousand_random_views_have_no_crack(void **state) {
    (void)state;
    static const uint32_t cells[] = {4, 8, 8, 8, 12, 16};
    for (int k = 0; k < 10000; ++k) {
        bolan_nested_desc desc = {.cells = cells[below(6)], .levels = 1 + below(5)};
        if (k % 2) desc.spacing = pow(10.0, -1.0 + 4.0 * uniform()); // no power of two
        check_view(desc);
    }
}

static void the_papers_grid_has_no_crack(void **state) {
    (void)state;
    for (int k = 0; k < 20; ++k) {
        bolan_nested_desc desc = bolan_nested_desc_default();
        if (k % 2) desc.spacing = pow(10.0, 3.0 * uniform());
        check_view(desc);
    }
}

static void many_small_levels_have_no_crack(void **state) {
    (void)state;
    for (int k = 0; k < 100; ++k)
        check_view((bolan_nested_desc){.cells = 4 + 4 * below(3), .levels = BOLAN_NESTED_MAX_LEVELS});
}

RUN_TESTS(cmocka_unit_test(ten_thousand_random_views_have_no_crack), cmocka_unit_test(the_papers_grid_has_no_crack),
          cmocka_unit_test(many_small_levels_have_no_crack))

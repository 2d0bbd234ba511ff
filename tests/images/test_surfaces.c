// SPDX-License-Identifier: MIT
// Labels, normals and motion at the pixels of a view are those that the query, the ground and the poses of the objects
// give at the place of the pixel, which is found here from camera and distance alone. Reading them changes no picture.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "bolan/query.h"
#include "picture.h"

enum { WIDTH = 256, HEIGHT = 144, PIXELS = WIDTH * HEIGHT };

typedef struct reading {
    stage s;
    bolan_context *context;
    bolan_view view;
    picture picture;
    uint32_t label[PIXELS];
    bolan_vec3 normal[PIXELS], motion[PIXELS];
    bolan_flow *flow;
} reading;

// SURFACES=FOLDER: pictures of what was read, to look at.
static void show(const reading *r, const char *name) {
    static uint8_t rgb[2][PIXELS][3];
    static const uint8_t colours[][3] = {{90, 160, 255}, {0, 40, 120}, {240, 240, 240}, {90, 130, 40}};
    const char *folder = getenv("SURFACES");
    char path[512];
    if (!folder) return;
    for (int i = 0; i < PIXELS; i++) {
        const uint32_t l = r->label[i];
        const float *n = &r->normal[i].x;
        for (int c = 0; c < 3; c++) {
            rgb[0][i][c] = l < 4 ? colours[l][c] : (uint8_t)(255 - 37 * (l - 3) * (c + 1));
            rgb[1][i][c] = (uint8_t)(127.5f + 127.0f * n[c]);
        }
    }
    snprintf(path, sizeof path, "%s/%s-label.png", folder, name), bolan_png_write(path, WIDTH, HEIGHT, rgb[0][0]);
    snprintf(path, sizeof path, "%s/%s-normal.png", folder, name), bolan_png_write(path, WIDTH, HEIGHT, rgb[1][0]);
    snprintf(path, sizeof path, "%s/%s.png", folder, name), bolan_png_write(path, WIDTH, HEIGHT, r->picture.rgb);
}

static reading *read_scene(const char *name, const bolan_camera *camera) {
    reading *r = calloc(1, sizeof *r);
    bolan_scene scene;
    bolan_target *target = NULL;
    uint8_t *again = malloc((size_t)PIXELS * 3);
    assert_non_null(r);
    assert_non_null(again);
    assert_int_equal(bolan_scene_load(name, &scene), BOLAN_OK);
    scene.sky.cloud_cover = 0.0;
    if (camera) scene.camera = *camera;
    scene.camera_key_count = 0;
    if (bolan_context_create(BOLAN_GL_CORE, &r->context) != BOLAN_OK) skip_without_gl();
    assert_true(stage_open(&r->s, &scene, BOLAN_QUALITY_ULTRA, false));
    r->picture = stage_draw(&r->s, WIDTH, HEIGHT, 1);
    const bolan_water *water = bolan_world_water(r->s.world);
    assert_int_equal(bolan_flow_create(water->sea, &r->flow), BOLAN_OK);
    bolan_flow_step(r->flow, water->sea);
    assert_int_equal(bolan_target_create(WIDTH, HEIGHT, &target), BOLAN_OK);
    r->view = stage_view(&r->s, target, WIDTH, HEIGHT);
    bolan_renderer_read_surfaces(r->s.renderer, r->s.world, &r->view,
                                 &(bolan_surfaces){r->label, r->normal, r->motion, r->flow});
    assert_true(watch_is_clean("after surfaces"));
    // The same picture as before.
    bolan_renderer_draw_world(r->s.renderer, r->s.world, &r->view);
    bolan_renderer_read_rgb8(r->s.renderer, r->view.framebuffer, WIDTH, HEIGHT, again);
    assert_memory_equal(again, r->picture.rgb, (size_t)PIXELS * 3);
    bolan_target_destroy(&target);
    free(again);
    show(r, name);
    return r;
}

static void close_reading(reading *r) {
    bolan_flow_destroy(&r->flow);
    picture_free(&r->picture);
    stage_close(&r->s);
    bolan_context_destroy(&r->context);
    free(r);
}

// The place of a pixel [m], by heading and pitch: not by the matrices of the view.
static bolan_dvec3 place_of(const reading *r, uint32_t x, uint32_t y) {
    const bolan_camera *c = &r->s.scene.camera;
    const double h = bolan_radians(c->heading_deg), p = bolan_radians(c->pitch_deg);
    const double t = tan(0.5 * bolan_radians(c->fov_deg)), d = (double)r->picture.distance[y * WIDTH + x];
    const double right = (2.0 * (x + 0.5) / WIDTH - 1.0) * t * WIDTH / HEIGHT,
                 up = (1.0 - 2.0 * (y + 0.5) / HEIGHT) * t;
    const double ahead = cos(p) - up * sin(p);
    return bolan_dv3(r->view.eye.x + d * (sin(h) * ahead + cos(h) * right),
                     r->view.eye.y + d * (cos(h) * ahead - sin(h) * right), r->view.eye.z + d * (sin(p) + up * cos(p)));
}

static double dot(bolan_vec3 a, bolan_vec3 b) {
    return (double)a.x * (double)b.x + (double)a.y * (double)b.y + (double)a.z * (double)b.z;
}

static bool is_water(uint32_t label) { return label == BOLAN_LABEL_WATER || label == BOLAN_LABEL_FOAM; }

// The normal of the drawn surface, across three neighbouring pixels.
static bolan_vec3 drawn_normal(const reading *r, uint32_t x, uint32_t y) {
    const bolan_dvec3 a = place_of(r, x, y), b = place_of(r, x + 1, y), c = place_of(r, x, y + 1);
    const bolan_dvec3 u = {b.x - a.x, b.y - a.y, b.z - a.z}, v = {c.x - a.x, c.y - a.y, c.z - a.z};
    const double n[3] = {u.z * v.y - u.y * v.z, u.x * v.z - u.z * v.x, u.y * v.x - u.x * v.y};
    const double l = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    return (bolan_vec3){(float)(n[0] / l), (float)(n[1] / l), (float)(n[2] / l)};
}

// ---- the open sea ---------------------------------------------------------------------------------------------------

static void test_water_is_that_of_the_query(void **state) {
    (void)state;
    const bolan_camera camera = {
        .position = {300.0, -200.0, 4.0}, .heading_deg = 70.0, .pitch_deg = -18.0, .fov_deg = 50.0};
    reading *r = read_scene("storm", &camera);
    bolan_water water = *bolan_world_water(r->s.world);
    water.flow = r->flow;
    uint32_t count = 0, wrong = 0, foam = 0, drawn = 0;
    double across = 0.0, moved = 0.0;
    for (uint32_t y = 0; y < HEIGHT; y++)
        for (uint32_t x = 0; x < WIDTH; x++) {
            const uint32_t i = y * WIDTH + x;
            if (isinf((double)r->picture.distance[i])) {
                assert_int_equal(r->label[i], BOLAN_LABEL_SKY);
                continue;
            }
            assert_true(is_water(r->label[i]));
            if (r->picture.distance[i] > 60.0f) continue;
            const bolan_dvec3 at = place_of(r, x, y);
            const bolan_dvec2 xy = {at.x, at.y};
            bolan_query_point q;
            bolan_surface_motion m;
            bolan_query_surface(&water, &xy, 1, &q);
            bolan_query_motion(&water, NULL, &xy, 1, &m);
            const bolan_vec3 v = r->motion[i];
            const double off = fabs((double)(v.x - m.velocity.x)) + fabs((double)(v.y - m.velocity.y)) +
                               fabs((double)(v.z - m.velocity.z));
            count++;
            foam += r->label[i] == BOLAN_LABEL_FOAM;
            moved += fabs((double)v.x) + fabs((double)v.y) + fabs((double)v.z);
            // Two ways to the place differ by a tenth of a millimetre.
            wrong += dot(r->normal[i], q.normal) < 0.9999 || off > 0.01 ||
                     (r->label[i] == BOLAN_LABEL_FOAM) != ((double)q.jacobian < bolan_sea_foam_threshold(water.sea));
            if (x + 1 == WIDTH || y + 1 == HEIGHT || r->picture.distance[i] > 25.0f) continue;
            drawn++;
            across += dot(r->normal[i], drawn_normal(r, x, y));
        }
    print_message("%u pixels of water, %u wrong, %u foam; mean speed %.2f m/s; %u near ones, drawn normal %.4f\n",
                  count, wrong, foam, moved / count, drawn, across / drawn);
    assert_true(count > 5000 && foam > 50 && foam < count / 2 && drawn > 1000);
    assert_true(wrong * 200 <= count); // at folds and crests a pixel has two places
    assert_true(moved / count > 0.5);
    assert_true(across / drawn > 0.97);
    close_reading(r);
}

// ---- land -----------------------------------------------------------------------------------------------------------

static bolan_vec3 ground_normal(const bolan_ground *g, double x, double y) {
    const double h = 4.0;
    const double e = (double)(bolan_ground_elevation(g, x + h, y, h) - bolan_ground_elevation(g, x - h, y, h)) /
                     (2.0 * h),
                 n = (double)(bolan_ground_elevation(g, x, y + h, h) - bolan_ground_elevation(g, x, y - h, h)) /
                     (2.0 * h);
    const double l = sqrt(1.0 + e * e + n * n);
    return (bolan_vec3){(float)(-e / l), (float)(-n / l), (float)(1.0 / l)};
}

static void test_land_is_the_ground(void **state) {
    (void)state;
    reading *r = read_scene("island", NULL);
    const bolan_ground *ground = stage_ground(&r->s);
    const double level = r->s.scene.water.level;
    uint32_t land = 0, water = 0, wrong = 0;
    double along = 0.0, flat = 0.0;
    for (uint32_t y = 0; y < HEIGHT; y++)
        for (uint32_t x = 0; x < WIDTH; x++) {
            const uint32_t i = y * WIDTH + x;
            if (!(r->picture.distance[i] < 3000.0f)) continue;
            const bolan_dvec3 at = place_of(r, x, y);
            const double over = (double)bolan_ground_elevation(ground, at.x, at.y, 0.0) - level;
            if (over < -3.0) wrong += !is_water(r->label[i]), water++;
            if (over < 5.0) continue;
            const bolan_vec3 n = ground_normal(ground, at.x, at.y);
            land++;
            wrong += r->label[i] != BOLAN_LABEL_LAND;
            along += dot(n, r->normal[i]);
            flat += (double)r->normal[i].z;
        }
    print_message("%u pixels of land, %u of water, %u wrong; normals %.3f, mean z %.3f\n", land, water, wrong,
                  along / (land + 1), flat / (land + 1));
    assert_true(land > 500 && water > 2000);
    assert_true(wrong * 100 <= land + water);
    assert_true(along / land > 0.9);
    close_reading(r);
}

// ---- objects --------------------------------------------------------------------------------------------------------

static void test_objects_have_their_numbers(void **state) {
    (void)state;
    reading *r = read_scene("pond", NULL);
    enum { HOUSE = 2, BOAT = 3 };
    uint32_t seen[BOLAN_MAX_OBJECTS] = {0}, far_off = 0, averted = 0;
    for (uint32_t y = 0; y < HEIGHT; y++)
        for (uint32_t x = 0; x < WIDTH; x++) {
            const uint32_t i = y * WIDTH + x, label = r->label[i];
            assert_true(label != BOLAN_LABEL_LAND); // an object shows the ground
            if (label < BOLAN_LABEL_OBJECT) continue;
            const uint32_t index = label - BOLAN_LABEL_OBJECT;
            assert_true(index < r->s.scene.object_count);
            seen[index]++;
            if (index != HOUSE && index != BOAT) continue;
            const bolan_dvec3 at = place_of(r, x, y), eye = r->view.eye;
            const bolan_dvec3 origin = bolan_world_object_pose(r->s.world, index).origin;
            const bolan_vec3 back = {(float)(eye.x - at.x), (float)(eye.y - at.y), (float)(eye.z - at.z)};
            far_off += hypot(at.x - origin.x, at.y - origin.y) > 8.0;
            averted += dot(back, r->normal[i]) < 0.0;
        }
    print_message("house %u, boat %u, bank %u pixels; %u far off, %u averted\n", seen[HOUSE], seen[BOAT], seen[0],
                  far_off, averted);
    assert_true(seen[HOUSE] > 100 && seen[BOAT] > 100 && seen[0] > 500);
    assert_int_equal(far_off, 0);
    assert_true(averted * 20 <= seen[HOUSE] + seen[BOAT]);
    close_reading(r);
}

// ---- refusals -------------------------------------------------------------------------------------------------------

static void test_what_cannot_be_read_is_left_alone(void **state) {
    (void)state;
    reading *r = read_scene("open-sea", NULL);
    const uint32_t before = 77;
    uint32_t label = before;
    bolan_view other = r->view;
    other.width = 64;
    bolan_renderer_read_surfaces(r->s.renderer, r->s.world, &other, &(bolan_surfaces){.label = &label});
    assert_int_equal(label, before);
    bolan_vec3 motion = {7.0f, 7.0f, 7.0f};
    bolan_renderer_read_surfaces(r->s.renderer, r->s.world, &r->view, &(bolan_surfaces){.motion = &motion});
    assert_true(motion.x == 7.0f);
    other = r->view;
    other.eye.z = -1.0;
    bolan_renderer_read_surfaces(r->s.renderer, r->s.world, &other, &(bolan_surfaces){.label = &label});
    assert_int_equal(label, before);
    close_reading(r);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_water_is_that_of_the_query),
        cmocka_unit_test(test_land_is_the_ground),
        cmocka_unit_test(test_objects_have_their_numbers),
        cmocka_unit_test(test_what_cannot_be_read_is_left_alone),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

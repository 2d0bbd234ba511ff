// SPDX-License-Identifier: MIT
// Many views of one step: split screen, halves of an image by off-centre frusta, faces of a cube, and what they upload.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "picture.h"

enum { WIDTH = 256, HEIGHT = 144, HALF = WIDTH / 2, BYTES = WIDTH * HEIGHT * 3 };

static void open(stage *s, const char *name, bolan_quality quality) {
    bolan_scene scene;
    assert_int_equal(bolan_scene_load(name, &scene), BOLAN_OK);
    scene.sea.resolution = 64;
    assert_true(stage_open(s, &scene, quality, false));
}

// Draws a view of the world, or its water alone over grey, into the bound rectangle of a target.
static void draw_into(stage *s, const bolan_target *target, const bolan_view *from, bool world) {
    bolan_view view = *from;
    view.framebuffer = bolan_target_framebuffer(target);
    if (world) {
        bolan_renderer_draw_world(s->renderer, s->world, &view);
    } else {
        const bolan_lighting lighting = bolan_lighting_from_scene(&s->scene);
        bolan_renderer_prepare(s->renderer, bolan_world_water(s->world), &lighting);
        bolan_renderer_draw_water(s->renderer, &view, NULL);
    }
    assert_true(watch_is_clean("after a view"));
}

static void draw(stage *s, const bolan_view *view, bool world, uint8_t *rgb) {
    bolan_target *target = NULL;
    assert_int_equal(bolan_target_create(view->width, view->height, &target), BOLAN_OK);
    draw_into(s, target, view, world);
    bolan_renderer_read_rgb8(s->renderer, bolan_target_framebuffer(target), view->width, view->height, rgb);
    bolan_target_destroy(&target);
}

// ---- split screen ---------------------------------------------------------------------------------------------------

static bolan_view player(int which) {
    bolan_view v = bolan_view_default();
    v.eye = which == 0 ? (bolan_dvec3){0.0, 0.0, 4.0} : (bolan_dvec3){3000.0, 800.0, 60.0};
    v.view = which == 0 ? bolan_m4_view(270.0, -3.0, 0.0) : bolan_m4_view(200.0, -20.0, 5.0);
    v.width = HALF;
    v.height = HEIGHT;
    v.projection = bolan_m4_projection(bolan_radians(50.0), (double)HALF / HEIGHT, 0.1, 0);
    return v;
}

// Two views in one framebuffer, the renderer's own cache or one each; then each alone, by a renderer of its own, into a
// framebuffer of its size.
static void check_split(bool world, bool caches) {
    static uint8_t both[BYTES], alone[BYTES];
    stage s;
    bolan_target *target = NULL;
    bolan_view_cache *cache[2] = {NULL};
    open(&s, "open-sea", BOLAN_QUALITY_MEDIUM);
    assert_int_equal(bolan_target_create(WIDTH, HEIGHT, &target), BOLAN_OK);
    for (int i = 0; i < 2; ++i) {
        bolan_view v = player(i);
        v.x = i == 0 ? 0 : HALF;
        if (caches) assert_int_equal(bolan_view_cache_create(s.renderer, &cache[i]), BOLAN_OK);
        v.cache = cache[i];
        draw_into(&s, target, &v, world);
    }
    bolan_renderer_read_rgb8(s.renderer, bolan_target_framebuffer(target), WIDTH, HEIGHT, both);
    for (int i = 0; i < 2; ++i) bolan_view_cache_destroy(&cache[i]);
    bolan_target_destroy(&target);
    stage_close(&s);
    for (int i = 0; i < 2; ++i) {
        const bolan_view v = player(i);
        open(&s, "open-sea", BOLAN_QUALITY_MEDIUM);
        draw(&s, &v, world, alone);
        stage_close(&s);
        for (int row = 0; row < HEIGHT; ++row)
            assert_memory_equal(alone + 3 * row * HALF, both + 3 * (row * WIDTH + i * HALF), 3 * HALF);
    }
}

static void split_screen_is_each_view_bit_for_bit(void **state) {
    (void)state;
    check_split(true, false);
    check_split(false, true);
}

// ---- off-centre halves ----------------------------------------------------------------------------------------------

// Half of a view's image by a frustum of its own: x' = 2 x + 1 on the left, 2 x - 1 on the right, in clip space.
static bolan_view half_of(const bolan_view *whole, int right) {
    bolan_view v = *whole;
    v.width = HALF;
    v.projection.m[0] *= 2.0f;
    v.projection.m[8] = 2.0f * v.projection.m[8] + (right ? 1.0f : -1.0f);
    return v;
}

static double mean_difference(const uint8_t *a, const uint8_t *b, int from, int to) {
    double sum = 0.0;
    for (int row = 0; row < HEIGHT; ++row)
        for (int i = 3 * (row * WIDTH + from); i < 3 * (row * WIDTH + to); ++i) sum += abs((int)a[i] - (int)b[i]);
    return sum / (3.0 * HEIGHT * (to - from));
}

static void check_halves(const char *scene, bool world, double psnr, double seam) {
    static uint8_t whole[BYTES], half[HALF * HEIGHT * 3], joined[BYTES];
    stage s;
    open(&s, scene, BOLAN_QUALITY_MEDIUM);
    const bolan_view view = bolan_view_from_camera(&s.scene.camera, WIDTH, HEIGHT);
    draw(&s, &view, world, whole);
    for (int i = 0; i < 2; ++i) {
        const bolan_view part = half_of(&view, i);
        draw(&s, &part, world, half);
        for (int row = 0; row < HEIGHT; ++row)
            memcpy(joined + 3 * (row * WIDTH + i * HALF), half + 3 * row * HALF, 3 * HALF);
    }
    const picture a = {WIDTH, HEIGHT, whole, NULL}, b = {WIDTH, HEIGHT, joined, NULL};
    const double got = picture_psnr(&a, &b), all = mean_difference(whole, joined, 0, WIDTH),
                 near = mean_difference(whole, joined, HALF - 4, HALF + 4);
    print_message("%s, %s: %.1f dB, mean difference %.2f levels, %.2f at the seam\n", scene, world ? "world" : "water",
                  got, all, near);
    if (getenv("BOLAN_KEEP") || got < psnr || near > seam) picture_report("halves", &a, &b, got, psnr);
    assert_true(got >= psnr);
    assert_true(near <= seam);
    stage_close(&s);
}

static void halves_by_off_centre_frusta_join(void **state) {
    (void)state;
    // The dither of the world's images, 0.2 levels, lies elsewhere in the halves; the water drawn alone has none.
    check_halves("open-sea", true, 55.0, 0.5); // the air is interpolated over 16 columns, and ends at the seam
    check_halves("open-sea", false, 60.0, 0.3);
    check_halves("island", true, 55.0, 0.5);
}

// ---- faces of a cube ------------------------------------------------------------------------------------------------

enum { SIDE = 96, FACES = 6 };

static const bolan_vec3 ahead[FACES] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
static uint8_t face_rgb[FACES][SIDE * SIDE * 3];

static bolan_vec3 up_of(int face) {
    return face < 4 ? bolan_v3(0.0f, 0.0f, 1.0f) : face == 4 ? bolan_v3(0.0f, -1.0f, 0.0f) : bolan_v3(0.0f, 1.0f, 0.0f);
}

static bolan_view face_view(int face, bolan_dvec3 eye) {
    const bolan_vec3 f = ahead[face], up = up_of(face), right = bolan_v3_cross(f, up);
    const float rows[3][3] = {{right.x, right.y, right.z}, {up.x, up.y, up.z}, {-f.x, -f.y, -f.z}};
    bolan_view v = bolan_view_default();
    v.view = bolan_m4_identity();
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c) v.view.m[4 * c + r] = rows[r][c];
    v.eye = eye;
    v.width = v.height = SIDE;
    v.projection = bolan_m4_projection(0.5 * BOLAN_PI, 1.0, 0.1, 0);
    return v;
}

// Brightness of the pixel of a face in which a direction lies.
static double at(int face, bolan_vec3 d) {
    const bolan_vec3 f = ahead[face], up = up_of(face), right = bolan_v3_cross(f, up);
    const double along = (double)bolan_v3_dot(d, f);
    const int i = (int)floor((0.5 + 0.5 * (double)bolan_v3_dot(d, right) / along) * SIDE);
    const int j = (int)floor((0.5 - 0.5 * (double)bolan_v3_dot(d, up) / along) * SIDE);
    assert_true(i >= 0 && i < SIDE && j >= 0 && j < SIDE);
    const uint8_t *c = &face_rgb[face][3 * (j * SIDE + i)];
    return (c[0] + c[1] + c[2]) / 3.0;
}

static bolan_vec3 sum3(bolan_vec3 a, bolan_vec3 b, double s, bolan_vec3 c, double t) {
    return bolan_v3((float)((double)a.x + s * (double)b.x + t * (double)c.x),
                    (float)((double)a.y + s * (double)b.y + t * (double)c.y),
                    (float)((double)a.z + s * (double)b.z + t * (double)c.z));
}

// Brightness at the line s between two pixels of a face, t along it, from the two pixels before (step -1) or after it.
static double beside(int face, bolan_vec3 across, bolan_vec3 along, double s, double t, double step) {
    const double pixel = 2.0 / SIDE * step;
    return 1.5 * at(face, sum3(ahead[face], across, s + 0.5 * pixel, along, t)) -
           0.5 * at(face, sum3(ahead[face], across, s + 1.5 * pixel, along, t));
}

// Each pixel's neighbour at the edge of its face is in another one. The mean step at the edge of two faces, and that at
// a line of pixels within each.
static void measure_edge(int a, int b, double *edge, double *within) {
    const bolan_vec3 along = bolan_v3_cross(ahead[a], ahead[b]);
    *edge = *within = 0.0;
    for (int k = 0; k < SIDE; ++k) {
        const double t = (2.0 * k + 1.0) / SIDE - 1.0, s = 1.0 - 8.0 / SIDE;
        *edge += fabs(beside(a, ahead[b], along, 1.0, t, -1.0) - beside(b, ahead[a], along, 1.0, t, -1.0)) / SIDE;
        *within += 0.5 * fabs(beside(a, ahead[b], along, s, t, -1.0) - beside(a, ahead[b], along, s, t, 1.0)) / SIDE;
        *within += 0.5 * fabs(beside(b, ahead[a], along, s, t, -1.0) - beside(b, ahead[a], along, s, t, 1.0)) / SIDE;
    }
}

static void faces_of_a_cube_join_at_their_edges(void **state) {
    (void)state;
    stage s;
    open(&s, "open-sea", BOLAN_QUALITY_HIGH); // at medium pixels at an edge share a sample of one side
    for (int face = 0; face < FACES; ++face) {
        const bolan_view v = face_view(face, (bolan_dvec3){40.0, 70.0, 30.0});
        draw(&s, &v, true, face_rgb[face]);
        char name[64];
        snprintf(name, sizeof name, "face_%d.png", face);
        if (getenv("BOLAN_KEEP")) bolan_png_write(name, SIDE, SIDE, face_rgb[face]);
    }
    stage_close(&s);
    double all = 0.0, inside = 0.0;
    for (int a = 0; a < FACES; ++a)
        for (int b = a + 1; b < FACES; ++b) {
            double edge, within;
            if (a / 2 == b / 2) continue; // opposite
            measure_edge(a, b, &edge, &within);
            if (edge > 1.5 * within + 2.0)
                fail_msg("faces %d and %d: a step of %.2f levels, %.2f within them", a, b, edge, within);
            all += edge;
            inside += within;
        }
    print_message("faces: a mean step of %.2f levels at an edge, %.2f beside it\n", all / 12.0, inside / 12.0);
    assert_true(all < inside); // where faces join, the step at an edge is one between neighbours like any other
}

// ---- uploads --------------------------------------------------------------------------------------------------------

typedef struct waters {
    bolan_sea *sea[BOLAN_KEPT_SEAS + 1];
    bolan_renderer *renderer;
    bolan_lighting lighting;
    bolan_target *target;
} waters;

static void open_waters(waters *w) {
    watch_begin();
    *w = (waters){.lighting = bolan_lighting_default()};
    for (int i = 0; i <= BOLAN_KEPT_SEAS; ++i) {
        bolan_sea_desc desc = bolan_sea_desc_default();
        desc.sea_state = bolan_sea_state_from_wind(5.0 + 2.0 * i, 270.0, 100e3);
        desc.resolution = 64;
        desc.fft.cascade_count = 2;
        desc.seed = (uint64_t)i + 1;
        assert_int_equal(bolan_sea_create(&desc, &w->sea[i]), BOLAN_OK);
        bolan_sea_step(w->sea[i], 3.0);
    }
    const bolan_renderer_desc desc = bolan_renderer_desc_default();
    assert_int_equal(bolan_renderer_create(&desc, &w->renderer), BOLAN_OK);
    assert_int_equal(bolan_target_create(HALF, HEIGHT, &w->target), BOLAN_OK);
}

static void close_waters(waters *w) {
    bolan_target_destroy(&w->target);
    bolan_renderer_destroy(&w->renderer);
    for (int i = 0; i <= BOLAN_KEPT_SEAS; ++i) bolan_sea_destroy(&w->sea[i]);
    assert_true(watch_is_clean("at the end"));
}

static void prepare(waters *w, int i) {
    bolan_water water = bolan_water_default();
    water.sea = w->sea[i];
    bolan_renderer_prepare(w->renderer, &water, &w->lighting);
}

static void draw_water(waters *w, const bolan_view *from, uint8_t *rgb) {
    bolan_view view = *from;
    view.framebuffer = bolan_target_framebuffer(w->target);
    bolan_renderer_draw_water(w->renderer, &view, NULL);
    bolan_renderer_read_rgb8(w->renderer, view.framebuffer, HALF, HEIGHT, rgb);
}

// Bytes since the last call.
static uint64_t uploaded(const waters *w, uint64_t *before) {
    const uint64_t now = bolan_renderer_statistics(w->renderer).upload_bytes, bytes = now - *before;
    *before = now;
    return bytes;
}

// Half floats: displacement and slopes of 4 with their smaller levels, which software OpenGL gets too, pinch and foam;
// and slopes of the fine waves.
static uint64_t bytes_of_fields(uint64_t n, uint64_t cascades) {
    uint64_t texels = 0;
    for (uint64_t side = n; side > 0; side /= 2) texels += bolan_gl_get_info().software || side == n ? side * side : 0;
    return cascades * (2 * 8 * texels + 4 * n * n) + 8 * texels;
}

static void an_unchanged_step_uploads_nothing(void **state) {
    (void)state;
    static uint8_t rgb[BYTES];
    waters w;
    uint64_t mark = 0;
    bolan_view view = player(0);
    open_waters(&w);
    prepare(&w, 0);
    draw_water(&w, &view, rgb);
    assert_true(uploaded(&w, &mark) > bytes_of_fields(64, 2));
    prepare(&w, 0);
    assert_int_equal(uploaded(&w, &mark), 0); // the same step again
    view = player(1);
    draw_water(&w, &view, rgb);
    assert_int_equal(uploaded(&w, &mark), 0); // another view of it
    const uint32_t count = bolan_renderer_statistics(w.renderer).uploads;
    bolan_sea_step(w.sea[0], 3.0);
    prepare(&w, 0);
    assert_int_equal(uploaded(&w, &mark), 0); // a step that leads nowhere
    assert_int_equal(bolan_renderer_statistics(w.renderer).uploads, count);
    bolan_sea_step(w.sea[0], 3.1);
    prepare(&w, 0);
    assert_int_equal(uploaded(&w, &mark), bytes_of_fields(64, 2));
    assert_true(bolan_renderer_statistics(w.renderer).uploads > count);
    close_waters(&w);
}

static void waters_that_take_turns_upload_nothing(void **state) {
    (void)state;
    static uint8_t first[BYTES], again[BYTES];
    const bolan_view view = player(0);
    waters w;
    uint64_t mark = 0;
    open_waters(&w);
    prepare(&w, 0);
    draw_water(&w, &view, first);
    for (int i = 1; i < BOLAN_KEPT_SEAS; ++i) prepare(&w, i);
    uploaded(&w, &mark);
    for (int round = 0; round < 2; ++round)
        for (int i = 0; i < BOLAN_KEPT_SEAS; ++i) prepare(&w, i);
    assert_int_equal(uploaded(&w, &mark), 0);
    bolan_sea_step(w.sea[2], 3.1); // one of them moves on
    for (int i = 0; i < BOLAN_KEPT_SEAS; ++i) prepare(&w, i);
    assert_int_equal(uploaded(&w, &mark), bytes_of_fields(64, 2));
    prepare(&w, 0);
    draw_water(&w, &view, again);
    assert_memory_equal(again, first, 3 * HALF * HEIGHT); // and each is itself
    uploaded(&w, &mark);
    prepare(&w, BOLAN_KEPT_SEAS); // one too many: the sea that waited longest makes room
    assert_true(uploaded(&w, &mark) > 0);
    prepare(&w, 0);
    prepare(&w, 2);
    assert_int_equal(uploaded(&w, &mark), 0);
    prepare(&w, 1);
    assert_true(uploaded(&w, &mark) > 0);
    close_waters(&w);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(split_screen_is_each_view_bit_for_bit), cmocka_unit_test(halves_by_off_centre_frusta_join),
        cmocka_unit_test(faces_of_a_cube_join_at_their_edges), cmocka_unit_test(an_unchanged_step_uploads_nothing),
        cmocka_unit_test(waters_that_take_turns_upload_nothing)};
    bolan_context *context = NULL;
    if (bolan_context_create(BOLAN_GL_CORE, &context) != BOLAN_OK) return 77;
    const int failed = cmocka_run_group_tests_name("views", tests, NULL, NULL);
    bolan_context_destroy(&context);
    return failed;
}

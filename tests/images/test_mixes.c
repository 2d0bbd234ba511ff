// SPDX-License-Identifier: MIT
// Techniques: every mix of waves, surface and optics draws water; core and ES agree; frames after the first allocate
// nothing; and the counts of triangles that the papers give.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <unistd.h>

#include <cmocka.h>

#include "picture.h"
#include "render/gl/gl.h"

#define WIDTH 96
#define HEIGHT 64

static int errors; // sentences of the library that are not mere information

static void count_errors(void *user, bolan_log_level level, bolan_log_id id, const char *sentence) {
    (void)user, (void)id;
    if (level == BOLAN_LOG_INFO) return;
    errors++;
    fprintf(stderr, "%s\n", sentence);
}

static bolan_scene load(const char *name) {
    bolan_scene scene;
    assert_int_equal(bolan_scene_load(name, &scene), BOLAN_OK);
    scene.sky.cloud_cover = 0.0; // they are not what is tested, and take long to make
    return scene;
}

// A stage for scenes that follow.
static void open_empty(stage *s) {
    const bolan_scene scene = load("pond");
    assert_true(stage_open(s, &scene, BOLAN_QUALITY_LOW, false));
}

// Mean radiance of the lower third of the picture. Everything in the picture is a finite, non-negative radiance, and
// below the horizon nothing is missing.
static double look_at(stage *s, const char *what) {
    float *rgb = malloc(sizeof(float) * WIDTH * HEIGHT * 3);
    picture p = stage_draw(s, WIDTH, HEIGHT, 1);
    bolan_renderer_read_linear(s->renderer, rgb, NULL);
    double sum = 0.0;
    for (int i = 0; i < WIDTH * HEIGHT * 3; i++) {
        if (!(rgb[i] >= 0.0f && rgb[i] < 1e4f)) fail_msg("%s: a radiance of %g", what, (double)rgb[i]);
        if (i >= WIDTH * HEIGHT * 2) sum += (double)rgb[i];
    }
    for (int i = WIDTH * (HEIGHT - 8); i < WIDTH * HEIGHT; i++)
        if (!isfinite(p.distance[i])) fail_msg("%s: a hole at pixel %d", what, i);
    free(rgb);
    picture_free(&p);
    return sum / (WIDTH * HEIGHT);
}

// The physical optics over the projected FFT is the yardstick: water is neither black nor burnt out by any other way. A
// factor of 4 either way: the glitter of a few pixels may be in one picture and not in the other.
static void every_mix_draws_water(void **state) {
    (void)state;
    static const char *const scenes[] = {"pond", "open-sea"};
    bolan_set_hooks(&(bolan_hooks){.log = count_errors});
    bolan_context *context = NULL;
    stage s;
    if (bolan_context_create(BOLAN_GL_CORE, &context) != BOLAN_OK) skip_without_gl();
    open_empty(&s);
    for (int c = 0; c < (test_is_short() ? 1 : 2); c++) {
        double expected = 0.0;
        for (int w = 0; w < BOLAN_WAVE_MODELS; w++) {
            bolan_scene scene = load(scenes[c]);
            bolan_technique mix = bolan_technique_ocean;
            mix.waves = (bolan_wave_model)w;
            scene.sea.resolution = 128;
            bolan_scene_set_technique(&scene, &mix);
            stage_settle_scene(&s, &scene);
            const int step = test_is_short() ? 2 : 1; // which still meets each surface and each optics
            for (int m = 0; m < BOLAN_SURFACE_KINDS * BOLAN_OPTICS_KINDS; m += step) {
                char what[128];
                s.scene.technique.surface = (bolan_surface_kind)(m % BOLAN_SURFACE_KINDS);
                s.scene.technique.optics = (bolan_optics_kind)(m / BOLAN_SURFACE_KINDS);
                snprintf(what, sizeof what, "%s: %s x %s x %s", scenes[c], bolan_wave_model_names[w],
                         bolan_surface_kind_names[s.scene.technique.surface],
                         bolan_optics_kind_names[s.scene.technique.optics]);
                errors = 0;
                double mean = look_at(&s, what);
                if (w == 0 && m == 0) expected = mean;
                if (errors) fail_msg("%s: %d errors", what, errors);
                if (!(mean > 0.25 * expected && mean < 4.0 * expected))
                    fail_msg("%s: mean radiance %g, expected about %g", what, mean, expected);
            }
        }
    }
    stage_close(&s);
    bolan_context_destroy(&context);
    bolan_set_hooks(NULL);
}

static void paper_modes_draw_water(void **state) {
    (void)state;
    bolan_context *context = NULL;
    stage s;
    if (bolan_context_create(BOLAN_GL_CORE, &context) != BOLAN_OK) skip_without_gl();
    bolan_set_hooks(&(bolan_hooks){.log = count_errors});
    open_empty(&s);
    uint32_t count = 0;
    const bolan_technique *all = bolan_techniques(&count);
    for (uint32_t i = 0; i < count; i++) {
        bolan_scene scene = load("pond");
        bolan_scene_set_technique(&scene, &all[i]);
        scene.look.paper = true;
        scene.sea = bolan_scene_sea_desc(&scene);
        scene.sea.resolution = 128;
        errors = 0;
        stage_settle_scene(&s, &scene);
        look_at(&s, all[i].name);
        s.scene.look.effects = 0;
        look_at(&s, all[i].name);
        for (int show = 0; show < BOLAN_SHOWS; show++) {
            s.scene.look.show = (bolan_show)show;
            look_at(&s, all[i].name);
        }
        assert_int_equal(errors, 0);
    }
    stage_close(&s);
    bolan_set_hooks(NULL);
    bolan_context_destroy(&context);
}

enum { MOST_TECHNIQUES = 8 };

// A picture by each technique.
static void draw_all(bolan_gl_api api, const bolan_technique *all, uint32_t count, picture *out) {
    bolan_context *context = NULL;
    stage s;
    if (bolan_context_create(api, &context) != BOLAN_OK) skip_without_gl();
    open_empty(&s);
    for (uint32_t i = 0; i < count; i++) {
        bolan_scene scene = load("pond");
        scene.sea.resolution = 128;
        bolan_scene_set_technique(&scene, &all[i]);
        stage_settle_scene(&s, &scene);
        out[i] = stage_draw(&s, WIDTH, HEIGHT, 1);
    }
    stage_close(&s);
    bolan_context_destroy(&context);
}

static void core_and_es_draw_the_same(void **state) {
    (void)state;
    uint32_t count = 0;
    const bolan_technique *all = bolan_techniques(&count);
    picture core[MOST_TECHNIQUES], es[MOST_TECHNIQUES];
    assert_in_range(count, 1, MOST_TECHNIQUES);
    bolan_set_hooks(&(bolan_hooks){.log = count_errors});
    errors = 0;
    draw_all(BOLAN_GL_CORE, all, count, core);
    draw_all(BOLAN_GL_ES, all, count, es);
    for (uint32_t i = 0; i < count; i++) {
        const double psnr = picture_psnr(&core[i], &es[i]);
        if (psnr < 40.0) picture_report(all[i].name, &core[i], &es[i], psnr, 40.0);
        assert_true(psnr >= 40.0); // the same driver and code: only the precision of constants may differ
        picture_free(&core[i]);
        picture_free(&es[i]);
    }
    assert_int_equal(errors, 0);
    bolan_set_hooks(NULL);
}

// Ma, Zhu & Gong 2006, table 2: 13 912 triangles, and two more for the water.
static void the_pond_with_its_water_has_two_triangles_more(void **state) {
    (void)state;
    bolan_context *context = NULL;
    if (bolan_context_create(BOLAN_GL_CORE, &context) != BOLAN_OK) skip_without_gl();
    bolan_scene scene = load("pond");
    stage s;
    assert_true(stage_open(&s, &scene, BOLAN_QUALITY_LOW, false));
    picture p = stage_draw(&s, WIDTH, HEIGHT, 1);
    const bolan_frame_statistics with = bolan_renderer_statistics(s.renderer);
    assert_int_equal(with.water_triangles, 2);
    assert_int_equal(with.triangles, 13914);
    picture_free(&p);
    stage_close(&s);
    bolan_context_destroy(&context);
}

static uint32_t triangles_within(const bolan_technique *technique, uint32_t max_vertices) {
    bolan_scene scene = load("pond");
    bolan_scene_set_technique(&scene, technique);
    stage s = {.world = NULL};
    stage_settle_scene(&s, &scene);
    bolan_renderer_desc desc = bolan_renderer_desc_default();
    desc.quality = BOLAN_QUALITY_ULTRA; // only ULTRA exceeds the bound at this size
    desc.max_vertices = max_vertices;
    assert_int_equal(bolan_renderer_create(&desc, &s.renderer), BOLAN_OK);
    look_at(&s, technique->name);
    const uint32_t triangles = bolan_renderer_statistics(s.renderer).water_triangles;
    stage_close(&s);
    return triangles;
}

// On the grid that is made for each view, and on the one that never changes.
static void the_mesh_keeps_to_the_most_vertices_that_it_may_have(void **state) {
    (void)state;
    static const bolan_technique each_view = {"each view", BOLAN_WAVES_EXP_COSINE, BOLAN_SURFACE_PROJECTED,
                                              BOLAN_OPTICS_LIT, -1},
                                 fixed = {"fixed", BOLAN_WAVES_EXP_COSINE, BOLAN_SURFACE_PROJECTED, BOLAN_OPTICS_CREST,
                                          -1};
    const bolan_technique *const list[] = {&each_view, &fixed};
    bolan_context *context = NULL;
    if (bolan_context_create(BOLAN_GL_CORE, &context) != BOLAN_OK) skip_without_gl();
    for (int i = 0; i < 2; i++) {
        const uint32_t quality = triangles_within(list[i], 0), least = triangles_within(list[i], 1024);
        assert_in_range(least, 2 * 500, 2 * 1024); // the mesh is of whole blocks of 16 x 16
        assert_true(quality > 2 * 1024);
        assert_int_equal(triangles_within(list[i], 1000000), quality); // a bound: it makes nothing finer
    }
    bolan_context_destroy(&context);
}

static int out_of_range;

static void count_out_of_range(void *user, bolan_log_level level, bolan_log_id id, const char *sentence) {
    (void)user;
    out_of_range += level == BOLAN_LOG_ERROR && id == BOLAN_LOG_OUT_OF_RANGE && strstr(sentence, "max_vertices");
}

static void a_bound_of_the_mesh_out_of_range_is_refused(void **state) {
    (void)state;
    static const uint32_t wrong[] = {1, 1023, 1000001, UINT32_MAX};
    bolan_context *context = NULL;
    if (bolan_context_create(BOLAN_GL_CORE, &context) != BOLAN_OK) skip_without_gl();
    bolan_set_hooks(&(bolan_hooks){.log = count_out_of_range});
    for (int i = 0; i < 4; i++) {
        bolan_renderer_desc desc = bolan_renderer_desc_default();
        bolan_renderer *renderer = NULL;
        desc.max_vertices = wrong[i];
        assert_int_equal(bolan_renderer_create(&desc, &renderer), BOLAN_ERROR_ARGUMENT);
        assert_null(renderer);
        assert_int_equal(out_of_range, i + 1);
    }
    bolan_set_hooks(NULL);
    bolan_context_destroy(&context);
}

// From 10 km the round earth's horizon lies acos(R / (R + h)) = 3.209 degrees below the level (R = 6371 km), and so
// must that of the plane that two triangles are.
static void two_triangles_end_at_the_horizon(void **state) {
    (void)state;
    static const bolan_technique *const flat[] = {&bolan_technique_two_triangle, &bolan_technique_exp_cosine};
    bolan_context *context = NULL;
    if (bolan_context_create(BOLAN_GL_CORE, &context) != BOLAN_OK) skip_without_gl();
    stage s;
    open_empty(&s);
    for (int i = 0; i < 2; i++) {
        bolan_scene scene = load("open-sea");
        scene.sea.resolution = 128;
        scene.camera =
            (bolan_camera){.position = {0.0, 0.0, 10000.0}, .heading_deg = 40.0, .pitch_deg = -6.0, .fov_deg = 12.0};
        bolan_scene_set_technique(&scene, flat[i]);
        stage_settle_scene(&s, &scene);
        picture p = stage_draw(&s, 240, 180, 1);
        int sky = 0; // rows above the water in the middle of the picture
        while (sky < 180 && !isfinite(p.distance[sky * 240 + 120])) sky++;
        const double degree = acos(-1.0) / 180.0;
        const double row = 90.0 * (1.0 - tan((6.0 - 3.209) * degree) / tan(6.0 * degree));
        if (fabs(sky - row) > 1.0) fail_msg("%s: the horizon is in row %d instead of %.1f", flat[i]->name, sky, row);
        picture_free(&p);
    }
    stage_close(&s);
    bolan_context_destroy(&context);
}

static int allocations;

static void *counted(void *user, size_t size, size_t align) {
    (void)user;
    ++allocations;
    return aligned_alloc(align, (size + align - 1) / align * align);
}

static void uncounted(void *user, void *memory, size_t size) {
    (void)user;
    (void)size;
    free(memory);
}

static void check_allocations(stage *s, const char *name, const bolan_technique *technique) {
    bolan_scene scene = load(name);
    scene.sea.resolution = 128;
    bolan_scene_set_technique(&scene, technique);
    stage_settle_scene(s, &scene);
    bolan_target *target = NULL;
    assert_int_equal(bolan_target_create(WIDTH, HEIGHT, &target), BOLAN_OK);
    for (int k = 0; k < 5; ++k) {
        if (k == 2) allocations = 0;
        s->scene.camera.position.x += 0.3;
        stage_update(s);
        stage_step(s, scene.time + 0.1 * k);
        const bolan_view view = stage_view(s, target, WIDTH, HEIGHT);
        bolan_renderer_draw_world(s->renderer, s->world, &view);
    }
    assert_int_equal(errors, 0);
    if (allocations) fail_msg("%s: %d allocations", technique->name, allocations);
    bolan_target_destroy(&target);
}

static void later_frames_allocate_nothing(void **state) {
    (void)state;
    bolan_set_hooks(&(bolan_hooks){.allocate = counted, .release = uncounted, .log = count_errors});
    errors = 0;
    bolan_context *context = NULL;
    if (bolan_context_create(BOLAN_GL_CORE, &context) != BOLAN_OK) skip_without_gl();
    uint32_t count = 0;
    const bolan_technique *all = bolan_techniques(&count);
    stage s;
    open_empty(&s);
    for (uint32_t i = 0; i < count; i++) check_allocations(&s, "pond", &all[i]);
    bolan_technique nested = bolan_technique_ocean;
    nested.name = "ocean on nested levels", nested.surface = BOLAN_SURFACE_NESTED;
    check_allocations(&s, "open-sea", &nested);
    stage_close(&s);
    stage_pixels = bolan_gl_get_caps().compute ? BOLAN_PIXELS_COMPUTE : BOLAN_PIXELS_FRAGMENT;
    open_empty(&s);
    check_allocations(&s, "island", &nested); // tiles of each class
    stage_close(&s);
    stage_pixels = BOLAN_PIXELS_AUTO;
    bolan_context_destroy(&context);
    bolan_set_hooks(NULL);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_mix_draws_water),
        cmocka_unit_test(paper_modes_draw_water),
        cmocka_unit_test(core_and_es_draw_the_same),
        cmocka_unit_test(the_pond_with_its_water_has_two_triangles_more),
        cmocka_unit_test(the_mesh_keeps_to_the_most_vertices_that_it_may_have),
        cmocka_unit_test(a_bound_of_the_mesh_out_of_range_is_refused),
        cmocka_unit_test(two_triangles_end_at_the_horizon),
        cmocka_unit_test(later_frames_allocate_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

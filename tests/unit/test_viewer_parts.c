// SPDX-License-Identifier: MIT
// The parts of the viewer that are pure functions: camera, knobs of the sea, pace, steps of a still image.
#include "../../apps/viewer/fly.c"
#include "../../apps/viewer/pace.c"
#include "../../apps/viewer/refine.c"
#include "../../apps/viewer/sea_knobs.c"
#include "support.h"

static bolan_sea_desc desc_of(bolan_sea_state state) {
    bolan_sea_desc desc = bolan_sea_desc_default();
    desc.sea_state = state;
    return desc;
}

// A float in a slider holds seven digits.
#define SLIDER_ERROR 1e-5

static void writing_back_what_was_read_keeps_the_sea(void **state) {
    (void)state;
    const double winds[] = {3.0, 8.0, 14.0, 25.0}, fetches[] = {5e3, 60e3, 500e3};
    for (size_t i = 0; i < 4; ++i)
        for (size_t j = 0; j < 3; ++j) {
            bolan_sea_desc desc = desc_of(bolan_sea_state_from_wind(winds[i], 300.0, fetches[j]));
            assert_int_equal(bolan_sea_state_add_swell(&desc.sea_state, 1.5, 12.0, 210.0, 40.0), BOLAN_OK);
            bolan_sea_desc again = desc;
            sea_knobs knobs = sea_knobs_read(&desc, false);
            sea_knobs_write(&knobs, SEA_KNOBS_WIND | SEA_KNOBS_SWELL | SEA_KNOBS_LAYOUT, &again);
            bolan_sea_summary a = bolan_sea_state_summary(&desc.sea_state),
                              b = bolan_sea_state_summary(&again.sea_state);
            assert_near(b.hs, a.hs, SLIDER_ERROR * a.hs);
            assert_near(b.tm02, a.tm02, SLIDER_ERROR * a.tm02);
            assert_near(b.from_deg, a.from_deg, SLIDER_ERROR * 360.0);
            assert_int_equal(again.seed, desc.seed);
            assert_int_equal(again.resolution, desc.resolution);
        }
}

static void a_new_wind_keeps_the_swell_and_a_new_swell_the_wind_sea(void **state) {
    (void)state;
    bolan_sea_desc desc = desc_of(bolan_sea_state_from_wind(8.0, 240.0, 100e3));
    assert_int_equal(bolan_sea_state_add_swell(&desc.sea_state, 2.0, 14.0, 300.0, 50.0), BOLAN_OK);
    sea_knobs knobs = sea_knobs_read(&desc, false);
    knobs.wind_speed = 16.0f;
    sea_knobs_write(&knobs, SEA_KNOBS_WIND, &desc);
    sea_knobs after = sea_knobs_read(&desc, false);
    assert_true(after.swell);
    assert_near(after.swell_height, 2.0, SLIDER_ERROR);
    knobs.swell = false;
    sea_knobs_write(&knobs, SEA_KNOBS_SWELL, &desc);
    assert_int_equal(desc.sea_state.system_count, 1);
    assert_near(desc.sea_state.systems[0].wind_speed, 16.0, SLIDER_ERROR);
}

static void the_wind_of_a_measured_sea_makes_no_waves(void **state) {
    (void)state;
    bolan_sea_desc desc = desc_of(bolan_sea_state_default());
    sea_knobs knobs = sea_knobs_read(&desc, true);
    knobs.wind_speed = 12.0f;
    sea_knobs_write(&knobs, SEA_KNOBS_WIND, &desc);
    assert_int_equal(desc.sea_state.system_count, 0);
    assert_near(desc.sea_state.wind_speed, 12.0, 0.0);
}

static void forward_is_where_the_camera_looks(void **state) {
    (void)state;
    bolan_camera camera = {.heading_deg = 90.0, .pitch_deg = 0.0, .position = {0.0, 0.0, 100.0}};
    fly_step(&camera, &(fly_input){.forward = 1.0, .faster = 1.0}, 10.0, 0.0, 2.0);
    assert_near(camera.position.x, 20.0, 1e-9); // east
    assert_near(camera.position.y, 0.0, 1e-9);
    fly_step(&camera, &(fly_input){.right = 1.0, .faster = 1.0}, 10.0, 0.0, 2.0);
    assert_near(camera.position.y, -20.0, 1e-9); // south is to the right of east
    fly_step(&camera, &(fly_input){.tilt = 30.0, .forward = 1.0, .faster = 1.0}, 10.0, 0.0, 1.0);
    assert_near(camera.position.z, 105.0, 1e-9); // sin 30
}

static void the_camera_stays_between_floor_and_ceiling(void **state) {
    (void)state;
    bolan_camera camera = {.position = {0.0, 0.0, 3.0}};
    fly_step(&camera, &(fly_input){.up = -1.0, .faster = 1.0}, 100.0, 1.5, 1.0);
    assert_near(camera.position.z, 1.5, 0.0);
    fly_step(&camera, &(fly_input){.up = 1.0, .faster = 1e6, .tilt = 400.0}, 100.0, 1.5, 1.0);
    assert_near(camera.position.z, CEILING, 0.0);
    assert_true(camera.pitch_deg < 90.0);
}

// A machine that needs 140 ms for a full picture, 10 of them whatever its size.
static double cost(double scale) { return 10.0 + 130.0 * scale * scale; }

static void the_pace_settles_without_fluttering(void **state) {
    (void)state;
    pace p;
    pace_start(&p, true);
    for (int i = 0; i < 200; ++i) pace_frame(&p, cost(p.scale), true);
    double settled = p.scale;
    assert_true(cost(settled) <= SLOW_MS);
    assert_true(settled > 0.5); // and no coarser than it must be
    for (int i = 0; i < 500; ++i) {
        pace_frame(&p, cost(p.scale), true);
        assert_near(p.scale, settled, 0.0);
    }
}

static void the_pace_is_left_alone_unless_automatic(void **state) {
    (void)state;
    pace p;
    pace_start(&p, false);
    for (int i = 0; i < 100; ++i) pace_frame(&p, 500.0, false);
    assert_near(p.scale, 1.0, 0.0);
}

static void the_pace_has_other_limits(void **state) {
    (void)state;
    pace viewer, page;
    pace_start(&viewer, false);
    pace_start(&page, false);
    pace_limit(&page, 42.0, 32.0);
    for (int i = 0; i < 20; ++i) {
        pace_frame(&viewer, 50.0, true);
        pace_frame(&page, 50.0 * page.scale * page.scale, true);
    }
    assert_true(viewer.scale == 1.0); // 50 ms do for the viewer
    assert_true(page.scale == 0.75);  // and a page goes one step down, to 28 ms
}

// ---- a still image

#define TICK 0.05

static refine_view still_view(void) {
    static refine_view view; // without random padding
    view.scene = bolan_scene_default();
    view.width = 640;
    view.height = 360;
    return view;
}

// A renderer that has all of the ground after so many frames of the full size. The samples restart as the views ask.
static refine_step draw_still(refine *r, const refine_view *view, uint32_t *uploads, uint32_t last_upload) {
    const refine_step step = refine_next(r, view, TICK);
    if (step == REFINE_SIZE && *uploads < last_upload) ++*uploads;
    const bolan_frame_statistics drawn = {.uploads = *uploads, .samples = step == REFINE_ADD ? r->samples + 1 : 1};
    refine_drawn(r, &drawn);
    return step;
}

static void a_still_image_gets_its_size_then_its_samples(void **state) {
    (void)state;
    const refine_view view = still_view();
    refine r = {.most = 16};
    uint32_t uploads = 0;
    char said[32];
    for (int i = 0; i < 6; i++) { // the first shows something new, five wait 0.25 s
        assert_int_equal(draw_still(&r, &view, &uploads, 3), REFINE_MOVING);
        refine_say(&r, said, sizeof said);
        assert_string_equal(said, "");
    }
    for (int i = 0; i < 4; i++) { // three bring ground, one more shows that all is there
        assert_int_equal(draw_still(&r, &view, &uploads, 3), REFINE_SIZE);
        refine_say(&r, said, sizeof said);
        assert_string_equal(said, "refined: full size");
    }
    for (uint32_t i = 1; i <= 16; i++) {
        assert_int_equal(draw_still(&r, &view, &uploads, 3), REFINE_ADD);
        assert_int_equal(r.samples, i);
    }
    assert_int_equal(draw_still(&r, &view, &uploads, 3), REFINE_DONE);
    refine_say(&r, said, sizeof said);
    assert_string_equal(said, "refined: 16 samples");
}

// One frame after the change, from each step that it can happen in.
static void check_drops_back(void (*alter)(refine_view *)) {
    static const int frames[] = {8, 12, 40};
    for (int i = 0; i < 3; i++) {
        refine_view view = still_view();
        refine r = {.most = 16};
        uint32_t uploads = 0;
        for (int k = 0; k < frames[i]; k++) draw_still(&r, &view, &uploads, 3);
        assert_int_equal(r.step, i == 0 ? REFINE_SIZE : i == 1 ? REFINE_ADD : REFINE_DONE);
        alter(&view);
        assert_int_equal(draw_still(&r, &view, &uploads, 3), REFINE_MOVING);
        assert_int_equal(r.samples, 0);
        for (int k = 0; k < 5; k++) assert_int_equal(draw_still(&r, &view, &uploads, 3), REFINE_MOVING);
        assert_int_equal(draw_still(&r, &view, &uploads, 3), REFINE_SIZE);
    }
}

static void turn_a_little(refine_view *v) { v->scene.camera.heading_deg += 1e-6; }
static void let_time_pass(refine_view *v) { v->time += 1e-3; }
static void resize(refine_view *v) { v->height += 1; }
static void widen(refine_view *v) { v->width += 1; }
static void choose_a_size(refine_view *v) { v->scale = 0.5; }
static void choose_a_quality(refine_view *v) { v->quality = BOLAN_QUALITY_ULTRA; }

static void any_change_drops_back_at_once(void **state) {
    (void)state;
    check_drops_back(turn_a_little);
    check_drops_back(let_time_pass);
    check_drops_back(resize);
    check_drops_back(widen);
    check_drops_back(choose_a_size);
    check_drops_back(choose_a_quality);
    refine_view view = still_view();
    refine r = {.most = 16};
    uint32_t uploads = 0;
    for (int k = 0; k < 40; k++) draw_still(&r, &view, &uploads, 3);
    refine_restart(&r);
    assert_int_equal(draw_still(&r, &view, &uploads, 3), REFINE_MOVING);
}

RUN_TESTS(cmocka_unit_test(writing_back_what_was_read_keeps_the_sea),
          cmocka_unit_test(a_new_wind_keeps_the_swell_and_a_new_swell_the_wind_sea),
          cmocka_unit_test(the_wind_of_a_measured_sea_makes_no_waves),
          cmocka_unit_test(forward_is_where_the_camera_looks),
          cmocka_unit_test(the_camera_stays_between_floor_and_ceiling),
          cmocka_unit_test(the_pace_settles_without_fluttering),
          cmocka_unit_test(the_pace_is_left_alone_unless_automatic), cmocka_unit_test(the_pace_has_other_limits),
          cmocka_unit_test(a_still_image_gets_its_size_then_its_samples),
          cmocka_unit_test(any_change_drops_back_at_once))

// SPDX-License-Identifier: MIT
// What a renderer does with the host's state: `full` is test_guest.c; here `declared` puts back what was declared,
// `none` draws the same image whatever the host has set, and neither asks OpenGL for anything. The calls of OpenGL are
// counted: at most 60 for the water of a view, whatever makes its surface; 20 more where its tiles are sorted and each
// class is shaded.
#include "guest_host.h"

#include <epoxy/gl.h>

enum { MOST_WATER_CALLS = 60, MOST_TILE_CALLS = 20, WARM_UP = 3, FRAMES = 40 };

static bolan_renderer_desc desc_of(bolan_restore restore) {
    bolan_renderer_desc desc = low_quality();
    desc.restore = restore;
    return desc;
}

static void step_and_draw(rig *r, int frame) {
    bolan_world_step(r->world, 3.0 + frame / 30.0);
    draw_rig(r);
}

static uint32_t calls_of(const bolan_frame_statistics *s, const char *pass) {
    for (uint32_t i = 0; i < s->pass_count; ++i)
        if (strcmp(s->passes[i].name, pass) == 0) return s->passes[i].gl_calls;
    fail_msg("there is no pass %s", pass);
    return 0;
}

// ---- none -----------------------------------------------------------------------------------------------------------

static void none_draws_the_same_image_whatever_the_host_has_set(void **state) {
    (void)state;
    static shot calm, wild;
    const bolan_renderer_desc desc = desc_of(BOLAN_RESTORE_NONE);
    host h;
    rig r;
    open_rig(&r, &desc);
    take_shot(&r, &calm);
    open_host(&h);
    set_apart(&h);
    take_shot(&r, &wild);
    assert_memory_equal(&wild, &calm, sizeof wild);
    assert_true(watch_is_clean("none"));
    close_rig(&r);
    close_host(&h);
}

// ---- declared -------------------------------------------------------------------------------------------------------

// A host that has set what it can declare.
static bolan_gl_state set_declared(const host *h) {
    bolan_gl_state d = bolan_gl_state_default();
    d.draw_framebuffer = h->framebuffer, d.read_framebuffer = h->framebuffer;
    d.program = h->program, d.vertex_array = h->vertex_array;
    d.array_buffer = h->buffers[0], d.uniform_buffer = h->buffers[3];
    d.active_unit = 5, d.samplers = true;
    d.scissor_test = d.depth_test = d.blend = d.cull_face = d.stencil_test = true;
    d.depth_mask = d.dither = false;
    d.depth_function = GL_NEVER, d.depth_clear = 0.25f;
    d.cull_mode = GL_FRONT_AND_BACK, d.front_face = GL_CW;
    d.framebuffer_srgb = d.clip_upper_left = d.clip_zero_to_one = !is_es();
    const int32_t viewport[4] = {1, 2, 3, 4}, box[4] = {5, 6, 7, 8};
    const uint32_t blend[4] = {GL_DST_COLOR, GL_ZERO, GL_ONE, GL_SRC_ALPHA};
    const float clear[4] = {0.125f, 0.25f, 0.375f, 0.5f};
    memcpy(d.viewport, viewport, sizeof viewport), memcpy(d.scissor_box, box, sizeof box);
    memcpy(d.blend_function, blend, sizeof blend), memcpy(d.color_clear, clear, sizeof clear);
    d.color_mask[1] = false;
    bind_everything(h);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0), glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    glBindFramebuffer(GL_FRAMEBUFFER, h->framebuffer);
    glEnable(GL_SCISSOR_TEST), glEnable(GL_DEPTH_TEST), glEnable(GL_BLEND), glEnable(GL_CULL_FACE);
    glEnable(GL_STENCIL_TEST), glDisable(GL_DITHER), glDepthMask(GL_FALSE), glDepthFunc(GL_NEVER);
    glClearDepthf(0.25f), glCullFace(GL_FRONT_AND_BACK), glFrontFace(GL_CW);
    glViewport(1, 2, 3, 4), glScissor(5, 6, 7, 8), glClearColor(clear[0], clear[1], clear[2], clear[3]);
    glBlendFuncSeparate(blend[0], blend[1], blend[2], blend[3]);
    glColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_TRUE);
    if (!is_es()) glEnable(GL_FRAMEBUFFER_SRGB), glClipControl(GL_UPPER_LEFT, GL_ZERO_TO_ONE);
    return d;
}

// Bindings that the host sets anew before its next draw call.
static bool is_left(const char *name) {
    return strncmp(name, "GL_TEXTURE_BINDING", 18) == 0 || strncmp(name, "GL_SAMPLER_BINDING", 18) == 0 ||
           strncmp(name, "GL_UNIFORM_BUFFER[", 18) == 0;
}

static void what_is_declared_is_put_back(void **state) {
    (void)state;
    static shot calm, wild;
    static snapshot before;
    const bolan_renderer_desc desc = desc_of(BOLAN_RESTORE_DECLARED);
    uint32_t count = 0;
    const bolan_technique *list = bolan_techniques(&count);
    host h;
    rig r;
    open_rig(&r, &desc);
    draw_rig(&r);
    take_shot(&r, &calm);
    open_host(&h);
    const bolan_gl_state declared = set_declared(&h);
    bolan_renderer_declare_state(r.renderer, &declared);
    take(&before);
    take_shot(&r, &wild);
    assert_same_but(&before, "draw and read", is_left);
    assert_memory_equal(&wild, &calm, sizeof wild);
    for (uint32_t i = 0; i < count; i++) {
        bolan_scene_set_technique(&r.scene, &list[i]);
        assert_int_equal(bolan_world_set_scene(r.world, &r.scene), BOLAN_OK);
        draw_rig(&r);
        assert_same_but(&before, list[i].name, is_left);
    }
    close_rig(&r);
    close_host(&h);
}

// ---- counted --------------------------------------------------------------------------------------------------------

static void only_full_asks(void **state) {
    (void)state;
    for (int restore = BOLAN_RESTORE_FULL; restore <= BOLAN_RESTORE_NONE; ++restore) {
        const bolan_renderer_desc desc = desc_of((bolan_restore)restore);
        rig r;
        open_rig(&r, &desc);
        for (int i = 0; i < WARM_UP; i++) step_and_draw(&r, i);
        uint32_t questions = 0, calls = 0;
        for (int i = WARM_UP; i < WARM_UP + FRAMES; i++) {
            step_and_draw(&r, i);
            questions += bolan_renderer_statistics(r.renderer).gl_questions;
            calls += bolan_renderer_statistics(r.renderer).gl_calls;
        }
        print_message("restore %d: %u calls of OpenGL a frame, %u questions\n", restore, calls / FRAMES,
                      questions / FRAMES);
        if (restore == BOLAN_RESTORE_FULL)
            assert_true(questions > 150 * FRAMES);
        else
            assert_int_equal(questions, 0);
        close_rig(&r);
    }
}

static void count_technique(const bolan_technique *technique, const char *scene, bolan_pixels pixels) {
    bolan_renderer_desc desc = desc_of(BOLAN_RESTORE_NONE);
    rig r;
    desc.pixels = pixels;
    open_rig_of(&r, &desc, scene);
    assert_int_equal(bolan_renderer_pixels(r.renderer), pixels);
    bolan_scene_set_technique(&r.scene, technique);
    assert_int_equal(bolan_world_set_scene(r.world, &r.scene), BOLAN_OK);
    for (int i = 0; i < WARM_UP; i++) step_and_draw(&r, i);
    for (int i = WARM_UP; i < 2 * WARM_UP; i++) {
        step_and_draw(&r, i);
        const bolan_frame_statistics s = bolan_renderer_statistics(r.renderer);
        const uint32_t view = calls_of(&s, "view"), water = calls_of(&s, "water");
        if (i == WARM_UP)
            print_message("%s, %s, %s: %u calls of OpenGL prepare the view, %u draw the water, %u in all\n", scene,
                          technique->name, bolan_pixels_names[pixels], view, water, s.gl_calls);
        assert_true(water > 0 && view > 0);
        const bool tiles = pixels == BOLAN_PIXELS_COMPUTE && bolan_world_water(r.world)->ground != NULL;
        assert_true(view + water <= (tiles ? MOST_WATER_CALLS + MOST_TILE_CALLS : MOST_WATER_CALLS));
        assert_true(s.gl_calls >= view + water);
    }
    close_rig(&r);
}

static void water_takes_few_calls(void **state) {
    (void)state;
    uint32_t count = 0;
    const bolan_technique *list = bolan_techniques(&count);
    for (uint32_t i = 0; i < count; i++) count_technique(&list[i], "open-sea", BOLAN_PIXELS_FRAGMENT);
}

static void nested_levels_and_tiles_take_few_calls(void **state) {
    (void)state;
    const char *const scenes[] = {"open-sea", "island"};
    bolan_technique nested = bolan_technique_ocean;
    nested.name = "ocean on nested levels", nested.surface = BOLAN_SURFACE_NESTED;
    for (int i = 0; i < 2; ++i) {
        count_technique(&nested, scenes[i], BOLAN_PIXELS_FRAGMENT);
        if (!bolan_gl_get_caps().compute) continue;
        count_technique(&nested, scenes[i], BOLAN_PIXELS_COMPUTE);
        count_technique(&bolan_technique_ocean, scenes[i], BOLAN_PIXELS_COMPUTE);
    }
}

// ---- refused --------------------------------------------------------------------------------------------------------

static int refusals;
static bolan_log_id refusal;
static void hear(void *user, bolan_log_level level, bolan_log_id id, const char *sentence) {
    (void)user, (void)sentence;
    if (level != BOLAN_LOG_ERROR) return;
    refusals++;
    refusal = id;
}

static void nonsense_is_refused_without_full_too(void **state) {
    (void)state;
    bolan_renderer *none = NULL;
    bolan_set_hooks(&(bolan_hooks){.log = hear});
    bolan_renderer_desc desc = desc_of((bolan_restore)3);
    assert_int_equal(bolan_renderer_create(&desc, &none), BOLAN_ERROR_ARGUMENT);
    assert_int_equal(refusal, BOLAN_LOG_OUT_OF_RANGE);
    desc.restore = BOLAN_RESTORE_NONE;
    rig r;
    open_rig(&r, &desc);
    draw_rig(&r);
    refusals = 0;
    const uint32_t good = r.view.framebuffer;
    r.view.framebuffer = 9999;
    draw_rig(&r);
    assert_int_equal(refusals, 1);
    assert_int_equal(refusal, BOLAN_LOG_GL_TARGET);
    r.view.framebuffer = good;
    draw_rig(&r);
    r.view.framebuffer = 9999;
    draw_rig(&r);
    assert_int_equal(refusals, 2);
    bolan_host frame = bolan_host_default();
    frame.mask = 9999;
    r.view.framebuffer = good;
    bolan_renderer_draw_water(r.renderer, &r.view, &frame);
    assert_int_equal(refusals, 3);
    assert_int_equal(refusal, BOLAN_LOG_GUEST_FRAME);
    assert_true(watch_is_clean("refusals"));
    close_rig(&r);
    bolan_set_hooks(NULL);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(none_draws_the_same_image_whatever_the_host_has_set, gl_setup_core,
                                        gl_teardown),
        IN_BOTH_APIS(what_is_declared_is_put_back),
        IN_BOTH_APIS(only_full_asks),
        cmocka_unit_test_setup_teardown(water_takes_few_calls, gl_setup_core, gl_teardown),
        cmocka_unit_test_setup_teardown(nested_levels_and_tiles_take_few_calls, gl_setup_core, gl_teardown),
        cmocka_unit_test_setup_teardown(nonsense_is_refused_without_full_too, gl_setup_core, gl_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

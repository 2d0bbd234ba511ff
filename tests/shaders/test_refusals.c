// SPDX-License-Identifier: MIT
// What the renderer refuses: in one sentence, once, and without an error in GL.
#include "gl_support.h"
#include "heard.h"

#include "bolan/io.h"

#include <stdio.h>
#include <string.h>

enum { WIDTH = 32, HEIGHT = 24 };

static long allocations;
static void *count_allocation(void *user, size_t size, size_t align) {
    (void)user;
    void *memory = NULL;
    allocations++;
    return posix_memalign(&memory, align < sizeof(void *) ? sizeof(void *) : align, size) == 0 ? memory : NULL;
}
static void release(void *user, void *memory, size_t size) {
    (void)user, (void)size;
    free(memory);
}

static int asserted;
static void note_assert(void *user, const char *expression, const char *file, int line) {
    (void)user, (void)expression, (void)file, (void)line;
    asserted++;
}

typedef struct rig {
    bolan_scene scene;
    bolan_world *world;
    bolan_renderer *renderer;
    bolan_target *target;
    bolan_view view;
} rig;

static bolan_view view_of(const rig *r, uint32_t width, uint32_t height) {
    bolan_view view = bolan_view_from_camera(&r->scene.camera, width, height);
    view.framebuffer = bolan_target_framebuffer(r->target);
    return view;
}

static void open_rig(rig *r) {
    bolan_renderer_desc desc = bolan_renderer_desc_default();
    memset(r, 0, sizeof *r);
    memset(&heard, 0, sizeof heard);
    asserted = 0;
    bolan_set_hooks(
        &(bolan_hooks){.log = hear, .allocate = count_allocation, .release = release, .assert_failed = note_assert});
    desc.quality = BOLAN_QUALITY_LOW;
    assert_int_equal(bolan_scene_load("open-sea", &r->scene), BOLAN_OK);
    r->scene.sea.resolution = 32;
    r->scene.sea.fft.cascade_count = 2;
    assert_int_equal(bolan_world_load_scene(&r->scene, &r->world), BOLAN_OK);
    bolan_world_step(r->world, 3.0);
    assert_int_equal(bolan_renderer_create(&desc, &r->renderer), BOLAN_OK);
    assert_int_equal(bolan_target_create(WIDTH, HEIGHT, &r->target), BOLAN_OK);
    r->view = view_of(r, WIDTH, HEIGHT);
}

static void close_rig(rig *r) {
    bolan_target_destroy(&r->target);
    bolan_renderer_destroy(&r->renderer);
    bolan_world_destroy(&r->world);
    bolan_set_hooks(NULL);
}

// The last call said this, and no other.
static void assert_heard(int errors, bolan_log_id id, const char *part) {
    assert_int_equal(heard.errors, errors);
    assert_int_equal(heard.id, id);
    if (strstr(heard.sentence, part) == NULL) fail_msg("\"%s\" does not say \"%s\"", heard.sentence, part);
    assert_true(watch_is_clean(part));
    heard.errors = 0;
}

static uint32_t mean_red(rig *r) {
    static uint8_t rgb[WIDTH * HEIGHT * 3];
    uint32_t sum = 0;
    bolan_renderer_read_rgb8(r->renderer, bolan_target_framebuffer(r->target), WIDTH, HEIGHT, rgb);
    for (int i = 0; i < WIDTH * HEIGHT; i++) sum += rgb[3 * i];
    return sum / (WIDTH * HEIGHT);
}

static void paint_white(rig *r) {
    glBindFramebuffer(GL_FRAMEBUFFER, bolan_target_framebuffer(r->target));
    glClearColor(1, 1, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
}

static void draw(rig *r, const bolan_view *view) { bolan_renderer_draw_world(r->renderer, r->world, view); }

// Refused twice and said once; said again after a frame that was drawn. The host's framebuffer keeps what it had.
static void assert_refused(rig *r, bolan_view view, bolan_log_id id, const char *part) {
    paint_white(r);
    draw(r, &view);
    draw(r, &view);
    assert_heard(1, id, part);
    assert_int_equal(mean_red(r), 255);
    draw(r, &r->view);
    assert_int_equal(heard.errors, 0);
    assert_true(mean_red(r) < 255);
    draw(r, &view);
    assert_heard(1, id, part);
    draw(r, &r->view);
}

static void a_frame_out_of_range_is_refused(void **state) {
    (void)state;
    static const struct {
        uint32_t width, height, samples;
        const char *part;
    } list[] = {{0, HEIGHT, 1, "0 x 24"},
                {WIDTH, 0, 1, "32 x 0"},
                {16385, HEIGHT, 1, "16385 x 24"},
                {WIDTH, 16385, 1, "32 x 16385"},
                {WIDTH, 0xffffffff, 1, "1 to 16384"},
                {WIDTH, HEIGHT, 0, "0 samples"},
                {WIDTH, HEIGHT, 257, "257 samples"}};
    rig r;
    open_rig(&r);
    for (size_t i = 0; i < sizeof list / sizeof *list; i++) {
        bolan_view view = r.view;
        view.width = list[i].width, view.height = list[i].height, view.samples = list[i].samples;
        assert_refused(&r, view, BOLAN_LOG_OUT_OF_RANGE, list[i].part);
    }
    close_rig(&r);
}

// Refused twice and said once, and no water is drawn after it; said again after a step that was prepared.
static void assert_not_prepared(rig *r, const bolan_lighting *lighting, bolan_log_id id, const char *part) {
    const bolan_water *water = bolan_world_water(r->world);
    paint_white(r);
    for (int twice = 0; twice < 2; twice++) bolan_renderer_prepare(r->renderer, water, lighting);
    assert_heard(1, id, part);
    bolan_renderer_draw_water(r->renderer, &r->view, NULL);
    assert_heard(1, BOLAN_LOG_BAD_ARGUMENT, "no step is prepared");
    assert_int_equal(mean_red(r), 255);
    draw(r, &r->view);
    assert_int_equal(heard.errors, 0);
    assert_true(mean_red(r) < 255);
    bolan_renderer_prepare(r->renderer, water, lighting);
    assert_heard(1, id, part);
    draw(r, &r->view);
}

static void a_technique_that_is_none_or_not_the_seas_is_refused(void **state) {
    (void)state;
    rig r;
    open_rig(&r);
    bolan_lighting lighting = bolan_lighting_from_scene(&r.scene);
    lighting.technique.optics = (bolan_optics_kind)99;
    assert_not_prepared(&r, &lighting, BOLAN_LOG_OUT_OF_RANGE, "technique.optics is 99");
    lighting = bolan_lighting_from_scene(&r.scene);
    lighting.technique.surface = (bolan_surface_kind)BOLAN_SURFACE_KINDS;
    assert_not_prepared(&r, &lighting, BOLAN_LOG_OUT_OF_RANGE, "technique.surface");
    lighting = bolan_lighting_from_scene(&r.scene);
    lighting.technique.waves = (bolan_wave_model)99;
    assert_not_prepared(&r, &lighting, BOLAN_LOG_OUT_OF_RANGE, "technique.waves is 99");
    lighting = bolan_lighting_from_scene(&r.scene);
    lighting.technique.waves = BOLAN_WAVES_COSINES;
    assert_not_prepared(&r, &lighting, BOLAN_LOG_BAD_ARGUMENT, "waves is cosines, but the sea is made of fft");
    close_rig(&r);
}

typedef struct odd_framebuffers {
    GLuint names[4], buffers[2], texture; // empty, of several samples, without a draw buffer, of integers
} odd_framebuffers;

static void open_odd(odd_framebuffers *o) {
    glGenFramebuffers(4, o->names);
    glGenRenderbuffers(2, o->buffers);
    glGenTextures(1, &o->texture);
    glBindFramebuffer(GL_FRAMEBUFFER, o->names[0]);
    glBindFramebuffer(GL_FRAMEBUFFER, o->names[1]);
    glBindRenderbuffer(GL_RENDERBUFFER, o->buffers[0]);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, 4, GL_RGBA8, WIDTH, HEIGHT);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, o->buffers[0]);
    glBindFramebuffer(GL_FRAMEBUFFER, o->names[2]);
    glBindTexture(GL_TEXTURE_2D, o->texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, WIDTH, HEIGHT, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, o->texture, 0);
    glDrawBuffers(1, (const GLenum[]){GL_NONE});
    glReadBuffer(GL_NONE);
    glBindFramebuffer(GL_FRAMEBUFFER, o->names[3]);
    glBindRenderbuffer(GL_RENDERBUFFER, o->buffers[1]);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8UI, WIDTH, HEIGHT);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, o->buffers[1]);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

static void close_odd(odd_framebuffers *o) {
    glDeleteFramebuffers(4, o->names);
    glDeleteRenderbuffers(2, o->buffers);
    glDeleteTextures(1, &o->texture);
}

static void a_framebuffer_that_will_not_do_is_refused(void **state) {
    (void)state;
    odd_framebuffers odd;
    rig r;
    open_rig(&r);
    open_odd(&odd);
    const struct {
        GLuint framebuffer;
        const char *part;
    } list[] = {{9999, "9999 is no framebuffer"},
                {0, "no window"},
                {odd.names[0], "is not complete"},
                {odd.names[2], "has no draw buffer"},
                {odd.names[3], "holds integers"}};
    for (size_t i = 0; i < sizeof list / sizeof *list; i++) {
        bolan_view view = r.view;
        view.framebuffer = list[i].framebuffer;
        assert_refused(&r, view, BOLAN_LOG_GL_TARGET, list[i].part);
        bolan_target_show(r.target, list[i].framebuffer, WIDTH, HEIGHT);
        bolan_target_show(r.target, list[i].framebuffer, WIDTH, HEIGHT);
        assert_heard(1, BOLAN_LOG_GL_TARGET, strchr(list[i].part, ' ') ? strrchr(list[i].part, ' ') : "");
    }
    bolan_target_show(r.target, bolan_target_framebuffer(r.target), WIDTH, HEIGHT);
    assert_heard(1, BOLAN_LOG_GL_TARGET, "the target itself");
    bolan_target_show(r.target, 9999, 0, HEIGHT);
    assert_heard(1, BOLAN_LOG_GL_TARGET, "1 to 16384");
    bolan_view view = r.view; // several samples are drawn into
    view.framebuffer = odd.names[1];
    draw(&r, &view);
    assert_int_equal(heard.errors, 0);
    assert_true(watch_is_clean("several samples"));
    close_odd(&odd);
    close_rig(&r);
}

static void reading_what_cannot_be_read_is_refused(void **state) {
    (void)state;
    static uint8_t rgb[WIDTH * HEIGHT * 3];
    static float linear[WIDTH * HEIGHT * 3];
    odd_framebuffers odd;
    rig r;
    open_rig(&r);
    linear[0] = 77.0f;
    bolan_renderer_read_linear(r.renderer, linear, NULL);
    bolan_renderer_read_linear(r.renderer, linear, NULL);
    assert_heard(1, BOLAN_LOG_BAD_ARGUMENT, "no picture yet");
    assert_float_equal(linear[0], 77.0f, 0.0f);
    open_odd(&odd);
    const struct {
        GLuint framebuffer;
        const char *part;
    } list[] = {{9999, "9999 is no framebuffer"},
                {odd.names[0], "is not complete"},
                {odd.names[1], "several samples"},
                {odd.names[2], "has no read buffer"},
                {odd.names[3], "holds integers"}};
    rgb[0] = 77;
    for (size_t i = 0; i < sizeof list / sizeof *list; i++) {
        for (int twice = 0; twice < 2; twice++)
            bolan_renderer_read_rgb8(r.renderer, list[i].framebuffer, WIDTH, HEIGHT, rgb);
        assert_heard(1, BOLAN_LOG_GL_TARGET, list[i].part);
        assert_int_equal(rgb[0], 77);
    }
    bolan_renderer_read_rgb8(r.renderer, r.view.framebuffer, 0, HEIGHT, rgb);
    assert_heard(1, BOLAN_LOG_OUT_OF_RANGE, "0 x 24");
    bolan_renderer_read_rgb8(r.renderer, r.view.framebuffer, WIDTH, 16385, rgb);
    assert_heard(1, BOLAN_LOG_OUT_OF_RANGE, "32 x 16385");
    assert_true(bolan_renderer_yardstick(r.renderer, 0, 9, 1) == 0.0);
    assert_heard(1, BOLAN_LOG_OUT_OF_RANGE, "0 x 9");
    close_odd(&odd);
    close_rig(&r);
}

static void a_target_of_a_wrong_size_is_refused(void **state) {
    (void)state;
    static const uint32_t sizes[][2] = {{0, 1}, {1, 0}, {16385, 1}, {1, 16385}, {0xffffffff, 0xffffffff}};
    int something = 0;
    rig r;
    open_rig(&r);
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        bolan_target *target = (bolan_target *)(void *)&something;
        assert_int_equal(bolan_target_create(sizes[i][0], sizes[i][1], &target), BOLAN_ERROR_ARGUMENT);
        assert_null(target);
        assert_heard(1, BOLAN_LOG_OUT_OF_RANGE, "expected 1 to 16384 each way");
    }
    bolan_target *widest = NULL;
    assert_int_equal(bolan_target_create(16384, 1, &widest), BOLAN_OK);
    bolan_target_destroy(&widest);
    close_rig(&r);
}

static void a_renderer_of_wrong_wishes_is_refused(void **state) {
    (void)state;
    static char long_path[1100];
    int something = 0;
    rig r;
    open_rig(&r);
    memset(long_path, 'a', sizeof long_path - 1);
    for (int i = 0; i < 4; i++) {
        bolan_renderer *renderer = (bolan_renderer *)(void *)&something;
        bolan_renderer_desc desc = bolan_renderer_desc_default();
        if (i == 0) desc.quality = (bolan_quality)4;
        if (i == 1) desc.max_vertices = 1023;
        if (i == 2) desc.max_vertices = 1000001;
        if (i == 3) desc.shader_directory = long_path;
        assert_int_equal(bolan_renderer_create(&desc, &renderer), BOLAN_ERROR_ARGUMENT);
        assert_null(renderer);
        assert_heard(1, BOLAN_LOG_OUT_OF_RANGE, "renderer: ");
    }
    bolan_renderer *renderer = (bolan_renderer *)(void *)&something;
    bolan_renderer_desc desc = bolan_renderer_desc_default();
    desc.shader_directory = "nowhere";
    assert_int_equal(bolan_renderer_create(&desc, &renderer), BOLAN_ERROR_GL);
    assert_null(renderer);
    assert_heard(1, BOLAN_LOG_GL_SHADER, "nowhere");
    draw(&r, &r.view); // from its own directory still: a first draw compiles shaders
    assert_int_equal(heard.errors, 0);
    close_rig(&r);
}

static void misuse_is_asserted_and_survived(void **state) {
    (void)state;
    rig r;
    open_rig(&r);
    const bolan_lighting lighting = bolan_lighting_default();
    bolan_renderer_draw_world(NULL, r.world, &r.view);
    bolan_renderer_draw_world(r.renderer, NULL, &r.view);
    bolan_renderer_draw_world(r.renderer, r.world, NULL);
    bolan_renderer_prepare(r.renderer, &(bolan_water){.sea = NULL}, &lighting);
    assert_int_equal(asserted, 4);
    assert_true(watch_is_clean("misuse"));
    close_rig(&r);
}

static void without_a_context_all_is_refused(void **state) {
    static uint8_t rgb[WIDTH * HEIGHT * 3];
    static float linear[WIDTH * HEIGHT * 3];
    bolan_context *context = NULL;
    int something = 0;
    (void)state;
    if (bolan_context_create(BOLAN_GL_CORE, &context) != BOLAN_OK) skip_without_gl();
    rig r;
    open_rig(&r);
    bolan_context_destroy(&context);
    const long before = allocations;
    for (int twice = 0; twice < 2; twice++) draw(&r, &r.view);
    assert_int_equal(heard.errors, 1);
    for (int twice = 0; twice < 2; twice++) bolan_renderer_read_linear(r.renderer, linear, NULL);
    assert_int_equal(heard.errors, 2);
    for (int twice = 0; twice < 2; twice++) bolan_renderer_read_rgb8(r.renderer, 1, WIDTH, HEIGHT, rgb);
    assert_int_equal(heard.errors, 3);
    for (int twice = 0; twice < 2; twice++) assert_true(bolan_renderer_yardstick(r.renderer, 8, 8, 1) == 0.0);
    assert_int_equal(heard.errors, 4);
    assert_int_equal(bolan_renderer_reload(r.renderer), BOLAN_ERROR_GL);
    assert_int_equal(heard.errors, 5);
    for (int twice = 0; twice < 2; twice++) bolan_target_show(r.target, 0, 8, 8);
    assert_int_equal(heard.errors, 6);
    assert_int_equal(allocations, before);
    bolan_renderer *renderer = (bolan_renderer *)(void *)&something;
    bolan_target *target = (bolan_target *)(void *)&something;
    const bolan_renderer_desc desc = bolan_renderer_desc_default();
    assert_int_equal(bolan_renderer_create(&desc, &renderer), BOLAN_ERROR_GL);
    assert_int_equal(bolan_target_create(8, 8, &target), BOLAN_ERROR_GL);
    assert_null(renderer);
    assert_null(target);
    assert_int_equal(heard.errors, 8);
    bolan_target_destroy(&r.target);
    assert_int_equal(heard.errors, 9);
    bolan_renderer_destroy(&r.renderer);
    assert_int_equal(heard.errors, 10);
    assert_int_equal(heard.id, BOLAN_LOG_GL_CONTEXT);
    close_rig(&r);
}

static void reading_again_allocates_nothing(void **state) {
    (void)state;
    static uint8_t rgb[WIDTH * HEIGHT * 3];
    static float linear[WIDTH * HEIGHT * 3], distance[WIDTH * HEIGHT];
    rig r;
    open_rig(&r);
    for (int i = 0; i < 3; i++) {
        const long before = allocations;
        draw(&r, &r.view);
        bolan_renderer_read_linear(r.renderer, linear, distance);
        bolan_renderer_read_rgb8(r.renderer, r.view.framebuffer, WIDTH, HEIGHT, rgb);
        if (i == 2) assert_int_equal(allocations, before);
    }
    r.view = view_of(&r, WIDTH / 2, HEIGHT); // smaller: what is there will do, and is read in its own size
    draw(&r, &r.view);
    bolan_renderer_read_linear(r.renderer, linear, distance);
    assert_true(isinf(distance[0]) && isfinite(distance[WIDTH / 2 * HEIGHT - 1]));
    assert_int_equal(heard.errors, 0);
    close_rig(&r);
}

#define IN_CORE(f) cmocka_unit_test_setup_teardown(f, gl_setup_core, gl_teardown)

int main(void) {
    const struct CMUnitTest tests[] = {
        IN_CORE(a_frame_out_of_range_is_refused),
        IN_CORE(a_technique_that_is_none_or_not_the_seas_is_refused),
        IN_BOTH_APIS(a_framebuffer_that_will_not_do_is_refused),
        IN_BOTH_APIS(reading_what_cannot_be_read_is_refused),
        IN_CORE(a_target_of_a_wrong_size_is_refused),
        IN_CORE(a_renderer_of_wrong_wishes_is_refused),
        IN_CORE(misuse_is_asserted_and_survived),
        IN_BOTH_APIS(reading_again_allocates_nothing),
        cmocka_unit_test(without_a_context_all_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

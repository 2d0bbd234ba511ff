// SPDX-License-Identifier: MIT
// The renderer as a guest: whatever state the host has set, the picture is the same, and each call leaves all of it as
// it was.
#include "guest_host.h"

#include "bolan/io.h"

#include <epoxy/egl.h>
#include <stdio.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

// ---- state ----------------------------------------------------------------------------------------------------------

static void no_call_changes_any_state(void **state) {
    (void)state;
    static snapshot before;
    static shot calm, wild;
    host h;
    rig r, second;
    open_low(&r);
    take_shot(&r, &calm);
    open_host(&h);
    set_apart(&h);
    assert_true(watch_is_clean("the host itself"));
    take(&before);
    take_shot(&r, &wild);
    assert_same(&before, "draw and read");
    assert_memory_equal(&wild, &calm, sizeof wild);
    r.view.samples = 3;
    draw_rig(&r);
    assert_same(&before, "draw with 3 samples");
    bolan_renderer_measure_passes(r.renderer, true);
    draw_rig(&r);
    bolan_renderer_measure_passes(r.renderer, false);
    assert_same(&before, "draw with times");
    assert_int_equal(bolan_renderer_reload(r.renderer), BOLAN_OK);
    assert_same(&before, "reload");
    bolan_renderer_yardstick(r.renderer, 16, 16, 1);
    assert_same(&before, "yardstick");
    bolan_target_show(r.target, h.framebuffer, 20, 30);
    assert_same(&before, "show");
    open_low(&second);
    assert_same(&before, "create");
    take_shot(&second, &wild);
    assert_memory_equal(&wild, &calm, sizeof wild); // its textures and shaders were made amid all this
    close_rig(&second);
    assert_same(&before, "destroy");
    close_rig(&r);
    close_host(&h);
}

// Each technique has passes and textures of its own.
static void no_technique_changes_any_state_or_leaves_an_error(void **state) {
    (void)state;
    static snapshot before;
    uint32_t count = 0;
    const bolan_technique *list = bolan_techniques(&count);
    host h;
    rig r;
    open_low(&r);
    open_host(&h);
    set_apart(&h);
    take(&before);
    for (uint32_t i = 0; i < count; i++) {
        bolan_scene_set_technique(&r.scene, &list[i]);
        r.scene.sea.resolution = 64;
        for (int show = BOLAN_SHOW_PICTURE; show <= BOLAN_SHOW_MESH; show += BOLAN_SHOW_MESH - BOLAN_SHOW_PICTURE) {
            r.scene.look.show = (bolan_show)show;
            assert_int_equal(bolan_world_set_scene(r.world, &r.scene), BOLAN_OK);
            draw_rig(&r);
            assert_same(&before, list[i].name);
        }
    }
    close_rig(&r);
    close_host(&h);
}

// ---- errors of the host ---------------------------------------------------------------------------------------------

static void a_pending_error_stays_the_hosts(void **state) {
    (void)state;
    static shot s;
    rig r, second;
    open_low(&r);
    glEnable(0xdead);
    take_shot(&r, &s);
    bolan_renderer_yardstick(r.renderer, 16, 16, 1);
    assert_int_equal(bolan_renderer_reload(r.renderer), BOLAN_OK);
    bolan_target_show(r.target, 9999, 16, 16);
    open_low(&second);
    close_rig(&second);
    close_rig(&r);
    (void)bolan_gl_get_info();
    assert_int_equal(glGetError(), GL_INVALID_ENUM);
    assert_int_equal(glGetError(), GL_NO_ERROR);
    assert_int_equal(watched.errors, 1); // the host's own
    watched.errors = 0;
}

// ---- the debug callback ---------------------------------------------------------------------------------------------

static int host_messages;
static void APIENTRY count_message(GLenum source, GLenum type, GLuint id, GLenum severity, GLsizei length,
                                   const GLchar *message, const void *user) {
    (void)source, (void)type, (void)id, (void)severity, (void)length, (void)message;
    host_messages += user == &host_messages;
}

static int debug_sentences;
static void note_debug(void *user, bolan_log_level level, bolan_log_id id, const char *sentence) {
    (void)user, (void)level, (void)sentence;
    debug_sentences += id == BOLAN_LOG_GL_DEBUG;
}

static void say(void) {
    static const char text[] = "hello";
    glDebugMessageInsert(GL_DEBUG_SOURCE_APPLICATION, GL_DEBUG_TYPE_OTHER, 1, GL_DEBUG_SEVERITY_HIGH, -1, text);
}

// The layer itself, since a driver that is content says nothing.
static void debug_messages_go_to_the_log_and_to_the_host(void **state) {
    (void)state;
    const gl_caps caps = bolan_gl_get_caps();
    gl_saved saved;
    bolan_set_hooks(&(bolan_hooks){.log = note_debug});
    glEnable(GL_DEBUG_OUTPUT);
    for (int with_host = 0; with_host < 2; with_host++)
        for (int debug = 0; debug < 2; debug++) {
            void *callback = NULL, *user = NULL;
            glDebugMessageCallback(with_host ? count_message : NULL, with_host ? &host_messages : NULL);
            host_messages = debug_sentences = 0;
            bolan_gl_save(&saved, &caps, debug);
            say();
            assert_int_equal(host_messages, with_host);
            assert_int_equal(debug_sentences, debug);
            bolan_gl_restore(&saved);
            glGetPointerv(GL_DEBUG_CALLBACK_FUNCTION, &callback);
            glGetPointerv(GL_DEBUG_CALLBACK_USER_PARAM, &user);
            assert_ptr_equal(user, with_host ? &host_messages : NULL);
            assert_int_equal(callback != NULL, with_host);
            say();
            assert_int_equal(host_messages, 2 * with_host);
            assert_int_equal(debug_sentences, debug);
        }
    glDisable(GL_DEBUG_OUTPUT); // what the host does not want it does not get
    host_messages = debug_sentences = 0;
    bolan_gl_save(&saved, &caps, true);
    say();
    bolan_gl_restore(&saved);
    assert_int_equal(host_messages, 0);
    assert_int_equal(debug_sentences, 1);
    assert_int_equal(glIsEnabled(GL_DEBUG_OUTPUT), GL_FALSE);
    bolan_set_hooks(NULL);
    watch_begin();
}

static void a_renderer_with_debug_gives_the_callback_back(void **state) {
    (void)state;
    static snapshot before;
    bolan_renderer_desc desc = low_quality();
    rig r, second;
    desc.debug = true;
    take(&before);
    open_rig(&r, &desc);
    assert_same(&before, "create with debug");
    open_rig(&second, &desc);
    draw_rig(&r);
    assert_same(&before, "draw with debug");
    close_rig(&r);
    draw_rig(&second);
    close_rig(&second);
    assert_same(&before, "destroy with debug");
}

// ---- queries of the host --------------------------------------------------------------------------------------------

static double sum_of_passes(const rig *r) {
    const bolan_frame_statistics s = bolan_renderer_statistics(r->renderer);
    double sum = 0.0;
    for (uint32_t i = 0; i < s.pass_count; i++) {
        assert_true(s.passes[i].ms >= 0.0);
        sum += s.passes[i].ms;
    }
    return sum;
}

static void timers_leave_the_hosts_query_alone(void **state) {
    (void)state;
    bolan_renderer_desc desc = low_quality();
    GLuint query = 0;
    GLuint64 ns = 0;
    GLint current = 0;
    rig r;
    desc.force_timers = true;
    open_rig(&r, &desc);
    bolan_renderer_measure_passes(r.renderer, true);
    glGenQueries(1, &query);
    for (int i = 0; i < 12; i++) {
        glBeginQuery(GL_TIME_ELAPSED, query);
        draw_rig(&r);
        glGetQueryiv(GL_TIME_ELAPSED, GL_CURRENT_QUERY, &current);
        assert_int_equal(current, query);
        glEndQuery(GL_TIME_ELAPSED);
        assert_true(watch_is_clean("a frame inside the host's query"));
        glFinish();
    }
    glGetQueryObjectui64v(query, GL_QUERY_RESULT, &ns);
    assert_true(ns > 0);
    const double ms = sum_of_passes(&r);
    assert_true(ms > 0.0 && ms < 1e5); // less than a minute and a half
    bolan_renderer_measure_passes(r.renderer, false);
    draw_rig(&r);
    assert_true(sum_of_passes(&r) == 0.0);
    glDeleteQueries(1, &query);
    close_rig(&r);
}

static void times_come_without_timers_too(void **state) {
    (void)state;
    rig r;
    open_low(&r);
    draw_rig(&r);
    assert_true(sum_of_passes(&r) == 0.0);
    bolan_renderer_measure_passes(r.renderer, true);
    draw_rig(&r);
    assert_true(sum_of_passes(&r) > 0.0);
    close_rig(&r);
}

static void transform_feedback_is_paused(void **state) {
    (void)state;
    static shot calm, amid;
    host h;
    rig r;
    GLboolean active = GL_FALSE, paused = GL_TRUE;
    GLfloat *written = NULL;
    open_low(&r);
    take_shot(&r, &calm);
    open_host(&h);
    glBindVertexArray(h.vertex_array);
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, h.buffers[0]);
    glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, 64, NULL, GL_STATIC_READ);
    glUseProgram(h.program);
    glBeginTransformFeedback(GL_POINTS);
    glDrawArrays(GL_POINTS, 0, 1);
    take_shot(&r, &amid);
    glGetBooleanv(GL_TRANSFORM_FEEDBACK_ACTIVE, &active);
    glGetBooleanv(GL_TRANSFORM_FEEDBACK_PAUSED, &paused);
    assert_true(active && !paused);
    glDrawArrays(GL_POINTS, 0, 2);
    glEndTransformFeedback();
    assert_true(watch_is_clean("transform feedback"));
    assert_memory_equal(&amid, &calm, sizeof amid);
    written = glMapBufferRange(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 12, GL_MAP_READ_BIT);
    for (int i = 0; i < 3; i++) assert_float_equal(written[i], 7.0f, 0.0f);
    glUnmapBuffer(GL_TRANSFORM_FEEDBACK_BUFFER);
    close_host(&h);
    close_rig(&r);
}

// ---- other contexts -------------------------------------------------------------------------------------------------

typedef struct plain_context {
    EGLDisplay display;
    EGLContext context;
} plain_context;

// As a host makes one that asks for nothing: the compatibility profile.
static bool open_compatibility(plain_context *c) {
    static const EGLint config[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig chosen = NULL;
    EGLint count = 0;
    c->display = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL);
    if (c->display == EGL_NO_DISPLAY || !eglInitialize(c->display, NULL, NULL) || !eglBindAPI(EGL_OPENGL_API))
        return false;
    if (!eglChooseConfig(c->display, config, &chosen, 1, &count) || count == 0) return false;
    c->context = eglCreateContext(c->display, chosen, EGL_NO_CONTEXT, NULL);
    return c->context != EGL_NO_CONTEXT && eglMakeCurrent(c->display, EGL_NO_SURFACE, EGL_NO_SURFACE, c->context);
}

static void close_compatibility(plain_context *c) {
    eglMakeCurrent(c->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(c->display, c->context);
}

static void the_compatibility_profile_is_a_host_too(void **state) {
    (void)state;
    plain_context c;
    if (!open_compatibility(&c)) skip();
    watch_begin();
    if (!is_compatibility() || epoxy_gl_version() < 44) {
        close_compatibility(&c);
        skip();
    }
    no_call_changes_any_state(NULL);
    close_compatibility(&c);
}

static int wrong_sentences, version_sentences;
static void note_version(void *user, bolan_log_level level, bolan_log_id id, const char *sentence) {
    (void)user, (void)level;
    version_sentences += id == BOLAN_LOG_GL_VERSION && strstr(sentence, "2.1") != NULL;
    wrong_sentences += id != BOLAN_LOG_GL_VERSION;
}

// In a process of its own: the environment tells Mesa to be old. 0: refused as it should be; 77: no such context here.
static int visit_old_context(void) {
    plain_context c;
    int something = 0;
    bolan_renderer *renderer = (bolan_renderer *)(void *)&something;
    bolan_target *target = (bolan_target *)(void *)&something;
    const bolan_renderer_desc desc = low_quality();
    if (!open_compatibility(&c) || epoxy_gl_version() != 21) return 77;
    bolan_set_hooks(&(bolan_hooks){.log = note_version});
    if (strncmp(bolan_gl_get_info().version, "2.1", 3) != 0) return 1;
    if (bolan_renderer_create(&desc, &renderer) != BOLAN_ERROR_GL || renderer != NULL || version_sentences != 1)
        return 2;
    if (bolan_target_create(8, 8, &target) != BOLAN_ERROR_GL || target != NULL || version_sentences != 2) return 3;
    if (wrong_sentences != 0 || glGetError() != GL_NO_ERROR) return 4;
    close_compatibility(&c);
    return 0;
}

static void a_context_that_is_too_old_is_refused(void **state) {
    (void)state;
    const pid_t child = fork();
    if (child == 0) {
        setenv("MESA_GL_VERSION_OVERRIDE", "2.1", 1);
        execl("/proc/self/exe", "test_guest", "old", (char *)NULL);
        _exit(127);
    }
    int status = 0;
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_true(WIFEXITED(status));
    if (WEXITSTATUS(status) == 77) skip();
    assert_int_equal(WEXITSTATUS(status), 0);
}

int main(int argc, char **argv) {
    if (argc == 2 && strcmp(argv[1], "old") == 0) return visit_old_context();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_context_that_is_too_old_is_refused),
        cmocka_unit_test(the_compatibility_profile_is_a_host_too),
        IN_BOTH_APIS(no_call_changes_any_state),
        cmocka_unit_test_setup_teardown(no_technique_changes_any_state_or_leaves_an_error, gl_setup_core, gl_teardown),
        IN_BOTH_APIS(a_pending_error_stays_the_hosts),
        IN_BOTH_APIS(debug_messages_go_to_the_log_and_to_the_host),
        cmocka_unit_test_setup_teardown(a_renderer_with_debug_gives_the_callback_back, gl_setup_core, gl_teardown),
        cmocka_unit_test_setup_teardown(timers_leave_the_hosts_query_alone, gl_setup_core, gl_teardown),
        cmocka_unit_test_setup_teardown(times_come_without_timers_too, gl_setup_core, gl_teardown),
        IN_BOTH_APIS(transform_feedback_is_paused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

// SPDX-License-Identifier: MIT
// OpenGL entry points come from the host's get_proc_address hook: each is asked for there, each call goes through what
// the hook gave, and a hook that lacks a function is refused by name.
#include "gl_support.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <string.h>

enum { WIDTH = 16, HEIGHT = 8 };

static struct {
    int asked, links;
    const char *hidden; // the function that the hook does not know
    bolan_log_id id;
    char sentence[512];
} host;

static void hear(void *user, bolan_log_level level, bolan_log_id id, const char *sentence) {
    (void)user;
    if (level != BOLAN_LOG_ERROR) return;
    host.id = id;
    snprintf(host.sentence, sizeof host.sentence, "%s", sentence);
}

static void count_link(GLuint program) {
    host.links++;
    epoxy_glLinkProgram(program);
}

static void *get_proc_address(void *user, const char *name) {
    void *address = NULL;
    void (*const link)(GLuint) = count_link;
    assert_ptr_equal(user, &host);
    host.asked++;
    if (host.hidden && strcmp(name, host.hidden) == 0) return NULL;
    if (strcmp(name, "glLinkProgram") == 0) return memcpy(&address, &link, sizeof address), address;
    void (*const found)(void) = eglGetProcAddress(name);
    memcpy(&address, &found, sizeof address);
    return address;
}

static void use_hook(const char *hidden) {
    memset(&host, 0, sizeof host);
    host.hidden = hidden;
    // Another hook in between, so that the same one is asked again.
    bolan_set_hooks(NULL);
    bolan_gl_get_info();
    bolan_set_hooks(&(bolan_hooks){.user = &host, .log = hear, .get_proc_address = get_proc_address});
}

static void every_call_goes_through_the_hook(void **state) {
    (void)state;
    use_hook(NULL);
    bolan_renderer_desc desc = bolan_renderer_desc_default();
    desc.quality = BOLAN_QUALITY_LOW;
    bolan_renderer *renderer = NULL;
    bolan_target *target = NULL;
    assert_int_equal(bolan_target_create(WIDTH, HEIGHT, &target), BOLAN_OK);
    assert_int_equal(bolan_renderer_create(&desc, &renderer), BOLAN_OK);
    assert_true(host.asked > 80);
    assert_true(host.links > 5);
    const int asked = host.asked;
    assert_string_not_equal(bolan_gl_get_info().version, "");
    assert_int_equal(host.asked, asked); // once for each function
    bolan_renderer_destroy(&renderer);
    bolan_target_destroy(&target);
    bolan_set_hooks(NULL);
}

static void a_function_that_the_hook_lacks_is_named(void **state) {
    (void)state;
    static const char *const needed[] = {"glBindTexture", "glUniformBlockBinding", "glGenVertexArrays"};
    for (int i = 0; i < 3; ++i) {
        bolan_renderer_desc desc = bolan_renderer_desc_default();
        bolan_renderer *renderer = (bolan_renderer *)&desc;
        bolan_target *target = (bolan_target *)&desc;
        use_hook(needed[i]);
        assert_int_equal(bolan_renderer_create(&desc, &renderer), BOLAN_ERROR_GL);
        assert_null(renderer);
        assert_int_equal(host.id, BOLAN_LOG_GL_LOADER);
        assert_non_null(strstr(host.sentence, needed[i]));
        assert_int_equal(bolan_target_create(WIDTH, HEIGHT, &target), BOLAN_ERROR_GL);
        assert_null(target);
    }
    // Without glGetString nothing can be asked: there is no context as far as the library can see.
    use_hook("glGetString");
    bolan_target *target = NULL;
    assert_int_equal(bolan_target_create(WIDTH, HEIGHT, &target), BOLAN_ERROR_GL);
    assert_string_equal(bolan_gl_get_info().version, "");
    bolan_set_hooks(NULL);
}

static void without_a_hook_the_library_finds_them_itself(void **state) {
    (void)state;
    use_hook("glBindTexture");
    bolan_set_hooks(NULL);
    bolan_target *target = NULL;
    assert_int_equal(bolan_target_create(WIDTH, HEIGHT, &target), BOLAN_OK);
    bolan_target_destroy(&target);
    assert_int_equal(host.asked, 0);
}

static void hooks_can_be_asked(void **state) {
    (void)state;
    use_hook(NULL);
    const bolan_hooks hooks = bolan_get_hooks();
    assert_ptr_equal(hooks.user, &host);
    assert_true(hooks.get_proc_address == get_proc_address && hooks.log == hear && hooks.allocate == NULL);
    bolan_set_hooks(NULL);
    assert_null(bolan_get_hooks().user);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        IN_BOTH_APIS(every_call_goes_through_the_hook),
        IN_BOTH_APIS(a_function_that_the_hook_lacks_is_named),
        IN_BOTH_APIS(without_a_hook_the_library_finds_them_itself),
        IN_BOTH_APIS(hooks_can_be_asked),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

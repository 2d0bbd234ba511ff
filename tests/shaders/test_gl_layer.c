// SPDX-License-Identifier: MIT
// The GL layer itself: every format survives upload and read-back, the caller's state is left as found, and errors
// name the file and the line.
#include "gl_support.h"

#include "render/gl/gl.h"
#include <epoxy/gl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { W = 7, H = 5 }; // odd, so that a wrong row alignment shows

static const struct {
    gl_format format;
    uint32_t components;
    float tolerance;
    bool bytes;
    bool renderable_on_es;
} cases[] = {
    // Half floats keep 11 bits, R11G11B10F 7 and 6 (blue has 5 explicit bits: a step of 2^-6), bytes 1/255.
    {GL_FMT_R8, 1, 0.5f / 255, true, true},
    {GL_FMT_RG8, 2, 0.5f / 255, true, true},
    {GL_FMT_RGBA8, 4, 0.5f / 255, true, true},
    {GL_FMT_R16F, 1, 1.0f / 2048, false, true},
    {GL_FMT_RG16F, 2, 1.0f / 2048, false, true},
    {GL_FMT_RGBA16F, 4, 1.0f / 2048, false, true},
    {GL_FMT_R32F, 1, 0.0f, false, true},
    {GL_FMT_RGBA32F, 4, 0.0f, false, true},
    {GL_FMT_R11G11B10F, 3, 1.0f / 64, false, true},
};

static float pattern(uint32_t i) { return (float)((i * 37u) % 256u) / 255.0f; }

static void check_format(size_t c) {
    float floats[W * H * 4];
    uint8_t bytes[W * H * 4];
    const uint32_t n = cases[c].components;
    for (uint32_t i = 0; i < W * H * n; i++) {
        floats[i] = pattern(i);
        bytes[i] = (uint8_t)((i * 37u) % 256u);
    }
    gl_texture t;
    gl_target target;
    const gl_texture *color = &t;
    const gl_texture_desc d = {.format = cases[c].format, .width = W, .height = H};
    assert_int_equal(bolan_gl_texture_create(&d, &t), BOLAN_OK);
    bolan_gl_texture_upload(&t, 0, -1, cases[c].bytes ? (const void *)bytes : (const void *)floats, false);
    assert_int_equal(bolan_gl_target_create(&color, 1, NULL, -1, 0, &target), BOLAN_OK);
    float back[W * H * 4];
    if (cases[c].bytes) { // ES reads bytes as bytes only
        uint8_t rgb[W * H * 3];
        read_bytes(target.id, W, H, rgb);
        for (uint32_t y = 0; y < H; y++) {
            for (uint32_t x = 0; x < W; x++) {
                for (uint32_t k = 0; k < n && k < 3; k++) {
                    assert_int_equal(rgb[3 * ((H - 1 - y) * W + x) + k], bytes[(y * W + x) * n + k]);
                }
            }
        }
    } else {
        bolan_gl_target_read_float(&target, 0, back);
        for (uint32_t i = 0; i < W * H; i++) {
            for (uint32_t k = 0; k < n; k++)
                assert_float_equal(back[4 * i + k], floats[i * n + k], cases[c].tolerance + 1e-7f);
        }
    }
    assert_true(watch_is_clean("format test"));
    bolan_gl_target_free(&target);
    bolan_gl_texture_free(&t);
}

static void every_colour_format_survives_upload_and_read_back(void **state) {
    (void)state;
    for (size_t c = 0; c < sizeof cases / sizeof cases[0]; c++) check_format(c);
}

static void halfs_are_uploaded_as_they_are(void **state) {
    (void)state;
    const uint16_t one_two[4] = {0x3c00, 0x4000, 0xb800, 0x7bff}; // 1, 2, -0.5, 65504 (IEEE 754 binary16)
    gl_texture t;
    gl_target target;
    const gl_texture *color = &t;
    const gl_texture_desc d = {.format = GL_FMT_RGBA16F, .width = 1, .height = 1};
    assert_int_equal(bolan_gl_texture_create(&d, &t), BOLAN_OK);
    bolan_gl_texture_upload(&t, 0, -1, one_two, true);
    assert_int_equal(bolan_gl_target_create(&color, 1, NULL, -1, 0, &target), BOLAN_OK);
    float back[4];
    bolan_gl_target_read_float(&target, 0, back);
    assert_float_equal(back[0], 1.0f, 0);
    assert_float_equal(back[1], 2.0f, 0);
    assert_float_equal(back[2], -0.5f, 0);
    assert_float_equal(back[3], 65504.0f, 0);
    bolan_gl_target_free(&target);
    bolan_gl_texture_free(&t);
}

static void layers_of_an_array_are_separate_targets(void **state) {
    (void)state;
    gl_texture t;
    const gl_texture *color = &t;
    const gl_texture_desc d = {.format = GL_FMT_RGBA16F, .width = 4, .height = 4, .depth = 3, .array = true};
    assert_int_equal(bolan_gl_texture_create(&d, &t), BOLAN_OK);
    gl_target target[3];
    for (int l = 0; l < 3; l++) {
        assert_int_equal(bolan_gl_target_create(&color, 1, NULL, l, 0, &target[l]), BOLAN_OK);
        bolan_gl_target_bind(&target[l]);
        bolan_gl_target_clear_color((float)l, 0, 0, 1);
    }
    for (int l = 0; l < 3; l++) {
        float back[4 * 4 * 4];
        bolan_gl_target_read_float(&target[l], 0, back);
        assert_float_equal(back[0], (float)l, 0);
        bolan_gl_target_free(&target[l]);
    }
    bolan_gl_texture_free(&t);
}

static void depth_reads_back_exactly(void **state) {
    (void)state;
    gl_texture color, depth;
    const gl_texture *colors = &color;
    const gl_texture_desc c = {.format = GL_FMT_RGBA16F, .width = W, .height = H};
    const gl_texture_desc d = {.format = GL_FMT_DEPTH32F, .width = W, .height = H};
    gl_target target;
    assert_int_equal(bolan_gl_texture_create(&c, &color), BOLAN_OK);
    assert_int_equal(bolan_gl_texture_create(&d, &depth), BOLAN_OK);
    assert_int_equal(bolan_gl_target_create(&colors, 1, &depth, -1, 0, &target), BOLAN_OK);
    bolan_gl_target_bind(&target);
    bolan_gl_target_clear_depth(0.0123f);
    float back[W * H];
    read_depths(&depth, back);
    for (int i = 0; i < W * H; i++) assert_float_equal(back[i], 0.0123f, 0);
    assert_true(watch_is_clean("depth test"));
    bolan_gl_target_free(&target);
    bolan_gl_texture_free(&depth);
    bolan_gl_texture_free(&color);
}

// ---- state --------------------------------------------------------------------------------------------------------

typedef struct snapshot {
    GLint integers[64];
    GLfloat floats[16];
    GLboolean switches[16];
    int count, switch_count;
} snapshot;

// What include/bolan/render.h promises to leave as it was.
static void take(snapshot *s, bool es) {
    static const GLenum names[] = {GL_DRAW_FRAMEBUFFER_BINDING,
                                   GL_READ_FRAMEBUFFER_BINDING,
                                   GL_CURRENT_PROGRAM,
                                   GL_VERTEX_ARRAY_BINDING,
                                   GL_ARRAY_BUFFER_BINDING,
                                   GL_UNIFORM_BUFFER_BINDING,
                                   GL_ACTIVE_TEXTURE,
                                   GL_BLEND_SRC_RGB,
                                   GL_BLEND_DST_RGB,
                                   GL_BLEND_SRC_ALPHA,
                                   GL_BLEND_DST_ALPHA,
                                   GL_BLEND_EQUATION_RGB,
                                   GL_CULL_FACE_MODE,
                                   GL_FRONT_FACE,
                                   GL_DEPTH_FUNC,
                                   GL_DEPTH_WRITEMASK,
                                   GL_UNPACK_ALIGNMENT,
                                   GL_PACK_ALIGNMENT,
                                   GL_UNPACK_ROW_LENGTH};
    static const GLenum switches[] = {GL_BLEND,        GL_CULL_FACE, GL_DEPTH_TEST,          GL_SCISSOR_TEST,
                                      GL_STENCIL_TEST, GL_DITHER,    GL_POLYGON_OFFSET_FILL, GL_FRAMEBUFFER_SRGB};
    memset(s, 0, sizeof *s);
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) glGetIntegerv(names[i], &s->integers[s->count++]);
    glGetIntegerv(GL_VIEWPORT, &s->integers[s->count]), s->count += 4;
    glGetIntegerv(GL_SCISSOR_BOX, &s->integers[s->count]), s->count += 4;
    glGetIntegeri_v(GL_UNIFORM_BUFFER_BINDING, 0, &s->integers[s->count++]);
    GLint active = 0;
    glGetIntegerv(GL_ACTIVE_TEXTURE, &active);
    for (GLuint unit = 0; unit < 17; unit++) {
        glActiveTexture(GL_TEXTURE0 + unit);
        glGetIntegerv(GL_TEXTURE_BINDING_2D, &s->integers[s->count++]);
        glGetIntegerv(GL_SAMPLER_BINDING, &s->integers[s->count++]);
    }
    glActiveTexture((GLenum)active);
    glGetFloatv(GL_COLOR_CLEAR_VALUE, s->floats);
    glGetFloatv(GL_DEPTH_CLEAR_VALUE, s->floats + 4);
    glGetFloatv(GL_DEPTH_RANGE, s->floats + 5);
    for (size_t i = 0; i < sizeof switches / sizeof switches[0] - es; i++)
        s->switches[s->switch_count++] = glIsEnabled(switches[i]);
    glGetBooleanv(GL_COLOR_WRITEMASK, s->switches + s->switch_count);
}

static void disturb(const gl_caps *caps) {
    gl_texture t;
    const gl_texture *color = &t;
    gl_target target;
    gl_program program;
    const gl_texture_desc d = {.format = GL_FMT_RGBA16F, .width = W, .height = H, .filter = GL_FILTER_MIPMAP};
    assert_int_equal(bolan_gl_texture_create(&d, &t), BOLAN_OK);
    assert_int_equal(bolan_gl_target_create(&color, 1, NULL, -1, 0, &target), BOLAN_OK);
    assert_int_equal(bolan_gl_program_create("depth_copy", NULL, &program), BOLAN_OK);
    if (caps->clip_control) bolan_gl_set_clip_zero_to_one(true);
    bolan_gl_target_bind(&target);
    bolan_gl_target_clear_color(1, 2, 3, 4);
    const gl_state drawing = {.color_write = true, .blend = GL_BLEND_ADD, .cull_back = true};
    bolan_gl_set_state(&drawing);
    bolan_gl_set_framebuffer_srgb(true);
    bolan_gl_texture_bind(&t, 0);
    bolan_gl_texture_bind(&t, 9);
    bolan_gl_program_use(&program);
    bolan_gl_draw_fullscreen();
    gl_buffer buffer;
    assert_int_equal(bolan_gl_buffer_create(GL_BUFFER_UNIFORM, GL_USAGE_STREAM, 256, NULL, &buffer), BOLAN_OK);
    bolan_gl_buffer_bind_uniform(&buffer, 0);
    bolan_gl_buffer_free(&buffer);
    bolan_gl_program_free(&program);
    bolan_gl_target_free(&target);
    bolan_gl_texture_free(&t);
}

static void the_callers_state_is_left_as_it_was(void **state) {
    (void)state;
    const gl_caps caps = bolan_gl_get_caps();
    GLuint names[6];
    glGenTextures(2, names);
    glGenBuffers(2, names + 2);
    glGenSamplers(1, names + 4);
    glGenVertexArrays(1, names + 5);
    glActiveTexture(GL_TEXTURE0 + 9), glBindTexture(GL_TEXTURE_2D, names[0]), glBindSampler(9, names[4]);
    glActiveTexture(GL_TEXTURE0 + 3), glBindTexture(GL_TEXTURE_2D, names[1]);
    glBindVertexArray(names[5]);
    glBindBuffer(GL_ARRAY_BUFFER, names[2]);
    glBindBuffer(GL_UNIFORM_BUFFER, names[3]);
    glBufferData(GL_UNIFORM_BUFFER, 1024, NULL, GL_STATIC_DRAW);
    glBindBufferRange(GL_UNIFORM_BUFFER, 0, names[3], 256, 512);
    glViewport(1, 2, 3, 4), glScissor(5, 6, 7, 8), glEnable(GL_SCISSOR_TEST), glEnable(GL_BLEND),
        glEnable(GL_STENCIL_TEST);
    glBlendFuncSeparate(GL_DST_COLOR, GL_ONE, GL_ZERO, GL_SRC_ALPHA), glBlendEquation(GL_MAX);
    glCullFace(GL_FRONT), glFrontFace(GL_CW), glDepthFunc(GL_NOTEQUAL), glDepthMask(GL_FALSE);
    glColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_FALSE), glDepthRangef(0.25f, 0.75f), glClearDepthf(0.5f);
    glClearColor(0.1f, 0.2f, 0.3f, 0.4f), glPixelStorei(GL_UNPACK_ALIGNMENT, 2),
        glPixelStorei(GL_UNPACK_ROW_LENGTH, 99);
    snapshot before, after;
    take(&before, caps.es);
    gl_saved saved;
    bolan_gl_save(&saved, &caps, false);
    disturb(&caps);
    bolan_gl_restore(&saved);
    take(&after, caps.es);
    assert_memory_equal(&before, &after, sizeof before);
    GLint64 start = 0;
    glGetInteger64i_v(GL_UNIFORM_BUFFER_START, 0, &start);
    assert_int_equal(start, 256);
    if (caps.clip_control) {
        GLint mode = 0;
        glGetIntegerv(GL_CLIP_DEPTH_MODE, &mode);
        assert_int_equal(mode, GL_NEGATIVE_ONE_TO_ONE);
    }
    assert_true(watch_is_clean("state test"));
}

// ---- programs -----------------------------------------------------------------------------------------------------

static char last_sentence[1024];
static void keep_sentence(void *user, bolan_log_level level, bolan_log_id id, const char *sentence) {
    (void)user, (void)level;
    if (id == BOLAN_LOG_GL_SHADER && !last_sentence[0]) snprintf(last_sentence, sizeof last_sentence, "%s", sentence);
}

static void write_file(const char *folder, const char *name, const char *text) {
    char path[512];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *f = fopen(path, "wb");
    assert_non_null(f);
    fputs(text, f);
    fclose(f);
}

static bolan_result build_from(const char *folder, const char *stem, const char *defines, gl_program *p) {
    const bolan_hooks hooks = {.log = keep_sentence};
    last_sentence[0] = '\0';
    bolan_gl_program_set_directory(folder);
    bolan_set_hooks(&hooks);
    const bolan_result result = bolan_gl_program_create(stem, defines, p);
    bolan_set_hooks(NULL);
    bolan_gl_program_set_directory(NULL);
    return result;
}

static void a_shader_error_names_the_included_file_and_its_line(void **state) {
    (void)state;
    char folder[] = "shaders_XXXXXX";
    assert_non_null(mkdtemp(folder));
    write_file(folder, "a.glsl",
               "#include \"b.glsl\"\n#ifdef VERTEX\nvoid main() { gl_Position = vec4(0.0); }\n#endif\n"
               "#ifdef FRAGMENT\nout vec4 c;\nvoid main() { c = vec4(VALUE); }\n#endif\n");
    write_file(folder, "b.glsl", "// one\n// two\nfloat f() { return nonsense; }\n");
    write_file(folder, "c.glsl", "// one\n#include \"missing.glsl\"\n");
    gl_program p;
    assert_int_equal(build_from(folder, "a", "VALUE 0.5\n", &p), BOLAN_ERROR_GL);
    assert_non_null(strstr(last_sentence, "b.glsl:3: "));
    assert_int_equal(build_from(folder, "c", NULL, &p), BOLAN_ERROR_GL);
    assert_non_null(strstr(last_sentence, "c.glsl:2: "));
    assert_non_null(strstr(last_sentence, "missing.glsl"));
    write_file(folder, "b.glsl", "float f() { return 1.0; }\n");
    assert_int_equal(build_from(folder, "a", NULL, &p), BOLAN_ERROR_GL); // VALUE is not defined now, on line 7
    assert_non_null(strstr(last_sentence, "a.glsl:7: "));
    assert_int_equal(build_from(folder, "a", "VALUE 0.5\n", &p), BOLAN_OK);
    // A reload that fails keeps the old program.
    const uint32_t id = p.id;
    write_file(folder, "b.glsl", "broken\n");
    const bolan_hooks hooks = {.log = keep_sentence};
    bolan_gl_program_set_directory(folder);
    bolan_set_hooks(&hooks);
    assert_int_equal(bolan_gl_program_reload(&p), BOLAN_ERROR_GL);
    bolan_set_hooks(NULL);
    bolan_gl_program_set_directory(NULL);
    assert_int_equal(p.id, id);
    bolan_gl_program_free(&p);
    char command[64];
    snprintf(command, sizeof command, "rm -r %s", folder);
    assert_int_equal(system(command), 0);
}

// Two pixels, black and white, shown in eight: the middle four lie between them, at 1/8, 3/8, 5/8, 7/8.
static void an_image_is_enlarged_linearly(void **state) {
    (void)state;
    static const uint8_t colors[2][4] = {{0, 0, 0, 255}, {255, 255, 255, 255}};
    static const float expected[8] = {0.0f, 0.0f, 0.125f, 0.375f, 0.625f, 0.875f, 1.0f, 1.0f};
    float shown[8][4];
    gl_texture small, large;
    gl_target from, to;
    const gl_texture *color[] = {&small, &large};
    const gl_texture_desc d = {.format = GL_FMT_RGBA8, .width = 2, .height = 1},
                          e = {.format = GL_FMT_RGBA32F, .width = 8, .height = 1};
    assert_int_equal(bolan_gl_texture_create(&d, &small), BOLAN_OK);
    assert_int_equal(bolan_gl_texture_create(&e, &large), BOLAN_OK);
    bolan_gl_texture_upload(&small, 0, -1, colors, false);
    assert_int_equal(bolan_gl_target_create(&color[0], 1, NULL, -1, 0, &from), BOLAN_OK);
    assert_int_equal(bolan_gl_target_create(&color[1], 1, NULL, -1, 0, &to), BOLAN_OK);
    bolan_gl_target_show(&from, to.id, 8, 1);
    bolan_gl_target_read_float(&to, 0, shown[0]);
    for (int i = 0; i < 8; i++) assert_near(shown[i][0], expected[i], 1.0 / 128); // hardware filters with 8 bits
    bolan_gl_target_free(&from);
    bolan_gl_target_free(&to);
    bolan_gl_texture_free(&small);
    bolan_gl_texture_free(&large);
}

static void without_a_context_the_information_is_empty(void **state) {
    (void)state;
    const bolan_gl_info info = bolan_gl_get_info();
    assert_string_equal(info.version, "");
}

static void the_context_is_what_was_asked_for(void **state) {
    (void)state;
    const bolan_gl_info info = bolan_gl_get_info();
    assert_int_equal(bolan_gl_get_caps().es, strstr(info.version, "OpenGL ES") != NULL);
    assert_true(strlen(info.renderer) > 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(without_a_context_the_information_is_empty),
        IN_BOTH_APIS(the_context_is_what_was_asked_for),
        IN_BOTH_APIS(every_colour_format_survives_upload_and_read_back),
        IN_BOTH_APIS(halfs_are_uploaded_as_they_are),
        IN_BOTH_APIS(layers_of_an_array_are_separate_targets),
        IN_BOTH_APIS(depth_reads_back_exactly),
        IN_BOTH_APIS(an_image_is_enlarged_linearly),
        IN_BOTH_APIS(the_callers_state_is_left_as_it_was),
        IN_BOTH_APIS(a_shader_error_names_the_included_file_and_its_line),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

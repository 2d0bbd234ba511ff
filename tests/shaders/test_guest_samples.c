// SPDX-License-Identifier: MIT
// The water in a multisampled framebuffer and under a host's stencil. Each sample has its own test against the host's
// depth; the water has one colour a pixel. Against a composite by hand: coverage times object plus the rest of water.
#include "gl_support.h"

#include <epoxy/gl.h>
#include <string.h>

enum { WIDTH = 96, HEIGHT = 64, PIXELS = WIDTH * HEIGHT, SAMPLES = 4 };

typedef struct bytes {
    uint8_t rgb[PIXELS][3]; // top row first
} bytes;

// ---- the host -------------------------------------------------------------------------------------------------------

// A framebuffer of renderbuffers, or with `textures` of multisampled textures, and one that it is resolved into.
typedef struct host_frame {
    GLuint many, one, color, depth, resolved, plain_depth, program, vertices;
    bool textures;
} host_frame;

static GLuint renderbuffer(GLenum format, GLsizei samples) {
    GLuint name;
    glGenRenderbuffers(1, &name);
    glBindRenderbuffer(GL_RENDERBUFFER, name);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, WIDTH, HEIGHT);
    return name;
}

static GLuint samples_texture(GLenum format) {
    GLuint name;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, name);
    glTexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, SAMPLES, format, WIDTH, HEIGHT, GL_TRUE);
    glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, 0);
    return name;
}

// One triangle of one colour; its corners are set by the test.
static GLuint triangle_program(void) {
    const char *head = epoxy_is_desktop_gl() ? "#version 330\n" : "#version 300 es\nprecision highp float;\n";
    const char *vertex = "uniform vec3 corner[3];\nvoid main() { gl_Position = vec4(corner[gl_VertexID], 1.0); }";
    const char *fragment = "uniform vec3 tint;\nout vec4 c;\nvoid main() { c = vec4(tint, 1.0); }";
    const GLuint program = glCreateProgram();
    for (int i = 0; i < 2; i++) {
        const char *parts[] = {head, i == 0 ? vertex : fragment};
        const GLuint shader = glCreateShader(i == 0 ? GL_VERTEX_SHADER : GL_FRAGMENT_SHADER);
        glShaderSource(shader, 2, parts, NULL);
        glCompileShader(shader);
        glAttachShader(program, shader);
        glDeleteShader(shader);
    }
    glLinkProgram(program);
    GLint linked = GL_FALSE;
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    assert_true(linked);
    return program;
}

static void open_host(host_frame *h, GLsizei samples, bool textures) {
    memset(h, 0, sizeof *h);
    h->textures = textures;
    h->program = triangle_program();
    glGenVertexArrays(1, &h->vertices);
    glGenFramebuffers(1, &h->many);
    glGenFramebuffers(1, &h->one);
    h->resolved = renderbuffer(GL_RGBA8, 0);
    glBindFramebuffer(GL_FRAMEBUFFER, h->one);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, h->resolved);
    glBindFramebuffer(GL_FRAMEBUFFER, h->many);
    h->color = textures ? samples_texture(GL_RGBA8) : renderbuffer(GL_RGBA8, samples);
    h->depth = textures ? samples_texture(GL_DEPTH_COMPONENT32F) : renderbuffer(GL_DEPTH32F_STENCIL8, samples);
    if (textures) {
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D_MULTISAMPLE, h->color, 0);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D_MULTISAMPLE, h->depth, 0);
    } else {
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, h->color);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, h->depth);
    }
    assert_int_equal(glCheckFramebufferStatus(GL_FRAMEBUFFER), GL_FRAMEBUFFER_COMPLETE);
}

static void close_host(host_frame *h) {
    const GLuint framebuffers[] = {h->many, h->one};
    glDeleteFramebuffers(2, framebuffers);
    glDeleteRenderbuffers(1, &h->resolved);
    if (h->textures) {
        glDeleteTextures(1, &h->color);
        glDeleteTextures(1, &h->depth);
    } else {
        glDeleteRenderbuffers(1, &h->color);
        glDeleteRenderbuffers(1, &h->depth);
    }
    glDeleteProgram(h->program);
    glDeleteVertexArrays(1, &h->vertices);
}

static void clear(const host_frame *h, float r, float g, float b) {
    glBindFramebuffer(GL_FRAMEBUFFER, h->many);
    glClearColor(r, g, b, 1.0f);
    glClearDepthf(0.0f); // reversed: far
    glClearStencil(5);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | (h->textures ? 0 : GL_STENCIL_BUFFER_BIT));
}

// A slanted edge across the water: left of it stands a wall near the eye.
static void draw_wall(const host_frame *h, float r, float g, float b) {
    static const float corners[] = {-3.0f, -1.7f, 0.6f, 0.5f, -1.3f, 0.6f, -0.6f, 3.0f, 0.6f};
    glBindFramebuffer(GL_FRAMEBUFFER, h->many);
    glViewport(0, 0, WIDTH, HEIGHT);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GEQUAL);
    glUseProgram(h->program);
    glBindVertexArray(h->vertices);
    glUniform3fv(glGetUniformLocation(h->program, "corner"), 3, corners);
    glUniform3f(glGetUniformLocation(h->program, "tint"), r, g, b);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_DEPTH_TEST);
}

static void resolve(const host_frame *h, bytes *out) {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, h->many);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, h->one);
    glBlitFramebuffer(0, 0, WIDTH, HEIGHT, 0, 0, WIDTH, HEIGHT, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    read_bytes(h->one, WIDTH, HEIGHT, out->rgb[0]);
}

// ---- a rig ----------------------------------------------------------------------------------------------------------

typedef struct rig {
    bolan_sea *sea;
    bolan_renderer *renderer;
    bolan_water water;
    bolan_lighting lighting;
    bolan_view view;
} rig;

static void open_rig(rig *r) {
    memset(r, 0, sizeof *r);
    r->sea = small_sea(bolan_sea_state_from_wind(8.0, 270.0, 100e3));
    bolan_renderer_desc desc = bolan_renderer_desc_default();
    assert_int_equal(bolan_renderer_create(&desc, &r->renderer), BOLAN_OK);
    r->water = bolan_water_default();
    r->water.sea = r->sea;
    r->lighting = bolan_lighting_default();
    r->view = bolan_view_default();
    r->view.eye = (bolan_dvec3){100.0, -200.0, 6.0};
    r->view.view = bolan_m4_view(20.0, -20.0, 0.0);
    r->view.projection = bolan_m4_projection(bolan_radians(50.0), (double)WIDTH / HEIGHT, 0.1, 0);
    r->view.zero_to_one = false;
    r->view.width = WIDTH;
    r->view.height = HEIGHT;
}

static void close_rig(rig *r) {
    bolan_renderer_destroy(&r->renderer);
    bolan_sea_destroy(&r->sea);
}

static void draw_water(rig *r, const host_frame *h, const bolan_host *host) {
    r->view.framebuffer = h->many;
    bolan_renderer_prepare(r->renderer, &r->water, &r->lighting);
    bolan_renderer_draw_water(r->renderer, &r->view, host);
}

// ---- tests ----------------------------------------------------------------------------------------------------------

static bytes coverage, alone, got;

// How much of each pixel the wall covers, and the water without it.
static void measure(rig *r, const host_frame *h) {
    clear(h, 0.0f, 0.0f, 0.0f);
    draw_wall(h, 1.0f, 1.0f, 1.0f);
    resolve(h, &coverage);
    clear(h, 1.0f, 0.0f, 1.0f);
    draw_water(r, h, NULL);
    resolve(h, &alone);
}

// Without textures: the depth of the framebuffer decides for each sample.
static void samples_are_a_composite_by_hand(void **state) {
    (void)state;
    rig r;
    host_frame h;
    open_rig(&r);
    open_host(&h, SAMPLES, false);
    measure(&r, &h);
    clear(&h, 1.0f, 0.0f, 1.0f);
    draw_wall(&h, 0.2f, 0.8f, 0.4f);
    draw_water(&r, &h, NULL);
    resolve(&h, &got);
    int partly = 0;
    for (int i = 0; i < PIXELS; i++) {
        const double share = coverage.rgb[i][0] / 255.0, wall[3] = {51.0, 204.0, 102.0};
        partly += share > 0.0 && share < 1.0;
        for (int c = 0; c < 3; c++)
            assert_near(got.rgb[i][c], share * wall[c] + (1.0 - share) * alone.rgb[i][c], 1.01);
    }
    assert_true(partly > 20);
    close_host(&h);
    close_rig(&r);
}

// A pixel of one sample and of four: the same water where no edge is.
static void one_sample_and_four_show_the_same_water(void **state) {
    (void)state;
    static bytes single;
    rig r;
    host_frame h;
    open_rig(&r);
    open_host(&h, 0, false);
    clear(&h, 1.0f, 0.0f, 1.0f);
    draw_water(&r, &h, NULL);
    resolve(&h, &single);
    close_host(&h);
    open_host(&h, SAMPLES, false);
    clear(&h, 1.0f, 0.0f, 1.0f);
    draw_water(&r, &h, NULL);
    resolve(&h, &got);
    assert_memory_equal(got.rgb, single.rgb, sizeof got.rgb);
    close_host(&h);
    close_rig(&r);
}

// With the scene as multisampled textures no sample at an edge shows what stood there before: here a glaring magenta,
// which no water reflects, for where there is nothing there is no scene.
static void multisampled_textures_leave_no_rim(void **state) {
    (void)state;
    rig r;
    host_frame h;
    open_rig(&r);
    open_host(&h, SAMPLES, true);
    measure(&r, &h);
    clear(&h, 1.0f, 0.0f, 1.0f);
    draw_wall(&h, 0.0f, 0.0f, 0.0f);
    const bolan_host host = {.color = h.color, .depth = h.depth, .samples = SAMPLES};
    draw_water(&r, &h, &host);
    resolve(&h, &got);
    int edges = 0, rims = 0;
    for (int i = 0; i < PIXELS; i++) {
        if (coverage.rgb[i][0] == 0 || coverage.rgb[i][0] == 255 || alone.rgb[i][0] == 255) continue;
        edges++;
        rims += got.rgb[i][0] > alone.rgb[i][0] + 20;
    }
    assert_true(edges > 20);
    assert_int_equal(rims, 0);
    close_host(&h);
    close_rig(&r);
}

static void no_water_where_the_stencil_says_so(void **state) {
    (void)state;
    rig r;
    host_frame h;
    open_rig(&r);
    open_host(&h, 0, false);
    measure(&r, &h);
    glBindFramebuffer(GL_FRAMEBUFFER, h.many);
    clear(&h, 1.0f, 0.0f, 1.0f);
    glEnable(GL_SCISSOR_TEST);
    glScissor(10, 0, 40, HEIGHT);
    glClearStencil(0x13);
    glClear(GL_STENCIL_BUFFER_BIT);
    glDisable(GL_SCISSOR_TEST);
    glStencilFuncSeparate(GL_FRONT, GL_LESS, 7, 0x1f), glStencilFuncSeparate(GL_BACK, GL_GREATER, 9, 0x2f);
    glStencilOpSeparate(GL_BACK, GL_INVERT, GL_INCR, GL_ZERO);
    const bolan_host host = {.stencil = 0x3, .stencil_mask = 0xf}; // of 0x13; elsewhere 5
    draw_water(&r, &h, &host);
    resolve(&h, &got);
    for (int i = 0; i < PIXELS; i++) {
        const bool kept_out = i % WIDTH >= 10 && i % WIDTH < 50;
        for (int c = 0; c < 3; c++) assert_int_equal(got.rgb[i][c], kept_out ? (c == 1 ? 0 : 255) : alone.rgb[i][c]);
    }
    static const struct {
        GLenum name;
        GLint value;
    } kept[] = {{GL_STENCIL_FUNC, GL_LESS},         {GL_STENCIL_REF, 7},           {GL_STENCIL_VALUE_MASK, 0x1f},
                {GL_STENCIL_BACK_FUNC, GL_GREATER}, {GL_STENCIL_BACK_REF, 9},      {GL_STENCIL_BACK_VALUE_MASK, 0x2f},
                {GL_STENCIL_FAIL, GL_KEEP},         {GL_STENCIL_BACK_FAIL, GL_INVERT},
                {GL_STENCIL_TEST, GL_FALSE},        {GL_STENCIL_BACK_PASS_DEPTH_FAIL, GL_INCR},
                {GL_STENCIL_BACK_PASS_DEPTH_PASS, GL_ZERO}};
    glBindFramebuffer(GL_FRAMEBUFFER, h.many); // OpenGL clamps the reference to the bits of what is bound
    for (size_t i = 0; i < sizeof kept / sizeof *kept; i++) {
        GLint value = -1;
        glGetIntegerv(kept[i].name, &value);
        if (value != kept[i].value) fail_msg("state 0x%x is 0x%x, not 0x%x", kept[i].name, value, kept[i].value);
    }
    close_host(&h);
    close_rig(&r);
}

// ---- refusals -------------------------------------------------------------------------------------------------------

static char sentence[256];

static void note(void *user, bolan_log_level level, bolan_log_id id, const char *text) {
    (void)user, (void)level;
    if (id == BOLAN_LOG_GUEST_FRAME) snprintf(sentence, sizeof sentence, "%s", text);
}

static void expect(rig *r, const host_frame *h, const bolan_host *host, const char *words) {
    sentence[0] = '\0';
    clear(h, 1.0f, 0.0f, 1.0f);
    draw_water(r, h, host);
    if (strstr(sentence, words) == NULL) fail_msg("'%s', not '%s'", sentence, words);
    resolve(h, &got);
    for (int i = 0; i < PIXELS; i++) assert_true(got.rgb[i][0] == 255 && got.rgb[i][1] == 0);
}

static void what_is_not_supported_is_refused(void **state) {
    (void)state;
    rig r;
    host_frame h;
    open_rig(&r);
    bolan_set_hooks(&(bolan_hooks){.log = note});
    const bool es = !epoxy_is_desktop_gl();
    open_host(&h, SAMPLES, !es);
    GLuint flat;
    glGenTextures(1, &flat);
    glBindTexture(GL_TEXTURE_2D, flat);
    const bolan_host several = {.color = flat, .depth = flat, .samples = SAMPLES};
    expect(&r, &h, &several, es ? "OpenGL ES 3.0 has no multisampled textures" : "color is no multisampled 2D texture");
    if (!es) {
        const bolan_host single = {.color = h.color, .depth = h.depth};
        expect(&r, &h, &single, "color is no 2D texture of this context, and samples is not above 1");
        const bolan_host stencil = {.stencil_mask = 1};
        expect(&r, &h, &stencil, "the view's framebuffer has no stencil");
    }
    glDeleteTextures(1, &flat);
    close_host(&h);
    close_rig(&r);
    bolan_set_hooks(NULL);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        IN_BOTH_APIS(samples_are_a_composite_by_hand), IN_BOTH_APIS(one_sample_and_four_show_the_same_water),
        cmocka_unit_test_setup_teardown(multisampled_textures_leave_no_rim, gl_setup_core, gl_teardown),
        IN_BOTH_APIS(no_water_where_the_stencil_says_so), IN_BOTH_APIS(what_is_not_supported_is_refused)};
    return cmocka_run_group_tests_name("samples and stencil of a host's frame", tests, NULL, NULL);
}

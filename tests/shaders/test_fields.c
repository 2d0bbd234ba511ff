// SPDX-License-Identifier: MIT
// shaders/include/bolan_fields.glsl in a program of a host's, against its twins on the CPU: bolan_sea_sample_rest(),
// bolan_sea_sample_grid() and bolan_query_surface(), for each wave model.
#include "gl_support.h"

#include "bolan/coast.h"
#include "bolan/query.h"

#include <epoxy/gl.h>
#include <stdio.h>
#include <string.h>

enum { POINTS = 256, OUTPUTS = 3, UNIT = 7, SLOT = 3 };

// ---- the host -------------------------------------------------------------------------------------------------------

// As a host would write it: points come in as a texture, what is asked of the sea goes out as three.
static const char host_body[] = "uniform highp sampler2D points;\n"
                                "uniform int question;\n"
                                "layout(location = 0) out vec4 out0;\n"
                                "layout(location = 1) out vec4 out1;\n"
                                "layout(location = 2) out vec4 out2;\n"
                                "void main() {\n"
                                "    vec4 p = texelFetch(points, ivec2(gl_FragCoord.xy), 0);\n"
                                "    bolan_fields f;\n"
                                "    if (question == 0) f = bolan_fields_at_rest(p.xy, p.z);\n"
                                "    else if (question == 1) f = bolan_fields_at(p.xy, p.z);\n"
                                "    else f = bolan_fields_on_grid(p.xy, p.z, p.w);\n"
                                "    out0 = vec4(f.displacement, bolan_water_level);\n"
                                "    out1 = vec4(f.slope, f.jacobian, f.foam);\n"
                                "    out2 = vec4(f.normal, bolan_height_at(p.xy, p.z));\n"
                                "}\n";
static const char host_vertex[] =
    "void main() {\n"
    "    gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, "
    "0.0, 1.0);\n"
    "}\n";

static GLuint compile(GLenum type, const char *const *parts, GLsizei count) {
    GLuint shader = glCreateShader(type);
    GLint ok = 0;
    char log[1024] = "";
    glShaderSource(shader, count, parts, NULL);
    glCompileShader(shader);
    glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
    glGetShaderInfoLog(shader, sizeof log, NULL, log);
    if (!ok) fail_msg("%s", log);
    return shader;
}

static GLuint host_program(const char *include, const char *body) {
    const char *version = epoxy_is_desktop_gl() ? "#version 330 core\n" : "#version 300 es\n";
    const char *vertex[] = {version, host_vertex}, *fragment[] = {version, include, body};
    GLuint v = compile(GL_VERTEX_SHADER, vertex, 2), f = compile(GL_FRAGMENT_SHADER, fragment, 3);
    GLuint program = glCreateProgram();
    GLint ok = 0;
    glAttachShader(program, v);
    glAttachShader(program, f);
    glLinkProgram(program);
    glGetProgramiv(program, GL_LINK_STATUS, &ok);
    assert_true(ok);
    glDeleteShader(v);
    glDeleteShader(f);
    return program;
}

typedef struct host {
    bolan_context *context;
    bolan_renderer *renderer;
    GLuint program, vertex_array, points, framebuffer, outputs[OUTPUTS];
} host;

static GLuint float_texture(void) {
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, POINTS, 1, 0, GL_RGBA, GL_FLOAT, NULL);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return name;
}

// Made once for all tests of an API.
static int open_host(void **state, bolan_gl_api api, bolan_backend backend) {
    static host all;
    host *h = &all;
    memset(h, 0, sizeof *h);
    if (gl_setup((void **)&h->context, api) != 0) return -1;
    bolan_renderer_desc desc = bolan_renderer_desc_default();
    desc.quality = BOLAN_QUALITY_LOW;
    desc.backend = backend;
    assert_int_equal(bolan_renderer_create(&desc, &h->renderer), BOLAN_OK);
    h->program = host_program(bolan_fields_glsl(), host_body);
    assert_int_equal(bolan_renderer_link_fields(h->renderer, h->program, UNIT, SLOT), BOLAN_OK);
    const GLenum buffers[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1, GL_COLOR_ATTACHMENT2};
    glGenVertexArrays(1, &h->vertex_array);
    glGenFramebuffers(1, &h->framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, h->framebuffer);
    for (int i = 0; i < OUTPUTS; i++) {
        h->outputs[i] = float_texture();
        glFramebufferTexture2D(GL_FRAMEBUFFER, buffers[i], GL_TEXTURE_2D, h->outputs[i], 0);
    }
    glDrawBuffers(OUTPUTS, buffers);
    assert_int_equal(glCheckFramebufferStatus(GL_FRAMEBUFFER), GL_FRAMEBUFFER_COMPLETE);
    h->points = float_texture();
    *state = h;
    return 0;
}

static int open_core(void **state) { return open_host(state, BOLAN_GL_CORE, BOLAN_BACKEND_CPU); }
static int open_es(void **state) { return open_host(state, BOLAN_GL_ES, BOLAN_BACKEND_CPU); }
static int open_compute(void **state) { return open_host(state, BOLAN_GL_CORE, BOLAN_BACKEND_COMPUTE); }

static bool has_compute(void) {
    bolan_context *context = NULL;
    const bool has = bolan_context_create(BOLAN_GL_CORE, &context) == BOLAN_OK && bolan_gl_get_info().compute;
    bolan_context_destroy(&context);
    return has;
}

static int close_host(void **state) {
    host *h = *state;
    glDeleteProgram(h->program);
    glDeleteTextures(OUTPUTS, h->outputs);
    glDeleteTextures(1, &h->points);
    glDeleteFramebuffers(1, &h->framebuffer);
    glDeleteVertexArrays(1, &h->vertex_array);
    bolan_renderer_destroy(&h->renderer);
    return gl_teardown((void **)&h->context);
}

static int end(void **state) {
    (void)state;
    return watch_is_clean("at the end of the test") ? 0 : -1;
}

typedef struct answer {
    float displacement[3], level, slope[2], jacobian, foam, normal[3], height;
} answer;

static void ask(const host *h, int question, float (*points)[4], answer *out) {
    static float read[OUTPUTS][POINTS][4];
    glBindFramebuffer(GL_FRAMEBUFFER, h->framebuffer);
    glViewport(0, 0, POINTS, 1);
    glBindVertexArray(h->vertex_array);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, h->points);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, POINTS, 1, GL_RGBA, GL_FLOAT, points);
    glUseProgram(h->program);
    glUniform1i(glGetUniformLocation(h->program, "points"), 0);
    glUniform1i(glGetUniformLocation(h->program, "question"), question);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    for (int i = 0; i < OUTPUTS; i++) {
        glReadBuffer((GLenum)(GL_COLOR_ATTACHMENT0 + i));
        glReadPixels(0, 0, POINTS, 1, GL_RGBA, GL_FLOAT, read[i]);
    }
    for (int i = 0; i < POINTS; i++) {
        memcpy(&out[i].displacement, read[0][i], sizeof read[0][i]);
        memcpy(&out[i].slope, read[1][i], sizeof read[1][i]);
        memcpy(&out[i].normal, read[2][i], sizeof read[2][i]);
    }
}

// ---- seas -----------------------------------------------------------------------------------------------------------

static bolan_sea *sea_with(bolan_wave_model model, uint32_t resolution, double choppiness, uint32_t order) {
    bolan_sea_desc desc = bolan_sea_desc_default();
    bolan_sea *sea = NULL;
    desc.waves = model;
    desc.resolution = resolution;
    desc.choppiness = choppiness;
    desc.order = order;
    desc.fft.cascade_count = 3;
    desc.textures.frames = 4;
    desc.seed = 7;
    desc.sea_state.current_x = -2.0, desc.sea_state.current_y = 1.25;
    assert_int_equal(bolan_sea_create(&desc, &sea), BOLAN_OK);
    bolan_sea_settle(sea, 12.5);
    return sea;
}

static bolan_sea *sea_of(bolan_wave_model model) { return sea_with(model, 64, 1.0, 1); }

// Every model, at every order that it has.
static const struct {
    bolan_wave_model model;
    uint32_t order;
} seas[] = {{BOLAN_WAVES_FFT, 1},        {BOLAN_WAVES_FFT, 2},      {BOLAN_WAVES_COSINES, 1},
            {BOLAN_WAVES_EXP_COSINE, 1}, {BOLAN_WAVES_TEXTURES, 1}, {BOLAN_WAVES_TEXTURES, 2}};
enum { SEAS = sizeof seas / sizeof *seas };

// Steeper than any wind makes it.
static bolan_sea *folded_sea(double choppiness) {
    bolan_sea_desc desc = bolan_sea_desc_default();
    bolan_sea *sea = NULL;
    desc.sea_state = bolan_sea_state_from_wind(20.0, 240.0, 300e3);
    desc.sea_state.systems[0].hs *= 1.6;
    desc.resolution = 128;
    desc.choppiness = choppiness;
    assert_int_equal(bolan_sea_create(&desc, &sea), BOLAN_OK);
    bolan_sea_step(sea, 12.5);
    return sea;
}

// Points round the origin, every fourth over shallow water; world and eye-relative.
static const bolan_dvec3 origin = {81234.5, -40321.25, 17.0};
static const double level = 3.5;

static void place_points(float (*points)[4], bolan_dvec2 *world, float depth) {
    for (int i = 0; i < POINTS; i++) {
        const double a = 2.399963 * i, r = 11.0 * sqrt(i);
        points[i][0] = (float)(r * cos(a));
        points[i][1] = (float)(r * sin(a));
        points[i][2] = depth;
        points[i][3] = 0.0f;
        world[i] = (bolan_dvec2){origin.x + (double)points[i][0], origin.y + (double)points[i][1]};
    }
}

// The fields come as halfs, 11 bits, and texture units weigh them with 8 bits: of a significant height, and of a slope.
#define HEIGHT_BOUND 2e-3
#define SLOPE_BOUND 4e-3

static void compare_rest(const answer *got, const bolan_sea_sample *want, double hs) {
    for (int i = 0; i < POINTS; i++) {
        assert_near(got[i].displacement[0], want[i].dx, HEIGHT_BOUND * hs);
        assert_near(got[i].displacement[1], want[i].dy, HEIGHT_BOUND * hs);
        assert_near(got[i].displacement[2], want[i].height, HEIGHT_BOUND * hs);
        assert_near(got[i].jacobian, want[i].jacobian, SLOPE_BOUND);
        assert_near(got[i].foam, want[i].foam, SLOPE_BOUND);
        // divided by the Jacobian, or by 0.1 in a fold
        const double steep = 1.0 + hypot((double)want[i].slope_x, (double)want[i].slope_y);
        const double bound = SLOPE_BOUND * steep / fmin(fmax(fabs((double)want[i].jacobian), 0.1), 0.5);
        assert_near(got[i].slope[0], want[i].slope_x, bound);
        assert_near(got[i].slope[1], want[i].slope_y, bound);
        assert_near(got[i].normal[0] + got[i].slope[0] * got[i].normal[2], 0.0, 1e-5);
        assert_near(got[i].normal[1] + got[i].slope[1] * got[i].normal[2], 0.0, 1e-5);
    }
}

static void every_model_equals_the_sample(void **state) {
    const host *h = *state;
    static float points[POINTS][4];
    static bolan_dvec2 world[POINTS];
    static bolan_sea_sample want[POINTS];
    static answer got[POINTS];
    for (int i = 0; i < SEAS; i++) {
        bolan_sea *sea = sea_with(seas[i].model, 64, 1.0, seas[i].order);
        place_points(points, world, 1e6f);
        bolan_sea_sample_rest(sea, world, POINTS, want);
        bolan_renderer_bind_fields(h->renderer, &(bolan_water){.sea = sea, .level = level}, origin, UNIT, SLOT);
        ask(h, 0, points, got);
        compare_rest(got, want, bolan_sea_get_summary(sea)->hs);
        assert_near(got[0].level, level - origin.z, 1e-5);
        bolan_sea_destroy(&sea);
    }
}

static void folded_water_equals_the_sample(void **state) {
    const host *h = *state;
    static float points[POINTS][4];
    static bolan_dvec2 world[POINTS];
    static bolan_sea_sample want[POINTS];
    static answer got[POINTS];
    bolan_sea *sea = folded_sea(2.0);
    int folding = 0;
    place_points(points, world, 1e6f);
    bolan_sea_sample_rest(sea, world, POINTS, want);
    bolan_renderer_bind_fields(h->renderer, &(bolan_water){.sea = sea, .level = level}, origin, UNIT, SLOT);
    ask(h, 0, points, got);
    compare_rest(got, want, bolan_sea_get_summary(sea)->hs);
    for (int i = 0; i < POINTS; i++) folding += fabsf(want[i].jacobian) < 0.25f;
    assert_true(folding > 3);
    bolan_sea_destroy(&sea);
}

// A bed of this depth everywhere.
static bolan_ground *flat_ground(float depth) {
    float elevation[16];
    bolan_ground_desc desc = bolan_ground_desc_default();
    bolan_ground *ground = NULL;
    for (int i = 0; i < 16; i++) elevation[i] = (float)level - depth;
    desc.field = (bolan_heightfield){.width = 4,
                                     .height = 4,
                                     .west = origin.x - 15e3,
                                     .south = origin.y - 15e3,
                                     .step_x = 1e4,
                                     .step_y = 1e4,
                                     .elevation = elevation};
    desc.detail = 0.0;
    assert_int_equal(bolan_ground_create(&desc, &ground), BOLAN_OK);
    return ground;
}

static void surface_equals_with(const host *h, const bolan_sea *sea, float depth, const bolan_wave_layer *const *layers,
                                uint32_t layer_count) {
    static float points[POINTS][4];
    static bolan_dvec2 world[POINTS];
    static bolan_query_point want[POINTS];
    static answer got[POINTS];
    const double hs = bolan_sea_get_summary(sea)->hs;
    bolan_ground *ground = depth < 1e5f ? flat_ground(depth) : NULL;
    place_points(points, world, depth);
    const bolan_water water = {
        .sea = sea, .ground = ground, .level = level, .layers = layers, .layer_count = layer_count};
    bolan_query_surface(&water, world, POINTS, want);
    bolan_renderer_bind_fields(h->renderer, &water, origin, UNIT, SLOT);
    ask(h, 1, points, got);
    int compared = 0;
    for (int i = 0; i < POINTS; i++) {
        if (want[i].jacobian < 0.3f) continue; // near a fold the query looks for the highest of several parcels
        compared++;
        assert_near(got[i].height + origin.z, want[i].height, HEIGHT_BOUND * hs);
        assert_near(got[i].displacement[2] + level, want[i].height, HEIGHT_BOUND * hs);
        assert_near(got[i].jacobian, want[i].jacobian, 3.0 * SLOPE_BOUND);
        assert_near(got[i].normal[0], want[i].normal.x, 3.0 * SLOPE_BOUND);
        assert_near(got[i].normal[1], want[i].normal.y, 3.0 * SLOPE_BOUND);
    }
    assert_true(compared > POINTS * 9 / 10);
    bolan_ground_destroy(&ground);
}

static void surface_equals(const host *h, const bolan_sea *sea, float depth) {
    surface_equals_with(h, sea, depth, NULL, 0);
}

// Two trains across each other, the edges of one among the points.
static void wave_trains_are_added(void **state) {
    const host *h = *state;
    bolan_wave_train_desc desc = bolan_wave_train_desc_default();
    bolan_wave_layer *layers[2] = {NULL};
    bolan_sea *sea = sea_of(BOLAN_WAVES_FFT);
    desc.from_deg = 200.0;
    desc.length = 60.0;
    desc.height = 2.0;
    desc.phase_deg = 70.0;
    desc.centre = (bolan_dvec2){origin.x + 20.0, origin.y - 10.0};
    desc.half_length = 150.0;
    desc.half_width = 80.0;
    assert_int_equal(bolan_wave_layer_create_train(&desc, &layers[0]), BOLAN_OK);
    desc = bolan_wave_train_desc_default();
    desc.from_deg = 80.0;
    desc.height = 1.5;
    assert_int_equal(bolan_wave_layer_create_train(&desc, &layers[1]), BOLAN_OK);
    const bolan_wave_layer *const both[] = {layers[0], layers[1]};
    surface_equals_with(h, sea, 1e6f, both, 2);
    surface_equals_with(h, sea, 4.0f, both, 2);
    bolan_sea_destroy(&sea);
    for (int i = 0; i < 2; i++) bolan_wave_layer_destroy(&layers[i]);
}

static void every_model_equals_the_query_in_deep_and_shallow_water(void **state) {
    const host *h = *state;
    for (int i = 0; i < SEAS; i++) {
        bolan_sea *sea = sea_with(seas[i].model, 64, 1.0, seas[i].order);
        surface_equals(h, sea, 1e6f);
        surface_equals(h, sea, 2.0f);
        bolan_sea_destroy(&sea);
    }
}

// A mesh that cannot carry the short waves loses them, as bolan_sea_sample_grid() says, and never gains.
static void grid_fades_like_the_twin(void **state) {
    const host *h = *state;
    static float points[POINTS][4], spacing[POINTS];
    static bolan_dvec2 world[POINTS];
    static bolan_sea_sample want[POINTS];
    static answer got[POINTS];
    bolan_sea *sea = sea_of(BOLAN_WAVES_COSINES);
    place_points(points, world, 1e6f);
    for (int i = 0; i < POINTS; i++) points[i][3] = spacing[i] = 0.5f + 0.25f * (float)(i % 64);
    bolan_sea_sample_grid(sea, world, spacing, POINTS, want);
    bolan_renderer_bind_fields(h->renderer, &(bolan_water){.sea = sea, .level = level}, origin, UNIT, SLOT);
    ask(h, 2, points, got);
    for (int i = 0; i < POINTS; i++)
        assert_near(got[i].displacement[2], want[i].height, HEIGHT_BOUND * bolan_sea_get_summary(sea)->hs);
    bolan_sea_destroy(&sea);
}

// Mean square of the slopes on a grid; of the twin where h is NULL.
static double slopes_on_grid(const host *h, const bolan_sea *sea, double grid) {
    static float points[POINTS][4], spacing[POINTS];
    static bolan_dvec2 world[POINTS];
    static bolan_sea_sample twin[POINTS];
    static answer got[POINTS];
    double sum = 0.0;
    place_points(points, world, 1e6f);
    for (int i = 0; i < POINTS; i++) points[i][3] = spacing[i] = (float)grid;
    if (h)
        ask(h, 2, points, got);
    else
        bolan_sea_sample_grid(sea, world, spacing, POINTS, twin);
    for (int i = 0; i < POINTS; i++)
        sum += h ? pow((double)got[i].slope[0], 2.0) + pow((double)got[i].slope[1], 2.0)
                 : pow((double)twin[i].slope_x, 2.0) + pow((double)twin[i].slope_y, 2.0);
    return sum;
}

// The twin averages over a square of two spacings. A level of the textures half an octave below the spacing is an
// average over 1 / sqrt 2 of one, as the twin's over a grid 2 sqrt 2 times as fine, and linear interpolation takes a
// little more.
static void a_grid_of_cascades_loses_what_the_twin_loses(void **state) {
    const host *h = *state;
    bolan_sea *sea = sea_of(BOLAN_WAVES_FFT);
    bolan_renderer_bind_fields(h->renderer, &(bolan_water){.sea = sea, .level = level}, origin, UNIT, SLOT);
    double previous = slopes_on_grid(NULL, sea, 0.0);
    for (double grid = 0.5; grid < 30.0; grid *= 2.0) {
        const double ours = slopes_on_grid(h, sea, grid), twins = slopes_on_grid(NULL, sea, grid / (2.0 * sqrt(2.0)));
        assert_true(ours < 1.01 * twins && ours > 0.5 * twins);
        assert_true(ours <= 1.001 * previous);
        previous = ours;
    }
    assert_true(previous < 0.2 * slopes_on_grid(NULL, sea, 0.0));
    bolan_sea_destroy(&sea);
}

static void a_grid_carries_the_layers_that_it_can(void **state) {
    const host *h = *state;
    static float points[POINTS][4];
    static bolan_dvec2 world[POINTS];
    static answer got[POINTS];
    bolan_sea_desc calm = bolan_sea_desc_default();
    bolan_wave_train_desc desc = bolan_wave_train_desc_default();
    bolan_wave_layer *layer = NULL;
    bolan_sea *sea = NULL;
    calm.sea_state = bolan_sea_state_from_wind(0.0, 0.0, 1e5);
    calm.resolution = 32;
    assert_int_equal(bolan_sea_create(&calm, &sea), BOLAN_OK);
    bolan_sea_step(sea, 3.0);
    desc.length = 40.0;
    desc.height = 2.0;
    assert_int_equal(bolan_wave_layer_create_train(&desc, &layer), BOLAN_OK);
    const bolan_wave_layer *const layers[] = {layer};
    place_points(points, world, 1e6f);
    for (int i = 0; i < POINTS; i++) points[i][3] = 5.0f + 0.1f * (float)i; // from 8 to 1.3 spacings in a wave
    bolan_renderer_bind_fields(h->renderer,
                               &(bolan_water){.sea = sea, .level = level, .layers = layers, .layer_count = 1}, origin,
                               UNIT, SLOT);
    ask(h, 2, points, got);
    for (int i = 0; i < POINTS; i++) {
        bolan_wave_layer_sample want;
        bolan_wave_layer_sample_at(layer, 3.0, &world[i], 1, &want);
        const double keep = fmin(fmax(0.5 * 40.0 / (double)points[i][3] - 1.0, 0.0), 1.0); // all from 4 on, none from 2
        assert_near(got[i].displacement[2], keep * (double)want.height, 1e-3);
        assert_near(got[i].slope[1], keep * (double)want.slope_y, 1e-3);
    }
    bolan_sea_destroy(&sea);
    bolan_wave_layer_destroy(&layer);
}

// ---- life -----------------------------------------------------------------------------------------------------------

static void a_step_and_another_sea_are_seen(void **state) {
    const host *h = *state;
    bolan_sea *a = sea_of(BOLAN_WAVES_FFT), *b = sea_of(BOLAN_WAVES_COSINES);
    surface_equals(h, a, 1e6f);
    bolan_sea_step(a, 40.0);
    surface_equals(h, a, 1e6f);
    surface_equals(h, b, 1e6f);
    surface_equals(h, a, 1e6f);
    bolan_sea *steep = folded_sea(1.0);
    surface_equals(h, steep, 1e6f);
    bolan_sea_destroy(&steep);
    bolan_sea *finer = sea_with(BOLAN_WAVES_FFT, 128, 1.0, 1); // as many cascades of another size
    surface_equals(h, finer, 1e6f);
    bolan_sea_destroy(&finer);
    bolan_sea_destroy(&a);
    bolan_sea_destroy(&b);
}

static int heard[2]; // sentences with the ids GUEST_PROGRAM and GUEST_SLOTS
static void hear(void *user, bolan_log_level log_level, bolan_log_id id, const char *sentence) {
    (void)user, (void)log_level, (void)sentence;
    heard[0] += id == BOLAN_LOG_GUEST_PROGRAM;
    heard[1] += id == BOLAN_LOG_GUEST_SLOTS || id == BOLAN_LOG_NOT_FINITE;
}

static void misuse_is_refused(void **state) {
    const host *h = *state;
    GLint units = 0, slots = 0;
    glGetIntegerv(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS, &units);
    glGetIntegerv(GL_MAX_UNIFORM_BUFFER_BINDINGS, &slots);
    GLuint without = host_program("#ifdef GL_ES\nprecision highp float;\n#endif\n",
                                  "out vec4 color;\nvoid main() { color = vec4(1.0); }\n");
    bolan_sea *sea = sea_of(BOLAN_WAVES_FFT);
    bolan_renderer *r = h->renderer;
    heard[0] = heard[1] = 0;
    bolan_set_hooks(&(bolan_hooks){.log = hear});
    assert_int_equal(bolan_renderer_link_fields(r, without, UNIT, SLOT), BOLAN_ERROR_ARGUMENT);
    assert_int_equal(bolan_renderer_link_fields(r, 9999, UNIT, SLOT), BOLAN_ERROR_ARGUMENT);
    assert_int_equal(bolan_renderer_link_fields(r, h->program, (uint32_t)units - 3, SLOT), BOLAN_ERROR_ARGUMENT);
    assert_int_equal(bolan_renderer_link_fields(r, h->program, UNIT, (uint32_t)slots), BOLAN_ERROR_ARGUMENT);
    bolan_renderer_bind_fields(r, &(bolan_water){.sea = sea, .level = level}, origin, (uint32_t)units, SLOT);
    bolan_renderer_bind_fields(r, &(bolan_water){.sea = sea, .level = level}, origin, (uint32_t)units,
                               SLOT); // said once
    bolan_renderer_bind_fields(r, &(bolan_water){.sea = sea, .level = level}, (bolan_dvec3){NAN, 0.0, 0.0}, UNIT, SLOT);
    bolan_set_hooks(NULL);
    assert_int_equal(heard[0], 4);
    assert_int_equal(heard[1], 2);
    glDeleteProgram(without);
    bolan_sea_destroy(&sea);
}

#define TEST(f) cmocka_unit_test_teardown(f, end)

int main(void) {
    const struct CMUnitTest tests[] = {
        TEST(every_model_equals_the_sample),
        TEST(folded_water_equals_the_sample),
        TEST(every_model_equals_the_query_in_deep_and_shallow_water),
        TEST(wave_trains_are_added),
        TEST(grid_fades_like_the_twin),
        TEST(a_grid_of_cascades_loses_what_the_twin_loses),
        TEST(a_grid_carries_the_layers_that_it_can),
        TEST(a_step_and_another_sea_are_seen),
        TEST(misuse_is_refused),
    };
    const struct CMUnitTest computed[] = {
        TEST(every_model_equals_the_sample),
        TEST(a_step_and_another_sea_are_seen),
    };
    int failed = cmocka_run_group_tests_name("fields for the host's programs (core)", tests, open_core, close_host);
    if (has_compute())
        failed += cmocka_run_group_tests_name("fields that are computed", computed, open_compute, close_host);
    return failed + cmocka_run_group_tests_name("fields for the host's programs (es)", tests, open_es, close_host);
}

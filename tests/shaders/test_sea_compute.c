// SPDX-License-Identifier: MIT
// The synthesis by compute shaders (src/render/sea_compute.h) against that of the CPU (src/waves/cascades), texel by
// texel, and what a renderer does with it.
#include "cascade_twin.h"
#include "gl_support.h"

#include "bolan/query.h"
#include "heard.h"
#include "render/foam_statistics.h"
#include "render/sea_gpu.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <string.h>

typedef struct rig {
    bolan_sea *sea;
    gl_caps caps;
    frame step;
    sea_gpu gpu;
    sea_compute compute;
    water_textures textures;
} rig;

static void rig_open(rig *r, const bolan_sea_desc *desc, bool packed) {
    memset(r, 0, sizeof *r);
    assert_int_equal(bolan_sea_create(desc, &r->sea), BOLAN_OK);
    r->caps = bolan_gl_get_caps();
    if (!r->caps.compute) skip();
    r->textures = packed ? WATER_TEXTURES_PACKED : WATER_TEXTURES_ALL;
    r->step = (frame){.caps = &r->caps, .compute = &r->compute, .sea = r->sea, .lighting = bolan_lighting_default()};
    assert_int_equal(bolan_sea_gpu_create(&r->gpu), BOLAN_OK);
}

static void rig_close(rig *r) {
    bolan_sea_gpu_free(&r->gpu);
    bolan_sea_compute_free(&r->compute);
    bolan_sea_destroy(&r->sea);
}

// All texels of a layer's level, as floats.
static float *read_layer(const gl_texture *t, int layer, uint32_t level) {
    const gl_texture *color = t;
    gl_target target;
    assert_int_equal(bolan_gl_target_create(&color, 1, NULL, layer, level, &target), BOLAN_OK);
    float *rgba = malloc((size_t)target.width * target.height * 4 * sizeof *rgba);
    bolan_gl_target_read_float(&target, 0, rgba);
    bolan_gl_target_free(&target);
    return rgba;
}

// ---- texels ---------------------------------------------------------------------------------------------------------

#define FLOAT_ERROR 4e-6 // of the rms of the two fields in a complex transform, in single precision
#define HALF_ERROR 0x1p-11
#define SMALLEST_HALF 0x1p-25

static double rms_of(const bolan_cascade_view *v, twin_field f) {
    double squares = 0.0;
    for (uint32_t p = 0; p < v->n * v->n; p++) squares += pow((double)twin_at(f, p % v->n, p / v->n), 2.0);
    return sqrt(squares / ((double)v->n * v->n));
}

// A channel of the texels against a field of the CPU. `partner`: the other field of its transform.
static void check_channel(const float *texels, int channel, const bolan_cascade_view *v, twin_field field,
                          twin_field partner, const char *name) {
    const double scale = rms_of(v, field) + rms_of(v, partner);
    double worst = 0.0;
    for (uint32_t p = 0; p < v->n * v->n; p++) {
        const double want = (double)twin_at(field, p % v->n, p / v->n), rounding = HALF_ERROR * fabs(want);
        const double off = fabs((double)texels[4 * p + (uint32_t)channel] - want) - rounding - SMALLEST_HALF;
        worst = fmax(worst, off / fmax(scale, 1e-30));
    }
    if (worst > FLOAT_ERROR) fail_msg("%s: a texel is off by %.3g of the rms, beyond half floats", name, worst);
}

static void check_packed(const sea_fields *f, const bolan_cascade_view *v, uint32_t c) {
    const size_t count = (size_t)v->n * v->n;
    float *slopes = read_layer(&f->packed_slopes[c], -1, 0), *sums = malloc(count * sizeof *sums);
    for (size_t i = 0; i < count; i++) sums[i] = v->dxx[i] + v->dyy[i];
    const twin_field divergence = {sums, 1, v->n};
    check_channel(slopes, 0, v, TWIN_PLANE(v, slope_x), TWIN_PLANE(v, slope_y), "packed slope x");
    check_channel(slopes, 1, v, TWIN_PLANE(v, slope_y), TWIN_PLANE(v, slope_x), "packed slope y");
    check_channel(slopes, 2, v, divergence, TWIN_PLANE(v, dxx), "packed divergence");
    check_channel(slopes, 3, v, TWIN_PLANE(v, foam), divergence, "packed foam");
    free(slopes);
    free(sums);
}

static void check_whole(const sea_fields *f, const bolan_cascade_view *v, uint32_t c) {
    float *slopes = read_layer(&f->slopes, (int)c, 0), *fold = read_layer(&f->fold, (int)c, 0);
    check_channel(slopes, 0, v, TWIN_PLANE(v, slope_x), TWIN_PLANE(v, slope_y), "slope x");
    check_channel(slopes, 1, v, TWIN_PLANE(v, slope_y), TWIN_PLANE(v, slope_x), "slope y");
    check_channel(slopes, 2, v, TWIN_PLANE(v, dxx), TWIN_PLANE(v, dyy), "dxx");
    check_channel(slopes, 3, v, TWIN_PLANE(v, dyy), TWIN_PLANE(v, dxx), "dyy");
    check_channel(fold, 0, v, TWIN_TEXELS(v, dxy), TWIN_TEXELS(v, height), "fold dxy");
    check_channel(fold, 1, v, TWIN_PLANE(v, foam), TWIN_PLANE(v, dxx), "fold foam");
    free(slopes);
    free(fold);
}

static void check_now(rig *r) {
    assert_true(bolan_sea_gpu_prepare(&r->gpu, &r->step, r->textures));
    const sea_fields *f = r->gpu.now;
    for (uint32_t c = 0; c < bolan_sea_cascade_count(r->sea); c++) {
        const bolan_cascade_view v = bolan_sea_cascade(r->sea, c);
        float *displacement = read_layer(&f->displacement, (int)c, 0);
        check_channel(displacement, 0, &v, TWIN_TEXELS(&v, dx), TWIN_TEXELS(&v, dy), "dx");
        check_channel(displacement, 1, &v, TWIN_TEXELS(&v, dy), TWIN_TEXELS(&v, dx), "dy");
        check_channel(displacement, 2, &v, TWIN_TEXELS(&v, height), TWIN_TEXELS(&v, dxy), "height");
        check_channel(displacement, 3, &v, TWIN_TEXELS(&v, dxy), TWIN_TEXELS(&v, height), "dxy");
        free(displacement);
        (r->textures == WATER_TEXTURES_PACKED ? check_packed : check_whole)(f, &v, c);
    }
}

static bolan_sea_desc windy(uint32_t n) {
    bolan_sea_desc desc = bolan_sea_desc_default();
    desc.sea_state = bolan_sea_state_from_wind(13.0, 250.0, 200e3);
    desc.resolution = n;
    desc.foam_decay = 0.75; // 15 ticks
    desc.fft.cascade_count = 2;
    return desc;
}

static void every_texel_is_the_cpus(void **state) {
    (void)state;
    for (uint32_t n = 32; n <= 512; n *= 2) {
        for (int packed = 0; packed < 2; packed++) {
            if (n == 512 && !packed) continue; // the same transforms
            rig r;
            bolan_sea_desc desc = windy(n);
            desc.fft.cascade_count = n == 64 ? 4 : n == 512 ? 1 : 2;
            rig_open(&r, &desc, packed);
            bolan_sea_step(r.sea, 3.37);
            check_now(&r);
            rig_close(&r);
        }
    }
}

static void the_finest_resolution_has_one_transform_a_group(void **state) {
    (void)state;
    rig r;
    bolan_sea_desc desc = windy(1024);
    desc.fft.cascade_count = 1;
    rig_open(&r, &desc, true);
    bolan_sea_step(r.sea, 1.0);
    check_now(&r);
    rig_close(&r);
}

static void every_sea_is_the_cpus(void **state) {
    (void)state;
    bolan_sea_desc desc[5];
    for (int i = 0; i < 5; i++) desc[i] = windy(64);
    desc[0].sea_state.depth = 6.0;
    desc[0].choppiness = 0.4;
    desc[1].sea_state.current_x = 1.4, desc[1].sea_state.current_y = -0.8;
    desc[2].waves = BOLAN_WAVES_TEXTURES;
    desc[3].loop_period = 60.0;
    desc[3].seed = 77;
    desc[4].sea_state = bolan_sea_state_default(); // a calm
    bolan_sea_state_add_swell(&desc[4].sea_state, 1.5, 13.0, 200.0, 25.0);
    for (int i = 0; i < 5; i++) {
        rig r;
        rig_open(&r, &desc[i], i % 2 == 0);
        bolan_sea_settle(r.sea, 123.4);
        check_now(&r);
        rig_close(&r);
    }
}

// ---- time -----------------------------------------------------------------------------------------------------------

static void phases_are_exact_at_any_time(void **state) {
    (void)state;
    static const double times[] = {0.0, 0.249, 86400.1, 1e6 + 0.3, -17.3, 3e9 + 0.11, -1e6};
    rig r;
    const bolan_sea_desc desc = windy(64);
    rig_open(&r, &desc, true);
    for (size_t i = 0; i < sizeof times / sizeof *times; i++) {
        bolan_sea_step(r.sea, times[i]);
        check_now(&r);
    }
    rig_close(&r);
}

// By steps short and long, a jump forth and back, a settled sea, and frames that nobody drew.
static void foam_remembers_as_on_the_cpu(void **state) {
    (void)state;
    rig r;
    const bolan_sea_desc desc = windy(64);
    rig_open(&r, &desc, true);
    double time = 0.0;
    for (int i = 0; i < 60; i++) {
        time += i == 20 ? 5.0 : i == 30 ? -2.2 : i % 7 == 0 ? 0.9 : 0.06;
        if (i == 40) bolan_sea_settle(r.sea, time);
        bolan_sea_step(r.sea, time);
        if (i % 4 == 0 || i > 50) check_now(&r);
    }
    rig_close(&r);
}

static void forks_take_turns(void **state) {
    (void)state;
    rig r;
    const bolan_sea_desc desc = windy(32);
    rig_open(&r, &desc, true);
    bolan_sea *fork = NULL, *first = r.sea;
    assert_int_equal(bolan_sea_fork(first, &fork), BOLAN_OK);
    for (int i = 0; i < 6; i++) {
        bolan_sea_step(first, 0.3 * i);
        bolan_sea_step(fork, 50.0 + 0.3 * i);
        r.sea = first;
        r.step.sea = first;
        check_now(&r);
        r.sea = fork;
        r.step.sea = fork;
        check_now(&r);
    }
    r.sea = first;
    bolan_sea_destroy(&fork);
    rig_close(&r);
}

// ---- levels, foam law -----------------------------------------------------------------------------------------------

static void check_levels(const gl_texture *t, int layer) {
    float *finer = read_layer(t, layer, 0);
    for (uint32_t l = 1; l < t->levels; l++) {
        float *level = read_layer(t, layer, l);
        const uint32_t n = t->width >> l;
        for (uint32_t y = 0; y < n; y++)
            for (uint32_t x = 0; x < n; x++)
                for (uint32_t k = 0; k < 4; k++) {
                    const float *a = finer + 4 * (2 * y * 2 * n + 2 * x) + k, *b = a + 4 * 2 * n;
                    const double want = 0.25 * ((double)a[0] + a[4] + b[0] + b[4]);
                    const double size =
                        0.25 * (fabs((double)a[0]) + fabs((double)a[4]) + fabs((double)b[0]) + fabs((double)b[4]));
                    assert_near(level[4 * (y * n + x) + k], want, 0x1p-9 * size + 1e-7);
                }
        free(finer);
        finer = level;
    }
    free(finer);
}

static void levels_are_means(void **state) {
    (void)state;
    for (uint32_t n = 32; n <= 512; n *= 4) {
        rig r;
        const bolan_sea_desc desc = windy(n);
        rig_open(&r, &desc, n == 128);
        bolan_sea_step(r.sea, 4.2);
        assert_true(bolan_sea_gpu_prepare(&r.gpu, &r.step, r.textures));
        const sea_fields *f = r.gpu.now;
        check_levels(&f->displacement, 1);
        check_levels(&f->slopes, 0);
        if (n == 128)
            check_levels(&f->packed_slopes[1], -1);
        else
            check_levels(&f->fold, 1);
        rig_close(&r);
    }
}

static void read_buffer(const gl_buffer *b, size_t size, void *out) {
    glBindBuffer(GL_ARRAY_BUFFER, b->id);
    const void *data = glMapBufferRange(GL_ARRAY_BUFFER, 0, (GLsizeiptr)size, GL_MAP_READ_BIT);
    assert_non_null(data);
    memcpy(out, data, size);
    glUnmapBuffer(GL_ARRAY_BUFFER);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
}

static void the_law_of_old_foam_is_the_cpus(void **state) {
    (void)state;
    for (int packed = 0; packed < 2; packed++) {
        rig r;
        const bolan_sea_desc desc = windy(128);
        rig_open(&r, &desc, packed);
        bolan_sea_settle(r.sea, 20.0);
        assert_true(bolan_sea_gpu_prepare(&r.gpu, &r.step, r.textures));
        assert_non_null(r.step.foam_law);
        float law[4];
        read_buffer(r.step.foam_law, sizeof law, law);
        const foam_law want = bolan_foam_law(r.sea, 0.1, true);
        assert_near(law[FOAM_LAW_THRESHOLD], want.memory, 2e-4 * want.memory);
        assert_near(law[FOAM_LAW_VARIANCE], want.memory_variance, 1e-3 * want.memory_variance);
        assert_near(law[FOAM_LAW_EDGE], 0.4 * want.memory_variance, 4e-4 * want.memory_variance);
        assert_near(law[FOAM_LAW_SHARE], want.memory_variance / want.variance,
                    1e-3 * want.memory_variance / want.variance);
        rig_close(&r);
    }
}

// ---- the renderer ---------------------------------------------------------------------------------------------------

static uint32_t loops; // of the task hook

static void count_loop(void *user, uint32_t count, uint32_t grain, bolan_task_fn *task, void *context) {
    (void)user;
    (void)grain;
    loops++;
    task(context, 0, count, 0);
}

// Of the fine waves, whose columns and rows the CPU makes with either backend; and their levels.
enum { FINE_LOOPS = 2, FINE_UPLOADS = 7 };

// Nothing of the cascades.
static void a_drawn_sea_costs_the_cpu_nothing(void **state) {
    (void)state;
    const bolan_hooks hooks = {.parallel = count_loop, .parallel_workers = 1};
    if (!bolan_gl_get_info().compute) skip();
    bolan_set_hooks(&hooks);
    bolan_renderer_desc desc = bolan_renderer_desc_default();
    desc.backend = BOLAN_BACKEND_COMPUTE;
    bolan_renderer *renderer = NULL;
    bolan_target *target = NULL;
    assert_int_equal(bolan_renderer_create(&desc, &renderer), BOLAN_OK);
    assert_int_equal(bolan_renderer_backend(renderer), BOLAN_BACKEND_COMPUTE);
    assert_int_equal(bolan_target_create(64, 48, &target), BOLAN_OK);
    bolan_water water = bolan_water_default();
    bolan_lighting lighting = bolan_lighting_default();
    bolan_sea *sea = small_sea(bolan_sea_state_from_wind(9.0, 250.0, 100e3));
    water.sea = sea;
    bolan_view view = bolan_view_default();
    view.framebuffer = bolan_target_framebuffer(target);
    view.width = 64, view.height = 48;
    for (int i = 0; i < 4; i++) {
        loops = 0;
        bolan_sea_step(sea, 3.0 + 0.2 * i);
        bolan_renderer_prepare(renderer, &water, &lighting);
        bolan_renderer_draw_water(renderer, &view, NULL);
        if (i == 0) continue; // which may make tables on the CPU
        assert_int_equal(loops, FINE_LOOPS);
    }
    const bolan_frame_statistics warm = bolan_renderer_statistics(renderer);
    bolan_sea_step(sea, 4.0);
    bolan_renderer_prepare(renderer, &water, &lighting);
    bolan_renderer_draw_water(renderer, &view, NULL);
    const bolan_frame_statistics after = bolan_renderer_statistics(renderer);
    assert_int_equal(after.programs, warm.programs);
    assert_true(after.uploads <= warm.uploads + FINE_UPLOADS);
    assert_true(after.sea_bytes > 2 * 64 * 64 * 16);
    bolan_sea_destroy(&sea);
    bolan_target_destroy(&target);
    bolan_renderer_destroy(&renderer);
    bolan_set_hooks(NULL);
}

// ---- a context without compute shaders, and a host with bindings of its own -----------------------------------------

static void *without_dispatch(void *user, const char *name) {
    void *address = NULL;
    void (*const found)(void) = eglGetProcAddress(name);
    (void)user;
    if (strcmp(name, "glDispatchCompute") != 0) memcpy(&address, &found, sizeof address);
    return address;
}

static void where_there_is_none_it_is_refused_in_one_sentence(void **state) {
    (void)state;
    bolan_set_hooks(&(bolan_hooks){.log = hear, .get_proc_address = without_dispatch});
    assert_false(bolan_gl_get_info().compute);
    bolan_renderer_desc desc = bolan_renderer_desc_default();
    bolan_renderer *renderer = NULL;
    heard.errors = 0;
    desc.backend = BOLAN_BACKEND_COMPUTE;
    assert_int_equal(bolan_renderer_create(&desc, &renderer), BOLAN_ERROR_UNSUPPORTED);
    assert_null(renderer);
    assert_int_equal(heard.errors, 1);
    assert_int_equal(heard.id, BOLAN_LOG_UNSUPPORTED);
    assert_non_null(strstr(heard.sentence, "has no compute shaders; expected OpenGL 4.3"));
    desc.backend = BOLAN_BACKEND_AUTO;
    assert_int_equal(bolan_renderer_create(&desc, &renderer), BOLAN_OK);
    assert_int_equal(bolan_renderer_backend(renderer), BOLAN_BACKEND_CPU);
    bolan_renderer_destroy(&renderer);
    heard.errors = 0;
    desc.backend = (bolan_backend)3;
    assert_int_equal(bolan_renderer_create(&desc, &renderer), BOLAN_ERROR_ARGUMENT);
    assert_int_equal(heard.id, BOLAN_LOG_OUT_OF_RANGE);
    bolan_set_hooks(NULL);
}

typedef struct bindings {
    GLint buffer, slot[4], image[4][6];
    GLint64 start[4], size[4];
} bindings;

static bindings bindings_now(void) {
    static const GLenum names[6] = {GL_IMAGE_BINDING_NAME,  GL_IMAGE_BINDING_LEVEL,  GL_IMAGE_BINDING_LAYERED,
                                    GL_IMAGE_BINDING_LAYER, GL_IMAGE_BINDING_ACCESS, GL_IMAGE_BINDING_FORMAT};
    bindings b;
    memset(&b, 0, sizeof b);
    glGetIntegerv(GL_SHADER_STORAGE_BUFFER_BINDING, &b.buffer);
    for (GLuint i = 0; i < 4; i++) {
        glGetIntegeri_v(GL_SHADER_STORAGE_BUFFER_BINDING, i, &b.slot[i]);
        glGetInteger64i_v(GL_SHADER_STORAGE_BUFFER_START, i, &b.start[i]);
        glGetInteger64i_v(GL_SHADER_STORAGE_BUFFER_SIZE, i, &b.size[i]);
        for (int k = 0; k < 6; k++) glGetIntegeri_v(names[k], i, &b.image[i][k]);
    }
    return b;
}

static void the_hosts_bindings_stay(void **state) {
    (void)state;
    if (!bolan_gl_get_info().compute) skip();
    GLuint buffer[3], image;
    glGenBuffers(3, buffer);
    for (int i = 0; i < 3; i++) {
        glBindBuffer(GL_SHADER_STORAGE_BUFFER, buffer[i]);
        glBufferData(GL_SHADER_STORAGE_BUFFER, 4096, NULL, GL_STATIC_DRAW);
    }
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, buffer[0]);
    glBindBufferRange(GL_SHADER_STORAGE_BUFFER, 3, buffer[1], 1024, 512);
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, buffer[2]);
    glGenTextures(1, &image);
    glBindTexture(GL_TEXTURE_2D_ARRAY, image);
    glTexStorage3D(GL_TEXTURE_2D_ARRAY, 2, GL_RGBA32F, 8, 8, 4);
    glBindImageTexture(1, image, 1, GL_FALSE, 2, GL_READ_ONLY, GL_RGBA32F);
    const bindings before = bindings_now();
    bolan_renderer_desc desc = bolan_renderer_desc_default();
    desc.backend = BOLAN_BACKEND_COMPUTE;
    bolan_renderer *renderer = NULL;
    assert_int_equal(bolan_renderer_create(&desc, &renderer), BOLAN_OK);
    bolan_water water = bolan_water_default();
    bolan_lighting lighting = bolan_lighting_default();
    bolan_sea *sea = small_sea(bolan_sea_state_from_wind(9.0, 250.0, 100e3));
    water.sea = sea;
    bolan_renderer_prepare(renderer, &water, &lighting);
    const bindings after = bindings_now();
    assert_memory_equal(&before, &after, sizeof before);
    assert_true(before.slot[3] != 0 && before.image[1][0] != 0 && before.start[3] == 1024);
    bolan_sea_destroy(&sea);
    bolan_renderer_destroy(&renderer);
    glDeleteBuffers(3, buffer);
    glDeleteTextures(1, &image);
}

static void the_default_on_software_is_the_cpu(void **state) {
    (void)state;
    bolan_renderer_desc desc = bolan_renderer_desc_default();
    bolan_renderer *renderer = NULL;
    assert_int_equal(bolan_renderer_create(&desc, &renderer), BOLAN_OK);
    const bolan_gl_info info = bolan_gl_get_info();
    assert_int_equal(bolan_renderer_backend(renderer),
                     info.compute && !info.software ? BOLAN_BACKEND_COMPUTE : BOLAN_BACKEND_CPU);
    bolan_renderer_destroy(&renderer);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        IN_BOTH_APIS(every_texel_is_the_cpus),
        cmocka_unit_test_setup_teardown(the_finest_resolution_has_one_transform_a_group, gl_setup_core, gl_teardown),
        IN_BOTH_APIS(every_sea_is_the_cpus),
        cmocka_unit_test_setup_teardown(phases_are_exact_at_any_time, gl_setup_core, gl_teardown),
        IN_BOTH_APIS(foam_remembers_as_on_the_cpu),
        cmocka_unit_test_setup_teardown(forks_take_turns, gl_setup_core, gl_teardown),
        IN_BOTH_APIS(levels_are_means),
        IN_BOTH_APIS(the_law_of_old_foam_is_the_cpus),
        IN_BOTH_APIS(a_drawn_sea_costs_the_cpu_nothing),
        IN_BOTH_APIS(where_there_is_none_it_is_refused_in_one_sentence),
        IN_BOTH_APIS(the_hosts_bindings_stay),
        IN_BOTH_APIS(the_default_on_software_is_the_cpu),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

// SPDX-License-Identifier: MIT
// No program is compiled inside a frame: for each technique the eye flies from 10 km to under the waves, turns and
// comes to a coast, and after the first frame the renderer's count of programs stays. Every program that this made
// fetches from at most 16 textures, the kept shape included.
#include "gl_support.h"

#include "bolan/io.h"

#include <epoxy/gl.h>
#include <stdio.h>
#include <string.h>

enum { WIDTH = 96, HEIGHT = 64, MOST_NAMES = 4000 };
enum { MOST_SAMPLERS = 16 }; // OpenGL 3.3 and ES 3.0 promise so many to a stage

typedef struct flight {
    bolan_scene scene;
    bolan_world *world;
    bolan_renderer *renderer;
    bolan_target *target;
} flight;

static bolan_pixels pixels; // what shades them; auto

static void open_flight(flight *f, const char *name, const bolan_technique *technique, bolan_quality quality) {
    *f = (flight){.world = NULL};
    assert_int_equal(bolan_scene_load(name, &f->scene), BOLAN_OK);
    f->scene.sea.resolution = 64;
    f->scene.sky.cloud_cover = 0.0;
    bolan_scene_set_technique(&f->scene, technique);
    assert_int_equal(bolan_world_load_scene(&f->scene, &f->world), BOLAN_OK);
    bolan_world_step(f->world, 1.0);
    bolan_renderer_desc desc = bolan_renderer_desc_default();
    desc.quality = quality;
    desc.pixels = pixels;
    assert_int_equal(bolan_renderer_create(&desc, &f->renderer), BOLAN_OK);
    assert_int_equal(bolan_target_create(WIDTH, HEIGHT, &f->target), BOLAN_OK);
}

static void close_flight(flight *f) {
    bolan_target_destroy(&f->target);
    bolan_renderer_destroy(&f->renderer);
    bolan_world_destroy(&f->world);
}

// Draws a frame and returns how many programs the renderer has compiled so far.
static uint32_t programs_after(flight *f) {
    assert_int_equal(bolan_world_set_scene(f->world, &f->scene), BOLAN_OK);
    bolan_view view = bolan_view_from_camera(&f->scene.camera, WIDTH, HEIGHT);
    view.eye = bolan_world_clear_eye(f->world, view.eye);
    view.framebuffer = bolan_target_framebuffer(f->target);
    view.progressive = true;
    bolan_renderer_draw_world(f->renderer, f->world, &view);
    return bolan_renderer_statistics(f->renderer).programs;
}

// Samplers of fragment and compute shaders where the driver tells (OpenGL 4.3), else those of all stages.
static int samplers_of(GLuint program) {
    GLint count = 0, samplers = 0;
    glGetProgramiv(program, GL_ACTIVE_UNIFORMS, &count);
    const bool tells = epoxy_gl_version() >= 43;
    for (GLint i = 0; i < count; ++i) {
        GLint size;
        GLenum type;
        char name[64];
        glGetActiveUniform(program, (GLuint)i, sizeof name, NULL, &size, &type, name);
        const bool fetched = type == GL_SAMPLER_2D || type == GL_SAMPLER_3D || type == GL_SAMPLER_2D_ARRAY ||
                             type == GL_SAMPLER_CUBE || type == GL_UNSIGNED_INT_SAMPLER_2D;
        if (!fetched) continue;
        GLint used[2] = {1, 1};
        const GLenum by[2] = {GL_REFERENCED_BY_FRAGMENT_SHADER, GL_REFERENCED_BY_COMPUTE_SHADER};
        if (tells) glGetProgramResourceiv(program, GL_UNIFORM, (GLuint)i, 2, by, 2, NULL, used);
        samplers += used[0] || used[1] ? size : 0;
    }
    return samplers;
}

static void check_samplers(const char *name) {
    int most = 0, programs = 0;
    for (GLuint i = 1; i < MOST_NAMES; ++i) {
        if (!glIsProgram(i)) continue;
        ++programs;
        const int samplers = samplers_of(i);
        most = samplers > most ? samplers : most;
        if (samplers > MOST_SAMPLERS) fail_msg("%s: program %u fetches from %d textures", name, i, samplers);
    }
    print_message("%s: %d programs, at most %d textures\n", name, programs, most);
    assert_true(programs > 10);
}

static void fly(flight *f, const char *name) {
    static const double heights[] = {10000.0, 1500.0, 401.0, 399.0, 41.0, 39.0, 8.0, 1.0, -1.0, -4.0, 2.0};
    bolan_camera *camera = &f->scene.camera;
    camera->position.z = f->scene.water.level + 3000.0;
    const uint32_t before = programs_after(f);
    assert_true(before > 10);
    for (size_t i = 0; i < sizeof heights / sizeof heights[0]; ++i)
        for (int steep = 0; steep < 3; ++steep) {
            camera->position.z = f->scene.water.level + heights[i];
            camera->pitch_deg = steep == 0 ? 3.0 : steep == 1 ? -12.0 : -60.0;
            camera->roll_deg = steep == 1 ? 20.0 : 0.0;
            camera->fov_deg = steep == 0 ? 60.0 : 8.0;
            const uint32_t after = programs_after(f);
            if (after != before)
                fail_msg("%s: %u programs were compiled in a frame, %g m over the water", name, after - before,
                         heights[i]);
        }
    check_samplers(name);
}

static void fly_one(const char *scene, bolan_quality quality, const bolan_technique *technique) {
    flight f;
    open_flight(&f, scene, technique, quality);
    fly(&f, technique->name);
    close_flight(&f);
}

static void fly_all(const char *scene, bolan_quality quality) {
    uint32_t count;
    const bolan_technique *all = bolan_techniques(&count);
    assert_int_equal(count, 5);
    for (uint32_t i = 0; i < count; ++i) fly_one(scene, quality, &all[i]);
}

static void a_flight_over_the_open_sea_compiles_nothing(void **state) {
    (void)state;
    fly_all("open-sea", BOLAN_QUALITY_LOW);
}

static void a_flight_over_a_coast_compiles_nothing(void **state) {
    (void)state;
    fly_all("island", BOLAN_QUALITY_MEDIUM);
}

// The levels are drawn by instancing, of whatever blocks are in sight; of the tiles, more classes come into sight.
static void a_flight_over_nested_levels_and_tiles_compiles_nothing(void **state) {
    (void)state;
    bolan_technique nested = bolan_technique_ocean;
    nested.name = "ocean on nested levels", nested.surface = BOLAN_SURFACE_NESTED;
    fly_one("open-sea", BOLAN_QUALITY_MEDIUM, &nested);
    pixels = bolan_gl_get_caps().compute ? BOLAN_PIXELS_COMPUTE : BOLAN_PIXELS_FRAGMENT;
    fly_one("island", BOLAN_QUALITY_LOW, &nested);
    pixels = BOLAN_PIXELS_AUTO;
}

// ---- the sun turns --------------------------------------------------------------------------------------------------

static long allocations;

static void *count_and_allocate(void *user, size_t size, size_t align) {
    (void)user;
    void *memory = NULL;
    ++allocations;
    return posix_memalign(&memory, align < sizeof(void *) ? sizeof(void *) : align, size) == 0 ? memory : NULL;
}

static void release(void *user, void *memory, size_t size) {
    (void)user, (void)size;
    free(memory);
}

static void a_window_bakes_for_a_new_sun_only_when_asked(void **state) {
    (void)state;
    flight f;
    bolan_set_hooks(&(bolan_hooks){.allocate = count_and_allocate, .release = release});
    open_flight(&f, "pond", &bolan_technique_two_triangle, BOLAN_QUALITY_LOW);
    f.scene.sky.sun_azimuth_deg = 100.0;
    f.scene.sky.sun_elevation_deg = 40.0;
    programs_after(&f);
    programs_after(&f);
    assert_false(bolan_renderer_needs_baking(f.renderer));
    for (int i = 1; i <= 3; ++i) { // the light of another 25 degrees, thrice
        f.scene.sky.sun_azimuth_deg += 25.0;
        const long before = allocations;
        programs_after(&f);
        assert_int_equal(allocations, before);
        assert_true(bolan_renderer_needs_baking(f.renderer));
    }
    long before = allocations;
    bolan_renderer_bake(f.renderer);
    programs_after(&f);
    assert_true(allocations > before);
    assert_false(bolan_renderer_needs_baking(f.renderer));
    before = allocations;
    programs_after(&f);
    assert_int_equal(allocations, before);
    close_flight(&f);
    bolan_set_hooks(NULL);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(a_flight_over_the_open_sea_compiles_nothing, gl_setup_core, gl_teardown),
        cmocka_unit_test_setup_teardown(a_flight_over_a_coast_compiles_nothing, gl_setup_core, gl_teardown),
        cmocka_unit_test_setup_teardown(a_flight_over_nested_levels_and_tiles_compiles_nothing, gl_setup_core,
                                        gl_teardown),
        cmocka_unit_test_setup_teardown(a_window_bakes_for_a_new_sun_only_when_asked, gl_setup_core, gl_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

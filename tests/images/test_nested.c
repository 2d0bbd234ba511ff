// SPDX-License-Identifier: MIT
// No hole in the nested grids as they are drawn: over ten thousand random views the waves are drawn over a coloured
// background, and below the horizon none of it may show. tests/unit/test_surface_nested_cracks.c shows the same of the
// triangles, by their bits.
#include "../shaders/gl_support.h"
#include "bolan/earth.h"

#include "render/sea_gpu.h"
#include "render/water_mesh.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { WIDTH = 64, HEIGHT = 48, VIEWS = 10000, VIEWS_ES = 500 };

static const char shader[] = "#ifdef VERTEX\n"
                             "layout(location = 0) in vec4 vertex;\n"
                             "layout(location = 2) in vec3 mesh_offset;\n"
                             "uniform vec4 row[4];\n"
                             "void main() { vec4 p = vec4(vertex.xyz + mesh_offset.yzx, 1.0);\n"
                             "gl_Position = vec4(dot(row[0], p), dot(row[1], p), dot(row[2], p), dot(row[3], p)); }\n"
                             "#endif\n"
                             "#ifdef FRAGMENT\n"
                             "out vec4 color;\n"
                             "void main() { color = vec4(0.0, 1.0, 0.0, 1.0); }\n"
                             "#endif\n";

typedef struct rig {
    bolan_sea *sea;
    bolan_scene scene;
    shore_map shore;
    frame step;
    render_view f;
    water_mesh mesh;
    gl_program program;
    gl_texture color;
    gl_target target;
    uint8_t pixels[WIDTH * HEIGHT * 3];
} rig;

static void make_program(gl_program *out) {
    char folder[] = "nested_XXXXXX", path[64];
    assert_non_null(mkdtemp(folder));
    snprintf(path, sizeof path, "%s/hole.glsl", folder);
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fputs(shader, file);
    fclose(file);
    bolan_gl_program_set_directory(folder);
    assert_int_equal(bolan_gl_program_create("hole", NULL, out), BOLAN_OK);
    bolan_gl_program_set_directory(NULL);
    unlink(path);
    rmdir(folder);
}

// A gale of few waves: high, and quick to make.
static void rig_open(rig *r) {
    memset(r, 0, sizeof *r);
    bolan_sea_desc desc = bolan_sea_desc_default();
    desc.sea_state = bolan_sea_state_from_wind(18.0, 250.0, 400e3);
    desc.waves = BOLAN_WAVES_COSINES;
    desc.cosines.frequencies = 6;
    desc.cosines.directions = 3;
    assert_int_equal(bolan_sea_create(&desc, &r->sea), BOLAN_OK);
    r->scene = bolan_scene_default();
    assert_int_equal(bolan_water_mesh_create(&r->mesh, BOLAN_QUALITY_LOW, 0), BOLAN_OK);
    make_program(&r->program);
    gl_texture_desc color = {.format = GL_FMT_RGBA8, .width = WIDTH, .height = HEIGHT, .filter = GL_FILTER_NEAREST};
    assert_int_equal(bolan_gl_texture_create(&color, &r->color), BOLAN_OK);
    const gl_texture *colors[] = {&r->color};
    assert_int_equal(bolan_gl_target_create(colors, 1, NULL, -1, 0, &r->target), BOLAN_OK);
}

static void rig_close(rig *r) {
    bolan_gl_target_free(&r->target);
    bolan_gl_texture_free(&r->color);
    bolan_gl_program_free(&r->program);
    bolan_water_mesh_free(&r->mesh);
    bolan_sea_destroy(&r->sea);
}

static uint64_t seed = 5;
static double uniform(double low, double high) {
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * (double)(seed >> 11) * 0x1p-53;
}

// From over the highest wave to an airliner's height, mostly low; looking anywhere where there is water.
static void random_view(rig *r, double highest) {
    bolan_camera *c = &r->scene.camera;
    c->position = bolan_dv3(uniform(-1e6, 1e6), uniform(-1e6, 1e6), highest + 0.5 * exp(uniform(0.0, 10.0)));
    c->heading_deg = uniform(0.0, 360.0);
    c->pitch_deg = uniform(-1.0, 1.0) * uniform(0.0, 90.0) - 5.0;
    c->pitch_deg = fmax(fmin(c->pitch_deg, 20.0), -90.0);
    c->roll_deg = uniform(0.0, 1.0) < 0.3 ? uniform(-40.0, 40.0) : 0.0;
    c->fov_deg = uniform(5.0, 100.0);
    r->mesh.nested.cells = 4u * (uint32_t)uniform(2.0, 7.0); // 8..24
    r->mesh.nested.levels = (uint32_t)uniform(1.0, 8.0);
    const uint32_t least =
        r->mesh.nested.cells < 12 ? 12 : 8; // else level 0 of so few cells does not resemble a round earth
    r->mesh.nested.levels = r->mesh.nested.levels > least ? least : r->mesh.nested.levels;
    bolan_sea_step(r->sea, uniform(0.0, 1e5));
    r->step = (frame){.sea = r->sea,
                      .water = {.sea = r->sea},
                      .lighting = bolan_lighting_from_scene(&r->scene),
                      .time = bolan_sea_time(r->sea)};
    const bolan_view view = bolan_view_from_camera(c, WIDTH, HEIGHT);
    bolan_view_open(&r->f, &r->step, &view, false);
    r->f.shore = &r->shore;
}

static bolan_mat4 draw(rig *r) {
    const bolan_camera *c = &r->scene.camera;
    bolan_water_mesh_build(&r->mesh, &r->f, BOLAN_SURFACE_NESTED, WATER_MESH, (mesh_wishes){0}, NULL);
    bolan_mat4 clip = bolan_m4_mul(bolan_m4_projection(bolan_radians(c->fov_deg), (double)WIDTH / HEIGHT, 0.1, 0),
                                   bolan_m4_view(c->heading_deg, c->pitch_deg, c->roll_deg));
    bolan_mat4 rows = bolan_m4_transpose(clip);
    bolan_gl_target_bind(&r->target);
    bolan_gl_set_state(&(gl_state){.color_write = true});
    bolan_gl_target_clear_color(1.0f, 0.0f, 1.0f, 1.0f);
    bolan_gl_program_use(&r->program);
    bolan_gl_program_vec4_array(&r->program, "row", rows.m, 4);
    bolan_water_mesh_draw(&r->mesh);
    read_bytes(r->target.id, WIDTH, HEIGHT, r->pixels);
    return bolan_m4_inverse(clip);
}

// Whether a ray must meet the water: it meets a round earth that lies as deep as the deepest trough and the chords of
// the coarsest cells, and a pixel's width before its horizon.
static bool must_be_water(const rig *r, bolan_vec4 far, double low) {
    const double plan = hypot((double)far.x, (double)far.y), h = r->scene.camera.position.z + low;
    const double pixel = 2.0 * tan(0.5 * bolan_radians(r->scene.camera.fov_deg)) / HEIGHT;
    return atan2(-(double)far.z, plan) > sqrt(2.0 * h / BOLAN_EARTH_RADIUS) + 1.5 * pixel;
}

static uint32_t holes(const rig *r, bolan_mat4 from_clip, double low) {
    uint32_t count = 0;
    for (uint32_t y = 0; y < HEIGHT; ++y)
        for (uint32_t x = 0; x < WIDTH; ++x) {
            const uint8_t *p = &r->pixels[3 * (y * WIDTH + x)];
            if (p[1] > 128) continue;
            bolan_vec4 at = {(2.0f * (float)x + 1.0f) / WIDTH - 1.0f, 1.0f - (2.0f * (float)y + 1.0f) / HEIGHT, 1.0f,
                             1.0f};
            bolan_vec4 ray = bolan_m4_mul_v4(from_clip, at); // w > 0 on the near plane
            if (must_be_water(r, ray, low)) ++count;
        }
    return count;
}

static void look(uint32_t views) {
    rig *r = malloc(sizeof *r);
    rig_open(r);
    double highest, horizontal;
    bolan_sea_bounds(r->sea, &highest, &horizontal);
    uint32_t water = 0;
    for (uint32_t i = 0; i < views; ++i) {
        random_view(r, highest);
        bolan_mat4 from_clip = draw(r);
        // a chord of the coarsest cells lies d^2 / 8 R under the round earth, and their diagonal is sqrt(2) d
        const double d = r->mesh.placed.level[0].spacing, sag = d * d / (4.0 * BOLAN_EARTH_RADIUS);
        const uint32_t found = holes(r, from_clip, highest + sag);
        const bolan_camera *c = &r->scene.camera;
        if (found > 0)
            fail_msg("view %u: %u pixels of background; n %u, %u levels, camera %.3f,%.3f,%.3f,%.3f,%.3f,%.3f roll "
                     "%.3f at %.3f s",
                     i, found, r->mesh.placed.cells, r->mesh.placed.levels, c->position.x, c->position.y, c->position.z,
                     c->heading_deg, c->pitch_deg, c->fov_deg, c->roll_deg, r->step.time);
        for (uint32_t k = 0; k < WIDTH * HEIGHT; ++k) water += r->pixels[3 * k + 1] > 128;
    }
    assert_true(water / views > WIDTH * HEIGHT / 4); // the views do show water
    rig_close(r);
    free(r);
}

static void ten_thousand_views_have_no_hole(void **state) {
    (void)state;
    look(test_is_short() ? VIEWS / 40 : VIEWS);
}

static void five_hundred_views_have_no_hole_in_es(void **state) {
    (void)state;
    look(test_is_short() ? VIEWS_ES / 40 : VIEWS_ES);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(ten_thousand_views_have_no_hole, gl_setup_core, gl_teardown),
        cmocka_unit_test_setup_teardown(five_hundred_views_have_no_hole_in_es, gl_setup_es, gl_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

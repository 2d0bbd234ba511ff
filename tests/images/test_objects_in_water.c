// SPDX-License-Identifier: MIT
// Objects on open water: their shadow, the part below the surface, the wet line, and no surf at a hull.
#include "bolan/ground.h"
#include "bolan/model.h"
#include "picture.h"
#include "shared/wet.glsl"
#include "support.h"

static bolan_context *context;

static int open_context(void **state) {
    (void)state;
    return bolan_context_create(BOLAN_GL_CORE, &context) == BOLAN_OK ? 0 : -1;
}

static int close_context(void **state) {
    (void)state;
    bolan_context_destroy(&context);
    return 0;
}

// A box about the origin of its model, x east, y north, z up [m].
static void write_box(const char *path, double x, double y, double z) {
    FILE *f = fopen(path, "w");
    assert_non_null(f);
    for (int i = 0; i < 8; ++i) // of a file: y up, z towards the south
        fprintf(f, "v %g %g %g\n", i & 1 ? x : -x, i & 4 ? z : -z, i & 2 ? -y : y);
    fprintf(f, "f 1 2 6 5\nf 2 4 8 6\nf 4 3 7 8\nf 3 1 5 7\nf 5 6 8 7\nf 1 3 4 2\n");
    fclose(f);
}

static bolan_scene open_water(double wind, const char *model, bolan_dvec3 place) {
    bolan_scene scene = bolan_scene_default();
    bolan_scene_set_wind(&scene, wind, 240.0);
    scene.sky.cloud_cover = 0.0;
    scene.sky.sun_azimuth_deg = 90.0;
    scene.sky.sun_elevation_deg = 45.0;
    scene.camera.roll_deg = 0.0;
    scene.camera.heading_deg = 0.0;
    scene.object_count = 1;
    scene.objects[0] = (bolan_object){.position = place, .scale = 1.0};
    snprintf(scene.objects[0].model, sizeof scene.objects[0].model, "%s", model);
    return scene;
}

// The light that leaves the water as the sun and the sky enter it, nothing else.
#define LIGHT_OF_THE_WATER BOLAN_EFFECT_AMBIENT

static void a_shadow_lies_where_the_sun_puts_it(void **state) {
    (void)state;
    enum { SIZE = 128 };
    const double above = 10.0, eye = 6.0, half = 0.5 * SIZE; // a field of view of 90 degrees
    write_box("box.obj", 1.0, 1.0, 1.0);
    bolan_scene scene = open_water(0.0, "box.obj", bolan_dv3(0.0, 0.0, above));
    scene.look.effects = LIGHT_OF_THE_WATER;
    const double middle = above - 1.0 + 0.56 * 2.0; // of the ellipsoid
    scene.camera = (bolan_camera){.position = {-middle, 0.0, eye}, .pitch_deg = -90.0, .fov_deg = 90.0};
    float *one = stage_radiance(&scene, SIZE, SIZE);
    scene.objects[1] = scene.objects[0], scene.object_count = 2;
    float *two = stage_radiance(&scene, SIZE, SIZE);
    scene.object_count = 1, scene.objects[0].position.y = 100.0;
    float *none = stage_radiance(&scene, SIZE, SIZE);
    const float *a = one + 3 * (SIZE / 2), *b = two + 3 * (SIZE / 2), *c = none + 3 * (SIZE / 2); // a column
    // Across the sun's azimuth the shadow has the radius of the box, 1 m; its soft edge is half dark at sqrt(.85).
    const int at = SIZE / 2;
    const double lit = (double)c[3 * SIZE * at + 1], dark = (double)a[3 * SIZE * at + 1];
    int first = 0, last = SIZE - 1;
    while ((double)a[3 * SIZE * first + 1] > 0.5 * (lit + dark)) ++first;
    while ((double)a[3 * SIZE * last + 1] > 0.5 * (lit + dark)) --last;
    print_message("shadow: %.3f of the light, radius %.3f m\n", dark / lit, 0.5 * (last - first) * eye / half);
    const double pixel = eye / half;
    assert_near(0.5 * (last + 1 - first) * pixel, 0.922, pixel);
    assert_near(0.5 * (last + 1 + first), half, 1.0); // under the ray through the middle
    // Of the sunlight S over the sky's K one box leaves .18 S + K, two leave .18^2 S + K.
    const double twice = (double)b[3 * SIZE * at + 1];
    assert_near((lit - dark) / (lit - twice), 0.82 / (1.0 - 0.18 * 0.18), 0.005); // half floats
    assert_near((double)a[1] / (double)c[1], 1.0, 1e-3);                          // outside of it
    free(one), free(two), free(none);
}

// Beer's law both ways, over the water's own light: seen straight down.
static void the_part_below_dims_by_its_depth(void **state) {
    (void)state;
    static const double depths[3] = {1.0, 3.0, 6.0};
    double seen[4][3] = {{0.0}};
    write_box("plate.obj", 20.0, 20.0, 0.1);
    bolan_scene scene = open_water(0.0, "plate.obj", bolan_dv3(0.0, 0.0, 0.0));
    scene.water.type = BOLAN_JERLOV_III;
    scene.look.effects = BOLAN_EFFECTS_ALL & ~(unsigned)(BOLAN_EFFECT_REFLECTION | BOLAN_EFFECT_GLITTER |
                                                         BOLAN_EFFECT_FOAM | BOLAN_EFFECT_CAUSTICS);
    scene.camera = (bolan_camera){.position = {0.0, 0.0, 3.0}, .pitch_deg = -90.0, .fov_deg = 10.0};
    for (int i = 0; i < 4; ++i) {
        scene.objects[0].position.z = i < 3 ? -depths[i] - 0.1 : 0.0;
        scene.object_count = i < 3;
        float *rgb = stage_radiance(&scene, 16, 16);
        for (int j = 0; j < 256; ++j)
            for (int k = 0; k < 3; ++k) seen[i][k] += (double)rgb[3 * j + k] / 256.0;
        free(rgb);
    }
    const bolan_vec3 kd = bolan_water_optics_from_jerlov(BOLAN_JERLOV_III).kd;
    for (int i = 1; i < 3; ++i)
        for (int k = 0; k < 3; ++k) {
            const double left = (seen[i][k] - seen[3][k]) / (seen[0][k] - seen[3][k]);
            const double expected = exp(-2.0 * (depths[i] - depths[0]) * (double)(&kd.x)[k]);
            print_message("%g m, band %d: %.4f, expected %.4f\n", depths[i], k, left, expected);
            if (expected > 0.02) assert_near(left / expected, 1.0, 0.02); // the bound of a plate seen from below
        }
}

static double row_mean(const float *rgb, int width, int row) {
    double sum = 0.0;
    for (int x = width / 8; x < width - width / 8; ++x) sum += (double)rgb[3 * (row * width + x) + 1];
    return sum;
}

static void a_wall_is_wet_where_waves_reach_it(void **state) {
    (void)state;
    enum { WIDTH = 1024, HEIGHT = 128 };
    // Angstrom 1925, index 1.33: albedo .5 -> .361, .1 -> .0591
    assert_near(wet_albedo(0.5f, 1.33f), 0.361, 0.001);
    assert_near(wet_albedo(0.1f, 1.33f), 0.0591, 0.0001);
    write_box("wall.obj", 20.0, 0.2, 2.0);
    bolan_scene scene = open_water(0.0, "wall.obj", bolan_dv3(0.0, 4.0, 0.0));
    scene.sky.sun_azimuth_deg = 180.0;
    scene.camera = (bolan_camera){.position = {0.0, 0.0, 0.25}, .fov_deg = 10.0};
    bolan_model *model = NULL;
    const bolan_model_desc desc = {.path = "wall.obj"};
    assert_int_equal(bolan_model_load(&desc, &model), BOLAN_OK);
    const float albedo = bolan_model_get_view(model).colors[0].y;
    bolan_model_destroy(&model);
    float *rgb = stage_radiance(&scene, WIDTH, HEIGHT);
    const double metre = 0.5 * HEIGHT / tan(bolan_radians(5.0)) / 3.8; // pixels a metre of the wall
    const int over = (int)(0.25 * metre);                              // rows from the middle down to the water
    double wet = 0.0, dry = 0.0;
    for (int i = 0; i < 3; ++i) {
        wet += row_mean(rgb, WIDTH, HEIGHT / 2 + over - 2 - i);
        dry += row_mean(rgb, WIDTH, HEIGHT / 2 + over - (int)(0.2 * metre) - i);
    }
    const double expected = (double)(wet_albedo(albedo, 1.34f) / albedo);
    print_message("wet over dry: %.3f, expected %.3f\n", wet / dry, expected);
    assert_near(wet / dry / expected, 1.0, 0.06); // grain of the wall
    free(rgb);
}

// Swash belongs to a bed that the water runs up, not to a hull that it laps.
static void no_surf_breaks_at_a_hull(void **state) {
    (void)state;
    enum { WIDTH = 160, HEIGHT = 90 };
    bolan_scene scene = open_water(0.0, "builtin:boat", bolan_dv3(0.0, 8.0, 0.0));
    scene.objects[0].heading_deg = 70.0;
    scene.objects[0].floats = true;
    scene.camera = (bolan_camera){.position = {0.0, 0.0, 2.0}, .pitch_deg = -12.0, .fov_deg = 40.0};
    float *with = stage_radiance(&scene, WIDTH, HEIGHT);
    scene.look.effects &= ~(unsigned)BOLAN_EFFECT_FOAM;
    float *without = stage_radiance(&scene, WIDTH, HEIGHT);
    double most = 0.0;
    for (int i = 0; i < 3 * WIDTH * HEIGHT; ++i)
        most = fmax(most, fabs((double)with[i] - (double)without[i]) / ((double)without[i] + 0.05));
    print_message("foam changes a pixel by %.4f of its radiance at most\n", most);
    assert_true(most < 0.03); // rare crests that foam without wind
    free(with), free(without);
}

enum { BED_SIZE = 160 };

// The view from straight above over a level bed and, or not, the box at the scene's first object.
static float *bed_radiance(const bolan_scene *scene, float bed, bool box) {
    bolan_scene copy = *scene, bare = *scene;
    copy.object_count = box;
    bare.object_count = 0;
    stage s;
    assert_true(stage_open(&s, &bare, BOLAN_QUALITY_MEDIUM, false));
    stage_over_bed(&s, &copy, bed);
    return stage_last_radiance(&s, BED_SIZE, BED_SIZE);
}

// Where the light that a box at that height takes is missing on the bed: the mean place to the west of the picture's
// middle [m], and the greatest loss.
static double shadow_west(const bolan_scene *scene, float bed, double metres, double *most) {
    float *with = bed_radiance(scene, bed, true), *without = bed_radiance(scene, bed, false);
    double sum = 0.0, moment = 0.0;
    *most = 0.0;
    for (int i = 0; i < BED_SIZE * BED_SIZE; ++i) {
        const double loss = 1.0 - (double)with[3 * i + 1] / (double)without[3 * i + 1];
        if (loss < 0.05) continue;
        *most = fmax(*most, loss);
        sum += loss, moment += loss * (0.5 * BED_SIZE - (i % BED_SIZE + 0.5)) * metres;
    }
    free(with), free(without);
    return moment / sum;
}

// The shadow lies where the bent ray past the box meets the bed: h tan 45 degrees in the air to the west, and by
// Snell's law d tan(asin(sin 45 / 1.34)) in the water. The eye sees depths at d / 1.34.
static void a_shadow_falls_through_the_water_on_the_bed(void **state) {
    (void)state;
    const double depth = 3.0, eye = 30.0, middle_over = 0.12; // of the ellipsoid over the box
    const double bent = tan(asin(sin(bolan_radians(45.0)) / 1.34));
    write_box("box.obj", 1.0, 1.0, 1.0);
    bolan_scene scene = open_water(0.0, "box.obj", bolan_dv3(0.0, 0.0, 6.0));
    scene.look.effects = BOLAN_EFFECT_REFRACTION;
    scene.camera = (bolan_camera){.position = {-8.5, 0.0, eye}, .pitch_deg = -90.0, .fov_deg = 14.0};
    const double metres = (eye + depth / 1.34) * 2.0 * tan(bolan_radians(7.0)) / BED_SIZE;
    double most;
    const double air = -8.5 - shadow_west(&scene, (float)-depth, metres, &most);
    const double expected = -(6.0 + middle_over) - depth * bent;
    print_message("over the water: shadow at %.3f m, expected %.3f, %.2f of the light gone\n", air, expected, most);
    assert_near(air, expected, 0.1); // a texel of the ground's noise
    assert_true(most > 0.3);
    // A box in the water throws one too, along the bent ray alone.
    scene.objects[0].position.z = -2.0;
    scene.camera.position.x = -3.2, scene.camera.fov_deg = 8.0; // the box is out of sight
    write_box("box.obj", 0.25, 0.25, 0.25);
    const double deep = 6.0, metres_deep = (eye + deep / 1.34) * 2.0 * tan(bolan_radians(4.0)) / BED_SIZE;
    const double wet = -3.2 - shadow_west(&scene, (float)-deep, metres_deep, &most);
    const double wet_expected = -(deep - 2.0 + 0.25 * middle_over) * bent;
    print_message("in the water: %.3f, expected %.3f\n", wet, wet_expected);
    assert_near(wet, wet_expected, 0.1);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_shadow_lies_where_the_sun_puts_it),
        cmocka_unit_test(the_part_below_dims_by_its_depth),
        cmocka_unit_test(a_wall_is_wet_where_waves_reach_it),
        cmocka_unit_test(no_surf_breaks_at_a_hull),
        cmocka_unit_test(a_shadow_falls_through_the_water_on_the_bed),
    };
    return cmocka_run_group_tests(tests, open_context, close_context);
}

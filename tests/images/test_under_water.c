// SPDX-License-Identifier: MIT
// The physical optics for an eye in the water: Snell's window, light by depth, the colour of the deep, the waterline of
// the surface that queries return, and caustics that lose no light.
#include "bolan/query.h"
#include "picture.h"
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

static bolan_scene open_water(double wind) {
    bolan_scene scene = bolan_scene_default();
    bolan_scene_set_wind(&scene, wind, 240.0);
    scene.sky.cloud_cover = 0.0;
    scene.sky.sun_elevation_deg = 60.0;
    scene.camera.position = bolan_dv3(0.0, 0.0, -3.0);
    scene.camera.roll_deg = 0.0;
    return scene;
}

static void mean_of(const float *rgb, uint32_t pixels, double mean[3]) {
    for (int k = 0; k < 3; ++k) {
        mean[k] = 0.0;
        for (uint32_t i = 0; i < pixels; ++i) mean[k] += (double)rgb[3 * i + (uint32_t)k] / pixels;
    }
}

static void snells_window_has_the_right_radius(void **state) {
    (void)state;
    enum { SIZE = 600 };
    const double fov = 110.0;
    bolan_scene scene = open_water(0.0);
    scene.look.effects = BOLAN_EFFECTS_ALL & ~(unsigned)(BOLAN_EFFECT_FOG | BOLAN_EFFECT_GLITTER);
    scene.camera.pitch_deg = 90.0;
    scene.camera.fov_deg = fov;
    float *rgb = stage_radiance(&scene, SIZE, SIZE);
    const float *row = rgb + 3 * (size_t)(SIZE / 2 * SIZE);
    const float inside = row[3 * (SIZE / 2) + 1], outside = row[3 * 2 + 1];
    assert_true(inside > 3.0f * outside);
    uint32_t first = 0, last = SIZE - 1;
    while (row[3 * first + 1] < 0.5f * (inside + outside) && first < SIZE / 2) ++first;
    while (row[3 * last + 1] < 0.5f * (inside + outside) && last > SIZE / 2) --last;
    const double half = 0.5 * SIZE / tan(bolan_radians(0.5 * fov));
    const double east = bolan_degrees(atan((last + 1 - 0.5 * SIZE) / half)),
                 west = bolan_degrees(atan((0.5 * SIZE - first) / half));
    print_message("Snell's window: %.2f and %.2f degrees\n", east, west);
    assert_near(0.5 * (east + west), 48.268, 0.5); // asin(1 / 1.34)
    assert_near(east, west, 0.3);
    free(rgb);
}

// A flat plate, level, 40 m wide.
static const char *plate(void) {
    static const char *const path = "plate.obj";
    FILE *f = fopen(path, "w");
    assert_non_null(f);
    fprintf(f, "v -20 0 -20\nv 20 0 -20\nv 20 0 20\nv -20 0 20\nf 1 4 3 2\n");
    fclose(f);
    return path;
}

static bolan_scene over_plate(double wind, double depth) {
    bolan_scene scene = open_water(wind);
    scene.object_count = 1;
    scene.objects[0] = (bolan_object){.position = {0.0, 0.0, -depth}, .scale = 1.0};
    snprintf(scene.objects[0].model, sizeof scene.objects[0].model, "%s", plate());
    scene.camera.position = bolan_dv3(0.0, 0.0, 1.5 - depth);
    scene.camera.pitch_deg = -90.0;
    scene.camera.fov_deg = 60.0;
    return scene;
}

// The acceptance number: exp(-Kd d) within 2 %.
static void a_plate_at_ten_metres_has_the_light_that_kd_leaves(void **state) {
    (void)state;
    static const bolan_jerlov types[] = {BOLAN_JERLOV_I, BOLAN_JERLOV_III, BOLAN_JERLOV_5C};
    for (int i = 0; i < 3; ++i) {
        double shallow[3], deep[3];
        bolan_scene scene = over_plate(0.0, 2.0);
        scene.water.type = types[i];
        scene.look.effects = BOLAN_EFFECTS_ALL & ~(unsigned)(BOLAN_EFFECT_FOG | BOLAN_EFFECT_CAUSTICS);
        float *rgb = stage_radiance(&scene, 32, 32);
        mean_of(rgb, 32 * 32, shallow);
        free(rgb);
        scene.objects[0].position.z -= 8.0;
        scene.camera.position.z -= 8.0;
        rgb = stage_radiance(&scene, 32, 32);
        mean_of(rgb, 32 * 32, deep);
        free(rgb);
        const bolan_vec3 kd = bolan_water_optics_from_jerlov(types[i]).kd;
        for (int k = 0; k < 3; ++k) {
            const double expected = exp(-8.0 * (double)(&kd.x)[k]), got = deep[k] / shallow[k];
            if (expected > 1e-3) assert_near(got / expected, 1.0, 0.02);
        }
    }
}

enum { PLATE_SIZE = 64 };

// Adds the radiance of a picture with some effects to that of others.
static void add_radiance(stage *s, unsigned effects, float *sum) {
    static float rgb[3 * PLATE_SIZE * PLATE_SIZE];
    s->scene.look.effects = effects;
    picture p = stage_draw(s, PLATE_SIZE, PLATE_SIZE, 1);
    bolan_renderer_read_linear(s->renderer, rgb, NULL);
    for (int i = 0; i < 3 * PLATE_SIZE * PLATE_SIZE; ++i) sum[i] += rgb[i];
    picture_free(&p);
}

// Mean light of a plate under these waves over that of flat light, and the rms contrast, at so many times; `eye`: its
// height over the mean water; with a bed, the plate lies on it. The contrast is at least `least`.
static void check_caustics(const bolan_technique *technique, double under, double eye, int times, bool bed,
                           double least) {
    const unsigned effects = BOLAN_EFFECTS_ALL & ~(unsigned)(BOLAN_EFFECT_FOG | BOLAN_EFFECT_REFLECTION |
                                                             BOLAN_EFFECT_GLITTER | BOLAN_EFFECT_FOAM);
    double with = 0.0, without = 0.0, contrast = 0.0;
    bolan_scene scene = over_plate(5.0, under);
    bolan_scene_set_technique(&scene, technique);
    scene.camera.position.z = eye;
    scene.camera.fov_deg = 90.0;
    stage s;
    assert_true(stage_open(&s, &scene, BOLAN_QUALITY_HIGH, false));
    if (bed) stage_over_bed(&s, &scene, (float)(-under - 0.01));
    for (int t = 0; t < times; ++t) {
        static float rgb[3 * PLATE_SIZE * PLATE_SIZE], flat[3 * PLATE_SIZE * PLATE_SIZE];
        double mean[3], plain[3];
        memset(rgb, 0, sizeof rgb), memset(flat, 0, sizeof flat);
        stage_step(&s, scene.time + 7.3 * t);
        add_radiance(&s, effects, rgb);
        add_radiance(&s, effects & ~(unsigned)BOLAN_EFFECT_CAUSTICS, flat);
        mean_of(rgb, PLATE_SIZE * PLATE_SIZE, mean);
        mean_of(flat, PLATE_SIZE * PLATE_SIZE, plain);
        with += mean[1], without += plain[1];
        for (uint32_t j = 0; j < PLATE_SIZE * PLATE_SIZE; ++j) {
            const double share = (double)rgb[3 * j + 1] / (double)flat[3 * j + 1] - 1.0;
            contrast += share * share / (PLATE_SIZE * PLATE_SIZE * times);
        }
    }
    stage_close(&s);
    print_message("%s, eye at %g m: %g m down: mean %.4f, rms contrast %.3f\n", technique->name, eye, under,
                  with / without, sqrt(contrast));
    assert_near(with / without, 1.0, 0.02);
    assert_true(sqrt(contrast) > least);
}

// The pattern has its mean where it has its contrast. From 1.5 m only 2 m of it are seen, some 40 spots of light with a
// contrast of 0.3: their mean over 24 moments is good to 1 %. Deeper plates show 500 and more, of
// both patches; there long waves pass (see below).
static void caustics_lose_no_light(void **state) {
    (void)state;
    static const struct {
        double under, eye;
        int times;
        double contrast; // 0.28, 0.26, 0.20 with the blur of a slanting sun; the wide patch alone: half of the first
    } plates[] = {{1.5, -0.6, 24, 0.26}, {4.0, -0.6, 8, 0.24}, {10.0, -3.6, 4, 0.1}};
    for (int i = 0; i < 3; ++i)
        check_caustics(&bolan_technique_ocean, plates[i].under, plates[i].eye, plates[i].times, true,
                       plates[i].contrast);
}

// Those of sums too, seen in the water and, where vertices carry the waves, from above. The few metres in view have 7 %
// more or less as long waves pass; the mean of eight moments is within 1 %.
static void every_synthesis_has_caustics(void **state) {
    (void)state;
    bolan_technique cosines = bolan_technique_ocean, exponential = bolan_technique_ocean;
    cosines.name = "cosines", cosines.waves = BOLAN_WAVES_COSINES;
    exponential.name = "exp-cosine", exponential.waves = BOLAN_WAVES_EXP_COSINE;
    check_caustics(&cosines, 4.0, -1.8, 8, false, 0.05);
    check_caustics(&cosines, 4.0, 3.0, 8, false, 0.05);
    check_caustics(&exponential, 4.0, -1.8, 8, false, 0.05);
}

// One wave that runs east: its wave number [rad/m] and amplitude [m], from zero crossings of what a query returns.
static void fit_wave(const bolan_water *water, double *k, double *amplitude) {
    enum { N = 4000 };
    static bolan_dvec2 at[N];
    static float h[N];
    const double step = 0.01;
    for (int i = 0; i < N; ++i) at[i] = (bolan_dvec2){step * i, 0.0};
    bolan_query_heights(water, at, N, h);
    double first = -1.0, last = 0.0;
    int crossings = 0;
    *amplitude = 0.0;
    for (int i = 1; i < N; ++i) {
        *amplitude = fmax(*amplitude, fabs((double)h[i]));
        if ((h[i] < 0.0f) == (h[i - 1] < 0.0f)) continue;
        last = step * (i - (double)h[i] / ((double)h[i] - (double)h[i - 1]));
        if (first < 0.0) first = last;
        ++crossings;
    }
    *k = BOLAN_PI * (crossings - 1) / (last - first);
}

// The acceptance number: the first focus within 5 %. Under a crest of a cos k x the light is 1 / (1 - depth / f), f = n
// / ((n - 1) a k^2): Snell's law for a thin lens of curvature a k^2.
static void a_single_wave_gathers_light_at_its_first_focus(void **state) {
    (void)state;
    enum { SIZE = 192 };
    const double depth = 10.0, index = 1.34;
    bolan_scene scene = over_plate(0.0, depth);
    bolan_technique technique = bolan_technique_ocean;
    technique.waves = BOLAN_WAVES_EXP_COSINE; // of low sharpness: a cosine
    bolan_scene_set_technique(&scene, &technique);
    scene.sea.exp_cosine.wave_count = 1;
    scene.sea.exp_cosine.sharpness = 0.01;
    scene.wind_sea = false;
    scene.sea.sea_state.system_count = 0;
    bolan_wave_system system = bolan_wave_system_default();
    system.hs = 0.33, system.peak_omega = 3.2, system.from_deg = 270.0;
    assert_int_equal(bolan_sea_state_add_system(&scene.sea.sea_state, &system), BOLAN_OK);
    scene.water.type = BOLAN_JERLOV_I;
    scene.sky.sun_elevation_deg = 90.0;
    scene.camera.heading_deg = 0.0;
    scene.camera.position.z = 6.0 - depth;
    scene.look.effects = BOLAN_EFFECTS_ALL & ~(unsigned)BOLAN_EFFECT_FOG;
    stage s;
    assert_true(stage_open(&s, &scene, BOLAN_QUALITY_HIGH, false));
    double k, amplitude;
    fit_wave(bolan_world_water(s.world), &k, &amplitude);
    stage_close(&s);
    float *rgb = stage_radiance(&scene, SIZE, SIZE);
    scene.look.effects &= ~(unsigned)BOLAN_EFFECT_CAUSTICS;
    float *flat = stage_radiance(&scene, SIZE, SIZE);
    double most = 0.0;
    for (int x = 0; x < SIZE; ++x) {
        double with = 0.0, without = 0.0;
        for (int y = SIZE / 4; y < 3 * SIZE / 4; ++y) {
            with += (double)rgb[3 * (y * SIZE + x) + 1];
            without += (double)flat[3 * (y * SIZE + x) + 1];
        }
        most = fmax(most, with / without);
    }
    // Three quarters of an object's light are the sun's; what is scattered once on the way leaves the pattern.
    const double scattering = (double)bolan_water_optics_from_jerlov(BOLAN_JERLOV_I).scattering.y;
    const double crest = 1.0 + (most - 1.0) / (0.75 * exp(-0.5 * scattering * depth));
    const double focus = depth / (1.0 - 1.0 / crest), expected = index / ((index - 1.0) * amplitude * k * k);
    print_message("crest %.3f; focus at %.2f m, expected %.2f m\n", crest, focus, expected);
    assert_true(expected > 1.5 * depth); // the law holds before the focus
    assert_near(focus / expected, 1.0, 0.05);
    free(rgb);
    free(flat);
}

// A shallow plate is bright where the light entered by a crest, which gathers it, and dim by a trough. Correlation of
// light and height, in the wide patch or, on a bed, in the near one.
static double light_by_height(bool bed) {
    enum { SIZE = 128 };
    const double depth = 1.5, above = 1.0, half = 0.5 * SIZE; // a field of view of 90 degrees
    bolan_scene scene = over_plate(5.0, depth);
    scene.sky.sun_azimuth_deg = 90.0;
    scene.camera.heading_deg = 0.0;
    scene.camera.position.z = above - depth;
    scene.camera.fov_deg = 90.0;
    scene.look.effects = BOLAN_EFFECTS_ALL & ~(unsigned)BOLAN_EFFECT_FOG;
    stage s;
    assert_true(stage_open(&s, &scene, BOLAN_QUALITY_HIGH, false));
    if (bed) stage_over_bed(&s, &scene, (float)(-depth - 0.01));
    picture p = stage_draw(&s, SIZE, SIZE, 1);
    float *rgb = malloc(sizeof(float) * 3 * SIZE * SIZE);
    bolan_renderer_read_linear(s.renderer, rgb, NULL);
    const double sine = cos(bolan_radians(60.0)) / 1.34, travel = sine / sqrt(1.0 - sine * sine); // away from the sun
    double lh = 0.0, ll = 0.0, hh = 0.0, l1 = 0.0, h1 = 0.0;
    for (int i = 0; i < SIZE * SIZE; ++i) {
        const double east = above * (i % SIZE + 0.5 - half) / half, north = above * (half - i / SIZE - 0.5) / half;
        const bolan_dvec2 entry = {east + travel * depth, north};
        float height;
        bolan_query_heights(bolan_world_water(s.world), &entry, 1, &height);
        const double l = (double)rgb[3 * i + 1], h = (double)height;
        lh += l * h, ll += l * l, hh += h * h, l1 += l, h1 += h;
    }
    const double n = SIZE * SIZE, covariance = lh - l1 * h1 / n;
    const double correlation = covariance / sqrt((ll - l1 * l1 / n) * (hh - h1 * h1 / n));
    print_message("correlation of light and height%s: %.3f\n", bed ? " on a bed" : "", correlation);
    free(rgb);
    picture_free(&p);
    stage_close(&s);
    return correlation;
}

static void crests_gather_the_light(void **state) {
    (void)state;
    assert_true(light_by_height(false) > 0.2);
    assert_true(light_by_height(true) > 0.15); // short waves gather more of it, which are not high
}

// Straight down into the deep, just under the surface, is seen what leaves the water, times n^2 and the rest of
// BED_LEAVES.
static void the_deep_has_the_colour_that_is_seen_from_above(void **state) {
    (void)state;
    bolan_scene scene = open_water(0.0);
    scene.look.effects = BOLAN_EFFECTS_ALL & ~(unsigned)(BOLAN_EFFECT_REFLECTION | BOLAN_EFFECT_GLITTER |
                                                         BOLAN_EFFECT_FOAM | BOLAN_EFFECT_CAUSTICS);
    scene.camera.pitch_deg = -90.0;
    scene.camera.fov_deg = 10.0;
    scene.camera.position.z = 3.0;
    double above[3], below[3];
    float *rgb = stage_radiance(&scene, 32, 32);
    mean_of(rgb, 32 * 32, above);
    free(rgb);
    scene.camera.position.z = -0.7;
    rgb = stage_radiance(&scene, 32, 32);
    mean_of(rgb, 32 * 32, below);
    free(rgb);
    const bolan_vec3 kd = bolan_water_optics_from_jerlov(scene.water.type).kd;
    for (int k = 0; k < 3; ++k) {
        const double expected = 1.0 / (0.54 * (1.0 - 0.0211)) * exp(-0.7 * (double)(&kd.x)[k]);
        print_message("under over above: %.4f, expected %.4f\n", below[k] / above[k], expected);
        assert_near(below[k] / above[k] / expected, 1.0, k == 0 ? 0.08 : 0.03); // red is as dim as the air before it
    }
}

// The meniscus is darkest where the near plane, 0.12 m away, cuts the surface that queries return.
static void the_waterline_is_that_of_the_queries(void **state) {
    (void)state;
    enum { SIZE = 240 };
    const double near = 0.12, fov = 60.0, half = 0.5 * SIZE / tan(bolan_radians(0.5 * fov));
    bolan_scene scene = open_water(6.0);
    scene.camera.heading_deg = 0.0;
    scene.camera.pitch_deg = 0.0;
    scene.camera.fov_deg = fov;
    stage s;
    assert_true(stage_open(&s, &scene, BOLAN_QUALITY_HIGH, false));
    float *rgb = malloc(sizeof(float) * 3 * SIZE * SIZE), height;
    int found = 0;
    for (int place = 0; place < 4; ++place) {
        const bolan_dvec2 eye = {13.7 * place, 1e5 - 7.3 * place};
        bolan_query_heights(bolan_world_water(s.world), &eye, 1, &height);
        s.scene.camera.position = bolan_dv3(eye.x, eye.y, (double)height);
        picture p = stage_draw(&s, SIZE, SIZE, 1);
        bolan_renderer_read_linear(s.renderer, rgb, NULL);
        picture_free(&p);
        for (int x = 10; x < SIZE; x += 20) {
            const bolan_dvec2 at = {eye.x + near * (x + 0.5 - 0.5 * SIZE) / half, eye.y + near};
            float there;
            bolan_query_heights(bolan_world_water(s.world), &at, 1, &there);
            const double row = 0.5 * SIZE - ((double)there - (double)height) / near * half;
            if (row < 12.0 || row > SIZE - 12.0) continue;
            int darkest = (int)row;
            double least = 1e9;
            for (int y = (int)row - 8; y <= (int)row + 8; ++y) {
                const double light = (double)rgb[3 * (SIZE * y + x) + 1];
                if (light < least) least = light, darkest = y;
            }
            assert_near(darkest + 0.5, row, 1.5);
            ++found;
        }
    }
    print_message("%d places of the waterline\n", found);
    assert_true(found > 20);
    free(rgb);
    stage_close(&s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(snells_window_has_the_right_radius),
        cmocka_unit_test(a_plate_at_ten_metres_has_the_light_that_kd_leaves),
        cmocka_unit_test(caustics_lose_no_light),
        cmocka_unit_test(every_synthesis_has_caustics),
        cmocka_unit_test(crests_gather_the_light),
        cmocka_unit_test(a_single_wave_gathers_light_at_its_first_focus),
        cmocka_unit_test(the_deep_has_the_colour_that_is_seen_from_above),
        cmocka_unit_test(the_waterline_is_that_of_the_queries),
    };
    return cmocka_run_group_tests(tests, open_context, close_context);
}

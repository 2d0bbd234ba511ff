// SPDX-License-Identifier: MIT
// Laws of the light in pictures of every technique: how wide the sun's glitter is, what a layer of water lets through,
// how white foam is; and the sea runs the way the wind blows.
#include "bolan/content.h"
#include "picture.h"
#include "support.h"

enum { SIZE = 96 };

static bolan_context *context;
static stage the_stage; // one renderer serves all, so that its programs are made once

static int open_context(void **state) {
    (void)state;
    return bolan_context_create(BOLAN_GL_CORE, &context) == BOLAN_OK ? 0 : -1;
}

static int close_context(void **state) {
    (void)state;
    stage_close(&the_stage);
    bolan_context_destroy(&context);
    return 0;
}

static stage *set_stage(const bolan_scene *scene) {
    stage *s = &the_stage;
    if (!s->renderer) {
        assert_true(stage_open(s, scene, BOLAN_QUALITY_MEDIUM, false));
        return s;
    }
    assert_true(stage_load(s, scene));
    return s;
}

// A clear sky, the eye straight above, north up.
static bolan_scene from_above(const char *name, const bolan_technique *technique, double height, double fov) {
    bolan_scene scene;
    assert_int_equal(bolan_scene_load(name, &scene), BOLAN_OK);
    bolan_scene_set_technique(&scene, technique);
    scene.sea.resolution = 64;
    scene.sky.cloud_cover = 0.0;
    scene.camera = (bolan_camera){.position = {0.0, 0.0, height}, .pitch_deg = -90.0, .fov_deg = fov};
    return scene;
}

// Linear radiance of the picture: SIZE x SIZE x 3.
static float *radiance(stage *s) {
    float *rgb = malloc(sizeof(float) * 3 * SIZE * SIZE);
    picture p = stage_draw(s, SIZE, SIZE, 1);
    bolan_renderer_read_linear(s->renderer, rgb, NULL);
    picture_free(&p);
    return rgb;
}

static float *radiance_with(stage *s, unsigned effects) {
    s->scene.look.effects = effects;
    return radiance(s);
}

// ---- glitter --------------------------------------------------------------------------------------------------------

// Means of s s^T of the slopes that mirror the sun into the picture: a sun straight above lights a pixel r = tan(theta)
// from the middle by facets of slope tan(theta / 2), with a radiance of p(s) F / (4 cos^4 cos theta).
static void glitter_moments(const float *glitter, double tangent, double out[3]) {
    double sum = 0.0, moment[3] = {0};
    for (int i = 0; i < SIZE * SIZE; ++i) {
        const double x = (2.0 * (i % SIZE + 0.5) / SIZE - 1.0) * tangent;
        const double y = (1.0 - 2.0 * (i / SIZE + 0.5) / SIZE) * tangent;
        const double r = hypot(x, y), theta = atan(r), slope = tan(0.5 * theta), up = cos(0.5 * theta);
        const double fresnel = (double)bolan_fresnel((float)up, 1.34f);
        // d(slope) / d(picture): along r by ds/dr, across by s/r
        const double area = 0.5 / (up * up) * cos(theta) * cos(theta) * slope / r;
        const double weight = (double)glitter[3 * i + 1] * 4.0 * pow(up, 4.0) * cos(theta) / fresnel * area;
        sum += weight;
        moment[0] += weight * slope * slope * x * x / (r * r);
        moment[1] += weight * slope * slope * x * y / (r * r);
        moment[2] += weight * slope * slope * y * y / (r * r);
    }
    for (int k = 0; k < 3; ++k) out[k] = moment[k] / sum;
}

// Patches of rougher and smoother water are kilometres wide: the mean over places as far from each other.
enum { PLACES = 5 };

static void measure_glitter(stage *s, unsigned effect, double out[3]) {
    for (int k = 0; k < 3; ++k) out[k] = 0.0;
    for (int place = 0; place < PLACES; ++place) {
        s->scene.camera.position.x = 9300.0 * place, s->scene.camera.position.y = -7100.0 * place * place;
        float *with = radiance_with(s, BOLAN_EFFECTS_ALL), *without = radiance_with(s, BOLAN_EFFECTS_ALL & ~effect);
        double moments[3];
        for (int i = 0; i < 3 * SIZE * SIZE; ++i) with[i] -= without[i];
        glitter_moments(with, tan(bolan_radians(55.0)), moments);
        for (int k = 0; k < 3; ++k) out[k] += moments[k] / PLACES;
        free(with);
        free(without);
    }
}

// The brightness-weighted width of the glitter is that of the slopes (Cox & Munk 1954), along and across the wind.
// `least`, `most`: bounds of its size, relative.
static void check_glitter(const bolan_technique *technique, unsigned effect, double from, double least, double most) {
    bolan_scene scene = from_above("open-sea", technique, 400.0, 110.0);
    scene.sea.sea_state = bolan_sea_state_from_wind(8.0, from, 3e5);
    scene.sky.sun_elevation_deg = 89.9;
    scene.sky.visibility = 300000.0;
    scene.look.shininess = 4096.0;
    stage *s = set_stage(&scene);
    double got[3];
    float want[3];
    measure_glitter(s, effect, got);
    bolan_sea_unresolved_slopes(stage_sea(s), 1e5, 1e5, 0.0, want);
    const double size = got[0] + got[2], all = (double)(want[0] + want[2]);
    print_message("%s, wind from %.0f: %.4f of %.4f; %.3f %+.3f %.3f, not %.3f %+.3f %.3f\n", technique->name, from,
                  size, all, got[0] / size, got[1] / size, got[2] / size, (double)want[0] / all, (double)want[1] / all,
                  (double)want[2] / all);
    assert_true(size > least * all && size < most * all);
    if (technique == &bolan_technique_two_triangle) return; // the sun on its slide is round
    for (int k = 0; k < 3; ++k) assert_near(got[k] / size, (double)want[k] / all, 0.015);
}

// The acceptance number is 10 % of the slope variance. The gusts of five places scatter by 10 % more; the tone of the
// slide's perspective and the missing 1 / cos^4 of its light take a quarter from the mirror optics' glitter (at 16
// degrees rms).
static void the_glitter_is_as_wide_as_the_slopes(void **state) {
    (void)state;
    for (int k = 0; k < 2; ++k) {
        const double from = k ? 30.0 : 270.0;
        check_glitter(&bolan_technique_two_triangle, BOLAN_EFFECT_GLITTER, from, 0.6, 0.9);
        check_glitter(&bolan_technique_exp_cosine, BOLAN_EFFECT_SPECULAR, from, 0.9, 1.1);
        check_glitter(&bolan_technique_nested_grid, BOLAN_EFFECT_SPECULAR, from, 0.8, 1.2);
        check_glitter(&bolan_technique_flight_sim, BOLAN_EFFECT_GLITTER, from, 0.8, 1.2);
    }
}

// ---- the bed --------------------------------------------------------------------------------------------------------

// Radiance of the pond's bed from straight above through water of a type; nothing else is lit.
static float *bed_of(const bolan_technique *technique, bolan_jerlov type, bolan_dvec2 at) {
    bolan_scene scene = from_above("pond", technique, 12.0, 30.0);
    scene.camera.position.x = at.x, scene.camera.position.y = at.y;
    scene.water.type = type;
    scene.look.blend = 1.0;
    bolan_scene_set_wind(&scene, 0.0, 0.0);
    return radiance_with(set_stage(&scene), BOLAN_EFFECT_REFRACTION | BOLAN_EFFECT_FOG);
}

// Least squares of ln(clear / turbid) by the depth: light that goes down and straight up again is attenuated twice.
static void check_bed(const bolan_technique *technique) {
    const bolan_dvec2 at = {0.0, -16.0};
    const float *clear = bed_of(technique, BOLAN_JERLOV_I, at), *turbid = bed_of(technique, BOLAN_JERLOV_III, at);
    const double kd = (double)(bolan_water_optics_from_jerlov(BOLAN_JERLOV_III).kd.z -
                               bolan_water_optics_from_jerlov(BOLAN_JERLOV_I).kd.z);
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (int i = 0; i < SIZE * SIZE; ++i) {
        const double tangent = tan(bolan_radians(15.0));
        const double x = at.x + 12.0 * (2.0 * (i % SIZE + 0.5) / SIZE - 1.0) * tangent;
        const double y = at.y + 12.0 * (1.0 - 2.0 * (i / SIZE + 0.5) / SIZE) * tangent;
        const double depth = -bolan_pond_elevation(x, y);
        if (depth < 0.3 || depth > 1.5) continue;
        const double ratio = log((double)clear[3 * i + 2] / (double)turbid[3 * i + 2]) / kd;
        ++n, sx += depth, sy += ratio, sxx += depth * depth, sxy += depth * ratio;
    }
    const double slope = (n * sxy - sx * sy) / (n * sxx - sx * sx);
    print_message("%s: %.0f pixels, attenuated %.2f times\n", technique->name, n, slope);
    // The slanting sun and the water's own light, which grows with depth and is not the same in both, take or give 0.4.
    assert_true(n > 1000 && slope > 1.5 && slope < 2.4);
    free((void *)(uintptr_t)clear);
    free((void *)(uintptr_t)turbid);
}

static void light_from_the_bed_goes_through_the_water_twice(void **state) {
    (void)state;
    uint32_t count = 0;
    const bolan_technique *all = bolan_techniques(&count);
    for (uint32_t i = 0; i < count; ++i) check_bed(&all[i]);
}

// ---- foam -----------------------------------------------------------------------------------------------------------

// Foam under the light that the water's own colour is lit by: albedo / pi against Rrs.
static void check_foam(const bolan_technique *technique, unsigned own) {
    bolan_scene scene = from_above("storm", technique, 40.0, 60.0);
    stage *s = set_stage(&scene);
    stage_settle(s, 20.0);
    float *foam = radiance_with(s, own | BOLAN_EFFECT_FOAM), *water = radiance_with(s, own);
    const double deep = (double)bolan_water_optics_from_jerlov(scene.water.type).deep.y;
    double most = 0.0;
    for (int i = 0; i < SIZE * SIZE; ++i)
        most = fmax(most, (double)foam[3 * i + 1] / (double)water[3 * i + 1] * 0.98 * deep * BOLAN_PI);
    print_message("%s: the whitest foam reflects %.2f\n", technique->name, most);
    // Foam of bubbles over water reflects 0.2 to 0.8 of the light (Whitlock, Bartlett & Gurganus 1982: 0.55 where it is
    // dense)
    assert_true(most > 0.2 && most < 0.8);
    free(foam);
    free(water);
}

static void foam_is_as_white_as_foam(void **state) {
    (void)state;
    check_foam(&bolan_technique_nested_grid, BOLAN_EFFECT_AMBIENT);
    check_foam(&bolan_technique_flight_sim, 0);
}

// ---- motion ---------------------------------------------------------------------------------------------------------

// Correlation of what changes between two pictures with what their gradient towards (east, north) says of a shift that
// way: 1 where all moves that way, -1 against it.
static double flow(const float *before, const float *after, double east, double north) {
    double both = 0.0, t = 0.0, g = 0.0;
    for (int j = 1; j + 1 < SIZE; ++j)
        for (int i = 1; i + 1 < SIZE; ++i) {
            const size_t at = 3 * ((size_t)j * SIZE + i) + 1, row = 3 * SIZE;
            const double change = (double)(after[at] - before[at]);
            const double slope =
                0.25 * (east * (double)(before[at + 3] - before[at - 3] + after[at + 3] - after[at - 3]) +
                        north * (double)(before[at - row] - before[at + row] + after[at - row] - after[at + row]));
            both -= change * slope, t += change * change, g += slope * slope;
        }
    return both / sqrt(t * g);
}

static void check_motion(const bolan_technique *technique, double from) {
    bolan_scene scene = from_above("open-sea", technique, 60.0, 50.0);
    scene.sea.sea_state = bolan_sea_state_from_wind(8.0, from, 1e5);
    const double to = bolan_compass_from_to_math(from), c = cos(to), n = sin(to);
    stage *s = set_stage(&scene);
    double along = 0.0, across = 0.0;
    for (int k = 0; k < 2; ++k) {
        const double time = 20.0 + 3.7 * k;
        stage_step(s, time);
        float *before = radiance(s);
        stage_step(s, time + 0.35); // a frame of the loop of textures lasts 0.3 s
        float *after = radiance(s);
        along += 0.5 * flow(before, after, c, n), across += 0.5 * flow(before, after, -n, c);
        free(before);
        free(after);
    }
    print_message("%s, wind from %.0f: %.2f along, %.2f across\n", technique->name, from, along, across);
    // waves of all directions within 60 degrees or so, and what they mirror: far from 1, and as far from 0
    assert_true(along > 0.12 && along > fabs(across));
}

static void the_sea_runs_with_the_wind(void **state) {
    (void)state;
    uint32_t count = 0;
    const bolan_technique *all = bolan_techniques(&count);
    for (uint32_t i = 0; i < count; ++i) {
        check_motion(&all[i], 240.0);
        check_motion(&all[i], 340.0);
    }
}

// The foam alone: what it adds to a picture, averaged over 5 x 5 pixels, for its bubbles stay where they are.
static float *foam_of(stage *s, double time) {
    stage_step(s, time);
    s->scene.water.foam = 1.0;
    float *with = radiance(s);
    s->scene.water.foam = 0.0;
    float *without = radiance(s), *mean = calloc(3 * SIZE * SIZE, sizeof(float));
    for (int j = 2; j + 2 < SIZE; ++j)
        for (int i = 2; i + 2 < SIZE; ++i)
            for (int k = 0; k < 25; ++k) {
                const size_t at = 3 * ((size_t)(j + k / 5 - 2) * SIZE + i + k % 5 - 2) + 1;
                mean[3 * ((size_t)j * SIZE + i) + 1] += (with[at] - without[at]) / 25.0f;
            }
    free(with);
    free(without);
    return mean;
}

typedef struct bores {
    double both, change, slope;
    int pixels;
} bores;

// Adds how the change from one picture of foam to the next goes with its slope towards (x, y), where the ground rises.
static void add_bores(const stage *s, const float *before, const float *after, double metre, bores *b) {
    const bolan_ground *ground = stage_ground(s);
    const size_t row = 3 * SIZE;
    for (int j = 3; j + 3 < SIZE; ++j)
        for (int i = 3; i + 3 < SIZE; ++i) {
            const double x = s->scene.camera.position.x + (i + 0.5 - SIZE / 2) * metre;
            const double y = s->scene.camera.position.y - (j + 0.5 - SIZE / 2) * metre;
            const double depth = -(double)bolan_ground_elevation(ground, x, y, 2.0);
            if (depth < 0.4 || depth > 1.2) continue;
            const double east = (double)(bolan_ground_elevation(ground, x + 2.0, y, 2.0) -
                                         bolan_ground_elevation(ground, x - 2.0, y, 2.0));
            const double north = (double)(bolan_ground_elevation(ground, x, y + 2.0, 2.0) -
                                          bolan_ground_elevation(ground, x, y - 2.0, 2.0));
            const size_t at = 3 * ((size_t)j * SIZE + i) + 1;
            const double change = (double)(after[at] - before[at]), steep = fmax(hypot(east, north), 1e-9);
            const double slope =
                (east * (double)(before[at + 3] - before[at - 3] + after[at + 3] - after[at - 3]) +
                 north * (double)(before[at - row] - before[at + row] + after[at - row] - after[at + row])) /
                (4.0 * metre * steep);
            b->both -= change * slope, b->change += change * change, b->slope += slope * slope;
            b->pixels++;
        }
}

// The first place round the island, from the east counter-clockwise, where the bed comes up to 0.8 m at a slope of 1 :
// 30 to 1 : 10. Gives the direction to the land.
static bolan_dvec2 find_beach(const bolan_ground *ground, bolan_dvec3 *place) {
    for (int degrees = 0; degrees < 360; degrees += 2)
        for (double r = 4000.0; r > 500.0; r -= 5.0) {
            const double a = bolan_radians(degrees), x = r * cos(a), y = r * sin(a);
            if (bolan_ground_elevation(ground, x, y, 2.0) < -0.8f) continue;
            const bolan_dvec2 up = {(double)(bolan_ground_elevation(ground, x + 15, y, 2.0) -
                                             bolan_ground_elevation(ground, x - 15, y, 2.0)),
                                    (double)(bolan_ground_elevation(ground, x, y + 15, 2.0) -
                                             bolan_ground_elevation(ground, x, y - 15, 2.0))};
            const double slope = hypot(up.x, up.y) / 30.0;
            if (slope < 0.033 || slope > 0.1) break;
            place->x = x, place->y = y;
            return (bolan_dvec2){up.x / slope / 30.0, up.y / slope / 30.0};
        }
    fail_msg("the island has no beach");
    return (bolan_dvec2){0};
}

// Broken water over the shallows before the island's beach, from above: it runs to where the ground rises, about as
// fast as a bore in water as deep as it is high.
static void check_bores(const bolan_technique *technique) {
    const double height = 60.0, metre = 2.0 * height * tan(bolan_radians(35.0)) / SIZE, step = 0.4;
    bolan_scene scene = from_above("island", technique, height, 70.0);
    stage *s = set_stage(&scene);
    const bolan_dvec2 up = find_beach(stage_ground(s), &scene.camera.position);
    // waves that run straight onto it
    scene.sea.sea_state = bolan_sea_state_from_wind(7.0, bolan_degrees(atan2(-up.x, -up.y)), 6e4);
    s = set_stage(&scene);
    const double period = bolan_sea_get_summary(stage_sea(s))->tp;
    bores b = {0};
    for (int k = 0; k < 4; ++k) { // all phases of a wave: what swells and ebbs where it is counts for nothing
        const double time = 20.0 + 0.25 * period * k;
        float *before = foam_of(s, time), *after = foam_of(s, time + step);
        add_bores(s, before, after, metre, &b);
        free(before);
        free(after);
    }
    const double correlation = b.both / sqrt(b.change * b.slope), speed = b.both / b.slope / step;
    print_message("%s: %d pixels of shallows, correlation %.2f, %.2f m/s\n", technique->name, b.pixels, correlation,
                  speed);
    // foam that stands still, and that of the waves' own crests, is most of it: 0.22 and 0.09; run backwards, -0.22 and
    // -0.10
    assert_true(b.pixels > 500 && correlation > 0.04);
    assert_true(speed < 3.0); // sqrt(g 1 m)
}

static void bores_run_in_to_the_shore(void **state) {
    (void)state;
    check_bores(&bolan_technique_ocean);
    check_bores(&bolan_technique_flight_sim);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_glitter_is_as_wide_as_the_slopes),
        cmocka_unit_test(light_from_the_bed_goes_through_the_water_twice),
        cmocka_unit_test(foam_is_as_white_as_foam),
        cmocka_unit_test(the_sea_runs_with_the_wind),
        cmocka_unit_test(bores_run_in_to_the_shore),
    };
    if (getenv("CMOCKA_TEST_FILTER") != NULL) cmocka_set_test_filter(getenv("CMOCKA_TEST_FILTER"));
    return cmocka_run_group_tests(tests, open_context, close_context);
}

// SPDX-License-Identifier: MIT
// Half-rate shading (src/render/half_rate.c): the water covers the same pixels as at full rate, is as bright, and
// leaves no pixel out, at any width of the image.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "picture.h"

#define HEIGHT 160
#define LARGEST 331

typedef struct look {
    uint32_t width;
    float *brightness, *distance;
} look;

static look look_at(stage *s, uint32_t width) {
    const size_t pixels = (size_t)width * HEIGHT;
    float *rgb = malloc(sizeof(float) * 3 * pixels);
    look l = {width, malloc(sizeof(float) * pixels), malloc(sizeof(float) * pixels)};
    picture p = stage_draw(s, width, HEIGHT, 1);
    bolan_renderer_read_linear(s->renderer, rgb, l.distance);
    for (size_t i = 0; i < pixels; ++i)
        l.brightness[i] =
            fminf(0.3f * rgb[3 * i] + 0.6f * rgb[3 * i + 1] + 0.1f * rgb[3 * i + 2], 1.0f); // glitter aside
    picture_free(&p);
    free(rgb);
    return l;
}

static void look_free(look *l) {
    free(l->brightness);
    free(l->distance);
}

static void open(stage *s, const char *name, const bolan_technique *technique, bolan_quality quality) {
    bolan_scene scene;
    assert_int_equal(bolan_scene_load(name, &scene), BOLAN_OK);
    scene.sky.cloud_cover = 0.0;
    scene.sky.sun_azimuth_deg =
        scene.camera.heading_deg + 150.0; // from behind: glitter is not where it was when it is narrower
    scene.sea.resolution = 128;
    bolan_scene_set_technique(&scene, technique);
    assert_true(stage_open(s, &scene, quality, false));
}

// Mean square of the differences of the lower part where `b` is moved to the right.
static double difference(const look *a, const look *b, int moved) {
    double sum = 0.0;
    size_t count = 0;
    for (int y = HEIGHT / 2; y < HEIGHT; ++y)
        for (int x = 8; x < (int)a->width - 8; ++x, ++count) {
            const double d =
                (double)a->brightness[y * (int)a->width + x] - (double)b->brightness[y * (int)a->width + x - moved];
            sum += d * d;
        }
    return sum / (double)count;
}

static double mean(const look *l, int x0, int x1, int y0, int y1) {
    double sum = 0.0;
    for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x) sum += (double)l->brightness[y * (int)l->width + x];
    return sum / ((double)(x1 - x0) * (y1 - y0));
}

static void compare(const char *what, const look *sparse, const look *dense) {
    const int width = (int)sparse->width;
    for (int i = 0; i < width * HEIGHT; ++i)
        if (isfinite(sparse->distance[i]) && !(sparse->brightness[i] > 0.0f))
            fail_msg("%s: pixel %d is unlit", what, i);
    const double here = difference(sparse, dense, 0);
    for (int moved = -2; moved <= 2; ++moved)
        if (moved != 0 && difference(sparse, dense, moved) < here) fail_msg("%s: moved by %d pixels", what, moved);
    // Of areas so large, texture is left out: 15 % is what the qualities' different meshes and look-ups make of it.
    for (int y = HEIGHT / 2; y < HEIGHT; y += HEIGHT / 8)
        for (int part = 0; part < 3; ++part) {
            const int from = width * part / 3, to = width * (part + 1) / 3;
            const double a = mean(sparse, from, to, y, y + HEIGHT / 8), b = mean(dense, from, to, y, y + HEIGHT / 8);
            if (fabs(a - b) > 0.15 * b) fail_msg("%s: %g instead of %g at row %d, part %d", what, a, b, y, part);
        }
}

// The quad, a mesh, and a shape that is kept (over the quad: the static grids of two qualities put waves elsewhere);
// widths that 4 and 2 divide, that 2 divides, that nothing does.
static void sparse_water_is_like_dense_water(void **state) {
    (void)state;
    static const bolan_technique kept = {"kept shape", BOLAN_WAVES_FFT, BOLAN_SURFACE_QUAD, BOLAN_OPTICS_CREST, -1};
    static const struct {
        const char *scene;
        const bolan_technique *technique;
    } list[] = {{"pond", &bolan_technique_exp_cosine}, {"pond", &bolan_technique_nested_grid}, {"pond", &kept}};
    static const uint32_t widths[] = {320, 330, LARGEST};
    bolan_context *context = NULL;
    if (bolan_context_create(BOLAN_GL_CORE, &context) != BOLAN_OK) skip_without_gl();
    for (int i = 0; i < 3; ++i) {
        stage dense, sparse[2];
        open(&dense, list[i].scene, list[i].technique, BOLAN_QUALITY_HIGH);
        for (int q = 0; q < 2; ++q) open(&sparse[q], list[i].scene, list[i].technique, (bolan_quality)q);
        for (int w = test_is_short() ? 2 : 0; w < 3; ++w) {
            look want = look_at(&dense, widths[w]);
            for (int q = 0; q < 2; ++q) {
                char what[96];
                snprintf(what, sizeof what, "%s, %s, quality %d, %u columns", list[i].scene, list[i].technique->name, q,
                         widths[w]);
                look got = look_at(&sparse[q], widths[w]);
                compare(what, &got, &want);
                look_free(&got);
            }
            look_free(&want);
        }
        for (int q = 0; q < 2; ++q) stage_close(&sparse[q]);
        stage_close(&dense);
    }
    bolan_context_destroy(&context);
}

// ---- other GPUs ----------------------------------------------------------------------------------------------------

// A copy of the shaders in which the vertices of shaders/<stem>.glsl are moved by `change`.
static void perturb(const char *folder, const char *stem, const char *change) {
    char command[1024];
    snprintf(
        command, sizeof command,
        "rm -rf %s && cp -r %s/shaders %s && sed -i '/^#ifdef VERTEX/,/^#endif/ s/water_vertex();/water_vertex(); %s/' "
        "%s/%s.glsl && grep -qF 'water_vertex(); %.20s' %s/%s.glsl",
        folder, BOLAN_SOURCE_DIR, folder, change, folder, stem, change, folder, stem);
    assert_int_equal(system(command), 0);
}

// The pond by that copy.
static void open_perturbed(stage *s, const char *stem, const char *change) {
    perturb("sparse_shaders", stem, change);
    stage_shaders = "sparse_shaders";
    open(s, "pond", &bolan_technique_exp_cosine, BOLAN_QUALITY_MEDIUM);
    stage_shaders = NULL;
}

static look draw(const char *stem, const char *change) {
    stage s;
    if (stem)
        open_perturbed(&s, stem, change);
    else
        open(&s, "pond", &bolan_technique_exp_cosine, BOLAN_QUALITY_MEDIUM);
    look l = look_at(&s, 320);
    stage_close(&s);
    assert_int_equal(system("rm -rf sparse_shaders"), 0);
    return l;
}

// Root mean square of the difference of two pictures, and no pixel of the first unlit.
static double distance_of(const char *what, const look *l, const look *plain) {
    double sum = 0.0;
    const size_t pixels = (size_t)l->width * HEIGHT;
    for (size_t i = 0; i < pixels; ++i) {
        if (isfinite(l->distance[i]) && !(l->brightness[i] > 0.0f)) fail_msg("%s: pixel %zu is unlit", what, i);
        sum += pow((double)l->brightness[i] - (double)plain->brightness[i], 2.0);
    }
    return sqrt(sum / (double)pixels);
}

// Another GPU rounds depth and the edges of triangles otherwise than this one, and in each program otherwise. Four
// steps of 2^-23 either way, half of what DEPTH_ROUNDING allows, change nothing.
static void rounding_of_depth_changes_nothing(void **state) {
    (void)state;
    static const struct {
        const char *stem, *change;
    } list[] = {
        {"papers/phong", "gl_Position.z -= 4.8e-7 * gl_Position.w;"},
        {"papers/phong", "gl_Position.z += 4.8e-7 * gl_Position.w;"},
        {"water_depth", "gl_Position.z += 4.8e-7 * gl_Position.w;"},
        {"half_rate_resolve", "gl_Position.z -= 4.8e-7 * gl_Position.w;"},
    };
    bolan_context *context = NULL;
    if (bolan_context_create(BOLAN_GL_CORE, &context) != BOLAN_OK) skip_without_gl();
    look plain = draw(NULL, NULL);
    for (size_t i = 0; i < sizeof list / sizeof *list; ++i) {
        look l = draw(list[i].stem, list[i].change);
        const double rms = distance_of(list[i].stem, &l, &plain);
        // Depth that moves by so little moves the water's edge on the shore by less than a pixel here and there.
        if (!(rms < 0.002)) fail_msg("%s: differs by %g", list[i].change, rms);
        look_free(&l);
    }
    look_free(&plain);
    bolan_context_destroy(&context);
}

// Samples that fail altogether leave no hole: their pixels reflect the mean sky.
static void a_pixel_without_samples_is_lit(void **state) {
    (void)state;
    bolan_context *context = NULL;
    if (bolan_context_create(BOLAN_GL_CORE, &context) != BOLAN_OK) skip_without_gl();
    look plain = draw(NULL, NULL);
    look l = draw("papers/phong", "gl_Position.z *= 0.5;");
    const double rms = distance_of("no samples", &l, &plain);
    assert_true(rms > 0.002 && rms < 0.3); // it is another picture, and no wild one
    look_free(&l);
    look_free(&plain);
    bolan_context_destroy(&context);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(rounding_of_depth_changes_nothing),
                                       cmocka_unit_test(a_pixel_without_samples_is_lit),
                                       cmocka_unit_test(sparse_water_is_like_dense_water)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

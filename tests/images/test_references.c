// SPDX-License-Identifier: MIT
// The light of whole pictures against stored references: every technique in six views, at high quality, and as its
// paper has it.
//
// A reference holds no pixels but blocks of 16 x 12 of them: the mean radiance (red, green, blue), the rms contrast of
// the luminance within the block, and the mean level of the displayed picture. BOLAN_WRITE_REFERENCES=1 writes all of
// them anew, with a PNG of each in the report folder: tools/references.sh. Look at each before it is committed.
// BOLAN_REFERENCES="near,shore" draws these views alone, CMOCKA_TEST_FILTER="ocean*" one technique.
//
// Tolerances. The sea has the same bits on every CPU, and the software rasteriser nearly: with vectors of 4 and of 8
// lanes, with and without AVX2 and fused multiply-add, no block's mean differs by 0.01 %. Another release of it may
// filter textures by a bit or two of 8 otherwise, and compile shaders in another order: the bounds leave room for that,
// a hundred times what was measured. A wrong term of the light changes some block by more than 2 % of its radiance, a
// whole row of blocks by more than 0.5 %, or the contrast of a block by more than a tenth.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <unistd.h>

#include <cmocka.h>

#include "picture.h"

enum { BLOCK_WIDTH = 16, BLOCK_HEIGHT = 12, COLUMNS = 20, MAX_ROWS = 22, WIDTH = COLUMNS * BLOCK_WIDTH, VALUES = 5 };

#define BLOCK_MEAN 0.02     // of the radiance, relative
#define ROW_MEAN 0.005      // likewise, of a row of blocks
#define BLOCK_CONTRAST 0.1  // of the rms contrast, relative
#define LEAST_CONTRAST 0.01 // of the mean radiance: less contrast than this is compared with this much
#define LEAST_RADIANCE 0.05 // of the picture's mean: darker blocks are compared with this much
#define BLOCK_DISPLAY 1.0   // levels of 255

typedef struct view {
    const char *name, *scene;
    double x, y, height, heading, pitch, fov;
    double sun_azimuth, sun_elevation; // NAN: the scene's
    double wind;                       // [m/s]; 0: the scene's
    double cover;                      // of clouds: they cost more time than all else, and few views need them
    bolan_quality quality;
    bool paper;
    uint32_t rows; // of blocks
} view;

#define MEDIUM BOLAN_QUALITY_MEDIUM, false, 15
#define PAPER BOLAN_QUALITY_MEDIUM, true, 15
#define HIGH BOLAN_QUALITY_HIGH, false, MAX_ROWS // as many rows as a glow needs

// The open sea as all techniques draw it: the sun stands ahead, and in one of the views low.
#define NEAR \
    { "near", "open-sea", 0, 0, 2, 215, -9, 50, NAN, NAN, 0, 0, MEDIUM }
#define FAR \
    { "far", "open-sea", 700, -300, 100, 190, -12, 50, NAN, NAN, 0, 0.4, MEDIUM }
#define ALOFT(cover) \
    { "high", "open-sea", -20000, 9000, 5000, 230, -9, 50, NAN, NAN, 0, cover, MEDIUM }
#define LOW_SUN(suffix, how) \
    { "low_sun" suffix, "open-sea", 40, 80, 4, 262, -6, 50, 265, 5, 0, 0, how }
#define STORM \
    { "storm", "storm", 0, 0, 12, 250, -7, 50, NAN, NAN, 20, 0, MEDIUM }
// Along the beach in the island's west, and over its lagoon; the pond. In paper mode with the sun ahead.
#define SHORE \
    { "shore", "island", -2637, 4, 3.5, 136, -13, 50, NAN, NAN, 0, 0, MEDIUM }
#define SHORE_PAPER \
    { "shore_paper", "island", -2637, 4, 3.5, 136, -13, 50, 140, 25, 0, 0, PAPER }
#define LAGOON \
    { "lagoon_fine", "island", -1130, -1050, 14, 20, -11, 50, NAN, NAN, 0, 0, HIGH }
#define POND(suffix, how) \
    { "pond" suffix, "pond", 0, -26, 2.4, 350, -10, 47, NAN, NAN, 0, 0, how }
#define POND_PAPER \
    { "pond_paper", "pond", 0, -26, 2.4, 350, -10, 47, 355, 22, 0, 0, PAPER }
// From under the water through its surface to the sun.
#define BELOW \
    { "below", "pond", 0, -8, -0.8, 248, 50, 75, NAN, NAN, 0, 0, MEDIUM }

static const view ocean_views[] = {NEAR,  FAR,   ALOFT(0.3), LOW_SUN("", MEDIUM),
                                   STORM, SHORE, LAGOON,     LOW_SUN("_fine", HIGH)};
static const view two_triangle_views[] = {
    NEAR, FAR, ALOFT(0), LOW_SUN("", MEDIUM), STORM, POND("", MEDIUM), POND("_fine", HIGH), POND_PAPER, BELOW};
static const view exp_cosine_views[] = {
    NEAR, FAR, ALOFT(0), LOW_SUN("", MEDIUM), STORM, POND("", MEDIUM), POND("_fine", HIGH), POND_PAPER};
static const view nested_grid_views[] = {NEAR, FAR, ALOFT(0), LOW_SUN("", MEDIUM), STORM, SHORE, LAGOON, SHORE_PAPER};
static const view flight_sim_views[] = {NEAR, FAR, ALOFT(0), LOW_SUN("", MEDIUM), STORM, SHORE, LAGOON, SHORE_PAPER};

typedef struct blocks {
    uint32_t rows;
    float value[MAX_ROWS * COLUMNS][VALUES]; // red, green, blue, contrast, displayed
} blocks;

// ---- drawing --------------------------------------------------------------------------------------------------------

// Pictures of one technique share its programs, and those of one scene its sea.
typedef struct studio {
    stage s;
    const view *last;
} studio;

static bolan_scene scene_of(const view *v, const bolan_technique *technique) {
    bolan_scene scene;
    assert_int_equal(bolan_scene_load(v->scene, &scene), BOLAN_OK);
    if (v->wind > 0.0) bolan_scene_set_wind(&scene, v->wind, 285.0);
    bolan_scene_set_technique(&scene, technique);
    scene.look.paper = v->paper;
    return scene;
}

static bool same_sea(const view *a, const view *b) {
    return a && strcmp(a->scene, b->scene) == 0 && a->paper == b->paper && a->wind == b->wind;
}

static void studio_fit(studio *d, const view *v, const bolan_technique *technique) {
    const bool same = same_sea(d->last, v);
    if (d->last && (d->last->quality != v->quality || !same)) bolan_renderer_destroy(&d->s.renderer);
    if (!same) {
        if (d->last) stage_close(&d->s);
        const bolan_scene scene = scene_of(v, technique);
        assert_true(stage_open(&d->s, &scene, v->quality, false));
    } else if (d->s.renderer == NULL) {
        bolan_renderer_desc desc = bolan_renderer_desc_default();
        desc.quality = v->quality;
        assert_int_equal(bolan_renderer_create(&desc, &d->s.renderer), BOLAN_OK);
    }
    d->last = v;
}

static void place_camera(bolan_scene *scene, const view *v, uint64_t seed) {
    scene->camera = (bolan_camera){
        .position = {v->x, v->y, v->height}, .heading_deg = v->heading, .pitch_deg = v->pitch, .fov_deg = v->fov};
    if (!isnan(v->sun_azimuth)) scene->sky.sun_azimuth_deg = v->sun_azimuth;
    if (!isnan(v->sun_elevation)) scene->sky.sun_elevation_deg = v->sun_elevation;
    scene->sky.cloud_seed = seed;
    scene->sky.cloud_cover = v->cover;
}

static double luminance(const float *rgb) {
    return 0.2126 * (double)rgb[0] + 0.7152 * (double)rgb[1] + 0.0722 * (double)rgb[2];
}

static void fill_block(const picture *p, const float *rgb, uint32_t column, uint32_t row, float out[VALUES]) {
    const double n = BLOCK_WIDTH * BLOCK_HEIGHT;
    double sum[VALUES] = {0}, light = 0.0;
    for (uint32_t y = row * BLOCK_HEIGHT; y < (row + 1) * BLOCK_HEIGHT; ++y)
        for (uint32_t x = column * BLOCK_WIDTH; x < (column + 1) * BLOCK_WIDTH; ++x) {
            const size_t i = 3 * ((size_t)y * p->width + x);
            for (int c = 0; c < 3; ++c) sum[c] += (double)rgb[i + c], sum[4] += p->rgb[i + c] / 3.0;
            light += luminance(rgb + i);
            sum[3] += luminance(rgb + i) * luminance(rgb + i);
        }
    sum[3] = n * sqrt(fmax(sum[3] / n - light / n * light / n, 0.0));
    for (int k = 0; k < VALUES; ++k) out[k] = (float)(sum[k] / n);
}

static picture shoot(studio *d, const view *v, uint64_t seed, const bolan_technique *technique, blocks *out) {
    studio_fit(d, v, technique);
    place_camera(&d->s.scene, v, seed);
    picture p = stage_draw(&d->s, WIDTH, v->rows * BLOCK_HEIGHT, 1);
    float *rgb = malloc(sizeof(float) * 3 * p.width * p.height);
    bolan_renderer_read_linear(d->s.renderer, rgb, NULL);
    out->rows = v->rows;
    for (uint32_t row = 0; row < v->rows; ++row)
        for (uint32_t column = 0; column < COLUMNS; ++column)
            fill_block(&p, rgb, column, row, out->value[row * COLUMNS + column]);
    free(rgb);
    return p;
}

// ---- the files ------------------------------------------------------------------------------------------------------

static void write_reference(const char *path, const blocks *b) {
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fprintf(file, "%d %u blocks from the top left: red green blue contrast displayed\n", COLUMNS, b->rows);
    for (uint32_t i = 0; i < b->rows * COLUMNS; ++i) {
        const float *v = b->value[i];
        fprintf(file, "%.5g %.5g %.5g %.4g %.1f\n", (double)v[0], (double)v[1], (double)v[2], (double)v[3],
                (double)v[4]);
    }
    assert_int_equal(fclose(file), 0);
}

static void read_reference(const char *path, blocks *b) {
    int columns = 0;
    FILE *file = fopen(path, "r");
    if (!file) fail_msg("there is no reference %s", path);
    assert_int_equal(fscanf(file, "%d %u %*[^\n]", &columns, &b->rows), 2);
    assert_int_equal(columns, COLUMNS);
    assert_true(b->rows <= MAX_ROWS);
    for (uint32_t i = 0; i < b->rows * COLUMNS; ++i)
        for (int k = 0; k < VALUES; ++k) assert_int_equal(fscanf(file, "%f", &b->value[i][k]), 1);
    fclose(file);
}

// ---- comparing ------------------------------------------------------------------------------------------------------

// What differs most, each as a multiple of what may.
typedef struct difference {
    double mean, row, contrast, display;
    uint32_t mean_at, row_at, contrast_at, display_at; // block, row of blocks
} difference;

static void keep_worst(double value, uint32_t at, double *worst, uint32_t *worst_at) {
    if (value > *worst || !isfinite(value)) *worst = value, *worst_at = at;
}

static difference compare(const blocks *want, const blocks *got) {
    difference d = {0};
    double picture_mean = 0.0;
    for (uint32_t i = 0; i < want->rows * COLUMNS; ++i)
        picture_mean += luminance(want->value[i]) / (want->rows * COLUMNS);
    for (uint32_t row = 0; row < want->rows; ++row) {
        double sum[3][2] = {{0}};
        for (uint32_t column = 0; column < COLUMNS; ++column) {
            const uint32_t i = row * COLUMNS + column;
            const float *w = want->value[i], *g = got->value[i];
            const double light = fmax(luminance(w), LEAST_RADIANCE * picture_mean);
            for (int c = 0; c < 3; ++c) {
                const double least = fmax((double)w[c], LEAST_RADIANCE * light);
                keep_worst(fabs((double)(g[c] - w[c])) / (BLOCK_MEAN * least), i, &d.mean, &d.mean_at);
                sum[c][0] += (double)w[c], sum[c][1] += (double)g[c];
            }
            const double contrast = fmax((double)w[3], LEAST_CONTRAST * light);
            keep_worst(fabs((double)(g[3] - w[3])) / (BLOCK_CONTRAST * contrast), i, &d.contrast, &d.contrast_at);
            keep_worst(fabs((double)(g[4] - w[4])) / BLOCK_DISPLAY, i, &d.display, &d.display_at);
        }
        for (int c = 0; c < 3; ++c) {
            const double least = fmax(sum[c][0], COLUMNS * LEAST_RADIANCE * LEAST_RADIANCE * picture_mean);
            keep_worst(fabs(sum[c][1] - sum[c][0]) / (ROW_MEAN * least), row, &d.row, &d.row_at);
        }
    }
    return d;
}

static bool is_near(const difference *d) {
    return d->mean <= 1.0 && d->row <= 1.0 && d->contrast <= 1.0 && d->display <= 1.0;
}

static void print_difference(const char *name, const difference *d) {
    print_message("%s: block (%u, %u) %.2f %%, row %u %.2f %%, contrast (%u, %u) %.0f %%, displayed (%u, %u) %.1f\n",
                  name, d->mean_at % COLUMNS, d->mean_at / COLUMNS, 100.0 * BLOCK_MEAN * d->mean, d->row_at,
                  100.0 * ROW_MEAN * d->row, d->contrast_at % COLUMNS, d->contrast_at / COLUMNS,
                  100.0 * BLOCK_CONTRAST * d->contrast, d->display_at % COLUMNS, d->display_at / COLUMNS,
                  BLOCK_DISPLAY * d->display);
}

static void keep_picture(const char *name, const picture *p) {
    char path[256];
    mkdir("report", 0777);
    snprintf(path, sizeof path, "report/%s.png", name);
    bolan_png_write(path, p->width, p->height, p->rgb);
}

static bool check(const char *technique, const view *v, const picture *p, const blocks *got) {
    char name[128], path[512];
    snprintf(name, sizeof name, "%s_%s", technique, v->name);
    snprintf(path, sizeof path, "%s/tests/images/references/%s.txt", BOLAN_SOURCE_DIR, name);
    if (getenv("BOLAN_WRITE_REFERENCES") != NULL) {
        write_reference(path, got);
        keep_picture(name, p);
        return true;
    }
    blocks want;
    read_reference(path, &want);
    assert_int_equal(want.rows, got->rows);
    const difference d = compare(&want, got);
    const bool near = is_near(&d);
    if (!near || getenv("BOLAN_PRINT_DIFFERENCES") != NULL) print_difference(name, &d);
    if (!near) keep_picture(name, p);
    return near;
}

static void check_views(const bolan_technique *technique, const view *views, size_t count) {
    bolan_context *context = NULL;
    if (bolan_context_create(BOLAN_GL_CORE, &context) != BOLAN_OK) skip_without_gl();
    const char *only = test_is_short() ? "near,shore" : getenv("BOLAN_REFERENCES");
    studio d = {0};
    int wrong = 0;
    for (size_t i = 0; i < count; ++i) {
        if (only && strstr(only, views[i].name) == NULL) continue;
        blocks got;
        picture p = shoot(&d, &views[i], 100 + i, technique, &got);
        wrong += !check(technique->name, &views[i], &p, &got);
        picture_free(&p);
    }
    if (d.last) stage_close(&d.s);
    bolan_context_destroy(&context);
    if (wrong) fail_msg("%d of %zu pictures are not their references", wrong, count);
}

#define VIEWS(list) list, sizeof list / sizeof list[0]

static void ocean_is_its_references(void **state) {
    (void)state;
    check_views(&bolan_technique_ocean, VIEWS(ocean_views));
}

static void two_triangle_is_its_references(void **state) {
    (void)state;
    check_views(&bolan_technique_two_triangle, VIEWS(two_triangle_views));
}

static void exp_cosine_is_its_references(void **state) {
    (void)state;
    check_views(&bolan_technique_exp_cosine, VIEWS(exp_cosine_views));
}

static void nested_grid_is_its_references(void **state) {
    (void)state;
    check_views(&bolan_technique_nested_grid, VIEWS(nested_grid_views));
}

static void flight_sim_is_its_references(void **state) {
    (void)state;
    check_views(&bolan_technique_flight_sim, VIEWS(flight_sim_views));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ocean_is_its_references),      cmocka_unit_test(two_triangle_is_its_references),
        cmocka_unit_test(exp_cosine_is_its_references), cmocka_unit_test(nested_grid_is_its_references),
        cmocka_unit_test(flight_sim_is_its_references),
    };
    if (getenv("CMOCKA_TEST_FILTER") != NULL) cmocka_set_test_filter(getenv("CMOCKA_TEST_FILTER"));
    return cmocka_run_group_tests(tests, NULL, NULL);
}

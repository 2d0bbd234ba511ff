// SPDX-License-Identifier: MIT
// bolan-bench techniques: every technique on the scene it was made for, and the tables of the four papers measured
// again, with the printed figures beside ours. Their machines were of 2004 to 2018, so only ratios within one table
// can be compared.
//   A  Ma, Zhu & Gong 2006, table 2: a scene once, twice, three times, without and with two triangles of water
//   B  Liu & Xie 2010, table 1 (its figures are lost): four ways to the same water
//   C  Liu, Xu & Chen 2009, section 6: 16 x 8 waves on 6 levels of 32 x 32 cells
//   D  Ni, Zhang & Tan: the frame rate over a flight
#include "stage.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { TECHNIQUES = 5, A_ROWS = 3, B_ROWS = 4, C_ROWS = 3, D_ROWS = 6 };

typedef struct row_a {
    uint32_t triangles[3]; // without water, with two triangles, with a mesh
    double fps[3];
} row_a;

typedef struct row {
    const char *what;
    stage_figures figures;
} row;

typedef struct results {
    stage_figures techniques[TECHNIQUES];
    row_a a[A_ROWS];
    row b[B_ROWS], c[C_ROWS], d[D_ROWS];
} results;

// ---- scenes ---------------------------------------------------------------------------------------------------------

typedef struct change {
    const bolan_technique *technique;
    uint32_t copies;                  // of every object; 0: as they are
    uint32_t frequencies, directions; // 0: as they are
    uint32_t resolution;              // 0: as it is
    uint32_t max_vertices;            // of the water; 0: by quality
    double height;                    // of the camera [m]; 0: as it is
    bool paper;                       // the mode of the paper
} change;

static void copy_objects(bolan_scene *s, uint32_t copies) {
    const uint32_t count = s->object_count;
    for (uint32_t c = 1; c < copies; ++c)
        for (uint32_t i = 0; i < count && s->object_count < BOLAN_MAX_OBJECTS; ++i)
            s->objects[s->object_count++] = s->objects[i];
}

static void apply(bolan_scene *s, void *context) {
    const change *c = context;
    if (c->technique) bolan_scene_set_technique(s, c->technique);
    copy_objects(s, c->copies);
    if (c->frequencies) s->sea.cosines.frequencies = c->frequencies;
    if (c->directions) s->sea.cosines.directions = c->directions;
    if (c->resolution) s->sea.resolution = c->resolution;
    if (c->paper) s->look.paper = true;
    if (c->height > 0.0) s->camera.position.z = c->height;
}

// Opens, measures, closes.
static bolan_result measure(const char *scene, const stage_options *o, change c, bool passes, bool without_water,
                            stage_figures *f) {
    stage s;
    stage_options own = *o;
    own.max_vertices = c.max_vertices;
    bolan_result result = stage_open(&s, scene, &own, apply, &c);
    if (result != BOLAN_OK) return result;
    s.without_water = without_water;
    stage_measure(&s, passes, f);
    stage_close(&s);
    return BOLAN_OK;
}

// ---- the tables -----------------------------------------------------------------------------------------------------

static bolan_result measure_techniques(const stage_options *o, results *r) {
    static const struct {
        const bolan_technique *technique;
        const char *scene;
    } list[TECHNIQUES] = {{&bolan_technique_two_triangle, "pond"},
                          {&bolan_technique_exp_cosine, "pond"},
                          {&bolan_technique_nested_grid, "open-sea"},
                          {&bolan_technique_flight_sim, "open-sea"},
                          {&bolan_technique_ocean, "open-sea"}};
    bolan_result result = BOLAN_OK;
    for (int i = 0; i < TECHNIQUES && result == BOLAN_OK; ++i)
        result = measure(list[i].scene, o, (change){.technique = list[i].technique}, true, false, &r->techniques[i]);
    return result;
}

// A: the row "mesh" draws the same image by a grid of the resolution of the view.
static bolan_result measure_a(const stage_options *o, results *r) {
    static const bolan_technique mesh = {"mesh", BOLAN_WAVES_TEXTURES, BOLAN_SURFACE_PROJECTED, BOLAN_OPTICS_MIRROR,
                                         -1};
    bolan_result result = BOLAN_OK;
    for (uint32_t i = 0; i < A_ROWS * 3 && result == BOLAN_OK; ++i) {
        const uint32_t copies = i / 3 + 1, column = i % 3;
        stage_figures f;
        change c = {.technique = column == 2 ? &mesh : &bolan_technique_two_triangle, .copies = copies};
        result = measure("pond", o, c, false, column == 0, &f);
        r->a[i / 3].triangles[column] = f.triangles;
        r->a[i / 3].fps[column] = 1e3 / f.ms;
    }
    return result;
}

// B: the four methods of section 2 of the paper, each as its paper states it: 8 exp-cosines at the vertices of a mesh,
// which have the normals; a coarse mesh with its waves and normals from a texture (Kryachko 2005); two triangles with
// textures (paper A); two triangles with 8 exp-cosines. The light is that of this paper, of the third that of its own.
static bolan_result measure_b(const stage_options *o, results *r) {
    static const bolan_technique mesh = {"mesh", BOLAN_WAVES_EXP_COSINE, BOLAN_SURFACE_PROJECTED, BOLAN_OPTICS_PHONG,
                                         -1},
                                 noise = {"noise 1", BOLAN_WAVES_TEXTURES, BOLAN_SURFACE_PROJECTED, BOLAN_OPTICS_PHONG,
                                          -1};
    const struct {
        const char *what;
        change c;
    } list[B_ROWS] = {
        {"mesh of up to 16384 vertices", {.technique = &mesh, .max_vertices = 128 * 128}},
        {"noise 1: up to 1024, texture 128 x 128", {.technique = &noise, .max_vertices = 32 * 32, .resolution = 128}},
        {"noise 2: two triangles, 512 x 512", {.technique = &bolan_technique_two_triangle, .resolution = 512}},
        {"own: two triangles, 8 exp-cosines", {.technique = &bolan_technique_exp_cosine}}};
    bolan_result result = BOLAN_OK;
    for (int i = 0; i < B_ROWS && result == BOLAN_OK; ++i) {
        change c = list[i].c;
        c.paper = true;
        r->b[i].what = list[i].what;
        result = measure("pond", o, c, false, false, &r->b[i].figures);
    }
    return result;
}

static bolan_result measure_c(const stage_options *o, results *r) {
    static const struct {
        const char *what;
        uint32_t frequencies, directions;
    } list[C_ROWS] = {{"16 x 8 waves", 16, 8}, {"32 x 16 waves", 32, 16}, {"64 x 32 waves", 64, 32}};
    bolan_result result = BOLAN_OK;
    for (int i = 0; i < C_ROWS && result == BOLAN_OK; ++i) {
        change c = {.technique = &bolan_technique_nested_grid,
                    .frequencies = list[i].frequencies,
                    .directions = list[i].directions};
        r->c[i].what = list[i].what;
        result = measure("open-sea", o, c, true, false, &r->c[i].figures);
    }
    return result;
}

static bolan_result measure_d(const stage_options *o, results *r) {
    static const struct {
        const char *what;
        double height;
    } list[D_ROWS] = {{"10 km", 10000.0}, {"3 km", 3000.0}, {"1 km", 1000.0},
                      {"300 m", 300.0},   {"30 m", 30.0},   {"3 m", 3.0}};
    bolan_result result = BOLAN_OK;
    for (int i = 0; i < D_ROWS && result == BOLAN_OK; ++i) {
        change c = {.technique = &bolan_technique_flight_sim, .height = list[i].height};
        r->d[i].what = list[i].what;
        result = measure("open-sea", o, c, false, false, &r->d[i].figures);
    }
    return result;
}

// ---- printing -------------------------------------------------------------------------------------------------------

static const struct {
    uint32_t without, with;
    double fps_without, fps_with;
} paper_a[A_ROWS] = {{13912, 13914, 61, 55}, {27824, 27826, 46, 45}, {41736, 41738, 39, 39}};

static double constancy(const results *r) {
    double least = HUGE_VAL, most = 0.0;
    for (int i = 0; i < D_ROWS; ++i) {
        const double ratio = r->d[i].figures.ms / r->d[i].figures.yard.ms; // cancels the speed of the machine
        least = fmin(least, ratio);
        most = fmax(most, ratio);
    }
    return (most - least) / (most + least);
}

// Milliseconds of a pass; below 0 where the row lacks the pass or its passes were not measured.
static double pass_ms(const stage_figures *f, const char *name) {
    for (uint32_t p = 0; p < f->pass_count; ++p)
        if (strcmp(f->passes[p].name, name) == 0) return f->passes[p].ms;
    return -1.0;
}

// Where the rows' passes were measured, their waves have a column: the pass "sea", in which the vertices get them.
static void print_rows(const char *title, const row *rows, int count) {
    const bool waves = pass_ms(&rows[0].figures, "sea") >= 0.0;
    printf("\n%s\n%-38s %10s %9s %8s %7s %6s %9s%s\n", title, "", "triangles", "water", "ms", "fps", "ratio",
           "cpu ratio", waves ? "   sea ms" : "");
    for (int i = 0; i < count; ++i) {
        const stage_figures *f = &rows[i].figures;
        printf("%-38s %10u %9u %8.2f %7.1f %6.2f %9.2f", rows[i].what, f->triangles, f->water_triangles, f->ms,
               1e3 / f->ms, f->ms / f->yard.ms, f->cpu_ms / f->yard.cpu_ms);
        if (waves) printf(" %8.2f", pass_ms(f, "sea"));
        printf("\n");
    }
}

static void print_table(const stage_options *o, const results *r) {
    stage_print_machine(o, r->techniques[0].yard);
    stage_print_table(r->techniques, TECHNIQUES);
    printf("\nA, table 2: frames a second of the scene alone, with two triangles of water, with a mesh of water\n"
           "%-22s %21s %21s   paper: %s\n",
           "without", "two triangles", "mesh", "without, two triangles");
    for (int i = 0; i < A_ROWS; ++i)
        printf("%9u %12.1f %9u %11.1f %9u %11.1f   %9u %4.0f %9u %4.0f\n", r->a[i].triangles[0], r->a[i].fps[0],
               r->a[i].triangles[1], r->a[i].fps[1], r->a[i].triangles[2], r->a[i].fps[2], paper_a[i].without,
               paper_a[i].fps_without, paper_a[i].with, paper_a[i].fps_with);
    print_rows(
        "B, table 1: four ways to the pond, to the letter (the paper's figures are lost; its order: mesh slowest)",
        r->b, B_ROWS);
    print_rows("C, section 6: 6 levels of 32 x 32 cells (paper: 16 x 8 waves, 9728 triangles, 40 frames a second)",
               r->c, C_ROWS);
    print_rows("D: the view from these heights (paper: steady at 62 frames a second)", r->d, D_ROWS);
    printf("over the flight the time of a frame stays within +- %.0f %%\n", 100.0 * constancy(r));
}

static void print_rows_json(const char *key, const row *rows, int count) {
    printf("    \"%s\": [\n", key);
    for (int i = 0; i < count; ++i) {
        const stage_figures *f = &rows[i].figures;
        const double sea = pass_ms(f, "sea");
        printf("      {\"what\": \"%s\", \"triangles\": %u, \"water_triangles\": %u, \"ms\": %.3f, \"fps\": %.2f, "
               "\"ratio\": %.3f, \"cpu_ratio\": %.3f",
               rows[i].what, f->triangles, f->water_triangles, f->ms, 1e3 / f->ms, f->ms / f->yard.ms,
               f->cpu_ms / f->yard.cpu_ms);
        if (sea >= 0.0) printf(", \"sea_ms\": %.3f", sea);
        printf("}%s\n", i + 1 < count ? "," : "");
    }
    printf("    ],\n");
}

static void print_json(const stage_options *o, const results *r) {
    printf("{\n");
    stage_print_machine_json(o, r->techniques[0].yard);
    printf("  \"techniques\": [\n");
    stage_print_json(o, r->techniques, TECHNIQUES);
    printf("  ],\n  \"papers\": {\n    \"a\": [\n");
    for (int i = 0; i < A_ROWS; ++i)
        printf("      {\"triangles\": %u, \"fps\": %.2f, \"triangles_with_water\": %u, \"fps_with_water\": %.2f, "
               "\"triangles_with_mesh\": %u, \"fps_with_mesh\": %.2f, \"paper_fps\": %.0f, \"paper_fps_with_water\": "
               "%.0f}%s\n",
               r->a[i].triangles[0], r->a[i].fps[0], r->a[i].triangles[1], r->a[i].fps[1], r->a[i].triangles[2],
               r->a[i].fps[2], paper_a[i].fps_without, paper_a[i].fps_with, i + 1 < A_ROWS ? "," : "");
    printf("    ],\n");
    print_rows_json("b", r->b, B_ROWS);
    print_rows_json("c", r->c, C_ROWS);
    print_rows_json("d", r->d, D_ROWS);
    printf("    \"c_paper_fps\": 40, \"d_paper_fps\": 62, \"d_constancy\": %.4f\n  }\n}\n", constancy(r));
}

// ---- the command ----------------------------------------------------------------------------------------------------

static int parse(int argc, char **argv, stage_options *o) {
    for (int i = 1; i < argc; ++i) {
        const int taken = stage_option("techniques", argc, argv, &i, o);
        if (taken < 0) return 2;
        if (taken > 0) continue;
        fprintf(stderr,
                "bolan-bench techniques: unknown argument %s\n"
                "usage: techniques [--json] [--size WxH] [--quality low|medium|high|ultra]\n"
                "       [--backend auto|cpu|compute] [--pixels auto|fragment|compute] [--threads N]\n",
                argv[i]);
        return 2;
    }
    return 0;
}

int bench_techniques(int argc, char **argv) {
    stage_options o = stage_options_default();
    const int status = parse(argc, argv, &o);
    if (status != 0) return status;
    bolan_set_threads(o.threads);
    bolan_context *context = NULL;
    if (bolan_context_create(BOLAN_GL_CORE, &context) != BOLAN_OK) return 1;
    static results r; // large
    bolan_result (*const parts[])(const stage_options *, results *) = {measure_techniques, measure_a, measure_b,
                                                                       measure_c, measure_d};
    bolan_result result = BOLAN_OK;
    for (size_t i = 0; i < sizeof parts / sizeof parts[0] && result == BOLAN_OK; ++i) {
        result = parts[i](&o, &r);
        if (!o.json) fprintf(stderr, "%zu of %zu\r", i + 1, sizeof parts / sizeof parts[0]);
    }
    if (result == BOLAN_OK) (o.json ? print_json : print_table)(&o, &r);
    bolan_context_destroy(&context);
    return result == BOLAN_OK ? 0 : 1;
}

// SPDX-License-Identifier: MIT
// bolan-bench frame: the time of a frame, pass by pass, and its ratio to a full-screen pass of 6 bilinear texture
// fetches of the same size in the same run.
#include "stage.h"

#include <stdio.h>
#include <string.h>

#define SCENES_MAX 16

typedef struct frame_options {
    stage_options stage;
    const char *scenes[SCENES_MAX];
    uint32_t scene_count;
    const bolan_technique *technique; // NULL: each scene's own
} frame_options;

static void change(bolan_scene *scene, void *context) {
    const frame_options *o = context;
    if (o->technique) bolan_scene_set_technique(scene, o->technique);
}

static bolan_result measure(const char *name, frame_options *o, stage_figures *f) {
    stage s;
    bolan_result result = stage_open(&s, name, &o->stage, change, o);
    if (result != BOLAN_OK) return result;
    stage_measure(&s, true, f);
    stage_close(&s);
    return BOLAN_OK;
}

// ---- printing -------------------------------------------------------------------------------------------------------

static void print_json(const frame_options *o, const stage_figures *figures) {
    printf("{\n");
    stage_print_machine_json(&o->stage, figures[0].yard);
    printf("  \"frame\": [\n");
    stage_print_json(&o->stage, figures, o->scene_count);
    printf("  ]\n}\n");
}

static void print_table(const frame_options *o, const stage_figures *figures) {
    stage_print_machine(&o->stage, figures[0].yard);
    stage_print_table(figures, o->scene_count);
}

// ---- the command ----------------------------------------------------------------------------------------------------

static int usage(const char *why, const char *what) {
    fprintf(stderr,
            "bolan-bench frame: %s: %s\n"
            "usage: frame [--technique NAME] [--json] [--size WxH] [--quality low|medium|high|ultra] "
            "[--backend auto|cpu|compute] [--pixels auto|fragment|compute] [--threads N] [SCENE...]\n",
            why, what);
    return 2;
}

static int parse(int argc, char **argv, frame_options *o) {
    for (int i = 1; i < argc; ++i) {
        const int taken = stage_option("frame", argc, argv, &i, &o->stage);
        if (taken < 0) return 2;
        if (taken > 0) continue;
        if (strcmp(argv[i], "--technique") == 0) {
            const char *name = i + 1 < argc ? argv[++i] : "";
            o->technique = bolan_technique_find(name);
            if (!o->technique) return usage("--technique expects one that bolan info lists", name);
            continue;
        }
        if (argv[i][0] == '-') return usage("unknown option", argv[i]);
        if (o->scene_count == SCENES_MAX) return usage("too many scenes from here", argv[i]);
        o->scenes[o->scene_count++] = argv[i];
    }
    return 0;
}

int bench_frame(int argc, char **argv) {
    frame_options o = {.stage = stage_options_default()};
    int status = parse(argc, argv, &o);
    if (status != 0) return status;
    if (o.scene_count == 0) {
        static const char *const usual[] = {"island", "open-sea", "storm"};
        for (size_t i = 0; i < sizeof usual / sizeof usual[0]; ++i) o.scenes[o.scene_count++] = usual[i];
    }
    bolan_set_threads(o.stage.threads);
    bolan_context *context = NULL;
    if (bolan_context_create(BOLAN_GL_CORE, &context) != BOLAN_OK) return 1;
    stage_figures figures[SCENES_MAX];
    for (uint32_t i = 0; i < o.scene_count && status == 0; ++i)
        if (measure(o.scenes[i], &o, &figures[i]) != BOLAN_OK) status = 1;
    if (status == 0) (o.stage.json ? print_json : print_table)(&o, figures);
    bolan_context_destroy(&context);
    return status;
}

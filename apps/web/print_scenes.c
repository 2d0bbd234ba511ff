// SPDX-License-Identifier: MIT
// Prints the built-in scenes as C, for the web page, which has no reader of scene files: print_scenes > scenes.c
// Scenes that need a raster or a spectrum file are left out. A path of the camera becomes its place at the scene's
// time.
#include "bolan/io.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

// A member of the scene: "sky", or "objects[3]" of a list.
typedef struct place {
    const bolan_param_table *table;
    const char *name; // "" is the scene itself
    const void *now, *before;
} place;

static void print_text(const char *text) {
    putchar('"');
    for (; *text; text++) {
        if (*text == '"' || *text == '\\') putchar('\\');
        putchar(*text);
    }
    putchar('"');
}

static void print_row(const place *at, const bolan_param *p) {
    const char *dot = *at->name ? "." : "", *text = (const char *)at->now + p->offset;
    if (p->kind == BOLAN_PARAM_TEXT) {
        if (strcmp(text, (const char *)at->before + p->offset) == 0) return;
        printf("    put(s->%s%s%s, sizeof s->%s%s%s, ", at->name, dot, p->field, at->name, dot, p->field);
        print_text(text);
        puts(");");
        return;
    }
    const double value = bolan_param_get(p, at->now), before = bolan_param_get(p, at->before);
    if (value == before || (isnan(value) && isnan(before))) return;
    char number[40];
    bolan_format(number, sizeof number, "%.17g", value);
    printf("    s->%s%s%s = %s;\n", at->name, dot, p->field, number);
}

static void print_place(const place *at) {
    for (uint32_t i = 0; i < at->table->count; i++) print_row(at, &at->table->params[i]);
}

static void print_list(const char *list, const bolan_param_table *table, const void *now, const void *before,
                       size_t stride, uint32_t count) {
    for (uint32_t i = 0; i < count; i++) {
        char name[96];
        snprintf(name, sizeof name, "%s[%u]", list, (unsigned)i);
        print_place(&(place){table, name, (const char *)now + i * stride, (const char *)before + i * stride});
    }
}

static void print_group(const bolan_param_group *g, const bolan_scene *scene, const bolan_scene *plain) {
    const char *now = (const char *)scene + g->offset, *before = (const char *)plain + g->offset;
    if (g->capacity == 0) {
        print_place(&(place){g->table, g->field, now, before});
        return;
    }
    uint32_t count;
    memcpy(&count, (const char *)scene + g->count_offset, sizeof count);
    print_list(g->field, g->table, now, before, g->stride, count);
}

// What the tables of scene files leave out.
static void print_rest(const bolan_scene *s, const bolan_scene *plain) {
    const bolan_sea_state *state = &s->sea.sea_state;
    printf("    s->technique = *bolan_technique_find(\"%s\");\n", s->technique.name);
    printf("    s->sea.waves = s->technique.waves;\n");
    printf("    s->object_count = %u;\n    s->train_count = %u;\n", (unsigned)s->object_count,
           (unsigned)s->train_count);
    printf("    s->sea.sea_state.system_count = %u;\n", (unsigned)state->system_count);
    print_list("sea.sea_state.systems", &bolan_wave_system_params, state->systems, plain->sea.sea_state.systems,
               sizeof *state->systems, state->system_count);
    printf("    s->terrain.shown_by_object = %d;\n", (int)s->terrain.shown_by_object);
}

static int print_scene(const char *name, int count) {
    const bolan_scene plain = bolan_scene_default();
    bolan_scene scene;
    if (bolan_scene_load(name, &scene) != BOLAN_OK) return -1;
    if (scene.terrain.kind == BOLAN_GROUND_RASTER || scene.spectrum_path[0] || scene.tiles_path[0]) return 0;
    scene.camera = bolan_scene_camera_at(&scene, scene.time);
    scene.camera_key_count = 0;
    printf("static void scene_%d(bolan_scene *s) {\n", count);
    for (const bolan_param_group *g = bolan_scene_groups; g->table; g++) print_group(g, &scene, &plain);
    print_rest(&scene, &plain);
    puts("}\n");
    return 1;
}

int main(void) {
    int count = 0;
    puts("// Written by print_scenes from the folder scenes/.\n#include \"scenes.h\"\n\n#include <stdio.h>\n");
    puts("static void put(char *field, size_t size, const char *text) { snprintf(field, size, \"%s\", text); }\n");
    const char *names[32];
    for (uint32_t i = 0; count < 32 && bolan_scene_builtin_name(i); i++) {
        const int printed = print_scene(bolan_scene_builtin_name(i), count);
        if (printed < 0) return 1;
        if (printed > 0) names[count++] = bolan_scene_builtin_name(i);
    }
    puts("const web_scene web_scenes[] = {");
    for (int i = 0; i < count; i++) printf("    {\"%s\", scene_%d},\n", names[i], i);
    puts("    {NULL, NULL},\n};");
    return 0;
}

// SPDX-License-Identifier: MIT
// print_variants SHADER-FOLDER OUT-FOLDER: every variant of the water's programs that the optics list for any setup
// (src/render/programs.h), as the text that the engine hands to the driver: each stage, core and ES, one file each.
#include "render/gl/source.h"
#include "render/half_rate.h"
#include "render/papers/tiles.h"
#include "render/water_optics.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const water_optics *const optics[] = {&bolan_optics_physical, &bolan_optics_mirror, &bolan_optics_phong,
                                             &bolan_optics_lit, &bolan_optics_crest};
enum { OPTICS = sizeof optics / sizeof *optics };

// Names like water_physical.LAND_1.TAPS_2.core.frag: glslangValidator takes the stage from the last ending.
static void name_file(const char *folder, const char *stem, const char *defines, bool es, const char *ending,
                      char out[512]) {
    const int start = snprintf(out, 512, "%s/", folder);
    snprintf(out + start, 512 - (size_t)start, "%s.%s%s.%s", stem, defines, es ? "es" : "core", ending);
    for (char *c = out + start; *c != '\0'; ++c) *c = (char)(*c == '/' ? '-' : *c == ' ' ? '_' : *c == '\n' ? '.' : *c);
}

static bool write_variant(const char *folder, const water_shader *shader, const char *defines) {
    static const char *const stages[][2] = {{"VERTEX", "vert"}, {"FRAGMENT", "frag"}, {"COMPUTE", "comp"}};
    for (int i = shader->dispatched ? 4 : 0; i < (shader->dispatched || shader->pixels ? 6 : 4); ++i) {
        const char *const *stage = stages[i / 2];
        const bool es = i & 1;
        char path[512];
        shader_text text;
        name_file(folder, shader->stem, defines, es, stage[1], path);
        if (bolan_shader_text_build(shader->stem, stage[0], defines, es, &text) != BOLAN_OK) return false;
        FILE *file = fopen(path, "w");
        const bool written = file != NULL && fputs(text.text, file) >= 0;
        if (file == NULL || fclose(file) != 0 || !written) {
            fprintf(stderr, "cannot write %s\n", path);
            return false;
        }
        bolan_shader_text_free(&text);
    }
    return true;
}

// The mirror optics has one set of variants for a sea that is baked into tiles, and one for others.
static void *state_of(const water_optics *o, bool tiles) {
    void *state = calloc(1, o->size);
    if (state != NULL && o == &bolan_optics_mirror && tiles) {
        static char base, fine; // only compared, never read
        paper_tiles *t = state;
        t->base = (bolan_tiles *)(void *)&base;
        t->fine = (bolan_tiles *)(void *)&fine;
    }
    return state;
}

static void list(const water_optics *o, const water_setup *s, water_programs *all) {
    half_rate sparse = {.farthest.stem = "listed"}; // its one program outside the list has no variants
    for (int tiles = 0; tiles <= (o == &bolan_optics_mirror); ++tiles) {
        void *state = state_of(o, tiles);
        if (state != NULL) o->list(state, s, all);
        free(state);
    }
    if (s->shares_samples) bolan_half_rate_prepare(&sparse, s, o->shape != NULL, all);
}

// Bits of `choice`: land, paper, bounds with bound waves, layers with streaks of foam, compute shaders without foam;
// what else stands in the picture goes with the land.
static void list_setups(const water_optics *o, bolan_quality quality, bolan_surface_kind surface, int choice,
                        water_programs *all) {
    static const bolan_wave_form forms[] = {BOLAN_FORM_CASCADES, BOLAN_FORM_COSINES, BOLAN_FORM_EXP_COSINES};
    const bool land = choice & 1, bounds = choice & 4, layers = choice & 8, compute = choice & 16;
    const bolan_look look = {.paper = choice & 2};
    for (int i = 0; i < 3; ++i) {
        const water_waves waves = bolan_water_waves_of(forms[i], surface);
        const mesh_rules *rules = o->mesh != NULL ? o->mesh(&look) : NULL;
        const bool grid = bolan_water_mesh_is_fixed(surface, waves, (mesh_wishes){.coarse = false}, rules);
        const water_setup s = {.quality = quality,
                               .waves = waves,
                               .waves_below = bolan_water_waves_of(forms[i], BOLAN_SURFACE_QUAD),
                               .surface = surface,
                               .below = o->draw_body != NULL,
                               .land = land,
                               .static_grid = grid,
                               .packed = o->packed,
                               .bounds = bounds,
                               .layers = layers,
                               .bound_waves = bounds,
                               .compute = compute,
                               .foams = !compute,
                               .streaks = layers,
                               .look = &look,
                               .shares_samples = o->shade_columns(&look, quality) > 1,
                               .wave_count = 5,
                               .cascades = waves == WATER_CASCADES ? BOLAN_MAX_CASCADES : 1};
        list(o, &s, all);
    }
}

int main(int argc, char **argv) {
    if (argc != 3) {
        fprintf(stderr, "usage: print_variants SHADER-FOLDER OUT-FOLDER\n");
        return 2;
    }
    static const int choices[] = {0, 1, 2, 3, 4, 5, 8, 9, 16, 17};
    water_programs all = {0};
    for (int o = 0; o < OPTICS; ++o)
        for (int quality = BOLAN_QUALITY_LOW; quality <= BOLAN_QUALITY_ULTRA; ++quality)
            for (int surface = BOLAN_SURFACE_PROJECTED; surface <= BOLAN_SURFACE_QUAD; ++surface)
                // paper, bounds and layers meet no line that depends on the quality
                for (int i = 0; i < (quality == BOLAN_QUALITY_HIGH ? 10 : 2); ++i)
                    list_setups(optics[o], (bolan_quality)quality, (bolan_surface_kind)surface, choices[i], &all);
    bolan_gl_program_set_directory(argv[1]);
    bool written = all.count > 0 && !all.refused;
    for (uint32_t i = 0; i < all.count && written; ++i) {
        char defines[256];
        bolan_water_variant_defines(&all.list[i].variant, defines, sizeof defines);
        written = write_variant(argv[2], all.list[i].variant.shader, defines);
    }
    printf("%u variants of the water's programs\n", all.count);
    bolan_water_programs_free(&all);
    return written ? 0 : 1;
}

// SPDX-License-Identifier: MIT
// See programs.h. A list that grows in prepare(); tens of variants at most, so that looking one up is a short walk.
#include "programs.h"
#include "memory.h"

#include <stdio.h>
#include <string.h>

static const char *const feature_defines[WATER_FEATURE_COUNT] = {
    "WAVES_EXP 1\n",   "WAVES_SUM 1\n", "WAVES_MESH 1\n", "QUAD 1\n",   "TRIM 1\n",        "LAND 1\n",
    "STATIC_GRID 1\n", "PACKED 1\n",    "BOUNDS 1\n",     "LAYERS 1\n", "BOUND_WAVES 1\n", "NESTED_GRID 1\n"};

enum { FIRST_PROGRAMS = 32 };

// ---- which ----------------------------------------------------------------------------------------------------------

static bool is_same(const water_variant *a, const water_variant *b) {
    return a->shader == b->shader && a->features == b->features && a->own == b->own && a->waves == b->waves &&
           a->compute == b->compute;
}

static uint32_t features_of_waves(water_waves waves) {
    return waves == WATER_EXP    ? WATER_FEATURE_EXP
           : waves == WATER_SUM  ? WATER_FEATURE_SUM
           : waves == WATER_MESH ? WATER_FEATURE_MESH
                                 : 0;
}

water_variant bolan_water_variant_of(const water_shader *shader, uint32_t own, water_waves waves, uint32_t wave_count,
                                     uint32_t features, bool compute) {
    features |= features_of_waves(waves);
    if (waves != WATER_CASCADES) features &= ~(uint32_t)WATER_FEATURE_CASCADES;
    features &= shader->reads;
    return (water_variant){.shader = shader,
                           .features = features,
                           .own = own,
                           .waves = features & WATER_FEATURE_EXP ? wave_count : 0,
                           .compute = shader->dispatched || (compute && shader->pixels)};
}

static bool grow(water_programs *all) {
    const uint32_t capacity = all->capacity > 0 ? 2 * all->capacity : FIRST_PROGRAMS;
    water_program *list = allocate_for("the programs of the water", capacity * sizeof *list);
    if (list == NULL) return false;
    if (all->count > 0) memcpy(list, all->list, all->count * sizeof *list);
    bolan_release(all->list, all->capacity * sizeof *list);
    all->list = list;
    all->capacity = capacity;
    return true;
}

static bool add(water_programs *all, const water_variant *v) {
    for (uint32_t i = 0; i < all->count; ++i)
        if (is_same(&all->list[i].variant, v)) return true;
    if (all->count == all->capacity && !grow(all)) {
        all->refused = true;
        return false;
    }
    all->list[all->count++] = (water_program){.variant = *v};
    return true;
}

uint32_t bolan_water_grid_feature(bolan_surface_kind surface) {
    return surface == BOLAN_SURFACE_NESTED ? WATER_FEATURE_NESTED : WATER_FEATURE_GRID;
}

bool bolan_water_programs_add(water_programs *all, const water_setup *s, bool below, const water_shader *shader,
                              uint32_t own) {
    const bool quad = below || s->surface == BOLAN_SURFACE_QUAD;
    const uint32_t features = (quad ? WATER_FEATURE_QUAD : 0) | (s->land ? WATER_FEATURE_LAND : 0) |
                              (s->static_grid && !quad ? bolan_water_grid_feature(s->surface) : 0) |
                              (s->packed ? WATER_FEATURE_PACKED : 0) | (s->bounds ? WATER_FEATURE_BOUNDS : 0) |
                              (s->layers ? WATER_FEATURE_LAYERS : 0) | (s->bound_waves ? WATER_FEATURE_BOUND : 0);
    const water_waves waves = below ? s->waves_below : s->waves;
    const water_variant plain = bolan_water_variant_of(shader, own, waves, s->wave_count, features, s->compute);
    const water_variant trimmed =
        bolan_water_variant_of(shader, own, waves, s->wave_count, features | WATER_FEATURE_TRIM, s->compute);
    return add(all, &plain) && (!quad || below || add(all, &trimmed));
}

const gl_program *bolan_water_programs_find(const water_programs *all, const water_variant *v) {
    for (uint32_t i = 0; i < all->count; ++i)
        if (is_same(&all->list[i].variant, v)) return all->list[i].program.id != 0 ? &all->list[i].program : NULL;
    BOLAN_ASSERT(all->refused && "every program of the water is listed by its optics");
    return NULL;
}

// ---- compiling ------------------------------------------------------------------------------------------------------

static bool append(char *text, size_t size, const char *line) {
    const size_t length = strlen(text);
    snprintf(text + length, size - length, "%s", line);
    return length + strlen(line) < size;
}

void bolan_water_variant_defines(const water_variant *v, char *defines, size_t size) {
    char count[24];
    bool all = true;
    defines[0] = '\0';
    for (int i = 0; i < WATER_FEATURE_COUNT; ++i)
        if (v->features & 1u << i) all = append(defines, size, feature_defines[i]) && all;
    snprintf(count, sizeof count, "WAVE_COUNT %u\n", v->waves);
    if (v->waves > 0) all = append(defines, size, count) && all;
    for (int i = 0; i < WATER_SHADER_DEFINES; ++i)
        if (v->own & 1u << i) all = append(defines, size, v->shader->defines[i]) && all;
    BOLAN_ASSERT(all);
}

static void compile(water_program *p) {
    char defines[sizeof p->program.defines];
    bolan_water_variant_defines(&p->variant, defines, sizeof defines);
    const bolan_result result = p->variant.compute
                                    ? bolan_gl_program_create_compute(p->variant.shader->stem, defines, &p->program)
                                    : bolan_gl_program_create(p->variant.shader->stem, defines, &p->program);
    if (result != BOLAN_OK) p->program.id = 0;
    p->compiled = true;
}

uint32_t bolan_water_programs_missing(const water_programs *all) {
    uint32_t missing = 0;
    for (uint32_t i = 0; i < all->count; ++i) missing += !all->list[i].compiled;
    return missing;
}

void bolan_water_programs_compile(water_programs *all, bolan_progress *progress, void *user) {
    const uint32_t total = bolan_water_programs_missing(all);
    for (uint32_t i = 0, done = 0; i < all->count; ++i) {
        if (all->list[i].compiled) continue;
        compile(&all->list[i]);
        ++done;
        if (progress != NULL) progress(user, done, total);
    }
}

bool bolan_water_programs_are_whole(const water_programs *all) {
    for (uint32_t i = 0; i < all->count; ++i)
        if (all->list[i].program.id == 0) return false;
    return true;
}

bolan_result bolan_water_programs_reload(water_programs *all) {
    bolan_result result = BOLAN_OK;
    for (uint32_t i = 0; i < all->count && result == BOLAN_OK; ++i)
        if (all->list[i].compiled) result = bolan_gl_program_reload(&all->list[i].program);
    return result;
}

void bolan_water_programs_free(water_programs *all) {
    for (uint32_t i = 0; i < all->count; ++i) bolan_gl_program_free(&all->list[i].program);
    bolan_release(all->list, all->capacity * sizeof *all->list);
    *all = (water_programs){0};
}

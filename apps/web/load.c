// SPDX-License-Identifier: MIT
// Worlds without files. bolan_world_load_scene() of bolan_io does the same with them.
#include "load.h"

#include "bolan/content.h"

#include <string.h>

static const char *const builtin = "builtin:";

// The index of the first object with the model of object `i`.
static uint32_t first_like(const bolan_scene *scene, uint32_t i) {
    uint32_t same = 0;
    while (strcmp(scene->objects[same].model, scene->objects[i].model) != 0) same++;
    return same;
}

static bolan_result load_models(const bolan_scene *scene, bolan_world_assets *out) {
    for (uint32_t i = 0; i < scene->object_count; i++) {
        const uint32_t same = first_like(scene, i);
        if (same == i) {
            bolan_model **model = &out->models[out->model_count];
            const bolan_result result = bolan_content_create_model(scene->objects[i].model + strlen(builtin), model);
            if (result) return result;
            out->object_models[i] = *model;
            out->model_count++;
        } else {
            out->object_models[i] = out->object_models[same];
        }
    }
    return BOLAN_OK;
}

bolan_result load_world(const bolan_scene *scene, bolan_world **out) {
    bolan_world_assets assets = {.model_count = 0};
    bolan_result result = BOLAN_OK;
    *out = NULL;
    if (scene->terrain.kind == BOLAN_GROUND_GENERATED)
        result = bolan_content_create_ground(&scene->terrain.generator, &assets.ground);
    if (!result) result = load_models(scene, &assets);
    if (!result) return bolan_world_create(&(bolan_world_desc){.scene = scene, .assets = &assets}, out);
    bolan_world_assets_destroy(&assets);
    return result;
}

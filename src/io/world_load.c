// SPDX-License-Identifier: MIT
// Worlds: loads the objects that a scene refers to: spectrum, ground, tiles and models.
#include "bolan/io.h"

#include "bolan/content.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

// Global relief of Debian's package ferret-datasets (ETOPO5, US National Geophysical Data Center, 5 minutes of arc).
static const char *const global_relief = "/usr/share/ferret-vis/data/etopo5.cdf";

static bolan_result no_raster(const bolan_scene *scene) {
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_RASTER_OPEN,
              "%s: the scene needs a raster of elevations; give one with --terrain FILE [--at LAT,LON], or install the "
              "package ferret-datasets",
              scene->name);
    return BOLAN_ERROR_IO;
}

static bolan_result load_ground(const bolan_scene *scene, bolan_ground **out) {
    const bolan_ground_source *t = &scene->terrain;
    if (t->kind == BOLAN_GROUND_NONE) return BOLAN_OK;
    if (t->kind == BOLAN_GROUND_GENERATED) return bolan_content_create_ground(&t->generator, out);
    bolan_raster_desc desc = t->raster;
    if (!desc.path[0]) snprintf(desc.path, sizeof desc.path, "%s", global_relief);
    if (!t->raster.path[0] && access(desc.path, R_OK) != 0) return no_raster(scene);
    return bolan_raster_load(&desc, out);
}

static bolan_result load_model(const bolan_object *object, bolan_model **out) {
    static const char *const builtin = "builtin:";
    const char *name = object->model;
    if (strncmp(name, builtin, strlen(builtin)) == 0) return bolan_content_create_model(name + strlen(builtin), out);
    return bolan_model_load(&(bolan_model_desc){.path = name, .up = object->up, .offset = object->offset}, out);
}

static bool same_model(const bolan_object *a, const bolan_object *b) {
    return strcmp(a->model, b->model) == 0 && a->up == b->up && a->offset.x == b->offset.x &&
           a->offset.y == b->offset.y && a->offset.z == b->offset.z;
}

// Loads each different model once.
static bolan_result load_models(const bolan_scene *scene, bolan_world_assets *out) {
    for (uint32_t i = 0; i < scene->object_count; i++) {
        uint32_t same = 0;
        while (same < i && !same_model(&scene->objects[same], &scene->objects[i])) same++;
        if (same == i) {
            const bolan_result result = load_model(&scene->objects[i], &out->models[out->model_count]);
            if (result) return result;
            out->object_models[i] = out->models[out->model_count++];
        } else {
            out->object_models[i] = out->object_models[same];
        }
    }
    return BOLAN_OK;
}

static bolan_result load_assets(const bolan_scene *scene, bolan_world_assets *out) {
    bolan_result result = BOLAN_OK;
    if (scene->spectrum_path[0]) result = bolan_spectrum_load(scene->spectrum_path, &scene->spectrum, &out->spectrum);
    if (!result) result = load_ground(scene, &out->ground);
    if (!result && scene->tiles_path[0]) result = bolan_tiles_load(scene->tiles_path, &out->tiles);
    if (!result) result = load_models(scene, out);
    return result;
}

bolan_result bolan_world_load_scene(const bolan_scene *scene, bolan_world **out) {
    BOLAN_ASSERT(scene && out);
    *out = NULL;
    bolan_world_assets assets = {.model_count = 0};
    const bolan_result result = load_assets(scene, &assets);
    if (!result) return bolan_world_create(&(bolan_world_desc){.scene = scene, .assets = &assets}, out);
    bolan_world_assets_destroy(&assets);
    return result;
}

bolan_result bolan_world_load(const char *name_or_path, bolan_world **out) {
    BOLAN_ASSERT(name_or_path && out);
    *out = NULL;
    bolan_scene scene;
    const bolan_result result = bolan_scene_load(name_or_path, &scene);
    return result ? result : bolan_world_load_scene(&scene, out);
}

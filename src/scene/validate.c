// SPDX-License-Identifier: MIT
// Every field of a scene against its range, by the tables of params.c.
#include "bolan/scene.h"

#include <stdio.h>
#include <string.h>

// One sentence for a rule that no table states.
static bolan_result refuse(const char *field, double value, const char *expected) {
    bolan_log(BOLAN_LOG_ERROR, isfinite(value) ? BOLAN_LOG_OUT_OF_RANGE : BOLAN_LOG_NOT_FINITE,
              "scene: %s is %g; expected %s", field, value, expected);
    return BOLAN_ERROR_ARGUMENT;
}

static bool is_used(const bolan_scene *scene, const bolan_param_group *group) {
    if (group->table == &bolan_ground_generator_params) return scene->terrain.kind == BOLAN_GROUND_GENERATED;
    return group->table != &bolan_raster_params || scene->terrain.kind == BOLAN_GROUND_RASTER;
}

static bolan_result check_group(const bolan_scene *scene, const bolan_param_group *group) {
    const char *place = (const char *)scene + group->offset;
    char where[64];
    snprintf(where, sizeof where, "scene: %s%s", group->field, *group->field ? "." : "");
    if (group->capacity == 0) return bolan_params_validate(group->table, place, where);
    uint32_t count;
    memcpy(&count, (const char *)scene + group->count_offset, sizeof count);
    for (uint32_t i = 0; i < count; i++, place += group->stride) {
        snprintf(where, sizeof where, "scene: %s[%u].", group->field, (unsigned)i);
        if (bolan_params_validate(group->table, place, where)) return BOLAN_ERROR_ARGUMENT;
    }
    return BOLAN_OK;
}

static bolan_result check_counts(const bolan_scene *scene) {
    if (scene->object_count > BOLAN_MAX_OBJECTS) return refuse("object_count", scene->object_count, "0 to 64");
    if (scene->train_count > BOLAN_MAX_WAVE_LAYERS) return refuse("train_count", scene->train_count, "0 to 8");
    if (scene->camera_key_count > BOLAN_MAX_CAMERA_KEYS)
        return refuse("camera_key_count", scene->camera_key_count, "0 to 32");
    return BOLAN_OK;
}

static bolan_result check_times(const bolan_scene *scene) {
    for (uint32_t i = 1; i < scene->camera_key_count; i++)
        if (!(scene->camera_keys[i].time >= scene->camera_keys[i - 1].time + 1e-3))
            return refuse("camera_keys.time", scene->camera_keys[i].time, "a time later than that of the key before");
    return BOLAN_OK;
}

bolan_result bolan_scene_validate(const bolan_scene *scene) {
    BOLAN_ASSERT(scene);
    if (check_counts(scene)) return BOLAN_ERROR_ARGUMENT;
    for (const bolan_param_group *g = bolan_scene_groups; g->table; g++)
        if (is_used(scene, g) && check_group(scene, g)) return BOLAN_ERROR_ARGUMENT;
    return check_times(scene) || bolan_sea_state_validate(&scene->sea.sea_state) ||
                   bolan_spectrum_options_validate(&scene->spectrum)
               ? BOLAN_ERROR_ARGUMENT
               : BOLAN_OK;
}

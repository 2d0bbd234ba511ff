// SPDX-License-Identifier: MIT
// Scenes by name or path.
#include "io/file.h"
#include "io/scene_file.h"
#include "io/scene_source.h"
#include "io/yaml_limits.h"

#include <stdio.h>
#include <string.h>

static const char *const suffix = ".yaml";

// The stem of an embedded file of the folder scenes/ itself (below it lie spectra), or 0.
static int stem_length(const bolan_scene_source *source) {
    const size_t length = strlen(source->path), tail = strlen(suffix);
    if (strchr(source->path, '/') || length <= tail || strcmp(source->path + length - tail, suffix) != 0) return 0;
    return (int)(length - tail);
}

static const bolan_scene_source *find_builtin(const char *name) {
    for (unsigned i = 0; i < bolan_scene_source_count; i++) {
        const int length = stem_length(&bolan_scene_sources[i]);
        if (length > 0 && strlen(name) == (size_t)length &&
            memcmp(name, bolan_scene_sources[i].path, (size_t)length) == 0)
            return &bolan_scene_sources[i];
    }
    return NULL;
}

const char *bolan_scene_builtin_name(uint32_t index) {
    static char names[32][BOLAN_NAME_MAX];
    uint32_t found = 0;
    for (unsigned i = 0; i < bolan_scene_source_count && found < 32; i++) {
        const int length = stem_length(&bolan_scene_sources[i]);
        if (length == 0) continue;
        if (found == index) {
            snprintf(names[found], sizeof names[found], "%.*s", length, bolan_scene_sources[i].path);
            return names[found];
        }
        found++;
    }
    return NULL;
}

// `on_disk`: the name is a path, and paths of models are relative to it.
static bolan_result parse(const char *name, const char *text, size_t size, bool on_disk, bolan_scene *out) {
    scene_file file;
    schema_given given;
    bolan_scene scene = bolan_scene_default();
    memset(&file, 0, sizeof file);
    const schema_target targets[SCHEMA_TARGETS] = {{bolan_scene_groups, &scene}, {bolan_scene_file_groups, &file}};
    bolan_result result = bolan_schema_read(name, text, size, targets, &given);
    if (!result) result = bolan_scene_file_finish(&file, &given, name, &scene);
    if (!result && on_disk) result = bolan_scene_file_find_models(&given, name, &scene);
    if (!result) result = bolan_scene_validate(&scene);
    if (result) return result;
    const char *slash = strrchr(name, '/');
    const char *part = slash ? slash + 1 : name;
    snprintf(scene.name, sizeof scene.name, "%.*s", (int)bolan_text_fit(part, sizeof scene.name - 1), part);
    *out = scene;
    return BOLAN_OK;
}

bolan_result bolan_scene_parse(const char *name, const char *text, size_t size, bolan_scene *scene) {
    BOLAN_ASSERT(name && text && scene);
    return parse(name, text, size, false, scene);
}

static bolan_result too_long(const char *path) {
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_SCENE_BAD_VALUE, "%s: a path in it is longer than %d characters", path,
              BOLAN_PATH_MAX - 1);
    return BOLAN_ERROR_FORMAT;
}

// Paths in the file are relative to its folder; names of built-in spectra stay.
static bolan_result resolve(const char *beside, char path[BOLAN_PATH_MAX]) {
    char resolved[BOLAN_PATH_MAX];
    if (path[0] == '\0' || strncmp(path, "builtin:", 8) == 0) return BOLAN_OK;
    if (!bolan_file_resolve(beside, path, resolved)) return too_long(beside);
    memcpy(path, resolved, sizeof resolved);
    return BOLAN_OK;
}

static bolan_result load_file(const char *path, bolan_scene *out) {
    file_text text;
    bolan_result result = bolan_file_read(path, YAML_SIZE_LIMIT, &text);
    if (result) return result;
    bolan_scene scene;
    result = parse(path, text.data, text.size, true, &scene);
    bolan_file_release(&text);
    if (!result) result = resolve(path, scene.spectrum_path);
    if (!result && !bolan_file_resolve_raster(path, scene.terrain.raster.path)) result = too_long(path);
    if (!result) result = resolve(path, scene.tiles_path);
    if (!result) *out = scene;
    return result;
}

static bolan_result unknown_scene(const char *name) {
    char list[256] = "";
    for (uint32_t i = 0; bolan_scene_builtin_name(i); i++) {
        const size_t used = strlen(list);
        snprintf(list + used, sizeof list - used, "%s%s", i ? ", " : "", bolan_scene_builtin_name(i));
    }
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_UNKNOWN_NAME, "%s: there is no such scene; expected %s, or a YAML file", name,
              list);
    return BOLAN_ERROR_ARGUMENT;
}

bolan_result bolan_scene_load(const char *name_or_path, bolan_scene *scene) {
    BOLAN_ASSERT(name_or_path && scene);
    const bolan_scene_source *builtin = find_builtin(name_or_path);
    if (!builtin) {
        const bool looks_like_a_path = strpbrk(name_or_path, "/.") != NULL;
        return looks_like_a_path ? load_file(name_or_path, scene) : unknown_scene(name_or_path);
    }
    const bolan_result result = parse(builtin->path, builtin->text, strlen(builtin->text), false, scene);
    if (!result) snprintf(scene->name, sizeof scene->name, "%.*s", stem_length(builtin), builtin->path);
    return result;
}

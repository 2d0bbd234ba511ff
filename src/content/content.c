// SPDX-License-Identifier: MIT
// The generated grounds and models by name.
#include "bolan/content.h"

#include "content/island.h"
#include "content/model_build.h"
#include "content/pond.h"

#include <string.h>

static const struct {
    const char *name;
    bolan_result (*create)(const bolan_ground_generator *generator, bolan_ground **out);
} grounds[] = {
    {"island", bolan_island_create},
    {"pond", bolan_pond_create},
};
#define GROUNDS (sizeof grounds / sizeof *grounds)

static const struct {
    const char *name;
    void (*build)(model_builder *b);
} models[] = {
    {"pond-ground", bolan_model_pond_ground},
    {"pond-wood", bolan_model_pond_wood},
    {"house", bolan_model_house},
    {"boat", bolan_model_boat},
    {"stick", bolan_model_stick},
    {"tree", bolan_model_tree},
    {"conifer", bolan_model_conifer},
    {"reeds", bolan_model_reeds},
    {"jetty", bolan_model_jetty},
    {"rock", bolan_model_rock},
    {"coral", bolan_model_coral},
    {"staghorn", bolan_model_staghorn},
};
#define MODELS (sizeof models / sizeof *models)

const char *bolan_content_ground_name(uint32_t index) { return index < GROUNDS ? grounds[index].name : NULL; }

const char *bolan_content_model_name(uint32_t index) { return index < MODELS ? models[index].name : NULL; }

static bolan_result unknown(const char *what, const char *name, const char *(*name_of)(uint32_t index)) {
    char list[256] = "";
    size_t used = 0;
    for (uint32_t i = 0; name_of(i); i++) {
        const size_t length = strlen(name_of(i));
        if (used + length + 3 > sizeof list) break;
        if (i) memcpy(list + used, ", ", 2), used += 2;
        memcpy(list + used, name_of(i), length + 1), used += length;
    }
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_UNKNOWN_NAME, "there is no %s %.64s; expected one of %s", what, name, list);
    return BOLAN_ERROR_ARGUMENT;
}

bolan_result bolan_content_create_ground(const bolan_ground_generator *generator, bolan_ground **out) {
    BOLAN_ASSERT(generator && out);
    *out = NULL;
    for (size_t i = 0; i < GROUNDS; i++)
        if (strncmp(grounds[i].name, generator->name, sizeof generator->name) == 0)
            return grounds[i].create(generator, out);
    return unknown("generated ground", generator->name, bolan_content_ground_name);
}

bolan_result bolan_content_create_model(const char *name, bolan_model **out) {
    BOLAN_ASSERT(name && out);
    *out = NULL;
    for (size_t i = 0; i < MODELS; i++) {
        if (strcmp(models[i].name, name) != 0) continue;
        model_builder b = {.failed = false};
        models[i].build(&b);
        const bolan_model_view view = {b.vertex_count, b.index_count, b.positions, b.normals, b.colors, b.indices};
        bolan_result result = BOLAN_ERROR_MEMORY;
        if (!b.failed)
            result = bolan_model_create(&view, out);
        else
            bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY, "no memory for the model %s", name);
        bolan_build_free(&b);
        return result;
    }
    return unknown("built-in model", name, bolan_content_model_name);
}

// SPDX-License-Identifier: MIT
// A scene with its assets and its water.
#include "bolan/world.h"

#include "bolan/query.h"

#include <string.h>

struct bolan_world {
    bolan_scene scene;
    bolan_world_assets assets;
    bolan_sea *sea;
    bolan_wave_layer *layers[BOLAN_MAX_WAVE_LAYERS]; // of scene.trains
    bolan_water water;                               // of the members above
};

// ---- layers ---------------------------------------------------------------------------------------------------------

static void destroy_layers(bolan_wave_layer *layers[BOLAN_MAX_WAVE_LAYERS]) {
    for (uint32_t i = 0; i < BOLAN_MAX_WAVE_LAYERS; i++) bolan_wave_layer_destroy(&layers[i]);
}

static bolan_result create_layers(const bolan_scene *scene, bolan_wave_layer *layers[BOLAN_MAX_WAVE_LAYERS]) {
    bolan_result result = BOLAN_OK;
    for (uint32_t i = 0; i < scene->train_count && !result; i++)
        result = bolan_wave_layer_create_train(&scene->trains[i], &layers[i]);
    if (result) destroy_layers(layers);
    return result;
}

// ---- assets ---------------------------------------------------------------------------------------------------------

void bolan_world_assets_destroy(bolan_world_assets *assets) {
    if (!assets) return;
    bolan_measured_spectrum_destroy(&assets->spectrum);
    bolan_ground_destroy(&assets->ground);
    bolan_tiles_destroy(&assets->tiles);
    for (uint32_t i = 0; i < BOLAN_MAX_OBJECTS; i++) bolan_model_destroy(&assets->models[i]);
    *assets = (bolan_world_assets){.model_count = 0};
}

static bolan_result check_models(const bolan_scene *scene, const bolan_world_assets *assets) {
    for (uint32_t i = 0; i < scene->object_count; i++) {
        if (assets->object_models[i]) continue;
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_WORLD_MODEL,
                  "world: object %u (%.64s) has no model; expected one in assets.object_models", (unsigned)i,
                  scene->objects[i].model);
        return BOLAN_ERROR_ARGUMENT;
    }
    return BOLAN_OK;
}

// ---- life -----------------------------------------------------------------------------------------------------------

bolan_world_desc bolan_world_desc_default(void) { return (bolan_world_desc){.scene = NULL}; }

static bolan_sea_desc sea_desc_of(const bolan_scene *scene, const bolan_world_assets *assets) {
    bolan_sea_desc desc = bolan_scene_sea_desc(scene);
    desc.sea_state.measured = assets->spectrum;
    return desc;
}

static void update_water(bolan_world *w) {
    w->water = bolan_water_default();
    w->water.sea = w->sea;
    w->water.ground = w->assets.ground;
    w->water.level = w->scene.water.level;
    w->water.layers = (const bolan_wave_layer *const *)w->layers;
    w->water.layer_count = w->scene.train_count;
    w->water.optics = bolan_water_optics_from_jerlov(w->scene.water.type);
    w->water.foam = w->scene.water.foam;
}

static bolan_result build(bolan_world *w, const bolan_scene *scene) {
    w->scene = *scene;
    bolan_result result = bolan_scene_validate(scene);
    if (!result) result = check_models(scene, &w->assets);
    if (!result) result = create_layers(scene, w->layers);
    if (result) return result;
    const bolan_sea_desc desc = sea_desc_of(scene, &w->assets);
    result = bolan_sea_create(&desc, &w->sea);
    if (result) return result;
    bolan_sea_step(w->sea, scene->time);
    update_water(w);
    return BOLAN_OK;
}

bolan_result bolan_world_create(const bolan_world_desc *desc, bolan_world **out) {
    BOLAN_ASSERT(desc && desc->scene && out);
    *out = NULL;
    bolan_world *w = bolan_allocate(sizeof *w);
    if (!w) {
        bolan_world_assets_destroy(desc->assets);
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY, "no memory for a world of %zu bytes", sizeof *w);
        return BOLAN_ERROR_MEMORY;
    }
    if (desc->assets) {
        w->assets = *desc->assets;
        *desc->assets = (bolan_world_assets){.model_count = 0};
    }
    const bolan_result result = build(w, desc->scene);
    if (result) {
        bolan_world_destroy(&w);
        return result;
    }
    *out = w;
    return BOLAN_OK;
}

void bolan_world_destroy(bolan_world **world) {
    if (!world || !*world) return;
    bolan_world *w = *world;
    bolan_sea_destroy(&w->sea);
    destroy_layers(w->layers);
    bolan_world_assets_destroy(&w->assets);
    bolan_release(w, sizeof *w);
    *world = NULL;
}

// ---- time and change ------------------------------------------------------------------------------------------------

void bolan_world_step(bolan_world *world, double time) {
    BOLAN_ASSERT(world);
    bolan_sea_step(world->sea, time);
    world->scene.time = time;
}

void bolan_world_settle(bolan_world *world, double time) {
    BOLAN_ASSERT(world);
    bolan_sea_settle(world->sea, time);
    world->scene.time = time;
}

void bolan_world_set_camera(bolan_world *world, const bolan_camera *camera) {
    BOLAN_ASSERT(world && camera);
    world->scene.camera = *camera;
}

// The first field of the table in which the two structs differ; NULL where they are equal.
static const char *difference(const bolan_param_table *table, const void *a, const void *b) {
    for (uint32_t i = 0; i < table->count; i++) {
        const bolan_param *p = &table->params[i];
        const char *x = (const char *)a + p->offset, *y = (const char *)b + p->offset;
        const bool same = p->kind == BOLAN_PARAM_TEXT ? strncmp(x, y, p->size) == 0 : memcmp(x, y, p->size) == 0;
        if (!same) return p->field;
    }
    return NULL;
}

static const char *terrain_difference(const bolan_ground_source *a, const bolan_ground_source *b) {
    if (a->kind != b->kind) return "terrain.kind";
    if (a->kind == BOLAN_GROUND_GENERATED && difference(&bolan_ground_generator_params, &a->generator, &b->generator))
        return "terrain.generator";
    if (a->kind == BOLAN_GROUND_RASTER && difference(&bolan_raster_params, &a->raster, &b->raster))
        return "terrain.raster";
    return NULL;
}

// The name of a field that the assets depend on and in which two scenes differ; NULL where there is none.
static const char *asset_difference(const bolan_scene *a, const bolan_scene *b) {
    const char *terrain = terrain_difference(&a->terrain, &b->terrain);
    if (terrain) return terrain;
    if (strcmp(a->spectrum_path, b->spectrum_path) != 0) return "spectrum_path";
    if (difference(&bolan_spectrum_options_params, &a->spectrum, &b->spectrum)) return "spectrum";
    if (strcmp(a->tiles_path, b->tiles_path) != 0) return "tiles_path";
    if (a->object_count != b->object_count) return "object_count";
    for (uint32_t i = 0; i < a->object_count; i++) {
        const bolan_object *x = &a->objects[i], *y = &b->objects[i];
        if (strcmp(x->model, y->model) != 0) return "objects.model";
        if (x->up != y->up) return "objects.up";
        if (x->offset.x != y->offset.x || x->offset.y != y->offset.y || x->offset.z != y->offset.z)
            return "objects.offset";
    }
    return NULL;
}

static bolan_result check_change(const bolan_world *w, const bolan_scene *scene) {
    const bolan_result result = bolan_scene_validate(scene);
    if (result) return result;
    const char *field = asset_difference(&w->scene, scene);
    if (!field) return BOLAN_OK;
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_WORLD_ASSETS,
              "world: scene.%s differs from that of the loaded world; expected the same, or a new world", field);
    return BOLAN_ERROR_ARGUMENT;
}

bolan_result bolan_world_set_scene(bolan_world *world, const bolan_scene *scene) {
    BOLAN_ASSERT(world && scene);
    const double time = world->scene.time;
    bolan_wave_layer *layers[BOLAN_MAX_WAVE_LAYERS] = {NULL};
    bolan_result result = check_change(world, scene);
    if (!result) result = create_layers(scene, layers);
    if (result) return result;
    // Bytes of padding may differ too; then an equal sea is made, which costs time but is correct.
    const bolan_sea_desc old = sea_desc_of(&world->scene, &world->assets), fresh = sea_desc_of(scene, &world->assets);
    if (memcmp(&old, &fresh, sizeof old) != 0) {
        bolan_sea *sea = NULL;
        result = bolan_sea_create(&fresh, &sea);
        if (result) {
            destroy_layers(layers);
            return result;
        }
        bolan_sea_settle(sea, time);
        bolan_sea_destroy(&world->sea);
        world->sea = sea;
    }
    destroy_layers(world->layers);
    memcpy(world->layers, layers, sizeof layers);
    world->scene = *scene;
    world->scene.time = time;
    update_water(world);
    return BOLAN_OK;
}

// ---- reading --------------------------------------------------------------------------------------------------------

const bolan_scene *bolan_world_scene(const bolan_world *world) {
    BOLAN_ASSERT(world);
    return &world->scene;
}

const bolan_water *bolan_world_water(const bolan_world *world) {
    BOLAN_ASSERT(world);
    return &world->water;
}

bolan_sea_desc bolan_world_sea_desc(const bolan_world *world) {
    BOLAN_ASSERT(world);
    return sea_desc_of(&world->scene, &world->assets);
}

const bolan_tiles *bolan_world_tiles(const bolan_world *world) {
    BOLAN_ASSERT(world);
    return world->assets.tiles;
}

const bolan_model *const *bolan_world_object_models(const bolan_world *world) {
    BOLAN_ASSERT(world);
    return world->assets.object_models;
}

bolan_camera bolan_world_camera_at(const bolan_world *world, double time) {
    BOLAN_ASSERT(world);
    bolan_camera camera = bolan_scene_camera_at(&world->scene, time);
    if (!world->assets.ground) return camera;
    bolan_dvec3 *p = &camera.position;
    const double ground = (double)bolan_ground_elevation(world->assets.ground, p->x, p->y, 0.0);
    p->z = fmax(p->z, ground + (ground > world->scene.water.level ? 1.8 : 0.3)); // standing on land; over the sea bed
    return camera;
}

#define EYE_CLEARANCE 0.3 // over the water [m]

bolan_dvec3 bolan_world_clear_eye(const bolan_world *world, bolan_dvec3 eye) {
    BOLAN_ASSERT(world);
    const bolan_optics_kind optics = world->scene.technique.optics;
    if (optics == BOLAN_OPTICS_PHYSICAL) return eye;
    if (eye.z < world->water.level && bolan_optics_seen_from_below(optics)) return eye;
    double vertical, horizontal;
    bolan_sea_bounds(world->sea, &vertical, &horizontal);
    if (world->water.layer_count == 0 && eye.z > world->water.level + vertical + EYE_CLEARANCE) return eye;
    const bolan_dvec2 place = {eye.x, eye.y};
    bolan_query_point water;
    bolan_query_surface(&world->water, &place, 1, &water);
    eye.z = fmax(eye.z, (double)water.height + EYE_CLEARANCE);
    return eye;
}

bolan_pose bolan_world_object_pose(const bolan_world *world, uint32_t index) {
    BOLAN_ASSERT(world);
    BOLAN_ASSERT(index < world->scene.object_count);
    if (index >= world->scene.object_count) return (bolan_pose){.origin = {0.0, 0.0, 0.0}};
    return bolan_object_pose(&world->scene.objects[index], world->assets.object_models[index], &world->water);
}

// SPDX-License-Identifier: MIT
/// @file world.h
/// Tier 3. A world: a scene, what it refers to, and its water, in one object.
///
/// **Ownership.** A world owns a copy of its scene, the assets that it was created with, and its sea.
/// Pointers that its functions return stay valid until the world is destroyed.
/// The pointer bolan_world_water()->sea changes when bolan_world_set_scene() makes another sea.
///
/// **Threads.** Functions that take a const world may run at the same time.
/// No other function of the same world may run beside them.
/// A thread that needs the water of another time takes a fork of the sea.
///
/// **Memory.** bolan_world_step(), bolan_world_settle() and bolan_world_set_camera() allocate nothing and cannot fail.
///
/// Worlds of files and built-in scenes come from bolan_world_load() of io.h.
#ifndef BOLAN_WORLD_H
#define BOLAN_WORLD_H

#include "bolan/model.h"
#include "bolan/scene.h"
#include "bolan/tiles.h"
#include "bolan/water.h"

#ifdef __cplusplus
extern "C" {
#endif

// ---- what a scene refers to -----------------------------------------------------------------------------------------

/// What a scene refers to, in memory.
typedef struct bolan_world_assets {
    /// The measured spectrum of scene->spectrum_path; NULL where there is none.
    bolan_measured_spectrum *spectrum;
    /// The ground of scene->terrain; NULL where there is none.
    bolan_ground *ground;
    /// The tiles of scene->tiles_path; NULL where there are none.
    bolan_tiles *tiles;
    /// Number of different models, 0..BOLAN_MAX_OBJECTS.
    uint32_t model_count;
    /// The different models.
    bolan_model *models[BOLAN_MAX_OBJECTS];
    /// The model of each object of the scene: one of `models`.
    const bolan_model *object_models[BOLAN_MAX_OBJECTS];
} bolan_world_assets;

/// Releases the assets and clears the struct.
/// NULL-safe.
BOLAN_API void bolan_world_assets_destroy(bolan_world_assets *assets);

// ---- the world ------------------------------------------------------------------------------------------------------

/// A scene with all that it refers to, and its water.
typedef struct bolan_world bolan_world;

/// How a world is made.
typedef struct bolan_world_desc {
    /// The scene; copied. Must be given.
    const bolan_scene *scene;
    /// What the scene refers to: taken over and cleared, also when the creation fails.
    /// Default NULL: the scene refers to nothing.
    bolan_world_assets *assets;
} bolan_world_desc;

/// The defaults named above the fields, and no scene.
BOLAN_API bolan_world_desc bolan_world_desc_default(void);

/// Makes a world, whose sea is stepped to scene->time.
/// @param out receives the world; NULL on failure, and then nothing is left in memory.
/// Errors: ARGUMENT (a field of the scene out of range, an object without a model), MEMORY.
BOLAN_API bolan_result bolan_world_create(const bolan_world_desc *desc, bolan_world **out);

/// Releases the world and everything in it.
/// NULL-safe; NULLs the pointer.
BOLAN_API void bolan_world_destroy(bolan_world **world);

// ---- time and change ------------------------------------------------------------------------------------------------

/// Steps the sea to @p time [s] and sets the scene's time.
/// The foam remembers the last seconds where steps follow each other within 1 s: see bolan_sea_step().
/// The camera stays: see bolan_world_camera_at().
BOLAN_API void bolan_world_step(bolan_world *world, double time);

/// Like bolan_world_step(), with the foam that a running sea would show at @p time: see bolan_sea_settle().
BOLAN_API void bolan_world_settle(bolan_world *world, double time);

/// Replaces the scene's camera.
BOLAN_API void bolan_world_set_camera(bolan_world *world, const bolan_camera *camera);

/// Replaces the scene by a copy of @p scene, at the present time of the world.
/// Where the sea's desc differs, another sea takes the place of the present one, settled at the present time.
/// What the assets stand for must not differ: the terrain's source, spectrum_path and its options, tiles_path, and the
/// number and the models of objects. Objects may move.
/// Errors: ARGUMENT (a field out of range, or one that must not differ), MEMORY. The world then stays as it was.
BOLAN_API bolan_result bolan_world_set_scene(bolan_world *world, const bolan_scene *scene);

// ---- reading --------------------------------------------------------------------------------------------------------

/// The scene at the present time.
BOLAN_API const bolan_scene *bolan_world_scene(const bolan_world *world);

/// The water at the present time, for queries and for drawing.
BOLAN_API const bolan_water *bolan_world_water(const bolan_world *world);

/// The desc of the scene's sea with its measured spectrum put in.
/// bolan_sea_create() makes the world's sea of it.
/// The spectrum belongs to the world.
BOLAN_API bolan_sea_desc bolan_world_sea_desc(const bolan_world *world);

/// The tiles of the mirror optics; NULL where the scene names none.
BOLAN_API const bolan_tiles *bolan_world_tiles(const bolan_world *world);

/// The model of each object of the scene, scene->object_count pointers.
BOLAN_API const bolan_model *const *bolan_world_object_models(const bolan_world *world);

/// The scene's camera at @p time [s]: see bolan_scene_camera_at().
/// A camera inside the ground is lifted: to 1.8 m above land, to 0.3 m above the sea bed.
BOLAN_API bolan_camera bolan_world_camera_at(const bolan_world *world, double time);

/// Returns @p eye, raised to 0.3 m above the surface where @p eye is lower, so that no wave covers the eye.
/// The physical optics draws views from everywhere, the waterline among them: no eye is raised there.
/// An eye below the level stays where the scene's optics draws such views: bolan_optics_seen_from_below().
/// Thread-safe between steps.
BOLAN_API bolan_dvec3 bolan_world_clear_eye(const bolan_world *world, bolan_dvec3 eye);

/// Place and axes of a model in the world.
typedef struct bolan_pose {
    /// Position of the model's origin [m].
    bolan_dvec3 origin;
    /// Unit axes of the model (right, ahead, up) in world axes.
    bolan_dvec3 x, y, z;
} bolan_pose;

/// The pose of an object on @p water at the present time of its sea.
/// A floating object rests on the water under five points of its model: bow and stern give its pitch, the sides its
/// roll, and the mean its height.
/// Thread-safe between steps.
BOLAN_API bolan_pose bolan_object_pose(const bolan_object *object, const bolan_model *model, const bolan_water *water);

/// The pose of object @p index of the scene at the present time.
/// An index beyond the last object is misuse and gives a pose of zeros.
BOLAN_API bolan_pose bolan_world_object_pose(const bolan_world *world, uint32_t index);

#ifdef __cplusplus
}
#endif
#endif

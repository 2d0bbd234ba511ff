// SPDX-License-Identifier: MIT
/// @file content.h
/// Tier 3, library bolan_content. Generated grounds and models of the built-in scenes.
///
/// All content is computed, without data files, and has the same bits on every machine.
/// The core library does not need this library; bolan_io links it, because scene files name its grounds and models.
#ifndef BOLAN_CONTENT_H
#define BOLAN_CONTENT_H

#include "bolan/ground.h"
#include "bolan/model.h"

#ifdef __cplusplus
extern "C" {
#endif

// ---- grounds --------------------------------------------------------------------------------------------------------

/// Returns the name of a generator of ground: "island", "pond".
/// Returns NULL past the last.
/// Static storage.
/// Thread-safe.
BOLAN_API const char *bolan_content_ground_name(uint32_t index);

/// Generates a ground.
/// The bits of the ground are a function of @p generator alone.
///
/// "island" is a volcanic island: eroded peaks in a horseshoe, cliffs and stacks to windward, sandy bays to leeward.
/// Shallows 1 m to 6 m deep lie behind a barrier reef on the side generator->lagoon_from_deg.
/// The land is centred on the origin of the scene.
/// The generation takes about a second and uses the task hook.
///
/// "pond" is a basin 90 m across in a meadow, 0.4 m to 4 m deep, with a sandy shelf in the south.
/// The pond has no parameters.
///
/// @param out receives the ground, which the caller destroys; NULL on failure.
/// Errors: ARGUMENT (an unknown name, a parameter out of its range), MEMORY.
/// Thread-safe.
BOLAN_API bolan_result bolan_content_create_ground(const bolan_ground_generator *generator, bolan_ground **out);

/// Returns the elevation of the pond's ground [m] at world (x, y) [m], before it is sampled on a grid.
/// Thread-safe.
BOLAN_API float bolan_pond_elevation(double x, double y);

// ---- models ---------------------------------------------------------------------------------------------------------

/// Returns the name of a model: "boat", "house", "pond-ground" and so on.
/// Returns NULL past the last.
/// Static storage.
/// Thread-safe.
BOLAN_API const char *bolan_content_model_name(uint32_t index);

/// Builds the model of that name.
/// @param name one of bolan_content_model_name(), without "builtin:".
/// @param out receives the model, which the caller destroys; NULL on failure.
/// Errors: ARGUMENT (an unknown name), MEMORY.
/// Thread-safe.
BOLAN_API bolan_result bolan_content_create_model(const char *name, bolan_model **out);

#ifdef __cplusplus
}
#endif
#endif

// SPDX-License-Identifier: MIT
/// @file model.h
/// What the modules beside this one need of a model besides its view. Private to the library.
#ifndef BOLAN_SCENE_MODEL_H
#define BOLAN_SCENE_MODEL_H

#include "bolan/model.h"

/// A number made of all its arrays: equal for equal models, different for others (64-bit hash). A cache keyed by the
/// pointer alone would show an old model where a new one took its address.
uint64_t bolan_model_id(const bolan_model *model);
/// Its corners: the least and the greatest coordinates [m].
void bolan_model_bounds(const bolan_model *model, bolan_vec3 *low, bolan_vec3 *high);

#endif

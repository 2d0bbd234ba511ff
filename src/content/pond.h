// SPDX-License-Identifier: MIT
/// @file pond.h
/// The pond: its ground, and its outline for the mesh that follows it. Private to src/content.
#ifndef BOLAN_CONTENT_POND_H
#define BOLAN_CONTENT_POND_H

#include "bolan/ground.h"

/// Distance [m] of the shore from the middle of the pond towards the unit direction (c, s), but for small bays.
float bolan_pond_outline(float c, float s);
/// The ground "pond" of content.h.
bolan_result bolan_pond_create(const bolan_ground_generator *generator, bolan_ground **out);

#endif

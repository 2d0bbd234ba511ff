// SPDX-License-Identifier: MIT
/// @file pond.h
/// The pond's outline, for the mesh that follows it. Private to the library.
#ifndef BOLAN_SHORE_POND_H
#define BOLAN_SHORE_POND_H

/// Distance [m] of the shore from the middle of the pond towards the unit direction (c, s), but for small bays.
float bolan_pond_outline(float c, float s);

#endif

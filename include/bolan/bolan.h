// SPDX-License-Identifier: MIT
/// @file bolan.h
/// Includes all headers of tiers 0 to 3; the OpenGL renderer is in bolan/render.h.
#ifndef BOLAN_BOLAN_H
#define BOLAN_BOLAN_H

#include "bolan/base.h"
#include "bolan/earth.h"
#include "bolan/math.h"

#include "bolan/optics.h"
#include "bolan/params.h"
#include "bolan/spectrum.h"
#include "bolan/formats.h"

#include "bolan/waves.h"

#include "bolan/coast.h"
#include "bolan/flow.h"
#include "bolan/ground.h"
#include "bolan/query.h"
#include "bolan/record.h"
#include "bolan/surface.h"
#include "bolan/tiles.h"
#include "bolan/water.h"

#include "bolan/content.h"
#include "bolan/model.h"
#include "bolan/scene.h"
#include "bolan/technique.h"
#include "bolan/world.h"

#include "bolan/io.h"
#include "bolan/export.h"

#endif

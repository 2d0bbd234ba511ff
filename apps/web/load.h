// SPDX-License-Identifier: MIT
#ifndef WEB_LOAD_H
#define WEB_LOAD_H

#include "bolan/world.h"

// Makes the world of a scene that refers to generated grounds and built-in models alone.
bolan_result load_world(const bolan_scene *scene, bolan_world **out);

#endif

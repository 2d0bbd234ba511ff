// SPDX-License-Identifier: MIT
// The built-in scenes of the page, as print_scenes.c writes them.
#ifndef WEB_SCENES_H
#define WEB_SCENES_H

#include "bolan/scene.h"

typedef struct web_scene {
    const char *name;
    // Turns bolan_scene_default() into the scene.
    void (*fill)(bolan_scene *scene);
} web_scene;

extern const web_scene web_scenes[]; // a NULL name ends the list

#endif

// SPDX-License-Identifier: MIT
// A scene with everything it needs, in memory.
#ifndef BOLAN_CLI_SESSION_H
#define BOLAN_CLI_SESSION_H

#include "options.h"

typedef struct session {
    bolan_scene scene;
    bolan_scene_assets assets;
    bolan_sea *sea; // at time 0
} session;

// Returns an exit code; failures were reported, and then nothing needs closing.
int session_open(const options *o, session *s);
// The same without the terrain, for what looks at the open sea only.
int session_open_sea(const options *o, session *s);
// A camera inside the ground shows nothing: it is lifted to the height of somebody standing there.
void session_lift_camera(session *s);
void session_close(session *s);

#endif

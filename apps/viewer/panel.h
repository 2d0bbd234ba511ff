// SPDX-License-Identifier: MIT
// The panel shows the figures of the frame, edits the scene in place, and returns requests. C interface of the only C++
// file.
#ifndef VIEWER_PANEL_H
#define VIEWER_PANEL_H

#include "bolan/render.h"
#include "sea_knobs.h"
#include "window.h"

#ifdef __cplusplus
extern "C" {
#endif

// The values that the panel edits in place.
typedef struct panel_edits {
    bolan_scene *scene;
    sea_knobs *knobs;
    bolan_quality *quality;
    double *time_scale;
    bool *paused;
    double *render_scale; // 0: automatic
    double *speed;        // the camera's factor
    bool *visible;
} panel_edits;

// The values that the panel shows.
typedef struct panel_facts {
    uint32_t window_width, window_height, picture_width, picture_height; // [px]
    double frame_ms, synthesis_ms;
    bolan_frame_statistics statistics;
    bolan_sea_statistics sea;                 // when it was made
    double time, camera_height, camera_speed; // [s], [m] above the surface, [m/s]
    bool over_land, gamepad;
    const char *device, *shader_directory;
    char refined[32];   // one line under the figures of the frame, or empty
    const char *notice; // one line over the picture, or NULL
} panel_facts;

// The requests of the user in this frame.
typedef struct panel_wishes {
    unsigned sea;      // sea_knob_group bits: write the knobs to the scene and make the sea again
    const char *scene; // load this one; NULL: stay
    bool quality, screenshot, reload, home;
    bool measuring; // the times of the passes are on view
} panel_wishes;

// Needs the context of the window. False: the panel could not be set up (a sentence is on stderr).
bool panel_open(const window *w);
void panel_close(void);
// Offers an event first to the panel; afterwards panel_taken tells whether pointer or keyboard belong to it.
void panel_event(const SDL_Event *event);
void panel_taken(bool *mouse, bool *keyboard);
// Lays the panel out and draws it into the window's framebuffer.
panel_wishes panel_draw(const panel_edits *edits, const panel_facts *facts);

#ifdef __cplusplus
}
#endif
#endif

// SPDX-License-Identifier: MIT
// Keyboard, mouse and gamepad, turned into commands and a movement.
#ifndef VIEWER_INPUT_H
#define VIEWER_INPUT_H

#include "fly.h"
#include "window.h"

typedef enum command {
    COMMAND_QUIT = 1 << 0,
    COMMAND_PAUSE = 1 << 1,
    COMMAND_SLOWER = 1 << 2, // time
    COMMAND_FASTER = 1 << 3,
    COMMAND_PANEL = 1 << 4,
    COMMAND_RELOAD = 1 << 5,
    COMMAND_FULLSCREEN = 1 << 6,
    COMMAND_SCREENSHOT = 1 << 7,
    COMMAND_HOME = 1 << 8,      // back to the scene's camera
    COMMAND_TECHNIQUE = 1 << 9, // the next technique
    COMMAND_TEMPORAL = 1 << 10, // temporal antialiasing on or off
} command;

typedef struct input {
    SDL_GameController *gamepad;
    double speed;      // factor of the mouse wheel
    double turn, tilt; // by the mouse since the last frame [deg]
    bool captured;     // the mouse looks without a button held
    bool dragging;
} input;

// Input that the panel takes: the pointer is over it, or a field is being typed in.
typedef struct input_taken {
    bool mouse, keyboard;
} input_taken;

void input_open(input *in);
void input_close(input *in);
// Takes one event; returns the commands (bits) it gives. @p degrees_per_unit is how far the view turns for a unit of
// mouse movement.
unsigned input_event(input *in, window *w, const SDL_Event *event, input_taken taken, double degrees_per_unit);
// The movement of this frame; resets what the mouse has gathered.
fly_input input_movement(input *in, input_taken taken, double seconds);

#endif

// SPDX-License-Identifier: MIT
// Keyboard, mouse and gamepad.
#include "input.h"

#include <math.h>

#define PAD_TURN 90.0 // [deg/s] with the stick at its end

static const struct {
    SDL_Keycode key;
    command command;
} key_table[] = {
    {SDLK_ESCAPE, COMMAND_QUIT},     {SDLK_SPACE, COMMAND_PAUSE},    {SDLK_MINUS, COMMAND_SLOWER},
    {SDLK_KP_MINUS, COMMAND_SLOWER}, {SDLK_PLUS, COMMAND_FASTER},    {SDLK_EQUALS, COMMAND_FASTER},
    {SDLK_KP_PLUS, COMMAND_FASTER},  {SDLK_F1, COMMAND_PANEL},       {SDLK_F5, COMMAND_RELOAD},
    {SDLK_F11, COMMAND_FULLSCREEN},  {SDLK_F12, COMMAND_SCREENSHOT}, {SDLK_HOME, COMMAND_HOME},
    {SDLK_t, COMMAND_TECHNIQUE},     {SDLK_F6, COMMAND_TEMPORAL},
};

static void open_gamepad(input *in, int device) {
    if (in->gamepad == NULL && SDL_IsGameController(device)) in->gamepad = SDL_GameControllerOpen(device);
}

void input_open(input *in) {
    *in = (input){.speed = 1.0};
    // A machine without game controllers is no reason to refuse the window.
    if (SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER) != 0) return;
    for (int i = 0; i < SDL_NumJoysticks(); ++i) open_gamepad(in, i);
}

void input_close(input *in) {
    if (in->gamepad != NULL) SDL_GameControllerClose(in->gamepad);
    *in = (input){0};
}

static void capture(input *in, bool on) {
    in->captured = on;
    SDL_SetRelativeMouseMode(on || in->dragging ? SDL_TRUE : SDL_FALSE);
}

static void drag(input *in, bool on) {
    in->dragging = on;
    SDL_SetRelativeMouseMode(on || in->captured ? SDL_TRUE : SDL_FALSE);
}

static unsigned key_pressed(input *in, const SDL_KeyboardEvent *key, input_taken taken) {
    if (key->repeat != 0 || taken.keyboard) return 0;
    SDL_Keycode code = key->keysym.sym;
    if (code == SDLK_TAB) capture(in, !in->captured);
    if (code == SDLK_ESCAPE && in->captured) { // first give the mouse back
        capture(in, false);
        return 0;
    }
    for (size_t i = 0; i < sizeof key_table / sizeof key_table[0]; ++i)
        if (key_table[i].key == code) return key_table[i].command;
    return 0;
}

static unsigned button_pressed(const SDL_ControllerButtonEvent *button) {
    switch (button->button) {
    case SDL_CONTROLLER_BUTTON_A: return COMMAND_PAUSE;
    case SDL_CONTROLLER_BUTTON_X: return COMMAND_TECHNIQUE;
    case SDL_CONTROLLER_BUTTON_Y: return COMMAND_SCREENSHOT;
    case SDL_CONTROLLER_BUTTON_START: return COMMAND_PANEL;
    case SDL_CONTROLLER_BUTTON_BACK: return COMMAND_HOME;
    case SDL_CONTROLLER_BUTTON_DPAD_LEFT: return COMMAND_SLOWER;
    case SDL_CONTROLLER_BUTTON_DPAD_RIGHT: return COMMAND_FASTER;
    default: return 0;
    }
}

static void gamepad_removed(input *in, SDL_JoystickID id) {
    if (in->gamepad == NULL || SDL_JoystickInstanceID(SDL_GameControllerGetJoystick(in->gamepad)) != id) return;
    SDL_GameControllerClose(in->gamepad);
    in->gamepad = NULL;
}

unsigned input_event(input *in, window *w, const SDL_Event *event, input_taken taken, double degrees_per_unit) {
    switch (event->type) {
    case SDL_QUIT: return COMMAND_QUIT;
    case SDL_WINDOWEVENT:
        if (event->window.event == SDL_WINDOWEVENT_CLOSE && event->window.windowID == SDL_GetWindowID(w->handle))
            return COMMAND_QUIT;
        if (event->window.event == SDL_WINDOWEVENT_FOCUS_LOST) drag(in, false);
        return 0;
    case SDL_KEYDOWN: return key_pressed(in, &event->key, taken);
    case SDL_MOUSEBUTTONDOWN:
        if (!taken.mouse) drag(in, true);
        return 0;
    case SDL_MOUSEBUTTONUP:
        if (in->dragging) drag(in, false);
        return 0;
    case SDL_MOUSEMOTION:
        if (in->dragging || in->captured) {
            in->turn += event->motion.xrel * degrees_per_unit;
            in->tilt -= event->motion.yrel * degrees_per_unit;
        }
        return 0;
    case SDL_MOUSEWHEEL:
        if (!taken.mouse) in->speed = fmin(fmax(in->speed * pow(1.25, event->wheel.y), 0.02), 50.0);
        return 0;
    case SDL_CONTROLLERBUTTONDOWN: return button_pressed(&event->cbutton);
    case SDL_CONTROLLERDEVICEADDED: open_gamepad(in, event->cdevice.which); return 0;
    case SDL_CONTROLLERDEVICEREMOVED: gamepad_removed(in, event->cdevice.which); return 0;
    default: return 0;
    }
}

static double held(const Uint8 *keys, SDL_Scancode a, SDL_Scancode b) { return keys[a] || keys[b] ? 1.0 : 0.0; }

static void add_keyboard(fly_input *m) {
    const Uint8 *keys = SDL_GetKeyboardState(NULL); // by place on the board, whatever letter is printed there
    m->forward += held(keys, SDL_SCANCODE_W, SDL_SCANCODE_UP) - held(keys, SDL_SCANCODE_S, SDL_SCANCODE_DOWN);
    m->right += held(keys, SDL_SCANCODE_D, SDL_SCANCODE_RIGHT) - held(keys, SDL_SCANCODE_A, SDL_SCANCODE_LEFT);
    m->up += held(keys, SDL_SCANCODE_E, SDL_SCANCODE_PAGEUP) - held(keys, SDL_SCANCODE_Q, SDL_SCANCODE_PAGEDOWN);
    if (keys[SDL_SCANCODE_LSHIFT] || keys[SDL_SCANCODE_RSHIFT]) m->faster *= 5.0;
    if (keys[SDL_SCANCODE_LCTRL] || keys[SDL_SCANCODE_RCTRL]) m->faster *= 0.2;
}

// A stick at rest is not at zero; beyond the dead zone the square gives fine control.
static double axis(SDL_GameController *pad, SDL_GameControllerAxis which) {
    double x = SDL_GameControllerGetAxis(pad, which) / 32767.0, dead = 0.15;
    double live = (fabs(x) - dead) / (1.0 - dead);
    return live > 0.0 ? copysign(fmin(live * live, 1.0), x) : 0.0;
}

static void add_gamepad(fly_input *m, SDL_GameController *pad, double seconds) {
    m->forward -= axis(pad, SDL_CONTROLLER_AXIS_LEFTY);
    m->right += axis(pad, SDL_CONTROLLER_AXIS_LEFTX);
    m->up += axis(pad, SDL_CONTROLLER_AXIS_TRIGGERRIGHT) - axis(pad, SDL_CONTROLLER_AXIS_TRIGGERLEFT);
    m->turn += axis(pad, SDL_CONTROLLER_AXIS_RIGHTX) * PAD_TURN * seconds;
    m->tilt -= axis(pad, SDL_CONTROLLER_AXIS_RIGHTY) * PAD_TURN * seconds;
    if (SDL_GameControllerGetButton(pad, SDL_CONTROLLER_BUTTON_RIGHTSHOULDER)) m->faster *= 5.0;
    if (SDL_GameControllerGetButton(pad, SDL_CONTROLLER_BUTTON_LEFTSHOULDER)) m->faster *= 0.2;
}

fly_input input_movement(input *in, input_taken taken, double seconds) {
    fly_input m = {.turn = in->turn, .tilt = in->tilt, .faster = in->speed};
    in->turn = in->tilt = 0.0;
    if (!taken.keyboard) add_keyboard(&m);
    if (in->gamepad != NULL) add_gamepad(&m, in->gamepad, seconds);
    m.forward = fmin(fmax(m.forward, -1.0), 1.0);
    m.right = fmin(fmax(m.right, -1.0), 1.0);
    m.up = fmin(fmax(m.up, -1.0), 1.0);
    return m;
}

// SPDX-License-Identifier: MIT
// An SDL window with an OpenGL context.
#ifndef VIEWER_WINDOW_H
#define VIEWER_WINDOW_H

#include <SDL.h>
#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct window {
    SDL_Window *handle;
    SDL_GLContext context;
    bool es; // OpenGL ES 3.0, where there is no 3.3 core
} window;

// On failure one sentence is on stderr and nothing stays open.
bool window_open(window *w, const char *title, uint32_t width, uint32_t height);
void window_close(window *w);
void window_present(window *w);
// Pixels to draw, which on a dense screen are more than the window's own units. 0 while it is minimised.
void window_pixels(const window *w, uint32_t *width, uint32_t *height);
void window_toggle_fullscreen(window *w);
// Pixels per window unit: above 1 where the desktop scales windows itself.
float window_density(const window *w);
// How much larger than at 96 dots an inch letters must be, in window units: above 1 where the desktop leaves that to
// programs.
float window_text_scale(const window *w);

#ifdef __cplusplus
}
#endif
#endif

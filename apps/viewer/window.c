// SPDX-License-Identifier: MIT
// Window and context: OpenGL 3.3 core, or ES 3.0 where 3.3 is missing.
#include "window.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool complain(const char *what) {
    fprintf(stderr, "bolan: %s: %s\n", what, SDL_GetError());
    return false;
}

// Without a display SDL falls back to drivers that show nothing, which is an error here.
static bool start_video(void) {
#if defined(__linux__)
    // Without this folder the library of Wayland prints an error; so Wayland is not tried.
    if (getenv("XDG_RUNTIME_DIR") == NULL) SDL_SetHint(SDL_HINT_VIDEODRIVER, "x11,KMSDRM");
#endif
    bool started = SDL_Init(SDL_INIT_VIDEO) == 0;
    const char *driver = started ? SDL_GetCurrentVideoDriver() : NULL;
    if (driver != NULL && strcmp(driver, "offscreen") != 0 && strcmp(driver, "dummy") != 0) return true;
    fprintf(stderr, "bolan: no display to open a window on (neither DISPLAY nor WAYLAND_DISPLAY leads to one); "
                    "`bolan render` draws to a file\n");
    SDL_Quit();
    return false;
}

static bool create_context(window *w, bool es, int version) {
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, es ? SDL_GL_CONTEXT_PROFILE_ES : SDL_GL_CONTEXT_PROFILE_CORE);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, version / 10);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, version % 10);
    w->context = SDL_GL_CreateContext(w->handle);
    w->es = es;
    return w->context != NULL;
}

bool window_open(window *w, const char *title, uint32_t width, uint32_t height) {
    *w = (window){0};
    if (!start_video()) return false;
    SDL_GL_SetAttribute(SDL_GL_DOUBLEBUFFER, 1);
    SDL_GL_SetAttribute(SDL_GL_DEPTH_SIZE, 0); // the renderer has its own depth
    SDL_GL_SetAttribute(SDL_GL_RED_SIZE, 8);
    SDL_GL_SetAttribute(SDL_GL_GREEN_SIZE, 8);
    SDL_GL_SetAttribute(SDL_GL_BLUE_SIZE, 8);
    Uint32 flags = SDL_WINDOW_OPENGL | SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI;
    w->handle = SDL_CreateWindow(title, SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, (int)width, (int)height, flags);
    bool ok = w->handle != NULL || complain("the window cannot be opened");
    // The versions with compute shaders first: some drivers make what they are asked for and no more.
    ok = ok && (create_context(w, false, 43) || create_context(w, false, 33) || create_context(w, true, 31) ||
                create_context(w, true, 30) || complain("this display has neither OpenGL 3.3 core nor OpenGL ES 3.0"));
    if (!ok) {
        window_close(w);
        return false;
    }
    SDL_SetWindowMinimumSize(w->handle, 320, 240);
    if (SDL_GL_SetSwapInterval(-1) != 0)
        SDL_GL_SetSwapInterval(1); // adaptive: a late frame does not wait for the next refresh
    return true;
}

void window_close(window *w) {
    if (w->context != NULL) SDL_GL_DeleteContext(w->context);
    if (w->handle != NULL) SDL_DestroyWindow(w->handle);
    *w = (window){0};
    SDL_Quit();
}

void window_present(window *w) { SDL_GL_SwapWindow(w->handle); }

void window_pixels(const window *w, uint32_t *width, uint32_t *height) {
    int x = 0, y = 0;
    if ((SDL_GetWindowFlags(w->handle) & SDL_WINDOW_MINIMIZED) == 0) SDL_GL_GetDrawableSize(w->handle, &x, &y);
    *width = x > 0 ? (uint32_t)x : 0;
    *height = y > 0 ? (uint32_t)y : 0;
}

void window_toggle_fullscreen(window *w) {
    bool full = (SDL_GetWindowFlags(w->handle) & SDL_WINDOW_FULLSCREEN) != 0;
    if (SDL_SetWindowFullscreen(w->handle, full ? 0 : SDL_WINDOW_FULLSCREEN_DESKTOP) != 0)
        fprintf(stderr, "bolan: the window cannot fill the screen: %s\n", SDL_GetError());
}

float window_density(const window *w) {
    int units = 0, pixels = 0;
    SDL_GetWindowSize(w->handle, &units, NULL);
    SDL_GL_GetDrawableSize(w->handle, &pixels, NULL);
    return units > 0 && pixels > units ? (float)pixels / (float)units : 1.0f;
}

float window_text_scale(const window *w) {
    float dpi = 96.0f;
    int display = SDL_GetWindowDisplayIndex(w->handle);
    if (window_density(w) > 1.0f) return 1.0f;
    if (display < 0 || SDL_GetDisplayDPI(display, NULL, &dpi, NULL) != 0) dpi = 96.0f;
    float scale = dpi / 96.0f;
    return scale < 1.25f ? 1.0f : scale > 4.0f ? 4.0f : scale; // reported screen sizes are off by some per cent
}

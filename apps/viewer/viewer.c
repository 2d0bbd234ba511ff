// SPDX-License-Identifier: MIT
// The loop of the viewer: events, movement, sea, image, panel, requests.
#include "viewer.h"

#include "bolan/io.h"
#include "canvas.h"
#include "input.h"
#include "messages.h"
#include "pace.h"
#include "panel.h"
#include "refine.h"
#include "reload.h"
#include "world.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#define TEST_TICK (1.0 / 30.0) // [s] time of a frame when their number is given
#define LONGEST_TICK 0.1       // [s] longest advance of the sea in a frame, so that a stall does not jump
#define NOTICE_TIME 4.0        // [s]
#define IDLE_TIME 50           // [ms] between frames that change nothing: the notices end by them

typedef struct viewer {
    const viewer_options *options;
    window window;
    input input;
    bolan_world *world;
    bolan_scene scene;               // edited by panel, keys and mouse; copied to the world before each frame
    bolan_camera home;               // the camera that the scene came with
    bolan_sea_statistics statistics; // of the sea when it was made
    double synthesis_ms;             // of the last step
    sea_knobs knobs;
    canvas canvas;
    pace pace;
    refine refine;
    refine_step drawn; // of the last frame
    reload_watch watch;
    bolan_quality quality;
    double time, time_scale, render_scale;
    bool paused, panel_visible, running;
    uint32_t width, height, frame;
    double first_frame, last_frame, notice_until;
    char notice[128], device[192];
    const char *pending_scene; // loaded after the notice has been on screen
    int status;
} viewer;

viewer_options viewer_options_default(void) {
    return (viewer_options){.width = 1280, .height = 720, .quality = BOLAN_QUALITY_MEDIUM};
}

// ---- doing what was asked for ---------------------------------------------------------------------------------------

#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
static void
notice(viewer *v, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(v->notice, sizeof v->notice, format, arguments);
    va_end(arguments);
    v->notice_until = seconds_now() + NOTICE_TIME;
}

static void take_screenshot(viewer *v) {
    char name[32];
    canvas_free_name(name, sizeof name);
    if (canvas_save_picture(&v->canvas, v->world, v->width, v->height, name) != BOLAN_OK) {
        notice(v, "the screenshot failed");
        return;
    }
    printf("%s\n", name);
    fflush(stdout);
    notice(v, "saved %s", name);
}

static void reload_shaders(viewer *v) {
    if (v->options->shader_directory == NULL) {
        notice(v, "shaders are built in: a debug build reads them from disk");
        return;
    }
    messages_clear();
    refine_restart(&v->refine);
    bool ok = bolan_renderer_reload(v->canvas.renderer) == BOLAN_OK;
    notice(v, ok ? "shaders reloaded" : "shaders not reloaded: see the messages");
}

static void read_knobs(viewer *v) { v->knobs = sea_knobs_read(&v->scene.sea, v->scene.spectrum_path[0] != '\0'); }

// Copies the edited scene to the world. On failure the edited scene becomes that of the world again.
static bool update_world(viewer *v) {
    const uint64_t old = bolan_sea_id(bolan_world_water(v->world)->sea);
    const bool ok = bolan_world_set_scene(v->world, &v->scene) == BOLAN_OK;
    if (!ok) v->scene = *bolan_world_scene(v->world);
    const bolan_sea *sea = bolan_world_water(v->world)->sea;
    if (bolan_sea_id(sea) != old) v->statistics = bolan_sea_measure(sea);
    return ok;
}

static void rebuild_sea(viewer *v, unsigned changed) {
    sea_knobs_write(&v->knobs, changed, &v->scene.sea);
    if (!update_world(v)) read_knobs(v);
}

// The same scene and camera by the next technique of the list.
static void next_technique(viewer *v) {
    uint32_t count = 0, now = 0;
    const bolan_technique *all = bolan_techniques(&count);
    while (now < count && strcmp(all[now].name, v->scene.technique.name) != 0) now++;
    const bolan_technique *next = &all[(now + 1) % count];
    bolan_scene_set_technique(&v->scene, next);
    if (!update_world(v)) {
        notice(v, "%s cannot be shown here: see the messages", next->name);
        return;
    }
    read_knobs(v);
    notice(v, "%s: %s waves on a %s surface, %s optics", next->name, bolan_wave_model_names[next->waves],
           bolan_surface_kind_names[next->surface], bolan_optics_kind_names[next->optics]);
}

static void set_title(viewer *v) {
    char said[32], title[BOLAN_NAME_MAX + 48];
    refine_say(&v->refine, said, sizeof said);
    snprintf(title, sizeof title, "%s%s%s - Bolan", v->scene.name, said[0] != '\0' ? " - " : "", said);
    SDL_SetWindowTitle(v->window.handle, title);
}

static bool open_world(viewer *v, const bolan_scene *scene) {
    bolan_world *fresh = NULL;
    if (bolan_world_load_scene(scene, &fresh) != BOLAN_OK) return false;
    bolan_world_destroy(&v->world);
    v->world = fresh;
    bolan_world_settle(fresh, scene->time);
    v->scene = *scene;
    v->home = scene->camera;
    v->time = scene->time;
    refine_restart(&v->refine); // the same values may name other files
    v->statistics = bolan_sea_measure(bolan_world_water(fresh)->sea);
    read_knobs(v);
    set_title(v);
    return true;
}

static void load_scene(viewer *v, const char *name) {
    bolan_scene scene;
    if (bolan_scene_load(name, &scene) != BOLAN_OK || !open_world(v, &scene)) {
        notice(v, "%s was not loaded: see the messages", name);
        return;
    }
    notice(v, "%s", scene.description);
}

static void set_quality(viewer *v) {
    if (canvas_set_quality(&v->canvas, v->quality) != BOLAN_OK) v->quality = v->canvas.desc.quality;
}

static void obey_panel(viewer *v, const panel_wishes *wishes) {
    bolan_renderer_measure_passes(v->canvas.renderer, wishes->measuring);
    if (wishes->sea != 0) rebuild_sea(v, wishes->sea);
    if (wishes->quality) set_quality(v);
    if (wishes->screenshot) take_screenshot(v);
    if (wishes->reload) reload_shaders(v);
    if (wishes->home) v->scene.camera = v->home;
    if (wishes->scene != NULL) {
        v->pending_scene = wishes->scene;
        notice(v, "loading %s ...", wishes->scene);
    }
}

static void obey_commands(viewer *v, unsigned commands) {
    if (commands & COMMAND_QUIT) v->running = false;
    if (commands & COMMAND_PAUSE) v->paused = !v->paused;
    if (commands & COMMAND_SLOWER) v->time_scale = fmax(v->time_scale * 0.5, 0.0625);
    if (commands & COMMAND_FASTER) v->time_scale = fmin(v->time_scale * 2.0, 16.0);
    if (commands & (COMMAND_SLOWER | COMMAND_FASTER)) notice(v, "time x %g", v->time_scale);
    if (commands & COMMAND_PANEL) v->panel_visible = !v->panel_visible;
    if (commands & COMMAND_FULLSCREEN) window_toggle_fullscreen(&v->window);
    if (commands & COMMAND_SCREENSHOT) take_screenshot(v);
    if (commands & COMMAND_RELOAD) reload_shaders(v);
    if (commands & COMMAND_HOME) v->scene.camera = v->home;
    if (commands & COMMAND_TECHNIQUE) next_technique(v);
    if (commands & COMMAND_TEMPORAL) {
        v->canvas.temporal = !v->canvas.temporal;
        notice(v, "temporal antialiasing %s", v->canvas.temporal ? "on" : "off");
    }
}

// ---- one frame ------------------------------------------------------------------------------------------------------

static void take_events(viewer *v, double seconds, panel_facts *facts) {
    SDL_Event event;
    int units = 0;
    input_taken taken;
    bolan_camera *camera = &v->scene.camera;
    SDL_GetWindowSize(v->window.handle, NULL, &units);
    panel_taken(&taken.mouse, &taken.keyboard);
    while (SDL_PollEvent(&event)) {
        panel_event(&event);
        obey_commands(v, input_event(&v->input, &v->window, &event, taken, camera->fov_deg / fmax(units, 1.0)));
    }
    double surface = world_surface(v->world, camera->position.x, camera->position.y, &facts->over_land);
    double speed = fly_speed(camera->position.z - surface);
    fly_input movement = input_movement(&v->input, taken, seconds);
    fly_step(camera, &movement, speed, -INFINITY, seconds);
    fly_keep_above(camera, world_floor(v->world, camera->position.x, camera->position.y));
    facts->camera_height = camera->position.z - surface;
    facts->camera_speed = speed * movement.faster;
    facts->gamepad = v->input.gamepad != NULL;
}

static void advance(viewer *v, double seconds) {
    if (v->paused) {
        v->synthesis_ms = 0.0;
        return;
    }
    v->time += seconds * v->time_scale;
    const double start = seconds_now();
    bolan_world_step(v->world, v->time);
    v->synthesis_ms = (seconds_now() - start) * 1e3;
}

static void draw_panel(viewer *v, panel_facts *facts) {
    panel_edits edits = {.scene = &v->scene,
                         .knobs = &v->knobs,
                         .quality = &v->quality,
                         .time_scale = &v->time_scale,
                         .paused = &v->paused,
                         .render_scale = &v->render_scale,
                         .speed = &v->input.speed,
                         .visible = &v->panel_visible};
    facts->window_width = v->width;
    facts->window_height = v->height;
    facts->picture_width = v->canvas.width;
    facts->picture_height = v->canvas.height;
    facts->frame_ms = v->pace.frame_ms;
    facts->synthesis_ms = v->synthesis_ms;
    facts->statistics = bolan_renderer_statistics(v->canvas.renderer);
    facts->sea = v->statistics;
    facts->time = v->time;
    facts->device = v->device;
    facts->shader_directory = v->options->shader_directory;
    refine_say(&v->refine, facts->refined, sizeof facts->refined);
    facts->notice = seconds_now() < v->notice_until ? v->notice : NULL;
    panel_wishes wishes = panel_draw(&edits, facts);
    obey_panel(v, &wishes);
}

static void load_pending(viewer *v, const char *loading) {
    if (loading == NULL) return;
    SDL_PumpEvents(); // brings the notice to the screen before the wait
    v->pending_scene = NULL;
    load_scene(v, loading);
}

static void finish_test(viewer *v) {
    if (v->options->frames == 0 || v->frame < v->options->frames) return;
    v->running = false;
    const char *path = v->options->screenshot;
    if (path != NULL && canvas_save_window(&v->canvas, v->width, v->height, path) != BOLAN_OK) v->status = 1;
}

static void draw_world(viewer *v, double seconds) {
    static refine_view view; // static: its padding is 0
    view.scene = v->scene;
    view.time = v->time;
    view.scale = v->render_scale;
    view.width = v->width;
    view.height = v->height;
    view.quality = v->quality;
    const uint32_t before = v->refine.samples;
    v->drawn = refine_next(&v->refine, &view, seconds);
    const bool refined = v->drawn != REFINE_MOVING;
    const double scale = v->render_scale > 0.0 ? v->render_scale : refined ? 1.0 : v->pace.scale;
    canvas_draw(&v->canvas, v->world, v->width, v->height, scale, v->drawn);
    const bolan_frame_statistics statistics = bolan_renderer_statistics(v->canvas.renderer);
    refine_drawn(&v->refine, &statistics);
    // A window manager need not write each number.
    const uint32_t now = v->refine.samples;
    if (now != before && (now & (now - 1)) == 0) set_title(v);
}

static void one_frame(viewer *v) {
    double now = seconds_now(), elapsed = now - v->last_frame;
    v->last_frame = now;
    double seconds = v->options->frames > 0 ? TEST_TICK : fmin(elapsed, LONGEST_TICK);
    const char *loading = v->pending_scene;
    panel_facts facts = {0};
    take_events(v, seconds, &facts);
    if (reload_due(&v->watch, now)) reload_shaders(v);
    window_pixels(&v->window, &v->width, &v->height);
    if (v->width == 0 || v->height == 0) { // minimised: time goes on, nothing is drawn
        SDL_Delay(50);
        return;
    }
    bool automatic = v->render_scale == 0.0 && v->options->frames == 0;
    if (v->frame > 0 && v->drawn == REFINE_MOVING) pace_frame(&v->pace, elapsed * 1e3, automatic);
    advance(v, seconds);
    update_world(v);
    draw_world(v, seconds);
    draw_panel(v, &facts);
    if (v->frame++ == 0) v->first_frame = seconds_now();
    finish_test(v);
    window_present(&v->window);
    if (v->drawn == REFINE_DONE && v->options->frames == 0) SDL_WaitEventTimeout(NULL, IDLE_TIME);
    load_pending(v, loading);
}

// ---- from start to end ----------------------------------------------------------------------------------------------

static bool start(viewer *v, const bolan_scene *scene) {
    const viewer_options *o = v->options;
    if (!window_open(&v->window, "Bolan", o->width, o->height)) return false;
    if (canvas_open(&v->canvas, o->quality, o->backend, o->pixels, o->shader_directory) != BOLAN_OK) return false;
    if (!open_world(v, scene) || !panel_open(&v->window)) return false;
    input_open(&v->input);
    bolan_gl_info info = bolan_gl_get_info();
    snprintf(v->device, sizeof v->device, "%s, %s%s", info.renderer, v->window.es ? "" : "OpenGL ", info.version);
    v->quality = o->quality;
    v->time_scale = 1.0;
    v->paused = o->samples > 0;
    v->refine.most = o->samples > 0 ? o->samples : REFINE_SAMPLES;
    v->render_scale = o->render_scale;
    v->panel_visible = v->running = true;
    pace_start(&v->pace, info.software && o->frames == 0);
    v->last_frame = seconds_now();
    reload_start(&v->watch, o->shader_directory, v->last_frame);
    window_pixels(&v->window, &v->width, &v->height);
    return true;
}

// Prints the machine and the mean time of a given number of frames, for tests and measurements.
static void report(const viewer *v) {
    if (v->options->frames == 0) return;
    double ms = (seconds_now() - v->first_frame) * 1e3 / fmax(v->frame - 1.0, 1.0); // the first compiles shaders
    printf("%u frames of %u x %u on %s, %s, %.1f ms each\n", v->frame, v->width, v->height, SDL_GetCurrentVideoDriver(),
           v->device, ms);
    char said[32];
    refine_say(&v->refine, said, sizeof said);
    if (said[0] != '\0') printf("%s\n", said);
}

static void stop(viewer *v) {
    if (v->window.handle == NULL) return;
    input_close(&v->input);
    panel_close();
    canvas_close(&v->canvas);
    bolan_world_destroy(&v->world);
    window_close(&v->window);
}

int viewer_run(const bolan_scene *scene, const viewer_options *options) {
    viewer v = {.options = options};
    messages_start();
    if (start(&v, scene)) {
        while (v.running) one_frame(&v);
        report(&v);
    } else {
        v.status = 1;
    }
    stop(&v);
    messages_stop();
    return v.status;
}

// SPDX-License-Identifier: MIT
// The page's side of C: one sea, one canvas. page.js calls the functions here; it owns the panel, the keys, the pointer
// and the clock. Text that a function returns stays until the next call.
#include "../viewer/fly.h"
#include "../viewer/pace.h"
#include "../viewer/world.h"
#include "load.h"
#include "scenes.h"
#include "settings.h"

#include "bolan/query.h"
#include "bolan/render.h"

#include <emscripten/emscripten.h>
#include <emscripten/html5.h>
#include <emscripten/html5_webgl.h>

#include <math.h>
#include <string.h>

#define SLOW_MS 42.0 // the pace of a page: a frame takes one, two or three periods of a display of 60 Hz
#define FAST_MS 32.0
#define FAR 20000.0 // [m] how far the cursor asks for a height

static struct {
    EMSCRIPTEN_WEBGL_CONTEXT_HANDLE context;
    bolan_renderer *renderer;
    bolan_world *world;
    bolan_scene scene; // what the panel and the keys edit; copied to the world before a frame
    pace pace;
    bool edited;
    char text[4096];
} page;

// ---- hooks ----------------------------------------------------------------------------------------------------------

EM_JS(void, tell_page, (int level, const char *sentence), { Module.onBolanLog(level, UTF8ToString(sentence)); })

static void log_to_page(void *user, bolan_log_level level, bolan_log_id id, const char *sentence) {
    (void)user;
    (void)id;
    tell_page((int)level, sentence);
}

static void *find_function(void *user, const char *name) {
    (void)user;
    return emscripten_webgl_get_proc_address(name);
}

// When the page has loaded the program.
int main(void) {
    bolan_set_hooks(&(bolan_hooks){.log = log_to_page, .get_proc_address = find_function});
    return 0;
}

// ---- context and renderer -------------------------------------------------------------------------------------------

// Nothing but the canvas's colour is used: the renderer has depth buffers of its own.
static bool make_context(const char *canvas) {
    EmscriptenWebGLContextAttributes wanted;
    emscripten_webgl_init_context_attributes(&wanted);
    wanted.alpha = wanted.depth = wanted.stencil = wanted.antialias = false;
    wanted.powerPreference = EM_WEBGL_POWER_PREFERENCE_HIGH_PERFORMANCE;
    wanted.majorVersion = 2;
    wanted.minorVersion = 0;
    page.context = emscripten_webgl_create_context(canvas, &wanted);
    return page.context > 0 && emscripten_webgl_make_context_current(page.context) == EMSCRIPTEN_RESULT_SUCCESS;
}

// Returns 0, or 1: the browser has no WebGL 2; 2: the renderer cannot be made, and the log says why.
EMSCRIPTEN_KEEPALIVE int web_open(const char *canvas, int quality) {
    if (!make_context(canvas)) return 1;
    bolan_renderer_desc desc = bolan_renderer_desc_default();
    desc.quality = (bolan_quality)quality;
    desc.restore = BOLAN_RESTORE_NONE; // nobody else draws here
    desc.backend = BOLAN_BACKEND_CPU;
    if (bolan_renderer_create(&desc, &page.renderer) != BOLAN_OK) return 2;
    pace_start(&page.pace, false); // a browser does not tell whether a processor draws
    pace_limit(&page.pace, SLOW_MS, FAST_MS);
    return 0;
}

// Before another web_open(): the context was lost, or another quality is wanted.
EMSCRIPTEN_KEEPALIVE void web_close(void) {
    bolan_renderer_destroy(&page.renderer);
    emscripten_webgl_destroy_context(page.context);
    page.context = 0;
}

// ---- scene and settings ---------------------------------------------------------------------------------------------

EMSCRIPTEN_KEEPALIVE const char *web_scene_name(int index) { return web_scenes[index].name; }

EMSCRIPTEN_KEEPALIVE const char *web_description(void) { return page.scene.description; }

// Edits the scene that is opened next, or is open.
EMSCRIPTEN_KEEPALIVE int web_set(const char *key, const char *value) {
    page.edited = true;
    return settings_set(&page.scene, key, value);
}

EMSCRIPTEN_KEEPALIVE const char *web_get(const char *key) {
    settings_get(&page.scene, key, page.text, sizeof page.text);
    return page.text;
}

EMSCRIPTEN_KEEPALIVE const char *web_describe(const char *key) {
    settings_describe(key, page.text, sizeof page.text);
    return page.text;
}

// Takes the named scene, which web_set() may edit before web_enter().
EMSCRIPTEN_KEEPALIVE int web_choose(const char *name) {
    const web_scene *s = web_scenes;
    while (s->name && strcmp(s->name, name) != 0) s++;
    if (!s->name) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_UNKNOWN_NAME, "the page has no scene %.64s; expected one of its list",
                  name);
        return false;
    }
    page.scene = bolan_scene_default();
    s->fill(&page.scene);
    return true;
}

// Makes the world of the scene. The old one stays after a failure.
EMSCRIPTEN_KEEPALIVE int web_enter(void) {
    bolan_world *fresh = NULL;
    if (load_world(&page.scene, &fresh) != BOLAN_OK) return false;
    bolan_world_destroy(&page.world);
    page.world = fresh;
    page.edited = false;
    bolan_world_settle(fresh, page.scene.time);
    page.scene.camera = bolan_world_camera_at(fresh, page.scene.time);
    return true;
}

// What was edited; the old scene where it cannot be had, and the log has said why.
static void update_world(void) {
    if (!page.edited) return;
    page.edited = false;
    const bool ok = bolan_world_set_scene(page.world, &page.scene) == BOLAN_OK;
    if (!ok) page.scene = *bolan_world_scene(page.world);
}

// ---- a frame --------------------------------------------------------------------------------------------------------

// Moves the camera for `seconds`: forward, right and up are -1..1, turn and tilt degrees to the right and up.
EMSCRIPTEN_KEEPALIVE void web_fly(double seconds, double forward, double right, double up, double turn, double tilt,
                                  double faster) {
    bolan_camera *camera = &page.scene.camera;
    bool land = false;
    const double surface = world_surface(page.world, camera->position.x, camera->position.y, &land);
    const fly_input input = {forward, right, up, turn, tilt, faster};
    fly_step(camera, &input, fly_speed(fabs(camera->position.z - surface)), -INFINITY, seconds);
    fly_keep_above(camera, world_floor(page.world, camera->position.x, camera->position.y));
}

// The scale at which the canvas is drawn, after a frame that took `ms`; 0: none did.
EMSCRIPTEN_KEEPALIVE double web_pace(double ms) {
    if (ms > 0.0) pace_frame(&page.pace, ms, true);
    return page.pace.scale;
}

// Steps the sea to `time` and draws a picture of that size.
EMSCRIPTEN_KEEPALIVE void web_draw(double time, uint32_t width, uint32_t height) {
    update_world();
    page.scene.time = time;
    bolan_world_step(page.world, time);
    bolan_world_set_camera(page.world, &page.scene.camera);
    bolan_view view = bolan_view_from_camera(&page.scene.camera, width, height);
    view.eye = bolan_world_clear_eye(page.world, view.eye);
    view.progressive = true;
    if (bolan_renderer_needs_baking(page.renderer)) bolan_renderer_bake(page.renderer);
    bolan_renderer_draw_world(page.renderer, page.world, &view);
}

// ---- asking ---------------------------------------------------------------------------------------------------------

// The ray through the point `x`, `y` of the picture, 0..1 from its upper left corner.
static bolan_ray ray_through(double x, double y, double aspect) {
    const bolan_camera *c = &page.scene.camera;
    const bolan_view view = bolan_view_from_camera(c, 64, 64);
    const double tangent = tan(0.5 * bolan_radians(c->fov_deg));
    const double right = (2.0 * x - 1.0) * tangent * aspect, up = (1.0 - 2.0 * y) * tangent;
    const float *m = view.view.m; // column-major: its rows are the axes of the camera
    const bolan_dvec3 way = {right * (double)m[0] + up * (double)m[1] - (double)m[2],
                             right * (double)m[4] + up * (double)m[5] - (double)m[6],
                             right * (double)m[8] + up * (double)m[9] - (double)m[10]};
    return (bolan_ray){bolan_world_clear_eye(page.world, c->position), way, FAR};
}

// Whether the ground stands before the end of the way.
static bool meets_ground(const bolan_ray *ray, double distance) {
    const bolan_ground *ground = bolan_world_water(page.world)->ground;
    const double size = sqrt(ray->direction.x * ray->direction.x + ray->direction.y * ray->direction.y +
                             ray->direction.z * ray->direction.z);
    for (double d = 1.0; ground && d < distance; d *= 1.02) {
        const double x = ray->origin.x + d / size * ray->direction.x, y = ray->origin.y + d / size * ray->direction.y;
        const double z = ray->origin.z + d / size * ray->direction.z;
        if ((double)bolan_ground_elevation(ground, x, y, 0.0) > z) return true;
    }
    return false;
}

// The water at a point of the picture, as JSON: place, height, distance; or {"land":true}, or {} in the sky.
EMSCRIPTEN_KEEPALIVE const char *web_ask(double x, double y, double aspect) {
    const bolan_ray ray = ray_through(x, y, aspect);
    bolan_ray_hit hit = {0};
    bolan_query_rays(bolan_world_water(page.world), NULL, &ray, 1, &hit);
    if (meets_ground(&ray, hit.hit ? hit.distance : FAR)) return "{\"land\":true}";
    if (!hit.hit) return "{}";
    bolan_query_point at = {0};
    bolan_query_surface(bolan_world_water(page.world), &(bolan_dvec2){hit.point.x, hit.point.y}, 1, &at);
    bolan_format(page.text, sizeof page.text, "{\"x\":%.2f,\"y\":%.2f,\"height\":%.3f,\"distance\":%.2f}", hit.point.x,
                 hit.point.y, (double)at.height, hit.distance);
    return page.text;
}

// Height of the surface at a place of the world [m].
EMSCRIPTEN_KEEPALIVE double web_height(double x, double y) {
    bolan_query_point at = {0};
    bolan_query_surface(bolan_world_water(page.world), &(bolan_dvec2){x, y}, 1, &at);
    return (double)at.height;
}

// Bytes that the library holds, for tests.
EMSCRIPTEN_KEEPALIVE double web_memory(void) { return (double)bolan_memory_in_use(); }

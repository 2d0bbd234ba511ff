// SPDX-License-Identifier: MIT
// A first image: a headless context, a world, the renderer, a target, a PNG.
//
//     03_first_frame [FILE.png]
#include "bolan/io.h"
#include "bolan/render.h"

#include <stdio.h>

enum { WIDTH = 960, HEIGHT = 540 };

static bolan_scene make_scene(void) {
    bolan_scene scene = bolan_scene_default();
    scene.sea.sea_state = bolan_sea_state_from_wind(9.0, 250.0, 200e3);
    scene.camera.position = (bolan_dvec3){0.0, 0.0, 4.0};
    scene.camera.heading_deg = 335.0;
    scene.camera.pitch_deg = -3.0;
    scene.sky.sun_azimuth_deg = 285.0;
    scene.sky.sun_elevation_deg = 18.0;
    return scene;
}

// Draws the scene and writes the file; false if something failed, and then the log has said what.
static bool draw(const bolan_scene *scene, const char *path) {
    bolan_world *world = NULL;
    bolan_renderer *renderer = NULL;
    bolan_target *target = NULL;
    uint8_t *rgb = NULL;
    const size_t size = (size_t)WIDTH * HEIGHT * 3;
    bool ok = false;

    const bolan_renderer_desc desc = bolan_renderer_desc_default();
    bolan_world_desc world_desc = bolan_world_desc_default();
    world_desc.scene = scene;
    if (bolan_world_create(&world_desc, &world) != BOLAN_OK) goto done;
    if (bolan_renderer_create(&desc, &renderer) != BOLAN_OK) goto done;
    if (bolan_target_create(WIDTH, HEIGHT, &target) != BOLAN_OK) goto done;
    rgb = bolan_allocate(size);
    if (!rgb) goto done;

    bolan_world_settle(world, 30.0); // to half a minute, with the foam that the last seconds would have left
    bolan_view view = bolan_view_from_camera(&scene->camera, WIDTH, HEIGHT);
    view.eye = bolan_world_clear_eye(world, view.eye); // no wave covers it
    view.framebuffer = bolan_target_framebuffer(target);
    view.samples = 4;
    bolan_renderer_draw_world(renderer, world, &view);
    bolan_renderer_read_rgb8(renderer, view.framebuffer, WIDTH, HEIGHT, rgb);
    ok = bolan_png_write(path, WIDTH, HEIGHT, rgb) == BOLAN_OK;

done:
    bolan_release(rgb, size);
    bolan_target_destroy(&target);
    bolan_renderer_destroy(&renderer);
    bolan_world_destroy(&world);
    return ok;
}

int main(int argc, char **argv) {
    const char *path = argc > 1 ? argv[1] : "first_frame.png";
    bolan_context *context = NULL;
    if (bolan_context_create(BOLAN_GL_CORE, &context) != BOLAN_OK) return 77; // no OpenGL on this machine
    const bolan_scene scene = make_scene();
    const bool ok = draw(&scene, path);
    bolan_context_destroy(&context);
    if (ok) printf("%s: %d x %d\n", path, WIDTH, HEIGHT);
    return ok ? 0 : 1;
}

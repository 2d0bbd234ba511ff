// SPDX-License-Identifier: MIT
// bolan view: hands the scene to the viewer.
#include "commands.h"
#include "help.h"
#include "options.h"

#ifdef BOLAN_HAVE_VIEWER
#include "viewer.h"

#include <math.h>

enum { MOST_PIXELS = 16384 }; // of a window, each way

int command_view(int count, char **arguments) {
    options o;
    int result = options_parse(ON_VIEW, "view", count, arguments, &o);
    if (result) return result;
    if (o.help) return help_command(ON_VIEW, "view [SCENE] [OPTIONS]", "Opens a window on the scene.");
    bolan_scene scene;
    result = options_scene(&o, &scene);
    if (result) return result;
    bolan_set_threads(isnan(o.threads) ? 0 : (uint32_t)o.threads);
    viewer_options v = viewer_options_default();
    if (o.size[0] > MOST_PIXELS || o.size[1] > MOST_PIXELS)
        return usage_error("--size: a window has at most %d pixels each way", MOST_PIXELS);
    if (!isnan(o.size[0])) {
        v.width = (uint32_t)o.size[0];
        v.height = (uint32_t)o.size[1];
    }
    if (o.quality >= 0) v.quality = (bolan_quality)o.quality;
    if (o.backend >= 0) v.backend = (bolan_backend)o.backend;
    if (o.pixels >= 0) v.pixels = (bolan_pixels)o.pixels;
    if (!isnan(o.frames)) v.frames = (uint32_t)o.frames;
    v.screenshot = o.screenshot;
    if (!isnan(o.samples)) v.samples = (uint32_t)o.samples;
#ifdef BOLAN_SHADER_DIR
    v.shader_directory = BOLAN_SHADER_DIR;
#endif
    return viewer_run(&scene, &v);
}
#endif

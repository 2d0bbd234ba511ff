// SPDX-License-Identifier: MIT
// The sky of a scene, as its renderer draws it.
#include "exports.h"

#include "session.h"

#include "bolan/export.h"
#include "bolan/render.h"

#include <math.h>
#include <string.h>

static bool draw(const options *o, const bolan_world *w, uint32_t width, uint32_t height, float *rgb,
                 bolan_sky_light *light) {
    bolan_context *context = NULL;
    bolan_renderer *renderer = NULL;
    bolan_renderer_desc desc = bolan_renderer_desc_default();
    desc.quality = o->quality >= 0 ? (bolan_quality)o->quality : BOLAN_QUALITY_HIGH;
    desc.restore = BOLAN_RESTORE_NONE; // the context is this program's
    bool ok = !bolan_context_create(BOLAN_GL_CORE, &context) && !bolan_renderer_create(&desc, &renderer);
    if (ok) {
        const bolan_scene *scene = bolan_world_scene(w);
        const bolan_lighting lighting = bolan_lighting_from_scene(scene);
        bolan_renderer_prepare(renderer, bolan_world_water(w), &lighting);
        ok = !bolan_renderer_read_sky(renderer, scene->camera.position, width, height, rgb, light);
    }
    bolan_renderer_destroy(&renderer);
    bolan_context_destroy(&context);
    return ok;
}

int export_sky(const options *o) {
    const size_t length = strlen(o->output);
    const uint32_t width = isnan(o->size[0]) ? 2048 : (uint32_t)o->size[0];
    const uint32_t height = isnan(o->size[1]) ? 1024 : (uint32_t)o->size[1];
    bolan_world *w = NULL;
    bolan_sky_light light;
    if (length < 5 || strcmp(o->output + length - 4, ".exr") != 0)
        return usage_error("-o %s: expected a name that ends in .exr", o->output);
    if (width != 2 * height)
        return usage_error("--size %ux%u: the map of a sky is twice as wide as high", (unsigned)width,
                           (unsigned)height);
    int result = bolan_file_check_writable(o->output) ? EXIT_FAILED : session_open_sea(o, &w);
    if (result) return result;
    const size_t bytes = 3 * (size_t)width * height * sizeof(float);
    float *rgb = bolan_allocate(bytes);
    if (!rgb) failure("no memory for a map of %ux%u", (unsigned)width, (unsigned)height);
    const bool ok =
        rgb && draw(o, w, width, height, rgb, &light) && !bolan_export_sky(o->output, width, height, rgb, &light);
    bolan_release(rgb, bytes);
    bolan_world_destroy(&w);
    return ok ? EXIT_OK : EXIT_FAILED;
}

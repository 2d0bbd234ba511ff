// SPDX-License-Identifier: MIT
// bolan bake: writes the water of a scene as looping tiles into a folder, for other programs and the scene key `tiles`.
#include "commands.h"
#include "help.h"
#include "output.h"
#include "session.h"

#include <math.h>

// A sea of textures, whatever the scene's technique.
static int open_sea(const options *o, bolan_world **w, bolan_sea **sea) {
    const int result = session_open_sea(o, w);
    if (result) return result;
    bolan_sea_desc desc = bolan_world_sea_desc(*w);
    desc.waves = BOLAN_WAVES_TEXTURES;
    if (!isnan(o->frames)) desc.textures.frames = (uint32_t)o->frames;
    return bolan_sea_create(&desc, sea) ? EXIT_FAILED : EXIT_OK;
}

static bolan_tiles_desc how(const bolan_scene *scene) {
    const bolan_water_optics water = bolan_water_optics_from_jerlov(scene->water.type);
    const double azimuth = bolan_radians(scene->sky.sun_azimuth_deg);
    const double elevation =
        bolan_radians(fmax(scene->sky.sun_elevation_deg, 7.0)); // light on the bottom even at night
    bolan_tiles_desc d = bolan_tiles_desc_default();
    d.paper = scene->look.paper;
    d.color = water.deep;
    d.index = (double)water.index;
    d.sun =
        bolan_v3((float)(sin(azimuth) * cos(elevation)), (float)(cos(azimuth) * cos(elevation)), (float)sin(elevation));
    return d;
}

static int bake(const options *o, const bolan_world *w, bolan_sea *sea) {
    const bolan_tiles_desc desc = how(bolan_world_scene(w));
    bolan_tiles *tiles = NULL;
    const bool ok = !bolan_tiles_bake(sea, &desc, &tiles) && !bolan_tiles_save(tiles, o->output);
    if (ok && !o->quiet) {
        const bolan_tiles_view v = bolan_tiles_get_view(tiles);
        output_print(o->output);
        printf(": %u frames of %u x %u texels, %.4g m, loop of %.4g s\n", (unsigned)v.frames, (unsigned)v.n,
               (unsigned)v.n, v.length, v.period);
    }
    bolan_tiles_destroy(&tiles);
    return ok ? EXIT_OK : EXIT_FAILED;
}

int command_bake(int count, char **arguments) {
    options o;
    bolan_world *w = NULL;
    bolan_sea *sea = NULL;
    int result = options_parse(ON_BAKE, "bake", count, arguments, &o);
    if (result) return result;
    if (o.help)
        return help_command(
            ON_BAKE, "bake [SCENE] -o DIR [OPTIONS]",
            "Makes a new folder DIR with the scene's water as looping tiles: heights, normal maps, the water's own\n"
            "texture and the light on the bottom, for each frame of the loop, and index.json.");
    if (!o.output) return usage_error("bake needs -o DIR, a folder that is not there yet");
    if (o.frames < 2.0 || o.frames > BOLAN_MAX_LOOP_FRAMES)
        return usage_error("--frames %.0f: a loop has 2 to %d frames", o.frames, BOLAN_MAX_LOOP_FRAMES);
    if (bolan_tiles_check_writable(o.output)) return EXIT_FAILED;
    result = open_sea(&o, &w, &sea);
    if (!result) result = bake(&o, w, sea);
    bolan_sea_destroy(&sea);
    bolan_world_destroy(&w);
    return result;
}

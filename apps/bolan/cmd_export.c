// SPDX-License-Identifier: MIT
// bolan export WHAT: what the scene holds, as files for other programs.
#include "commands.h"
#include "exports.h"
#include "help.h"
#include "session.h"

#include <string.h>

typedef struct export_kind {
    const char *name;
    unsigned command; // ON_...
    int (*run)(const options *o);
    const char *usage, *suffixes, *what;
} export_kind;

static const export_kind kinds[] = {
    {"mesh", ON_MESH, export_mesh, "export mesh [SCENE] -o FILE [OPTIONS]", ".ply, .obj or .glb",
     "Writes the surface as triangles with normals, foam and velocity: as the camera sees it, or a rectangle (--rect,\n"
     "--spacing). --frames makes a numbered sequence (sea-%04d.ply) or, in one .glb, an animation."},
    {"fields", ON_FIELDS, export_fields, "export fields [SCENE] -o FILE [OPTIONS]", ".exr or .nc",
     "Writes the fields of the waves: of each cascade, or with --rect or --spacing of the surface over a grid of the\n"
     "world. --frames makes the time dimension of a .nc, or a numbered sequence of .exr."},
    {"sky", ON_SKY, export_sky, "export sky [SCENE] -o FILE.exr [OPTIONS]", ".exr",
     "Writes the sky as an equirectangular map of linear radiance, with the sun in the header."},
    {"spectrum", ON_SPECTRUM, export_spectrum, "export spectrum [SCENE] -o FILE [OPTIONS]", ".png, .csv or .spec",
     "Writes the spectrum of the scene's sea: a polar plot (.png), a table (.csv: frequency, direction, density) or\n"
     "SWAN text (.spec) that --spectrum reads."},
};
enum { KINDS = sizeof kinds / sizeof *kinds };

// The spectrum of the scene's sea: systems and measured spectrum.
int export_spectrum(const options *o) {
    bolan_world *w = NULL;
    int result = session_open_sea(o, &w);
    if (result) return result;
    const bolan_sea_desc desc = bolan_world_sea_desc(w);
    const bolan_result saved = bolan_spectrum_save(o->output, &desc.sea_state, bolan_world_scene(w)->name);
    if (saved) result = saved == BOLAN_ERROR_ARGUMENT ? EXIT_USAGE : EXIT_FAILED;
    bolan_world_destroy(&w);
    return result;
}

int command_export(int count, char **arguments) {
    options o;
    const export_kind *kind = NULL;
    for (int i = 0; i < KINDS && count > 0; i++)
        if (strcmp(arguments[0], kinds[i].name) == 0) kind = &kinds[i];
    if (!kind && count > 0 && arguments[0][0] != '-') {
        char word[SHORT_WORD];
        return usage_error("bolan export %s: expected mesh, fields, sky or spectrum", shorten(arguments[0], word));
    }
    const bool named = kind != NULL;
    char name[32];
    snprintf(name, sizeof name, "export%s%s", named ? " " : "", named ? kind->name : "");
    const int result = options_parse(named ? kind->command : ON_EXPORT, name, count - named, arguments + named, &o);
    if (result) return result;
    if (o.help && named) return help_command(kind->command, kind->usage, kind->what);
    if (o.help)
        return help_command(ON_EXPORT, "export mesh|fields|sky|spectrum [SCENE] -o FILE [OPTIONS]",
                            "Writes the water for other programs; bolan export mesh --help has the options of a mesh.");
    if (!named) return usage_error("bolan export needs to know what: mesh, fields, sky or spectrum");
    if (!o.output) return usage_error("bolan export %s needs -o FILE: %s", kind->name, kind->suffixes);
    return kind->run(&o);
}

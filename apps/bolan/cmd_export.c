// SPDX-License-Identifier: MIT
// bolan export WHAT: what the scene holds, as files for other programs.
#include "commands.h"
#include "help.h"
#include "session.h"

#include <string.h>

// The spectrum of the scene's sea: systems and measured spectrum.
static int export_spectrum(const options *o) {
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
    static const char usage[] = "export spectrum [SCENE] -o FILE [OPTIONS]";
    options o;
    const bool named = count > 0 && strcmp(arguments[0], "spectrum") == 0;
    if (count > 0 && !named && arguments[0][0] != '-') {
        char word[SHORT_WORD];
        return usage_error("bolan export %s: expected spectrum", shorten(arguments[0], word));
    }
    const int result = options_parse(ON_EXPORT, "export", count - named, arguments + named, &o);
    if (result) return result;
    if (o.help)
        return help_command(ON_EXPORT, usage,
                            "Writes the spectrum of the scene's sea: a polar plot (.png), a table (.csv: frequency, "
                            "direction, density) or\n"
                            "SWAN text (.spec) that --spectrum reads.");
    if (!named) return usage_error("bolan export needs to know what: spectrum");
    if (!o.output) return usage_error("bolan export needs -o FILE: .png, .csv or .spec");
    return export_spectrum(&o);
}

// SPDX-License-Identifier: MIT
// See man.h.
#include "man.h"

#include "commands.h"
#include "describe.h"

#include <string.h>

// Plain text for troff: a backslash would begin an escape, a hyphen would become a dash, and a point or an apostrophe
// at the start of a line would be a request. What stands between backquotes is bold.
static void print_text(FILE *file, const char *text) {
    bool bold = false;
    fputs("\\&", file);
    for (const char *p = text; *p; p++) {
        switch (*p) {
        case '\\': fputs("\\e", file); break;
        case '-': fputs("\\-", file); break;
        case '\'': fputs("\\(aq", file); break;
        case '`':
            bold = !bold;
            fputs(bold ? "\\fB" : "\\fR", file);
            break;
        default: fputc(*p, file);
        }
    }
}

static void print_styled(FILE *file, const char *before, char style, const char *text) {
    fprintf(file, "%s\\f%c", before, style);
    print_text(file, text);
    fputs("\\fR", file);
}

static void print_command(FILE *file, const command *c) {
    fputs(".TP\n", file);
    print_styled(file, "", 'B', "bolan");
    print_styled(file, " ", 'B', c->name);
    print_styled(file, " ", 'I', c->arguments);
    fputc('\n', file);
    print_text(file, c->help);
    fputs(".\n", file);
}

static void print_option(FILE *file, const option_info *info) {
    char values[DESCRIBE_MAX], on[128];
    const char letter[] = {'-', info->letter, '\0'};
    fputs(".TP\n", file);
    if (info->letter) {
        print_styled(file, "", 'B', letter);
        fputs(", ", file);
    }
    fputs("\\fB\\-\\-", file);
    print_text(file, info->name);
    fputs("\\fR", file);
    if (info->argument) print_styled(file, " ", 'I', info->argument);
    fputc('\n', file);
    print_text(file, describe_option_help(info));
    describe_option_values(info, "", values, sizeof values);
    if (*values) {
        fputs("\n(", file);
        print_text(file, values);
        fputc(')', file);
    }
    describe_goes_with(info, on, sizeof on);
    fputs(".\nGoes with: ", file);
    print_text(file, on);
    fputs(".\n", file);
}

static void print_scenes(FILE *file) {
    fputs(".SH SCENES\nSCENE is a YAML file, or the name of a scene that comes with the program. Without one it is "
          "island.\n",
          file);
    for (uint32_t i = 0; bolan_scene_builtin_name(i); i++) {
        bolan_scene scene;
        if (bolan_scene_load(bolan_scene_builtin_name(i), &scene) != BOLAN_OK) continue;
        print_styled(file, ".TP\n", 'B', scene.name);
        fputc('\n', file);
        print_text(file, scene.description);
        fputc('\n', file);
    }
}

static const char rules[] =
    ".PP\nAn option and its value are two words or \\fB\\-\\-name=value\\fR; \\fB\\-\\-\\fR ends the options.\n"
    ".SH EXIT STATUS\n"
    ".TP\n0\nsuccess\n.TP\n1\na file, format, memory or OpenGL failed\n"
    ".TP\n2\nthe command line or the scene is wrong\n.TP\n130\ninterrupted\n"
    ".PP\nEach error is one sentence on standard error. No partial file is left behind.\n"
    ".SH EXAMPLES\n.nf\n"
    "bolan render island \\-o island.png \\-\\-size 1920x1080\n"
    "bolan render storm \\-o storm.mp4 \\-\\-frames 300 \\-\\-fps 30\n"
    "bolan measure \\-\\-spectrum buoy.spec \\-\\-json\n"
    "printf \\(aq0,0\\en25,0\\en\\(aq | bolan query open\\-sea \\-\\-time 10 \\-\\-points \\-\n"
    ".fi\n"
    ".SH SEE ALSO\nThe keys of scene files: \\fBbolan info \\-\\-parameters\\fR.\n"
    "\\fBffmpeg\\fR(1) writes the films.\n";

void man_print(FILE *file) {
    fprintf(file,
            ".\\\" Written by bolan info --man.\n.TH BOLAN 1 \"\" \"bolan %s\" \"User Commands\"\n"
            ".SH NAME\nbolan \\- make, measure and draw seas\n"
            ".SH SYNOPSIS\n\\fBbolan\\fR \\fICOMMAND\\fR [\\fISCENE\\fR] [\\fIOPTIONS\\fR]\n.br\n"
            "\\fBbolan\\fR \\fICOMMAND\\fR \\fB\\-\\-help\\fR\n.br\n\\fBbolan \\-\\-version\\fR\n"
            ".SH DESCRIPTION\nBolan simulates a sea from a wind, a table or a measured spectrum, returns its heights "
            "and motion at any point, and draws it with OpenGL.\n.SH COMMANDS\n",
            bolan_version());
    for (const command *c = command_table; c->name; c++)
        if (!c->exists) print_command(file, c); // bench is not installed
    fputs(".SH OPTIONS\nAn option that changes the scene replaces what the scene says, and leaves the rest of it.\n",
          file);
    for (const option_info *i = option_table; i->name; i++) print_option(file, i);
    fputs(rules, file);
    print_scenes(file);
}

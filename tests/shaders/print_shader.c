// SPDX-License-Identifier: MIT
// print_shader STEM VERTEX|FRAGMENT|COMPUTE core|es [NAME[=VALUE]...]: with these names defined, as 1 where no value
// is given, the text that the engine hands to the driver, for an offline compiler.
#include "render/gl/source.h"

#include <stdio.h>
#include <string.h>

int main(int argc, char **argv) {
    if (argc < 4) {
        fprintf(stderr, "usage: print_shader STEM VERTEX|FRAGMENT|COMPUTE core|es [NAME[=VALUE]...]\n");
        return 2;
    }
    char defines[256] = "";
    for (int i = 4; i < argc; i++) {
        const size_t used = strlen(defines);
        const size_t name = strcspn(argv[i], "=");
        snprintf(defines + used, sizeof defines - used, "%.*s %s\n", (int)name, argv[i],
                 argv[i][name] == '=' ? argv[i] + name + 1 : "1");
    }
    shader_text text;
    if (bolan_shader_text_build(argv[1], argv[2], defines, strcmp(argv[3], "es") == 0, &text) != BOLAN_OK) return 1;
    fputs(text.text, stdout);
    bolan_shader_text_free(&text);
    return 0;
}

// SPDX-License-Identifier: MIT
// print_shader STEM VERTEX|FRAGMENT core|es [NAME...]: with these names defined as 1, the text that the engine hands to
// the driver, for an offline compiler.
#include "render/gl/source.h"

#include <stdio.h>
#include <string.h>

int main(int argc, char **argv) {
    if (argc < 4) {
        fprintf(stderr, "usage: print_shader STEM VERTEX|FRAGMENT core|es [NAME...]\n");
        return 2;
    }
    char defines[256] = "";
    for (int i = 4; i < argc; i++) {
        const size_t used = strlen(defines);
        snprintf(defines + used, sizeof defines - used, "%s 1\n", argv[i]);
    }
    shader_text text;
    if (bolan_shader_text_build(argv[1], argv[2], defines, strcmp(argv[3], "es") == 0, &text) != BOLAN_OK) return 1;
    fputs(text.text, stdout);
    bolan_shader_text_free(&text);
    return 0;
}

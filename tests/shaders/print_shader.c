// SPDX-License-Identifier: MIT
// print_shader STEM VERTEX|FRAGMENT core|es: the text that the engine hands to the driver, for an offline compiler.
#include "render/gl/source.h"

#include <stdio.h>
#include <string.h>

int main(int argc, char **argv) {
    if (argc != 4) {
        fprintf(stderr, "usage: print_shader STEM VERTEX|FRAGMENT core|es\n");
        return 2;
    }
    shader_text text;
    if (shader_text_build(argv[1], argv[2], NULL, strcmp(argv[3], "es") == 0, &text) != BOLAN_OK) return 1;
    fputs(text.text, stdout);
    shader_text_free(&text);
    return 0;
}

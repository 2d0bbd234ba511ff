// SPDX-License-Identifier: MIT
// See help.h.
#include "help.h"

#include "options.h"

int help_command(unsigned command, const char *usage, const char *what) {
    printf("usage: bolan %s\n\n%s\n\noptions:\n", usage, what);
    options_print(stdout, command);
    if (command == ON_INFO) return EXIT_OK;
    printf("\nSCENE is one of");
    for (uint32_t i = 0; bolan_scene_builtin_name(i); i++) printf("%s %s", i ? "," : "", bolan_scene_builtin_name(i));
    printf(", or a YAML file; the default is island.\n");
    return EXIT_OK;
}

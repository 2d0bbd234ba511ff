// SPDX-License-Identifier: MIT
// See yaml_limits.h.
//
// libyaml visits every open bracket at every token, and every anchor at every alias: 100 kB of "[" take a quarter of a
// minute, and twice as many take four times that. All other costs are linear. Within these limits the worst text takes
// a few hundredths of a second.
//
// Brackets in quotes and comments count too. An exception for them would have to find the ends of quotes and comments
// exactly as libyaml does, or a text could hide brackets from the count. Scenes stay far below the limits: 64 objects
// and 32 camera keys need some hundred brackets.
#include "io/yaml_limits.h"

static bool begins_name(char c) {
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_' || c == '-';
}

static bolan_result refuse(const char *name, unsigned line, int limit, const char *what) {
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_SCENE_TOO_DEEP, "%s:%u: more than %d %s up to here; expected a scene", name,
              line, limit, what);
    return BOLAN_ERROR_FORMAT;
}

bolan_result bolan_yaml_check_limits(const char *name, const char *text, size_t size) {
    if (size > YAML_SIZE_LIMIT) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_FILE_TOO_LARGE, "%s: larger than a scene can be; expected at most %d KiB",
                  name, YAML_SIZE_LIMIT >> 10);
        return BOLAN_ERROR_FORMAT;
    }
    unsigned line = 1;
    int brackets = 0, anchors = 0;
    for (size_t i = 0; i < size; i++) {
        line += text[i] == '\n';
        brackets += text[i] == '[' || text[i] == '{';
        anchors += (text[i] == '&' || text[i] == '*') && i + 1 < size && begins_name(text[i + 1]);
        if (brackets > YAML_BRACKET_LIMIT) return refuse(name, line, YAML_BRACKET_LIMIT, "brackets");
        if (anchors > YAML_ANCHOR_LIMIT) return refuse(name, line, YAML_ANCHOR_LIMIT, "anchors and aliases");
    }
    return BOLAN_OK;
}

// SPDX-License-Identifier: MIT
// See output.h. The pattern is read here and never given to printf.
#include "output.h"

#include <stdio.h>
#include <string.h>

static output_kind kind_of(const char *path) {
    static const struct {
        const char *suffix;
        output_kind kind;
    } kinds[] = {{".png", OUTPUT_PNG}, {".exr", OUTPUT_EXR}, {".mp4", OUTPUT_VIDEO}, {".webm", OUTPUT_VIDEO}};
    const size_t length = strlen(path);
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
        const size_t tail = strlen(kinds[i].suffix);
        if (length > tail && strcmp(path + length - tail, kinds[i].suffix) == 0) return kinds[i].kind;
    }
    return OUTPUT_UNKNOWN;
}

output_name output_parse(const char *path) {
    output_name name = {.kind = kind_of(path), .digits = 1};
    const char *percent = strchr(path, '%');
    if (!percent) return name;
    const char *p = percent + 1;
    if (*p == '0' && p[1] >= '1' && p[1] <= '9') {
        name.digits = p[1] - '0';
        p += 2;
    }
    const bool good = *p == 'd' && !strchr(p, '%') && !strchr(p, '/') && name.kind != OUTPUT_VIDEO;
    name.numbered = good;
    name.before = (size_t)(percent - path);
    name.after = (size_t)(p + 1 - path);
    if (!good) name.kind = OUTPUT_UNKNOWN;
    return name;
}

bool output_frame_path(const output_name *name, const char *path, uint32_t number, char out[BOLAN_PATH_MAX]) {
    if (!name->numbered) return snprintf(out, BOLAN_PATH_MAX, "%s", path) < BOLAN_PATH_MAX;
    return snprintf(out, BOLAN_PATH_MAX, "%.*s%0*u%s", (int)name->before, path, name->digits, (unsigned)number,
                    path + name->after) < BOLAN_PATH_MAX;
}

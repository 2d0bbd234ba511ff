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

static const char *last_part(const char *path) {
    const char *slash = strrchr(path, '/');
    return slash ? slash + 1 : path;
}

// The end of a pattern for a number after the percent sign, "d" or "04d", or NULL. *good: a pattern that is supported.
static const char *end_of_pattern(const char *p, bool *good) {
    const size_t flags = strspn(p, "+-#0123456789");
    if (p[flags] != 'd') return NULL;
    *good = flags == 0 || (flags == 2 && p[0] == '0' && p[1] >= '1' && p[1] <= '9');
    return p + flags + 1;
}

output_name output_parse(const char *path) {
    output_name name = {.kind = kind_of(path), .digits = 1};
    for (const char *p = strchr(last_part(path), '%'); p; p = strchr(p, '%')) {
        bool good = false;
        const char *end = end_of_pattern(p + 1, &good);
        if (end) {
            name.wrong_pattern |= !good || name.numbered || name.kind == OUTPUT_VIDEO;
            name.numbered = true;
            name.before = (size_t)(p - path);
            name.after = (size_t)(end - path);
            if (end - p > 2) name.digits = p[2] - '0';
            p = end;
        } else {
            p += p[1] == '%' ? 2 : 1;
        }
    }
    return name;
}

typedef struct writer {
    char *out;
    size_t used; // BOLAN_PATH_MAX: it did not fit
} writer;

static void put(writer *w, const char *text, size_t length) {
    if (w->used + length >= BOLAN_PATH_MAX) {
        w->used = BOLAN_PATH_MAX;
        return;
    }
    memcpy(w->out + w->used, text, length);
    w->used += length;
    w->out[w->used] = '\0';
}

// %% becomes %.
static void put_name(writer *w, const char *begin, const char *end) {
    for (const char *p = begin; p < end; p++) {
        put(w, p, 1);
        if (p[0] == '%' && p + 1 < end && p[1] == '%') p++;
    }
}

bool output_frame_path(const output_name *name, const char *path, uint32_t number, char out[BOLAN_PATH_MAX]) {
    const char *part = last_part(path), *end = path + strlen(path);
    char digits[32];
    const int length = snprintf(digits, sizeof digits, "%0*u", name->digits, (unsigned)number);
    writer w = {out, 0};
    put(&w, path, (size_t)(part - path));
    put_name(&w, part, name->numbered ? path + name->before : end);
    if (name->numbered) {
        put(&w, digits, (size_t)length);
        put_name(&w, path + name->after, end);
    }
    return w.used < BOLAN_PATH_MAX;
}

void output_print(const char *text) {
    char shown[4 * BOLAN_PATH_MAX]; // "\x1b" of every byte
    bolan_text_escape(text, shown, sizeof shown);
    printf("%s", shown);
}

// SPDX-License-Identifier: MIT
// The hooks, and log and assertions through them.
#include "base/hooks.h"

#include "base/number.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

enum { SENTENCE_CAPACITY = 2048 }; // a path of BOLAN_PATH_MAX bytes, and a sentence about it

// All process-wide state is: these hooks, the pool (pool.c) and the byte count (memory.c).
static bolan_hooks hooks;

const bolan_hooks *bolan_active_hooks(void) { return &hooks; }

void bolan_set_hooks(const bolan_hooks *new_hooks) {
    static const bolan_hooks built_in;
    hooks = new_hooks ? *new_hooks : built_in;
    BOLAN_ASSERT(!hooks.allocate == !hooks.release); // memory is released by the hook that allocated it
    BOLAN_ASSERT(!hooks.parallel || hooks.parallel_workers >= 1);
}

bolan_hooks bolan_get_hooks(void) { return hooks; }

static void print_line(bolan_log_level level, const char *sentence) {
    static const char *const names[] = {"error", "warning", "info"};
    // One call, so that lines of different threads do not mix.
    fprintf(stderr, "bolan: %s: %s\n", names[level], sentence);
}

static _Thread_local bool muted;

void bolan_log_mute(bool on) { muted = on; }

void bolan_log(bolan_log_level level, bolan_log_id id, const char *format, ...) {
    if (muted) return;
    char raw[SENTENCE_CAPACITY], sentence[SENTENCE_CAPACITY];
    va_list arguments;
    va_start(arguments, format);
    bolan_number_format_list(raw, sizeof raw, format, arguments);
    va_end(arguments);
    bolan_text_escape(raw, sentence, sizeof sentence);
    if (hooks.log) {
        hooks.log(hooks.user, level, id, sentence);
    } else {
        print_line(level, sentence);
    }
}

void bolan_assert_failed(const char *expression, const char *file, int line) {
    if (hooks.assert_failed) {
        hooks.assert_failed(hooks.user, expression, file, line);
        return;
    }
    fprintf(stderr, "bolan: %s:%d: misuse: %s does not hold\n", file, line, expression);
    abort();
}

// SPDX-License-Identifier: MIT
// The log, kept for the panel. The library may log from any thread, so a lock guards the lines.
#include "messages.h"

#include "bolan/base.h"

#include <SDL.h>
#include <stdarg.h>
#include <stdio.h>

static struct {
    SDL_SpinLock lock;
    unsigned count;
    char line[MESSAGES_KEPT][MESSAGE_MAX];
} kept;

static void keep(const char *sentence) {
    SDL_AtomicLock(&kept.lock);
    snprintf(kept.line[kept.count % MESSAGES_KEPT], MESSAGE_MAX, "%s", sentence);
    kept.count++;
    SDL_AtomicUnlock(&kept.lock);
}

static void on_log(void *user, bolan_log_level level, bolan_log_id id, const char *sentence) {
    (void)user;
    (void)id;
    if (level == BOLAN_LOG_INFO) return;
    fprintf(stderr, "bolan: %s%s\n", level == BOLAN_LOG_WARNING ? "warning: " : "", sentence); // as on the command line
    keep(sentence);
}

void messages_start(void) {
    messages_clear();
    bolan_set_hooks(&(bolan_hooks){.log = on_log});
}

void messages_stop(void) { bolan_set_hooks(NULL); }

void messages_clear(void) {
    SDL_AtomicLock(&kept.lock);
    kept.count = 0;
    SDL_AtomicUnlock(&kept.lock);
}

const char *messages_get(unsigned back) {
    return back < kept.count && back < MESSAGES_KEPT ? kept.line[(kept.count - 1 - back) % MESSAGES_KEPT] : NULL;
}

void messages_add(const char *format, ...) {
    char line[MESSAGE_MAX];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(line, sizeof line, format, arguments);
    va_end(arguments);
    keep(line);
}

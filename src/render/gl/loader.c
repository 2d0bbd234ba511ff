// SPDX-License-Identifier: MIT
// See loader.h.
#include "loader.h"

#include "bolan/base.h"

#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

gl_functions bolan_gl_functions;

_Thread_local gl_calls bolan_gl_calls_made;
gl_calls bolan_gl_calls(void) { return bolan_gl_calls_made; }

static atomic_flag filling = ATOMIC_FLAG_INIT;
static bool filled;
static bolan_hooks filled_from; // its get_proc_address and user are what the table was filled by
static const char *missing;

// Object pointers become function pointers by way of memory: ISO C has no cast for it, POSIX promises equal sizes.
#define FROM_HOOK(name)                                                   \
    {                                                                     \
        void *address = hooks->get_proc_address(hooks->user, "gl" #name); \
        memcpy(&bolan_gl_functions.name, &address, sizeof address);       \
    }
#if BOLAN_WITH_EPOXY
#define WITHOUT_HOOK(name) bolan_gl_functions.name = epoxy_gl##name;
#else
#define WITHOUT_HOOK(name) bolan_gl_functions.name = NULL;
#endif
#define NOTE_MISSING(name) \
    if (!bolan_gl_functions.name && !missing) missing = "gl" #name;

static void fill(const bolan_hooks *hooks) {
    missing = NULL;
    if (hooks->get_proc_address) {
        GL_NEEDED(FROM_HOOK)
        GL_OPTIONAL(FROM_HOOK)
    } else {
        GL_NEEDED(WITHOUT_HOOK)
        GL_OPTIONAL(WITHOUT_HOOK)
    }
    GL_NEEDED(NOTE_MISSING)
}

const char *bolan_gl_load(void) {
    const bolan_hooks hooks = bolan_get_hooks();
    while (atomic_flag_test_and_set_explicit(&filling, memory_order_acquire)) continue;
    if (!filled || hooks.get_proc_address != filled_from.get_proc_address || hooks.user != filled_from.user) {
        fill(&hooks);
        filled_from = hooks;
        filled = true;
    }
    const char *result = missing;
    atomic_flag_clear_explicit(&filling, memory_order_release);
    return result;
}

static const char *version_text(void) {
    const GLubyte *text = bolan_gl_functions.GetString ? glGetString(GL_VERSION) : NULL;
    return text ? (const char *)text : "";
}

bool bolan_gl_is_es(void) { return strncmp(version_text(), "OpenGL ES", 9) == 0; }

int bolan_gl_version(void) {
    const char *digits = version_text() + strcspn(version_text(), "0123456789");
    char *end;
    const long major = strtol(digits, &end, 10);
    return (int)(10 * major + (*end == '.' ? strtol(end + 1, NULL, 10) : 0));
}

bool bolan_gl_has_extension(const char *name) {
    GLint count = 0;
    if (bolan_gl_version() < 30) return false; // older contexts have one string of them, and no other use here
    glGetIntegerv(GL_NUM_EXTENSIONS, &count);
    for (GLint i = 0; i < count; ++i)
        if (strcmp((const char *)glGetStringi(GL_EXTENSIONS, (GLuint)i), name) == 0) return true;
    return false;
}

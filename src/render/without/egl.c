// SPDX-License-Identifier: MIT
// Contexts without a window in a build without EGL. See src/render/gl/context.c.
#include "bolan/render_context.h"

bolan_result bolan_context_create(bolan_gl_api api, bolan_context **out) {
    (void)api;
    BOLAN_ASSERT(out);
    *out = NULL;
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_UNSUPPORTED,
              "this build makes no OpenGL context; make one current yourself, or build Bolan with -DBOLAN_WITH_EGL=ON");
    return BOLAN_ERROR_UNSUPPORTED;
}

void bolan_context_make_current(bolan_context *context) { (void)context; }

void bolan_context_destroy(bolan_context **context) {
    if (context) *context = NULL;
}

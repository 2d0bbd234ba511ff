// SPDX-License-Identifier: MIT
// Memory of the renderer: where there is none, the log says once for what.
#ifndef BOLAN_RENDER_MEMORY_H
#define BOLAN_RENDER_MEMORY_H

#include "bolan/base.h"

// bolan_allocate(); `what` ends the sentence "no memory for ...".
static inline void *allocate_for(const char *what, size_t size) {
    void *memory = bolan_allocate(size);
    if (memory == NULL) bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY, "no memory for %s (%zu bytes)", what, size);
    return memory;
}

#endif

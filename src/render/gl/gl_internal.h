// SPDX-License-Identifier: MIT
// What the files of this folder share: the loader, and the format table.
#ifndef BOLAN_GL_INTERNAL_H
#define BOLAN_GL_INTERNAL_H

#include "gl.h"
#include "loader.h"

// Passes bind units 0..23; the layer itself binds on this one, so that creating or filling a texture disturbs no pass.
// Every GL 3.3 has 48 combined units, every ES 3.0 has 32.
enum { SCRATCH_UNIT = 28 };

typedef struct format_info {
    GLenum internal_format, format, type; // type of what an upload hands over (floats or bytes)
    bool half;                            // stored as 16-bit floats: may be handed over as halfs
    bool wide;                            // 32-bit floats: linear filtering is an extension on ES
    uint32_t components;
} format_info;
const format_info *bolan_gl_format_info(gl_format format);

void bolan_gl_set_enabled(GLenum name, bool on);

// The driver's messages go to the log from here on, and to the caller's own callback; or to that callback alone again.
void bolan_gl_listen(gl_saved *s);
void bolan_gl_stop_listening(const gl_saved *s);

#endif

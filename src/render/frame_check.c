// SPDX-License-Identifier: MIT
// What a frame must be before it is drawn.
#include "renderer.h"

static bool check_numbers(bolan_renderer *r, const bolan_frame_desc *d) {
    if (d->width < 1 || d->width > MOST_PIXELS || d->height < 1 || d->height > MOST_PIXELS)
        return bolan_renderer_refuse(r, CALL_DRAW, BOLAN_LOG_OUT_OF_RANGE,
                                     "draw: the frame is %u x %u pixels; expected 1 to %d each way", d->width,
                                     d->height, MOST_PIXELS);
    if (d->samples < 1 || d->samples > MOST_SAMPLES)
        return bolan_renderer_refuse(r, CALL_DRAW, BOLAN_LOG_OUT_OF_RANGE,
                                     "draw: the frame has %u samples; expected 1 to %d", d->samples, MOST_SAMPLES);
    return true;
}

static bool check_kind(bolan_renderer *r, const char *field, int value, int count) {
    if (value >= 0 && value < count) return true;
    return bolan_renderer_refuse(r, CALL_DRAW, BOLAN_LOG_OUT_OF_RANGE,
                                 "draw: scene.technique.%s is %d; expected 0 to %d", field, value, count - 1);
}

static bool check_technique(bolan_renderer *r, const bolan_frame_desc *d) {
    const bolan_technique *t = &d->scene->technique;
    const bolan_wave_model waves = bolan_sea_get_desc(d->sea)->waves;
    if (!check_kind(r, "waves", (int)t->waves, BOLAN_WAVE_MODELS) ||
        !check_kind(r, "surface", (int)t->surface, BOLAN_SURFACE_KINDS) ||
        !check_kind(r, "optics", (int)t->optics, BOLAN_OPTICS_KINDS))
        return false;
    if (t->waves == waves) return true;
    return bolan_renderer_refuse(
        r, CALL_DRAW, BOLAN_LOG_BAD_ARGUMENT,
        "draw: scene.technique.waves is %s, but the sea is made of %s; expected the same wave model",
        bolan_wave_model_names[t->waves], bolan_wave_model_names[waves]);
}

bool bolan_frame_is_valid(bolan_renderer *r, const bolan_frame_desc *d) {
    if (!bolan_gl_has_context())
        return bolan_renderer_refuse(r, CALL_DRAW, BOLAN_LOG_GL_CONTEXT,
                                     "draw: no OpenGL context is current on this thread");
    return check_numbers(r, d) && check_technique(r, d);
}

bool bolan_frame_has_framebuffer(bolan_renderer *r, const bolan_frame_desc *d) {
    const char *problem = bolan_gl_framebuffer_problem(d->framebuffer, GL_TO_DRAW);
    if (problem == NULL) return true;
    return bolan_renderer_refuse(r, CALL_DRAW, BOLAN_LOG_GL_TARGET, "draw: framebuffer %u %s", d->framebuffer, problem);
}

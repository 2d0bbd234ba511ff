// SPDX-License-Identifier: MIT
// Timers: GPU queries, read a frame late so that nothing waits; or the CPU clock between two glFinish().
#include "gl_internal.h"
#include <time.h>

static double now_ms(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec * 1e3 + (double)t.tv_nsec * 1e-6;
}

void gl_finish(void) { glFinish(); }

void gl_timer_create(gl_timer *t) {
    *t = (gl_timer){0};
    if (gl_get_caps().timers) glGenQueries(2, t->query);
}

void gl_timer_begin(gl_timer *t, bool finish) {
    if (finish || !t->query[0]) {
        if (finish) glFinish();
        t->cpu_start = now_ms();
        return;
    }
    const int slot = t->current;
    if (t->pending[slot]) {
        GLuint64 ns = 0;
        glGetQueryObjectui64v(t->query[slot], GL_QUERY_RESULT, &ns);
        t->ms = (double)ns * 1e-6;
        t->pending[slot] = false;
    }
    glBeginQuery(GL_TIME_ELAPSED, t->query[slot]);
}

void gl_timer_end(gl_timer *t, bool finish) {
    if (finish || !t->query[0]) {
        if (finish) glFinish();
        t->ms = now_ms() - t->cpu_start;
        return;
    }
    glEndQuery(GL_TIME_ELAPSED);
    t->pending[t->current] = true;
    t->current ^= 1;
}

void gl_timer_free(gl_timer *t) {
    if (t->query[0]) glDeleteQueries(2, t->query);
    *t = (gl_timer){0};
}

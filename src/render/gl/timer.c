// SPDX-License-Identifier: MIT
// Timers: timestamps of the GPU, taken when they have come, so that nothing waits; or the CPU clock between two
// glFinish().
#include "gl_internal.h"
#include <time.h>

static double now_ms(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec * 1e3 + (double)t.tv_nsec * 1e-6;
}

void bolan_gl_finish(void) { glFinish(); }

static void begin_gpu(gl_timer *t) {
    if (!t->query[0][0]) glGenQueries(2 * GL_TIMER_SLOTS, &t->query[0][0]);
    t->running = !t->pending[t->next]; // every result is still to come: this frame goes untimed
    if (t->running) glQueryCounter(t->query[t->next][0], GL_TIMESTAMP);
}

// Takes the results that are there, oldest first.
static void collect(gl_timer *t) {
    while (t->pending[t->oldest]) {
        const uint32_t *query = t->query[t->oldest];
        GLuint there = 0;
        glGetQueryObjectuiv(query[1], GL_QUERY_RESULT_AVAILABLE, &there);
        if (!there) return;
        GLuint64 ns[2] = {0};
        for (int i = 0; i < 2; i++) glGetQueryObjectui64v(query[i], GL_QUERY_RESULT, &ns[i]);
        t->ms = (double)(ns[1] - ns[0]) * 1e-6;
        t->pending[t->oldest] = false;
        t->oldest = (t->oldest + 1) % GL_TIMER_SLOTS;
    }
}

static void end_gpu(gl_timer *t) {
    if (t->running) {
        glQueryCounter(t->query[t->next][1], GL_TIMESTAMP);
        t->pending[t->next] = true;
        t->next = (t->next + 1) % GL_TIMER_SLOTS;
    }
    collect(t);
}

void bolan_gl_timer_begin(gl_timer *t, gl_timing how) {
    if (how == GL_TIMING_GPU) begin_gpu(t);
    if (how != GL_TIMING_FINISH) return;
    glFinish();
    t->cpu_start = now_ms();
}

void bolan_gl_timer_end(gl_timer *t, gl_timing how) {
    if (how == GL_TIMING_OFF) t->ms = 0.0;
    if (how == GL_TIMING_GPU) end_gpu(t);
    if (how != GL_TIMING_FINISH) return;
    glFinish();
    t->ms = now_ms() - t->cpu_start;
}

void bolan_gl_timer_free(gl_timer *t) {
    if (t->query[0][0] && bolan_gl_has_context()) glDeleteQueries(2 * GL_TIMER_SLOTS, &t->query[0][0]);
    *t = (gl_timer){0};
}

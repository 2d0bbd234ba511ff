// SPDX-License-Identifier: MIT
// See farm_run.h.
#include "farm_run.h"

#include "farm_process.h"
#include "progress.h"

#include <errno.h>
#include <poll.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

enum {
    WARNINGS = 16,     // of different texts, which are said once each
    VAIN_FRAMES = 8,   // beyond one for each slot: failures without a success after which no frame is begun
    LONG_SILENCE = 30, // [s] of a rank, which says that it lives every second
};

// A process of this machine, or another rank.
typedef struct slot {
    farm_process process;
    int rank; // 0: a process of this machine
    bool busy, closed;
    uint32_t frame;
    double handed; // [s]
} slot;

typedef struct hall {
    farm_run *run;
    slot *slots;
    uint32_t slot_count, next, ended, succeeded;
    progress bar;
    double begun, told; // [s]
    char warnings[WARNINGS][FARM_SENTENCE];
    uint32_t warning_count;
} hall;

// Processor time of this process [s].
static double processor_time(void) {
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

// ---- what is said ---------------------------------------------------------------------------------------------------

static void warn(hall *h, const char *sentence) {
    for (uint32_t i = 0; i < h->warning_count; i++)
        if (strcmp(h->warnings[i], sentence) == 0) return;
    if (!sentence[0] || h->warning_count == WARNINGS) return;
    memcpy(h->warnings[h->warning_count++], sentence, FARM_SENTENCE);
    if (!h->run->job->quiet) fprintf(stderr, "bolan: warning: %s\n", sentence);
}

// A bar on a terminal; elsewhere, as under mpirun, a line now and then.
static void tell_progress(hall *h) {
    enum { EVERY = 30 }; // [s]
    progress_update(&h->bar, h->ended);
    const double t = farm_now();
    if (h->bar.shown || h->run->job->quiet || t - h->told < EVERY || h->ended == 0) return;
    h->told = t;
    const long left = (long)((t - h->begun) / h->ended * (h->run->todo_count - h->ended) + 0.5);
    fprintf(stderr, "bolan: %u of %u frames, %ld:%02ld left\n", (unsigned)h->ended, (unsigned)h->run->todo_count,
            left / 60, left % 60);
}

// ---- frames ---------------------------------------------------------------------------------------------------------

static void take_result(hall *h, slot *s, const farm_result *result) {
    farm_result *kept = &h->run->results[s->frame];
    *kept = *result;
    kept->frame = s->frame;
    kept->taken = farm_now() - s->handed;
    kept->by = (uint32_t)(s - h->slots);
    h->succeeded += result->state == FARM_DONE;
    h->ended++;
    s->busy = false;
    warn(h, result->warning);
    if (h->succeeded == 0 && h->ended >= h->slot_count + VAIN_FRAMES) h->next = h->run->todo_count;
    tell_progress(h);
}

static void fail_frame(hall *h, slot *s, const char *reason) {
    farm_result result = {.state = FARM_FAILED};
    snprintf(result.reason, sizeof result.reason, "%s", reason);
    take_result(h, s, &result);
}

static void bury(hall *h, slot *s) {
    char reason[FARM_SENTENCE];
    farm_process_bury(&s->process, h->run->job, s->frame, reason);
    fail_frame(h, s, reason);
}

static void hand_out(hall *h, slot *s) {
    farm_run *run = h->run;
    if (h->next == run->todo_count) {
        s->closed = true;
        if (s->rank > 0)
            ranks_give(s->rank, FARM_STOP);
        else
            farm_process_dismiss(&s->process);
        return;
    }
    s->frame = run->todo[h->next++];
    s->busy = true;
    s->handed = farm_now();
    if (s->rank > 0) {
        ranks_give(s->rank, s->frame);
    } else if (s->process.pid == 0 && !farm_process_start(&s->process, run->count, run->arguments, run->threads)) {
        fail_frame(h, s, strerror(errno));
    } else if (!farm_process_give(&s->process, s->frame)) {
        bury(h, s);
    }
}

static void hear_processes(hall *h, struct pollfd *waits, bool alone) {
    nfds_t count = 0;
    farm_result result;
    for (uint32_t i = 0; i < h->slot_count; i++)
        if (h->slots[i].busy && h->slots[i].rank == 0)
            waits[count++] = (struct pollfd){.fd = h->slots[i].process.socket, .events = POLLIN};
    if (poll(waits, count, alone ? 1000 : 0) <= 0) return;
    for (uint32_t i = 0, k = 0; i < h->slot_count; i++) {
        slot *s = &h->slots[i];
        if (!s->busy || s->rank > 0) continue;
        if (waits[k++].revents == 0) continue;
        if (farm_process_take(&s->process, &result))
            take_result(h, s, &result);
        else
            bury(h, s);
    }
}

static slot *slot_of(hall *h, int rank) {
    for (uint32_t i = 0; i < h->slot_count; i++)
        if (h->slots[i].rank == rank) return &h->slots[i];
    return NULL;
}

static void hear_ranks(hall *h) {
    farm_result result;
    int rank;
    bool heard = false;
    while (ranks_hear(&rank, &result)) {
        slot *s = slot_of(h, rank);
        heard = true;
        if (s && s->busy) take_result(h, s, &result);
    }
    for (uint32_t i = 0; i < h->slot_count; i++) {
        slot *s = &h->slots[i];
        if (s->rank == 0 || s->closed || ranks_silence(s->rank) < LONG_SILENCE) continue;
        char reason[FARM_SENTENCE];
        snprintf(reason, sizeof reason, "rank %d was not heard for %d s", s->rank, LONG_SILENCE);
        if (s->busy) fail_frame(h, s, reason);
        s->closed = h->run->lost = true;
    }
    if (!heard) ranks_nap();
}

static bool is_open(const hall *h) {
    for (uint32_t i = 0; i < h->slot_count; i++)
        if (!h->slots[i].closed) return true;
    return false;
}

bool farm_run_all(farm_run *run, const ranks *r) {
    const uint32_t others = (uint32_t)r->count - 1, wanted = others > 0 ? 1 : run->processes;
    const uint32_t here = wanted < run->todo_count || others > 0 ? wanted : run->todo_count;
    hall h = {.run = run, .slot_count = here + others, .begun = farm_now(), .told = farm_now()};
    h.slots = calloc(h.slot_count + 1, sizeof *h.slots);
    struct pollfd *waits = calloc(here + 1, sizeof *waits);
    if (!h.slots || !waits) return free(h.slots), free(waits), failure("no memory for the processes"), false;
    for (uint32_t i = 0; i < h.slot_count; i++)
        h.slots[i] = (slot){.process = {0, -1}, .rank = i < here ? 0 : (int)(i - here + 1)};
    h.bar = progress_start(run->todo_count, run->job->quiet);
    const double used = processor_time();
    while (is_open(&h)) {
        for (uint32_t i = 0; i < h.slot_count; i++)
            if (!h.slots[i].busy && !h.slots[i].closed) hand_out(&h, &h.slots[i]);
        hear_processes(&h, waits, others == 0);
        if (others > 0) hear_ranks(&h);
    }
    run->processor = processor_time() - used;
    progress_end(&h.bar);
    free(h.slots);
    free(waits);
    return true;
}

// ---- another rank ---------------------------------------------------------------------------------------------------

// Waits for the answer of the process, and says meanwhile that this rank lives.
static void wait_for(farm_run *run, farm_process *p, uint32_t frame, farm_result *result) {
    struct pollfd wait = {.fd = p->socket, .events = POLLIN};
    while (poll(&wait, 1, 500) <= 0) ranks_beat();
    if (farm_process_take(p, result)) return;
    *result = (farm_result){.frame = frame, .state = FARM_FAILED};
    farm_process_bury(p, run->job, frame, result->reason);
}

static void draw_frame(farm_run *run, farm_process *p, uint32_t frame) {
    farm_result result = {.frame = frame, .state = FARM_FAILED};
    if (p->pid == 0 && !farm_process_start(p, run->count, run->arguments, run->threads))
        snprintf(result.reason, sizeof result.reason, "%s", strerror(errno));
    else if (farm_process_give(p, frame))
        wait_for(run, p, frame, &result);
    else
        farm_process_bury(p, run->job, frame, result.reason);
    ranks_answer(&result);
}

bool farm_run_rank(farm_run *run) {
    farm_process process = {0, -1};
    uint32_t frame = 0;
    for (;;) {
        if (!ranks_take(&frame)) {
            ranks_beat();
            ranks_nap();
            continue;
        }
        if (frame == FARM_STOP) break;
        draw_frame(run, &process, frame);
    }
    farm_process_dismiss(&process);
    return true;
}

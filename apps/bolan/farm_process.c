// SPDX-License-Identifier: MIT
// See farm_process.h.
#include "farm_process.h"

#include "commands.h"
#include "farm_stage.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

extern char **environ;

double farm_now(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

// ---- bytes ----------------------------------------------------------------------------------------------------------

static bool send_all(int socket, const void *data, size_t size) {
    for (const char *at = data; size > 0;) {
        const ssize_t sent = send(socket, at, size, MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR) continue;
        if (sent <= 0) return false;
        at += sent, size -= (size_t)sent;
    }
    return true;
}

static bool receive_all(int socket, void *data, size_t size) {
    for (char *at = data; size > 0;) {
        const ssize_t got = recv(socket, at, size, 0);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return false;
        at += got, size -= (size_t)got;
    }
    return true;
}

// ---- the side that hands out ----------------------------------------------------------------------------------------

bool farm_process_start(farm_process *p, int count, char **arguments, uint32_t threads) {
    int ends[2];
    char number[16], amount[32];
    *p = (farm_process){0, -1};
    char **list = calloc((size_t)count + 5, sizeof *list);
    if (!list || socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends)) return free(list), false;
    fcntl(ends[1], F_SETFD, 0);
    snprintf(number, sizeof number, "%d", ends[1]);
    snprintf(amount, sizeof amount, "--threads=%u", (unsigned)threads);
    char verb[] = "worker", program[] = "bolan";
    list[0] = program, list[1] = verb, list[2] = number, list[3] = amount;
    for (int i = 0; i < count; i++) list[4 + i] = arguments[i]; // of which --threads replaces the one above
    // Software OpenGL has threads of its own.
    setenv("LP_NUM_THREADS", amount + strlen("--threads="), 0);
    const int failed = posix_spawn(&p->pid, "/proc/self/exe", NULL, NULL, list, environ);
    free(list);
    close(ends[1]);
    p->socket = ends[0];
    if (!failed) return true;
    close(ends[0]);
    *p = (farm_process){0, -1};
    errno = failed;
    return false;
}

bool farm_process_give(const farm_process *p, uint32_t frame) { return send_all(p->socket, &frame, sizeof frame); }

bool farm_process_take(const farm_process *p, farm_result *result) {
    return receive_all(p->socket, result, sizeof *result);
}

static void wait_for(farm_process *p, int *status) {
    *status = 0;
    while (waitpid(p->pid, status, 0) < 0 && errno == EINTR) continue;
    if (p->socket >= 0) close(p->socket);
}

void farm_process_bury(farm_process *p, const farm_job *job, uint32_t frame, char reason[FARM_SENTENCE]) {
    int status;
    char path[BOLAN_PATH_MAX], unfinished[BOLAN_PATH_MAX + 32];
    wait_for(p, &status);
    if (WIFSIGNALED(status))
        snprintf(reason, FARM_SENTENCE, "its process was ended by signal %d", WTERMSIG(status));
    else
        snprintf(reason, FARM_SENTENCE, "its process ended with code %d", WEXITSTATUS(status));
    // What bolan_file_write() had begun.
    for (farm_file f = FARM_FILE_PICTURE; f < FARM_FILES; f++) {
        if (!farm_job_file(job, frame, f, path)) continue;
        snprintf(unfinished, sizeof unfinished, "%s.part%ld", path, (long)p->pid);
        unlink(unfinished);
    }
    *p = (farm_process){0, -1};
}

void farm_process_dismiss(farm_process *p) {
    int status;
    if (p->pid == 0) return;
    close(p->socket);
    p->socket = -1;
    wait_for(p, &status);
    *p = (farm_process){0, -1};
}

// ---- the side that draws --------------------------------------------------------------------------------------------

static farm_result *answer; // of the frame in hand, for what is logged meanwhile

static void keep_sentence(void *user, bolan_log_level level, bolan_log_id id, const char *sentence) {
    (void)user, (void)id;
    char *to = level == BOLAN_LOG_ERROR ? answer->reason : answer->warning;
    if (level == BOLAN_LOG_INFO || to[0]) return;
    memcpy(to, sentence, bolan_text_fit(sentence, FARM_SENTENCE - 1));
}

static void work(const farm_job *job, int socket) {
    farm_result result = {.frame = 0};
    farm_stage *stage = NULL;
    uint32_t frame;
    answer = &result;
    bolan_set_hooks(&(bolan_hooks){.log = keep_sentence});
    while (receive_all(socket, &frame, sizeof frame)) {
        memset(&result, 0, sizeof result);
        if (!stage) stage = farm_stage_open(job);
        const double begun = farm_now();
        const bool done = stage && farm_stage_draw(stage, frame, &result);
        result.draw = farm_now() - begun;
        result.frame = frame;
        result.state = done ? FARM_DONE : FARM_FAILED;
        if (!done && !result.reason[0]) snprintf(result.reason, FARM_SENTENCE, "no reason was given");
        if (!send_all(socket, &result, sizeof result)) break;
    }
    farm_stage_close(&stage);
}

int command_farm_worker(int count, char **arguments) {
    double number = -1.0;
    if (count < 1 || !bolan_parse_number(arguments[0], strlen(arguments[0]), &number) || number < 3.0)
        return usage_error("worker is started by bolan farm alone");
    prctl(PR_SET_PDEATHSIG, SIGTERM); // nobody to draw for
    options o;
    farm_job job;
    int result = options_parse(ON_FARM, "farm", count - 1, arguments + 1, &o);
    if (result) return result;
    result = farm_job_read(&o, &job);
    if (!result) work(&job, (int)number);
    farm_job_free(&job);
    return result;
}

// SPDX-License-Identifier: MIT
// Video: raw frames through a pipe into the program ffmpeg.
//
//     this process ---- rgb24 frames --------> ffmpeg's stdin  (a pipe)
//     this process <--- its complaints ------- ffmpeg's stderr (a temporary file: neither waits for the other)
//
// Without the program, no video; it is started directly, without a shell, and the film appears under its name at the
// end.
#include "io/file.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

struct bolan_video {
    char path[BOLAN_PATH_MAX];
    char temporary[FILE_NAME_CAPACITY];
    size_t frame_bytes;
    pid_t process;
    int input;      // the pipe's writing end
    FILE *messages; // what ffmpeg prints
    bool failed;    // a sentence was logged
};

// ---- the child ------------------------------------------------------------------------------------------------------

enum { NOT_FOUND = 127 };

// Everything the child needs, made before the fork: after it only exec is safe, for other threads may hold locks.
typedef struct command {
    char size[32], rate[32], output[FILE_NAME_CAPACITY + 8];
    const char *arguments[48]; // NULL at the end
} command;

static void add(command *c, const char *const *words) {
    size_t n = 0;
    while (c->arguments[n]) n++;
    for (; *words; words++) c->arguments[n++] = *words;
}

static void make_command(command *c, const bolan_video *video, uint32_t width, uint32_t height, double fps, bool webm) {
    memset(c, 0, sizeof *c);
    snprintf(c->size, sizeof c->size, "%ux%u", (unsigned)width, (unsigned)height);
    snprintf(c->rate, sizeof c->rate, "%.6f", fps);
    snprintf(c->output, sizeof c->output, "file:%s",
             video->temporary); // a name with '-' in front or a ':' stays a name
    static const char *const mp4[] = {"-c:v",      "libx264",    "-preset", "medium", "-crf", "18",
                                      "-movflags", "+faststart", "-f",      "mp4",    NULL};
    static const char *const webm_codec[] = {"-c:v",    "libvpx-vp9", "-b:v", "0",    "-crf", "28",
                                             "-row-mt", "1",          "-f",   "webm", NULL};
    const char *const input[] = {"ffmpeg", "-nostdin", "-hide_banner", "-loglevel", "error", "-y",
                                 "-f",     "rawvideo", "-pix_fmt",     "rgb24",     "-s",    c->size,
                                 "-r",     c->rate,    "-i",           "pipe:0",    "-an",   NULL};
    // The picture is sRGB; say so, and convert by the matrix that players assume for it.
    static const char *const colour[] = {"-vf",
                                         "scale=out_color_matrix=bt709:out_range=tv",
                                         "-colorspace",
                                         "bt709",
                                         "-color_primaries",
                                         "bt709",
                                         "-color_trc",
                                         "iec61966-2-1",
                                         "-pix_fmt",
                                         "yuv420p",
                                         NULL};
    const char *const output[] = {c->output, NULL};
    add(c, input);
    add(c, colour);
    add(c, webm ? webm_codec : mp4);
    add(c, output);
}

static void become_ffmpeg(const command *c, int input, int sink, int messages) {
    if (dup2(input, STDIN_FILENO) < 0 || dup2(sink, STDOUT_FILENO) < 0 || dup2(messages, STDERR_FILENO) < 0)
        _exit(NOT_FOUND - 1);
    // An interrupt on the terminal goes to the whole group; ffmpeg must wait for the parent's decision.
    signal(SIGINT, SIG_IGN);
    execvp("ffmpeg", (char *const *)(uintptr_t)c->arguments);
    _exit(NOT_FOUND);
}

// ---- errors ---------------------------------------------------------------------------------------------------------

// The last line that ffmpeg printed.
static void last_message(FILE *messages, char *out, size_t capacity) {
    char line[512];
    out[0] = '\0';
    rewind(messages);
    while (fgets(line, sizeof line, messages)) {
        line[strcspn(line, "\r\n")] = '\0';
        if (line[0] != '\0') snprintf(out, capacity, "%s", line);
    }
}

static bolan_result report_exit(bolan_video *video, int status) {
    const bool missing = WIFEXITED(status) && WEXITSTATUS(status) == NOT_FOUND;
    char message[512];
    last_message(video->messages, message, sizeof message);
    if (missing) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_VIDEO_PROGRAM,
                  "%s: the program ffmpeg was not found; install it (package ffmpeg), or write numbered pictures",
                  video->path);
    } else {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_VIDEO_WRITE, "%s: ffmpeg failed: %s", video->path,
                  message[0] ? message : "it ended early without a message");
    }
    video->failed = true;
    return missing ? BOLAN_ERROR_UNSUPPORTED : BOLAN_ERROR_IO;
}

static int wait_for(pid_t process) {
    int status = 0;
    while (waitpid(process, &status, 0) < 0 && errno == EINTR) continue;
    return status;
}

// ---- frames ---------------------------------------------------------------------------------------------------------

// Writes it all. A pipe whose reader has gone raises SIGPIPE, which would end the caller's program: it is held back in
// this thread and, if it came, taken off again.
static bool write_quietly(int file, const uint8_t *data, size_t size) {
    sigset_t pipe_signal, before;
    sigemptyset(&pipe_signal);
    sigaddset(&pipe_signal, SIGPIPE);
    pthread_sigmask(SIG_BLOCK, &pipe_signal, &before);
    bool ok = true;
    while (size > 0 && ok) {
        const ssize_t written = write(file, data, size);
        ok = written > 0 || (written < 0 && errno == EINTR);
        if (written > 0) data += written, size -= (size_t)written;
    }
    if (!ok) {
        const struct timespec now = {0, 0};
        while (sigtimedwait(&pipe_signal, NULL, &now) < 0 && errno == EINTR) continue;
    }
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    return ok;
}

bolan_result bolan_video_write(bolan_video *video, const uint8_t *rgb) {
    BOLAN_ASSERT(video && rgb);
    if (video->failed) return BOLAN_ERROR_IO;
    if (write_quietly(video->input, rgb, video->frame_bytes)) return BOLAN_OK;
    close(video->input);
    video->input = -1;
    const int status = wait_for(video->process);
    video->process = -1;
    return report_exit(video, status);
}

bolan_result bolan_video_close(bolan_video **handle, bool keep) {
    BOLAN_ASSERT(handle);
    bolan_video *video = *handle;
    if (!video) return BOLAN_OK;
    *handle = NULL;
    if (video->input >= 0) close(video->input); // the end of the stream
    if (!keep && video->process > 0) kill(video->process, SIGKILL);
    const int status = video->process > 0 ? wait_for(video->process) : 0;
    bolan_result result = video->failed ? BOLAN_ERROR_IO : BOLAN_OK;
    if (keep && !video->failed && status != 0) result = report_exit(video, status);
    const bolan_result finished = file_finish(video->temporary, video->path, keep && !result);
    if (video->messages) fclose(video->messages);
    bolan_release(video, sizeof *video);
    return result ? result : finished;
}

// ---- opening --------------------------------------------------------------------------------------------------------

static bool has_suffix(const char *path, const char *suffix) {
    const size_t length = strlen(path), tail = strlen(suffix);
    return length > tail && strcmp(path + length - tail, suffix) == 0;
}

static bolan_result check(const char *path, uint32_t width, uint32_t height, double fps) {
    const char *wrong = NULL;
    if (!has_suffix(path, ".mp4") && !has_suffix(path, ".webm")) {
        wrong = "a video's name ends in .mp4 or .webm";
    } else if (width < 16 || width > 16384 || height < 16 || height > 16384 || width % 2 != 0 || height % 2 != 0) {
        wrong = "a video's width and height are even numbers from 16 to 16384";
    } else if (!(fps >= 1.0 && fps <= 240.0)) {
        wrong = "a video has 1 to 240 frames a second";
    }
    if (!wrong) return BOLAN_OK;
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_BAD_ARGUMENT, "%s: %s", path, wrong);
    return BOLAN_ERROR_ARGUMENT;
}

// The program is searched for before any work is done for it.
static bool program_exists(const char *name) {
    const char *folders = getenv("PATH");
    char path[BOLAN_PATH_MAX];
    for (const char *p = folders ? folders : "/usr/bin:/bin"; *p;) {
        const size_t length = strcspn(p, ":");
        snprintf(path, sizeof path, "%.*s/%s", (int)length, p, name);
        if (access(path, X_OK) == 0) return true;
        p += length + (p[length] == ':');
    }
    return false;
}

static bool start(bolan_video *video, uint32_t width, uint32_t height, double fps) {
    int ends[2];
    command c;
    make_command(&c, video, width, height, fps, has_suffix(video->path, ".webm"));
    const int sink = open("/dev/null", O_WRONLY);
    video->messages = tmpfile();
    const bool ready = sink >= 0 && video->messages && pipe(ends) == 0;
    if (ready) {
        fcntl(ends[1], F_SETFD, FD_CLOEXEC); // or ffmpeg would never see the end of its input
        video->process = fork();
        if (video->process == 0) become_ffmpeg(&c, ends[0], sink, fileno(video->messages));
        close(ends[0]);
        video->input = ends[1];
    }
    if (sink >= 0) close(sink);
    return ready && video->process > 0;
}

bolan_result bolan_video_open(const char *path, uint32_t width, uint32_t height, double fps, bolan_video **out) {
    BOLAN_ASSERT(path && out);
    *out = NULL;
    if (check(path, width, height, fps)) return BOLAN_ERROR_ARGUMENT;
    if (bolan_file_check_writable(path)) return BOLAN_ERROR_IO;
    if (!program_exists("ffmpeg")) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_VIDEO_PROGRAM,
                  "%s: the program ffmpeg was not found; install it (package ffmpeg), or write numbered pictures",
                  path);
        return BOLAN_ERROR_UNSUPPORTED;
    }
    bolan_video *video = bolan_allocate(sizeof *video);
    if (!video) return BOLAN_ERROR_MEMORY;
    snprintf(video->path, sizeof video->path, "%s", path);
    video->frame_bytes = (size_t)width * height * 3;
    video->input = -1;
    video->process = -1;
    if (file_temporary_name(path, video->temporary) || !start(video, width, height, fps)) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_VIDEO_PROGRAM, "%s: ffmpeg could not be started: %s", path,
                  strerror(errno));
        bolan_video_close(&video, false);
        return BOLAN_ERROR_IO;
    }
    *out = video;
    return BOLAN_OK;
}

// SPDX-License-Identifier: MIT
// Video: raw frames through a pipe into the program ffmpeg.
//
//     this process ---- rgb24 frames --------> ffmpeg's stdin  (a pipe)
//     this process <--- messages ------------- ffmpeg's stderr (a temporary file, so neither side blocks)
//
// ffmpeg is started directly, without a shell. The film is renamed to its name at the end.
//
// The exit code of ffmpeg is not sufficient: with a full disk it is 0, and the film is half written. A film is complete
// when the code is 0, ffmpeg printed no message, and the container is complete (film_check.c).
#include "io/file.h"
#include "io/film_check.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

struct bolan_video {
    file_output output;
    bool webm;
    size_t frame_bytes;
    pid_t process;
    int input;      // the pipe's writing end
    FILE *messages; // of ffmpeg
    bool failed;    // a sentence was logged
};

// ---- the child ------------------------------------------------------------------------------------------------------

enum { NOT_FOUND = 127 };

// All data of the child are made before the fork. After it only exec is safe, because other threads may hold locks.
typedef struct command {
    char size[32], rate[32], output[FILE_NAME_CAPACITY + 8];
    const char *arguments[48]; // NULL at the end
} command;

static void add(command *c, const char *const *words) {
    size_t n = 0;
    while (c->arguments[n]) n++;
    for (; *words; words++) c->arguments[n++] = *words;
}

static void make_command(command *c, const bolan_video *video, uint32_t width, uint32_t height, double fps) {
    memset(c, 0, sizeof *c);
    snprintf(c->size, sizeof c->size, "%ux%u", (unsigned)width, (unsigned)height);
    bolan_format(c->rate, sizeof c->rate, "%.6f", fps);
    // "file:" keeps a name that begins with '-' or holds a ':' a name.
    snprintf(c->output, sizeof c->output, "file:%s", video->output.temporary);
    static const char *const mp4[] = {"-c:v",      "libx264",    "-preset", "medium", "-crf", "18",
                                      "-movflags", "+faststart", "-f",      "mp4",    NULL};
    static const char *const webm_codec[] = {"-c:v",    "libvpx-vp9", "-b:v", "0",    "-crf", "28",
                                             "-row-mt", "1",          "-f",   "webm", NULL};
    const char *const input[] = {"ffmpeg", "-nostdin", "-hide_banner", "-loglevel", "error", "-xerror", "-y",
                                 "-f",     "rawvideo", "-pix_fmt",     "rgb24",     "-s",    c->size,   "-r",
                                 c->rate,  "-i",       "pipe:0",       "-an",       NULL};
    // The image is sRGB: tag it so, and convert by the matrix that players assume for sRGB.
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
    add(c, video->webm ? webm_codec : mp4);
    add(c, output);
}

static void become_ffmpeg(const command *c, int input, int sink, int messages, const sigset_t *mask) {
    if (dup2(input, STDIN_FILENO) < 0 || dup2(sink, STDOUT_FILENO) < 0 || dup2(messages, STDERR_FILENO) < 0)
        _exit(NOT_FOUND - 1);
    // A separate process group: the parent handles an interrupt of the terminal, and children of ffmpeg end with it.
    setpgid(0, 0);
    static const int reset[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE};
    for (size_t i = 0; i < sizeof reset / sizeof *reset; i++) signal(reset[i], SIG_DFL);
    signal(SIGXFSZ, SIG_IGN); // ffmpeg then reports a file size limit as an error
    sigprocmask(SIG_SETMASK, mask, NULL);
    execvp("ffmpeg", (char *const *)(uintptr_t)c->arguments);
    _exit(NOT_FOUND);
}

// ---- errors ---------------------------------------------------------------------------------------------------------

// The first line that ffmpeg printed, which states the cause; later lines are consequences. The prefix of the module,
// "[mp4 @ 0x55d0c8] ", is left out.
static void first_message(FILE *messages, char *out, size_t capacity) {
    char line[512];
    out[0] = '\0';
    rewind(messages);
    while (!out[0] && fgets(line, sizeof line, messages)) {
        line[strcspn(line, "\r\n")] = '\0';
        const char *address = strstr(line, " @ 0x"), *end = address ? strstr(address, "] ") : NULL;
        snprintf(out, capacity, "%s", line[0] == '[' && end ? end + 2 : line);
    }
}

static bolan_result report_missing(const char *path) {
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_VIDEO_PROGRAM,
              "%s: the program ffmpeg was not found; install it (package ffmpeg), or write numbered pictures", path);
    return BOLAN_ERROR_UNSUPPORTED;
}

static bolan_result report_failure(bolan_video *video, const char *reason) {
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_VIDEO_WRITE, "%s: ffmpeg failed: %s", video->output.path, reason);
    video->failed = true;
    return BOLAN_ERROR_IO;
}

// The result of ffmpeg after its end. @p finished: ffmpeg was asked to finish the film.
static bolan_result judge(bolan_video *video, int status, bool finished) {
    char message[512];
    if (WIFEXITED(status) && WEXITSTATUS(status) == NOT_FOUND) {
        video->failed = true;
        return report_missing(video->output.path);
    }
    first_message(video->messages, message, sizeof message);
    if (message[0]) return report_failure(video, message);
    if (status != 0 || !finished) return report_failure(video, "it ended early without a message");
    const char *wrong = bolan_film_check(video->output.temporary, video->webm);
    return wrong ? report_failure(video, wrong) : BOLAN_OK;
}

static int wait_for(bolan_video *video) {
    int status = 0;
    while (waitpid(video->process, &status, 0) < 0 && errno == EINTR) continue;
    bolan_unfinished_reclaim(&video->output.entry); // the process number may be reused
    video->process = -1;
    bolan_unfinished_own(&video->output.entry, 0);
    return status;
}

// ---- frames ---------------------------------------------------------------------------------------------------------

bolan_result bolan_video_write(bolan_video *video, const uint8_t *rgb) {
    BOLAN_ASSERT(video && rgb);
    if (video->failed) return BOLAN_ERROR_IO;
    if (bolan_file_write_all(video->input, rgb, video->frame_bytes)) return BOLAN_OK;
    close(video->input);
    video->input = -1;
    return judge(video, wait_for(video), false);
}

bolan_result bolan_video_close(bolan_video **handle, bool keep) {
    BOLAN_ASSERT(handle);
    bolan_video *video = *handle;
    if (!video) return BOLAN_OK;
    *handle = NULL;
    if (video->input >= 0) close(video->input); // the end of the stream
    if (!keep && video->process > 0) kill(-video->process, SIGKILL);
    bolan_result result = video->failed ? BOLAN_ERROR_IO : BOLAN_OK;
    if (video->process > 0) {
        const int status = wait_for(video);
        if (keep && !result) result = judge(video, status, true);
    }
    const bolan_result finished = bolan_file_output_finish(&video->output, keep && !result);
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
    struct stat status;
    if (!has_suffix(path, ".mp4") && !has_suffix(path, ".webm")) {
        wrong = "a video's name ends in .mp4 or .webm";
    } else if (width < 16 || width > 16384 || height < 16 || height > 16384 || width % 2 != 0 || height % 2 != 0) {
        wrong = "a video's width and height are even numbers from 16 to 16384";
    } else if (!(fps >= 1.0 && fps <= 240.0)) {
        wrong = "a video has 1 to 240 frames a second";
    } else if (stat(path, &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode)) {
        wrong = "a video cannot go into a device or pipe, for its index is written last; expected the name of a file";
    }
    if (!wrong) return BOLAN_OK;
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_BAD_ARGUMENT, "%s: %s", path, wrong);
    return BOLAN_ERROR_ARGUMENT;
}

// Whether the program is in PATH, checked before any work.
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

bolan_result bolan_video_check(const char *path, uint32_t width, uint32_t height, double fps) {
    BOLAN_ASSERT(path);
    if (check(path, width, height, fps)) return BOLAN_ERROR_ARGUMENT;
    if (bolan_file_check_writable(path)) return BOLAN_ERROR_IO;
    return program_exists("ffmpeg") ? BOLAN_OK : report_missing(path);
}

static bool start(bolan_video *video, uint32_t width, uint32_t height, double fps) {
    int ends[2];
    command c;
    make_command(&c, video, width, height, fps);
    const int sink = open("/dev/null", O_WRONLY | O_CLOEXEC);
    video->messages = tmpfile();
    const bool ready = sink >= 0 && video->messages && pipe(ends) == 0;
    if (ready) {
        fcntl(ends[1], F_SETFD, FD_CLOEXEC); // ffmpeg must see the end of its input
        unfinished *entry = &video->output.entry;
        bolan_unfinished_reclaim(entry);
        video->process = fork();
        if (video->process == 0) become_ffmpeg(&c, ends[0], sink, fileno(video->messages), &entry->before);
        const int reason = errno;
        if (video->process > 0)
            setpgid(video->process, video->process); // parent and child both set it, in either order
        bolan_unfinished_own(entry, video->process > 0 ? video->process : 0);
        close(ends[0]);
        video->input = ends[1];
        errno = reason;
    }
    if (sink >= 0) close(sink);
    return ready && video->process > 0;
}

bolan_result bolan_video_open(const char *path, uint32_t width, uint32_t height, double fps, bolan_video **out) {
    BOLAN_ASSERT(path && out);
    *out = NULL;
    bolan_result result = bolan_video_check(path, width, height, fps);
    if (result) return result;
    bolan_video *video = bolan_allocate(sizeof *video);
    if (!video) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY, "%s: no memory for the video", path);
        return BOLAN_ERROR_MEMORY;
    }
    video->webm = has_suffix(path, ".webm");
    video->frame_bytes = (size_t)width * height * 3;
    video->input = -1;
    video->process = -1;
    result = bolan_file_output_open(path, &video->output);
    if (!result && !start(video, width, height, fps)) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_VIDEO_PROGRAM, "%s: ffmpeg could not be started: %s", path,
                  strerror(errno));
        result = BOLAN_ERROR_IO;
    }
    if (result) {
        bolan_video_close(&video, false);
        return result;
    }
    *out = video;
    return BOLAN_OK;
}

// SPDX-License-Identifier: MIT
// Films: what ffprobe finds in them, and every way in which ffmpeg can fail.
#include "bolan/io.h"
#include "io_support.h"

#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { WIDTH = 64, HEIGHT = 36 };

static uint8_t picture[WIDTH * HEIGHT * 3];
static char folder[64], *old_path;

// A folder with a program bin/ffmpeg in it, which a test writes.
static int enter(void **state) {
    (void)state;
    char path[4096];
    snprintf(folder, sizeof folder, "film_%ld", (long)getpid());
    if (mkdir(folder, 0755) || chdir(folder) || mkdir("bin", 0755)) return 1;
    old_path = strdup(getenv("PATH"));
    snprintf(path, sizeof path, "bin:%s", old_path);
    for (int i = 0; i < WIDTH * HEIGHT * 3; i++) picture[i] = (uint8_t)(i * 7 + i / 191);
    return setenv("PATH", path, 1);
}

static int leave(void **state) {
    (void)state;
    char command[96];
    setenv("PATH", old_path, 1);
    free(old_path);
    if (chdir("..")) return 1;
    snprintf(command, sizeof command, "rm -rf %s", folder);
    return system(command);
}

static void put_ffmpeg(const char *script) {
    write_text("bin/ffmpeg", script);
    chmod("bin/ffmpeg", 0755);
}

static bool is_alone(void) { return system("[ \"$(ls -A)\" = bin ]") == 0; }

// Opens, writes frames until one fails, and closes.
static bolan_result make_film(const char *path, double fps, int frames) {
    bolan_video *video = NULL;
    bolan_result result = bolan_video_open(path, WIDTH, HEIGHT, fps, &video);
    for (int i = 0; i < frames && !result; i++) {
        memset(picture, 40 * i + 10, sizeof picture / 2);
        result = bolan_video_write(video, picture);
    }
    const bolan_result closed = bolan_video_close(&video, true);
    return result ? result : closed;
}

static void probe(const char *path, const char *entry, char out[64]) {
    char command[256];
    snprintf(command, sizeof command,
             "ffprobe -v error -count_frames -select_streams v -show_entries stream=%s -of csv=p=0 %s", entry, path);
    FILE *pipe = popen(command, "r");
    assert_non_null(pipe);
    if (!fgets(out, 64, pipe)) out[0] = '\0';
    out[strcspn(out, "\n")] = '\0';
    pclose(pipe);
}

static void films_have_their_rate_size_and_frames(void **state) {
    (void)state;
    static const char *const names[] = {"a.mp4", "a.webm"};
    char found[64];
    for (int i = 0; i < 2; i++) {
        assert_int_equal(make_film(names[i], 12.5, 5), BOLAN_OK);
        probe(names[i], "width,height", found);
        assert_string_equal(found, "64,36");
        probe(names[i], "r_frame_rate", found);
        assert_string_equal(found, "25/2");
        probe(names[i], "nb_read_frames", found);
        assert_string_equal(found, "5");
        remove(names[i]);
    }
    assert_int_equal(make_film("b.mp4", 29.97, 2), BOLAN_OK);
    probe("b.mp4", "r_frame_rate", found);
    assert_string_equal(found, "2997/100");
    remove("b.mp4");
    assert_true(is_alone());
}

// A disk that fills: as ffmpeg 5 does, with exit code 0 and a file without an end.
static void a_film_that_is_cut_off_is_an_error(void **state) {
    (void)state;
    static const char *const names[] = {"a.mp4", "a.webm"};
    struct rlimit before;
    getrlimit(RLIMIT_FSIZE, &before);
    for (int i = 0; i < 2; i++)
        for (rlim_t limit = 64; limit <= 1024; limit *= 4) {
            setrlimit(RLIMIT_FSIZE, &(struct rlimit){limit, before.rlim_max});
            error_count = 0;
            const bolan_result result = make_film(names[i], 30, 8);
            setrlimit(RLIMIT_FSIZE, &before);
            assert_int_equal(result, BOLAN_ERROR_IO);
            assert_int_equal(error_count, 1);
            assert_non_null(strstr(last_sentence, ": ffmpeg failed: "));
            assert_true(is_alone());
        }
}

// Code 0, and yet no film. The sentence is about the file.
static void success_of_ffmpeg_is_not_believed(void **state) {
    (void)state;
    char name[32], script[512];
    static const struct {
        const char *write, *words;
    } ways[] = {
        {"", "it left an empty file"},
        {"rm \"$f\"", "it left no file"},
        {"printf 'half a film' > \"$f\"", "the file is cut off"},
        {"printf '\\0\\0\\0\\010free\\0\\0\\0\\010mdat' > \"$f\"", "the film has no index"},
        {"printf '\\0\\0\\0\\010moov\\0\\0\\0\\011mdat' > \"$f\"", "the file is cut off"},
        {"printf '\\0\\0\\0\\001moov\\0\\0\\0\\0\\0\\0\\0\\020\\0\\0\\0\\010mdat' > \"$f\"; echo oh >&2", "failed: oh"},
    };
    for (size_t i = 0; i < sizeof ways / sizeof *ways; i++) {
        snprintf(script, sizeof script, "#!/bin/sh\nfor f; do :; done\nf=${f#file:}\ncat > /dev/null\n%s\nexit 0\n",
                 ways[i].write);
        put_ffmpeg(script);
        snprintf(name, sizeof name, "way%d.mp4", (int)i);
        assert_refusal(make_film(name, 30, 2), BOLAN_ERROR_IO, BOLAN_LOG_VIDEO_WRITE, ways[i].words);
        assert_true(is_alone());
    }
    // The smallest files that count as whole.
    put_ffmpeg("#!/bin/sh\nfor f; do :; done\ncat > /dev/null\n"
               "printf '\\0\\0\\0\\010moov\\0\\0\\0\\001mdat\\0\\0\\0\\0\\0\\0\\0\\021x' > \"${f#file:}\"\n");
    assert_int_equal(make_film("whole.mp4", 30, 2), BOLAN_OK);
    put_ffmpeg("#!/bin/sh\nfor f; do :; done\ncat > /dev/null\n"
               "printf '\\032\\105\\337\\243\\201x\\030\\123\\200\\147\\100\\002yz' > \"${f#file:}\"\n");
    assert_int_equal(make_film("whole.webm", 30, 2), BOLAN_OK);
    // Bytes behind the segment: it was not closed.
    put_ffmpeg("#!/bin/sh\nfor f; do :; done\ncat > /dev/null\n"
               "printf '\\032\\105\\337\\243\\201x\\030\\123\\200\\147\\100\\002yzz' > \"${f#file:}\"\n");
    assert_refusal(make_film("more.webm", 30, 2), BOLAN_ERROR_IO, BOLAN_LOG_VIDEO_WRITE, "the file is cut off");
    // A segment of unknown size is one that nobody came back to.
    put_ffmpeg("#!/bin/sh\nfor f; do :; done\ncat > /dev/null\n"
               "printf '\\032\\105\\337\\243\\201x\\030\\123\\200\\147\\377yz' > \"${f#file:}\"\n");
    assert_refusal(make_film("cut.webm", 30, 2), BOLAN_ERROR_IO, BOLAN_LOG_VIDEO_WRITE, "the file is cut off");
}

static void the_first_line_of_ffmpeg_is_the_cause(void **state) {
    (void)state;
    put_ffmpeg("#!/bin/sh\necho '[mp4 @ 0x55d0c8] No space left' >&2\necho 'Conversion failed!' >&2\nexit 1\n");
    error_count = 0;
    assert_int_equal(make_film("a.mp4", 30, 1000), BOLAN_ERROR_IO);
    assert_string_equal(last_sentence, "a.mp4: ffmpeg failed: No space left");
    assert_int_equal(error_count, 1);
    put_ffmpeg("#!/bin/sh\nprintf 'red \\033[31m' >&2\nexit 1\n");
    assert_int_equal(make_film("a.mp4", 30, 1000), BOLAN_ERROR_IO);
    assert_string_equal(last_sentence, "a.mp4: ffmpeg failed: red \\x1b[31m");
    put_ffmpeg("#!/bin/sh\nexit 3\n");
    assert_int_equal(make_film("a.mp4", 30, 1000), BOLAN_ERROR_IO);
    assert_string_equal(last_sentence, "a.mp4: ffmpeg failed: it ended early without a message");
    assert_true(is_alone());
}

static void abandon(int signal_number) {
    (void)signal_number;
    bolan_files_abandon();
    _exit(77);
}

// What the script below has started ended with it, if perhaps it is not yet collected.
static void assert_sleeper_is_dead(void) {
    int sleeper = 0;
    FILE *file = fopen("sleeper", "r");
    assert_true(file && fscanf(file, "%d", &sleeper) == 1 && sleeper > 1);
    fclose(file);
    char command[96];
    snprintf(command, sizeof command, "case $(ps -o stat= -p %d) in ''|Z*) ;; *) exit 1 ;; esac", sleeper);
    assert_int_equal(system(command), 0);
}

static void wait_for_sleeper(void) {
    for (int i = 0; i < 500 && access("sleeper", R_OK) != 0; i++) nanosleep(&(struct timespec){0, 20000000}, NULL);
    nanosleep(&(struct timespec){0, 100000000}, NULL);
}

static void a_film_that_is_thrown_away_ends_ffmpeg(void **state) {
    (void)state;
    put_ffmpeg("#!/bin/sh\nsleep 60 &\necho $! > sleeper\nwait\n");
    bolan_video *video = NULL;
    assert_int_equal(bolan_video_open("a.mp4", WIDTH, HEIGHT, 30, &video), BOLAN_OK);
    wait_for_sleeper();
    const time_t before = time(NULL);
    assert_int_equal(bolan_video_close(&video, false), BOLAN_OK);
    assert_true(time(NULL) - before <= 2 && !video);
    assert_sleeper_is_dead();
    remove("sleeper");
    assert_true(is_alone());
}

// ffmpeg neither reads nor ends, and neither does what it has started.
static void an_interrupt_ends_an_ffmpeg_that_hangs(void **state) {
    (void)state;
    put_ffmpeg("#!/bin/sh\nsleep 60 &\necho $! > sleeper\nwait\n");
    const pid_t child = fork();
    if (child == 0) {
        signal(SIGHUP, abandon);
        make_film("a.mp4", 30, 1 << 20); // stops at a full pipe
        _exit(0);
    }
    wait_for_sleeper();
    const time_t before = time(NULL);
    kill(child, SIGHUP);
    kill(child, SIGHUP); // twice does not matter
    int status = 0;
    waitpid(child, &status, 0);
    assert_true(time(NULL) - before <= 2);
    assert_true(WIFEXITED(status) && WEXITSTATUS(status) == 77);
    assert_sleeper_is_dead();
    remove("sleeper");
    assert_true(is_alone());
}

static void a_film_that_cannot_be_is_found_before_the_work(void **state) {
    (void)state;
    assert_int_equal(bolan_video_check("a.mp4", WIDTH, HEIGHT, 30), BOLAN_OK);
    assert_true(is_alone());
    assert_refusal(bolan_video_check("no/a.mp4", WIDTH, HEIGHT, 30), BOLAN_ERROR_IO, BOLAN_LOG_FILE_WRITE, "no/a.mp4");
    assert_refusal(bolan_video_check("a.mp4", WIDTH, HEIGHT, 0.5), BOLAN_ERROR_ARGUMENT, BOLAN_LOG_BAD_ARGUMENT,
                   "a.mp4");
    setenv("PATH", "/nowhere", 1);
    assert_refusal(bolan_video_check("a.mp4", WIDTH, HEIGHT, 30), BOLAN_ERROR_UNSUPPORTED, BOLAN_LOG_VIDEO_PROGRAM,
                   "the program ffmpeg was not found");
    setenv("PATH", old_path, 1);
    assert_true(is_alone());
}

#define IN_FOLDER(test) cmocka_unit_test_setup_teardown(test, enter, leave)

int main(void) {
    const struct CMUnitTest tests[] = {
        IN_FOLDER(films_have_their_rate_size_and_frames),
        IN_FOLDER(a_film_that_is_cut_off_is_an_error),
        IN_FOLDER(success_of_ffmpeg_is_not_believed),
        IN_FOLDER(the_first_line_of_ffmpeg_is_the_cause),
        IN_FOLDER(a_film_that_is_thrown_away_ends_ffmpeg),
        IN_FOLDER(an_interrupt_ends_an_ffmpeg_that_hangs),
        IN_FOLDER(a_film_that_cannot_be_is_found_before_the_work),
    };
    return cmocka_run_group_tests(tests, listen_to_log, NULL);
}

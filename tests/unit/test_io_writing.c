// SPDX-License-Identifier: MIT
// Where files end up: links, modes, pipes, long names, limits; and what bolan_files_abandon() clears away.
#include "bolan/io.h"
#include "io_support.h"

#include <dirent.h>
#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

static char folder[64];

static int enter(void **state) {
    (void)state;
    snprintf(folder, sizeof folder, "writing_%ld", (long)getpid());
    return mkdir(folder, 0755) || chdir(folder);
}

static int leave(void **state) {
    (void)state;
    char command[192];
    if (chdir("..")) return 1;
    snprintf(command, sizeof command, "chmod -R u+w %s && rm -rf %s", folder, folder);
    return system(command);
}

static int entries(void) {
    int count = 0;
    DIR *d = opendir(".");
    for (struct dirent *e; d && (e = readdir(d)) != NULL;) count += e->d_name[0] != '.';
    if (d) closedir(d);
    return count;
}

static void assert_holds(const char *path, const char *text) {
    char found[64] = "";
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    found[fread(found, 1, sizeof found - 1, file)] = '\0';
    fclose(file);
    assert_string_equal(found, text);
}

static mode_t mode_of(const char *path) {
    struct stat status;
    assert_int_equal(lstat(path, &status), 0);
    return status.st_mode;
}

// ---- links, modes ---------------------------------------------------------------------------------------------------

static void a_link_is_followed_and_stays(void **state) {
    (void)state;
    mkdir("deep", 0755);
    write_text("deep/target", "old");
    assert_int_equal(symlink("deep/second", "first"), 0);
    assert_int_equal(symlink("target", "deep/second"), 0); // counts from the folder of the link
    assert_int_equal(bolan_file_write("first", "new", 3), BOLAN_OK);
    assert_true(S_ISLNK(mode_of("first")) && S_ISLNK(mode_of("deep/second")) && S_ISREG(mode_of("deep/target")));
    assert_holds("deep/target", "new");
    assert_int_equal(entries(), 2);
}

static void a_link_that_leads_nowhere_makes_its_target(void **state) {
    (void)state;
    assert_int_equal(symlink("later", "link"), 0);
    assert_int_equal(bolan_file_write("link", "new", 3), BOLAN_OK);
    assert_true(S_ISLNK(mode_of("link")));
    assert_holds("later", "new");
    assert_int_equal(symlink("no/such", "lost"), 0);
    assert_refusal(bolan_file_write("lost", "new", 3), BOLAN_ERROR_IO, BOLAN_LOG_FILE_WRITE,
                   "lost: cannot be written: No such file");
    assert_true(S_ISLNK(mode_of("lost")));
    assert_int_equal(symlink("b", "a") + symlink("a", "b"), 0);
    assert_refusal(bolan_file_write("a", "new", 3), BOLAN_ERROR_IO, BOLAN_LOG_FILE_WRITE, "a: cannot be written");
    assert_int_equal(entries(), 5);
}

static void the_mode_of_a_file_is_kept(void **state) {
    (void)state;
    static const mode_t modes[] = {0600, 0640, 0755, 0666};
    const mode_t mask = umask(022);
    for (size_t i = 0; i < sizeof modes / sizeof *modes; i++) {
        write_text("file", "old");
        chmod("file", modes[i]);
        assert_int_equal(bolan_file_write("file", "new", 3), BOLAN_OK);
        assert_int_equal(mode_of("file") & 07777, modes[i]);
    }
    assert_int_equal(bolan_file_write("fresh", "new", 3), BOLAN_OK);
    assert_int_equal(mode_of("fresh") & 07777, 0644); // as the mask says
    umask(mask);
}

static void a_file_that_nobody_may_write_is_kept(void **state) {
    (void)state;
    write_text("locked", "old");
    chmod("locked", 0444);
    assert_refusal(bolan_file_check_writable("locked"), BOLAN_ERROR_IO, BOLAN_LOG_FILE_WRITE,
                   "locked: cannot be written: Permission denied");
    assert_refusal(bolan_file_write("locked", "new", 3), BOLAN_ERROR_IO, BOLAN_LOG_FILE_WRITE, "Permission denied");
    assert_holds("locked", "old");
    assert_int_equal(mode_of("locked") & 07777, 0444);
    assert_int_equal(entries(), 1);
}

// Root may write everything, so another user tries.
static void a_file_of_another_user_is_kept(void **state) {
    (void)state;
    if (geteuid() != 0) skip();
    write_text("theirs", "old");
    chmod(".", 0777);
    const pid_t child = fork();
    if (child == 0) {
        if (setgid(65534) || setuid(65534)) _exit(3);
        _exit(bolan_file_write("theirs", "new", 3) == BOLAN_ERROR_IO && bolan_file_write("mine", "new", 3) == BOLAN_OK
                  ? 0
                  : 4);
    }
    int status = -1;
    waitpid(child, &status, 0);
    assert_int_equal(status, 0);
    assert_holds("theirs", "old");
    assert_holds("mine", "new");
    // And root gives a file back to whom it belongs.
    assert_int_equal(bolan_file_write("mine", "root", 4), BOLAN_OK);
    struct stat now;
    assert_int_equal(stat("mine", &now), 0);
    assert_int_equal(now.st_uid, 65534);
    assert_int_equal(entries(), 2);
}

// ---- names ----------------------------------------------------------------------------------------------------------

static void a_name_as_long_as_a_folder_takes_is_written(void **state) {
    (void)state;
    for (size_t length = 240; length <= 255; length++) {
        char name[256] = "";
        while (strlen(name) + 3 <= length) strcat(name, "\xe6\xb5\xb7"); // three bytes: a cut must not split it
        while (strlen(name) < length) strcat(name, "n");
        assert_int_equal(bolan_file_write(name, "x", 1), BOLAN_OK);
        assert_holds(name, "x");
        assert_int_equal(remove(name), 0);
    }
    char name[300];
    memset(name, 'n', 256);
    name[256] = '\0';
    assert_refusal(bolan_file_write(name, "x", 1), BOLAN_ERROR_IO, BOLAN_LOG_FILE_WRITE, "File name too long");
    assert_refusal(bolan_file_write("", "x", 1), BOLAN_ERROR_IO, BOLAN_LOG_FILE_WRITE, "No such file");
    assert_int_equal(entries(), 0);
}

static void what_stands_under_a_temporary_name_is_not_ours(void **state) {
    (void)state;
    char name[64];
    snprintf(name, sizeof name, "file.part%ld", (long)getpid());
    write_text(name, "precious");
    assert_int_equal(bolan_file_check_writable("file"), BOLAN_OK);
    assert_int_equal(bolan_file_write("file", "new", 3), BOLAN_OK);
    assert_holds(name, "precious");
    assert_holds("file", "new");
    assert_int_equal(entries(), 2);
}

// ---- pipes and devices ----------------------------------------------------------------------------------------------

typedef struct reading {
    const char *path;
    char text[4096];
    size_t size;
} reading;

static void *read_pipe(void *context) {
    reading *r = context;
    const int file = open(r->path, O_RDONLY);
    for (ssize_t got; (got = read(file, r->text + r->size, sizeof r->text - r->size)) > 0;) r->size += (size_t)got;
    close(file);
    return NULL;
}

static void a_pipe_is_opened_once_and_stays(void **state) {
    (void)state;
    assert_int_equal(mkfifo("pipe", 0600), 0);
    alarm(20); // not for ever
    for (int kind = 0; kind < 3; kind++) {
        reading r = {.path = "pipe"};
        pthread_t reader;
        const uint8_t rgb[3] = {1, 2, 3};
        const float plane[1] = {1.0f};
        const bolan_exr_channel channel = {"Z", plane};
        pthread_create(&reader, NULL, read_pipe, &r);
        assert_int_equal(bolan_file_check_writable("pipe"), BOLAN_OK);
        assert_int_equal(kind == 0   ? bolan_file_write("pipe", "text", 4)
                         : kind == 1 ? bolan_png_write("pipe", 1, 1, rgb)
                                     : bolan_exr_write("pipe", 1, 1, &channel, 1),
                         BOLAN_OK);
        pthread_join(reader, NULL);
        static const char *const begins[] = {"text", "\x89PNG", "\x76\x2f\x31\x01"};
        assert_true(r.size >= 4);
        assert_memory_equal(r.text, begins[kind], 4);
        assert_true(S_ISFIFO(mode_of("pipe")));
    }
    bolan_video *video = NULL;
    assert_int_equal(rename("pipe", "pipe.mp4"), 0);
    assert_refusal(bolan_video_open("pipe.mp4", 64, 36, 30, &video), BOLAN_ERROR_ARGUMENT, BOLAN_LOG_BAD_ARGUMENT,
                   "pipe.mp4: a video cannot go into a device or pipe");
    alarm(0);
    assert_int_equal(entries(), 1);
}

static void a_link_to_a_device_is_written_to_and_stays(void **state) {
    (void)state;
    const float plane[1] = {1.0f};
    const bolan_exr_channel channel = {"Z", plane};
    assert_int_equal(symlink("/dev/full", "full.exr"), 0);
    assert_refusal(bolan_exr_write("full.exr", 1, 1, &channel, 1), BOLAN_ERROR_IO, BOLAN_LOG_FILE_WRITE,
                   "full.exr: cannot be written: No space left");
    assert_refusal(bolan_file_write("full.exr", "x", 1), BOLAN_ERROR_IO, BOLAN_LOG_FILE_WRITE, "No space left");
    assert_true(S_ISLNK(mode_of("full.exr")));
    assert_int_equal(entries(), 1);
}

// A reader that goes away, and a file that may not grow: sentences, and no signal that ends the program.
static void signals_of_writing_are_sentences(void **state) {
    (void)state;
    static char text[1 << 20];
    assert_int_equal(mkfifo("pipe", 0600), 0);
    const pid_t child = fork();
    if (child == 0) {
        close(open("pipe", O_RDONLY));
        _exit(0);
    }
    assert_refusal(bolan_file_write("pipe", text, sizeof text), BOLAN_ERROR_IO, BOLAN_LOG_FILE_WRITE, "Broken pipe");
    waitpid(child, NULL, 0);
    remove("pipe");
    write_text("big", "old");
    struct rlimit before;
    getrlimit(RLIMIT_FSIZE, &before);
    setrlimit(RLIMIT_FSIZE, &(struct rlimit){4096, before.rlim_max});
    assert_refusal(bolan_file_write("big", text, sizeof text), BOLAN_ERROR_IO, BOLAN_LOG_FILE_WRITE,
                   "big: cannot be written: File too large");
    setrlimit(RLIMIT_FSIZE, &before);
    assert_holds("big", "old");
    assert_int_equal(entries(), 1);
    sigset_t pending;
    sigpending(&pending);
    assert_false(sigismember(&pending, SIGPIPE) || sigismember(&pending, SIGXFSZ));
}

// ---- abandoned ------------------------------------------------------------------------------------------------------

static void wait_us(long us) { nanosleep(&(struct timespec){0, 1000 * us}, NULL); }

static void abandon(int signal_number) {
    (void)signal_number;
    bolan_files_abandon();
    _exit(77);
}

// A process that is ended while it writes, many times and at many moments: nothing may be left of what was not
// finished.
static void an_interrupted_writer_leaves_whole_files_or_none(void **state) {
    (void)state;
    static char text[1 << 16];
    memset(text, 'x', sizeof text);
    write_text("stays", "old");
    for (int i = 0; i < 60; i++) {
        const pid_t child = fork();
        if (child == 0) {
            signal(SIGTERM, abandon);
            for (;;) bolan_file_write("file", text, sizeof text);
        }
        wait_us(1500 + 97 * (long)i);
        kill(child, SIGTERM);
        int status = 0;
        waitpid(child, &status, 0);
        assert_true(WIFEXITED(status) ? WEXITSTATUS(status) == 77 : WTERMSIG(status) == SIGTERM); // before signal()
        struct stat written;
        const bool there = stat("file", &written) == 0;
        if (there) assert_int_equal(written.st_size, sizeof text);
        assert_int_equal(entries(), there ? 2 : 1);
    }
    assert_holds("stays", "old");
}

static bolan_tiles *make_tiles(void) {
    static float height[64 * 8 * 8];
    static uint8_t bytes[64 * 8 * 8 * 7];
    bolan_tiles *tiles = NULL;
    const bolan_tiles_view view = {.n = 8,
                                   .frames = 64,
                                   .length = 1,
                                   .period = 1,
                                   .depth = 1,
                                   .height = height,
                                   .normal = bytes,
                                   .detail = bytes,
                                   .caustics = bytes};
    assert_int_equal(bolan_tiles_create(&view, &tiles), BOLAN_OK);
    return tiles;
}

static void an_interrupted_folder_is_removed(void **state) {
    (void)state;
    bolan_tiles *tiles = make_tiles();
    int caught = 0;
    for (int i = 0; i < 20; i++) {
        const pid_t child = fork();
        if (child == 0) {
            signal(SIGTERM, abandon);
            if (bolan_tiles_save(tiles, "tiles/")) _exit(1);
            _exit(0);
        }
        wait_us(500 + 700 * (long)i);
        kill(child, SIGTERM);
        int status = 0;
        waitpid(child, &status, 0);
        caught += WIFEXITED(status) && WEXITSTATUS(status) == 77;
        assert_false(WIFEXITED(status) && WEXITSTATUS(status) == 1);
        assert_int_equal(entries(), access("tiles/height_063.pgm", R_OK) == 0 ? 1 : 0);
        if (entries() == 1) assert_int_equal(system("rm -r tiles"), 0);
    }
    assert_true(caught > 0);
    bolan_tiles_destroy(&tiles);
}

// ---- misuse ---------------------------------------------------------------------------------------------------------

static jmp_buf before_the_call;

static void leave_the_call(void *user, const char *expression, const char *file, int line) {
    (void)user, (void)expression, (void)file, (void)line;
    longjmp(before_the_call, 1);
}

#define assert_misuse(call)                               \
    do {                                                  \
        if (setjmp(before_the_call) == 0) call, _exit(1); \
    } while (0)

// The assertion comes before the crash. In a child: longjmp() out of the library leaves what it had begun.
static void misuse_is_asserted(void **state) {
    (void)state;
    const pid_t child = fork();
    if (child == 0) {
        bolan_set_hooks(&(bolan_hooks){.assert_failed = leave_the_call});
        static const float height[64];
        static const uint8_t bytes[192];
        bolan_tiles *tiles = NULL;
        const bolan_tiles_view whole = {.n = 8,
                                        .frames = 1,
                                        .length = 1,
                                        .period = 1,
                                        .depth = 1,
                                        .height = height,
                                        .normal = bytes,
                                        .detail = bytes,
                                        .caustics = bytes};
        bolan_tiles_view v = whole;
        assert_misuse(bolan_file_write(NULL, "x", 1));
        assert_misuse(bolan_file_write("x", NULL, 1));
        assert_misuse(bolan_file_check_writable(NULL));
        assert_misuse(bolan_video_check(NULL, 64, 36, 30));
        assert_misuse(bolan_tiles_create(NULL, &tiles));
        assert_misuse(bolan_tiles_create(&whole, NULL));
        v = whole, v.height = NULL;
        assert_misuse(bolan_tiles_create(&v, &tiles));
        v = whole, v.normal = NULL;
        assert_misuse(bolan_tiles_create(&v, &tiles));
        v = whole, v.detail = NULL;
        assert_misuse(bolan_tiles_create(&v, &tiles));
        v = whole, v.caustics = NULL;
        assert_misuse(bolan_tiles_create(&v, &tiles));
        _exit(bolan_file_write("x", NULL, 0) || bolan_tiles_create(&whole, &tiles)); // and these are none
    }
    int status = -1;
    waitpid(child, &status, 0);
    assert_int_equal(status, 0);
}

#define IN_FOLDER(test) cmocka_unit_test_setup_teardown(test, enter, leave)

int main(void) {
    const struct CMUnitTest tests[] = {
        IN_FOLDER(a_link_is_followed_and_stays),
        IN_FOLDER(a_link_that_leads_nowhere_makes_its_target),
        IN_FOLDER(the_mode_of_a_file_is_kept),
        IN_FOLDER(a_file_that_nobody_may_write_is_kept),
        IN_FOLDER(a_file_of_another_user_is_kept),
        IN_FOLDER(a_name_as_long_as_a_folder_takes_is_written),
        IN_FOLDER(what_stands_under_a_temporary_name_is_not_ours),
        IN_FOLDER(a_pipe_is_opened_once_and_stays),
        IN_FOLDER(a_link_to_a_device_is_written_to_and_stays),
        IN_FOLDER(signals_of_writing_are_sentences),
        IN_FOLDER(an_interrupted_writer_leaves_whole_files_or_none),
        IN_FOLDER(an_interrupted_folder_is_removed),
        IN_FOLDER(misuse_is_asserted),
    };
    return cmocka_run_group_tests(tests, listen_to_log, NULL);
}

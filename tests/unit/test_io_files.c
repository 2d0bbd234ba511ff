// SPDX-License-Identifier: MIT
// Files: whole or not at all; PNG and EXR that come back as they went; films; spectra and their companions.
#include "bolan/io.h"
#include "io_support.h"

#include <dirent.h>
#include <sys/stat.h>
#include <unistd.h>

enum { WIDTH = 64, HEIGHT = 36 };

static uint8_t picture[WIDTH * HEIGHT * 3];

static void paint(void) {
    for (int i = 0; i < WIDTH * HEIGHT * 3; i++) picture[i] = (uint8_t)(i * 7 + i / 191);
}

// Files in the working folder whose name begins so: what an interrupted writer would leave.
static int count_files(const char *beginning) {
    int count = 0;
    DIR *folder = opendir(".");
    assert_non_null(folder);
    for (struct dirent *entry; (entry = readdir(folder)) != NULL;)
        count += strncmp(entry->d_name, beginning, strlen(beginning)) == 0;
    closedir(folder);
    return count;
}

static void test_png_comes_back_as_it_went(void **state) {
    (void)state;
    paint();
    assert_int_equal(bolan_png_write("files_a.png", WIDTH, HEIGHT, picture), BOLAN_OK);
    uint32_t width = 0, height = 0;
    uint8_t *rgb = NULL;
    assert_int_equal(bolan_image_read("files_a.png", &width, &height, &rgb), BOLAN_OK);
    assert_true(width == WIDTH && height == HEIGHT);
    assert_memory_equal(rgb, picture, sizeof picture);
    bolan_release(rgb, sizeof picture);
    assert_int_equal(count_files("files_a"), 1);
    remove("files_a.png");
}

static void test_what_cannot_be_written_leaves_nothing(void **state) {
    (void)state;
    paint();
    const float plane[WIDTH * HEIGHT] = {0};
    const bolan_exr_channel channel = {"Z", plane};
    bolan_video *video = NULL;
    assert_refusal(bolan_png_write("no/such/a.png", WIDTH, HEIGHT, picture), BOLAN_ERROR_IO, BOLAN_LOG_FILE_WRITE,
                   "no/such/a.png: cannot be written: No such file or directory");
    assert_refusal(bolan_exr_write("no/such/a.exr", WIDTH, HEIGHT, &channel, 1), BOLAN_ERROR_IO, BOLAN_LOG_FILE_WRITE,
                   "no/such/a.exr: cannot be written: No such file or directory");
    assert_refusal(bolan_video_open("no/such/a.mp4", WIDTH, HEIGHT, 30, &video), BOLAN_ERROR_IO, BOLAN_LOG_FILE_WRITE,
                   "no/such/a.mp4: cannot be written: No such file or directory");
    assert_refusal(bolan_file_write(".", "x", 1), BOLAN_ERROR_IO, BOLAN_LOG_FILE_WRITE,
                   ".: cannot be written: Is a directory");
    assert_refusal(bolan_png_write("a.png", 0, HEIGHT, picture), BOLAN_ERROR_ARGUMENT, BOLAN_LOG_OUT_OF_RANGE,
                   "a picture of 0x");
    // Every write to this device fails at the close, as on a full disk.
    if (access("/dev/full", W_OK) == 0)
        assert_refusal(bolan_file_write("/dev/full", "x", 1), BOLAN_ERROR_IO, BOLAN_LOG_FILE_WRITE, "No space left");
}

static void test_a_device_is_written_to_and_not_replaced(void **state) {
    (void)state;
    struct stat status;
    assert_int_equal(bolan_file_write("/dev/null", "x", 1), BOLAN_OK);
    assert_int_equal(stat("/dev/null", &status), 0);
    assert_true(S_ISCHR(status.st_mode));
}

static void test_an_old_file_stays_until_the_new_one_is_whole(void **state) {
    (void)state;
    write_text("files_old.txt", "old");
    assert_int_equal(bolan_file_check_writable("files_old.txt"), BOLAN_OK);
    FILE *file = fopen("files_old.txt", "rb"); // still open while it is replaced: the reader keeps the old text
    assert_non_null(file);
    assert_int_equal(bolan_file_write("files_old.txt", "newer", 5), BOLAN_OK);
    char text[8] = "";
    assert_int_equal(fread(text, 1, sizeof text, file), 3);
    assert_memory_equal(text, "old", 3);
    fclose(file);
    assert_int_equal(count_files("files_old"), 1);
    remove("files_old.txt");
}

static uint32_t little_endian(const uint8_t *p) {
    return (uint32_t)p[0] | (uint32_t)p[1] << 8 | (uint32_t)p[2] << 16 | (uint32_t)p[3] << 24;
}

static void test_exr_has_its_magic_and_its_channels_in_order(void **state) {
    (void)state;
    static float planes[3][WIDTH * HEIGHT];
    for (int i = 0; i < WIDTH * HEIGHT; i++) planes[0][i] = (float)i, planes[1][i] = -0.5f, planes[2][i] = HUGE_VALF;
    const bolan_exr_channel channels[] = {{"Z", planes[2]}, {"R", planes[0]}, {"G", planes[1]}};
    assert_int_equal(bolan_exr_write("files_b.exr", WIDTH, HEIGHT, channels, 3), BOLAN_OK);
    FILE *file = fopen("files_b.exr", "rb");
    assert_non_null(file);
    uint8_t head[1024];
    const size_t size = fread(head, 1, sizeof head, file);
    fclose(file);
    assert_true(size > 300);
    assert_int_equal(little_endian(head), 20000630); // OpenEXR file layout, "Magic Number"
    // The channel list is sorted by name: entries of 18 bytes (name, NUL, type 2 = float, ...) after its attribute
    // header.
    const uint8_t *list = NULL;
    for (size_t i = 8; i + 64 < size && !list; i++)
        if (memcmp(head + i, "chlist\0", 7) == 0) list = head + i + 7 + 4;
    assert_non_null(list);
    assert_true(list[0] == 'G' && list[18] == 'R' && list[36] == 'Z' && list[54] == 0);
    assert_int_equal(little_endian(list + 2), 2);
    remove("files_b.exr");
    const bolan_exr_channel twice[] = {{"R", planes[0]}, {"R", planes[1]}};
    assert_refusal(bolan_exr_write("files_b.exr", WIDTH, HEIGHT, twice, 2), BOLAN_ERROR_ARGUMENT,
                   BOLAN_LOG_BAD_ARGUMENT, "different names");
    assert_int_equal(count_files("files_b"), 0);
}

static void test_what_is_no_picture_is_refused(void **state) {
    (void)state;
    uint32_t width, height;
    uint8_t *rgb;
    write_text("files_c.png", "no picture");
    assert_refusal(bolan_image_read("files_c.png", &width, &height, &rgb), BOLAN_ERROR_FORMAT, BOLAN_LOG_IMAGE_FORMAT,
                   "files_c.png: not a picture");
    assert_null(rgb);
    remove("files_c.png");
    assert_refusal(bolan_image_read("files_c.png", &width, &height, &rgb), BOLAN_ERROR_IO, BOLAN_LOG_FILE_OPEN,
                   "files_c.png");
}

static void test_videos_are_checked_before_they_start(void **state) {
    (void)state;
    bolan_video *video = NULL;
    assert_refusal(bolan_video_open("a.avi", WIDTH, HEIGHT, 30, &video), BOLAN_ERROR_ARGUMENT, BOLAN_LOG_BAD_ARGUMENT,
                   ".mp4 or .webm");
    assert_refusal(bolan_video_open("a.mp4", 63, HEIGHT, 30, &video), BOLAN_ERROR_ARGUMENT, BOLAN_LOG_BAD_ARGUMENT,
                   "even");
    assert_refusal(bolan_video_open("a.mp4", WIDTH, HEIGHT, 0, &video), BOLAN_ERROR_ARGUMENT, BOLAN_LOG_BAD_ARGUMENT,
                   "frames a second");
    assert_null(video);
    char *path = strdup(getenv("PATH"));
    setenv("PATH", "/nowhere", 1);
    assert_refusal(bolan_video_open("files_d.mp4", WIDTH, HEIGHT, 30, &video), BOLAN_ERROR_UNSUPPORTED,
                   BOLAN_LOG_VIDEO_PROGRAM, "the program ffmpeg was not found; install it");
    setenv("PATH", path, 1);
    free(path);
    assert_int_equal(count_files("files_d"), 0);
}

// A program in ffmpeg's place that gives up at once: its words arrive, the caller survives, nothing is left.
static void test_the_words_of_ffmpeg_arrive(void **state) {
    (void)state;
    mkdir("files_bin", 0755);
    write_text("files_bin/ffmpeg", "#!/bin/sh\necho 'first line' >&2\necho 'the encoder is missing' >&2\nexit 3\n");
    chmod("files_bin/ffmpeg", 0755);
    char *path = strdup(getenv("PATH")), both[4096];
    snprintf(both, sizeof both, "files_bin:%s", path);
    setenv("PATH", both, 1);
    bolan_video *video = NULL;
    assert_int_equal(bolan_video_open("files_e.mp4", WIDTH, HEIGHT, 30, &video), BOLAN_OK);
    bolan_result result = BOLAN_OK;
    error_count = 0;
    for (int i = 0; i < 1000 && !result; i++) // until the pipe's buffer is full or gone
        result = bolan_video_write(video, picture);
    assert_int_equal(result, BOLAN_ERROR_IO);
    assert_non_null(strstr(last_sentence, "files_e.mp4: ffmpeg failed: first line"));
    assert_int_equal(bolan_video_close(&video, true), BOLAN_ERROR_IO);
    assert_int_equal(error_count, 1);
    assert_null(video);
    setenv("PATH", path, 1);
    free(path);
    remove("files_bin/ffmpeg");
    rmdir("files_bin");
    assert_int_equal(count_files("files_e"), 0);
}

static void test_a_film_appears_when_it_is_whole(void **state) {
    (void)state;
    bolan_video *video = NULL;
    error_count = 0;
    const bolan_result opened = bolan_video_open("files_f.mp4", WIDTH, HEIGHT, 25, &video);
    if (opened == BOLAN_ERROR_UNSUPPORTED) {
        print_message("skipped: ffmpeg is not installed\n");
        skip();
    }
    assert_int_equal(opened, BOLAN_OK);
    for (int i = 0; i < 3; i++) assert_int_equal(bolan_video_write(video, picture), BOLAN_OK);
    assert_false(file_exists("files_f.mp4"));
    assert_int_equal(bolan_video_close(&video, true), BOLAN_OK);
    assert_true(file_exists("files_f.mp4"));
    assert_int_equal(count_files("files_f"), 1);
    remove("files_f.mp4");
    assert_int_equal(bolan_video_open("files_f.webm", WIDTH, HEIGHT, 25, &video), BOLAN_OK);
    assert_int_equal(bolan_video_write(video, picture), BOLAN_OK);
    assert_int_equal(bolan_video_close(&video, false), BOLAN_OK); // thrown away
    assert_int_equal(count_files("files_f"), 0);
    assert_int_equal(bolan_video_close(&video, true), BOLAN_OK); // NULL-safe
}

static void test_spectrum_files(void **state) {
    (void)state;
    bolan_measured_spectrum *spectrum = NULL;
    assert_refusal(bolan_spectrum_load("none.spec", NULL, &spectrum), BOLAN_ERROR_IO, BOLAN_LOG_FILE_OPEN,
                   "none.spec: cannot be read");
    assert_refusal(bolan_spectrum_load("builtin:none", NULL, &spectrum), BOLAN_ERROR_ARGUMENT, BOLAN_LOG_UNKNOWN_NAME,
                   "builtin:none");
    write_text("files_g.spec", "");
    assert_refusal(bolan_spectrum_load("files_g.spec", NULL, &spectrum), BOLAN_ERROR_FORMAT, BOLAN_LOG_SPECTRUM_EMPTY,
                   "files_g.spec");
    remove("files_g.spec");
    assert_int_equal(bolan_spectrum_load("builtin:synthetic-bimodal", NULL, &spectrum), BOLAN_OK);
    assert_int_equal(bolan_measured_spectrum_view(spectrum).direction_count, 36);
    bolan_measured_spectrum_destroy(&spectrum);
    bolan_spectrum_options options = bolan_spectrum_options_default();
    options.record = 7;
    assert_refusal(bolan_spectrum_load("builtin:synthetic-bimodal", &options, &spectrum), BOLAN_ERROR_ARGUMENT,
                   BOLAN_LOG_SPECTRUM_TIME_INDEX, "synthetic-bimodal");
}

static bolan_sea_summary load_sea(const char *path, const bolan_spectrum_options *options) {
    bolan_measured_spectrum *spectrum = NULL;
    assert_int_equal(bolan_spectrum_load(path, options, &spectrum), BOLAN_OK);
    bolan_sea_state sea = bolan_sea_state_default();
    sea.measured = spectrum;
    const bolan_sea_summary summary = bolan_sea_state_summary(&sea);
    bolan_measured_spectrum_destroy(&spectrum);
    return summary;
}

static void test_ndbc_companions_are_found(void **state) {
    (void)state;
    char path[1024];
    bolan_spectrum_options options = bolan_spectrum_options_default();
    options.record = 148;
    // The newest record, 2020-06-08 03:50: 1.1188 m from 158.6 degrees; the direction is in the companions alone.
    bolan_sea_summary s = load_sea(test_data("spectra/ndbc_41010.data_spec", path, sizeof path), &options);
    assert_near(s.hs, 1.1188, 0.006);
    assert_near(s.from_deg, 158.6, 0.5);
    // The set of a year: w, and d, i, j, k beside it. All from 180 with r1 = 0.85.
    options.record = 0;
    s = load_sea(test_data("spectra/41004w2018.txt", path, sizeof path), &options);
    assert_near(s.hs, 1.99544, 1e-5); // trapezoid rule over the text
    assert_near(s.from_deg, 180.0, 1e-3);
    assert_near(s.spread_deg, sqrt(2.0 * 0.15) * 180.0 / acos(-1.0), 1e-3);
    // No row of that time: that of an hour before is taken.
    s = load_sea(test_data("spectra/rtmiss.data_spec", path, sizeof path), &options);
    assert_near(s.hs, 1.99510, 1e-5);
    assert_near(s.from_deg, 180.0, 1e-3);
}

// The set of a year again, packed by gzip, the densities in two parts; and bytes that are not whole.
static void test_packed_spectra(void **state) {
    (void)state;
    char path[1024];
    bolan_measured_spectrum *spectrum = NULL;
    if (!bolan_io_get_features().gzip) skip();
    const bolan_sea_summary s = load_sea(test_data("spectra/packed/41004w2018.txt.gz", path, sizeof path), NULL);
    assert_near(s.hs, 1.99544, 1e-5);
    assert_near(s.from_deg, 180.0, 1e-3); // from the companions
    FILE *file = fopen("files_i.spec", "wb");
    fwrite("\x1f\x8b\x08\0\0\0\0\0\0\x03\x4b", 1, 11, file);
    fclose(file);
    assert_refusal(bolan_spectrum_load("files_i.spec", NULL, &spectrum), BOLAN_ERROR_FORMAT, BOLAN_LOG_FILE_UNPACK,
                   "files_i.spec: cannot be unpacked: it ends too soon");
    assert_null(spectrum);
    write_text("files_i.spec", "\x1f\x8b not packed");
    assert_refusal(bolan_spectrum_load("files_i.spec", NULL, &spectrum), BOLAN_ERROR_FORMAT, BOLAN_LOG_FILE_UNPACK,
                   "files_i.spec: cannot be unpacked");
    remove("files_i.spec");
    bolan_spectrum_contents *contents = NULL;
    assert_int_equal(bolan_spectrum_contents_load(path, &contents), BOLAN_OK);
    assert_string_equal(contents->format, "ndbc");
    bolan_spectrum_contents_destroy(&contents);
}

// Each companion by its own letter, also in capitals, and only where the density's name has its own.
static void test_letters_in_names_of_the_history(void **state) {
    (void)state;
    static const char head[] = "YYYY MM DD hh .1 .2\n2000 01 01 00 ";
    static const char *const rows[] = {"1.5 2.5", "40 40", "50 50", "80 80", "55 55"};
    for (int capital = 0; capital < 2; capital++) {
        const char *letters = capital ? "WDIJK" : "wdijk";
        char name[64], text[128];
        for (int i = 0; i < 5; i++) {
            snprintf(name, sizeof name, "files%c2000w.txt", letters[i]);
            snprintf(text, sizeof text, "%s%s\n", head, rows[i]);
            write_text(name, text);
        }
        snprintf(name, sizeof name, "files%c2000w.txt", letters[0]);
        bolan_sea_summary s = load_sea(name, NULL);
        assert_near(s.from_deg, 40.0, 1e-3);
        assert_near(s.spread_deg, sqrt(2.0 * 0.2) * 180.0 / acos(-1.0), 1e-3);
        snprintf(name, sizeof name, "files%c2000w.txt", letters[1]);
        remove(name);
        bolan_spectrum_options options = bolan_spectrum_options_default();
        options.from_deg = 90.0;
        snprintf(name, sizeof name, "files%c2000w.txt", letters[0]);
        assert_near(load_sea(name, &options).from_deg, 90.0, 1e-3);
        for (int i = 0; i < 5; i++) {
            snprintf(name, sizeof name, "files%c2000w.txt", letters[i]);
            remove(name);
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_png_comes_back_as_it_went),
        cmocka_unit_test(test_what_cannot_be_written_leaves_nothing),
        cmocka_unit_test(test_a_device_is_written_to_and_not_replaced),
        cmocka_unit_test(test_an_old_file_stays_until_the_new_one_is_whole),
        cmocka_unit_test(test_exr_has_its_magic_and_its_channels_in_order),
        cmocka_unit_test(test_what_is_no_picture_is_refused),
        cmocka_unit_test(test_videos_are_checked_before_they_start),
        cmocka_unit_test(test_the_words_of_ffmpeg_arrive),
        cmocka_unit_test(test_a_film_appears_when_it_is_whole),
        cmocka_unit_test(test_spectrum_files),
        cmocka_unit_test(test_ndbc_companions_are_found),
        cmocka_unit_test(test_packed_spectra),
        cmocka_unit_test(test_letters_in_names_of_the_history),
    };
    return cmocka_run_group_tests(tests, listen_to_log, NULL);
}

// SPDX-License-Identifier: MIT
// A host program with a decimal comma (Qt and GTK programs call setlocale): every number that a machine reads or writes
// stays as it is. The locale is made here, so that the test runs on every machine that has localedef and its sources
// (Debian: package locales).
#include "bolan/io.h"
#include "io_support.h"

#include <locale.h>
#include <unistd.h>

static char folder[64];

static int speak_german(void **state) {
    char command[256], path[256];
    snprintf(folder, sizeof folder, "locale_%ld", (long)getpid());
    snprintf(command, sizeof command, "mkdir %s && localedef -i de_DE -f UTF-8 %s/de_DE.UTF-8", folder, folder);
    if (system(command) != 0)
        return print_error("localedef cannot make de_DE; install the package locales"
                           "\n"),
               1;
    snprintf(path, sizeof path, "%s", folder);
    setenv("LOCPATH", path, 1);
    setenv("LC_ALL", "de_DE.UTF-8", 1);
    if (!setlocale(LC_ALL, "de_DE.UTF-8"))
        return print_error("de_DE.UTF-8 cannot be set"
                           "\n"),
               1;
    return listen_to_log(state);
}

static int clean(void **state) {
    (void)state;
    char command[96];
    setlocale(LC_ALL, "C");
    snprintf(command, sizeof command, "rm -rf %s", folder);
    return system(command);
}

static void this_program_writes_a_comma(void **state) {
    (void)state;
    char text[32];
    snprintf(text, sizeof text, "%.1f", 0.5);
    assert_string_equal(text, "0,5"); // or the other tests prove nothing
    assert_true(strtod("0,5", NULL) == 0.5);
}

static void numbers_keep_their_point(void **state) {
    (void)state;
    char text[64];
    double value = 0.0;
    bolan_format(text, sizeof text, "%.6f %g", 29.97, 1e-3);
    assert_string_equal(text, "29.970000 0.001");
    assert_true(bolan_parse_number("29.97", 5, &value) && value == 29.97);
    assert_false(bolan_parse_number("29,97", 5, &value));
    snprintf(text, sizeof text, "%.1f", 0.5);
    assert_string_equal(text, "0,5"); // the host's own locale is as it was
    bolan_raster_desc raster = bolan_raster_desc_default();
    snprintf(raster.path, sizeof raster.path, "none.tif");
    raster.latitude = 0.5;
    raster.radius = 1.0;
    assert_refusal(bolan_raster_load(&raster, &(bolan_ground *){NULL}), BOLAN_ERROR_ARGUMENT, BOLAN_LOG_OUT_OF_RANGE,
                   "latitude 0.5,");
}

static void tiles_keep_their_numbers(void **state) {
    (void)state;
    char path[96], command[160];
    bolan_sea_desc d = bolan_sea_desc_default();
    d.waves = BOLAN_WAVES_TEXTURES;
    d.resolution = 32;
    d.textures.frames = 2;
    bolan_sea *sea = NULL;
    bolan_tiles *tiles = NULL, *back = NULL;
    const bolan_tiles_desc desc = bolan_tiles_desc_default();
    assert_int_equal(bolan_sea_create(&d, &sea), BOLAN_OK);
    assert_int_equal(bolan_tiles_bake(sea, &desc, &tiles), BOLAN_OK);
    bolan_sea_destroy(&sea);
    snprintf(path, sizeof path, "%s/tiles", folder);
    assert_int_equal(bolan_tiles_save(tiles, path), BOLAN_OK);
    snprintf(command, sizeof command, "grep -q '[0-9],[0-9]' %s/index.json", path);
    assert_int_not_equal(system(command), 0);
    assert_int_equal(bolan_tiles_load(path, &back), BOLAN_OK);
    const bolan_tiles_view a = bolan_tiles_get_view(tiles), b = bolan_tiles_get_view(back);
    assert_true(a.depth == b.depth && a.length == b.length && a.period == b.period && a.angle == b.angle);
    double most = 0.0;
    for (size_t i = 0; i < (size_t)2 * 32 * 32; i++) most = fmax(most, fabs((double)a.height[i]));
    for (size_t i = 0; i < (size_t)2 * 32 * 32; i++) assert_near(a.height[i], b.height[i], most / 32767.0);
    bolan_tiles_destroy(&tiles);
    bolan_tiles_destroy(&back);
}

static void scenes_points_and_spectra_are_read(void **state) {
    (void)state;
    static const char text[] = "time: 1.5\nsea: {wind: {speed: 7.25, from: 200.5}}\n";
    bolan_scene scene;
    assert_int_equal(bolan_scene_parse("s.yaml", text, sizeof text - 1, &scene), BOLAN_OK);
    assert_true(scene.time == 1.5 && scene.sea.sea_state.wind_speed == 7.25);
    assert_refusal(bolan_scene_parse("s.yaml", "sea: {fetch_km: x}", 18, &scene), BOLAN_ERROR_FORMAT,
                   BOLAN_LOG_SCENE_BAD_VALUE,
                   "expected a number from 0.1 to"); // not "0,1"
    bolan_points points;
    assert_int_equal(bolan_points_parse("p.csv", "1.25,-2.5\n", 10, &points), BOLAN_OK);
    assert_true(points.points[0].x == 1.25 && points.points[0].y == -2.5);
    bolan_points_destroy(&points);
    bolan_measured_spectrum *spectrum = NULL;
    assert_int_equal(bolan_spectrum_load("builtin:synthetic-bimodal", 0, &spectrum), BOLAN_OK);
    bolan_sea_state sea = bolan_sea_state_default();
    sea.measured = spectrum;
    const double hs = bolan_sea_state_summary(&sea).hs;
    setlocale(LC_ALL, "C");
    bolan_measured_spectrum *again = NULL;
    assert_int_equal(bolan_spectrum_load("builtin:synthetic-bimodal", 0, &again), BOLAN_OK);
    setlocale(LC_ALL, "de_DE.UTF-8");
    sea.measured = again;
    assert_true(hs > 1.0 && bolan_sea_state_summary(&sea).hs == hs);
    bolan_measured_spectrum_destroy(&spectrum);
    bolan_measured_spectrum_destroy(&again);
}

static void films_have_their_rate(void **state) {
    (void)state;
    static uint8_t picture[64 * 36 * 3];
    char path[96], command[256], rate[32] = "";
    bolan_video *video = NULL;
    snprintf(path, sizeof path, "%s/film.mp4", folder);
    assert_int_equal(bolan_video_open(path, 64, 36, 29.97, &video), BOLAN_OK);
    for (int i = 0; i < 3; i++) assert_int_equal(bolan_video_write(video, picture), BOLAN_OK);
    assert_int_equal(bolan_video_close(&video, true), BOLAN_OK);
    snprintf(command, sizeof command, "ffprobe -v error -show_entries stream=r_frame_rate -of csv=p=0 %s", path);
    FILE *pipe = popen(command, "r");
    assert_non_null(pipe);
    assert_non_null(fgets(rate, sizeof rate, pipe));
    pclose(pipe);
    assert_string_equal(rate, "2997/100\n");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(this_program_writes_a_comma), cmocka_unit_test(numbers_keep_their_point),
        cmocka_unit_test(tiles_keep_their_numbers),    cmocka_unit_test(scenes_points_and_spectra_are_read),
        cmocka_unit_test(films_have_their_rate),
    };
    return cmocka_run_group_tests(tests, speak_german, clean);
}

// SPDX-License-Identifier: MIT
// Folders of tiles: written whole, read back, refused with a sentence.
#include "bolan/io.h"
#include "io_support.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static bolan_tiles *bake(void) {
    bolan_sea_desc d = bolan_sea_desc_default();
    d.waves = BOLAN_WAVES_TEXTURES;
    d.resolution = 32;
    d.textures.frames = 2;
    bolan_sea *sea = NULL;
    bolan_tiles *tiles = NULL;
    const bolan_tiles_desc desc = bolan_tiles_desc_default();
    assert_int_equal(bolan_sea_create(&d, &sea), BOLAN_OK);
    assert_int_equal(bolan_tiles_bake(sea, &desc, &tiles), BOLAN_OK);
    bolan_sea_destroy(&sea);
    return tiles;
}

static char folder[64];

static void in_folder(const char *name, char out[128]) { snprintf(out, 128, "%s/%s", folder, name); }

static int make(void **state) {
    (void)state;
    snprintf(folder, sizeof folder, "tiles_test_%ld", (long)getpid());
    return 0;
}

static int clean(void **state) {
    (void)state;
    static const char *const kinds[] = {"height_%03d.pgm", "normal_%03d.png", "detail_%03d.png", "caustics_%03d.png"};
    char name[64], path[128];
    for (int k = 0; k < 8; k++) {
        snprintf(name, sizeof name, kinds[k / 2], k % 2);
        in_folder(name, path);
        unlink(path);
    }
    in_folder("index.json", path);
    unlink(path);
    rmdir(folder);
    return 0;
}

static void what_is_written_is_read_back(void **state) {
    (void)state;
    bolan_tiles *tiles = bake(), *back = NULL;
    assert_int_equal(bolan_tiles_save(tiles, folder), BOLAN_OK);
    assert_int_equal(bolan_tiles_load(folder, &back), BOLAN_OK);
    const bolan_tiles_view a = bolan_tiles_get_view(tiles), b = bolan_tiles_get_view(back);
    const size_t size = (size_t)a.frames * a.n * a.n;
    assert_int_equal(b.n, 32);
    assert_int_equal(b.frames, 2);
    assert_near(b.length, a.length, 0.0);
    assert_near(b.period, a.period, 0.0);
    assert_near(b.depth, a.depth, 0.0);
    assert_memory_equal(a.normal, b.normal, 3 * size);
    assert_memory_equal(a.detail, b.detail, 3 * size);
    assert_memory_equal(a.caustics, b.caustics, size);
    double most = 0.0;
    for (size_t i = 0; i < size; i++) most = fmax(most, fabs((double)a.height[i]));
    for (size_t i = 0; i < size; i++)
        assert_near(a.height[i], b.height[i], most / 32767.0); // half a step of 16 bits, and rounding
    bolan_tiles_destroy(&back);
    assert_int_equal(bolan_tiles_save(tiles, folder), BOLAN_ERROR_IO); // it is there already
    assert_int_equal(bolan_tiles_check_writable(folder), BOLAN_ERROR_IO);
    bolan_tiles_destroy(&tiles);
}

static void damaged_folders_are_refused(void **state) {
    (void)state;
    bolan_tiles *tiles = bake(), *back = NULL;
    char path[128];
    assert_int_equal(bolan_tiles_load(folder, &back), BOLAN_ERROR_IO);
    assert_int_equal(bolan_tiles_save(tiles, folder), BOLAN_OK);
    in_folder("height_001.pgm", path);
    assert_int_equal(bolan_file_write(path, "P5 32 32 65535\n", 15), BOLAN_OK);
    assert_int_equal(bolan_tiles_load(folder, &back), BOLAN_ERROR_FORMAT);
    in_folder("index.json", path);
    static const char wrong[] =
        "{\"n\": 33, \"frames\": 2, \"length\": 1, \"angle\": 0, \"period\": 1, \"depth\": 1, \"paper\": 0, "
        "\"height_step\": 1}";
    assert_int_equal(bolan_file_write(path, wrong, sizeof wrong - 1), BOLAN_OK);
    assert_int_equal(bolan_tiles_load(folder, &back), BOLAN_ERROR_FORMAT);
    assert_int_equal(bolan_file_write(path, "{}", 2), BOLAN_OK);
    assert_int_equal(bolan_tiles_load(folder, &back), BOLAN_ERROR_FORMAT);
    assert_null(back);
    bolan_tiles_destroy(&tiles);
}

// index.json: the JSON that was written, and only that.
static const char index_text[] =
    "{\"bolan_tiles\": 1, \"n\": 8, \"frames\": 2, \"length\": 1, \"angle\": 0, \"period\": 1, \"depth\": 1, "
    "\"paper\": 0, \"height_step\": 0.25, \"caustics_range\": 4}";

// The index with @p old in it replaced, or with @p fresh behind it where @p old is NULL.
static bolan_result load_changed(const char *old, const char *fresh) {
    char text[512] = "", path[128];
    const char *at = old ? strstr(index_text, old) : index_text + strlen(index_text);
    assert_non_null(at);
    snprintf(text, sizeof text, "%.*s%s%s", (int)(at - index_text), index_text, fresh, at + (old ? strlen(old) : 0));
    in_folder("index.json", path);
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    fputs(text, file);
    fclose(file);
    bolan_tiles *tiles = NULL;
    error_count = 0;
    const bolan_result result = bolan_tiles_load(folder, &tiles);
    if (result) assert_true(!tiles && error_count == 1);
    bolan_tiles_destroy(&tiles);
    return result;
}

static void the_index_is_json_in_range(void **state) {
    (void)state;
    static float height[2 * 8 * 8];
    static uint8_t bytes[2 * 8 * 8 * 7];
    bolan_tiles *tiles = NULL;
    const bolan_tiles_view view = {.n = 8,
                                   .frames = 2,
                                   .length = 1,
                                   .period = 1,
                                   .depth = 1,
                                   .height = height,
                                   .normal = bytes,
                                   .detail = bytes,
                                   .caustics = bytes};
    assert_int_equal(bolan_tiles_create(&view, &tiles), BOLAN_OK);
    assert_int_equal(bolan_tiles_save(tiles, folder), BOLAN_OK);
    bolan_tiles_destroy(&tiles);
    listen_to_log(NULL);
    static const struct {
        const char *old, *fresh;
    } good[] = {{NULL, " \n"}, {"{", "{\n\t"}, {"0.25", "2.5e-1"}, {"\"angle\": 0", "\"angle\":-0.5"}, {"0.25", "1"}};
    for (size_t i = 0; i < sizeof good / sizeof *good; i++)
        assert_int_equal(load_changed(good[i].old, good[i].fresh), BOLAN_OK);
    static const struct {
        const char *old, *fresh, *words;
    } bad[] = {
        {"\"bolan_tiles\": 1", "\"bolan_tiles\": 99", "\"bolan_tiles\" is 99; expected 1"},
        {"\"bolan_tiles\": 1, ", "", "no number \"bolan_tiles\""},
        {"0.25", "1e-320", "\"height_step\" is"},
        {"0.25", "0", "\"height_step\" is 0"},
        {"0.25", "-0.25", "\"height_step\" is -0.25"},
        {"0.25", "1.5", "\"height_step\" is 1.5"},
        {"0.25", "nan", "\"height_step\" is no number"},
        {"0.25", "0,25", "not JSON"},
        {"0.25", ".25", "is no number"},
        {"0.25", "+0.25", "is no number"},
        {"0.25", "00.25", "is no number"},
        {"0.25", "1.", "is no number"},
        {"0.25", "\"0.25\"", "is no number"},
        {"\"n\": 8", "\"n\": 12", "\"n\" is 12"},
        {"\"n\": 8", "\"n\": 4", "\"n\" is 4"},
        {"\"n\": 8", "\"n\": 8.5", "\"n\" is 8.5"},
        {"\"frames\": 2", "\"frames\": 65", "\"frames\" is 65"},
        {"\"frames\": 2", "\"frames\": 0", "\"frames\" is 0"},
        {"\"length\": 1", "\"length\": 0", "\"length\" is 0"},
        {"\"period\": 1", "\"period\": 1e7", "\"period\" is 1e+07"},
        {"\"depth\": 1", "\"depth\": 201", "\"depth\" is 201"},
        {"\"paper\": 0", "\"paper\": 2", "\"paper\" is 2"},
        {"\"caustics_range\": 4", "\"caustics_range\": 5", "\"caustics_range\" is 5"},
        {"\"frames\": 2", "\"frames\": 2, \"frames\": 2", "\"frames\" is given twice"},
        {"\"frames\"", "\"Frames\"", "a key that the index"},
        {"{", "", "not JSON"},
        {"}", "", "not JSON"},
        {"4}", "4,}", "not JSON"},
        {NULL, "x", "text behind the object"},
        {"\"angle\": 0, ", "\"angle\": 0 ", "not JSON"},
    };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        assert_int_equal(load_changed(bad[i].old, bad[i].fresh), BOLAN_ERROR_FORMAT);
        if (!strstr(last_sentence, bad[i].words)) print_error("%s, not %s\n", last_sentence, bad[i].words);
        assert_non_null(strstr(last_sentence, bad[i].words));
        assert_int_equal(last_id, BOLAN_LOG_IMAGE_FORMAT);
    }
    // An index that asks for 738 MB of files that are not there is refused before it gets them.
    const size_t before = bolan_memory_in_use();
    assert_int_equal(load_changed("\"frames\": 2", "\"frames\": 64"), BOLAN_ERROR_IO);
    assert_int_equal(load_changed("\"n\": 8", "\"n\": 1024"), BOLAN_ERROR_FORMAT);
    assert_non_null(strstr(last_sentence, "height_000.pgm: not a 16-bit PGM of the size"));
    assert_int_equal(bolan_memory_in_use(), before);
    bolan_set_hooks(NULL);
}

// Rows are told from columns, and frames from each other: height 1 + x/10 + y/3 in the first, its negative in the
// second.
static void files_of_tiles_hold_what_they_should(void **state) {
    (void)state;
    enum { N = 8 };
    static float height[2][N][N];
    static uint8_t normal[2][N][N][3], detail[2][N][N][3], caustics[2][N][N];
    for (int f = 0; f < 2; f++)
        for (int y = 0; y < N; y++)
            for (int x = 0; x < N; x++) {
                height[f][y][x] = (f ? -1.0f : 1.0f) * (1.0f + (float)x / 10 + (float)y / 3);
                normal[f][y][x][0] = (uint8_t)(10 * x + f), normal[f][y][x][1] = (uint8_t)(20 * y);
                detail[f][y][x][2] = (uint8_t)(5 * x + 11 * y + f),
                caustics[f][y][x] = (uint8_t)(3 * x + 17 * y + 2 * f);
            }
    bolan_tiles *tiles = NULL;
    const bolan_tiles_view view = {.n = N,
                                   .frames = 2,
                                   .length = 2.5,
                                   .angle = 0.7,
                                   .period = 3.5,
                                   .depth = 1.25,
                                   .paper = true,
                                   .height = &height[0][0][0],
                                   .normal = &normal[0][0][0][0],
                                   .detail = &detail[0][0][0][0],
                                   .caustics = &caustics[0][0][0]};
    assert_int_equal(bolan_tiles_create(&view, &tiles), BOLAN_OK);
    assert_int_equal(bolan_tiles_save(tiles, folder), BOLAN_OK);
    bolan_tiles_destroy(&tiles);
    // The PGM, byte by byte: (value - 32768) * height_step, the larger byte first; the highest is 32767 steps.
    const double step = (1.0 + 0.7 + 7.0 / 3.0) / 32767.0;
    for (int f = 0; f < 2; f++) {
        char path[128], name[32], head[16] = "";
        uint8_t grey[N][N][2];
        snprintf(name, sizeof name, "height_%03d.pgm", f);
        in_folder(name, path);
        FILE *file = fopen(path, "rb");
        assert_non_null(file);
        assert_int_equal(fread(head, 1, 13, file), 13);
        assert_string_equal(head, "P5\n8 8\n65535\n");
        assert_int_equal(fread(grey, 1, sizeof grey, file), sizeof grey);
        fclose(file);
        for (int y = 0; y < N; y++)
            for (int x = 0; x < N; x++)
                assert_near(((grey[y][x][0] << 8 | grey[y][x][1]) - 32768) * step, height[f][y][x], 0.51 * step);
    }
    assert_int_equal(bolan_tiles_load(folder, &tiles), BOLAN_OK);
    const bolan_tiles_view back = bolan_tiles_get_view(tiles);
    assert_true(back.n == N && back.frames == 2 && back.length == 2.5 && back.angle == 0.7 && back.period == 3.5);
    assert_true(back.depth == 1.25 && back.paper);
    assert_memory_equal(back.normal, normal, sizeof normal);
    assert_memory_equal(back.detail, detail, sizeof detail);
    assert_memory_equal(back.caustics, caustics, sizeof caustics);
    for (int i = 0; i < 2 * N * N; i++) assert_near(back.height[i], (&height[0][0][0])[i], 0.51 * step);
    bolan_tiles_destroy(&tiles);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(the_index_is_json_in_range, make, clean),
        cmocka_unit_test_setup_teardown(files_of_tiles_hold_what_they_should, make, clean),
        cmocka_unit_test_setup_teardown(what_is_written_is_read_back, make, clean),
        cmocka_unit_test_setup_teardown(damaged_folders_are_refused, make, clean),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

// SPDX-License-Identifier: MIT
// Folders of tiles: written whole, read back, refused with a sentence.
#include "bolan/io.h"
#include "support.h"

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
    d.loop_frames = 2;
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

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(what_is_written_is_read_back, make, clean),
        cmocka_unit_test_setup_teardown(damaged_folders_are_refused, make, clean),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

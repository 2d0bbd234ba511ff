// SPDX-License-Identifier: MIT
// What stands in the picture files, value by value: read back by other code than Bolan's readers and writers. Row is
// told from column, and each channel from every other.
#include "bolan/io.h"
#include "io_support.h"

#include <sys/resource.h>

#pragma GCC diagnostic ignored "-Wunused-function" // of which some are left over
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#include <stb/stb_image.h>

enum { WIDTH = 5, HEIGHT = 37 }; // EXR: two blocks of 16 lines and one of 5

static void png_rows_columns_and_channels_are_in_order(void **state) {
    (void)state;
    uint8_t rgb[HEIGHT][WIDTH][3];
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++)
            rgb[y][x][0] = (uint8_t)(7 * y), rgb[y][x][1] = (uint8_t)(50 * x), rgb[y][x][2] = 3;
    assert_int_equal(bolan_png_write("order.png", WIDTH, HEIGHT, &rgb[0][0][0]), BOLAN_OK);
    int w = 0, h = 0, channels = 0;
    FILE *file = fopen("order.png", "rb");
    assert_non_null(file);
    uint8_t *back = stbi_load_from_file(file, &w, &h, &channels, 0);
    fclose(file);
    assert_non_null(back);
    assert_true(w == WIDTH && h == HEIGHT && channels == 3);
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++) {
            const uint8_t *pixel = back + 3 * (y * WIDTH + x);
            assert_true(pixel[0] == 7 * y && pixel[1] == 50 * x && pixel[2] == 3);
        }
    stbi_image_free(back);
    uint32_t width = 0, height = 0;
    uint8_t *read = NULL;
    assert_int_equal(bolan_image_read("order.png", &width, &height, &read), BOLAN_OK);
    assert_true(width == WIDTH && height == HEIGHT);
    assert_memory_equal(read, rgb, sizeof rgb);
    bolan_release(read, sizeof rgb);
    remove("order.png");
}

// ---- EXR, after the OpenEXR project's "OpenEXR File Layout" ---------------------------------------------------------

static uint32_t word(const uint8_t *p) {
    return (uint32_t)p[0] | (uint32_t)p[1] << 8 | (uint32_t)p[2] << 16 | (uint32_t)p[3] << 24;
}

// The data of the attribute of that name; *end: behind the header.
static const uint8_t *attribute(const uint8_t *file, const char *name, const uint8_t **end) {
    const uint8_t *p = file + 8, *found = NULL;
    while (*p) {
        const char *at = (const char *)p;
        p += strlen(at) + 1;
        p += strlen((const char *)p) + 1; // type
        const uint32_t size = word(p);
        if (strcmp(at, name) == 0) found = p + 4;
        p += 4 + size;
    }
    *end = p + 1;
    return found;
}

// One block of lines as bytes: inflated, the differences summed, the two halves put together again.
static void unpack(const uint8_t *packed, int size, uint8_t *out, int raw) {
    uint8_t bytes[16 * WIDTH * 4 * 4];
    assert_true(raw <= (int)sizeof bytes && size <= raw);
    if (size == raw) {
        memcpy(out, packed, (size_t)raw); // it did not become smaller
        return;
    }
    assert_int_equal(stbi_zlib_decode_buffer((char *)bytes, raw, (const char *)packed, size), raw);
    for (int i = 1; i < raw; i++) bytes[i] = (uint8_t)(bytes[i - 1] + bytes[i] - 128);
    for (int i = 0; i < raw; i++) out[i] = bytes[i / 2 + (i % 2) * ((raw + 1) / 2)];
}

static float value_of(char name, int x, int y) {
    switch (name) {
    case 'R': return (float)(x + 100 * y);
    case 'G': return -0.5f * (float)y;
    case 'B': return 3e-5f * (float)x;
    default: return y < 4 ? HUGE_VALF : 1e4f + (float)y;
    }
}

static void exr_planes_have_their_values_by_name(void **state) {
    (void)state;
    static const char names[] = "RGBZ", sorted[] = "BGRZ";
    static float planes[4][HEIGHT * WIDTH];
    static uint8_t file[65536];
    for (int c = 0; c < 4; c++)
        for (int i = 0; i < HEIGHT * WIDTH; i++) planes[c][i] = value_of(names[c], i % WIDTH, i / WIDTH);
    const bolan_exr_channel channels[] = {{"R", planes[0]}, {"G", planes[1]}, {"B", planes[2]}, {"Z", planes[3]}};
    assert_int_equal(bolan_exr_write("planes.exr", WIDTH, HEIGHT, channels, 4), BOLAN_OK);
    FILE *stream = fopen("planes.exr", "rb");
    assert_non_null(stream);
    const size_t size = fread(file, 1, sizeof file, stream);
    fclose(stream);
    remove("planes.exr");
    assert_true(size > 400 && size < sizeof file);
    const uint8_t *table = NULL, *list = attribute(file, "channels", &table);
    for (int c = 0; c < 4; c++) { // name, NUL, then float (2), and three more words
        assert_true(list[18 * c] == sorted[c] && list[18 * c + 1] == 0);
        assert_int_equal(word(list + 18 * c + 2), 2);
    }
    const uint8_t *window = attribute(file, "dataWindow", &table);
    assert_true(word(window) == 0 && word(window + 4) == 0 && word(window + 8) == WIDTH - 1 &&
                word(window + 12) == HEIGHT - 1);
    assert_int_equal(*attribute(file, "compression", &table), 3); // ZIP, 16 lines
    for (int block = 0; block < 3; block++) {
        const uint8_t *at = file + word(table + 8 * block);
        const int first = 16 * block, lines = block < 2 ? 16 : 5;
        uint8_t raw[16 * WIDTH * 4 * 4];
        assert_int_equal(word(at), first);
        unpack(at + 8, (int)word(at + 4), raw, lines * WIDTH * 4 * 4);
        for (int i = 0; i < lines * 4 * WIDTH; i++) { // line by line, in it channel by channel
            float value;
            memcpy(&value, raw + 4 * i, sizeof value);
            assert_true(value == value_of(sorted[i / WIDTH % 4], i % WIDTH, first + i / (4 * WIDTH)));
        }
    }
}

// A few bytes that ask for a gigabyte: refused by the header, in little memory.
static void a_picture_cannot_ask_for_more_than_it_holds(void **state) {
    (void)state;
    uint32_t width, height;
    uint8_t *rgb = NULL;
    struct rlimit before;
    getrlimit(RLIMIT_AS, &before);
#if !defined(__SANITIZE_ADDRESS__)
    setrlimit(RLIMIT_AS, &(struct rlimit){512u << 20, before.rlim_max});
#endif
    assert_refusal(
        bolan_image_read(BOLAN_SOURCE_DIR "/tests/data/hostile/png_1GB_allocation_340B.png", &width, &height, &rgb),
        BOLAN_ERROR_FORMAT, BOLAN_LOG_IMAGE_FORMAT,
        "png_1GB_allocation_340B.png: not a picture that can be read: a part of the PNG is longer");
    assert_null(rgb);
    // And one whose size is the lie: 1024 x 512 of 1 bit in 57 bytes, which can hold 57 * 8 * 1032 = 470592. 680 x 680
    // they can: that one fails later.
    uint8_t lie[57] = "\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR\0\0\4\0\0\0\2\0\1\0\0\0\0\0\0\0\0"
                      "\0\0\0\0IDAT\0\0\0\0\0\0\0\0IEND";
    assert_int_equal(bolan_file_write("lie.png", lie, sizeof lie), BOLAN_OK);
    assert_refusal(bolan_image_read("lie.png", &width, &height, &rgb), BOLAN_ERROR_FORMAT, BOLAN_LOG_IMAGE_FORMAT,
                   "lie.png: its header says 1024 x 512 pixels");
    lie[18] = lie[22] = 0x02, lie[19] = lie[23] = 0xA8;
    assert_int_equal(bolan_file_write("lie.png", lie, sizeof lie), BOLAN_OK);
    assert_refusal(bolan_image_read("lie.png", &width, &height, &rgb), BOLAN_ERROR_FORMAT, BOLAN_LOG_IMAGE_FORMAT,
                   "lie.png: not a picture that can be read");
    remove("lie.png");
    setrlimit(RLIMIT_AS, &before);
    assert_null(rgb);
    // The emptiest picture that there is passes: one grey of 2048 x 2048 in a few kilobytes.
    uint8_t *grey = calloc(2048 * 2048, 3);
    assert_int_equal(bolan_png_write("empty.png", 2048, 2048, grey), BOLAN_OK);
    free(grey);
    assert_int_equal(bolan_image_read("empty.png", &width, &height, &rgb), BOLAN_OK);
    assert_true(width == 2048 && height == 2048);
    bolan_release(rgb, 2048 * 2048 * 3);
    remove("empty.png");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(png_rows_columns_and_channels_are_in_order),
        cmocka_unit_test(exr_planes_have_their_values_by_name),
        cmocka_unit_test(a_picture_cannot_ask_for_more_than_it_holds),
    };
    return cmocka_run_group_tests(tests, listen_to_log, NULL);
}

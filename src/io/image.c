// SPDX-License-Identifier: MIT
// 8-bit images: writes PNG, reads the formats of stb_image.
#include "io/file.h"

#include <string.h>

// The code of stb as static functions of this file, since an application may link its own stb.
#pragma GCC diagnostic ignored "-Wunused-function" // stb functions that are not called
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_NO_STDIO
#define STBI_NO_HDR
#define STBI_NO_LINEAR
#define STBI_MAX_DIMENSIONS 16384
#include <stb/stb_image.h>

#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>

enum { LARGEST_SIDE = STBI_MAX_DIMENSIONS, IMAGE_FILE_LIMIT = 512 << 20 };
// Deflate makes at most 1032 bytes of one (zlib, "Maximum Compression Factor"), and a byte of a PNG holds 8 pixels at
// most. The other formats compress less.
enum { MOST_PIXELS_PER_BYTE = 8 * 1032 };

static bolan_result check_size(const char *path, uint32_t width, uint32_t height) {
    if (width >= 1 && width <= BOLAN_IMAGE_MOST_SIDE && height >= 1 && height <= BOLAN_IMAGE_MOST_SIDE &&
        (uint64_t)width * height <= BOLAN_IMAGE_MOST_PIXELS)
        return BOLAN_OK;
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_RANGE,
              "%s: a picture of %ux%u; expected 1 to %d each way, and at most %u pixels in all", path, (unsigned)width,
              (unsigned)height, BOLAN_IMAGE_MOST_SIDE, BOLAN_IMAGE_MOST_PIXELS);
    return BOLAN_ERROR_ARGUMENT;
}

bolan_result bolan_png_write(const char *path, uint32_t width, uint32_t height, const uint8_t *rgb) {
    BOLAN_ASSERT(path && rgb);
    if (check_size(path, width, height)) return BOLAN_ERROR_ARGUMENT;
    int size = 0;
    unsigned char *png = stbi_write_png_to_mem(rgb, (int)(3 * width), (int)width, (int)height, 3, &size);
    if (!png) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY, "%s: no memory to compress the picture", path);
        return BOLAN_ERROR_MEMORY;
    }
    const bolan_result result = bolan_file_write(path, png, (size_t)size);
    STBIW_FREE(png);
    return result;
}

static bolan_result not_a_picture(const char *path, const char *reason) {
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_IMAGE_FORMAT, "%s: not a picture that can be read: %s", path, reason);
    return BOLAN_ERROR_FORMAT;
}

// The decoder reserves the stated length of a PNG chunk before it reads the chunk.
static bool png_chunks_fit(const file_text *file) {
    static const uint8_t signature[8] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
    const uint8_t *data = (const uint8_t *)file->data;
    if (file->size < 8 || memcmp(data, signature, 8) != 0) return true; // another format
    for (size_t at = 8; file->size - at >= 8;) {                        // length, type, data, checksum
        const size_t length =
            (size_t)data[at] << 24 | (size_t)data[at + 1] << 16 | (size_t)data[at + 2] << 8 | data[at + 3];
        if (memcmp(data + at + 4, "IEND", 4) == 0) return true;
        if (length > file->size - at - 8 || file->size - at - 8 - length < 4) return false;
        at += 12 + length;
    }
    return false;
}

// The decoder reserves the size in the header: a file of a few bytes could cost a gigabyte.
static bolan_result check_header(const char *path, const file_text *file) {
    int w = 0, h = 0, channels = 0;
    if (!png_chunks_fit(file)) return not_a_picture(path, "a part of the PNG is longer than the file; is it cut off?");
    if (!stbi_info_from_memory((const stbi_uc *)file->data, (int)file->size, &w, &h, &channels))
        return not_a_picture(path, stbi_failure_reason());
    const bool good = w >= 1 && w <= LARGEST_SIDE && h >= 1 && h <= LARGEST_SIDE;
    if (good && (size_t)w * (size_t)h <= file->size * MOST_PIXELS_PER_BYTE) return BOLAN_OK;
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_IMAGE_FORMAT,
              "%s: its header says %d x %d pixels; expected 1 to %d each way, and no more than %zu bytes can hold",
              path, w, h, LARGEST_SIDE, file->size);
    return BOLAN_ERROR_FORMAT;
}

static bool is_out_of_memory(void) { return strcmp(stbi_failure_reason(), "outofmem") == 0; }

static bolan_result no_memory(const char *path) {
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY, "%s: no memory for the picture", path);
    return BOLAN_ERROR_MEMORY;
}

bolan_result bolan_image_read(const char *path, uint32_t *width, uint32_t *height, uint8_t **rgb) {
    BOLAN_ASSERT(path && width && height && rgb);
    *rgb = NULL;
    file_text file;
    bolan_result result = bolan_file_read(path, IMAGE_FILE_LIMIT, &file);
    if (!result) result = check_header(path, &file);
    if (result) return bolan_file_release(&file), result;
    int w = 0, h = 0, channels = 0;
    stbi_uc *pixels = stbi_load_from_memory((const stbi_uc *)file.data, (int)file.size, &w, &h, &channels, 3);
    bolan_file_release(&file);
    if (!pixels) return is_out_of_memory() ? no_memory(path) : not_a_picture(path, stbi_failure_reason());
    const size_t bytes = (size_t)w * (size_t)h * 3;
    *rgb = bolan_allocate(bytes);
    if (*rgb) memcpy(*rgb, pixels, bytes);
    stbi_image_free(pixels);
    *width = (uint32_t)w;
    *height = (uint32_t)h;
    return *rgb ? BOLAN_OK : no_memory(path);
}

// SPDX-License-Identifier: MIT
// 8-bit pictures: PNG out, what stb_image knows in.
#include "io/file.h"

#include <stdio.h>
#include <string.h>

// stb's code as static functions of this file: an application may have its own stb.
#pragma GCC diagnostic ignored "-Wunused-function" // of which some are left over
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

enum { LARGEST_SIDE = 16384, IMAGE_FILE_LIMIT = 512 << 20 };

static bolan_result check_size(const char *path, uint32_t width, uint32_t height) {
    if (width >= 1 && width <= LARGEST_SIDE && height >= 1 && height <= LARGEST_SIDE) return BOLAN_OK;
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_RANGE, "%s: a picture of %ux%u; expected 1 to %d each way", path,
              (unsigned)width, (unsigned)height, LARGEST_SIDE);
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

bolan_result bolan_image_read(const char *path, uint32_t *width, uint32_t *height, uint8_t **rgb) {
    BOLAN_ASSERT(path && width && height && rgb);
    *rgb = NULL;
    file_text file;
    bolan_result result = file_read(path, IMAGE_FILE_LIMIT, &file);
    if (result) return result;
    int w = 0, h = 0, channels = 0;
    stbi_uc *pixels = stbi_load_from_memory((const stbi_uc *)file.data, (int)file.size, &w, &h, &channels, 3);
    file_release(&file);
    if (!pixels) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_IMAGE_FORMAT, "%s: not a picture that can be read: %s", path,
                  stbi_failure_reason());
        return BOLAN_ERROR_FORMAT;
    }
    const size_t bytes = (size_t)w * (size_t)h * 3;
    *rgb = bolan_allocate(bytes);
    if (*rgb) memcpy(*rgb, pixels, bytes);
    stbi_image_free(pixels);
    *width = (uint32_t)w;
    *height = (uint32_t)h;
    return *rgb ? BOLAN_OK : BOLAN_ERROR_MEMORY;
}

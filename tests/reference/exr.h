// SPDX-License-Identifier: MIT
// Half-float images in OpenEXR's simplest form: one part of scan lines without compression, so that no library is
// needed to read them. Channels: B, G, R, "sunless" (G without the sun's reflection) and "sigma" (the standard error of
// that). Little-endian machines.
// Source: "OpenEXR File Layout", openexr.com.
#ifndef BOLAN_REFERENCE_EXR_H
#define BOLAN_REFERENCE_EXR_H

#include "math/half.h"
#include "views.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>

enum { EXR_HEADER_MAX = 512, EXR_LINE = 8 + REFERENCE_CHANNELS * REFERENCE_WIDTH * 2 };
static const int exr_order[REFERENCE_CHANNELS] = {2, 1, 0, 3, 4}; // of the file: names in alphabetical order

static inline void exr_put(uint8_t *out, size_t *at, const void *bytes, size_t count) {
    memcpy(out + *at, bytes, count);
    *at += count;
}

static inline void exr_attribute(uint8_t *out, size_t *at, const char *name, const char *type, const void *value,
                                 uint32_t size) {
    exr_put(out, at, name, strlen(name) + 1);
    exr_put(out, at, type, strlen(type) + 1);
    exr_put(out, at, &size, 4);
    exr_put(out, at, value, size);
}

// Everything before the scan lines; the same bytes for each image. Returns their number.
static inline size_t exr_header(uint8_t out[EXR_HEADER_MAX]) {
    static const char *const names[REFERENCE_CHANNELS] = {"B", "G", "R", "sigma", "sunless"};
    const uint32_t magic[2] = {20000630, 2};
    const int32_t half_channel[4] = {1, 0, 1, 1}, box[4] = {0, 0, REFERENCE_WIDTH - 1, REFERENCE_HEIGHT - 1};
    const float one = 1.0f, middle[2] = {0.0f, 0.0f};
    uint8_t channels[128], zero = 0;
    size_t at = 0, size = 0;
    for (int c = 0; c < REFERENCE_CHANNELS; ++c) {
        exr_put(channels, &size, names[c], strlen(names[c]) + 1);
        exr_put(channels, &size, half_channel, sizeof half_channel);
    }
    exr_put(channels, &size, &zero, 1);
    exr_put(out, &at, magic, sizeof magic);
    exr_attribute(out, &at, "channels", "chlist", channels, (uint32_t)size);
    exr_attribute(out, &at, "compression", "compression", &zero, 1);
    exr_attribute(out, &at, "dataWindow", "box2i", box, sizeof box);
    exr_attribute(out, &at, "displayWindow", "box2i", box, sizeof box);
    exr_attribute(out, &at, "lineOrder", "lineOrder", &zero, 1);
    exr_attribute(out, &at, "pixelAspectRatio", "float", &one, 4);
    exr_attribute(out, &at, "screenWindowCenter", "v2f", middle, sizeof middle);
    exr_attribute(out, &at, "screenWindowWidth", "float", &one, 4);
    exr_put(out, &at, &zero, 1);
    return at;
}

// pixels: REFERENCE_PIXELS x REFERENCE_CHANNELS, row 0 at the top.
static inline bool reference_write(const char *path, const float *pixels) {
    uint8_t header[EXR_HEADER_MAX];
    const size_t size = exr_header(header);
    FILE *file = fopen(path, "wb");
    if (file == NULL) return false;
    bool good = fwrite(header, 1, size, file) == size;
    for (uint64_t y = 0; y < REFERENCE_HEIGHT; ++y) {
        const uint64_t offset = size + 8 * REFERENCE_HEIGHT + y * EXR_LINE;
        good = fwrite(&offset, 8, 1, file) == 1 && good;
    }
    for (int32_t y = 0; y < REFERENCE_HEIGHT; ++y) {
        const int32_t head[2] = {y, EXR_LINE - 8};
        uint16_t line[REFERENCE_CHANNELS][REFERENCE_WIDTH];
        for (int c = 0; c < REFERENCE_CHANNELS; ++c)
            for (int x = 0; x < REFERENCE_WIDTH; ++x)
                line[c][x] = half_from_float(pixels[REFERENCE_CHANNELS * (y * REFERENCE_WIDTH + x) + exr_order[c]]);
        good = fwrite(head, 4, 2, file) == 2 && fwrite(line, 1, sizeof line, file) == sizeof line && good;
    }
    return fclose(file) == 0 && good;
}

// Reads what reference_write() wrote; false for any other file.
static inline bool reference_read(const char *path, float *pixels) {
    uint8_t header[EXR_HEADER_MAX], found[EXR_HEADER_MAX];
    const size_t size = exr_header(header);
    FILE *file = fopen(path, "rb");
    if (file == NULL) return false;
    bool good = fread(found, 1, size, file) == size && memcmp(header, found, size) == 0 &&
                fseek(file, 8 * REFERENCE_HEIGHT, SEEK_CUR) == 0;
    for (int32_t y = 0; y < REFERENCE_HEIGHT && good; ++y) {
        int32_t head[2];
        uint16_t line[REFERENCE_CHANNELS][REFERENCE_WIDTH];
        good = fread(head, 4, 2, file) == 2 && head[0] == y && fread(line, 1, sizeof line, file) == sizeof line;
        for (int c = 0; c < REFERENCE_CHANNELS && good; ++c)
            for (int x = 0; x < REFERENCE_WIDTH; ++x)
                pixels[REFERENCE_CHANNELS * (y * REFERENCE_WIDTH + x) + exr_order[c]] = float_from_half(line[c][x]);
    }
    fclose(file);
    return good;
}

#endif

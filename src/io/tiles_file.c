// SPDX-License-Identifier: MIT
// Folders of tiles: index.json, and for each frame height_NNN.pgm (16-bit grey), normal_NNN.png, detail_NNN.png, caustics_NNN.png.
// Row 0 of a picture is row 0 of the tile.
#include "io/file.h"

#include <dirent.h>
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { PGM_HEADER = 32, INDEX_LIMIT = 1 << 16, PICTURE_LIMIT = 1 << 24, TILE_NAME = FILE_NAME_CAPACITY + 32 };
static const char *const kinds[] = {"height", "normal", "detail", "caustics"};
static const char *const endings[] = {"pgm", "png", "png", "png"};
enum { HEIGHT, NORMAL, DETAIL, CAUSTICS, KINDS };

static void name_of(const char *folder, int kind, uint32_t frame, char out[TILE_NAME]) {
    snprintf(out, TILE_NAME, "%s/%s_%03u.%s", folder, kinds[kind], (unsigned)frame, endings[kind]);
}

// ---- writing --------------------------------------------------------------------------------------------------------

static double height_step(const bolan_tiles_view *v) {
    double most = 1e-6;
    for (size_t i = 0; i < (size_t)v->frames * v->n * v->n; i++) most = fmax(most, fabs((double)v->height[i]));
    return most / 32767.0;
}

// Heights as steps from 32768, the larger byte first, as the format wants it.
static bolan_result write_height(const char *path, const float *height, uint32_t n, double step) {
    const size_t size = (size_t)n * n * 2 + PGM_HEADER;
    uint8_t *data = bolan_allocate(size);
    if (!data) return BOLAN_ERROR_MEMORY;
    const int header = snprintf((char *)data, PGM_HEADER, "P5\n%u %u\n65535\n", (unsigned)n, (unsigned)n);
    uint8_t *out = data + header;
    for (size_t i = 0; i < (size_t)n * n; i++, out += 2) {
        const unsigned value = (unsigned)(32768.0 + floor((double)height[i] / step + 0.5));
        out[0] = (uint8_t)(value >> 8), out[1] = (uint8_t)value;
    }
    const bolan_result result = bolan_file_write(path, data, (size_t)header + (size_t)n * n * 2);
    bolan_release(data, size);
    return result;
}

static bolan_result write_grey(const char *path, const uint8_t *grey, uint32_t n) {
    const size_t size = (size_t)n * n;
    uint8_t *rgb = bolan_allocate(3 * size);
    if (!rgb) return BOLAN_ERROR_MEMORY;
    for (size_t i = 0; i < 3 * size; i++) rgb[i] = grey[i / 3];
    const bolan_result result = bolan_png_write(path, n, n, rgb);
    bolan_release(rgb, 3 * size);
    return result;
}

static bolan_result write_frame(const char *folder, const bolan_tiles_view *v, uint32_t frame, double step) {
    const size_t size = (size_t)v->n * v->n, at = frame * size;
    char path[KINDS][TILE_NAME];
    for (int k = 0; k < KINDS; k++) name_of(folder, k, frame, path[k]);
    bolan_result result = write_height(path[HEIGHT], v->height + at, v->n, step);
    if (!result) result = bolan_png_write(path[NORMAL], v->n, v->n, v->normal + 3 * at);
    if (!result) result = bolan_png_write(path[DETAIL], v->n, v->n, v->detail + 3 * at);
    return result ? result : write_grey(path[CAUSTICS], v->caustics + at, v->n);
}

static bolan_result write_index(const char *folder, const bolan_tiles_view *v, double step) {
    char text[1024], path[TILE_NAME];
    snprintf(path, sizeof path, "%s/index.json", folder);
    const int size = snprintf(
        text, sizeof text,
        "{\n  \"bolan_tiles\": 1,\n  \"n\": %u,\n  \"frames\": %u,\n  \"length\": %.17g,\n  \"angle\": %.17g,\n"
        "  \"period\": %.17g,\n  \"depth\": %.17g,\n  \"paper\": %d,\n  \"height_step\": %.17g,\n"
        "  \"caustics_range\": %g\n}\n",
        (unsigned)v->n, (unsigned)v->frames, v->length, v->angle, v->period, v->depth, v->paper ? 1 : 0, step,
        BOLAN_CAUSTICS_RANGE);
    return bolan_file_write(path, text, (size_t)size);
}

// A folder with nothing but files in it.
static void remove_folder(const char *folder) {
    DIR *d = opendir(folder);
    char path[TILE_NAME + 256];
    for (struct dirent *e; d && (e = readdir(d)) != NULL;) {
        snprintf(path, sizeof path, "%s/%s", folder, e->d_name);
        if (e->d_name[0] != '.') unlink(path);
    }
    if (d) closedir(d);
    rmdir(folder);
}

bolan_result bolan_tiles_check_writable(const char *folder) {
    BOLAN_ASSERT(folder);
    char temporary[FILE_NAME_CAPACITY];
    struct stat status;
    errno = strlen(folder) >= BOLAN_PATH_MAX ? ENAMETOOLONG : stat(folder, &status) == 0 ? EEXIST : 0;
    if (errno) return file_cannot_write(folder);
    snprintf(temporary, sizeof temporary, "%s.part%ld", folder, (long)getpid());
    if (mkdir(temporary, 0777) != 0) return file_cannot_write(folder);
    rmdir(temporary);
    return BOLAN_OK;
}

bolan_result bolan_tiles_save(const bolan_tiles *tiles, const char *folder) {
    BOLAN_ASSERT(tiles && folder);
    const bolan_tiles_view v = bolan_tiles_get_view(tiles);
    const double step = height_step(&v);
    char temporary[FILE_NAME_CAPACITY];
    bolan_result result = bolan_tiles_check_writable(folder);
    if (result) return result;
    snprintf(temporary, sizeof temporary, "%s.part%ld", folder, (long)getpid());
    if (mkdir(temporary, 0777) != 0) return file_cannot_write(folder);
    result = write_index(temporary, &v, step);
    for (uint32_t f = 0; f < v.frames && !result; f++) result = write_frame(temporary, &v, f, step);
    if (!result && rename(temporary, folder) != 0) result = file_cannot_write(folder);
    if (result) remove_folder(temporary);
    return result;
}

// ---- reading --------------------------------------------------------------------------------------------------------

static bolan_result bad(const char *path, const char *what) {
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_IMAGE_FORMAT, "%s: %s", path, what);
    return BOLAN_ERROR_FORMAT;
}

// The number after "key": in a flat object; NAN where it is not.
static double number_of(const char *text, const char *key) {
    char quoted[32];
    snprintf(quoted, sizeof quoted, "\"%s\"", key);
    const char *at = strstr(text, quoted);
    at = at ? strchr(at, ':') : NULL;
    char *end = NULL;
    const double value = at ? strtod(at + 1, &end) : 0.0;
    return at && end != at + 1 ? value : (double)NAN;
}

static bool whole(double x, double low, double high) { return x >= low && x <= high && x == floor(x); }

static bolan_result read_index(const char *folder, bolan_tiles_view *v, double *step) {
    char path[TILE_NAME], sentence[96];
    snprintf(path, sizeof path, "%s/index.json", folder);
    file_text text;
    const bolan_result result = file_read(path, INDEX_LIMIT, &text);
    if (result) return result;
    static const char *const keys[] = {"n", "frames", "length", "angle", "period", "depth", "paper", "height_step"};
    double x[8];
    int missing = -1;
    for (int i = 7; i >= 0; i--) {
        x[i] = number_of(text.data, keys[i]);
        if (isnan(x[i])) missing = i;
    }
    file_release(&text);
    snprintf(sentence, sizeof sentence, "no number \"%s\"; expected the index of a folder of tiles",
             missing < 0 ? "" : keys[missing]);
    if (missing >= 0) return bad(path, sentence);
    if (!whole(x[0], 8, 1024) || ((uint32_t)x[0] & ((uint32_t)x[0] - 1)) != 0)
        return bad(path, "\"n\" is not a power of two 8..1024");
    if (!whole(x[1], 1, BOLAN_MAX_LOOP_FRAMES)) return bad(path, "\"frames\" is not 1..64");
    if (!(x[7] > 0.0 && x[7] < 1e3)) return bad(path, "\"height_step\" is not above 0");
    *v = (bolan_tiles_view){.n = (uint32_t)x[0],
                            .frames = (uint32_t)x[1],
                            .length = x[2],
                            .angle = x[3],
                            .period = x[4],
                            .depth = x[5],
                            .paper = x[6] != 0.0};
    *step = x[7];
    return BOLAN_OK;
}

static bolan_result read_height(const char *path, uint32_t n, double step, float *height) {
    file_text file;
    const bolan_result result = file_read(path, PICTURE_LIMIT, &file);
    if (result) return result;
    unsigned width = 0, rows = 0, most = 0;
    int header = 0;
    const bool read = sscanf(file.data, "P5 %u %u %u%n", &width, &rows, &most, &header) == 3 && width == n &&
                      rows == n && most == 65535;
    const bool fits = read && file.size == (size_t)header + 1 + (size_t)n * n * 2;
    const uint8_t *in = (const uint8_t *)file.data + header + 1;
    for (size_t i = 0; fits && i < (size_t)n * n; i++, in += 2)
        height[i] = (float)(((in[0] << 8 | in[1]) - 32768) * step);
    file_release(&file);
    return fits ? BOLAN_OK : bad(path, "not a 16-bit PGM of the size that the index says");
}

// Of each pixel the first `channels` values.
static bolan_result read_bytes(const char *path, uint32_t n, size_t channels, uint8_t *out) {
    uint32_t width, rows;
    uint8_t *rgb;
    const bolan_result result = bolan_image_read(path, &width, &rows, &rgb);
    if (result) return result;
    const bool fits = width == n && rows == n;
    for (size_t i = 0; fits && i < (size_t)n * n; i++) memcpy(out + i * channels, rgb + 3 * i, channels);
    bolan_release(rgb, (size_t)width * rows * 3);
    return fits ? BOLAN_OK : bad(path, "not of the size that the index says");
}

static bolan_result read_frames(const char *folder, const bolan_tiles_view *v, double step, float *height,
                                uint8_t *bytes) {
    const size_t size = (size_t)v->n * v->n, all = size * v->frames;
    bolan_result result = BOLAN_OK;
    for (uint32_t f = 0; f < v->frames && !result; f++) {
        char path[KINDS][TILE_NAME];
        for (int k = 0; k < KINDS; k++) name_of(folder, k, f, path[k]);
        result = read_height(path[HEIGHT], v->n, step, height + f * size);
        if (!result) result = read_bytes(path[NORMAL], v->n, 3, bytes + 3 * f * size);
        if (!result) result = read_bytes(path[DETAIL], v->n, 3, bytes + 3 * all + 3 * f * size);
        if (!result) result = read_bytes(path[CAUSTICS], v->n, 1, bytes + 6 * all + f * size);
    }
    return result;
}

bolan_result bolan_tiles_load(const char *folder, bolan_tiles **out) {
    BOLAN_ASSERT(folder && out);
    *out = NULL;
    bolan_tiles_view v;
    double step;
    bolan_result result = read_index(folder, &v, &step);
    if (result) return result;
    const size_t all = (size_t)v.frames * v.n * v.n;
    float *height = bolan_allocate(all * sizeof *height);
    uint8_t *bytes = bolan_allocate(7 * all);
    result = height && bytes ? read_frames(folder, &v, step, height, bytes) : BOLAN_ERROR_MEMORY;
    v.height = height, v.normal = bytes;
    if (!result) v.detail = bytes + 3 * all, v.caustics = bytes + 6 * all;
    if (!result) result = bolan_tiles_create(&v, out);
    bolan_release(height, all * sizeof *height);
    bolan_release(bytes, 7 * all);
    return result;
}

// SPDX-License-Identifier: MIT
// Folders of tiles: index.json, and for each frame height_NNN.pgm (16-bit grey), normal_NNN.png, detail_NNN.png,
// caustics_NNN.png. Row 0 of an image is row 0 of the tile.
#include "io/file.h"
#include "io/tiles_index.h"

#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <poll.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { PGM_HEADER = 32, PICTURE_LIMIT = 1 << 24, TILE_NAME = FILE_NAME_CAPACITY + 32 };
static const char *const kinds[] = {"height", "normal", "detail", "caustics"};
static const char *const endings[] = {"pgm", "png", "png", "png"};
enum { HEIGHT, NORMAL, DETAIL, CAUSTICS, KINDS };

static void name_of(const char *folder, int kind, uint32_t frame, char out[TILE_NAME]) {
    snprintf(out, TILE_NAME, "%s/%s_%03u.%s", folder, kinds[kind], (unsigned)frame, endings[kind]);
}

static bolan_result no_memory(const char *path) {
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY, "%s: no memory for a frame of tiles", path);
    return BOLAN_ERROR_MEMORY;
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
    if (!data) return no_memory(path);
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
    if (!rgb) return no_memory(path);
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
    char text[TILES_INDEX_CAPACITY], path[TILE_NAME];
    snprintf(path, sizeof path, "%s/index.json", folder);
    return bolan_file_write(path, text, bolan_tiles_index_print(v, step, text));
}

// Like name_of(), without the folder and async-signal-safe.
static void bare_name_of(int kind, uint32_t frame, char out[32]) {
    const char digits[5] = {'_', (char)('0' + frame / 100 % 10), (char)('0' + frame / 10 % 10),
                            (char)('0' + frame % 10), '\0'};
    const char *const parts[] = {kinds[kind], digits, ".", endings[kind]};
    for (size_t i = 0; i < 4; i++)
        for (const char *c = parts[i]; *c; c++) *out++ = *c;
    *out = '\0';
}

// Removes an incomplete folder of tiles. Async-signal-safe. Tries again where another thread was writing a file.
static void remove_folder(const char *path) {
    const int folder = open(path, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    char name[32];
    for (int attempt = 0; attempt < 50 && folder >= 0; attempt++) {
        for (uint32_t f = 0; f < BOLAN_MAX_LOOP_FRAMES; f++)
            for (int k = 0; k < KINDS; k++) bare_name_of(k, f, name), unlinkat(folder, name, 0);
        unlinkat(folder, "index.json", 0);
        if (rmdir(path) == 0 || errno == ENOENT) break;
        poll(NULL, 0, 5);
    }
    if (folder >= 0) close(folder);
}

// The folder without a slash at its end. IO with a sentence where the path exists.
static bolan_result find_folder(const char *folder, char out[BOLAN_PATH_MAX]) {
    struct stat status;
    size_t length = strlen(folder);
    while (length > 1 && folder[length - 1] == '/') length--;
    errno = length == 0 ? ENOENT : ENAMETOOLONG;
    if (length == 0 || length >= BOLAN_PATH_MAX) return bolan_file_cannot_write(folder);
    memcpy(out, folder, length);
    out[length] = '\0';
    errno = EEXIST; // also for a dangling link
    return lstat(out, &status) == 0 ? bolan_file_cannot_write(folder) : BOLAN_OK;
}

// Makes an empty folder under a new temporary name.
static bolan_result make_folder(const char *folder, char temporary[FILE_NAME_CAPACITY], unfinished *entry) {
    char target[BOLAN_PATH_MAX];
    if (find_folder(folder, target)) return BOLAN_ERROR_IO;
    for (int attempt = 0; attempt < 100; attempt++) {
        bolan_file_temporary_name(target, attempt, temporary);
        *entry = bolan_unfinished_claim(temporary, remove_folder);
        if (mkdir(temporary, 0777) == 0) return bolan_unfinished_own(entry, 0), BOLAN_OK;
        const int reason = errno;
        bolan_unfinished_forget(entry);
        errno = reason;
        if (errno != EEXIST) break;
    }
    return bolan_file_cannot_write(folder);
}

bolan_result bolan_tiles_check_writable(const char *folder) {
    BOLAN_ASSERT(folder);
    char temporary[FILE_NAME_CAPACITY];
    unfinished entry;
    if (make_folder(folder, temporary, &entry)) return BOLAN_ERROR_IO;
    rmdir(temporary);
    bolan_unfinished_forget(&entry);
    return BOLAN_OK;
}

bolan_result bolan_tiles_save(const bolan_tiles *tiles, const char *folder) {
    BOLAN_ASSERT(tiles && folder);
    const bolan_tiles_view v = bolan_tiles_get_view(tiles);
    const double step = height_step(&v);
    char temporary[FILE_NAME_CAPACITY], target[BOLAN_PATH_MAX];
    unfinished entry;
    if (make_folder(folder, temporary, &entry)) return BOLAN_ERROR_IO;
    bolan_result result = write_index(temporary, &v, step);
    for (uint32_t f = 0; f < v.frames && !result; f++) result = write_frame(temporary, &v, f, step);
    bolan_unfinished_wait_if_abandoned();
    if (!result) result = find_folder(folder, target);
    if (!result && rename(temporary, target) != 0) result = bolan_file_cannot_write(folder);
    if (result) remove_folder(temporary);
    bolan_unfinished_forget(&entry);
    return result;
}

// ---- reading --------------------------------------------------------------------------------------------------------

static bolan_result bad(const char *path, const char *what) {
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_IMAGE_FORMAT, "%s: %s", path, what);
    return BOLAN_ERROR_FORMAT;
}

static bolan_result read_index(const char *folder, bolan_tiles_view *v, double *step) {
    char path[TILE_NAME];
    snprintf(path, sizeof path, "%s/index.json", folder);
    file_text text;
    bolan_result result = bolan_file_read(path, TILES_INDEX_LIMIT, &text);
    if (!result) result = bolan_tiles_index_parse(path, text.data, text.size, v, step);
    bolan_file_release(&text);
    return result;
}

static bolan_result read_height(const char *path, uint32_t n, double step, float *height) {
    file_text file;
    const bolan_result result = bolan_file_read(path, PICTURE_LIMIT, &file);
    if (result) return result;
    unsigned width = 0, rows = 0, most = 0;
    int header = 0;
    const bool read = sscanf(file.data, "P5 %u %u %u%n", &width, &rows, &most, &header) == 3 && width == n &&
                      rows == n && most == 65535;
    const bool fits = read && file.size == (size_t)header + 1 + (size_t)n * n * 2;
    const uint8_t *in = (const uint8_t *)file.data + header + 1;
    for (size_t i = 0; fits && i < (size_t)n * n; i++, in += 2)
        height[i] = (float)(((in[0] << 8 | in[1]) - 32768) * step);
    bolan_file_release(&file);
    return fits ? BOLAN_OK : bad(path, "not a 16-bit PGM of the size that the index says");
}

// Reads the first `channels` values of each pixel.
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

// An index of a few bytes could cause a gigabyte of allocations, so the files of heights must exist first.
static bolan_result check_sizes(const char *folder, const bolan_tiles_view *v) {
    for (uint32_t f = 0; f < v->frames; f++) {
        char path[TILE_NAME];
        struct stat status;
        name_of(folder, HEIGHT, f, path);
        if (stat(path, &status) != 0) {
            bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_FILE_OPEN, "%s: cannot be read: %s", path, strerror(errno));
            return BOLAN_ERROR_IO;
        }
        if (status.st_size < (off_t)v->n * v->n * 2)
            return bad(path, "not a 16-bit PGM of the size that the index says");
    }
    return BOLAN_OK;
}

bolan_result bolan_tiles_load(const char *folder, bolan_tiles **out) {
    BOLAN_ASSERT(folder && out);
    *out = NULL;
    bolan_tiles_view v;
    double step;
    bolan_result result = read_index(folder, &v, &step);
    if (!result) result = check_sizes(folder, &v);
    if (result) return result;
    const size_t all = (size_t)v.frames * v.n * v.n;
    float *height = bolan_allocate(all * sizeof *height);
    uint8_t *bytes = bolan_allocate(7 * all);
    result = height && bytes ? read_frames(folder, &v, step, height, bytes) : no_memory(folder);
    v.height = height, v.normal = bytes;
    if (!result) v.detail = bytes + 3 * all, v.caustics = bytes + 6 * all;
    if (!result) result = bolan_tiles_create(&v, out);
    bolan_release(height, all * sizeof *height);
    bolan_release(bytes, 7 * all);
    return result;
}

// SPDX-License-Identifier: MIT
// See file.h and the file functions of bolan/io.h.
#include "io/file.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

// ---- reading --------------------------------------------------------------------------------------------------------

static bolan_result cannot_read(bolan_log_id id, const char *path, const char *reason) {
    bolan_log(BOLAN_LOG_ERROR, id, "%s: cannot be read: %s", path, reason);
    return BOLAN_ERROR_IO;
}

static bolan_result read_stream(FILE *stream, const char *path, size_t limit, file_text *out) {
    size_t capacity = 0;
    char *data = NULL;
    size_t size = 0;
    for (;;) {
        if (size == capacity) { // the size is not known before the end: the file may be a pipe
            const size_t larger = capacity ? 2 * capacity : 65536;
            char *next = bolan_allocate(larger + 1);
            if (next && data) memcpy(next, data, size);
            bolan_release(data, capacity + 1);
            if (!next) {
                bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY, "%s: no memory to read it", path);
                return BOLAN_ERROR_MEMORY;
            }
            data = next;
            capacity = larger;
        }
        const size_t got = fread(data + size, 1, capacity - size, stream);
        size += got;
        if (got == 0 || size > limit) break;
    }
    bolan_result result = BOLAN_OK;
    if (ferror(stream)) {
        result = cannot_read(BOLAN_LOG_FILE_READ, path, strerror(errno));
    } else if (size > limit) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_FILE_TOO_LARGE, "%s: larger than %zu MiB; expected a smaller file", path,
                  limit >> 20);
        result = BOLAN_ERROR_IO;
    }
    // Give the exact size back, so that the owner need not remember the capacity.
    char *exact = result ? NULL : bolan_allocate(size + 1);
    if (exact) memcpy(exact, data, size);
    if (!result && !exact) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY, "%s: no memory to read it", path);
        result = BOLAN_ERROR_MEMORY;
    }
    bolan_release(data, capacity + 1);
    *out = (file_text){exact, exact ? size : 0};
    return result;
}

bolan_result file_read(const char *path, size_t limit, file_text *out) {
    *out = (file_text){NULL, 0};
    struct stat status;
    if (stat(path, &status) == 0 && S_ISDIR(status.st_mode))
        return cannot_read(BOLAN_LOG_FILE_OPEN, path, "it is a folder");
    FILE *stream = fopen(path, "rb");
    if (!stream) return cannot_read(BOLAN_LOG_FILE_OPEN, path, strerror(errno));
    const bolan_result result = read_stream(stream, path, limit, out);
    fclose(stream);
    return result;
}

void file_release(file_text *text) {
    if (text->data) bolan_release(text->data, text->size + 1);
    *text = (file_text){NULL, 0};
}

bool file_resolve(const char *beside, const char *name, char out[BOLAN_PATH_MAX]) {
    const char *slash = strrchr(beside, '/');
    const int folder = name[0] == '/' || !slash ? 0 : (int)(slash - beside + 1);
    return snprintf(out, BOLAN_PATH_MAX, "%.*s%s", folder, beside, name) < BOLAN_PATH_MAX;
}

// Length of a driver's prefix with its colon: capitals, digits and _ (at least two, so that no letter of a drive
// counts).
static size_t prefix_length(const char *name) {
    const size_t length = strspn(name, "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_");
    return length >= 2 && name[length] == ':' ? length + 1 : 0;
}

const char *file_of_raster(const char *name, size_t *length) {
    const char *file = name + prefix_length(name);
    *length = strlen(file);
    if (file == name) return file;
    // GTIFF_DIR:2:f.tif and GTIFF_DIR:off:8192:f.tif have numbers before the file.
    if (strncmp(file, "off:", 4) == 0) file += 4;
    const size_t digits = strspn(file, "0123456789");
    if (digits > 0 && file[digits] == ':') file += digits + 1;
    const char end = file[0] == '"' ? '"' : ':';
    if (end == '"') file++;
    const char *stop = strchr(file, end);
    *length = stop ? (size_t)(stop - file) : strlen(file);
    return file;
}

bool file_resolve_raster(const char *beside, char name[BOLAN_PATH_MAX]) {
    char resolved[BOLAN_PATH_MAX];
    size_t length;
    const char *file = file_of_raster(name, &length), *slash = strrchr(beside, '/');
    if (length == 0 || file[0] == '/' || !slash) return true;
    const int folder = (int)(slash - beside + 1), before = (int)(file - name);
    // A colon in the folder would end the file's name, but not between quotes.
    const bool quote = before > 0 && name[before - 1] != '"' && memchr(beside, ':', (size_t)folder);
    const char *mark = quote ? "\"" : "";
    const int written = snprintf(resolved, sizeof resolved, "%.*s%s%.*s%.*s%s%s", before, name, mark, folder, beside,
                                 (int)length, file, mark, file + length);
    if (written >= BOLAN_PATH_MAX) return false;
    memcpy(name, resolved, (size_t)written + 1);
    return true;
}

// ---- writing --------------------------------------------------------------------------------------------------------

bolan_result file_cannot_write(const char *path) {
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_FILE_WRITE, "%s: cannot be written: %s", path, strerror(errno));
    return BOLAN_ERROR_IO;
}

bolan_result file_temporary_name(const char *path, char out[FILE_NAME_CAPACITY]) {
    struct stat status;
    const bool exists = stat(path, &status) == 0;
    errno = strlen(path) >= BOLAN_PATH_MAX ? ENAMETOOLONG : exists && S_ISDIR(status.st_mode) ? EISDIR : 0;
    if (errno) return file_cannot_write(path);
    if (exists && !S_ISREG(status.st_mode)) {
        snprintf(out, FILE_NAME_CAPACITY, "%s", path);
    } else {
        snprintf(out, FILE_NAME_CAPACITY, "%s.part%ld", path, (long)getpid());
    }
    return BOLAN_OK;
}

bolan_result file_finish(const char *temporary, const char *path, bool keep) {
    if (strcmp(temporary, path) == 0) return BOLAN_OK;
    if (keep && rename(temporary, path) == 0) return BOLAN_OK;
    const int reason = errno;
    remove(temporary);
    errno = reason;
    return keep ? file_cannot_write(path) : BOLAN_OK;
}

bolan_result bolan_file_check_writable(const char *path) {
    char temporary[FILE_NAME_CAPACITY];
    if (file_temporary_name(path, temporary)) return BOLAN_ERROR_IO;
    FILE *stream = fopen(temporary, "wb");
    if (!stream) return file_cannot_write(path);
    fclose(stream);
    return file_finish(temporary, path, false);
}

bolan_result bolan_file_write(const char *path, const void *data, size_t size) {
    char temporary[FILE_NAME_CAPACITY];
    if (file_temporary_name(path, temporary)) return BOLAN_ERROR_IO;
    FILE *stream = fopen(temporary, "wb");
    if (!stream) return file_cannot_write(path);
    const bool written = fwrite(data, 1, size, stream) == size;
    // The last bytes leave the buffer at the close: a full disk shows there.
    if (fclose(stream) != 0 || !written) {
        const bolan_result result = file_cannot_write(path);
        file_finish(temporary, path, false);
        return result;
    }
    return file_finish(temporary, path, true);
}

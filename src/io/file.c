// SPDX-License-Identifier: MIT
// See file.h and the file functions of bolan/io.h.
#include "io/file.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

// ---- reading -----------------------------------------------------------------------------------------------------

static bolan_result cannot_read(bolan_log_id id, const char *path, const char *reason) {
    bolan_log(BOLAN_LOG_ERROR, id, "%s: cannot be read: %s", path, reason);
    return BOLAN_ERROR_IO;
}

static bolan_result no_memory(const char *path) {
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY, "%s: no memory to read it", path);
    return BOLAN_ERROR_MEMORY;
}

static bolan_result read_stream(FILE *stream, const char *path, size_t limit, file_text *out) {
    size_t capacity = 0;
    char *data = NULL;
    size_t size = 0;
    for (;;) {
        if (size == capacity) { // the size is unknown before the end, since the file may be a pipe
            const size_t larger = capacity ? 2 * capacity : 65536;
            char *next = bolan_enlarge(data, data ? capacity + 1 : 0, larger + 1);
            if (!next) {
                bolan_release(data, capacity + 1);
                return no_memory(path);
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
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_FILE_TOO_LARGE, "%s: larger than %zu KiB; expected a smaller file", path,
                  limit >> 10);
        result = BOLAN_ERROR_IO;
    }
    // Shrink to the exact size, so that the owner need not remember the capacity.
    char *exact = result ? NULL : bolan_allocate(size + 1);
    if (exact) memcpy(exact, data, size);
    if (!result && !exact) result = no_memory(path);
    bolan_release(data, capacity + 1);
    *out = (file_text){exact, exact ? size : 0};
    return result;
}

bolan_result bolan_file_cannot_read(const char *path) {
    return cannot_read(BOLAN_LOG_FILE_READ, path, strerror(errno));
}

bolan_result bolan_file_open(const char *path, FILE **out, uint64_t *size) {
    struct stat status;
    const bool exists = stat(path, &status) == 0;
    if (exists && S_ISDIR(status.st_mode)) return cannot_read(BOLAN_LOG_FILE_OPEN, path, "it is a folder");
    *size = exists && S_ISREG(status.st_mode) ? (uint64_t)status.st_size : 0;
    *out = fopen(path, "rb");
    return *out ? BOLAN_OK : cannot_read(BOLAN_LOG_FILE_OPEN, path, strerror(errno));
}

bolan_result bolan_file_read(const char *path, size_t limit, file_text *out) {
    FILE *stream;
    uint64_t size;
    *out = (file_text){NULL, 0};
    const bolan_result opened = bolan_file_open(path, &stream, &size);
    if (opened) return opened;
    const bolan_result result = read_stream(stream, path, limit, out);
    fclose(stream);
    return result;
}

void bolan_file_release(file_text *text) {
    if (text->data) bolan_release(text->data, text->size + 1);
    *text = (file_text){NULL, 0};
}

bool bolan_file_resolve(const char *beside, const char *name, char out[BOLAN_PATH_MAX]) {
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

const char *bolan_file_of_raster(const char *name, size_t *length) {
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

bool bolan_file_resolve_raster(const char *beside, char name[BOLAN_PATH_MAX]) {
    char resolved[BOLAN_PATH_MAX];
    size_t length;
    const char *file = bolan_file_of_raster(name, &length), *slash = strrchr(beside, '/');
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

// ---- where to write -----------------------------------------------------------------------------------------------

enum { MOST_LINKS = 40, MOST_ATTEMPTS = 100, NAME_BYTES = 255 }; // NAME_BYTES: what Linux and BSD folders hold

bolan_result bolan_file_cannot_write(const char *path) {
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_FILE_WRITE, "%s: cannot be written: %s", path, strerror(errno));
    return BOLAN_ERROR_IO;
}

void bolan_file_temporary_name(const char *target, int attempt, char out[FILE_NAME_CAPACITY]) {
    char tail[32];
    const char *slash = strrchr(target, '/'), *name = slash ? slash + 1 : target;
    snprintf(tail, sizeof tail, attempt ? ".part%ld-%d" : ".part%ld", (long)getpid(), attempt);
    const size_t stem = bolan_text_fit(name, NAME_BYTES - strlen(tail));
    snprintf(out, FILE_NAME_CAPACITY, "%.*s%.*s%s", (int)(name - target), target, (int)stem, name, tail);
}

// Symbolic links, followed to the end: the last may lead to a name that is not there yet. False with errno.
static bool follow_links(const char *path, char out[BOLAN_PATH_MAX]) {
    char link[BOLAN_PATH_MAX], next[BOLAN_PATH_MAX];
    snprintf(out, BOLAN_PATH_MAX, "%s", path);
    for (int i = 0; i < MOST_LINKS; i++) {
        const ssize_t length = readlink(out, link, sizeof link - 1);
        if (length < 0) return errno == EINVAL || errno == ENOENT; // no link, or no file, which are both valid
        link[length] = '\0';
        errno = ENAMETOOLONG;
        if (length == sizeof link - 1 || !bolan_file_resolve(out, link, next)) return false;
        memcpy(out, next, sizeof next);
    }
    errno = ELOOP;
    return false;
}

// Fills path and target. *old: the present file, all zero where there is none; *straight: a device or pipe.
static bolan_result find_target(const char *path, file_output *out, struct stat *old, bool *straight) {
    memset(old, 0, sizeof *old);
    *out = (file_output){.file = -1, .entry = {.slot = -1}};
    *straight = false;
    errno = *path ? ENAMETOOLONG : ENOENT;
    if (!*path || strlen(path) >= BOLAN_PATH_MAX) return bolan_file_cannot_write(path);
    snprintf(out->path, sizeof out->path, "%s", path);
    snprintf(out->target, sizeof out->target, "%s", path);
    const bool exists = stat(path, old) == 0;
    if (!exists && errno != ENOENT) return bolan_file_cannot_write(path);
    errno = EISDIR;
    if (exists && S_ISDIR(old->st_mode)) return bolan_file_cannot_write(path);
    // A file without write permission is kept, also from root, to whom the system would allow the write.
    errno = EACCES;
    if (exists && (old->st_mode & 0222) == 0) return bolan_file_cannot_write(path);
    if (exists && faccessat(AT_FDCWD, path, W_OK, AT_EACCESS) != 0) return bolan_file_cannot_write(path);
    *straight = exists && !S_ISREG(old->st_mode);
    if (*straight || follow_links(path, out->target)) return BOLAN_OK;
    return bolan_file_cannot_write(path);
}

static void remove_file(const char *path) { unlink(path); }

// Makes the temporary file under a new name; existing files of such names are never touched.
static bool make_temporary(file_output *out, const struct stat *old) {
    const bool replaces = old->st_nlink > 0;
    for (int attempt = 0; attempt < MOST_ATTEMPTS; attempt++) {
        bolan_file_temporary_name(out->target, attempt, out->temporary);
        out->entry = bolan_unfinished_claim(out->temporary, remove_file);
        out->file = open(out->temporary, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, replaces ? 0600 : 0666);
        const int reason = errno;
        if (out->file >= 0) {
            bolan_unfinished_own(&out->entry, 0);
            // Only root can restore a different owner; without root the mode alone is restored.
            const bool given = replaces && fchown(out->file, old->st_uid, old->st_gid) == 0;
            return !replaces || fchmod(out->file, old->st_mode & (given ? 07777 : 0777)) == 0;
        }
        bolan_unfinished_forget(&out->entry);
        errno = reason;
        if (errno != EEXIST) return false;
    }
    return false;
}

bolan_result bolan_file_output_open(const char *path, file_output *out) {
    struct stat old;
    bool straight;
    if (find_target(path, out, &old, &straight)) return BOLAN_ERROR_IO;
    if (straight) {
        out->file = open(path, O_WRONLY | O_CLOEXEC | O_NOCTTY);
        return out->file >= 0 ? BOLAN_OK : bolan_file_cannot_write(path);
    }
    if (make_temporary(out, &old)) return BOLAN_OK;
    const bolan_result result = bolan_file_cannot_write(path);
    if (out->file < 0) out->temporary[0] = '\0'; // not made: a file of that name is not ours
    bolan_file_output_finish(out, false);
    return result;
}

bolan_result bolan_file_output_finish(file_output *out, bool keep) {
    bolan_result result = BOLAN_OK;
    // A network folder or a quota may report an error only here.
    if (out->file >= 0 && close(out->file) != 0 && keep) result = bolan_file_cannot_write(out->path);
    out->file = -1;
    if (!out->temporary[0]) return result;
    bolan_unfinished_wait_if_abandoned();
    if (!result && keep && rename(out->temporary, out->target) != 0) result = bolan_file_cannot_write(out->path);
    if (result || !keep) unlink(out->temporary);
    out->temporary[0] = '\0';
    bolan_unfinished_forget(&out->entry);
    return result;
}

// ---- writing -----------------------------------------------------------------------------------------------------

bool bolan_file_write_all(int file, const void *data, size_t size) {
    sigset_t ours, before, pending;
    sigemptyset(&ours);
    sigpending(&pending);
    if (!sigismember(&pending, SIGPIPE)) sigaddset(&ours, SIGPIPE); // an earlier signal stays pending
    if (!sigismember(&pending, SIGXFSZ)) sigaddset(&ours, SIGXFSZ);
    pthread_sigmask(SIG_BLOCK, &ours, &before);
    const uint8_t *at = data;
    bool ok = true;
    while (size > 0 && ok) {
        const ssize_t written = write(file, at, size);
        ok = written > 0 || (written < 0 && errno == EINTR);
        if (written > 0) at += written, size -= (size_t)written;
    }
    const int reason = errno;
    if (!ok) {
        const struct timespec now = {0, 0};
        while (sigtimedwait(&ours, NULL, &now) < 0 && errno == EINTR) continue;
    }
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    errno = reason;
    return ok;
}

bolan_result bolan_file_check_writable(const char *path) {
    BOLAN_ASSERT(path);
    file_output output;
    struct stat old;
    bool straight;
    if (find_target(path, &output, &old, &straight)) return BOLAN_ERROR_IO;
    if (straight) return BOLAN_OK; // a pipe is opened once, because its reader takes the close for the end
    const bolan_result result = bolan_file_output_open(path, &output);
    return result ? result : bolan_file_output_finish(&output, false);
}

bolan_result bolan_file_write(const char *path, const void *data, size_t size) {
    BOLAN_ASSERT(path && (data || size == 0));
    file_output output;
    if (bolan_file_output_open(path, &output)) return BOLAN_ERROR_IO;
    const bool written = bolan_file_write_all(output.file, data, size);
    const bolan_result result = written ? BOLAN_OK : bolan_file_cannot_write(path);
    const bolan_result finished = bolan_file_output_finish(&output, written);
    return result ? result : finished;
}

// ---- piece by piece -------------------------------------------------------------------------------------------------

struct bolan_file_stream {
    file_output output;
};

bolan_result bolan_file_stream_open(const char *path, bolan_file_stream **out) {
    BOLAN_ASSERT(path && out);
    *out = NULL;
    bolan_file_stream *stream = bolan_allocate(sizeof *stream);
    if (!stream) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY, "%s: no memory to write it", path);
        return BOLAN_ERROR_MEMORY;
    }
    const bolan_result result = bolan_file_output_open(path, &stream->output);
    if (result) {
        bolan_release(stream, sizeof *stream);
    } else {
        *out = stream;
    }
    return result;
}

bolan_result bolan_file_stream_write(bolan_file_stream *stream, const void *data, size_t size) {
    BOLAN_ASSERT(stream && (data || size == 0));
    if (bolan_file_write_all(stream->output.file, data, size)) return BOLAN_OK;
    return bolan_file_cannot_write(stream->output.path);
}

bolan_result bolan_file_stream_close(bolan_file_stream **stream, bool keep) {
    if (!stream || !*stream) return BOLAN_OK;
    const bolan_result result = bolan_file_output_finish(&(*stream)->output, keep);
    bolan_release(*stream, sizeof **stream);
    *stream = NULL;
    return result;
}

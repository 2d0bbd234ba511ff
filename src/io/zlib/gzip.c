// SPDX-License-Identifier: MIT
// Files packed by gzip (RFC 1952), by zlib.
#include "io/unpack.h"

#include <zlib.h>

static bolan_result refuse(const char *path, const char *what) {
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_FILE_UNPACK, "%s: cannot be unpacked: %s; expected a whole gzip file", path,
              what);
    return BOLAN_ERROR_FORMAT;
}

static bolan_result no_memory(const char *path) {
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY, "%s: no memory to unpack it", path);
    return BOLAN_ERROR_MEMORY;
}

// Doubles the room.
static bool grow(char **data, size_t *capacity) {
    char *larger = bolan_enlarge(*data, *capacity, 2 * *capacity);
    if (!larger) return false;
    *data = larger;
    *capacity *= 2;
    return true;
}

// Inflates all members of the file into *data, which has room for *capacity bytes.
static bolan_result inflate_all(const char *path, size_t limit, z_stream *z, char **data, size_t *capacity,
                                size_t *size) {
    for (;;) {
        if (*size == *capacity && !grow(data, capacity)) return no_memory(path);
        z->next_out = (Bytef *)*data + *size;
        z->avail_out = (uInt)(*capacity - *size);
        const int code = inflate(z, Z_NO_FLUSH);
        *size = *capacity - z->avail_out;
        if (*size > limit) {
            bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_FILE_TOO_LARGE,
                      "%s: unpacked it is larger than %zu KiB; expected a smaller file", path, limit >> 10);
            return BOLAN_ERROR_IO;
        }
        if (code == Z_MEM_ERROR) return no_memory(path);
        if (code == Z_STREAM_END && z->avail_in == 0) return BOLAN_OK;
        if (code == Z_STREAM_END)
            inflateReset(z); // another member follows
        else if (code != Z_OK && code != Z_BUF_ERROR)
            return refuse(path, z->msg ? z->msg : "the bytes are damaged");
        else if (z->avail_in == 0 && z->avail_out > 0)
            return refuse(path, "it ends too soon");
    }
}

bolan_result bolan_unpack_gzip(const char *path, size_t limit, file_text *file) {
    if (!unpack_is_gzip(file)) return BOLAN_OK;
    z_stream z = {.next_in = (Bytef *)(void *)file->data, .avail_in = (uInt)file->size};
    size_t capacity = 1 << 16, size = 0;
    char *data = bolan_allocate(capacity), *exact = NULL;
    if (!data) return no_memory(path);
    bolan_result result = inflateInit2(&z, 15 + 16) == Z_OK ? BOLAN_OK : no_memory(path); // 16: a gzip header
    if (!result) {
        result = inflate_all(path, limit, &z, &data, &capacity, &size);
        inflateEnd(&z);
    }
    if (!result && !(exact = bolan_allocate(size + 1))) result = no_memory(path);
    if (exact) memcpy(exact, data, size);
    bolan_release(data, capacity);
    if (result) return result;
    bolan_file_release(file);
    *file = (file_text){exact, size};
    return BOLAN_OK;
}

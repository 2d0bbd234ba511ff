// SPDX-License-Identifier: MIT
// See film_check.h. Both containers are boxes with their sizes in front, and both muxers write the index last. A film
// that was cut off therefore has a box that reaches beyond the end of the file, or no index.
//     MP4: ISO/IEC 14496-12, 4.2: size and type of a box; "moov" holds the index.
//     WebM: RFC 8794 (EBML): id and size of an element; RFC 9559 (Matroska): the Segment, whose size is unknown (all
//     bits one) until the muxer fills it in at the end.
#include "io/film_check.h"

#include <fcntl.h>
#include <stdint.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static const char cut_off[] = "the file is cut off; is the disk full?";

typedef struct film {
    int file;
    uint64_t size;
} film;

static uint64_t big_endian(const uint8_t *bytes, int count) {
    uint64_t value = 0;
    for (int i = 0; i < count; i++) value = value << 8 | bytes[i];
    return value;
}

static bool read_at(const film *f, uint64_t at, uint8_t *bytes, size_t count) {
    return at + count <= f->size && pread(f->file, bytes, count, (off_t)at) == (ssize_t)count;
}

// Boxes without a gap from the first byte to the last, an index and pictures among them.
static const char *check_mp4(const film *f) {
    bool index = false, data = false;
    for (uint64_t at = 0; at < f->size;) {
        uint8_t head[16];
        if (!read_at(f, at, head, 8)) return cut_off;
        uint64_t size = big_endian(head, 4), least = 8;
        if (size == 1) { // the size stands behind the type, in 64 bits
            if (!read_at(f, at, head, 16)) return cut_off;
            size = big_endian(head + 8, 8);
            least = 16;
        }
        if (size < least || size > f->size - at) return cut_off;
        index |= memcmp(head + 4, "moov", 4) == 0;
        data |= memcmp(head + 4, "mdat", 4) == 0;
        at += size;
    }
    return index && data ? NULL : "the film has no index; is the disk full?";
}

// A number of EBML at *at: as many bytes as the first has leading zeros, and one. `whole`: with its length bits, as ids
// are written.
static bool ebml_number(const film *f, uint64_t *at, bool whole, uint64_t *value) {
    uint8_t bytes[8];
    if (!read_at(f, *at, bytes, 1) || bytes[0] == 0) return false;
    int length = 1;
    while (!(bytes[0] & (0x80 >> (length - 1)))) length++;
    if (!read_at(f, *at, bytes, (size_t)length)) return false;
    if (!whole) bytes[0] = (uint8_t)(bytes[0] & (0x7F >> (length - 1)));
    *value = big_endian(bytes, length);
    *at += (uint64_t)length;
    return true;
}

// The head, then one Segment that ends where the file ends.
static const char *check_webm(const film *f) {
    static const uint64_t ids[] = {0x1A45DFA3, 0x18538067}; // EBML, Segment
    uint64_t at = 0, id = 0, size = 0;
    for (int i = 0; i < 2; i++) {
        if (!ebml_number(f, &at, true, &id) || id != ids[i] || !ebml_number(f, &at, false, &size) ||
            size > f->size - at)
            return cut_off;
        at += size;
    }
    return at == f->size ? NULL : cut_off;
}

const char *bolan_film_check(const char *path, bool webm) {
    struct stat status;
    const film f0 = {open(path, O_RDONLY | O_CLOEXEC), 0};
    if (f0.file < 0 || fstat(f0.file, &status) != 0) {
        if (f0.file >= 0) close(f0.file);
        return "it left no file";
    }
    const film f = {f0.file, (uint64_t)status.st_size};
    const char *wrong = f.size == 0 ? "it left an empty file" : webm ? check_webm(&f) : check_mp4(&f);
    close(f.file);
    return wrong;
}

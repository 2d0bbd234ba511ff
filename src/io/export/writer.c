// SPDX-License-Identifier: MIT
// See writer.h.
#include "io/export/writer.h"

#include <stdio.h>
#include <string.h>

enum { BUFFER = 1 << 16 };

bolan_result bolan_export_open(const char *path, export_writer *out) {
    *out = (export_writer){.path = path, .buffer = bolan_allocate(BUFFER)};
    if (!out->buffer) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY, "%s: no memory to write it", path);
        return BOLAN_ERROR_MEMORY;
    }
    const bolan_result result = bolan_file_stream_open(path, &out->stream);
    if (result) bolan_release(out->buffer, BUFFER);
    return result;
}

static void flush(export_writer *w) {
    if (w->result == BOLAN_OK && w->used > 0) w->result = bolan_file_stream_write(w->stream, w->buffer, w->used);
    w->used = 0;
}

void bolan_export_bytes(export_writer *w, const void *bytes, size_t size) {
    const uint8_t *from = bytes;
    while (size > 0) {
        const size_t room = BUFFER - w->used, part = size < room ? size : room;
        memcpy(w->buffer + w->used, from, part);
        w->used += part;
        from += part;
        size -= part;
        if (w->used == BUFFER) flush(w);
    }
}

// The `size` low bytes of a number.
static void put_number(export_writer *w, uint64_t value, uint32_t size) {
    uint8_t bytes[8];
    for (uint32_t i = 0; i < size; i++) bytes[i] = (uint8_t)(value >> 8 * (w->big_endian ? size - 1 - i : i));
    bolan_export_bytes(w, bytes, size);
}

void bolan_export_u8(export_writer *w, uint8_t value) { put_number(w, value, 1); }
void bolan_export_u32(export_writer *w, uint32_t value) { put_number(w, value, 4); }
void bolan_export_u64(export_writer *w, uint64_t value) { put_number(w, value, 8); }

void bolan_export_f32(export_writer *w, float value) {
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    put_number(w, bits, 4);
}

void bolan_export_f64(export_writer *w, double value) {
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    put_number(w, bits, 8);
}

void bolan_export_text(export_writer *w, const char *format, ...) {
    char plain[1024];
    va_list arguments;
    va_start(arguments, format);
    const int length = vsnprintf(plain, sizeof plain, format, arguments);
    va_end(arguments);
    if (length > 0) bolan_export_bytes(w, plain, (size_t)length < sizeof plain ? (size_t)length : sizeof plain - 1);
}

void bolan_export_number(export_writer *w, double value, int digits) {
    char text[32];
    bolan_export_bytes(w, text, (size_t)bolan_format_number(text, sizeof text, value, digits));
}

bolan_result bolan_export_close(export_writer *w, bool keep) {
    if (keep) flush(w);
    const bolan_result closed = bolan_file_stream_close(&w->stream, keep && w->result == BOLAN_OK);
    bolan_release(w->buffer, BUFFER);
    return w->result ? w->result : closed;
}

bool bolan_export_has_suffix(const char *path, const char *suffix) {
    const size_t length = strlen(path), tail = strlen(suffix);
    return length > tail && strcmp(path + length - tail, suffix) == 0;
}

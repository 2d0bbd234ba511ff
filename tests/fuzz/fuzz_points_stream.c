// SPDX-License-Identifier: MIT
// Any bytes as query points, read piece by piece from a file: the same points and the same refusals as of the text in
// memory. The first byte puts comment lines in front, so that the bytes meet the edges of the reader's buffer; the last
// byte is how many points are asked for at once.
#define _GNU_SOURCE // memfd_create
#include "bolan/io.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

enum { LONGEST = 65535, MOST_BEFORE = 4 * (LONGEST + 1) };

static unsigned sentences;
static char last[512];

static void keep_sentence(void *user, bolan_log_level level, bolan_log_id id, const char *sentence) {
    (void)user, (void)level, (void)id;
    sentences += sentence[0] != '\0';
    snprintf(last, sizeof last, "%s", sentence);
}

// A file of the text, without a file system.
static void name_of_file(const char *text, size_t size, char path[64], int *handle) {
    *handle = memfd_create("points", 0);
    if (*handle < 0 || write(*handle, text, size) != (ssize_t)size) abort();
    snprintf(path, 64, "/proc/self/fd/%d", *handle);
}

static bool has_long_line(const char *text, size_t size) {
    size_t run = 0;
    for (size_t i = 0; i < size; i++) {
        run = text[i] == '\n' ? 0 : run + 1;
        if (run > LONGEST) return true;
    }
    return false;
}

static void check_stream(const char *path, const bolan_points *whole, bolan_result expected, uint32_t step) {
    bolan_points_reader *reader = NULL;
    bolan_dvec3 some[64];
    uint32_t count = 0, n = 0;
    if (bolan_points_open(path, &reader)) abort();
    sentences = 0;
    bolan_result result = BOLAN_OK;
    for (;;) {
        result = bolan_points_next(reader, some, step, &n);
        if (result || n == 0) break;
        for (uint32_t i = 0; i < n; i++, count++) {
            if (isnan(some[i].z)) some[i].z = 0.0;
            if (!expected && (count >= whole->count || memcmp(&some[i], &whole->points[count], sizeof *some))) abort();
        }
    }
    if (result != expected || (!result && count != whole->count) || sentences != (result != BOLAN_OK)) abort();
    bolan_points_close(&reader);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    static char text[MOST_BEFORE + (1 << 17)];
    char path[64], refusal[512];
    int handle;
    if (size < 2 || size > 1 << 17) return 0;
    bolan_set_hooks(&(bolan_hooks){.log = keep_sentence});
    // Comments of 65536 bytes with their ends; the last of them is shorter, by up to 63 bytes.
    size_t before = (size_t)(data[0] & 3u) * (LONGEST + 1u);
    if (before) before -= data[0] >> 2;
    memset(text, '#', before);
    for (size_t i = LONGEST; i < before; i += LONGEST + 1) text[i] = '\n';
    if (before) text[before - 1] = '\n';
    memcpy(text + before, data + 1, size - 1);
    const size_t length = before + size - 1;
    bolan_points whole;
    sentences = 0;
    bolan_result expected = bolan_points_parse("fuzz", text, length, &whole);
    const bool is_long = has_long_line(text, length); // which the text in memory may have
    if ((expected != BOLAN_OK) != (sentences == 1)) abort();
    if (is_long) expected = BOLAN_ERROR_FORMAT;
    snprintf(refusal, sizeof refusal, "%s", last);
    name_of_file(text, length, path, &handle);
    check_stream(path, &whole, expected, 1u + (data[size - 1] & 63u));
    if (expected && !is_long && strcmp(refusal + strlen("fuzz"), last + strlen(path)) != 0) abort(); // another line
    close(handle);
    bolan_points_destroy(&whole);
    if (bolan_memory_in_use() != 0) abort();
    return 0;
}

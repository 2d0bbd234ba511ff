// SPDX-License-Identifier: MIT
/// @file io_support.h
/// What the tests of scenes and files share: a log that remembers its last sentence, and files.
#ifndef BOLAN_TESTS_IO_SUPPORT_H
#define BOLAN_TESTS_IO_SUPPORT_H

#include "bolan/base.h"

#include "support.h"

#include <string.h>

static bolan_log_id last_id;
static char last_sentence[1024];
static unsigned error_count; ///< sentences of level ERROR since the last assert_refusal()

static inline void remember(void *user, bolan_log_level level, bolan_log_id id, const char *sentence) {
    (void)user;
    if (level != BOLAN_LOG_ERROR) return;
    last_id = id;
    error_count++;
    snprintf(last_sentence, sizeof last_sentence, "%s", sentence);
}

/// Group fixture: messages go to last_id and last_sentence.
static inline int listen_to_log(void **state) {
    (void)state;
    bolan_hooks hooks = {0};
    hooks.log = remember;
    bolan_set_hooks(&hooks);
    return 0;
}

/// The call failed as it should: this result, one sentence with this id and these words, on one line.
#define assert_refusal(actual, result, id, words)                             \
    do {                                                                      \
        error_count = 0;                                                      \
        last_sentence[0] = '\0';                                              \
        const bolan_result refusal_result = (actual);                         \
        check_refusal(refusal_result, result, id, words, __FILE__, __LINE__); \
    } while (0)
static inline void check_refusal(bolan_result actual, bolan_result expected, bolan_log_id id, const char *words,
                                 const char *file, int line) {
    const bool good = actual == expected && error_count == 1 && last_id == id && strstr(last_sentence, words) &&
                      !strchr(last_sentence, '\n');
    if (!good)
        print_error("result %d (%u errors), id %d, \"%s\"; expected result %d, id %d, \"%s\"\n", (int)actual,
                    error_count, (int)last_id, last_sentence, (int)expected, (int)id, words);
    _assert_true(good, words, file, line);
}

// ---- memory that runs out -------------------------------------------------------------------------------------------

static int allocations_left; ///< how many more succeed before one fails; below 0: all do

static inline void *scarce_allocate(void *user, size_t size, size_t align) {
    (void)user;
    if (allocations_left >= 0 && allocations_left-- == 0) return NULL;
    return aligned_alloc(align, (size + align - 1) / align * align);
}
static inline void scarce_release(void *user, void *memory, size_t size) {
    (void)user, (void)size;
    free(memory);
}

/// Lets each allocation of @p attempt fail once: it returns MEMORY with one sentence, and keeps nothing.
static inline void assert_memory_failures(bolan_result (*attempt)(void)) {
    bolan_hooks hooks = {.log = remember, .allocate = scarce_allocate, .release = scarce_release};
    bolan_set_hooks(&hooks);
    const size_t before = bolan_memory_in_use();
    for (int n = 0; n < 1000; n++) {
        allocations_left = n;
        error_count = 0;
        const bolan_result result = attempt();
        const bool failed = allocations_left < 0;
        allocations_left = -1;
        assert_int_equal(bolan_memory_in_use(), before);
        if (!failed) {
            assert_int_equal(result, BOLAN_OK);
            assert_true(n > 3);
            break;
        }
        if (result != BOLAN_ERROR_MEMORY || error_count != 1)
            print_error("allocation %d: result %d, %u sentences, %s\n", n, (int)result, error_count, last_sentence);
        assert_int_equal(result, BOLAN_ERROR_MEMORY);
        assert_int_equal(error_count, 1);
    }
    hooks.allocate = NULL, hooks.release = NULL;
    bolan_set_hooks(&hooks);
}

static inline bool file_exists(const char *path) {
    FILE *file = fopen(path, "rb");
    if (file) fclose(file);
    return file != NULL;
}

static inline void write_text(const char *path, const char *text) {
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    fwrite(text, 1, strlen(text), file);
    fclose(file);
}

#endif

// SPDX-License-Identifier: MIT
// Names, hooks, log, assertions and counted memory.
#include "support.h"

#include "bolan/base.h"

#include <string.h>

static void every_result_and_set_has_a_name(void **state) {
    (void)state;
    for (int r = BOLAN_OK; r <= BOLAN_ERROR_GL; r++) {
        assert_string_not_equal(bolan_result_string((bolan_result)r), "unknown result");
    }
    assert_string_equal(bolan_cpu_name(BOLAN_CPU_AVX512), "avx512");
    assert_string_equal(bolan_version(), BOLAN_VERSION_STRING);
}

static void log_ids_are_unique(void **state) {
    (void)state;
    const int ids[] = {
#define ID(id, name) id,
        BOLAN_LOG_TABLE(ID)
#undef ID
    };
    const size_t n = sizeof ids / sizeof ids[0];
    for (size_t i = 0; i < n; i++) {
        for (size_t j = i + 1; j < n; j++) assert_int_not_equal(ids[i], ids[j]);
    }
}

static void this_machine_runs_a_set_it_names(void **state) {
    (void)state;
    const bolan_cpu best = bolan_cpu_best();
    assert_true(best >= BOLAN_CPU_SCALAR && best <= BOLAN_CPU_AVX512);
    print_message("widest set: %s\n", bolan_cpu_name(best));
}

// ---- log and assertions through hooks -------------------------------------------------------------------------------

typedef struct record {
    int calls;
    bolan_log_level level;
    bolan_log_id id;
    char text[2048];
    size_t bytes, blocks; // what the counting allocator has handed out
    bool refuse;
} record;

static void keep_log(void *user, bolan_log_level level, bolan_log_id id, const char *sentence) {
    record *r = user;
    r->calls++;
    r->level = level;
    r->id = id;
    snprintf(r->text, sizeof r->text, "%s", sentence);
}

static void keep_assert(void *user, const char *expression, const char *file, int line) {
    record *r = user;
    r->calls++;
    snprintf(r->text, sizeof r->text, "%s at %s", expression, file);
    assert_true(line > 0);
}

static void the_log_hook_gets_level_id_and_sentence(void **state) {
    (void)state;
    record r = {0};
    const bolan_hooks hooks = {.user = &r, .log = keep_log};
    bolan_set_hooks(&hooks);
    bolan_log(BOLAN_LOG_WARNING, BOLAN_LOG_FILE_OPEN, "cannot open %s: %d", "a.spec", 7);
    bolan_set_hooks(NULL);
    assert_int_equal(r.calls, 1);
    assert_int_equal(r.level, BOLAN_LOG_WARNING);
    assert_int_equal(r.id, BOLAN_LOG_FILE_OPEN);
    assert_string_equal(r.text, "cannot open a.spec: 7");
}

static void a_sentence_that_is_too_long_is_cut_not_overrun(void **state) {
    (void)state;
    record r = {0};
    const bolan_hooks hooks = {.user = &r, .log = keep_log};
    static char text[4000];
    memset(text, 'x', sizeof text - 1);
    bolan_set_hooks(&hooks);
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_FILE_OPEN, "%s", text);
    bolan_set_hooks(NULL);
    assert_true(strlen(r.text) > 500 && strlen(r.text) < sizeof text - 1);
}

static void misuse_reaches_the_assert_hook(void **state) {
    (void)state;
    record r = {0};
    const bolan_hooks hooks = {.user = &r, .assert_failed = keep_assert};
    bolan_set_hooks(&hooks);
    BOLAN_ASSERT(2 + 2 == 4);
    assert_int_equal(r.calls, 0);
    BOLAN_ASSERT(2 + 2 == 5);
    bolan_set_hooks(NULL);
    assert_int_equal(r.calls, 1);
    assert_non_null(strstr(r.text, "2 + 2 == 5"));
    assert_non_null(strstr(r.text, "test_base.c"));
}

// ---- memory ---------------------------------------------------------------------------------------------------------

static void *counting_allocate(void *user, size_t size, size_t align) {
    record *r = user;
    if (r->refuse) return NULL;
    r->bytes += size;
    r->blocks++;
    return aligned_alloc(align, (size + align - 1) / align * align);
}

static void counting_release(void *user, void *memory, size_t size) {
    record *r = user;
    r->bytes -= size;
    r->blocks--;
    free(memory);
}

static void assert_fresh(const uint8_t *memory, size_t size) {
    assert_non_null(memory);
    assert_int_equal((uintptr_t)memory % 64, 0);
    for (size_t i = 0; i < size; i++) assert_int_equal(memory[i], 0);
}

static void memory_is_aligned_zero_and_counted(void **state) {
    (void)state;
    const size_t before = bolan_memory_in_use();
    for (size_t size = 1; size < 10000; size = size * 3 + 1) {
        uint8_t *memory = bolan_allocate(size);
        assert_fresh(memory, size);
        memset(memory, 0xff, size); // so that a second round would show memory that was not cleared
        assert_int_equal(bolan_memory_in_use(), before + size);
        bolan_release(memory, size);
    }
    assert_int_equal(bolan_memory_in_use(), before);
}

static void nothing_comes_of_nothing(void **state) {
    (void)state;
    assert_null(bolan_allocate(0));
    bolan_release(NULL, 0);
    assert_int_equal(bolan_memory_in_use(), 0);
}

static void an_impossible_size_gives_null(void **state) {
    (void)state;
    assert_null(bolan_allocate(SIZE_MAX - 3)); // would wrap round when aligned
    assert_int_equal(bolan_memory_in_use(), 0);
}

static void a_counting_allocator_sees_balanced_bytes(void **state) {
    (void)state;
    record r = {0};
    const bolan_hooks hooks = {.user = &r, .allocate = counting_allocate, .release = counting_release};
    bolan_set_hooks(&hooks);
    uint8_t *a = bolan_allocate(100), *b = bolan_allocate(1 << 20);
    assert_fresh(a, 100);
    assert_fresh(b, 1 << 20);
    assert_int_equal(r.bytes, 100 + (1 << 20));
    assert_int_equal(bolan_memory_in_use(), r.bytes);
    bolan_release(a, 100);
    bolan_release(b, 1 << 20);
    bolan_set_hooks(NULL);
    assert_int_equal(r.bytes, 0);
    assert_int_equal(r.blocks, 0);
}

static void a_refusing_allocator_is_told_on(void **state) {
    (void)state;
    record r = {.refuse = true};
    const bolan_hooks hooks = {.user = &r, .allocate = counting_allocate, .release = counting_release};
    bolan_set_hooks(&hooks);
    assert_null(bolan_allocate(100));
    assert_int_equal(bolan_memory_in_use(), 0);
    bolan_set_hooks(NULL);
}

static void memory_that_grows_keeps_its_bytes(void **state) {
    (void)state;
    record r = {0};
    const bolan_hooks hooks = {.user = &r, .allocate = counting_allocate, .release = counting_release};
    bolan_set_hooks(&hooks);
    uint8_t *small = bolan_enlarge(NULL, 0, 100);
    assert_fresh(small, 100);
    memset(small, 7, 100);
    uint8_t *large = bolan_enlarge(small, 100, 300);
    for (size_t i = 0; i < 300; i++) assert_int_equal(large[i], i < 100 ? 7 : 0);
    assert_int_equal(r.bytes, 300);
    assert_int_equal(bolan_memory_in_use(), 300);
    r.refuse = true;
    assert_null(bolan_enlarge(large, 300, 900));
    assert_int_equal(large[99], 7); // still there
    assert_int_equal(r.bytes, 300);
    bolan_release(large, 300);
    bolan_set_hooks(NULL);
    assert_int_equal(bolan_memory_in_use(), 0);
}

static void half_a_pair_of_memory_hooks_is_misuse(void **state) {
    (void)state;
    record r = {0};
    const bolan_hooks hooks = {.user = &r, .allocate = counting_allocate, .assert_failed = keep_assert};
    bolan_set_hooks(&hooks);
    bolan_set_hooks(NULL);
    assert_int_equal(r.calls, 1);
}

RUN_TESTS(cmocka_unit_test(every_result_and_set_has_a_name), cmocka_unit_test(log_ids_are_unique),
          cmocka_unit_test(this_machine_runs_a_set_it_names), cmocka_unit_test(the_log_hook_gets_level_id_and_sentence),
          cmocka_unit_test(a_sentence_that_is_too_long_is_cut_not_overrun),
          cmocka_unit_test(misuse_reaches_the_assert_hook), cmocka_unit_test(memory_is_aligned_zero_and_counted),
          cmocka_unit_test(nothing_comes_of_nothing), cmocka_unit_test(an_impossible_size_gives_null),
          cmocka_unit_test(a_counting_allocator_sees_balanced_bytes), cmocka_unit_test(a_refusing_allocator_is_told_on),
          cmocka_unit_test(memory_that_grows_keeps_its_bytes),
          cmocka_unit_test(half_a_pair_of_memory_hooks_is_misuse))

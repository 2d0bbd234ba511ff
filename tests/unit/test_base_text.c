// SPDX-License-Identifier: MIT
// Numbers for machines, and foreign text in messages.
#include "support.h"

#include "bolan/base.h"

#include <float.h>
#include <string.h>

static char sentence[4096];
static int sentences;

static void keep(void *user, bolan_log_level level, bolan_log_id id, const char *text) {
    (void)user, (void)level, (void)id;
    sentences++;
    snprintf(sentence, sizeof sentence, "%s", text);
}

// ---- numbers --------------------------------------------------------------------------------------------------------

static void every_number_comes_back_as_it_went(void **state) {
    (void)state;
    const double values[] = {0.1, -1.0 / 3.0, DBL_MAX, DBL_MIN, 5e-324, 9007199254740993.0, 5.67e-7, 1e22, 1e23, -0.0};
    for (size_t i = 0; i < sizeof values / sizeof *values; i++) {
        char text[64];
        double back = 7.0;
        const int length = bolan_format(text, sizeof text, "%.17g", values[i]);
        assert_int_equal(length, strlen(text));
        assert_true(bolan_parse_number(text, (size_t)length, &back));
        assert_memory_equal(&back, &values[i], sizeof back);
    }
}

static void numbers_are_rounded_correctly(void **state) {
    (void)state;
    double value = 0.0;
    // Halfway between two doubles and just above it: David Gay's cases, "Correctly rounded binary-decimal conversions",
    // 1990.
    assert_true(bolan_parse_number("9007199254740993", 16, &value) && value == 9007199254740992.0);
    assert_true(bolan_parse_number("9007199254740993.00000000000000000000000000001", 46, &value) &&
                value == 9007199254740994.0);
    assert_true(bolan_parse_number("2.2250738585072011e-308", 23, &value) && value == 0x0.fffffffffffffp-1022);
    assert_true(bolan_parse_number("12abc", 2, &value) && value == 12.0); // what follows the word is not read
}

static void only_decimal_numbers_count(void **state) {
    (void)state;
    static const char *const good[] = {"1", "+1", "-1", "1.", ".5", "1.5e3", "1E-3", "007", "1e+05"};
    static const char *const bad[] = {"",    " ",    "+",     ".",    "-.",   "e5",  "1e", "1e+",
                                      " 1",  "1 ",   "1,5",   "0x10", "nan",  "inf", "1_", "1.5.",
                                      "--1", "1e5.", "1e999", "1d3",  "1e5e", "\t1", "1f"};
    double value;
    for (size_t i = 0; i < sizeof good / sizeof *good; i++)
        assert_true(bolan_parse_number(good[i], strlen(good[i]), &value));
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        assert_false(bolan_parse_number(bad[i], strlen(bad[i]), &value));
    char digits[500];
    memset(digits, '1', sizeof digits);
    assert_false(bolan_parse_number(digits, 401, &value));
    assert_false(bolan_parse_number(digits, 400, &value)); // beyond a double
    digits[1] = '.';
    assert_true(bolan_parse_number(digits, 400, &value));
}

// ---- text -----------------------------------------------------------------------------------------------------------

static void text_is_cut_between_characters(void **state) {
    (void)state;
    const char text[] = "a\xc3\xbc\xe6\xb5\xb7\xf0\x9f\x8c\x8a!"; // a, ue, sea, wave: 1, 2, 3, 4 bytes, and one more
    const size_t expected[] = {0, 1, 1, 3, 3, 3, 6, 6, 6, 6, 10, 11, 11};
    for (size_t most = 0; most < sizeof expected / sizeof *expected; most++)
        assert_int_equal(bolan_text_fit(text, most), expected[most]);
    assert_int_equal(bolan_text_fit("\x80\x80\x80\x80\x80\x80", 4), 4); // no UTF-8 at all
    assert_int_equal(bolan_text_fit("", 4), 0);
}

static void control_characters_are_escaped(void **state) {
    (void)state;
    static const struct {
        const char *text, *shown;
    } cases[] = {
        {"plain, 100 %", "plain, 100 %"},
        {"\x1b[31mred", "\\x1b[31mred"},
        {"a\nb\tc\rd\x7f", "a\\nb\\tc\\x0dd\\x7f"},
        {"\xc2\x9b"
         "31m",
         "\\u009b31m"},                          // CSI of C1, in UTF-8
        {"\xc2\x80\xc2\xa0", "\\u0080\xc2\xa0"}, // the blank that does not break is no control character
        {"\x9b"
         "31m",
         "\\x9b31m"}, // and as one byte
        {"\xe2\x80\xae"
         "txt\xe2\x81\xa6\xe2\x80\xa8",
         "\\u202etxt\\u2066\\u2028"},
        {"\xc3\xbc\xe6\xb5\xb7\xf0\x9f\x8c\x8a", "\xc3\xbc\xe6\xb5\xb7\xf0\x9f\x8c\x8a"},
        {"\xc0\xaf \xe0\x80\x80 \xed\xa0\x80 \xf8 .", "\\xc0\\xaf \\xe0\\x80\\x80 \\xed\\xa0\\x80 \\xf8 ."}, // no UTF-8
        {"\xf4\x90\x80\x80.", "\\xf4\\x90\\x80\\x80."},
        {"cut \xe6\xb5", "cut "},
        {"cut \xf0\x9f\x8c", "cut "},
        {"not cut \xe6\xb5.", "not cut \\xe6\\xb5."},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char shown[128];
        bolan_text_escape(cases[i].text, shown, sizeof shown);
        assert_string_equal(shown, cases[i].shown);
    }
    char small[8];
    bolan_text_escape("abc\x1bx", small, sizeof small); // "abc\x1b" fits with its NUL, the x does not
    assert_string_equal(small, "abc\\x1b");
    bolan_text_escape("abcd\x1bx", small, sizeof small);
    assert_string_equal(small, "abcd");
}

static void a_sentence_is_one_line_of_whole_characters(void **state) {
    (void)state;
    bolan_set_hooks(&(bolan_hooks){.log = keep});
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_BAD_ARGUMENT, "%s: %g", "a\nb\x1b]0;title\x07", 0.5);
    assert_string_equal(sentence, "a\\nb\\x1b]0;title\\x07: 0.5");
    char longer[3000] = "";
    for (int i = 0; i < 990; i++) strcat(longer, "\xe6\xb5\xb7");
    for (int shift = 0; shift < 3; shift++) { // wherever the end of the sentence falls
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_BAD_ARGUMENT, "%.*s%s", shift, "xy", longer);
        const size_t length = strlen(sentence);
        assert_true(length > 2040 && length < 2048);
        assert_int_equal((length - (size_t)shift) % 3, 0);
    }
    bolan_set_hooks(NULL);
    assert_int_equal(sentences, 4);
}

static void nothing(void *user, uint32_t count, uint32_t grain, bolan_task_fn *task, void *context) {
    (void)user, (void)count, (void)grain, (void)task, (void)context;
}

static void count_assert(void *user, const char *expression, const char *file, int line) {
    (void)expression, (void)file, (void)line;
    ++*(int *)user;
}

static void a_task_system_without_workers_is_misuse_and_counts_as_one(void **state) {
    (void)state;
    int asserts = 0;
    const bolan_hooks hooks = {.user = &asserts, .assert_failed = count_assert, .parallel = nothing};
    bolan_set_hooks(&hooks);
    assert_int_equal(asserts, 1);
    assert_int_equal(bolan_threads(), 1);
    bolan_set_hooks(&(bolan_hooks){.user = &asserts, .parallel = nothing, .parallel_workers = 3});
    assert_int_equal(bolan_threads(), 3);
    bolan_set_hooks(NULL);
    assert_int_equal(asserts, 1);
}

RUN_TESTS(cmocka_unit_test(every_number_comes_back_as_it_went), cmocka_unit_test(numbers_are_rounded_correctly),
          cmocka_unit_test(only_decimal_numbers_count), cmocka_unit_test(text_is_cut_between_characters),
          cmocka_unit_test(control_characters_are_escaped),
          cmocka_unit_test(a_sentence_is_one_line_of_whole_characters),
          cmocka_unit_test(a_task_system_without_workers_is_misuse_and_counts_as_one))

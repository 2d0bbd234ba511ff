// SPDX-License-Identifier: MIT
// Query points from CSV.
#include "bolan/io.h"
#include "io_support.h"

static bolan_result parse(const char *text, bolan_points *points) {
    return bolan_points_parse("p.csv", text, strlen(text), points);
}

static void test_points_with_and_without_header_and_height(void **state) {
    (void)state;
    static const char *const texts[] = {
        "1,2\n-3.5,4e2\n",
        "x,y\n1,2\n-3.5,4e2\n",
        "x,y,z\n1,2,0\n-3.5,4e2,7\n",
        "# a comment\n\n 1 , 2 \r\n-3.5;4e2 # here too",
        "\xEF\xBB\xBFX\tY\n1\t2\n-3.5\t400\n",
    };
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        bolan_points points;
        assert_int_equal(parse(texts[i], &points), BOLAN_OK);
        assert_int_equal(points.count, 2);
        assert_near(points.points[0].x, 1, 0);
        assert_near(points.points[0].y, 2, 0);
        assert_near(points.points[1].x, -3.5, 0);
        assert_near(points.points[1].y, 400, 0);
        bolan_points_destroy(&points);
        assert_null(points.points);
    }
}

static void test_bad_lines_are_named(void **state) {
    (void)state;
    static const struct {
        const char *text, *words;
    } bad[] = {
        {"", "p.csv: there is no point"},
        {"x,y\n", "p.csv: there is no point"},
        {"1,2\n3\n", "p.csv:2: found the end of the line; expected y"},
        {"1,2\n\n# c\n3,abc\n", "p.csv:4: found abc; expected y"},
        {"1,nan\n", "p.csv:1: found nan; expected y"},
        {"nan,1\n", "p.csv:1: found nan; expected x"},
        {"inf,1\n", "p.csv:1: found inf; expected x"},
        {"1,1e9\n", "p.csv:1: found 1e9; expected y"},
        {"1,2,3,4\n", "p.csv:1: found 4; expected x,y or x,y,z"},
        {"1,2,3,4,5,6,7\n", "p.csv:1: found 4; expected x,y or x,y,z"},
        {"1,,2\n", "p.csv:1: found nothing; expected y"},
        {",1\n", "p.csv:1: found nothing; expected x"},
        {"x,y\n1,2\nx,y\n", "p.csv:3: found x; expected x"},
        {"\x01\x02\x03", "p.csv:1: found \\x01\\x02\\x03; expected x"},
    };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        bolan_points points;
        const size_t before = bolan_memory_in_use();
        assert_refusal(parse(bad[i].text, &points), BOLAN_ERROR_FORMAT, BOLAN_LOG_POINTS_SYNTAX, bad[i].words);
        assert_int_equal(points.count, 0);
        assert_null(points.points);
        assert_int_equal(bolan_memory_in_use(), before);
    }
}

// Programs that quote everything quote numbers too: a first line of them is a point, and no header.
static void test_quoted_numbers(void **state) {
    (void)state;
    static const char text[] = "\"1\",\"2\"\n\"-3.5\";\"4e1\"\n5,\"6\",\"7\"\n";
    bolan_points points;
    assert_int_equal(bolan_points_parse("q.csv", text, sizeof text - 1, &points), BOLAN_OK);
    assert_int_equal(points.count, 3);
    assert_true(points.points[0].x == 1 && points.points[0].y == 2 && points.points[0].z == 0);
    assert_true(points.points[1].x == -3.5 && points.points[1].y == 40);
    assert_true(points.points[2].x == 5 && points.points[2].y == 6 && points.points[2].z == 7);
    bolan_points_destroy(&points);
    static const char named[] = "\"x\",\"y\"\n8,9\n";
    assert_int_equal(bolan_points_parse("q.csv", named, sizeof named - 1, &points), BOLAN_OK);
    assert_int_equal(points.count, 1);
    assert_true(points.points[0].x == 8 && points.points[0].y == 9);
    bolan_points_destroy(&points);
    static const struct {
        const char *text, *words;
    } bad[] = {
        {"\"1,5\",\"2\"\n", "q.csv:1: found \"1; expected x"}, // a decimal comma
        {"\"1\",\"\"\n", "q.csv:1: found \"\"; expected y"},
        {"\"x\",\"y\"\n\"a\",\"1\"\n", "q.csv:2: found \"a\"; expected x"},
        {"\"1\",\"2\"\n\"x\",\"y\"\n", "q.csv:2: found \"x\"; expected x"}, // a header is the first line
        {"\"name\",\"2\"\n", "q.csv:1: found \"name\"; expected x"},
        {"1,"
         "\xe6\xb5\xb7\xe6\xb5\xb7\xe6\xb5\xb7\xe6\xb5\xb7\xe6\xb5\xb7\xe6\xb5\xb7\xe6\xb5\xb7\xe6\xb5\xb7\xe6\xb5\xb7"
         "\n",
         "found \xe6\xb5\xb7\xe6\xb5\xb7\xe6\xb5\xb7\xe6\xb5\xb7\xe6\xb5\xb7\xe6\xb5\xb7\xe6\xb5\xb7\xe6\xb5\xb7; "
         "expected y"},
    };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        assert_refusal(bolan_points_parse("q.csv", bad[i].text, strlen(bad[i].text), &points), BOLAN_ERROR_FORMAT,
                       BOLAN_LOG_POINTS_SYNTAX, bad[i].words);
}

static void test_many_points(void **state) {
    (void)state;
    enum { MANY = 3000, LINE = 12 };
    char *text = malloc(MANY * LINE + 1), *p = text;
    assert_non_null(text);
    for (int i = 0; i < MANY; i++) p += snprintf(p, LINE + 1, "%d,%d\n", i, -i);
    bolan_points points;
    assert_int_equal(bolan_points_parse("many", text, (size_t)(p - text), &points), BOLAN_OK);
    assert_int_equal(points.count, MANY);
    assert_near(points.points[MANY - 1].y, 1 - MANY, 0);
    bolan_points_destroy(&points);
    free(text);
}

static void test_a_missing_file_is_named(void **state) {
    (void)state;
    bolan_points points;
    assert_refusal(bolan_points_load("none.csv", &points), BOLAN_ERROR_IO, BOLAN_LOG_FILE_OPEN,
                   "none.csv: cannot be read");
    assert_null(points.points);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_points_with_and_without_header_and_height),
        cmocka_unit_test(test_bad_lines_are_named),
        cmocka_unit_test(test_quoted_numbers),
        cmocka_unit_test(test_many_points),
        cmocka_unit_test(test_a_missing_file_is_named),
    };
    return cmocka_run_group_tests(tests, listen_to_log, NULL);
}

// SPDX-License-Identifier: MIT
// Datawell, TRIAXYS, OCTOPUS and Spotter texts: what each word means, and what is wrong with others.
#include "spectrum_support.h"

static bolan_spectrum_texts named(const char *name, const char *data) {
    bolan_spectrum_texts texts = bolan_spectrum_texts_default();
    texts.density = literal(name, data);
    return texts;
}

static void refuse_as(const char *name, const char *data, bolan_log_id id, const char *part) {
    const bolan_spectrum_texts texts = named(name, data);
    assert_refused(&texts, 0, BOLAN_ERROR_FORMAT, id, part);
}

// Every text that is shorter is refused, and no step goes beyond its end.
static void refuse_truncations(const char *name, const char *data, size_t from, size_t to) {
    for (size_t size = from; size < to; size++) {
        char *copy = malloc(size);
        memcpy(copy, data, size);
        bolan_spectrum_texts texts = bolan_spectrum_texts_default();
        texts.density = (bolan_spectrum_text){name, copy, size};
        bolan_measured_spectrum *spectrum;
        if (bolan_measured_spectrum_parse(&texts, NULL, &spectrum) != BOLAN_ERROR_FORMAT)
            print_error("%s of %zu bytes is read\n", name, size);
        assert_null(spectrum);
        free(copy);
    }
    assert_int_equal(bolan_memory_in_use(), 0);
}

// ---- Datawell -------------------------------------------------------------------------------------------------------

#define SPT_HEAD "10\n85.0\n4.5\n2.0E+0\n25\n19\n7\n-0.1\n0.3\n0.2\n213.8\n68.2\n"
#define SPT_ROWS "0.100,5.0E-1,200.0,30.0,0.5,6.0\n0.200,1.0E+0,200.0,30.0,0.5,6.0\n"

static void a_waverider_text(void **state) {
    (void)state;
    bolan_spectrum_texts texts = named("buoy}2024-09-09T01h44Z.spt", SPT_HEAD SPT_ROWS);
    bolan_sea_summary s = summary_with(&texts, NULL);
    assert_int_equal(warning_count, 0);
    assert_near(s.m0, 2.0 * 0.5 * (0.5 + 1.0) * 0.1, 1e-12); // Smax is the fourth line
    assert_near(s.tp, 5.0, 1e-9);
    assert_near(s.from_deg, 200.0, 0.01);
    assert_near(s.spread_deg, 30.0, 0.01);
    bolan_measured_spectrum *spectrum = parse(&texts, 0);
    assert_string_equal(bolan_measured_spectrum_view(spectrum).time, "2024-09-09T01:44Z");
    bolan_measured_spectrum_destroy(&spectrum);
    texts = named("plain.spt", SPT_HEAD SPT_ROWS);
    spectrum = parse(&texts, 0);
    assert_string_equal(bolan_measured_spectrum_view(spectrum).time, "");
    bolan_measured_spectrum_destroy(&spectrum);
    refuse_as("a.spt", SPT_HEAD SPT_ROWS "0.2,1,200,30,0,6\n", BOLAN_LOG_SPECTRUM_TRUNCATED, "a.spt:15");
    refuse_as("a.spt", SPT_HEAD SPT_ROWS "0.3,1.5,200,30,0,6\n", BOLAN_LOG_SPECTRUM_SYNTAX,
              "a.spt:15: expected a density over Smax, 0 to 1, found \"1.5\"");
    refuse_as("a.spt", SPT_HEAD SPT_ROWS "0.3,1,400,30,0,6\n", BOLAN_LOG_SPECTRUM_SYNTAX, "a direction in degrees");
    refuse_as("a.spt", SPT_HEAD SPT_ROWS "0.3,1,200,90,0,6\n", BOLAN_LOG_SPECTRUM_SYNTAX, "a spread of 0 to 81");
    refuse_as("a.spt", SPT_HEAD SPT_ROWS "0.3,1,200,30,0\n", BOLAN_LOG_SPECTRUM_TRUNCATED, "a kurtosis");
    refuse_as("a.spt", SPT_HEAD SPT_ROWS "0.3,1,200,30,0,6,7\n", BOLAN_LOG_SPECTRUM_SYNTAX, "the end of the row");
    refuse_as("a.spt", SPT_HEAD "0.100,0.5,200.0,30.0,0.5,6.0\n", BOLAN_LOG_SPECTRUM_TRUNCATED, "a second frequency");
    refuse_truncations("a.spt", SPT_HEAD SPT_ROWS, 1, sizeof SPT_HEAD SPT_ROWS - 5);
}

// ---- TRIAXYS --------------------------------------------------------------------------------------------------------

#define TRIAXYS_HEAD(type, date)                                                            \
    "TRIAXYS BUOY DATA REPORT - TAS01970 - TAB01401 - 4830.0000S16631.5000W\n"              \
    "VERSION = WV (NDS)\nTYPE\t= " type "\nDATE    = " date "\nNUMBER OF FREQUENCIES = 3\n" \
    "INITIAL FREQUENCY (Hz) = 0.000\nFREQUENCY SPACING (Hz) = 0.100\n"
#define DIRECTIONAL                                               \
    TRIAXYS_HEAD("DIRECTIONAL SPECTRUM", "2018-01-31 21:00(UTC)") \
    "NUMBER OF DIRECTIONS = 5\nDIRECTION SPACING (DEG) = 90\nCOLUMNS = 0.00 TO 360.00 DEG\nROWS\t= 0.00 TO 0.20 Hz\n"
#define PLAIN \
    TRIAXYS_HEAD("NON-DIRECTIONAL SPECTRUM", "2018-01-31 21:00(UTC)") "COLUMN 1 = FREQUENCY (Hz)\nCOLUMN 2 = X\n"

static void a_triaxys_text(void **state) {
    (void)state;
    bolan_spectrum_texts texts = named("a.DIRSPEC", DIRECTIONAL "0 0 0 0 0\n0 4 0 0 0\n0 2 0 0 0\n"); // from the east
    bolan_sea_summary s = summary_with(&texts, NULL);
    assert_int_equal(warning_count, 0);
    assert_near(s.m0, 0.5 * (4.0 + 2.0) * 0.1 * 90.0, 1e-9);
    assert_near(s.from_deg, 90.0, 1e-6);
    assert_near(s.tp, 10.0, 1e-9);
    texts = named("a.DIRSPEC", DIRECTIONAL "0 0 0 0 0\n4 0 0 0 4\n2 0 0 0 2\n"); // 0 and 360 are one
    assert_near(summary_with(&texts, NULL).m0, 0.5 * (4.0 + 2.0) * 0.1 * 90.0, 1e-9);
    bolan_spectrum_contents *c = NULL;
    assert_int_equal(bolan_spectrum_contents_parse(&texts, &c), BOLAN_OK);
    assert_string_equal(c->records[0].time, "2018-01-31T21:00Z");
    assert_near(c->places[0].x, -(166.0 + 31.5 / 60.0), 1e-12);
    assert_near(c->places[0].y, -48.5, 1e-12);
    bolan_spectrum_contents_destroy(&c);
    bolan_spectrum_options options = bolan_spectrum_options_default();
    options.from_deg = 10.0;
    options.spread_s = 5.0;
    texts = named("a.NONDIRSPEC", PLAIN "0.000 0\n0.100 4\n0.200 2\n");
    s = summary_with(&texts, &options);
    assert_near(s.m0, 0.5 * (4.0 + 2.0) * 0.1, 1e-9);
    assert_near(s.from_deg, 10.0, 0.01);
    refuse_as("a.D", DIRECTIONAL "0 0 0 0 0\n0 4 0 0 0\n", BOLAN_LOG_SPECTRUM_TRUNCATED, "a row of densities");
    refuse_as("a.D", DIRECTIONAL "0 0 0 0 0\n0 4 0 0\n0 0 0 0 0\n", BOLAN_LOG_SPECTRUM_TRUNCATED, "a.D:13: the line");
    refuse_as("a.D", DIRECTIONAL "0 0 0 0 0\n0 4 0 0 0 0\n0 0 0 0 0\n", BOLAN_LOG_SPECTRUM_SYNTAX,
              "the end of the row");
    refuse_as("a.D", DIRECTIONAL "0 0 0 0 0\n0 -4 0 0 0\n0 0 0 0 0\n", BOLAN_LOG_SPECTRUM_NEGATIVE, "a.D:13");
    refuse_as("a.D", TRIAXYS_HEAD("DIRECTIONAL SPECTRUM", "2018-02-31 21:00"), BOLAN_LOG_SPECTRUM_SYNTAX,
              "a.D:4: expected a date such as");
    refuse_as("a.D", PLAIN "0.0 0\n0.2 1\n0.1 1\n", BOLAN_LOG_SPECTRUM_TRUNCATED, "an ascending frequency");
    refuse_truncations("a.D", DIRECTIONAL "0 0 0 0 0\n0 4 0 0 0\n0 2 0 0 0", 1, sizeof DIRECTIONAL + 27);
}

// ---- OCTOPUS --------------------------------------------------------------------------------------------------------

#define OCT_HEAD "Forecast\nnfreqs,3\nndir,4\nnrecs,2\nLatitude, -39.5\nLongitude, 173.25\nDepth,100\n"
#define OCT_RECORD(time, east)                                                                  \
    "\nCCYYMM,DDHHmm,LPoint\n" time ",maari,123\nfreq,0.1,0.2,0.4,anspec\n0,0,0,0,0,\n90," east \
    ",0.3,\n180,0,0,0,0,\n"                                                                     \
    "270,0,0,0,0,\nfSpec,1,2,3,\nden,1,2,3,\n"
#define OCT OCT_HEAD OCT_RECORD("201803,'120000", "0.2,0.1,0") OCT_RECORD("201803,'110600", "0.4,0.2,0")

static void an_octopus_text(void **state) {
    (void)state;
    const bolan_spectrum_texts texts = named("a.oct", OCT);
    for (uint32_t record = 0; record < 2; record++) { // the second in the text is the earlier
        const bolan_spectrum_options options = record_number(record);
        const bolan_sea_summary s = summary_with(&texts, &options);
        assert_near(s.m0, record ? 0.3 : 0.6, 1e-12); // the sum of the cells
        assert_near(s.from_deg, 90.0, 1e-6);
        assert_near(s.tp, 10.0, 1e-9); // 0.2 / 0.05 Hz is more than 0.1 / 0.15 Hz
    }
    bolan_spectrum_contents *c = NULL;
    assert_int_equal(bolan_spectrum_contents_parse(&texts, &c), BOLAN_OK);
    assert_int_equal(c->record_count, 2);
    assert_string_equal(c->records[0].time, "2018-03-11T06:00Z");
    assert_string_equal(c->records[1].time, "2018-03-12T00:00Z");
    assert_near(c->places[0].x, 173.25, 0.0);
    assert_near(c->places[0].y, -39.5, 0.0);
    bolan_spectrum_contents_destroy(&c);
    refuse_as("a.oct", "x\nnfreqs,1\n", BOLAN_LOG_SPECTRUM_SYNTAX,
              "a.oct:2: expected nfreqs of 2 to 1000, found \"1\"");
    refuse_as("a.oct", OCT_HEAD, BOLAN_LOG_SPECTRUM_TRUNCATED, "a line CCYYMM,DDHHmm");
    refuse_as("a.oct", OCT_HEAD OCT_RECORD("201813,'110600", "0,0,0"), BOLAN_LOG_SPECTRUM_SYNTAX, "found \"201813\"");
    refuse_as("a.oct", OCT_HEAD OCT_RECORD("201803,'1106", "0,0,0"), BOLAN_LOG_SPECTRUM_SYNTAX, "found \"'1106\"");
    refuse_as("a.oct", OCT_HEAD OCT_RECORD("201803,'110600", "-1,0,0"), BOLAN_LOG_SPECTRUM_SYNTAX,
              "a.oct:13: expected a variance of 0 to 1000 m2, found \"-1\"");
    refuse_as("a.oct", OCT_HEAD "\nCCYYMM,DDHHmm\n201803,110600\nfreq,0.1,0.1,0.4\n", BOLAN_LOG_SPECTRUM_SYNTAX,
              "an ascending frequency");
    refuse_truncations("a.oct", OCT_HEAD OCT_RECORD("201803,'120000", "0.2,0.1,0"), 1, sizeof OCT_HEAD + 110);
}

// ---- Spotter --------------------------------------------------------------------------------------------------------

#define SPOT(records) "{\"data\":{\"spotterId\":\"S\",\"frequencyData\":[" records "]}}\n"
#define SPOT_GRID "\"frequency\":[0.1,0.2,0.3],\"varianceDensity\":[1,2,0]"
#define SPOT_TIME(time) ",\"timestamp\":\"" time "\",\"latitude\":-61.5,\"longitude\":172.5"
#define COSINES ",\"a1\":[0.6,0.6,0.6],\"b1\":[-0.6,-0.6,-0.6],\"a2\":[0,0,0],\"b2\":[-0.5,-0.5,-0.5]"

static void a_spotter_text(void **state) {
    (void)state;
    bolan_spectrum_texts texts = named(
        "s.json",
        SPOT("{" SPOT_GRID COSINES SPOT_TIME("2018-02-14T03:27:19.000Z") "},"
                                                                         "{" SPOT_GRID ",\"direction\":[100,100,100],"
                                                                         "\"directionalSpread\":[30,30,30]" SPOT_TIME(
                                                                             "2018-02-14T00:27:19Z") "}"));
    bolan_spectrum_options options = record_number(1);
    bolan_sea_summary s = summary_with(&texts, &options);
    assert_int_equal(warning_count, 0);
    assert_near(s.m0, 0.1 * (0.5 * 1.0 + 2.0), 1e-12);
    assert_near(s.from_deg, 315.0, 0.01); // to the east and the south
    options = record_number(0);
    s = summary_with(&texts, &options);
    assert_near(s.from_deg, 100.0, 0.01);
    assert_near(s.spread_deg, 30.0, 0.2); // cos-2s
    bolan_spectrum_contents *c = NULL;
    assert_int_equal(bolan_spectrum_contents_parse(&texts, &c), BOLAN_OK);
    assert_int_equal(c->record_count, 2);
    assert_string_equal(c->records[1].time, "2018-02-14T03:27Z");
    assert_near(c->places[0].x, 172.5, 0.0);
    assert_near(c->places[0].y, -61.5, 0.0);
    bolan_spectrum_contents_destroy(&c);
    // Keys in any order, escapes and nested values on the way, no "data".
    texts = named("s.json",
                  "{\"x\":[{\"frequencyData\":1},\"a\\\"]\"],\"frequencyData\":[{\"n\":{\"timestamp\":1}" SPOT_TIME(
                      "2018-02-14T00:27:19Z") "," SPOT_GRID COSINES "}]}");
    assert_near(summary_with(&texts, NULL).from_deg, 315.0, 0.01);
    refuse_as("s.json", SPOT(""), BOLAN_LOG_SPECTRUM_SYNTAX, "no spectrum in frequencyData");
    refuse_as("s.json", SPOT("{" SPOT_GRID "}"), BOLAN_LOG_SPECTRUM_SYNTAX, "s.json:1: the record has no timestamp");
    refuse_as("s.json", SPOT("{" SPOT_GRID SPOT_TIME("2018-02-31T00:00") "}"), BOLAN_LOG_SPECTRUM_SYNTAX,
              "found \"2018-02-31T00:00\"");
    refuse_as("s.json", SPOT("{\"frequency\":[0.1,0.2]" SPOT_TIME("2018-02-14T00:27") "}"), BOLAN_LOG_SPECTRUM_SYNTAX,
              "no array varianceDensity");
    refuse_as("s.json", SPOT("{\"frequency\":[0.1,0.2],\"varianceDensity\":[1]" SPOT_TIME("2018-02-14T00:27") "}"),
              BOLAN_LOG_SPECTRUM_SYNTAX, "no value for each frequency");
    refuse_as("s.json", SPOT("{\"frequency\":[0.1,0.2],\"varianceDensity\":[1,2,3]" SPOT_TIME("2018-02-14T00:27") "}"),
              BOLAN_LOG_SPECTRUM_SYNTAX, "as many values as frequencies");
    refuse_as("s.json", SPOT("{\"frequency\":[0.1,0.2],\"varianceDensity\":[1,-2]" SPOT_TIME("2018-02-14T00:27") "}"),
              BOLAN_LOG_SPECTRUM_SYNTAX, "found \"-2\"");
    refuse_as("s.json", SPOT("{\"frequency\":[0.2,0.1],\"varianceDensity\":[1,2]" SPOT_TIME("2018-02-14T00:27") "}"),
              BOLAN_LOG_SPECTRUM_SYNTAX, "no array frequency that ascends");
    static const char whole[] = SPOT("{" SPOT_GRID COSINES SPOT_TIME("2018-02-14T03:27:19.000Z") "}");
    refuse_truncations("s.json", whole, 1, 120);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_waverider_text),
        cmocka_unit_test(a_triaxys_text),
        cmocka_unit_test(an_octopus_text),
        cmocka_unit_test(a_spotter_text),
    };
    return cmocka_run_group_tests(tests, capture_log, release_log);
}

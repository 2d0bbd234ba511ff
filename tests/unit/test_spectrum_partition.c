// SPDX-License-Identifier: MIT
// Wind sea and swells: seas that are made of known systems come apart into these again, and no variance is lost.
#include "spectrum_support.h"

// The parts of a sea; their variances add up to that of the sea within @p tolerance.
static uint32_t parts_of(const bolan_sea_state *sea_state, bolan_partition out[BOLAN_MAX_PARTITIONS],
                         double tolerance) {
    uint32_t count = 99;
    assert_int_equal(bolan_sea_state_partition(sea_state, out, &count), BOLAN_OK);
    assert_true(count <= BOLAN_MAX_PARTITIONS);
    double m0 = 0.0;
    for (uint32_t i = 0; i < count; i++) {
        m0 += out[i].hs * out[i].hs / 16.0;
        assert_true(out[i].hs > 0.0 && out[i].tp > 0.0);
        if (i > 0 && out[i].wind_sea == out[i - 1].wind_sea) assert_true(out[i].hs <= out[i - 1].hs);
        if (i > 0) assert_true(out[i - 1].wind_sea || !out[i].wind_sea);
    }
    assert_ratio(m0, bolan_sea_state_summary(sea_state).m0, tolerance);
    assert_int_equal(bolan_memory_in_use(), 0);
    return count;
}

static void assert_part(const bolan_partition *part, bool wind_sea, double hs, double tp, double from) {
    assert_int_equal(part->wind_sea, wind_sea);
    assert_ratio(part->hs, hs, 0.05);
    assert_ratio(part->tp, tp, 0.03);
    assert_near(remainder(part->from_deg - from, 360.0), 0.0, 4.0);
}

static void a_wind_sea_and_two_swells_come_apart(void **state) {
    (void)state;
    bolan_sea_state sea_state = bolan_sea_state_from_wind(10.0, 240.0, 100e3);
    const double hs = sea_state.systems[0].hs, tp = 2.0 * BOLAN_PI / sea_state.systems[0].peak_omega;
    assert_int_equal(bolan_sea_state_add_swell(&sea_state, 1.5, 14.0, 150.0, 40.0), BOLAN_OK);
    assert_int_equal(bolan_sea_state_add_swell(&sea_state, 1.0, 11.0, 330.0, 40.0), BOLAN_OK);
    bolan_partition parts[BOLAN_MAX_PARTITIONS];
    assert_int_equal(parts_of(&sea_state, parts, 0.01), 3);
    assert_part(&parts[0], true, hs, tp, 240.0);
    assert_part(&parts[1], false, 1.5, 14.0, 150.0);
    assert_part(&parts[2], false, 1.0, 11.0, 330.0);
}

// Swells that cross north, where the directions wrap; and opposed seas of one frequency.
static void directions_wrap(void **state) {
    (void)state;
    bolan_partition parts[BOLAN_MAX_PARTITIONS];
    for (int turn = 0; turn < 8; turn++) {
        bolan_sea_state sea_state = bolan_sea_state_default();
        assert_int_equal(bolan_sea_state_add_swell(&sea_state, 2.0, 12.0, 45.0 * turn, 20.0), BOLAN_OK);
        assert_int_equal(parts_of(&sea_state, parts, 0.01), 1);
        assert_part(&parts[0], false, 2.0, 12.0, 45.0 * turn);
        assert_ratio(parts[0].spread_deg, bolan_sea_state_summary(&sea_state).spread_deg, 0.02);
        assert_int_equal(bolan_sea_state_add_swell(&sea_state, 1.0, 12.0, 45.0 * turn - 180.0, 20.0), BOLAN_OK);
        assert_int_equal(parts_of(&sea_state, parts, 0.01), 2);
        assert_part(&parts[1], false, 1.0, 12.0, 45.0 * turn + 180.0);
    }
}

// By wave age, 1.5 times the wind's speed along the waves: g T / 2 pi is 12.5 m/s at 8 s.
static void the_wind_says_what_is_wind_sea(void **state) {
    (void)state;
    bolan_partition parts[BOLAN_MAX_PARTITIONS];
    const struct {
        double wind, from;
        bool wind_sea;
    } cases[] = {{9.0, 100.0, true},   {8.0, 100.0, false}, {9.0, 140.0, false}, {12.0, 140.0, true},
                 {40.0, 280.0, false}, {9.0, 90.0, true},   {0.0, 100.0, false}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        bolan_sea_state sea_state = bolan_sea_state_default();
        assert_int_equal(bolan_sea_state_add_swell(&sea_state, 1.0, 8.0, 100.0, 30.0), BOLAN_OK);
        sea_state.wind_speed = cases[i].wind;
        sea_state.wind_from_deg = cases[i].from;
        assert_int_equal(parts_of(&sea_state, parts, 0.01), 1);
        assert_int_equal(parts[0].wind_sea, cases[i].wind_sea);
    }
    // Without a wind, a peak above that of Pierson-Moskowitz is young: here 3.4 m at 6 s, far above 1.4 m.
    bolan_sea_state sea_state = bolan_sea_state_default();
    assert_int_equal(bolan_sea_state_add_swell(&sea_state, 3.4, 6.0, 100.0, 30.0), BOLAN_OK);
    assert_int_equal(parts_of(&sea_state, parts, 0.01), 1);
    assert_true(parts[0].wind_sea);
}

static void all_that_the_wind_drives_is_one_wind_sea(void **state) {
    (void)state;
    bolan_partition parts[BOLAN_MAX_PARTITIONS];
    bolan_sea_state sea_state = bolan_sea_state_default();
    assert_int_equal(bolan_sea_state_add_swell(&sea_state, 1.0, 4.0, 60.0, 30.0), BOLAN_OK);
    assert_int_equal(bolan_sea_state_add_swell(&sea_state, 1.0, 4.0, 140.0, 30.0), BOLAN_OK);
    assert_int_equal(parts_of(&sea_state, parts, 0.01), 2);
    sea_state.wind_speed = 15.0;
    sea_state.wind_from_deg = 100.0;
    assert_int_equal(parts_of(&sea_state, parts, 0.01), 1);
    assert_ratio(parts[0].hs, sqrt(2.0), 0.02);
}

// A noisy record of a buoy, with its own grid: few parts, and the variance to the last digit.
static void real_records_come_apart_without_loss(void **state) {
    (void)state;
    static const char *const files[] = {"swan_maari_lonlat_24f36d.spec", "ww3_44097_50f36d.spec",
                                        "triaxys_20180131.DIRSPEC",      "spotter_20180214.json",
                                        "datawell_20240909T0115Z.spt",   "octopus_maari_20180311.oct"};
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        bolan_spectrum_texts texts = bolan_spectrum_texts_default();
        texts.density = load_text(files[i]);
        bolan_measured_spectrum *spectrum = parse(&texts, 0);
        const bolan_sea_state sea_state = sea_of(spectrum);
        bolan_partition parts[BOLAN_MAX_PARTITIONS];
        uint32_t count = 0;
        double m0 = 0.0;
        assert_int_equal(bolan_sea_state_partition(&sea_state, parts, &count), BOLAN_OK);
        assert_true(count >= 1 && count <= 6);
        for (uint32_t k = 0; k < count; k++) m0 += parts[k].hs * parts[k].hs / 16.0;
        assert_ratio(m0, bolan_sea_state_summary(&sea_state).m0, 1e-9);
        bolan_measured_spectrum_destroy(&spectrum);
        free((char *)texts.density.data);
    }
}

// Two equal peaks, 120 degrees apart, with a level of @p valley of theirs between them, and nothing elsewhere.
static uint32_t parts_of_twin(double valley) {
    char text[4096];
    int used = snprintf(text, sizeof text, "SWAN 1\nLOCATIONS\n1\n0 0\nAFREQ\n5\n.08\n.09\n.1\n.11\n.12\nNDIR\n36\n");
    for (int j = 0; j < 36; j++) used += snprintf(text + used, sizeof text - (size_t)used, "%d\n", 10 * j);
    used += snprintf(text + used, sizeof text - (size_t)used, "QUANT\n1\nVaDens\nm2/Hz/degr\n-99\nFACTOR\n.001\n");
    for (int i = 0; i < 5; i++)
        for (int j = 0; j < 36; j++) {
            const int off = j > 18 ? 36 - j : j; // steps of 10 degrees from the north, where the valley is
            const bool peak = off >= 5 && off <= 7, between = off < 5;
            const double level = peak ? 100.0 : between ? 100.0 * valley : 0.0;
            used += snprintf(text + used, sizeof text - (size_t)used, "%d ", (int)(i == 0 || i == 4 ? 0.0 : level));
        }
    bolan_spectrum_texts texts = bolan_spectrum_texts_default();
    texts.density = literal("twin.spec", text);
    bolan_measured_spectrum *spectrum = parse(&texts, 0);
    const bolan_sea_state sea_state = sea_of(spectrum);
    bolan_partition parts[BOLAN_MAX_PARTITIONS];
    uint32_t count = 0;
    assert_int_equal(bolan_sea_state_partition(&sea_state, parts, &count), BOLAN_OK);
    bolan_measured_spectrum_destroy(&spectrum);
    return count;
}

// The valley crosses north, where the directions wrap.
static void peaks_that_meet_high_are_one(void **state) {
    (void)state;
    assert_int_equal(parts_of_twin(0.9), 1);
    assert_int_equal(parts_of_twin(0.7), 1);
    assert_int_equal(parts_of_twin(0.6), 2);
    assert_int_equal(parts_of_twin(0.2), 2);
    assert_int_equal(parts_of_twin(0.0), 2);
}

static void a_calm_has_no_parts(void **state) {
    (void)state;
    const bolan_sea_state calm = bolan_sea_state_default();
    bolan_partition parts[BOLAN_MAX_PARTITIONS];
    uint32_t count = 7;
    assert_int_equal(bolan_sea_state_partition(&calm, parts, &count), BOLAN_OK);
    assert_int_equal(count, 0);
}

// Of a sea of systems as of a file, the grid holds what the sea state has.
static void a_sampled_sea_is_the_sea(void **state) {
    (void)state;
    bolan_sea_state sea_state = bolan_sea_state_from_wind(12.0, 30.0, 200e3);
    assert_int_equal(bolan_sea_state_add_swell(&sea_state, 2.0, 13.0, 300.0, 30.0), BOLAN_OK);
    bolan_measured_spectrum *spectrum = NULL;
    assert_int_equal(bolan_measured_spectrum_sample(&sea_state, &spectrum), BOLAN_OK);
    const bolan_sea_state sampled = sea_of(spectrum);
    const bolan_sea_summary a = bolan_sea_state_summary(&sea_state), b = bolan_sea_state_summary(&sampled);
    assert_ratio(b.hs, a.hs, 0.005);
    assert_ratio(b.tp, a.tp, 0.03);
    assert_ratio(b.tm02, a.tm02, 0.01);
    assert_near(b.from_deg, a.from_deg, 0.5);
    assert_ratio(bolan_sea_state_density(&sampled, 0.7, 4.0), bolan_sea_state_density(&sea_state, 0.7, 4.0), 0.03);
    bolan_measured_spectrum_destroy(&spectrum);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_wind_sea_and_two_swells_come_apart),
        cmocka_unit_test(directions_wrap),
        cmocka_unit_test(the_wind_says_what_is_wind_sea),
        cmocka_unit_test(all_that_the_wind_drives_is_one_wind_sea),
        cmocka_unit_test(real_records_come_apart_without_loss),
        cmocka_unit_test(peaks_that_meet_high_are_one),
        cmocka_unit_test(a_calm_has_no_parts),
        cmocka_unit_test(a_sampled_sea_is_the_sea),
    };
    return cmocka_run_group_tests(tests, capture_log, release_log);
}

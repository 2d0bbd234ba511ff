// SPDX-License-Identifier: MIT
// A sea synthesised from a measured spectrum has the height, direction and period that its file says.
#include "spectrum_support.h"

#include "bolan/waves.h"

typedef struct expected_sea {
    double hs, tm02, te, from_deg, spread_deg, wind;
    const char *time;
} expected_sea;

enum { SEEDS = 8 };

// SWAN off Taranaki: integrals of the file (test_measured_spectra.c), which are what is measured of the sea but for its
// height: that is of one realisation, between whose samples some is lost.
static void assert_synthesis(const bolan_spectrum_texts *texts, uint32_t record, expected_sea expected) {
    bolan_measured_spectrum *spectrum = parse(texts, record);
    bolan_sea_desc desc = bolan_sea_desc_default();
    desc.sea_state = sea_of(spectrum);
    desc.sea_state.wind_speed = expected.wind;
    double m0 = 0.0;
    for (uint32_t s = 0; s < SEEDS; s++) {
        desc.seed = s;
        bolan_sea *sea = NULL;
        assert_int_equal(bolan_sea_create(&desc, &sea), BOLAN_OK);
        const bolan_sea_statistics m = bolan_sea_measure(sea);
        m0 += m.m0_field / SEEDS;
        assert_near(m.direction_from, expected.from_deg, 0.005);
        assert_near(m.spread, expected.spread_deg, 0.005);
        assert_near(m.tm02, expected.tm02, 5e-5);
        assert_near(m.tp, 13.5685, 5e-5);
        assert_near(m.te, expected.te, 5e-5);
        assert_near(16.0 * m.m0_spectrum, expected.hs * expected.hs, 4e-4);
        assert_true(strncmp(bolan_sea_record_time(sea), expected.time, strlen(expected.time)) == 0);
        bolan_sea_destroy(&sea);
    }
    assert_ratio(4.0 * sqrt(m0), expected.hs, 0.05);
    bolan_measured_spectrum_destroy(&spectrum);
}

static void a_swan_spectrum_becomes_its_sea(void **state) {
    (void)state;
    bolan_spectrum_texts texts = bolan_spectrum_texts_default();
    texts.density = load_text("swan_maari_lonlat_24f36d.spec");
    assert_synthesis(&texts, 0, (expected_sea){1.7158, 7.6839, 10.7262, 250.02, 21.06, 6.0, "2016-10-11T00:00:00"});
    assert_synthesis(&texts, 4, (expected_sea){4.2587, 7.3809, 10.1755, 254.11, 23.27, 15.0, "2016-10-15T00:00:00"});
    free((char *)texts.density.data);
}

// The sums are cut from the file's own frequencies: its height and direction to what 65536 places and 128 waves allow.
static void a_swan_spectrum_becomes_a_sum_of_cosines(void **state) {
    (void)state;
    bolan_spectrum_texts texts = bolan_spectrum_texts_default();
    texts.density = load_text("swan_maari_lonlat_24f36d.spec");
    for (uint32_t record = 0; record <= 4; record += 4) {
        bolan_measured_spectrum *spectrum = parse(&texts, record);
        bolan_sea_desc desc = bolan_sea_desc_default();
        desc.waves = BOLAN_WAVES_COSINES;
        desc.sea_state = sea_of(spectrum);
        bolan_sea *sea = NULL;
        assert_int_equal(bolan_sea_create(&desc, &sea), BOLAN_OK);
        const bolan_sea_statistics m = bolan_sea_measure(sea);
        assert_ratio(m.hs, record ? 4.2587 : 1.7158, 0.02); // sampling
        assert_near(m.direction_from, record ? 254.11 : 250.02, 0.1);
        bolan_sea_destroy(&sea);
        bolan_measured_spectrum_destroy(&spectrum);
    }
    free((char *)texts.density.data);
}

// Every format: the height of the water that queries return, against that of the file. No wind is given, and in some of
// the files a wind sea of a sixteenth of the length of the swell has a tenth of the energy.
static void a_sea_of_each_format_has_the_height_of_its_file(void **state) {
    (void)state;
    static const struct {
        const char *name;
        uint32_t record, location;
        double hs;
    } files[] = {{"swan_maari_lonlat_24f36d.spec", 2, 0, 0.0}, {"ww3_44097_50f36d.spec", 0, 0, 1.1573},
                 {"ww3_netcdf.nc", 0, 1, 0.7413},              {"era5_spectra.nc", 0, 26, 2.0952},
                 {"triaxys_20180131.DIRSPEC", 0, 0, 3.4128},   {"datawell_20240909T0115Z.spt", 0, 0, 0.8488},
                 {"spotter_20180214.json", 0, 0, 1.6214},      {"octopus_maari_20180311.oct", 2, 0, 2.2096},
                 {"ndbc_44004w2000.txt", 0, 0, 1.2881},        {"ndbc_41010.data_spec", 148, 0, 1.1188}};
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        bolan_spectrum_texts texts = bolan_spectrum_texts_default();
        texts.density = load_text(files[i].name);
        bolan_spectrum_options options = record_number(files[i].record);
        options.location = files[i].location;
        bolan_measured_spectrum *spectrum = parse_with(&texts, &options);
        bolan_sea_desc desc = bolan_sea_desc_default();
        desc.sea_state = sea_of(spectrum);
        desc.resolution = 128;
        double m0 = 0.0;
        for (desc.seed = 1; desc.seed <= 3; desc.seed++) {
            bolan_sea *sea = NULL;
            assert_int_equal(bolan_sea_create(&desc, &sea), BOLAN_OK);
            m0 += bolan_sea_measure(sea).m0_field / 3.0;
            bolan_sea_destroy(&sea);
        }
        const double hs = files[i].hs > 0.0 ? files[i].hs : bolan_sea_state_summary(&desc.sea_state).hs;
        print_message("%s: Hs %.4f m, of the file %.4f m\n", files[i].name, 4.0 * sqrt(m0), hs);
        assert_ratio(4.0 * sqrt(m0), hs, 0.02);
        bolan_measured_spectrum_destroy(&spectrum);
        free((char *)texts.density.data);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(a_swan_spectrum_becomes_its_sea),
                                       cmocka_unit_test(a_sea_of_each_format_has_the_height_of_its_file),
                                       cmocka_unit_test(a_swan_spectrum_becomes_a_sum_of_cosines)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

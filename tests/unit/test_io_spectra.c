// SPDX-License-Identifier: MIT
// Files of spectra: NetCDF-4 within gzip is the classic file again; memory that runs out in every format.
#include "io_support.h"

#include "bolan/io.h"

#include <math.h>
#include <stdlib.h>

static bolan_sea_summary load_sea(const char *file, uint32_t record, uint32_t location) {
    char path[1024];
    bolan_measured_spectrum *spectrum = NULL;
    bolan_spectrum_options options = bolan_spectrum_options_default();
    options.record = record;
    options.location = location;
    const bolan_result result = bolan_spectrum_load(test_data(file, path, sizeof path), &options, &spectrum);
    if (result) print_error("%s\n", last_sentence);
    assert_int_equal(result, BOLAN_OK);
    bolan_sea_state sea_state = bolan_sea_state_default();
    sea_state.measured = spectrum;
    const bolan_sea_summary summary = bolan_sea_state_summary(&sea_state);
    bolan_measured_spectrum_destroy(&spectrum);
    return summary;
}

// The first two times of the classic file, written by netCDF-C with compression and an unlimited axis.
static void netcdf4_is_the_classic_file_again(void **state) {
    (void)state;
    const bolan_io_features have = bolan_io_get_features();
    if (!have.gzip || !have.netcdf4) skip();
    for (uint32_t record = 0; record < 2; record++)
        for (uint32_t location = 1; location <= 2; location++) {
            const bolan_sea_summary a = load_sea("spectra/ww3_netcdf.nc", record, location);
            const bolan_sea_summary b = load_sea("spectra/packed/ww3_netcdf4.nc.gz", record, location);
            assert_memory_equal(&a, &b, sizeof a);
        }
    bolan_measured_spectrum *spectrum = NULL;
    FILE *file = fopen("spectra_a.nc", "wb");
    fwrite("\x89HDF\r\n\x1a\n and nothing more", 1, 25, file);
    fclose(file);
    assert_refusal(bolan_spectrum_load("spectra_a.nc", NULL, &spectrum), BOLAN_ERROR_FORMAT, BOLAN_LOG_FILE_UNPACK,
                   "spectra_a.nc: cannot be read as NetCDF-4: NetCDF");
    assert_null(spectrum);
    remove("spectra_a.nc");
}

static const char *const files[] = {"spectra/swan_maari_lonlat_24f36d.spec",
                                    "spectra/ww3_44097_50f36d.spec",
                                    "spectra/ndbc_41010.data_spec",
                                    "spectra/ww3_netcdf.nc",
                                    "spectra/era5_spectra.nc",
                                    "spectra/triaxys_20180131.DIRSPEC",
                                    "spectra/triaxys_20180131.NONDIRSPEC",
                                    "spectra/datawell_20240909T0115Z.spt",
                                    "spectra/spotter_20180214.json",
                                    "spectra/octopus_maari_20180311.oct"};
static char chosen[1024];

static bolan_result read_chosen(void) {
    bolan_measured_spectrum *spectrum = NULL;
    bolan_spectrum_options options = bolan_spectrum_options_default();
    if (strstr(chosen, "era5")) options.location = 26; // at sea
    const bolan_result result = bolan_spectrum_load(chosen, &options, &spectrum);
    assert_true((result == BOLAN_OK) == (spectrum != NULL));
    bolan_measured_spectrum_destroy(&spectrum);
    return result;
}

static void a_record_that_runs_out_of_memory(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        test_data(files[i], chosen, sizeof chosen);
        assert_memory_failures(read_chosen);
    }
}

static bolan_result list_chosen(void) {
    bolan_spectrum_contents *contents = NULL;
    const bolan_result result = bolan_spectrum_contents_load(chosen, &contents);
    assert_true((result == BOLAN_OK) == (contents != NULL));
    bolan_spectrum_contents_destroy(&contents);
    return result;
}

static void contents_that_run_out_of_memory(void **state) {
    (void)state;
    static const char *const listed[] = {"spectra/ww3_44097_50f36d.spec", "spectra/ww3_netcdf.nc",
                                         "spectra/spotter_20180214.json", "spectra/firstdry.spec"};
    for (size_t i = 0; i < sizeof listed / sizeof *listed; i++) {
        test_data(listed[i], chosen, sizeof chosen);
        assert_memory_failures(list_chosen);
    }
}

static bolan_result take_apart(void) {
    bolan_sea_state sea_state = bolan_sea_state_from_wind(10.0, 240.0, 100e3);
    bolan_partition parts[BOLAN_MAX_PARTITIONS];
    uint32_t count = 9;
    const bolan_result saved = bolan_spectrum_save(chosen, &sea_state, "sea");
    if (saved) assert_false(file_exists(chosen));
    if (saved) return saved;
    remove(chosen);
    const bolan_result result = bolan_sea_state_partition(&sea_state, parts, &count);
    assert_int_equal(count, result ? 0 : 1);
    return result;
}

static void writing_that_runs_out_of_memory(void **state) {
    (void)state;
    static const char *const written[] = {"spectra_b.csv", "spectra_b.spec"};
    for (size_t i = 0; i < sizeof written / sizeof *written; i++) {
        snprintf(chosen, sizeof chosen, "%s", written[i]);
        assert_memory_failures(take_apart);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(netcdf4_is_the_classic_file_again),
        cmocka_unit_test(a_record_that_runs_out_of_memory),
        cmocka_unit_test(contents_that_run_out_of_memory),
        cmocka_unit_test(writing_that_runs_out_of_memory),
    };
    return cmocka_run_group_tests(tests, listen_to_log, NULL);
}

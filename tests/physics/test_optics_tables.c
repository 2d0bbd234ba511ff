// SPDX-License-Identifier: MIT
// Attenuation by water type against the published tables of tests/data/optics. Red, green and blue are bands of 100 nm,
// so each coefficient lies between the smallest and the largest of its band.
#include "bolan/scene.h"
#include "support.h"

#include <string.h>

enum { COLUMNS = 13, BANDS = 3 }; // 400, 425 .. 700 nm; blue, green, red

// The row that begins with "NAME," of a CSV file.
static int read_row(FILE *file, const char *name, double *values, int capacity) {
    char line[512];
    const size_t length = strlen(name);
    rewind(file);
    while (fgets(line, sizeof line, file)) {
        if (strncmp(line, name, length) != 0 || line[length] != ',') continue;
        int count = 0;
        for (char *p = line + length; *p == ',' && count < capacity; count++) values[count] = strtod(p + 1, &p);
        return count;
    }
    return 0;
}

static FILE *open_table(const char *name) {
    char path[1024];
    FILE *file = fopen(test_data(name, path, sizeof path), "r");
    assert_non_null(file);
    return file;
}

static void kd_lies_within_jerlovs_bands(void **state) {
    (void)state;
    static const char *const types[] = {"I", "IA", "IB", "II", "III", "1C", "3C", "5C", "7C", "9C"};
    FILE *file = open_table("optics/jerlov_kd.csv");
    for (int t = BOLAN_JERLOV_I; t <= BOLAN_JERLOV_9C; t++) {
        double table[COLUMNS];
        assert_int_equal(read_row(file, types[t], table, COLUMNS), COLUMNS);
        const bolan_vec3 kd = bolan_water_optics_from_jerlov((bolan_jerlov)t).kd;
        const double found[BANDS] = {(double)kd.z, (double)kd.y, (double)kd.x};
        for (int band = 0; band < BANDS; band++) {
            double low = HUGE_VAL, high = 0.0;
            for (int i = 4 * band; i <= 4 * band + 4; i++) low = fmin(low, table[i]), high = fmax(high, table[i]);
            assert_true(found[band] > 0.999 * low && found[band] < 1.001 * high); // floats
        }
    }
    fclose(file);
}

static void no_water_is_clearer_than_pure_water(void **state) {
    (void)state;
    static const char *const nodes[BANDS] = {"450", "550", "650"};
    FILE *file = open_table("optics/pope_fry_1997_aw.csv");
    for (int t = BOLAN_JERLOV_I; t <= BOLAN_JERLOV_9C; t++) {
        const bolan_vec3 kd = bolan_water_optics_from_jerlov((bolan_jerlov)t).kd;
        const double found[BANDS] = {(double)kd.z, (double)kd.y, (double)kd.x};
        for (int band = 0; band < BANDS; band++) {
            double pure[2];
            assert_int_equal(read_row(file, nodes[band], pure, 2), 2); // absorption, scattering
            assert_true(found[band] > pure[0]);
        }
    }
    fclose(file);
}

RUN_TESTS(cmocka_unit_test(kd_lies_within_jerlovs_bands), cmocka_unit_test(no_water_is_clearer_than_pure_water))

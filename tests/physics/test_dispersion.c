// SPDX-License-Identifier: MIT
// Dispersion against its own equation, textbook values and the validation points of MHKiT (BSD-3, NREL/Sandia/PNNL).
#include "spectrum_support.h"

static void the_dispersion_relation_holds_to_rounding(void **state) {
    (void)state;
    for (double depth = 0.1; depth <= 1.0e4; depth *= 3.1)
        for (double k = 1e-4; k < 5e3; k *= 1.7) {
            const double w = bolan_omega_from_k(k, depth);
            const double w2 = (BOLAN_GRAVITY * k + BOLAN_SURFACE_TENSION_SEA * k * k * k) * tanh(k * depth);
            assert_ratio(w * w, w2, 1e-14); // a few roundings of libm's and our tanh
        }
    assert_true(bolan_omega_from_k(0.0, 10.0) == 0.0);
}

static void the_inverse_returns_the_wave_number_to_1e_12(void **state) {
    (void)state;
    for (double depth = 0.1; depth <= 1.0e4; depth *= 2.3)
        for (double k = 1e-4; k < 5e3; k *= 1.3)
            assert_ratio(bolan_k_from_omega(bolan_omega_from_k(k, depth), depth), k, 1e-12);
    assert_true(bolan_k_from_omega(0.0, 10.0) == 0.0);
    assert_ratio(bolan_k_from_omega(1e-9, 10.0), 1e-9 / sqrt(BOLAN_GRAVITY * 10.0), 1e-12); // the shallow limit
}

// Linear theory with g = 9.81: period, depth -> length, phase speed, group speed, shoaling coefficient.
static void lengths_and_speeds_match_the_tables_of_linear_theory(void **state) {
    (void)state;
    static const double table[][6] = {
        {5, 2, 20.9543, 4.19086, 3.76163, 1.01865},     {8, 5, 53.0815, 6.63519, 5.97075, 1.02273},
        {8, 10, 70.8984, 8.86229, 7.17954, 0.93267},    {10, 10, 92.3739, 9.23739, 8.06993, 0.98355},
        {10, 20, 121.2369, 12.12369, 9.27450, 0.91745}, {12, 50, 204.8328, 17.0694, 10.97675, 0.92381},
        {10, 1000, 156.1310, 15.6131, 7.80655, 1.0},
    };
    for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
        const double w = 2.0 * BOLAN_PI / table[i][0], depth = table[i][1];
        const double k = bolan_k_from_omega(w, depth), cg = bolan_group_speed(k, depth);
        // The table is printed to 5 or 6 digits; surface tension, which it leaves out, is 1e-6 of the slowest.
        assert_ratio(2.0 * BOLAN_PI / k, table[i][2], 5e-6);
        assert_ratio(w / k, table[i][3], 5e-6);
        assert_ratio(cg, table[i][4], 5e-6);
        assert_ratio(sqrt(BOLAN_GRAVITY / (2.0 * w) / cg), table[i][5], 1e-5);
    }
}

static void group_speed_is_the_slope_of_the_frequency(void **state) {
    (void)state;
    for (double depth = 0.1; depth <= 1.0e4; depth *= 7.0)
        for (double k = 1e-3; k < 3e3; k *= 2.0) {
            const double d = 1e-5 * k;
            const double slope = (bolan_omega_from_k(k + d, depth) - bolan_omega_from_k(k - d, depth)) / (2.0 * d);
            assert_ratio(bolan_group_speed(k, depth), slope, 1e-8); // differences: d^2 and rounding / d
        }
}

// sigma/rho = 7.17e-5: the slowest wave of the sea runs at 0.2303 m/s and is 16.99 mm long.
static void the_slowest_wave_is_seventeen_millimetres_long(void **state) {
    (void)state;
    double slowest = 1.0, length = 0.0;
    for (double k = 200.0; k < 700.0; k += 0.05) {
        const double c = bolan_omega_from_k(k, BOLAN_DEEP) / k;
        if (c < slowest) {
            slowest = c;
            length = 2.0 * BOLAN_PI / k;
        }
    }
    assert_near(slowest, 0.2303, 5e-5);
    assert_near(length, 0.01699, 5e-6);
}

// Reads the numbers of the array that follows "key" at or after *at.
static int read_array(const char **at, const char *key, double *values, int capacity) {
    const char *p = strstr(*at, key);
    assert_non_null(p);
    p = strchr(p + strlen(key), ':') + 1;
    int count = 0;
    p += strspn(p, " [");
    while (count < capacity) {
        char *end;
        values[count] = strtod(p, &end);
        if (end == p) break;
        count++;
        if (*end != ',') break;
        p = end + 1;
    }
    *at = p;
    return count;
}

static void sixty_validation_points_of_mhkit_agree(void **state) {
    (void)state;
    bolan_spectrum_text text = load_text("mhkit_ValData1.json");
    char *json = calloc(text.size + 1, 1);
    memcpy(json, text.data, text.size);
    int points = 0;
    for (const char *set = strstr(json, "\"Data1"); set; set = strstr(set + 1, "\"Data1")) {
        double k[64], w[64], h[1];
        const char *at = set;
        const int n = read_array(&at, "\"k\"", k, 64);
        at = set;
        assert_int_equal(read_array(&at, "\"w\"", w, 64), n);
        at = set;
        assert_int_equal(read_array(&at, "\"h\"", h, 1), 1);
        for (int i = 0; i < n; i++, points++) {
            // MHKiT leaves surface tension out: 7.3e-6 of w^2 at k = 1 1/m, the shortest of its waves.
            assert_ratio(bolan_omega_from_k(k[i], h[0]), w[i], 4e-6);
            assert_ratio(bolan_k_from_omega(w[i], h[0]), k[i], 8e-6);
        }
    }
    assert_int_equal(points, 60);
    free(json);
    free((char *)text.data);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_dispersion_relation_holds_to_rounding),
        cmocka_unit_test(the_inverse_returns_the_wave_number_to_1e_12),
        cmocka_unit_test(lengths_and_speeds_match_the_tables_of_linear_theory),
        cmocka_unit_test(group_speed_is_the_slope_of_the_frequency),
        cmocka_unit_test(the_slowest_wave_is_seventeen_millimetres_long),
        cmocka_unit_test(sixty_validation_points_of_mhkit_agree),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

// SPDX-License-Identifier: MIT
// Seas of several systems and kinds: what is synthesised has the spectrum that was asked for.
#include "sea_support.h"

#include "bolan/spectrum.h"

static double resolved_slopes(const bolan_sea *sea) {
    double sum = 0.0;
    for (uint32_t i = 0; i < bolan_sea_cascade_count(sea); i++) sum += bolan_sea_cascade(sea, i).mss;
    return sum;
}

static double spectral_slopes(const bolan_sea_state *state, double k_max) {
    double sum = 0.0;
    for (double u = log(1e-3); u < log(k_max); u += 0.02) {
        for (int d = 0; d < 120; d++) {
            const double k = exp(u + 0.01), th = (d + 0.5) * BOLAN_PI / 60;
            sum += bolan_sea_state_wavenumber_density(state, k * cos(th), k * sin(th)) * k * k * k * k * 0.02 *
                   BOLAN_PI / 60;
        }
    }
    return sum;
}

static void a_sea_of_elfouhaily_keeps_its_short_waves(void **state) {
    (void)state;
    bolan_sea_desc desc = bolan_sea_desc_default();
    desc.sea_state = bolan_sea_state_from_elfouhaily(8.0, 240.0, HUGE_VAL);
    desc.resolution = 128;
    bolan_sea *sea = test_sea(desc);
    const double k_max = bolan_sea_cascade(sea, 3).k_max;
    const double expected = spectral_slopes(&desc.sea_state, k_max), got = resolved_slopes(sea);
    assert_near(got, expected, 0.03 * expected);
    bolan_sea_destroy(&sea);
    // The same waves with a tail w^-5 in their place are rolled off to the slopes of Cox & Munk.
    desc.sea_state.systems[0].kind = BOLAN_SPECTRUM_JONSWAP;
    sea = test_sea(desc);
    double up, cross;
    bolan_cox_munk(8.0, &up, &cross);
    assert_true(resolved_slopes(sea) < up + cross);
    bolan_sea_destroy(&sea);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_sea_of_elfouhaily_keeps_its_short_waves),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

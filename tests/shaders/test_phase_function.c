// SPDX-License-Identifier: MIT
// The phase function of particles in water against its own integral and against what Petzold measured.
#include "shared/fournier_forand.glsl"
#include "bolan/math.h"
#include "support.h"

// Integral over the angles beyond `from`, in steps of even ratio.
static double integral(double from, double m) {
    enum { STEPS = 20000 };
    const double n = fournier_forand_index(m), ratio = log(PI / from);
    double sum = 0.0;
    for (int i = 0; i < STEPS; ++i) {
        const double t = from * exp(ratio * (i + 0.5) / STEPS);
        sum += fournier_forand(cos(t), n, m) * 2.0 * PI * sin(t) * t * ratio / STEPS;
    }
    return sum;
}

static void the_share_within_an_angle_is_the_integral(void **state) {
    (void)state;
    static const double exponents[] = {3.3, 3.5835, 3.9, 4.5}, angles[] = {2.0, 5.0, 30.0, 90.0, 150.0};
    for (int i = 0; i < 4; ++i)
        for (int k = 0; k < 5; ++k) {
            const double m = exponents[i], t = bolan_radians(angles[k]);
            assert_near(integral(t, m), 1.0 - fournier_forand_within(cos(t), fournier_forand_index(m), m), 1e-5);
        }
}

// Mobley, Sundman & Boss 2002: index 1.10 and exponent 3.5835 scatter 0.0183 back, as Petzold's mean does.
static void petzolds_water_scatters_two_hundredths_back(void **state) {
    (void)state;
    assert_near(fournier_forand_index(3.5835), 1.10, 1e-4);
    assert_near(1.0 - fournier_forand_within(0.0, 1.10, 3.5835), 0.0183, 1e-4);
    assert_near(fournier_forand_within(-1.0, 1.10, 3.5835), 1.0, 1e-9);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_share_within_an_angle_is_the_integral),
        cmocka_unit_test(petzolds_water_scatters_two_hundredths_back),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

// SPDX-License-Identifier: MIT
// Every function of shaders/shared/ on the GPU against the same source in C: each expression of the list below is
// compiled as GLSL and as C and evaluated at 256 places. C computes in double, so the bounds are single precision's
// rounding, for a function with a difference of nearly equal numbers as much more as that difference loses.
#include "probe.h"

#include "shared/attenuation.glsl"
#include "shared/bed.glsl"
#include "shared/cascade.glsl"
#include "shared/constants.glsl"
#include "shared/earth.glsl"
#include "shared/exp_cosine.glsl"
#include "shared/foam.glsl"
#include "shared/fresnel.glsl"
#include "shared/grid.glsl"
#include "shared/microfacets.glsl"
#include "shared/normal.glsl"
#include "shared/refraction.glsl"
#include "shared/surf.glsl"

#define R 6371000.0          // of the earth
#define SINGLE(x) (float)(x) // an argument that is a float in C too

// name, expression of a, b, c; ranges of a, b, c; absolute bound, relative bound
#define TWINS(X)                                                                                         \
    X(fresnel_from_air, fresnel(a, 1.34), 0.001, 1, 0, 0, 0, 0, 1e-6, 1e-5)                              \
    X(fresnel_from_water, fresnel(a, 1.0 / 1.34), 0.01, 0.65, 0, 0, 0, 0, 1e-6, 1e-5)                    \
    X(fresnel_at_the_window, fresnel(a, 1.0 / 1.34), 0.68, 1, 0, 0, 0, 0, 3e-5, 1e-4)                    \
    X(fresnel_straight, fresnel_normal(a), 1.01, 2.5, 0, 0, 0, 0, 1e-7, 1e-4)                            \
    X(fresnel_schlick, fresnel_fast(a, 1.34), 0, 1, 0, 0, 0, 0, 1e-6, 1e-5)                              \
    X(fresnel_mean, fresnel_mean_fast(a, b, 1.34), 0, 1, 0, 0.3, 0, 0, 1e-6, 1e-5)                       \
    X(refraction_path, refraction_tangent(a, b, c, 1.34), 0.1, 100, 0, 30, 0, 500, 1e-5, 1e-4)           \
    X(refraction_raises, refraction_k(a, 1.34), 0, 50, 0, 0, 0, 0, 1e-7, 1e-5)                           \
    X(seen_from_above, apparent_height(a, -b, c, 1.34), 0.1, 100, 0, 30, 0, 500, 1e-5, 1e-4)             \
    X(seen_from_below, apparent_height(-a, b, c, 1.34), 0.1, 30, 0.1, 30, 0, 200, 1e-4, 1e-3)            \
    X(snell, refracted_cosine(a, 1.34), 0, 1, 0, 0, 0, 0, 1e-6, 1e-6)                                    \
    X(tanh_by_fractions, rational_tanh(SINGLE(a)), 0, 12, 0, 0, 0, 0, 1e-6, 0)                           \
    X(coast, coast_attenuation(SINGLE(a), SINGLE(b)), -1, 50, 0, 12, 0, 0, 1e-6, 0)                      \
    X(coast_bands, coast_share2(SINGLE(a), SINGLE(b), SINGLE(c)), 0, 1, 0, 9, 0.1, 9, 1e-6, 1e-5)        \
    X(bed, bed_path(a, b), 0, 60, 0.3, 1, 0, 0, 1e-6, 1e-5)                                              \
    X(tile_along, along_tile(a, b, cos(c), sin(c)), -3, 3, -3, 3, -3, 3, 2e-6, 1e-5)                     \
    X(tile_across, across_tile(a, b, cos(c), sin(c)), -3, 3, -3, 3, -3, 3, 2e-6, 1e-5)                   \
    X(drop, earth_drop(a *a, R), 0, 400000, 0, 0, 0, 0, 1e-6, 1e-6)                                      \
    X(drop_of_the_sphere, earth_drop_exact(a *a, R), 0, 400000, 0, 0, 0, 0, 1e-6, 1e-6)                  \
    X(height, earth_height(a, b, c *c, R), -5, 5, 0, 30, 0, 9000, 1e-5, 1e-5)                            \
    X(horizon, earth_horizon(a, R), 0.5, 20000, 0, 0, 0, 0, 0, 1e-6)                                     \
    X(horizon_of_the_sphere, earth_horizon_exact(a, R), 0.5, 20000, 0, 0, 0, 0, 0, 1e-6)                 \
    X(dip, earth_dip(a, R), 0.5, 20000, 0, 0, 0, 0, 0, 1e-6)                                             \
    X(dip_of_the_sphere, earth_dip_exact(a, R), 0.5, 20000, 0, 0, 0, 0, 0, 3e-5)                         \
    X(shell, earth_shell(a, b, R), 0, 20000, 30000, 90000, 0, 0, 0, 1e-6)                                \
    X(height_along, earth_height_along(a, b, c, R), 0, 20000, -1, 1, 0, 9000, 2, 1e-4)                   \
    X(meets, earth_meets(a, b, R), 0.1, 3, 0.5, 9000, 0, 0, 0, 2e-6)                                     \
    X(meets_near_the_horizon, earth_meets(a *earth_dip(b, R), b, R), 0.9, 1.5, 0.5, 9000, 0, 0, 1, 5e-3) \
    X(meets_the_sphere, earth_meets_exact(b, -a, R), 0.1, 1, 0.5, 9000, 0, 0, 0, 2e-6)                   \
    X(half_phase_sine, half_sine(within_half_a_turn(a)), -3, 3, 0, 0, 0, 0, 1e-6, 0)                     \
    X(half_phase_cosine, half_cosine(within_half_a_turn(a)), -3, 3, 0, 0, 0, 0, 1e-6, 0)                 \
    X(exponential, exp_cosine(a, b, c), 0.1, 2, -1, 1, -3, 0, 2e-6, 1e-5)                                \
    X(exponential_slope, exp_cosine_slope(a, b, c, 0.0), 0.1, 2, -1, 1, -1, 1, 2e-6, 1e-5)               \
    X(row_parameter, grid_parameter(a), 0.001, 3000, 0, 0, 0, 0, 1e-5, 1e-5)                             \
    X(row_distance, grid_distance(a), 0.001, 2.3, 0, 0, 0, 0, 1e-5, 2e-5)                                \
    X(row_steepness, grid_steepness(a), 0.001, 300, 0, 0, 0, 0, 1e-6, 1e-6)                              \
    X(row_half_angle, grid_half_angle(a, b, c), 0.3, 1, 0, 30, 0, 300, 1e-6, 1e-6)                       \
    X(density, normal_pdf(a), -6, 6, 0, 0, 0, 0, 1e-6, 1e-5)                                             \
    X(distribution, normal_below(a, normal_pdf(a)), -4, 4, 0, 0, 0, 0, 1e-6, 1e-5)                       \
    X(distribution_fast, normal_cdf(a), -9, 9, 0, 0, 0, 0, 1e-6, 0)                                      \
    X(distribution_linear, normal_cdf_linear(a, b), -2, 2, 0.01, 2, 0, 0, 2e-6, 0)                       \
    X(cover, foam_cover(a, b), -2, 2, 0.01, 2, 0, 0, 2e-6, 1e-5)                                         \
    X(cover_fast, foam_cover_fast(a, b), -2, 2, 0.01, 2, 0, 0, 2e-6, 0)                                  \
    X(mills, normal_mills(a), 0, 6, 0, 0, 0, 0, 1e-6, 1e-5)                                              \
    X(opacity, foam_opacity(a, b, c), -2, 2, 0.01, 2, 0.1, 3, 3e-6, 1e-5)                                \
    X(opacity_thick, foam_opacity(a, b, c), -0.3, 0.3, 0.002, 0.1, 5, 50, 2e-5, 1e-4)                    \
    X(foam_deviations, foam_quantile(a), 0, 0.99, 0, 0, 0, 0, 2e-5, 1e-5)                                \
    X(streaked, streak_share(a), 0, 60, 0, 0, 0, 0, 1e-6, 1e-6)                                          \
    X(threshold, softened_offset(a, b, c), -2, 2, 0.01, 2, 0, 0.1, 1e-6, 1e-6)                           \
    X(bore, bore_foam(a), 0, 1, 0, 0, 0, 0, 1e-6, 1e-5)                                                  \
    X(shoal, shallows(a, b, b + c), 0, 3, 0.1, 1, 0.2, 2, 2e-6, 0)                                       \
    X(swash, surge(a, b, c), 0, 1, 0, 1, 0, 1, 2e-6, 0)                                                  \
    X(facets_area, facing_exact(a).area, -2, 20, 0, 0, 0, 0, 1e-6, 1e-5)                                 \
    X(facets_tilt, facing_exact(a).tilt, -1, 20, 0, 0, 0, 0, 1e-5, 1e-4)                                 \
    X(facets_kept, facing_exact(a).kept, -0.5, 20, 0, 0, 0, 0, 1e-5, 1e-4)                               \
    X(facets_area_fast, facing_fast(a).area, -2, 20, 0, 0, 0, 0, 1e-6, 1e-5)                             \
    X(facets_tilt_fast, facing_fast(a).tilt, -2, 20, 0, 0, 0, 0, 1e-6, 1e-5)                             \
    X(facets_kept_fast, facing_fast(a).kept, -2, 20, 0, 0, 0, 0, 1e-6, 1e-5)                             \
    X(lit, lit_fast(a, b), -0.1, 1, 0.01, 0.3, 0, 0, 1e-6, 1e-5)                                         \
    X(smith, smith_ratio(a), 0.05, 3, 0, 0, 0, 0, 2e-6, 1e-5)                                            \
    X(slopes, slope_density(a, b, 0.03, c, 0.02), -0.4, 0.4, -0.4, 0.4, -0.015, 0.015, 1e-6, 5e-5)       \
    X(glint, glint_radiance(a, 0.02, b, c, 0.5), 0, 50, 0.3, 1, 0, 1, 1e-6, 1e-5)

#define EVALUATE(name, expression, ...)                       \
    static double name##_in_c(double a, double b, double c) { \
        (void)a, (void)b, (void)c;                            \
        return (double)(expression);                          \
    }
TWINS(EVALUATE)

typedef struct twin {
    const char *name, *glsl;
    double (*c)(double a, double b, double c);
    double from[3], to[3], absolute, relative;
} twin;

#define ROW(name, expression, a0, a1, b0, b1, c0, c1, absolute, relative) \
    {#name, #expression, name##_in_c, {a0, b0, c0}, {a1, b1, c1}, absolute, relative},
static const twin twins[] = {TWINS(ROW)};
enum { COUNT = sizeof twins / sizeof *twins };

static const char includes[] = "#include \"shared/attenuation.glsl\"\n#include \"shared/bed.glsl\"\n"
                               "#include \"shared/cascade.glsl\"\n#include \"shared/constants.glsl\"\n"
                               "#include \"shared/earth.glsl\"\n#include \"shared/exp_cosine.glsl\"\n"
                               "#include \"shared/foam.glsl\"\n#include \"shared/surf.glsl\"\n"
                               "#include \"shared/fresnel.glsl\"\n#include \"shared/grid.glsl\"\n"
                               "#include \"shared/microfacets.glsl\"\n#include \"shared/refraction.glsl\"\n"
                               "#define R 6371000.0\n#define SINGLE(x) (x)\n";

// Places that fill the ranges evenly: multiples of irrational numbers, modulo 1; the first and last are the ends.
static void place(const twin *t, uint32_t i, float out[4]) {
    static const double steps[3] = {1.0, 0.6180339887, 0.7548776662};
    for (int k = 0; k < 3; ++k) {
        const double share = k == 0 ? i / (PROBE_WIDTH - 1.0) : fmod(i * steps[k], 1.0);
        out[k] = (float)(t->from[k] + share * (t->to[k] - t->from[k]));
    }
    out[3] = 0.0f;
}

static bool agrees(const twin *t) {
    float in[PROBE_WIDTH][4], out[PROBE_WIDTH][4];
    char body[256];
    for (uint32_t i = 0; i < PROBE_WIDTH; ++i) place(t, i, in[i]);
    snprintf(body, sizeof body, "vec4 probe(vec4 x) { float a = x.x, b = x.y, c = x.z; return vec4(%s); }", t->glsl);
    probe_run(includes, body, in, PROBE_WIDTH, out);
    for (uint32_t i = 0; i < PROBE_WIDTH; ++i) {
        const double want = t->c((double)in[i][0], (double)in[i][1], (double)in[i][2]);
        if (fabs((double)out[i][0] - want) <= t->absolute + t->relative * fabs(want)) continue;
        print_error("%s at (%g, %g, %g): %.9g on the GPU, %.9g in C\n", t->name, (double)in[i][0], (double)in[i][1],
                    (double)in[i][2], (double)out[i][0], want);
        return false;
    }
    return true;
}

static void the_gpu_computes_what_c_does(void **state) {
    (void)state;
    int failures = 0;
    for (int i = 0; i < COUNT; ++i) failures += !agrees(&twins[i]);
    assert_int_equal(failures, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {IN_BOTH_APIS(the_gpu_computes_what_c_does)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

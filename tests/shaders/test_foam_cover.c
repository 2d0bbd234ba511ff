// SPDX-License-Identifier: MIT
// How much of the sea is under foam: the law of shaders/shared/foam.glsl on real seas against the observed covers, and
// the noise of shaders/common/foam.glsl, which covers the same share at every distance.
#include "cascade_twin.h"
#include "probe.h"

#include "render/foam_statistics.h"
#include "render/foam_texture.h"
#include "render/frame.h"
#include "shared/foam.glsl"

// ---- covers by wind -------------------------------------------------------------------------------------------------

typedef struct covers {
    double breaking, all;
    bool can; // foam can form
} covers;

static uint32_t random_state;

static double unit(void) {
    random_state = random_state * 1664525u + 1013904223u;
    return (double)(random_state >> 8) / 16777216.0;
}

static double share_over(double excess, double variance) { return 0.5 * erfc(-excess / sqrt(2.0 * variance)); }

typedef struct measured_sea {
    bolan_sea *sea;
    foam_law law;
    double weight[4];
} measured_sea;

static measured_sea sea_of(double wind, uint32_t resolution, double edge) {
    bolan_sea_desc desc = bolan_sea_desc_default();
    desc.sea_state = bolan_sea_state_from_wind(wind, 240.0, 3e5);
    if (resolution) desc.resolution = resolution;
    measured_sea m = {0};
    assert_int_equal(bolan_sea_create(&desc, &m.sea), BOLAN_OK);
    bolan_sea_settle(m.sea, 20.0);
    m.law = bolan_foam_law(m.sea, edge * bolan_foam_breaking_edge(m.sea), true);
    const bolan_vec4 weights = bolan_foam_weights(m.sea);
    const double weight[] = {(double)weights.x, (double)weights.y, (double)weights.z, (double)weights.w};
    memcpy(m.weight, weight, sizeof weight);
    return m;
}

// Jacobian less 1 and foam memory at the next random places, one of each tile: tiles are independent. The places have
// drifted with the foam since tick 0 until `tick`.
static void at_random(const measured_sea *m, double tick, double *jacobian, double *memory) {
    const double choppiness = bolan_sea_get_desc(m->sea)->choppiness;
    double xx = 1.0, yy = 1.0, xy = 0.0;
    *memory = 0.0;
    for (uint32_t c = 0; c < bolan_sea_cascade_count(m->sea); ++c) {
        const bolan_cascade_view v = bolan_sea_cascade(m->sea, c);
        uint32_t drift[2];
        bolan_sea_foam_drift(m->sea, c, tick, drift);
        const double x = v.n * fmod(unit() + drift[0] * 0x1p-32, 1.0), y = v.n * fmod(unit() + drift[1] * 0x1p-32, 1.0);
        const twin_place p = {v.n, (uint32_t)x % v.n, (uint32_t)y % v.n, x - floor(x), y - floor(y)};
        xx += choppiness * twin_linear(TWIN_PLANE(&v, dxx), &p);
        yy += choppiness * twin_linear(TWIN_PLANE(&v, dyy), &p);
        xy += choppiness * twin_linear(TWIN_TEXELS(&v, dxy), &p);
        *memory += m->weight[c] * twin_linear(TWIN_PLANE(&v, foam), &p);
    }
    *jacobian = xx * yy - xy * xy - 1.0;
}

// Shares that are beyond the thresholds.
static covers measure(double wind) {
    measured_sea m = sea_of(wind, 0, 1.0);
    covers sum = {0.0, 0.0, bolan_foam_can_form(m.sea)};
    enum { PLACES = 200000 };
    random_state = 7;
    for (int i = 0; i < PLACES; ++i) {
        double jacobian, memory;
        at_random(&m, 0.0, &jacobian, &memory);
        const double fresh = share_over(m.law.breaking - jacobian, m.law.edge);
        const double old = share_over(memory - m.law.memory, OLD_FOAM_EDGE * m.law.memory_variance);
        sum.breaking += fresh / PLACES, sum.all += (1.0 - (1.0 - fresh) * (1.0 - old)) / PLACES;
    }
    bolan_sea_destroy(&m.sea);
    return sum;
}

// Callaghan et al. 2008, extended over the 23 m/s that were observed; Monahan 1993 for the crests that break.
static double callaghan(double u) {
    return fmin(3.18e-5 * pow(fmax(u - 3.70, 0.0), 3.0), 4.82e-6 * pow(u + 1.98, 3.0));
}

static void foam_covers_what_was_observed(void **state) {
    (void)state;
    static const double winds[] = {3.0, 5.0, 7.0, 10.0, 14.0, 19.0, 24.0, 30.0, 38.0, 50.0};
    for (size_t k = 0; k < sizeof winds / sizeof *winds; ++k) {
        const double u = winds[k], breaking = fmin(3.16e-7 * pow(u, 3.2), callaghan(u));
        const covers c = measure(u);
        print_message("%.0f m/s: breaking %.2g (%.2g), all %.2g (%.2g)\n", u, c.breaking, breaking, c.all,
                      callaghan(u));
        assert_int_equal(c.can, u > 3.7);
        if (u < 3.7) assert_true(c.breaking == 0.0 && c.all == 0.0);
        if (u < 3.7) continue;
        // at 5 m/s a few places in a hundred thousand
        assert_near(log(c.breaking / breaking), 0.0, log(u > 6.0 ? 1.67 : 5.0));
        assert_near(log(c.all / callaghan(u)), 0.0, log(u > 6.0 ? 1.33 : 5.0));
    }
}

// How long foam lasts, as it drifts: mean over the foam that is seen at one moment [s]. At the default resolution:
// coarser samples blur what lies between them.
static double life(double wind) {
    enum { PLACES = 3000, STEPS = 160 };
    static uint32_t lasted[PLACES];
    const double step = 0.125;
    measured_sea m = sea_of(wind, 0, 0.0);
    double all = 0.0, squares = 0.0;
    memset(lasted, 0, sizeof lasted);
    for (int t = 0; t < STEPS; ++t) {
        bolan_sea_step(m.sea, 20.0 + step * t);
        random_state = 7; // the same places
        for (int i = 0; i < PLACES; ++i) {
            double jacobian, memory;
            at_random(&m, bolan_sea_get_clock(m.sea).now, &jacobian, &memory);
            if (jacobian < m.law.breaking || memory > m.law.memory) {
                lasted[i]++;
            } else {
                all += lasted[i], squares += (double)lasted[i] * lasted[i];
                lasted[i] = 0;
            }
        }
    }
    bolan_sea_destroy(&m.sea);
    return step * squares / all;
}

static void dense_foam_lasts_for_seconds(void **state) {
    (void)state;
    static const double winds[] = {10.0, 15.0, 24.0};
    for (int k = 0; k < 3; ++k) {
        const double seconds = life(winds[k]);
        print_message("%.0f m/s: foam of whitecaps lasts for %.2f s\n", winds[k], seconds);
        assert_true(seconds > 1.0 && seconds < 3.0);
    }
}

// ---- noise ----------------------------------------------------------------------------------------------------------

typedef struct rig {
    gl_texture noise;
    block_buffers uniforms;
    block_values blocks;
} rig;

static void set_foam(const gl_program *program, const void *context) {
    const rig *r = context;
    (void)program;
    bolan_blocks_bind(&r->uniforms);
    bolan_gl_texture_bind(&r->noise, UNIT_FOAM_DETAIL);
}

// x: quantile of the share, width of the pixel [m], density. Mean opacity of fresh and old foam and of streaks, and
// half the squares of the first and the last: how much of them is resolved.
static const char *const probe_body =
    "vec4 probe(vec4 x) {\n"
    "    vec4 sum = vec4(0.0);\n"
    "    for (int i = 0; i < 4096; ++i) {\n"
    "        vec2 at = 2000.0 * fract(float(i) * vec2(0.75487766, 0.56984029));\n"
    "        foam_texels t = foam_look_up(at, x.y);\n"
    "        float fresh = foam_film(x.x, 0.0, 1.0, patch_grain(t, FRESH_WEIGHTS, x.y), x.z);\n"
    "        float old = foam_film(x.x, 0.0, 1.0, patch_grain(t, OLD_WEIGHTS, x.y), x.z);\n"
    "        foam_grain windrows = streak_grain(t, x.y, windrow_texels(at, x.y), x.y);\n"
    "        float streaks = foam_film(x.x, 0.0, 1.0, windrows, x.z);\n"
    "        sum += vec4(fresh, old, streaks, 0.5 * (fresh * fresh + streaks * streaks)) / 4096.0;\n"
    "    }\n"
    "    return sum;\n"
    "}\n";

static void noise_covers_the_same_share_at_every_distance(void **state) {
    (void)state;
    static const double shares[][2] = {{0.02, -2.05375}, {0.1, -1.28155}, {0.5, 0.0}, {0.9, 1.28155}};
    static const float widths[] = {0.0002f, 0.02f, 0.1f, 0.5f, 2.0f, 10.0f, 100.0f, 2000.0f};
    enum { SHARES = sizeof shares / sizeof *shares, WIDTHS = sizeof widths / sizeof *widths };
    rig r = {.blocks = {.frame = {.wind_direction = {0.8f, 0.6f}, .streak_scale = {1.0f / 300.0f, 1.0f / 1800.0f}},
                        .view = {.foam_wrapped = {700.0f, 100.0f}}}};
    float in[SHARES * WIDTHS][4], out[SHARES * WIDTHS][4];
    for (int i = 0; i < SHARES; ++i)
        for (int j = 0; j < WIDTHS; ++j) {
            float *x = in[i * WIDTHS + j];
            x[0] = (float)shares[i][1], x[1] = widths[j], x[2] = 1000.0f, x[3] = 0.0f; // thick: it hides what it covers
        }
    assert_int_equal(bolan_foam_noise_create(&r.noise), BOLAN_OK);
    assert_int_equal(bolan_blocks_create(&r.uniforms), BOLAN_OK);
    bolan_blocks_upload(&r.uniforms, &r.blocks);
    probe_run_with("#include \"common/frame.glsl\"\n#include \"common/foam.glsl\"", probe_body, NULL, set_foam, &r, in,
                   SHARES * WIDTHS, out);
    for (int i = 0; i < SHARES; ++i) {
        const double share = shares[i][0], bound = 0.005 + 0.2 * fmin(share, 1.0 - share);
        for (int j = 0; j < WIDTHS; ++j)
            for (int k = 0; k < 3; ++k) assert_near(out[i * WIDTHS + j][k], share, bound);
        const float half = 0.5f * (out[i * WIDTHS][0] + out[i * WIDTHS][2]);
        assert_true(out[i * WIDTHS][3] > 0.95f * half);                     // near, foam is or is not
        assert_near(out[i * WIDTHS + WIDTHS - 1][3], share * share, 0.003); // far, the mean is left
    }
    bolan_blocks_free(&r.uniforms);
    bolan_gl_texture_free(&r.noise);
}

// x: sine of the sun's angle from the zenith, width of the pixel [m], azimuth. Mean and mean square of the relief; what
// the nets rise towards the sun within 8 cm, and its product with the relief.
static const char *const relief_body =
    "vec4 probe(vec4 x) {\n"
    "    vec4 sum = vec4(0.0);\n"
    "    vec2 towards = vec2(cos(x.z), sin(x.z));\n"
    "    for (int i = 0; i < 4096; ++i) {\n"
    "        vec2 at = 2000.0 * fract(float(i) * vec2(0.75487766, 0.56984029));\n"
    "        float rise = foam_look_up(at + 0.04 * towards, x.y).middle.g -\n"
    "                     foam_look_up(at - 0.04 * towards, x.y).middle.g;\n"
    "        float relief = foam_relief(foam_look_up(at, x.y), at, x.y);\n"
    "        sum += vec4(relief, relief * relief, rise * rise, relief * rise) / 4096.0;\n"
    "    }\n"
    "    return sum;\n"
    "}\n";

static void foam_that_rises_towards_the_sun_faces_away_from_it(void **state) {
    (void)state;
    enum { SUNS = 5 };
    rig r = {.blocks = {.frame = {.streak_scale = {1.0f / 300.0f, 1.0f / 1800.0f}},
                        .view = {.foam_wrapped = {700.0f, 100.0f}}}};
    assert_int_equal(bolan_foam_noise_create(&r.noise), BOLAN_OK);
    assert_int_equal(bolan_blocks_create(&r.uniforms), BOLAN_OK);
    for (int i = 0; i < SUNS; ++i) {
        const float azimuth = 1.3f * (float)i, low = 0.2f * (float)i;
        float in[2][4] = {{low, 0.004f, azimuth, 0.0f}, {low, 0.29f, azimuth, 0.0f}}, out[2][4];
        r.blocks.frame.sun_direction = (bolan_vec3){low * cosf(azimuth), low * sinf(azimuth), sqrtf(1.0f - low * low)};
        bolan_blocks_upload(&r.uniforms, &r.blocks);
        probe_run_with("#include \"common/frame.glsl\"\n#include \"common/foam.glsl\"", relief_body, NULL, set_foam, &r,
                       in, 2, out);
        const float deviation = sqrtf(out[0][1]);
        assert_near(out[0][0], 0.0, 0.05f * deviation + 1e-6); // three errors of the mean of 4096
        // Nets are a part of the relief, whose slope goes over half of these 8 cm. The other part is that of bubbles.
        if (i > 0) assert_true(out[0][3] > 0.3f * deviation * sqrtf(out[0][2]));
        assert_near(deviation, 0.3f * low, 0.12f * low);     // foam is not steep; a sun in the zenith sees no relief
        assert_true(out[1][1] < 1e-4f * out[0][1] + 1e-12f); // nor one of 0.29 m: no seam where it ends
    }
    bolan_blocks_free(&r.uniforms);
    bolan_gl_texture_free(&r.noise);
}

// x: quantile of the share, width of the pixel [m]. Mean and variance of the light of the sky on foam; mean opacity,
// and mean light of the foam of that opacity, over that of a flat film.
static const char *const hollows_body =
    "vec4 probe(vec4 x) {\n"
    "    vec4 sum = vec4(0.0);\n"
    "    for (int i = 0; i < 4096; ++i) {\n"
    "        foam_texels t = foam_look_up(2000.0 * fract(float(i) * vec2(0.75487766, 0.56984029)), x.y);\n"
    "        float light = foam_hollows(t), film = foam_film(x.x, 0.0, 1.0, patch_grain(t, OLD_WEIGHTS, x.y), 4.0);\n"
    "        sum += vec4(light, (light - 1.0) * (light - 1.0), film, film * mix(1.0, light, film)) / 4096.0;\n"
    "    }\n"
    "    return sum;\n"
    "}\n";

static void hollows_of_foam_keep_its_light_at_every_distance(void **state) {
    (void)state;
    static const float widths[] = {0.002f, 0.02f, 0.1f, 1.0f, 100.0f};
    enum { WIDTHS = sizeof widths / sizeof *widths };
    rig r = {.blocks = {.frame = {.wind_direction = {0.8f, 0.6f}, .streak_scale = {1.0f / 300.0f, 1.0f / 1800.0f}},
                        .view = {.foam_wrapped = {700.0f, 100.0f}, .eddies_wrapped = {300.0f, 200.0f}}}};
    float in[2 * WIDTHS][4] = {{0}}, out[2 * WIDTHS][4];
    for (int i = 0; i < 2 * WIDTHS; ++i) in[i][0] = i < WIDTHS ? -1.28155f : 0.0f, in[i][1] = widths[i % WIDTHS];
    assert_int_equal(bolan_foam_noise_create(&r.noise), BOLAN_OK);
    assert_int_equal(bolan_blocks_create(&r.uniforms), BOLAN_OK);
    bolan_blocks_upload(&r.uniforms, &r.blocks);
    probe_run_with("#include \"common/frame.glsl\"\n#include \"common/foam.glsl\"", hollows_body, NULL, set_foam, &r,
                   in, 2 * WIDTHS, out);
    for (int i = 0; i < 2 * WIDTHS; ++i) {
        assert_near(out[i][0], 1.0, 0.01);             // three errors of the mean of 4096
        assert_near(out[i][3] / out[i][2], 1.0, 0.02); // likewise of those that foam covers
    }
    assert_near(sqrtf(out[0][1]), 0.15, 0.02);       // near: both cells of HOLLOWS
    assert_true(sqrtf(out[WIDTHS - 1][1]) < 0.005f); // far: none
    bolan_blocks_free(&r.uniforms);
    bolan_gl_texture_free(&r.noise);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(foam_covers_what_was_observed),
                                       cmocka_unit_test(dense_foam_lasts_for_seconds),
                                       IN_BOTH_APIS(foam_that_rises_towards_the_sun_faces_away_from_it),
                                       IN_BOTH_APIS(hollows_of_foam_keep_its_light_at_every_distance),
                                       IN_BOTH_APIS(noise_covers_the_same_share_at_every_distance)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

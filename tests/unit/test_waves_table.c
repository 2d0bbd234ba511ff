// SPDX-License-Identifier: MIT
// Every wave model through the same functions: what waves.h promises of all of them.
#include "sea_support.h"

#include <string.h>

enum { MODELS = BOLAN_WAVE_MODELS, POINTS = 1000 };

static bolan_sea_desc desc_of(int model) {
    bolan_sea_desc desc = bolan_sea_desc_default();
    desc.waves = (bolan_wave_model)model;
    desc.sea_state = bolan_sea_state_from_wind(12.0, 250.0, 100e3);
    return desc;
}

static bolan_sea_desc small(int model) {
    bolan_sea_desc desc = desc_of(model);
    desc.resolution = 32;
    return desc;
}

static bool is_sum(int model) { return model == BOLAN_WAVES_COSINES || model == BOLAN_WAVES_EXP_COSINE; }

static void places(bolan_dvec2 at[POINTS]) {
    for (int i = 0; i < POINTS; i++) at[i] = (bolan_dvec2){37.7 * i - 9000.0, 17.3 * (i % 97) * (i % 89)};
}

static void every_model_has_its_name_and_form(void **state) {
    (void)state;
    const char *const names[MODELS] = {"fft", "cosines", "exp-cosine", "textures"};
    const bolan_wave_form forms[MODELS] = {BOLAN_FORM_CASCADES, BOLAN_FORM_COSINES, BOLAN_FORM_EXP_COSINES,
                                           BOLAN_FORM_CASCADES};
    const uint32_t cascades[MODELS] = {4, 0, 0, 1}, components[MODELS] = {0, 16 * 8, 8, 0};
    assert_null(bolan_wave_model_names[MODELS]);
    for (int model = 0; model < MODELS; model++) {
        bolan_sea *sea = test_sea(small(model));
        assert_string_equal(bolan_wave_model_names[model], names[model]);
        assert_int_equal(bolan_sea_form(sea), forms[model]);
        assert_int_equal(bolan_sea_cascade_count(sea), cascades[model]);
        assert_int_equal(bolan_sea_component_count(sea), components[model]);
        assert_int_equal(bolan_sea_get_desc(sea)->waves, model);
        assert_string_equal(bolan_sea_record_time(sea), "");
        bolan_sea_destroy(&sea);
    }
}

// A table that reads its fields at the wrong place or time would be off by Hs / 4 times the root of 2.
static void samples_are_those_of_the_direct_sum(void **state) {
    (void)state;
    bolan_dvec2 at[POINTS];
    places(at);
    for (int model = 0; model < MODELS; model++) {
        bolan_sea *sea = test_sea(desc_of(model));
        static bolan_sea_sample s[POINTS];
        double error = 0.0, slope_error = 0.0, slope = 0.0;
        enum { COMPARED = 40 };
        bolan_sea_step(sea, 21.7);
        bolan_sea_sample_rest(sea, at, COMPARED, s);
        for (int i = 0; i < COMPARED; i++) {
            const bolan_sea_sample d = bolan_sea_sample_direct(sea, at[i].x, at[i].y, 21.7);
            error += pow((double)s[i].height - (double)d.height, 2.0) / COMPARED;
            slope_error += pow((double)s[i].slope_x - (double)d.slope_x, 2.0) / COMPARED;
            slope += pow((double)d.slope_x, 2.0) / COMPARED;
        }
        const double sigma = 0.25 * bolan_sea_get_summary(sea)->hs;
        print_message("%s: height off by %.4f sigma, slope by %.3f of itself\n", bolan_wave_model_names[model],
                      sqrt(error) / sigma, sqrt(slope_error / slope));
        assert_true(sqrt(error) < (is_sum(model) ? 1e-4 : 0.1) * sigma); // cascades interpolate between samples
        assert_true(sqrt(slope_error) < (is_sum(model) ? 1e-3 : 0.7) * sqrt(slope));
        bolan_sea_destroy(&sea);
    }
}

static void samples_lie_within_the_bounds_and_a_grid_takes_short_waves_away(void **state) {
    (void)state;
    bolan_dvec2 at[POINTS];
    static float spacing[3][POINTS];
    static bolan_sea_sample rest[POINTS], grid[POINTS];
    places(at);
    for (int i = 0; i < POINTS; i++) spacing[0][i] = 0.0f, spacing[1][i] = 8.0f, spacing[2][i] = 1e5f;
    for (int model = 0; model < MODELS; model++) {
        bolan_sea *sea = test_sea(desc_of(model));
        double vertical, horizontal, slope[3] = {0};
        bolan_sea_bounds(sea, &vertical, &horizontal);
        assert_true(vertical > 0.0 && (horizontal > 0.0) == (model != BOLAN_WAVES_EXP_COSINE));
        bolan_sea_settle(sea, 33.0);
        bolan_sea_sample_rest(sea, at, POINTS, rest);
        float highest = 0.0f;
        for (int i = 0; i < POINTS; i++) {
            assert_true(fabs((double)rest[i].height) <= vertical);
            assert_true(hypot((double)rest[i].dx, (double)rest[i].dy) <= horizontal);
            assert_true(rest[i].foam >= 0.0f);
            highest = fmaxf(highest, rest[i].height);
        }
        assert_true((double)highest > 0.2 * vertical); // the bounds are of this sea
        bolan_sea_sample_grid(sea, at, NULL, POINTS, grid);
        assert_memory_equal(grid, rest, sizeof rest);
        for (int s = 0; s < 3; s++) {
            bolan_sea_sample_grid(sea, at, spacing[s], POINTS, grid);
            for (int i = 0; i < POINTS; i++) slope[s] += (double)grid[i].slope_x * (double)grid[i].slope_x;
        }
        assert_true(slope[0] > 0.0 && slope[1] < 0.9 * slope[0] && slope[2] < 1e-6 * slope[0]);
        bolan_sea_destroy(&sea);
    }
}

static double foam_on_grid(const bolan_sea *sea, const bolan_dvec2 *at, double spacing) {
    static float all[POINTS];
    static bolan_sea_sample grid[POINTS];
    double sum = 0.0;
    for (int i = 0; i < POINTS; i++) all[i] = (float)spacing;
    bolan_sea_sample_grid(sea, at, all, POINTS, grid);
    for (int i = 0; i < POINTS; i++) sum += (double)grid[i].foam;
    return sum;
}

// Of a cascade that has half faded away, and of one that has faded altogether.
static void the_foam_of_waves_that_a_grid_averages_away_stays(void **state) {
    (void)state;
    bolan_dvec2 at[POINTS];
    places(at);
    bolan_sea *sea = test_sea(desc_of(BOLAN_WAVES_FFT));
    bolan_sea_settle(sea, 33.0);
    const double all = foam_on_grid(sea, at, 0.0);
    assert_true(all > 0.0);
    for (uint32_t c = 0; c < bolan_sea_cascade_count(sea); c++) {
        const bolan_cascade_view v = bolan_sea_cascade(sea, c);
        const double longest = v.k_min > 0.0 ? 2.0 * BOLAN_PI / v.k_min : v.length;
        assert_near(foam_on_grid(sea, at, longest / 3.0) / all, 1.0, 0.03);
        assert_near(foam_on_grid(sea, at, longest) / all, 1.0, 0.03);
    }
    bolan_sea_destroy(&sea);
}

static void every_model_carries_the_energy_of_its_sea_state(void **state) {
    (void)state;
    for (int model = 0; model < MODELS; model++) {
        bolan_sea *sea = test_sea(desc_of(model));
        const bolan_sea_summary *asked = bolan_sea_get_summary(sea);
        bolan_sea_step(sea, 50.0);
        const bolan_sea_statistics got = bolan_sea_measure(sea);
        print_message("%s: Hs %.2f of %.2f m, Tp %.2f of %.2f s, mean %.3f m\n", bolan_wave_model_names[model], got.hs,
                      asked->hs, got.tp, asked->tp, got.mean_level);
        assert_near(got.hs, asked->hs, 0.15 * asked->hs); // one realisation, and few waves of a sum
        assert_near(got.tp, asked->tp, 0.12 * asked->tp);
        assert_near(got.m0_spectrum, asked->m0, 1e-9 * asked->m0);
        assert_near(got.mean_level, 0.0, 0.03 * asked->hs);
        assert_true(got.mss > 0.0 && got.mss_up > got.mss_cross);
        bolan_sea_destroy(&sea);
    }
}

// A footprint of 100 km removes all slopes, none leaves the wind's short waves; the table is the function.
static void slopes_are_removed_by_their_footprint(void **state) {
    (void)state;
    for (int model = 0; model < MODELS; model++) {
        bolan_sea *sea = test_sea(desc_of(model));
        float none[3], some[3], all[3], texel[3];
        bolan_sea_unresolved_slopes(sea, 0.0, 0.0, 0.0, none);
        bolan_sea_unresolved_slopes(sea, 1.0, 0.5, 0.3, some);
        bolan_sea_unresolved_slopes(sea, 1e5, 1e5, 0.0, all);
        assert_true(none[0] + none[2] < some[0] + some[2] && some[0] + some[2] < all[0] + all[2]);
        bolan_sea_step(sea, 10.0);
        double held = 0.0;
        bolan_dvec2 at[POINTS];
        static bolan_sea_sample s[POINTS];
        places(at);
        bolan_sea_sample_rest(sea, at, POINTS, s);
        for (int i = 0; i < POINTS; i++)
            held += (double)(s[i].slope_x * s[i].slope_x + s[i].slope_y * s[i].slope_y) *
                    fmax((double)s[i].jacobian, 0.0) / POINTS;
        const double expected = (double)(all[0] + all[2] - none[0] - none[2]);
        assert_true(held > 0.4 * expected && held < 2.0 * expected); // interpolation takes away, folds add
        const float *table = bolan_sea_slope_table(sea);
        const int i = 15, j = 2, l = 3;
        const double major = exp2(i / 1.5 - 11.0);
        bolan_sea_unresolved_slopes(sea, major, major / 4.0, l * BOLAN_PI / 8.0, texel);
        for (int e = 0; e < 3; e++)
            assert_near(table[((l * BOLAN_SLOPE_TABLE_ASPECT + j) * BOLAN_SLOPE_TABLE_MAJOR + i) * 4 + e], texel[e],
                        1e-6 * (double)(all[0] + all[2]));
        bolan_sea_destroy(&sea);
    }
}

static void only_waves_that_move_sideways_are_lifted_and_foam(void **state) {
    (void)state;
    for (int model = 0; model < MODELS; model++) {
        bolan_sea *sea = test_sea(desc_of(model));
        const double lift = bolan_sea_lift(sea, 0, 0.0), coarse = bolan_sea_lift(sea, 0, 1e6);
        const double threshold = bolan_sea_foam_threshold(sea);
        if (model == BOLAN_WAVES_EXP_COSINE) {
            assert_true(lift == 0.0 && threshold == -1e30);
        } else {
            assert_true(lift > 0.0 && lift < 0.2 * bolan_sea_get_summary(sea)->hs);
            assert_true(threshold > -1.0 && threshold < 1.0);
        }
        assert_true(coarse == 0.0);
        bolan_sea_destroy(&sea);
    }
}

// ---- what a model reads of the desc ---------------------------------------------------------------------------------

static void hash_of(bolan_sea_desc desc, char out[17]) {
    bolan_sea *sea = test_sea(desc);
    bolan_sea_step(sea, 3.3);
    bolan_sea_hash(sea, out);
    bolan_sea_destroy(&sea);
}

enum {
    FFT = 1 << BOLAN_WAVES_FFT,
    COSINES = 1 << BOLAN_WAVES_COSINES,
    EXP = 1 << BOLAN_WAVES_EXP_COSINE,
    TEXTURES = 1 << BOLAN_WAVES_TEXTURES
};

// The models whose fields are others after the change are `readers` and no more.
static void check_readers(const char *field, void (*change)(bolan_sea_desc *desc), int readers) {
    for (int model = 0; model < MODELS; model++) {
        bolan_sea_desc desc = small(model);
        char before[17], after[17];
        hash_of(desc, before);
        change(&desc);
        hash_of(desc, after);
        if ((strcmp(before, after) != 0) != ((readers >> model & 1) != 0))
            fail_msg("%s: %s %s", field, bolan_wave_model_names[model],
                     readers >> model & 1 ? "does not read it" : "reads it");
    }
}

#define CHANGE(name, assignment) \
    static void change_##name(bolan_sea_desc *desc) { desc->assignment; }
CHANGE(seed, seed = 77)
CHANGE(choppiness, choppiness = 0.3)
CHANGE(loop, loop_period = 20.0)
CHANGE(current, sea_state.current_x = 2.0)
CHANGE(resolution, resolution = 64)
CHANGE(length, length = 640.0)
CHANGE(cascades, fft.cascade_count = 2)
CHANGE(period, textures.period = 5.0)
CHANGE(frames, textures.frames = 7)
CHANGE(frequencies, cosines.frequencies = 5)
CHANGE(directions, cosines.directions = 3)
CHANGE(split, cosines.split = BOLAN_SPLIT_EQUAL_WIDTH)
CHANGE(waves, exp_cosine.wave_count = 3)
CHANGE(sharpness, exp_cosine.sharpness = 1.0)

static void a_field_of_one_model_is_read_by_that_model_alone(void **state) {
    (void)state;
    check_readers("seed", change_seed, FFT | TEXTURES | COSINES | EXP);
    check_readers("choppiness", change_choppiness, 0); // the fields are of D itself
    check_readers("loop_period", change_loop, FFT | COSINES | EXP);
    check_readers("current_x", change_current, FFT | TEXTURES | COSINES | EXP);
    check_readers("resolution", change_resolution, FFT | TEXTURES);
    check_readers("length", change_length, FFT | TEXTURES);
    check_readers("fft.cascade_count", change_cascades, FFT);
    check_readers("textures.period", change_period, TEXTURES);
    check_readers("textures.frames", change_frames, TEXTURES);
    check_readers("cosines.frequencies", change_frequencies, COSINES);
    check_readers("cosines.directions", change_directions, COSINES);
    check_readers("cosines.split", change_split, COSINES);
    check_readers("exp_cosine.wave_count", change_waves, EXP);
    check_readers("exp_cosine.sharpness", change_sharpness, EXP);
}

static void every_model_repeats_after_its_period(void **state) {
    (void)state;
    for (int model = 0; model < MODELS; model++) {
        bolan_sea_desc desc = small(model);
        desc.loop_period = 40.0;
        desc.textures.period = 8.0;
        desc.textures.frames = 5;
        bolan_sea *sea = test_sea(desc);
        const bool textures = model == BOLAN_WAVES_TEXTURES;
        const double period = textures ? 8.0 : 40.0;
        bolan_sea_loop loop = bolan_sea_get_loop(sea);
        assert_near(loop.period, period, 0.0);
        assert_int_equal(loop.frames, textures ? 5 : 0);
        char hash[5][17];
        const double times[] = {3.5, 3.5 + period, 3.5 + 0.4 * period, 4.7, -0.1};
        const uint32_t frames[] = {2, 2, 4, 2, 4}; // 3.5 s and 4.7 s of 8 s lie in the third fifth
        for (int i = 0; i < 5; i++) {
            bolan_sea_step(sea, times[i]);
            loop = bolan_sea_get_loop(sea);
            assert_int_equal(loop.frame, textures ? frames[i] : 0);
            bolan_sea_hash(sea, hash[i]);
        }
        assert_string_equal(hash[0], hash[1]);
        assert_string_not_equal(hash[0], hash[2]);
        assert_true((strcmp(hash[0], hash[3]) == 0) == textures); // time stands still for a frame
        bolan_sea_destroy(&sea);
    }
    bolan_sea *sea = test_sea(small(BOLAN_WAVES_FFT));
    assert_true(bolan_sea_get_loop(sea).period == 0.0); // by default no repetition
    bolan_sea_destroy(&sea);
}

// ---- refusals -------------------------------------------------------------------------------------------------------

typedef struct heard {
    uint32_t sentences;
    bolan_log_id id;
    char sentence[256];
} heard;

static void hear(void *user, bolan_log_level level, bolan_log_id id, const char *sentence) {
    heard *h = user;
    (void)level;
    h->sentences++;
    h->id = id;
    snprintf(h->sentence, sizeof h->sentence, "%s", sentence);
}

static void break_cascades(bolan_sea_desc *d) { d->fft.cascade_count = 9; }
static void break_period(bolan_sea_desc *d) { d->textures.period = 0.5; }
static void break_frames(bolan_sea_desc *d) { d->textures.frames = 1; }
static void break_frequencies(bolan_sea_desc *d) { d->cosines.frequencies = 0; }
static void break_directions(bolan_sea_desc *d) { d->cosines.directions = 33; }
static void break_split(bolan_sea_desc *d) { d->cosines.split = (bolan_frequency_split)2; }
static void break_waves(bolan_sea_desc *d) { d->exp_cosine.wave_count = 17; }
static void break_sharpness(bolan_sea_desc *d) { d->exp_cosine.sharpness = NAN; }
static void break_loop(bolan_sea_desc *d) { d->loop_period = 9.0; }

static void every_model_refuses_every_bad_field(void **state) {
    (void)state;
    static const struct {
        const char *field;
        void (*apply)(bolan_sea_desc *desc);
    } broken[] = {{"fft.cascade_count", break_cascades},
                  {"textures.period", break_period},
                  {"textures.frames", break_frames},
                  {"cosines.frequencies", break_frequencies},
                  {"cosines.directions", break_directions},
                  {"cosines.split", break_split},
                  {"exp_cosine.wave_count", break_waves},
                  {"exp_cosine.sharpness", break_sharpness},
                  {"loop_period", break_loop}};
    for (int model = 0; model < MODELS; model++) {
        for (size_t i = 0; i < sizeof broken / sizeof *broken; i++) {
            heard h = {0};
            bolan_sea_desc desc = small(model);
            bolan_sea *sea = (bolan_sea *)&h;
            broken[i].apply(&desc);
            bolan_set_hooks(&(bolan_hooks){.user = &h, .log = hear});
            assert_int_equal(bolan_sea_create(&desc, &sea), BOLAN_ERROR_ARGUMENT);
            bolan_set_hooks(NULL);
            assert_null(sea);
            assert_int_equal(h.sentences, 1);
            assert_non_null(strstr(h.sentence, broken[i].field));
        }
    }
}

RUN_TESTS(cmocka_unit_test(every_model_has_its_name_and_form), cmocka_unit_test(samples_are_those_of_the_direct_sum),
          cmocka_unit_test(samples_lie_within_the_bounds_and_a_grid_takes_short_waves_away),
          cmocka_unit_test(the_foam_of_waves_that_a_grid_averages_away_stays),
          cmocka_unit_test(every_model_carries_the_energy_of_its_sea_state),
          cmocka_unit_test(slopes_are_removed_by_their_footprint),
          cmocka_unit_test(only_waves_that_move_sideways_are_lifted_and_foam),
          cmocka_unit_test(a_field_of_one_model_is_read_by_that_model_alone),
          cmocka_unit_test(every_model_repeats_after_its_period), cmocka_unit_test(every_model_refuses_every_bad_field))

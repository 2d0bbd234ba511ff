// SPDX-License-Identifier: MIT
// Creation, validation, layout and memory of a sea.
#include "sea_support.h"

#include "bolan/formats.h"
#include "waves/cascades/cascades.h"

#include <string.h>

typedef struct watcher {
    uint32_t allocations, sentences;
    int64_t budget; // allocations that succeed; negative: all
    bolan_log_id id;
    char sentence[256];
} watcher;

static void *count_allocation(void *user, size_t size, size_t align) {
    watcher *w = user;
    w->allocations++;
    if (w->budget >= 0 && w->allocations > w->budget) return NULL;
    return aligned_alloc(align, (size + align - 1) / align * align);
}

static void release(void *user, void *memory, size_t size) {
    (void)user;
    (void)size;
    free(memory);
}

static void keep_sentence(void *user, bolan_log_level level, bolan_log_id id, const char *sentence) {
    watcher *w = user;
    (void)level;
    w->sentences++;
    w->id = id;
    snprintf(w->sentence, sizeof w->sentence, "%s", sentence);
}

static void watch(watcher *w) {
    const bolan_hooks hooks = {.user = w, .allocate = count_allocation, .release = release, .log = keep_sentence};
    *w = (watcher){.budget = -1};
    bolan_set_hooks(&hooks);
}

static void refused(bolan_sea_desc desc, const char *field, bolan_log_id id) {
    watcher w;
    bolan_sea *sea = (bolan_sea *)&w;
    watch(&w);
    assert_int_equal(bolan_sea_create(&desc, &sea), BOLAN_ERROR_ARGUMENT);
    assert_null(sea);
    assert_int_equal(w.sentences, 1);
    assert_int_equal(w.id, id);
    assert_non_null(strstr(w.sentence, field));
    bolan_set_hooks(NULL);
}

#define REFUSED(field, value, id)                       \
    do {                                                \
        bolan_sea_desc desc = bolan_sea_desc_default(); \
        desc.field = value;                             \
        refused(desc, #field, id);                      \
    } while (0)

static void every_bad_field_is_named_in_one_sentence(void **state) {
    (void)state;
    REFUSED(resolution, 100, BOLAN_LOG_OUT_OF_RANGE);
    REFUSED(resolution, 16, BOLAN_LOG_OUT_OF_RANGE);
    REFUSED(resolution, 2048, BOLAN_LOG_OUT_OF_RANGE);
    REFUSED(fft.cascade_count, 0, BOLAN_LOG_OUT_OF_RANGE);
    REFUSED(fft.cascade_count, 5, BOLAN_LOG_OUT_OF_RANGE);
    REFUSED(length, 9.0, BOLAN_LOG_OUT_OF_RANGE);
    REFUSED(length, NAN, BOLAN_LOG_NOT_FINITE);
    REFUSED(choppiness, -0.1, BOLAN_LOG_OUT_OF_RANGE);
    REFUSED(choppiness, INFINITY, BOLAN_LOG_NOT_FINITE);
    REFUSED(loop_period, 5.0, BOLAN_LOG_OUT_OF_RANGE);
    REFUSED(foam_decay, 0.0, BOLAN_LOG_OUT_OF_RANGE);
    REFUSED(waves, (bolan_wave_model)7, BOLAN_LOG_BAD_ARGUMENT);
    REFUSED(cpu, (bolan_cpu)9, BOLAN_LOG_BAD_ARGUMENT);
    bolan_sea_desc desc = bolan_sea_desc_default();
    desc.sea_state.wind_speed = 100.0;
    refused(desc, "wind_speed", BOLAN_LOG_OUT_OF_RANGE);
}

static void stepping_allocates_nothing_and_all_memory_comes_back(void **state) {
    (void)state;
    watcher w;
    watch(&w);
    bolan_sea_desc desc = bolan_sea_desc_default();
    desc.resolution = 64;
    desc.foam_decay = 0.5;
    bolan_sea *sea = test_sea(desc);
    const uint32_t before = w.allocations;
    for (int i = 0; i < 10; i++) bolan_sea_step(sea, 0.1 * i);
    bolan_sea_settle(sea, 77.0);
    const bolan_dvec2 at = {1.0, 2.0};
    bolan_sea_sample sample;
    bolan_sea_sample_rest(sea, &at, 1, &sample);
    bolan_sea_measure(sea);
    char hash[17];
    bolan_sea_hash(sea, hash);
    assert_int_equal(strlen(hash), 16);
    assert_int_equal(w.allocations, before);
    bolan_sea_destroy(&sea);
    assert_null(sea);
    bolan_sea_destroy(&sea);
    assert_int_equal(bolan_memory_in_use(), 0);
    assert_int_equal(w.sentences, 0);
    bolan_set_hooks(NULL);
}

static void refused_memory_is_an_error_and_leaks_nothing(void **state) {
    (void)state;
    bolan_sea_desc desc = bolan_sea_desc_default();
    desc.resolution = 32;
    for (int64_t budget = 0; budget < 20; budget++) {
        watcher w;
        watch(&w);
        w.budget = budget;
        bolan_sea *sea = NULL;
        const bolan_result result = bolan_sea_create(&desc, &sea);
        if (result == BOLAN_OK) {
            bolan_sea_destroy(&sea);
        } else {
            assert_int_equal(result, BOLAN_ERROR_MEMORY);
            assert_int_equal(w.id, BOLAN_LOG_OUT_OF_MEMORY);
            assert_int_equal(w.sentences, 1);
        }
        assert_int_equal(bolan_memory_in_use(), 0);
        bolan_set_hooks(NULL);
    }
}

static void rings_are_disjoint_and_leave_no_gap(void **state) {
    (void)state;
    for (uint32_t n = 32; n <= 512; n *= 2) {
        bolan_sea_desc desc = bolan_sea_desc_default();
        desc.resolution = n;
        bolan_sea *sea = test_sea(desc);
        for (uint32_t i = 0; i < bolan_sea_cascade_count(sea); i++) {
            const bolan_cascade_view v = bolan_sea_cascade(sea, i);
            assert_true(v.k_max <= BOLAN_PI * n / v.length);
            assert_true(v.k_min == (i > 0 ? bolan_sea_cascade(sea, i - 1).k_max : 0.0));
            if (i > 0 && n >= 128) assert_true(v.k_min >= 6.0 * 2.0 * BOLAN_PI / v.length);
        }
        bolan_sea_destroy(&sea);
    }
}

static void the_first_tile_holds_sixteen_peak_waves_and_twelve_of_a_swell(void **state) {
    (void)state;
    bolan_sea_desc desc = bolan_sea_desc_default();
    desc.resolution = 32;
    bolan_sea *sea = test_sea(desc);
    const double tp = bolan_sea_state_summary(&desc.sea_state).tp, peak = 9.81 * tp * tp / (2.0 * BOLAN_PI);
    assert_true(bolan_sea_get_desc(sea)->length >= 15.9 * peak && bolan_sea_get_desc(sea)->length <= 20.0 * peak);
    bolan_sea_destroy(&sea);
    assert_int_equal(bolan_sea_state_add_swell(&desc.sea_state, 0.8, 15.0, 10.0, 40.0), BOLAN_OK);
    sea = test_sea(desc);
    assert_true(bolan_sea_get_desc(sea)->length >= 12.0 * 9.81 * 15.0 * 15.0 / (2.0 * BOLAN_PI));
    bolan_sea_destroy(&sea);
}

// Length and angle of the first tile go in steps, so that a sea that has grown a little, or veered, has the same waves.
static void seas_of_nearly_one_state_have_the_same_tiles(void **state) {
    (void)state;
    bolan_cascade_view v[3];
    for (int i = 0; i < 3; i++) {
        bolan_sea_desc desc = bolan_sea_desc_default();
        const double from = i == 1 ? 243.0 : i == 2 ? 262.5 : 240.0;
        desc.sea_state = bolan_sea_state_from_wind(i == 1 ? 10.05 : 10.0, from, 300e3);
        desc.resolution = 32;
        bolan_sea *sea = test_sea(desc);
        v[i] = bolan_sea_cascade(sea, 0);
        bolan_sea_destroy(&sea);
    }
    const double steps = 4.0 * log2(v[0].length);
    assert_near(steps, floor(steps + 0.5), 1e-9);
    assert_true(v[1].length == v[0].length && v[1].angle == v[0].angle);
    assert_near(v[2].angle, v[0].angle - bolan_radians(22.5), 1e-12); // clockwise
}

// The phases of the waves of a tile with lattice indices up to PHASES, as unit numbers; 0 where the ring has no wave.
enum { PHASES = 45 };
typedef struct phases {
    const sea_cascade *cascade;
    double forth[PHASES][PHASES][2], back[PHASES][PHASES][2];
} phases;

static void keep_phase(void *context, const sea_mode *m) {
    phases *p = context;
    const sea_cascade *c = p->cascade;
    const double scale = c->length / (2.0 * BOLAN_PI);
    const int i = (int)floor((m->kx * c->cosine + m->ky * c->sine) * scale + 0.5);
    const int j = (int)floor((m->ky * c->cosine - m->kx * c->sine) * scale + 0.5);
    const double forth = hypot(m->re, m->im), back = hypot(m->back_re, m->back_im);
    if (i <= 0 || i >= PHASES || j <= 0 || j >= PHASES || !(forth > 0.0 && back > 0.0)) return;
    p->forth[j][i][0] = m->re / forth, p->forth[j][i][1] = m->im / forth;
    p->back[j][i][0] = m->back_re / back, p->back[j][i][1] = -m->back_im / back; // of h0(-k) itself
}

// |mean of e^{i (p - q)}| over the indices that both have, times the root of their number: 1 where phases are random.
static double likeness(double p[PHASES][PHASES][2], double q[PHASES][PHASES][2]) {
    double re = 0.0, im = 0.0, count = 0.0;
    for (int j = 0; j < PHASES; j++)
        for (int i = 0; i < PHASES; i++) {
            re += p[j][i][0] * q[j][i][0] + p[j][i][1] * q[j][i][1];
            im += p[j][i][1] * q[j][i][0] - p[j][i][0] * q[j][i][1];
            count += (p[j][i][0] != 0.0 || p[j][i][1] != 0.0) && (q[j][i][0] != 0.0 || q[j][i][1] != 0.0);
        }
    assert_true(count > 200.0);
    return hypot(re, im) / sqrt(count);
}

static void no_two_waves_share_their_phases(void **state) {
    (void)state;
    static phases tile[3];
    memset(tile, 0, sizeof tile);
    bolan_sea_desc desc = bolan_sea_desc_default();
    desc.sea_state = bolan_sea_state_from_wind(10.0, 240.0, 300e3);
    desc.resolution = 128;
    for (int s = 0; s < 2; s++) {
        desc.seed = (uint64_t)s + 1;
        bolan_sea *sea = test_sea(desc);
        const cascade_tables *t = cascade_tables_of(sea->shared);
        for (int c = 0; c < (s == 0 ? 2 : 1); c++) {
            tile[2 * s + c].cascade = &t->cascade[c];
            bolan_sea_each_mode(&t->cascade[c], keep_phase, &tile[2 * s + c]);
        }
        bolan_sea_destroy(&sea);
    }
    assert_true(likeness(tile[0].forth, tile[1].forth) < 4.0); // of two tiles
    assert_true(likeness(tile[0].back, tile[1].back) < 4.0);
    assert_true(likeness(tile[0].forth, tile[2].forth) < 4.0); // of two seeds
    for (int c = 0; c < 2; c++) assert_true(likeness(tile[c].forth, tile[c].back) < 4.0); // of opposite waves
}

// Modes of the first tile with two waves, and those in which two waves have one frequency.
static void count_waves(double loop_period, uint32_t *several, uint32_t *equal) {
    enum { SIDE = 64 };
    static bolan_sea_mode wave[BOLAN_MODE_PARTS][SIDE];
    bolan_sea_desc desc = bolan_sea_desc_default();
    desc.sea_state = bolan_sea_state_from_wind(10.0, 240.0, 300e3);
    desc.resolution = SIDE;
    desc.loop_period = loop_period;
    bolan_sea *sea = test_sea(desc);
    *several = *equal = 0;
    for (uint32_t j = 0; j < BOLAN_MODE_PART_REACH && j < bolan_sea_mode_rows(sea, 0); j++) {
        for (uint32_t part = 0; part < BOLAN_MODE_PARTS; part++) bolan_sea_modes(sea, 0, part, j, wave[part]);
        for (uint32_t i = 0; i < SIDE; i++) {
            *several += wave[1][i].turns > 0.0;
            for (uint32_t part = 1; part < BOLAN_MODE_PARTS; part++)
                *equal += wave[part][i].turns > 0.0 && wave[part][i].turns == wave[part - 1][i].turns;
        }
    }
    bolan_sea_destroy(&sea);
}

// Two waves of one wave vector and one frequency would hold more energy than both, or less, forever.
static void slices_that_a_loop_gives_one_frequency_are_one_wave(void **state) {
    (void)state;
    uint32_t several, equal;
    count_waves(0.0, &several, &equal);
    assert_true(several > 100 && equal == 0);
    count_waves(20.0, &several, &equal);
    assert_int_equal(equal, 0);
}

static void the_last_tile_reaches_a_few_centimetres(void **state) {
    (void)state;
    const double winds[] = {5.0, 10.0, 15.0};
    for (int w = 0; w < 3; w++) {
        bolan_sea_desc desc = bolan_sea_desc_default();
        desc.sea_state = bolan_sea_state_from_wind(winds[w], 0.0, 200e3);
        bolan_sea *sea = test_sea(desc);
        const double shortest = 2.0 * BOLAN_PI / bolan_sea_cascade(sea, 3).k_max;
        assert_true(shortest > 0.01 && shortest < 0.08); // four rings of 10 modes to half of Nyquist span 1 : 15 000
        bolan_sea_destroy(&sea);
    }
}

static void more_threads_after_creation_do_no_harm(void **state) {
    (void)state;
    bolan_sea_desc desc = bolan_sea_desc_default();
    desc.resolution = 64;
    bolan_sea *sea = test_sea(desc);
    char one[17], other[17];
    bolan_sea_step(sea, 4.0);
    bolan_sea_hash(sea, one);
    bolan_set_threads(4);
    bolan_sea_step(sea, 4.5);
    bolan_sea_step(sea, 4.0);
    bolan_sea_hash(sea, other);
    bolan_set_threads(1);
    assert_string_equal(one, other);
    bolan_sea_destroy(&sea);
}

// Every default that waves.h and spectrum.h name.
static void defaults_are_those_of_the_headers(void **state) {
    (void)state;
    const bolan_sea_desc d = bolan_sea_desc_default();
    assert_int_equal(d.waves, BOLAN_WAVES_FFT);
    assert_true(d.seed == 1 && d.resolution == 256 && d.fft.cascade_count == 4);
    assert_true(d.length == 0.0 && d.choppiness == 1.0 && d.loop_period == 0.0 && d.foam_decay == 9.0);
    assert_int_equal(d.cpu, BOLAN_CPU_AUTO);
    assert_true(d.sea_state.current_x == 0.0 && d.sea_state.current_y == 0.0);
    assert_true(d.cosines.frequencies == 16 && d.cosines.directions == 8 && d.exp_cosine.wave_count == 8);
    assert_true(d.textures.period == 0.0 && d.textures.frames == 32);
    assert_int_equal(d.cosines.split, BOLAN_SPLIT_EQUAL_ENERGY);
    assert_true(d.exp_cosine.sharpness == 0.5);
    const bolan_sea_state *s = &d.sea_state;
    assert_true(s->system_count == 1 && s->wind_speed == 8.0 && s->wind_from_deg == 240.0);
    assert_true(s->depth == BOLAN_DEEP && s->measured == NULL);
    const bolan_sea_state of_fetch = bolan_sea_state_from_wind(8.0, 240.0, 200e3);
    assert_true(s->systems[0].hs == of_fetch.systems[0].hs &&
                s->systems[0].peak_omega == of_fetch.systems[0].peak_omega);
    const bolan_wave_system young = bolan_sea_state_from_wind(10.0, 10.0, 50e3).systems[0];
    assert_int_equal(young.kind, BOLAN_SPECTRUM_JONSWAP);
    assert_int_equal(young.spreading, BOLAN_SPREADING_HASSELMANN);
    assert_true(young.gamma == 3.3 && young.spread_s == 10.0 && young.swell == 0.0);
    assert_true(young.wind_speed == 10.0 && young.from_deg == 10.0);
    const bolan_sea_state calm = bolan_sea_state_default();
    assert_true(calm.system_count == 0 && calm.depth == BOLAN_DEEP && calm.wind_speed == 0.0 && calm.measured == NULL);
    bolan_sea_state with_swell = bolan_sea_state_default();
    assert_int_equal(bolan_sea_state_add_swell(&with_swell, 2.0, 12.5, 300.0, 40.0), BOLAN_OK);
    const bolan_wave_system *w = &with_swell.systems[0];
    assert_int_equal(w->kind, BOLAN_SPECTRUM_JONSWAP);
    assert_int_equal(w->spreading, BOLAN_SPREADING_COS2S);
    assert_true(w->hs == 2.0 && w->gamma == 5.0 && w->spread_s == 40.0 && w->from_deg == 300.0 && w->wind_speed == 0.0);
    assert_near(2.0 * BOLAN_PI / w->peak_omega, 12.5, 1e-12);
    const bolan_spectrum_texts texts = bolan_spectrum_texts_default();
    assert_true(texts.density.data == NULL && texts.swdir.data == NULL);
    const bolan_spectrum_options options = bolan_spectrum_options_default();
    assert_true(isnan(options.from_deg) && isnan(options.spread_s) && options.record == 0);
}

// Beyond 10 peak wave numbers the slopes add up to (B - M1)(1 - keep), B being what was measured at that wind: so the
// sum never exceeds B, and what is kept at the end says how near it comes.
static void short_waves_add_up_to_the_measured_slopes(void **state) {
    (void)state;
    static sea_radial r;
    const bolan_sea_state sea_state = bolan_sea_state_from_wind(8.0, 250.0, 300e3);
    const spectrum_eval eval = bolan_spectrum_eval_prepare(&sea_state);
    const double peak = bolan_k_from_omega(sea_state.systems[0].peak_omega, BOLAN_DEEP);
    double up, cross, long_waves = 0.0, kept = 0.0;
    bolan_cox_munk(8.0, &up, &cross);
    bolan_sea_radial_prepare(&eval, 10.0 * peak, up + cross, &r);
    for (int i = 1; i < RADIAL_COUNT; i++) {
        const double slopes = r.mss[i] - r.mss[i - 1];
        if (r.k[i] <= 10.0 * peak)
            long_waves += slopes;
        else
            kept += 0.5 * (r.keep[i] + r.keep[i - 1]) * slopes;
    }
    assert_true(long_waves > 0.0 && long_waves < up + cross);
    assert_near(kept, (up + cross - long_waves) * (1.0 - r.keep[RADIAL_COUNT - 1]), 0.02 * (up + cross));
    assert_true(r.keep[RADIAL_COUNT - 1] < 0.6);
}

RUN_TESTS(cmocka_unit_test(defaults_are_those_of_the_headers),
          cmocka_unit_test(every_bad_field_is_named_in_one_sentence),
          cmocka_unit_test(stepping_allocates_nothing_and_all_memory_comes_back),
          cmocka_unit_test(refused_memory_is_an_error_and_leaks_nothing),
          cmocka_unit_test(rings_are_disjoint_and_leave_no_gap),
          cmocka_unit_test(the_first_tile_holds_sixteen_peak_waves_and_twelve_of_a_swell),
          cmocka_unit_test(seas_of_nearly_one_state_have_the_same_tiles),
          cmocka_unit_test(no_two_waves_share_their_phases),
          cmocka_unit_test(slices_that_a_loop_gives_one_frequency_are_one_wave),
          cmocka_unit_test(the_last_tile_reaches_a_few_centimetres),
          cmocka_unit_test(short_waves_add_up_to_the_measured_slopes),
          cmocka_unit_test(more_threads_after_creation_do_no_harm))

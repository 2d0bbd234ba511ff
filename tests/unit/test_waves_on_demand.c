// SPDX-License-Identifier: MIT
// Fields that are made when they are read: when that is, that it does not matter, and what a synthesis of one's own
// gets instead.
#include "bolan/query.h"
#include "sea_support.h"

#include <complex.h>
#include <pthread.h>
#include <string.h>

static bolan_sea_desc small(bolan_wave_model waves) {
    bolan_sea_desc desc = bolan_sea_desc_default();
    desc.waves = waves;
    desc.resolution = 64;
    desc.foam_decay = 0.85; // a memory of 17 ticks
    return desc;
}

// ---- when -----------------------------------------------------------------------------------------------------------

static uint32_t loops; // that the task hook was asked for

static void count_loop(void *user, uint32_t count, uint32_t grain, bolan_task_fn *task, void *context) {
    (void)user;
    (void)grain;
    loops++;
    task(context, 0, count, 0);
}

static void a_step_makes_nothing_and_the_first_question_all(void **state) {
    (void)state;
    const bolan_hooks hooks = {.parallel = count_loop, .parallel_workers = 1};
    bolan_set_hooks(&hooks);
    bolan_sea *sea = test_sea(small(BOLAN_WAVES_FFT));
    bolan_water water = bolan_water_default();
    water.sea = sea;
    const bolan_dvec2 place = {3.0, 4.0};
    float first, second, later;
    loops = 0;
    for (int i = 0; i < 100; i++) bolan_sea_step(sea, 0.1 * i);
    const uint64_t serial = bolan_sea_serial(sea);
    (void)bolan_sea_cascade_layout(sea, 0);
    (void)bolan_sea_get_clock(sea);
    assert_int_equal(loops, 0);
    bolan_query_heights(&water, &place, 1, &first);
    assert_true(loops > 0);
    assert_true(bolan_sea_serial(sea) == serial);
    loops = 0;
    bolan_query_heights(&water, &place, 1, &second);
    (void)bolan_sea_cascade(sea, 0);
    assert_int_equal(loops, 0);
    assert_true(first == second);
    bolan_sea_step(sea, 9.95);
    bolan_query_heights(&water, &place, 1, &later);
    assert_int_equal(loops, 1); // no tick since 9.9 s: the fields alone
    assert_true(later != first);
    bolan_sea_step(sea, 10.0);
    bolan_query_heights(&water, &place, 1, &later);
    assert_int_equal(loops, 3); // a tick, and the fields
    bolan_sea_destroy(&sea);
    bolan_set_hooks(NULL);
}

// ---- the same bits --------------------------------------------------------------------------------------------------

static void assert_equal_seas(const bolan_sea *a, const bolan_sea *b) {
    for (uint32_t c = 0; c < bolan_sea_cascade_count(a); c++) {
        const bolan_cascade_view v = bolan_sea_cascade(a, c), w = bolan_sea_cascade(b, c);
        const size_t bytes = (size_t)v.n * v.n * sizeof(float);
        assert_memory_equal(v.displacement, w.displacement, (size_t)v.n * v.pitch * sizeof *v.displacement);
        assert_memory_equal(v.slope_x, w.slope_x, bytes);
        assert_memory_equal(v.foam, w.foam, bytes);
        assert_memory_equal(v.foam_half, w.foam_half, bytes / 2);
    }
}

static void check_settled(const bolan_sea *sea, bolan_wave_model waves, double time) {
    bolan_sea *fresh = test_sea(small(waves));
    bolan_sea_settle(fresh, time);
    assert_equal_seas(sea, fresh);
    bolan_sea_destroy(&fresh);
}

// One sea is read at every step, the other after `every` of them; both jump and settle on the way.
static void run_both(bolan_wave_model waves, int every) {
    bolan_sea *eager = test_sea(small(waves)), *lazy = test_sea(small(waves));
    double time = 0.0;
    for (int i = 0; i < 120; i++) {
        time += i == 50 ? 7.0 : i == 85 ? -3.5 : 0.13;
        if (i == 90) {
            bolan_sea_settle(eager, time);
            bolan_sea_settle(lazy, time);
            check_settled(eager, waves, time); // which has remembered but half a second so far
        }
        bolan_sea_step(eager, time);
        bolan_sea_step(lazy, time);
        bolan_sea_fields(eager);
        if (i % every == 0) assert_equal_seas(eager, lazy);
    }
    assert_equal_seas(eager, lazy);
    bolan_sea_destroy(&eager);
    bolan_sea_destroy(&lazy);
}

static void it_does_not_matter_how_often_a_sea_is_read(void **state) {
    (void)state;
    run_both(BOLAN_WAVES_FFT, 1);
    run_both(BOLAN_WAVES_FFT, 7);
    run_both(BOLAN_WAVES_FFT, 1000);
    run_both(BOLAN_WAVES_TEXTURES, 11);
}

static void *read_hash(void *argument) {
    void **pair = argument;
    bolan_sea_hash(pair[0], pair[1]);
    return NULL;
}

static void many_threads_may_read_first(void **state) {
    (void)state;
    enum { READERS = 8 };
    bolan_sea *sea = test_sea(small(BOLAN_WAVES_FFT)), *alone = test_sea(small(BOLAN_WAVES_FFT));
    for (int round = 0; round < 20; round++) {
        pthread_t thread[READERS];
        char hash[READERS][17], want[17];
        void *pair[READERS][2];
        bolan_sea_step(sea, 0.7 * round);
        for (int i = 0; i < READERS; i++) {
            pair[i][0] = sea;
            pair[i][1] = hash[i];
            assert_int_equal(pthread_create(&thread[i], NULL, read_hash, pair[i]), 0);
        }
        for (int i = 0; i < READERS; i++) pthread_join(thread[i], NULL);
        bolan_sea_step(alone, 0.7 * round);
        bolan_sea_hash(alone, want);
        for (int i = 0; i < READERS; i++) assert_string_equal(hash[i], want);
    }
    bolan_sea_destroy(&sea);
    bolan_sea_destroy(&alone);
}

// ---- for a synthesis of one's own -----------------------------------------------------------------------------------

// Coefficient of the height plane of a cascade at sample (x, y), by the modes and the clock alone.
static double height_by_modes(const bolan_sea *sea, uint32_t cascade, uint32_t x, uint32_t y) {
    const uint32_t n = bolan_sea_cascade_layout(sea, cascade).n;
    const double t = bolan_sea_get_clock(sea).shown;
    bolan_sea_mode row[64];
    double sum = 0.0;
    const uint32_t rows = bolan_sea_mode_rows(sea, cascade);
    for (uint32_t wave = 0; wave < BOLAN_MODE_PARTS * rows; wave++) {
        const uint32_t part = wave / rows, j = wave % rows;
        bolan_sea_modes(sea, cascade, part, j, row);
        for (uint32_t i = 0; i < n; i++) {
            const bolan_sea_mode *m = &row[i];
            const double turn = 2.0 * BOLAN_PI * fmod(m->turns * t, 1.0), c = cos(turn), s = sin(turn);
            const double complex h = CMPLX(m->a[0] * c + m->a[1] * s, m->a[2] * c + m->a[3] * s) * m->cubic;
            const double phase = 2.0 * BOLAN_PI * ((double)i * x + (double)j * y) / n;
            sum += (j > 0 ? 2.0 : 1.0) * creal(h * CMPLX(cos(phase), sin(phase)));
        }
    }
    return sum;
}

// So that the 4 x 4 texels of a spline need not wrap.
static void the_first_texels_follow_the_last(void **state) {
    (void)state;
    bolan_sea *sea = test_sea(small(BOLAN_WAVES_FFT));
    bolan_sea_step(sea, 3.3);
    for (uint32_t c = 0; c < bolan_sea_cascade_count(sea); c++) {
        const bolan_cascade_view v = bolan_sea_cascade(sea, c);
        assert_int_equal(v.pitch, v.n + BOLAN_CASCADE_GUARD);
        for (uint32_t j = 0; j < v.pitch; j++)
            for (uint32_t i = 0; i < v.pitch; i++)
                assert_memory_equal(&v.displacement[(size_t)j * v.pitch + i],
                                    &v.displacement[(size_t)(j % v.n) * v.pitch + i % v.n], sizeof *v.displacement);
        assert_memory_not_equal(v.displacement, v.displacement + BOLAN_CASCADE_GUARD, sizeof *v.displacement);
    }
    bolan_sea_destroy(&sea);
}

static void modes_and_clock_make_the_planes(void **state) {
    (void)state;
    bolan_sea *sea = test_sea(small(BOLAN_WAVES_FFT));
    for (int t = 0; t < 2; t++) {
        bolan_sea_step(sea, t == 0 ? 3.3 : 1e6 + 0.7);
        for (uint32_t c = 0; c < bolan_sea_cascade_count(sea); c++) {
            const bolan_cascade_view v = bolan_sea_cascade(sea, c);
            for (uint32_t p = 5; p < 64 * 64; p += 1301)
                assert_near(v.displacement[p / 64 * v.pitch + p % 64].height, height_by_modes(sea, c, p % 64, p / 64),
                            1e-5 * (1.0 + 4.0 * sqrt(v.variance)));
        }
    }
    bolan_sea_destroy(&sea);
}

// The foam at a sample is the largest of what the ticks from first_tick on have left, and of the present pinch.
static void the_clock_tells_what_foam_remembers(void **state) {
    (void)state;
    bolan_sea_desc desc = small(BOLAN_WAVES_FFT);
    desc.sea_state = bolan_sea_state_from_wind(14.0, 250.0, 200e3);
    bolan_sea *sea = test_sea(desc), *at = test_sea(desc);
    bolan_sea_settle(sea, 41.3);
    const bolan_sea_clock clock = bolan_sea_get_clock(sea);
    const bolan_cascade_view v = bolan_sea_cascade(sea, 1);
    enum { SAMPLES = 40 };
    float memory[SAMPLES] = {0};
    for (double tick = clock.first_tick + 1.0; tick <= clock.tick; tick += 1.0) {
        bolan_sea_step(at, bolan_sea_tick_time(sea, tick));
        const bolan_cascade_view w = bolan_sea_cascade(at, 1);
        for (int s = 0; s < SAMPLES; s++) {
            const float pinch = -(w.dxx[s * 97] + w.dyy[s * 97]) * (float)desc.choppiness;
            memory[s] = fmaxf(memory[s] * clock.tick_keep - clock.tick_lose, fminf(fmaxf(pinch, 0.0f), 3.0f));
        }
    }
    float highest = 0.0f;
    for (int s = 0; s < SAMPLES; s++) {
        const float pinch = -(v.dxx[s * 97] + v.dyy[s * 97]) * (float)desc.choppiness;
        const float foam = fmaxf(memory[s] * clock.keep - clock.lose, fminf(fmaxf(pinch, 0.0f), 3.0f));
        assert_near(v.foam[s * 97], foam, 1e-6);
        highest = fmaxf(highest, foam - fmaxf(pinch, 0.0f));
    }
    assert_true(highest > 0.02f); // some of it is remembered
    bolan_sea_destroy(&sea);
    bolan_sea_destroy(&at);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_step_makes_nothing_and_the_first_question_all),
        cmocka_unit_test(it_does_not_matter_how_often_a_sea_is_read),
        cmocka_unit_test(many_threads_may_read_first),
        cmocka_unit_test(the_first_texels_follow_the_last),
        cmocka_unit_test(modes_and_clock_make_the_planes),
        cmocka_unit_test(the_clock_tells_what_foam_remembers),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

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

// What a place of a tile [samples] is pinched by at the time of a tick, by the modes alone.
static double pinch_by_modes(const bolan_sea *sea, uint32_t cascade, double time, double x, double y) {
    const bolan_cascade_view v = bolan_sea_cascade_layout(sea, cascade);
    const uint32_t rows = bolan_sea_mode_rows(sea, cascade);
    bolan_sea_mode row[64];
    double sum = 0.0;
    for (uint32_t wave = 0; wave < BOLAN_MODE_PARTS * rows; wave++) {
        const uint32_t part = wave / rows, j = wave % rows;
        bolan_sea_modes(sea, cascade, part, j, row);
        for (uint32_t i = 0; i < v.n; i++) {
            const bolan_sea_mode *m = &row[i];
            if (!(m->turns > 0.0)) continue;
            const double across = i < v.n / 2 ? (double)i : (double)i - v.n,
                         k = 2.0 * BOLAN_PI / v.length * hypot(across, j);
            const double turn = 2.0 * BOLAN_PI * fmod(m->turns * time, 1.0), c = cos(turn), s = sin(turn);
            const double complex h = CMPLX(m->a[0] * c + m->a[1] * s, m->a[2] * c + m->a[3] * s);
            const double phase = 2.0 * BOLAN_PI * (across * x + (double)j * y) / v.n;
            sum += (j > 0 ? 2.0 : 1.0) * creal(h * CMPLX(cos(phase), sin(phase))) * k * k * m->inverse_k * m->linear;
        }
    }
    return fmin(fmax(sum * bolan_sea_get_desc(sea)->choppiness, 0.0), 3.0);
}

// Drift of the foam by a tick [samples].
static bolan_dvec2 drift_of(const bolan_sea *sea, uint32_t cascade, double tick) {
    const double n = bolan_sea_cascade_layout(sea, cascade).n;
    uint32_t drift[2];
    bolan_sea_foam_drift(sea, cascade, tick, drift);
    return (bolan_dvec2){drift[0] * 0x1p-32 * n, drift[1] * 0x1p-32 * n};
}

// What a sample of the memory holds at the clock's tick.
static double memory_of(const bolan_sea *sea, const bolan_sea_clock *clock, uint32_t cascade, double x, double y) {
    double memory = 0.0;
    for (double tick = clock->first_tick + 1.0; tick <= clock->tick; tick += 1.0) {
        const bolan_dvec2 d = drift_of(sea, cascade, tick);
        const double pinch = pinch_by_modes(sea, cascade, bolan_sea_tick_time(sea, tick), x + d.x, y + d.y);
        memory = fmax(memory * (double)clock->tick_keep - (double)clock->tick_lose, pinch);
    }
    return memory;
}

// The foam at a sample is the largest of what the ticks from first_tick on have left where it drifted from, and of the
// present pinch.
static void the_clock_tells_what_foam_remembers(void **state) {
    (void)state;
    enum { CASCADE = 1, SAMPLES = 12 };
    bolan_sea_desc desc = small(BOLAN_WAVES_FFT);
    desc.sea_state = bolan_sea_state_from_wind(14.0, 250.0, 200e3);
    bolan_sea *sea = test_sea(desc);
    bolan_sea_settle(sea, 41.3);
    const bolan_sea_clock clock = bolan_sea_get_clock(sea);
    const bolan_cascade_view v = bolan_sea_cascade(sea, CASCADE);
    const bolan_dvec2 now = drift_of(sea, CASCADE, clock.now);
    uint32_t count = 0;
    for (uint32_t at = 0; at < v.n * v.n && count < SAMPLES; at += 7) {
        if (v.foam[at] < 0.02f - (v.dxx[at] + v.dyy[at]) * (float)desc.choppiness) continue; // it is not remembered
        const double x = at % v.n - now.x, y = at / v.n - now.y, left = floor(x), low = floor(y);
        double memory = 0.0;
        for (int corner = 0; corner < 4; corner++) {
            const double dx = corner & 1, dy = corner / 2;
            memory += (1.0 - fabs(x - left - dx)) * (1.0 - fabs(y - low - dy)) *
                      memory_of(sea, &clock, CASCADE, left + dx, low + dy);
        }
        const double pinch = pinch_by_modes(sea, CASCADE, clock.shown, at % v.n, at / v.n);
        assert_near(v.foam[at], fmax(memory * (double)clock.keep - (double)clock.lose, pinch), 3e-6); // floats
        count++;
    }
    assert_int_equal(count, SAMPLES);
    bolan_sea_destroy(&sea);
}

// 3.1 % of 14 m/s (Wu 1983), from the west by south: in 4 ticks, which are a second, 0.408 m east and 0.148 m north.
static void foam_drifts_at_the_speed_of_the_surface(void **state) {
    (void)state;
    bolan_sea_desc desc = small(BOLAN_WAVES_FFT);
    desc.sea_state = bolan_sea_state_from_wind(14.0, 250.0, 200e3);
    bolan_sea *sea = test_sea(desc);
    for (uint32_t c = 0; c < bolan_sea_cascade_count(sea); c++) {
        const bolan_cascade_view v = bolan_sea_cascade_layout(sea, c);
        uint32_t from[2], to[2];
        bolan_sea_foam_drift(sea, c, 1e6, from);
        bolan_sea_foam_drift(sea, c, 1e6 + 4.0, to);
        const double u = (int32_t)(to[0] - from[0]) * 0x1p-32 * v.length,
                     w = (int32_t)(to[1] - from[1]) * 0x1p-32 * v.length;
        assert_near(u * cos(v.angle) - w * sin(v.angle), 0.031 * 14.0 * 0.93969, 1e-4);
        assert_near(u * sin(v.angle) + w * cos(v.angle), 0.031 * 14.0 * 0.34202, 1e-4);
    }
    bolan_sea_destroy(&sea);
}

// A plane of a cascade `shift` metres down the wind of the test, 70 degrees, at a sample, read linearly.
static double downwind(const bolan_cascade_view *v, const float *plane, uint32_t sample, double shift) {
    const double c = cos(v->angle), s = sin(v->angle), east = 0.93969 * shift, north = 0.34202 * shift, n = v->n;
    const double x = sample % v->n + n + (c * east + s * north) / v->length * n;
    const double y = sample / v->n + n + (c * north - s * east) / v->length * n;
    const uint32_t x0 = (uint32_t)x, y0 = (uint32_t)y;
    double sum = 0.0;
    for (uint32_t k = 0; k < 4; k++) {
        const uint32_t i = x0 + k % 2, j = y0 + k / 2;
        sum += (double)plane[j % v->n * v->n + i % v->n] * (1.0 - fabs(x - i)) * (1.0 - fabs(y - j));
    }
    return sum;
}

// The shift down the wind of `to` against `from` that leaves the least mean difference [m]. Where new foam came, any
// difference counts as 0.02.
static double best_shift(const bolan_cascade_view *v, const float *from, const float *to, double most) {
    double best = 0.0, least = 1e9;
    for (double shift = -most; shift <= most; shift += most / 30.0) {
        double sum = 0.0;
        for (uint32_t i = 0; i < v->n * v->n; i++)
            if (from[i] > 0.1f) sum += fmin(fabs(downwind(v, to, i, shift) - (double)from[i]), 0.02);
        if (sum < least) least = sum, best = shift;
    }
    return best;
}

// Foam that lasts goes 2 s with the surface, 0.868 m.
static void the_memory_of_foam_goes_with_the_wind(void **state) {
    (void)state;
    enum { SAMPLES = 64 * 64 };
    static float before[SAMPLES];
    bolan_sea_desc desc = small(BOLAN_WAVES_FFT);
    desc.sea_state = bolan_sea_state_from_wind(14.0, 250.0, 200e3);
    desc.foam_decay = 60.0;
    bolan_sea *sea = test_sea(desc);
    const uint32_t cascade = bolan_sea_cascade_count(sea) - 1;
    bolan_sea_settle(sea, 40.0);
    const bolan_cascade_view v = bolan_sea_cascade(sea, cascade);
    memcpy(before, v.foam, sizeof before);
    bolan_sea_step(sea, 41.0);
    bolan_sea_step(sea, 42.0);
    const double gone = best_shift(&v, before, bolan_sea_cascade(sea, cascade).foam, 3.0);
    print_message("samples of %.2f m: foam has gone %.2f m\n", v.length / v.n, gone);
    assert_near(gone, 0.031 * 14.0 * 2.0, 0.15); // half of a step of the search, and what the decay shifts
    bolan_sea_destroy(&sea);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_step_makes_nothing_and_the_first_question_all),
        cmocka_unit_test(it_does_not_matter_how_often_a_sea_is_read),
        cmocka_unit_test(many_threads_may_read_first),
        cmocka_unit_test(the_first_texels_follow_the_last),
        cmocka_unit_test(modes_and_clock_make_the_planes),
        cmocka_unit_test(the_clock_tells_what_foam_remembers),
        cmocka_unit_test(foam_drifts_at_the_speed_of_the_surface),
        cmocka_unit_test(the_memory_of_foam_goes_with_the_wind),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

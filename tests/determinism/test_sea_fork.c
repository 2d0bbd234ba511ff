// SPDX-License-Identifier: MIT
// Forks of a sea, and the numbers by which a sea and its fields are told apart.
#include "sea_support.h"

#include <pthread.h>
#include <string.h>

enum { MODELS = BOLAN_WAVE_MODELS };

static bolan_sea_desc desc_of(int model) {
    bolan_sea_desc desc = bolan_sea_desc_default();
    desc.waves = (bolan_wave_model)model;
    desc.sea_state = bolan_sea_state_from_wind(14.0, 250.0, 100e3); // whitecaps
    desc.resolution = 64;
    desc.fft.cascade_count = 3;
    desc.foam_decay = 0.5;
    desc.cosines.frequencies = desc.cosines.directions = 5;
    return desc;
}

static bolan_sea *fork_of(const bolan_sea *sea) {
    bolan_sea *fork = NULL;
    assert_int_equal(bolan_sea_fork(sea, &fork), BOLAN_OK);
    assert_non_null(fork);
    return fork;
}

// Equal in every bit: fields, foam memory, halfs, samples, and what is constant.
static void assert_same(const bolan_sea *a, const bolan_sea *b) {
    char one[17], other[17];
    bolan_sea_hash(a, one);
    bolan_sea_hash(b, other);
    assert_string_equal(one, other);
    assert_int_equal(bolan_sea_cascade_count(a), bolan_sea_cascade_count(b));
    for (uint32_t i = 0; i < bolan_sea_cascade_count(a); i++) {
        const bolan_cascade_view v = bolan_sea_cascade(a, i), w = bolan_sea_cascade(b, i);
        const size_t samples = (size_t)v.n * v.n;
        assert_int_equal(v.n, w.n);
        assert_true(v.displacement != w.displacement && v.foam != w.foam);
        assert_memory_equal(v.foam, w.foam, samples * sizeof(float));
        assert_memory_equal(v.displacement_half, w.displacement_half, samples * 4 * sizeof(uint16_t));
        assert_memory_equal(v.slope_half, w.slope_half, samples * 4 * sizeof(uint16_t));
        assert_memory_equal(v.foam_half, w.foam_half, samples * sizeof(uint16_t));
    }
    bolan_dvec2 at[100];
    bolan_sea_sample s[2][100];
    for (int i = 0; i < 100; i++) at[i] = (bolan_dvec2){13.1 * i, -7.7 * i};
    bolan_sea_sample_rest(a, at, 100, s[0]);
    bolan_sea_sample_rest(b, at, 100, s[1]);
    assert_memory_equal(s[0], s[1], sizeof s[0]);
}

static void a_fork_shows_the_same_waves_at_a_time_of_its_own(void **state) {
    (void)state;
    for (int model = 0; model < MODELS; model++) {
        bolan_sea *sea = test_sea(desc_of(model));
        bolan_sea_settle(sea, 12.5);
        char before[17], after[17];
        bolan_sea_hash(sea, before);
        bolan_sea *fork = fork_of(sea);
        assert_near(bolan_sea_time(fork), 0.0, 0.0);
        bolan_sea *fresh = test_sea(desc_of(model)); // stands at time 0, too
        assert_same(fork, fresh);
        bolan_sea_step(fork, 40.0);
        bolan_sea_hash(sea, after);
        assert_string_equal(before, after); // the origin stays where it was
        assert_near(bolan_sea_time(sea), 12.5, 0.0);
        bolan_sea_hash(fork, after);
        assert_string_not_equal(before, after);
        bolan_sea_settle(fork, 12.5);
        assert_same(fork, sea);
        bolan_sea_destroy(&fresh);
        bolan_sea_destroy(&fork);
        bolan_sea_destroy(&sea);
    }
}

static void a_fork_answers_what_its_origin_answers(void **state) {
    (void)state;
    for (int model = 0; model < MODELS; model++) {
        bolan_sea *sea = test_sea(desc_of(model)), *fork = fork_of(sea);
        double bounds[2][2];
        bolan_sea_bounds(sea, &bounds[0][0], &bounds[0][1]);
        bolan_sea_bounds(fork, &bounds[1][0], &bounds[1][1]);
        assert_memory_equal(bounds[0], bounds[1], sizeof bounds[0]);
        assert_memory_equal(bolan_sea_get_desc(fork), bolan_sea_get_desc(sea), sizeof(bolan_sea_desc));
        assert_memory_equal(bolan_sea_get_summary(fork), bolan_sea_get_summary(sea), sizeof(bolan_sea_summary));
        assert_true(bolan_sea_foam_threshold(fork) == bolan_sea_foam_threshold(sea));
        assert_true(bolan_sea_lift(fork, 0, 3.0) == bolan_sea_lift(sea, 0, 3.0));
        assert_ptr_equal(bolan_sea_slope_table(fork), bolan_sea_slope_table(sea)); // shared, not copied
        const bolan_sea_sample a = bolan_sea_sample_direct(sea, 31.0, 17.0, 9.0),
                               b = bolan_sea_sample_direct(fork, 31.0, 17.0, 9.0);
        assert_memory_equal(&a, &b, sizeof a);
        bolan_sea_destroy(&fork);
        bolan_sea_destroy(&sea);
    }
}

static void seas_may_be_destroyed_in_any_order(void **state) {
    (void)state;
    const size_t before = bolan_memory_in_use();
    const int orders[][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    for (int model = 0; model < MODELS; model++) {
        bolan_sea *twin = test_sea(desc_of(model));
        bolan_sea_step(twin, 7.0);
        for (int o = 0; o < 6; o++) {
            bolan_sea *sea[3] = {test_sea(desc_of(model))};
            sea[1] = fork_of(sea[0]);
            sea[2] = fork_of(sea[1]); // a fork of a fork
            for (int i = 0; i < 2; i++) {
                bolan_sea_destroy(&sea[orders[o][i]]);
                assert_null(sea[orders[o][i]]);
            }
            bolan_sea *last = sea[orders[o][2]], *child = fork_of(last);
            bolan_sea_step(last, 7.0);
            bolan_sea_step(child, 7.0);
            assert_same(last, twin);
            assert_same(child, twin);
            bolan_sea_destroy(&last);
            bolan_sea_destroy(&child);
        }
        bolan_sea_destroy(&twin);
        assert_int_equal(bolan_memory_in_use(), before);
    }
}

// ---- memory ---------------------------------------------------------------------------------------------------------

typedef struct watcher {
    uint32_t allocations, sentences;
    int64_t budget; // allocations that succeed; negative: all
    bolan_log_id id;
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

static void keep_id(void *user, bolan_log_level level, bolan_log_id id, const char *sentence) {
    watcher *w = user;
    (void)level;
    (void)sentence;
    w->sentences++;
    w->id = id;
}

static void watch(watcher *w) {
    const bolan_hooks hooks = {.user = w, .allocate = count_allocation, .release = release, .log = keep_id};
    *w = (watcher){.budget = -1};
    bolan_set_hooks(&hooks);
}

// Bytes of the fields: 10 planes of floats and 9 of halfs, less than 60 bytes a sample, with the lines between; the 8
// parts that lie between the two passes of a step; three buffers of a worker. Of a sum, 64 bytes a wave.
static size_t most_bytes_of_fields(const bolan_sea *sea) {
    size_t bytes = 4096 + bolan_sea_component_count(sea) * 64;
    for (uint32_t i = 0; i < bolan_sea_cascade_count(sea); i++) {
        const size_t n = bolan_sea_cascade(sea, i).n;
        bytes += 60 * n * n + 15 * 7 * 64 + n * (n / 2) * 16 * sizeof(float);
        if (i == 0) bytes += bolan_threads() * 3 * (n * 32 + 144) * sizeof(float);
    }
    const size_t fine = bolan_sea_fine_layout(sea).n; // slopes alone
    bytes += fine * (fine + 64) * 9 * sizeof(float) + fine * (fine / 2) * 16 * sizeof(float);
    return bytes;
}

static void the_memory_of_a_fork_is_its_fields(void **state) {
    (void)state;
    for (int model = 0; model < MODELS; model++) {
        watcher w;
        watch(&w);
        bolan_sea *sea = test_sea(desc_of(model));
        const size_t whole = bolan_memory_in_use();
        bolan_sea *fork = fork_of(sea);
        const size_t of_fork = bolan_memory_in_use() - whole;
        print_message("%s: a sea %zu bytes, a fork %zu\n", bolan_wave_model_names[model], whole, of_fork);
        assert_true(of_fork <= most_bytes_of_fields(sea));
        assert_true(of_fork <
                    whole - BOLAN_SLOPE_TABLE_MAJOR * BOLAN_SLOPE_TABLE_ASPECT * BOLAN_SLOPE_TABLE_ANGLE * 16);
        const uint32_t allocations = w.allocations;
        for (int i = 1; i < 5; i++) bolan_sea_step(fork, 0.1 * i); // no step allocates
        bolan_sea_settle(fork, 3.0);
        assert_int_equal(w.allocations, allocations);
        bolan_sea_destroy(&fork);
        assert_int_equal(bolan_memory_in_use(), whole); // nothing of the origin went with it
        bolan_sea_destroy(&sea);
        assert_int_equal(bolan_memory_in_use(), 0);
        assert_int_equal(w.sentences, 0);
        bolan_set_hooks(NULL);
    }
}

static void a_fork_without_memory_is_an_error_and_leaves_the_sea_whole(void **state) {
    (void)state;
    for (int model = 0; model < MODELS; model++) {
        watcher w;
        watch(&w);
        bolan_sea *sea = test_sea(desc_of(model));
        const size_t whole = bolan_memory_in_use();
        uint32_t refused = 0;
        for (int64_t more = 0; more < 8; more++) {
            bolan_sea *fork = sea;
            w.sentences = 0;
            w.budget = w.allocations + more;
            if (bolan_sea_fork(sea, &fork) == BOLAN_OK) {
                bolan_sea_destroy(&fork);
            } else {
                refused++;
                assert_null(fork);
                assert_int_equal(w.sentences, 1);
                assert_int_equal(w.id, BOLAN_LOG_OUT_OF_MEMORY);
            }
            assert_int_equal(bolan_memory_in_use(), whole);
        }
        assert_true(refused > 0 && refused < 8);
        w.budget = -1;
        bolan_sea_step(sea, 5.0);
        bolan_sea_destroy(&sea);
        assert_int_equal(bolan_memory_in_use(), 0);
        bolan_set_hooks(NULL);
    }
}

// ---- threads --------------------------------------------------------------------------------------------------------

enum { THREADS = 4, ROUNDS = 12 };

typedef struct job {
    const bolan_sea *origin;
    bolan_sea *fork;
    uint32_t seed;
    char hash[ROUNDS][17];
} job;

static double time_of(uint32_t seed, int round) { return 0.5 * ((seed * 7 + (uint32_t)round * 5) % 13); }

// Makes forks, steps and reads them, and gives them up, all while others do.
static void *work(void *context) {
    job *j = context;
    for (int i = 0; i < ROUNDS; i++) {
        bolan_sea_step(j->fork, time_of(j->seed, i));
        bolan_sea_hash(j->fork, j->hash[i]);
        bolan_sea *child = NULL;
        if (bolan_sea_fork(i % 2 ? j->origin : j->fork, &child) == BOLAN_OK) bolan_sea_step(child, i);
        bolan_sea_destroy(&child);
    }
    bolan_sea_destroy(&j->fork);
    return NULL;
}

static void forks_step_on_several_threads_at_once(void **state) {
    (void)state;
    const size_t before = bolan_memory_in_use();
    for (int model = 0; model < MODELS; model++) {
        bolan_sea_desc desc = desc_of(model);
        desc.resolution = 32;
        bolan_sea *sea = test_sea(desc);
        job jobs[THREADS] = {{0}};
        pthread_t thread[THREADS];
        for (uint32_t t = 0; t < THREADS; t++) jobs[t] = (job){.origin = sea, .fork = fork_of(sea), .seed = t};
        for (uint32_t t = 0; t < THREADS; t++) assert_int_equal(pthread_create(&thread[t], NULL, work, &jobs[t]), 0);
        for (int i = 0; i < 20; i++) bolan_sea_step(sea, 100.0 + i); // the origin moves on meanwhile
        for (uint32_t t = 0; t < THREADS; t++) pthread_join(thread[t], NULL);
        for (uint32_t t = 0; t < THREADS; t++) {
            for (int i = 0; i < ROUNDS; i++) {
                char expected[17];
                bolan_sea_step(sea, time_of(t, i));
                bolan_sea_hash(sea, expected);
                assert_string_equal(jobs[t].hash[i], expected);
            }
        }
        bolan_sea_destroy(&sea);
    }
    assert_int_equal(bolan_memory_in_use(), before);
}

// The last owner may be any thread: each gives up its fork while the origin is given up here.
static void *give_up(void *context) {
    bolan_sea *fork = context;
    bolan_sea_step(fork, 3.0);
    bolan_sea_destroy(&fork);
    return NULL;
}

static void the_last_owner_may_be_any_thread(void **state) {
    (void)state;
    const size_t before = bolan_memory_in_use();
    for (int round = 0; round < 8; round++) {
        bolan_sea_desc desc = desc_of(round % MODELS);
        desc.resolution = 32;
        bolan_sea *sea = test_sea(desc);
        pthread_t thread[THREADS];
        for (int t = 0; t < THREADS; t++) assert_int_equal(pthread_create(&thread[t], NULL, give_up, fork_of(sea)), 0);
        bolan_sea_destroy(&sea);
        for (int t = 0; t < THREADS; t++) pthread_join(thread[t], NULL);
        assert_int_equal(bolan_memory_in_use(), before);
    }
}

// ---- numbers --------------------------------------------------------------------------------------------------------

static void an_id_is_of_a_sea_and_all_its_forks(void **state) {
    (void)state;
    enum { SEAS = 6 };
    bolan_sea *sea[SEAS], *fork[SEAS];
    for (int i = 0; i < SEAS; i++) {
        sea[i] = test_sea(desc_of(i % MODELS));
        fork[i] = fork_of(sea[i]);
        const uint64_t id = bolan_sea_id(sea[i]);
        assert_true(id != 0);
        assert_true(bolan_sea_id(fork[i]) == id);
        bolan_sea_settle(sea[i], 5.0);
        assert_true(bolan_sea_id(sea[i]) == id);                             // whatever the time
        for (int j = 0; j < i; j++) assert_true(bolan_sea_id(sea[j]) != id); // also of an equal desc
    }
    const uint64_t last = bolan_sea_id(sea[0]);
    bolan_sea_destroy(&sea[0]);
    assert_true(bolan_sea_id(fork[0]) == last); // the fork is that sea still
    bolan_sea_destroy(&fork[0]);
    sea[0] = test_sea(desc_of(0)); // it may lie at the same address
    assert_true(bolan_sea_id(sea[0]) != last);
    fork[0] = NULL;
    for (int i = 0; i < SEAS; i++) {
        bolan_sea_destroy(&sea[i]);
        bolan_sea_destroy(&fork[i]);
    }
}

static void a_serial_changes_when_the_fields_may_have(void **state) {
    (void)state;
    for (int model = 0; model < MODELS; model++) {
        bolan_sea *sea = test_sea(desc_of(model)), *fork = fork_of(sea);
        uint64_t seen[16];
        uint32_t count = 0;
        seen[count++] = bolan_sea_serial(sea);
        seen[count++] = bolan_sea_serial(fork); // equal fields may have two serials
        bolan_sea_step(sea, 0.3);
        seen[count++] = bolan_sea_serial(sea);
        bolan_sea_step(fork, 0.3);
        seen[count++] = bolan_sea_serial(fork);
        bolan_sea_step(sea, 0.0);
        seen[count++] = bolan_sea_serial(sea);
        bolan_sea_settle(sea, 0.0); // the foam changes, at the same time
        seen[count++] = bolan_sea_serial(sea);
        bolan_sea_settle(sea, 9.0);
        seen[count++] = bolan_sea_serial(sea);
        bolan_sea_step(sea, 9.0);
        assert_true(bolan_sea_serial(sea) == seen[count - 1]);
        assert_true(bolan_sea_serial(fork) == seen[3]); // the other's steps do not touch it
        for (uint32_t i = 0; i < count; i++) {
            assert_true(seen[i] != 0);
            for (uint32_t j = 0; j < i; j++) assert_true(seen[i] != seen[j]);
        }
        for (int step = 0; step < 100; step++) { // however often one of them is stepped
            bolan_sea_step(fork, 20.0 + step);
            for (uint32_t i = 0; i < count; i++) assert_true(bolan_sea_serial(fork) != seen[i]);
        }
        bolan_sea_destroy(&fork);
        bolan_sea_destroy(&sea);
    }
}

// Copies of all planes of cascade 0; of a sum, samples.
static void keep_fields(const bolan_sea *sea, char hash[17], bolan_sea_sample sample[100]) {
    bolan_dvec2 at[100];
    for (int i = 0; i < 100; i++) at[i] = (bolan_dvec2){3.7 * i, 11.3 * i};
    bolan_sea_hash(sea, hash);
    bolan_sea_sample_rest(sea, at, 100, sample); // with the foam
}

static void a_step_to_the_present_time_changes_no_bit(void **state) {
    (void)state;
    for (int model = 0; model < MODELS; model++) {
        bolan_sea *sea = test_sea(desc_of(model));
        bolan_sea_settle(sea, 4.4);
        bolan_sea_step(sea, 4.5);
        char hash[2][17];
        bolan_sea_sample sample[2][100];
        keep_fields(sea, hash[0], sample[0]);
        for (int i = 0; i < 5; i++) bolan_sea_step(sea, 4.5);
        keep_fields(sea, hash[1], sample[1]);
        assert_string_equal(hash[0], hash[1]);
        assert_memory_equal(sample[0], sample[1], sizeof sample[0]);
        bolan_sea_destroy(&sea);
    }
}

RUN_TESTS(cmocka_unit_test(a_fork_shows_the_same_waves_at_a_time_of_its_own),
          cmocka_unit_test(a_fork_answers_what_its_origin_answers),
          cmocka_unit_test(seas_may_be_destroyed_in_any_order), cmocka_unit_test(the_memory_of_a_fork_is_its_fields),
          cmocka_unit_test(a_fork_without_memory_is_an_error_and_leaves_the_sea_whole),
          cmocka_unit_test(forks_step_on_several_threads_at_once), cmocka_unit_test(the_last_owner_may_be_any_thread),
          cmocka_unit_test(an_id_is_of_a_sea_and_all_its_forks),
          cmocka_unit_test(a_serial_changes_when_the_fields_may_have),
          cmocka_unit_test(a_step_to_the_present_time_changes_no_bit))

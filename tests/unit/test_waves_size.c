// SPDX-License-Identifier: MIT
// The memory of a sea is known before its creation, for every model, resolution and number of workers.
#include "sea_support.h"

#include <string.h>

static size_t allocated, released;
static void *take(void *user, size_t size, size_t align) {
    (void)user;
    allocated += size;
    return aligned_alloc(align, (size + align - 1) / align * align);
}
static void give(void *user, void *memory, size_t size) {
    (void)user;
    released += size;
    free(memory);
}

static void check(const bolan_sea_desc *desc) {
    const bolan_sea_bytes bytes = bolan_sea_size(desc);
    bolan_sea *sea = NULL, *fork = NULL;
    allocated = released = 0;
    assert_int_equal(bolan_sea_create(desc, &sea), BOLAN_OK);
    assert_int_equal(allocated - released, bytes.tables + bytes.fields);
    assert_true(released < 1 << 20); // borrowed meanwhile
    const size_t before = allocated - released;
    assert_int_equal(bolan_sea_fork(sea, &fork), BOLAN_OK);
    assert_int_equal(allocated - released - before, bytes.fields);
    bolan_sea_destroy(&sea);
    bolan_sea_destroy(&fork);
    assert_int_equal(allocated, released);
}

static void the_size_of_a_sea_is_what_it_allocates(void **state) {
    (void)state;
    bolan_set_hooks(&(bolan_hooks){.allocate = take, .release = give});
    static const double winds[] = {0.0, 6.0, 13.0};
    for (int model = 0; model < BOLAN_WAVE_MODELS; model++) {
        for (int i = 0; i < 3; i++) {
            bolan_sea_desc desc = bolan_sea_desc_default();
            desc.waves = (bolan_wave_model)model;
            desc.sea_state = bolan_sea_state_from_wind(winds[i], 250.0, 100e3);
            desc.sea_state.depth = i == 2 ? 20.0 : BOLAN_DEEP;
            desc.resolution = 32u << i;
            desc.fft.cascade_count = 4 - (uint32_t)i;
            desc.length = i == 1 ? 777.0 : 0.0;
            bolan_set_threads(1 + (uint32_t)i);
            check(&desc);
        }
    }
    bolan_set_threads(1);
    bolan_set_hooks(NULL);
}

static int warnings;
static void count_warnings(void *user, bolan_log_level level, bolan_log_id id, const char *sentence) {
    (void)user, (void)level, (void)id, (void)sentence;
    warnings++;
}

static void the_size_says_nothing_but_what_is_wrong_with_the_desc(void **state) {
    (void)state;
    bolan_set_hooks(&(bolan_hooks){.log = count_warnings});
    bolan_sea_desc desc = bolan_sea_desc_default();
    desc.sea_state.depth = 0.5; // the sea would be lowered, with a warning
    const size_t held = bolan_memory_in_use();
    assert_true(bolan_sea_size(&desc).fields > 0);
    assert_int_equal(warnings, 0);
    desc.resolution = 100;
    const bolan_sea_bytes none = bolan_sea_size(&desc);
    assert_true(none.tables == 0 && none.fields == 0 && warnings == 1);
    assert_int_equal(bolan_memory_in_use(), held);
    bolan_set_hooks(NULL);
}

RUN_TESTS(cmocka_unit_test(the_size_of_a_sea_is_what_it_allocates),
          cmocka_unit_test(the_size_says_nothing_but_what_is_wrong_with_the_desc))

// SPDX-License-Identifier: MIT
// The bits of everything that is promised to be the same on every machine, as literal hashes: the seas, the answers
// about them, the ground, tiles, grids and models. A comparison of two runs of one program cannot see what a compiler,
// its flags, its optimisation or another processor changes; a literal can. tools/check_bits.sh runs this test with
// several of each.
//
// After an intended change of any of them:
//     BOLAN_PRINT_HASHES=1 build/tests/test_golden > tests/determinism/golden_hashes.h
// With the argument `once`, for slow builds and emulators, each case runs once and not by every instruction set and
// number of threads: these take turns.
#include "content_support.h"
#include "sea_support.h"

#include "bolan/ground.h"
#include "bolan/query.h"
#include "bolan/scene.h"
#include "bolan/surface.h"
#include "bolan/tiles.h"

#include <string.h>

// ---- a digest -------------------------------------------------------------------------------------------------------

static uint64_t add_bytes(uint64_t hash, const void *data, size_t size) {
    const unsigned char *bytes = data;
    for (size_t i = 0; i < size; i++) hash = (hash ^ bytes[i]) * 0x100000001b3u; // FNV-1a
    return hash;
}
#define FNV_START 0xcbf29ce484222325u
#define ADD(hash, value) ((hash) = add_bytes(hash, &(value), sizeof(value)))

// ---- seas -----------------------------------------------------------------------------------------------------------

// A time on a step, one between, one far away, one before the beginning.
static const double times[] = {0.0, 12.34, 86400.0 * 365.0, -777.7};
enum { TIMES = sizeof times / sizeof *times };

enum { POINTS = 300 }; // more than a block of a query holds

// Near the origin and a thousand kilometres away, apart from each other by no simple number.
static void place(bolan_dvec2 at[POINTS]) {
    for (int i = 0; i < POINTS; i++) {
        const double far = i % 3 == 2 ? 1e6 : 0.0;
        at[i] = (bolan_dvec2){far + 7.3 * i - 900.0, 0.37 * i * (i % 17) - far - 450.0};
    }
}

static uint64_t add_fields(uint64_t hash, const bolan_sea *sea) {
    char digits[17];
    bolan_sea_hash(sea, digits);
    hash = add_bytes(hash, digits, 16);
    for (uint32_t i = 0; i < bolan_sea_cascade_count(sea); i++) {
        const bolan_cascade_view v = bolan_sea_cascade(sea, i);
        const size_t points = (size_t)v.n * v.n;
        const double numbers[] = {v.length, v.angle, v.k_min, v.k_max, v.variance, v.mss};
        ADD(hash, numbers);
        hash = add_bytes(hash, v.foam, points * sizeof *v.foam);
        hash = add_bytes(hash, v.displacement_half, points * 8);
        hash = add_bytes(hash, v.slope_half, points * 8);
        hash = add_bytes(hash, v.foam_half, points * 2);
    }
    for (uint32_t i = 0; i < bolan_sea_component_count(sea); i++) {
        const bolan_sea_component c = bolan_sea_get_component(sea, i);
        ADD(hash, c);
    }
    return hash;
}

// What does not change with time.
static uint64_t add_constants(uint64_t hash, const bolan_sea *sea) {
    const size_t table = (size_t)BOLAN_SLOPE_TABLE_MAJOR * BOLAN_SLOPE_TABLE_ASPECT * BOLAN_SLOPE_TABLE_ANGLE * 4;
    hash = add_bytes(hash, bolan_sea_slope_table(sea), table * sizeof(float));
    const double threshold = bolan_sea_foam_threshold(sea);
    double bounds[2];
    bolan_sea_bounds(sea, &bounds[0], &bounds[1]);
    ADD(hash, threshold);
    ADD(hash, bounds);
    return add_bytes(hash, bolan_sea_get_summary(sea), sizeof(bolan_sea_summary));
}

static uint64_t add_answers(uint64_t hash, const bolan_sea *sea, const bolan_ground *terrain) {
    bolan_dvec2 at[POINTS];
    float spacing[POINTS], height[POINTS];
    bolan_query_point water[POINTS];
    bolan_sea_sample sample[POINTS];
    place(at);
    for (int i = 0; i < POINTS; i++) spacing[i] = 0.21f * (float)(i % 50);
    bolan_query_heights(&(bolan_water){.sea = sea}, at, POINTS, height);
    ADD(hash, height);
    bolan_query_surface(&(bolan_water){.sea = sea}, at, POINTS, water);
    ADD(hash, water);
    bolan_query_surface(&(bolan_water){.sea = sea, .ground = terrain, .level = 0.5}, at, POINTS, water);
    ADD(hash, water);
    bolan_sea_sample_rest(sea, at, POINTS, sample);
    ADD(hash, sample);
    bolan_sea_sample_grid(sea, at, spacing, POINTS, sample);
    ADD(hash, sample);
    const bolan_sea_sample direct = bolan_sea_sample_direct(sea, at[5].x, at[5].y, 3.21);
    ADD(hash, direct);
    const bolan_sea_statistics statistics = bolan_sea_measure(sea);
    return ADD(hash, statistics);
}

static uint64_t sea_bits(bolan_sea_desc desc, const bolan_ground *terrain) {
    bolan_sea *sea = test_sea(desc);
    uint64_t hash = add_constants(FNV_START, sea);
    for (int t = 0; t < TIMES; t++) {
        bolan_sea_step(sea, times[t]);
        hash = add_fields(hash, sea);
    }
    bolan_sea_settle(sea, 5.5); // foam of the seconds before
    hash = add_fields(hash, sea);
    hash = add_answers(hash, sea, terrain);
    bolan_sea_destroy(&sea);
    return hash;
}

static bolan_sea_desc small(void) {
    bolan_sea_desc desc = bolan_sea_desc_default();
    desc.resolution = 64;
    return desc;
}
static bolan_sea_desc of_model(bolan_wave_model waves) {
    bolan_sea_desc desc = small();
    desc.waves = waves;
    return desc;
}
static bolan_sea_desc stormy(void) {
    bolan_sea_desc desc = small();
    desc.sea_state = bolan_sea_state_from_wind(21.0, 310.0, 120e3);
    bolan_sea_state_add_swell(&desc.sea_state, 2.5, 13.0, 200.0, 25.0);
    desc.choppiness = 1.3;
    desc.seed = 0x123456789abcdefu;
    return desc;
}
static bolan_sea_desc shallow(void) {
    bolan_sea_desc desc = small();
    desc.sea_state.systems[0].kind = BOLAN_SPECTRUM_TMA;
    desc.sea_state.systems[0].spreading = BOLAN_SPREADING_COS2S;
    desc.sea_state.depth = 8.0;
    desc.loop_period = 200.0;
    desc.fft.cascade_count = 2;
    return desc;
}
static bolan_sea_desc second_order(void) {
    bolan_sea_desc desc = small();
    desc.sea_state.depth = 15.0;
    desc.order = 2;
    return desc;
}
static bolan_sea_desc phillips(void) {
    bolan_sea_desc desc = small();
    desc.sea_state = bolan_sea_state_from_phillips(12.0, 45.0);
    desc.length = 300.0;
    desc.fft.cascade_count = 1;
    return desc;
}
static bolan_sea_desc carried(void) {
    bolan_sea_desc desc = of_model(BOLAN_WAVES_COSINES);
    desc.sea_state.current_x = 1.5;
    desc.sea_state.current_y = -0.5;
    desc.cosines.split = BOLAN_SPLIT_EQUAL_WIDTH;
    return desc;
}

// ---- the ground -----------------------------------------------------------------------------------------------------

static uint64_t terrain_bits(const bolan_ground *terrain, double west, double step) {
    enum { SIDE = 96 };
    static float grid[SIDE * SIDE];
    bolan_ground_elevations(terrain, west, west, step, SIDE, SIDE, grid);
    uint64_t hash = FNV_START;
    ADD(hash, grid);
    for (int i = 0; i < 500; i++) { // all detail, at places off the grid
        const float z = bolan_ground_elevation(terrain, west + 3.17 * i, west + 0.91 * step * (i % 90), 0.0);
        ADD(hash, z);
    }
    const bolan_ground_extent extent = bolan_ground_get_extent(terrain);
    const uint64_t id = bolan_ground_id(terrain);
    ADD(hash, extent);
    ADD(hash, id);
    float lowest, highest;
    bolan_ground_bounds(terrain, west, west, 10.0 * step, &lowest, &highest);
    ADD(hash, lowest);
    return ADD(hash, highest);
}

static uint64_t island_bits(void) {
    bolan_ground_generator desc = generator_named("island");
    desc.seed = 11;
    desc.lagoon_from_deg = 100.0;
    bolan_ground *terrain = NULL;
    assert_int_equal(bolan_content_create_ground(&desc, &terrain), BOLAN_OK);
    const uint64_t hash = terrain_bits(terrain, -2400.0, 50.0);
    bolan_ground_destroy(&terrain);
    return hash;
}

static uint64_t raster_bits(void) {
    enum { WIDTH = 24, HEIGHT = 16 };
    float elevation[WIDTH * HEIGHT];
    for (int i = 0; i < WIDTH * HEIGHT; i++) elevation[i] = (float)((i * 7919) % 1009) * 0.25f - 90.0f;
    bolan_ground_desc desc = bolan_ground_desc_default();
    desc.field = (bolan_heightfield){WIDTH, HEIGHT, -700.0, -500.0, 61.3, 74.9, elevation};
    bolan_ground *terrain = NULL;
    assert_int_equal(bolan_ground_create(&desc, &terrain), BOLAN_OK);
    const uint64_t hash = terrain_bits(terrain, -800.0, 17.0);
    bolan_ground_destroy(&terrain);
    return hash;
}

// ---- tiles, grids, models -------------------------------------------------------------------------------------------

static uint64_t tiles_bits(bolan_cpu cpu) {
    bolan_sea_desc sea_desc = of_model(BOLAN_WAVES_TEXTURES);
    sea_desc.textures.frames = 4;
    sea_desc.cpu = cpu;
    bolan_sea *sea = test_sea(sea_desc);
    bolan_tiles_desc desc = bolan_tiles_desc_default();
    desc.sun = (bolan_vec3){0.36f, -0.48f, 0.8f};
    bolan_tiles *tiles = NULL;
    assert_int_equal(bolan_tiles_bake(sea, &desc, &tiles), BOLAN_OK);
    const bolan_tiles_view v = bolan_tiles_get_view(tiles);
    const size_t texels = (size_t)v.n * v.n * v.frames;
    uint64_t hash = add_bytes(FNV_START, v.height, texels * sizeof(float));
    hash = add_bytes(hash, v.normal, texels * 3);
    hash = add_bytes(hash, v.detail, texels * 3);
    hash = add_bytes(hash, v.caustics, texels);
    const double numbers[] = {v.length, v.angle, v.period, v.depth};
    ADD(hash, numbers);
    bolan_tiles_destroy(&tiles);
    bolan_sea_destroy(&sea);
    return hash;
}

// bolan_surface_nested_place() promises the same levels on every machine.
static uint64_t nested_bits(void) {
    const bolan_surface_view view = {{123.4, -56.7, 21.0}, 33.0, -7.0, 4.0, 0.9, 1.5, 720, 0.25, 2.0, 1.5, 0.0, 0.0};
    bolan_nested_desc desc = bolan_nested_desc_default();
    const bolan_nested nested = bolan_surface_nested_place(&desc, &view);
    uint64_t hash = FNV_START;
    ADD(hash, nested.levels);
    ADD(hash, nested.centre);
    ADD(hash, nested.least_spacing);
    for (uint32_t i = 0; i < nested.levels; i++) {
        const bolan_nested_level level = nested.level[i];
        ADD(hash, level);
    }
    bolan_dvec2 *rest = calloc(bolan_surface_nested_vertex_count(&nested), sizeof *rest);
    bolan_surface_nested_vertices(&nested, NULL, rest, NULL, NULL);
    hash = add_bytes(hash, rest, bolan_surface_nested_vertex_count(&nested) * sizeof *rest);
    free(rest);
    return hash;
}

static uint64_t model_bits(const char *name) {
    bolan_model *model = NULL;
    assert_int_equal(bolan_content_create_model(name, &model), BOLAN_OK);
    const bolan_model_view v = bolan_model_get_view(model);
    uint64_t hash = add_bytes(FNV_START, v.positions, v.vertex_count * sizeof *v.positions);
    hash = add_bytes(hash, v.normals, v.vertex_count * sizeof *v.normals);
    hash = add_bytes(hash, v.colors, v.vertex_count * sizeof *v.colors);
    hash = add_bytes(hash, v.indices, v.index_count * sizeof *v.indices);
    bolan_model_destroy(&model);
    return hash;
}

// ---- the table ------------------------------------------------------------------------------------------------------

static const struct golden {
    const char *name;
    uint64_t hash;
} golden[] = {
#include "determinism/golden_hashes.h"
    {NULL, 0},
};

static unsigned differences;
static bool printing, once;

static void check(const char *name, uint64_t hash, const char *how) {
    if (printing) {
        printf("{\"%s\", 0x%016llxu},\n", name, (unsigned long long)hash);
        return;
    }
    for (const struct golden *g = golden; g->name; g++)
        if (strcmp(g->name, name) == 0) {
            if (g->hash == hash) return;
            break;
        }
    print_error("%s%s: 0x%016llxu is not what golden_hashes.h has\n", name, how, (unsigned long long)hash);
    differences++;
}

static const struct sea_case {
    const char *name;
    bolan_sea_desc (*desc)(void);
} seas[] = {{"sea: default", small},     {"sea: storm and swell", stormy}, {"sea: shallow, looping", shallow},
            {"sea: Phillips", phillips}, {"sea: order 2", second_order},   {"sea: cosines in a current", carried}};
static const struct model_case {
    const char *name;
    bolan_wave_model waves;
} wave_models[] = {{"sea: cosines", BOLAN_WAVES_COSINES},
                   {"sea: exp-cosine", BOLAN_WAVES_EXP_COSINE},
                   {"sea: textures", BOLAN_WAVES_TEXTURES}};

enum {
    SEAS = sizeof seas / sizeof *seas,
    MODELS = sizeof wave_models / sizeof *wave_models,
    CASES = SEAS + MODELS + 1
};

// Case `i`: a sea of the first table, one of the second, or the tiles.
static void check_case(int i, bolan_cpu cpu, const bolan_ground *pond, const char *how) {
    if (i == CASES - 1) {
        check("tiles", tiles_bits(cpu), how);
        return;
    }
    bolan_sea_desc desc = i < SEAS ? seas[i].desc() : of_model(wave_models[i - SEAS].waves);
    desc.cpu = cpu;
    check(i < SEAS ? seas[i].name : wave_models[i - SEAS].name, sea_bits(desc, pond), how);
}

static void check_ground(const bolan_ground *pond, const char *how) {
    check("ground: pond", terrain_bits(pond, -60.0, 1.3), how);
    check("ground: island", island_bits(), how);
    check("ground: raster", raster_bits(), how);
}

static bolan_ground *create_pond(void) {
    bolan_ground *pond = NULL;
    const bolan_ground_generator generator = generator_named("pond");
    assert_int_equal(bolan_content_create_ground(&generator, &pond), BOLAN_OK);
    return pond;
}

static const char *const set_names[] = {"", " (scalar)", " (generic4)", " (AVX2)", " (AVX-512)"};

static void check_by_every_set(const bolan_ground *pond) {
    const int last = printing ? BOLAN_CPU_SCALAR : (int)bolan_cpu_best();
    for (int cpu = BOLAN_CPU_SCALAR; cpu <= last; cpu++)
        for (int i = 0; i < CASES; i++) check_case(i, (bolan_cpu)cpu, pond, set_names[cpu]);
    if (printing) return;
    bolan_set_threads(3);
    for (int i = 0; i < CASES; i++) check_case(i, BOLAN_CPU_AUTO, pond, " (3 threads)");
    bolan_set_threads(1);
}

// The order of the cases gives each set a sea of cascades, and each but the first of four a sum of waves.
static void check_by_turns(const bolan_ground *pond) {
    const int sets = (int)bolan_cpu_best() - BOLAN_CPU_SCALAR + 1;
    for (int i = 0; i < CASES; i++) {
        const bolan_cpu cpu = (bolan_cpu)(BOLAN_CPU_SCALAR + i % sets);
        bolan_set_threads(1 + (uint32_t)i % 3);
        check_case(i, cpu, pond, set_names[cpu]);
    }
    bolan_set_threads(1);
}

static void seas_and_answers_have_their_bits(void **state) {
    (void)state;
    bolan_ground *pond = create_pond();
    differences = 0;
    if (once)
        check_by_turns(pond);
    else
        check_by_every_set(pond);
    bolan_ground_destroy(&pond);
    assert_int_equal(differences, 0);
}

static void the_ground_has_its_bits(void **state) {
    (void)state;
    bolan_ground *pond = create_pond();
    differences = 0;
    if (!once) check_ground(pond, "");
    if (!printing) {
        bolan_set_threads(3);
        check_ground(pond, " (3 threads)");
        bolan_set_threads(1);
    }
    bolan_ground_destroy(&pond);
    assert_int_equal(differences, 0);
}

static void grids_and_models_have_their_bits(void **state) {
    (void)state;
    differences = 0;
    check("nested grid", nested_bits(), "");
    const char *name;
    for (uint32_t i = 0; (name = bolan_content_model_name(i)) != NULL; i++) {
        char label[64];
        snprintf(label, sizeof label, "model: %s", name);
        check(label, model_bits(name), "");
    }
    assert_int_equal(differences, 0);
}

int main(int count, char **arguments) {
    printing = getenv("BOLAN_PRINT_HASHES") != NULL;
    once = count > 1 && strcmp(arguments[1], "once") == 0;
    if (printing) {
        printf("// SPDX-License-Identifier: MIT\n// Written by test_golden.c, which says how.\n");
        seas_and_answers_have_their_bits(NULL);
        the_ground_has_its_bits(NULL);
        grids_and_models_have_their_bits(NULL);
        return 0;
    }
    const struct CMUnitTest tests[] = {cmocka_unit_test(seas_and_answers_have_their_bits),
                                       cmocka_unit_test(the_ground_has_its_bits),
                                       cmocka_unit_test(grids_and_models_have_their_bits)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

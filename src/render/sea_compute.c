// SPDX-License-Identifier: MIT
// See sea_compute.h.
#include "sea_compute.h"

#include "foam_statistics.h"
#include "frame.h"
#include "memory.h"
#include "shared/constants.glsl"

#include <math.h>
#include <stdio.h>
#include <string.h>

const char *const bolan_sea_stage_names[SEA_STAGES] = {"sea ticks", "sea rows", "sea columns", "sea levels"};

enum { SLOT_MODES, SLOT_DIVISORS, SLOT_ROWS, SLOT_MEMORY, SLOT_LAW = 0 }; // storage buffers
enum { GROUP_VALUES = 1024, TICKS = 4, LEVELS = 4, TILE = 16 };           // of a dispatch of the shaders

// Waves beside the first of the modes of a cascade that have several.
enum { PART_SIDE = 2 * MODE_PART_REACH, PART_ROWS = (MODE_PARTS - 1) * MODE_PART_REACH, PARTS = PART_ROWS * PART_SIDE };
_Static_assert(MODE_PARTS == BOLAN_MODE_PARTS && MODE_PART_REACH == BOLAN_MODE_PART_REACH,
               "the shaders read the modes that the public header states");

// A wave of a mode as sea_rows.glsl has it.
typedef struct gpu_mode {
    float amplitude[4];
    uint32_t step[2];
    float turns, inverse_k;
} gpu_mode;

// ---- programs -------------------------------------------------------------------------------------------------------

static sea_programs *programs_of(sea_compute *p, uint32_t n) {
    uint32_t size = 0;
    while (32u << size < n) ++size;
    BOLAN_ASSERT(size < SEA_SIZES && 32u << size == n);
    return &p->programs[size];
}

static bool make(gl_program *program, const char *stem, uint32_t n, const char *more) {
    char defines[48];
    if (program->id != 0) return true;
    snprintf(defines, sizeof defines, "SIZE %u\n%s", n, more);
    return bolan_gl_program_create_compute(stem, defines, program) == BOLAN_OK;
}

bool bolan_sea_compute_compile(sea_compute *p, uint32_t n, sea_layout layout) {
    static const char *const defines[] = {"", "PACKED 1\n", "HOST 1\n"};
    sea_programs *s = programs_of(p, n);
    if (s->compiled[layout]) return s->whole[layout];
    s->compiled[layout] = true;
    s->whole[layout] = make(&s->rows, "compute/sea_rows", n, "") &&
                       make(&s->tick_rows, "compute/sea_rows", n, "TICKS 1\n") &&
                       make(&s->tick_columns, "compute/sea_columns", n, "TICKS 1\n") &&
                       make(&s->columns[layout], "compute/sea_columns", n, defines[layout]) &&
                       make(&p->levels, "compute/sea_levels", 0, "") &&
                       (layout == SEA_LAYOUT_HOST || make(&p->law[layout], "compute/sea_foam_law", 0, defines[layout]));
    return s->whole[layout];
}

enum { SIZE_PROGRAMS = 3 + SEA_LAYOUTS };

static void list_programs(sea_programs *s, gl_program *out[SIZE_PROGRAMS]) {
    out[0] = &s->rows;
    out[1] = &s->tick_rows;
    out[2] = &s->tick_columns;
    for (int i = 0; i < SEA_LAYOUTS; ++i) out[3 + i] = &s->columns[i];
}

static bolan_result reload(gl_program *program) {
    return program->id != 0 ? bolan_gl_program_reload(program) : BOLAN_OK;
}

bolan_result bolan_sea_compute_reload(sea_compute *p) {
    bolan_result result = reload(&p->levels);
    for (int i = 0; i < SEA_LAYOUT_HOST && result == BOLAN_OK; ++i) result = reload(&p->law[i]);
    for (int i = 0; i < SEA_SIZES && result == BOLAN_OK; ++i) {
        gl_program *all[SIZE_PROGRAMS];
        list_programs(&p->programs[i], all);
        for (int k = 0; k < SIZE_PROGRAMS && result == BOLAN_OK; ++k) result = reload(all[k]);
    }
    return result;
}

void bolan_sea_compute_free(sea_compute *p) {
    for (int i = 0; i < SEA_SIZES; ++i) {
        gl_program *all[SIZE_PROGRAMS];
        list_programs(&p->programs[i], all);
        for (int k = 0; k < SIZE_PROGRAMS; ++k) bolan_gl_program_free(all[k]);
    }
    bolan_gl_program_free(&p->levels);
    for (int i = 0; i < SEA_LAYOUT_HOST; ++i) bolan_gl_program_free(&p->law[i]);
    for (int i = 0; i < SEA_STAGES; ++i) bolan_gl_timer_free(&p->timers[i]);
    bolan_gl_buffer_free(&p->rows);
}

// ---- tables of a sea ------------------------------------------------------------------------------------------------

void bolan_sea_tables_free(sea_tables *t) {
    bolan_gl_buffer_free(&t->modes);
    bolan_gl_buffer_free(&t->divisors);
    bolan_gl_buffer_free(&t->memory);
    bolan_gl_buffer_free(&t->law);
    *t = (sea_tables){.sea = 0};
}

#define QUARTER 0.25 // [s], of which the GPU counts time

// Turns in a quarter of a second, without the whole ones, in units of 2^-64: a double has no more bits.
static void split_step(double turns, uint32_t step[2]) {
    const double in = turns * QUARTER - floor(turns * QUARTER), high = floor(in * 0x1p32);
    step[1] = (uint32_t)high;
    step[0] = (uint32_t)((in * 0x1p32 - high) * 0x1p32);
}

// A time as phase_of() of sea_rows.glsl takes it.
static void split_time(double time, float out[4]) {
    const double quarters = floor(time / QUARTER), high = floor(quarters * 0x1p-32), low = quarters - high * 0x1p32;
    const double second = floor(low * 0x1p-16);
    out[0] = (float)(low - second * 0x1p16);
    out[1] = (float)second;
    out[2] = (float)high;
    out[3] = (float)(time - quarters * QUARTER);
}

// The drift of the foam at a tick, as tick_drifts of sea_block.glsl, and as drifted.
static void split_drift(const bolan_sea *sea, uint32_t cascade, double tick, float out[4]) {
    uint32_t drift[2];
    bolan_sea_foam_drift(sea, cascade, tick, drift);
    for (int e = 0; e < 2; ++e) out[2 * e] = (float)(drift[e] & 0xffff), out[2 * e + 1] = (float)(drift[e] >> 16);
}

static void drift_samples(const bolan_sea *sea, uint32_t cascade, double tick, float out[4]) {
    const uint32_t n = bolan_sea_cascade_layout(sea, cascade).n;
    uint32_t drift[2];
    bolan_sea_foam_drift(sea, cascade, tick, drift);
    for (int e = 0; e < 2; ++e) {
        const uint64_t samples = (uint64_t)drift[e] * n;
        out[e] = (float)(samples >> 32), out[2 + e] = (float)(uint32_t)samples * 0x1p-32f;
    }
}

static void place_cascades(sea_tables *t, const bolan_sea *sea) {
    double modes = 0.0, rows = 0.0;
    t->count = bolan_sea_cascade_count(sea);
    t->most_rows = 0;
    for (uint32_t c = 0; c < t->count; ++c) {
        const bolan_cascade_view v = bolan_sea_cascade_layout(sea, c);
        const uint32_t half = bolan_sea_mode_rows(sea, c), count = 2 * half - 1;
        const float axes[4] = {(float)cos(v.angle), (float)sin(v.angle), (float)(2.0 * BOLAN_PI / v.length),
                               (float)half};
        const float parts[4] = {(float)modes, (float)rows, (float)(modes + (double)half * v.n), 0.0f};
        memcpy(t->axes[c], axes, sizeof axes);
        memcpy(t->parts[c], parts, sizeof parts);
        modes += (double)half * v.n + PARTS;
        rows += 2.0 * count * v.n;
        if (count > t->most_rows) t->most_rows = count;
    }
    t->bytes = (uint64_t)(modes * sizeof(gpu_mode) + 2.0 * rows * sizeof(bolan_vec4));
}

static gpu_mode gpu_mode_of(const bolan_sea_mode *m) {
    gpu_mode out = {.turns = (float)m->turns, .inverse_k = m->inverse_k};
    memcpy(out.amplitude, m->a, sizeof m->a);
    split_step(m->turns, out.step);
    return out;
}

static void upload_modes(sea_tables *t, const bolan_sea *sea, uint32_t cascade, bolan_sea_mode *row, gpu_mode *out) {
    const uint32_t n = bolan_sea_cascade_layout(sea, cascade).n, rows = bolan_sea_mode_rows(sea, cascade);
    for (uint32_t j = 0; j < rows; ++j) {
        bolan_sea_modes(sea, cascade, 0, j, row);
        for (uint32_t i = 0; i < n; ++i) out[i] = gpu_mode_of(&row[i]);
        const size_t at = (size_t)t->parts[cascade][0] + (size_t)j * n;
        bolan_gl_buffer_update(&t->modes, at * sizeof *out, n * sizeof *out, out);
    }
}

// The other waves of the modes near the origin, by part and j; i goes from -MODE_PART_REACH on.
static void upload_parts(sea_tables *t, const bolan_sea *sea, uint32_t cascade, bolan_sea_mode *row) {
    const uint32_t n = bolan_sea_cascade_layout(sea, cascade).n, rows = bolan_sea_mode_rows(sea, cascade);
    size_t at = (size_t)t->parts[cascade][2];
    for (uint32_t line = 0; line < PART_ROWS; ++line, at += PART_SIDE) {
        const uint32_t part = 1 + line / MODE_PART_REACH, j = line % MODE_PART_REACH;
        gpu_mode out[PART_SIDE] = {{.turns = 0.0f}};
        if (j < rows) bolan_sea_modes(sea, cascade, part, j, row);
        for (uint32_t x = 0; x < PART_SIDE && j < rows; ++x)
            out[x] = gpu_mode_of(&row[(x - MODE_PART_REACH) & (n - 1)]);
        bolan_gl_buffer_update(&t->modes, at * sizeof *out, sizeof out, out);
    }
}

// Row 0 has the divisors of one axis alone.
static void upload_divisors(sea_tables *t, const bolan_sea *sea, uint32_t n, bolan_sea_mode *row, bolan_vec2 *out) {
    bolan_sea_modes(sea, 0, 0, 0, row);
    for (uint32_t i = 0; i < n / 2; ++i) out[i] = (bolan_vec2){row[i].cubic, row[i].linear};
    bolan_gl_buffer_update(&t->divisors, 0, n / 2 * sizeof *out, out);
}

static bool upload_tables(sea_tables *t, const bolan_sea *sea, uint32_t n) {
    const size_t row_bytes = n * sizeof(bolan_sea_mode), out_bytes = n * sizeof(gpu_mode);
    char *scratch = allocate_for("the modes of a sea", row_bytes + out_bytes);
    if (scratch == NULL) return false;
    bolan_sea_mode *row = (void *)scratch;
    void *out = scratch + row_bytes;
    for (uint32_t c = 0; c < t->count; ++c) {
        upload_modes(t, sea, c, row, out);
        upload_parts(t, sea, c, row);
    }
    upload_divisors(t, sea, n, row, out);
    bolan_release(scratch, row_bytes + out_bytes);
    return true;
}

static bool create_storage(size_t bytes, gl_buffer *out) {
    return bolan_gl_buffer_create(GL_BUFFER_STORAGE, GL_USAGE_STATIC, bytes, NULL, out) == BOLAN_OK;
}

static bool fit_tables(sea_tables *t, const bolan_sea *sea) {
    if (t->sea == bolan_sea_id(sea)) return true;
    bolan_sea_tables_free(t);
    place_cascades(t, sea);
    const uint32_t n = bolan_sea_cascade_layout(sea, 0).n, last = t->count - 1;
    const size_t modes = (size_t)t->parts[last][2] + PARTS;
    const bool all = create_storage(modes * sizeof(gpu_mode), &t->modes) &&
                     create_storage(n / 2 * sizeof(bolan_vec2), &t->divisors) &&
                     create_storage((size_t)t->count * n * n * sizeof(float), &t->memory) &&
                     create_storage(FOAM_LAW_COUNT * sizeof(float), &t->law) && upload_tables(t, sea, n);
    if (!all) {
        bolan_sea_tables_free(t);
        return false;
    }
    bolan_foam_law_constants(sea, &t->offset, &t->variance);
    t->weights = bolan_foam_weights(sea);
    t->sea = bolan_sea_id(sea);
    return true;
}

static bool fit_rows(sea_compute *p, const sea_tables *t, uint32_t n) {
    const uint32_t last = t->count - 1;
    const size_t values = (size_t)t->parts[last][1] + 2 * (size_t)(2.0f * t->axes[last][3] - 1.0f) * n;
    if (p->rows.size >= values * sizeof(bolan_vec4)) return true;
    bolan_gl_buffer_free(&p->rows);
    return create_storage(values * sizeof(bolan_vec4), &p->rows);
}

// ---- dispatches -----------------------------------------------------------------------------------------------------

static void use(const gl_program *g, const sea_tables *t, const bolan_sea *sea) {
    bolan_gl_program_use(g);
    bolan_gl_program_vec4_array(g, "cascade_axes", t->axes[0], 4);
    bolan_gl_program_vec4_array(g, "cascade_parts", t->parts[0], 4);
    bolan_gl_program_float(g, "choppiness", (float)bolan_sea_get_desc(sea)->choppiness);
}

static void run_rows(const gl_program *g, const sea_tables *t, const bolan_sea *sea, const float *moments,
                     uint32_t count, uint32_t sets) {
    const uint32_t transforms = GROUP_VALUES / bolan_sea_cascade_layout(sea, 0).n;
    use(g, t, sea);
    bolan_gl_program_vec4_array(g, "moments", moments, count);
    bolan_gl_dispatch((t->most_rows + transforms - 1) / transforms, sets, t->count);
    bolan_gl_wait_for(GL_BARRIER_STORAGE);
}

static void run_columns(const gl_program *g, const sea_tables *t, const bolan_sea *sea, bolan_vec4 foam,
                        uint32_t sets) {
    const uint32_t n = bolan_sea_cascade_layout(sea, 0).n;
    use(g, t, sea);
    bolan_gl_program_vec4(g, "foam", foam);
    bolan_gl_dispatch(n * n / GROUP_VALUES, sets, t->count);
    bolan_gl_wait_for(GL_BARRIER_ALL);
}

// Brings the foam memory to the last tick; four ticks at a time, which two complex transforms hold.
static void run_ticks(const sea_programs *s, sea_tables *t, const bolan_sea *sea, const bolan_sea_clock *clock) {
    const bool goes_on =
        t->remembers && t->from == clock->foam_from && t->tick >= clock->first_tick && t->tick <= clock->tick;
    if (!goes_on) {
        t->tick = clock->first_tick;
        t->remembers = false;
    }
    t->from = clock->foam_from;
    while (t->tick < clock->tick) {
        float moments[TICKS][4] = {{0}}, drifts[TICKS * BOLAN_MAX_CASCADES][4] = {{0}};
        uint32_t count = 0;
        for (; count < TICKS && t->tick < clock->tick; ++count) {
            t->tick += 1.0;
            split_time(bolan_sea_tick_time(sea, t->tick), moments[count]);
            for (uint32_t c = 0; c < t->count; ++c)
                split_drift(sea, c, t->tick, drifts[BOLAN_MAX_CASCADES * count + c]);
        }
        const bolan_vec4 foam = {clock->tick_keep, clock->tick_lose, t->remembers ? 1.0f : 0.0f, (float)count};
        bolan_gl_program_use(&s->tick_rows);
        bolan_gl_program_vec4_array(&s->tick_rows, "tick_drifts", drifts[0], TICKS * BOLAN_MAX_CASCADES);
        run_rows(&s->tick_rows, t, sea, moments[0], TICKS, 1);
        run_columns(&s->tick_columns, t, sea, foam, 1);
        t->remembers = true;
    }
}

static void run_levels(const sea_compute *p, const gl_texture *image) {
    bolan_gl_texture_bind(image, UNIT_OWN);
    for (uint32_t from = 0; from + 1 < image->levels; from += LEVELS) {
        const uint32_t left = image->levels - 1 - from, count = left < LEVELS ? left : LEVELS;
        const uint32_t size = image->width >> from, tiles = size > TILE ? size / TILE : 1;
        bolan_gl_program_int(&p->levels, "from", (int)from);
        bolan_gl_program_int(&p->levels, "count", (int)count);
        for (uint32_t l = 0; l < LEVELS; ++l) bolan_gl_image_bind(image, from + 1 + (l < count ? l : count - 1), l);
        bolan_gl_dispatch(tiles, tiles, image->depth);
        bolan_gl_wait_for(GL_BARRIER_TEXTURES);
    }
}

static void run_law(const sea_compute *p, const sea_tables *t, const sea_images *images) {
    if (images->layout == SEA_LAYOUT_HOST) return;
    const gl_program *g = &p->law[images->layout];
    bolan_gl_program_vec2(g, "law", t->offset, t->variance);
    bolan_gl_program_vec4(g, "weights", t->weights);
    bolan_gl_texture_bind(images->layout == SEA_LAYOUT_PACKED ? images->slopes : images->third, UNIT_OWN);
    bolan_gl_storage_bind(&t->law, SLOT_LAW);
    bolan_gl_dispatch(1, 1, 1);
}

static void bind(const sea_compute *p, const sea_tables *t) {
    bolan_gl_storage_bind(&t->modes, SLOT_MODES);
    bolan_gl_storage_bind(&t->divisors, SLOT_DIVISORS);
    bolan_gl_storage_bind(&p->rows, SLOT_ROWS);
    bolan_gl_storage_bind(&t->memory, SLOT_MEMORY);
}

static void run_fields(sea_compute *p, const sea_programs *s, sea_tables *t, const bolan_sea *sea,
                       const bolan_sea_clock *clock, const sea_images *images, gl_timing timing) {
    const bool packed = images->layout == SEA_LAYOUT_PACKED;
    float moment[4];
    split_time(clock->shown, moment);
    bolan_gl_timer_begin(&p->timers[SEA_STAGE_ROWS], timing);
    run_rows(&s->rows, t, sea, moment, 1, 2);
    bolan_gl_timer_end(&p->timers[SEA_STAGE_ROWS], timing);
    bolan_gl_timer_begin(&p->timers[SEA_STAGE_COLUMNS], timing);
    bolan_gl_image_bind(images->displacement, 0, 0);
    bolan_gl_image_bind(images->slopes, 0, 1);
    if (!packed) bolan_gl_image_bind(images->third, 0, 2);
    const bolan_vec4 foam = {clock->keep, clock->lose, t->remembers ? 1.0f : 0.0f, 0.0f};
    float drifts[BOLAN_MAX_CASCADES][4] = {{0}};
    for (uint32_t c = 0; c < t->count; ++c) drift_samples(sea, c, clock->now, drifts[c]);
    bolan_gl_program_use(&s->columns[images->layout]);
    bolan_gl_program_vec4_array(&s->columns[images->layout], "drifted", drifts[0], BOLAN_MAX_CASCADES);
    run_columns(&s->columns[images->layout], t, sea, foam, packed ? 2 : 1);
    bolan_gl_timer_end(&p->timers[SEA_STAGE_COLUMNS], timing);
    bolan_gl_timer_begin(&p->timers[SEA_STAGE_LEVELS], timing);
    run_levels(p, images->displacement);
    run_levels(p, images->slopes);
    if (!packed) run_levels(p, images->third);
    run_law(p, t, images);
    bolan_gl_wait_for(GL_BARRIER_ALL);
    bolan_gl_timer_end(&p->timers[SEA_STAGE_LEVELS], timing);
}

// Texels of all levels, written once, and the memory of the foam, read once.
static uint64_t image_bytes(const sea_images *images) {
    const uint64_t texels =
        (uint64_t)images->displacement->width * images->displacement->width * images->displacement->depth;
    return texels * (images->layout == SEA_LAYOUT_PACKED ? 2 : 3) * 8 * 4 / 3 + texels * sizeof(float);
}

bool bolan_sea_compute_run(sea_compute *p, sea_tables *t, const bolan_sea *sea, const sea_images *images,
                           gl_timing timing) {
    const uint32_t n = bolan_sea_cascade_layout(sea, 0).n;
    const bolan_sea_clock clock = bolan_sea_get_clock(sea);
    if (!bolan_sea_compute_compile(p, n, images->layout)) return false;
    if (!fit_tables(t, sea) || !fit_rows(p, t, n)) return false;
    const sea_programs *s = programs_of(p, n);
    gl_compute_saved saved;
    bolan_gl_compute_begin(&saved);
    bind(p, t);
    bolan_gl_timer_begin(&p->timers[SEA_STAGE_TICKS], timing);
    run_ticks(s, t, sea, &clock);
    bolan_gl_timer_end(&p->timers[SEA_STAGE_TICKS], timing);
    run_fields(p, s, t, sea, &clock, images, timing);
    bolan_gl_compute_end(&saved);
    p->bytes = t->bytes + image_bytes(images);
    return true;
}

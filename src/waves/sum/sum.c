// SPDX-License-Identifier: MIT
// A sum through time, and what is read of it. The models COSINES and EXP_COSINE.
#include "waves/sum/sum.h"
#include "waves/sum/exp_cosine.h"

#include <string.h>

#define SUM_DECLARE(set) sum_fields_function bolan_sum_fields_##set;
SUM_DECLARE(scalar)
SUM_DECLARE(generic4)
#ifdef BOLAN_KERNELS_X86
SUM_DECLARE(avx2)
SUM_DECLARE(avx512)
#endif

enum { GRAIN_BLOCKS = 8 };

sum_fields_function *bolan_sum_fields_for(bolan_cpu cpu) {
    static sum_fields_function *const table[] = {
        [BOLAN_CPU_SCALAR] = bolan_sum_fields_scalar,
        [BOLAN_CPU_GENERIC4] = bolan_sum_fields_generic4,
#ifdef BOLAN_KERNELS_X86
        [BOLAN_CPU_AVX2] = bolan_sum_fields_avx2,
        [BOLAN_CPU_AVX512] = bolan_sum_fields_avx512,
#endif
    };
    const bolan_cpu best = bolan_cpu_best();
    return table[cpu == BOLAN_CPU_AUTO || cpu > best ? best : cpu];
}

static double fraction(double x) { return x - floor(x); }

// EXP_COSINE has one direction each, and so as many frequencies as waves.
static sum_cut cut_of(const bolan_sea_desc *d) {
    if (d->waves == BOLAN_WAVES_EXP_COSINE)
        return (sum_cut){true, d->exp_cosine.wave_count, 1, BOLAN_SPLIT_EQUAL_ENERGY};
    return (sum_cut){false, d->cosines.frequencies, d->cosines.directions, d->cosines.split};
}

static bool create(sea_shared *shared, const spectrum_eval *eval) {
    const sum_cut cut = cut_of(&shared->desc);
    return bolan_sum_create(shared, eval, &cut);
}

static void size(sea_shared *shared, const spectrum_eval *eval, bolan_sea_bytes *bytes) {
    (void)eval;
    const sum_cut cut = cut_of(&shared->desc);
    bytes->tables += bolan_sum_table_bytes(&cut);
    bytes->fields += sizeof(sum_tables) + (size_t)cut.lines * cut.directions * sizeof(sum_wave);
}

static bool create_fields(bolan_sea *sea) {
    const sum_tables *from = &sea_sum_of(sea->shared)->tables;
    sum_tables *t = sea->fields = bolan_sea_reserve(&sea->memory, sizeof *t);
    if (!t) return false;
    *t = *from;
    t->wave =
        bolan_sea_reserve(&sea->memory, t->capacity * sizeof *t->wave); // also in a calm: as bolan_sea_size() says
    if (t->wave) memcpy(t->wave, from->wave, t->count * sizeof *t->wave);
    return t->wave != NULL;
}

const sum_tables *bolan_sea_sum(const bolan_sea *sea) {
    bolan_sea_fields(sea);
    return sea->shared->model->form == BOLAN_FORM_CASCADES ? NULL : sea->fields;
}

// Only the phases turn; nothing is remembered.
static void step(const bolan_sea *sea, const sea_instant *instant) {
    const sea_sum *sum = sea_sum_of(sea->shared);
    sum_tables *t = sea->fields;
    for (uint32_t i = 0; i < t->count; i++) {
        const double start = sum->component[i].phase / (2.0 * BOLAN_PI);
        t->wave[i].base = fraction(start - fraction(sum->turns[i] * instant->shown)) + SUM_MAGIC;
    }
}

// ---- points ---------------------------------------------------------------------------------------------------------

typedef struct block {
    double x[SUM_LANES], y[SUM_LANES];
    float fade[SUM_LANES];
    float field[SEA_FIELDS][SUM_LANES];
} block;

typedef struct batch {
    const sum_tables *tables;
    sum_fields_function *fields;
    const sea_lift *lift;
    double choppiness;
    const bolan_dvec2 *points;
    const float *spacing; // or NULL
    uint32_t count;
    bolan_sea_sample *out;
} batch;

// Points [first, first + SUM_LANES); beyond the last, the last again.
static void load(const batch *b, uint32_t first, block *to) {
    for (uint32_t l = 0; l < SUM_LANES; l++) {
        const uint32_t i = first + l < b->count ? first + l : b->count - 1;
        to->x[l] = b->points[i].x;
        to->y[l] = b->points[i].y;
        to->fade[l] = b->spacing ? 0.5f / b->spacing[i] : 0.0f;
    }
}

static sea_sums lane_of(const block *b, uint32_t l, double choppiness, double lift) {
    const double dxx = b->field[FIELD_DXX][l], dyy = b->field[FIELD_DYY][l];
    const double pinch = -(dxx + dyy) * choppiness; // fmax(-0.0, 0.0) may be either zero
    return (sea_sums){.height = b->field[FIELD_HEIGHT][l] + lift,
                      .dx = b->field[FIELD_DX][l],
                      .dy = b->field[FIELD_DY][l],
                      .sx = b->field[FIELD_SLOPE_X][l],
                      .sy = b->field[FIELD_SLOPE_Y][l],
                      .dxx = dxx,
                      .dyy = dyy,
                      .dxy = b->field[FIELD_DXY][l],
                      .dyx = b->field[FIELD_DXY][l],
                      .foam = pinch > 0.0 ? pinch : 0.0};
}

// Task: blocks [begin, end).
static void sample_blocks(void *context, uint32_t begin, uint32_t end, uint32_t worker) {
    (void)worker;
    const batch *b = context;
    const double choppiness = b->choppiness;
    block k;
    for (uint32_t i = begin; i < end; i++) {
        const uint32_t first = i * SUM_LANES;
        load(b, first, &k);
        b->fields(b->tables, k.x, k.y, b->spacing ? k.fade : NULL, k.field);
        for (uint32_t l = 0; l < SUM_LANES && first + l < b->count; l++) {
            const double spacing = b->spacing ? (double)b->spacing[first + l] : 0.0;
            const sea_sums sums = lane_of(&k, l, choppiness, bolan_sea_lift_at(b->lift, spacing));
            b->out[first + l] = bolan_sea_displaced(&sums, choppiness);
        }
    }
}

static void sample_grid(const bolan_sea *sea, const bolan_dvec2 *points, const float *spacing, uint32_t count,
                        bolan_sea_sample *out) {
    const sea_shared *shared = sea->shared;
    batch b = {sum_tables_of(sea),
               bolan_sum_fields_for(shared->desc.cpu),
               &shared->band[0].lift,
               shared->desc.choppiness,
               points,
               spacing,
               count,
               out};
    const uint32_t blocks = count / SUM_LANES + (count % SUM_LANES != 0);
    if (blocks <= GRAIN_BLOCKS) {
        sample_blocks(&b, 0, blocks, 0); // not worth waking anybody
    } else {
        bolan_parallel(blocks, GRAIN_BLOCKS, sample_blocks, &b);
    }
}

static void sample_rest(const bolan_sea *sea, const bolan_dvec2 *points, uint32_t count, bolan_sea_sample *out) {
    sample_grid(sea, points, NULL, count, out);
}

static void sample_direct(const sea_shared *shared, bolan_dvec2 at, bolan_dvec2 drift, double shown, sea_sums *v) {
    (void)drift; // the frequencies of a sum are over the ground
    const sea_sum *sum = sea_sum_of(shared);
    const double s = shared->desc.exp_cosine.sharpness, mean = exp_cosine_mean(s);
    for (uint32_t i = 0; i < sum->tables.count; i++) {
        const bolan_sea_component *c = &sum->component[i];
        const double along = (c->kx * at.x + c->ky * at.y + c->phase) / (2.0 * BOLAN_PI);
        const double turns = fraction(fraction(along) - fraction(sum->turns[i] * shown));
        double sine, cosine;
        bolan_sincos(2.0 * BOLAN_PI * turns, &sine, &cosine);
        if (sum->tables.exponential) {
            const double scale = exp_cosine_scale(s), e = portable_exp(s * cosine);
            v->height += c->amplitude * scale * (e - mean);
            v->sx -= c->amplitude * scale * s * c->kx * sine * e;
            v->sy -= c->amplitude * scale * s * c->ky * sine * e;
            continue;
        }
        const double k = sqrt(c->kx * c->kx + c->ky * c->ky), ux = c->kx / k, uy = c->ky / k;
        v->height += c->amplitude * cosine;
        v->sx -= c->amplitude * c->kx * sine;
        v->sy -= c->amplitude * c->ky * sine;
        v->dx -= c->drift * ux * sine;
        v->dy -= c->drift * uy * sine;
        v->dxx -= c->drift * ux * c->kx * cosine;
        v->dyy -= c->drift * uy * c->ky * cosine;
        v->dxy -= c->drift * ux * c->ky * cosine;
        v->dyx = v->dxy;
    }
}

// ---- statistics -----------------------------------------------------------------------------------------------------

// A cosine as a mode: all its energy goes along k. The slope variance of exp(s cos) is more than k^2 times its
// variance, which slopes.c puts right by slope_ratio.
static void each_wave(const sea_shared *shared, sea_visit *visit, void *context) {
    const sea_sum *sum = sea_sum_of(shared);
    for (uint32_t i = 0; i < sum->tables.count; i++) {
        const bolan_sea_component *c = &sum->component[i];
        const sea_mode mode = {.kx = c->kx,
                               .ky = c->ky,
                               .turns = sum->turns[i],
                               .inverse_k = 1.0 / sqrt(c->kx * c->kx + c->ky * c->ky),
                               .re = 0.5 * c->amplitude,
                               .expected = sum->variance[i]};
        visit(context, &mode);
    }
}

static void slopes(const sea_shared *shared, double out[3]) { memcpy(out, sea_sum_of(shared)->slope, 3 * sizeof *out); }

// The sum of few waves may not even reach 6 standard deviations.
static void bounds(const sea_shared *shared, double *vertical, double *horizontal) {
    const sea_sum *sum = sea_sum_of(shared);
    *vertical = fmin(6.0 * sqrt(shared->band[0].variance), sum->highest) + shared->lift;
    *horizontal = fmin(6.0 * sqrt(sum->displacement), sum->farthest) * shared->desc.choppiness;
}

// Of few frequencies, each of which stands for its own width: the top of the parabola through three points that lie
// anyhow (Lagrange).
static double peak_period(const sea_shared *shared) {
    const sea_sum *sum = sea_sum_of(shared);
    if (sum->line_count == 0) return 0.0;
    const sum_line *l = sum->line;
    uint32_t top = 0;
    for (uint32_t i = 0; i < sum->line_count; i++)
        if (l[i].energy * l[top].width > l[top].energy * l[i].width) top = i;
    const double peak = 2.0 * BOLAN_PI / l[top].omega;
    if (top == 0 || top + 1 >= sum->line_count) return peak;
    const double x0 = l[top - 1].omega, x1 = l[top].omega, x2 = l[top + 1].omega;
    const double y0 = l[top - 1].energy / l[top - 1].width, y1 = l[top].energy / l[top].width,
                 y2 = l[top + 1].energy / l[top + 1].width;
    const double rise = (y1 - y0) / (x1 - x0), fall = (y2 - y1) / (x2 - x1);
    const double curve = (fall - rise) / (x2 - x0);
    return curve < 0.0 ? 2.0 * BOLAN_PI / (0.5 * (x0 + x1) - 0.5 * rise / curve) : peak;
}

// 50 of the longest waves.
static double side(const sea_shared *shared) {
    const sum_tables *t = &sea_sum_of(shared)->tables;
    return t->count > 0 ? 50.0 * (double)t->wave[0].length : 1.0;
}

enum { SUM_HASH_POINTS = 4096 };

// A sum has no planes: its fields at some of the places where it is measured.
static uint64_t hash_places(const bolan_sea *sea, uint64_t hash) {
    sum_fields_function *const fields = bolan_sum_fields_for(sea->shared->desc.cpu);
    for (uint32_t first = 0; first < SUM_HASH_POINTS; first += SUM_LANES) {
        double x[SUM_LANES], y[SUM_LANES];
        float field[SEA_FIELDS][SUM_LANES];
        for (uint32_t l = 0; l < SUM_LANES; l++) {
            const bolan_dvec2 place = bolan_sea_place(sea->shared, first + l);
            x[l] = place.x;
            y[l] = place.y;
        }
        fields(sum_tables_of(sea), x, y, NULL, field);
        for (int f = 0; f < SEA_FIELDS; f++) hash = bolan_sea_hash_plane(hash, field[f], SUM_LANES);
    }
    return hash;
}

static bolan_sea_component component(const sea_shared *shared, uint32_t index) {
    return sea_sum_of(shared)->component[index];
}

#define SUM_MODEL                                                                                         \
    .create = create, .size = size, .create_fields = create_fields, .shown_time = bolan_sea_reduced_time, \
    .step = step, .sample_rest = sample_rest, .sample_grid = sample_grid, .sample_direct = sample_direct, \
    .each_wave = each_wave, .slopes = slopes, .bounds = bounds, .peak_period = peak_period, .side = side, \
    .hash = hash_places, .component = component

const sea_model bolan_sea_model_cosines = {SUM_MODEL, .form = BOLAN_FORM_COSINES};
const sea_model bolan_sea_model_exp_cosine = {SUM_MODEL, .form = BOLAN_FORM_EXP_COSINES};

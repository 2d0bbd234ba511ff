// SPDX-License-Identifier: MIT
// A sum through time, and its fields at points.
#include "waves/sum.h"

#include "waves/exp_cosine.h"

#define SUM_DECLARE(set) sum_fields_function bolan_sum_fields_##set;
SUM_DECLARE(scalar)
#ifdef BOLAN_KERNELS_X86
SUM_DECLARE(sse2)
SUM_DECLARE(avx2)
SUM_DECLARE(avx512)
#endif

enum { GRAIN_BLOCKS = 8 };

sum_fields_function *bolan_sum_fields_for(bolan_cpu cpu) {
    static sum_fields_function *const table[] = {
        [BOLAN_CPU_SCALAR] = bolan_sum_fields_scalar,
#ifdef BOLAN_KERNELS_X86
        [BOLAN_CPU_SSE2] = bolan_sum_fields_sse2,
        [BOLAN_CPU_AVX2] = bolan_sum_fields_avx2,
        [BOLAN_CPU_AVX512] = bolan_sum_fields_avx512,
#endif
    };
    const bolan_cpu best = bolan_cpu_best();
    return table[cpu == BOLAN_CPU_AUTO || cpu > best ? best : cpu];
}

static double fraction(double x) { return x - floor(x); }

void bolan_sea_sum_step(bolan_sea *sea, double shown) {
    sea_sum *sum = sea->sum;
    for (uint32_t i = 0; i < sum->tables.count; i++) {
        const double start = sum->component[i].phase / (2.0 * BOLAN_PI);
        sum->tables.wave[i].base = fraction(start - fraction(sum->turns[i] * shown)) + SUM_MAGIC;
    }
}

// ---- points ---------------------------------------------------------------------------------------------------------

typedef struct block {
    double x[SUM_LANES], y[SUM_LANES];
    float fade[SUM_LANES];
    float field[SEA_FIELDS][SUM_LANES];
} block;

typedef struct batch {
    const bolan_sea *sea;
    sum_fields_function *fields;
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
                      .foam = pinch > 0.0 ? pinch : 0.0};
}

// Task: blocks [begin, end).
static void sample_blocks(void *context, uint32_t begin, uint32_t end, uint32_t worker) {
    (void)worker;
    const batch *b = context;
    const double choppiness = b->sea->desc.choppiness;
    block k;
    for (uint32_t i = begin; i < end; i++) {
        const uint32_t first = i * SUM_LANES;
        load(b, first, &k);
        b->fields(&b->sea->sum->tables, k.x, k.y, b->spacing ? k.fade : NULL, k.field);
        for (uint32_t l = 0; l < SUM_LANES && first + l < b->count; l++) {
            const double spacing = b->spacing ? (double)b->spacing[first + l] : 0.0;
            const sea_sums sums = lane_of(&k, l, choppiness, bolan_sea_lift_at(&b->sea->sum->lift, spacing));
            b->out[first + l] = bolan_sea_displaced(&sums, choppiness);
        }
    }
}

void bolan_sea_sum_sample(const bolan_sea *sea, const bolan_dvec2 *points, const float *spacing, uint32_t count,
                          bolan_sea_sample *out) {
    batch b = {sea, bolan_sum_fields_for(sea->desc.cpu), points, spacing, count, out};
    const uint32_t blocks = count / SUM_LANES + (count % SUM_LANES != 0);
    if (blocks <= GRAIN_BLOCKS) {
        sample_blocks(&b, 0, blocks, 0); // not worth waking anybody
    } else {
        bolan_parallel(blocks, GRAIN_BLOCKS, sample_blocks, &b);
    }
}

void bolan_sea_sum_direct(const bolan_sea *sea, double x, double y, double shown, sea_sums *v) {
    const sea_sum *sum = sea->sum;
    const double s = sea->desc.exp_cosine.sharpness, mean = exp_cosine_mean(s);
    for (uint32_t i = 0; i < sum->tables.count; i++) {
        const bolan_sea_component *c = &sum->component[i];
        const double along = (c->kx * x + c->ky * y + c->phase) / (2.0 * BOLAN_PI);
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
    }
}

// ---- statistics -----------------------------------------------------------------------------------------------------

// A cosine as a mode: all its energy goes along k. The slope variance of exp(s cos) is more than k^2 times its variance, which
// slopes.c puts right by slope_ratio.
void bolan_sea_sum_each(const sea_sum *sum, void (*visit)(void *context, const sea_mode *mode), void *context) {
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

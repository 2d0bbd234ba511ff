// SPDX-License-Identifier: MIT
// The waves of a sum: each frequency of lines.c goes in several directions,
//
//     eta(x, t) = sum_i sum_j sqrt(2 S(w_i, th_j) dw_i dth_j) cos(k_ij . x - w_i t + eps_ij)
//
// (Liu, Xu & Chen 2009; without the root the variance would be 20 times too small). The one spreading cos^2 gets N
// mid-points of +-90 degrees, by which sum cos^2 dth is exact; any other spectrum N parts of equal energy at that
// frequency, each represented by a direction inside it that advances from frequency to frequency by the golden section,
// so that no two frequencies have the same directions. EXP_COSINE takes its few waves in the same way with one
// direction for each frequency.
#include "spectrum/portable.h"
#include "waves/sum/exp_cosine.h"
#include "waves/sum/sum.h"

enum { ANGLES = 360 };
#define GOLDEN 0.61803398874989485

// ---- directions -----------------------------------------------------------------------------------------------------

typedef struct fan {
    uint32_t count;
    double angle[BOLAN_MAX_DIRECTIONS], share[BOLAN_MAX_DIRECTIONS];
} fan;

// One wind sea whose spreading ends at +-90 degrees.
static bool is_cos2(const spectrum_eval *eval) {
    return eval->system_count == 1 && !eval->measured && !eval->on_current &&
           eval->systems[0].spreading == BOLAN_SPREADING_COS2;
}

static void fan_cos2(const spectrum_eval *eval, double omega, uint32_t count, fan *out) {
    const spectrum_system *system = &eval->systems[0];
    const double mean = portable_angle(system->to_y, system->to_x);
    double sum = 0.0, s, c;
    for (uint32_t j = 0; j < count; j++) {
        const double from_mean = ((j + 0.5) / count - 0.5) * BOLAN_PI;
        bolan_sincos(from_mean, &s, &c);
        out->angle[j] = mean + from_mean;
        out->share[j] = bolan_spectrum_system_spreading(system, omega, c);
        sum += out->share[j];
    }
    for (uint32_t j = 0; j < count; j++) out->share[j] /= sum;
}

// Parts of equal energy, counted from the direction against the mean; `offset` 0..1 is where in a part its wave runs.
static void fan_equal_energy(const spectrum_eval *eval, double omega, uint32_t count, double offset, fan *out) {
    double density[ANGLES], sine = 0.0, cosine = 0.0, total = 0.0, below = 0.0;
    for (int a = 0; a < ANGLES; a++) {
        double s, c;
        bolan_sincos(2.0 * BOLAN_PI * a / ANGLES, &s, &c);
        density[a] = bolan_spectrum_eval_density(eval, omega, c, s);
        sine += density[a] * s;
        cosine += density[a] * c;
        total += density[a];
    }
    const int mean = (int)(portable_angle(sine, cosine) / (2.0 * BOLAN_PI) * ANGLES + 0.5);
    const int first = mean + ANGLES / 2;
    uint32_t j = 0;
    for (int a = 0; a < ANGLES && j < count; a++) {
        const double here = density[(first + a) % ANGLES];
        for (; j < count && (j + offset) / count * total <= below + here; j++) {
            const double part = here > 0.0 ? ((j + offset) / count * total - below) / here : 0.5;
            out->angle[j] = (first + a + part - 0.5) * 2.0 * BOLAN_PI / ANGLES;
            out->share[j] = 1.0 / count;
        }
        below += here;
    }
    for (; j < count; j++) { // rounding may leave the last ones open
        out->angle[j] = mean * 2.0 * BOLAN_PI / ANGLES;
        out->share[j] = 1.0 / count;
    }
}

static double fraction(double x) { return x - floor(x); }

static void fan_of(const sea_sum *sum, const spectrum_eval *eval, uint32_t line, uint32_t count, fan *out) {
    const double omega = sum->line[line].omega;
    const bool exponential = sum->tables.exponential;
    out->count = count;
    if (is_cos2(eval) && !exponential) {
        fan_cos2(eval, omega, count, out);
    } else {
        const double offset = count > 1 || exponential ? fraction(0.5 + GOLDEN * line) : 0.5;
        fan_equal_energy(eval, omega, count, offset, out);
    }
}

// ---- waves ----------------------------------------------------------------------------------------------------------

static double phase_of(uint64_t seed, uint32_t i, uint32_t j) {
    const uint64_t bits = bolan_sea_mix(bolan_sea_mix(seed ^ 0x9d5c0ffee5eau) ^ bolan_sea_mix((uint64_t)i << 32 | j));
    return (double)(bits >> 11) * (2.0 * BOLAN_PI * 0x1p-53);
}

// Frequency over the ground: the waves ride on the current (Doppler). With a loop, the nearest multiple of 1 / period.
static double turns_of(const bolan_sea_desc *d, double omega, double kx, double ky) {
    const double turns = (omega + kx * d->sea_state.current_x + ky * d->sea_state.current_y) / (2.0 * BOLAN_PI);
    if (d->loop_period == 0.0) return turns;
    const double whole = floor(fabs(turns) * d->loop_period + 0.5);
    return (turns < 0.0 ? -1.0 : 1.0) * fmax(whole, 1.0) / d->loop_period;
}

// Amplitude a of a wave whose variance is `energy`: a^2 / 2 for a cosine.
static double amplitude_of(const sea_sum *sum, double s, double energy) {
    if (!sum->tables.exponential) return sqrt(2.0 * energy);
    return sqrt(energy / exp_cosine_variance(s)) / exp_cosine_scale(s);
}

static void set_wave(const sea_shared *shared, sea_sum *sum, double omega, double angle, double energy, double phase) {
    const uint32_t at = sum->tables.count++;
    const double depth = shared->desc.sea_state.depth, k = bolan_k_from_omega(omega, depth);
    bolan_sea_component *c = &sum->component[at];
    double sine, cosine;
    bolan_sincos(angle, &sine, &cosine);
    c->kx = k * cosine;
    c->ky = k * sine;
    sum->turns[at] = turns_of(&shared->desc, omega, c->kx, c->ky);
    c->omega = 2.0 * BOLAN_PI * sum->turns[at];
    c->phase = phase;
    c->amplitude = amplitude_of(sum, shared->desc.exp_cosine.sharpness, energy);
    c->drift = sum->tables.exponential ? 0.0 : c->amplitude / portable_tanh(k * depth);
    sum->variance[at] = energy;
}

// The mean direction of few waves is off by some degrees. Turns all waves to the mean direction of the sea state. Where
// the sea state has hardly a mean direction (waves from all sides), the waves stay as they are.
static void align(const sea_shared *shared, fan *fans) {
    const sea_sum *sum = sea_sum_of(shared);
    double x = 0.0, y = 0.0, s, c;
    for (uint32_t i = 0; i < sum->line_count; i++) {
        for (uint32_t j = 0; j < fans[i].count; j++) {
            bolan_sincos(fans[i].angle[j], &s, &c);
            x += sum->line[i].energy * fans[i].share[j] * c;
            y += sum->line[i].energy * fans[i].share[j] * s;
        }
    }
    bolan_sincos(bolan_compass_from_to_math(shared->summary.from_deg), &s, &c);
    const double along = x * c + y * s, across = y * c - x * s; // of the mean, from the direction asked for
    if (along < 2.0 * fabs(across)) return;
    const double turn = portable_angle(across, along);
    for (uint32_t i = 0; i < sum->line_count; i++) {
        for (uint32_t j = 0; j < fans[i].count; j++) fans[i].angle[j] -= turn;
    }
}

// Lines ascend in frequency, so the waves descend in length.
static void set_waves(const sea_shared *shared, const spectrum_eval *eval, uint32_t directions, fan *fans) {
    sea_sum *sum = shared->tables;
    for (uint32_t i = 0; i < sum->line_count; i++) fan_of(sum, eval, i, directions, &fans[i]);
    if (!is_cos2(eval) || sum->tables.exponential) align(shared, fans);
    for (uint32_t i = 0; i < sum->line_count; i++) {
        for (uint32_t j = 0; j < directions; j++) {
            const double energy = sum->line[i].energy * fans[i].share[j];
            if (energy > 1e-24) // less than a picometre
                set_wave(shared, sum, sum->line[i].omega, fans[i].angle[j], energy, phase_of(shared->desc.seed, i, j));
        }
    }
}

static void set_cosine_factors(const bolan_sea_component *c, float *factor) {
    const double k = sqrt(c->kx * c->kx + c->ky * c->ky), x = c->kx / k, y = c->ky / k;
    factor[FIELD_HEIGHT] = (float)c->amplitude;
    factor[FIELD_DX] = (float)(-c->drift * x);
    factor[FIELD_DY] = (float)(-c->drift * y);
    factor[FIELD_SLOPE_X] = (float)(-c->amplitude * c->kx);
    factor[FIELD_SLOPE_Y] = (float)(-c->amplitude * c->ky);
    factor[FIELD_DXX] = (float)(-c->drift * x * c->kx);
    factor[FIELD_DYY] = (float)(-c->drift * y * c->ky);
    factor[FIELD_DXY] = (float)(-c->drift * x * c->ky);
}

static void set_exponential_factors(const bolan_sea_component *c, double sharpness, float *factor) {
    const double height = c->amplitude * exp_cosine_scale(sharpness);
    factor[FIELD_HEIGHT] = (float)height;
    factor[FIELD_SLOPE_X] = (float)(-height * sharpness * c->kx);
    factor[FIELD_SLOPE_Y] = (float)(-height * sharpness * c->ky);
}

static void set_tables(sea_shared *shared) {
    sea_sum *sum = shared->tables;
    const double s = shared->desc.exp_cosine.sharpness;
    sum->tables.sharpness_8th = (float)(s / 8.0);
    sum->tables.mean = (float)exp_cosine_mean(s);
    // The crest of (1) is 2 - (1 - e^{-2s}) of the trough to its mean: larger than the trough's depth.
    const double crest = sum->tables.exponential ? exp_cosine_scale(s) * (portable_exp(s) - exp_cosine_mean(s)) : 1.0;
    if (sum->tables.exponential) shared->slope_ratio = exp_cosine_slope_variance(s) / exp_cosine_variance(s);
    for (uint32_t i = 0; i < sum->tables.count; i++) {
        const bolan_sea_component *c = &sum->component[i];
        sum_wave *w = &sum->tables.wave[i];
        w->tx = c->kx / (2.0 * BOLAN_PI);
        w->ty = c->ky / (2.0 * BOLAN_PI);
        w->length = (float)(1.0 / sqrt(w->tx * w->tx + w->ty * w->ty));
        if (sum->tables.exponential) {
            set_exponential_factors(c, s, w->factor);
        } else {
            set_cosine_factors(c, w->factor);
        }
        const double slope = sum->variance[i] * shared->slope_ratio;
        sum->slope[0] += slope * c->kx * c->kx;
        sum->slope[1] += slope * c->kx * c->ky;
        sum->slope[2] += slope * c->ky * c->ky;
        sum->displacement += 0.5 * c->drift * c->drift;
        shared->band[0].variance += sum->variance[i];
        sum->highest += c->amplitude * crest;
        sum->farthest += c->drift;
    }
}

// ---- lift -----------------------------------------------------------------------------------------------------------

// The share of a wave's amplitude that a grid keeps; twin of faded() in fields.kernel.c.
static double faded(double length, double spacing) {
    const double t = spacing > 0.0 ? 0.5 * length / spacing - 1.0 : 1.0, u = fmin(fmax(t, 0.0), 1.0);
    return u * u * (3.0 - 2.0 * u);
}

static void set_lift(sea_shared *shared) {
    const sea_sum *sum = sea_sum_of(shared);
    sea_lift *lift = &shared->band[0].lift;
    if (sum->tables.count == 0) return;
    lift->finest = LIFT_FIRST_LEVEL * (double)sum->tables.wave[sum->tables.count - 1].length;
    for (uint32_t i = 0; i < sum->tables.count; i++) {
        const bolan_sea_component *c = &sum->component[i];
        const double k = sqrt(c->kx * c->kx + c->ky * c->ky),
                     whole = 0.5 * shared->desc.choppiness * c->amplitude * c->drift * k;
        for (int l = 0; l < LIFT_LEVELS; l++) {
            const double keep = faded(2.0 * BOLAN_PI / k, bolan_sea_lift_spacing(lift, l));
            lift->level[l] += whole * keep * keep;
        }
    }
}

// ---- all of it ------------------------------------------------------------------------------------------------------

static size_t waves_bytes(uint32_t count) {
    return count * (sizeof(sum_wave) + sizeof(bolan_sea_component) + 2 * sizeof(double));
}

size_t bolan_sum_table_bytes(const sum_cut *cut) {
    return sizeof(sea_sum) + waves_bytes(cut->lines * cut->directions);
}

static bool reserve_waves(sea_memory *memory, uint32_t count, sea_sum *sum) {
    char *next = bolan_sea_reserve(memory, waves_bytes(count));
    if (!next) return false;
    sum->tables.capacity = count;
    sum->tables.wave = (sum_wave *)(void *)next;
    sum->component = (bolan_sea_component *)(void *)(sum->tables.wave + count);
    sum->turns = (double *)(void *)(sum->component + count);
    sum->variance = sum->turns + count;
    return true;
}

bool bolan_sum_create(sea_shared *shared, const spectrum_eval *eval, const sum_cut *cut) {
    const size_t bytes = SUM_MAX_LINES * sizeof(fan);
    sea_sum *sum = shared->tables = bolan_sea_reserve(&shared->memory, sizeof *sum);
    if (!sum || !reserve_waves(&shared->memory, cut->lines * cut->directions, sum)) return false;
    sum->tables.exponential = cut->exponential;
    if (!bolan_sum_set_lines(eval, cut->lines, cut->split, sum)) return false;
    fan *fans = bolan_sea_borrow(bytes);
    if (!fans) return false;
    shared->bands = 1;
    set_waves(shared, eval, cut->directions, fans);
    shared->components = sum->tables.count;
    set_tables(shared);
    set_lift(shared);
    bolan_release(fans, bytes);
    return true;
}

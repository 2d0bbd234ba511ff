// SPDX-License-Identifier: MIT
// The frequencies of a sum: any spectrum is cut by its cumulative energy. For Pierson-Moskowitz, where the share
// exp(-B / w^4) of the energy lies below w (Liu, Xu & Chen 2009), the cuts are
//
//     equal energy   w_i = (B / ln(2M / (2i - 1)))^(1/4), the middle of M equal parts: one amplitude for all,
//     equal width    w_i in the middle of M equal steps from (-B / ln mu)^(1/4) to (-B / ln(1 - mu))^(1/4), mu = .002,
//                    energy by S(w_i), scaled so that the sum holds the 1 - 2 mu of the spectrum that lies between.
#include "spectrum/portable.h"
#include "waves/sum/sum.h"

enum { NODES = 4096 };
#define LOWEST 0.02 // [rad/s]
#define HIGHEST 1e3 // [rad/s] 20 times the highest peak
#define MU 0.002    // energy beyond either end of the equal-width split

typedef struct running {
    double omega[NODES], energy[NODES]; // energy of the waves slower than omega [m2]
} running;

static void accumulate(const spectrum_eval *eval, running *out) {
    const double step = portable_log(HIGHEST / LOWEST) / (NODES - 1);
    double previous = 0.0;
    for (int i = 0; i < NODES; i++) {
        const double omega = LOWEST * portable_exp(step * i);
        const double density = bolan_spectrum_eval_omnidirectional(eval, omega) * omega; // per unit of log w
        out->omega[i] = omega;
        out->energy[i] = i > 0 ? out->energy[i - 1] + 0.5 * (previous + density) * step : 0.0;
        previous = density;
    }
}

// The frequency below which a share of the energy lies.
static double quantile(const running *r, double share) {
    const double wanted = share * r->energy[NODES - 1];
    int low = 0, high = NODES - 1;
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        *(r->energy[middle] < wanted ? &low : &high) = middle;
    }
    const double rise = r->energy[high] - r->energy[low];
    const double part = rise > 0.0 ? (wanted - r->energy[low]) / rise : 0.0;
    return r->omega[low] + (r->omega[high] - r->omega[low]) * part;
}

static void split_equal_energy(const running *r, uint32_t count, sea_sum *out) {
    for (uint32_t i = 0; i < count; i++) {
        const double low = fmax(i, MU * count) / count, high = fmin(i + 1.0, (1.0 - MU) * count) / count;
        out->line[i] = (sum_line){.omega = quantile(r, (i + 0.5) / count),
                                  .energy = r->energy[NODES - 1] / count,
                                  .width = quantile(r, high) - quantile(r, low)};
    }
}

static void split_equal_width(const running *r, const spectrum_eval *eval, uint32_t count, sea_sum *out) {
    const double first = quantile(r, MU), step = (quantile(r, 1.0 - MU) - first) / count;
    double sum = 0.0;
    for (uint32_t i = 0; i < count; i++) {
        const double omega = first + (i + 0.5) * step;
        out->line[i] = (sum_line){omega, bolan_spectrum_eval_omnidirectional(eval, omega) * step, step};
        sum += out->line[i].energy;
    }
    const double scale = sum > 0.0 ? r->energy[NODES - 1] * (1.0 - 2.0 * MU) / sum : 0.0;
    for (uint32_t i = 0; i < count; i++) out->line[i].energy *= scale;
}

bool bolan_sum_set_lines(const spectrum_eval *eval, uint32_t count, bolan_frequency_split split, sea_sum *out) {
    running *r = bolan_sea_borrow(sizeof *r);
    if (!r) return false;
    accumulate(eval, r);
    if (r->energy[NODES - 1] > 0.0) { // else a flat calm
        out->line_count = count;
        if (split == BOLAN_SPLIT_EQUAL_ENERGY) {
            split_equal_energy(r, count, out);
        } else {
            split_equal_width(r, eval, count, out);
        }
    }
    bolan_release(r, sizeof *r);
    return true;
}

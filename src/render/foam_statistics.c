// SPDX-License-Identifier: MIT
// See foam_statistics.h.
#include "foam_statistics.h"

#include <math.h>

double bolan_foam_quantile(double p) {
    double low = -8.0, high = 8.0;
    for (int i = 0; i < 50; ++i) {
        double middle = 0.5 * (low + high);
        if (0.5 * erfc(-middle * 0.70710678118654752) < p)
            low = middle;
        else
            high = middle;
    }
    return 0.5 * (low + high);
}

// Mean and variance of the summed foam memory, from a sparse lattice of each cascade.
static void memory_moments(const bolan_sea *sea, double *mean, double *variance) {
    *mean = *variance = 0.0;
    for (uint32_t c = 0; c < bolan_sea_cascade_count(sea); ++c) {
        bolan_cascade_view v = bolan_sea_cascade(sea, c);
        double sum = 0.0, squares = 0.0;
        uint32_t count = 0, size = v.n * v.n;
        for (uint32_t i = 0; i < size; i += 61, ++count) { // 61 is prime to every n
            sum += v.foam[i];
            squares += (double)v.foam[i] * v.foam[i];
        }
        *mean += sum / count;
        *variance += squares / count - (sum / count) * (sum / count);
    }
}

double bolan_foam_slope_variance(const bolan_sea *sea) {
    double mss = 0.0;
    for (uint32_t c = 0; c < bolan_sea_cascade_count(sea); ++c) mss += bolan_sea_cascade(sea, c).mss;
    for (uint32_t i = 0; i < bolan_sea_component_count(sea); ++i) {
        const bolan_sea_component w = bolan_sea_get_component(sea, i);
        mss += 0.5 * w.amplitude * w.amplitude * (w.kx * w.kx + w.ky * w.ky);
    }
    return mss;
}

double bolan_foam_memory_threshold(const bolan_sea *sea, double share, double softness, double *variance) {
    double mean;
    memory_moments(sea, &mean, variance);
    return share > 0.0 && *variance > 0.0 ? mean - bolan_foam_quantile(share) * sqrt(*variance * (1.0 + softness))
                                          : FOAM_NEVER;
}

double bolan_foam_breaking_pinch(const bolan_sea *sea, double edge, double *spread) {
    const bolan_sea_desc *desc = bolan_sea_get_desc(sea);
    const double cover = bolan_monahan_cover(desc->sea_state.wind_speed);
    *spread = fmax(desc->choppiness * desc->choppiness * bolan_foam_slope_variance(sea), 1e-9);
    return cover > 1e-7 ? bolan_foam_quantile(cover) * sqrt(*spread + edge * edge) : -FOAM_NEVER;
}

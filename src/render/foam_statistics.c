// SPDX-License-Identifier: MIT
// See foam_statistics.h.
#include "foam_statistics.h"
#include "frame.h"
#include "shared/foam.glsl"

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

// Whitecaps travel at 0.3 to 0.8 of the phase speed of the dominant waves (Gemmrich, Banner & Garrett 2008), so their
// waves are longer than about 1/8 of the dominant length. The memories of cascades of shorter waves fade.
#define WHITECAP_WAVES 8.0

static double weight_of(const bolan_sea *sea, uint32_t c) {
    if (c >= bolan_sea_cascade_count(sea)) return 0.0;
    const bolan_cascade_view v = bolan_sea_cascade_layout(sea, c);
    const double longest = v.k_min > 0.0 ? 2.0 * BOLAN_PI / v.k_min : v.length;
    return fmin(WHITECAP_WAVES * longest / fmax(bolan_sea_peak_length(bolan_sea_get_summary(sea)), 1e-6), 1.0);
}

bolan_vec4 bolan_foam_weights(const bolan_sea *sea) {
    return (bolan_vec4){(float)weight_of(sea, 0), (float)weight_of(sea, 1), (float)weight_of(sea, 2),
                        (float)weight_of(sea, 3)};
}

// Mean and variance of the weighted sum of the foam memories, from a sparse lattice of each cascade.
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
        const double weight = weight_of(sea, c);
        *mean += weight * sum / count;
        *variance += weight * weight * (squares / count - (sum / count) * (sum / count));
    }
}

double bolan_foam_slope_variance(const bolan_sea *sea) {
    double mss = 0.0;
    for (uint32_t c = 0; c < bolan_sea_cascade_count(sea); ++c) mss += bolan_sea_cascade_layout(sea, c).mss;
    for (uint32_t i = 0; i < bolan_sea_component_count(sea); ++i) {
        const bolan_sea_component w = bolan_sea_get_component(sea, i);
        mss += 0.5 * w.amplitude * w.amplitude * (w.kx * w.kx + w.ky * w.ky);
    }
    return mss;
}

static double cover_of(const bolan_sea *sea) {
    return bolan_monahan_cover(bolan_sea_get_desc(sea)->sea_state.wind_speed);
}

static double old_share_of(const bolan_sea *sea) {
    const double wind = bolan_sea_get_desc(sea)->sea_state.wind_speed;
    return old_foam_share(bolan_breaker_cover(wind), bolan_callaghan_cover(wind));
}

// Where old foam of that share begins [standard deviations of the memory over its mean].
static double memory_offset(double share) { return memory_quantile(-bolan_foam_quantile(share)); }

static double jacobian_variance(const bolan_sea *sea) {
    return fmax(jacobian_variance_of(bolan_foam_slope_variance(sea), bolan_sea_get_desc(sea)->choppiness), 1e-9);
}

double bolan_foam_breaking_edge(const bolan_sea *sea) { return sqrt(FRESH_FOAM_EDGE * jacobian_variance(sea)); }

// Threshold of old foam; FOAM_NEVER in a calm, and where there is no memory.
static double memory_threshold(double share, double mean, double variance) {
    if (!(share > 0.0) || !(variance > 0.0)) return FOAM_NEVER;
    return mean + softened_offset(memory_offset(share) * sqrt(variance), variance, OLD_FOAM_EDGE * variance);
}

void bolan_foam_law_constants(const bolan_sea *sea, float *offset, float *variance) {
    const double share = old_share_of(sea);
    *offset = (float)(share > 0.0 ? memory_offset(share) : FOAM_NEVER);
    *variance = (float)jacobian_variance(sea);
}

// The breaking threshold less 1, softened by a noise of that variance. Low Jacobians are rarer than a Gaussian's, but
// those of the noise are not, so that its part goes by the quantile of the share that breaks.
static double breaking_offset(const bolan_sea *sea, double edge) {
    const double wind = bolan_sea_get_desc(sea)->sea_state.wind_speed, offset = bolan_sea_breaker_threshold(sea) - 1.0;
    const bool remembers = bolan_sea_cascade_count(sea) > 0;
    const double share = remembers ? bolan_breaker_cover(wind) : bolan_callaghan_cover(wind);
    if (!(offset > -1e29 && offset < 0.0 && share > 0.0)) return offset;
    const double deviations = bolan_foam_quantile(share);
    return -sqrt(offset * offset + edge * deviations * deviations);
}

bool bolan_foam_can_form(const bolan_sea *sea) {
    return bolan_sea_breaker_threshold(sea) - 1.0 > -FOAM_NEVER || old_share_of(sea) > 0.0;
}

double bolan_foam_streak_share(const bolan_sea *sea) {
    const bool breaks = bolan_sea_breaker_threshold(sea) > -FOAM_NEVER;
    return breaks ? streak_share(bolan_sea_get_desc(sea)->sea_state.wind_speed) : 0.0;
}

foam_law bolan_foam_law(const bolan_sea *sea, double edge, bool memory) {
    const double cover = cover_of(sea), spread = jacobian_variance(sea);
    double mean = 0.0, variance = 0.0;
    float rest[3];
    if (memory) memory_moments(sea, &mean, &variance);
    bolan_sea_unresolved_slopes(sea, 0.0, 0.0, 0.0, rest);
    const double measured = breaking_offset(sea, edge * edge);
    const double gaussian = softened_offset(bolan_foam_quantile(cover) * sqrt(spread), spread, edge * edge);
    return (foam_law){.breaking = fmax(measured, -1e30),
                      .breaking_gaussian = cover > 1e-7 ? gaussian : -FOAM_NEVER,
                      .variance = spread,
                      .edge = edge * edge,
                      .slopes_beyond = (double)rest[0] + (double)rest[2],
                      .memory = memory_threshold(old_share_of(sea), mean, variance),
                      .memory_variance = variance};
}

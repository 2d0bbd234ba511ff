// SPDX-License-Identifier: MIT
// Statistics of the surface at the present time, of the realised amplitudes, and of the discrete spectrum.
#include "spectrum/portable.h"
#include "waves/model.h"

// Additive recurrence by the plastic number (Roberts 2018): even in the plane, without a lattice that waves could be
// in phase with.
bolan_dvec2 bolan_sea_place(const sea_shared *shared, uint32_t index) {
    const double side = shared->model->side(shared);
    const double x = index * 0.75487766624669276, y = index * 0.56984029099805327;
    return (bolan_dvec2){side * (x - floor(x)), side * (y - floor(y))};
}

void bolan_sea_sample_places(const bolan_sea *sea, uint32_t first, bolan_sea_sample out[SEA_PLACES]) {
    bolan_dvec2 place[SEA_PLACES];
    for (uint32_t i = 0; i < SEA_PLACES; i++) place[i] = bolan_sea_place(sea->shared, first + i);
    bolan_sea_sample_rest(sea, place, SEA_PLACES, out);
}

// ---- fields ---------------------------------------------------------------------------------------------------------

// At fixed world points a parcel counts by the area it covers, the Jacobian; folded parcels lie under others.
typedef struct moments {
    double weight, first, second, third, fourth;
    double slope[3];
} moments;

static void add_moment(moments *m, const bolan_sea_sample *v) {
    const double height = v->height, h2 = height * height, weight = fmax(v->jacobian, 0.0);
    const double sx = v->slope_x, sy = v->slope_y;
    m->weight += weight;
    m->first += weight * height;
    m->second += weight * h2;
    m->third += weight * h2 * height;
    m->fourth += weight * h2 * h2;
    m->slope[0] += weight * sx * sx;
    m->slope[1] += weight * sx * sy;
    m->slope[2] += weight * sy * sy;
}

static void set_shape(const moments *m, bolan_sea_statistics *out) {
    const double a = m->first / m->weight, b = m->second / m->weight, c = m->third / m->weight,
                 d = m->fourth / m->weight;
    const double variance = b - a * a;
    out->mean_level = a;
    if (!(variance > 0.0)) return;
    out->m0_field = variance;
    out->hs = 4.0 * sqrt(variance);
    out->skewness = (c - 3.0 * a * b + 2.0 * a * a * a) / (variance * sqrt(variance));
    out->kurtosis = (d - 4.0 * a * c + 6.0 * a * a * b - 3.0 * a * a * a * a) / (variance * variance);
}

static void set_slopes(const bolan_sea *sea, const moments *m, bolan_sea_statistics *out) {
    double s, c;
    const bolan_sea_state *state = &sea->shared->desc.sea_state;
    const double from = state->wind_speed > 0.0 ? state->wind_from_deg : out->direction_from;
    bolan_sincos(bolan_compass_from_to_math(from), &s, &c);
    const double xx = m->slope[0] / m->weight, xy = m->slope[1] / m->weight, yy = m->slope[2] / m->weight;
    out->mss = xx + yy;
    out->mss_up = c * c * xx + 2.0 * c * s * xy + s * s * yy;
    out->mss_cross = out->mss - out->mss_up;
}

static void measure_places(const bolan_sea *sea, bolan_sea_statistics *out) {
    moments m = {0};
    double lowest = 1e30, covered = 0.0, jacobians = 0.0;
    bolan_sea_sample sample[SEA_PLACES];
    for (uint32_t first = 0; first < SEA_MEASURED; first += SEA_PLACES) {
        bolan_sea_sample_places(sea, first, sample);
        for (uint32_t i = 0; i < SEA_PLACES; i++) {
            const double jacobian = sample[i].jacobian;
            lowest = fmin(lowest, jacobian);
            covered += jacobian < sea->shared->foam_threshold ? 1.0 : 0.0;
            jacobians += jacobian;
            add_moment(&m, &sample[i]);
        }
    }
    out->jacobian_min = lowest;
    out->jacobian_mean = jacobians / SEA_MEASURED;
    out->whitecap_fraction = covered / SEA_MEASURED;
    set_shape(&m, out);
    set_slopes(sea, &m, out);
}

// ---- modes ----------------------------------------------------------------------------------------------------------

enum { PERIOD_BINS = 160 }; // of 5 % in frequency, from 0.01 rad/s: 0.05 wp is narrower than any peak of JONSWAP
#define BIN_RATIO 1.05
#define LOWEST_OMEGA 0.01

typedef struct spectrum_sums {
    double current_x, current_y; // that the tables of turns leave out [m/s]
    double m0, m1_inverse, m2;   // expected moments over w, over the ground
    double energy, cosine, sine; // realised |h0|^2 by direction
    double bin[PERIOD_BINS];     // expected variance by log w, in the water
} spectrum_sums;

static void add_wave(spectrum_sums *s, double in_water, double expected, double realised, double kx, double ky) {
    const double k = sqrt(kx * kx + ky * ky), bin = portable_log(in_water / LOWEST_OMEGA) / portable_log(BIN_RATIO);
    const double shift = kx * s->current_x + ky * s->current_y;
    const double omega = shift != 0.0 ? fmax(fabs(in_water + shift), LOWEST_OMEGA) : in_water;
    s->m0 += expected;
    s->m1_inverse += expected / omega;
    s->m2 += expected * omega * omega;
    s->energy += realised;
    s->cosine += realised * kx / k;
    s->sine += realised * ky / k;
    s->bin[(int)fmin(fmax(bin, 0.0), PERIOD_BINS - 1.0)] += expected;
}

static void sum_mode(void *context, const sea_mode *m) {
    const double omega = 2.0 * BOLAN_PI * fabs(m->turns); // < 0 where a current carries a wave back
    add_wave(context, omega, m->expected, m->re * m->re + m->im * m->im, m->kx, m->ky);
    if (!m->paired) return;
    add_wave(context, omega, m->expected_back, m->back_re * m->back_re + m->back_im * m->back_im, -m->kx, -m->ky);
}

// The highest of S(w) = variance / width of the bin: the top of the parabola through three bins.
static double peak_of_bins(const double *bin) {
    double density[PERIOD_BINS];
    int top = 1;
    for (int i = 0; i < PERIOD_BINS; i++) density[i] = bin[i] / portable_pow(BIN_RATIO, i);
    for (int i = 1; i < PERIOD_BINS - 1; i++)
        if (density[i] > density[top]) top = i;
    const double a = density[top - 1], b = density[top], c = density[top + 1], curve = a - 2.0 * b + c;
    const double shift = curve < 0.0 ? 0.5 * (a - c) / curve : 0.0;
    return 2.0 * BOLAN_PI / (LOWEST_OMEGA * portable_pow(BIN_RATIO, top + 0.5 + shift));
}

// A measured spectrum has no energy above its last frequency; the sea adds the tail. The integrals are
// therefore those of the file over its own frequencies, like m0_spectrum.
static void measure_file(const bolan_sea_summary *summary, bolan_sea_statistics *out) {
    out->tp = summary->tp;
    out->tm02 = summary->tm02;
    out->te = summary->te;
    out->direction_from = summary->from_deg;
    out->spread = summary->spread_deg;
}

static void measure_modes(const sea_shared *shared, bolan_sea_statistics *out) {
    spectrum_sums s = {0};
    if (shared->cascades > 0) { // the turns of a sum are those over the ground
        s.current_x = shared->desc.sea_state.current_x;
        s.current_y = shared->desc.sea_state.current_y;
    }
    shared->model->each_wave(shared, sum_mode, &s);
    if (!(s.m0 > 0.0) || !(s.energy > 0.0)) return;
    const double r1 = sqrt(s.cosine * s.cosine + s.sine * s.sine) / s.energy;
    out->tp = shared->model->peak_period ? shared->model->peak_period(shared) : peak_of_bins(s.bin);
    out->tm02 = 2.0 * BOLAN_PI * sqrt(s.m0 / s.m2);
    out->te = 2.0 * BOLAN_PI * s.m1_inverse / s.m0;
    out->direction_from = bolan_math_to_compass_from(portable_angle(s.sine, s.cosine));
    out->spread = bolan_degrees(sqrt(fmax(2.0 * (1.0 - r1), 0.0)));
}

bolan_sea_statistics bolan_sea_measure(const bolan_sea *sea) {
    BOLAN_ASSERT(sea);
    bolan_sea_statistics out = {.m0_spectrum = sea->shared->summary.m0, .kurtosis = 3.0};
    if (sea->shared->is_measured) {
        measure_file(&sea->shared->summary, &out);
    } else {
        measure_modes(sea->shared, &out);
    }
    bolan_sea_fields(sea);
    measure_places(sea, &out);
    return out;
}

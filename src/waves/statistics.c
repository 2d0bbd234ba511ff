// SPDX-License-Identifier: MIT
// Statistics of the fields at the present time, of the realised amplitudes, and of the discrete spectrum.
#include "spectrum/portable.h"
#include "waves/sum.h"

sea_node sea_nearest_node(const bolan_sea *sea, uint32_t i, uint32_t j) {
    const sea_cascade *first = &sea->cascade[0];
    const double x = i * first->length / first->n, y = j * first->length / first->n; // tile 0 lies along the world axes
    sea_node v = {0};
    for (uint32_t a = 0; a < sea->count; a++) {
        const sea_cascade *c = &sea->cascade[a];
        const double scale = c->n / c->length;
        const uint32_t mask = c->n - 1;
        const uint32_t u = (uint32_t)(int64_t)floor((x * c->cosine + y * c->sine) * scale + 0.5) & mask;
        const uint32_t w = (uint32_t)(int64_t)floor((y * c->cosine - x * c->sine) * scale + 0.5) & mask;
        const size_t at = (size_t)w * c->n + u;
        v.height += c->field[FIELD_HEIGHT][at];
        v.sx += c->field[FIELD_SLOPE_X][at];
        v.sy += c->field[FIELD_SLOPE_Y][at];
        v.dxx += c->field[FIELD_DXX][at];
        v.dyy += c->field[FIELD_DYY][at];
        v.dxy += c->field[FIELD_DXY][at];
    }
    return v;
}

float sea_node_jacobian(const bolan_sea *sea, const sea_node *v) {
    const float l = (float)sea->desc.choppiness;
    return (1.0f + l * v->dxx) * (1.0f + l * v->dyy) - (l * v->dxy) * (l * v->dxy);
}

// ---- fields, tile by tile -------------------------------------------------------------------------------------------

static double mean_product(const sea_cascade *c, int a, int b) {
    const size_t points = (size_t)c->n * c->n;
    double sum = 0.0;
    for (size_t p = 0; p < points; p++) sum += (double)c->field[a][p] * c->field[b][p];
    return sum / (double)points;
}

static double mean_of(const sea_cascade *c, int a) {
    const size_t points = (size_t)c->n * c->n;
    double sum = 0.0;
    for (size_t p = 0; p < points; p++) sum += c->field[a][p];
    return sum / (double)points;
}

static void set_slopes(const bolan_sea *sea, const double slope[3], bolan_sea_statistics *out) {
    double s, c;
    const double from = sea->desc.sea_state.wind_speed > 0.0 ? sea->desc.sea_state.wind_from_deg : out->direction_from;
    bolan_sincos(bolan_compass_from_to_math(from), &s, &c);
    out->mss = slope[0] + slope[2];
    out->mss_up = c * c * slope[0] + 2.0 * c * s * slope[1] + s * s * slope[2];
    out->mss_cross = out->mss - out->mss_up;
}

// Tiles are independent, so the variances add, and so do the means of the Jacobian's second-order terms.
static void measure_tiles(const bolan_sea *sea, bolan_sea_statistics *out) {
    double slope[3] = {0}, dxx = 0.0, dyy = 0.0, dxy = 0.0, second = 0.0;
    for (uint32_t i = 0; i < sea->count; i++) {
        const sea_cascade *t = &sea->cascade[i];
        out->m0_field += mean_product(t, FIELD_HEIGHT, FIELD_HEIGHT);
        slope[0] += mean_product(t, FIELD_SLOPE_X, FIELD_SLOPE_X);
        slope[1] += mean_product(t, FIELD_SLOPE_X, FIELD_SLOPE_Y);
        slope[2] += mean_product(t, FIELD_SLOPE_Y, FIELD_SLOPE_Y);
        const double xx = mean_of(t, FIELD_DXX), yy = mean_of(t, FIELD_DYY), xy = mean_of(t, FIELD_DXY);
        second += mean_product(t, FIELD_DXX, FIELD_DYY) - xx * yy - (mean_product(t, FIELD_DXY, FIELD_DXY) - xy * xy);
        dxx += xx;
        dyy += yy;
        dxy += xy;
    }
    const double l = sea->desc.choppiness;
    out->hs = 4.0 * sqrt(out->m0_field);
    out->jacobian_mean = (1.0 + l * dxx) * (1.0 + l * dyy) - l * l * dxy * dxy + l * l * second;
    set_slopes(sea, slope, out);
}

// ---- fields, all tiles at once --------------------------------------------------------------------------------------

// At fixed world points a parcel counts by the area it covers, the Jacobian; folded parcels lie under others.
typedef struct moments {
    double weight, first, second, third, fourth;
} moments;

static void add_moment(moments *m, double height, double weight) {
    const double h2 = height * height;
    m->weight += weight;
    m->first += weight * height;
    m->second += weight * h2;
    m->third += weight * h2 * height;
    m->fourth += weight * h2 * h2;
}

static void set_shape(const moments *m, bolan_sea_statistics *out) {
    if (!(m->weight > 0.0)) return;
    const double a = m->first / m->weight, b = m->second / m->weight, c = m->third / m->weight,
                 d = m->fourth / m->weight;
    const double variance = b - a * a;
    if (!(variance > 0.0)) return;
    out->skewness = (c - 3.0 * a * b + 2.0 * a * a * a) / (variance * sqrt(variance));
    out->kurtosis = (d - 4.0 * a * c + 6.0 * a * a * b - 3.0 * a * a * a * a) / (variance * variance);
}

static void measure_nodes(const bolan_sea *sea, bolan_sea_statistics *out) {
    const uint32_t n = sea->desc.resolution;
    moments m = {0};
    double lowest = 1e30, covered = 0.0;
    for (uint32_t j = 0; j < n; j++) {
        for (uint32_t i = 0; i < n; i++) {
            const sea_node v = sea_nearest_node(sea, i, j);
            const double jacobian = sea_node_jacobian(sea, &v);
            lowest = fmin(lowest, jacobian);
            covered += jacobian < sea->foam_threshold ? 1.0 : 0.0;
            add_moment(&m, v.height, fmax(jacobian, 0.0));
        }
    }
    out->jacobian_min = lowest;
    out->whitecap_fraction = covered / ((double)n * n);
    set_shape(&m, out);
}

// A sum has no tile to average over exactly: everything at SUM_SAMPLES places.
static void measure_places(const bolan_sea *sea, bolan_sea_statistics *out) {
    moments m = {0};
    double slope[3] = {0}, lowest = 1e30, covered = 0.0, jacobians = 0.0, squares = 0.0;
    sea_node node[SUM_LANES];
    for (uint32_t i = 0; i < SUM_SAMPLES; i++) {
        if (i % SUM_LANES == 0) sea_sum_nodes(sea, i, node);
        const sea_node *v = &node[i % SUM_LANES];
        const double jacobian = sea_node_jacobian(sea, v), sx = v->sx, sy = v->sy;
        lowest = fmin(lowest, jacobian);
        covered += jacobian < sea->foam_threshold ? 1.0 : 0.0;
        jacobians += jacobian;
        squares += (double)v->height * v->height;
        slope[0] += sx * sx;
        slope[1] += sx * sy;
        slope[2] += sy * sy;
        add_moment(&m, v->height, fmax(jacobian, 0.0));
    }
    for (int i = 0; i < 3; i++) slope[i] /= SUM_SAMPLES;
    out->m0_field = squares / SUM_SAMPLES;
    out->hs = 4.0 * sqrt(out->m0_field);
    out->jacobian_min = lowest;
    out->jacobian_mean = jacobians / SUM_SAMPLES;
    out->whitecap_fraction = covered / SUM_SAMPLES;
    set_slopes(sea, slope, out);
    set_shape(&m, out);
}

// ---- modes ----------------------------------------------------------------------------------------------------------

enum { PERIOD_BINS = 160 }; // of 5 % in frequency, from 0.01 rad/s: 0.05 wp is narrower than any peak of JONSWAP
#define BIN_RATIO 1.05
#define LOWEST_OMEGA 0.01

typedef struct spectrum_sums {
    double m0, m1_inverse, m2;   // expected moments over w
    double energy, cosine, sine; // realised |h0|^2 by direction
    double bin[PERIOD_BINS];     // expected variance by log w
} spectrum_sums;

static void add_wave(spectrum_sums *s, double omega, double expected, double realised, double kx, double ky) {
    const double k = sqrt(kx * kx + ky * ky), bin = portable_log(omega / LOWEST_OMEGA) / portable_log(BIN_RATIO);
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
static double peak_period(const double *bin) {
    double density[PERIOD_BINS];
    int top = 1;
    for (int i = 0; i < PERIOD_BINS; i++) density[i] = bin[i] / portable_pow(BIN_RATIO, i);
    for (int i = 1; i < PERIOD_BINS - 1; i++)
        if (density[i] > density[top]) top = i;
    const double a = density[top - 1], b = density[top], c = density[top + 1], curve = a - 2.0 * b + c;
    const double shift = curve < 0.0 ? 0.5 * (a - c) / curve : 0.0;
    return 2.0 * BOLAN_PI / (LOWEST_OMEGA * portable_pow(BIN_RATIO, top + 0.5 + shift));
}

// The same of the few frequencies of a sum, each of which stands for its own width: the parabola through three points
// that lie anyhow (Lagrange).
static double peak_of_lines(const sea_sum *sum) {
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

static void measure_modes(const bolan_sea *sea, bolan_sea_statistics *out) {
    spectrum_sums s = {0};
    sea_each_wave(sea, sum_mode, &s);
    if (!(s.m0 > 0.0) || !(s.energy > 0.0)) return;
    const double r1 = sqrt(s.cosine * s.cosine + s.sine * s.sine) / s.energy;
    out->tp = sea->sum ? peak_of_lines(sea->sum) : peak_period(s.bin);
    out->tm02 = 2.0 * BOLAN_PI * sqrt(s.m0 / s.m2);
    out->te = 2.0 * BOLAN_PI * s.m1_inverse / s.m0;
    out->direction_from = bolan_math_to_compass_from(portable_angle(s.sine, s.cosine));
    out->spread = bolan_degrees(sqrt(fmax(2.0 * (1.0 - r1), 0.0)));
}

bolan_sea_statistics bolan_sea_measure(const bolan_sea *sea) {
    bolan_sea_statistics out = {.m0_spectrum = sea->summary.m0, .kurtosis = 3.0};
    measure_modes(sea, &out);
    if (sea->sum) {
        measure_places(sea, &out);
    } else {
        measure_tiles(sea, &out);
        measure_nodes(sea, &out);
    }
    return out;
}

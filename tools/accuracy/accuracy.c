// SPDX-License-Identifier: MIT
// bolan_accuracy FOLDER SWAN-FILE: the plots of docs/accuracy.md, and their numbers on standard output.
//
// Three spectra of each sea: the one that is asked for; the one that images draw, which read cubic splines over the
// half floats of bolan_cascade_view; and the one that buoys at fixed points hear of bolan_query_heights(). The last two
// are estimated by Welch's method (bolan_record_spectrum), whose window is applied to the first as well. Choppiness is
// 0: a spectrum at fixed points is that of the request for linear waves alone.
#include "bolan/io.h"
#include "bolan/query.h"
#include "bolan/record.h"
#include "bolan/waves.h"
#include "io/canvas.h"
#include "math/half.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SEEDS = 32, BUOYS = 64, SAMPLES = 1024, SEGMENT = 512, BINS = SEGMENT / 2 - 1, BANDS = 38 };
#define RATE 2.0    // [Hz]
#define BAND 1.0718 // a tenth of an octave
#define LOWEST 0.05 // [Hz]

static const uint8_t GREY[3] = {205, 208, 212}, BLUE[3] = {30, 100, 200}, ORANGE[3] = {225, 110, 20},
                     WHITE[3] = {255, 255, 255}, SHADE[3] = {228, 238, 226};

static void check(bool good, const char *what) {
    if (good) return;
    fprintf(stderr, "bolan_accuracy: %s failed\n", what);
    exit(1);
}

// ---- plots ----------------------------------------------------------------------------------------------------------

// A rectangle of the image with its axes.
typedef struct frame {
    canvas *image;
    int left, top, right, bottom;
    double x0, x1, y0, y1;
    bool log_x, log_y;
} frame;

static double place_on(double v, double from, double to, bool is_log) {
    return is_log ? log(v / from) / log(to / from) : (v - from) / (to - from);
}

static double x_of(const frame *f, double x) {
    return f->left + place_on(x, f->x0, f->x1, f->log_x) * (f->right - f->left);
}

static double y_of(const frame *f, double y) {
    return f->bottom - fmin(fmax(place_on(y, f->y0, f->y1, f->log_y), 0.0), 1.0) * (f->bottom - f->top);
}

static void draw_grid(const frame *f, const double *xs, int x_count, const double *ys, int y_count, bool names_x) {
    char text[32];
    for (int i = 0; i < x_count; i++) {
        const double x = x_of(f, xs[i]);
        bolan_canvas_line(f->image, x, f->top, x, f->bottom, 1.0, GREY);
        bolan_format(text, sizeof text, "%g", xs[i]);
        if (names_x) bolan_canvas_print_centred(f->image, (int)x, f->bottom + 12, 1, text);
    }
    for (int i = 0; i < y_count; i++) {
        const double y = y_of(f, ys[i]);
        bolan_canvas_line(f->image, f->left, y, f->right, y, 1.0, GREY);
        bolan_format(text, sizeof text, "%g", ys[i]);
        bolan_canvas_print(f->image, f->left - 8 - 6 * (int)strlen(text), (int)y - 4, 1, text);
    }
}

static void draw_curve(const frame *f, const double *x, const double *y, int count, double width,
                       const uint8_t colour[3]) {
    for (int i = 0; i + 1 < count; i++) {
        if (x[i] < f->x0 || x[i + 1] > f->x1) continue;
        const bool low = y[i] <= (f->log_y ? f->y0 : -HUGE_VAL) && y[i + 1] <= (f->log_y ? f->y0 : -HUGE_VAL);
        if (!low)
            bolan_canvas_line(f->image, x_of(f, x[i]), y_of(f, fmax(y[i], f->y0)), x_of(f, x[i + 1]),
                              y_of(f, fmax(y[i + 1], f->y0)), width, colour);
    }
}

static canvas new_image(int width, int height) {
    canvas c = {width, height, malloc((size_t)width * height * 3)};
    check(c.rgb != NULL, "memory");
    memset(c.rgb, 255, (size_t)width * height * 3);
    return c;
}

static void save(canvas *c, const char *folder, const char *name) {
    char path[1024];
    snprintf(path, sizeof path, "%s/%s.png", folder, name);
    check(!bolan_png_write(path, (uint32_t)c->width, (uint32_t)c->height, c->rgb), path);
    free(c->rgb);
}

static void legend(canvas *image, int x, int y, const uint8_t colour[3], double width, const char *text) {
    bolan_canvas_line(image, x, y + 3, x + 26, y + 3, width, colour);
    bolan_canvas_print(image, x + 34, y, 1, text);
}

// ---- spectra --------------------------------------------------------------------------------------------------------

typedef struct spectra {
    double asked[BINS], drawn[BINS], buoy[BINS]; // [m2/Hz], of frequency (i + 1) RATE / SEGMENT
    double asked_m0, drawn_m0, buoy_m0;
} spectra;

// The spline of one plane of half floats, as the shaders read it: weights of the cubic B-spline, 4 x 4 samples.
static double spline(const bolan_cascade_view *v, double x, double y) {
    const double c = cos(v->angle), s = sin(v->angle), h = v->length / v->n;
    const double u = (x * c + y * s) / h, w = (-x * s + y * c) / h;
    const double iu = floor(u), iw = floor(w);
    double weights[2][4], sum = 0.0;
    for (int axis = 0; axis < 2; axis++) {
        const double t = axis ? w - iw : u - iu, r = 1.0 - t;
        weights[axis][0] = r * r * r / 6.0;
        weights[axis][1] = (4.0 - 6.0 * t * t + 3.0 * t * t * t) / 6.0;
        weights[axis][2] = (4.0 - 6.0 * r * r + 3.0 * r * r * r) / 6.0;
        weights[axis][3] = t * t * t / 6.0;
    }
    const double n = v->n;
    for (int j = 0; j < 4; j++)
        for (int i = 0; i < 4; i++) {
            const uint32_t column = (uint32_t)(fmod(fmod(iu + i - 1, n) + n, n)),
                           row = (uint32_t)(fmod(fmod(iw + j - 1, n) + n, n));
            sum += weights[0][i] * weights[1][j] *
                   (double)float_from_half(v->displacement_half[((size_t)row * v->n + column) * 4 + 2]);
        }
    return sum;
}

static float drawn_height(const bolan_sea *sea, bolan_dvec2 at) {
    double gradient[4], sum = 0.0;
    const bolan_dvec2 read = bolan_sea_place_read(sea, at.x, at.y, gradient);
    for (uint32_t i = 0; i < bolan_sea_cascade_count(sea); i++) {
        const bolan_cascade_view v = bolan_sea_cascade(sea, i);
        sum += spline(&v, read.x, read.y);
    }
    return (float)sum;
}

static void add_record(const float *heave, double out[BINS]) {
    bolan_record_band band[BINS];
    check(!bolan_record_spectrum(heave, NULL, NULL, SAMPLES, RATE, SEGMENT, band), "bolan_record_spectrum");
    for (int i = 0; i < BINS; i++) out[i] += band[i].density / (SEEDS * BUOYS);
}

static double variance_of(const float *heave) {
    double sum = 0.0;
    for (int i = 0; i < SAMPLES; i++) sum += (double)heave[i] * (double)heave[i];
    return sum / SAMPLES;
}

// The request through the same window: a line at f gives bin i (sinc(d) + (sinc(d - 1) + sinc(d + 1)) / 2)^2 / 1.5 with
// d in bins (Hann).
static double window_share(double d) {
    double sum = 0.0;
    for (int k = -1; k <= 1; k++) {
        const double x = BOLAN_PI * (d + k);
        sum += (k == 0 ? 1.0 : 0.5) * (fabs(x) < 1e-9 ? 1.0 : sin(x) / x);
    }
    return sum * sum / 1.5;
}

static void ask(const bolan_sea_state *state, spectra *s) {
    enum { FINE = 8, ANGLES = 120, REACH = 8 };
    const double bin = RATE / SEGMENT, df = bin / FINE, dth = 2.0 * BOLAN_PI / ANGLES;
    for (int f = 1; f < FINE * (BINS + 4); f++) {
        const double hertz = (f + 0.5) * df, k = bolan_k_from_omega(2.0 * BOLAN_PI * hertz, state->depth);
        double sum = 0.0; // S(f) = 2 pi Psi k / (dw/dk), over the angles: with the tail of a measured spectrum
        for (int j = 0; j < ANGLES; j++)
            sum += bolan_sea_state_wavenumber_density(state, k * cos(j * dth), k * sin(j * dth));
        const double variance = sum * dth * 2.0 * BOLAN_PI * k / bolan_group_speed(k, state->depth) * df;
        s->asked_m0 += variance;
        for (int i = f / FINE - REACH; i <= f / FINE + REACH; i++)
            if (i >= 1 && i <= BINS) s->asked[i - 1] += variance * window_share(hertz / bin - i) / bin;
    }
}

static void measure(bolan_sea_desc desc, spectra *s) {
    static float drawn[BUOYS][SAMPLES], heard[BUOYS][SAMPLES], now[BUOYS];
    static bolan_dvec2 at[BUOYS];
    *s = (spectra){.asked_m0 = 0.0};
    ask(&desc.sea_state, s);
    for (int b = 0; b < BUOYS; b++) {
        const double x = 0.5 + b * 0.7548776662466927, y = 0.5 + b * 0.5698402909980532;
        at[b] = (bolan_dvec2){1e5 * (x - floor(x)), 1e5 * (y - floor(y))};
    }
    for (uint32_t seed = 1; seed <= SEEDS; seed++) {
        bolan_sea *sea = NULL;
        desc.seed = seed;
        check(!bolan_sea_create(&desc, &sea), "bolan_sea_create");
        for (int i = 0; i < SAMPLES; i++) {
            bolan_sea_step(sea, i / RATE);
            bolan_query_heights(&(bolan_water){.sea = sea}, at, BUOYS, now);
            for (int b = 0; b < BUOYS; b++) heard[b][i] = now[b], drawn[b][i] = drawn_height(sea, at[b]);
        }
        bolan_sea_destroy(&sea);
        for (int b = 0; b < BUOYS; b++) {
            add_record(heard[b], s->buoy);
            add_record(drawn[b], s->drawn);
            s->buoy_m0 += variance_of(heard[b]) / (SEEDS * BUOYS);
            s->drawn_m0 += variance_of(drawn[b]) / (SEEDS * BUOYS);
        }
    }
}

// Means over tenths of an octave.
static void band_means(const double bins[BINS], double hertz[BANDS], double out[BANDS]) {
    for (int b = 0; b < BANDS; b++) {
        const double bin = RATE / SEGMENT, from = LOWEST * pow(BAND, b) / bin, to = from * BAND;
        double sum = 0.0;
        for (int i = 1; i <= BINS; i++) // a bin reaches half a bin to either side
            sum += bins[i - 1] * fmax(fmin(to, i + 0.5) - fmax(from, i - 0.5), 0.0);
        hertz[b] = sqrt(from * to) * bin;
        out[b] = sum / (to - from);
    }
}

// Over and under each other: the densities, and the ratios of the measured ones to the request.
static void plot_spectra(const spectra *s, const char *folder, const char *name, const char *title) {
    static const double hertz[] = {0.05, 0.07, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.7},
                        ratios[] = {0.9, 0.97, 1, 1.03, 1.1};
    double densities[5], at[BANDS], asked[BANDS], drawn[BANDS], buoy[BANDS], top = 0.0;
    char text[96];
    canvas image = new_image(720, 480);
    band_means(s->asked, at, asked), band_means(s->drawn, at, drawn), band_means(s->buoy, at, buoy);
    for (int b = 0; b < BANDS; b++) top = fmax(top, asked[b]);
    const double ceiling = pow(10.0, ceil(log10(top) + 0.05));
    for (int i = 0; i < 5; i++) densities[i] = ceiling * pow(10.0, -i);
    frame up = {&image, 70, 56, 700, 320, 0.045, 0.7, ceiling * 1e-4, ceiling, true, true}, down = up;
    down.top = 340, down.bottom = 440, down.y0 = 0.86, down.y1 = 1.14, down.log_y = false;
    bolan_canvas_fill(&image, down.left, (int)y_of(&down, 1.03), down.right, (int)y_of(&down, 0.97), SHADE);
    draw_grid(&up, hertz, 9, densities, 5, false);
    draw_grid(&down, hertz, 9, ratios, 5, true);
    draw_curve(&up, at, asked, BANDS, 5.0, GREY);
    draw_curve(&up, at, drawn, BANDS, 2.5, ORANGE);
    draw_curve(&up, at, buoy, BANDS, 1.0, BLUE);
    int first = BANDS, end = 0; // where the request is above a hundredth of its peak
    for (int b = 0; b < BANDS; b++) {
        if (asked[b] < 1e-2 * top) continue;
        drawn[b] /= asked[b], buoy[b] /= asked[b];
        if (first == BANDS) first = b;
        end = b + 1;
        printf("%s,%.5f,%.6g,%.4f,%.4f\n", name, at[b], asked[b], drawn[b], buoy[b]);
    }
    draw_curve(&down, at + first, drawn + first, end - first, 2.5, ORANGE);
    draw_curve(&down, at + first, buoy + first, end - first, 1.0, BLUE);
    bolan_canvas_print(&image, 70, 14, 2, title);
    bolan_format(text, sizeof text, "drawn %+.1f %%, buoys %+.1f %% of the variance; %d seeds x %d buoys x %.0f s",
                 100.0 * (s->drawn_m0 / s->asked_m0 - 1.0), 100.0 * (s->buoy_m0 / s->asked_m0 - 1.0), (int)SEEDS,
                 (int)BUOYS, SAMPLES / RATE);
    bolan_canvas_print(&image, 70, 38, 1, text);
    bolan_canvas_fill(&image, 560, 62, 694, 112, WHITE);
    legend(&image, 568, 66, GREY, 5.0, "asked, m2/Hz");
    legend(&image, 568, 82, ORANGE, 2.5, "drawn");
    legend(&image, 568, 98, BLUE, 1.0, "buoys, queried");
    bolan_canvas_print_centred(&image, 385, 468, 1,
                               "frequency, Hz, tenths of an octave; below: over the request, shaded 3 %");
    save(&image, folder, name);
}

// ---- correlation ----------------------------------------------------------------------------------------------------

enum { DISTANCES = 200, TURNS = 16, PAIRS = 4096, CORRELATED = 6 };
#define FARTHEST 20000.0 // [m]

// The largest correlation over the directions at each distance, of the average over the seeds.
static void correlate(bolan_sea_desc desc, double out[DISTANCES]) {
    static double sum[DISTANCES][TURNS];
    static bolan_dvec2 at[PAIRS], there[PAIRS];
    static float here[PAIRS], height[PAIRS];
    double power = 0.0;
    memset(sum, 0, sizeof sum);
    for (uint32_t seed = 1; seed <= CORRELATED; seed++) {
        bolan_sea *sea = NULL;
        desc.seed = seed;
        check(!bolan_sea_create(&desc, &sea), "bolan_sea_create");
        const bolan_water water = {.sea = sea};
        for (int p = 0; p < PAIRS; p++) {
            const double x = p * 0.7548776662466927, y = p * 0.5698402909980532;
            at[p] = (bolan_dvec2){3e5 * (x - floor(x)), 3e5 * (y - floor(y))};
        }
        bolan_query_heights(&water, at, PAIRS, here);
        for (int p = 0; p < PAIRS; p++) power += (double)here[p] * (double)here[p];
        for (int d = 0; d < DISTANCES; d++)
            for (int t = 0; t < TURNS; t++) {
                const double r = FARTHEST * (d + 1) / DISTANCES, angle = BOLAN_PI * t / TURNS;
                for (int p = 0; p < PAIRS; p++)
                    there[p] = (bolan_dvec2){at[p].x + r * cos(angle), at[p].y + r * sin(angle)};
                bolan_query_heights(&water, there, PAIRS, height);
                for (int p = 0; p < PAIRS; p++) sum[d][t] += (double)here[p] * (double)height[p];
            }
        bolan_sea_destroy(&sea);
    }
    for (int d = 0; d < DISTANCES; d++) {
        out[d] = -1.0;
        for (int t = 0; t < TURNS; t++) out[d] = fmax(out[d], sum[d][t] / power);
    }
}

static void plot_correlation(const bolan_sea_desc *wind, const bolan_sea_desc *swell, const char *folder) {
    static double of_wind[DISTANCES], of_swell[DISTANCES], km[DISTANCES];
    static const double xs[] = {0, 5, 10, 15, 20}, ys[] = {0, 0.15, 0.25, 0.5, 0.75, 1};
    canvas image = new_image(720, 360);
    frame f = {&image, 70, 40, 700, 310, 0.0, 20.0, -0.05, 1.0, false, false};
    correlate(*wind, of_wind);
    correlate(*swell, of_swell);
    for (int d = 0; d < DISTANCES; d++) {
        km[d] = FARTHEST * (d + 1) / DISTANCES / 1e3;
        printf("correlation,%.2f,%.4f,%.4f\n", km[d], of_wind[d], of_swell[d]);
    }
    draw_grid(&f, xs, 5, ys, 6, true);
    draw_curve(&f, km, of_swell, DISTANCES, 1.5, ORANGE);
    draw_curve(&f, km, of_wind, DISTANCES, 1.5, BLUE);
    bolan_canvas_print(&image, 70, 14, 2, "correlation of heights over distance");
    bolan_canvas_fill(&image, 420, 50, 694, 84, WHITE);
    legend(&image, 428, 54, BLUE, 1.5, "wind sea, 10 m/s over 300 km");
    legend(&image, 428, 70, ORANGE, 1.5, "swell of 14 s");
    bolan_canvas_print_centred(&image, 385, 344, 1, "distance, km; the largest of 16 directions, mean of 6 seeds");
    save(&image, folder, "accuracy-correlation");
}

int main(int count, char **arguments) {
    bolan_measured_spectrum *swan = NULL;
    bolan_spectrum_options options = bolan_spectrum_options_default();
    static spectra s;
    if (count != 3) {
        fprintf(stderr, "usage: bolan_accuracy FOLDER SWAN-FILE\n");
        return 2;
    }
    options.record = 4;
    check(!bolan_spectrum_load(arguments[2], &options, &swan), arguments[2]);
    bolan_sea_desc wind = bolan_sea_desc_default(), swell, measured;
    wind.choppiness = 0.0;
    swell = measured = wind;
    wind.sea_state = bolan_sea_state_from_wind(10.0, 240.0, 300e3);
    swell.sea_state = measured.sea_state = bolan_sea_state_default();
    check(!bolan_sea_state_add_swell(&swell.sea_state, 2.0, 14.0, 270.0, 75.0), "bolan_sea_state_add_swell");
    measured.sea_state.measured = swan, measured.sea_state.wind_speed = 15.0;
    measure(wind, &s);
    plot_spectra(&s, arguments[1], "accuracy-wind", "wind sea, 10 m/s over 300 km");
    measure(swell, &s);
    plot_spectra(&s, arguments[1], "accuracy-swell", "swell of 2 m and 14 s");
    measure(measured, &s);
    plot_spectra(&s, arguments[1], "accuracy-measured", "SWAN off Taranaki, 2016-10-15");
    plot_correlation(&wind, &swell, arguments[1]);
    bolan_measured_spectrum_destroy(&swan);
    return 0;
}

// SPDX-License-Identifier: MIT
// The spectrum of the surface by tenths of an octave: its waves against the request, and virtual buoys (Welch 1967)
// against its waves.
//
// A mode near the origin of its lattice is a few waves of one wave vector (modes.c), which beat for minutes in all of
// the sea at once. A record of four minutes holds what the beats have there and then, so a band of few such modes is
// off the request by a third in one record, by a tenth in the mean of ten, however many the buoys. The waves are known,
// so both parts are measured without that error: the variance of all waves is the mean over all times, and the records
// of all places have a spectrum in closed form, which those of some hundred buoys are near. The short version is the
// test; BOLAN_LONG=1 measures the seas and sides of the table in docs/accuracy.md, and prints each band.
#include "sea_kinds.h"

#include "bolan/query.h"

enum { MOST_BUOYS = 2048, SAMPLES = 512, BINS = SAMPLES / 2 + 1, BANDS = 40, RECORDS = 8 };
#define RATE 2.0    // [Hz]
#define BAND 1.0718 // a tenth of an octave
#define LOWEST 0.05 // [Hz]
#define HIGHEST 0.7 // [Hz] above, records of RATE have aliases
#define LARGEST 2.5 // standard deviations: the largest of 28 bands is 2.2 off in the mean
#define REACH 8     // bins to either side that Hann's window spreads a wave over

typedef struct spectrum {
    double bin[BINS]; // variance per bin of RATE / SAMPLES Hz
} spectrum;

static double band_from(int band) { return LOWEST * pow(BAND, band); }

static double in_band(const spectrum *s, int band) {
    double sum = 0.0;
    const double from = band_from(band) * SAMPLES / RATE, to = from * BAND;
    for (int i = 0; i < BINS; i++) { // a bin reaches half a bin to either side
        const double low = fmax(from, i - 0.5), high = fmin(to, i + 0.5);
        if (high > low) sum += (high - low) * s->bin[i];
    }
    return sum;
}

// ---- lines ----------------------------------------------------------------------------------------------------------

// Amplitude that a line of frequency f gives bin i, of Hann's window about the middle of the record.
static double window(double f, int i) {
    const double d = f * SAMPLES / RATE - i;
    if (fabs(d) > REACH) return 0.0;
    double sum = 0.0;
    for (int k = -1; k <= 1; k++) {
        const double x = BOLAN_PI * (d + k);
        sum += (k == 0 ? 1.0 : 0.5) * (fabs(x) < 1e-9 ? 1.0 : sin(x) / x);
    }
    return sum / sqrt(1.5);
}

static int first_bin(double f) { return (int)fmax(f * SAMPLES / RATE - REACH, 0.0); }
static int last_bin(double f) { return (int)fmin(f * SAMPLES / RATE + REACH + 1, BINS - 1); }

static void add_line(spectrum *s, double f, double variance) {
    for (int i = first_bin(f); i <= last_bin(f); i++) {
        const double share = window(f, i);
        s->bin[i] += variance * share * share;
    }
}

// What was asked for, the continuous spectrum, as the same instrument would see it.
static void requested(const bolan_sea_state *state, spectrum *s) {
    enum { LINES = 4 * SAMPLES, ANGLES = 120 };
    memset(s, 0, sizeof *s);
    for (int i = 0; i < LINES; i++) {
        const double f = 0.5 * RATE * (i + 0.5) / LINES;
        double density = 0.0;
        for (int a = 0; a < ANGLES; a++)
            density += bolan_sea_state_density(state, 2.0 * BOLAN_PI * f, 2.0 * BOLAN_PI * a / ANGLES);
        add_line(s, f, density * (2.0 * BOLAN_PI / ANGLES) * BOLAN_PI * RATE / LINES);
    }
}

static void realised(spectrum *s) {
    memset(s, 0, sizeof *s);
    for (uint32_t i = 0; i < wave_count; i++) add_line(s, waves[i].turns, waves[i].variance);
}

// Adds a group of waves of one wave vector. Over all places the products of different wave vectors have no mean.
static void add_group(const wave *group, uint32_t count, double middle, spectrum *s) {
    static double complex now[SEA_PARTS];
    int first = BINS, last = -1;
    assert_true(count <= SEA_PARTS);
    for (uint32_t w = 0; w < count; w++) {
        now[w] = group[w].amplitude * cexp(-2.0 * I * BOLAN_PI * group[w].turns * middle);
        first = first_bin(group[w].turns) < first ? first_bin(group[w].turns) : first;
        last = last_bin(group[w].turns) > last ? last_bin(group[w].turns) : last;
    }
    for (int i = first; i <= last; i++) {
        double complex z = 0.0;
        for (uint32_t w = 0; w < count; w++) z += now[w] * window(group[w].turns, i);
        s->bin[i] += 2.0 * creal(z * conj(z));
    }
}

static int by_vector(const void *left, const void *right) {
    const wave *a = left, *b = right;
    return a->kx != b->kx ? (a->kx < b->kx ? -1 : 1) : (a->ky > b->ky) - (a->ky < b->ky);
}

// The mean over all places of what a record that begins at a time holds. Sorted waves.
static void everywhere(double time, spectrum *s) {
    memset(s, 0, sizeof *s);
    for (uint32_t i = 0, j; i < wave_count; i = j) {
        for (j = i; j < wave_count && by_vector(&waves[i], &waves[j]) == 0;) j++;
        if (waves[i].turns < 0.6 * RATE) add_group(&waves[i], j - i, time + 0.5 * (SAMPLES - 1) / RATE, s);
    }
}

// ---- buoys ----------------------------------------------------------------------------------------------------------

static void add_record(const float *h, spectrum *s, double weight) {
    double complex x[SAMPLES];
    double power = 0.0;
    for (int i = 0; i < SAMPLES; i++) {
        const double w = 0.5 - 0.5 * cos(2.0 * BOLAN_PI * (i + 0.5) / SAMPLES);
        x[i] = w * (double)h[i];
        power += w * w;
    }
    fft(x, SAMPLES);
    for (int i = 0; i < BINS; i++) s->bin[i] += weight * 2.0 * creal(x[i] * conj(x[i])) / (power * SAMPLES);
}

static double at_random(void) {
    static uint32_t random = 1;
    random = random * 1664525u + 1013904223u;
    return (random >> 8) / 16777216.0;
}

// Places at random: evenly scattered buoys would hear beats of waves that fit their spacing.
static void listen(bolan_sea *sea, uint32_t buoys, double time, spectrum *s) {
    static float record[MOST_BUOYS][SAMPLES];
    static float now[MOST_BUOYS];
    static bolan_dvec2 at[MOST_BUOYS];
    memset(s, 0, sizeof *s);
    for (uint32_t b = 0; b < buoys; b++) at[b].x = 1e5 * at_random(), at[b].y = 1e5 * at_random();
    for (int i = 0; i < SAMPLES; i++) {
        bolan_sea_step(sea, time + i / RATE);
        bolan_query_heights(&(bolan_water){.sea = sea}, at, buoys, now);
        for (uint32_t b = 0; b < buoys; b++) record[b][i] = now[b];
    }
    for (uint32_t b = 0; b < buoys; b++) add_record(record[b], s, 1.0 / buoys);
}

// ---- ratios ---------------------------------------------------------------------------------------------------------

// Sums over records of what buoys hear, x, and of what there is everywhere, y.
typedef struct ratio {
    double x, y, xx, xy, yy;
} ratio;

static void add_pair(ratio *r, double x, double y) {
    r->x += x, r->y += y, r->xx += x * x, r->xy += x * y, r->yy += y * y;
}

// Standard deviation of x / y, by the residuals x - (x / y) y of n records.
static double doubt_of(const ratio *r, double n) {
    const double q = r->x / r->y, residuals = r->xx - 2.0 * q * r->xy + q * q * r->yy;
    return sqrt(fmax(residuals, 0.0) * n / (n - 1.0)) / r->y;
}

typedef struct bands {
    ratio heard[BANDS], variance;
    double held[BANDS], asked[BANDS], m0;
} bands;

static void hold_sea(which which_sea, uint32_t n, uint32_t seed, bolan_sea **sea, bands *out) {
    const bolan_sea_desc desc = desc_of(which_sea, n, seed);
    static spectrum modes, request;
    *sea = test_sea(desc);
    gather(*sea);
    realised(&modes);
    requested(&desc.sea_state, &request);
    out->m0 = 0.0;
    for (uint32_t i = 0; i < wave_count; i++) out->m0 += waves[i].variance / m0_of(*sea);
    for (int b = 0; b < BANDS; b++) out->held[b] = in_band(&modes, b), out->asked[b] = in_band(&request, b);
}

static void hear_sea(bolan_sea *sea, uint32_t buoys, bands *out) {
    static spectrum buoy, all;
    qsort(waves, wave_count, sizeof *waves, by_vector);
    for (int r = 0; r < RECORDS; r++) {
        const double time = floor(1e5 * at_random());
        double x = 0.0, y = 0.0;
        listen(sea, buoys, time, &buoy);
        everywhere(time, &all);
        for (int b = 0; b < BANDS; b++) add_pair(&out->heard[b], in_band(&buoy, b), in_band(&all, b));
        for (int i = 0; i < BINS; i++) x += buoy.bin[i], y += all.bin[i];
        add_pair(&out->variance, x, y);
    }
}

// Frequency [Hz] up to which a sea is as it was asked for; its shorter waves are rolled off (bolan/waves.h).
static double asked_end(which which_sea) {
    const bolan_sea_desc d = desc_of(which_sea, 128, 1);
    const bolan_sea_summary summary = bolan_sea_state_summary(&d.sea_state);
    return bolan_omega_from_k(bolan_sea_asked_end(&d.sea_state, &summary), d.sea_state.depth) / (2.0 * BOLAN_PI);
}

// Tenths of an octave that hold a hundredth of the largest.
static bool counts(const bands *all, int band) {
    double top = 0.0;
    for (int b = 0; b < BANDS; b++) top = fmax(top, all->asked[b]);
    return all->asked[band] >= 1e-2 * top && band_from(band + 1) <= HIGHEST;
}

// ---- the tests ------------------------------------------------------------------------------------------------------

// No statistics: amplitudes are those of the spectrum, whatever the seed.
static double check_waves(which which_sea, uint32_t n, double tolerance, bands *all, bolan_sea **sea) {
    double worst = 0.0, at = 0.0;
    hold_sea(which_sea, n, 1, sea, all);
    for (int b = 0; b < BANDS; b++) {
        if (!counts(all, b) || band_from(b + 1) >= asked_end(which_sea)) continue;
        const double error = all->held[b] / all->asked[b] - 1.0;
        if (fabs(error) > fabs(worst)) worst = error, at = band_from(b) * sqrt(BAND);
    }
    print_message("%s, N %u: waves off the request by %+.3f at %.3f Hz, variance %.4f\n", names[which_sea], n, worst,
                  at, all->m0);
    assert_true(fabs(worst) < tolerance);
    assert_near(all->m0, 1.0, 0.01);
    return worst;
}

// Buoys against the waves in the same records; and both together against the request.
static void check_buoys(which which_sea, uint32_t n, uint32_t seeds, uint32_t buoys, double tolerance) {
    const double records = RECORDS * seeds, end = asked_end(which_sea);
    double worst = 0.0, at = 0.0, doubt = 0.0, beyond = 0.0;
    static bands all;
    memset(&all, 0, sizeof all);
    for (uint32_t seed = 1; seed <= seeds; seed++) {
        bolan_sea *sea = NULL;
        hold_sea(which_sea, n, seed, &sea, &all);
        hear_sea(sea, buoys, &all);
        bolan_sea_destroy(&sea);
    }
    for (int b = 0; b < BANDS; b++) {
        if (!counts(&all, b)) continue;
        const ratio *r = &all.heard[b];
        const double held = band_from(b + 1) < end ? all.held[b] / all.asked[b] : 1.0;
        const double error = r->x / r->y - 1.0, sd = doubt_of(r, records);
        if (is_long())
            print_message("      %.4f Hz  waves/request %.3f  buoys/waves %.3f +- %.3f  waves then/always %.3f\n",
                          band_from(b) * sqrt(BAND), all.held[b] / all.asked[b], r->x / r->y, sd,
                          r->y / records / all.held[b]);
        if (fabs(error) > fabs(worst)) worst = error, at = band_from(b) * sqrt(BAND), doubt = sd;
        beyond = fmax(beyond, fabs((1.0 + error) * held - 1.0) - LARGEST * sd);
    }
    const double variance = all.variance.x / all.variance.y * all.m0, sd = doubt_of(&all.variance, records);
    print_message("%s, N %u: buoys off the waves by %+.3f +- %.3f at %.3f Hz; off the request beyond 2.5 times the "
                  "error by %.3f; variance %.3f +- %.3f\n",
                  names[which_sea], n, worst, doubt, at, beyond, variance, sd);
    assert_true(beyond < tolerance);
    assert_true(doubt < tolerance); // or the test could not fail
    assert_true(fabs(variance - 1.0) < 0.01 + LARGEST * sd);
}

// 64 samples a side: six cells around the origin of a tile are few. 3.9 % at .63 Hz, where the third tile of a wind of
// 5 m/s begins.
static void waves_have_the_spectrum_at_every_side(void **state) {
    (void)state;
    static bands all;
    for (int s = 0; s < SEAS; s++)
        for (uint32_t n = 64; n <= (is_long() ? 1024u : 128u); n *= 2) {
            bolan_sea *sea = NULL;
            check_waves((which)s, n, n > 64 ? 0.015 : s == WIND5 ? 0.045 : 0.03, &all, &sea);
            bolan_sea_destroy(&sea);
        }
}

static void buoys_hear_the_waves(void **state) {
    (void)state;
    if (!is_long()) {
        check_buoys(WIND10, 128, 1, 256, 0.03);
        return;
    }
    static const which measured[] = {WIND10, NARROW14, OPEN_SEA, SWAN4};
    for (uint32_t n = 64; n <= 1024; n *= 2)
        for (int s = 0; s < 4; s++) check_buoys(measured[s], n, n <= 128 ? 4 : n == 256 ? 2 : 1, MOST_BUOYS, 0.03);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(waves_have_the_spectrum_at_every_side),
                                       cmocka_unit_test(buoys_hear_the_waves)};
    if (getenv("BOLAN_ONLY")) cmocka_set_test_filter(getenv("BOLAN_ONLY"));
    return cmocka_run_group_tests(tests, open_swan, close_swan);
}

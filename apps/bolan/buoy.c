// SPDX-License-Identifier: MIT
// See buoy.h.
#include "buoy.h"

#include "progress.h"

#include "bolan/record.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { LEAST_SAMPLES = 64, ROW = 192, MOST_BANDS = 2048, LEVELS = 5 };
#define DURATION 1800.0       // [s]
#define RATE 2.0              // [1/s]
#define SEGMENT_SECONDS 128.0 // of the spectrum

static const double exceeded[LEVELS] = {0.5, 1.0, 1.25, 1.5, 2.0}; // heights, over hm0

typedef struct record {
    uint32_t count;
    double rate, start;
    float *heave, *east, *north, *slope_x, *slope_y; // in one block
    bolan_record_wave *waves;
    bolan_record_statistics statistics;
    uint32_t segment;
    bolan_record_band band[MOST_BANDS];
} record;

static double duration_of(const options *o) { return isnan(o->duration) ? DURATION : o->duration; }
static double rate_of(const options *o) { return isnan(o->rate) ? RATE : o->rate; }

bool buoy_options_check(const options *o) {
    const bool buoy = option_given(o, "buoy");
    static const char *const others[] = {"duration", "rate", "output"};
    for (int i = 0; i < 3; i++) {
        if (buoy || !option_given(o, others[i])) continue;
        usage_error("--%s needs --buoy X,Y", others[i]);
        return false;
    }
    if (buoy && duration_of(o) * rate_of(o) < LEAST_SAMPLES) {
        usage_error("a record of %g s at %g a second has too few samples; expected %d", duration_of(o), rate_of(o),
                    (int)LEAST_SAMPLES);
        return false;
    }
    return true;
}

// A multiple of 4 samples.
static uint32_t segment_of(uint32_t count, double rate) {
    const double samples = fmin(fmin(SEGMENT_SECONDS * rate, 2.0 * MOST_BANDS), count);
    return (uint32_t)fmax(samples, 16.0) / 4 * 4;
}

static bool create(record *r, const options *o, double start) {
    r->rate = rate_of(o);
    r->start = start;
    r->count = (uint32_t)(duration_of(o) * r->rate + 0.5);
    r->segment = segment_of(r->count, r->rate);
    r->heave = malloc((size_t)r->count * 5 * sizeof(float));
    r->waves = malloc((size_t)r->count * sizeof *r->waves);
    if (!r->heave || !r->waves) return false;
    r->east = r->heave + r->count;
    r->north = r->east + r->count;
    r->slope_x = r->north + r->count;
    r->slope_y = r->slope_x + r->count;
    return true;
}

static void sail(record *r, const options *o, bolan_sea *sea) {
    const bolan_dvec2 mooring = {o->buoy[0], o->buoy[1]};
    progress bar = progress_start(r->count, o->quiet);
    for (uint32_t i = 0; i < r->count; i++) {
        bolan_sea_sample s;
        bolan_sea_step(sea, r->start + i / r->rate);
        bolan_sea_sample_rest(sea, &mooring, 1, &s);
        r->heave[i] = s.height, r->east[i] = s.dx, r->north[i] = s.dy;
        r->slope_x[i] = s.slope_x, r->slope_y[i] = s.slope_y;
        progress_update(&bar, i + 1);
    }
    progress_end(&bar);
}

// ---- output ---------------------------------------------------------------------------------------------------------

static bool write_rows(const record *r, bolan_file_stream *file) {
    static const char header[] = "time,heave,east,north,slope_x,slope_y\n";
    if (bolan_file_stream_write(file, header, sizeof header - 1)) return false;
    for (uint32_t i = 0; i < r->count; i++) {
        char row[ROW];
        const double values[6] = {r->start + i / r->rate, (double)r->heave[i],   (double)r->east[i],
                                  (double)r->north[i],    (double)r->slope_x[i], (double)r->slope_y[i]};
        size_t used = 0;
        for (int c = 0; c < 6; c++) {
            if (c) row[used++] = ',';
            used += (size_t)bolan_format_number(row + used, 32, values[c], c ? 6 : 12);
        }
        row[used++] = '\n';
        if (bolan_file_stream_write(file, row, used)) return false;
    }
    return true;
}

static bool write_file(const record *r, const char *path) {
    bolan_file_stream *file = NULL;
    if (bolan_file_stream_open(path, &file)) return false;
    const bool written = write_rows(r, file);
    return bolan_file_stream_close(&file, written) == BOLAN_OK && written;
}

static void print_pair(const char *before, const char *key, double value, const char *behind) {
    char text[32];
    bolan_format_number(text, sizeof text, value, 7);
    printf("%s\"%s\": %s%s", before, key, isfinite(value) ? text : "null", behind);
}

static void print_json(const record *r) {
    const bolan_record_statistics *s = &r->statistics;
    const struct {
        const char *key;
        double value;
    } list[] = {
        {"samples", r->count},   {"rate", r->rate},         {"waves", s->waves},       {"mean", s->mean},
        {"hm0", s->hm0},         {"skewness", s->skewness}, {"kurtosis", s->kurtosis}, {"h_mean", s->h_mean},
        {"h_third", s->h_third}, {"h_tenth", s->h_tenth},   {"h_max", s->h_max},       {"crest_max", s->crest_max},
        {"tz", s->tz},           {"t_third", s->t_third}};
    printf("{\n");
    for (size_t i = 0; i < sizeof list / sizeof *list; i++) print_pair("  ", list[i].key, list[i].value, ",\n");
    printf("  \"exceedance\": [\n");
    for (int i = 0; i < LEVELS; i++) {
        print_pair("    {", "height", exceeded[i] * s->hm0, ", ");
        print_pair("", "share", bolan_record_exceedance(r->waves, s->waves, exceeded[i] * s->hm0),
                   i + 1 < LEVELS ? "},\n" : "}\n");
    }
    printf("  ],\n  \"spectrum\": [\n");
    const uint32_t bands = r->segment / 2 - 1;
    for (uint32_t i = 0; i < bands; i++) {
        print_pair("    {", "frequency", r->band[i].frequency, ", ");
        print_pair("", "density", r->band[i].density, ", ");
        print_pair("", "direction_from", r->band[i].direction_from, ", ");
        print_pair("", "spread", r->band[i].spread, i + 1 < bands ? "},\n" : "}\n");
    }
    printf("  ]\n}\n");
}

static void print_table(const record *r) {
    const bolan_record_statistics *s = &r->statistics;
    printf("buoy, %u samples at %g a second, %u waves\n\n", (unsigned)r->count, r->rate, (unsigned)s->waves);
    const struct {
        const char *what, *unit;
        double value;
    } list[] = {{"Hm0, 4 standard deviations", "m", s->hm0},
                {"H1/3", "m", s->h_third},
                {"H1/10", "m", s->h_tenth},
                {"mean height", "m", s->h_mean},
                {"highest wave", "m", s->h_max},
                {"highest crest", "m", s->crest_max},
                {"Tz", "s", s->tz},
                {"T1/3", "s", s->t_third},
                {"skewness", "", s->skewness},
                {"kurtosis", "", s->kurtosis}};
    for (size_t i = 0; i < sizeof list / sizeof *list; i++)
        printf("  %-26s %12.5g %s\n", list[i].what, list[i].value, list[i].unit);
    printf("\n  higher than   share of waves\n");
    for (int i = 0; i < LEVELS; i++)
        printf("  %8.3f m    %12.4f\n", exceeded[i] * s->hm0,
               bolan_record_exceedance(r->waves, s->waves, exceeded[i] * s->hm0));
    printf("\n  frequency Hz   density m2/Hz   from deg   spread deg\n");
    const double least = 1e-3 * s->hm0 * s->hm0; // of a density that is worth a line
    for (uint32_t i = 0; i < r->segment / 2 - 1; i++) {
        const bolan_record_band *b = &r->band[i];
        if (b->density > least)
            printf("  %12.5f %15.5g %10.1f %12.1f\n", b->frequency, b->density, b->direction_from, b->spread);
    }
}

static int finish(record *r, const options *o) {
    if (bolan_record_measure(r->heave, r->count, r->rate, &r->statistics)) return EXIT_FAILED;
    bolan_record_waves(r->heave, r->count, r->rate, r->count, r->waves);
    if (bolan_record_spectrum(r->heave, r->east, r->north, r->count, r->rate, r->segment, r->band)) return EXIT_FAILED;
    if (o->output && !write_file(r, o->output)) return EXIT_FAILED;
    (o->json ? print_json : print_table)(r);
    return EXIT_OK;
}

int buoy_measure(const options *o, const bolan_sea *sea) {
    if (o->output && bolan_file_check_writable(o->output)) return EXIT_FAILED;
    record *r = calloc(1, sizeof *r);
    bolan_sea *fork = NULL;
    int result = EXIT_FAILED;
    if (!r || !create(r, o, bolan_sea_time(sea))) {
        failure("no memory for the record of a buoy");
    } else if (bolan_sea_fork(sea, &fork) == BOLAN_OK) {
        sail(r, o, fork);
        result = finish(r, o);
    }
    bolan_sea_destroy(&fork);
    if (r) free(r->heave), free(r->waves);
    free(r);
    return result;
}

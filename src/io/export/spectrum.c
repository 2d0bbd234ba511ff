// SPDX-License-Identifier: MIT
// A sea's spectrum as a file: a table (.csv), SWAN text (.spec), a polar plot (.png, spectrum_plot.c).
#include "io/export/writer.h"
#include "io/spectrum_plot.h"

#include <math.h>

typedef void write_form(const bolan_measured_view *v, export_writer *w);

// A number that reads back as itself to 12 digits, whatever the locale.
static void put_number(export_writer *w, double value, char after) {
    bolan_export_number(w, value, 12);
    bolan_export_bytes(w, &after, 1);
}

static double from_degrees(double theta) {
    const double degrees = bolan_math_to_compass_from(theta);
    return degrees < 360.0 ? degrees : 0.0;
}

// m2 s/rad per rad to m2/Hz per degree.
static double per_hertz_and_degree(double density) { return density * 2.0 * BOLAN_PI * BOLAN_PI / 180.0; }

static void write_csv(const bolan_measured_view *v, export_writer *w) {
    bolan_export_text(w, "frequency_hz,direction_from_deg,density_m2_per_hz_per_deg\n");
    for (uint32_t i = 0; i < v->frequency_count; i++)
        for (uint32_t j = 0; j < v->direction_count; j++) {
            put_number(w, v->omega[i] / (2.0 * BOLAN_PI), ',');
            put_number(w, from_degrees(v->theta[j]), ',');
            put_number(w, per_hertz_and_degree(v->density[(size_t)i * v->direction_count + j]), '\n');
        }
}

// "2018-01-01T06:00Z" as SWAN's 20180101.060000.
static void write_time(export_writer *w, const char *time) {
    char digits[15] = "00000000000000";
    size_t n = 0;
    for (const char *p = time; *p && n < 14; p++)
        if (*p >= '0' && *p <= '9') digits[n++] = *p;
    bolan_export_text(w, "%.8s.%s\n", digits, digits + 8);
}

// Whole numbers and a factor (SWAN user manual, appendix D). Below 1e7, since eight digits may be a date; no error is
// above 5e-8 of the largest density.
static void write_matrix(const bolan_measured_view *v, export_writer *w) {
    double largest = 0.0;
    const size_t n = (size_t)v->frequency_count * v->direction_count;
    for (size_t k = 0; k < n; k++) largest = fmax(largest, per_hertz_and_degree(v->density[k]));
    if (!(largest > 0.0)) {
        bolan_export_text(w, "ZERO\n");
        return;
    }
    const double factor = largest / 9999999.0;
    bolan_export_text(w, "FACTOR\n");
    put_number(w, factor, '\n');
    for (size_t k = 0; k < n; k++)
        bolan_export_text(w, "%.0f%c", round(per_hertz_and_degree(v->density[k]) / factor),
                          (k + 1) % v->direction_count ? ' ' : '\n');
}

static void write_swan(const bolan_measured_view *v, export_writer *w) {
    bolan_export_text(w, "SWAN 1\n$ written by Bolan %s\n", bolan_version());
    if (v->time[0]) bolan_export_text(w, "TIME\n1\n");
    bolan_export_text(w, "%s\n1\n", v->place.spherical ? "LONLAT" : "LOCATIONS");
    put_number(w, v->place.x, ' ');
    put_number(w, v->place.y, '\n');
    bolan_export_text(w, "AFREQ\n%u\n", (unsigned)v->frequency_count);
    for (uint32_t i = 0; i < v->frequency_count; i++) put_number(w, v->omega[i] / (2.0 * BOLAN_PI), '\n');
    bolan_export_text(w, "NDIR\n%u\n", (unsigned)v->direction_count);
    for (uint32_t j = 0; j < v->direction_count; j++) put_number(w, from_degrees(v->theta[j]), '\n');
    bolan_export_text(w, "QUANT\n1\nVaDens\nm2/Hz/degr\n-99\n");
    if (v->time[0]) write_time(w, v->time);
    write_matrix(v, w);
}

static bolan_result write_text(const char *path, const bolan_measured_view *v, write_form *write) {
    export_writer w;
    const bolan_result result = bolan_export_open(path, &w);
    if (result) return result;
    write(v, &w);
    return bolan_export_close(&w, true);
}

bolan_result bolan_spectrum_save(const char *path, const bolan_sea_state *sea_state, const char *title) {
    BOLAN_ASSERT(path && sea_state && title);
    write_form *const write = bolan_export_has_suffix(path, ".csv")    ? write_csv
                              : bolan_export_has_suffix(path, ".spec") ? write_swan
                                                                       : NULL;
    if (!write && !bolan_export_has_suffix(path, ".png")) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_BAD_ARGUMENT,
                  "%s: the suffix names no form of a spectrum; expected .png, .csv or .spec", path);
        return BOLAN_ERROR_ARGUMENT;
    }
    bolan_measured_spectrum *spectrum = NULL;
    bolan_result result = bolan_measured_spectrum_sample(sea_state, &spectrum);
    if (result) return result;
    const bolan_measured_view view = bolan_measured_spectrum_view(spectrum);
    result = write ? write_text(path, &view, write) : bolan_spectrum_plot(path, sea_state, spectrum, title);
    bolan_measured_spectrum_destroy(&spectrum);
    return result;
}

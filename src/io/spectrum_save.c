// SPDX-License-Identifier: MIT
// A sea's spectrum as a file: a table (.csv), SWAN text (.spec), a polar plot (.png, spectrum_plot.c).
#include "io/file.h"
#include "io/spectrum_plot.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

// Text that grows.
typedef struct writer {
    char *text;
    size_t size, capacity;
    bool failed;
} writer;

#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
static void
put(writer *w, const char *format, ...) {
    char piece[256];
    va_list arguments;
    va_start(arguments, format);
    const int length = vsnprintf(piece, sizeof piece, format, arguments);
    va_end(arguments);
    if (w->failed || length < 0) return;
    const size_t used = (size_t)length < sizeof piece ? (size_t)length : sizeof piece - 1;
    if (w->size + used > w->capacity) {
        const size_t larger = w->capacity ? 2 * w->capacity : 1 << 16;
        char *text = bolan_enlarge(w->text, w->capacity, larger);
        w->failed = !text;
        if (!text) return;
        w->text = text;
        w->capacity = larger;
    }
    memcpy(w->text + w->size, piece, used);
    w->size += used;
}

// A number that reads back as itself to 12 digits, whatever the locale.
static void put_number(writer *w, double value, char after) {
    char text[32];
    bolan_format(text, sizeof text, "%.12g", value);
    put(w, "%s%c", text, after);
}

static double from_degrees(double theta) {
    const double degrees = bolan_math_to_compass_from(theta);
    return degrees < 360.0 ? degrees : 0.0;
}

// m2 s/rad per rad to m2/Hz per degree.
static double per_hertz_and_degree(double density) { return density * 2.0 * BOLAN_PI * BOLAN_PI / 180.0; }

static void write_csv(const bolan_measured_view *v, writer *w) {
    put(w, "frequency_hz,direction_from_deg,density_m2_per_hz_per_deg\n");
    for (uint32_t i = 0; i < v->frequency_count; i++)
        for (uint32_t j = 0; j < v->direction_count; j++) {
            put_number(w, v->omega[i] / (2.0 * BOLAN_PI), ',');
            put_number(w, from_degrees(v->theta[j]), ',');
            put_number(w, per_hertz_and_degree(v->density[(size_t)i * v->direction_count + j]), '\n');
        }
}

// "2018-01-01T06:00Z" as SWAN's 20180101.060000.
static void write_time(writer *w, const char *time) {
    char digits[15] = "00000000000000";
    size_t n = 0;
    for (const char *p = time; *p && n < 14; p++)
        if (*p >= '0' && *p <= '9') digits[n++] = *p;
    put(w, "%.8s.%s\n", digits, digits + 8);
}

// Whole numbers and a factor (SWAN user manual, appendix D). Below 1e7, since eight digits may be a date; no error is
// above 5e-8 of the largest density.
static void write_matrix(const bolan_measured_view *v, writer *w) {
    double largest = 0.0;
    const size_t n = (size_t)v->frequency_count * v->direction_count;
    for (size_t k = 0; k < n; k++) largest = fmax(largest, per_hertz_and_degree(v->density[k]));
    if (!(largest > 0.0)) {
        put(w, "ZERO\n");
        return;
    }
    const double factor = largest / 9999999.0;
    put(w, "FACTOR\n");
    put_number(w, factor, '\n');
    for (size_t k = 0; k < n; k++)
        put(w, "%.0f%c", round(per_hertz_and_degree(v->density[k]) / factor),
            (k + 1) % v->direction_count ? ' ' : '\n');
}

static void write_swan(const bolan_measured_view *v, writer *w) {
    put(w, "SWAN 1\n$ written by Bolan %s\n", bolan_version());
    if (v->time[0]) put(w, "TIME\n1\n");
    put(w, "%s\n1\n", v->place.spherical ? "LONLAT" : "LOCATIONS");
    put_number(w, v->place.x, ' ');
    put_number(w, v->place.y, '\n');
    put(w, "AFREQ\n%u\n", (unsigned)v->frequency_count);
    for (uint32_t i = 0; i < v->frequency_count; i++) put_number(w, v->omega[i] / (2.0 * BOLAN_PI), '\n');
    put(w, "NDIR\n%u\n", (unsigned)v->direction_count);
    for (uint32_t j = 0; j < v->direction_count; j++) put_number(w, from_degrees(v->theta[j]), '\n');
    put(w, "QUANT\n1\nVaDens\nm2/Hz/degr\n-99\n");
    if (v->time[0]) write_time(w, v->time);
    write_matrix(v, w);
}

static bool ends_in(const char *path, const char *suffix) {
    const size_t length = strlen(path), tail = strlen(suffix);
    return length > tail && strcmp(path + length - tail, suffix) == 0;
}

bolan_result bolan_spectrum_save(const char *path, const bolan_sea_state *sea_state, const char *title) {
    BOLAN_ASSERT(path && sea_state && title);
    void (*const write)(const bolan_measured_view *, writer *) = ends_in(path, ".csv")    ? write_csv
                                                                 : ends_in(path, ".spec") ? write_swan
                                                                                          : NULL;
    if (!write && !ends_in(path, ".png")) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_BAD_ARGUMENT,
                  "%s: the suffix names no form of a spectrum; expected .png, .csv or .spec", path);
        return BOLAN_ERROR_ARGUMENT;
    }
    bolan_measured_spectrum *spectrum = NULL;
    writer w = {.text = NULL};
    bolan_result result = bolan_measured_spectrum_sample(sea_state, &spectrum);
    if (result) return result;
    const bolan_measured_view view = bolan_measured_spectrum_view(spectrum);
    if (write) {
        write(&view, &w);
        if (w.failed) bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY, "%s: no memory to write it", path);
        result = w.failed ? BOLAN_ERROR_MEMORY : bolan_file_write(path, w.text, w.size);
        bolan_release(w.text, w.capacity);
    } else {
        result = bolan_spectrum_plot(path, sea_state, spectrum, title);
    }
    bolan_measured_spectrum_destroy(&spectrum);
    return result;
}

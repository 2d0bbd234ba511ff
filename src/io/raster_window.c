// SPDX-License-Identifier: MIT
// Which pixels a plan needs, and reading them: thinned when there are too many, in two pieces where a global raster's
// seam lies between them, holes filled.
#include "io/raster.h"

#include <cpl_error.h>
#include <stdlib.h>

enum { MOST_SAMPLES = 6144, PROBES = 33, MARGIN = 3 };

typedef struct bounds {
    double x0, y0, x1, y1;
} bounds;

// Pixel bounds of the plan's area: a net of points, since its edges are curved in the raster.
static bounds pixel_bounds(const raster_source *source, const raster_plan *plan) {
    bounds b = {HUGE_VAL, HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    for (int j = 0; j < PROBES; j++) {
        double x[PROBES], y[PROBES];
        for (int i = 0; i < PROBES; i++) {
            x[i] = plan->west + plan->step * (plan->width - 1) * i / (PROBES - 1);
            y[i] = plan->south + plan->step * (plan->height - 1) * j / (PROBES - 1);
        }
        raster_local_to_pixel(source, PROBES, x, y);
        for (int i = 0; i < PROBES; i++) {
            b.x0 = fmin(b.x0, x[i]), b.x1 = fmax(b.x1, x[i]); // fmin and fmax pass NAN by
            b.y0 = fmin(b.y0, y[i]), b.y1 = fmax(b.y1, y[i]);
        }
    }
    return b;
}

// [low, high] in whole pixels with a margin for the interpolation, not beyond [0, size).
static void clip(double low, double high, int size, int *first, int *count) {
    const double a = fmax(floor(low) - MARGIN, 0.0), b = fmin(ceil(high) + MARGIN, (double)size);
    *first = b > a ? (int)a : a >= size ? size - 1 : 0;
    *count = b > a ? (int)(b - a) : 1;
}

static void place_window(const raster_source *source, const bounds *b, raster_window *w) {
    clip(b->y0, b->y1, source->height, &w->y, &w->height);
    if (source->period > 0) {
        w->x = (int)floor(b->x0) - MARGIN;
        const double span = ceil(b->x1) + MARGIN - w->x;
        w->width = (int)fmin(span, source->period);
    } else {
        clip(b->x0, b->x1, source->width, &w->x, &w->width);
    }
    const int longer = w->width > w->height ? w->width : w->height;
    w->pixels_per_sample = (double)((longer + MOST_SAMPLES - 1) / MOST_SAMPLES);
    w->width = (int)ceil(w->width / w->pixels_per_sample);
    w->height = (int)ceil(w->height / w->pixels_per_sample);
}

// Samples [first, first + count) of every row, from the raster's own columns starting at column.
static bool read_piece(const raster_source *source, raster_window *w, int first, int count, int column) {
    GDALRasterIOExtraArg how;
    INIT_RASTERIO_EXTRA_ARG(how);
    how.eResampleAlg = w->pixels_per_sample > 1.0 ? GRIORA_Average : GRIORA_NearestNeighbour;
    const int columns = (int)fmin(count * w->pixels_per_sample, source->width - column);
    const int rows = (int)fmin(w->height * w->pixels_per_sample, source->height - w->y);
    return GDALRasterIOEx(source->band, GF_Read, column, w->y, columns, rows, w->values + first, count, w->height,
                          GDT_Float32, 0, (GSpacing)w->width * (GSpacing)sizeof(float), &how) == CE_None;
}

static bool read_pixels(const raster_source *source, raster_window *w) {
    if (source->period == 0) return read_piece(source, w, 0, w->width, w->x);
    for (int first = 0; first < w->width;) {
        const int pixel = w->x + (int)(first * w->pixels_per_sample);
        const int column = ((pixel % source->period) + source->period) % source->period;
        if (column >= source->width) return false; // cannot be: a global raster has all its columns
        int count = (int)ceil((source->width - column) / w->pixels_per_sample);
        if (count > w->width - first) count = w->width - first;
        if (!read_piece(source, w, first, count, column)) return false;
        first += count;
    }
    return true;
}

static void mark_holes_and_scale(const raster_source *source, raster_window *w, double vertical_scale) {
    int has_hole = 0, has_scale = 0, has_offset = 0;
    const double hole = GDALGetRasterNoDataValue(source->band, &has_hole);
    double scale = GDALGetRasterScale(source->band, &has_scale),
           offset = GDALGetRasterOffset(source->band, &has_offset);
    if (!has_scale || scale == 0.0) scale = 1.0;
    if (!has_offset) offset = 0.0;
    const float hole_f = (float)hole; // the band may hold it rounded to float
    for (size_t i = 0; i < (size_t)w->width * (size_t)w->height; i++) {
        const float value = w->values[i];
        const double metres = ((double)value * scale + offset) * vertical_scale;
        const bool known = isfinite(value) && !(has_hole && value == hole_f) && fabs(metres) < 1e5;
        w->values[i] = known ? (float)metres : NAN;
    }
}

bolan_result raster_window_read(const raster_source *source, const raster_plan *plan, double vertical_scale,
                                raster_window *out) {
    const bounds b = pixel_bounds(source, plan);
    *out = (raster_window){0};
    place_window(source, &b, out);
    out->bytes = (size_t)out->width * (size_t)out->height * sizeof(float);
    out->values = bolan_allocate(out->bytes);
    if (!out->values) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY, "%s: no memory for %dx%d samples", source->path, out->width,
                  out->height);
        return BOLAN_ERROR_MEMORY;
    }
    bolan_result result = BOLAN_OK;
    if (!read_pixels(source, out)) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_FILE_READ, "%s: its pixels cannot be read: %.200s", source->path,
                  CPLGetLastErrorMsg());
        result = BOLAN_ERROR_IO;
    } else {
        mark_holes_and_scale(source, out, vertical_scale);
        if (!raster_fill(out->values, out->width, out->height)) {
            bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_RASTER_EMPTY,
                      "%s: there is no elevation around the place that was asked for, only no-data", source->path);
            result = BOLAN_ERROR_FORMAT;
        }
    }
    if (result) raster_window_release(out);
    return result;
}

void raster_window_release(raster_window *window) {
    bolan_release(window->values, window->bytes);
    *window = (raster_window){0};
}

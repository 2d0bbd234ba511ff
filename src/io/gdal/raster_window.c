// SPDX-License-Identifier: MIT
// Reads the pixels that a plan needs: thinned when there are too many, in two pieces where the seam of a global raster
// lies between them. Then converts the numbers of the file to metres, with NAN where there is no data.
#include "io/gdal/raster.h"

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
            x[i] = plan->west + plan->step_x * (plan->width - 1) * i / (PROBES - 1);
            y[i] = plan->south + plan->step_y * (plan->height - 1) * j / (PROBES - 1);
        }
        bolan_raster_local_to_pixel(source, PROBES, x, y);
        for (int i = 0; i < PROBES; i++) {
            b.x0 = fmin(b.x0, x[i]), b.x1 = fmax(b.x1, x[i]); // fmin and fmax ignore NAN
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

// Part of a band into memory: samples [first, first + count) of every row, from the raster's columns from column on.
typedef struct piece {
    GDALRasterBandH band;
    void *to;
    GDALDataType type;
    int bytes; // of a sample in memory
} piece;

static bool read_piece(const raster_source *source, const raster_window *w, const piece *p, int first, int count,
                       int column) {
    GDALRasterIOExtraArg how;
    INIT_RASTERIO_EXTRA_ARG(how);
    // GDAL leaves declared no-data and masked pixels out of its averages; a value that only the desc names, it does
    // not.
    const bool average = w->pixels_per_sample > 1.0 && p->type == GDT_Float32 && isnan(source->desc->nodata_value);
    how.eResampleAlg = average ? GRIORA_Average : GRIORA_NearestNeighbour;
    const int columns = (int)fmin(count * w->pixels_per_sample, source->width - column);
    const int rows = (int)fmin(w->height * w->pixels_per_sample, source->height - w->y);
    return GDALRasterIOEx(p->band, GF_Read, column, w->y, columns, rows,
                          (char *)p->to + (size_t)first * (size_t)p->bytes, count, w->height, p->type, 0,
                          (GSpacing)w->width * p->bytes, &how) == CE_None;
}

static bool read_pixels(const raster_source *source, const raster_window *w, const piece *p) {
    if (source->period == 0) return read_piece(source, w, p, 0, w->width, w->x);
    for (int first = 0; first < w->width;) {
        const int pixel = w->x + (int)(first * w->pixels_per_sample);
        const int column = ((pixel % source->period) + source->period) % source->period;
        if (column >= source->width) return false; // cannot be: a global raster has all its columns
        int count = (int)ceil((source->width - column) / w->pixels_per_sample);
        if (count > w->width - first) count = w->width - first;
        if (!read_piece(source, w, p, first, count, column)) return false;
        first += count;
    }
    return true;
}

// ---- from numbers to metres -----------------------------------------------------------------------------------------

#define LOWEST (-12000.0) // below every place on Earth [m]: the Challenger Deep is 10 935 m deep
#define HIGHEST 9000.0    // above every place on Earth [m]: Mount Everest is 8849 m high
#define LARGEST 1e5       // with every exaggeration [m]
#define USUAL_VOID (-9999.0f)
#define NEAR_VOID (-9000.0f) // a file with other values below this one has real data there

// NAN where the file says that there is no data. Values stay as in the file.
static void mark_holes(const raster_source *source, raster_window *w, const uint8_t *mask) {
    int declared = 0;
    const double hole = GDALGetRasterNoDataValue(source->band, &declared);
    const float hole_f = (float)hole, own_f = (float)source->desc->nodata_value; // the band may hold them rounded
    for (size_t i = 0; i < (size_t)w->width * (size_t)w->height; i++) {
        const float value = w->values[i];
        if (!isfinite(value) || (declared && value == hole_f) || value == own_f || (mask && mask[i] == 0))
            w->values[i] = NAN;
    }
}

// -9999 is the usual void; an undeclared one stands alone, far below all else.
static size_t mark_usual_voids(const raster_source *source, raster_window *w) {
    size_t voids = 0;
    float lowest = INFINITY;
    const size_t count = (size_t)w->width * (size_t)w->height;
    for (size_t i = 0; i < count; i++) {
        voids += w->values[i] == USUAL_VOID;
        if (w->values[i] != USUAL_VOID) lowest = fminf(lowest, w->values[i]); // ignores NAN
    }
    if (voids == 0 || lowest < NEAR_VOID || !isnan(source->desc->nodata_value)) return 0;
    for (size_t i = 0; i < count; i++)
        if (w->values[i] == USUAL_VOID) w->values[i] = NAN;
    return voids;
}

static void read_scale(const raster_source *source, double *scale, double *offset) {
    int has_scale = 0, has_offset = 0;
    *scale = GDALGetRasterScale(source->band, &has_scale);
    *offset = GDALGetRasterOffset(source->band, &has_offset);
    if (!has_scale || *scale == 0.0) *scale = 1.0;
    if (!has_offset) *offset = 0.0;
}

// A band that is called a depth but states no direction: depths if most of its values are positive.
static void decide_direction(raster_source *source, const raster_window *w, double scale, double offset) {
    size_t positive = 0, known = 0;
    for (size_t i = 0; i < (size_t)w->width * (size_t)w->height; i++) {
        known += !isnan(w->values[i]);
        positive += (double)w->values[i] * scale + offset > 0.0;
    }
    source->perhaps_down = false;
    if (2 * positive <= known) return;
    source->metres = -source->metres;
    bolan_log(
        BOLAN_LOG_WARNING, BOLAN_LOG_RASTER_UNIT,
        "%s: %s is called a depth and is mostly positive; it is taken as positive downwards (vertical_scale: 1 says "
        "otherwise)",
        source->path, source->variable);
}

static void to_metres(raster_source *source, raster_window *w, const uint8_t *mask) {
    double scale, offset;
    read_scale(source, &scale, &offset);
    mark_holes(source, w, mask);
    size_t strange = mark_usual_voids(source, w);
    if (source->perhaps_down) decide_direction(source, w, scale, offset);
    // A scale of the caller may exaggerate; heights above those of the Earth are then intended.
    const double exaggeration = isnan(source->desc->vertical_scale) ? 1.0 : fmax(fabs(source->metres), 1.0);
    for (size_t i = 0; i < (size_t)w->width * (size_t)w->height; i++) {
        if (isnan(w->values[i])) continue;
        const double z = ((double)w->values[i] * scale + offset) * source->metres, real = z / exaggeration;
        const bool possible = real >= LOWEST && real <= HIGHEST && fabs(z) <= LARGEST;
        w->values[i] = possible ? (float)z : NAN;
        strange += !possible;
    }
    if (strange == 0) return;
    bolan_log(
        BOLAN_LOG_WARNING, BOLAN_LOG_RASTER_VALUES,
        "%s: %zu samples are below -12000 m, above 9000 m or a lone -9999, as no place on Earth is; they count as "
        "no-data (nodata_value and vertical_scale say otherwise)",
        source->path, strange);
}

// ---- the window -----------------------------------------------------------------------------------------------------

static bolan_result read_window(raster_source *source, raster_window *w) {
    const size_t count = (size_t)w->width * (size_t)w->height, mask_bytes = source->mask ? count : 0;
    uint8_t *mask = bolan_allocate(mask_bytes);
    w->bytes = count * sizeof(float);
    w->values = bolan_allocate(w->bytes);
    if (!w->values || (mask_bytes && !mask)) {
        bolan_release(mask, mask_bytes);
        return bolan_raster_no_memory(source->path, count, "samples");
    }
    const piece values = {source->band, w->values, GDT_Float32, (int)sizeof(float)},
                masked = {source->mask, mask, GDT_Byte, 1};
    const bool ok = read_pixels(source, w, &values) && (!mask || read_pixels(source, w, &masked));
    if (ok) to_metres(source, w, mask);
    bolan_release(mask, mask_bytes);
    if (ok) return BOLAN_OK;
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_FILE_READ, "%s: its pixels cannot be read: %.200s", source->path,
              CPLGetLastErrorMsg());
    return BOLAN_ERROR_IO;
}

// Metres of a sample along the raster's rows and columns, in the middle of the plan.
static void sample_size(const raster_source *source, const raster_plan *plan, double per_sample, double *width,
                        double *height) {
    const double east = plan->west + 0.5 * plan->step_x * (plan->width - 1),
                 north = plan->south + 0.5 * plan->step_y * (plan->height - 1), metres = 100.0;
    double x[3] = {east, east + metres, east}, y[3] = {north, north, north + metres};
    bolan_raster_local_to_pixel(source, 3, x, y);
    // Pixels per metre eastwards (a, c) and northwards (b, d); the inverse has the vectors of a pixel.
    const double a = (x[1] - x[0]) / metres, b = (x[2] - x[0]) / metres, c = (y[1] - y[0]) / metres,
                 d = (y[2] - y[0]) / metres, determinant = fabs(a * d - b * c);
    *width = per_sample * hypot(d, c) / determinant;
    *height = per_sample * hypot(b, a) / determinant;
    if (!isfinite(*width) || !isfinite(*height)) *width = *height = fmax(plan->step_x, plan->step_y);
}

bolan_result bolan_raster_window_read(raster_source *source, const raster_plan *plan, raster_window *out) {
    const bounds b = pixel_bounds(source, plan);
    *out = (raster_window){0};
    place_window(source, &b, out);
    bolan_result result = read_window(source, out);
    if (!result) {
        double width, height;
        sample_size(source, plan, out->pixels_per_sample, &width, &height);
        result = bolan_raster_holes(source, out, width, height);
    }
    if (result) bolan_raster_window_release(out);
    return result;
}

void bolan_raster_window_release(raster_window *window) {
    bolan_release(window->values, window->bytes);
    *window = (raster_window){0};
}

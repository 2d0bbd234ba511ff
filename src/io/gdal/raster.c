// SPDX-License-Identifier: MIT
// Terrain from any raster that GDAL reads: the plan of the local grid, and the steps in their order. See raster.h.
#include "io/gdal/raster.h"

#include <cpl_error.h>
#include <stdio.h>
#include <string.h>

enum { MOST_SAMPLES_A_SIDE = 4096, EDGE_PROBES = 33 };

// ---- the plan -------------------------------------------------------------------------------------------------------

typedef struct rectangle {
    double west, south, east, north;
} rectangle;

static void include(rectangle *r, double x, double y) {
    r->west = fmin(r->west, x), r->east = fmax(r->east, x);
    r->south = fmin(r->south, y), r->north = fmax(r->north, y);
}

// The rectangle of the raster in local metres; unlimited for a raster that covers much of the globe.
static rectangle footprint(const raster_source *s) {
    const rectangle world = {-HUGE_VAL, -HUGE_VAL, HUGE_VAL, HUGE_VAL};
    if (s->geographic && fabs(s->to_map[1]) * s->width > 90.0) return world;
    rectangle r = {HUGE_VAL, HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    OGRCoordinateTransformationH to_local = s->planar ? NULL : OCTGetInverse(s->local_to_map);
    bool ok = s->planar || to_local;
    for (int i = 0; i < 4 * EDGE_PROBES && ok; i++) {
        // From centre to centre of the rim's pixels, where there are values.
        const double t = (double)(i % EDGE_PROBES) / (EDGE_PROBES - 1);
        const double across = 0.5 + t * (s->width - 1), down = 0.5 + t * (s->height - 1);
        const double px = i / EDGE_PROBES < 2 ? across : i / EDGE_PROBES == 2 ? 0.5 : s->width - 0.5;
        const double py = i / EDGE_PROBES >= 2 ? down : i / EDGE_PROBES == 0 ? 0.5 : s->height - 0.5;
        double x, y;
        bolan_raster_map_point(s->to_map, px, py, &x, &y);
        ok = !to_local || OCTTransform(to_local, 1, &x, &y, NULL);
        include(&r, x - (s->planar ? s->origin_x : 0.0), y - (s->planar ? s->origin_y : 0.0));
    }
    if (to_local) OCTDestroyCoordinateTransformation(to_local);
    return ok ? r : world;
}

// Metres per pixel in the middle of a rectangle, the finer direction.
static double native_step(const raster_source *s, const rectangle *r) {
    const double east = 0.5 * (r->west + r->east), north = 0.5 * (r->south + r->north), metres = 100.0;
    double x[3] = {east, east + metres, east}, y[3] = {north, north, north + metres};
    bolan_raster_local_to_pixel(s, 3, x, y);
    const double per_metre = fmax(hypot(x[1] - x[0], y[1] - y[0]), hypot(x[2] - x[0], y[2] - y[0])) / metres;
    return per_metre > 0.0 && isfinite(per_metre) ? 1.0 / per_metre : 1000.0;
}

static bolan_result place_outside(const raster_source *s) {
    double west, north, east, south;
    bolan_raster_map_point(s->to_map, 0, 0, &west, &north);
    bolan_raster_map_point(s->to_map, s->width, s->height, &east, &south);
    bolan_log(
        BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_RANGE,
        "%s: the place that was asked for lies outside the raster, which covers %.6g to %.6g north and %.6g to %.6g "
        "east%s",
        s->path, fmin(south, north), fmax(south, north), west, east, s->geographic ? "" : " on its map");
    return BOLAN_ERROR_ARGUMENT;
}

static bolan_result make_plan(const raster_source *s, double radius, raster_plan *plan) {
    const rectangle f = footprint(s);
    const rectangle r = {fmax(f.west, -radius), fmax(f.south, -radius), fmin(f.east, radius), fmin(f.north, radius)};
    if (!(r.east - r.west > 1.0 && r.north - r.south > 1.0)) {
        return place_outside(s);
    }
    const double east = r.east - r.west, north = r.north - r.south, longer = fmax(east, north);
    const double step = fmin(fmax(native_step(s, &r), longer / (MOST_SAMPLES_A_SIDE - 1)), longer / 2.0);
    // The count is rounded up and the step shortened, so that the grid ends exactly at the rim of the area.
    plan->west = r.west;
    plan->south = r.south;
    plan->width = (uint32_t)fmax(ceil(east / step - 1e-6), 1.0) + 1;
    plan->height = (uint32_t)fmax(ceil(north / step - 1e-6), 1.0) + 1;
    plan->step_x = east / (plan->width - 1);
    plan->step_y = north / (plan->height - 1);
    return BOLAN_OK;
}

// ---- the terrain ----------------------------------------------------------------------------------------------------

// The elevation beyond the grid: the mean depth of its rim where the rim is sea, or a shelf of 50 m where all is land.
static double elevation_beyond(const raster_plan *plan, const float *grid) {
    double sum = 0.0;
    size_t count = 0;
    for (uint32_t j = 0; j < plan->height; j++) {
        const uint32_t step = j == 0 || j == plan->height - 1 ? 1 : plan->width - 1;
        for (uint32_t i = 0; i < plan->width; i += step) {
            const float z = grid[(size_t)j * plan->width + i];
            if (z < 0.0f) sum += (double)z, count++;
        }
    }
    return count ? fmin(sum / (double)count, -10.0) : -50.0;
}

static bolan_result make_terrain(const raster_source *s, const raster_plan *plan, float *grid, bolan_ground **out) {
    // Points outside the domain of the projection have no value yet.
    const bolan_result result = bolan_raster_fill(s->path, grid, (int)plan->width, (int)plan->height);
    if (result == BOLAN_ERROR_FORMAT)
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_RASTER_EMPTY, "%s: nothing of it lies around the place that was asked for",
                  s->path);
    if (result) return result;
    bolan_ground_desc d = bolan_ground_desc_default();
    d.field = (bolan_heightfield){plan->width, plan->height, plan->west, plan->south, plan->step_x, plan->step_y, grid};
    d.edge_elevation = elevation_beyond(plan, grid);
    return bolan_ground_create(&d, out);
}

static bolan_result read_terrain(raster_source *s, bolan_ground **out) {
    raster_plan plan;
    raster_window window;
    bolan_result result = make_plan(s, s->desc->radius, &plan);
    if (!result) result = bolan_raster_window_read(s, &plan, &window);
    if (result) return result;
    const size_t count = (size_t)plan.width * plan.height, bytes = count * sizeof(float);
    float *grid = bolan_allocate(bytes);
    result =
        grid ? bolan_raster_resample(s, &window, &plan, grid) : bolan_raster_no_memory(s->path, count, "elevations");
    if (!result) result = make_terrain(s, &plan, grid, out);
    bolan_release(grid, bytes);
    bolan_raster_window_release(&window);
    if (!result)
        bolan_log(BOLAN_LOG_INFO, BOLAN_LOG_RASTER_READ,
                  "%s: band %d%s%s, unit \"%s\" at %g m upwards, in %s, %ux%u elevations %.4g x %.4g m apart", s->path,
                  s->number, s->variable[0] ? " " : "", s->variable, s->unit[0] ? s->unit : "none", s->metres, s->crs,
                  (unsigned)plan.width, (unsigned)plan.height, plan.step_x, plan.step_y);
    return result;
}

static bool is_text(const char *text, size_t capacity) { return memchr(text, '\0', capacity) != NULL; }

static bolan_result check(const bolan_raster_desc *d) {
    if (!is_text(d->path, sizeof d->path) || !d->path[0] || !is_text(d->variable, sizeof d->variable) ||
        !is_text(d->crs, sizeof d->crs)) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_BAD_ARGUMENT,
                  "bolan_raster_desc: path is empty, or a text is not ended; expected a file");
        return BOLAN_ERROR_ARGUMENT;
    }
    const bool place =
        isnan(d->latitude) == isnan(d->longitude) && !(fabs(d->latitude) > 90.0) && !(fabs(d->longitude) > 360.0);
    const bool scale = isnan(d->vertical_scale) || (fabs(d->vertical_scale) >= 1e-3 && fabs(d->vertical_scale) <= 1e3);
    const bool names = (unsigned)d->nodata <= BOLAN_NODATA_SEA && (unsigned)d->zero <= BOLAN_ZERO_SEA;
    if (place && scale && names && d->radius >= 100.0 && d->radius <= 5e6 && d->band <= 65535) return BOLAN_OK;
    bolan_log(
        BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_RANGE,
        "%s: latitude %g, longitude %g, radius %g m, vertical scale %g, band %u, nodata %d, zero %d; expected +-90, "
        "+-360, 100 to 5e6, +-(1e-3 to 1e3), 0 to 65535, 0 to 2, 0 to 2",
        d->path, d->latitude, d->longitude, d->radius, d->vertical_scale, (unsigned)d->band, (int)d->nodata,
        (int)d->zero);
    return BOLAN_ERROR_ARGUMENT;
}

// Keeps the warnings of GDAL about the raster; its errors become part of the sentence that is logged.
static void CPL_STDCALL keep_message(CPLErr level, CPLErrorNum number, const char *text) {
    (void)number;
    raster_messages *m = CPLGetErrorHandlerUserData();
    if (level != CE_Warning || !m || m->count == RASTER_MOST_MESSAGES) return;
    char *line = m->text[m->count];
    snprintf(line, RASTER_MESSAGE_MAX, "%s", text);
    for (char *c = line; *c; c++)
        if ((unsigned char)*c < 32) *c = ' ';
    for (int i = 0; i < m->count; i++)
        if (strcmp(m->text[i], line) == 0) return;
    m->count++;
}

bolan_result bolan_raster_load(const bolan_raster_desc *desc, bolan_ground **out) {
    BOLAN_ASSERT(desc && out);
    *out = NULL;
    if (check(desc)) return BOLAN_ERROR_ARGUMENT;
    GDALAllRegister();
    raster_source source = {.desc = desc, .path = desc->path};
    CPLPushErrorHandlerEx(keep_message, &source.messages);
    bolan_result result = bolan_raster_open(&source);
    if (!result) result = bolan_raster_place(&source);
    if (!result) result = read_terrain(&source, out);
    if (source.local_to_map) OCTDestroyCoordinateTransformation(source.local_to_map);
    if (source.file) GDALClose(source.file);
    CPLPopErrorHandler();
    for (int i = 0; i < source.messages.count && !result; i++)
        bolan_log(BOLAN_LOG_WARNING, BOLAN_LOG_RASTER_LIBRARY, "%s: GDAL warns: %s", desc->path,
                  source.messages.text[i]);
    return result;
}

// SPDX-License-Identifier: MIT
// Terrain from any raster that GDAL reads: opening, georeference, and the plan of the local grid. See raster.h.
#include "io/raster.h"

#include <cpl_conv.h>
#include <cpl_error.h>
#include <cpl_string.h>
#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

enum { MOST_SAMPLES_A_SIDE = 4096, EDGE_PROBES = 33 };

// ---- opening --------------------------------------------------------------------------------------------------------

// GDAL's sentence on one line, or a general one.
static void last_gdal_message(char out[200]) {
    snprintf(out, 200, "%s", CPLGetLastErrorMsg());
    out[strcspn(out, "\r\n")] = '\0';
    if (out[0] == '\0') snprintf(out, 200, "no raster in it");
}

// A NetCDF or HDF file may hold several rasters: the first of them.
static GDALDatasetH open_first_raster(const char *path) {
    GDALDatasetH file = GDALOpenEx(path, GDAL_OF_RASTER | GDAL_OF_READONLY, NULL, NULL, NULL);
    if (!file || GDALGetRasterCount(file) > 0) return file;
    const char *name = CSLFetchNameValue(GDALGetMetadata(file, "SUBDATASETS"), "SUBDATASET_1_NAME");
    GDALDatasetH inner = name ? GDALOpenEx(name, GDAL_OF_RASTER | GDAL_OF_READONLY, NULL, NULL, NULL) : NULL;
    GDALClose(file);
    return inner;
}

static bolan_result open_file(const char *path, raster_source *s) {
    s->path = path;
    CPLErrorReset();
    s->file = open_first_raster(path);
    if (s->file && GDALGetRasterCount(s->file) > 0) {
        s->band = GDALGetRasterBand(s->file, 1);
        s->width = GDALGetRasterXSize(s->file);
        s->height = GDALGetRasterYSize(s->file);
        return BOLAN_OK;
    }
    char message[200];
    last_gdal_message(message);
    const bool missing = access(path, R_OK) != 0;
    bolan_log(BOLAN_LOG_ERROR, missing ? BOLAN_LOG_FILE_OPEN : BOLAN_LOG_RASTER_OPEN, "%s: %s: %s", path,
              missing ? "the raster cannot be read" : "not a raster that GDAL reads",
              missing ? strerror(errno) : message);
    return missing ? BOLAN_ERROR_IO : BOLAN_ERROR_FORMAT;
}

// ---- georeference ---------------------------------------------------------------------------------------------------

static void map_point(const double m[6], double x, double y, double *u, double *v) {
    *u = m[0] + m[1] * x + m[2] * y;
    *v = m[3] + m[4] * x + m[5] * y;
}

static OGRSpatialReferenceH reference_from(const char *definition) {
    OGRSpatialReferenceH reference = OSRNewSpatialReference(NULL);
    if (OSRSetFromUserInput(reference, definition) != OGRERR_NONE) {
        OSRDestroySpatialReference(reference);
        return NULL;
    }
    OSRSetAxisMappingStrategy(reference, OAMS_TRADITIONAL_GIS_ORDER); // longitude first
    return reference;
}

// Without a projection in the file: degrees if the numbers can be degrees, else metres.
static bool looks_like_degrees(const raster_source *s) {
    double west, north, east, south;
    map_point(s->to_map, 0, 0, &west, &north);
    map_point(s->to_map, s->width, s->height, &east, &south);
    return fabs(north) <= 91.0 && fabs(south) <= 91.0 && west >= -361.0 && east <= 721.0 && fabs(east - west) <= 361.0;
}

static OGRSpatialReferenceH own_reference(raster_source *s) {
    OGRSpatialReferenceH given = GDALGetSpatialRef(s->file);
    if (!given && !looks_like_degrees(s)) {
        s->planar = true;
        return NULL;
    }
    OGRSpatialReferenceH reference = given ? OSRClone(given) : reference_from("EPSG:4326");
    if (reference) OSRSetAxisMappingStrategy(reference, OAMS_TRADITIONAL_GIS_ORDER);
    s->geographic = reference && OSRIsGeographic(reference);
    return reference;
}

static bolan_result bad_projection(const raster_source *s, const char *what) {
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_RASTER_PROJECTION, "%s: %s", s->path, what);
    return BOLAN_ERROR_FORMAT;
}

// Where the raster's centre lies [deg].
static bool centre_of(const raster_source *s, OGRSpatialReferenceH map, double *latitude, double *longitude) {
    map_point(s->to_map, 0.5 * s->width, 0.5 * s->height, longitude, latitude);
    OGRSpatialReferenceH degrees = reference_from("EPSG:4326");
    OGRCoordinateTransformationH to_degrees = degrees ? OCTNewCoordinateTransformation(map, degrees) : NULL;
    const bool ok = to_degrees && OCTTransform(to_degrees, 1, longitude, latitude, NULL);
    if (to_degrees) OCTDestroyCoordinateTransformation(to_degrees);
    if (degrees) OSRDestroySpatialReference(degrees);
    return ok && isfinite(*latitude) && isfinite(*longitude);
}

static bolan_result project(raster_source *s, OGRSpatialReferenceH map, double latitude, double longitude) {
    if (isnan(latitude) && !centre_of(s, map, &latitude, &longitude))
        return bad_projection(s, "its centre has no latitude and longitude: the projection is not one that PROJ knows");
    char definition[160];
    CPLsnprintf(definition, sizeof definition, "+proj=aeqd +lat_0=%.9f +lon_0=%.9f +datum=WGS84 +units=m", latitude,
                longitude);
    OGRSpatialReferenceH local = reference_from(definition);
    if (local) s->local_to_map = OCTNewCoordinateTransformation(local, map);
    if (local) OSRDestroySpatialReference(local);
    if (!s->local_to_map) return bad_projection(s, "its projection is not one that PROJ can convert");
    s->centre_longitude = longitude;
    const double turn = fabs(s->to_map[1]) * s->width;
    if (s->geographic && turn > 359.9 && s->to_map[2] == 0.0) s->period = (int)lrint(360.0 / fabs(s->to_map[1]));
    return BOLAN_OK;
}

static bolan_result georeference(raster_source *s, double latitude, double longitude) {
    if (GDALGetGeoTransform(s->file, s->to_map) != CE_None || !GDALInvGeoTransform(s->to_map, s->to_pixel))
        return bad_projection(s, "it does not say where it lies; expected a raster with a georeference");
    OGRSpatialReferenceH map = own_reference(s);
    if (!s->planar && !map) return bad_projection(s, "its projection is not one that GDAL knows");
    bolan_result result = BOLAN_OK;
    if (!s->planar) {
        result = project(s, map, latitude, longitude);
        OSRDestroySpatialReference(map);
    } else if (!isnan(latitude)) {
        result =
            bad_projection(s, "it has no map projection, so a latitude and longitude cannot be found in it; leave the "
                              "place out to stand at its centre");
    } else {
        map_point(s->to_map, 0.5 * s->width, 0.5 * s->height, &s->origin_x, &s->origin_y);
    }
    return result;
}

// A longitude in the turn that begins 180 degrees west of the scene, then moved by whole turns towards the raster.
static double near_raster(const raster_source *s, double longitude) {
    const double centre = s->to_map[0] + 0.5 * s->width * s->to_map[1];
    const double scene = longitude - s->centre_longitude;
    const double unwrapped = s->centre_longitude + scene - 360.0 * rint(scene / 360.0);
    if (s->period > 0) return unwrapped; // the window goes around by itself
    return unwrapped - 360.0 * rint((unwrapped - centre) / 360.0);
}

void raster_local_to_pixel(const raster_source *s, int count, double *x, double *y) {
    if (s->local_to_map) OCTTransform(s->local_to_map, count, x, y, NULL); // what fails becomes HUGE_VAL
    for (int i = 0; i < count; i++) {
        double u = s->planar ? x[i] + s->origin_x : x[i], v = s->planar ? y[i] + s->origin_y : y[i];
        if (s->geographic) u = near_raster(s, u);
        const bool known = isfinite(u) && isfinite(v);
        map_point(s->to_pixel, u, v, &x[i], &y[i]);
        if (!known) x[i] = y[i] = (double)NAN;
    }
}

// ---- the plan -------------------------------------------------------------------------------------------------------

typedef struct rectangle {
    double west, south, east, north;
} rectangle;

static void include(rectangle *r, double x, double y) {
    r->west = fmin(r->west, x), r->east = fmax(r->east, x);
    r->south = fmin(r->south, y), r->north = fmax(r->north, y);
}

// Where the raster's edge lies in local metres; all the world for one that covers much of the globe.
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
        map_point(s->to_map, px, py, &x, &y);
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
    raster_local_to_pixel(s, 3, x, y);
    const double per_metre = fmax(hypot(x[1] - x[0], y[1] - y[0]), hypot(x[2] - x[0], y[2] - y[0])) / metres;
    return per_metre > 0.0 && isfinite(per_metre) ? 1.0 / per_metre : 1000.0;
}

static bolan_result place_outside(const raster_source *s) {
    double west, north, east, south;
    map_point(s->to_map, 0, 0, &west, &north);
    map_point(s->to_map, s->width, s->height, &east, &south);
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
    const double longer = fmax(r.east - r.west, r.north - r.south);
    plan->step = fmin(fmax(native_step(s, &r), longer / (MOST_SAMPLES_A_SIDE - 1)), longer / 2.0);
    plan->west = r.west;
    plan->south = r.south;
    plan->width = (uint32_t)fmax(floor((r.east - r.west) / plan->step + 1e-6) + 1.0, 2.0);
    plan->height = (uint32_t)fmax(floor((r.north - r.south) / plan->step + 1e-6) + 1.0, 2.0);
    return BOLAN_OK;
}

// ---- the terrain ----------------------------------------------------------------------------------------------------

// What lies beyond: the mean depth of the grid's rim where it is sea, or a shelf of 50 m where it is all land.
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

static bolan_result make_terrain(const raster_source *s, const raster_plan *plan, float *grid, bolan_terrain **out) {
    if (!raster_fill(grid, (int)plan->width, (int)plan->height)) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_RASTER_EMPTY, "%s: nothing of it lies around the place that was asked for",
                  s->path);
        return BOLAN_ERROR_FORMAT;
    }
    bolan_terrain_desc d = bolan_terrain_desc_default();
    d.field = (bolan_heightfield){plan->width, plan->height, plan->west, plan->south, plan->step, plan->step, grid};
    d.edge_elevation = elevation_beyond(plan, grid);
    return bolan_terrain_create(&d, out);
}

static bolan_result read_terrain(const raster_source *s, double radius, double vertical_scale, bolan_terrain **out) {
    raster_plan plan;
    raster_window window;
    bolan_result result = make_plan(s, radius, &plan);
    if (result) return result;
    result = raster_window_read(s, &plan, vertical_scale, &window);
    if (result) return result;
    const size_t bytes = (size_t)plan.width * plan.height * sizeof(float);
    float *grid = bolan_allocate(bytes);
    if (grid) {
        raster_resample(s, &window, &plan, grid);
        result = make_terrain(s, &plan, grid, out);
    } else {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY, "%s: no memory for %ux%u elevations", s->path,
                  (unsigned)plan.width, (unsigned)plan.height);
        result = BOLAN_ERROR_MEMORY;
    }
    bolan_release(grid, bytes);
    raster_window_release(&window);
    return result;
}

static bolan_result check(const char *path, double latitude, double longitude, double radius, double vertical_scale) {
    const bool place = isnan(latitude) == isnan(longitude) && !(fabs(latitude) > 90.0) && !(fabs(longitude) > 360.0);
    if (place && radius >= 100.0 && radius <= 5e6 && vertical_scale >= 1e-3 && vertical_scale <= 1e3) return BOLAN_OK;
    bolan_log(
        BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_RANGE,
        "%s: latitude %g, longitude %g, radius %g m, vertical scale %g; expected +-90, +-360, 100 to 5e6, 1e-3 to 1e3",
        path, latitude, longitude, radius, vertical_scale);
    return BOLAN_ERROR_ARGUMENT;
}

bolan_result bolan_raster_load(const char *path, double latitude, double longitude, double radius,
                               double vertical_scale, bolan_terrain **out) {
    BOLAN_ASSERT(path && out);
    *out = NULL;
    if (check(path, latitude, longitude, radius, vertical_scale)) return BOLAN_ERROR_ARGUMENT;
    GDALAllRegister();
    CPLPushErrorHandler(CPLQuietErrorHandler); // its messages become part of ours
    raster_source source = {.path = path};
    bolan_result result = open_file(path, &source);
    if (!result) result = georeference(&source, latitude, longitude);
    if (!result) result = read_terrain(&source, radius, vertical_scale, out);
    if (source.local_to_map) OCTDestroyCoordinateTransformation(source.local_to_map);
    if (source.file) GDALClose(source.file);
    CPLPopErrorHandler();
    return result;
}

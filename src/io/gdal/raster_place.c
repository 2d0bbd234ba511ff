// SPDX-License-Identifier: MIT
// Georeference of a raster: its map coordinates, and the map from local metres to pixels.
#include "io/gdal/raster.h"

#include <cpl_conv.h>
#include <cpl_string.h>
#include <stdio.h>
#include <string.h>

#define COARSEST_DEGREES 0.5 // longest step of a raster in degrees without a CRS, except for a whole globe

static bolan_result bad_projection(const raster_source *s, const char *what) {
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_RASTER_PROJECTION, "%s: %s", s->path, what);
    return BOLAN_ERROR_FORMAT;
}

void bolan_raster_map_point(const double m[6], double x, double y, double *u, double *v) {
    *u = m[0] + m[1] * x + m[2] * y;
    *v = m[3] + m[4] * x + m[5] * y;
}

// ---- the coordinates of the map -------------------------------------------------------------------------------------

static OGRSpatialReferenceH reference_from(const char *definition) {
    OGRSpatialReferenceH reference = OSRNewSpatialReference(NULL);
    if (OSRSetFromUserInput(reference, definition) != OGRERR_NONE) {
        OSRDestroySpatialReference(reference);
        return NULL;
    }
    OSRSetAxisMappingStrategy(reference, OAMS_TRADITIONAL_GIS_ORDER); // longitude first
    return reference;
}

// Numbers that can be degrees: of a part of the globe in fine steps, or of the whole of it.
static bool looks_like_degrees(const raster_source *s) {
    double west, north, east, south;
    bolan_raster_map_point(s->to_map, 0, 0, &west, &north);
    bolan_raster_map_point(s->to_map, s->width, s->height, &east, &south);
    const double step = fmax(fabs(s->to_map[1]), fabs(s->to_map[5]));
    const bool globe = fabs(east - west) >= 359.0 && fabs(north - south) >= 90.0;
    return (step < COARSEST_DEGREES || globe) && fabs(north) <= 91.0 && fabs(south) <= 91.0 && west >= -361.0 &&
           east <= 721.0 && fabs(east - west) <= 361.0;
}

// Units of the axes as the CF conventions write them: netCDF files often have no other CRS.
static const char *coordinates_in_metadata(const raster_source *s) {
    char **items = GDALGetMetadata(s->file, NULL);
    for (int i = 0; items && items[i]; i++) {
        if (strstr(items[i], "#units=degrees_north") || strstr(items[i], "#units=degree_north")) return "degrees";
        if (strstr(items[i], "#standard_name=projection_x_coordinate")) return "metres";
    }
    return NULL;
}

// A CRS by a text that reads neither a file nor the network: AUTHORITY:CODE, +proj, or WKT.
static bool is_crs_text(const char *text) {
    const size_t letters = strspn(text, "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz");
    const bool code = letters > 0 && text[letters] == ':' && text[letters + 1] != '/';
    return code || strncmp(text, "+proj=", 6) == 0 || (letters > 0 && text[letters] == '[');
}

// A map in metres, or in another unit of length.
static void make_planar(raster_source *s, double metres) {
    s->planar = true;
    for (int i = 0; i < 6; i++) s->to_map[i] *= metres;
}

static bolan_result named_reference(raster_source *s, const char *name, OGRSpatialReferenceH *out) {
    snprintf(s->crs, sizeof s->crs, "%s", name);
    if (bolan_raster_same_text(name, "metres") || bolan_raster_same_text(name, "meters")) {
        make_planar(s, 1.0);
        return BOLAN_OK;
    }
    const bool degrees = bolan_raster_same_text(name, "degrees");
    *out = degrees ? reference_from("EPSG:4326") : is_crs_text(name) ? reference_from(name) : NULL;
    if (*out) return BOLAN_OK;
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_RASTER_PROJECTION,
              "%s: there is no CRS \"%s\"; expected metres, degrees, or one that PROJ knows, such as EPSG:32604",
              s->path, name);
    return BOLAN_ERROR_FORMAT;
}

static bolan_result guessed_reference(raster_source *s, OGRSpatialReferenceH *out) {
    const char *stated = coordinates_in_metadata(s);
    if (stated) return named_reference(s, stated, out);
    const char *guess = looks_like_degrees(s) ? "degrees" : "metres";
    bolan_log(BOLAN_LOG_WARNING, BOLAN_LOG_RASTER_CRS,
              "%s: it has no CRS, and by its numbers they are taken as %s (crs says otherwise)", s->path, guess);
    return named_reference(s, guess, out);
}

static bolan_result file_reference(raster_source *s, OGRSpatialReferenceH given, OGRSpatialReferenceH *out) {
    const char *name = OSRGetName(given);
    snprintf(s->crs, sizeof s->crs, "%s", name ? name : "its CRS");
    if (OSRIsLocal(given)) { // engineering: no place on Earth, but a unit
        make_planar(s, OSRGetLinearUnits(given, NULL));
        return BOLAN_OK;
    }
    *out = OSRClone(given);
    if (!*out) return bad_projection(s, "its projection is not one that GDAL knows");
    OSRSetAxisMappingStrategy(*out, OAMS_TRADITIONAL_GIS_ORDER);
    return BOLAN_OK;
}

// @p out stays NULL for a planar map.
static bolan_result own_reference(raster_source *s, OGRSpatialReferenceH *out) {
    OGRSpatialReferenceH given = GDALGetSpatialRef(s->file);
    *out = NULL;
    const bolan_result result = s->desc->crs[0] ? named_reference(s, s->desc->crs, out)
                                : given         ? file_reference(s, given, out)
                                                : guessed_reference(s, out);
    s->geographic = *out && OSRIsGeographic(*out);
    return result;
}

// ---- the way from local metres --------------------------------------------------------------------------------------

// Where the raster's centre lies [deg].
static bool centre_of(const raster_source *s, OGRSpatialReferenceH map, double *latitude, double *longitude) {
    bolan_raster_map_point(s->to_map, 0.5 * s->width, 0.5 * s->height, longitude, latitude);
    OGRSpatialReferenceH degrees = reference_from("EPSG:4326");
    OGRCoordinateTransformationH to_degrees = degrees ? OCTNewCoordinateTransformation(map, degrees) : NULL;
    const bool ok = to_degrees && OCTTransform(to_degrees, 1, longitude, latitude, NULL);
    if (to_degrees) OCTDestroyCoordinateTransformation(to_degrees);
    if (degrees) OSRDestroySpatialReference(degrees);
    return ok && isfinite(*latitude) && isfinite(*longitude);
}

static bolan_result project(raster_source *s, OGRSpatialReferenceH map) {
    double latitude = s->desc->latitude, longitude = s->desc->longitude;
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

bolan_result bolan_raster_place(raster_source *s) {
    static const char *const nowhere = "it does not say where it lies; expected a raster with a georeference";
    if (GDALGetGeoTransform(s->file, s->to_map) != CE_None) return bad_projection(s, nowhere);
    OGRSpatialReferenceH map;
    bolan_result result = own_reference(s, &map);
    if (!result && !GDALInvGeoTransform(s->to_map, s->to_pixel)) result = bad_projection(s, nowhere);
    if (!result && !s->planar) {
        result = project(s, map);
    } else if (!result && !isnan(s->desc->latitude)) {
        result =
            bad_projection(s, "it has no map projection, so a latitude and longitude cannot be found in it; leave the "
                              "place out to stand at its centre");
    } else if (!result) {
        bolan_raster_map_point(s->to_map, 0.5 * s->width, 0.5 * s->height, &s->origin_x, &s->origin_y);
    }
    if (map) OSRDestroySpatialReference(map);
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

void bolan_raster_local_to_pixel(const raster_source *s, int count, double *x, double *y) {
    if (s->local_to_map) OCTTransform(s->local_to_map, count, x, y, NULL); // what fails becomes HUGE_VAL
    for (int i = 0; i < count; i++) {
        double u = s->planar ? x[i] + s->origin_x : x[i], v = s->planar ? y[i] + s->origin_y : y[i];
        if (s->geographic) u = near_raster(s, u);
        const bool known = isfinite(u) && isfinite(v);
        bolan_raster_map_point(s->to_pixel, u, v, &x[i], &y[i]);
        if (!known) x[i] = y[i] = (double)NAN;
    }
}

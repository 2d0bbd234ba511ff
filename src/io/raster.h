// SPDX-License-Identifier: MIT
/// @file raster.h
/// The parts of reading a raster. Private to src/io.
///
///     file -open-> raster_source -plan-> raster_plan (local grid) -window-> raster_window -resample-> elevations
///
/// *Pixel coordinates* are those of GDAL: x to the right, y down, pixel (0, 0) has its centre at (0.5, 0.5). *Local
/// coordinates* are metres east and north of the scene's origin.
#ifndef BOLAN_IO_RASTER_H
#define BOLAN_IO_RASTER_H

#include "bolan/io.h"

#include <gdal.h>
#include <ogr_srs_api.h>

typedef struct raster_source {
    const char *path; ///< as the caller wrote it, for messages
    GDALDatasetH file;
    GDALRasterBandH band;
    int width, height;             ///< [pixels]
    double to_map[6], to_pixel[6]; ///< affine, GDAL's order: pixel <-> the raster's own map coordinates
    bool planar;                   ///< no projection known: map coordinates are metres
    bool geographic;               ///< map coordinates are longitude, latitude [deg]
    int period;                    ///< width of the whole globe [pixels], 0 for a raster that does not go around
    double centre_longitude;       ///< of the scene: longitudes are taken within 180 degrees of it
    double origin_x, origin_y;     ///< planar: the scene's origin on the map
    OGRCoordinateTransformationH local_to_map; ///< NULL when planar
} raster_source;

/// The grid to fill, in local metres.
typedef struct raster_plan {
    uint32_t width, height;
    double west, south, step;
} raster_plan;

/// Part of the band in memory, every no-data pixel filled.
typedef struct raster_window {
    int x, y;                 ///< first pixel; x may lie outside [0, width) where the raster goes around
    int width, height;        ///< [samples]
    double pixels_per_sample; ///< 1, or more where the raster was thinned
    float *values;
    size_t bytes;
} raster_window;

/// Local [m] -> pixel coordinates, @p count points in place. Points that cannot be mapped become NAN.
void raster_local_to_pixel(const raster_source *source, int count, double *x, double *y);

bolan_result raster_window_read(const raster_source *source, const raster_plan *plan, double vertical_scale,
                                raster_window *out);
void raster_window_release(raster_window *window);
/// Replaces NAN by values around it; false when there is nothing but NAN. (See raster_fill.c.)
bool raster_fill(float *values, int width, int height);

/// Fills plan->width * plan->height elevations, row 0 in the south.
void raster_resample(const raster_source *source, const raster_window *window, const raster_plan *plan, float *out);

#endif

// SPDX-License-Identifier: MIT
/// @file raster.h
/// The stages of reading a raster. Private to src/io.
///
///     desc -open-> raster_source -place-> (georeference) -plan-> raster_plan (local grid)
///          -window-> raster_window -holes-> (no sample without a value) -resample-> elevations
///
/// *Pixel coordinates* are those of GDAL: x to the right, y down, pixel (0, 0) has its centre at (0.5, 0.5). *Local
/// coordinates* are metres east and north of the scene's origin.
#ifndef BOLAN_IO_RASTER_H
#define BOLAN_IO_RASTER_H

#include "bolan/io.h"

#include <gdal.h>
#include <ogr_srs_api.h>

enum { RASTER_MOST_MESSAGES = 3, RASTER_MESSAGE_MAX = 200 };

/// Warnings of GDAL for the raster that is read, each once.
typedef struct raster_messages {
    int count;
    char text[RASTER_MOST_MESSAGES][RASTER_MESSAGE_MAX];
} raster_messages;

typedef struct raster_source {
    const bolan_raster_desc *desc;
    const char *path; ///< as the caller wrote it, for messages
    GDALDatasetH file;
    GDALRasterBandH band;
    GDALRasterBandH mask; ///< 0 where there is no data; NULL: no mask
    int number;           ///< of the band, from 1
    char variable[64];    ///< name of the variable or band, "" for none
    double metres;        ///< upwards, per unit of the band (after its scale and offset); below 0 for depths
    bool perhaps_down;    ///< named a depth without a stated direction: decided by the values
    char unit[48];        ///< as the file states it, for messages; "" for none
    char crs[80];         ///< description of the coordinates, for messages
    raster_messages messages;
    int width, height;             ///< [pixels]
    double to_map[6], to_pixel[6]; ///< affine, GDAL's order: pixel <-> the raster's own map coordinates
    bool planar;                   ///< no projection: map coordinates are metres
    bool geographic;               ///< map coordinates are longitude, latitude [deg]
    int period;                    ///< width of the whole globe [pixels], 0 for a raster that does not go around
    double centre_longitude;       ///< of the scene: longitudes are taken within 180 degrees of it
    double origin_x, origin_y;     ///< planar: the scene's origin on the map
    OGRCoordinateTransformationH local_to_map; ///< NULL when planar
} raster_source;

/// The grid to fill, in local metres.
typedef struct raster_plan {
    uint32_t width, height;
    double west, south, step_x, step_y;
} raster_plan;

/// Part of the band in memory.
typedef struct raster_window {
    int x, y;                 ///< first pixel; x may lie outside [0, width) where the raster goes around
    int width, height;        ///< [samples]
    double pixels_per_sample; ///< 1, or more where the raster was thinned
    float *values;            ///< [m]; NAN where there is no data
    size_t bytes;
} raster_window;

// ---- raster_names.c: what a raster says of a band -------------------------------------------------------------------

/// The texts that describe a band; "" where there is none.
typedef struct raster_words {
    char name[64], standard[64], description[128], unit[48], positive[16];
} raster_words;

/// Metres per @p unit; false for a text that is no unit of length.
bool bolan_raster_unit(const char *unit, double *metres);
/// How likely the words name elevations; 0: not at all. The band with the highest score is chosen.
int bolan_raster_elevation_score(const raster_words *words);
typedef enum raster_direction { RASTER_UP, RASTER_DOWN, RASTER_PERHAPS_DOWN } raster_direction;
/// Whether the words name heights or depths.
raster_direction bolan_raster_direction_of(const raster_words *words);
/// strcmp() == 0, whatever the case.
bool bolan_raster_same_text(const char *a, const char *b);

// ---- the steps ------------------------------------------------------------------------------------------------------

/// Opens the file and chooses variable, band, mask, unit and direction. IO or FORMAT.
bolan_result bolan_raster_open(raster_source *source);
/// Georeference: the map coordinates, and the way to local metres. FORMAT.
bolan_result bolan_raster_place(raster_source *source);
/// Local [m] -> pixel coordinates, @p count points in place. Points that cannot be mapped become NAN.
void bolan_raster_local_to_pixel(const raster_source *source, int count, double *x, double *y);
/// Pixel -> map coordinates by an affine of GDAL's, or back.
void bolan_raster_map_point(const double affine[6], double x, double y, double *u, double *v);

bolan_result bolan_raster_window_read(raster_source *source, const raster_plan *plan, raster_window *out);
void bolan_raster_window_release(raster_window *window);
/// Gives every sample a value, by the settings of the desc for holes and zeros. A sample is @p width x @p height
/// metres. FORMAT where there is no data at all, MEMORY.
bolan_result bolan_raster_holes(const raster_source *source, raster_window *window, double width, double height);
/// Replaces NAN by values around it. FORMAT, without a sentence, when there is nothing but NAN; MEMORY, with one.
bolan_result bolan_raster_fill(const char *path, float *values, int width, int height);

/// Fills plan->width * plan->height elevations, row 0 in the south. MEMORY.
bolan_result bolan_raster_resample(const raster_source *source, const raster_window *window, const raster_plan *plan,
                                   float *out);
/// Logs that there is no memory for @p count of @p what, and returns MEMORY.
bolan_result bolan_raster_no_memory(const char *path, size_t count, const char *what);

#endif

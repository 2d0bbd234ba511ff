// SPDX-License-Identifier: MIT
// The parameters of the sources of ground.
#include "bolan/ground.h"
#include "params/rows.h"

static const char *const nodata_names[] = {"fill", "sea", NULL};                 // bolan_raster_nodata, from 1
static const char *const zero_names[] = {"land", "sea", NULL};                   // bolan_raster_zero, from 1
static const char *const ground_names[] = {"none", "generated", "raster", NULL}; // bolan_ground_kind

#define STRUCT bolan_ground_generator
static const bolan_param generator_rows[] = {
    TEXT(name, .help = "which generator"),
    WHOLE(seed, .key = "seed", .high = SEED_MAX, .fallback = 7, .help = "which ground of this kind"),
    NUMBER(radius, .key = "radius", .low = 200, .high = 20000, .fallback = 2200, .unit = "m", .help = "of the land"),
    NUMBER(peak, .key = "peak", .low = 10, .high = 3000, .fallback = 620, .unit = "m", .help = "height of the summit"),
    NUMBER(sea_floor, .key = "sea_floor", .low = -11000, .high = -20, .fallback = -900, .unit = "m",
           .help = "elevation of the sea bed far out"),
    HEADING(lagoon_from_deg, .key = "lagoon_from", .fallback = 225, .help = "compass side of the sandy shallows"),
};
#undef STRUCT
const bolan_param_table bolan_ground_generator_params = TABLE("bolan_ground_generator", generator_rows);

#define STRUCT bolan_ground_source
static const bolan_param ground_source_rows[] = {
    NAME(kind, .names = ground_names, .high = BOLAN_GROUND_RASTER, .help = "where the ground comes from"),
    FLAG(shown_by_object, .help = "an object shows the ground, which is not drawn itself"),
};
#undef STRUCT
const bolan_param_table bolan_ground_source_params = TABLE("bolan_ground_source", ground_source_rows);

#define STRUCT bolan_raster_desc
static const bolan_param raster_rows[] = {
    TEXT(path, .key = "file", .rules = BOLAN_PARAM_PATH, .otherwise = "ETOPO5, where installed",
         .help = "elevations: any format that GDAL reads, in degrees, in a map projection, or in plain metres; "
                 "relative to the scene "
                 "file. GDAL's own names work as well: `\"NETCDF:f.nc:z\"`, `\"GTIFF_DIR:2:f.tif\"`, `/vsizip/...`"),
    NUMBER(latitude, .key = "at", .low = -90, .high = 90, .unit = "degrees", .rules = BOLAN_PARAM_OR_NAN,
           .fallback = (double)NAN, .otherwise = "its centre",
           .help = "latitude and longitude where the scene's origin lies in the raster"),
    NUMBER(longitude, .key = "at", .low = -360, .high = 360, .unit = "degrees", .rules = BOLAN_PARAM_OR_NAN,
           .fallback = (double)NAN),
    NUMBER(radius, .key = "radius_km", .low = 100, .high = 5e6, .unit = "m", .fallback = 150e3, .factor = 1e3,
           .factor_unit = "km", .help = "half side of the square that is read"),
    TEXT(variable, .key = "variable", .otherwise = "by its name",
         .help = "the variable of a netCDF or HDF file, or the band of that description"),
    WHOLE(band, .key = "band", .low = 1, .high = 65535, .rules = BOLAN_PARAM_OR_ZERO, .otherwise = "by its name",
          .help = "number of the band"),
    TEXT(crs, .key = "crs", .otherwise = "the file's",
         .help = "what the coordinates of the file are: `metres`, `degrees`, or text for PROJ such as `EPSG:32604`"),
    NUMBER(vertical_scale, .key = "vertical_scale", .low = 1e-3, .high = 1e3,
           .rules = BOLAN_PARAM_OR_NAN | BOLAN_PARAM_EITHER_SIGN, .fallback = (double)NAN,
           .otherwise = "the file's unit and direction",
           .help = "metres upwards per unit of the raster; negative for depths"),
    NUMBER(nodata_value, .key = "nodata_value", .low = -HUGE_VAL, .high = HUGE_VAL, .rules = BOLAN_PARAM_OR_NAN,
           .fallback = (double)NAN, .otherwise = "the file's", .help = "the number that stands for no-data"),
    NAME(nodata, .key = "nodata", .names = nodata_names, .low = BOLAN_NODATA_FILL, .high = BOLAN_NODATA_SEA,
         .rules = BOLAN_PARAM_OR_ZERO, .otherwise = "`sea` at the rim, `fill` within", .help = "what no-data is"),
    NAME(zero, .key = "zero_is", .names = zero_names, .low = BOLAN_ZERO_LAND, .high = BOLAN_ZERO_SEA,
         .rules = BOLAN_PARAM_OR_ZERO, .otherwise = "`land`, with a warning where it is much",
         .help = "what an elevation of exactly 0 is"),
};
#undef STRUCT
const bolan_param_table bolan_raster_params = TABLE("bolan_raster_desc", raster_rows);

// SPDX-License-Identifier: MIT
/// @file ground.h
/// Tier 2. The ground under and beside the sea: elevation of land and sea bed, and where it comes from.
#ifndef BOLAN_GROUND_H
#define BOLAN_GROUND_H

#include "bolan/base.h"
#include "bolan/math.h"
#include "bolan/params.h"

#ifdef __cplusplus
extern "C" {
#endif

// ---- a ground of a grid ---------------------------------------------------------------------------------------------

/// A regular grid of elevations in local metres.
/// Sample (i, j) is at (west + i * step_x, south + j * step_y); row 0 is in the south.
/// All samples lie within +-1e8 m of the origin.
typedef struct bolan_heightfield {
    /// Number of samples each way, 2..32768.
    uint32_t width, height;
    /// Position of sample (0, 0) [m east, m north of the scene's origin].
    double west, south;
    /// Spacing of the samples [m], 1e-3..1e7.
    double step_x, step_y;
    /// elevation[j * width + i] [m above mean sea level], width * height values within +-1e6.
    const float *elevation;
} bolan_heightfield;

/// How a ground is made of a grid.
typedef struct bolan_ground_desc {
    /// The elevations; copied.
    bolan_heightfield field;
    /// Strength of the procedural detail below the grid's spacing, 0..2; default 1. 0 leaves the data alone.
    double detail;
    /// Seed of the detail; default 1.
    uint64_t seed;
    /// Elevation far outside the grid [m], +-1e6; default -4000. The rim of the grid blends to it.
    double edge_elevation;
} bolan_ground_desc;

/// Immutable ground: data, interpolated, with procedural detail below their spacing.
/// Thread-safety: all reads may run at the same time.
typedef struct bolan_ground bolan_ground;

/// The defaults named above the fields, and no grid.
BOLAN_API bolan_ground_desc bolan_ground_desc_default(void);

/// Makes a ground of a grid.
/// Between the nodes the data are interpolated by limited bicubic patches (C1, no overshoot; Fritsch & Carlson 1980).
/// Below twice the spacing the detail adds ridges and gullies that run down the slopes of the data.
/// @param out receives the ground; NULL on failure.
/// Errors: ARGUMENT (the sentence names the field), MEMORY.
BOLAN_API bolan_result bolan_ground_create(const bolan_ground_desc *desc, bolan_ground **out);

/// Releases the ground.
/// NULL-safe; NULLs the pointer.
BOLAN_API void bolan_ground_destroy(bolan_ground **ground);

// ---- elevations -----------------------------------------------------------------------------------------------------

/// Elevation [m above mean sea level] at world (x, y) [m], low-passed for a grid of spacing @p resolution [m].
/// The data are low-passed where the spacing is coarser than theirs.
/// Detail of a wavelength below twice the spacing is left out; it fades in up to four times the spacing.
/// A resolution of 0 keeps everything.
/// The elevation is continuous in x, y and resolution, and finite everywhere.
/// Thread-safe.
BOLAN_API float bolan_ground_elevation(const bolan_ground *ground, double x, double y, double resolution);

/// Elevations at a regular grid: out[j * nx + i] is bolan_ground_elevation() at (west + i * step, south + j * step).
/// The spacing @p step [m] is the resolution.
/// Uses the task hook; the values are equal to those of single calls for any number of threads.
/// Thread-safe.
BOLAN_API void bolan_ground_elevations(const bolan_ground *ground, double west, double south, double step, uint32_t nx,
                                       uint32_t ny, float *out);

/// Extent of the data that a ground was made from.
typedef struct bolan_ground_extent {
    /// The rectangle of the data [m].
    double west, south, east, north;
    /// The lowest and highest elevation of the data [m].
    double lowest, highest;
    /// The spacing of the data [m]; the coarser of the two.
    double step;
} bolan_ground_extent;

/// The extent of the data.
/// Thread-safe.
BOLAN_API bolan_ground_extent bolan_ground_get_extent(const bolan_ground *ground);

/// A 64-bit hash of everything that the ground was created from: equal for equal grounds.
/// Thread-safe.
BOLAN_API uint64_t bolan_ground_id(const bolan_ground *ground);

/// Bounds [m] of the elevations, at any resolution, in the square of side @p size [m] from (@p west, @p south).
/// The bounds are not tight. A call costs a few memory reads; for culling.
/// Thread-safe.
BOLAN_API void bolan_ground_bounds(const bolan_ground *ground, double west, double south, double size, float *lowest,
                                   float *highest);

// ---- where a ground comes from --------------------------------------------------------------------------------------

/// Where the ground of a scene comes from.
typedef enum bolan_ground_kind {
    /// No ground: open sea.
    BOLAN_GROUND_NONE,
    /// A generator: bolan_ground_source::generator.
    BOLAN_GROUND_GENERATED,
    /// A raster file: bolan_ground_source::raster.
    BOLAN_GROUND_RASTER,
} bolan_ground_kind;

/// A generator of ground by name, and its parameters.
/// A generator ignores the parameters that it has no use for.
/// The core has no generator; content.h has some.
typedef struct bolan_ground_generator {
    /// Name of the generator; default "". See bolan_content_ground_name().
    char name[BOLAN_NAME_MAX];
    /// Which ground of this kind; default 7.
    uint64_t seed;
    /// Radius of the land [m], 200..20000; default 2200.
    double radius;
    /// Height of the summit [m], 10..3000; default 620.
    double peak;
    /// Elevation of the sea bed far out [m], -11000..-20; default -900.
    double sea_floor;
    /// Compass side where sandy shallows lie [deg], -360..360; default 225.
    double lagoon_from_deg;
} bolan_ground_generator;

/// The defaults named above the fields.
BOLAN_API bolan_ground_generator bolan_ground_generator_default(void);

/// What a sample without a value is.
typedef enum bolan_raster_nodata {
    /// SEA where the holes reach the rim of what is read, FILL where data enclose them; a warning says so.
    BOLAN_NODATA_AUTO,
    /// The sample takes the elevation around it.
    BOLAN_NODATA_FILL,
    /// A sea bed that falls off from the data, for rasters of land alone.
    BOLAN_NODATA_SEA,
} bolan_raster_nodata;

/// What an elevation of exactly 0 is.
typedef enum bolan_raster_zero {
    /// LAND, with a warning where much of the raster is 0.
    BOLAN_ZERO_AUTO,
    /// Ground at mean sea level.
    BOLAN_ZERO_LAND,
    /// Like BOLAN_NODATA_SEA, for rasters of land whose sea is 0.
    BOLAN_ZERO_SEA,
} bolan_raster_zero;

/// Size of bolan_raster_desc.crs [bytes], NUL included.
#define BOLAN_CRS_MAX 256

/// A raster of elevations, and what overrules the statements of the file: see bolan_raster_load() of io.h.
typedef struct bolan_raster_desc {
    /// Any file that GDAL reads, or a name with a prefix of GDAL's (NETCDF:f.nc:z, HDF5:..., GTIFF_DIR:2:f.tif).
    /// Default "".
    char path[BOLAN_PATH_MAX];
    /// Name of the variable or of the band.
    /// Default "": the one that is an elevation by its standard_name, name or unit.
    char variable[BOLAN_NAME_MAX];
    /// Number of the band, 1..65535.
    /// Default 0: the only band, or the one that is an elevation by its name.
    uint32_t band;
    /// Coordinates of the file: "metres", "degrees", or a CRS that PROJ knows ("EPSG:32604", WKT).
    /// Default "": the file's.
    char crs[BOLAN_CRS_MAX];
    /// Place of the scene's origin [deg], latitude +-90, longitude +-360.
    /// Default NAN: the centre of the raster.
    double latitude, longitude;
    /// Half side of the square that is read [m], 100..5e6; default 150000.
    double radius;
    /// Metres upwards per unit of the raster, +-(1e-3..1e3), negative for depths.
    /// Default NAN: by the unit and the sign that the file states.
    /// Scale and offset of the file apply first.
    double vertical_scale;
    /// The number that stands for no-data, as in the file.
    /// Default NAN: what the file declares.
    double nodata_value;
    /// What a sample without a value is; default AUTO.
    bolan_raster_nodata nodata;
    /// What an elevation of exactly 0 is; default AUTO.
    bolan_raster_zero zero;
} bolan_raster_desc;

/// The defaults named above the fields.
BOLAN_API bolan_raster_desc bolan_raster_desc_default(void);

/// The ground of a scene, by description.
typedef struct bolan_ground_source {
    /// Which of the members below is used; default NONE.
    bolan_ground_kind kind;
    /// For GENERATED.
    bolan_ground_generator generator;
    /// For RASTER. An empty path is the global relief ETOPO5, where it is installed.
    bolan_raster_desc raster;
    /// True: an object of the scene shows the ground, so the ground itself is not drawn; default false.
    /// The water still takes its depth and its shore from the ground.
    bool shown_by_object;
} bolan_ground_source;

/// The parameters of the structs above.
BOLAN_API extern const bolan_param_table bolan_ground_generator_params, bolan_raster_params, bolan_ground_source_params;

#ifdef __cplusplus
}
#endif
#endif

// SPDX-License-Identifier: MIT
/// @file export.h
/// Tier 3, library bolan_io. Water for other programs: meshes of the surface (PLY, OBJ, glTF), fields of the waves
/// (EXR, NetCDF), the sky (EXR).
///
/// Files are written as io.h says: whole or not at all, and piece by piece, so that memory does not grow with the file.
///
/// **Axes and units.** Metres, metres per second, seconds. The world is x east, y north, z up.
///
/// | format | its axes |
/// |---|---|
/// | .ply | x east, y north, z up |
/// | .obj, .glb | x east, y up, z south: glTF 2.0 is y up, and programs read OBJ so |
/// | .exr, fields | row 0 is the last along y or v, so that the picture has north (or v) at its top |
/// | .nc | coordinates x east, y north (or u, v along the tile), in ascending order |
/// | .exr, sky | row 0 is the zenith, the middle column north, columns run clockwise: west, north, east |
#ifndef BOLAN_EXPORT_H
#define BOLAN_EXPORT_H

#include "bolan/scene.h"
#include "bolan/world.h"

#ifdef __cplusplus
extern "C" {
#endif

/// A rectangle of points in the world, at a spacing: from its south-west corner on, as many as fit.
typedef struct bolan_export_grid {
    /// South-west and north-east corner [m], +-1e7; default -128, -128 and 128, 128.
    bolan_dvec2 from, to;
    /// Distance of neighbours [m], 0.001..1e5; default 0.5.
    /// 2..65536 points along each side, and at most 2^28 in all.
    double spacing;
} bolan_export_grid;
/// Points along x and along y; 0 and 0 where the grid is out of range.
/// Thread-safe.
BOLAN_API void bolan_export_grid_size(const bolan_export_grid *grid, uint32_t *columns, uint32_t *rows);

/// Frames of an export that has several.
typedef struct bolan_export_frames {
    /// How many, 1..100000; default 1: the present time of the world, which is not stepped.
    /// More: the world is settled at its present time, stepped from frame to frame, and left at the last.
    uint32_t count;
    /// Frames a second, 0.001..1000; default 30.
    double fps;
    /// Called after each part of the work; default NULL. @c user is handed to it.
    bolan_progress *progress;
    void *user;
} bolan_export_frames;

// ---- meshes ---------------------------------------------------------------------------------------------------------

/// Which vertices a mesh has.
typedef enum bolan_export_vertices {
    /// The projected grid of the scene's camera, which the renderer draws: fine near the eye, coarse far away,
    /// low-passed for its spacing, and curved with the earth.
    BOLAN_EXPORT_VIEW,
    /// A rectangle, whose rest points are at a spacing. Every vertex has all the waves of a query.
    BOLAN_EXPORT_RECTANGLE,
} bolan_export_vertices;

/// How a mesh is made.
typedef struct bolan_export_mesh_desc {
    /// Default BOLAN_EXPORT_VIEW.
    bolan_export_vertices vertices;
    /// RECTANGLE: the rest points of the vertices.
    bolan_export_grid grid;
    /// VIEW: the picture that the grid is for [px], 16..65536; default 1280 x 720.
    uint32_t width, height;
    /// VIEW: most vertices, 1024..10000000; default 200000. The grid is coarsened to fit.
    uint32_t most_vertices;
    /// The ground too, as a mesh of its own over the same points. Default false.
    /// A world without ground: ARGUMENT.
    bool ground;
    /// The place of the world that is the origin of the file [m]; default 0, 0, 0.
    /// Positions are floats: beyond 8 km from the origin they are rounded to more than half a millimetre, with one
    /// warning (EXPORT_PRECISION).
    bolan_dvec3 origin;
    /// More than one: an animation, in .glb alone.
    bolan_export_frames frames;
} bolan_export_mesh_desc;
/// The defaults named above the fields. Thread-safe.
BOLAN_API bolan_export_mesh_desc bolan_export_mesh_desc_default(void);

/// Writes the water of @p world as a mesh, in the format that the suffix of @p path names.
///
/// A vertex of the water is a parcel of bolan_query_parcels(), with its normal; its foam is that of bolan_sea_sample,
/// and its velocity that of bolan_query_motion() at its place, the current included. Triangles are counter-clockwise
/// seen from above. Vertices of the ground have its normal, no foam and no velocity.
///
/// | suffix | format | foam | velocity | water and ground |
/// |---|---|---|---|---|
/// | .ply | binary, little-endian | `foam` | `vx`, `vy`, `vz` | with ground: vertex property `part`, 0 and 1 |
/// | .obj | text | grey of the vertex, not clamped | none: EXPORT_LEFT_OUT warns | objects `water`, `ground` |
/// | .glb | glTF 2.0, binary | `_FOAM` | `_VELOCITY` | nodes `water`, `ground` |
///
/// An animation holds the mesh of the first frame and, for each other frame, a morph target of position and normal with
/// the weight 1 at its time; foam and velocity are those of the first frame. It is played with linear interpolation.
/// A scene whose technique draws another surface gets the projected grid, with one warning (EXPORT_LEFT_OUT).
/// Memory: a view's grid, and 16384 vertices or one row at a time; an animation holds its first frame.
/// Errors: ARGUMENT (the suffix, a field out of range, no water in view, several frames for another format, no ground),
/// FORMAT (EXPORT_TOO_LARGE: more than 4 GiB of .glb), IO, MEMORY.
BOLAN_API bolan_result bolan_export_mesh(bolan_world *world, const bolan_export_mesh_desc *desc, const char *path);

// ---- fields ---------------------------------------------------------------------------------------------------------

/// How fields are written.
typedef struct bolan_export_fields_desc {
    /// False (default): the fields of each cascade at its samples. True: the surface over `grid`.
    bool resampled;
    /// The points of the world that are asked, where resampled.
    bolan_export_grid grid;
    /// EXR: halfs in the place of floats. Default false.
    bool half;
    /// More than one: the time dimension of NetCDF. An EXR has one.
    bolan_export_frames frames;
} bolan_export_fields_desc;
/// The defaults named above the fields. Thread-safe.
BOLAN_API bolan_export_fields_desc bolan_export_fields_desc_default(void);

/// Writes the fields of the waves of @p world: .exr, OpenEXR, or .nc, NetCDF-3 with 64-bit offsets and the conventions
/// CF-1.8.
///
/// Of cascades (a sea of form CASCADES): height, dx, dy, slope_x, slope_y, dxx, dyy, dxy, foam, as bolan_cascade_view
/// has them, at the samples: height, dx and dy are values of the spline, not its coefficients. In EXR each cascade is a
/// part "cascade0" ..., whose header has time, length, angle, k_min, k_max, variance and origin; in NetCDF the
/// variables are height_0(time, v_0, u_0) ..., with the same as attributes.
///
/// Resampled: height, normal_x, normal_y, normal_z, jacobian of bolan_query_surface(), velocity_x, velocity_y,
/// velocity_z of bolan_query_motion(), foam of bolan_query_foam(), at fixed points; in NetCDF height(time, y, x) and so
/// on, with CF standard names where there are any.
///
/// Times are seconds since the epoch of the scene, which CF wants as a date: it is named 1970-01-01.
/// Memory: one frame and, of .exr, the compressed file.
/// Errors: ARGUMENT (the suffix, a field out of range, cascades of a sum, several frames of .exr), FORMAT
/// (EXPORT_TOO_LARGE: more than 2^28 points), UNSUPPORTED (EXR in a build without it), IO, MEMORY.
BOLAN_API bolan_result bolan_export_fields(bolan_world *world, const bolan_export_fields_desc *desc, const char *path);

// ---- the sky --------------------------------------------------------------------------------------------------------

/// Writes the sky as an equirectangular map, .exr: channels R, G, B of linear radiance, floats.
///
/// Column i looks to the compass direction 360 ((i + 0.5) / width - 0.5) degrees, row j to the elevation
/// 180 (0.5 - (j + 0.5) / height). The sun's disc is not in the map, but in the header, as a light of its own:
/// sunDirection, the unit vector to it (x east, y north, z up); sunAzimuth, sunElevation [deg]; sunIrradiance, on a
/// surface that faces it; skyIrradiance, of the map on a horizontal surface. The unit is the irradiance of the sun in
/// space at normal incidence.
/// @param rgb width * height * 3 floats, row 0 at the top, as bolan_renderer_read_sky() has them.
/// Errors: ARGUMENT (a size as of bolan_exr_write(), another suffix), UNSUPPORTED, IO, MEMORY.
BOLAN_API bolan_result bolan_export_sky(const char *path, uint32_t width, uint32_t height, const float *rgb,
                                        const bolan_sky_light *light);

#ifdef __cplusplus
}
#endif
#endif

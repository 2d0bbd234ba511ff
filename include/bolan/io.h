// SPDX-License-Identifier: MIT
/// @file io.h
/// Tier 3, library bolan_io. Files: scenes (YAML), rasters (GDAL), measured spectra, images (PNG, EXR), video (the
/// ffmpeg program), query points (CSV).
///
/// Every writer writes to a temporary file beside the target and renames it at the end.
/// No partial file is left, and an existing file is replaced whole or not at all.
/// Numbers in files and in arguments of programs are in the C locale, whatever locale the host program has set.
/// Errors are a ::bolan_result and one logged sentence with the file, the line or field, and what was expected.
/// On failure nothing is returned.
/// Functions are not thread-safe unless their comment says so.
#ifndef BOLAN_IO_H
#define BOLAN_IO_H

#include "bolan/scene.h"
#include "bolan/tiles.h"
#include "bolan/world.h"

#ifdef __cplusplus
extern "C" {
#endif

// ---- this build -----------------------------------------------------------------------------------------------------

/// Formats that this build reads or writes.
/// A function of a format that is left out logs one sentence and returns UNSUPPORTED.
typedef struct bolan_io_features {
    /// bolan_raster_load(), by GDAL.
    bool rasters;
    /// bolan_model_load(), by assimp.
    bool models;
    /// bolan_exr_write(), by OpenEXR.
    bool exr;
    /// Spectra packed by gzip, by zlib.
    bool gzip;
    /// Spectra in NetCDF-4, by netCDF-C. NetCDF-3 needs no library.
    bool netcdf4;
} bolan_io_features;
/// Returns the formats of this build.
/// Thread-safe.
BOLAN_API bolan_io_features bolan_io_get_features(void);

// ---- files ----------------------------------------------------------------------------------------------------------

/// Writes a whole file.
/// Symbolic links are followed, also to a name that does not exist yet.
/// A file that is replaced keeps its mode; hard links to it keep the old content.
/// A device or pipe is opened once and written straight.
/// Errors: IO, also for a file without write permission for anybody.
BOLAN_API bolan_result bolan_file_write(const char *path, const void *data, size_t size);
/// Checks that a file can be written at @p path, so that long work fails before it starts.
/// Leaves nothing behind.
/// Errors: IO.
BOLAN_API bolan_result bolan_file_check_writable(const char *path);
/// A file that is written piece by piece.
typedef struct bolan_file_stream bolan_file_stream;
/// Begins a file at @p path, as bolan_file_write() would write it: under a temporary name until it is closed.
/// A device or pipe is opened and written straight. Errors: IO, MEMORY; then *out is NULL.
BOLAN_API bolan_result bolan_file_stream_open(const char *path, bolan_file_stream **out);
/// Appends @p size bytes. IO where they cannot be written; then only bolan_file_stream_close() is left to do.
BOLAN_API bolan_result bolan_file_stream_write(bolan_file_stream *stream, const void *data, size_t size);
/// Gives the file its name, or removes it (@p keep false). NULL-safe, NULLs. IO where that fails; nothing is left.
BOLAN_API bolan_result bolan_file_stream_close(bolan_file_stream **stream, bool keep);
/// Removes every unfinished file and folder of this library, and ends the ffmpeg processes.
/// For a signal handler that ends the program: async-signal-safe, from any thread.
/// Call _exit() next: a thread that begins a file afterwards waits for ever.
BOLAN_API void bolan_files_abandon(void);

// ---- scenes ---------------------------------------------------------------------------------------------------------

/// Reads a scene: the name of a built-in scene ("island"), or a path to a YAML file of at most 256 KiB.
/// Relative paths in the file are relative to the folder of the file.
/// On failure @p scene is untouched.
/// Errors: IO, or FORMAT with file, line and key (an unknown key, a value outside its range, text that is not YAML).
BOLAN_API bolan_result bolan_scene_load(const char *name_or_path, bolan_scene *scene);
/// Parses YAML text of @p size bytes.
/// @p name is used in messages.
/// Relative paths stay as they are.
BOLAN_API bolan_result bolan_scene_parse(const char *name, const char *text, size_t size, bolan_scene *scene);
/// The keys of scene files that are no field of a scene, such as sea.beaufort.
/// Their effect on the scene is computed when the file is read.
/// Every other key is in bolan_scene_groups.
/// A NULL table ends the list.
BOLAN_API extern const bolan_param_group bolan_scene_file_groups[];
/// Returns the name of a built-in scene; NULL past the last.
BOLAN_API const char *bolan_scene_builtin_name(uint32_t index);

// ---- worlds ---------------------------------------------------------------------------------------------------------

/// Loads a world: the scene of that name or path, see bolan_scene_load(), and all that it refers to.
/// @param out receives the world; NULL on failure.
/// Errors: those of bolan_scene_load() and bolan_world_load_scene().
BOLAN_API bolan_result bolan_world_load(const char *name_or_path, bolan_world **out);

/// Loads what @p scene refers to and makes a world of both.
/// "builtin:" models and generated grounds come from bolan_content.
/// A raster with an empty path is the global relief ETOPO5 at the path of Debian's package ferret-datasets.
/// @param out receives the world; NULL on failure.
/// Errors: IO, FORMAT, MEMORY, UNSUPPORTED (a format that this build does not have), ARGUMENT (a field of the scene out
/// of range, an unknown name of a model or a ground).
BOLAN_API bolan_result bolan_world_load_scene(const bolan_scene *scene, bolan_world **out);

// ---- models ---------------------------------------------------------------------------------------------------------

/// A model file.
typedef struct bolan_model_desc {
    /// Path of the file, which must be given; read during the call only.
    const char *path;
    /// Which axis of the file points up; default Y.
    bolan_up up;
    /// Subtracted from the coordinates of the file, in its axes and units, +-1e8; default 0.
    /// The coordinates are floats before the subtraction: around 5e6 (UTM) they are rounded to half a metre.
    /// For fine models subtract the offset in the file.
    bolan_dvec3 offset;
} bolan_model_desc;

/// Reads a model with the assimp library: OBJ, glTF 2.0 and the other formats of that library.
/// Node transforms are applied.
/// The albedo is the base colour of the material times the colour of the vertex, both taken as linear.
/// The sky is open above every vertex. Textures are not read.
/// A glTF mesh without normals gets flat normals (glTF 2.0, 3.7.2.1).
/// In other formats the normals are smooth, except at edges of 45 degrees and more.
/// Limits: 64 MiB, 8388608 vertices, nodes 64 deep.
/// Errors: IO; FORMAT (a glTF that requires an extension, no triangle, a vertex that is not finite or beyond 1e7 m);
/// ARGUMENT (offset); MEMORY.
BOLAN_API bolan_result bolan_model_load(const bolan_model_desc *desc, bolan_model **out);

// ---- tiles ----------------------------------------------------------------------------------------------------------

/// Writes tiles into the new folder @p folder, whole or not at all.
/// The folder holds index.json and, for each frame NNN from 000:
/// - height_NNN.pgm (16-bit grey: (value - 32768) * height_step metres);
/// - normal_NNN.png, detail_NNN.png, caustics_NNN.png.
///
/// Row 0 of an image is row 0 of the tile.
/// Errors: IO (the folder exists or cannot be written), MEMORY.
BOLAN_API bolan_result bolan_tiles_save(const bolan_tiles *tiles, const char *folder);
/// Checks that bolan_tiles_save() could write the folder.
/// Leaves nothing behind.
/// Errors: IO.
BOLAN_API bolan_result bolan_tiles_check_writable(const char *folder);
/// Reads a folder of bolan_tiles_save().
/// index.json must be one JSON object with the numbers that bolan_tiles_save() writes, each once, and nothing else.
/// Errors: IO; FORMAT, with the file and what is wrong in it; ARGUMENT; MEMORY.
BOLAN_API bolan_result bolan_tiles_load(const char *folder, bolan_tiles **out);

// ---- spectra, rasters, points ---------------------------------------------------------------------------------------

/// Reads a measured spectrum file of at most 64 MiB, also packed by gzip; bolan/formats.h names the formats.
/// The tables of directions that NDBC publishes beside a density are used where they lie beside it: for NAME.data_spec
/// (real time) NAME.swdir, .swdir2, .swr1, .swr2; for NAMEwYEAR.txt (history) the same name with d, i, j, k.
/// A path that begins with "builtin:" names a shipped spectrum ("builtin:synthetic-bimodal").
/// @param options NULL: the defaults.
/// Errors: IO, UNSUPPORTED (a packing that this build does not have), and those of bolan_measured_spectrum_parse().
BOLAN_API bolan_result bolan_spectrum_load(const char *path, const bolan_spectrum_options *options,
                                           bolan_measured_spectrum **out);
/// Lists what such a file holds. Errors: IO, UNSUPPORTED, and those of bolan_spectrum_contents_parse().
BOLAN_API bolan_result bolan_spectrum_contents_load(const char *path, bolan_spectrum_contents **out);
/// Writes the spectrum of a sea in the form that the suffix of @p path names:
/// - .png: a polar plot of 960 x 720 with axes, scale, heights, periods and the parts of bolan_sea_state_partition();
/// - .csv: frequency [Hz], direction FROM [deg], density [m2/Hz/deg], a row a cell;
/// - .spec: SWAN text, which bolan_spectrum_load() reads back equal within 5e-8 of the largest density.
/// The grid is that of bolan_measured_spectrum_sample(). @p title stands above the plot.
/// Errors: ARGUMENT (another suffix), IO, MEMORY, FORMAT (a sea of more than 40 m). Then nothing is written.
BOLAN_API bolan_result bolan_spectrum_save(const char *path, const bolan_sea_state *sea_state, const char *title);

/// Reads part of a raster, projected or geographic, of any format of GDAL, as elevations on a local grid.
/// The grid is in metres around (desc->latitude, longitude): azimuthal equidistant, x east, y north, +-radius.
/// The step of the grid is the resolution of the raster, or coarser where a side would need more than 4096 samples.
/// Longitudes may run -180..180 or 0..360.
/// Outside the raster its rim continues.
///
/// The metadata of the file are used, and the desc overrides them:
/// - which variable or band is the elevation: by CF standard_name, name, description, unit; several that may be:
///   FORMAT, with their names;
/// - unit (of the band, else of the vertical CRS), scale and offset, and direction (CF `positive`, standard names of
///   depths, a vertical CRS that counts down);
/// - no-data: the declared value, NaN, mask and alpha bands. Values below -12000 m or above 9000 m, which no place on
///   Earth has, and a lone -9999 are no-data too, with a warning;
/// - coordinates: the CRS; a local CRS is metres. Without any: degrees where the step is below 0.5 and the numbers can
///   be degrees, or where they span the globe, else metres, with a warning.
///
/// Where no-data or 0 stands for sea, the bed is nowhere above the data around it.
/// It falls off from the coast like a sandy beach (Dean 1991: 0.1 m^(1/3) distance^(2/3)), to 50 m.
/// One message of level INFO names what was chosen.
/// Errors: IO, FORMAT, ARGUMENT (a field of the desc; the place is outside), MEMORY.
BOLAN_API bolan_result bolan_raster_load(const bolan_raster_desc *desc, bolan_ground **out);

/// A growable list of points.
typedef struct bolan_points {
    /// Number of points.
    uint32_t count;
    /// The points [m].
    bolan_dvec3 *points;
    /// Points that the memory holds.
    size_t capacity;
} bolan_points;
/// Parses CSV of x,y[,z] [m].
/// A header line that begins with x is optional. Blank lines and # comments are skipped.
/// Numbers may stand in double quotes, separated by commas, semicolons or white space.
/// A number that is missing, not finite or beyond 1e8 m is refused with its line.
BOLAN_API bolan_result bolan_points_parse(const char *name, const char *text, size_t size, bolan_points *out);
/// Like bolan_points_parse(), from a file.
/// Errors: also IO.
BOLAN_API bolan_result bolan_points_load(const char *path, bolan_points *out);
/// Releases the points and leaves an empty list.
/// NULL-safe.
BOLAN_API void bolan_points_destroy(bolan_points *points);

/// Points of a file of any length, read piece by piece in constant memory.
typedef struct bolan_points_reader bolan_points_reader;
/// Opens a file of points, of the format of bolan_points_parse(), with lines of at most 65535 bytes.
/// Errors: IO, MEMORY; then *out is NULL.
BOLAN_API bolan_result bolan_points_open(const char *path, bolan_points_reader **out);
/// Reads the next points: @p count receives how many, at most @p capacity, and 0 at the end. A point that has no z gets
/// NAN for it. Errors: IO; FORMAT with file and line, also for a file without a point: then nothing more is read.
BOLAN_API bolan_result bolan_points_next(bolan_points_reader *reader, bolan_dvec3 *points, uint32_t capacity,
                                         uint32_t *count);
/// How much was read and how much there is [bytes]; @p size is 0 where that is not known, as of a pipe.
BOLAN_API void bolan_points_progress(const bolan_points_reader *reader, uint64_t *position, uint64_t *size);
/// NULL-safe; NULLs.
BOLAN_API void bolan_points_close(bolan_points_reader **reader);

// ---- images and video -----------------------------------------------------------------------------------------------

/// Longest side of an image that is written [px].
#define BOLAN_IMAGE_MOST_SIDE 65536
/// Most pixels of an image that is written.
#define BOLAN_IMAGE_MOST_PIXELS (1u << 28)

/// Writes an 8-bit sRGB image of 3 channels, row 0 at the top, as PNG.
/// Width and height 1..BOLAN_IMAGE_MOST_SIDE, their product at most BOLAN_IMAGE_MOST_PIXELS.
BOLAN_API bolan_result bolan_png_write(const char *path, uint32_t width, uint32_t height, const uint8_t *rgb);
/// Reads an image of any format of stb_image as 8-bit RGB.
/// Release it with bolan_release(rgb, width * height * 3).
/// Errors: IO; FORMAT, also for a header with more pixels than the file can hold, or more than 16384 each way; MEMORY.
BOLAN_API bolan_result bolan_image_read(const char *path, uint32_t *width, uint32_t *height, uint8_t **rgb);
/// One channel of an EXR image.
typedef struct bolan_exr_channel {
    /// Name of the channel, such as "R".
    const char *name;
    /// width * height values, row 0 at the top.
    const float *pixels;
} bolan_exr_channel;
/// Writes an EXR image of 32-bit floats, ZIP compressed.
/// The channels, 1..64, may stand in any order and must have different names.
/// Errors: ARGUMENT, IO, MEMORY (the file is encoded in memory first).
BOLAN_API bolan_result bolan_exr_write(const char *path, uint32_t width, uint32_t height,
                                       const bolan_exr_channel *channels, uint32_t count);

/// An attribute in the header of an EXR part: text, a number or a vector.
typedef struct bolan_exr_attribute {
    /// Its name, such as "sunDirection".
    const char *name;
    /// Text; NULL: numbers.
    const char *text;
    /// 1 (a double) or 3 (a vector of floats); of text 0.
    uint32_t count;
    double number[3];
} bolan_exr_attribute;
/// A part of an EXR image.
typedef struct bolan_exr_part {
    /// Its name, which no other part has; NULL in an image of one part.
    const char *name;
    uint32_t width, height;
    /// 1..64 channels.
    const bolan_exr_channel *channels;
    uint32_t channel_count;
    const bolan_exr_attribute *attributes;
    uint32_t attribute_count;
    /// The file holds 16-bit floats, to the nearest.
    bool half;
} bolan_exr_part;
/// Writes an EXR image of 1..16 parts; otherwise like bolan_exr_write().
BOLAN_API bolan_result bolan_exr_write_parts(const char *path, const bolan_exr_part *parts, uint32_t count);

/// A film that is being written.
typedef struct bolan_video bolan_video;
/// Checks that a film can be begun, so that long work fails before it starts.
/// Leaves nothing behind.
/// Errors: those of bolan_video_open().
BOLAN_API bolan_result bolan_video_check(const char *path, uint32_t width, uint32_t height, double fps);
/// Begins a film by starting the `ffmpeg` program: .mp4 (H.264, yuv420p) or .webm (VP9) by the suffix.
/// Width and height must be even; @p fps is 1..240.
/// Errors: UNSUPPORTED where ffmpeg is not installed; ARGUMENT, also for a device or pipe; MEMORY; IO, with the message
/// of ffmpeg.
BOLAN_API bolan_result bolan_video_open(const char *path, uint32_t width, uint32_t height, double fps,
                                        bolan_video **out);
/// Appends a frame, rgb as for bolan_png_write().
/// Errors: IO when ffmpeg has ended; then call bolan_video_close().
BOLAN_API bolan_result bolan_video_write(bolan_video *video, const uint8_t *rgb);
/// Ends the stream and waits for ffmpeg.
/// The file gets its name when ffmpeg has succeeded without a message and the container is complete.
/// @param keep false: the film is discarded.
/// NULL-safe; NULLs the pointer.
/// Errors: IO, with the first line of ffmpeg's messages.
BOLAN_API bolan_result bolan_video_close(bolan_video **video, bool keep);

#ifdef __cplusplus
}
#endif
#endif

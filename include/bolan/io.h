// SPDX-License-Identifier: MIT
/// @file io.h
/// Tier 3, library bolan_io. Files: scenes (YAML), rasters (GDAL), measured spectra, images (PNG, EXR), video (the
/// ffmpeg program), query points (CSV). Every writer writes under a temporary name beside the file and renames at the
/// end: no partial file is left, and a file that stood there is replaced whole or not at all. Numbers in files and
/// arguments of programs are those of the C locale, whatever locale the host program has set. Errors are ::bolan_result
/// with one logged sentence: file, line or field, what was expected; on failure nothing is returned. Not thread-safe
/// unless said.
#ifndef BOLAN_IO_H
#define BOLAN_IO_H

#include "bolan/scene.h"
#include "bolan/tiles.h"

#ifdef __cplusplus
extern "C" {
#endif

// ---- files ----------------------------------------------------------------------------------------------------------

/// Writes a whole file. Symbolic links are followed, also to a name that is not there yet; the mode of a file that is
/// replaced is kept, hard links to it keep the old content. A device or pipe is opened once and written straight. IO
/// where it cannot be written, and for a file that has no permission to write for anybody.
bolan_result bolan_file_write(const char *path, const void *data, size_t size);
/// Would a file be written at @p path? Leaves nothing behind; for long work that should fail before it starts. IO if
/// not.
bolan_result bolan_file_check_writable(const char *path);
/// Removes every file and folder of this library that is being written and not finished, and ends the ffmpeg processes.
/// For a signal handler that ends the program: async-signal-safe, from any thread. No file is written after it: a
/// thread that tries to waits for ever, so call _exit() next.
void bolan_files_abandon(void);

// ---- scenes ---------------------------------------------------------------------------------------------------------

/// Reads a scene: the name of a built-in scene ("island"), or a path to a YAML file of at most 256 KiB. Relative paths
/// in the file are taken from the file's folder. On failure @p scene is untouched: IO, or FORMAT with file, line and
/// key (an unknown key, a value outside its range, text that is not YAML).
bolan_result bolan_scene_load(const char *name_or_path, bolan_scene *scene);
/// Parses YAML text of @p size bytes; @p name is used in messages; relative paths stay as they are.
bolan_result bolan_scene_parse(const char *name, const char *text, size_t size, bolan_scene *scene);
/// Names of the built-in scenes; NULL past the last.
const char *bolan_scene_builtin_name(uint32_t index);

/// What a scene refers to, loaded: the measured spectrum and the terrain (NULL where the scene has none), the models.
typedef struct bolan_scene_assets {
    bolan_measured_spectrum *spectrum;
    bolan_terrain *terrain;
    bolan_tiles *tiles;                                  ///< of scene->tiles_path, or NULL
    uint32_t model_count;                                ///< different models
    bolan_model *models[BOLAN_MAX_OBJECTS];              ///< owned
    const bolan_model *object_models[BOLAN_MAX_OBJECTS]; ///< the model of each object of the scene
} bolan_scene_assets;
/// Reads them. A raster scene with an empty path takes the global ETOPO5 relief where Debian's ferret-datasets put it,
/// and says what to do when it is not there. Errors: IO, FORMAT, MEMORY; @p out is then empty.
bolan_result bolan_scene_assets_load(const bolan_scene *scene, bolan_scene_assets *out);
/// NULL-safe; NULLs the members.
void bolan_scene_assets_destroy(bolan_scene_assets *assets);
/// Creates the scene's sea: its desc with the measured spectrum of @p assets put in.
bolan_result bolan_scene_create_sea(const bolan_scene *scene, const bolan_scene_assets *assets, bolan_sea **out);

/// Reads a model with the assimp library: OBJ, glTF 2.0 and what else it knows. Files count as y-up and are turned:
/// (x, y, z) becomes (x, -z, y). Node transforms are applied; the base colour of the material times the colour of the
/// vertex, taken as linear, is the albedo, and the sky is open; textures are not read. Normals are made where there are
/// none. At most 256 MiB and 16777216 vertices. Errors: IO, FORMAT (no triangle in it, a vertex that is not finite),
/// MEMORY.
bolan_result bolan_model_load(const char *path, bolan_model **out);

// ---- tiles ----------------------------------------------------------------------------------------------------------

/// Writes tiles into the new folder @p folder, whole or not at all: index.json and, for each frame NNN from 000,
/// height_NNN.pgm (16-bit grey: (value - 32768) * height_step metres), normal_NNN.png, detail_NNN.png,
/// caustics_NNN.png. Row 0 of a picture is row 0 of the tile. IO: it is there already, or cannot be written; MEMORY.
bolan_result bolan_tiles_save(const bolan_tiles *tiles, const char *folder);
/// Would the folder be written? Leaves nothing behind. IO if not.
bolan_result bolan_tiles_check_writable(const char *folder);
/// Reads such a folder. Errors: IO; FORMAT with the file and what is wrong with it (index.json is one JSON object with
/// the numbers that bolan_tiles_save() writes, each once, and nothing else); ARGUMENT, MEMORY.
bolan_result bolan_tiles_load(const char *folder, bolan_tiles **out);

// ---- spectra, rasters, points ---------------------------------------------------------------------------------------

/// Reads a measured spectrum file of at most 64 MiB; @p record in time, 0 the earliest. For an NDBC real-time
/// .data_spec the companions of the same stem beside it (.swdir, .swdir2, .swr1, .swr2) are used where they are. A path
/// that begins with "builtin:" names a shipped spectrum ("builtin:synthetic-bimodal"). Errors: IO, FORMAT, MEMORY,
/// ARGUMENT (record).
bolan_result bolan_spectrum_load(const char *path, uint32_t record, bolan_measured_spectrum **out);

/// Reads part of a raster (band 1; any GDAL format; projected or geographic) as elevations on a square local grid in
/// metres around (@p latitude, @p longitude) [deg] (NAN: its centre): azimuthal equidistant, x east, y north, +-@p
/// radius. No-data becomes the mean of its neighbours, and outside the raster the rim continues. The grid's step
/// follows the raster's own resolution, coarser where that would need more than 4096 samples a side; longitudes may run
/// -180..180 or 0..360. Of a file with several rasters (NetCDF) the first is read. Errors: IO, FORMAT, ARGUMENT (the
/// place is outside), MEMORY.
bolan_result bolan_raster_load(const char *path, double latitude, double longitude, double radius,
                               double vertical_scale, bolan_terrain **out);

/// A growable list of points.
typedef struct bolan_points {
    uint32_t count;
    bolan_dvec3 *points;
    size_t capacity;
} bolan_points;
/// CSV of x,y[,z] [m] with an optional header line, which begins with x; numbers may stand in double quotes; blank
/// lines and # comments are skipped, numbers may be separated by commas, semicolons or white space. A number that is
/// missing, not finite or beyond 1e8 m is refused with its line.
bolan_result bolan_points_parse(const char *name, const char *text, size_t size, bolan_points *out);
/// The same from a file. IO where it cannot be read.
bolan_result bolan_points_load(const char *path, bolan_points *out);
/// Releases the points; NULL-safe, and leaves an empty list.
void bolan_points_destroy(bolan_points *points);

// ---- images and video -----------------------------------------------------------------------------------------------

/// 8-bit sRGB, 3 channels, row 0 at the top, to PNG. Width and height 1..16384.
bolan_result bolan_png_write(const char *path, uint32_t width, uint32_t height, const uint8_t *rgb);
/// Reads any image stb_image can, as 8-bit RGB; release with bolan_release(pixels, width * height * 3). Errors: IO;
/// FORMAT, also for a header that asks for more pixels than the file can hold, or than 16384 each way; MEMORY.
bolan_result bolan_image_read(const char *path, uint32_t *width, uint32_t *height, uint8_t **rgb);
/// One plane of an EXR; pixels row 0 at the top.
typedef struct bolan_exr_channel {
    const char *name;
    const float *pixels;
} bolan_exr_channel;
/// Multi-channel 32-bit float EXR, ZIP compressed. Channels may come in any order; 1..64 of them, with different names.
/// Errors: ARGUMENT, IO, MEMORY: the file is made in memory first.
bolan_result bolan_exr_write(const char *path, uint32_t width, uint32_t height, const bolan_exr_channel *channels,
                             uint32_t count);

/// A film that is being written.
typedef struct bolan_video bolan_video;
/// Could a film be begun? Leaves nothing behind; for long work that should fail before it starts. Errors as for
/// bolan_video_open().
bolan_result bolan_video_check(const char *path, uint32_t width, uint32_t height, double fps);
/// Starts the `ffmpeg` program: .mp4 (H.264, yuv420p) or .webm (VP9) by the suffix. Width and height must be even, @p
/// fps 1..240. UNSUPPORTED where ffmpeg is not installed; ARGUMENT, also for a device or pipe; MEMORY; IO with ffmpeg's
/// own words.
bolan_result bolan_video_open(const char *path, uint32_t width, uint32_t height, double fps, bolan_video **out);
/// Appends a frame, rgb as for bolan_png_write(). IO when ffmpeg gave up; then only bolan_video_close() is left to do.
bolan_result bolan_video_write(bolan_video *video, const uint8_t *rgb);
/// Ends the stream and waits for ffmpeg. The file gets its name when ffmpeg succeeded without a complaint and the
/// container is complete; otherwise IO, with the first line that ffmpeg said. @p keep false: throws it away. NULL-safe,
/// NULLs.
bolan_result bolan_video_close(bolan_video **video, bool keep);

#ifdef __cplusplus
}
#endif
#endif

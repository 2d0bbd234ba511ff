// SPDX-License-Identifier: MIT
/// @file scene.h
/// Tier 3. A scene as plain data: camera, sun, sky, water, terrain, technique, and the sea. No pointers but the ones
/// the caller puts in; copy it freely. io.h reads it from YAML; render.h draws it. Every function here is pure and
/// thread-safe.
#ifndef BOLAN_SCENE_H
#define BOLAN_SCENE_H

#include "bolan/ground.h"
#include "bolan/model.h"
#include "bolan/optics.h"
#include "bolan/params.h"
#include "bolan/surface.h"
#include "bolan/waves.h"

#ifdef __cplusplus
extern "C" {
#endif

#define BOLAN_NAME_MAX 64   ///< bytes of a scene's name, NUL included
#define BOLAN_PATH_MAX 1024 ///< bytes of a path, NUL included

// ---- technique ------------------------------------------------------------------------------------------------------

/// How the surface is shaded.
typedef enum bolan_optics_kind {
    BOLAN_OPTICS_PHYSICAL, ///< filtered slopes, Fresnel, sky, absorption, foam
    BOLAN_OPTICS_MIRROR, ///< pictures of what is mirrored and refracted, looked up where waves bend them (Ma, Zhu & Gong 2006)
    BOLAN_OPTICS_PHONG, ///< Fresnel mix of such pictures; ambient, diffuse, specular light (Liu & Xie 2010)
    BOLAN_OPTICS_LIT,   ///< normals of the mesh and one light (Liu, Xu & Chen 2009)
    BOLAN_OPTICS_CREST, ///< light through the crests, ramps of foam at the shore (Ni, Zhang & Tan)
} bolan_optics_kind;
#define BOLAN_OPTICS_KINDS 5 ///< how many there are
/// The names that the command line and scene files use, "physical" ...; by bolan_optics_kind, NULL at the end.
extern const char *const bolan_optics_kind_names[BOLAN_OPTICS_KINDS + 1];

/// A way to make water: a wave model x a surface x an optics. Every mix works.
typedef struct bolan_technique {
    const char *name;
    bolan_wave_model waves;
    bolan_surface_kind surface;
    bolan_optics_kind optics;
    int wind_spectrum; ///< a bolan_spectrum_kind: what the technique makes of a wind; -1: the scene's own wind_spectrum
} bolan_technique;
extern const bolan_technique bolan_technique_ocean;        ///< the default
extern const bolan_technique bolan_technique_two_triangle; ///< Ma, Zhu & Gong 2006: two triangles, all else is textures
extern const bolan_technique bolan_technique_exp_cosine;   ///< Liu & Xie 2010: a sum of exp(cos) in each pixel
extern const bolan_technique
    bolan_technique_nested_grid; ///< Liu, Xu & Chen 2009: Pierson-Moskowitz waves on nested grids
extern const bolan_technique bolan_technique_flight_sim; ///< Ni, Zhang & Tan: Phillips waves on a projected grid
/// All techniques, for lists, the default first; @p count receives the number. Static storage.
const bolan_technique *bolan_techniques(uint32_t *count);
/// By name; NULL when there is none of that name.
const bolan_technique *bolan_technique_find(const char *name);

/// Parts of the light that can be switched off, to see what each does. A part that an optics does not have is ignored.
typedef enum bolan_effect {
    BOLAN_EFFECT_REFLECTION = 1 << 0, ///< what the water mirrors
    BOLAN_EFFECT_REFRACTION = 1 << 1, ///< what shines through it
    BOLAN_EFFECT_BUMP = 1 << 2,       ///< light and dark by the slope of the waves
    BOLAN_EFFECT_DISTORTION = 1 << 3, ///< waves bend what is mirrored and refracted
    BOLAN_EFFECT_GLITTER = 1 << 4,    ///< the sun mirrored
    BOLAN_EFFECT_CAUSTICS = 1 << 5,   ///< light that the waves gather on the sea bed
    BOLAN_EFFECT_AMBIENT = 1 << 6,    ///< the water's own colour
    BOLAN_EFFECT_DIFFUSE = 1 << 7,
    BOLAN_EFFECT_SPECULAR = 1 << 8,
    BOLAN_EFFECT_SCATTERING = 1 << 9, ///< light through crests
    BOLAN_EFFECT_FOAM = 1 << 10,
    BOLAN_EFFECT_FOG = 1 << 11, ///< under water
} bolan_effect;
#define BOLAN_EFFECTS_ALL 0xfffu ///< the default
#define BOLAN_EFFECTS 12         ///< how many there are
/// Names of the effects by bit, "reflection" ...; NULL at the end.
extern const char *const bolan_effect_names[BOLAN_EFFECTS + 1];

/// What is drawn of the water.
typedef enum bolan_show {
    BOLAN_SHOW_PICTURE, ///< the water
    BOLAN_SHOW_MASK,    ///< false colours: open sea, crests, shore, land
    BOLAN_SHOW_MESH,    ///< the edges of its triangles
} bolan_show;
#define BOLAN_SHOWS 3 ///< how many there are
/// Names by bolan_show, "picture" ...; NULL at the end.
extern const char *const bolan_show_names[BOLAN_SHOWS + 1];

/// Shading options.
typedef struct bolan_look {
    bool paper;        ///< follow the technique's paper to the letter, where we know better; default false
    uint32_t effects;  ///< bits of bolan_effect; default all
    bolan_show show;   ///< default PICTURE
    double distortion; ///< factor on how far waves bend what is looked up (MIRROR, PHONG), 0..4; default 1
    double
        blend; ///< lerpScale: share of the mirrored and refracted over the water's own texture (MIRROR), 0..1; default 0.85
    double ambient;   ///< Ka (PHONG, LIT), 0..2; default 1
    double diffuse;   ///< Kd (PHONG, LIT), 0..2; default 0.05
    double specular;  ///< Ks (PHONG, LIT), 0..4; default 1
    double shininess; ///< exponent of the highlight (PHONG, LIT), 1..4096; default 300. Raised: smaller and sharper
} bolan_look;
/// The defaults named beside the fields.
bolan_look bolan_look_default(void);

/// How much a picture may cost: steps of the grid, look-ups and target sizes. Raised: finer and slower.
typedef enum bolan_quality {
    BOLAN_QUALITY_LOW,
    BOLAN_QUALITY_MEDIUM,
    BOLAN_QUALITY_HIGH,
    BOLAN_QUALITY_ULTRA,
} bolan_quality;

// ---- the scene ------------------------------------------------------------------------------------------------------

/// Where the picture is taken from.
typedef struct bolan_camera {
    bolan_dvec3 position; ///< world [m], z above mean sea level; x, y +-1e7, z -1000..1e6; default (0, 0, 3)
    double heading_deg;   ///< compass [deg], -360..360; default 0: north
    double pitch_deg;     ///< up [deg], -90..90; default 0
    double roll_deg;      ///< clockwise [deg], -180..180; default 0
    double fov_deg;       ///< vertical field of view [deg], 1..150; default 50
} bolan_camera;

/// Where a moving camera is at a moment.
typedef struct bolan_camera_key {
    double time; ///< [s], +-1e9
    bolan_camera camera;
} bolan_camera_key;
#define BOLAN_MAX_CAMERA_KEYS 32 ///< of a scene's path

/// The sun, the air and the clouds.
typedef struct bolan_sky {
    double sun_azimuth_deg;   ///< compass [deg], -360..360; default 220
    double sun_elevation_deg; ///< [deg], -90..90; default 35. Below -18 it is night
    double visibility;        ///< meteorological range at sea level [m], 500..300000: haze; default 40000
    double cloud_cover;       ///< share of the sky with clouds, 0..1; default 0.3
    double cloud_base;        ///< [m], 100..12000; default 1200
    uint64_t cloud_seed;      ///< which clouds; default 1
} bolan_sky;

/// Where the sun stands at @p unix_time [s since 1970-01-01 UTC] seen from @p latitude, @p longitude [deg, north and
/// east positive]: compass azimuth and elevation [deg] without refraction, within 0.02 deg for the years 1950 to 2050.
/// Source: the Astronomical Almanac's low-precision sun (Michalsky, Solar Energy 40, 1988).
void bolan_sun_position(double unix_time, double latitude, double longitude, double *azimuth, double *elevation);

/// The water as light meets it, and its level.
typedef struct bolan_seawater {
    bolan_jerlov type; ///< default IB
    double level;      ///< mean water level above the terrain's datum [m], -20..20; default 0
    double foam;       ///< strength of the foam, 0..2; default 1
} bolan_seawater;

/// Where the ground comes from.
typedef enum bolan_ground_kind {
    BOLAN_GROUND_NONE,
    BOLAN_GROUND_ISLAND,
    BOLAN_GROUND_RASTER,
    BOLAN_GROUND_POND, ///< bolan_ground_create_pond(); its ground is drawn as the model "builtin:pond-ground"
} bolan_ground_kind;

/// What a sample without a value is.
typedef enum bolan_raster_nodata {
    /// SEA where the holes reach the rim of what is read, FILL where data enclose them; a warning says so.
    BOLAN_NODATA_AUTO,
    BOLAN_NODATA_FILL, ///< takes the elevation around it
    BOLAN_NODATA_SEA,  ///< a sea bed that falls off from the data: land-only elevations
} bolan_raster_nodata;

/// What an elevation of exactly 0 is.
typedef enum bolan_raster_zero {
    BOLAN_ZERO_AUTO, ///< LAND, with a warning where much of the raster is 0
    BOLAN_ZERO_LAND, ///< ground at mean sea level
    BOLAN_ZERO_SEA,  ///< like BOLAN_NODATA_SEA: elevations of land whose sea is 0
} bolan_raster_zero;

#define BOLAN_CRS_MAX 256 ///< of bolan_raster_desc.crs, with its NUL

/// Elevations from a raster, and what overrules the file: see bolan_raster_load().
typedef struct bolan_raster_desc {
    /// Any file that GDAL reads, or a name with a prefix of GDAL's (NETCDF:f.nc:z, HDF5:..., GTIFF_DIR:2:f.tif).
    /// Default "".
    char path[BOLAN_PATH_MAX];
    /// Name of the variable, or of the band; default "": the one that is an elevation by its standard_name, name or
    /// unit.
    char variable[BOLAN_NAME_MAX];
    /// Number of the band, from 1; default 0: the only one, or the one that is an elevation by its name.
    uint32_t band;
    /// Coordinates of the file: "metres", "degrees", or a CRS that PROJ knows ("EPSG:32604", WKT); default "": the
    /// file's.
    char crs[BOLAN_CRS_MAX];
    /// Place of the scene's origin [deg], latitude +-90, longitude +-360; default NAN: the centre of the raster.
    double latitude, longitude;
    /// Half side of the square that is read [m], 100..5e6; default 150000.
    double radius;
    /// Metres upwards per unit of the raster, +-(1e-3..1e3), negative for depths; default NAN: by the unit and the sign
    /// that the file states. Scale and offset of the file apply first.
    double vertical_scale;
    /// The number that stands for no-data, as in the file; default NAN: what the file declares.
    double nodata_value;
    bolan_raster_nodata nodata; ///< default AUTO
    bolan_raster_zero zero;     ///< default AUTO
} bolan_raster_desc;
/// The defaults named beside the fields.
bolan_raster_desc bolan_raster_desc_default(void);

/// The ground, by description; loaded by bolan_scene_assets_load().
typedef struct bolan_ground_source {
    bolan_ground_kind kind;   ///< default NONE: open sea
    bolan_island_desc island; ///< for ISLAND
    bolan_raster_desc raster; ///< for RASTER; an empty path: the global relief (see bolan_scene_assets_load())
} bolan_ground_source;

/// Which axis of a model file points up.
typedef enum bolan_up {
    BOLAN_UP_Y, ///< OBJ, glTF: (x, y, z) becomes (x, -z, y)
    BOLAN_UP_Z, ///< files of geographic information systems: (x, y, z) stays
} bolan_up;

/// A thing in the scene: a model and where it stands.
typedef struct bolan_object {
    char model[256];      ///< "builtin:NAME" (see bolan_model_builtin_name()) or a path: OBJ, glTF
    bolan_dvec3 position; ///< of the model's origin, world [m]; x, y +-1e7, z -11000..10000
    double heading_deg;   ///< compass direction of its +y axis [deg], -360..360
    double scale;         ///< 1e-3..1e3
    bool floats;          ///< rides on the waves: z is its height above the water under it
    bolan_up up;          ///< of a file; default Y
    bolan_dvec3 offset;   ///< subtracted from a file's coordinates, in the file's axes [file units], +-1e8; default 0
} bolan_object;
#define BOLAN_MAX_OBJECTS 64 ///< of a scene

/// Everything that is drawn, except what lies in files: see bolan_scene_assets.
typedef struct bolan_scene {
    char name[BOLAN_NAME_MAX];          ///< of a built-in scene, or the file it was read from
    char description[256];              ///< one sentence, "" for none
    bolan_technique technique;          ///< default bolan_technique_ocean. See bolan_scene_set_technique()
    bolan_look look;                    ///< how it is carried out
    bolan_sea_desc sea;                 ///< sea.sea_state.measured stays NULL here; sea.waves is the technique's
    double fetch;                       ///< of the wind sea [m], 100..1e7; default 2e5. See bolan_scene_set_wind()
    bolan_spectrum_kind wind_spectrum;  ///< shape of the wind sea; default JONSWAP. See bolan_scene_set_wind()
    char spectrum_path[BOLAN_PATH_MAX]; ///< "" or a measured spectrum file
    bolan_spectrum_options spectrum;    ///< what is read of that file, and what stands in for what it lacks
    bolan_camera camera;
    uint32_t camera_key_count;                           ///< 0..BOLAN_MAX_CAMERA_KEYS; 0: the camera stays where it is
    bolan_camera_key camera_keys[BOLAN_MAX_CAMERA_KEYS]; ///< its path, times ascending
    bolan_sky sky;
    bolan_seawater water;
    bolan_ground_source terrain;
    char tiles_path[BOLAN_PATH_MAX]; ///< "", or a folder of baked tiles for the mirror optics: see bolan_tiles_load()
    uint32_t object_count;           ///< 0..BOLAN_MAX_OBJECTS
    bolan_object objects[BOLAN_MAX_OBJECTS];
    double time;     ///< [s], +-1e9; default 0
    double exposure; ///< in stops over the automatic exposure, -10..10; default 0
} bolan_scene;

/// The parameters of the structs above; those of the wind sea are fields of bolan_scene.
extern const bolan_param_table bolan_technique_params, bolan_look_params, bolan_camera_params, bolan_camera_key_params;
extern const bolan_param_table bolan_sky_params, bolan_seawater_params, bolan_ground_source_params, bolan_raster_params;
extern const bolan_param_table bolan_object_params, bolan_scene_params, bolan_wind_sea_params;
/// Where they stand in a scene and in the maps of a scene file; a NULL table ends the list.
extern const bolan_param_group bolan_scene_groups[];

/// A scene with every default: open sea, wind 8 m/s, camera 3 m up, sun 35 degrees high.
bolan_scene bolan_scene_default(void);
/// Gives the scene another wind of @p wind_speed [m/s] FROM @p from_deg [deg]: the wind sea is built anew from it, from
/// scene->fetch and the technique's spectrum or scene->wind_spectrum (Pierson-Moskowitz: fully developed, whatever the fetch; TMA: at the sea's
/// depth); swells stay. With a spectrum file the waves are the file's, and the wind only roughens them. The wind sea is
/// told from swells by its system's wind_speed, which is above 0. Values are checked by bolan_scene_validate().
void bolan_scene_set_wind(bolan_scene *scene, double wind_speed, double from_deg);
/// Gives the scene another technique: the wave model of its sea follows, and the wind sea is built anew where the
/// technique has a spectrum of its own.
void bolan_scene_set_technique(bolan_scene *scene, const bolan_technique *technique);
/// The camera at @p time [s]: on the path through the keys, where it begins before the first and ends after the last;
/// without keys scene->camera. Smooth, and never beyond the keys it lies between (monotone cubic pieces, Fritsch &
/// Carlson 1980); headings turn the short way.
bolan_camera bolan_scene_camera_at(const bolan_scene *scene, double time);
/// The desc of the scene's sea as its look wants it: scene->sea, and in paper mode the papers' own choices (sharpness 1,
/// equal width of frequencies).
bolan_sea_desc bolan_scene_sea_desc(const bolan_scene *scene);
/// Checks every field against its range; logs a sentence naming the field and returns ARGUMENT at the first that is
/// not.
bolan_result bolan_scene_validate(const bolan_scene *scene);

#ifdef __cplusplus
}
#endif
#endif

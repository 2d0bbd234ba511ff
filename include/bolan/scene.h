// SPDX-License-Identifier: MIT
/// @file scene.h
/// Tier 3. A scene as plain data: camera, sun, sky, water, ground, objects, technique, and the sea.
///
/// A scene owns nothing and may be copied. io.h reads it from YAML; world.h holds it with all that it refers to.
/// Every function here is pure and thread-safe.
#ifndef BOLAN_SCENE_H
#define BOLAN_SCENE_H

#include "bolan/formats.h"
#include "bolan/ground.h"
#include "bolan/model.h"
#include "bolan/optics.h"
#include "bolan/params.h"
#include "bolan/technique.h"
#include "bolan/water.h"
#include "bolan/waves.h"

#ifdef __cplusplus
extern "C" {
#endif

/// The eye and its lens.
typedef struct bolan_camera {
    /// Position [m], z above mean sea level; x, y +-1e7, z -1000..1e6; default (0, 0, 3).
    bolan_dvec3 position;
    /// Compass direction of the view [deg], -360..360; default 0: north.
    double heading_deg;
    /// Elevation of the view direction [deg], -90..90, positive upwards; default 0.
    double pitch_deg;
    /// Roll [deg], -180..180, positive clockwise; default 0.
    double roll_deg;
    /// Vertical field of view [deg], 1..150; default 50.
    double fov_deg;
} bolan_camera;

/// The camera at a time of its path.
typedef struct bolan_camera_key {
    /// Time [s], +-1e9.
    double time;
    /// The camera at that time.
    bolan_camera camera;
} bolan_camera_key;
/// Most camera keys of a scene.
#define BOLAN_MAX_CAMERA_KEYS 32

/// The sun, the air and the clouds.
typedef struct bolan_sky {
    /// Compass direction of the sun [deg], -360..360; default 220.
    double sun_azimuth_deg;
    /// Elevation of the sun [deg], -90..90; default 35. Below -18 it is night.
    double sun_elevation_deg;
    /// Meteorological range at sea level [m], 500..300000; default 40000. Raised: less haze.
    double visibility;
    /// Share of the sky with clouds, 0..1; default 0.3.
    double cloud_cover;
    /// Height of the clouds' base [m], 100..12000; default 1200.
    double cloud_base;
    /// Which clouds; default 1.
    uint64_t cloud_seed;
} bolan_sky;

/// What sun and sky give at the sea, linear, in units of the irradiance of the sun in space at normal incidence.
typedef struct bolan_sky_light {
    /// Unit vector to the sun.
    bolan_vec3 sun_direction;
    /// Irradiance of the sun on a surface that faces it; 0 below the horizon.
    bolan_vec3 sun_irradiance;
    /// Irradiance of the sky on a horizontal surface.
    bolan_vec3 sky_irradiance;
} bolan_sky_light;

/// Position of the sun at @p unix_time [s since 1970-01-01 UTC] seen from @p latitude, @p longitude [deg, north and
/// east positive].
/// @param azimuth receives the compass direction [deg].
/// @param elevation receives the elevation [deg] without refraction.
/// Within 0.02 deg for the years 1950 to 2050.
/// Source: the Astronomical Almanac's low-precision sun (Michalsky, Solar Energy 40, 1988).
BOLAN_API void bolan_sun_position(double unix_time, double latitude, double longitude, double *azimuth,
                                  double *elevation);

/// The water's colour and its level.
typedef struct bolan_seawater {
    /// Optical type of the water; default IB.
    bolan_jerlov type;
    /// Mean water level above the ground's datum [m], -20..20; default 0.
    double level;
    /// Strength of the foam, 0..2; default 1.
    double foam;
} bolan_seawater;

/// A model and where it stands.
typedef struct bolan_object {
    /// "builtin:NAME" (see bolan_content_model_name()), or the path of a model file: OBJ, glTF.
    char model[256];
    /// Position of the model's origin [m]; x, y +-1e7, z -11000..10000.
    bolan_dvec3 position;
    /// Compass direction of the model's +y axis [deg], -360..360.
    double heading_deg;
    /// Scale of the model, 1e-3..1e3.
    double scale;
    /// True: the object rides on the waves, and position.z is its height above the water under it.
    bool floats;
    /// Which axis of a model file points up; default Y.
    bolan_up up;
    /// Subtracted from a file's coordinates, in the file's axes and units, +-1e8; default 0.
    bolan_dvec3 offset;
} bolan_object;
/// Most objects of a scene.
#define BOLAN_MAX_OBJECTS 64

/// Everything that is drawn, except what lies in files: see bolan_world.
typedef struct bolan_scene {
    /// Name of a built-in scene, or the file that the scene was read from.
    char name[BOLAN_NAME_MAX];
    /// One sentence; "" for none.
    char description[256];
    /// Default bolan_technique_ocean. See bolan_scene_set_technique().
    bolan_technique technique;
    /// Shading options.
    bolan_look look;
    /// The sea. sea.sea_state.measured stays NULL; sea.waves is the technique's.
    bolan_sea_desc sea;
    /// Fetch of the wind sea [m], 100..1e7; default 2e5. See bolan_scene_set_wind().
    double fetch;
    /// Spectrum of the wind sea; default JONSWAP. See bolan_scene_set_wind().
    bolan_spectrum_kind wind_spectrum;
    /// Whether the wind raises a wind sea; default true. False: the sea has the systems of sea.sea_state alone, and the
    /// wind roughens them. See bolan_scene_set_wind().
    bool wind_sea;
    /// A measured spectrum file; "" for none.
    char spectrum_path[BOLAN_PATH_MAX];
    /// What is read from the spectrum file, and what replaces missing directions and spreads.
    bolan_spectrum_options spectrum;
    /// The camera where there is no path.
    bolan_camera camera;
    /// Number of keys, 0..BOLAN_MAX_CAMERA_KEYS; default 0: the camera does not move.
    uint32_t camera_key_count;
    /// The path of the camera, times ascending. See bolan_scene_camera_at().
    bolan_camera_key camera_keys[BOLAN_MAX_CAMERA_KEYS];
    /// Number of wave trains, 0..BOLAN_MAX_WAVE_LAYERS; default 0.
    uint32_t train_count;
    /// Wave trains that are added to the waves of the sea.
    bolan_wave_train_desc trains[BOLAN_MAX_WAVE_LAYERS];
    /// Sun, air and clouds.
    bolan_sky sky;
    /// The water's colour and level.
    bolan_seawater water;
    /// Where the ground comes from; default none.
    bolan_ground_source terrain;
    /// A folder of baked tiles for the mirror optics, see bolan_tiles_load(); "" for none.
    char tiles_path[BOLAN_PATH_MAX];
    /// Number of objects, 0..BOLAN_MAX_OBJECTS; default 0.
    uint32_t object_count;
    /// The objects.
    bolan_object objects[BOLAN_MAX_OBJECTS];
    /// Time of the scene [s], +-1e9; default 0.
    double time;
    /// Exposure over the automatic one [stops], -10..10; default 0.
    double exposure;
} bolan_scene;

/// The parameters of the structs above; those of the wind sea are fields of bolan_scene.
BOLAN_API extern const bolan_param_table bolan_camera_params, bolan_camera_key_params, bolan_sky_params,
    bolan_seawater_params;
BOLAN_API extern const bolan_param_table bolan_object_params, bolan_scene_params, bolan_wind_sea_params;
/// Where these parameters stand in a scene and in the maps of a scene file; a NULL table ends the list.
BOLAN_API extern const bolan_param_group bolan_scene_groups[];

/// Returns a scene with every default: open sea, wind 8 m/s, camera 3 m up, sun 35 degrees high.
BOLAN_API bolan_scene bolan_scene_default(void);

/// Gives the scene another wind of @p wind_speed [m/s] FROM @p from_deg [deg].
/// The wind sea is built anew from the wind, scene->fetch, and the technique's spectrum or scene->wind_spectrum.
/// A Pierson-Moskowitz sea is fully developed whatever the fetch; a TMA sea takes the sea's depth. Other systems stay.
/// The wind sea is the first wave system, where that has a wind_speed above 0.
/// With a spectrum file, or without scene->wind_sea, the wind only roughens the waves that are there.
/// bolan_scene_validate() checks the values.
BOLAN_API void bolan_scene_set_wind(bolan_scene *scene, double wind_speed, double from_deg);

/// Gives the scene another technique.
/// The sea takes the wave model of the technique.
/// The wind sea is built anew where the technique changes its spectrum.
BOLAN_API void bolan_scene_set_technique(bolan_scene *scene, const bolan_technique *technique);

/// Returns the camera at @p time [s]: on the path through the keys, or scene->camera where there are no keys.
/// Before the first key and after the last the camera stands still.
/// The path is smooth and overshoots no key (monotone cubic pieces, Fritsch & Carlson 1980).
/// Headings turn the short way.
BOLAN_API bolan_camera bolan_scene_camera_at(const bolan_scene *scene, double time);

/// Returns the desc of the scene's sea with the options of scene->look applied.
/// In paper mode the sea takes the choices of the papers: sharpness 1, equal width of frequencies.
BOLAN_API bolan_sea_desc bolan_scene_sea_desc(const bolan_scene *scene);

/// Checks every field against its range.
/// Logs a sentence that names the first field out of range, and returns ARGUMENT.
BOLAN_API bolan_result bolan_scene_validate(const bolan_scene *scene);

#ifdef __cplusplus
}
#endif
#endif

// SPDX-License-Identifier: MIT
// The parameters of a scene, and the maps of a scene file in which they stand.
#include "bolan/scene.h"
#include "params/rows.h"

static const char *const up_names[] = {"y", "z", NULL}; // bolan_up

// ---- camera, sky, water ---------------------------------------------------------------------------------------------

#define STRUCT bolan_camera
static const bolan_param camera_rows[] = {
    NUMBER(position.x, .key = "position", .low = -1e7, .high = 1e7, .unit = "m",
           .help = "east, north, up from the scene's origin at mean sea level"),
    NUMBER(position.y, .key = "position", .low = -1e7, .high = 1e7, .unit = "m"),
    NUMBER(position.z, .key = "position", .low = -1000, .high = 1e6, .unit = "m", .fallback = 3),
    HEADING(heading_deg, .key = "heading", .help = "compass degrees"),
    NUMBER(pitch_deg, .key = "pitch", .low = -90, .high = 90, .unit = "degrees", .help = "up"),
    NUMBER(roll_deg, .key = "roll", .low = -180, .high = 180, .unit = "degrees", .help = "clockwise"),
    NUMBER(fov_deg, .key = "fov", .low = 1, .high = 150, .unit = "degrees", .fallback = 50, .label = "field of view",
           .usual_low = 5, .usual_high = 120, .help = "vertical field of view"),
};
#undef STRUCT
const bolan_param_table bolan_camera_params = TABLE("bolan_camera", camera_rows);

#define STRUCT bolan_camera_key
static const bolan_param camera_key_rows[] = {
    NUMBER(time, .key = "time", .low = -1e9, .high = 1e9, .unit = "s", .rules = BOLAN_PARAM_REQUIRED,
           .help = "when the camera is there; times grow"),
};
#undef STRUCT
const bolan_param_table bolan_camera_key_params = TABLE("bolan_camera_key", camera_key_rows);

#define STRUCT bolan_sky
static const bolan_param sky_rows[] = {
    HEADING(sun_azimuth_deg, .key = "sun.azimuth", .fallback = 220, .label = "sun azimuth", .usual_high = 360,
            .help = "compass degrees"),
    NUMBER(sun_elevation_deg, .key = "sun.elevation", .low = -90, .high = 90, .unit = "degrees", .fallback = 35,
           .label = "sun elevation", .usual_low = -18, .usual_high = 90, .digits = 1, .help = "below -18 it is night"),
    NUMBER(visibility, .key = "visibility_km", .low = 500, .high = 300e3, .unit = "m", .fallback = 40e3, .factor = 1e3,
           .factor_unit = "km", .rules = BOLAN_PARAM_LOGARITHMIC, .digits = 1,
           .help = "meteorological range at sea level: haze"),
    NUMBER(cloud_cover, .key = "clouds.cover", .low = 0, .high = 1, .fallback = 0.3, .label = "clouds", .digits = 2,
           .help = "share of the sky with clouds"),
    NUMBER(cloud_base, .key = "clouds.base", .low = 100, .high = 12000, .unit = "m", .fallback = 1200,
           .label = "cloud base", .usual_low = 300, .usual_high = 6000, .help = "height of the clouds' base"),
    WHOLE(cloud_seed, .key = "clouds.seed", .high = SEED_MAX, .fallback = 1, .help = "which clouds"),
};
#undef STRUCT
const bolan_param_table bolan_sky_params = TABLE("bolan_sky", sky_rows);

#define STRUCT bolan_seawater
static const bolan_param seawater_rows[] = {
    NAME(type, .key = "type", .option = "water", .names = bolan_jerlov_names, .high = BOLAN_JERLOV_9C,
         .fallback = BOLAN_JERLOV_IB, .label = "Jerlov type",
         .help = "Jerlov's optical type, five of the ocean and five of the coast: I is the clearest, 9C a muddy brown"),
    NUMBER(level, .key = "level", .low = -20, .high = 20, .unit = "m",
           .help = "mean water level over the ground's zero: tide"),
    NUMBER(foam, .key = "foam", .low = 0, .high = 2, .fallback = 1, .digits = 2, .help = "strength of the foam"),
};
#undef STRUCT
const bolan_param_table bolan_seawater_params = TABLE("bolan_seawater", seawater_rows);

// ---- objects --------------------------------------------------------------------------------------------------------

#define STRUCT bolan_object
static const bolan_param object_rows[] = {
    TEXT(model, .key = "model", .rules = BOLAN_PARAM_PATH | BOLAN_PARAM_REQUIRED,
         .help = "`builtin:NAME`, or a file that the assimp library reads: OBJ, glTF 2.0 and more, up to 64 MiB and 8 "
                 "388 608 "
                 "vertices; relative to the scene file"),
    NUMBER(position.x, .key = "position", .low = -1e7, .high = 1e7, .unit = "m",
           .help = "of the model's origin: east, north, up"),
    NUMBER(position.y, .key = "position", .low = -1e7, .high = 1e7, .unit = "m"),
    NUMBER(position.z, .key = "position", .low = -11000, .high = 10000, .unit = "m"),
    HEADING(heading_deg, .key = "heading", .help = "compass direction of the model's +y axis"),
    NUMBER(scale, .key = "scale", .low = 1e-3, .high = 1e3, .fallback = 1, .help = "factor on the model's size"),
    NAME(up, .key = "up", .names = up_names, .high = BOLAN_UP_Z,
         .help = "which axis of the file points up; files of geographic information systems have `z`"),
    NUMBER(offset.x, .key = "offset", .low = -1e8, .high = 1e8,
           .help = "subtracted from the file's coordinates, in its axes: brings map coordinates (UTM) near the origin. "
                   "They have been "
                   "rounded to half a metre by then"),
    NUMBER(offset.y, .key = "offset", .low = -1e8, .high = 1e8),
    NUMBER(offset.z, .key = "offset", .low = -1e8, .high = 1e8),
    FLAG(floats, .key = "floats", .help = "rides on the waves; z is then its height above the water under it"),
};
#undef STRUCT
const bolan_param_table bolan_object_params = TABLE("bolan_object", object_rows);

// ---- the scene ------------------------------------------------------------------------------------------------------

#define STRUCT bolan_scene
static const bolan_param scene_rows[] = {
    TEXT(name, .help = "of a built-in scene, or the file it was read from"),
    TEXT(description, .key = "description", .help = "one sentence, shown by `bolan info`"),
    TEXT(tiles_path, .key = "tiles", .rules = BOLAN_PARAM_PATH,
         .help = "a folder that `bolan bake` made, of 256 texels: the waves of the [mirror "
                 "optics](technique-two-triangle.md) "
                 "where the sea's are `textures`"),
    NUMBER(time, .key = "time", .option = "time", .low = -1e9, .high = 1e9, .unit = "s",
           .help = "the moment that is drawn; a film begins there"),
    NUMBER(exposure, .key = "exposure", .low = -10, .high = 10, .unit = "stops", .usual_low = -4, .usual_high = 4,
           .digits = 1, .help = "over the automatic exposure"),
};
static const bolan_param wind_sea_rows[] = {
    NUMBER(fetch, .key = "fetch_km", .option = "fetch", .low = 100, .high = 1e7, .unit = "m", .fallback = 200e3,
           .factor = 1e3, .factor_unit = "km", .usual_low = 1, .usual_high = 5000, .rules = BOLAN_PARAM_LOGARITHMIC,
           .help = "open water to windward; a short fetch makes a young, steep sea"),
    NAME(wind_spectrum, .key = "spectrum.shape", .names = bolan_wind_spectrum_names,
         .high = BOLAN_WIND_SPECTRUM_KINDS - 1, .fallback = BOLAN_SPECTRUM_JONSWAP,
         .help = "of the wind sea. `pierson-moskowitz` is fully developed whatever the fetch; `tma` needs `depth`"),
    FLAG(wind_sea, .key = "wind.sea", .fallback = 1, .otherwise = "`true`, `false` with `systems` or two peaks",
         .help = "the wind raises a wind sea; `false`: it only roughens the waves that are given"),
    TEXT(spectrum_path, .key = "spectrum.file", .rules = BOLAN_PARAM_PATH,
         .help = "a measured spectrum ([formats](formats.md)) in place of the "
                 "wind sea; relative to "
                 "the scene file. `builtin:synthetic-bimodal` is the shipped one"),
};
#undef STRUCT
const bolan_param_table bolan_scene_params = TABLE("bolan_scene", scene_rows);
const bolan_param_table bolan_wind_sea_params = TABLE("bolan_scene", wind_sea_rows);

#define AT(member, map, rows) \
    { .field = #member, .key = (map), .offset = offsetof(bolan_scene, member), .table = &(rows) }
#define LIST(member, inner, count, map, rows, what)                                                               \
    {                                                                                                             \
        .field = #member, .help = (what), .key = (map), .offset = offsetof(bolan_scene, inner), .table = &(rows), \
        .capacity = sizeof(((bolan_scene *)NULL)->member) / sizeof(((bolan_scene *)NULL)->member[0]),             \
        .stride = sizeof(((bolan_scene *)NULL)->member[0]), .count_offset = offsetof(bolan_scene, count)          \
    }
const bolan_param_group bolan_scene_groups[] = {
    {.field = "", .key = "", .table = &bolan_scene_params},
    AT(technique, "", bolan_technique_params),
    AT(look, "look", bolan_look_params),
    AT(sea.sea_state, "sea", bolan_sea_state_params),
    {.field = "", .key = "sea", .table = &bolan_wind_sea_params},
    AT(spectrum, "sea.spectrum", bolan_spectrum_options_params),
    AT(sea, "sea", bolan_sea_params),
    LIST(trains, trains[0], train_count, "trains", bolan_wave_train_params,
         "wave trains that are added to the waves of the sea: parallel waves of one length inside an area"),
    AT(water, "water", bolan_seawater_params),
    AT(sky, "sky", bolan_sky_params),
    AT(terrain, "terrain", bolan_ground_source_params),
    AT(terrain.generator, "terrain.island", bolan_ground_generator_params),
    AT(terrain.raster, "terrain.raster", bolan_raster_params),
    LIST(objects, objects[0], object_count, "objects", bolan_object_params,
         "things that stand in the scene or float on its water"),
    AT(camera, "camera", bolan_camera_params),
    LIST(camera_keys, camera_keys[0], camera_key_count, "camera.path", bolan_camera_key_params,
         "where the camera is at times that grow: `{time, position, heading, pitch, roll, fov}`. What a key leaves out "
         "is as in the "
         "key before. Between keys it moves smoothly and never beyond them; films and numbered images follow it, and "
         "`--camera` "
         "puts it aside"),
    LIST(camera_keys, camera_keys[0].camera, camera_key_count, "camera.path", bolan_camera_params, NULL),
    {.table = NULL},
};

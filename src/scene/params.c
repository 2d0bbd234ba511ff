// SPDX-License-Identifier: MIT
// The parameters of a scene, and which maps of a scene file they stand in.
#include "bolan/scene.h"
#include "params/rows.h"

static const char *const nodata_names[] = {"fill", "sea", NULL};                      // bolan_raster_nodata, from 1
static const char *const zero_names[] = {"land", "sea", NULL};                        // bolan_raster_zero, from 1
static const char *const up_names[] = {"y", "z", NULL};                               // bolan_up
static const char *const ground_names[] = {"none", "island", "raster", "pond", NULL}; // bolan_ground_kind

// ---- technique and look ---------------------------------------------------------------------------------------------

#define STRUCT bolan_technique
static const bolan_param technique_rows[] = {
    NAME(waves, .names = bolan_wave_model_names, .high = BOLAN_WAVE_MODELS - 1, .help = "its wave model"),
    NAME(surface, .option = "surface", .names = bolan_surface_kind_names, .high = BOLAN_SURFACE_KINDS - 1,
         .help = "the geometry of the technique"),
    NAME(optics, .option = "optics", .names = bolan_optics_kind_names, .high = BOLAN_OPTICS_KINDS - 1,
         .help = "the shading of the technique"),
};
#undef STRUCT
const bolan_param_table bolan_technique_params = TABLE("bolan_technique", technique_rows);

#define STRUCT bolan_look
static const bolan_param look_rows[] = {
    FLAG(paper, .key = "paper", .option = "paper",
         .help = "follow the technique's paper to the letter, also where we know better"),
    SET(effects, .key = "effects", .option = "effects", .names = bolan_effect_names, .high = BOLAN_EFFECTS_ALL,
        .fallback = BOLAN_EFFECTS_ALL, .help = "only these parts of the light"),
    NAME(show, .key = "show", .option = "show", .names = bolan_show_names, .high = BOLAN_SHOWS - 1,
         .help = "the water, its parts in false colours, or the edges of its triangles"),
    NUMBER(distortion, .key = "distortion", .low = 0, .high = 4, .fallback = 1,
           .help = "how far waves shift reflections and refractions"),
    NUMBER(blend, .key = "blend", .low = 0, .high = 1, .fallback = 0.85,
           .help = "share of reflection and refraction over the water's own texture"),
    NUMBER(ambient, .key = "ambient", .low = 0, .high = 2, .fallback = 1, .help = "strength of ambient light"),
    NUMBER(diffuse, .key = "diffuse", .low = 0, .high = 2, .fallback = 0.05, .help = "strength of diffuse light"),
    NUMBER(specular, .key = "specular", .low = 0, .high = 4, .fallback = 1, .help = "strength of specular light"),
    NUMBER(shininess, .key = "shininess", .low = 1, .high = 4096, .fallback = 300,
           .help = "exponent of the highlight; larger: smaller and sharper"),
};
#undef STRUCT
const bolan_param_table bolan_look_params = TABLE("bolan_look", look_rows);

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

// ---- ground and objects ---------------------------------------------------------------------------------------------

#define STRUCT bolan_ground_source
static const bolan_param ground_source_rows[] = {
    NAME(kind, .names = ground_names, .high = BOLAN_GROUND_POND, .help = "where the ground comes from"),
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
    NAME(wind_spectrum, .key = "spectrum.shape", .names = bolan_spectrum_kind_names, .high = BOLAN_SPECTRUM_KINDS - 1,
         .fallback = BOLAN_SPECTRUM_JONSWAP,
         .help = "of the wind sea. `pierson-moskowitz` is fully developed whatever the fetch; `tma` needs `depth`"),
    TEXT(spectrum_path, .key = "spectrum.file", .rules = BOLAN_PARAM_PATH,
         .help = "a measured spectrum (SWAN, WAVEWATCH III, NDBC; see [sea states](sea-states.md)) in place of the "
                 "wind sea; relative to "
                 "the scene file. `builtin:synthetic-bimodal` is the shipped one"),
};
#undef STRUCT
const bolan_param_table bolan_scene_params = TABLE("bolan_scene", scene_rows);
const bolan_param_table bolan_wind_sea_params = TABLE("bolan_scene", wind_sea_rows);

#define AT(member, map, rows) \
    { .field = #member, .key = (map), .offset = offsetof(bolan_scene, member), .table = &(rows) }
#define LIST(member, inner, count, map, rows)                                                            \
    {                                                                                                    \
        .field = #member, .key = (map), .offset = offsetof(bolan_scene, inner), .table = &(rows),        \
        .capacity = sizeof(((bolan_scene *)NULL)->member) / sizeof(((bolan_scene *)NULL)->member[0]),    \
        .stride = sizeof(((bolan_scene *)NULL)->member[0]), .count_offset = offsetof(bolan_scene, count) \
    }
const bolan_param_group bolan_scene_groups[] = {
    {.field = "", .key = "", .table = &bolan_scene_params},
    AT(technique, "", bolan_technique_params),
    AT(look, "look", bolan_look_params),
    AT(sea.sea_state, "sea", bolan_sea_state_params),
    {.field = "", .key = "sea", .table = &bolan_wind_sea_params},
    AT(spectrum, "sea.spectrum", bolan_spectrum_options_params),
    AT(sea, "sea", bolan_sea_params),
    AT(water, "water", bolan_seawater_params),
    AT(sky, "sky", bolan_sky_params),
    AT(terrain, "terrain", bolan_ground_source_params),
    AT(terrain.island, "terrain.island", bolan_island_params),
    AT(terrain.raster, "terrain.raster", bolan_raster_params),
    LIST(objects, objects[0], object_count, "objects", bolan_object_params),
    AT(camera, "camera", bolan_camera_params),
    LIST(camera_keys, camera_keys[0], camera_key_count, "camera.path", bolan_camera_key_params),
    LIST(camera_keys, camera_keys[0].camera, camera_key_count, "camera.path", bolan_camera_params),
    {.table = NULL},
};

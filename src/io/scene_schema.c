// SPDX-License-Identifier: MIT
// The keys of a scene file, with their ranges. docs/scenes.md describes each for people.
#include "io/scene_file.h"

// clang-format off
#define SIZE_OF(key) sizeof(((STRUCT *)0)->key)
#define KEY(key, ...) {.name = #key, .offset = offsetof(STRUCT, key), __VA_ARGS__}
#define NUMBER(key, from, to, in) KEY(key, .kind = SCHEMA_NUMBER, .low = (from), .high = (to), .unit = (in))
#define COUNT(key, from, to)      KEY(key, .kind = SCHEMA_COUNT, .low = (from), .high = (to))
#define NAME(key, list)           KEY(key, .kind = SCHEMA_NAME, .names = (list))
#define FLAG(key)                 KEY(key, .kind = SCHEMA_FLAG)
#define SET(key, list)            KEY(key, .kind = SCHEMA_SET, .names = (list))
#define TEXT(key)                 KEY(key, .kind = SCHEMA_TEXT, .capacity = SIZE_OF(key))
#define VECTOR(key, from, to, in) KEY(key, .kind = SCHEMA_VECTOR, .low = (from), .high = (to), .unit = (in), \
                                      .capacity = SIZE_OF(key) / sizeof(double))
#define MAP(key, table)           KEY(key, .kind = SCHEMA_MAP, .keys = (table))
#define LIST(key, count, table)   KEY(key, .kind = SCHEMA_LIST, .keys = (table), .stride = SIZE_OF(key[0]), \
                                      .capacity = SIZE_OF(key) / SIZE_OF(key[0]), \
                                      .count_offset = offsetof(STRUCT, count))
#define END {.name = NULL}
// clang-format on

#define SEED_MAX 0x1p64 // any of 64 bits

static const char *const technique_names[] = {"ocean",       "two-triangle", "exp-cosine",
                                              "nested-grid", "flight-sim",   NULL}; // order of bolan_techniques()
static const char *const water_names[] = {"I",  "IA", "IB", "II", "III", "1C",
                                          "3C", "5C", "7C", "9C", NULL}; // bolan_jerlov

static const char *const split_names[] = {"equal-energy", "equal-width", NULL}; // bolan_frequency_split

static const char *const nodata_names[] = {"fill", "sea", NULL}; // bolan_raster_nodata, from 1
static const char *const zero_names[] = {"land", "sea", NULL};   // bolan_raster_zero, from 1
static const char *const up_names[] = {"y", "z", NULL};          // bolan_up

// Offsets of an inner map count from the start of that map: STRUCT is its type.

#define STRUCT struct scene_file_wind
static const schema_key wind_keys[] = {
    NUMBER(speed, 0, 70, "m/s"),
    NUMBER(from, -360, 360, "degrees"),
    END,
};
#undef STRUCT

#define STRUCT struct scene_file_spectrum
static const schema_key spectrum_keys[] = {
    NAME(shape, bolan_spectrum_kind_names),
    TEXT(file),
    TEXT(record),
    TEXT(location),
    NUMBER(from, -360, 360, "degrees"),
    NUMBER(spread, 0, 200, NULL),
    END,
};
#undef STRUCT

#define STRUCT struct scene_file_swell
static const schema_key swell_keys[] = {
    NUMBER(hs, 0, 40, "m"),
    NUMBER(tp, 1, 60, "s"),
    NUMBER(from, -360, 360, "degrees"),
    NUMBER(spread, 0, 200, NULL),
    END,
};
#undef STRUCT

#define STRUCT struct scene_file_sea
static const schema_key sea_keys[] = {
    MAP(wind, wind_keys),
    NUMBER(fetch_km, 0.1, 1e4, "km"),
    NUMBER(beaufort, 0, 12, NULL),
    NUMBER(douglas, 0, 9, NULL),
    LIST(swell, swell_count, swell_keys),
    MAP(spectrum, spectrum_keys),
    NUMBER(depth, 0.1, BOLAN_DEEP, "m"),
    COUNT(seed, 0, SEED_MAX),
    COUNT(resolution, 32, 1024),
    COUNT(cascades, 1, BOLAN_MAX_CASCADES),
    NUMBER(length, 10, 1e5, "m"),
    NUMBER(choppiness, 0, 2, NULL),
    NUMBER(loop, 10, 1e6, "s"),
    NUMBER(foam_decay, 0.1, 60, "s"),
    COUNT(frequencies, 1, BOLAN_MAX_FREQUENCIES),
    COUNT(directions, 1, BOLAN_MAX_DIRECTIONS),
    NAME(split, split_names),
    COUNT(waves, 1, BOLAN_MAX_EXP_WAVES),
    NUMBER(sharpness, 0.01, 2, NULL),
    NUMBER(texture_loop, 1, 1e6, "s"),
    COUNT(loop_frames, 2, BOLAN_MAX_LOOP_FRAMES),
    END,
};
#undef STRUCT

#define STRUCT struct scene_file_look
static const schema_key look_keys[] = {
    FLAG(paper),
    SET(effects, bolan_effect_names),
    NAME(show, bolan_show_names),
    NUMBER(distortion, 0, 4, NULL),
    NUMBER(blend, 0, 1, NULL),
    NUMBER(ambient, 0, 2, NULL),
    NUMBER(diffuse, 0, 2, NULL),
    NUMBER(specular, 0, 4, NULL),
    NUMBER(shininess, 1, 4096, NULL),
    END,
};
#undef STRUCT

#define STRUCT struct scene_file_water
static const schema_key water_keys[] = {
    NAME(type, water_names),
    NUMBER(level, -20, 20, "m"),
    NUMBER(foam, 0, 2, NULL),
    END,
};
#undef STRUCT

#define STRUCT struct scene_file_sun
static const schema_key sun_keys[] = {
    NUMBER(azimuth, -360, 360, "degrees"),
    NUMBER(elevation, -90, 90, "degrees"),
    TEXT(date),
    VECTOR(place, -360, 360, "degrees"),
    END,
};
#undef STRUCT

#define STRUCT struct scene_file_clouds
static const schema_key clouds_keys[] = {
    NUMBER(cover, 0, 1, NULL),
    NUMBER(base, 100, 12000, "m"),
    COUNT(seed, 0, SEED_MAX),
    END,
};
#undef STRUCT

#define STRUCT struct scene_file_sky
static const schema_key sky_keys[] = {
    MAP(sun, sun_keys),
    NUMBER(visibility_km, 0.5, 300, "km"),
    MAP(clouds, clouds_keys),
    END,
};
#undef STRUCT

#define STRUCT struct scene_file_island
static const schema_key island_keys[] = {
    COUNT(seed, 0, SEED_MAX),
    NUMBER(radius, 200, 20000, "m"),
    NUMBER(peak, 10, 3000, "m"),
    NUMBER(sea_floor, -11000, -20, "m"),
    NUMBER(lagoon_from, -360, 360, "degrees"),
    END,
};
#undef STRUCT

#define STRUCT struct scene_file_raster
static const schema_key raster_keys[] = {
    TEXT(file),
    VECTOR(at, -360, 360, "degrees"),
    NUMBER(radius_km, 0.1, 5000, "km"),
    NUMBER(vertical_scale, -1e3, 1e3, NULL),
    TEXT(variable),
    COUNT(band, 1, 65535),
    TEXT(crs),
    NAME(nodata, nodata_names),
    NUMBER(nodata_value, -1e39, 1e39, NULL),
    NAME(zero_is, zero_names),
    END,
};
#undef STRUCT

#define STRUCT struct scene_file_pond
static const schema_key pond_keys[] = {END};
#undef STRUCT

#define STRUCT struct scene_file_terrain
static const schema_key terrain_keys[] = {
    MAP(island, island_keys),
    MAP(raster, raster_keys),
    MAP(pond, pond_keys),
    END,
};
#undef STRUCT

#define STRUCT struct scene_file_object
static const schema_key object_keys[] = {
    TEXT(model),
    VECTOR(position, -1e7, 1e7, "m"),
    NUMBER(heading, -360, 360, "degrees"),
    NUMBER(scale, 1e-3, 1e3, NULL),
    FLAG(floats),
    NAME(up, up_names),
    VECTOR(offset, -1e8, 1e8, NULL),
    END,
};
#undef STRUCT

#define STRUCT struct scene_file_key
static const schema_key path_keys[] = {
    NUMBER(time, -1e9, 1e9, "s"),
    VECTOR(position, -1e7, 1e7, "m"),
    NUMBER(heading, -360, 360, "degrees"),
    NUMBER(pitch, -90, 90, "degrees"),
    NUMBER(roll, -180, 180, "degrees"),
    NUMBER(fov, 1, 150, "degrees"),
    END,
};
#undef STRUCT

#define STRUCT struct scene_file_camera
static const schema_key camera_keys[] = {
    VECTOR(position, -1e7, 1e7, "m"),
    NUMBER(heading, -360, 360, "degrees"),
    NUMBER(pitch, -90, 90, "degrees"),
    NUMBER(roll, -180, 180, "degrees"),
    NUMBER(fov, 1, 150, "degrees"),
    LIST(path, path_count, path_keys),
    END,
};
#undef STRUCT

#define STRUCT scene_file
const schema_key bolan_scene_file_keys[] = {
    TEXT(description),
    NAME(technique, technique_names),
    MAP(look, look_keys),
    MAP(sea, sea_keys),
    MAP(water, water_keys),
    MAP(sky, sky_keys),
    MAP(terrain, terrain_keys),
    TEXT(tiles),
    LIST(objects, object_count, object_keys),
    MAP(camera, camera_keys),
    NUMBER(time, -1e9, 1e9, "s"),
    NUMBER(exposure, -10, 10, "stops"),
    END,
};

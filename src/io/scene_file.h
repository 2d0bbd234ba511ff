// SPDX-License-Identifier: MIT
/// @file scene_file.h
/// A scene as it is written in YAML: one member a key, in the units of the file. Private to src/io.
#ifndef BOLAN_IO_SCENE_FILE_H
#define BOLAN_IO_SCENE_FILE_H

#include "io/schema.h"

#include "bolan/scene.h"

/// A number that the file does not give is NAN, a name -1, a text "", a map's line 0. Seeds and counts start as in the
/// default scene.
typedef struct scene_file {
    uint32_t line; ///< every map begins with its line: see schema.h
    int technique;
    char description[256];
    char tiles[BOLAN_PATH_MAX];
    double time, exposure;
    struct scene_file_sea {
        uint32_t line;
        struct scene_file_wind {
            uint32_t line;
            double speed, from;
        } wind;
        double fetch_km, beaufort, douglas, depth, length, choppiness, loop, foam_decay;
        double sharpness, texture_loop;
        uint64_t seed, resolution, cascades, frequencies, directions, waves, loop_frames;
        int split;
        struct scene_file_spectrum {
            uint32_t line;
            int shape;
            char file[BOLAN_PATH_MAX];
            char record[32], location[64];
            double from, spread;
        } spectrum;
        uint32_t swell_count;
        struct scene_file_swell {
            uint32_t line;
            double hs, tp, from, spread;
        } swell[BOLAN_MAX_WAVE_SYSTEMS - 1]; // beside the wind sea
    } sea;
    struct scene_file_look {
        uint32_t line;
        bool paper;
        uint32_t effects;
        int show;
        double distortion, blend, ambient, diffuse, specular, shininess;
    } look;
    struct scene_file_water {
        uint32_t line;
        int type;
        double level, foam;
    } water;
    struct scene_file_sky {
        uint32_t line;
        struct scene_file_sun {
            uint32_t line;
            double azimuth, elevation, place[2];
            char date[32];
        } sun;
        double visibility_km;
        struct scene_file_clouds {
            uint32_t line;
            double cover, base;
            uint64_t seed;
        } clouds;
    } sky;
    struct scene_file_terrain {
        uint32_t line;
        struct scene_file_island {
            uint32_t line;
            double radius, peak, sea_floor, lagoon_from;
            uint64_t seed;
        } island;
        struct scene_file_raster {
            uint32_t line;
            char file[BOLAN_PATH_MAX];
            double at[2], radius_km, vertical_scale, nodata_value;
            char variable[BOLAN_NAME_MAX], crs[BOLAN_CRS_MAX];
            uint64_t band;
            int nodata, zero_is;
        } raster;
        struct scene_file_pond {
            uint32_t line;
        } pond;
    } terrain;
    uint32_t object_count;
    struct scene_file_object {
        uint32_t line;
        bool floats;
        char model[256];
        double position[3], heading, scale, offset[3];
        int up;
    } objects[BOLAN_MAX_OBJECTS];
    struct scene_file_camera {
        uint32_t line;
        double position[3], heading, pitch, roll, fov;
        uint32_t path_count;
        struct scene_file_key {
            uint32_t line;
            double time, position[3], heading, pitch, roll, fov;
        } path[BOLAN_MAX_CAMERA_KEYS];
    } camera;
} scene_file;

extern const schema_key bolan_scene_file_keys[];

/// Every key absent.
void bolan_scene_file_clear(scene_file *file);
/// Builds the scene; @p name is used in messages about keys that exclude or need each other. FORMAT.
bolan_result bolan_scene_file_build(const scene_file *file, const char *name, bolan_scene *scene);
/// Takes the paths of the models from the folder of the scene file @p name, and looks whether the files are there.
/// FORMAT, with the line of the object.
bolan_result bolan_scene_file_find_models(const scene_file *file, const char *name, bolan_scene *scene);
/// "2026-06-21T18:00:00Z" (or +HH:MM instead of Z; seconds may be left out) as seconds since 1970 UTC; false if it is
/// not one.
bool bolan_scene_file_date(const char *text, double *unix_time);

#endif

// SPDX-License-Identifier: MIT
/// @file scene_file.h
/// The contents of a scene file that are no field of a scene, and their effect on the scene. Private to src/io.
#ifndef BOLAN_IO_SCENE_FILE_H
#define BOLAN_IO_SCENE_FILE_H

#include "io/schema.h"

#include "bolan/scene.h"

/// The most swells of a scene: one wave system is the wind sea.
#define SCENE_MAX_SWELLS (BOLAN_MAX_WAVE_SYSTEMS - 1)

/// The keys of bolan_scene_file_groups. schema_given states which keys the file has.
typedef struct scene_file {
    int technique;                 ///< index in bolan_techniques()
    double beaufort;               ///< a wind force instead of a wind speed
    uint32_t douglas;              ///< a Douglas degree instead of a wind speed
    char record[32], location[64]; ///< which record and location of the spectrum file
    char date[32];                 ///< of the sun
    double latitude, longitude;    ///< of the observer of the sun [deg]
    struct scene_file_peaks {
        double hs, tp, from; ///< [m], [s], [deg] NAN: as the wind
        uint32_t member;
    } ochi_hubble, torsethaugen; ///< two-peak families
    uint32_t system_count;
    struct scene_file_system {
        bolan_wave_system system;
        double tp; ///< [s]
    } systems[BOLAN_MAX_WAVE_SYSTEMS];
    uint32_t swell_count;
    struct scene_file_swell {
        double hs, tp, from, spread; ///< [m], [s], [deg] NAN: as the wind, exponent of cos-2s
    } swell[SCENE_MAX_SWELLS];
} scene_file;

/// Makes the scene consistent once its fields and @p file are read: wind sea and swells, sun, ground, camera path.
/// @p name is used in messages about keys that exclude or need each other. FORMAT, with the line.
bolan_result bolan_scene_file_finish(const scene_file *file, const schema_given *given, const char *name,
                                     bolan_scene *scene);
/// Resolves the paths of the models from the folder of the scene file @p name, and checks that the files exist.
/// FORMAT, with the line of the object.
bolan_result bolan_scene_file_find_models(const schema_given *given, const char *name, bolan_scene *scene);
/// "2026-06-21T18:00:00Z" (or +HH:MM in the place of Z; seconds may be left out) as seconds since 1970 UTC; false if it
/// is no such date.
bool bolan_scene_file_date(const char *text, double *unix_time);

#endif

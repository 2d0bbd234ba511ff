// SPDX-License-Identifier: MIT
// The keys of scene files that are no field of a scene.
#include "io/scene_file.h"
#include "params/rows.h"
#include "spectrum/measured.h"

#include "bolan/io.h"

#define STRUCT scene_file
static const bolan_param document_rows[] = {
    NAME(technique, .key = "technique", .option = "technique", .names = bolan_technique_names,
         .high = BOLAN_TECHNIQUES - 1, .help = "the way to make water"),
};
static const bolan_param sea_rows[] = {
    NUMBER(beaufort, .key = "beaufort", .option = "beaufort", .high = 12, .otherwise = "",
           .help = "in the place of the wind speed: the fully developed sea of that force"),
    WHOLE(douglas, .key = "douglas", .option = "sea-state", .high = 9, .otherwise = "",
          .help = "in the place of the wind speed: the fully developed sea of that Douglas degree (WMO 3700)"),
    TEXT(record, .key = "spectrum.record", .option = "record", .otherwise = "0",
         .help = "which record in time of the spectrum file, 0 the earliest; or a date such as `2018-01-01T06:00` "
                 "(UTC): the "
                 "nearest within an hour"),
    TEXT(location, .key = "spectrum.location", .option = "location", .otherwise = "the first",
         .help = "which location of the spectrum file, from 1; or `LON,LAT`, as in `174.67,-38.17`: the nearest"),
};
static const bolan_param peaks_rows[] = {
    NUMBER(ochi_hubble.hs, .key = "ochi_hubble.hs", .high = SPECTRUM_MAX_HS, .unit = "m", .otherwise = "",
           .help = "height of a sea of two peaks, in place of the wind sea: Ochi & Hubble's family"),
    WHOLE(ochi_hubble.member, .key = "ochi_hubble.member", .high = BOLAN_OCHI_HUBBLE_MEMBERS - 1,
          .help = "member of that family; 0 the most probable, 1 to 10 the bounds of 95 %"),
    HEADING(ochi_hubble.from, .key = "ochi_hubble.from", .otherwise = "the wind's",
            .help = "where it comes from, compass degrees"),
    NUMBER(torsethaugen.hs, .key = "torsethaugen.hs", .high = SPECTRUM_MAX_HS, .unit = "m", .otherwise = "",
           .help = "height of a sea of two peaks, in place of the wind sea: Torsethaugen's"),
    NUMBER(torsethaugen.tp, .key = "torsethaugen.tp", .low = 1, .high = 60, .unit = "s", .otherwise = "must be given",
           .help = "period of its higher peak"),
    HEADING(torsethaugen.from, .key = "torsethaugen.from", .otherwise = "the wind's",
            .help = "where it comes from, compass degrees"),
};
static const bolan_param sun_rows[] = {
    TEXT(date, .key = "date", .otherwise = "",
         .help = "in the place of the angles, with `place`: `\"2026-06-21T18:00:00Z\"`, or `+02:00` for `Z`"),
    NUMBER(latitude, .key = "place", .low = -90, .high = 90, .unit = "degrees", .otherwise = "",
           .help = "latitude and longitude of the observer; the sun is within 0.02 degrees"),
    NUMBER(longitude, .key = "place", .low = -360, .high = 360, .unit = "degrees"),
};
#undef STRUCT

#define STRUCT struct scene_file_system
static const bolan_param system_rows[] = {
    NUMBER(tp, .key = "tp", .low = 0.2, .high = 60, .unit = "s", .rules = BOLAN_PARAM_REQUIRED, .help = "peak period"),
};
#undef STRUCT

#define STRUCT struct scene_file_swell
static const bolan_param swell_rows[] = {
    NUMBER(hs, .key = "hs", .high = SPECTRUM_MAX_HS, .unit = "m", .rules = BOLAN_PARAM_REQUIRED, .label = "height",
           .usual_low = 0.1, .usual_high = 10, .digits = 1, .help = "height"),
    NUMBER(tp, .key = "tp", .low = 1, .high = 60, .unit = "s", .rules = BOLAN_PARAM_REQUIRED, .label = "period",
           .usual_low = 5, .usual_high = 25, .digits = 1, .help = "peak period"),
    HEADING(from, .key = "from", .rules = BOLAN_PARAM_OR_NAN, .fallback = (double)NAN, .otherwise = "the wind's",
            .usual_high = 360, .help = "where it comes from, compass degrees"),
    NUMBER(spread, .key = "spread", .high = 200, .fallback = 30, .label = "narrowness", .usual_low = 5,
           .usual_high = 100, .help = "exponent of cos-2s; larger: longer crests"),
};
#undef STRUCT

static const bolan_param_table document_table = TABLE("scene file", document_rows);
static const bolan_param_table sea_table = TABLE("scene file", sea_rows);
static const bolan_param_table peaks_table = TABLE("scene file", peaks_rows);
static const bolan_param_table system_table = TABLE("wave system", system_rows);
static const bolan_param_table sun_table = TABLE("scene file", sun_rows);
static const bolan_param_table swell_table = TABLE("swell", swell_rows);
static const bolan_param_table no_keys = {"pond", document_rows, 0};

const bolan_param_group bolan_scene_file_groups[] = {
    {.field = "", .key = "", .table = &document_table},
    {.field = "", .key = "sea", .table = &sea_table},
    {.field = "", .key = "sea", .table = &peaks_table},
    {.field = "systems",
     .help = "wind seas and swells, in place of the wind sea",
     .key = "sea.systems",
     .table = &bolan_wave_system_params,
     .offset = offsetof(scene_file, systems[0].system),
     .capacity = BOLAN_MAX_WAVE_SYSTEMS,
     .stride = sizeof(struct scene_file_system),
     .count_offset = offsetof(scene_file, system_count)},
    {.field = "systems",
     .key = "sea.systems",
     .table = &system_table,
     .offset = offsetof(scene_file, systems),
     .capacity = BOLAN_MAX_WAVE_SYSTEMS,
     .stride = sizeof(struct scene_file_system),
     .count_offset = offsetof(scene_file, system_count)},
    {.field = "swell",
     .help = "waves from elsewhere",
     .key = "sea.swell",
     .table = &swell_table,
     .offset = offsetof(scene_file, swell),
     .capacity = SCENE_MAX_SWELLS,
     .stride = sizeof(struct scene_file_swell),
     .count_offset = offsetof(scene_file, swell_count)},
    {.field = "", .key = "sky.sun", .table = &sun_table},
    {.field = "",
     .help = "a basin 90 m across in a meadow, whose ground is drawn as the model `builtin:pond-ground`",
     .key = "terrain.pond",
     .table = &no_keys},
    {.table = NULL},
};

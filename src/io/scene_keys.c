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
static const bolan_param sun_rows[] = {
    TEXT(date, .key = "date", .otherwise = "",
         .help = "in the place of the angles, with `place`: `\"2026-06-21T18:00:00Z\"`, or `+02:00` for `Z`"),
    NUMBER(latitude, .key = "place", .low = -90, .high = 90, .unit = "degrees", .otherwise = "",
           .help = "latitude and longitude of the observer; the sun is within 0.02 degrees"),
    NUMBER(longitude, .key = "place", .low = -360, .high = 360, .unit = "degrees"),
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
static const bolan_param_table sun_table = TABLE("scene file", sun_rows);
static const bolan_param_table swell_table = TABLE("swell", swell_rows);
static const bolan_param_table no_keys = {"pond", document_rows, 0};

const bolan_param_group bolan_scene_file_groups[] = {
    {.field = "", .key = "", .table = &document_table},
    {.field = "", .key = "sea", .table = &sea_table},
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

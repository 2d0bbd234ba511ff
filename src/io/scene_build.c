// SPDX-License-Identifier: MIT
// From a scene as it is written to a scene as it is used: defaults, units, and keys that exclude or need each other.
#include "bolan/content.h"

#include "io/file.h"
#include "io/scene_file.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

void bolan_scene_file_clear(scene_file *file) {
    const double absent = (double)NAN;
    const bolan_scene d = bolan_scene_default();
    memset(file, 0, sizeof *file);
    file->technique = file->sea.spectrum.shape = file->water.type = file->sea.split = file->look.show = -1;
    double *const numbers[] = {
        &file->time,
        &file->exposure,
        &file->sea.wind.speed,
        &file->sea.wind.from,
        &file->sea.spectrum.from,
        &file->sea.spectrum.spread,
        &file->sea.fetch_km,
        &file->sea.beaufort,
        &file->sea.douglas,
        &file->sea.depth,
        &file->sea.length,
        &file->sea.choppiness,
        &file->sea.loop,
        &file->sea.foam_decay,
        &file->sea.sharpness,
        &file->sea.texture_loop,
        &file->look.distortion,
        &file->look.blend,
        &file->look.ambient,
        &file->look.diffuse,
        &file->look.specular,
        &file->look.shininess,
        &file->water.level,
        &file->water.foam,
        &file->sky.sun.azimuth,
        &file->sky.sun.elevation,
        &file->sky.sun.place[0],
        &file->sky.sun.place[1],
        &file->sky.visibility_km,
        &file->sky.clouds.cover,
        &file->sky.clouds.base,
        &file->terrain.island.radius,
        &file->terrain.island.peak,
        &file->terrain.island.sea_floor,
        &file->terrain.island.lagoon_from,
        &file->terrain.raster.at[0],
        &file->terrain.raster.at[1],
        &file->terrain.raster.radius_km,
        &file->terrain.raster.vertical_scale,
        &file->terrain.raster.nodata_value,
        &file->camera.position[0],
        &file->camera.position[1],
        &file->camera.position[2],
        &file->camera.heading,
        &file->camera.pitch,
        &file->camera.roll,
        &file->camera.fov,
    };
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) *numbers[i] = absent;
    for (int i = 0; i < BOLAN_MAX_WAVE_SYSTEMS - 1; i++)
        file->sea.swell[i] = (struct scene_file_swell){0, absent, absent, absent, absent};
    file->terrain.raster.nodata = file->terrain.raster.zero_is = -1;
    for (int i = 0; i < BOLAN_MAX_OBJECTS; i++) file->objects[i].scale = 1.0, file->objects[i].up = -1;
    for (int i = 0; i < BOLAN_MAX_CAMERA_KEYS; i++)
        file->camera.path[i] =
            (struct scene_file_key){0, absent, {absent, absent, absent}, absent, absent, absent, absent};
    file->look.effects = d.look.effects;
    file->sea.frequencies = d.sea.cosines.frequencies;
    file->sea.directions = d.sea.cosines.directions;
    file->sea.waves = d.sea.exp_cosine.wave_count;
    file->sea.loop_frames = d.sea.textures.frames;
    file->sea.seed = d.sea.seed;
    file->sea.resolution = d.sea.resolution;
    file->sea.cascades = d.sea.fft.cascade_count;
    file->sky.clouds.seed = d.sky.cloud_seed;
    file->terrain.island.seed = d.terrain.generator.seed;
}

static void set(double *value, double given, double factor) {
    if (!isnan(given)) *value = given * factor;
}

static bolan_result refuse(const char *name, uint32_t line, const char *what) {
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_SCENE_BAD_VALUE, "%s:%u: %s", name, (unsigned)line, what);
    return BOLAN_ERROR_FORMAT;
}

// ---- the sea --------------------------------------------------------------------------------------------------------

static bolan_result check_sea(const struct scene_file_sea *sea, const char *name) {
    const int winds = !isnan(sea->wind.speed) + !isnan(sea->beaufort) + !isnan(sea->douglas);
    if (winds > 1)
        return refuse(name, sea->line, "sea has more than one of wind.speed, beaufort and douglas; expected one");
    if (!isnan(sea->douglas) && sea->douglas != floor(sea->douglas))
        return refuse(name, sea->line, "sea.douglas is not a whole number; expected 0 to 9");
    if (!isnan(sea->fetch_km) && (!isnan(sea->beaufort) || !isnan(sea->douglas)))
        return refuse(name, sea->line,
                      "sea.fetch_km does not go with beaufort or douglas, whose seas are fully developed");
    const uint64_t n = sea->resolution;
    if ((n & (n - 1)) != 0)
        return refuse(name, sea->line, "sea.resolution is not a power of two; expected 32, 64, 128, 256, 512 or 1024");
    if (sea->spectrum.shape == BOLAN_SPECTRUM_TMA && isnan(sea->depth))
        return refuse(name, sea->spectrum.line, "sea.spectrum.shape tma needs sea.depth, the depth in metres");
    return BOLAN_OK;
}

static bolan_result add_swells(const struct scene_file_sea *sea, const char *name, bolan_sea_state *state) {
    for (uint32_t i = 0; i < sea->swell_count; i++) {
        const struct scene_file_swell *s = &sea->swell[i];
        if (isnan(s->hs) || isnan(s->tp))
            return refuse(name, s->line, "a swell needs hs, its height in metres, and tp, its period in seconds");
        if (bolan_sea_state_add_swell(state, s->hs, s->tp, isnan(s->from) ? state->wind_from_deg : s->from,
                                      isnan(s->spread) ? 30.0 : s->spread))
            return BOLAN_ERROR_FORMAT;
    }
    return BOLAN_OK;
}

static void set_wind(const struct scene_file_sea *sea, bolan_scene *scene) {
    const bolan_sea_state *old = &scene->sea.sea_state;
    double from = old->wind_from_deg, speed = old->wind_speed;
    set(&from, sea->wind.from, 1.0);
    set(&speed, sea->wind.speed, 1.0);
    if (!isnan(sea->beaufort) || !isnan(sea->douglas)) {
        speed = isnan(sea->beaufort) ? bolan_sea_state_from_douglas((int)sea->douglas, from).wind_speed
                                     : bolan_sea_state_from_beaufort(sea->beaufort, from).wind_speed;
        scene->wind_spectrum = BOLAN_SPECTRUM_PIERSON_MOSKOWITZ;
    }
    if (sea->spectrum.shape >= 0) scene->wind_spectrum = (bolan_spectrum_kind)sea->spectrum.shape;
    bolan_scene_set_wind(scene, speed, from);
}

static bolan_result build_spectrum(const struct scene_file_spectrum *spectrum, const char *name, bolan_scene *scene) {
    bolan_spectrum_options *o = &scene->spectrum;
    snprintf(scene->spectrum_path, sizeof scene->spectrum_path, "%s", spectrum->file);
    const bool any = spectrum->record[0] || spectrum->location[0] || !isnan(spectrum->from) || !isnan(spectrum->spread);
    if (any && !spectrum->file[0])
        return refuse(name, spectrum->line,
                      "sea.spectrum has record, location, from or spread but no file; expected file");
    if (spectrum->record[0] && !bolan_spectrum_options_set_record(o, spectrum->record))
        return refuse(name, spectrum->line,
                      "sea.spectrum.record is neither a whole number from 0 nor a date such as 2018-01-01T06:00");
    if (spectrum->location[0] && !bolan_spectrum_options_set_location(o, spectrum->location))
        return refuse(name, spectrum->line,
                      "sea.spectrum.location is neither a whole number from 1 nor LON,LAT such as 174.67,-38.17");
    set(&o->from_deg, spectrum->from, 1.0);
    set(&o->spread_s, spectrum->spread, 1.0);
    return BOLAN_OK;
}

static bolan_result build_sea(const struct scene_file_sea *sea, const char *name, bolan_scene *scene) {
    if (check_sea(sea, name)) return BOLAN_ERROR_FORMAT;
    bolan_sea_desc *d = &scene->sea;
    if (build_spectrum(&sea->spectrum, name, scene)) return BOLAN_ERROR_FORMAT;
    set(&scene->fetch, sea->fetch_km, 1000.0);
    set(&d->sea_state.depth, sea->depth, 1.0);
    set_wind(sea, scene);
    d->seed = sea->seed;
    d->resolution = (uint32_t)sea->resolution;
    d->fft.cascade_count = (uint32_t)sea->cascades;
    set(&d->length, sea->length, 1.0);
    set(&d->choppiness, sea->choppiness, 1.0);
    set(&d->loop_period, sea->loop, 1.0);
    set(&d->textures.period, sea->texture_loop, 1.0);
    set(&d->foam_decay, sea->foam_decay, 1.0);
    d->cosines.frequencies = (uint32_t)sea->frequencies;
    d->cosines.directions = (uint32_t)sea->directions;
    if (sea->split >= 0) d->cosines.split = (bolan_frequency_split)sea->split;
    d->exp_cosine.wave_count = (uint32_t)sea->waves;
    set(&d->exp_cosine.sharpness, sea->sharpness, 1.0);
    d->textures.frames = (uint32_t)sea->loop_frames;
    return add_swells(sea, name, &d->sea_state);
}

// ---- sky, terrain, camera -------------------------------------------------------------------------------------------

// Days from 1970-01-01 to a date of the Gregorian calendar (Fliegel & Van Flandern, Comm. ACM 11, 1968).
static int days_since_1970(int year, int month, int day) {
    const int a = (month - 14) / 12;
    const int julian = day - 32075 + 1461 * (year + 4800 + a) / 4 + 367 * (month - 2 - a * 12) / 12 -
                       3 * ((year + 4900 + a) / 100) / 4;
    return julian - 2440588;
}

// Exactly @p count digits at *text, which is moved behind them; -1 for anything else: no sign, no blank.
static int digits(const char **text, int count) {
    int value = 0;
    for (int i = 0; i < count; i++, (*text)++) {
        if (**text < '0' || **text > '9') return -1;
        value = value * 10 + (**text - '0');
    }
    return value;
}

// That many digits behind the character @p before.
static int digits_behind(char before, const char **text, int count) {
    return **text == before ? ((*text)++, digits(text, count)) : -1;
}

static int days_of_month(int year, int month) {
    static const int days[12] = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
    const bool leap = (year % 4 == 0 && year % 100 != 0) || year % 400 == 0;
    return month == 2 && leap ? 29 : days[month - 1];
}

// ISO 8601: YYYY-MM-DDTHH:MM, :SS if you like, and Z or +HH:MM or -HH:MM.
bool bolan_scene_file_date(const char *text, double *unix_time) {
    const int year = digits(&text, 4);
    if (year < 1900 || year > 2100) return false;
    const int month = digits_behind('-', &text, 2);
    if (month < 1 || month > 12) return false;
    const int day = digits_behind('-', &text, 2);
    if (day < 1 || day > days_of_month(year, month)) return false;
    const int hour = digits_behind('T', &text, 2);
    if (hour < 0 || hour > 23) return false;
    const int minute = digits_behind(':', &text, 2);
    if (minute < 0 || minute > 59) return false;
    const int second = *text == ':' ? digits_behind(':', &text, 2) : 0;
    if (second < 0 || second > 60) return false; // 60: a leap second
    const char sign = *text;
    int zone_hour = 0, zone_minute = 0;
    if (sign == '+' || sign == '-') {
        zone_hour = digits_behind(sign, &text, 2);
        if (zone_hour < 0 || zone_hour > 14) return false;
        zone_minute = digits_behind(':', &text, 2);
        if (zone_minute < 0 || zone_minute > 59) return false;
    } else if (*text++ != 'Z') {
        return false;
    }
    if (*text) return false;
    const double zone = (zone_hour * 60.0 + zone_minute) * 60.0 * (sign == '-' ? -1.0 : 1.0);
    *unix_time = days_since_1970(year, month, day) * 86400.0 + (hour * 60.0 + minute) * 60.0 + second - zone;
    return true;
}

static bolan_result build_sun(const struct scene_file_sun *sun, const char *name, bolan_sky *sky) {
    const bool dated = sun->date[0] != '\0';
    if (dated != !isnan(sun->place[0]))
        return refuse(name, sun->line, "sky.sun needs date and place [latitude, longitude] together");
    if (dated && (!isnan(sun->azimuth) || !isnan(sun->elevation)))
        return refuse(name, sun->line,
                      "sky.sun has date and angles; expected date and place, or azimuth and elevation");
    if (dated) {
        double unix_time = 0.0;
        if (!bolan_scene_file_date(sun->date, &unix_time))
            return refuse(name, sun->line,
                          "sky.sun.date is no date; expected one like 2026-06-21T18:00:00Z or ...+02:00");
        if (fabs(sun->place[0]) > 90.0)
            return refuse(name, sun->line, "sky.sun.place has a latitude beyond 90; expected [latitude, longitude]");
        bolan_sun_position(unix_time, sun->place[0], sun->place[1], &sky->sun_azimuth_deg, &sky->sun_elevation_deg);
    }
    set(&sky->sun_azimuth_deg, sun->azimuth, 1.0);
    set(&sky->sun_elevation_deg, sun->elevation, 1.0);
    return BOLAN_OK;
}

static bolan_result build_sky(const scene_file *file, const char *name, bolan_sky *sky) {
    set(&sky->visibility, file->sky.visibility_km, 1000.0);
    set(&sky->cloud_cover, file->sky.clouds.cover, 1.0);
    set(&sky->cloud_base, file->sky.clouds.base, 1.0);
    sky->cloud_seed = file->sky.clouds.seed;
    return build_sun(&file->sky.sun, name, sky);
}

static bolan_result build_raster(const struct scene_file_raster *r, const char *name, bolan_raster_desc *out) {
    if (!isnan(r->at[0]) && fabs(r->at[0]) > 90.0)
        return refuse(name, r->line, "terrain.raster.at has a latitude beyond 90; expected [latitude, longitude]");
    if (fabs(r->vertical_scale) < 1e-3)
        return refuse(name, r->line,
                      "terrain.raster.vertical_scale is too small; expected 0.001 to 1000, negative for depths");
    snprintf(out->path, sizeof out->path, "%s", r->file);
    memcpy(out->variable, r->variable, sizeof out->variable);
    memcpy(out->crs, r->crs, sizeof out->crs);
    out->band = (uint32_t)r->band;
    out->latitude = r->at[0];
    out->longitude = r->at[1];
    set(&out->radius, r->radius_km, 1000.0);
    out->vertical_scale = r->vertical_scale;
    out->nodata_value = r->nodata_value;
    out->nodata = (bolan_raster_nodata)(r->nodata + 1); // an absent name is -1: AUTO
    out->zero = (bolan_raster_zero)(r->zero_is + 1);
    return BOLAN_OK;
}

static bolan_result build_terrain(const struct scene_file_terrain *t, const char *name, bolan_ground_source *out) {
    if ((t->island.line != 0) + (t->raster.line != 0) + (t->pond.line != 0) > 1)
        return refuse(name, t->line, "terrain has more than one of island, raster and pond; expected one");
    const char *generator = t->island.line ? "island" : t->pond.line ? "pond" : "";
    out->kind = t->raster.line ? BOLAN_GROUND_RASTER : generator[0] ? BOLAN_GROUND_GENERATED : BOLAN_GROUND_NONE;
    out->shown_by_object = t->pond.line != 0; // as the model builtin:pond-ground
    snprintf(out->generator.name, sizeof out->generator.name, "%s", generator);
    out->generator.seed = t->island.seed;
    set(&out->generator.radius, t->island.radius, 1.0);
    set(&out->generator.peak, t->island.peak, 1.0);
    set(&out->generator.sea_floor, t->island.sea_floor, 1.0);
    set(&out->generator.lagoon_from_deg, t->island.lagoon_from, 1.0);
    return build_raster(&t->raster, name, &out->raster);
}

static void build_camera(const struct scene_file_camera *c, bolan_camera *out) {
    set(&out->position.x, c->position[0], 1.0);
    set(&out->position.y, c->position[1], 1.0);
    set(&out->position.z, c->position[2], 1.0);
    set(&out->heading_deg, c->heading, 1.0);
    set(&out->pitch_deg, c->pitch, 1.0);
    set(&out->roll_deg, c->roll, 1.0);
    set(&out->fov_deg, c->fov, 1.0);
}

// A key has what it says, and the rest from the key before it; the first, from the camera.
static bolan_result build_path(const struct scene_file_camera *c, const char *name, bolan_scene *scene) {
    bolan_camera camera = scene->camera;
    for (uint32_t i = 0; i < c->path_count; i++) {
        const struct scene_file_key *k = &c->path[i];
        if (isnan(k->time)) return refuse(name, k->line, "a key of camera.path needs time, in seconds");
        if (i > 0 && !(k->time > scene->camera_keys[i - 1].time))
            return refuse(name, k->line,
                          "a key of camera.path is not later than the one before; expected times that grow");
        const struct scene_file_camera at = {.position = {k->position[0], k->position[1], k->position[2]},
                                             .heading = k->heading,
                                             .pitch = k->pitch,
                                             .roll = k->roll,
                                             .fov = k->fov};
        build_camera(&at, &camera);
        scene->camera_keys[i] = (bolan_camera_key){k->time, camera};
    }
    scene->camera_key_count = c->path_count;
    if (c->path_count > 0) scene->camera = bolan_scene_camera_at(scene, scene->time);
    return BOLAN_OK;
}

// ---- look and objects -----------------------------------------------------------------------------------------------

static void build_look(const struct scene_file_look *l, bolan_look *out) {
    out->paper = l->paper;
    out->effects = l->effects;
    if (l->show >= 0) out->show = (bolan_show)l->show;
    set(&out->distortion, l->distortion, 1.0);
    set(&out->blend, l->blend, 1.0);
    set(&out->ambient, l->ambient, 1.0);
    set(&out->diffuse, l->diffuse, 1.0);
    set(&out->specular, l->specular, 1.0);
    set(&out->shininess, l->shininess, 1.0);
}

static const char *const builtin = "builtin:";

static bool is_builtin(const char *model) { return strncmp(model, builtin, strlen(builtin)) == 0; }

static bolan_result unknown_model(const char *name, uint32_t line, const char *model) {
    char list[256] = "", sentence[512];
    for (uint32_t i = 0; bolan_content_model_name(i); i++) {
        const size_t used = strlen(list);
        snprintf(list + used, sizeof list - used, "%s%s", i ? ", " : "", bolan_content_model_name(i));
    }
    snprintf(sentence, sizeof sentence, "there is no model %.*s; expected builtin: and one of %s",
             (int)bolan_text_fit(model, 64), model, list);
    return refuse(name, line, sentence);
}

static bolan_result build_object(const struct scene_file_object *o, const char *name, bolan_object *out) {
    if (!o->model[0]) return refuse(name, o->line, "an object needs a model: builtin:NAME, or a file (OBJ, glTF)");
    uint32_t i = 0;
    while (is_builtin(o->model) && bolan_content_model_name(i) &&
           strcmp(bolan_content_model_name(i), o->model + strlen(builtin)) != 0)
        i++;
    if (is_builtin(o->model) && !bolan_content_model_name(i)) return unknown_model(name, o->line, o->model);
    if (is_builtin(o->model) && (o->up >= 0 || o->offset[0] != 0.0 || o->offset[1] != 0.0 || o->offset[2] != 0.0))
        return refuse(name, o->line, "up and offset are of model files; expected neither with a builtin: model");
    memcpy(out->model, o->model, sizeof out->model);
    out->up = o->up == BOLAN_UP_Z ? BOLAN_UP_Z : BOLAN_UP_Y;
    out->offset = bolan_dv3(o->offset[0], o->offset[1], o->offset[2]);
    out->position = bolan_dv3(o->position[0], o->position[1], o->position[2]);
    out->heading_deg = o->heading;
    out->scale = o->scale;
    out->floats = o->floats;
    return BOLAN_OK;
}

static bolan_result build_objects(const scene_file *file, const char *name, bolan_scene *scene) {
    for (uint32_t i = 0; i < file->object_count; i++)
        if (build_object(&file->objects[i], name, &scene->objects[i])) return BOLAN_ERROR_FORMAT;
    scene->object_count = file->object_count;
    return BOLAN_OK;
}

bolan_result bolan_scene_file_find_models(const scene_file *file, const char *name, bolan_scene *scene) {
    for (uint32_t i = 0; i < scene->object_count; i++) {
        bolan_object *o = &scene->objects[i];
        char path[BOLAN_PATH_MAX], sentence[512];
        if (is_builtin(o->model)) continue;
        if (!bolan_file_resolve(name, o->model, path) || strlen(path) >= sizeof o->model)
            return refuse(name, file->objects[i].line, "the path of a model is longer than 255 characters");
        if (access(path, R_OK) != 0) {
            snprintf(sentence, sizeof sentence,
                     "the model %.*s cannot be read; expected a file (OBJ, glTF), or builtin:NAME",
                     (int)bolan_text_fit(path, 300), path);
            return refuse(name, file->objects[i].line, sentence);
        }
        memcpy(o->model, path, strlen(path) + 1);
    }
    return BOLAN_OK;
}

bolan_result bolan_scene_file_build(const scene_file *file, const char *name, bolan_scene *scene) {
    *scene = bolan_scene_default();
    snprintf(scene->description, sizeof scene->description, "%s", file->description);
    snprintf(scene->tiles_path, sizeof scene->tiles_path, "%s", file->tiles);
    if (file->technique >= 0) {
        uint32_t count = 0;
        bolan_scene_set_technique(scene, &bolan_techniques(&count)[file->technique]);
    }
    if (file->water.type >= 0) scene->water.type = (bolan_jerlov)file->water.type;
    set(&scene->water.level, file->water.level, 1.0);
    set(&scene->water.foam, file->water.foam, 1.0);
    set(&scene->time, file->time, 1.0);
    set(&scene->exposure, file->exposure, 1.0);
    build_camera(&file->camera, &scene->camera);
    build_look(&file->look, &scene->look);
    if (build_sea(&file->sea, name, scene) || build_sky(file, name, &scene->sky) ||
        build_terrain(&file->terrain, name, &scene->terrain) || build_objects(file, name, scene) ||
        build_path(&file->camera, name, scene))
        return BOLAN_ERROR_FORMAT;
    return BOLAN_OK;
}

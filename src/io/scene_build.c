// SPDX-License-Identifier: MIT
// From the keys of a scene file to a scene: fields that follow from several keys, and keys that exclude or need each
// other.
#include "bolan/content.h"

#include "io/file.h"
#include "io/scene_file.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

// The data of all functions here.
typedef struct builder {
    const scene_file *file;
    const schema_given *given;
    const char *name;
    bolan_scene *scene;
} builder;

static bool has(const builder *b, const char *path) { return bolan_schema_line(b->given, path) != 0; }

// One sentence with the line of the key @p path.
static bolan_result refuse(const builder *b, const char *path, const char *what) {
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_SCENE_BAD_VALUE, "%s:%u: %s", b->name,
              (unsigned)bolan_schema_line(b->given, path), what);
    return BOLAN_ERROR_FORMAT;
}

// ---- the sea --------------------------------------------------------------------------------------------------------

static bolan_result check_sea(const builder *b) {
    const bool table = has(b, "sea.beaufort") || has(b, "sea.douglas");
    if (has(b, "sea.wind.speed") + has(b, "sea.beaufort") + has(b, "sea.douglas") > 1)
        return refuse(b, "sea", "sea has more than one of wind.speed, beaufort and douglas; expected one");
    if (has(b, "sea.fetch_km") && table)
        return refuse(b, "sea", "sea.fetch_km does not go with beaufort or douglas, whose seas are fully developed");
    if (has(b, "sea.spectrum.shape") && b->scene->wind_spectrum == BOLAN_SPECTRUM_TMA && !has(b, "sea.depth"))
        return refuse(b, "sea.spectrum", "sea.spectrum.shape tma needs sea.depth, the depth in metres");
    return BOLAN_OK;
}

static bolan_result build_spectrum(const builder *b) {
    static const char *const needy[] = {"sea.spectrum.record", "sea.spectrum.location", "sea.spectrum.from",
                                        "sea.spectrum.spread"};
    bolan_spectrum_options *o = &b->scene->spectrum;
    for (int i = 0; i < 4 && !has(b, "sea.spectrum.file"); i++)
        if (has(b, needy[i]))
            return refuse(b, "sea.spectrum",
                          "sea.spectrum has record, location, from or spread but no file; expected file");
    if (has(b, "sea.spectrum.record") && !bolan_spectrum_options_set_record(o, b->file->record))
        return refuse(b, "sea.spectrum",
                      "sea.spectrum.record is neither a whole number from 0 nor a date such as 2018-01-01T06:00");
    if (has(b, "sea.spectrum.location") && !bolan_spectrum_options_set_location(o, b->file->location))
        return refuse(b, "sea.spectrum",
                      "sea.spectrum.location is neither a whole number from 1 nor LON,LAT such as 174.67,-38.17");
    return BOLAN_OK;
}

// The wind sea follows from wind, fetch, depth, spectrum and technique, all of which are read by now.
static void build_wind(const builder *b) {
    const bolan_sea_state *state = &b->scene->sea.sea_state;
    const double from = state->wind_from_deg;
    double speed = state->wind_speed;
    if (has(b, "sea.beaufort")) speed = bolan_sea_state_from_beaufort(b->file->beaufort, from).wind_speed;
    if (has(b, "sea.douglas")) speed = bolan_sea_state_from_douglas((int)b->file->douglas, from).wind_speed;
    if ((has(b, "sea.beaufort") || has(b, "sea.douglas")) && !has(b, "sea.spectrum.shape"))
        b->scene->wind_spectrum = BOLAN_SPECTRUM_PIERSON_MOSKOWITZ;
    bolan_scene_set_wind(b->scene, speed, from);
}

// Where waves come from that say it, or as the wind.
static double from_of(const builder *b, const char *path, double from) {
    return has(b, path) ? from : b->scene->sea.sea_state.wind_from_deg;
}

static bolan_result build_systems(const builder *b) {
    bolan_sea_state *state = &b->scene->sea.sea_state;
    for (uint32_t i = 0; i < b->file->system_count; i++) {
        bolan_wave_system system = b->file->systems[i].system;
        char path[SCHEMA_PATH];
        snprintf(path, sizeof path, "sea.systems[%u].from", (unsigned)i);
        system.peak_omega = 2.0 * BOLAN_PI / b->file->systems[i].tp;
        system.from_deg = from_of(b, path, system.from_deg);
        if (bolan_sea_state_add_system(state, &system)) return BOLAN_ERROR_FORMAT;
    }
    return BOLAN_OK;
}

static bolan_result build_peaks(const builder *b) {
    bolan_sea_state *state = &b->scene->sea.sea_state;
    const struct scene_file_peaks *o = &b->file->ochi_hubble, *t = &b->file->torsethaugen;
    if (has(b, "sea.ochi_hubble") != has(b, "sea.ochi_hubble.hs"))
        return refuse(b, "sea.ochi_hubble", "sea.ochi_hubble needs hs, the height in metres");
    if (has(b, "sea.torsethaugen") != (has(b, "sea.torsethaugen.hs") && has(b, "sea.torsethaugen.tp")))
        return refuse(b, "sea.torsethaugen",
                      "sea.torsethaugen needs hs and tp, the height in metres and the period in "
                      "seconds");
    const bool ochi_hubble = has(b, "sea.ochi_hubble"), torsethaugen = has(b, "sea.torsethaugen");
    if (ochi_hubble &&
        bolan_sea_state_add_ochi_hubble(state, o->hs, o->member, from_of(b, "sea.ochi_hubble.from", o->from)))
        return BOLAN_ERROR_FORMAT;
    if (torsethaugen &&
        bolan_sea_state_add_torsethaugen(state, t->hs, t->tp, from_of(b, "sea.torsethaugen.from", t->from)))
        return BOLAN_ERROR_FORMAT;
    return BOLAN_OK;
}

// Waves that are given stand in place of the wind sea, unless the file has both.
static bolan_result choose_wind_sea(const builder *b) {
    const bool given = b->file->system_count > 0 || has(b, "sea.ochi_hubble") || has(b, "sea.torsethaugen");
    if (given && !has(b, "sea.wind.sea")) b->scene->wind_sea = false;
    if (!b->scene->wind_sea && (has(b, "sea.fetch_km") || has(b, "sea.spectrum.shape")))
        return refuse(b, "sea",
                      "sea.fetch_km and sea.spectrum.shape are of the wind sea, and this sea has none; "
                      "sea.wind.sea: true gives it one beside the waves that are listed");
    return BOLAN_OK;
}

static bolan_result build_sea(const builder *b) {
    bolan_sea_state *state = &b->scene->sea.sea_state;
    if (check_sea(b) || build_spectrum(b) || choose_wind_sea(b)) return BOLAN_ERROR_FORMAT;
    build_wind(b);
    if (!b->scene->wind_sea) state->system_count = 0; // that of the default scene
    if (build_systems(b) || build_peaks(b)) return BOLAN_ERROR_FORMAT;
    for (uint32_t i = 0; i < b->file->swell_count; i++) {
        const struct scene_file_swell *s = &b->file->swell[i];
        const double from = isnan(s->from) ? state->wind_from_deg : s->from;
        if (bolan_sea_state_add_swell(state, s->hs, s->tp, from, s->spread)) return BOLAN_ERROR_FORMAT;
    }
    return BOLAN_OK;
}

// ---- sky, terrain, camera -------------------------------------------------------------------------------------------

static bolan_result build_sun(const builder *b) {
    const bool dated = has(b, "sky.sun.date");
    bolan_sky *sky = &b->scene->sky;
    double unix_time = 0.0;
    if (dated != has(b, "sky.sun.place"))
        return refuse(b, "sky.sun", "sky.sun needs date and place [latitude, longitude] together");
    if (!dated) return BOLAN_OK;
    if (has(b, "sky.sun.azimuth") || has(b, "sky.sun.elevation"))
        return refuse(b, "sky.sun", "sky.sun has date and angles; expected date and place, or azimuth and elevation");
    if (!bolan_scene_file_date(b->file->date, &unix_time))
        return refuse(b, "sky.sun", "sky.sun.date is no date; expected one like 2026-06-21T18:00:00Z or ...+02:00");
    bolan_sun_position(unix_time, b->file->latitude, b->file->longitude, &sky->sun_azimuth_deg,
                       &sky->sun_elevation_deg);
    return BOLAN_OK;
}

static bolan_result build_terrain(const builder *b) {
    const bool island = has(b, "terrain.island"), raster = has(b, "terrain.raster"), pond = has(b, "terrain.pond");
    if (island + raster + pond > 1)
        return refuse(b, "terrain", "terrain has more than one of island, raster and pond; expected one");
    bolan_ground_source *ground = &b->scene->terrain;
    const char *generator = island ? "island" : pond ? "pond" : "";
    ground->kind = raster ? BOLAN_GROUND_RASTER : *generator ? BOLAN_GROUND_GENERATED : BOLAN_GROUND_NONE;
    ground->shown_by_object = pond; // as the model builtin:pond-ground
    snprintf(ground->generator.name, sizeof ground->generator.name, "%s", generator);
    return BOLAN_OK;
}

// Fields that a key of the path leaves out come from the key before it, and for the first key from the camera.
static bolan_result build_path(const builder *b) {
    bolan_scene *scene = b->scene;
    const bolan_camera *before = &scene->camera;
    for (uint32_t i = 0; i < scene->camera_key_count; i++) {
        bolan_camera_key *key = &scene->camera_keys[i];
        char path[SCHEMA_PATH];
        for (uint32_t k = 0; k < bolan_camera_params.count; k++) {
            const bolan_param *p = &bolan_camera_params.params[k];
            snprintf(path, sizeof path, "camera.path[%u].%s", (unsigned)i, p->key);
            if (!has(b, path)) bolan_param_set(p, &key->camera, bolan_param_get(p, before));
        }
        snprintf(path, sizeof path, "camera.path[%u]", (unsigned)i);
        if (i > 0 && !(key->time > key[-1].time))
            return refuse(b, path, "a key of camera.path is not later than the one before; expected times that grow");
        before = &key->camera;
    }
    if (scene->camera_key_count > 0) scene->camera = bolan_scene_camera_at(scene, scene->time);
    return BOLAN_OK;
}

// ---- objects --------------------------------------------------------------------------------------------------------

static const char *const builtin = "builtin:";

static bool is_builtin(const char *model) { return strncmp(model, builtin, strlen(builtin)) == 0; }

static bolan_result unknown_model(const builder *b, const char *path, const char *model) {
    char list[256] = "", sentence[512];
    for (uint32_t i = 0; bolan_content_model_name(i); i++) {
        const size_t used = strlen(list);
        snprintf(list + used, sizeof list - used, "%s%s", i ? ", " : "", bolan_content_model_name(i));
    }
    snprintf(sentence, sizeof sentence, "there is no model %.*s; expected builtin: and one of %s",
             (int)bolan_text_fit(model, 64), model, list);
    return refuse(b, path, sentence);
}

static bolan_result check_object(const builder *b, uint32_t index) {
    const char *model = b->scene->objects[index].model;
    char path[SCHEMA_PATH], up[SCHEMA_PATH], offset[SCHEMA_PATH];
    uint32_t i = 0;
    if (!is_builtin(model)) return BOLAN_OK;
    snprintf(path, sizeof path, "objects[%u]", (unsigned)index);
    snprintf(up, sizeof up, "objects[%u].up", (unsigned)index);
    snprintf(offset, sizeof offset, "objects[%u].offset", (unsigned)index);
    while (bolan_content_model_name(i) && strcmp(bolan_content_model_name(i), model + strlen(builtin)) != 0) i++;
    if (!bolan_content_model_name(i)) return unknown_model(b, path, model);
    if (has(b, up) || has(b, offset))
        return refuse(b, path, "up and offset are of model files; expected neither with a builtin: model");
    return BOLAN_OK;
}

bolan_result bolan_scene_file_find_models(const schema_given *given, const char *name, bolan_scene *scene) {
    const builder b = {.given = given, .name = name};
    for (uint32_t i = 0; i < scene->object_count; i++) {
        bolan_object *o = &scene->objects[i];
        char path[BOLAN_PATH_MAX], sentence[512], at[SCHEMA_PATH];
        if (is_builtin(o->model)) continue;
        snprintf(at, sizeof at, "objects[%u]", (unsigned)i);
        if (!bolan_file_resolve(name, o->model, path) || strlen(path) >= sizeof o->model)
            return refuse(&b, at, "the path of a model is longer than 255 characters");
        if (access(path, R_OK) != 0) {
            snprintf(sentence, sizeof sentence,
                     "the model %.*s cannot be read; expected a file (OBJ, glTF), or builtin:NAME",
                     (int)bolan_text_fit(path, 300), path);
            return refuse(&b, at, sentence);
        }
        memcpy(o->model, path, strlen(path) + 1);
    }
    return BOLAN_OK;
}

// ---- the whole ------------------------------------------------------------------------------------------------------

bolan_result bolan_scene_file_finish(const scene_file *file, const schema_given *given, const char *name,
                                     bolan_scene *scene) {
    const builder b = {file, given, name, scene};
    uint32_t count = 0;
    if (has(&b, "technique")) bolan_scene_set_technique(scene, &bolan_techniques(&count)[file->technique]);
    for (uint32_t i = 0; i < scene->object_count; i++)
        if (check_object(&b, i)) return BOLAN_ERROR_FORMAT;
    return build_sea(&b) || build_sun(&b) || build_terrain(&b) || build_path(&b) ? BOLAN_ERROR_FORMAT : BOLAN_OK;
}

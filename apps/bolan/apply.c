// SPDX-License-Identifier: MIT
// Options over a scene: each changes what a person would expect, and leaves the rest.
#include "options.h"

#include <math.h>
#include <string.h>

static bool given(double value) { return !isnan(value); }

// ---- the sea --------------------------------------------------------------------------------------------------------

// "pm" and the like; -1 for anything else, which is a file.
static int shape_of(const char *spectrum) {
    if (!spectrum) return -1;
    if (strcmp(spectrum, "pm") == 0 || strcmp(spectrum, "pierson-moskowitz") == 0)
        return BOLAN_SPECTRUM_PIERSON_MOSKOWITZ;
    if (strcmp(spectrum, "jonswap") == 0) return BOLAN_SPECTRUM_JONSWAP;
    if (strcmp(spectrum, "phillips") == 0) return BOLAN_SPECTRUM_PHILLIPS;
    return strcmp(spectrum, "tma") == 0 ? BOLAN_SPECTRUM_TMA : -1;
}

static int check_sea(const options *o) {
    const int winds = given(o->wind) + given(o->beaufort) + given(o->sea_state);
    if (winds > 1) return usage_error("--wind, --beaufort and --sea-state exclude each other");
    if (given(o->fetch_km) && (given(o->beaufort) || given(o->sea_state)))
        return usage_error("--fetch does not go with --beaufort or --sea-state, whose seas are fully developed");
    return EXIT_OK;
}

// A measured sea takes the place of every wave system; --wind still roughens it.
static void use_file(const options *o, bolan_scene *scene) {
    snprintf(scene->spectrum_path, sizeof scene->spectrum_path, "%s", o->spectrum);
    scene->spectrum = bolan_spectrum_options_default();
    scene->sea.sea_state.system_count = 0;
}

// What is read of the spectrum file.
static int apply_spectrum(const options *o, bolan_scene *scene) {
    bolan_spectrum_options *spectrum = &scene->spectrum;
    const char *name = o->record          ? "record"
                       : o->location      ? "location"
                       : given(o->from)   ? "from"
                       : given(o->spread) ? "spread"
                                          : NULL;
    if (!name) return EXIT_OK;
    if (!scene->spectrum_path[0])
        return usage_error("--%s %s a spectrum file; give --spectrum FILE", name,
                           o->record || o->location ? "chooses from" : "completes");
    if (o->record && !bolan_spectrum_options_set_record(spectrum, o->record))
        return usage_error("--record is %.60s; expected a whole number from 0, or a date such as 2018-01-01T06:00",
                           o->record);
    if (o->location && !bolan_spectrum_options_set_location(spectrum, o->location))
        return usage_error("--location is %.60s; expected a whole number from 1, or LON,LAT such as 174.67,-38.17",
                           o->location);
    if (given(o->from)) spectrum->from_deg = o->from;
    if (given(o->spread)) spectrum->spread_s = o->spread;
    return EXIT_OK;
}

static void apply_wind(const options *o, bolan_scene *scene) {
    const bolan_sea_state *old = &scene->sea.sea_state;
    double speed = given(o->wind) ? o->wind : old->wind_speed;
    const double from = given(o->wind_from) ? o->wind_from : old->wind_from_deg;
    const int shape = shape_of(o->spectrum);
    const bool table = given(o->beaufort) || given(o->sea_state);
    if (given(o->beaufort)) speed = bolan_sea_state_from_beaufort(o->beaufort, from).wind_speed;
    if (given(o->sea_state)) speed = bolan_sea_state_from_douglas((int)o->sea_state, from).wind_speed;
    if (given(o->fetch_km)) scene->fetch = o->fetch_km * 1000.0;
    if (given(o->fetch_km) && scene->wind_spectrum == BOLAN_SPECTRUM_PIERSON_MOSKOWITZ)
        scene->wind_spectrum = BOLAN_SPECTRUM_JONSWAP; // a fetch means a growing sea
    if (table) scene->wind_spectrum = BOLAN_SPECTRUM_PIERSON_MOSKOWITZ;
    if (shape >= 0) scene->wind_spectrum = (bolan_spectrum_kind)shape;
    if (table || shape >= 0) scene->technique.wind_spectrum = -1; // what was asked for, whatever the technique likes
    // A Beaufort or Douglas sea is that sea alone; a wind leaves the swells that are there.
    if (table) scene->sea.sea_state.system_count = 0;
    bolan_scene_set_wind(scene, speed, from);
}

static int apply_sea(const options *o, bolan_scene *scene) {
    const int shape = shape_of(o->spectrum);
    if (check_sea(o)) return EXIT_USAGE;
    if (given(o->depth)) scene->sea.sea_state.depth = o->depth;
    if (shape == BOLAN_SPECTRUM_TMA && scene->sea.sea_state.depth >= BOLAN_DEEP)
        return usage_error("--spectrum tma is a sea of finite depth; give --depth too");
    if (o->spectrum && shape < 0) use_file(o, scene);
    const bool wind =
        given(o->wind) || given(o->wind_from) || given(o->fetch_km) || given(o->beaufort) || given(o->sea_state);
    if (shape >= 0 || given(o->beaufort) || given(o->sea_state))
        scene->spectrum_path[0] = '\0'; // a model sea was asked for
    if (apply_spectrum(o, scene)) return EXIT_USAGE;
    if (wind || shape >= 0) apply_wind(o, scene);
    if (o->seed.given) scene->sea.seed = o->seed.value;
    if (given(o->time)) scene->time = o->time;
    return EXIT_OK;
}

static int apply_cpu(const options *o, bolan_scene *scene) {
    if (o->backend == 1) return failure("--backend compute is not in this build; expected cpu");
    if (o->cpu < 0) return EXIT_OK;
    if ((bolan_cpu)o->cpu > bolan_cpu_best()) {
        return failure("--cpu %s: this machine does not have it; its widest set is %s",
                       bolan_cpu_name((bolan_cpu)o->cpu), bolan_cpu_name(bolan_cpu_best()));
    }
    scene->sea.cpu = (bolan_cpu)o->cpu;
    return EXIT_OK;
}

// ---- what is around it ----------------------------------------------------------------------------------------------

static int apply_terrain(const options *o, bolan_scene *scene) {
    bolan_ground_source *t = &scene->terrain;
    if (o->terrain) t->shown_by_object = false;
    if (o->terrain && strcmp(o->terrain, "none") == 0) {
        t->kind = BOLAN_GROUND_NONE;
    } else if (o->terrain && strcmp(o->terrain, "island") == 0) {
        t->kind = BOLAN_GROUND_GENERATED;
        snprintf(t->generator.name, sizeof t->generator.name, "%s", o->terrain);
    } else if (o->terrain) {
        t->kind = BOLAN_GROUND_RASTER;
        snprintf(t->raster.path, sizeof t->raster.path, "%s", o->terrain);
    }
    if (!given(o->at[0])) return EXIT_OK;
    if (t->kind != BOLAN_GROUND_RASTER) return usage_error("--at is a place in a raster; give --terrain FILE too");
    if (fabs(o->at[0]) > 90.0) return usage_error("--at has a latitude beyond 90 degrees; expected LAT,LON");
    t->raster.latitude = o->at[0];
    t->raster.longitude = o->at[1];
    return EXIT_OK;
}

static int apply_picture(const options *o, bolan_scene *scene) {
    if (given(o->camera[0])) {
        bolan_camera *c = &scene->camera;
        c->position = bolan_dv3(o->camera[0], o->camera[1], o->camera[2]);
        c->heading_deg = o->camera[3];
        c->pitch_deg = o->camera[4];
        c->roll_deg = 0.0;
        if (given(o->camera[5])) c->fov_deg = o->camera[5];
        scene->camera_key_count = 0; // it was told where to stand
    } else {
        scene->camera = bolan_scene_camera_at(scene, scene->time);
    }
    if (given(o->sun[0])) {
        scene->sky.sun_azimuth_deg = o->sun[0];
        scene->sky.sun_elevation_deg = o->sun[1];
    }
    if (o->water >= 0) scene->water.type = (bolan_jerlov)o->water;
    return EXIT_OK;
}

// ---- technique ------------------------------------------------------------------------------------------------------

static int effect_of(const char *name, size_t length) {
    for (int i = 0; bolan_effect_names[i]; i++)
        if (strlen(bolan_effect_names[i]) == length && strncmp(bolan_effect_names[i], name, length) == 0) return i;
    return -1;
}

static int apply_effects(const char *list, uint32_t *effects) {
    uint32_t bits = 0;
    for (const char *p = strcmp(list, "none") == 0 ? "" : list; *p; p += *p == ',') {
        const size_t length = strcspn(p, ",");
        const int effect = effect_of(p, length);
        if (effect < 0)
            return usage_error("--effects: %.*s is unknown; expected none, or some of reflection, refraction, bump, "
                               "distortion, glitter, caustics, ambient, diffuse, specular, scattering, foam, fog",
                               (int)(length < 40 ? length : bolan_text_fit(p, 40)), p);
        bits |= 1u << effect;
        p += length;
    }
    *effects = bits;
    return EXIT_OK;
}

static int apply_technique(const options *o, bolan_scene *scene) {
    uint32_t count = 0;
    bolan_technique technique = scene->technique;
    if (o->technique >= 0) technique = bolan_techniques(&count)[o->technique];
    if (o->waves >= 0) technique.waves = (bolan_wave_model)o->waves;
    if (o->surface >= 0) technique.surface = (bolan_surface_kind)o->surface;
    if (o->optics >= 0) technique.optics = (bolan_optics_kind)o->optics;
    bolan_scene_set_technique(scene, &technique);
    scene->look.paper |= o->paper;
    if (o->show >= 0) scene->look.show = (bolan_show)o->show;
    return o->effects ? apply_effects(o->effects, &scene->look.effects) : EXIT_OK;
}

int options_scene(const options *o, bolan_scene *scene) {
    const bolan_result loaded = bolan_scene_load(o->scene ? o->scene : "island", scene);
    if (loaded) return loaded == BOLAN_ERROR_ARGUMENT ? EXIT_USAGE : EXIT_FAILED;
    int result = apply_technique(o, scene);
    if (!result) result = apply_sea(o, scene);
    if (!result) result = apply_cpu(o, scene);
    if (!result) result = apply_terrain(o, scene);
    if (!result) result = apply_picture(o, scene);
    if (!result && bolan_scene_validate(scene)) result = EXIT_USAGE;
    return result;
}

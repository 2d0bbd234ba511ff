// SPDX-License-Identifier: MIT
// Applies the options to a scene: each option changes its own fields and those that follow from them.
#include "options.h"

#include <math.h>
#include <string.h>

static bool given(double value) { return !isnan(value); }

// ---- the sea --------------------------------------------------------------------------------------------------------

// A spectrum's name, or "pm"; -1 for anything else, which is a file.
static int shape_of(const char *spectrum) {
    if (spectrum && strcmp(spectrum, "pm") == 0) return BOLAN_SPECTRUM_PIERSON_MOSKOWITZ;
    for (int i = 0; spectrum && bolan_wind_spectrum_names[i]; i++)
        if (strcmp(spectrum, bolan_wind_spectrum_names[i]) == 0) return i;
    return -1;
}

// A Beaufort force or a Douglas degree.
static bool has_table(const options *o) { return option_given(o, "beaufort") || option_given(o, "sea-state"); }

static int check_sea(const options *o) {
    if (option_given(o, "wind") + option_given(o, "beaufort") + option_given(o, "sea-state") > 1)
        return usage_error("--wind, --beaufort and --sea-state exclude each other");
    if (option_given(o, "fetch") && has_table(o))
        return usage_error("--fetch does not go with --beaufort or --sea-state, whose seas are fully developed");
    return EXIT_OK;
}

// A measured sea replaces every wave system; --wind still roughens it.
static void use_file(const options *o, bolan_scene *scene) {
    snprintf(scene->spectrum_path, sizeof scene->spectrum_path, "%s", o->spectrum);
    scene->spectrum = bolan_spectrum_options_default();
    scene->sea.sea_state.system_count = 0;
}

int options_spectrum(const options *o, bolan_spectrum_options *spectrum) {
    if (option_given(o, "record") && !bolan_spectrum_options_set_record(spectrum, o->record))
        return usage_error("--record is %.60s; expected a whole number from 0, or a date such as 2018-01-01T06:00",
                           o->record);
    if (option_given(o, "location") && !bolan_spectrum_options_set_location(spectrum, o->location))
        return usage_error("--location is %.60s; expected a whole number from 1, or LON,LAT such as 174.67,-38.17",
                           o->location);
    return EXIT_OK;
}

// What is read of the spectrum file.
static int apply_spectrum(const options *o, bolan_scene *scene) {
    static const char *const names[] = {"record", "location", "interpolate", "from", "spread"};
    for (int i = 0; i < 5; i++)
        if (option_given(o, names[i]) && !scene->spectrum_path[0])
            return usage_error("--%s %s a spectrum file; give --spectrum FILE", names[i],
                               i < 3 ? "chooses from" : "completes");
    return options_spectrum(o, &scene->spectrum);
}

static void apply_wind(const options *o, bolan_scene *scene) {
    double speed = scene->sea.sea_state.wind_speed;
    const double from = scene->sea.sea_state.wind_from_deg;
    const int shape = shape_of(o->spectrum);
    if (option_given(o, "beaufort")) speed = bolan_sea_state_from_beaufort(o->beaufort, from).wind_speed;
    if (option_given(o, "sea-state")) speed = bolan_sea_state_from_douglas((int)o->sea_state, from).wind_speed;
    if (option_given(o, "fetch") && scene->wind_spectrum == BOLAN_SPECTRUM_PIERSON_MOSKOWITZ)
        scene->wind_spectrum = BOLAN_SPECTRUM_JONSWAP; // a fetch means a growing sea
    if (has_table(o)) scene->wind_spectrum = BOLAN_SPECTRUM_PIERSON_MOSKOWITZ;
    if (shape >= 0) scene->wind_spectrum = (bolan_spectrum_kind)shape;
    // A wind sea that was asked for joins the waves that the scene lists, or replaces the first, if that has a wind.
    if (option_given(o, "fetch") || has_table(o) || shape >= 0) scene->wind_sea = true;
    // The spectrum of the option, whatever spectrum the technique has.
    if (has_table(o) || shape >= 0) scene->technique.wind_spectrum = -1;
    // A Beaufort or Douglas sea has no swells; --wind keeps the swells of the scene.
    if (has_table(o)) scene->sea.sea_state.system_count = 0;
    bolan_scene_set_wind(scene, speed, from);
}

static int apply_sea(const options *o, bolan_scene *scene) {
    const int shape = shape_of(o->spectrum);
    if (check_sea(o)) return EXIT_USAGE;
    if (shape == BOLAN_SPECTRUM_TMA && scene->sea.sea_state.depth >= BOLAN_DEEP)
        return usage_error("--spectrum tma is a sea of finite depth; give --depth too");
    if (shape >= 0 || has_table(o)) scene->spectrum_path[0] = '\0'; // a model sea was asked for
    if (apply_spectrum(o, scene)) return EXIT_USAGE;
    if (option_given(o, "wind") || option_given(o, "wind-from") || option_given(o, "fetch") || has_table(o) ||
        shape >= 0)
        apply_wind(o, scene);
    return EXIT_OK;
}

static int check_machine(const bolan_scene *scene) {
    if (scene->sea.cpu > bolan_cpu_best())
        return failure("--cpu %s: this machine does not have it; its widest set is %s", bolan_cpu_name(scene->sea.cpu),
                       bolan_cpu_name(bolan_cpu_best()));
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
        scene->camera_key_count = 0; // a given camera does not follow the path
    } else {
        scene->camera = bolan_scene_camera_at(scene, scene->time);
    }
    if (given(o->sun[0])) {
        scene->sky.sun_azimuth_deg = o->sun[0];
        scene->sky.sun_elevation_deg = o->sun[1];
    }
    return EXIT_OK;
}

// ---- technique ------------------------------------------------------------------------------------------------------

static void apply_technique(const options *o, bolan_scene *scene) {
    uint32_t count = 0;
    bolan_technique technique = scene->technique;
    if (option_given(o, "technique")) technique = bolan_techniques(&count)[o->technique];
    if (option_given(o, "waves")) technique.waves = o->edits.technique.waves;
    if (option_given(o, "surface")) technique.surface = o->edits.technique.surface;
    if (option_given(o, "optics")) technique.optics = o->edits.technique.optics;
    bolan_scene_set_technique(scene, &technique);
}

int options_scene(const options *o, bolan_scene *scene) {
    const bolan_result loaded = bolan_scene_load(o->scene ? o->scene : "island", scene);
    if (loaded) return loaded == BOLAN_ERROR_ARGUMENT ? EXIT_USAGE : EXIT_FAILED;
    if (o->spectrum && shape_of(o->spectrum) < 0) use_file(o, scene);
    options_edit(o, scene);
    apply_technique(o, scene);
    int result = apply_sea(o, scene);
    if (!result) result = check_machine(scene);
    if (!result) result = apply_terrain(o, scene);
    if (!result) result = apply_picture(o, scene);
    if (!result && bolan_scene_validate(scene)) result = EXIT_USAGE;
    return result;
}

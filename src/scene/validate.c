// SPDX-License-Identifier: MIT
// Every field of a scene against its range.
#include "bolan/scene.h"

#include <string.h>

static bolan_result check(const char *field, double value, double low, double high, const char *unit) {
    if (value >= low && value <= high) return BOLAN_OK;
    const bool finite = isfinite(value);
    bolan_log(BOLAN_LOG_ERROR, finite ? BOLAN_LOG_OUT_OF_RANGE : BOLAN_LOG_NOT_FINITE,
              "scene: %s is %g; expected %g to %g%s%s", field, value, low, high, *unit ? " " : "", unit);
    return BOLAN_ERROR_ARGUMENT;
}

// Longer than its buffer: not a string.
static bolan_result check_text(const char *field, const char *text, size_t capacity) {
    if (memchr(text, '\0', capacity)) return BOLAN_OK;
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_BAD_ARGUMENT, "scene: %s is not ended; expected fewer than %u characters",
              field, (unsigned)capacity);
    return BOLAN_ERROR_ARGUMENT;
}

static bolan_result check_resolution(uint32_t n) {
    if (n >= 32 && n <= 1024 && (n & (n - 1)) == 0) return BOLAN_OK;
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_RANGE,
              "scene: sea.resolution is %u; expected a power of two, 32 to 1024", (unsigned)n);
    return BOLAN_ERROR_ARGUMENT;
}

static bolan_result check_sea(const bolan_scene *s) {
    const bolan_sea_desc *d = &s->sea;
    const bool ok =
        !bolan_sea_state_validate(&d->sea_state) && !check_resolution(d->resolution) &&
        !check("sea.fft.cascade_count", d->fft.cascade_count, 1, BOLAN_MAX_CASCADES, "") &&
        !(d->length != 0.0 && check("sea.length", d->length, 10, 1e5, "m")) &&
        !check("sea.choppiness", d->choppiness, 0, 2, "") && !check("sea.current_x", d->current_x, -5, 5, "m/s") &&
        !check("sea.current_y", d->current_y, -5, 5, "m/s") &&
        !(d->loop_period != 0.0 && check("sea.loop_period", d->loop_period, 10, 1e6, "s")) &&
        !(d->textures.period != 0.0 && check("sea.textures.period", d->textures.period, 1, 1e6, "s")) &&
        !check("sea.cpu", (double)d->cpu, 0, BOLAN_CPU_AVX512, "(a bolan_cpu)") &&
        !check("sea.foam_decay", d->foam_decay, 0.1, 60, "s") && !check("fetch", s->fetch, 100, 1e7, "m") &&
        !check("wind_spectrum", (double)s->wind_spectrum, 0, BOLAN_SPECTRUM_KINDS - 1, "(a bolan_spectrum_kind)") &&
        !check("sea.cosines.frequencies", d->cosines.frequencies, 1, BOLAN_MAX_FREQUENCIES, "") &&
        !check("sea.cosines.directions", d->cosines.directions, 1, BOLAN_MAX_DIRECTIONS, "") &&
        !check("sea.cosines.split", (double)d->cosines.split, 0, BOLAN_SPLIT_EQUAL_WIDTH,
               "(a bolan_frequency_split)") &&
        !check("sea.exp_cosine.wave_count", d->exp_cosine.wave_count, 1, BOLAN_MAX_EXP_WAVES, "") &&
        !check("sea.exp_cosine.sharpness", d->exp_cosine.sharpness, 0.01, 2, "") &&
        !check("sea.textures.frames", d->textures.frames, 2, BOLAN_MAX_LOOP_FRAMES, "") &&
        !check_text("spectrum_path", s->spectrum_path, sizeof s->spectrum_path) &&
        !bolan_spectrum_options_validate(&s->spectrum) &&
        !check_text("tiles_path", s->tiles_path, sizeof s->tiles_path);
    return ok ? BOLAN_OK : BOLAN_ERROR_ARGUMENT;
}

static bolan_result check_technique(const bolan_technique *t, const bolan_look *l) {
    const bool ok =
        !check("technique.waves", (double)t->waves, 0, BOLAN_WAVE_MODELS - 1, "(a bolan_wave_model)") &&
        !check("technique.surface", (double)t->surface, 0, BOLAN_SURFACE_KINDS - 1, "(a bolan_surface_kind)") &&
        !check("technique.optics", (double)t->optics, 0, BOLAN_OPTICS_KINDS - 1, "(a bolan_optics_kind)") &&
        !check("look.effects", l->effects, 0, BOLAN_EFFECTS_ALL, "(bits of bolan_effect)") &&
        !check("look.show", (double)l->show, 0, BOLAN_SHOWS - 1, "(a bolan_show)") &&
        !check("look.distortion", l->distortion, 0, 4, "") && !check("look.blend", l->blend, 0, 1, "") &&
        !check("look.ambient", l->ambient, 0, 2, "") && !check("look.diffuse", l->diffuse, 0, 2, "") &&
        !check("look.specular", l->specular, 0, 4, "") && !check("look.shininess", l->shininess, 1, 4096, "");
    return ok ? BOLAN_OK : BOLAN_ERROR_ARGUMENT;
}

static bolan_result check_objects(const bolan_scene *s) {
    if (check("object_count", s->object_count, 0, BOLAN_MAX_OBJECTS, "")) return BOLAN_ERROR_ARGUMENT;
    for (uint32_t i = 0; i < s->object_count; i++) {
        const bolan_object *o = &s->objects[i];
        const bool ok = !check_text("objects.model", o->model, sizeof o->model) &&
                        !check("objects.position.x", o->position.x, -1e7, 1e7, "m") &&
                        !check("objects.position.y", o->position.y, -1e7, 1e7, "m") &&
                        !check("objects.position.z", o->position.z, -11000, 10000, "m") &&
                        !check("objects.heading_deg", o->heading_deg, -360, 360, "degrees") &&
                        !check("objects.scale", o->scale, 1e-3, 1e3, "") &&
                        !check("objects.up", (double)o->up, 0, BOLAN_UP_Z, "(a bolan_up)") &&
                        !check("objects.offset.x", o->offset.x, -1e8, 1e8, "") &&
                        !check("objects.offset.y", o->offset.y, -1e8, 1e8, "") &&
                        !check("objects.offset.z", o->offset.z, -1e8, 1e8, "");
        if (!ok) return BOLAN_ERROR_ARGUMENT;
    }
    return BOLAN_OK;
}

static bolan_result check_camera(const bolan_camera *c) {
    const bool ok = !check("camera.position.x", c->position.x, -1e7, 1e7, "m") &&
                    !check("camera.position.y", c->position.y, -1e7, 1e7, "m") &&
                    !check("camera.position.z", c->position.z, -1000, 1e6, "m") &&
                    !check("camera.heading_deg", c->heading_deg, -360, 360, "degrees") &&
                    !check("camera.pitch_deg", c->pitch_deg, -90, 90, "degrees") &&
                    !check("camera.roll_deg", c->roll_deg, -180, 180, "degrees") &&
                    !check("camera.fov_deg", c->fov_deg, 1, 150, "degrees");
    return ok ? BOLAN_OK : BOLAN_ERROR_ARGUMENT;
}

static bolan_result check_path(const bolan_scene *s) {
    if (check("camera_key_count", s->camera_key_count, 0, BOLAN_MAX_CAMERA_KEYS, "")) return BOLAN_ERROR_ARGUMENT;
    for (uint32_t i = 0; i < s->camera_key_count; i++) {
        const bolan_camera_key *k = &s->camera_keys[i];
        const double after = i > 0 ? k[-1].time + 1e-3 : -1e9;
        if (check("camera_keys.time", k->time, after, 1e9, "s, later than the key before") || check_camera(&k->camera))
            return BOLAN_ERROR_ARGUMENT;
    }
    return BOLAN_OK;
}

static bolan_result check_sky_and_water(const bolan_sky *k, const bolan_seawater *w) {
    const bool ok = !check("sky.sun_azimuth_deg", k->sun_azimuth_deg, -360, 360, "degrees") &&
                    !check("sky.sun_elevation_deg", k->sun_elevation_deg, -90, 90, "degrees") &&
                    !check("sky.visibility", k->visibility, 500, 300e3, "m") &&
                    !check("sky.cloud_cover", k->cloud_cover, 0, 1, "") &&
                    !check("sky.cloud_base", k->cloud_base, 100, 12000, "m") &&
                    !check("water.type", (double)w->type, 0, BOLAN_JERLOV_9C, "(a bolan_jerlov)") &&
                    !check("water.level", w->level, -20, 20, "m") && !check("water.foam", w->foam, 0, 2, "");
    return ok ? BOLAN_OK : BOLAN_ERROR_ARGUMENT;
}

static bolan_result check_island(const bolan_island_desc *d) {
    const bool ok = !check("terrain.island.radius", d->radius, 200, 20000, "m") &&
                    !check("terrain.island.peak", d->peak, 10, 3000, "m") &&
                    !check("terrain.island.sea_floor", d->sea_floor, -11000, -20, "m") &&
                    !check("terrain.island.lagoon_from_deg", d->lagoon_from_deg, -360, 360, "degrees");
    return ok ? BOLAN_OK : BOLAN_ERROR_ARGUMENT;
}

static bolan_result check_raster(const bolan_raster_desc *r) {
    const bool ok =
        !check_text("terrain.raster.path", r->path, sizeof r->path) &&
        !check_text("terrain.raster.variable", r->variable, sizeof r->variable) &&
        !check_text("terrain.raster.crs", r->crs, sizeof r->crs) &&
        !check("terrain.raster.band", r->band, 0, 65535, "") &&
        !(!isnan(r->latitude) && check("terrain.raster.latitude", r->latitude, -90, 90, "degrees")) &&
        !(!isnan(r->longitude) && check("terrain.raster.longitude", r->longitude, -360, 360, "degrees")) &&
        !check("terrain.raster.radius", r->radius, 100, 5e6, "m") &&
        !(!isnan(r->vertical_scale) &&
          check("terrain.raster.vertical_scale (without its sign)", fabs(r->vertical_scale), 1e-3, 1e3, "")) &&
        !check("terrain.raster.nodata", (double)r->nodata, 0, BOLAN_NODATA_SEA, "(a bolan_raster_nodata)") &&
        !check("terrain.raster.zero", (double)r->zero, 0, BOLAN_ZERO_SEA, "(a bolan_raster_zero)");
    return ok ? BOLAN_OK : BOLAN_ERROR_ARGUMENT;
}

static bolan_result check_terrain(const bolan_ground_source *t) {
    if (check("terrain.kind", (double)t->kind, 0, BOLAN_GROUND_POND, "(a bolan_ground_kind)"))
        return BOLAN_ERROR_ARGUMENT;
    if (t->kind == BOLAN_GROUND_ISLAND) return check_island(&t->island);
    return t->kind == BOLAN_GROUND_RASTER ? check_raster(&t->raster) : BOLAN_OK;
}

bolan_result bolan_scene_validate(const bolan_scene *s) {
    BOLAN_ASSERT(s);
    const bool ok = !check_text("name", s->name, sizeof s->name) &&
                    !check_text("description", s->description, sizeof s->description) && !check_sea(s) &&
                    !check_technique(&s->technique, &s->look) && !check_objects(s) && !check_camera(&s->camera) &&
                    !check_path(s) && !check_sky_and_water(&s->sky, &s->water) && !check_terrain(&s->terrain) &&
                    !check("time", s->time, -1e9, 1e9, "s") && !check("exposure", s->exposure, -10, 10, "stops");
    return ok ? BOLAN_OK : BOLAN_ERROR_ARGUMENT;
}

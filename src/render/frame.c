// SPDX-License-Identifier: MIT
// One picture, as the list of its passes.
#include "frame.h"
#include "shared/constants.glsl"

#include <math.h>

#include "bolan/earth.h"
#include "bolan/query.h"
#include "renderer.h"

const char *const bolan_frame_part_names[PART_COUNT] = {"sky tables", "sea",   "terrain", "models",  "copy",
                                                        "mirror",     "water", "sky",     "tone map"};

static double near_plane(double height, bool clip_control) {
    // Reversed-Z keeps its precision whatever the near plane; without clip control the depth is a fixed-point number.
    return fmin(fmax(fabs(height) * 0.04, clip_control ? 0.08 : 0.4), 20.0);
}

static bolan_vec3 sun_direction(const bolan_sky *sky) {
    double azimuth = bolan_radians(sky->sun_azimuth_deg), elevation = bolan_radians(sky->sun_elevation_deg);
    return bolan_v3((float)(sin(azimuth) * cos(elevation)), (float)(cos(azimuth) * cos(elevation)),
                    (float)sin(elevation));
}

static void fill_water(frame_block *b, const bolan_seawater *water) {
    bolan_water_optics optics = bolan_water_optics_from_jerlov(water->type);
    b->water_reflectance = optics.deep;
    b->water_index = optics.index;
    b->water_attenuation = optics.kd;
    b->foam_strength = (float)water->foam;
    b->water_level = (float)water->level;
}

// Camera of one sub-picture; `shift` moves the picture by parts of a pixel.
static void fill_camera(frame *f, bool zero_to_one, double near_m, bolan_vec2 shift) {
    const bolan_camera *c = &f->scene->camera;
    view_block *b = &f->uniforms.view;
    double fov = bolan_radians(c->fov_deg), width = f->desc->width, height = f->desc->height;
    f->view = bolan_m4_view(c->heading_deg, c->pitch_deg, c->roll_deg);
    f->projection = bolan_m4_projection(fov, width / height, near_m, zero_to_one);
    f->projection.m[8] -= 2.0f * shift.x / (float)width;
    f->projection.m[9] -= 2.0f * shift.y / (float)height;
    b->view_projection = bolan_m4_mul(f->projection, f->view);
    b->inverse_view_projection = bolan_m4_inverse(b->view_projection);
    bolan_view_block_resize(b, f->desc->width, f->desc->height);
    b->radians_per_pixel = (float)(2.0 * tan(0.5 * fov) / height);
    b->near_distance = (float)near_m;
    b->clip_zero_to_one = zero_to_one ? 1.0f : 0.0f;
}

static float reduced(double x, double period) { return (float)(x - period * floor(x / period)); }

double bolan_sea_peak_period(const bolan_sea_summary *sea) { return sea->tp > 0.0 ? sea->tp : 8.0; }

double bolan_sea_peak_length(const bolan_sea_summary *sea) {
    const double period = bolan_sea_peak_period(sea);
    return BOLAN_GRAVITY * period * period / (2.0 * BOLAN_PI);
}

double bolan_sea_surf_height(const bolan_sea_summary *sea) { return fmin(fmax(sea->hs, 0.25), 4.0); }

#define BORE_DEPTH 0.71            // of the water under a bore, in heights of the bore
#define STREAK_ACROSS (1.0 / 16.0) // tiles of wind streaks per metre
#define STREAK_ALONG (0.4 * STREAK_ACROSS)

// Bores run with the speed of shallow water, one in each period of the sea.
static void fill_surf(frame *f, const bolan_sea_summary *sea) {
    const double period = fmin(fmax(bolan_sea_peak_period(sea), 3.0), 12.0);
    const double length = period * sqrt(BOLAN_GRAVITY * BORE_DEPTH * bolan_sea_surf_height(sea));
    const double to = bolan_compass_from_to_math(sea->from_deg), x = cos(to) / length, y = sin(to) / length;
    const double periods = f->time / period;
    f->uniforms.frame.surf_wave = (bolan_vec2){(float)x, (float)y};
    f->uniforms.frame.surf_time = reduced(periods, 1.0);
    f->uniforms.view.surf_phase = reduced(periods - x * f->eye.x - y * f->eye.y, 1.0);
}

void bolan_frame_streaks(block_values *blocks, bolan_dvec3 eye, double wind_to) {
    const double c = cos(wind_to), s = sin(wind_to);
    blocks->frame.streak_scale = (bolan_vec2){(float)STREAK_ACROSS, (float)STREAK_ALONG};
    blocks->view.streak_place = (bolan_vec2){reduced((c * eye.y - s * eye.x) * STREAK_ACROSS, 1.0),
                                             reduced((c * eye.x + s * eye.y) * STREAK_ALONG, 1.0)};
}

#define LEAST_DEPTH 0.12 // [m] of an eye under water, for the near plane's sake

// An eye that a wave would swallow rides over it, unless the optics has a picture from below.
static bolan_dvec3 eye_clear_of_water(const bolan_frame_desc *d) {
    bolan_dvec3 eye = d->scene->camera.position;
    if (eye.z < d->scene->water.level && bolan_pass_water_seen_from_below(d->scene)) {
        eye.z = fmin(eye.z, d->scene->water.level - LEAST_DEPTH);
        return eye;
    }
    bolan_dvec2 below = {eye.x, eye.y};
    bolan_query_point water;
    bolan_query_surface(&(bolan_water){.sea = d->sea, .ground = d->terrain, .level = d->scene->water.level}, &below, 1, &water);
    eye.z = fmax(eye.z, (double)water.height + 0.3);
    return eye;
}

static void fill_scene(frame *f) {
    const bolan_scene *s = f->scene;
    block_values *u = &f->uniforms;
    const bolan_sea_state *state = &bolan_sea_get_desc(f->desc->sea)->sea_state;
    f->time = bolan_sea_time(f->desc->sea);
    u->view.shade_columns = 1.0f;
    f->eye = eye_clear_of_water(f->desc);
    u->view.eye_under_water = f->eye.z < s->water.level ? 1.0f : 0.0f;
    f->sun_direction = sun_direction(&s->sky);
    double wind_to = bolan_compass_from_to_math(state->wind_from_deg);
    u->view.eye_wrapped = (bolan_vec2){reduced(f->eye.x, WORLD_WRAP), reduced(f->eye.y, WORLD_WRAP)};
    u->view.eye_wrapped_wide = (bolan_vec2){reduced(f->eye.x, WORLD_WRAP_WIDE), reduced(f->eye.y, WORLD_WRAP_WIDE)};
    u->view.eye_height = (float)(f->eye.z - s->water.level);
    u->frame.sun_direction = f->sun_direction;
    u->frame.wind_direction = (bolan_vec2){(float)cos(wind_to), (float)sin(wind_to)};
    u->frame.wind_speed = (float)state->wind_speed;
    u->frame.cloud_cover = (float)s->sky.cloud_cover;
    u->frame.cloud_base = (float)s->sky.cloud_base;
    u->frame.visibility = (float)s->sky.visibility;
    u->frame.earth_radius = (float)BOLAN_EARTH_RADIUS;
    fill_water(&u->frame, &s->water);
    fill_surf(f, bolan_sea_get_summary(f->desc->sea));
    bolan_frame_streaks(u, f->eye, wind_to);
    const bool under =
        u->view.eye_under_water > 0.5f; // the paper names the fog as work to come, so above the water its mode has none
    u->view.under_fog = s->look.effects & BOLAN_EFFECT_FOG && (under || !s->look.paper) ? 1.0f : 0.0f;
}

// Sub-pixel shifts of a sample: the R2 sequence (Roberts 2018), centred; the first is the pixel's middle.
static bolan_vec2 sample_shift(uint32_t i) {
    double x = fmod(0.7548776662466927 * i, 1.0), y = fmod(0.5698402909980532 * i, 1.0);
    return (bolan_vec2){(float)(x < 0.5 ? x : x - 1.0), (float)(y < 0.5 ? y : y - 1.0)};
}

static gl_timing timing_of(const bolan_renderer *r) {
    if (!r->measure) return GL_TIMING_OFF;
    return r->caps.timers ? GL_TIMING_GPU : GL_TIMING_FINISH;
}
static void begin_part(bolan_renderer *r, frame_part part) { bolan_gl_timer_begin(&r->timers[part], timing_of(r)); }
static void end_part(bolan_renderer *r, frame_part part) { bolan_gl_timer_end(&r->timers[part], timing_of(r)); }

static void upload_uniforms(bolan_renderer *r, const frame *f) { bolan_blocks_upload(&r->uniforms, &f->uniforms); }

// Everything that does not depend on the sub-pixel shift.
static void prepare(bolan_renderer *r, frame *f) {
    upload_uniforms(r, f);
    begin_part(r, PART_SKY_TABLES);
    bolan_pass_sky_prepare(r->sky, f);
    end_part(r, PART_SKY_TABLES);
    upload_uniforms(r, f); // the light is known now
    begin_part(r, PART_SEA);
    bolan_pass_ground_prepare(r->terrain, f);
    f->shore = bolan_pass_ground_shore(r->terrain);
    bolan_pass_objects_prepare(r->models, f);
    if (!f->desc->without_water) bolan_pass_water_prepare(r->water, f);
    end_part(r, PART_SEA);
}

static void draw_world(bolan_renderer *r, frame *f) {
    bolan_pass_ground_draw(r->terrain, f);
    bolan_pass_objects_draw(r->models, f);
}

static void draw_opaque(bolan_renderer *r, frame *f) {
    bolan_gl_set_state(&(gl_state){.depth_test = true, .depth_write = true, .color_write = true});
    bolan_gl_target_bind(&f->hdr);
    bolan_gl_target_clear_color(0.0f, 0.0f, 0.0f, 0.0f);
    bolan_gl_target_clear_depth(0.0f);
    begin_part(r, PART_TERRAIN);
    if (!f->desc->without_water) bolan_pass_water_cover(r->water, f);
    bolan_pass_ground_draw(r->terrain, f);
    end_part(r, PART_TERRAIN);
    begin_part(r, PART_MODELS);
    bolan_pass_objects_draw(r->models, f);
    end_part(r, PART_MODELS);
}

// What lies behind the water, for an optics that looks through it. Over the open sea nothing shines through.
static void copy_behind(bolan_renderer *r, frame *f) {
    bolan_gl_target_copy_color(&r->hdr, &r->behind);
    bolan_gl_target_copy_depth(&r->hdr, &r->behind);
    bolan_gl_texture_bind(&r->behind_color, UNIT_SCENE_COLOR);
    bolan_gl_texture_bind(&r->behind_depth, UNIT_SCENE_DEPTH);
    bolan_gl_target_bind(&f->hdr);
}

static void draw_picture(bolan_renderer *r, frame *m, bool sky) {
    const bolan_vec4 b = m->background;
    upload_uniforms(r, m);
    bolan_gl_set_state(&(gl_state){.depth_test = true, .depth_write = true, .color_write = true});
    bolan_gl_target_bind(&m->hdr);
    bolan_gl_target_clear_color(b.x, b.y, b.z, b.w);
    bolan_gl_target_clear_depth(0.0f);
    draw_world(r, m);
    if (m->uniforms.view.mirrored_under_water > 0.5f)
        bolan_planar_views_draw_body(r->mirror);
    else if (sky)
        bolan_pass_sky_draw(r->sky, m);
}

// What the water mirrors, and what shines through it, each as a picture.
static void draw_mirrors(bolan_renderer *r, frame *f) {
    if (!bolan_planar_views_fit(r->mirror, f)) return;
    frame above = bolan_planar_views_reflect(r->mirror, f), below = bolan_planar_views_refract(r->mirror, f);
    const uint32_t effects = f->scene->look.effects;
    // A margin for blurred look-ups at the horizon; what is mirrored there is the haze.
    bolan_gl_clip_rows(bolan_pass_water_rows(f) * above.hdr.height / f->hdr.height + 64);
    if (effects & BOLAN_EFFECT_REFLECTION) draw_picture(r, &above, bolan_pass_water_mirrors_sky(f));
    if (effects & BOLAN_EFFECT_REFRACTION) draw_picture(r, &below, false);
    bolan_gl_clip_rows(0);
    if (!f->scene->look.paper) bolan_planar_views_finish(r->mirror);
    upload_uniforms(r, f);
    bolan_planar_views_bind(r->mirror);
}

static void light_water(bolan_renderer *r, frame *f) {
    frame sparse = bolan_pass_half_rate(r->water, f);
    const bool fewer = sparse.uniforms.view.shade_columns > 1.0f;
    if (fewer) upload_uniforms(r, &sparse);
    bolan_gl_target_bind(&sparse.hdr);
    bolan_pass_water_draw(r->water, &sparse);
    f->triangles = sparse.triangles;
    f->water_triangles = sparse.water_triangles;
    if (!fewer) return;
    upload_uniforms(r, f);
    bolan_pass_water_lay(r->water, f);
}

static void draw_water(bolan_renderer *r, frame *f) {
    const bool water = !f->desc->without_water, mirrors = water && bolan_pass_water_mirrors(f);
    begin_part(r, PART_COPY);
    // Clouds below a high eye are laid over by the depth of the land.
    if (water && f->shore->present && (!mirrors || f->uniforms.view.eye_above_clouds > 0.5f)) copy_behind(r, f);
    end_part(r, PART_COPY);
    begin_part(r, PART_MIRROR);
    if (mirrors) draw_mirrors(r, f);
    end_part(r, PART_MIRROR);
    begin_part(r, PART_WATER);
    if (water) light_water(r, f);
    end_part(r, PART_WATER);
}

// Last, where nothing stands before it.
static void draw_sky(bolan_renderer *r, frame *f) {
    begin_part(r, PART_SKY);
    if (f->uniforms.view.eye_under_water > 0.5f) {
        bolan_planar_views_draw_body(r->mirror);
    } else {
        bolan_pass_sky_draw(r->sky, f);
        bolan_pass_sky_draw_over(r->sky, f);
    }
    end_part(r, PART_SKY);
}

static void keep_statistics(bolan_renderer *r, const frame *f) {
    bolan_frame_statistics *s = &r->statistics;
    s->triangles = f->triangles;
    s->water_triangles = f->water_triangles;
    s->pass_count = PART_COUNT;
    for (int i = 0; i < PART_COUNT; ++i) {
        s->passes[i].name = bolan_frame_part_names[i];
        s->passes[i].ms = r->timers[i].ms;
    }
}

static void draw_sample(bolan_renderer *r, frame *f, uint32_t sample) {
    const bolan_frame_desc *d = f->desc;
    f->triangles = f->water_triangles = 0;
    fill_camera(f, f->uniforms.view.clip_zero_to_one > 0.5f, r->near_plane, sample_shift(d->samples - 1 - sample));
    f->picture = f->uniforms.view.eye_under_water > 0.5f;
    upload_uniforms(r, f);
    draw_opaque(r, f);
    draw_water(r, f);
    draw_sky(r, f);
    begin_part(r, PART_TONEMAP);
    bolan_gl_target_bind_external(d->framebuffer, d->width, d->height);
    bolan_pass_tonemap_draw(r->tonemap, f, &r->hdr_color, sample, d->samples);
    end_part(r, PART_TONEMAP);
}

static void draw_frame(bolan_renderer *r, const bolan_frame_desc *desc) {
    frame f = {.desc = desc, .scene = desc->scene, .caps = &r->caps, .quality = r->desc.quality};
    const bool zero_to_one = r->caps.clip_control && !r->desc.no_clip_control;
    if (r->caps.clip_control) bolan_gl_set_clip_zero_to_one(zero_to_one);
    f.hdr = r->hdr;
    f.hdr_depth = &r->hdr_depth;
    fill_scene(&f);
    r->near_plane = near_plane(f.uniforms.view.eye_height, zero_to_one);
    fill_camera(&f, zero_to_one, r->near_plane, (bolan_vec2){0.0f, 0.0f});
    prepare(r, &f);
    // The unshifted sample comes last, so that the depth that remains is that of the pixels' middles.
    for (uint32_t s = 0; s < desc->samples; ++s) draw_sample(r, &f, s);
    r->radiance_unit = f.uniforms.frame.radiance_unit;
    keep_statistics(r, &f);
}

void bolan_renderer_draw(bolan_renderer *r, const bolan_frame_desc *desc) {
    const bool given = r != NULL && desc != NULL && desc->scene != NULL && desc->sea != NULL;
    BOLAN_ASSERT(given);
    if (!given || !bolan_frame_is_valid(r, desc)) return;
    bolan_renderer_enter(r);
    if (bolan_frame_has_framebuffer(r, desc)) {
        bolan_renderer_accept(r, CALL_DRAW);
        if (bolan_renderer_resize(r, desc->width, desc->height) == BOLAN_OK) draw_frame(r, desc);
    }
    bolan_renderer_leave(r);
}

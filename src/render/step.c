// SPDX-License-Identifier: MIT
// A step: what every view of it shares, and the uniform block Frame.
#include <math.h>

#include "bolan/earth.h"

#include "frame.h"
#include "shared/constants.glsl"
#include "shared/foam.glsl"

#define BORE_DEPTH 0.71 // of the water under a bore, in heights of the bore

float bolan_reduced(double x, double period) { return (float)(x - period * floor(x / period)); }

double bolan_sea_peak_period(const bolan_sea_summary *sea) { return sea->tp > 0.0 ? sea->tp : 8.0; }

double bolan_sea_peak_length(const bolan_sea_summary *sea) {
    const double period = bolan_sea_peak_period(sea);
    return BOLAN_GRAVITY * period * period / (2.0 * BOLAN_PI);
}

double bolan_sea_surf_height(const bolan_sea_summary *sea) { return fmin(fmax(sea->hs, 0.25), 4.0); }

bolan_dvec2 bolan_frame_drift_at(const frame *f, double time) {
    if (f->sea == NULL) return (bolan_dvec2){0.0, 0.0};
    const bolan_sea_state *state = &bolan_sea_get_desc(f->sea)->sea_state;
    return (bolan_dvec2){state->current_x * time, state->current_y * time};
}

bolan_dvec2 bolan_frame_drift(const frame *f) { return bolan_frame_drift_at(f, f->time); }

// Tiles of a pattern that have passed at so many a second.
static double tiles_passed(const frame *f, double speed) {
    const double period = f->sea != NULL ? bolan_sea_get_loop(f->sea).period : 0.0;
    return f->time * (period > 0.0 ? round(speed * period) / period : speed);
}

// share: of the wind speed.
static bolan_dvec2 drift_with_wind(const frame *f, double share) {
    const double speed = share * (double)f->block.wind_speed / FOAM_BROADEST;
    return (bolan_dvec2){FOAM_BROADEST * tiles_passed(f, speed * cos(f->wind_to)),
                         FOAM_BROADEST * tiles_passed(f, speed * sin(f->wind_to))};
}

bolan_dvec2 bolan_frame_foam_drift(const frame *f) { return drift_with_wind(f, FOAM_DRIFT); }

bolan_dvec2 bolan_frame_eddy_drift(const frame *f) { return drift_with_wind(f, EDDY_DRIFT); }

double bolan_frame_windrow_drift(const frame *f) {
    return tiles_passed(f, FOAM_DRIFT * (double)f->block.wind_speed * (double)f->block.streak_scale.y);
}

bolan_vec2 bolan_frame_streaks(bolan_dvec3 eye, double wind_to, bolan_vec2 scale) {
    const double c = cos(wind_to), s = sin(wind_to);
    return (bolan_vec2){bolan_reduced((c * eye.y - s * eye.x) * (double)scale.x, 1.0),
                        bolan_reduced((c * eye.x + s * eye.y) * (double)scale.y, 1.0)};
}

static bolan_vec3 direction_to_sun(const bolan_sky *sky) {
    const double azimuth = bolan_radians(sky->sun_azimuth_deg), elevation = bolan_radians(sky->sun_elevation_deg);
    return bolan_v3((float)(sin(azimuth) * cos(elevation)), (float)(cos(azimuth) * cos(elevation)),
                    (float)sin(elevation));
}

// Radiance in twilight falls by six orders of magnitude, below what half floats hold: so the unit of radiance falls
// with it, in steps of a degree.
float bolan_radiance_unit(float sun_height) {
    const double below = -bolan_degrees(asin(fmax(-1.0, fmin(1.0, (double)sun_height))));
    return below <= 0.0 ? 1.0f : (float)pow(10.0, floor(below) / 3.0);
}

// Bores run with the speed of shallow water, one in each period of the sea.
static void fill_surf(frame *f, const bolan_sea_summary *sea) {
    const double period = fmin(fmax(bolan_sea_peak_period(sea), 3.0), 12.0);
    const double length = period * sqrt(BOLAN_GRAVITY * BORE_DEPTH * bolan_sea_surf_height(sea));
    const double to = bolan_compass_from_to_math(sea->from_deg);
    f->surf_wave = (bolan_dvec2){cos(to) / length, sin(to) / length};
    f->surf_periods = f->time / period;
    f->block.surf_wave = (bolan_vec2){(float)f->surf_wave.x, (float)f->surf_wave.y};
    f->block.surf_time = bolan_reduced(f->surf_periods, 1.0);
}

// No haze is haze that neither dims nor shines.
static void fill_haze(frame *f) {
    const bolan_haze *h = &f->lighting.haze;
    const bool given = h->kind == BOLAN_HAZE_GIVEN;
    f->block.haze_given = h->kind != BOLAN_HAZE_AIR ? 1.0f : 0.0f;
    f->block.given_haze_radiance =
        given ? bolan_v3_scale(h->radiance, f->block.radiance_unit) : bolan_v3(0.0f, 0.0f, 0.0f);
    f->block.given_haze_extinction = given ? h->extinction : bolan_v3(0.0f, 0.0f, 0.0f);
}

static void fill_water(frame *f) {
    frame_block *b = &f->block;
    b->water_reflectance = f->water.optics.deep;
    b->water_index = f->water.optics.index;
    b->water_attenuation = f->water.optics.kd;
    b->foam_strength = (float)f->water.foam;
    b->water_level = (float)f->level;
    b->caustic_strength = f->caustics.strength;
    b->caustic_turn = f->caustics.turn;
    b->caustic_travel = f->caustics.travel;
}

void bolan_frame_fill(frame *f) {
    const bolan_sky *sky = &f->lighting.sky;
    const bolan_sea_state *state = &bolan_sea_get_desc(f->sea)->sea_state;
    frame_block *b = &f->block;
    f->time = bolan_sea_time(f->sea);
    const bool own_sky = f->lighting.environment.cube == 0;
    f->sun_direction = own_sky ? direction_to_sun(sky) : f->lighting.environment.sun_direction;
    f->wind_to = bolan_compass_from_to_math(state->wind_from_deg);
    b->sun_direction = f->sun_direction;
    b->radiance_unit = own_sky ? bolan_radiance_unit(f->sun_direction.z) : 1.0f;
    b->wind_direction = (bolan_vec2){(float)cos(f->wind_to), (float)sin(f->wind_to)};
    b->wind_speed = (float)state->wind_speed;
    const double gone = state->wind_speed * f->time; // gusts go with the wind
    b->gust_travel = (bolan_vec2){bolan_reduced(gone * cos(f->wind_to), WORLD_WRAP_WIDE),
                                  bolan_reduced(gone * sin(f->wind_to), WORLD_WRAP_WIDE)};
    b->cloud_cover = own_sky ? (float)sky->cloud_cover : 0.0f;
    b->cloud_base = (float)sky->cloud_base;
    b->visibility = (float)fmin(sky->visibility, spray_visibility(state->wind_speed));
    b->earth_radius = (float)BOLAN_EARTH_RADIUS;
    const double across = 1.0 / (WINDROWS * windrow_distance(state->wind_speed));
    b->streak_scale = (bolan_vec2){(float)across, (float)(across / WINDROW_STRETCH)};
    fill_haze(f);
    fill_surf(f, bolan_sea_get_summary(f->sea));
    fill_water(f);
}

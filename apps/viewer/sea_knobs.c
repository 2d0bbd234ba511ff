// SPDX-License-Identifier: MIT
// Wind, fetch and swell from a sea's wave systems, and back.
#include "sea_knobs.h"

#include "bolan/math.h"

#include <math.h>

// The wind sea is the first system with a wind speed, the swell the first without. -1: none.
static int find_system(const bolan_sea_state *state, bool wind_sea) {
    for (uint32_t i = 0; i < state->system_count; ++i)
        if ((state->systems[i].wind_speed > 0.0) == wind_sea) return (int)i;
    return -1;
}

// The fetch [km] at which this wind makes a sea of this peak: bisection, since the peak falls with the fetch.
static float find_fetch(double wind_speed, double peak_omega) {
    double low = log(SEA_KNOBS_FETCH_MIN * 1e3), high = log(SEA_KNOBS_FETCH_MAX * 1e3);
    for (int i = 0; i < 40; ++i) {
        double middle = 0.5 * (low + high);
        bolan_sea_state s = bolan_sea_state_from_wind(wind_speed, 0.0, exp(middle));
        if (s.system_count > 0 && s.systems[0].peak_omega > peak_omega * (1.0 + 1e-9))
            low = middle;
        else
            high = middle;
    }
    return (float)(exp(high) * 1e-3);
}

static void read_swell(sea_knobs *k, const bolan_wave_system *swell) {
    k->swell = true;
    k->swell_height = (float)swell->hs;
    k->swell_period = (float)(2.0 * BOLAN_PI / swell->peak_omega);
    k->swell_from = (float)bolan_wrap_degrees(swell->from_deg);
    k->swell_spread = (float)swell->spread_s;
}

sea_knobs sea_knobs_read(const bolan_sea_desc *desc, bool measured) {
    const bolan_sea_state *s = &desc->sea_state;
    sea_knobs k = {.measured = measured,
                   .wind_speed = (float)s->wind_speed,
                   .wind_from = (float)bolan_wrap_degrees(s->wind_from_deg),
                   .fetch_km = 300.0f,
                   .swell_height = 1.5f,
                   .swell_period = 11.0f,
                   .swell_from = 270.0f,
                   .swell_spread = 40.0f,
                   .choppiness = (float)desc->choppiness,
                   .foam_decay = (float)desc->foam_decay,
                   .second_order = desc->order > 1,
                   .seed = (int)(desc->seed & 0x7fffffff),
                   .resolution = (int)desc->resolution,
                   .cascades = (int)desc->fft.cascade_count};
    int wind_sea = find_system(s, true), swell = find_system(s, false);
    if (wind_sea >= 0) k.fetch_km = find_fetch(s->systems[wind_sea].wind_speed, s->systems[wind_sea].peak_omega);
    if (swell >= 0) read_swell(&k, &s->systems[swell]);
    return k;
}

static void remove_system(bolan_sea_state *state, int index) {
    if (index < 0) return;
    for (uint32_t i = (uint32_t)index; i + 1 < state->system_count; ++i) state->systems[i] = state->systems[i + 1];
    state->system_count--;
}

static void write_wind(const sea_knobs *k, bolan_sea_state *state) {
    state->wind_speed = k->wind_speed;
    state->wind_from_deg = k->wind_from;
    if (k->measured) return;
    remove_system(state, find_system(state, true));
    bolan_sea_state fresh = bolan_sea_state_from_wind(k->wind_speed, k->wind_from, 1e3 * k->fetch_km);
    if (fresh.system_count > 0 && state->system_count < BOLAN_MAX_WAVE_SYSTEMS)
        state->systems[state->system_count++] = fresh.systems[0];
}

static void write_swell(const sea_knobs *k, bolan_sea_state *state) {
    remove_system(state, find_system(state, false));
    // Cannot fail: the ranges of the sliders lie inside those of the sea, and a system has just been removed.
    if (k->swell)
        (void)bolan_sea_state_add_swell(state, k->swell_height, k->swell_period, k->swell_from, k->swell_spread);
}

void sea_knobs_write(const sea_knobs *k, unsigned changed, bolan_sea_desc *desc) {
    if (changed & SEA_KNOBS_WIND) write_wind(k, &desc->sea_state);
    if (changed & SEA_KNOBS_SWELL) write_swell(k, &desc->sea_state);
    if ((changed & SEA_KNOBS_LAYOUT) == 0) return;
    desc->choppiness = k->choppiness;
    desc->foam_decay = k->foam_decay;
    desc->order = k->second_order ? 2 : 1;
    desc->seed = (uint64_t)k->seed;
    desc->resolution = (uint32_t)k->resolution;
    desc->fft.cascade_count = (uint32_t)k->cascades;
}

// SPDX-License-Identifier: MIT
// The default scene, its wind, its technique and its sea.
#include "bolan/scene.h"

#include <string.h>

bolan_scene bolan_scene_default(void) {
    bolan_scene scene;
    memset(&scene, 0, sizeof scene); // also strings and padding, so that equal scenes have equal bytes
    for (const bolan_param_group *g = bolan_scene_groups; g->table; g++)
        if (g->capacity == 0) bolan_params_default(g->table, (char *)&scene + g->offset);
    memcpy(scene.name, "default", sizeof "default");
    scene.technique = bolan_technique_ocean;
    scene.sea = bolan_sea_desc_default();
    scene.spectrum = bolan_spectrum_options_default();
    return scene;
}

static bolan_sea_state sea_of_kind(bolan_spectrum_kind kind, double wind_speed, double from_deg, double fetch) {
    switch (kind) {
    case BOLAN_SPECTRUM_PHILLIPS: return bolan_sea_state_from_phillips(wind_speed, from_deg);
    case BOLAN_SPECTRUM_DONELAN: return bolan_sea_state_from_donelan(wind_speed, from_deg, fetch);
    case BOLAN_SPECTRUM_ELFOUHAILY: return bolan_sea_state_from_elfouhaily(wind_speed, from_deg, fetch);
    case BOLAN_SPECTRUM_PIERSON_MOSKOWITZ: return bolan_sea_state_from_wind(wind_speed, from_deg, HUGE_VAL);
    default: return bolan_sea_state_from_wind(wind_speed, from_deg, fetch);
    }
}

static bolan_sea_state wind_sea_of(const bolan_scene *scene, double wind_speed, double from_deg) {
    const int own = scene->technique.wind_spectrum;
    const bolan_spectrum_kind kind = own < 0 ? scene->wind_spectrum : (bolan_spectrum_kind)own;
    bolan_sea_state sea_state = sea_of_kind(kind, wind_speed, from_deg, scene->fetch);
    if (kind == BOLAN_SPECTRUM_TMA && sea_state.system_count > 0) sea_state.systems[0].kind = BOLAN_SPECTRUM_TMA;
    if (scene->spectrum_path[0] != '\0' || !scene->wind_sea) sea_state.system_count = 0;
    return sea_state;
}

void bolan_scene_set_wind(bolan_scene *scene, double wind_speed, double from_deg) {
    BOLAN_ASSERT(scene);
    const bolan_sea_state old = scene->sea.sea_state;
    bolan_sea_state next = wind_sea_of(scene, wind_speed, from_deg);
    next.depth = old.depth;
    next.measured = old.measured;
    next.current_x = old.current_x;
    next.current_y = old.current_y;
    next.frame = old.frame;
    const bool has_wind_sea = scene->wind_sea && old.system_count > 0 && old.systems[0].wind_speed > 0.0;
    for (uint32_t i = has_wind_sea; i < old.system_count && next.system_count < BOLAN_MAX_WAVE_SYSTEMS; i++)
        next.systems[next.system_count++] = old.systems[i];
    scene->sea.sea_state = next;
}

static int spectrum_of(const bolan_scene *scene, const bolan_technique *technique) {
    return technique->wind_spectrum < 0 ? (int)scene->wind_spectrum : technique->wind_spectrum;
}

void bolan_scene_set_technique(bolan_scene *scene, const bolan_technique *technique) {
    BOLAN_ASSERT(scene && technique);
    const bool same = spectrum_of(scene, &scene->technique) == spectrum_of(scene, technique);
    scene->technique = *technique;
    scene->sea.waves = technique->waves;
    const bolan_sea_state *state = &scene->sea.sea_state;
    if (!same) bolan_scene_set_wind(scene, state->wind_speed, state->wind_from_deg);
}

bolan_sea_desc bolan_scene_sea_desc(const bolan_scene *scene) {
    BOLAN_ASSERT(scene);
    bolan_sea_desc desc = scene->sea;
    if (scene->look.paper) {
        desc.exp_cosine.sharpness = 1.0;
        desc.cosines.split = BOLAN_SPLIT_EQUAL_WIDTH;
    }
    return desc;
}

// SPDX-License-Identifier: MIT
// The default scene, and the wind of a scene.
#include "bolan/scene.h"

#include <string.h>

bolan_scene bolan_scene_default(void) {
    bolan_scene scene;
    memset(&scene, 0, sizeof scene); // the strings and the padding too: equal scenes are equal bytes
    memcpy(scene.name, "default", sizeof "default");
    scene.technique = bolan_technique_ocean;
    scene.look = bolan_look_default();
    scene.sea = bolan_sea_desc_default();
    scene.fetch = 200e3;
    scene.wind_spectrum = BOLAN_SPECTRUM_JONSWAP;
    scene.spectrum = bolan_spectrum_options_default();
    scene.camera.position = bolan_dv3(0.0, 0.0, 3.0);
    scene.camera.fov_deg = 50.0;
    scene.sky.sun_azimuth_deg = 220.0;
    scene.sky.sun_elevation_deg = 35.0;
    scene.sky.visibility = 40e3;
    scene.sky.cloud_cover = 0.3;
    scene.sky.cloud_base = 1200.0;
    scene.sky.cloud_seed = 1;
    scene.water.type = BOLAN_JERLOV_IB;
    scene.water.foam = 1.0;
    scene.terrain.kind = BOLAN_GROUND_NONE;
    scene.terrain.island = bolan_island_desc_default();
    scene.terrain.raster = bolan_raster_desc_default();
    return scene;
}

bolan_raster_desc bolan_raster_desc_default(void) {
    const double none = (double)NAN;
    return (bolan_raster_desc){
        .latitude = none, .longitude = none, .radius = 150e3, .vertical_scale = none, .nodata_value = none};
}

static bolan_sea_state wind_sea_of(const bolan_scene *scene, double wind_speed, double from_deg) {
    const int own = scene->technique.wind_spectrum;
    const bolan_spectrum_kind kind = own < 0 ? scene->wind_spectrum : (bolan_spectrum_kind)own;
    const bool developed = kind == BOLAN_SPECTRUM_PIERSON_MOSKOWITZ;
    bolan_sea_state sea_state =
        kind == BOLAN_SPECTRUM_PHILLIPS
            ? bolan_sea_state_from_phillips(wind_speed, from_deg)
            : bolan_sea_state_from_wind(wind_speed, from_deg, developed ? HUGE_VAL : scene->fetch);
    if (kind == BOLAN_SPECTRUM_TMA && sea_state.system_count > 0) sea_state.systems[0].kind = BOLAN_SPECTRUM_TMA;
    if (scene->spectrum_path[0] != '\0') sea_state.system_count = 0;
    return sea_state;
}

void bolan_scene_set_wind(bolan_scene *scene, double wind_speed, double from_deg) {
    BOLAN_ASSERT(scene);
    const bolan_sea_state old = scene->sea.sea_state;
    bolan_sea_state next = wind_sea_of(scene, wind_speed, from_deg);
    next.depth = old.depth;
    next.measured = old.measured;
    for (uint32_t i = 0; i < old.system_count && next.system_count < BOLAN_MAX_WAVE_SYSTEMS; i++)
        if (!(old.systems[i].wind_speed > 0.0)) next.systems[next.system_count++] = old.systems[i];
    scene->sea.sea_state = next;
}

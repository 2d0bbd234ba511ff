// SPDX-License-Identifier: MIT
// A sea without an image: make it from a wind, step it, query its height at three places.
#include "bolan/query.h"

#include <stdio.h>

int main(void) {
    bolan_sea_desc desc = bolan_sea_desc_default();
    desc.sea_state = bolan_sea_state_from_wind(10.0, 240.0, 300e3); // m/s, degrees it blows FROM, metres of fetch

    bolan_sea *sea = NULL;
    if (bolan_sea_create(&desc, &sea) != BOLAN_OK) return 1; // one sentence in the log has said why
    const bolan_sea_summary summary = bolan_sea_state_summary(&desc.sea_state);
    printf("significant wave height %.2f m, peak period %.1f s\n", summary.hs, summary.tp);

    bolan_water water = bolan_water_default(); // the bundle that queries read: here the sea alone, without a sea bed
    water.sea = sea;
    const bolan_dvec2 places[3] = {{0.0, 0.0}, {25.0, 0.0}, {1e6, -1e6}}; // metres east and north
    printf("  time [s]    here [m]    25 m east [m]    far away [m]\n");
    for (int i = 0; i <= 8; i++) {
        const double time = 0.5 * i;
        float height[3];
        bolan_sea_step(sea, time);
        bolan_query_heights(&water, places, 3, height);
        printf("%10.1f %11.3f %16.3f %15.3f\n", time, (double)height[0], (double)height[1], (double)height[2]);
    }
    bolan_sea_destroy(&sea);
    return 0;
}

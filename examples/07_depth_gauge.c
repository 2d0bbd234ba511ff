// SPDX-License-Identifier: MIT
// An underwater robot in a seaway: the current that pushes it, and what its depth gauge reads. Prints CSV:
//
//     07_depth_gauge > gauge.csv
//
// time, true depth below the mean level, what a pressure gauge takes for the depth, and the velocity of the water.
#include "bolan/query.h"

#include <stdio.h>

static const double DEPTH = 6.0, SPEED = 1.0; // of the robot [m], [m/s]; it goes east

int main(void) {
    bolan_sea_desc desc = bolan_sea_desc_default();
    desc.sea_state = bolan_sea_state_from_wind(11.0, 250.0, 150e3);
    desc.sea_state.depth = 25.0;
    bolan_sea *sea = NULL;
    bolan_flow *flow = NULL;
    if (bolan_sea_create(&desc, &sea) != BOLAN_OK || bolan_flow_create(sea, &flow) != BOLAN_OK) {
        bolan_sea_destroy(&sea);
        return 1; // the log has said why
    }
    bolan_water water = bolan_water_default();
    water.sea = sea;
    water.flow = flow;

    const double weight = BOLAN_SEA_WATER_DENSITY * BOLAN_GRAVITY; // of a cubic metre of water [N]
    printf("time,depth,gauge,east,north,up\n");
    for (double time = 0.0; time <= 20.0; time += 0.5) {
        bolan_sea_step(sea, time);
        bolan_flow_step(flow, sea); // after every step of the sea that is asked about
        const bolan_dvec3 robot = {SPEED * time, 0.0, water.level - DEPTH};
        bolan_kinematics k;
        bolan_query_below(&water, NULL, &robot, 1, &k);
        const double pressure = weight * DEPTH + (double)k.pressure; // hydrostatic and dynamic, over that of the air
        printf("%.1f,%.2f,%.3f,%.3f,%.3f,%.3f\n", time, DEPTH, pressure / weight, (double)k.velocity.x,
               (double)k.velocity.y, (double)k.velocity.z);
    }
    bolan_flow_destroy(&flow);
    bolan_sea_destroy(&sea);
    return 0;
}

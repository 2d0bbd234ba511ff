// SPDX-License-Identifier: MIT
// The water under a hull: a grid of points that moves with a ship, queried in one batch each step. Prints CSV:
//
//     02_query > hull.csv
//
// time, mean height under the hull, pitch and roll of the plane that fits the water best, and the steepest slope.
#include "bolan/query.h"

#include <stdio.h>

enum { ALONG = 21, ACROSS = 7, POINTS = ALONG * ACROSS };
static const double LENGTH = 60.0, BEAM = 12.0;  // of the hull [m]
static const double SPEED = 6.0, HEADING = 45.0; // [m/s], compass [deg]

typedef struct hull_water {
    double height;      // mean [m]
    double pitch, roll; // of the plane: bow up, starboard down [deg]
    double steepest;    // slope of the water itself
} hull_water;

// Places of the grid, in the ship's axes: forward and to starboard, from the middle.
static double forward_of(int i) { return LENGTH * (i % ALONG / (ALONG - 1.0) - 0.5); }
static double starboard_of(int i) { return BEAM * (i / ALONG / (ACROSS - 1.0) - 0.5); }

static void place_points(double time, bolan_dvec2 *xy) {
    const double north = cos(bolan_radians(HEADING)), east = sin(bolan_radians(HEADING));
    for (int i = 0; i < POINTS; i++) {
        const double ahead = SPEED * time + forward_of(i), aside = starboard_of(i);
        xy[i] = (bolan_dvec2){ahead * east + aside * north, ahead * north - aside * east};
    }
}

// The grid is symmetric, so least squares needs no matrix: each slope is a ratio of two sums.
static hull_water fit(const bolan_query_point *p) {
    hull_water w = {0};
    double fh = 0.0, ff = 0.0, sh = 0.0, ss = 0.0;
    for (int i = 0; i < POINTS; i++) {
        const double f = forward_of(i), s = starboard_of(i), h = (double)p[i].height;
        w.height += h / POINTS;
        fh += f * h, ff += f * f, sh += s * h, ss += s * s;
        w.steepest = fmax(w.steepest, sqrt(1.0 - pow((double)p[i].normal.z, 2.0)) / (double)p[i].normal.z);
    }
    w.pitch = bolan_degrees(atan(fh / ff));
    w.roll = -bolan_degrees(atan(sh / ss));
    return w;
}

int main(void) {
    bolan_sea_desc desc = bolan_sea_desc_default();
    desc.sea_state = bolan_sea_state_from_wind(14.0, 225.0, 200e3);
    if (bolan_sea_state_add_swell(&desc.sea_state, 1.5, 12.0, 300.0, 50.0) != BOLAN_OK) return 1;
    bolan_sea *sea = NULL;
    if (bolan_sea_create(&desc, &sea) != BOLAN_OK) return 1;

    bolan_dvec2 xy[POINTS];
    bolan_query_point answers[POINTS];
    bolan_water water = bolan_water_default();
    water.sea = sea;
    printf("time,height,pitch,roll,steepest\n");
    for (double time = 0.0; time <= 20.0; time += 0.5) {
        bolan_sea_step(sea, time);
        place_points(time, xy);
        bolan_query_surface(&water, xy, POINTS, answers);
        const hull_water w = fit(answers);
        printf("%.1f,%.3f,%.2f,%.2f,%.3f\n", time, w.height, w.pitch, w.roll, w.steepest);
    }
    bolan_sea_destroy(&sea);
    return 0;
}

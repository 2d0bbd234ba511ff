// SPDX-License-Identifier: MIT
// A physics thread beside a loop of frames: a fork of the sea is stepped at 200 Hz and queried for the water at a hull,
// while the first sea is stepped at 60 Hz for drawing. Prints CSV:
//
//     06_physics_thread > hull.csv
//
// time, mean height under the hull, bow's height over the stern's, mean normal. The last lines on stderr compare all
// answers with those of one thread alone: they are the same bits.
#include "bolan/query.h"

#include <pthread.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

enum { RATE = 200, FRAMES = 60, SECONDS = 2, TICKS = RATE * SECONDS, POINTS = 9 };

// The hull: three points along, three across, at rest at the origin [m].
static const bolan_dvec2 hull[POINTS] = {{-4, -15}, {0, -15}, {4, -15}, {-4, 0}, {0, 0},
                                         {4, 0},    {-4, 15}, {0, 15},  {4, 15}};

typedef struct physics {
    bolan_sea *sea; // this thread's own fork
    bool paced;     // true: a tick begins when its time has come
    bolan_query_point answers[TICKS][POINTS];
} physics;

static void sleep_until(const struct timespec *start, double seconds) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    const double passed = (double)(now.tv_sec - start->tv_sec) + 1e-9 * (double)(now.tv_nsec - start->tv_nsec);
    if (passed >= seconds) return; // late: on a slow machine the clock of the sea falls behind, its answers stay
    nanosleep(&(struct timespec){.tv_nsec = (long)(1e9 * (seconds - passed))}, NULL);
}

// The time of a tick is a multiple of 1/200 s, not the time of a clock, so that results do not depend on the machine.
static void *run_physics(void *context) {
    physics *p = context;
    bolan_water water = bolan_water_default();
    water.sea = p->sea;
    struct timespec start;
    clock_gettime(CLOCK_MONOTONIC, &start);
    for (int i = 0; i < TICKS; i++) {
        const double time = (double)i / RATE;
        if (p->paced) sleep_until(&start, time);
        bolan_sea_step(p->sea, time);
        bolan_query_surface(&water, hull, POINTS, p->answers[i]);
    }
    return NULL;
}

// Where a program draws. This one reads the water under its camera.
static double run_frames(bolan_sea *sea) {
    struct timespec start;
    clock_gettime(CLOCK_MONOTONIC, &start);
    bolan_water water = bolan_water_default();
    water.sea = sea;
    double highest = 0.0;
    for (int i = 0; i < FRAMES * SECONDS; i++) {
        const double time = (double)i / FRAMES;
        sleep_until(&start, time);
        bolan_sea_step(sea, time);
        float height;
        bolan_query_heights(&water, &(bolan_dvec2){50.0, -80.0}, 1, &height);
        highest = fmax(highest, (double)height);
    }
    return highest;
}

static void print_answers(const physics *p) {
    printf("time,height,bow_over_stern,normal_x,normal_y,normal_z\n");
    for (int i = 0; i < TICKS; i += RATE / 10) {
        const bolan_query_point *a = p->answers[i];
        double height = 0.0;
        bolan_vec3 normal = {0.0f, 0.0f, 0.0f};
        for (int k = 0; k < POINTS; k++) {
            height += (double)a[k].height / POINTS;
            normal = bolan_v3_add(normal, a[k].normal);
        }
        normal = bolan_v3_normalize(normal);
        printf("%.2f,%.3f,%.3f,%.4f,%.4f,%.4f\n", (double)i / RATE, height, (double)(a[7].height - a[1].height),
               (double)normal.x, (double)normal.y, (double)normal.z);
    }
}

int main(void) {
    static physics beside, alone; // the answers are large for a stack
    bolan_sea_desc desc = bolan_sea_desc_default();
    desc.sea_state = bolan_sea_state_from_wind(12.0, 225.0, 200e3);
    desc.resolution = 64; // fast enough for 200 Hz on a small machine; the long waves are those of a finer sea
    bolan_sea *drawn = NULL;
    if (bolan_sea_create(&desc, &drawn) != BOLAN_OK) return 1;
    pthread_t thread;
    int status = 1;
    if (bolan_sea_fork(drawn, &beside.sea) != BOLAN_OK || bolan_sea_fork(drawn, &alone.sea) != BOLAN_OK) goto done;

    beside.paced = true;
    if (pthread_create(&thread, NULL, run_physics, &beside) != 0) goto done;
    const double highest = run_frames(drawn);
    pthread_join(thread, NULL);
    print_answers(&beside);

    run_physics(&alone); // on this thread, with nothing beside it, as fast as it goes
    const bool same = memcmp(beside.answers, alone.answers, sizeof beside.answers) == 0;
    fprintf(stderr, "%d frames, highest water under the camera %.2f m; %d ticks, %s\n", FRAMES * SECONDS, highest,
            TICKS, same ? "the same bits as on one thread" : "OTHER BITS than on one thread");
    status = same ? 0 : 1;
done:
    bolan_sea_destroy(&beside.sea);
    bolan_sea_destroy(&alone.sea);
    bolan_sea_destroy(&drawn);
    return status;
}

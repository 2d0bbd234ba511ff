// SPDX-License-Identifier: MIT
// The inside of a sea. Private to src/waves.
//
// A sea is two parts, so that several threads can show several times of one sea:
//
//     bolan_sea "a"  time, serial, fields ──┐
//     bolan_sea "b"  time, serial, fields ──┼──► sea_shared   desc, spectrum tables, slope table, lift, thresholds
//     bolan_sea "c"  time, serial, fields ──┘                 counted: `owners` is 3 here
//
// sea_shared is written during bolan_sea_create() alone. Afterwards every thread may read it without a lock, and only
// `owners` changes, atomically; the last sea that is destroyed frees it. What tables and fields hold is the wave
// model's business (model.h).
//
// A step only notes the time. The first reader afterwards makes the fields (bolan_sea_fields()), so a sea that nobody
// reads, because a GPU synthesises it, costs nothing:
//
//     step            time, tick, since, foam_from; made.state = SEA_STALE
//     first reader    SEA_STALE -> SEA_MAKING (compare and swap) ... makes the fields ... -> SEA_FRESH (release)
//     other readers   wait for SEA_FRESH (acquire)
//
// The foam memory is a function of two ticks, `foam_from` and `tick`, so it does not matter how many steps nobody read.
#ifndef BOLAN_WAVES_SEA_H
#define BOLAN_WAVES_SEA_H

#include "bolan/waves.h"
#include "spectrum/spectrum_eval.h"

#include <stdatomic.h>

// ---- memory ---------------------------------------------------------------------------------------------------------

enum { SEA_MAX_BLOCKS = 28 };
typedef struct sea_memory {
    uint32_t count;
    struct {
        void *at;
        size_t bytes;
    } block[SEA_MAX_BLOCKS];
} sea_memory;
// Zeroed memory that lives as long as its owner; NULL (logged) when there is none.
void *bolan_sea_reserve(sea_memory *memory, size_t bytes);
// bolan_allocate() that logs when there is none.
void *bolan_sea_borrow(size_t bytes);

// ---- a sea ----------------------------------------------------------------------------------------------------------

// What a step makes at each rest point; the derivatives are of the displacement. dxy is dDx/dy.
enum { FIELD_HEIGHT, FIELD_DX, FIELD_DY, FIELD_SLOPE_X, FIELD_SLOPE_Y, FIELD_DXX, FIELD_DYY, FIELD_DXY, SEA_FIELDS };

// By log2 of the spacing of a grid: level l > 0 is that of finest * 2^(l / LIFT_PER_OCTAVE), level 0 of a point. See
// lift.c.
enum { LIFT_LEVELS = 49 };
#define LIFT_PER_OCTAVE 4.0
typedef struct sea_lift {
    double finest;             // spacing [m] below which nothing fades; 0 without waves
    double level[LIFT_LEVELS]; // [m]
} sea_lift;

// A part of the waves that shallow water attenuates as one: a cascade, or all waves of a sum.
typedef struct sea_band {
    double variance; // expected [m2]
    sea_lift lift;
} sea_band;

// bolan_sea_place_read() with this warp.
bolan_dvec2 bolan_sea_warped(const bolan_sea_warp *warp, double x, double y, double gradient[4]);

struct sea_model;
struct slope_map;

// What all forks of a sea read. Nothing changes after creation but `owners`.
typedef struct sea_shared {
    atomic_uint owners; // seas that point here
    uint64_t id;
    bolan_sea_desc desc; // defaults resolved; without the measured spectrum
    const struct sea_model *model;
    void *tables;                                     // of the model
    double period;                                    // of the loop [s]; 0: the sea does not repeat
    double tick, loop_ticks, memory_ticks, tick_loss; // of the foam memory [s], of a loop, remembered, lost: see foam.c
    bolan_sea_warp warp;
    uint32_t frames;   // of a loop of still frames; 0: the sea moves on all the time
    uint32_t cascades; // 0 with a sum
    uint32_t components;
    uint32_t bands;
    sea_band band[BOLAN_MAX_CASCADES];
    bolan_bound_weights bound[BOLAN_MAX_CASCADES]; // of cascades; read with desc.order 2 alone
    double bound_keep;                             // what they are lowered to: 1 where theory holds
    double lift;                                   // of all bands for a point, added to every height [m]
    double slope_ratio;                            // of the slope variance to k^2 times the variance: 1 for cosines
    double rest_slope[3];                          // slope covariance of the waves shorter than all those of the model
    struct slope_map *slope_map;                   // see slopes.c
    float *slope_table;
    double foam_threshold;
    double breaker_threshold;
    bolan_sea_summary summary; // of the sea state, limited
    double limit;              // factor on the height that the sea state asks for
    bool is_measured;          // it has a measured spectrum
    char record_time[32];      // of that spectrum, or empty
    sea_memory memory;         // all of the tables
} sea_shared;

// What the fields hold at present.
enum { SEA_STALE, SEA_MAKING, SEA_FRESH };
typedef struct sea_made {
    atomic_uint state; // SEA_STALE ...
    atomic_uint fine;  // likewise of the fine waves
    bool any;          // the foam memory was ever made
    bool empty;        // it holds nothing yet
    double from;       // the sea's foam_from when it was begun
    double tick;       // the last tick in it
} sea_made;

struct bolan_sea {
    sea_shared *shared;
    uint64_t serial;
    double time;
    bool stepped;     // `time` and the members below were set
    uint32_t frame;   // of the loop
    double shown;     // time of the waves [s], as sea_model.shown_time() has it
    double tick;      // number of the last tick of the foam memory
    double since;     // how long before `time` that was [s]
    double foam_from; // the tick at which nothing was remembered
    sea_made *made;   // own_made, which readers write, though the sea is constant to them
    sea_made own_made;
    void *fields;      // of the model
    sea_memory memory; // all of the fields
};

// The plane that the tiles of a sea are read over.
const bolan_sea_warp *bolan_sea_warp_of(const bolan_sea *sea);
// The bands of a sea, bolan_sea_lift() index by index.
const sea_band *bolan_sea_bands(const bolan_sea *sea, uint32_t *count);

// ---- current --------------------------------------------------------------------------------------------------------

// How far the water has moved from time 0 to `time` [m].
bolan_dvec2 bolan_sea_drift(const sea_shared *shared, double time);
// ---- time -----------------------------------------------------------------------------------------------------------

// The most that a pinch leaves in the foam memory: water that has folded.
#define SEA_MOST_FOAM 3.0f
// What the model makes at once.
typedef struct sea_instant {
    double shown;     // whose fields [s], as sea_model.shown_time() has it
    bool tick;        // nothing but the foam memory of a tick
    float keep, lose; // factor on the foam memory of the last tick, and what it loses besides
    double at;        // number of the tick, or between two, to which foam has drifted
} sea_instant;
// Sets the ticks; `period` is known.
void bolan_sea_foam_prepare(sea_shared *shared);
// Numbers of seas and of their fields, one row for both: never 0, never twice.
uint64_t bolan_sea_next_number(void);

// ---- waves ----------------------------------------------------------------------------------------------------------

// One mode of the kept half plane, as the tables hold it.
typedef struct sea_mode {
    double kx, ky;                  // world wave vector [rad/m]
    double turns;                   // [1/s]
    double inverse_k;               // coth(kh) / |k|
    double re, im;                  // h0(k)
    double back_re, back_im;        // conj(h0(-k))
    double expected, expected_back; // variance of the waves that go along k and along -k [m2]
    bool paired;                    // it stands for -k as well; false where -k is an entry of its own
} sea_mode;

// A uniform hash (the finaliser of SplitMix64).
uint64_t bolan_sea_mix(uint64_t x);

// ---- lift -----------------------------------------------------------------------------------------------------------

// Of a cascade's sample distance, or of a sum's shortest wave: a grid finer than that fades nothing.
#define LIFT_FIRST_LEVEL 0.25
// The mean of the bound waves of a wave of unit variance, whose displacement is `drift` times its height [1/m].
static inline double bolan_sea_bound_mean(const bolan_bound_weights *bound, double drift) {
    return bound->height + bound->drift * drift * drift;
}
double bolan_sea_lift_at(const sea_lift *lift, double spacing);
// Spacing [m] of a level; 0 of level 0.
double bolan_sea_lift_spacing(const sea_lift *lift, int level);

// Share of the amplitude of a cascade on a grid of that spacing [m]: it fades from 4 to 2 spacings of its longest wave.
double bolan_cascade_fade(double k_min, double length, double spacing);

// ---- samples --------------------------------------------------------------------------------------------------------

// Sums over the cascades or waves of the fields at one rest point, choppiness not applied, and what becomes of them
// with it.
//
// dyx is dDy/dx, equal to dxy where nothing is interpolated.
typedef struct sea_sums {
    double height, dx, dy, sx, sy, dxx, dyy, dxy, dyx, foam;
} sea_sums;
bolan_sea_sample bolan_sea_displaced(const sea_sums *sums, double choppiness);

// Height and slope of the bound waves at a rest point of a sea of order 2, whose bands have `keep` times their
// amplitudes.
void bolan_sea_bound_at(const bolan_sea *sea, bolan_dvec2 rest, const float *keep, double *height, double slope[2]);

// Where the sea is measured: SEA_MEASURED places, SEA_PLACES at a time.
enum { SEA_PLACES = 64, SEA_MEASURED = 1 << 16 };
// Place `index` in the square that the model names.
bolan_dvec2 bolan_sea_place(const sea_shared *shared, uint32_t index);
// The surface at the rest points of the places [first, first + SEA_PLACES).
void bolan_sea_sample_places(const bolan_sea *sea, uint32_t first, bolan_sea_sample out[SEA_PLACES]);

// Goes on with a digest over the bits of `count` floats.
uint64_t bolan_sea_hash_plane(uint64_t hash, const float *plane, size_t count);

// ---- steps of the creation ------------------------------------------------------------------------------------------

// Memory of slope_map and slope_table [bytes].
size_t bolan_sea_slopes_bytes(void);
// rest_slope, slope_map and slope_table. False when memory is short.
bool bolan_sea_slopes_create(sea_shared *shared);
// foam_threshold and breaker_threshold, from the fields of `sea` at a few times; leaves it at time 0. False when memory
// is short.
bool bolan_sea_whitecaps_create(bolan_sea *sea);

#endif

// SPDX-License-Identifier: MIT
// The inside of a sea. Private to src/waves.
//
// How a step goes. Each cascade has n x n modes (i, j), wave vector k = (i, j) 2 pi / length in tile axes; its height
// is real, so only j >= 0 is kept. Two parallel passes, each over strips of 16 (fft/strip.h):
//
//     rows     16 values of j at once: modes at time t -> 5 FFTs along i -> `middle`, transposed
//     columns  16 values of x at once: 8 fields from the 5 by factors of j -> 4 complex FFTs along j -> fields, halfs,
//              foam
//
// Five are enough for eight fields because a factor that depends on j alone commutes with the FFT along i:
// with u = h coth(kh)/k the rows transform h, i h, u, i u, i^2 u, and the columns multiply by j and j^2.
#ifndef BOLAN_WAVES_SEA_H
#define BOLAN_WAVES_SEA_H

#include "bolan/waves.h"
#include "fft/plan.h"
#include "spectrum/spectrum_eval.h"

enum {
    SEA_PARTS = 5,                  // transforms along i
    SEA_CELL = SEA_PARTS * FFT_ROW, // floats of `middle` for one (strip of x, j)
    SEA_MAX_STRIPS = FFT_MAX / 2 / FFT_LANES,
    SEA_FIELDS = 8,
    SEA_MAX_BLOCKS = 32,
};

// By log2 of the spacing of a grid: level l > 0 is that of finest * 2^(l / LIFT_PER_OCTAVE), level 0 of a point. See
// lift.c.
enum { LIFT_LEVELS = 49 };
#define LIFT_PER_OCTAVE 4.0
typedef struct sea_lift {
    double finest;             // spacing [m] below which nothing fades; 0 without waves
    double level[LIFT_LEVELS]; // [m]
} sea_lift;

typedef struct sea_cascade {
    uint32_t n;
    double length, angle, cosine, sine, k_min, k_max;
    double variance;     // expected, discrete sum [m2]
    double slope[3];     // expected slope covariance xx, xy, yy in world axes
    double displacement; // expected variance of dx plus that of dy [m2]
    sea_lift lift;

    uint32_t strips;                // strips of 16 j that hold modes
    uint32_t reach[SEA_MAX_STRIPS]; // in a strip modes have |i| < reach
    float *amplitude;               // [strip][i][4][16]: h = (A0 c + A1 s) + i (A2 c + A3 s), c + i s = e^{i w t}
    double *turns;                  // [strip][i][16]: w / 2 pi [1/s]
    float *inverse_k;               // [strip][i][16]: coth(kh) / |k| [m]
    float *expected;                // [strip][i][2][16]: variance of the waves k and -k [m2]
    float *k, *k2;                  // [n]: tile wave number of index i (wrapped), and its square

    float *middle;            // [strip of x][j][SEA_PARTS][row]
    float *field[SEA_FIELDS]; // height, dx, dy, slope_x, slope_y, dxx, dyy, dxy
    float *foam;
    uint16_t *displacement_half, *slope_half, *foam_half;
} sea_cascade;

enum { FIELD_HEIGHT, FIELD_DX, FIELD_DY, FIELD_SLOPE_X, FIELD_SLOPE_Y, FIELD_DXX, FIELD_DYY, FIELD_DXY };

typedef struct sea_block {
    void *memory;
    size_t bytes;
} sea_block;

struct sea_kernels;
struct sea_sum;
struct slope_map;

struct bolan_sea {
    bolan_sea_desc desc;
    uint64_t id, serial;
    double time;
    bool foam_holds;     // the foam memory belongs to `time`
    struct sea_sum *sum; // COSINES and EXP_COSINE (sum.h); NULL for the others
    uint32_t loop_frame; // TEXTURES
    uint32_t count;      // cascades; 0 with a sum
    sea_cascade cascade[BOLAN_MAX_CASCADES];
    fft_plan plan;
    const struct sea_kernels *kernels;
    uint32_t slots; // workers that a step uses at most
    float *scratch; // [slots][scratch_floats]
    size_t scratch_floats;
    double rest_slope[3]; // slope covariance of the waves shorter than all cascades
    struct slope_map *slope_map;
    float *slope_table;
    double foam_threshold;
    double lift;               // of all waves, added to every height [m]
    bolan_sea_summary summary; // of the sea state, limited
    bool is_measured;          // it has a measured spectrum
    double limit;              // factor on the height that the sea state asks for
    char record_time[32];      // of the measured spectrum, or empty
    double tp, tm02, te;       // of the discrete modes [s]
    uint32_t block_count;
    sea_block block[SEA_MAX_BLOCKS]; // all memory
};

// Omnidirectional quantities of a sea state over log k, and the roll-off of its short waves.
enum { RADIAL_COUNT = 384 };
#define RADIAL_K_MIN 1e-4
#define RADIAL_K_MAX 4e3
typedef struct sea_radial {
    double k[RADIAL_COUNT];
    double variance[RADIAL_COUNT]; // m0 of the waves longer than k [m2]
    double mss[RADIAL_COUNT];      // their slope variance
    double keep[RADIAL_COUNT];     // factor on the power at k, 1 for the long waves
} sea_radial;

// The time [s] after which every field repeats; 0: never.
double bolan_sea_period(const bolan_sea *sea);
// The time [s] that a step to `time` shows: reduced by the loop or by 2^36 s, and down to a frame of the loop with TEXTURES.
double bolan_sea_shown_time(const bolan_sea *sea, double time, uint32_t *frame);
// A uniform hash (the finaliser of SplitMix64).
uint64_t bolan_sea_mix(uint64_t x);

// Zeroed memory that lives as long as the sea; NULL (logged) when there is none.
void *bolan_sea_reserve(bolan_sea *sea, size_t bytes);
// bolan_allocate() that logs when there is none.
void *bolan_sea_borrow(size_t bytes);
void bolan_sea_radial_prepare(const spectrum_eval *eval, double peak_k, double budget, sea_radial *out);
double bolan_sea_radial_keep(const sea_radial *radial, double k);
// Wave number above which a fraction 1 - share of the variance lies; 0 in a flat calm.
double bolan_sea_radial_quantile(const sea_radial *radial, double share);
// Wave number of the highest spectral peak among the systems [rad/m]; 0 where there is none.
double bolan_sea_wind_peak(const bolan_sea_state *state, const bolan_sea_summary *summary);
// Lengths, angles and rings of the cascades; resolves desc.length.
void bolan_sea_layout(bolan_sea *sea, const sea_radial *radial);
// Mode tables of every cascade. False when memory is short.
bool bolan_sea_modes_create(bolan_sea *sea, const spectrum_eval *eval, const sea_radial *radial);
// The lift of every cascade or of the sum. False when memory is short.
bool bolan_sea_lift_create(bolan_sea *sea);
double bolan_sea_lift_at(const sea_lift *lift, double spacing);
// rest_slope and slope_table. False when memory is short.
bool bolan_sea_slopes_create(bolan_sea *sea);
// foam_threshold, from fields at a few times; leaves the sea at time 0. False when memory is short.
bool bolan_sea_whitecaps_create(bolan_sea *sea);

// One mode of the kept half plane, as the tables hold it.
typedef struct sea_mode {
    double kx, ky;                  // world wave vector [rad/m]
    double turns;                   // [1/s]
    double inverse_k;               // coth(kh) / |k|
    double re, im;                  // h0(k)
    double back_re, back_im;        // conj(h0(-k))
    double expected, expected_back; // variance of the waves that go along k and along -k [m2]
    bool paired;                    // it stands for -k as well; false on j = 0, where -k is an entry of its own
} sea_mode;
// Calls `visit` for every mode of every cascade, or every wave of the sum, in a fixed order.
void bolan_sea_each_wave(const bolan_sea *sea, void (*visit)(void *context, const sea_mode *mode), void *context);
// Calls `visit` for every mode with energy, in a fixed order.
void bolan_sea_each_mode(const sea_cascade *cascade, void (*visit)(void *context, const sea_mode *mode), void *context);

// Sums over the cascades or waves of the fields at one rest point, choppiness not applied, and what becomes of them with it.
typedef struct sea_sums {
    double height, dx, dy, sx, sy, dxx, dyy, dxy, foam;
} sea_sums;
bolan_sea_sample bolan_sea_displaced(const sea_sums *sums, double choppiness);

// Where the sea is measured: SEA_MEASURED places, SEA_PLACES at a time.
enum { SEA_PLACES = 64, SEA_MEASURED = 1 << 16 };
// Place `index`: over the largest tile, or over 50 of a sum's longest waves.
bolan_dvec2 bolan_sea_place(const bolan_sea *sea, uint32_t index);
// The surface at the rest points of the places [first, first + SEA_PLACES).
void bolan_sea_sample_places(const bolan_sea *sea, uint32_t first, bolan_sea_sample out[SEA_PLACES]);

#endif

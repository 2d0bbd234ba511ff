// SPDX-License-Identifier: MIT
// The inside of a flow. Private to src/flow and src/query.
//
// The potential (1) of flow.h, its first and its second time derivative are three scalars, from whose gradients
// everything else follows. Each is synthesised at FLOW_LEVELS depths of each cascade:
//
//     level l holds  sum of E(d_l) / k * mode,   E(d) = e^{-kd} / (1 - e^{-2kH}),                                  (2)
//     cosh k(H - d) / sinh kH = E(d) + E(2H - d),   sinh k(H - d) / sinh kH = E(d) - E(2H - d)                      (3)
//
// and for every d there are weights with  e^{-kd} = sum_l across_l e^{-k d_l}  and  k e^{-kd} = sum_l up_l e^{-k d_l}
// over the band (fit.c). So a point costs one look-up in one grid, whatever its depth. 16 floats, a cache line, are one
// texel:
//
//     | Phi at 4 levels | its gradient, that of d2Phi/dt2 at level 0 | dPhi/dt at 4 levels | d2Phi/dt2 at 4 levels |
//
// Where no gradient is stored it is that of the spline, whose error for short waves is three times that of a value. At
// depth there are none. Gradients are along the axes of the tile. Two of the fields share a complex FFT.
#ifndef BOLAN_FLOW_TABLES_H
#define BOLAN_FLOW_TABLES_H

#include "bolan/flow.h"

#include "fft/transform.h"
#include "waves/model.h"

enum {
    FLOW_LEVELS = 4,
    FLOW_DRIFT = FLOW_LEVELS,   // fields of the gradient of Phi at level 0: u, v
    FLOW_PUSH = FLOW_DRIFT + 2, // of d2Phi/dt2
    FLOW_BENT = FLOW_PUSH + 2,  // fields that finding a rest point reads: a half of the texel
    FLOW_SPEED = FLOW_BENT,     // of dPhi/dt at all levels
    FLOW_RATE = FLOW_SPEED + FLOW_LEVELS,
    FLOW_TEXEL = FLOW_RATE + FLOW_LEVELS,
    FLOW_PAIRS = FLOW_TEXEL / 2,
    FLOW_BINS = 24,    // of wave number, along a band
    FLOW_CELLS = 4,    // of the table of weights, in an octave of depth
    FLOW_OCTAVES = 16, // beyond, every wave of the band has died out
    FLOW_NODES = FLOW_CELLS * FLOW_OCTAVES + 1,
    FLOW_MAX_STRIPS = FFT_MAX / 2 / FFT_LANES,
    FLOW_ORDER = 4,                          // of the least wavelength's filter
    FLOW_MAX_TILES = 2 * BOLAN_MAX_CASCADES, // a cascade of a wide band is two
};

// Weights of the levels. Each row lies among zeros, so that a load of eight lanes has it in its lower half, its upper
// half, or level 0 in any lane.
enum { FLOW_LOW = FLOW_LEVELS, FLOW_HIGH = 0, FLOW_ROW = 3 * FLOW_LEVELS, FLOW_ZERO = 7, FLOW_TOP = 2 * FLOW_ZERO + 1 };
typedef struct flow_weights {
    float across[FLOW_LEVELS], up[FLOW_LEVELS];
    float across_row[FLOW_ROW], across_deep[FLOW_ROW], across_top[FLOW_TOP]; // all levels; without level 0; level 0
    float up_row[FLOW_ROW], up_deep[FLOW_ROW], up_top[FLOW_TOP];
    bool used; // some weight is not negligible
} flow_weights;

// Weights at a node of the table, and their derivatives by depth.
typedef struct flow_node {
    float across[FLOW_LEVELS], across_slope[FLOW_LEVELS], up[FLOW_LEVELS], up_slope[FLOW_LEVELS];
} flow_node;

// A wave of a mode. Of the waves of one mode, which differ in frequency, the first is the mode: the others are added
// to it when they are evolved.
typedef struct flow_mode {
    double turns;                   // [1/s]
    float re, im, back_re, back_im; // h0(k), conj(h0(-k))
    uint32_t first;                 // wave of its mode: its own number, or a smaller one
    float level[FLOW_LEVELS];       // (2), over the transfer of the spline
    uint16_t row, lane;             // index along i, wrapped; along j, in its strip
} flow_mode;

// Realised waves of a band by wave number.
typedef struct flow_bin {
    double k;      // mean [rad/m]
    double motion; // variance of velocity and acceleration, each as a share of that of the band
    double lift;   // [m]
    double energy; // variance of the height [m2]
} flow_bin;

// Depths at which the potential of a band is kept, and the weights of any other depth.
typedef struct flow_levels {
    double k_low, k_high;      // waves that matter
    double depth[FLOW_LEVELS]; // [m]
    flow_bin bin[FLOW_BINS];
    double finest; // the unit of the table of weights [m]
    flow_node node[FLOW_NODES];
} flow_levels;

// A tile's side in samples, its length [m] and how it lies.
typedef struct tile_frame {
    uint32_t n;
    double length, cosine, sine;
} tile_frame;

typedef struct flow_tile {
    tile_frame frame;
    uint32_t band; // the cascade that it comes from
    flow_levels levels;
    fft_plan plan;
    uint32_t strips, mode_count, first[FLOW_MAX_STRIPS + 1]; // waves of strip s: [first[s], first[s + 1])
    flow_mode *modes;
    float (*evolved)[6]; // of the modes at the time, where their first wave is: h, dh/dt, d2h/dt2
    float *texels;       // [n][n][FLOW_TEXEL]
} flow_tile;

// A wave of a sum. A wave exp(s cos) is its harmonics.
typedef struct flow_wave {
    double kx, ky, k;
    double turns; // over the ground [1/s]
    double omega; // against the water [rad/s]
    double amplitude, phase;
    double norm; // 1 / (1 - e^{-2kH})
    double base; // phase at the world origin and the time [turns]
} flow_wave;

// The potential of second order of a cascade: second.h.
typedef struct flow_second flow_second;

// What kernels make of a tile: sums over its levels, along its axes.
enum {
    FLOW_SUM_U, // displacement
    FLOW_SUM_V,
    FLOW_SUM_UU, // its gradient
    FLOW_SUM_UV,
    FLOW_SUM_VV,
    FLOW_SUM_HEIGHT, // vertical displacement and its gradient
    FLOW_SUM_SLOPE_U,
    FLOW_SUM_SLOPE_V,
    FLOW_SUM_VELOCITY, // u, v, vertical
    FLOW_SUM_ACCELERATION = FLOW_SUM_VELOCITY + 3,
    FLOW_SUM_POTENTIAL = FLOW_SUM_ACCELERATION + 3,
    FLOW_SUMS = 16,
};

typedef struct flow_kernels {
    // The displacement and its gradient at (u, v), in samples, `per` of which are a metre.
    void (*bends)(const float *texels, uint32_t n, double u, double v, const flow_weights *w, float per,
                  float out[FLOW_SUMS]);
    // Everything.
    void (*whole)(const float *texels, uint32_t n, double u, double v, const flow_weights *w, float per,
                  float out[FLOW_SUMS]);
    // Of a sea of order 2. Value, gradient u, v and second derivatives uu, uv, vv by samples of the first half of a
    // texel, then of the second.
    void (*full)(const float *texels, uint32_t n, double u, double v, float out[12][FLOW_BENT]);
    // Value and gradient of the first half, then of the second.
    void (*slopes)(const float *texels, uint32_t n, double u, double v, float out[6][FLOW_BENT]);
} flow_kernels;

struct bolan_flow {
    uint64_t sea_id;
    double time;
    const sea_model *model; // of the sea: constant
    double depth;           // of the sea [m]
    bolan_sea_warp warp;    // of the plane that the tiles are read over
    float choppiness;       // 0 where parcels do not move sideways
    float current_x, current_y;
    bolan_dvec2 origin; // where the tiles lie: they drift with the current [m]
    uint32_t bands;
    float band_hs[BOLAN_MAX_CASCADES]; // [m]
    uint32_t tiles;                    // 0 of a sum
    flow_tile tile[FLOW_MAX_TILES];
    const flow_kernels *kernels;
    fft_strip_fn *transform;
    float *middle; // of the tile that is stepped: [strip of x][j][row]
    uint32_t slots;
    float *scratch;
    size_t scratch_floats;
    bool is_second; // the sea has order 2
    uint32_t seconds;
    flow_second *second;     // of the cascades that count, longest first
    fft_plan second_plan[2]; // of SECOND_COARSE and of SECOND_FINE points; `bytes` 0: not needed
    float *second_planes;    // SECOND_PLANES and one for each slot
    uint32_t wave_count;     // of a sum
    flow_wave *waves;
    sea_memory memory;
};

// ---- creation -------------------------------------------------------------------------------------------------------

// Sets depth and node from k_low, k_high and bin. `sea_depth` is H.
void bolan_flow_fit(flow_levels *levels, double sea_depth);
// Modes and memory of every cascade, or waves of a sum. False when memory is short.
bool bolan_flow_create_tiles(bolan_flow *flow, const bolan_sea *sea);
bool bolan_flow_create_waves(bolan_flow *flow, const bolan_sea *sea);
// The potentials of second order, after the tiles. False when memory is short.
bool bolan_flow_create_second(bolan_flow *flow, const bolan_sea *sea);
void bolan_flow_evolve_second(bolan_flow *flow, double shown);
void bolan_flow_evolve_tiles(bolan_flow *flow, double shown);
void bolan_flow_evolve_waves(bolan_flow *flow, double shown);
const flow_kernels *bolan_flow_kernels_for(bolan_cpu cpu);

// ---- reading --------------------------------------------------------------------------------------------------------

// What a least wavelength leaves of a wave: 1 - (1 - e^{-kl})^4 is a sum of four exponentials, and so four depths. It
// is 1/2 where kl = FLOW_HALF.
#define FLOW_HALF 1.8383
// The length l of a least wavelength [m].
static inline double flow_smoothing(double least_wavelength) {
    return least_wavelength * (FLOW_HALF / (2.0 * BOLAN_PI));
}
double bolan_flow_kept(double k, double smoothing);

// Weights of the levels at a depth d; above the mean level, d < 0, along the tangent there.
void bolan_flow_weights(const flow_levels *levels, double sea_depth, double d, double smoothing, flow_weights *out);

// A depth at rest, as it counts for all bands.
typedef struct flow_depth {
    double below;     // d [m], 0 .. H
    double smoothing; // l [m]
    flow_weights weights[FLOW_MAX_TILES];
} flow_depth;
void bolan_flow_depth(const bolan_flow *flow, double below, double smoothing, flow_depth *out);

// Displacement at a rest point, choppiness not applied, and its gradient; `weight` is a factor for each band.
typedef struct flow_bend {
    double dx, dy, dxx, dxy, dyy;
} flow_bend;
// Everything else there.
typedef struct flow_motion {
    double height, slope_x, slope_y; // vertical displacement and its gradient
    double vx, vy, vz, ax, ay, az;
    double potential; // d2Phi/dt2 [m2/s2]: the pressure is -density times it
} flow_motion;
// A place of the warped plane, and the tangent of the warp there, by which all rest points near it are read.
typedef struct flow_spot {
    bolan_dvec2 at, read;
    double gradient[4];
} flow_spot;
void bolan_flow_spot(const bolan_flow *flow, double x, double y, flow_spot *out);
// Asks the memory for what is read at (x, y) near a spot: there are more texels than a cache holds.
void bolan_flow_prefetch(const bolan_flow *flow, const flow_depth *at, const flow_spot *spot, double x, double y);
// Both at the rest point (x, y) near a spot. `motion` NULL: the displacement alone, for half the work.
void bolan_flow_read(const bolan_flow *flow, const flow_depth *at, const flow_spot *spot, double x, double y,
                     const float *weight, flow_bend *bend, flow_motion *motion);
// The lift of each band that is left by a least wavelength [m], and the share of its rms height.
void bolan_flow_lifts(const bolan_flow *flow, double smoothing, float out[BOLAN_MAX_CASCADES]);
void bolan_flow_shares(const bolan_flow *flow, double smoothing, float out[BOLAN_MAX_CASCADES]);
// For sums.
void bolan_flow_bend_waves(const bolan_flow *flow, const flow_depth *at, double x, double y, flow_bend *out);
void bolan_flow_motion_waves(const bolan_flow *flow, const flow_depth *at, double x, double y, flow_motion *out);

// ---- second order ---------------------------------------------------------------------------------------------------

// The water at a fixed point, to second order.
typedef struct flow_water {
    double velocity[3], acceleration[3]; // of the parcel that is there: acceleration is -grad of pressure
    double pressure;                     // dynamic, over density [m2/s2]
} flow_water;
// At (x, y), `below` under the mean level, less than 0 above it. `rides`: the short waves' depth is counted from the
// surface of the long ones. `keep` is a factor for each band's amplitudes, and `share` for those of its pairs, too.
void bolan_flow_ride(const bolan_flow *flow, double x, double y, double below, bool rides, double smoothing,
                     const float *keep, const float *share, flow_water *out);

// An item of a step's work; scratch: memory that no other item uses meanwhile.
typedef void flow_work(void *context, uint32_t item, float *scratch);
// Does all items on the threads of flow->slots, of which each has so many floats of @p scratch.
void bolan_flow_share(const bolan_flow *flow, uint32_t items, float *scratch, size_t floats, flow_work *work,
                      void *context);

#endif

// SPDX-License-Identifier: MIT
// A sea of cascades: tiles of random modes, synthesised by FFT. Private to src/waves; loop/ builds on it.
//
// How a step goes. Each cascade has n x n modes (i, j), wave vector k = (i, j) 2 pi / length in tile axes; its height
// is real, so only i >= 0 is kept. Two parallel passes make the four fields of displacement_half, two more those of
// slope_half, by the same intermediate memory, which so remains in the cache:
//
//     columns  16 values of i at once, one a lane: modes at time t -> spectra of 4 real fields -> FFTs along j
//              -> `middle`
//     rows     8 values of y: two fields share a complex FFT along i -> planes, halfs, foam
//
// Both passes read and write whole cache lines that follow each other. The first transforms without a shuffle, since
// its lanes are independent; what the second has to move between lanes is one transposition, in the midst of its FFT.
//
// Readers interpolate between the samples, and each mode is divided by what its reader does to it (spline.h), so that
// every wave has its amplitude everywhere. Height and displacement are read by cubic B-splines, their derivatives,
// which pixels fetch, linearly: two divisors, each the product of one of i and one of j.
//
// A tick of the foam (sea.h) needs div D alone: two of the fields of slope_half.
//
// Who owns what. A sea_cascade is a table: written at creation, then read by every fork. What a step writes are the
// planes and the scratch memory of one sea.
#ifndef BOLAN_WAVES_CASCADES_H
#define BOLAN_WAVES_CASCADES_H

#include "fft/plan.h"
#include "waves/model.h"

enum {
    SEA_ROWS = 8,                    // values of y in a block of `middle`
    SEA_PIECE = SEA_ROWS * FFT_ROW,  // floats of `middle` for one (block, strip, field)
    SEA_HALF = 4,                    // fields that are made at a time
    SEA_CELL = SEA_HALF * SEA_PIECE, // for one (block, strip)
    SEA_MAX_STRIPS = FFT_MAX / 2 / FFT_LANES,
};

// Waves in a table of rows of 16 lanes: h = (A0 c + A1 s) + i (A2 c + A3 s) with c + i s = e^{i w t}.
typedef struct sea_waves {
    double *turns;    // [row][16]: w / 2 pi [1/s]; 0: no wave
    float *amplitude; // [row][4][16]: A0 .. A3 [m]
    float *expected;  // [row][2][16]: variance of the waves k and -k [m2]
} sea_waves;

// A mode near the origin of the lattice stands for a cell that is wide beside its wave number. It is the sum of waves
// with one wave vector, each with the frequency of a slice of the cell (modes.c).
enum {
    SEA_PARTS = BOLAN_MODE_PARTS,
    SEA_PART_REACH = BOLAN_MODE_PART_REACH, // |i| and |j| of such modes are smaller
    SEA_PART_ROWS = 2 * SEA_PART_REACH - 1,
};
_Static_assert((int)SEA_PART_REACH == (int)FFT_LANES, "modes of several waves are those of the first strip");

typedef struct sea_cascade {
    uint32_t n;
    double length, angle, cosine, sine, k_min, k_max;
    double slope[3];     // expected slope covariance xx, xy, yy in world axes
    double displacement; // expected variance of dx plus that of dy [m2]
    sea_band *band;      // in sea_shared: variance, the discrete sum over the ring, and lift

    uint32_t strips;                // strips of 16 i that hold modes; none has |i| or |j| >= 3/8 n
    uint32_t reach[SEA_MAX_STRIPS]; // in a strip modes have |j| < reach
    sea_waves modes;                // [strip][j]: of each mode, its only wave or its first
    sea_waves parts;                // [SEA_PARTS - 1][SEA_PART_ROWS]: the others, of strip 0, from j = 1 - reach on
    float *inverse_k;               // [strip][j][16]: coth(kh) / |k| [m]
    float *k_cos, *k_sin;           // [n]: tile wave number of an index (wrapped) times cosine and sine of the angle
    float *cubic, *linear;          // [n]: one over the divisors along an axis (spline.h)
} sea_cascade;

// The halves of a step: the fields of displacement and displacement_half, then those of slope and slope_half.
typedef enum sea_half { SEA_DISPLACEMENT, SEA_SLOPES, SEA_HALVES } sea_half;
static const uint8_t sea_half_field[SEA_HALVES][SEA_HALF] = {{FIELD_DX, FIELD_DY, FIELD_HEIGHT, FIELD_DXY},
                                                             {FIELD_SLOPE_X, FIELD_SLOPE_Y, FIELD_DXX, FIELD_DYY}};
enum { SEA_DIVERGENCE = 2 }; // of SEA_SLOPES, the fields that a tick needs: from there on

// What a step writes of a cascade.
typedef struct sea_planes {
    float *modes;                  // [strip][j][FFT_ROW]: h at the time, for both halves
    float *middle;                 // [block of y][strip][SEA_HALF][SEA_ROWS][FFT_ROW]: fields at (i, y)
    bolan_sea_texel *displacement; // [n + guard][n + guard]: bolan/waves.h
    float *slope[SEA_HALF];        // fields of SEA_SLOPES
    float *foam;
    float *foam_tick; // foam memory at the last tick
    uint16_t *displacement_half, *slope_half, *foam_half;
} sea_planes;

struct sea_kernels;

// sea_shared.tables
typedef struct cascade_tables {
    sea_cascade cascade[BOLAN_MAX_CASCADES];
    sea_cascade fine; // fine.c; n 0: there is none
    sea_band fine_band;
    fft_plan columns; // n points
    fft_plan rows;    // n / 16 points, the first half of an FFT along a row: synth_rows.kernel.c
    float *turns;     // [n / 16][FFT_ROW]: e^{2 pi i bl / n} between its halves
    const struct sea_kernels *kernels;
} cascade_tables;

// bolan_sea.fields
typedef struct cascade_fields {
    sea_planes planes[BOLAN_MAX_CASCADES];
    sea_planes fine; // slopes alone
    uint32_t slots;  // workers that a step uses at most
    float *scratch;  // [slots][scratch_floats]
    size_t scratch_floats;
} cascade_fields;

static inline const cascade_tables *cascade_tables_of(const sea_shared *shared) { return shared->tables; }
static inline const cascade_fields *cascade_fields_of(const bolan_sea *sea) { return sea->fields; }

// ---- creation -------------------------------------------------------------------------------------------------------

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
// `budget` is the slope variance of all waves, by Cox & Munk; waves longer than that of `k1` are kept.
void bolan_sea_radial_prepare(const spectrum_eval *eval, double k1, double budget, sea_radial *out);
double bolan_sea_radial_keep(const sea_radial *radial, double k);
// Wave number above which a fraction 1 - share of the variance lies; 0 in a flat calm.
double bolan_sea_radial_quantile(const sea_radial *radial, double share);
// Wave number up to which a sea is as it was asked for [rad/m]: ten times that of the shortest peak, and the last one
// of a measured spectrum.
double bolan_sea_asked_end(const bolan_sea_state *state, const bolan_sea_summary *summary);

// How long the first tile is where the desc leaves it open: so many peak wavelengths, and at least so many of the
// longest waves that matter. `open`: the sea has no tiles to be seen, so they are turned away from the waves' direction
// and laid over a warped plane.
typedef struct cascade_extent {
    double peaks, longest;
    bool open;
} cascade_extent;
// Reserves the tables, resolves desc.length, and makes `count` cascades with all that is in them. Sets bands and
// counts. False when memory is short.
bool bolan_cascades_create(sea_shared *shared, const spectrum_eval *eval, uint32_t count, cascade_extent extent);
// See sea_model.size.
void bolan_cascades_size(sea_shared *shared, const spectrum_eval *eval, uint32_t count, cascade_extent extent,
                         bolan_sea_bytes *bytes);
// Lengths, angles and rings of `count` cascades.
void bolan_cascades_layout(sea_shared *shared, const sea_radial *radial, cascade_extent extent);
// The part of the Nyquist wave number at which rings end.
#define CASCADE_RING_END 0.7
// The tile of the fine waves behind `count` cascades.
void bolan_cascade_lay_fine(cascade_tables *tables, uint32_t count);
// Their spectrum: fine.c. Density [m4] at (kx, ky), whose k is not 0.
typedef struct cascade_fine_spectrum {
    double a, m, cosine, sine; // the latter of the wind's direction
} cascade_fine_spectrum;
double bolan_cascade_fine_density(const cascade_fine_spectrum *f, double kx, double ky);
// The strips of a cascade that hold modes, and how far they reach.
void bolan_cascade_set_reach(sea_cascade *cascade);
// Row of `parts` of wave `part`, 1 .. SEA_PARTS - 1, at a signed index j.
static inline size_t sea_part_row(uint32_t part, int32_t j) {
    return (size_t)(part - 1) * SEA_PART_ROWS + (size_t)(j + SEA_PART_REACH - 1);
}
// Memory of the mode tables of a cascade [bytes].
size_t bolan_cascade_table_bytes(const sea_cascade *cascade);
// The warped plane over which a sea is read whose first tile has that length and angle.
void bolan_sea_warp_prepare(double length, double angle, bolan_sea_warp *out);
// Mode tables of every cascade. False when memory is short.
bool bolan_cascades_modes(sea_shared *shared, const spectrum_eval *eval, const sea_radial *radial);
// Mode tables of cascade number `index`: of the sea state, or of the fine waves, where `fine` is not NULL.
bool bolan_cascade_fill(sea_shared *shared, sea_cascade *cascade, uint32_t index, const spectrum_eval *eval,
                        const sea_radial *radial, const cascade_fine_spectrum *fine);
// The weights of the bound waves, of a sea with its modes.
void bolan_cascades_bound(sea_shared *shared);
// The lift of a cascade. False when memory is short.
bool bolan_cascade_lift(const sea_cascade *cascade, double choppiness, const bolan_bound_weights *bound);
// Calls `visit` for every wave of every mode, in a fixed order.
void bolan_sea_each_mode(const sea_cascade *cascade, sea_visit *visit, void *context);

// ---- the functions of the table (model.h) ---------------------------------------------------------------------------

void bolan_cascades_destroy(sea_shared *shared);
bool bolan_cascades_create_fields(bolan_sea *sea);
void bolan_cascades_step(const bolan_sea *sea, const sea_instant *instant);
void bolan_cascades_sample_rest(const bolan_sea *sea, const bolan_dvec2 *points, uint32_t count, bolan_sea_sample *out);
void bolan_cascades_sample_grid(const bolan_sea *sea, const bolan_dvec2 *points, const float *spacing, uint32_t count,
                                bolan_sea_sample *out);
void bolan_cascades_sample_direct(const sea_shared *shared, bolan_dvec2 at, bolan_dvec2 drift, double shown,
                                  sea_sums *out);

// The part of a table that FFT and TEXTURES have in common.
#define CASCADES_MODEL                                                                                      \
    .form = BOLAN_FORM_CASCADES, .remembers = true, .destroy = bolan_cascades_destroy,                      \
    .create_fields = bolan_cascades_create_fields, .step = bolan_cascades_step,                             \
    .sample_rest = bolan_cascades_sample_rest, .sample_grid = bolan_cascades_sample_grid,                   \
    .sample_direct = bolan_cascades_sample_direct, .each_wave = bolan_cascades_each_wave,                   \
    .slopes = bolan_cascades_slopes, .bounds = bolan_cascades_bounds, .side = bolan_cascades_side,          \
    .hash = bolan_cascades_hash, .cascade = bolan_cascades_view, .create_fine = bolan_cascades_create_fine, \
    .each_fine = bolan_cascades_each_fine, .step_fine = bolan_cascades_step_fine, .fine = bolan_cascades_fine
bool bolan_cascades_create_fine(sea_shared *shared);
void bolan_cascades_each_fine(const sea_shared *shared, sea_visit *visit, void *context);
void bolan_cascades_step_fine(const bolan_sea *sea);
bolan_sea_fine_view bolan_cascades_fine(const bolan_sea *sea);
void bolan_cascades_each_wave(const sea_shared *shared, sea_visit *visit, void *context);
void bolan_cascades_slopes(const sea_shared *shared, double out[3]);
void bolan_cascades_bounds(const sea_shared *shared, double *vertical, double *horizontal);
double bolan_cascades_side(const sea_shared *shared);
uint64_t bolan_cascades_hash(const bolan_sea *sea, uint64_t hash);
bolan_cascade_view bolan_cascades_view(const bolan_sea *sea, uint32_t index);

#endif

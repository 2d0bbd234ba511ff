// SPDX-License-Identifier: MIT
/// @file waves.h
/// Tier 2. The sea: create it from a sea state, step it to a time, read its fields.
///
/// The sea is a pure function of (sea state, seed, layout, time): stepping from 0 to 10 s or straight to 10 s gives
/// the same bits, on any number of threads and with any instruction set. The one exception is the foam memory, which
/// remembers the last seconds; after a jump in time (backwards, or more than 0.5 s forward) it starts again from the
/// present.
///
/// **Layout.** The wave-number plane is cut into disjoint rings without gaps, one per *cascade*: a periodic square
/// tile of side `length` with `n` x `n` samples. Each tile lies rotated by `angle` about the world origin, and the
/// ratios of their lengths are incommensurate, so that the repetitions of different cascades never line up. The
/// fields of the sea at a world point are the sums of the cascades' fields there. Which waves a tile holds depends on
/// the seed and its length only: a finer resolution adds shorter waves to the same longer ones.
///
/// **Fields.** With eta the height, D the horizontal displacement that gathers water at crests (choppiness not
/// applied): a water parcel at rest at x0 is found at x = x0 + choppiness * D(x0), z = eta(x0) + lift. Fields live on
/// x0. Vectors are in world axes (east, north), whatever the angle of the tile.
///
/// **Level.** Parcels stand closer at crests and cover less there, so that the mean of eta at fixed points is
/// -choppiness * integral of k coth(k depth) S dw. The lift, a constant of the sea, is the opposite of that for the
/// interpolated fields: the mean of the surface at fixed points is the water level. Every height of a sample, a query
/// and a picture has it; the cascades' fields do not. Where shallow water attenuates waves by f it is f^2 of that.
///
/// **Limits.** A sea state that is too high for its depth or too steep is lowered as a whole, with one warning
/// (SEA_LIMITED): bolan_sea_state_limit() has the rules. No query is then asked of waves that no water could carry.
///
/// **Synthesis.** eta(x, t) = sum over k of h(k, t) e^{i k.x}, h(k, t) = h0(k) e^{-i w t} + conj(h0(-k)) e^{+i w t},
/// h0(k) = (xr + i xi)/2 sqrt(integral of Psi over the cell of k), xr and xi normal: waves run toward k and the
/// variance of eta is that of the spectrum (Tessendorf 2001, section 3, with the sign and the factor of a one-sided
/// spectrum). D = i k/|k| coth(kh) h. w follows bolan_omega_from_k(). Beyond ten times the wave number of the
/// spectral peak the power is rolled off so that the slope variance of all cascades stays below Cox & Munk's total
/// for the wind.
#ifndef BOLAN_WAVES_H
#define BOLAN_WAVES_H

#include "bolan/base.h"
#include "bolan/math.h"
#include "bolan/spectrum.h"

#ifdef __cplusplus
extern "C" {
#endif

#define BOLAN_MAX_CASCADES 4 ///< of a sea

/// How waves are made of a sea state.
typedef enum bolan_wave_model {
    BOLAN_WAVES_FFT,        ///< cascades of inverse FFTs of a random sea
    BOLAN_WAVES_COSINES,    ///< a sum of frequencies x directions cosine waves (Liu, Xu & Chen 2009)
    BOLAN_WAVES_EXP_COSINE, ///< a sum of few waves exp(s cos): sharp crests, wide troughs (Liu & Xie 2010)
    BOLAN_WAVES_TEXTURES,   ///< one tile of FFT whose time runs in a loop of few still frames (Ma, Zhu & Gong 2006)
} bolan_wave_model;
#define BOLAN_WAVE_MODELS 4 ///< how many there are
/// The names that the command line and scene files use, "fft" ...; by bolan_wave_model, NULL at the end.
extern const char *const bolan_wave_model_names[BOLAN_WAVE_MODELS + 1];

/// How BOLAN_WAVES_COSINES cuts a spectrum into frequencies.
typedef enum bolan_frequency_split {
    BOLAN_SPLIT_EQUAL_ENERGY, ///< every wave as high as the next: no common period
    BOLAN_SPLIT_EQUAL_WIDTH,  ///< equal steps of frequency between the quantiles .002 and .998 of the energy, as the
                              ///< paper: the groups of waves repeat after 2 pi / step (32 s at Hs 3 m)
} bolan_frequency_split;
#define BOLAN_FREQUENCY_SPLITS 2 ///< how many there are
/// The names that scene files use, "equal-energy" ...; by bolan_frequency_split, NULL at the end.
extern const char *const bolan_frequency_split_names[BOLAN_FREQUENCY_SPLITS + 1];
#define BOLAN_MAX_FREQUENCIES 64 ///< of BOLAN_WAVES_COSINES
#define BOLAN_MAX_DIRECTIONS 32  ///< of BOLAN_WAVES_COSINES
#define BOLAN_MAX_EXP_WAVES 16   ///< of BOLAN_WAVES_EXP_COSINE
#define BOLAN_MAX_LOOP_FRAMES 64 ///< of BOLAN_WAVES_TEXTURES

/// How a sea is made.
///
/// The fields that more than one model reads mean the same in each of them, so that another model shows the same sea
/// state, seed and current. What one model alone reads stands in the struct of that model; the other models ignore it,
/// but every field must be in its range whatever the model.
typedef struct bolan_sea_desc {
    /// The model that makes the waves.
    /// Default BOLAN_WAVES_FFT.
    bolan_wave_model waves;

    /// What the wind and swell are.
    /// Default: wind 8 m/s from 240 degrees, fetch 200 km.
    /// It is kept as given where the sea is limited; bolan_sea_get_summary() describes the limited sea.
    bolan_sea_state sea_state;

    /// Which sea of this sea state.
    /// Any value; default 1.
    uint64_t seed;

    /// Which kernels compute the fields.
    /// Default BOLAN_CPU_AUTO; a set that this machine lacks counts as AUTO.
    /// The fields have the same bits with every set.
    bolan_cpu cpu;

    /// Factor on the horizontal displacement.
    /// 0..2; default 1, linear theory.
    /// Raised: sharper crests, which fold sooner. EXP_COSINE has no horizontal displacement.
    double choppiness;

    /// Time after which every field repeats [s].
    /// 10..1e6, or 0 (default): no repetition.
    /// Frequencies are rounded to multiples of 1 / period; from 200 s on the rounding is not visible.
    /// TEXTURES has its own period, textures.period.
    double loop_period;

    /// Uniform current, east and north [m/s].
    /// -5..5; default 0.
    /// The waves stay the same and run over the ground at omega + k . current.
    /// FFT and TEXTURES ignore it.
    double current_x, current_y;

    /// Samples along the side of a tile, for FFT and TEXTURES.
    /// A power of two, 32..1024; default 256.
    /// Raised: shorter waves with the same number of tiles; time and memory grow with its square.
    uint32_t resolution;

    /// Side of the largest tile [m], for FFT and TEXTURES.
    /// 10..1e5, or 0 (default): 12 peak wavelengths and at least 10 of the longest swell that matters (TEXTURES: 7, 5).
    /// Raised: the sea repeats after a longer distance, and its shortest wave is longer.
    double length;

    /// e-folding time of the foam memory [s], for FFT and TEXTURES.
    /// 0.1..60; default 3.5.
    /// Raised: longer streaks behind crests.
    double foam_decay;

    /// BOLAN_WAVES_FFT.
    struct {
        /// Number of cascades.
        /// 1..BOLAN_MAX_CASCADES; default 4.
        /// Raised: shorter waves become geometry instead of roughness.
        uint32_t cascade_count;
    } fft;

    /// BOLAN_WAVES_TEXTURES: one tile, and a loop of still frames.
    struct {
        /// Time of the loop [s].
        /// 1..1e6, or 0 (default): the whole number of peak periods nearest to 10 s, at least one.
        double period;

        /// Frames of the loop.
        /// 2..BOLAN_MAX_LOOP_FRAMES; default 32.
        /// Raised: smoother motion. The foam memory runs in the time of the steps, not of the frames.
        uint32_t frames;
    } textures;

    /// BOLAN_WAVES_COSINES: frequencies x directions waves.
    struct {
        /// Number of frequencies, M.
        /// 1..BOLAN_MAX_FREQUENCIES; default 16.
        /// Raised: a richer sea, proportionally slower.
        uint32_t frequencies;

        /// Number of directions of each frequency, N.
        /// 1..BOLAN_MAX_DIRECTIONS; default 8.
        /// They are the mid-points of +-90 degrees for one system with COS2, else directions of equal energy.
        /// Raised: shorter crests, proportionally slower.
        uint32_t directions;

        /// How the spectrum is cut into frequencies.
        /// Default BOLAN_SPLIT_EQUAL_ENERGY.
        bolan_frequency_split split;
    } cosines;

    /// BOLAN_WAVES_EXP_COSINE: waves exp(s cos).
    struct {
        /// Number of waves.
        /// 1..BOLAN_MAX_EXP_WAVES; default 8.
        /// Raised: less regular from above, slower.
        uint32_t wave_count;

        /// Sharpness s.
        /// 0.01..2; default 0.5. The paper's is 1, steeper than any wave that does not break.
        /// Raised: sharper crests, wider troughs.
        double sharpness;
    } exp_cosine;
} bolan_sea_desc;

/// The parameters of bolan_sea_desc; those of its sea state are bolan_sea_state_params.
extern const bolan_param_table bolan_sea_params;

/// A sea: spectrum tables, and the fields of one time.
typedef struct bolan_sea bolan_sea;

/// The defaults named beside the fields.
/// A fresh breeze over the open sea. Thread-safe.
bolan_sea_desc bolan_sea_desc_default(void);
/// Builds the spectrum tables and all memory; no later call allocates. Uses the task hook: a sea steps on at most as
/// many workers as there were at its creation. Errors: ARGUMENT (field named in the log), MEMORY; then *out is NULL.
/// The desc is copied; a measured spectrum in it is not needed afterwards. The sea stands at time 0.
/// Thread-safety: different seas may be used from different threads; one sea is stepped by one thread at a time and
/// may be read by many between steps.
bolan_result bolan_sea_create(const bolan_sea_desc *desc, bolan_sea **out);
/// NULL-safe; NULLs the pointer.
void bolan_sea_destroy(bolan_sea **sea);
/// Synthesises all fields at @p time [s], any finite value, backwards too (beyond 2^36 s, 2000 years, it wraps
/// round). Uses the task hook. Never fails.
void bolan_sea_step(bolan_sea *sea, double time);
/// Like step, and fills the foam memory first by stepping through the last seconds before @p time (about 4
/// foam_decay) in ticks of 0.25 s, which lie at multiples of 0.25 s whatever the time, so that a single picture shows
/// the foam that a running sea would. Costs about 16 steps a second of foam_decay.
void bolan_sea_settle(bolan_sea *sea, double time);
/// The time of the last step [s]. TEXTURES shows the frame of its loop that was on at that time. Thread-safe between
/// steps, as everything below.
double bolan_sea_time(const bolan_sea *sea);
/// The desc the sea was made from, defaults resolved (measured is NULL). Valid while the sea lives.
const bolan_sea_desc *bolan_sea_get_desc(const bolan_sea *sea);

/// The number of the sea: never 0, and different for every sea that this process has created.
/// Use it, not the address, to tell whether something made from a sea still belongs to it.
/// Thread-safe, also during a step.
uint64_t bolan_sea_id(const bolan_sea *sea);
/// The number of the fields as they are now: never 0, and unique in this process, so that equal serials mean equal
/// fields of the same sea.
/// A step or settle changes it; a step to the time at which the fields stand already does nothing and keeps it.
/// Thread-safe between steps.
uint64_t bolan_sea_serial(const bolan_sea *sea);

/// Integral parameters of the sea state, a measured spectrum included, lowered by bolan_sea_state_limit(); computed at
/// creation.
const bolan_sea_summary *bolan_sea_get_summary(const bolan_sea *sea);
/// When the measured spectrum was taken, ISO 8601; "" when it does not say or there is none. Valid while the sea lives.
const char *bolan_sea_record_time(const bolan_sea *sea);
/// What cascade @p index adds to every height to keep the mean of the surface at the level [m], >= 0, as a grid of
/// @p spacing [m] carries it (0: a single point); a sum has index 0 alone. 0 without choppiness and for EXP_COSINE, whose
/// parcels do not move sideways. Thread-safe.
double bolan_sea_lift(const bolan_sea *sea, uint32_t index, double spacing);

/// One cascade, read-only; pointers stay valid while the sea lives, contents change with each step. Sample (i, j) of
/// a field is at [j * n + i], at tile coordinates (i, j) * length / n. World to tile: rotate by -angle:
/// u = x cos(angle) + y sin(angle), v = -x sin(angle) + y cos(angle).
typedef struct bolan_cascade_view {
    uint32_t n;
    double length;                     ///< side of the tile [m]
    double angle;                      ///< rotation of the tile against the world, counter-clockwise [rad]
    double k_min, k_max;               ///< ring of wave numbers [rad/m]: k_min <= |k| < k_max
    double variance;                   ///< expected variance of the height, the discrete sum over the ring [m2]
    double mss;                        ///< expected slope variance of the ring
    const float *height;               ///< eta [m]
    const float *dx, *dy;              ///< D, world east and north [m]
    const float *slope_x, *slope_y;    ///< grad eta
    const float *dxx, *dyy, *dxy;      ///< dDx/dx, dDy/dy, dDx/dy (= dDy/dx)
    const float *foam;                 ///< foam memory: recent peak of -(dxx + dyy) * choppiness, decaying; >= 0
    const uint16_t *displacement_half; ///< n*n*4 halfs: dx, dy, eta, dxy: ready to upload as RGBA16F
    const uint16_t *slope_half;        ///< n*n*4 halfs: slope_x, slope_y, dxx, dyy
    const uint16_t *foam_half;         ///< n*n halfs: foam
} bolan_cascade_view;
/// 1..BOLAN_MAX_CASCADES for FFT, 1 for TEXTURES, 0 for the sums COSINES and EXP_COSINE, which have components instead.
uint32_t bolan_sea_cascade_count(const bolan_sea *sea);
/// Cascade @p index, 0 the one of the longest waves.
bolan_cascade_view bolan_sea_cascade(const bolan_sea *sea, uint32_t index);

/// One wave of a sum, at rest point x and time t: with th = k.x - omega t + phase,
/// COSINES:    eta = amplitude cos th, D = -drift k/|k| sin th, drift = amplitude coth(|k| depth)
/// EXP_COSINE: eta = amplitude (e^{s (cos th - 1)} - mean) * 2 / (1 - e^{-2s}), mean = e^{-s} I0(s): zero mean, range
/// 2 amplitude; D = 0, as the crests are sharp already: choppiness does nothing, and the Jacobian is 1
typedef struct bolan_sea_component {
    double kx, ky;    ///< wave vector [rad/m], where the wave goes
    double omega;     ///< [rad/s], over the ground: with the current, < 0 where it carries the wave back
    double phase;     ///< at the world origin and time 0 [rad], 0..2 pi
    double amplitude; ///< [m]
    double drift;     ///< amplitude of the horizontal displacement, choppiness not applied [m]; 0 with EXP_COSINE
} bolan_sea_component;
/// Number of waves of a sum, longest first; 0 for FFT and TEXTURES. Thread-safe.
uint32_t bolan_sea_component_count(const bolan_sea *sea);
/// Wave @p index of the sum. Thread-safe.
bolan_sea_component bolan_sea_get_component(const bolan_sea *sea, uint32_t index);
/// TEXTURES: which frame of the loop the fields show, 0..textures.frames - 1; 0 for the others. Thread-safe.
uint32_t bolan_sea_loop_frame(const bolan_sea *sea);

/// Everything the sea is at one rest point, all cascades summed (bilinear between samples), choppiness and lift
/// applied.
typedef struct bolan_sea_sample {
    float height, dx, dy;   ///< displacement of the parcel: (x, y, z) = (x0 + dx, y0 + dy, height) [m]
    float slope_x, slope_y; ///< surface slope dz/dx, dz/dy *after* displacement; where |jacobian| < 0.1, as if it
                            ///< were 0.1
    float jacobian;         ///< of the horizontal map; < 0 where the surface folds
    float foam;             ///< sum of the foam memories
} bolan_sea_sample;
/// Samples at @p count rest points in world metres. The sums have no foam memory: their foam is what there is at the
/// moment, -(dDx/dx + dDy/dy) choppiness where that is > 0. They use the task hook. Thread-safe between steps.
void bolan_sea_sample_rest(const bolan_sea *sea, const bolan_dvec2 *points, uint32_t count, bolan_sea_sample *out);
/// Like bolan_sea_sample_rest(), low-passed for a grid of that spacing: @p spacing[i] >= 0 [m] is the distance of point
/// i to its neighbours, and waves fade out from 4 to 2 spacings of length, so that nothing aliases; NULL: everything.
/// For the sums this is the fast way to displace a mesh: SIMD over the points, on the task hook. A cascade of FFT and
/// TEXTURES is averaged over a square of two spacings by up to 4 x 4 look-ups, and fades as a whole from 4 to 2
/// spacings of its longest wave: what is shorter than two spacings keeps about 1/16 of its energy. Thread-safe between
/// steps.
void bolan_sea_sample_grid(const bolan_sea *sea, const bolan_dvec2 *points, const float *spacing, uint32_t count,
                           bolan_sea_sample *out);
/// The oracle: the same quantities at one rest point and time by the direct sum over every mode, O(n^2) a point, in
/// double, with the same lift. The result's foam is 0. Thread-safe, also during a step.
bolan_sea_sample bolan_sea_sample_direct(const bolan_sea *sea, double x, double y, double time);

/// Bounds that the surface does not leave (6 standard deviations; vertical with the lift, horizontal with choppiness):
/// vertical and horizontal [m].
void bolan_sea_bounds(const bolan_sea *sea, double *vertical, double *horizontal);

/// Slope covariance that a filter removes: what a picture's pixel (or a radar cell) cannot resolve and must treat as
/// roughness. A Gaussian footprint of standard deviations @p major, @p minor [m] whose major axis points along @p angle
/// (mathematical, rad) keeps exp(-sigma^2 k^2) of the power of a wave. Above the last cascade the wind's short waves
/// (Cox & Munk's total less what the cascades hold) are always removed. With major = minor = 0 that rest is what is
/// left.
/// @p out: xx, xy, yy. Thread-safe. Source: Bruneton, Neyret & Holzschuch 2010, section 4.
void bolan_sea_unresolved_slopes(const bolan_sea *sea, double major, double minor, double angle, float out[3]);

/// Texels along log2(major): texel i is major = 2^(i/1.5 - 8) m, from 4 mm to 2^(23/1.5 - 8) = 160 m.
#define BOLAN_SLOPE_TABLE_MAJOR 24
#define BOLAN_SLOPE_TABLE_ASPECT 8 ///< minor/major: texel j is 2^-j
#define BOLAN_SLOPE_TABLE_ANGLE 8  ///< texel l is angle = l pi / 8, periodic
/// The function above as a table to sample with linear filtering: out[((l * ASPECT) + j) * MAJOR + i][4] = xx, xy,
/// yy, 0. Computed at creation. Valid while the sea lives.
const float *bolan_sea_slope_table(const bolan_sea *sea);

/// Foam appears where the Jacobian is below this, so that the covered fraction is bolan_monahan_cover() of the wind: a
/// quantile of the Jacobian, above 1 where more than about half is covered. -1e30 where nothing foams: without wind,
/// without waves, and with EXP_COSINE. Computed at creation.
double bolan_sea_foam_threshold(const bolan_sea *sea);

/// Statistics of the surface at the present time, as it is asked and drawn: the JSON keys of `bolan measure`. They are
/// taken at 65536 places. At fixed points a parcel counts by the area that it covers, its Jacobian.
typedef struct bolan_sea_statistics {
    double hs;                     ///< 4 sqrt(m0_field) [m]
    double tp, tm02, te;           ///< of the discrete spectrum that is synthesised [s]; of a measured one, of the file
    double direction_from, spread; ///< from the realised amplitudes [deg]; of a measured spectrum, of the file
    double mss, mss_up,
        mss_cross;             ///< slope variance of the displaced surface at fixed points; up- and crosswind parts (of
                               ///< the mean direction when calm)
    double skewness, kurtosis; ///< of the height at fixed points; 0 and 3 for linear waves, with choppiness too
    double mean_level;         ///< mean height at fixed points [m]; 0 but for sampling
    double jacobian_min, jacobian_mean; ///< over all parcels
    double whitecap_fraction;           ///< of the parcels: those with a Jacobian below the foam threshold
    double m0_spectrum;                 ///< of the sea state, limited; of a measured one over its own frequencies [m2]
    double m0_field;                    ///< variance of the height at fixed points [m2]
} bolan_sea_statistics;
/// Measures over the largest tile, or a sum over 50 of its longest waves; as slow as a step. Thread-safe between steps.
bolan_sea_statistics bolan_sea_measure(const bolan_sea *sea);
/// Digest of every field (foam memory excluded; of a sum: at 4096 places) at the present time, as 16 lower-case hex
/// digits and NUL. Equal for any thread count and any instruction set.
void bolan_sea_hash(const bolan_sea *sea, char out[17]);

#ifdef __cplusplus
}
#endif
#endif

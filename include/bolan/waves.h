// SPDX-License-Identifier: MIT
/// @file waves.h
/// Tier 2. The sea: create it from a sea state, step it to a time, read its fields.
///
/// The sea is a pure function of sea state, seed, layout and time. Stepping from 0 to 10 s or straight to 10 s gives
/// the same bits, on any number of threads and with any instruction set. The one exception is the foam memory, which
/// remembers the last seconds. After a jump in time (backwards, or more than 1 s forward) it starts again from the
/// present; bolan_sea_settle() fills it. From there on steps of at most 1 s keep it a function of time, too: it is
/// made of the pinch at ticks 0.25 s apart, the same whatever the steps, and ends after 5 foam_decay.
///
/// **Layout.** The wave-number plane is cut into disjoint rings without gaps, one per *cascade*: a periodic square tile
/// of side `length` with `n` x `n` samples. Each tile is rotated by `angle` about the world origin, away from the mean
/// direction of the waves, and the ratios of the lengths are incommensurate. The tiles of FFT lie over a warped plane,
/// bolan_sea_place_read(), so that one tile away the waves are others: heights at any distance are correlated as the
/// spectrum wants, to 0.15. The fields of the sea at a world point are the sums of the cascades' fields there. Which
/// waves a tile holds depends on the seed and its number and length only. From a resolution of 128 on lengths and rings
/// do not depend on the resolution: a finer one adds shorter waves to the same longer ones.
///
/// **Between samples.** Height and displacement are read by cubic B-splines, and each mode is divided by what the
/// spline does to it, so every wave has its amplitude everywhere. Slopes and Jacobians of samples and queries are the
/// gradient of that surface. The planes of a cascade therefore hold coefficients, not samples of the surface.
///
/// **Fields.** With eta the height and D the horizontal displacement that gathers water at crests (choppiness not
/// applied), a water parcel at rest at x0 is found at x = x0 + choppiness * D(x0), z = eta(x0) + lift. Fields are
/// functions of x0. Vectors are in world axes (east, north), whatever the angle of the tile.
///
/// **Level.** Parcels stand closer at crests and cover less area there, so the mean of eta at fixed points is
/// -choppiness * integral of k coth(k depth) S dw. The lift, a constant of the sea, is the opposite of that: the mean
/// of the surface at fixed points is the water level; the mean of bound waves is taken away as well. Every height of a
/// sample, a query and an image includes the lift; the cascades' fields do not. Where shallow water attenuates waves by
/// f, the lift is attenuated by f^2.
///
/// **Order.** With desc.order 2 parcels stand higher by the bound waves, sums of products of the cascades' heights and
/// displacements with weights that the depth and the spectrum fix: bolan_bound_weights. The third moment of the surface
/// is then that of second-order theory for the sea's spectrum. Heights and slopes of samples, queries and images
/// include them, and the flow below the surface has their potentials (flow.h). The cascades' fields, Jacobians and foam
/// are of first order.
///
/// **Limits.** A sea state that is too high for its depth or too steep is lowered as a whole, with one warning
/// (SEA_LIMITED): bolan_sea_state_limit() has the rules. Queries never return waves that no water can carry.
///
/// **Synthesis.** eta(x, t) = sum over k of h(k, t) e^{i k.x}, h(k, t) = h0(k) e^{-i w t} + conj(h0(-k)) e^{+i w t},
/// h0(k) = sqrt(integral of Psi over the cell of k / 2) e^{i phase}, phases random. Waves run toward k, and the
/// variance of eta is that of the spectrum in each realisation (Tessendorf 2001, section 3, with the sign and the
/// factor of a one-sided spectrum, and amplitudes that are not random). D = i k/|k| coth(kh) h. w follows
/// bolan_omega_from_k(). Beyond ten times the wave number of the shortest spectral peak, and beyond the last frequency
/// of a measured spectrum, the power is rolled off, so that the slope variance of all cascades stays below Cox & Munk's
/// total for the wind; where the waves before that pass it, they are kept.
///
/// **Current.** On a current U a wave runs over the ground at omega = w + k.U: the sea of FFT and TEXTURES is that of
/// water at rest, drifting by U t, with its foam. Seas of FFT cannot both drift and loop; the frames of TEXTURES repeat
/// while their tile drifts. bolan_sea_state.frame says how a spectrum depends on the current. Where that blocks 99 % of
/// the energy and more, one warning says so (SEA_BLOCKED).
///
/// **Fields on demand.** A step notes the time. The first call afterwards that reads a field makes all of them, by
/// bolan_sea_fields(): samples, queries, cascades, measures, hashes. A sea that is drawn by the compute backend of a
/// renderer and asked nothing is never synthesised on the CPU, but for its fine waves.
///
/// **Threads.** Different seas may be used from different threads at the same time. One sea is stepped by one thread at
/// a time; between steps any number of threads may read it: the first makes the fields while the others wait. Forks of
/// a sea count as different seas: bolan_sea_fork().
#ifndef BOLAN_WAVES_H
#define BOLAN_WAVES_H

#include "bolan/base.h"
#include "bolan/math.h"
#include "bolan/spectrum.h"

#ifdef __cplusplus
extern "C" {
#endif

// ---- models ---------------------------------------------------------------------------------------------------------

/// How waves are made of a sea state.
typedef enum bolan_wave_model {
    /// Cascades of inverse FFTs of a random sea.
    BOLAN_WAVES_FFT,
    /// A sum of frequencies x directions cosine waves (Liu, Xu & Chen 2009).
    BOLAN_WAVES_COSINES,
    /// A sum of few waves exp(s cos): sharp crests, wide troughs (Liu & Xie 2010).
    BOLAN_WAVES_EXP_COSINE,
    /// One tile of FFT whose time runs in a loop of few still frames (Ma, Zhu & Gong 2006).
    BOLAN_WAVES_TEXTURES,
} bolan_wave_model;
/// Number of wave models.
#define BOLAN_WAVE_MODELS 4
/// The names that the command line and scene files use, "fft" ...; by bolan_wave_model, NULL at the end.
BOLAN_API extern const char *const bolan_wave_model_names[BOLAN_WAVE_MODELS + 1];

/// What the fields of a sea are read from. Several wave models have one form.
typedef enum bolan_wave_form {
    /// Periodic tiles: bolan_sea_cascade().
    BOLAN_FORM_CASCADES,
    /// Cosine waves: bolan_sea_get_component().
    BOLAN_FORM_COSINES,
    /// Waves exp(s cos): bolan_sea_get_component(), and exp_cosine.sharpness of the desc.
    BOLAN_FORM_EXP_COSINES,
} bolan_wave_form;

/// How BOLAN_WAVES_COSINES cuts a spectrum into frequencies.
typedef enum bolan_frequency_split {
    /// All waves have the same height; they have no common period.
    BOLAN_SPLIT_EQUAL_ENERGY,
    /// Equal steps of frequency between the quantiles .002 and .998 of the energy, as the paper.
    /// The groups of waves repeat after 2 pi / step (32 s at Hs 3 m).
    BOLAN_SPLIT_EQUAL_WIDTH,
} bolan_frequency_split;
/// Number of ways to cut a spectrum.
#define BOLAN_FREQUENCY_SPLITS 2
/// The names that scene files use, "equal-energy" ...; by bolan_frequency_split, NULL at the end.
BOLAN_API extern const char *const bolan_frequency_split_names[BOLAN_FREQUENCY_SPLITS + 1];

/// Most cascades of a sea.
#define BOLAN_MAX_CASCADES 4
/// Most frequencies of BOLAN_WAVES_COSINES.
#define BOLAN_MAX_FREQUENCIES 64
/// Most directions of BOLAN_WAVES_COSINES.
#define BOLAN_MAX_DIRECTIONS 32
/// Most waves of BOLAN_WAVES_EXP_COSINE.
#define BOLAN_MAX_EXP_WAVES 16
/// Most frames of BOLAN_WAVES_TEXTURES.
#define BOLAN_MAX_LOOP_FRAMES 64

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

    /// Order of the surface in the steepness of the waves, of FFT and TEXTURES.
    /// 1..2; default 1, a linear sea, symmetric about its level.
    /// 2: with the bound waves of second order, which make crests higher and sharper than troughs are deep
    /// (Longuet-Higgins 1963; Sharma & Dean 1981): see bolan_bound_weights.
    /// Sums of waves have order 1 alone: one warning says so (SEA_ORDER). Waves too high for the theory in their depth
    /// have lower bound waves, with one warning (SEA_BOUND_LIMITED).
    uint32_t order;

    /// Time after which every field repeats [s], bit for bit.
    /// 10..1e6, or 0 (default): no repetition.
    /// Frequencies are rounded to multiples of 1 / period; from 200 s on the rounding is not visible.
    /// With FFT and a current there is no loop: refused.
    /// TEXTURES has its own period, textures.period.
    double loop_period;

    /// Samples along the side of a tile, of FFT and TEXTURES.
    /// A power of two, 32..1024; default 256.
    /// Raised: shorter waves with the same number of tiles, and pixels nearer to the exact slopes; time and memory grow
    /// with its square. From 128 on all resolutions show the same waves.
    uint32_t resolution;

    /// Side of the largest tile [m], of FFT and TEXTURES.
    /// 10..1e5, or 0 (default): 16 peak wavelengths and at least 12 of the longest swell that matters, rounded up in
    /// quarters of an octave; of TEXTURES 7 and 5.
    /// Raised: more waves at the peak, which return to a point later; the shortest wave is longer.
    double length;

    /// e-folding time of the foam memory [s], of FFT and TEXTURES.
    /// 0.1..60; default 9: whitecaps last for 1 to 3 s on the water that they began on.
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
BOLAN_API extern const bolan_param_table bolan_sea_params;

// ---- a sea ----------------------------------------------------------------------------------------------------------

/// A sea: spectrum tables, and the fields of one time.
typedef struct bolan_sea bolan_sea;

/// Returns the defaults named above the fields: a fresh breeze over the open sea. Thread-safe.
BOLAN_API bolan_sea_desc bolan_sea_desc_default(void);

/// Memory of a sea [bytes].
typedef struct bolan_sea_bytes {
    /// Of the spectrum and all tables, which forks share.
    size_t tables;
    /// Of the fields, which every sea and every fork has.
    size_t fields;
} bolan_sea_bytes;

/// Returns the memory that a sea of this desc will hold, without creating it: exact with as many workers as now, since
/// fields include scratch memory for each. The creation borrows up to 1 MB more.
/// Both are 0 where the desc is not valid, with the field named in the log. Allocates nothing. Thread-safe.
BOLAN_API bolan_sea_bytes bolan_sea_size(const bolan_sea_desc *desc);

/// Creates a sea: builds the spectrum tables and reserves all memory, so that no later call allocates.
/// The sea stands at time 0.
/// The desc is copied; a measured spectrum in it is not needed afterwards.
/// Uses the task hook; a sea steps on at most as many workers as there were at its creation.
/// Errors: ARGUMENT, with the field named in the log, and MEMORY. Then *out is NULL. Thread-safe.
BOLAN_API bolan_result bolan_sea_create(const bolan_sea_desc *desc, bolan_sea **out);

/// Creates a sea that shows the same waves as @p sea at another time, for example for a physics thread.
/// The fork shares the spectrum and all tables with @p sea, which are constant, and has fields and a foam memory of its
/// own. At equal times the fields of all forks have the same bits.
/// The fork stands at time 0, with an empty foam memory, whatever the time of @p sea.
/// It lives on its own: forks and their origin may be destroyed in any order, on any thread.
/// Its memory is that of the fields alone.
/// Errors: MEMORY. Then *out is NULL. Thread-safe, also during a step of @p sea.
BOLAN_API bolan_result bolan_sea_fork(const bolan_sea *sea, bolan_sea **out);

/// Destroys a sea. NULL-safe; sets the pointer to NULL.
/// The tables that forks share are released with the last of them.
BOLAN_API void bolan_sea_destroy(bolan_sea **sea);

/// Moves the sea to @p time [s]: any finite value, backwards too.
/// Its fields are made when one of them is read: bolan_sea_fields().
/// Beyond 2^36 s, 2000 years, the time wraps round.
/// A step to the time of the last step does nothing. Never fails.
BOLAN_API void bolan_sea_step(bolan_sea *sea, double time);

/// Like bolan_sea_step(), with a full foam memory, so that a single image has the foam of a sea that has run.
/// Its fields are made by the ticks of 5 foam_decay before @p time. A tick costs about a quarter of a synthesis: 5 of
/// them for each second of foam_decay.
BOLAN_API void bolan_sea_settle(bolan_sea *sea, double time);

/// Makes the fields of the present time, unless they are made already. Every function that reads a field calls it.
/// It catches up with the ticks of the foam memory since the fields were made the last time, at most those of 5
/// foam_decay.
/// Call it after a step to choose the moment of the work, and before jobs of your own task system read the sea: a job
/// that waits for the fields must not run on a thread that is making them.
/// Uses the task hook. Thread-safe between steps.
BOLAN_API void bolan_sea_fields(const bolan_sea *sea);

/// Returns the time of the last step [s].
/// A sea of TEXTURES shows the frame of its loop at that time.
/// Thread-safe between steps, like every function below that says nothing else.
BOLAN_API double bolan_sea_time(const bolan_sea *sea);

/// Returns the number of the sea: never 0, equal for all forks, and different for all other seas of this process.
/// Compare it, not the address, to tell whether something made from a sea still belongs to it.
/// Thread-safe, also during a step.
BOLAN_API uint64_t bolan_sea_id(const bolan_sea *sea);

/// Returns the number of the present fields: never 0 and unique in this process, so that equal serials mean equal
/// fields. Every step and settle changes it, except a step to the time of the last step.
BOLAN_API uint64_t bolan_sea_serial(const bolan_sea *sea);

/// Returns the desc the sea was made from, defaults resolved; `measured` is NULL.
/// Valid while the sea lives. Thread-safe, also during a step.
BOLAN_API const bolan_sea_desc *bolan_sea_get_desc(const bolan_sea *sea);

/// Returns the integral parameters of the sea state, lowered by bolan_sea_state_limit(); of a measured spectrum too.
/// Computed at creation. Valid while the sea lives. Thread-safe, also during a step.
BOLAN_API const bolan_sea_summary *bolan_sea_get_summary(const bolan_sea *sea);

/// Returns when the measured spectrum was taken, ISO 8601; "" when it does not say or there is none.
/// Valid while the sea lives. Thread-safe, also during a step.
BOLAN_API const char *bolan_sea_record_time(const bolan_sea *sea);

/// Returns what the fields are read from. Thread-safe, also during a step.
BOLAN_API bolan_wave_form bolan_sea_form(const bolan_sea *sea);

/// How a sea repeats in time.
typedef struct bolan_sea_loop {
    /// Time after which every field repeats [s]; 0: never.
    double period;
    /// Number of still frames in the period; 0 where the sea moves continuously.
    uint32_t frames;
    /// The frame that the fields show, 0..frames - 1; 0 where there are no frames.
    uint32_t frame;
} bolan_sea_loop;
/// Returns how the sea repeats in time, and the present frame.
BOLAN_API bolan_sea_loop bolan_sea_get_loop(const bolan_sea *sea);

/// Returns what band @p index adds to every height to keep the mean of the surface at the water level [m].
/// It is >= 0 with order 1. Bound waves have a mean of their own, which it takes away.
/// A band is a cascade, or all components of a sum (index 0).
/// @p spacing [m] is that of the grid that carries the waves; 0: a single point.
/// 0 without choppiness and for EXP_COSINE, whose parcels do not move sideways. Thread-safe, also during a step.
BOLAN_API double bolan_sea_lift(const bolan_sea *sea, uint32_t index, double spacing);

// ---- cascades -------------------------------------------------------------------------------------------------------

/// Weights [1/m] of the bound waves of a cascade, all 0 with order 1. With eta_c and D_c the height and displacement of
/// cascade c at a rest point (choppiness not applied), parcels stand higher by
///
///     sum over c of  eta_c (height eta_c + H_c) + D_c . (drift D_c + G_c),
///     H_c = sum over longer cascades l of  height_long_l eta_l,   G_c = sum of  drift_long_l D_l.
///
/// Where shallow water attenuates cascades, eta_c and D_c are the attenuated ones.
typedef struct bolan_bound_weights {
    /// Of a cascade with itself.
    double height, drift;
    /// Of a cascade with every shorter one.
    double height_long, drift_long;
} bolan_bound_weights;

/// Columns and rows of bolan_cascade_view.displacement that repeat the first ones.
#define BOLAN_CASCADE_GUARD 4

/// A sample of the displacement of a cascade: 16 bytes, so that the 4 x 4 samples of a spline are four rows of 64.
typedef struct bolan_sea_texel {
    /// D, world east and north [m].
    float dx, dy;
    /// eta [m].
    float height;
    /// dDx/dy (= dDy/dx), by the place read.
    float dxy;
} bolan_sea_texel;

/// One cascade, read-only.
/// The pointers are valid while the sea lives. What they point to is of the present time until the next step; call
/// bolan_sea_cascade() again after it.
/// Sample (i, j) of a field is at [j * n + i], of displacement at [j * pitch + i]. It lies at tile coordinates
/// (i, j) * length / n. A rest point is read at
/// (x, y) = bolan_sea_place_read(); from there to the tile: rotate by -angle, u = x cos(angle) + y sin(angle),
/// v = -x sin(angle) + y cos(angle).
/// Height, dx and dy are coefficients of cubic B-splines: the field at a sample is the mean of 3 x 3 with weights
/// (1, 4, 1)/6 each way. The other fields are read by linear interpolation, which leaves them the slope variance of the
/// waves.
typedef struct bolan_cascade_view {
    /// Samples along a side.
    uint32_t n;
    /// Side of the tile [m].
    double length;
    /// Rotation of the tile against the world, counter-clockwise [rad].
    double angle;
    /// Ring of wave numbers [rad/m]: k_min <= |k| < k_max.
    double k_min, k_max;
    /// Expected variance of the height, the discrete sum over the ring [m2].
    double variance;
    /// Expected slope variance of the ring.
    double mss;
    /// Of its bound waves.
    bolan_bound_weights bound;
    /// Where sample (0, 0) lies in the world [m]: the tile drifts from the world origin with the current.
    /// bolan_sea_place_read() has taken it off.
    double origin_x, origin_y;
    /// Rows of @c pitch samples, n of each and then its first BOLAN_CASCADE_GUARD again. As many of the first rows
    /// follow row n - 1. So the 4 x 4 samples of a spline never wrap round: they begin at a column and a row below n.
    const bolan_sea_texel *displacement;
    /// Samples from one row of @c displacement to the next: n + BOLAN_CASCADE_GUARD.
    uint32_t pitch;
    /// Gradient of the height, by the place read.
    const float *slope_x, *slope_y;
    /// dDx/dx, dDy/dy, by the place read.
    const float *dxx, *dyy;
    /// Foam memory, 0..3: recent peak of -(dxx + dyy) * choppiness, decaying.
    const float *foam;
    /// n * n * 4 halfs to upload as RGBA16F: dx, dy, height, dxy.
    const uint16_t *displacement_half;
    /// n * n * 4 halfs: slope_x, slope_y, dxx, dyy.
    const uint16_t *slope_half;
    /// n * n halfs: foam.
    const uint16_t *foam_half;
} bolan_cascade_view;
/// Returns the number of cascades: 1..BOLAN_MAX_CASCADES of form CASCADES, else 0. Thread-safe, also during a step.
BOLAN_API uint32_t bolan_sea_cascade_count(const bolan_sea *sea);
/// Returns cascade @p index; 0 is the one of the longest waves.
BOLAN_API bolan_cascade_view bolan_sea_cascade(const bolan_sea *sea, uint32_t index);
/// Like bolan_sea_cascade(), without the planes: the pointers are NULL, and no fields are made.
BOLAN_API bolan_cascade_view bolan_sea_cascade_layout(const bolan_sea *sea, uint32_t index);

/// The fine waves of a sea of model FFT: capillary-gravity waves from the last cascade's ring down to 1 cm, of which
/// pixels near the eye read the slopes.
/// They have most of the slope variance that Cox & Munk state for the wind and the cascades lack. Their height is a
/// millimetre, which queries leave out, as they do the slopes.
/// Sample (i, j) is at [j * n + i]. It lies at tile coordinates (i, j) * length / n, as that of a bolan_cascade_view.
typedef struct bolan_sea_fine_view {
    /// Samples along a side; 0: there are none, and the rest is 0.
    uint32_t n;
    /// Side of the tile [m], and its rotation against the world, counter-clockwise [rad].
    double length, angle;
    /// Ring of wave numbers [rad/m].
    double k_min, k_max;
    /// Expected slope covariance xx, xy, yy.
    double slopes[3];
    /// Gradient of the height by the place read, to be read linearly.
    const float *slope_x, *slope_y;
    /// n * n * 4 halfs to upload as RGBA16F: slope_x, slope_y, and two fields without a use.
    const uint16_t *slope_half;
} bolan_sea_fine_view;
/// Like bolan_sea_fine(), without the planes: the pointers are NULL, and nothing is made.
BOLAN_API bolan_sea_fine_view bolan_sea_fine_layout(const bolan_sea *sea);
/// Returns the fine waves at the present time, which the first call after a step makes; bolan_sea_fields() does not.
/// The pointers are valid while the sea lives; what they point to is of the present time until the next step.
/// Thread-safe between steps. Source: Phillips 1958 (k^-4), Cox & Munk 1954 (variance), Lamb 1932 (dispersion).
BOLAN_API bolan_sea_fine_view bolan_sea_fine(const bolan_sea *sea);

/// Most waves that a mode has.
#define BOLAN_MODE_PARTS 4
/// Modes (i, j) with |i| and |j| below have several waves; others have one, part 0.
#define BOLAN_MODE_PART_REACH 16
/// One wave of a mode (i, j) of a cascade, wave vector 2 pi (i, j) / length in the axes of the tile.
/// A mode near the origin is the sum of several waves with one wave vector: its cell of the spectrum is wide, and each
/// wave has the frequency of a slice of the cell.
/// At time t, with c + i s = e^{2 pi i turns t}, the amplitude of the height is
/// h = (a[0] c + a[1] s) + i (a[2] c + a[3] s).
/// It stands for -(i, j) as well, whose amplitude is the conjugate.
typedef struct bolan_sea_mode {
    /// a of the formula above [m].
    float a[4];
    /// coth(|k| depth) / |k| [m]; D = i k inverse_k h.
    float inverse_k;
    /// Divisor of a field that a cubic B-spline reads, and of one that is read linearly: planes are h, D or their
    /// derivatives over these.
    float cubic, linear;
    /// Frequency [1/s]; 0: there is no such wave.
    double turns;
} bolan_sea_mode;
/// Returns how many rows of modes a cascade has: j = 0 .. rows - 1; the others are empty. Thread-safe, also during a
/// step.
BOLAN_API uint32_t bolan_sea_mode_rows(const bolan_sea *sea, uint32_t cascade);
/// Copies waves @p part, 0 .. BOLAN_MODE_PARTS - 1, of row @p j of the modes of a cascade: out[0 .. n - 1], where entry
/// i holds -n/2 <= i < n/2 modulo n.
/// For a synthesis of your own, on a GPU. Row 0 holds both (i, 0) and (-i, 0). Thread-safe, also during a step.
BOLAN_API void bolan_sea_modes(const bolan_sea *sea, uint32_t cascade, uint32_t part, uint32_t j, bolan_sea_mode *out);

/// What a synthesis of your own needs of the present time, besides the modes.
/// The foam memory has a tick every 0.25 s about. With pinch = min(max(-(dxx + dyy) choppiness, 0), 3), it is
/// F(k) = max(tick_keep F(k - 1) - tick_lose, pinch at tick k), and the foam is
/// max(keep F(tick) - lose, pinch at the present time).
/// Foam drifts with the wind over the water: sample x of F(k) is the foam that stands at x + bolan_sea_foam_drift(k),
/// and F(tick) is read at x - bolan_sea_foam_drift(now), bilinearly between its samples.
typedef struct bolan_sea_clock {
    /// Time of the waves [s]: that of the last step, reduced by the loop.
    double shown;
    /// Number of the last tick.
    double tick;
    /// Number of the present time: `tick`, and the part of a tick since.
    double now;
    /// F(first_tick) is 0.
    double first_tick;
    /// Number that changes when the memory is lost, by a jump in time or by bolan_sea_settle().
    double foam_from;
    /// Of the last tick, what is left now.
    float keep, lose;
    /// Of a tick, what is left at the next one.
    float tick_keep, tick_lose;
} bolan_sea_clock;
/// Returns the present clock; makes no fields.
BOLAN_API bolan_sea_clock bolan_sea_get_clock(const bolan_sea *sea);
/// Returns the time of the waves at a tick of the foam memory [s]. Thread-safe, also during a step.
BOLAN_API double bolan_sea_tick_time(const bolan_sea *sea, double tick);
/// Returns how far foam has drifted over the water by a tick, along the axes of the tile of a cascade.
/// The unit is 2^-32 of the length of the tile, modulo that length, so that products with whole numbers are exact. The
/// speed is 3.1 % of the wind speed (Wu 1983). With a loop it is rounded to whole tiles in a loop, which it so closes.
/// @p tick is a number of a tick, or between two. Thread-safe, also during a step.
BOLAN_API void bolan_sea_foam_drift(const bolan_sea *sea, uint32_t cascade, double tick, uint32_t out[2]);

#define BOLAN_WARP_WAVES 6 ///< most waves of a bolan_sea_warp
/// The warped plane over which the tiles of a sea are read. A sea that is seen from afar would show its tiles, because
/// what is one tile away is the same. So a rest point x is read at x + sum of a w(k.x + phase), w a wave of period and
/// amplitude 1 made of two parabolas: with u = 2 fract(k.x + phase) - 1 it is 4 u (1 - |u|). That moves waves by a few
/// times their length, slowly. Distances and directions change by some per cent; frequencies, and everything at a
/// point, do not change.
typedef struct bolan_sea_warp {
    /// Waves of the warp; 0: the plane is even.
    uint32_t count;
    struct {
        /// Wave vector [turns/m] and phase at the world origin [turns].
        double kx, ky, phase;
        /// Amplitude, a vector across the wave [m].
        double ax, ay;
    } wave[BOLAN_WARP_WAVES];
} bolan_sea_warp;
/// Returns the warp of a sea. Thread-safe, also during a step.
BOLAN_API bolan_sea_warp bolan_sea_get_warp(const bolan_sea *sea);
/// Returns the place at which the cascades are read for the rest point (@p x, @p y).
/// @p gradient receives dplace/drest: xx, xy, yx, yy. Thread-safe, also during a step.
BOLAN_API bolan_dvec2 bolan_sea_place_read(const bolan_sea *sea, double x, double y, double gradient[4]);

// ---- components -----------------------------------------------------------------------------------------------------

/// One wave of a sum. At rest point x and time t, with th = k.x - omega t + phase:
/// COSINES: eta = amplitude cos th, D = -drift k/|k| sin th, drift = amplitude coth(|k| depth).
/// EXP_COSINES: eta = amplitude (e^{s (cos th - 1)} - mean) * 2 / (1 - e^{-2s}), mean = e^{-s} I0(s), which has zero
/// mean and the range 2 amplitude. D = 0, because the crests are sharp already: choppiness does nothing, and the
/// Jacobian is 1.
typedef struct bolan_sea_component {
    /// Wave vector [rad/m]; points where the wave goes.
    double kx, ky;
    /// Frequency over the ground [rad/s]; < 0 where the current carries the wave back.
    double omega;
    /// Phase at the world origin and time 0 [rad], 0..2 pi.
    double phase;
    /// Amplitude [m].
    double amplitude;
    /// Amplitude of the horizontal displacement, choppiness not applied [m]; 0 with EXP_COSINES.
    double drift;
} bolan_sea_component;
/// Returns the number of waves of a sum; 0 of form CASCADES. Thread-safe, also during a step.
BOLAN_API uint32_t bolan_sea_component_count(const bolan_sea *sea);
/// Returns wave @p index of the sum; 0 is the longest. Thread-safe, also during a step.
BOLAN_API bolan_sea_component bolan_sea_get_component(const bolan_sea *sea, uint32_t index);

// ---- samples --------------------------------------------------------------------------------------------------------

/// The sea at one rest point: all bands summed (cascades by cubic splines), choppiness and lift applied.
typedef struct bolan_sea_sample {
    /// Displacement of the parcel: (x, y, z) = (x0 + dx, y0 + dy, height) [m].
    float height, dx, dy;
    /// Slope of the surface dz/dx, dz/dy *after* displacement.
    /// Where |jacobian| < 0.1, the slope for |jacobian| = 0.1.
    float slope_x, slope_y;
    /// Jacobian of the horizontal map; < 0 where the surface folds.
    float jacobian;
    /// Sum of the foam memories, >= 0.
    /// Sums of waves have no memory: the present -(dDx/dx + dDy/dy) choppiness where it is > 0.
    float foam;
} bolan_sea_sample;

/// Samples the sea at @p count rest points in world metres.
/// Sums of waves use the task hook.
BOLAN_API void bolan_sea_sample_rest(const bolan_sea *sea, const bolan_dvec2 *points, uint32_t count,
                                     bolan_sea_sample *out);

/// Like bolan_sea_sample_rest(), low-passed for a grid, so that nothing aliases. Uses the task hook.
/// @p spacing[i] >= 0 [m] is the distance of point i to its neighbours. NULL: no low-pass.
/// Waves fade out from 4 to 2 spacings of length.
/// A cascade is averaged over a square of two spacings by up to 4 x 4 texture fetches, and fades as a whole from 4 to 2
/// spacings of its longest wave: waves shorter than two spacings keep about 1/16 of their energy.
/// For sums this is the fast way to displace a mesh, by SIMD over the points.
BOLAN_API void bolan_sea_sample_grid(const bolan_sea *sea, const bolan_dvec2 *points, const float *spacing,
                                     uint32_t count, bolan_sea_sample *out);

/// The oracle of bolan_sea_sample_rest(): the same quantities at one rest point and any time by the direct sum over
/// every mode, in double, with the same lift. The foam of the result is 0.
/// O(n^2) a point. Thread-safe, also during a step.
BOLAN_API bolan_sea_sample bolan_sea_sample_direct(const bolan_sea *sea, double x, double y, double time);

/// Returns bounds that the surface does not leave, 6 standard deviations: vertical with the lift [m], horizontal with
/// the choppiness [m]. Thread-safe, also during a step.
BOLAN_API void bolan_sea_bounds(const bolan_sea *sea, double *vertical, double *horizontal);

// ---- roughness, foam, measures --------------------------------------------------------------------------------------

/// Returns the slope covariance that a filter removes: what a pixel or a radar cell cannot resolve and must treat as
/// roughness.
/// The filter is a Gaussian footprint of standard deviations @p major, @p minor [m], whose major axis points along
/// @p angle (mathematical, rad). It keeps exp(-sigma^2 k^2) of the power of a wave.
/// Waves shorter than the last cascade are always removed: Cox & Munk's total for the wind less what the cascades hold.
/// With major = minor = 0 they alone are left.
/// @p out: xx, xy, yy.
/// Thread-safe, also during a step. Source: Bruneton, Neyret & Holzschuch 2010, section 4.
BOLAN_API void bolan_sea_unresolved_slopes(const bolan_sea *sea, double major, double minor, double angle,
                                           float out[3]);

/// Texels of the slope table along log2(major): texel i is major = 2^(i/1.5 - 11) m, from 0.5 mm to 200 m.
#define BOLAN_SLOPE_TABLE_MAJOR 29
/// Texels along minor/major: texel j is 2^-j.
#define BOLAN_SLOPE_TABLE_ASPECT 8
/// Texels along the angle, periodic: texel l is l pi / 8.
#define BOLAN_SLOPE_TABLE_ANGLE 8
/// Returns bolan_sea_unresolved_slopes() as a table to sample with linear filtering:
/// out[((l * ASPECT) + j) * MAJOR + i][4] = xx, xy, yy, and the share of their slope variance that the footprint
/// removes of the fine waves. Where they are drawn (bolan_sea_fine()), take off what they keep: slopes * (1 - share).
/// Computed at creation. Valid while the sea lives. Thread-safe, also during a step.
BOLAN_API const float *bolan_sea_slope_table(const bolan_sea *sea);

/// Returns the Jacobian below which there is foam.
/// It is the quantile of the Jacobian that covers bolan_monahan_cover() of the surface for the wind; above 1 where more
/// than about half is covered.
/// -1e30 where nothing foams: without wind, without waves, and with EXP_COSINE.
/// Computed at creation. Thread-safe, also during a step.
BOLAN_API double bolan_sea_foam_threshold(const bolan_sea *sea);
/// Returns the Jacobian below which a crest is breaking: the quantile that covers bolan_breaker_cover() of the surface.
/// Where the sea has no foam memory, which would hold the older foam, it covers bolan_callaghan_cover().
/// -1e30 where nothing breaks. Thread-safe.
BOLAN_API double bolan_sea_breaker_threshold(const bolan_sea *sea);

/// Statistics of the surface at the present time, as queries return and images show it: the JSON keys of `bolan
/// measure`. They are taken at 65536 places. At fixed points a parcel counts by the area that it covers, its Jacobian.
typedef struct bolan_sea_statistics {
    /// 4 sqrt(m0_field) [m].
    double hs;
    /// Periods of the discrete spectrum that is synthesised [s]; of a measured spectrum, of the file.
    /// On a current: tp in the water, which goes with the length of the waves; tm02 and te over the ground.
    double tp, tm02, te;
    /// Mean direction and spread of the realised amplitudes [deg]; of a measured spectrum, of the file.
    double direction_from, spread;
    /// Slope variance of the displaced surface at fixed points, and its up- and crosswind parts (of the mean direction
    /// when calm).
    double mss, mss_up, mss_cross;
    /// Of the height at fixed points; 0 and 3 for linear waves, with choppiness too.
    double skewness, kurtosis;
    /// Mean height at fixed points [m]; 0 but for sampling.
    double mean_level;
    /// Over all parcels.
    double jacobian_min, jacobian_mean;
    /// Share of the parcels whose Jacobian is below the foam threshold.
    double whitecap_fraction;
    /// Variance of the limited sea state; of a measured spectrum over its own frequencies [m2].
    double m0_spectrum;
    /// Variance of the height at fixed points [m2].
    double m0_field;
} bolan_sea_statistics;
/// Measures the surface over the largest tile, or of a sum over 50 of its longest waves.
/// As slow as a step.
BOLAN_API bolan_sea_statistics bolan_sea_measure(const bolan_sea *sea);

/// Writes a digest of every field at the present time, the foam memory excluded: 16 lower-case hex digits and NUL.
/// Of a sum, of the fields at 4096 places.
/// Equal for any thread count, any instruction set and any fork.
BOLAN_API void bolan_sea_hash(const bolan_sea *sea, char out[17]);

#ifdef __cplusplus
}
#endif
#endif

// SPDX-License-Identifier: MIT
/// @file spectrum.h
/// Tier 1. Sea states as directional wave spectra: model spectra, directional spreading, measured spectra
/// (read by formats.h), dispersion, and sea-state tables. Pure functions; every one is thread-safe. Densities use no
/// libm function that differs between machines, so a sea state gives the same bits everywhere.
///
/// Convention: S(w, th) is the one-sided directional variance density [m2 s/rad per rad]; w = angular frequency
/// [rad/s]; th = mathematical angle where the waves GO [rad]. The integral over w and th is m0 [m2]; Hs = 4 sqrt(m0).
#ifndef BOLAN_SPECTRUM_H
#define BOLAN_SPECTRUM_H

#include "bolan/base.h"
#include "bolan/params.h"

#ifdef __cplusplus
extern "C" {
#endif

// ---- dispersion -----------------------------------------------------------------------------------------------------

/// Surface tension over density of sea water, sigma / rho [m3/s2].
#define BOLAN_SURFACE_TENSION_SEA 7.17e-5
/// A depth [m] that is deep for every wave of the sea.
#define BOLAN_DEEP 1.0e4

/// w(k): w^2 = (g k + (sigma/rho) k^3) tanh(k h). @p k wave number [rad/m] >= 0, @p depth [m] > 0. [rad/s]
/// Linear theory of gravity-capillary waves over a flat bottom.
BOLAN_API double bolan_omega_from_k(double k, double depth);
/// The inverse, to 1e-12 relative (Guo 2002, eq. 13, as first guess, then Newton). @p omega [rad/s] >= 0. [rad/m]
BOLAN_API double bolan_k_from_omega(double omega, double depth);
/// Group speed dw/dk [m/s] at wave number k > 0.
BOLAN_API double bolan_group_speed(double k, double depth);

// ---- model spectra --------------------------------------------------------------------------------------------------

/// The shape of a spectrum in frequency.
typedef enum bolan_spectrum_kind {
    /// Fully developed sea (Pierson & Moskowitz 1964).
    BOLAN_SPECTRUM_PIERSON_MOSKOWITZ,
    /// Fetch-limited sea (Hasselmann et al. 1973).
    BOLAN_SPECTRUM_JONSWAP,
    /// JONSWAP in water of finite depth (Bouws et al. 1985).
    BOLAN_SPECTRUM_TMA,
    /// A exp(-1/(kL)^2) k^-4 cos^2 e^{-k^2 l^2} of computer graphics (Tessendorf 2001).
    /// It is Pierson-Moskowitz with k = w^2/g and L = (4/5)^(1/2) g / wp^2, cut off below l = L/1000.
    BOLAN_SPECTRUM_PHILLIPS,
    /// w^-4 exp(-(wp/w)^4) gamma^r, whose gamma and width follow U/cp (Donelan, Hamilton & Hui 1985).
    BOLAN_SPECTRUM_DONELAN,
    /// Gravity and capillary waves in one formula of wave number, U10 and U/cp (Elfouhaily et al. 1997, eq. 30 to 44).
    /// Its short waves end by themselves: a sea of this kind is not rolled off to Cox & Munk's slope variance.
    BOLAN_SPECTRUM_ELFOUHAILY,
    /// w^-(4 lambda + 1) exp(-(lambda + 1/4) (wp/w)^4): one peak of Ochi & Hubble (1976). lambda 1: Pierson-Moskowitz.
    BOLAN_SPECTRUM_OCHI_HUBBLE,
    /// w^-4 exp(-(wp/w)^4) gamma^r with the widths of JONSWAP: one peak of Torsethaugen & Haver (2004).
    BOLAN_SPECTRUM_TORSETHAUGEN,
} bolan_spectrum_kind;
/// Number of spectrum kinds.
#define BOLAN_SPECTRUM_KINDS 8
/// Number of spectrum kinds that follow from a wind and a fetch: the first ones.
#define BOLAN_WIND_SPECTRUM_KINDS 6
/// The names that the command line and scene files use, "pierson-moskowitz" ...; by bolan_spectrum_kind.
/// NULL at the end.
BOLAN_API extern const char *const bolan_spectrum_kind_names[BOLAN_SPECTRUM_KINDS + 1];
/// The names of the kinds that follow from a wind and a fetch. NULL at the end.
BOLAN_API extern const char *const bolan_wind_spectrum_names[BOLAN_WIND_SPECTRUM_KINDS + 1];

/// The shape of a spectrum in direction.
typedef enum bolan_spreading_kind {
    /// (2/pi) cos^2 th on +-90 deg (ITTC).
    BOLAN_SPREADING_COS2,
    /// N(s) cos^{2s}(th/2), the same s at all frequencies.
    BOLAN_SPREADING_COS2S,
    /// cos-2s with s(w/wp, U/cp) (Hasselmann, Dunckel & Ewing 1980).
    BOLAN_SPREADING_HASSELMANN,
    /// cos-2s with s = sp (w/wp)^5 below the peak and sp (w/wp)^-2.5 above, sp = 11.5 (U/cp)^-2.5 (Mitsuyasu et al.
    /// 1975). s is at most 200.
    BOLAN_SPREADING_MITSUYASU,
    /// sech^2(b th) with b(w/wp) (Donelan, Hamilton & Hui 1985; above 1.6 wp Banner 1990).
    BOLAN_SPREADING_DONELAN_BANNER,
    /// 1 + D cos 2 th with D(w, U) on the half circle of the wind (Elfouhaily et al. 1997, eq. 49 and 57).
    /// The paper's is equal for waves with and against the wind; here all waves go with it.
    BOLAN_SPREADING_ELFOUHAILY,
} bolan_spreading_kind;
/// Number of spreading kinds.
#define BOLAN_SPREADING_KINDS 6
/// The names that scene files use, "cos2" ...; by bolan_spreading_kind. NULL at the end.
BOLAN_API extern const char *const bolan_spreading_kind_names[BOLAN_SPREADING_KINDS + 1];

/// One wind sea or swell. It is fixed by its height and peak; the helpers below derive these from wind and fetch.
typedef struct bolan_wave_system {
    /// Shape in frequency; default JONSWAP.
    bolan_spectrum_kind kind;
    /// Significant wave height 4 sqrt(m0) [m], 0..40; default 0. Of TMA: before the depth factor.
    double hs;
    /// Peak angular frequency [rad/s], 0.1..50; default 1.
    double peak_omega;
    /// Peak enhancement of JONSWAP, TMA and TORSETHAUGEN, 1..10; default 3.3. Raised: a narrower peak.
    double gamma;
    /// Shape of OCHI_HUBBLE, 0.1..10, or 0 (default): 1. Raised: a narrower peak and a steeper tail.
    double lambda;
    /// Where the waves come FROM, compass [deg], -360..360.
    double from_deg;
    /// Shape in direction; default HASSELMANN.
    bolan_spreading_kind spreading;
    /// Exponent s of COS2S, 0..200; default 10. Raised: longer crests.
    double spread_s;
    /// U10 [m/s], 0..70; default 0: U = cp, the phase speed g/wp at the peak.
    /// U/cp shapes DONELAN, ELFOUHAILY, HASSELMANN and MITSUYASU; U10 the short waves of ELFOUHAILY.
    double wind_speed;
    /// Swell parameter xi of Horvath, 0..1; default 0. Raised: longer crests.
    double swell;
} bolan_wave_system;

/// Most wave systems of a sea state.
#define BOLAN_MAX_WAVE_SYSTEMS 8

/// A measured or forecast spectrum on a grid of frequency x direction; bolan_spectrum_text lists the formats.
/// Immutable; safe to share between threads.
typedef struct bolan_measured_spectrum bolan_measured_spectrum;

/// The frame of reference of a spectrum on a current: which frequency w is.
///
/// A wave k on a current U has the frequency sigma(k) of bolan_omega_from_k() in the water, and
/// omega = sigma(k) + k.U over the ground (Doppler). Without a current the three are one.
///
/// A wave is *blocked* where the current's component against it is at least its group speed, cg(k) + U.k/|k| <= 0: its
/// energy does not get there, nor does that of shorter waves. For waves of c0 = g/omega in deep still water that is a
/// current of -c0/4.
typedef enum bolan_spectrum_frame {
    /// The observer drifts with the water: w is sigma. The waves are the same with any current and no wave is blocked,
    /// since water that moves as a whole is as good as water at rest. Wave models print spectra over sigma.
    BOLAN_FRAME_WATER,
    /// The observer stands on the ground, in the current: w is omega, as at a moored buoy.
    /// The variance stays, S(sigma, th) d sigma = S(omega, th) d omega. Blocked waves have none.
    BOLAN_FRAME_GROUND,
    /// The observer is in still water, from which the waves run into the current without turning: w is omega, which the
    /// waves keep. In every direction the flux of wave action stays, E (cg + U.k/|k|) / sigma (Bretherton & Garrett
    /// 1968): waves grow and shorten against the current, and fall and lengthen with it. Blocked waves are not there.
    BOLAN_FRAME_STILL,
} bolan_spectrum_frame;
/// Number of frames.
#define BOLAN_SPECTRUM_FRAMES 3
/// The names that scene files use, "water" ...; by bolan_spectrum_frame. NULL at the end.
BOLAN_API extern const char *const bolan_spectrum_frame_names[BOLAN_SPECTRUM_FRAMES + 1];

/// A sea: wave systems, or a measured spectrum, over water of one depth, with the local wind that roughens it.
typedef struct bolan_sea_state {
    /// Number of systems, 0..8.
    uint32_t system_count;
    /// The wind seas and swells; their energies add.
    bolan_wave_system systems[BOLAN_MAX_WAVE_SYSTEMS];
    /// A spectrum that is added to the systems, or NULL.
    /// Borrowed; it must live until bolan_sea_create() has returned.
    const bolan_measured_spectrum *measured;
    /// Depth of the water for dispersion and TMA [m], 0.1..BOLAN_DEEP; default BOLAN_DEEP.
    double depth;
    /// U10 [m/s], 0..70; it roughens the short waves and makes foam.
    double wind_speed;
    /// Where the wind comes FROM, compass [deg], -360..360.
    double wind_from_deg;
    /// Uniform current, east and north [m/s], -5..5; default 0. The waves ride on it.
    double current_x, current_y;
    /// The frame of the spectra of systems and of measured; default WATER. Without a current it makes no difference.
    bolan_spectrum_frame frame;
} bolan_sea_state;

/// The parameters of a bolan_sea_state beside its systems, and of one system.
BOLAN_API extern const bolan_param_table bolan_sea_state_params, bolan_wave_system_params;
/// A flat calm over deep water: no systems, no wind.
BOLAN_API bolan_sea_state bolan_sea_state_default(void);
/// A system without height, and the defaults named above the fields.
BOLAN_API bolan_wave_system bolan_wave_system_default(void);
/// Adds a wind sea or swell to the sea.
/// Errors: ARGUMENT with a sentence, when the list is full or a field is outside its range.
/// The sea state is then unchanged.
BOLAN_API bolan_result bolan_sea_state_add_system(bolan_sea_state *sea_state, const bolan_wave_system *system);
/// A wind sea: JONSWAP by wind and fetch, limited to the fully developed Pierson-Moskowitz sea.
/// @param wind_speed U10 [m/s], 0..70; a value outside is kept for bolan_sea_state_validate() to refuse.
/// @param from_deg where the wind comes FROM, compass [deg].
/// @param fetch [m] > 0; HUGE_VAL: no limit.
///
/// Growing sea (Hasselmann et al. 1973): alpha = 0.076 (U^2/(g F))^0.22, wp = 22 (g^2/(U F))^(1/3), gamma 3.3.
/// wp falls to the Pierson-Moskowitz peak 0.877 g / (1.026 U10); within 10 % of it gamma passes linearly into 1.
/// Hs grows with the fetch up to that of the fully developed sea, 0.209 (1.026 U10)^2 / g.
/// Hs arrives there at 0.63 of the fetch at which the peak arrives. Hs is at most 40 m.
/// No wind, no fetch, or a peak above 50 rad/s (ripples) give no system.
BOLAN_API bolan_sea_state bolan_sea_state_from_wind(double wind_speed, double from_deg, double fetch);

/// The wind sea of a Phillips spectrum, on the half plane that the wind blows to:
/// Psi(k) = 2 A exp(-1/(kL)^2) k^-4 cos^2(th) e^{-k^2 l^2}, L = U10^2/g, l = L/1000.
/// The printed form has no 2 and is equal for k and -k, so half of its energy runs against the wind.
/// Here all energy travels with the wind, with the same m0 = A pi L^2/2.
/// A = 0.0081/(2 pi) gives the tail of Pierson-Moskowitz and Hs = 0.18 U10^2/g.
/// In deep water the shape is that of Pierson-Moskowitz, with the peak at (4/5)^(1/4) g/U10.
/// Arguments and limits are those of bolan_sea_state_from_wind().
BOLAN_API bolan_sea_state bolan_sea_state_from_phillips(double wind_speed, double from_deg);

/// A wind sea after Donelan, Hamilton & Hui (1985), with Donelan-Banner spreading.
/// U/cp = 11.6 (g F/U^2)^-0.23, at least 0.83: the fully developed sea. alpha = 0.006 (U/cp)^0.55,
/// S = alpha g^2 w^-4 / wp exp(-(wp/w)^4) gamma^r, gamma = 1.7 + 6 log10(U/cp) for U/cp above 1 and 1.7 below,
/// r = exp(-(w/wp - 1)^2 / (2 s^2)), s = 0.08 (1 + 4 (U/cp)^-3). gamma and s keep their values beyond U/cp = 5.
/// Arguments and limits are those of bolan_sea_state_from_wind().
BOLAN_API bolan_sea_state bolan_sea_state_from_donelan(double wind_speed, double from_deg, double fetch);
/// A wind sea after Elfouhaily, Chapron, Katsaros & Vandemark (1997), with the paper's spreading.
/// U/cp = 0.84 tanh((g F/U^2 / 2.2e4)^0.4)^-0.75 (eq. 37). The curvature spectrum of the short waves is multiplied by
/// the cut of the long ones, exp(-1.25 (kp/k)^2), as in the authors' programs; without it m0 has no limit.
/// Arguments and limits are those of bolan_sea_state_from_wind().
BOLAN_API bolan_sea_state bolan_sea_state_from_elfouhaily(double wind_speed, double from_deg, double fetch);

/// The wind sea of a Beaufort number 0..12 (v = 0.836 B^1.5), fully developed. Other numbers are misuse.
BOLAN_API bolan_sea_state bolan_sea_state_from_beaufort(double beaufort, double from_deg);
/// The sea of a Douglas / WMO 3700 degree 0..9: Hs in the middle of the class (16 m for 9, which has no upper bound),
/// PM shape, and the wind that raises it. Other degrees are misuse.
BOLAN_API bolan_sea_state bolan_sea_state_from_douglas(int degree, double from_deg);
/// Adds a swell: JONSWAP with gamma 5 (Goda 2010: 3..10 for swell) and cos-2s spreading.
/// @param hs significant height [m].
/// @param tp peak period [s].
/// @param from_deg where the swell comes FROM, compass [deg].
/// @param spread_s exponent s of cos-2s; 25..75 is usual.
/// Errors: ARGUMENT with a sentence, when the list is full or a value is outside its range.
/// The sea state is then unchanged.
BOLAN_API bolan_result bolan_sea_state_add_swell(bolan_sea_state *sea_state, double hs, double tp, double from_deg,
                                                 double spread_s);
/// Members of Ochi & Hubble's family.
#define BOLAN_OCHI_HUBBLE_MEMBERS 11
/// Adds the two peaks of Ochi & Hubble (1976) for one height, with cos-2s spreading of s = 10.
/// @param hs significant height of the sum [m], 0..40. (In the paper's rounded table the squares of both heights add to
/// 0.995..1.009 of hs^2; here to hs^2.)
/// @param member 0 the most probable shape; 1..10 those of the 95 % confidence limit, as docs/sea-states.md lists them.
/// @param from_deg where both peaks come FROM, compass [deg].
/// Errors: as bolan_sea_state_add_system().
BOLAN_API bolan_result bolan_sea_state_add_ochi_hubble(bolan_sea_state *sea_state, double hs, uint32_t member,
                                                       double from_deg);
/// Adds the two peaks of Torsethaugen & Haver, "Simplified double peak spectral model for ocean waves" (ISOPE 2004).
/// Tp up to 6.6 hs^(1/3) is a wind sea with some swell; a longer Tp is a swell with some wind sea. The swell has cos-2s
/// spreading of s = 30, the wind sea of s = 10.
/// @param hs significant height of the sum [m], 0..40.
/// @param tp period of the higher peak [s], 1..60.
/// @param from_deg where both peaks come FROM, compass [deg].
/// Errors: as bolan_sea_state_add_system().
BOLAN_API bolan_result bolan_sea_state_add_torsethaugen(bolan_sea_state *sea_state, double hs, double tp,
                                                        double from_deg);
/// Checks every field against its range; logs a sentence and returns ARGUMENT at the first that is not.
BOLAN_API bolan_result bolan_sea_state_validate(const bolan_sea_state *sea_state);

/// Factors on the height, in (0, 1], with which water of this depth can carry the waves; 1: nothing is too high.
/// bolan_sea_create() applies the smaller factor to all waves and warns.
typedef struct bolan_sea_limit {
    /// Depth: Hs <= 0.6 depth (waves that break over a flat beach have Hrms = 0.42 depth: Thornton & Guza 1982).
    double by_depth;
    /// Steepness: the sum over the systems of (Hs / (0.142 L tanh(2 pi depth / L)))^2 is at most 1.
    /// L is the wave length at the peak of the system.
    /// So the significant wave of a lone system is at most as steep as the steepest single wave (Miche 1944).
    /// The energies of several systems add. A measured spectrum counts as one system.
    double by_steepness;
} bolan_sea_limit;
/// The limits of a valid sea state. Integrates the whole spectrum: milliseconds. Thread-safe.
BOLAN_API bolan_sea_limit bolan_sea_state_limit(const bolan_sea_state *sea_state);

/// S(w) of one system [m2 s/rad], integrated over direction, in water of @p depth [m] (TMA only); 0 at @p omega <= 0.
/// JONSWAP is (5/16) Hs^2 wp^4 C(gamma) w^-5 exp(-1.25 (wp/w)^4) gamma^r. C, as the level of every other kind, is by
/// quadrature, so that 4 sqrt(m0) is Hs.
/// ELFOUHAILY, a function of wave number, is taken at the deep-water wave number of w.
BOLAN_API double bolan_system_density(const bolan_wave_system *system, double omega, double depth);
/// D(w, th) [1/rad]: @p theta is the angle from the system's mean direction [rad]. Integrates to 1, swell factor
/// included.
BOLAN_API double bolan_system_spreading(const bolan_wave_system *system, double omega, double theta);
/// S(w, th) of the whole sea [m2 s/rad per rad], on its current: @p omega is the frequency in the water, sigma,
/// whatever the frame of the sea state. A measured spectrum is interpolated bilinearly, which conserves its m0, and is
/// 0 outside its frequencies.
BOLAN_API double bolan_sea_state_density(const bolan_sea_state *sea_state, double omega, double theta);
/// Psi(kx, ky) = S(w, th) (dw/dk) / k [m4]: variance density over wave vectors that point where the waves go, on the
/// current of the sea.
/// Includes the w^-5 tail that continues a measured spectrum above its last frequency, so that the synthesised sea
/// has short waves: level of its last band with energy, directions of its last three such bands. 0 at k = 0.
BOLAN_API double bolan_sea_state_wavenumber_density(const bolan_sea_state *sea_state, double kx, double ky);

/// Integral parameters of a sea state on its current, over the frequency in the water.
/// A calm has zeros, and the direction of the wind.
typedef struct bolan_sea_summary {
    /// Variance of the sea state [m2]; of a measured spectrum over its own frequencies.
    double m0;
    /// Significant wave height, 4 sqrt(m0) [m].
    double hs;
    /// Period of the spectral peak [s].
    double tp;
    /// Mean periods m0/m1 and sqrt(m0/m2) [s].
    double tm01, tm02;
    /// Energy period m-1/m0 [s].
    double te;
    /// Mean direction that the waves come FROM, compass [deg].
    double from_deg;
    /// Circular spread sqrt(2 (1 - r1)) [deg].
    double spread_deg;
} bolan_sea_summary;
/// Integrates the whole spectrum: milliseconds. Thread-safe.
BOLAN_API bolan_sea_summary bolan_sea_state_summary(const bolan_sea_state *sea_state);

/// A part of a sea: one wind sea or one swell.
typedef struct bolan_partition {
    /// The wind drives it; otherwise it is a swell.
    bool wind_sea;
    /// Significant height 4 sqrt(m0) of the part [m].
    double hs;
    /// Period of the peak of its S(w) [s].
    double tp;
    /// Mean direction FROM, compass [deg].
    double from_deg;
    /// Circular spread sqrt(2 (1 - r1)) [deg].
    double spread_deg;
} bolan_partition;
/// Most parts of a sea; of more the smallest join their nearest.
#define BOLAN_MAX_PARTITIONS 8
/// Splits a sea into wind sea and swells, by a watershed of S(w, th) (Hanson & Phillips 2001; Portilla et al.
/// 2009). The variances of the parts add up to that of the sea: of a measured spectrum exactly, of systems within 1 %.
/// With a wind, parts whose waves run slower than 1.5 wind_speed along it are one wind sea; without one, a part is wind
/// sea where its peak lies above that of Pierson-Moskowitz at its frequency.
/// @param out the wind seas, then the swells, each by falling height.
/// @param count receives how many; 0 of a calm.
/// Takes milliseconds. Thread-safe. Errors: MEMORY, FORMAT (a sea of more than 40 m); then count is 0.
BOLAN_API bolan_result bolan_sea_state_partition(const bolan_sea_state *sea_state,
                                                 bolan_partition out[BOLAN_MAX_PARTITIONS], uint32_t *count);

/// Slope variance of a clean surface, upwind and crosswind, by Cox & Munk (1954): 3.16e-3 U and 0.003 + 1.92e-3 U.
/// The published errors are +- 0.004 and 0.002.
/// Below 0.72 m/s the constant 0.003 fades, so that a calm is flat.
/// @param wind_speed U at 12.5 m [m/s].
BOLAN_API void bolan_cox_munk(double wind_speed, double *mss_up, double *mss_cross);
/// Fraction covered by whitecaps, by Monahan & O'Muircheartaigh (1980): 3.84e-6 U10^3.41; 0 without wind.
/// It is limited to 0.95, reached at 38 m/s: the published winds end at 17 m/s, and a hurricane leaves water uncovered.
BOLAN_API double bolan_monahan_cover(double wind_speed);
/// Fraction covered by whitecaps of all ages, by Callaghan et al. (2008): 3.18e-5 (U10 - 3.70)^3 up to about 10 m/s,
/// then 4.82e-6 (U10 + 1.98)^3; 0 up to 3.70 m/s.
/// It is limited to 0.95; the observed winds end at 23 m/s.
BOLAN_API double bolan_callaghan_cover(double wind_speed);
/// Fraction covered by crests that are breaking, the stage A of Monahan (1993): 3.16e-7 U10^3.2, at most
/// bolan_callaghan_cover().
BOLAN_API double bolan_breaker_cover(double wind_speed);

// ---- sea-state tables -----------------------------------------------------------------------------------------------

/// A class of the Douglas sea scale.
typedef struct bolan_douglas_row {
    int degree;
    /// Bounds of the significant wave height [m]; the last class has no upper bound: HUGE_VAL.
    double hs_min, hs_max;
    const char *name;
} bolan_douglas_row;
/// A class of the Beaufort wind scale.
typedef struct bolan_beaufort_row {
    int force;
    /// Bounds of the wind speed at 10 m [m/s]; the last class has no upper bound: HUGE_VAL.
    double wind_min, wind_max;
    /// Probable wave height on the open sea [m].
    double wave_height;
    const char *name;
} bolan_beaufort_row;
/// The Douglas scale by degree, WMO code 3700; a bound belongs to the lower class.
BOLAN_API extern const bolan_douglas_row bolan_douglas_table[10];
/// The Beaufort scale by force, WMO, with the probable wave height.
BOLAN_API extern const bolan_beaufort_row bolan_beaufort_table[13];
/// Returns the Douglas degree of a significant wave height [m], 0..9.
BOLAN_API int bolan_douglas_from_hs(double hs);
/// Returns the Beaufort force of a wind speed at 10 m [m/s], 0..12.
BOLAN_API int bolan_beaufort_from_wind(double wind_speed);

// ---- measured spectra -----------------------------------------------------------------------------------------------

/// NULL-safe; NULLs the pointer.
BOLAN_API void bolan_measured_spectrum_destroy(bolan_measured_spectrum **spectrum);

/// Any sea as a spectrum on a grid, for tables, plots and files. A measured spectrum alone keeps its grid; a sea with
/// systems has 96 frequencies in a geometric row, from half of the lowest peak to eight times the highest and at least
/// over those of the measured spectrum, and 72 directions. Thread-safe.
/// Errors: MEMORY, FORMAT (a sea of more than 40 m). Then *out is NULL.
BOLAN_API bolan_result bolan_measured_spectrum_sample(const bolan_sea_state *sea_state, bolan_measured_spectrum **out);

/// Where a spectrum was taken.
typedef struct bolan_measured_place {
    /// The text gives a place. If not, all else is 0.
    bool known;
    /// x and y are longitude and latitude [deg], else east and north of some origin [m].
    bool spherical;
    /// The place.
    double x, y;
} bolan_measured_place;

/// Read-only view: frequencies [rad/s], directions (mathematical, TO) [rad] ascending with constant step 2 pi /
/// direction_count, density[frequency * direction_count + direction] [m2 s/rad per rad].
typedef struct bolan_measured_view {
    uint32_t frequency_count, direction_count, record_count;
    const double *omega, *theta, *density;
    /// Time of the record in ISO 8601 ("2020-06-08T03:50Z"); "" when the text gives none.
    const char *time;
    /// Place of the record; of an interpolated one, of the earlier record.
    bolan_measured_place place;
} bolan_measured_view;
/// Valid while the spectrum lives. Thread-safe.
BOLAN_API bolan_measured_view bolan_measured_spectrum_view(const bolan_measured_spectrum *spectrum);

#ifdef __cplusplus
}
#endif
#endif

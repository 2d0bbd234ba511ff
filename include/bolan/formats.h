// SPDX-License-Identifier: MIT
/// @file formats.h
/// Tier 1. Measured and forecast spectra from bytes in memory: the formats that are read, what a file holds, and the
/// choice of one record in time and one location. bolan/io.h reads the files. Every function is thread-safe.
#ifndef BOLAN_FORMATS_H
#define BOLAN_FORMATS_H

#include "bolan/spectrum.h"

#ifdef __cplusplus
extern "C" {
#endif

/// The bytes of one file. The formats are recognised by their content; docs/formats.md has a table of them.
///
/// - **SWAN** ("SWAN 1"), 2-D or 1-D. ZERO is a calm.
/// - **WAVEWATCH III**, point spectra as text ("'WAVEWATCH III SPECTRA'") or NetCDF (efth).
/// - **ERA5** and other models of ECMWF, NetCDF (d2fd, a common logarithm).
/// - **Datawell** .spt, **TRIAXYS** directional and non-directional, **Spotter** JSON, **OCTOPUS**.
/// - **CDIP** and **NDBC** in NetCDF (waveEnergyDensity, spectral_wave_density).
/// - **NDBC**, history and real time, a set of texts: pass the density; the direction texts are optional. Their rows
///   are matched by time, their bands by frequency.
///
/// NetCDF is that of the classic layouts, CDF-1 and CDF-2.
///
/// Where a file has moments of the directions in place of the directions themselves, each band is spread by what is
/// known of it:
/// - alpha1, alpha2, r1, r2: the distribution of maximum entropy with these four moments (Kobune & Hashimoto 1986). It
///   is never negative and keeps the reported direction and spread, where the plain Fourier sum is negative in every
///   eighth bin. Moments that fit no distribution (noise): that sum, clipped and renormalised;
/// - alpha1, r1: cos-2s with s = r1 / (1 - r1);
/// - alpha1: cos-2s with @ref bolan_spectrum_options::spread_s;
/// - nothing: as the nearest lower band that has a direction, or the lowest that has one; where no band has one,
///   @ref bolan_spectrum_options::from_deg.
///
/// Missing densities (999) between two others are interpolated; in a matrix they count as no energy. A row of
/// directions that is missing is replaced by the nearest within an hour. All that stands in for missing data is a
/// warning.
///
/// Directions may be in any order, also a sector of the circle, or with both 0 and 360. Where their step varies, the
/// density is linear between neighbours. Limits: 2..1000 frequencies of 1e-3..10 Hz, 3..720 directions,
/// Hs up to 40 m. Numbers are read independently of the locale; "nan" and "inf" are refused. A record or location that
/// is not asked for need not be readable, only its date.
typedef struct bolan_spectrum_text {
    /// For messages: the file name. NDBC's history files name their quantity in it: 41004w2018.txt.
    const char *name;
    /// The bytes; text need not end in NUL.
    const char *data;
    /// How many.
    size_t size;
} bolan_spectrum_text;

/// The texts of one measurement.
typedef struct bolan_spectrum_texts {
    /// Any format above; of an NDBC set the density: history (w), or real-time .data_spec.
    bolan_spectrum_text density;
    /// NDBC alpha1, alpha2, r1, r2 (d, i, j, k); data NULL where absent.
    bolan_spectrum_text swdir, swdir2, swr1, swr2;
} bolan_spectrum_texts;

/// No text.
BOLAN_API bolan_spectrum_texts bolan_spectrum_texts_default(void);
/// How many tables NDBC publishes beside a density: swdir, swdir2, swr1, swr2.
#define BOLAN_SPECTRUM_COMPANIONS 4
/// Name of the file of table @p index, in the order of bolan_spectrum_texts, that belongs to the density @p path: for
/// NAME.data_spec (real time) NAME.swdir, .swdir2, .swr1, .swr2; for NAMEwYEAR.txt (history) the same name with d, i,
/// j, k. False, and @p out is "", where @p path is no name of that kind or @p capacity is too small. Reads no file.
/// Thread-safe.
BOLAN_API bool bolan_spectrum_companion(const char *path, uint32_t index, char *out, size_t capacity);

// ---- one record -----------------------------------------------------------------------------------------------------

/// What to read of a measured spectrum, and what stands in for what it lacks.
typedef struct bolan_spectrum_options {
    /// Which record in time; 0 (default) is the earliest, whatever the order in the text. Unused where @ref time is
    /// set.
    uint32_t record;
    /// The date of the record, UTC: ISO 8601, "2018-01-01T06:00", seconds and Z optional. "" (default): by number. The
    /// nearest record within an hour is taken, with a warning where it is not that time; see @ref interpolate.
    char time[32];
    /// A @ref time between two records is interpolated between them; default false: the nearest record.
    /// The variance density is linear in time, so m0 is. Of a sea with one seed every wave keeps its phase, and its
    /// amplitude changes steadily. Both records must have the same frequencies and directions.
    bool interpolate;
    /// Which location of a file with several, from 1. 0 (default): the one nearest to @ref place, or the
    /// first, with a warning where there are several.
    uint32_t location;
    /// Longitude and latitude [deg], or x and y [m], +-1e9; NAN (default): no place.
    /// A message names the location that is nearest and its distance.
    double place[2];
    /// Where the waves come FROM, compass [deg], -360..360, for a spectrum without directions. NAN (default): not
    /// known; 270 stands in, with a warning.
    double from_deg;
    /// The exponent s of cos-2s, 0..200, for a spectrum without spreads. NAN (default): not known; 10 stands in, with a
    /// warning.
    double spread_s;
} bolan_spectrum_options;

/// The parameters of bolan_spectrum_options that are numbers; the others are read by the functions below.
BOLAN_API extern const bolan_param_table bolan_spectrum_options_params;
/// The defaults named beside the fields.
BOLAN_API bolan_spectrum_options bolan_spectrum_options_default(void);
/// Reads "3" or "2018-01-01T06:00" into record and time. False, and nothing changed or logged, if it is neither.
BOLAN_API bool bolan_spectrum_options_set_record(bolan_spectrum_options *options, const char *text);
/// Reads "2" or "174.67,-38.17" into location and place. False, and nothing changed or logged, if it is neither.
BOLAN_API bool bolan_spectrum_options_set_location(bolan_spectrum_options *options, const char *text);
/// Checks every field against its range; logs a sentence and returns ARGUMENT at the first that is not.
BOLAN_API bolan_result bolan_spectrum_options_validate(const bolan_spectrum_options *options);

/// Parses one record. The texts are not kept; @p options NULL: the defaults. On failure @p out is NULL and one sentence
/// with name and line is logged: FORMAT, also for a location without data or a sea that cannot be; MEMORY; or ARGUMENT
/// for options outside their ranges or beyond what the text holds.
BOLAN_API bolan_result bolan_measured_spectrum_parse(const bolan_spectrum_texts *texts,
                                                     const bolan_spectrum_options *options,
                                                     bolan_measured_spectrum **out);

// ---- what a file holds ----------------------------------------------------------------------------------------------

/// A record in time.
typedef struct bolan_spectrum_record {
    /// Seconds since 1970; NAN where the file gives no time.
    double seconds;
    /// The time in ISO 8601; "" where the file gives none.
    char time[32];
} bolan_spectrum_record;

/// A location.
typedef struct bolan_spectrum_place {
    /// Longitude and latitude [deg], or x and y [m].
    double x, y;
    /// The file's name of it; "" where it gives none.
    char name[24];
} bolan_spectrum_place;

/// What a file of spectra holds.
typedef struct bolan_spectrum_contents {
    /// Short and long name of the format: "swan", "SWAN spectra".
    const char *format, *title;
    /// How many records, 1 or more.
    uint32_t record_count;
    /// The records in the order of time, by which @ref bolan_spectrum_options::record counts.
    const bolan_spectrum_record *records;
    /// How many locations the first record has; 0: the file is of one place that it does not give.
    uint32_t place_count;
    const bolan_spectrum_place *places;
    /// The places are longitudes and latitudes.
    bool spherical;
    /// Frequencies of the first spectrum that could be read, the lowest and the highest [Hz].
    uint32_t frequency_count;
    double lowest_hertz, highest_hertz;
    /// Directions; 0: the file has none, or moments alone.
    uint32_t direction_count;
    /// The bands have moments of the directions.
    bool has_moments;
    /// How many spectra, of all records and locations, were read for the ranges below: at most 512, evenly chosen.
    uint32_t read_count;
    /// How many of those have no readable data.
    uint32_t unreadable_count;
    /// Ranges of the significant height [m] and the peak period [s] of those that could be read; of the period without
    /// calms, 0 where all are.
    double hs_min, hs_max, tp_min, tp_max;
} bolan_spectrum_contents;

/// Lists what the texts hold. FORMAT with a sentence for what is no spectrum file, or where no spectrum of it can be
/// read; MEMORY.
BOLAN_API bolan_result bolan_spectrum_contents_parse(const bolan_spectrum_texts *texts, bolan_spectrum_contents **out);
/// NULL-safe; NULLs the pointer.
BOLAN_API void bolan_spectrum_contents_destroy(bolan_spectrum_contents **contents);

#ifdef __cplusplus
}
#endif
#endif

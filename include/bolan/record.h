// SPDX-License-Identifier: MIT
/// @file record.h
/// Tier 2. Records of a buoy: zero-crossing statistics and directional spectra of series at equal steps of time, from a
/// virtual buoy (bolan_sea_sample_rest() of one rest point) or a real one. Pure functions over the caller's arrays.
#ifndef BOLAN_RECORD_H
#define BOLAN_RECORD_H

#include "bolan/base.h"
#include "bolan/math.h"

#ifdef __cplusplus
extern "C" {
#endif

/// One wave of a record, from an up-crossing of the mean to the next.
typedef struct bolan_record_wave {
    /// From the lowest to the highest sample between the crossings [m].
    double height;
    /// Between the crossings, which are interpolated between samples [s].
    double period;
    /// Of the highest sample over the mean [m].
    double crest;
} bolan_record_wave;
/// The waves of @p count heights @p heave [m], @p rate a second. Writes at most @p capacity waves to @p out and returns
/// how many there are. Thread-safe.
BOLAN_API uint32_t bolan_record_waves(const float *heave, uint32_t count, double rate, uint32_t capacity,
                                      bolan_record_wave *out);
/// Share of the waves that are higher than @p height [m]; 0 of no waves. Thread-safe.
BOLAN_API double bolan_record_exceedance(const bolan_record_wave *waves, uint32_t count, double height);

/// Statistics of a record.
typedef struct bolan_record_statistics {
    /// Mean of the samples [m].
    double mean;
    /// 4 standard deviations of the samples [m].
    double hm0;
    /// Of the samples: 0 and 3 for a Gaussian sea.
    double skewness, kurtosis;
    /// Number of waves.
    uint32_t waves;
    /// Mean height of all waves, of the highest third and of the highest tenth, and the greatest [m].
    double h_mean, h_third, h_tenth, h_max;
    /// Highest crest over the mean [m].
    double crest_max;
    /// Mean period of all waves, and of the highest third [s].
    double tz, t_third;
} bolan_record_statistics;
/// Measures a record; heights and periods are 0 where there is no wave.
/// A gap of a real record must be filled or cut out before.
/// Errors: ARGUMENT (fewer than 2 samples, a rate that is not positive and finite, a sample that is not finite) and
/// MEMORY. Thread-safe.
BOLAN_API bolan_result bolan_record_measure(const float *heave, uint32_t count, double rate,
                                            bolan_record_statistics *out);

/// One band of a spectrum.
typedef struct bolan_record_band {
    /// [Hz]
    double frequency;
    /// Of the variance of the heave [m2/Hz].
    double density;
    /// First Fourier coefficients of the directions that the waves go to, mathematical angles: mean of cos, sin, cos 2,
    /// sin 2.
    double a1, b1, a2, b2;
    /// Mean direction that the waves come from [compass deg], and circular spread sqrt(2 (1 - r1)) [deg].
    double direction_from, spread;
} bolan_record_band;
/// Estimates the directional spectrum of a buoy that follows the surface, by Welch's method: segments of @p segment
/// samples that overlap by half, each less its mean, under a Hann window. Its coefficients are those of
/// Longuet-Higgins, Cartwright & Smith 1963 for the displacements of a buoy (Kuik, van Vledder & Holthuijsen 1988, eq.
/// 3).
/// @param east,north displacements [m]; NULL for both: no directions, and what belongs to them is 0.
/// @param segment a multiple of 4, 16..4096, and at most @p count.
/// @param out receives segment / 2 - 1 bands, of frequency i rate / segment for i = 1, 2 ...
/// Relative standard deviation of a density: about 1 / sqrt(number of segments).
/// Errors: ARGUMENT (as above, also where a sample is not finite), MEMORY. Thread-safe.
BOLAN_API bolan_result bolan_record_spectrum(const float *heave, const float *east, const float *north, uint32_t count,
                                             double rate, uint32_t segment, bolan_record_band *out);

#ifdef __cplusplus
}
#endif
#endif

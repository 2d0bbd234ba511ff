// SPDX-License-Identifier: MIT
// A sea that is a sum of waves: COSINES (Liu, Xu & Chen 2009) and EXP_COSINE (Liu & Xie 2010). Private to src/waves and
// src/query.
//
// How fields are evaluated. A step only turns the phase of every wave (`base`); fields are summed when a point is
// queried, 16 points at once, all waves for each. The phase in turns, x . k / 2 pi + base, is a double; adding 1.5 *
// 2^26 leaves its fraction in the low 26 bits of the mantissa, whatever the whole turns, so that the reduction costs
// one addition and is as accurate at 1e7 m as at the origin. The result of a point depends on the point alone, never on
// its neighbours.
//
// Cost. A wave-point of COSINES is 11 operations for the phase, 7 to reduce it, 30 for sine and cosine, 16 for the
// eight sums, with 11 loads of the wave's constants: on AVX2 about 75 instructions for 8 points, 25 to 38 cycles at 2
// to 3 a cycle, so 1.0 to 1.6 ns at 3 GHz. 128 waves at 6534 points: 0.9 to 1.3 ms; 2048 waves: 14 to 21 ms on one
// thread. The floor is the arithmetic: the constants of 2048 waves are 128 KB and stay in the second-level cache.
// Measured on an EPYC: 1.30 and 19.1 ms, 2.8 times faster than the scalar kernel with 4 lanes and 5.5 with 8 (`bolan
// bench waves`).
//
// Ownership. A sea_sum is a table, read by every fork. The kernels read a wave's phase beside its constants, so the
// fields of a sea are a copy of all waves with its own phases (`sum_tables`): 64 bytes a wave.
#ifndef BOLAN_WAVES_SUM_H
#define BOLAN_WAVES_SUM_H

#include "waves/model.h"

enum {
    SUM_LANES = 16,
    SUM_MAX_LINES = BOLAN_MAX_FREQUENCIES,
};

// One wave as the kernels read it. COSINES: field += factor * (cos th or sin th). EXP_COSINE: with e = e^{s cos th},
// height += factor (e - mean), slope += factor e sin th.
typedef struct sum_wave {
    double tx, ty; // k / 2 pi [1/m]
    double base;   // phase at the world origin and the present time [turns], 0..1, plus SUM_MAGIC
    float length;  // [m]
    float factor[SEA_FIELDS];
} sum_wave;
#define SUM_MAGIC 100663296.0 // 1.5 * 2^26

// A part of the spectrum: its frequency, its energy, and its width.
typedef struct sum_line {
    double omega, energy, width; // [rad/s], [m2], [rad/s]
} sum_line;

// All that the kernels read: bolan_sea.fields.
typedef struct sum_tables {
    uint32_t count;
    uint32_t capacity; // waves that memory was reserved for
    bool exponential;
    float sharpness_8th, mean; // s / 8, I0(s)
    sum_wave *wave;            // longest first
} sum_tables;

// sea_shared.tables
typedef struct sea_sum {
    sum_tables tables; // of no time: `base` is 0
    bolan_sea_component *component;
    double *turns;       // omega / 2 pi, rounded to the loop [1/s]
    double *variance;    // [m2]
    double slope[3];     // covariance xx, xy, yy
    double displacement; // variance of dx plus that of dy [m2]
    double highest;      // bound of crests and troughs [m]
    double farthest;     // sum of the amplitudes of D [m]
    uint32_t line_count;
    sum_line line[SUM_MAX_LINES];
} sea_sum;

static inline const sea_sum *sea_sum_of(const sea_shared *shared) { return shared->tables; }
static inline const sum_tables *sum_tables_of(const bolan_sea *sea) { return sea->fields; }

// How a spectrum is cut.
typedef struct sum_cut {
    bool exponential;
    uint32_t lines, directions;
    bolan_frequency_split split;
} sum_cut;
// Writes shared->tables and the one band. False when memory is short.
bool bolan_sum_create(sea_shared *shared, const spectrum_eval *eval, const sum_cut *cut);
// Memory of shared->tables [bytes].
size_t bolan_sum_table_bytes(const sum_cut *cut);
// Cuts the spectrum into `count` frequencies; none in a flat calm. False when memory is short.
bool bolan_sum_set_lines(const spectrum_eval *eval, uint32_t count, bolan_frequency_split split, sea_sum *out);

// 16 points' fields, by FIELD_HEIGHT ...: choppiness not applied. `fade` NULL, or 1 / (2 spacing) for each lane.
typedef void sum_fields_function(const sum_tables *tables, const double *x, const double *y, const float *fade,
                                 float out[SEA_FIELDS][SUM_LANES]);
sum_fields_function *bolan_sum_fields_for(bolan_cpu cpu);
// The waves of a sum at its time; NULL for a sea of cascades. Valid while the sea lives.
const sum_tables *bolan_sea_sum(const bolan_sea *sea);

#endif

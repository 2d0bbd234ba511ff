// SPDX-License-Identifier: MIT
// The parameters of a sea.
#include "bolan/waves.h"
#include "params/rows.h"

const char *const bolan_frequency_split_names[BOLAN_FREQUENCY_SPLITS + 1] = {"equal-energy", "equal-width", NULL};

#define STRUCT bolan_sea_desc
static const bolan_param sea_rows[] = {
    NAME(waves, .names = bolan_wave_model_names, .high = BOLAN_WAVE_MODELS - 1,
         .help = "the wave model of the technique"),
    WHOLE(seed, .key = "seed", .option = "seed", .high = SEED_MAX, .fallback = 1,
          .help = "which sea of this state: another seed, another arrangement of the same waves"),
    WHOLE(resolution, .key = "resolution", .low = 32, .high = 1024, .rules = BOLAN_PARAM_POWER_OF_TWO, .fallback = 256,
          .label = "waves a side",
          .help = "samples along a tile's side (`fft`, `textures`); larger: shorter waves, slower"),
    WHOLE(fft.cascade_count, .key = "cascades", .low = 1, .high = BOLAN_MAX_CASCADES, .fallback = BOLAN_MAX_CASCADES,
          .label = "cascades", .help = "tiles of the model `fft`; more: shorter waves become geometry"),
    NUMBER(length, .key = "length", .low = 10, .high = 1e5, .unit = "m", .rules = BOLAN_PARAM_OR_ZERO,
           .otherwise = "by the sea", .help = "side of the largest tile (`fft`, `textures`)"),
    NUMBER(choppiness, .key = "choppiness", .low = 0, .high = 2, .fallback = 1, .digits = 2,
           .help = "factor on the horizontal displacement; larger: sharper crests, 1 is linear theory"),
    WHOLE(order, .key = "order", .option = "order", .low = 1, .high = 2, .fallback = 1, .label = "order",
          .help = "of the surface in the waves' steepness (`fft`, `textures`); 2: crests higher than troughs are deep"),
    NUMBER(loop_period, .key = "loop", .low = 10, .high = 1e6, .unit = "s", .rules = BOLAN_PARAM_OR_ZERO,
           .otherwise = "none", .help = "everything repeats after this time, with any model but `textures`"),
    NAME(cpu, .option = "cpu", .names = bolan_cpu_names, .high = BOLAN_CPU_AVX512,
         .help = "instruction set of the wide kernels; no bit of a result depends on it"),
    NUMBER(foam_decay, .key = "foam_decay", .low = 0.1, .high = 60, .fallback = 9, .unit = "s", .label = "foam lasts",
           .usual_low = 0.5, .usual_high = 20, .digits = 1, .rules = BOLAN_PARAM_LOGARITHMIC,
           .help = "e-folding time of foam; larger: longer streaks behind crests"),
    WHOLE(cosines.frequencies, .key = "frequencies", .low = 1, .high = BOLAN_MAX_FREQUENCIES, .fallback = 16,
          .help = "frequencies of the model `cosines`; more: richer, slower"),
    WHOLE(cosines.directions, .key = "directions", .low = 1, .high = BOLAN_MAX_DIRECTIONS, .fallback = 8,
          .help = "directions of the model `cosines`; more: crests less long, slower"),
    NAME(cosines.split, .key = "split", .names = bolan_frequency_split_names, .high = BOLAN_FREQUENCY_SPLITS - 1,
         .help = "how the model `cosines` cuts the spectrum into frequencies"),
    WHOLE(exp_cosine.wave_count, .key = "waves", .low = 1, .high = BOLAN_MAX_EXP_WAVES, .fallback = 8,
          .help = "waves of the model `exp-cosine`; more: less regular from above, slower"),
    NUMBER(exp_cosine.sharpness, .key = "sharpness", .low = 0.01, .high = 2, .fallback = 0.5,
           .help = "of the crests of the model `exp-cosine`"),
    NUMBER(textures.period, .key = "texture_loop", .low = 1, .high = 1e6, .unit = "s", .rules = BOLAN_PARAM_OR_ZERO,
           .otherwise = "whole peak periods near 10 s", .help = "time of the loop of the model `textures`"),
    WHOLE(textures.frames, .key = "loop_frames", .low = 2, .high = BOLAN_MAX_LOOP_FRAMES, .fallback = 32,
          .help = "frames in the loop of the model `textures`; more: smoother"),
};
#undef STRUCT
const bolan_param_table bolan_sea_params = TABLE("bolan_sea_desc", sea_rows);

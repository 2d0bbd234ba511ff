// SPDX-License-Identifier: MIT
// The table of the wave models, the only list of them.
#include "waves/model.h"

const char *const bolan_wave_model_names[BOLAN_WAVE_MODELS + 1] = {"fft", "cosines", "exp-cosine", "textures", NULL};

const sea_model *bolan_sea_model_of(bolan_wave_model waves) {
    static const sea_model *const models[BOLAN_WAVE_MODELS] = {
        [BOLAN_WAVES_FFT] = &bolan_sea_model_fft,
        [BOLAN_WAVES_COSINES] = &bolan_sea_model_cosines,
        [BOLAN_WAVES_EXP_COSINE] = &bolan_sea_model_exp_cosine,
        [BOLAN_WAVES_TEXTURES] = &bolan_sea_model_textures,
    };
    return models[waves];
}

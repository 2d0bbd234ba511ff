// SPDX-License-Identifier: MIT
// Model files in a build without assimp. See src/io/assimp.
#include "bolan/io.h"

bolan_result bolan_model_load(const bolan_model_desc *desc, bolan_model **out) {
    BOLAN_ASSERT(desc && desc->path && out);
    *out = NULL;
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_UNSUPPORTED,
              "%s: this build reads no model files; build Bolan with -DBOLAN_WITH_ASSIMP=ON", desc->path);
    return BOLAN_ERROR_UNSUPPORTED;
}

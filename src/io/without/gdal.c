// SPDX-License-Identifier: MIT
// Rasters in a build without GDAL. See src/io/gdal.
#include "bolan/io.h"

bolan_result bolan_raster_load(const bolan_raster_desc *desc, bolan_ground **out) {
    BOLAN_ASSERT(desc && out);
    *out = NULL;
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_UNSUPPORTED,
              "%s: this build reads no rasters; build Bolan with -DBOLAN_WITH_GDAL=ON", desc->path);
    return BOLAN_ERROR_UNSUPPORTED;
}

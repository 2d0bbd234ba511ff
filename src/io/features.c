// SPDX-License-Identifier: MIT
// Which optional libraries this build of bolan_io has.
#include "bolan/io.h"

bolan_io_features bolan_io_get_features(void) {
    return (bolan_io_features){.rasters = BOLAN_WITH_GDAL,
                               .models = BOLAN_WITH_ASSIMP,
                               .exr = BOLAN_WITH_OPENEXR,
                               .gzip = BOLAN_WITH_ZLIB,
                               .netcdf4 = BOLAN_WITH_NETCDF};
}

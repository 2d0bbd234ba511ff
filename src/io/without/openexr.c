// SPDX-License-Identifier: MIT
// EXR images in a build without OpenEXR. See src/io/openexr.
#include "bolan/io.h"

bolan_result bolan_exr_write_parts(const char *path, const bolan_exr_part *parts, uint32_t count) {
    BOLAN_ASSERT(path && parts);
    return bolan_exr_write(path, parts->width, parts->height, parts->channels, count);
}

bolan_result bolan_exr_write(const char *path, uint32_t width, uint32_t height, const bolan_exr_channel *channels,
                             uint32_t count) {
    BOLAN_ASSERT(path && channels);
    (void)width, (void)height, (void)count;
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_UNSUPPORTED,
              "%s: this build writes no EXR images; build Bolan with -DBOLAN_WITH_OPENEXR=ON", path);
    return BOLAN_ERROR_UNSUPPORTED;
}

// SPDX-License-Identifier: MIT
// Packed files in a build without zlib. See src/io/zlib.
#include "io/unpack.h"

bolan_result bolan_unpack_gzip(const char *path, size_t limit, file_text *file) {
    (void)limit;
    if (!unpack_is_gzip(file)) return BOLAN_OK;
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_UNSUPPORTED,
              "%s: this build reads no gzip files; unpack it, or build Bolan with -DBOLAN_WITH_ZLIB=ON", path);
    return BOLAN_ERROR_UNSUPPORTED;
}

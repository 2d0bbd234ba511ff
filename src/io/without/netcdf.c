// SPDX-License-Identifier: MIT
// NetCDF-4 in a build without netCDF-C. See src/io/netcdf.
#include "io/unpack.h"

bolan_result bolan_unpack_netcdf4(const char *path, size_t limit, file_text *file) {
    (void)limit;
    if (!unpack_is_hdf5(file)) return BOLAN_OK;
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_UNSUPPORTED,
              "%s: this build reads no NetCDF-4 files; convert it (nccopy -k classic), or build Bolan with "
              "-DBOLAN_WITH_NETCDF=ON",
              path);
    return BOLAN_ERROR_UNSUPPORTED;
}

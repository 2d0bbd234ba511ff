// SPDX-License-Identifier: MIT
// Version, result codes and instruction sets by name.
#include "bolan/base.h"

const char *bolan_version(void) { return BOLAN_VERSION_STRING; }

const char *bolan_result_string(bolan_result result) {
    switch (result) {
    case BOLAN_OK: return "ok";
    case BOLAN_ERROR_ARGUMENT: return "argument error";
    case BOLAN_ERROR_MEMORY: return "out of memory";
    case BOLAN_ERROR_IO: return "input/output error";
    case BOLAN_ERROR_FORMAT: return "format error";
    case BOLAN_ERROR_UNSUPPORTED: return "unsupported";
    case BOLAN_ERROR_GL: return "OpenGL error";
    }
    return "unknown result";
}

const char *const bolan_cpu_names[BOLAN_CPUS + 1] = {"auto", "scalar", "generic4", "avx2", "avx512", NULL};

const char *bolan_cpu_name(bolan_cpu cpu) {
    return (int)cpu >= 0 && (int)cpu < BOLAN_CPUS ? bolan_cpu_names[cpu] : "unknown";
}

// SPDX-License-Identifier: MIT
// bolan bench: starts the program of the benchmarks, which lies beside this one. It is separate because it links FFTW,
// which is under the GPL.
#include "commands.h"
#include "options.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static bool find_bench(char path[BOLAN_PATH_MAX]) {
    static const char *const names[] = {"bolan-bench", "bolan_bench"};
    char self[BOLAN_PATH_MAX - 16];
    const ssize_t length = readlink("/proc/self/exe", self, sizeof self - 1);
    if (length <= 0) return false;
    self[length] = '\0';
    char *slash = strrchr(self, '/');
    if (!slash) return false;
    *slash = '\0';
    for (int i = 0; i < 2; i++) {
        snprintf(path, BOLAN_PATH_MAX, "%s/%s", self, names[i]);
        if (access(path, X_OK) == 0) return true;
    }
    return false;
}

int bench_is_there(void) {
    char path[BOLAN_PATH_MAX];
    return find_bench(path);
}

int command_bench(int count, char **arguments) {
    char path[BOLAN_PATH_MAX];
    if (!find_bench(path)) {
        return failure("the program bolan-bench is not beside this one; build it from the source tree");
    }
    char **list = calloc((size_t)count + 2, sizeof *list);
    if (!list) return failure("no memory for %d arguments", count);
    list[0] = path;
    for (int i = 0; i < count; i++) list[i + 1] = arguments[i];
    execv(path, list);
    free(list);
    return failure("%s cannot be started", path);
}

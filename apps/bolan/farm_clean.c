// SPDX-License-Identifier: MIT
// See farm_clean.h. bolan_file_write() writes NAME as NAME.partPID, and renames it.
#include "farm_clean.h"

#include <dirent.h>
#include <errno.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

// The length of NAME in NAME.partPID, and the process; 0 for another name.
static size_t unfinished_name(const char *name, long *process) {
    const char *part = strstr(name, ".part");
    while (part && strstr(part + 1, ".part")) part = strstr(part + 1, ".part");
    char *end;
    if (!part || part[5] < '0' || part[5] > '9') return 0;
    *process = strtol(part + 5, &end, 10);
    return *end == '\0' || *end == '-' ? (size_t)(part - name) : 0;
}

static bool is_file_of(const farm_job *job, const uint32_t *frames, uint32_t count, const char *name, size_t length) {
    char path[BOLAN_PATH_MAX];
    for (uint32_t i = 0; i < count; i++)
        for (farm_file f = FARM_FILE_PICTURE; f < FARM_FILES; f++) {
            if (!farm_job_file(job, frames[i], f, path)) continue;
            const char *last = farm_last_part(path);
            if (strlen(last) == length && strncmp(last, name, length) == 0) return true;
        }
    return false;
}

void farm_clean(const farm_job *job, const uint32_t *frames, uint32_t count) {
    char folder[BOLAN_PATH_MAX], path[2 * BOLAN_PATH_MAX];
    if (count == 0 || !farm_job_file(job, 0, FARM_FILE_RECORD, folder)) return;
    *(char *)farm_last_part(folder) = '\0';
    DIR *list = opendir(folder[0] ? folder : ".");
    for (struct dirent *entry; list && (entry = readdir(list));) {
        long process = 0;
        const size_t length = unfinished_name(entry->d_name, &process);
        const bool lives = process > 0 && (kill((pid_t)process, 0) == 0 || errno == EPERM);
        if (length == 0 || lives || !is_file_of(job, frames, count, entry->d_name, length)) continue;
        snprintf(path, sizeof path, "%s%s", folder, entry->d_name);
        unlink(path);
    }
    if (list) closedir(list);
}

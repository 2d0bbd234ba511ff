// SPDX-License-Identifier: MIT
// Any bytes as query points: refused with a sentence and nothing held, or points that are finite.
#include "bolan/io.h"

#include <stdlib.h>

static unsigned sentences;

static void count_sentence(void *user, bolan_log_level level, bolan_log_id id, const char *sentence) {
    (void)user, (void)level, (void)id;
    sentences += sentence[0] != '\0';
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    bolan_points points;
    bolan_set_hooks(&(bolan_hooks){.log = count_sentence});
    sentences = 0;
    const bolan_result result = bolan_points_parse("fuzz", (const char *)data, size, &points);
    if (result && (sentences != 1 || points.points)) abort();
    for (uint32_t i = 0; i < points.count; i++)
        if (!isfinite(points.points[i].x + points.points[i].y + points.points[i].z)) abort();
    bolan_points_destroy(&points);
    if (bolan_memory_in_use() != 0) abort();
    return 0;
}

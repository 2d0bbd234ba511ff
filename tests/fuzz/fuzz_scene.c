// SPDX-License-Identifier: MIT
// Any bytes as a scene: refused with a sentence, or a scene that is valid.
#include "bolan/io.h"

#include <stdlib.h>

static unsigned sentences;

static void count_sentence(void *user, bolan_log_level level, bolan_log_id id, const char *sentence) {
    (void)user, (void)level, (void)id;
    sentences += sentence[0] != '\0';
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    bolan_scene scene;
    bolan_set_hooks(&(bolan_hooks){.log = count_sentence});
    sentences = 0;
    const bolan_result result = bolan_scene_parse("fuzz", (const char *)data, size, &scene);
    if (result ? sentences != 1 : bolan_scene_validate(&scene) != BOLAN_OK) abort();
    return 0;
}

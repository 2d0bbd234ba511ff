// SPDX-License-Identifier: MIT
// Any bytes as a file packed by gzip: unpacked within the limit, or refused in one sentence. Other bytes stay.
#include "io/unpack.h"

#include "bolan/io.h"

#include <stdlib.h>

enum { LIMIT = 1 << 20 };

static unsigned errors;

static void count_errors(void *user, bolan_log_level level, bolan_log_id id, const char *sentence) {
    (void)user, (void)level, (void)id;
    errors += sentence[0] != '\0';
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    bolan_set_hooks(&(bolan_hooks){.log = count_errors});
    file_text file = {bolan_allocate(size + 1), size};
    if (!file.data) abort();
    memcpy(file.data, data, size);
    errors = 0;
    const bolan_result result = bolan_unpack_gzip("fuzz.gz", LIMIT, &file);
    if ((result != BOLAN_OK) != (errors == 1) || (!result && size <= LIMIT && file.size > LIMIT)) abort();
    bolan_file_release(&file);
    if (bolan_memory_in_use() != 0) abort();
    return 0;
}

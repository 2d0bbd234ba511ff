// SPDX-License-Identifier: MIT
// Runs a fuzz target without libFuzzer: standalone CORPUS-FOLDER MUTATIONS. First the empty input, then each file of
// the corpus, whole and cut short, then that many mutations: the same ones every time, on every machine.
#include <dirent.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

enum { MAX_SEEDS = 64, MAX_SEED_SIZE = 1 << 20, MAX_INPUT = 1 << 16 };

typedef struct seed {
    uint8_t *bytes;
    size_t size;
} seed;

static seed seeds[MAX_SEEDS];
static size_t seed_count;

// xorshift64 (Marsaglia 2003): enough to choose what to break.
static uint64_t random_bits(void) {
    static uint64_t state = 0x9e3779b97f4a7c15u;
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return state;
}

static size_t random_below(size_t n) { return n ? (size_t)(random_bits() % n) : 0; }

static void add_seed(const char *path) {
    FILE *file = fopen(path, "rb");
    uint8_t *bytes = file ? malloc(MAX_SEED_SIZE) : NULL;
    if (bytes) {
        seeds[seed_count].bytes = bytes;
        seeds[seed_count++].size = fread(bytes, 1, MAX_SEED_SIZE, file);
    }
    if (file) fclose(file);
}

static int by_name(const struct dirent **a, const struct dirent **b) { return strcmp((*a)->d_name, (*b)->d_name); }

static void read_corpus(const char *folder) {
    struct dirent **entries = NULL;
    const int n = scandir(folder, &entries, NULL, by_name);
    for (int i = 0; i < n; i++) {
        char path[4096];
        snprintf(path, sizeof path, "%s/%s", folder, entries[i]->d_name);
        if (entries[i]->d_name[0] != '.' && seed_count < MAX_SEEDS) add_seed(path);
        free(entries[i]);
    }
    free(entries);
}

// A fresh allocation of the exact size, so that a sanitizer sees a read past the end.
static void run(const uint8_t *bytes, size_t size) {
    uint8_t *copy = malloc(size ? size : 1);
    if (!copy) abort();
    memcpy(copy, bytes, size);
    LLVMFuzzerTestOneInput(copy, size);
    free(copy);
}

// Breaks the input in one place: a bit, a byte, a number made odd, a piece cut out, a piece doubled.
static size_t mutate_once(uint8_t *input, size_t size) {
    static const char *const odd[] = {"-1", "0", "nan", "inf", "1e999", "99999999999", "", "\n", "\xff", "-"};
    if (size == 0) return 0;
    const size_t at = random_below(size), length = random_below(size - at < 64 ? size - at : 64);
    switch (random_below(5)) {
    case 0: input[at] ^= (uint8_t)(1u << random_below(8)); return size;
    case 1: input[at] = (uint8_t)random_bits(); return size;
    case 2: {
        const char *text = odd[random_below(sizeof odd / sizeof odd[0])];
        const size_t n = strlen(text) < size - at ? strlen(text) : size - at;
        memcpy(input + at, text, n);
        return size;
    }
    case 3: memmove(input + at, input + at + length, size - at - length); return size - length;
    default:
        if (size + length > MAX_INPUT) return size;
        memmove(input + at + length, input + at, size - at);
        return size + length;
    }
}

static void run_mutation(void) {
    static uint8_t input[MAX_INPUT];
    size_t size = 0;
    if (seed_count > 0) {
        const seed *s = &seeds[random_below(seed_count)];
        size = s->size < MAX_INPUT ? s->size : MAX_INPUT;
        memcpy(input, s->bytes, size);
    } else {
        size = random_below(256);
        for (size_t i = 0; i < size; i++) input[i] = (uint8_t)random_bits();
    }
    for (size_t n = 1 + random_below(4); n > 0; n--) size = mutate_once(input, size);
    if (random_below(8) == 0) size = random_below(size);
    run(input, size);
}

int main(int argc, char **argv) {
    if (argc != 3) {
        fprintf(stderr, "usage: %s CORPUS-FOLDER MUTATIONS\n", argv[0]);
        return 2;
    }
    read_corpus(argv[1]);
    run((const uint8_t *)"", 0);
    for (size_t i = 0; i < seed_count; i++) {
        run(seeds[i].bytes, seeds[i].size);
        run(seeds[i].bytes, seeds[i].size / 2);
    }
    const long mutations = strtol(argv[2], NULL, 10);
    for (long i = 0; i < mutations; i++) run_mutation();
    printf("%zu files of the corpus and %ld mutations: no crash\n", seed_count, mutations);
    for (size_t i = 0; i < seed_count; i++) free(seeds[i].bytes);
    return 0;
}

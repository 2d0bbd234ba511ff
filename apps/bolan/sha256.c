// SPDX-License-Identifier: MIT
// See sha256.h. The names are those of the standard, section 6.2.
#include "sha256.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

enum { BLOCK = 64 };

typedef struct digest {
    uint32_t h[8];
    uint8_t block[BLOCK];
    uint64_t size;
} digest;

// The first 32 bits of the fractional parts of the cube roots of the first 64 primes.
static const uint32_t k[64] = {
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
    0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
    0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
    0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
    0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
    0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
    0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
    0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2,
};

static uint32_t rotated(uint32_t x, int bits) { return x >> bits | x << (32 - bits); }

static void schedule(const uint8_t *block, uint32_t w[64]) {
    for (int t = 0; t < 16; t++, block += 4)
        w[t] = (uint32_t)block[0] << 24 | (uint32_t)block[1] << 16 | (uint32_t)block[2] << 8 | block[3];
    for (int t = 16; t < 64; t++) {
        const uint32_t a = w[t - 15], b = w[t - 2];
        w[t] = (rotated(b, 17) ^ rotated(b, 19) ^ b >> 10) + w[t - 7] + (rotated(a, 7) ^ rotated(a, 18) ^ a >> 3) +
               w[t - 16];
    }
}

static void take_block(digest *d, const uint8_t *block) {
    uint32_t w[64], s[8];
    schedule(block, w);
    memcpy(s, d->h, sizeof s);
    for (int t = 0; t < 64; t++) {
        const uint32_t e = s[4], a = s[0];
        const uint32_t t1 =
            s[7] + (rotated(e, 6) ^ rotated(e, 11) ^ rotated(e, 25)) + ((e & s[5]) ^ (~e & s[6])) + k[t] + w[t];
        const uint32_t t2 =
            (rotated(a, 2) ^ rotated(a, 13) ^ rotated(a, 22)) + ((a & s[1]) ^ (a & s[2]) ^ (s[1] & s[2]));
        memmove(s + 1, s, 7 * sizeof *s);
        s[4] += t1;
        s[0] = t1 + t2;
    }
    for (int i = 0; i < 8; i++) d->h[i] += s[i];
}

static void begin(digest *d) {
    *d =
        (digest){.h = {0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a, 0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19}};
}

static void take(digest *d, const uint8_t *data, size_t size) {
    while (size > 0) {
        const size_t used = d->size % BLOCK, room = BLOCK - used, part = size < room ? size : room;
        memcpy(d->block + used, data, part);
        d->size += part;
        data += part, size -= part;
        if (d->size % BLOCK == 0) take_block(d, d->block);
    }
}

static void end(digest *d, char out[SHA256_TEXT]) {
    static const uint8_t padding[BLOCK] = {0x80};
    const uint64_t bits = d->size * 8;
    uint8_t length[8];
    for (int i = 0; i < 8; i++) length[i] = (uint8_t)(bits >> (56 - 8 * i));
    take(d, padding, (size_t)((119 - d->size % BLOCK) % BLOCK + 1));
    take(d, length, sizeof length);
    for (int i = 0; i < 8; i++) snprintf(out + 8 * i, 9, "%08x", (unsigned)d->h[i]);
}

void sha256_text(const void *data, size_t size, char out[SHA256_TEXT]) {
    digest d;
    begin(&d);
    take(&d, data, size);
    end(&d, out);
}

bool sha256_file(const char *path, char out[SHA256_TEXT]) {
    uint8_t piece[65536];
    FILE *file = fopen(path, "rb");
    if (!file) return false;
    digest d;
    begin(&d);
    for (size_t got; (got = fread(piece, 1, sizeof piece, file)) > 0;) take(&d, piece, got);
    const int reason = ferror(file) ? EIO : 0;
    fclose(file);
    errno = reason;
    if (reason) return false;
    end(&d, out);
    return true;
}

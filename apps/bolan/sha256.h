// SPDX-License-Identifier: MIT
// SHA-256 (FIPS 180-4), so that sha256sum checks what a manifest says.
#ifndef BOLAN_CLI_SHA256_H
#define BOLAN_CLI_SHA256_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { SHA256_TEXT = 65 }; // 64 hexadecimal digits and a NUL

void sha256_text(const void *data, size_t size, char out[SHA256_TEXT]);
// The digest of a file; false with errno where it cannot be read.
bool sha256_file(const char *path, char out[SHA256_TEXT]);

#endif
